/*
 * Angles as multiples of pi/128, and sines and cosines of them to some 64 bits.
 */
#ifndef BAT_ELEMENTARY_TURN_H
#define BAT_ELEMENTARY_TURN_H
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

#include <math.h>

/* x = steps pi/128 + d, steps modulo a whole turn of 256. |d| < 0.0123 and some rounding. */
typedef struct {
    int steps;
    bat_twin d;
} bat_angle;

/* 2^20 <= |x|, finite. */
bat_angle bat_reduce_large_angle(double x);

static inline bat_angle bat_reduce_angle(double x)
{
    if (!(fabs(x) < 0x1p20))
        return bat_reduce_large_angle(x);
    /* Added and taken away it rounds to a whole number, whose last bits are those of the sum. */
    const double round = 0x1.8p52, shifted = x * BAT_TURN_STEPS + round, n = shifted - round;
    /* The first two parts end at 2^-59, as x does where n is not 0: nothing is lost. */
    const double near = (x - n * BAT_TURN_STEP_1) - n * BAT_TURN_STEP_2;
    const bat_twin d = bat_twin_any_sum(near, -n * BAT_TURN_STEP_3);
    return (bat_angle){(int)(bat_bits_of(shifted) & 255),
                       bat_twin_sum(d.high, d.low - n * BAT_TURN_STEP_4)};
}

/* The sine of an angle: first part, and the sum of all that is below it; 1/2 is a quarter turn away for the cosine.
 * sin(a + d) = sin a + cos a d + (sin a (cos d - 1) + cos a (sin d - d)), where the second is split for small a. */
static inline bat_twin bat_sine_of(int steps, bat_twin d)
{
    const double *s = bat_sines[steps], *c = bat_sines[steps + 64];
    const double square = d.high * d.high;
    const double versine = square * (-1.0 / 2 + square * (1.0 / 24 - square * (1.0 / 720)));
    const double sine =
        square * d.high * (-1.0 / 6 + square * (1.0 / 120 - square * (1.0 / 5040)));
    const double c1 = bat_first_half(c[0]), d1 = bat_first_half(d.high);
    const bat_twin sum = bat_twin_sum(s[0], c1 * d1);
    const double rest = c1 * ((d.high - d1) + d.low) + ((c[0] - c1) + c[1]) * d.high;
    return (bat_twin){sum.high, sum.low + (s[1] + (rest + (s[0] * versine + c[0] * sine)))};
}

#endif
