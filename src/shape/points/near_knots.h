/* Knots that differ by less than anybody means. */
#ifndef BAT_NEAR_KNOTS_H
#define BAT_NEAR_KNOTS_H
#include "base/base.h"
#include <batten/curve.h>

/* Inner knots of clamped curves over [0, 1] that differ by no more than this would leave
 * slivers of spans in what is made of all of them. */
#define BAT_NEAR_KNOTS 1e-9

/*
 * Move knots onto near ones of other curves, where a curve moves by no more than `tolerance`.
 * @param fixed  the first so many curves keep their knots
 * @param curves [count] replaced where they move
 * @param[in,out] error grows by how far all curves moved together, at equal parameters
 */
batten_status bat_near_knots_join(int fixed, int count, batten_curve **curves, double tolerance,
                                  double *error);

#endif
