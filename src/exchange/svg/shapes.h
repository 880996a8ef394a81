/* Elements of SVG that are shapes, as rows of Bezier pieces. */
#ifndef BAT_SVG_SHAPES_H
#define BAT_SVG_SHAPES_H
#include "exchange/svg/path_data.h"
#include "exchange/svg/xml.h"

/* A number without a unit, in millimetres: 96 to an inch. */
#define BAT_SVG_PIXEL (25.4 / 96)

/* How many millimetres the unit is that follows a number; numbers alone are of 96 to an inch.
 * 0 for percents, sizes of letters, and what is no unit. */
double bat_svg_unit(bat_span text);

bool bat_svg_is_shape(const bat_xml *xml);
/* The shape that the element is, in parts; what stands before an error is handed over. A
 * failure has a message for a note. */
batten_status bat_svg_shape(const bat_xml *xml, bat_svg_row *row, bat_svg_take *take,
                            void *context);

#endif
