/*
 * e^x and e^x - 1: x is the nearest multiple k of log(2)/128 and a rest r, so e^x is 2^(k/128) from a table times a
 * short series. Source: [Tang89].
 */
#include "base/elementary/exp.h"

#include "base/elementary.h"

#include <math.h>

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

double bat_expm1(double x)
{
    if (!(fabs(x) < 44)) {
        if (isnan(x) || x > 0)
            return bat_exp(x);
        return -1;
    }
    /* The least double that is more than half a unit of the last place of x away is x^2/2. */
    if (fabs(x) < 0x1p-54)
        return x;
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
    const bat_twin less = bat_twin_any_sum(high, -1),
                   sum = bat_twin_any_sum(less.high, high1 * r1);
    return sum.high + (sum.low + (less.low + small));
}
