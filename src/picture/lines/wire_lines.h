/* The list of wires, and the isolines, edges and creases among them. */
#ifndef BAT_PICTURE_LINES_WIRE_LINES_H
#define BAT_PICTURE_LINES_WIRE_LINES_H
#include "picture/lines/wires.h"

/* A line more, which is taken over. */
batten_status bat_wires_add(bat_wires *w, bat_wire_kind kind, int object, double value,
                            bat_stroke stroke);
/* Edges where the domain ends, and lines between them; of a closed one its seam is a line. */
batten_status bat_wires_add_lines(bat_wires *w, int object, batten_direction direction);

#endif
