/* When a derivative counts as 0. */
#ifndef BAT_SINGULAR_H
#define BAT_SINGULAR_H
#include <batten/curvature.h>

/* The largest coordinate of the control points. */
double bat_curve_size(const batten_curve *curve);
/* Is it between 1e-120 and 1e120, or 0? Products of lengths then stay numbers; BAD_ARGUMENT
 * when it is not. */
batten_status bat_curve_check_size(const batten_curve *curve);
/* batten_curve_local_at, for many places of a curve of which `size` is known. */
batten_status bat_curve_local_at(const batten_curve *curve, double size, double u,
                                 batten_side side, batten_curve_local *out);
/* The width of the span that holds u. */
double bat_span_width(const batten_curve *curve, double u, batten_side side);
/* What rounding alone may leave of the m-th derivative of a curve with coordinates up to `size`
 * on a span of width h: m differences of p + 1 points, over h^m. */
double bat_derivative_roundoff(const batten_curve *curve, int m, double size, double h);

#endif
