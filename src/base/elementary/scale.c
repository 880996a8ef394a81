/*
 * Results of elementary functions put at their place: a number of twice the digits times a power of two.
 */
#include "base/elementary/pair.h"

#include <float.h>
#include <math.h>

double bat_twin_scaled(bat_twin x, int n)
{
    const double value = x.high + x.low, scaled = ldexp(value, n);
    if (fabs(scaled) > DBL_MIN || n > 0)
        return scaled;
    /* Here the last place of the result is 2^-1074, in units of x 2^(-1074 - n): that of numbers between one and two
     * times 2^(-1022 - n). A sum there is rounded to it, once. Far below it the result is 0. */
    const int below = -1022 - n;
    if (below > 60)
        return copysign(0, x.high);
    const double place = copysign(ldexp(1, below), x.high);
    const bat_twin sum = bat_twin_sum(place, x.high);
    return copysign(ldexp((sum.high + (sum.low + x.low)) - place, n), x.high);
}
