/*
 * Arc sine and cosine: near 0 by the series, up to 1/2 by the series about the nearest 256th, and beyond by
 * acos(x) = 2 asin(sqrt((1 - x) / 2)).
 */
#include "base/elementary.h"
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <math.h>

/* Below, the series about 0 serves; the table begins there, in 256ths. */
enum { FIRST_ARC = 48 };

/* asin(x) by its odd series for |x| < 0.19: what is left out is below 2^-60 of it. */
static inline bat_twin small_arc_sine(double x, double less)
{
    const double s = x * x, s2 = s * s, s4 = s2 * s2;
    /* The factor of x^(2 k + 1) is (2 k)! / (4^k k!^2 (2 k + 1)). */
    const double middle =
        (63.0 / 2816 + s * (231.0 / 13312)) + s2 * (143.0 / 10240 + s * (6435.0 / 557056));
    const double end =
        (12155.0 / 1245184 + s * (46189.0 / 5505024)) + s2 * (88179.0 / 12058624);
    const double tail = ((1.0 / 6 + s * (3.0 / 40)) + s2 * (5.0 / 112 + s * (35.0 / 1152))) +
                        s4 * (middle + s4 * end);
    return (bat_twin){x, less + x * s * tail};
}

/* asin(x + less), 0 <= x <= 1/2, less below the last place of x. */
static inline bat_twin arc_sine(double x, double less)
{
    const int j = (int)(256 * x + 0.5);
    if (j < FIRST_ARC)
        return small_arc_sine(x, less);
    const double *entry = bat_arc_sines[j - FIRST_ARC], d = x - j * (1.0 / 256), d2 = d * d;
    const double tail =
        (entry[3] + d * entry[4]) + d2 * ((entry[5] + d * entry[6]) + d2 * entry[7]);
    return (bat_twin){entry[0], entry[1] + ((less + d) * entry[2] + d2 * tail)};
}

/* asin(sqrt((1 - x) / 2)), 1/2 < x <= 1. */
static inline bat_twin half_arc_cosine(double x)
{
    const double square = 0.5 * (1 - x), root = sqrt(square), first = bat_first_half(root);
    const double rest = (square - first * first) - (root - first) * (root + first);
    return arc_sine(root, root > 0 ? rest / (2 * root) : 0);
}

/* a + factor b, a multiple of pi/2 and an angle. */
static inline double angle_sum(double quarters, double factor, bat_twin b)
{
    const bat_twin sum = bat_twin_sum(quarters * (BAT_PI_1 / 2), factor * b.high);
    return sum.high + (sum.low + (quarters * (BAT_PI_2 / 2) + factor * b.low));
}

double bat_asin(double x)
{
    const double size = fabs(x);
    if (!(size <= 1))
        return isnan(x) ? x + x : (double)NAN;
    if (size < 0x1p-27)
        return x;
    return copysign(size > 0.5 ? angle_sum(1, -2, half_arc_cosine(size))
                               : angle_sum(0, 1, arc_sine(size, 0)),
                    x);
}

double bat_acos(double x)
{
    const double size = fabs(x);
    if (!(size <= 1))
        return isnan(x) ? x + x : (double)NAN;
    if (size <= 0.5)
        return angle_sum(1, x > 0 ? -1 : 1, arc_sine(size, 0));
    return x > 0 ? angle_sum(0, 2, half_arc_cosine(size))
                 : angle_sum(2, -2, half_arc_cosine(size));
}
