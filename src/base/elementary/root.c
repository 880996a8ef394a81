/*
 * Cube root and hypotenuse.
 */
#include "base/elementary.h"
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <float.h>
#include <math.h>

/* With t near the root from a table and t^3 exact: t (1 + e)^(1/3), e = x / t^3 - 1. */
double bat_cbrt(double x)
{
    double size = fabs(x);
    if (!(size > 0 && size <= DBL_MAX))
        return x + x;
    int exponent = 1023;
    if (size < DBL_MIN) {
        size *= 0x1p54;
        exponent += 54;
    }
    const uint64_t bits = bat_bits_of(size);
    exponent = (int)(bits >> 52) - exponent;
    /* 1200 is a multiple of three that makes the division one of whole numbers > 0. */
    const int third = (exponent + 1200) / 3 - 400, octave = exponent - 3 * third;
    const double m = bat_of_bits((bits & 0xfffffffffffff) | (uint64_t)(1023 + octave) << 52);
    const double *entry = bat_cube_roots[octave * 32 + (int)(bits >> 47 & 31)];
    const double t = entry[0], e = (m - t * t * t) * entry[1], e2 = e * e;
    /* The binomial series, |e| < 1/60: what is left out is below 2^-59. */
    const double end = (374.0 / 19683 - e * (935.0 / 59049)) + e2 * (21505.0 / 1594323);
    const double tail = e * ((1.0 / 3 - e * (1.0 / 9)) +
                             e2 * ((5.0 / 81 - e * (10.0 / 243)) +
                                   e2 * ((22.0 / 729 - e * (154.0 / 6561)) + e2 * end)));
    return copysign((t + t * tail) * bat_power_of_two(third), x);
}

/* sqrt(x^2 + y^2) for x >= y > 0 without overflow or loss: the root of the rounded sum, and half of what is left over the
 * root. Squares of 26 bits are exact, and so is the difference of two that are within a factor of two. */
static inline bat_twin hypotenuse(double x, double y)
{
    const double root = sqrt(x * x + y * y);
    const double x1 = bat_first_half(x), y1 = bat_first_half(y), r1 = bat_first_half(root);
    const double rest = (x1 * x1 - r1 * r1) + y1 * y1;
    const double small =
        ((x - x1) * (x + x1) + (y - y1) * (y + y1)) - (root - r1) * (root + r1);
    return (bat_twin){root, (rest + small) / (2 * root)};
}

double bat_hypot(double x, double y)
{
    x = fabs(x);
    y = fabs(y);
    if (isinf(x) || isinf(y))
        return HUGE_VAL;
    const double large = x > y ? x : y, small = x > y ? y : x;
    if (isnan(x) || isnan(y))
        return x + y;
    if (small <= large * 0x1p-54)
        return large + small;
    if (large < 0x1p500 && small > 0x1p-460) {
        const bat_twin value = hypotenuse(large, small);
        return value.high + value.low;
    }
    const int up = large < 1 ? 600 : -600;
    const double scale = bat_power_of_two(up);
    return bat_twin_scaled(hypotenuse(large * scale, small * scale), -up);
}
