/* What derivatives tell about a curve, of whatever kind it is. */
#ifndef BAT_LOCAL_H
#define BAT_LOCAL_H
#include "spline/chain/chain.h"
#include <batten/curvature.h>

/* From the point and three derivatives [4][d] by any parameter; the first is not 0. */
void bat_local_of(int d, const double *values, batten_side side, batten_curve_local *out);

/* How a span of a chain bends at t: a plane one in its plane. */
typedef struct {
    double speed, curvature, rate; /* of a function 1, second and third derivative */
} bat_bend;
void bat_span_bend(int d, const batten_span *span, double t, bat_bend *out);

/* Integrals over a span: of the speed, curvature^2 and rate^2 by arc length. Exact but for
 * rounding where curvature is a polynomial of arc length, else to 1e-12 of each. */
typedef struct {
    double length, energy, variation;
} bat_span_sums;
#define BAT_SPAN_SUMS_ERROR 1e-12
enum { BAT_RULER_NODES = 16 };
typedef struct {
    double nodes[BAT_RULER_NODES], weights[BAT_RULER_NODES]; /* of bat_gauss */
} bat_ruler;
void bat_span_integrate(int d, const batten_span *span, const bat_ruler *ruler,
                        bat_span_sums *out);

#endif
