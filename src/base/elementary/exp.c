/*
 * e^x and e^x - 1: x is the nearest multiple k of log(2)/128 and a rest r, so e^x is 2^(k/128) from a table times a
 * short series. Source: [Tang89].
 */
#include "base/elementary/exp.h"

#include "base/elementary.h"

#include <math.h>

/* 128ths for which e^x stands in a table, on either side of 0. */
enum { SMALL_PARTS = 88 };

double bat_exp(double x)
{
    /* Between 2^-54, where e^x rounds to 1, and 2^1022: the result is a normal number. */
    if (!(fabs(x) < 708)) {
        if (isnan(x))
            return x + x;
        if (x > 710)
            return HUGE_VAL;
        if (x < -746)
            return 0;
        const bat_power power = bat_power_of_e((bat_twin){x, 0});
        return bat_twin_scaled(power.value, power.exponent);
    }
    const bat_power power = bat_power_of_e((bat_twin){x, 0});
    return (power.value.high + power.value.low) * bat_power_of_two(power.exponent);
}

/* e^(c + r) - 1 = e^c - 1 + e^c (e^r - 1) for |x| < 11/16, where c is the nearest 128th. Between 1/2 and 2 nothing is lost
 * when 1 is taken away. */
static inline double small_less_one(double x)
{
    /* Added and taken away it rounds to a 128th, whose number is in the last bits of the sum. */
    const double round = 0x1.8p45, shifted = x + round, r = x - (shifted - round);
    /* e^c in 26 bits and the rest, times r + tail, of which r has 26 bits and the rest. */
    const double *entry = bat_small_exponentials[(int32_t)bat_bits_of(shifted) + SMALL_PARTS];
    const double square = r * r, r1 = bat_first_half(r);
    /* e^r - 1 - r: what is left out is below r^8/40320, 2^-79. */
    const double tail =
        square *
        ((1.0 / 2 + r * (1.0 / 6)) +
         square * ((1.0 / 24 + r * (1.0 / 120)) + square * (1.0 / 720 + r * (1.0 / 5040))));
    /* e^c - 1 is 0, or at least e^(1/128) - 1 and so more than the product. */
    const bat_twin sum = bat_twin_sum(entry[0] - 1, entry[0] * r1);
    return sum.high +
           (sum.low + (entry[1] + (entry[0] * ((r - r1) + tail) + entry[1] * (r + tail))));
}

double bat_expm1(double x)
{
    if (fabs(x) < SMALL_PARTS / 128.0)
        /* The least double that is more than half a unit of the last place of x away is x^2/2. */
        return fabs(x) < 0x1p-54 ? x : small_less_one(x);
    if (!(fabs(x) < 44))
        return isnan(x) || x > 0 ? bat_exp(x) : -1;
    const bat_rest_of_e rest = bat_reduce_exponential((bat_twin){x, 0});
    const double r = rest.r.high;
    /* e^r - 1 is r and a small part. */
    const double part = rest.r.low + bat_exponential_tail(r);
    const double *entry = bat_exponentials[rest.k & 127];
    const double scale = bat_power_of_two(rest.k >> 7), high = scale * entry[0],
                 low = scale * entry[1];
    /* high r, of which the product of 26 bits each is exact. */
    const double high1 = bat_first_half(high), r1 = bat_first_half(r);
    const double small =
        high1 * (r - r1) + (high - high1) * r + (low + (high * part + low * r));
    const bat_twin less = bat_twin_any_sum(high, -1), sum = bat_twin_sum(less.high, high1 * r1);
    return sum.high + (sum.low + (less.low + small));
}
