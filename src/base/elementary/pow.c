/*
 * x^y = e^(y log x), with a logarithm of 68 bits: the ten bits that the exponential takes away are left over.
 */
#include "base/elementary.h"
#include "base/elementary/exp.h"
#include "base/elementary/log.h"

#include <float.h>
#include <math.h>

/* log(x) for a normal x > 0, wrong by at most 2^-67 of it: the square of the first 26 bits of r is exact. The second part
 * may be as large as 2^-15 of the first. */
static inline bat_twin fine_logarithm(double x, int lift)
{
    const bat_parts_of_log parts = bat_reduce_logarithm(x, lift);
    const double *entry = bat_logarithms[parts.part];
    /* Rounded to 2^-33 by adding what ends there. */
    const double round = 0x1.8p19, r = parts.r, r1 = (r + round) - round, r2 = r - r1;
    const bat_twin first = bat_twin_sum(parts.k * BAT_LOG_2_1 + entry[2], r);
    const bat_twin second = bat_twin_sum(first.high, -0.5 * r1 * r1);
    const double low = ((first.low + second.low) + (entry[3] + parts.k * BAT_LOG_2_2)) +
                       (r * r * r * bat_logarithm_tail(r) - 0.5 * (r2 * (r + r1)));
    return (bat_twin){second.high, low};
}

/* 0: not whole; 1: odd; 2: even. */
static int parity(double y)
{
    if (!(fabs(y) < 0x1p53))
        return 2;
    if (y != floor(y))
        return 0;
    return fmod(y, 2) == 0 ? 2 : 1;
}

/* Where x or y is 0, infinite or not a number. */
static double power_of_strange(double x, double y)
{
    if (y == 0 || x == 1)
        return 1;
    if (isnan(x) || isnan(y))
        return x + y;
    if (isinf(y)) {
        if (fabs(x) == 1)
            return 1;
        return (fabs(x) > 1) == (y > 0) ? HUGE_VAL : 0;
    }
    const double size = (fabs(x) > 1) == (y > 0) ? HUGE_VAL : 0;
    return parity(y) == 1 ? copysign(size, x) : size;
}

/* x^y = sign e^(y log(size)) for size 2^-lift = |x|, 2^-66 < |y| < 2^64. */
static inline double power_of_parts(double size, int lift, double y, double sign)
{
    const bat_twin log = fine_logarithm(size, lift);
    const double first = bat_first_half(log.high), rest = (log.high - first) + log.low,
                 y1 = bat_first_half(y);
    const bat_twin exponent = {y1 * first, y1 * rest + (y - y1) * (first + rest)};
    const double rough = exponent.high;
    if (!(fabs(rough) < 708)) {
        /* Farther than the exponents of doubles reach. */
        if (!(fabs(rough) < 746))
            return rough > 0 ? sign * HUGE_VAL : sign * 0.0;
        const bat_power power = bat_power_of_e(exponent);
        return sign * bat_twin_scaled(power.value, power.exponent);
    }
    const bat_power power = bat_power_of_e(exponent);
    return (power.value.high + power.value.low) * (sign * bat_power_of_two(power.exponent));
}

/* x < 0, or x subnormal, or y so small or large that the result is 1, 0 or infinite; or one of them strange. */
static double power_of_any(double x, double y)
{
    const double size = fabs(x);
    if (!(size > 0 && size <= DBL_MAX && fabs(y) <= DBL_MAX && y != 0))
        return power_of_strange(x, y);
    const int kind = x < 0 ? parity(y) : 2;
    if (kind == 0)
        return NAN;
    const double sign = kind == 1 ? -1 : 1;
    if (size == 1 || fabs(y) < 0x1p-65)
        return sign;
    if (fabs(y) > 0x1p63)
        return (size > 1) == (y > 0) ? sign * HUGE_VAL : sign * 0.0;
    const bool is_small = size < DBL_MIN;
    return power_of_parts(is_small ? size * 0x1p54 : size, is_small ? 54 : 0, y, sign);
}

double bat_pow(double x, double y)
{
    const bool is_usual = x >= DBL_MIN && x <= DBL_MAX && fabs(y) > 0x1p-65 && fabs(y) < 0x1p63;
    return is_usual ? power_of_parts(x, 0, y, 1) : power_of_any(x, y);
}
