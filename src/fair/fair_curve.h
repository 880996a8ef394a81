/* The control points of a B-spline curve, made fair: what its two methods share. */
#ifndef BAT_FAIR_CURVE_H
#define BAT_FAIR_CURVE_H
#include "fair/one_by_one.h"
#include "spline/curve/curve.h"

typedef struct {
    const batten_curve *curve;
    int dimension, degree, count; /* control points, of a periodic curve those of a period */
    const batten_curve_fair_options *options;
    const batten_job *job;
    bat_ducks ducks;
} bat_fair_net;

/* Control point i of the wrapped row: one period further it is the same. */
static inline int bat_fair_net_index(const bat_fair_net *net, int i)
{
    return i % net->count;
}

/* z [count][dimension], as given, is moved. */
batten_status bat_fair_by_knots(const bat_fair_net *net, double *z);
batten_status bat_fair_by_coefficients(const bat_fair_net *net, double *z);

#endif
