/* Writing SVG at true scale: what a laser or a knife cuts. Pictures are drawn elsewhere. */
#ifndef BAT_SVG_H
#define BAT_SVG_H
#include "base/base.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_write_svg(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

#endif
