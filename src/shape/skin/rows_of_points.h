/* Skins through rows of points: what their parts share. */
#ifndef BAT_SKIN_ROWS_PARTS_H
#define BAT_SKIN_ROWS_PARTS_H
#include "base/base.h"
#include <batten/skin.h>

/* Knots that rows share: distinct, rising, inside (0, 1). */
typedef struct {
    int count, capacity;
    double *knots; /* [capacity] */
} bat_shared_knots;

/*
 * Let a row of `count` parameters from 0 to 1 take knots of degree p: one in each of its
 * admissible intervals, of those that are there already or a new one. The row has then a
 * subset of the knots for which it is uniquely interpolated, count - p - 1 of them.
 * `capacity` has room for them all.
 */
void bat_shared_knots_take(bat_shared_knots *shared, int p, int count, const double *u,
                           double margin);

/*
 * The curve of degree p with all shared knots through the points of a row [count][d] at their
 * parameters, of least energy where that leaves a choice. *is_free says whether it does.
 */
batten_status bat_row_through(const bat_shared_knots *shared, int p, int d, int count,
                              const double *u, const double *points, bool *is_free,
                              batten_curve **out);

#endif
