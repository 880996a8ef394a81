/* SVG at true scale: what a laser or a knife cuts. Pictures are drawn elsewhere. */
#ifndef BAT_SVG_H
#define BAT_SVG_H
#include "exchange/reading/input.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_svg_recognise(const bat_input *input, bool *is_svg);
/* Shapes as plane curves in millimetres, y upwards. */
batten_status bat_read_svg(bat_input *input, batten_model **out);
batten_status bat_write_svg(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

#endif
