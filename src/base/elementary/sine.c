/*
 * Sine, cosine, tangent: the angle is the nearest multiple of pi/128 and a rest, the sine and cosine of the multiple
 * stand in a table, those of the rest are short series, and the theorem of addition joins them.
 */
#include "base/elementary.h"
#include "base/elementary/turn.h"

/* Below, the cube is less than half a unit of the last place. */
static const double so_small = 0x1p-27;

double bat_sin(double x)
{
    if (fabs(x) < so_small)
        return x;
    const bat_angle angle = bat_reduce_angle(x);
    const bat_twin sine = bat_sine_of(angle.steps, angle.d);
    return sine.high + sine.low;
}

double bat_cos(double x)
{
    const bat_angle angle = bat_reduce_angle(x);
    const bat_twin cosine = bat_sine_of((angle.steps + 64) & 255, angle.d);
    return cosine.high + cosine.low;
}

void bat_sincos(double x, double *sine, double *cosine)
{
    const bat_angle angle = bat_reduce_angle(x);
    const bat_twin s = bat_sine_of(angle.steps, angle.d),
                   c = bat_sine_of((angle.steps + 64) & 255, angle.d);
    *sine = fabs(x) < so_small ? x : s.high + s.low;
    *cosine = c.high + c.low;
}

double bat_tan(double x)
{
    if (fabs(x) < so_small)
        return x;
    const bat_angle angle = bat_reduce_angle(x);
    const bat_twin s = bat_sine_of(angle.steps, angle.d),
                   c = bat_sine_of((angle.steps + 64) & 255, angle.d);
    const bat_twin ratio = bat_twin_quotient(s, bat_twin_sum(c.high, c.low));
    return ratio.high + ratio.low;
}
