/* When a derivative counts as 0. */
#ifndef BAT_SINGULAR_H
#define BAT_SINGULAR_H
#include <batten/inspect.h>

/* The width of the span that holds u. */
double bat_span_width(const batten_curve *curve, double u, batten_side side);
/* What rounding alone may leave of the m-th derivative of a curve with coordinates up to `size`
 * on a span of width h: m differences of p + 1 points, over h^m. */
double bat_derivative_roundoff(const batten_curve *curve, int m, double size, double h);

#endif
