/*
 * The angle of a point: atan(y/x) = atan(c) + atan((y - c x) / (x + c y)) for a c of seven bits near y/x, where y - c x
 * is made without rounding.
 */
#include "base/elementary.h"
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <float.h>
#include <math.h>

/* start + sign atan(y/x) for 0 <= y <= x, both far from where products overflow or vanish. */
static inline double angle_from(bat_twin start, double sign, double y, double x)
{
    /* Added and taken away it rounds to a whole 128th. */
    const double round = 0x1.8p45, c = (y / x + round) - round;
    const double *entry = bat_arc_tangents[(int)(128 * c)];
    /* 26 bits of x times seven are exact, and so is their difference from y, which is near. */
    const double x1 = bat_first_half(x), y1 = bat_first_half(y);
    const bat_twin top = bat_twin_any_sum(y - c * x1, -c * (x - x1)),
                   first = bat_twin_any_sum(x, c * y1);
    const bat_twin z = bat_twin_quotient(top, (bat_twin){first.high, first.low + c * (y - y1)},
                                         1 / first.high);
    const double whole = z.high + z.low, square = whole * whole;
    const double tail = whole * square * (-1.0 / 3 + square * (1.0 / 5 - square * (1.0 / 7)));
    const bat_twin a = bat_twin_sum(start.high, sign * entry[0]),
                   b = bat_twin_sum(a.high, sign * z.high);
    return b.high + (b.low + (a.low + (start.low + sign * (entry[1] + (z.low + tail)))));
}

double bat_atan(double x)
{
    const double size = fabs(x);
    if (!(size > 0x1p-27))
        return x;
    if (size > 0x1p60)
        return copysign(BAT_PI_1 / 2, x);
    const double angle = size > 1
                             ? angle_from((bat_twin){BAT_PI_1 / 2, BAT_PI_2 / 2}, -1, 1, size)
                             : angle_from((bat_twin){0, 0}, 1, size, 1);
    return copysign(angle, x);
}

/* Where x or y is 0, infinite or not a number. */
static double angle_of_strange(double y, double x)
{
    if (isnan(x) || isnan(y))
        return x + y;
    double angle;
    if (isinf(y))
        angle = isinf(x) ? (x > 0 ? BAT_PI_1 / 4 : 3 * (BAT_PI_1 / 4)) : BAT_PI_1 / 2;
    else if (y == 0 || isinf(x))
        angle = signbit(x) ? BAT_PI_1 : 0;
    else
        angle = BAT_PI_1 / 2;
    return copysign(angle, y);
}

double bat_atan2(double y, double x)
{
    double a = fabs(y), b = fabs(x);
    if (!(a > 0 && b > 0 && a <= DBL_MAX && b <= DBL_MAX))
        return angle_of_strange(y, x);
    const int difference = (int)(bat_bits_of(a) >> 52) - (int)(bat_bits_of(b) >> 52);
    if (difference > 64)
        return copysign(BAT_PI_1 / 2, y);
    if (difference < -64)
        return copysign(x > 0 ? a / b : BAT_PI_1, y);
    if (!(a < 0x1p500 && b < 0x1p500))
        a *= 0x1p-600, b *= 0x1p-600;
    else if (!(a > 0x1p-500 && b > 0x1p-500))
        a *= 0x1p600, b *= 0x1p600;
    const bat_twin quarter = {BAT_PI_1 / 2, BAT_PI_2 / 2}, half = {BAT_PI_1, BAT_PI_2},
                   none = {0, 0};
    double angle;
    if (a > b)
        angle = angle_from(quarter, x > 0 ? -1 : 1, b, a);
    else
        angle = angle_from(x > 0 ? none : half, x > 0 ? 1 : -1, a, b);
    return copysign(angle, y);
}
