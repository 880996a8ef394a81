/*
 * Logarithms: log(2^k m) = k log(2) + log(c) + log(m / c), where c is near m and 1/c has so few bits that m / c - 1 is
 * made without rounding. Source: [Tang90].
 */
#include "base/elementary/log.h"

#include "base/elementary.h"

#include <float.h>
#include <math.h>

static inline bool is_ordinary(double x)
{
    return bat_bits_of(x) - ((uint64_t)1 << 52) < (uint64_t)0x7fe << 52;
}

/* A logarithm of parts. */
typedef double part_logarithm(bat_parts_of_log parts);

static inline double natural(bat_parts_of_log parts)
{
    const bat_twin value = bat_logarithm(parts);
    return value.high + value.low;
}

/* k + log2(c) + log(1 + r)/log(2), of which the first product with r is exact. */
static inline double binary(bat_parts_of_log parts)
{
    const double e = BAT_LOG2_E_1 + BAT_LOG2_E_2, r = parts.r, square = r * r;
    const double first = bat_first_half(r);
    const double *entry = bat_binary_logarithms[parts.part];
    const bat_twin sum = bat_twin_sum(parts.k + entry[0], first * BAT_LOG2_E_1);
    const double tail =
        (e / 3 - r * (e / 4)) +
        square * ((e / 5 - r * (e / 6)) + square * ((e / 7 - r * (e / 8)) + square * (e / 9)));
    return sum.high + (sum.low + ((entry[1] + (first * BAT_LOG2_E_2 + (r - first) * e)) +
                                  square * (r * tail - e / 2)));
}

/* The natural one times a factor, of which the first part has 26 bits. */
static inline double decimal(bat_parts_of_log parts)
{
    const bat_twin log = bat_logarithm(parts);
    const double first = bat_first_half(log.high), rest = (log.high - first) + log.low;
    return first * BAT_LOG10_E_1 +
           (first * BAT_LOG10_E_2 + rest * (BAT_LOG10_E_1 + BAT_LOG10_E_2));
}

/* The logarithm of what is not a normal number > 0. */
static double strange_logarithm(double x, part_logarithm *of)
{
    if (x == 0)
        return -HUGE_VAL;
    if (x < 0)
        return NAN;
    if (isinf(x) || isnan(x))
        return x + x;
    return of(bat_reduce_logarithm(x * 0x1p54, 54));
}

double bat_log(double x)
{
    return is_ordinary(x) ? natural(bat_reduce_logarithm(x, 0)) : strange_logarithm(x, natural);
}

double bat_log2(double x)
{
    return is_ordinary(x) ? binary(bat_reduce_logarithm(x, 0)) : strange_logarithm(x, binary);
}

double bat_log10(double x)
{
    return is_ordinary(x) ? decimal(bat_reduce_logarithm(x, 0)) : strange_logarithm(x, decimal);
}
