/*
 * Powers of e to some 64 bits, for those functions that are made of them.
 */
#ifndef BAT_ELEMENTARY_EXP_H
#define BAT_ELEMENTARY_EXP_H
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

/* x = k log(2)/128 + r. */
typedef struct {
    int k;
    bat_twin r;
} bat_rest_of_e;

/* value 2^exponent. */
typedef struct {
    bat_twin value;
    int exponent;
} bat_power;

/* |x| < 2000. |r| < 0.0028; its second part is below 2^-53 of log(2)/128 k and of x. */
static inline bat_rest_of_e bat_reduce_exponential(bat_twin x)
{
    /* Added and taken away it rounds to a whole number, whose last bits are those of the sum. */
    const double round = 0x1.8p52, shifted = x.high * BAT_EXP_STEPS + round,
                 k = shifted - round;
    const bat_twin r = bat_twin_sum(x.high - k * BAT_EXP_STEP_1, x.low - k * BAT_EXP_STEP_2);
    return (bat_rest_of_e){(int)(int32_t)bat_bits_of(shifted), r};
}

/* e^r - 1 - r for |r| < 0.0028: what is left out is below r^7/5040, 2^-71. */
static inline double bat_exponential_tail(double r)
{
    const double square = r * r;
    return square * ((1.0 / 2 + r * (1.0 / 6)) +
                     square * ((1.0 / 24 + r * (1.0 / 120)) + square * (1.0 / 720)));
}

/* e^x for |x| < 2000: the error is below 2^-61 of it, 1 <= value < 2. */
static inline bat_power bat_power_of_e(bat_twin x)
{
    const bat_rest_of_e rest = bat_reduce_exponential(x);
    const double *entry = bat_exponentials[rest.k & 127];
    const double less = rest.r.high + (rest.r.low + bat_exponential_tail(rest.r.high));
    return (bat_power){{entry[0], entry[1] + entry[0] * less}, rest.k >> 7};
}

#endif
