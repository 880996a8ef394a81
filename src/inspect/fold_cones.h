/* Where a surface cannot fold, by its control net. */
#ifndef BAT_FOLD_CONES_H
#define BAT_FOLD_CONES_H
#include "base/base.h"
#include <batten/surface.h>

/* Spans first .. end - 1 of each direction; without any when end is first. */
typedef struct {
    int first[2], end[2];
} bat_span_range;

typedef struct {
    bat_span_range *at;
    int count, room;
} bat_span_ranges;

/* Ranges with all spans that may fold, joined where it is less work to look at both at once: outside them the net proves
 * that the normal reverses nowhere. All spans of a surface that is neither a polynomial spline nor one whose weights are
 * products of those of a row and of a column. Release `at`. */
batten_status bat_folds_possible(const batten_surface *surface, bat_span_ranges *out);

#endif
