/* Numbers that a change of the unit leaves beside a short decimal one. */
#include "model/short_decimal.h"

#include <math.h>
#include <stdlib.h>

double bat_near_decimal(double x)
{
    const double size = fabs(x);
    if (!(size > 0) || !isfinite(size))
        return x;
    const int places = 12 - (int)floor(bat_log10(size));
    if (abs(places) > 22) /* beyond that powers of ten are no doubles */
        return x;
    const double power = bat_pow(10, abs(places));
    const double near = places < 0 ? round(x / power) * power : round(x * power) / power;
    return fabs(near - x) <= 2 * (nextafter(size, INFINITY) - size) ? near : x;
}
