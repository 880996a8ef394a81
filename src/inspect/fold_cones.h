/* Where a surface cannot fold, by its control net. */
#ifndef BAT_FOLD_CONES_H
#define BAT_FOLD_CONES_H
#include "base/base.h"
#include <batten/surface.h>

/* Spans first .. end - 1 of each direction; without any when end is first. */
typedef struct {
    int first[2], end[2];
} bat_span_range;

/* The smallest range with all spans that may fold: outside it the net proves that the normal reverses nowhere. All spans of a
 * surface that is not a polynomial spline. */
batten_status bat_folds_possible(const batten_surface *surface, bat_span_range *out);

#endif
