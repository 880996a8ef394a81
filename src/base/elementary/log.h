/*
 * Logarithms to some 62 and 68 bits, for those functions that are made of them.
 */
#ifndef BAT_ELEMENTARY_LOG_H
#define BAT_ELEMENTARY_LOG_H
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

/* x = 2^k c (1 + r), exactly; c is a number of `part`. */
typedef struct {
    double k, r;
    int part;
} bat_parts_of_log;

/* For normal x > 0 with x 2^lift given. |r| < 2^-7. */
static inline bat_parts_of_log bat_reduce_logarithm(double lifted, int lift)
{
    /* From 11/16 on, so that 1 lies within an octave and its logarithm is exact. */
    const uint64_t bits = bat_bits_of(lifted), from = bits - 0x3fe6000000000000;
    const int part = (int)(from >> 45 & 127);
    const double *entry = bat_logarithms[part];
    const uint64_t m = bits - (from & (uint64_t)0xfff << 52);
    /* From the start of the part m has 45 bits, 1/c has nine at most, and all ends at 2^-60: each step is exact. */
    const double begin = bat_of_bits(m & ~(((uint64_t)1 << 45) - 1));
    return (bat_parts_of_log){(double)((int)((int64_t)from >> 52) - lift),
                              (bat_of_bits(m) - begin) * entry[0] + entry[1], part};
}

/* log(1 + r) - r + r^2/2 by r^3 for |r| < 2^-7: what is left out is below r^8/11, 2^-59. */
static inline double bat_logarithm_tail(double r)
{
    const double square = r * r;
    return (1.0 / 3 - r * (1.0 / 4)) +
           square *
               ((1.0 / 5 - r * (1.0 / 6)) +
                square * ((1.0 / 7 - r * (1.0 / 8)) + square * (1.0 / 9 - r * (1.0 / 10))));
}

/* log(x) for such an x, wrong by at most 2^-60 of it. */
static inline bat_twin bat_logarithm(bat_parts_of_log x)
{
    const double *entry = bat_logarithms[x.part];
    const bat_twin sum = bat_twin_sum(x.k * BAT_LOG_2_1 + entry[2], x.r);
    const double square = x.r * x.r,
                 curved = square * x.r * bat_logarithm_tail(x.r) - 0.5 * square;
    return (bat_twin){sum.high, sum.low + ((entry[3] + x.k * BAT_LOG_2_2) + curved)};
}

#endif
