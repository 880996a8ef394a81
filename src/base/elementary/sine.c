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

/* tan(a + d) = (T + t) / (1 - T t) with T = tan a and t = tan d, for an a of the table, which is at most an eighth of a
 * turn; beyond, the angle is a quarter more, and the tangent is -1 over that. */
double bat_tan(double x)
{
    if (fabs(x) < so_small)
        return x;
    const bat_angle angle = bat_reduce_angle(x);
    const double *entry = bat_tangents[angle.steps & 63], d = angle.d.high, square = d * d;
    const double tail =
        angle.d.low + d * square *
                          ((1.0 / 3 + square * (2.0 / 15)) +
                           square * square * (17.0 / 315 + square * (62.0 / 2835)));
    const double d1 = bat_first_half(d);
    const bat_twin top = bat_twin_sum(entry[0], d), bottom = bat_twin_sum(1, -entry[0] * d1);
    const bat_twin sine = {top.high, top.low + (entry[1] + tail)};
    const bat_twin cosine = {
        bottom.high, bottom.low - (entry[0] * ((d - d1) + tail) + entry[1] * (d + tail))};
    const bool is_turned = (angle.steps + 32) & 64;
    const bat_twin over = is_turned ? (bat_twin){-cosine.high, -cosine.low} : sine,
                   under = is_turned ? sine : cosine;
    const bat_twin ratio = bat_twin_quotient(over, under, 1 / (under.high + under.low));
    return ratio.high + ratio.low;
}
