/*
 * Logarithms to some 62 and 68 bits, for those functions that are made of them.
 */
#ifndef BAT_ELEMENTARY_LOG_H
#define BAT_ELEMENTARY_LOG_H
#include "base/elementary/pair.h"
#include "base/elementary/tables.h"

/* x = 2^k c (1 + r + rest): 1/c has nine bits, so nothing of r is lost. */
typedef struct {
    double k, log_c, rest_of_log_c, r, rest;
} bat_parts_of_log;

/* For normal x > 0 with x 2^lift given. |r| < 2^-7. */
static inline bat_parts_of_log bat_reduce_logarithm(double lifted, int lift)
{
    /* From 11/16 on, so that 1 lies within an octave and its logarithm is exact. */
    const uint64_t bits = bat_bits_of(lifted), from = bits - 0x3fe6000000000000;
    const double *entry = bat_logarithms[(from >> 45) & 127];
    const double m = bat_of_bits(bits - (from & ((uint64_t)0xfff << 52)));
    /* 32 bits of m, whose product with nine is exact, and so is that of the other 21. */
    const double first = bat_of_bits(bat_bits_of(m) & ~(uint64_t)0x1fffff);
    const bat_twin r = bat_twin_sum(first * entry[0] - 1, (m - first) * entry[0]);
    const double k = (double)((int)((int64_t)from >> 52) - lift);
    return (bat_parts_of_log){k, entry[1], entry[2], r.high, r.low};
}

/* log(1 + r) - r + r^2/2 by r^3 for |r| < 2^-7: what is left out is below r^8/11, 2^-59. */
static inline double bat_logarithm_tail(double r)
{
    const double square = r * r;
    return (1.0 / 3 - r * (1.0 / 4)) +
           square * ((1.0 / 5 - r * (1.0 / 6)) +
                     square * (1.0 / 7 - r * (1.0 / 8) + square * (1.0 / 9 - r * (1.0 / 10))));
}

/* log(x) for such an x, wrong by at most 2^-60 of it. */
static inline bat_twin bat_logarithm(bat_parts_of_log x)
{
    const double square = x.r * x.r;
    const bat_twin sum = bat_twin_sum(x.k * BAT_LOG_2_1 + x.log_c, x.r);
    return (bat_twin){
        sum.high, sum.low + ((x.rest_of_log_c + x.k * BAT_LOG_2_2) + (x.rest - x.r * x.rest) +
                             (square * x.r * bat_logarithm_tail(x.r) - 0.5 * square))};
}

#endif
