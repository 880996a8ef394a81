/*
 * Hyperbolic sine and cosine of e^x and e^-x, each to some 61 bits.
 */
#include "base/elementary.h"
#include "base/elementary/exp.h"

#include <math.h>

/* e^x/2 + sign e^-x/2 for 0.2 <= x < 711. */
static double half_sum(double x, double sign)
{
    const bat_power up = bat_power_of_e((bat_twin){x, 0});
    if (x > 23) /* e^-2x is below 2^-66 */
        return bat_twin_scaled(up.value, up.exponent - 1);
    const bat_power down = bat_power_of_e((bat_twin){-x, 0});
    const double scale = bat_power_of_two(up.exponent - 1),
                 less = sign * bat_power_of_two(down.exponent - 1);
    const bat_twin sum = bat_twin_sum(scale * up.value.high, less * down.value.high);
    return sum.high + (sum.low + (scale * up.value.low + less * down.value.low));
}

double bat_sinh(double x)
{
    const double size = fabs(x);
    if (!(size < 711))
        return isnan(x) ? x + x : copysign(HUGE_VAL, x);
    if (size < 0.25) {
        /* x + x^3/3! + ...: what is left out is below 2^-60 of it. */
        const double square = x * x;
        return x + x * square *
                       (1.0 / 6 +
                        square * ((1.0 / 120 + square * (1.0 / 5040)) +
                                  square * square *
                                      (1.0 / 362880 + square * (1.0 / 39916800 +
                                                                square * (1.0 / 6227020800)))));
    }
    return copysign(half_sum(size, -1), x);
}

double bat_cosh(double x)
{
    const double size = fabs(x);
    if (!(size < 711))
        return isnan(x) ? x + x : HUGE_VAL;
    return half_sum(size, 1);
}
