/* Shapes in the form that IGES and STEP share: NURBS in space, clamped. */
#ifndef BAT_PREPARE_H
#define BAT_PREPARE_H
#include "base/base.h"
#include <batten/exchange.h>

batten_status bat_prepare_curve(const batten_object *object, batten_curve **out);
/* A note says what was approximated. */
batten_status bat_prepare_surface(const batten_object *object, double tolerance,
                                  batten_notes *notes, batten_surface **out);
/* How many control points the objects have: what the length of their file hangs on. */
size_t bat_count_points(const batten_model *model);

#endif
