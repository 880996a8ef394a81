/* Writing G-code. */
#ifndef BAT_GCODE_H
#define BAT_GCODE_H
#include "base/base.h"
#include <batten/exchange.h>
#include <batten/text.h>

/* One move of the tool as the program says it, in the machine's unit: the bulge is that of a path. */
typedef enum { BAT_TOOL_TRAVELS, BAT_TOOL_PLUNGES, BAT_TOOL_CUTS } bat_tool_does;
typedef struct {
    bat_tool_does does;
    double from[3], to[3], bulge;
    const char
        *path; /* that it is of, borrowed from the model; going over, the one it leads to */
} bat_tool_move;
typedef struct {
    bat_tool_move *items;
    int count, room;
} bat_tool_moves;

/* batten_write_gcode into a text; the moves are also listed when `moves` is not NULL, from the
 * machine's origin on. They are the caller's to release. */
batten_status bat_write_gcode(const batten_model *model,
                              const batten_write_gcode_options *options, batten_notes *notes,
                              batten_text *text, bat_tool_moves *moves);
/* BATTEN_BAD_ARGUMENT with the option and its value, when one cannot be. */
batten_status bat_gcode_check_options(const batten_write_gcode_options *options);
/* How many metres the unit of the program is. */
double bat_gcode_unit_metres(const batten_model *model);

#endif
