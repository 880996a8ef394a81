/* Shapes in the form that IGES and STEP share: NURBS in space, clamped. */
#ifndef BAT_PREPARE_H
#define BAT_PREPARE_H
#include "base/base.h"
#include <batten/exchange.h>

/* Metres: how near writers come to a shape when no tolerance is given. A micrometre is finer
 * than any yard or workshop measures. */
#define BAT_WRITE_TOLERANCE 1e-6

batten_status bat_prepare_curve(const batten_object *object, batten_curve **out);
/* A note says what was approximated. */
batten_status bat_prepare_surface(const batten_object *object, double tolerance,
                                  batten_notes *notes, batten_surface **out);
/* A body, or a surface as a body of one face, traced: every use has its curve in (u, v), and
 * the outer loop comes first. A body of which faces cannot be traced stays as it is, with a
 * note. */
batten_status bat_prepare_body(const batten_object *object, double tolerance,
                               double unit_metres, batten_notes *notes, batten_body **out);
/* How many control points the objects have: what the length of their file hangs on. */
size_t bat_count_points(const batten_model *model);

#endif
