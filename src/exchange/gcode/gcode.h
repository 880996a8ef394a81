/* Writing G-code. */
#ifndef BAT_GCODE_H
#define BAT_GCODE_H
#include "base/base.h"
#include <batten/exchange.h>
#include <batten/text.h>

/* batten_write_gcode into a text. */
batten_status bat_write_gcode(const batten_model *model,
                              const batten_write_gcode_options *options, batten_notes *notes,
                              batten_text *text);

#endif
