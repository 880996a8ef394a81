/* What local methods share: Hermite data that may be closed and may have corners. */
#ifndef BAT_LOCAL_H
#define BAT_LOCAL_H
#include "base/base.h"
#include <batten/local.h>

/* Index i of a row of `count` that closes, for -count <= i < 2 count. */
static inline int bat_around(int count, int i)
{
    return i < 0 ? i + count : i >= count ? i - count : i;
}

/* A third of the derivative at both ends of a span, by its chord, when its speed is the same at
 * both ends and in the middle. u: direction of the chord, t0, t1: tangents; unit vectors. */
double bat_middle_leg(int d, const double *u, const double *t0, const double *t1);

/* Points and parameters of batten_curve_from_tangents and its like are good. */
batten_status bat_local_check(int dimension, int count, const double *points,
                              const double *parameters, bool closed);
/* `what` i is not finite: refused. */
batten_status bat_local_check_rows(int dimension, int count, const double *rows,
                                   const char *what);

#endif
