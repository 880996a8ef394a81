/* What SVG says of shapes in short: numbers and path data. */
#ifndef BAT_PATH_DATA_H
#define BAT_PATH_DATA_H
#include "exchange/svg/attributes.h"
#include <batten/curve.h>

/* Past blanks and commas from `at` on. */
size_t bat_svg_past_separators(bat_span text, size_t at);
/* The next number, past blanks and a comma; false when none stands there. *at goes behind it.
 */
bool bat_svg_number(bat_span text, size_t *at, double *value);
/* The same, with a note when it is too small for a double and becomes 0. */
bool bat_svg_real(const bat_input *input, int line, bat_span text, size_t *at, double *value);

/* A row of Bezier pieces that goes on, in the plane. */
typedef struct {
    bat_input *input;
    int line;        /* of the element */
    bat_list points; /* of double[3]: x, y, weight; after the first three for each piece: all
                        are raised to cubics */
    bool has_curves, has_weights;
    double x, y; /* where it stands */
} bat_svg_row;

void bat_svg_row_begin(bat_svg_row *row, bat_input *input);
void bat_svg_row_end(bat_svg_row *row);
batten_status bat_svg_move(bat_svg_row *row, double x, double y); /* begins anew */
batten_status bat_svg_line(bat_svg_row *row, double x, double y);
batten_status bat_svg_quadratic(bat_svg_row *row, const double middle[2], double weight,
                                const double end[2]);
batten_status bat_svg_cubic(bat_svg_row *row, const double one[2], const double two[2],
                            const double end[2]);
/* An arc of an ellipse as the command A has it: half axes, the angle of the first in degrees.
 */
batten_status bat_svg_arc(bat_svg_row *row, double rx, double ry, double angle, bool large,
                          bool sweep, double x, double y);
/* The row as a curve, mapped; NULL when it is one point. A row of lines has degree 1. */
batten_status bat_svg_curve(const bat_svg_row *row, const bat_svg_map *map, batten_curve **out);

/* Each part of a path, from M to M, is handed over. */
typedef batten_status bat_svg_take(void *context, const bat_svg_row *row);
/* The data of a path. What stands before an error is taken; then BAD_FORMAT with a message. */
batten_status bat_svg_path(bat_span data, bat_svg_row *row, bat_svg_take *take, void *context);

#endif
