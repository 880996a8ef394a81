/* The spans of a curve: what lies between its distinct knots. */
#include "spline/curve/curve.h"

int batten_curve_spans(const batten_curve *curve, double *knots)
{
    const double *U = curve->knots;
    int count = 0;
    for (int i = curve->degree; i <= curve->count; i++) {
        if (i > curve->degree && U[i] == U[i - 1])
            continue;
        if (knots)
            knots[count] = U[i];
        count++;
    }
    return count;
}
