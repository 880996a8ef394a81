/*
 * Logarithms: log(2^k m) = k log(2) + log(c) + log(m / c), where c is near m and 1/c has nine bits, so that m / c - 1
 * is made without rounding. Source: [Tang90].
 */
#include "base/elementary/log.h"

#include "base/elementary.h"

#include <float.h>
#include <math.h>

/* The logarithm of what is not a normal number > 0; *lift: it is one when multiplied with 2^54. */
static double strange_logarithm(double x, int *lift)
{
    *lift = 0;
    if (x == 0)
        return -HUGE_VAL;
    if (x < 0)
        return NAN;
    if (isinf(x) || isnan(x))
        return x + x;
    *lift = 54;
    return x * 0x1p54;
}

static inline bool is_ordinary(double x)
{
    return bat_bits_of(x) - ((uint64_t)1 << 52) < (uint64_t)0x7fe << 52;
}

double bat_log(double x)
{
    int lift = 0;
    if (!is_ordinary(x)) {
        x = strange_logarithm(x, &lift);
        if (lift == 0)
            return x;
    }
    const bat_twin value = bat_logarithm(bat_reduce_logarithm(x, lift));
    return value.high + value.low;
}

/* log(x) times a factor, of which the first part has 26 bits. */
static inline double scaled_logarithm(double x, bat_twin factor)
{
    int lift = 0;
    if (!is_ordinary(x)) {
        x = strange_logarithm(x, &lift);
        if (lift == 0)
            return x;
    }
    const bat_twin log = bat_logarithm(bat_reduce_logarithm(x, lift));
    const double first = bat_first_half(log.high), rest = (log.high - first) + log.low;
    return first * factor.high + (first * factor.low + rest * (factor.high + factor.low));
}

double bat_log2(double x)
{
    return scaled_logarithm(x, (bat_twin){BAT_LOG2_E_1, BAT_LOG2_E_2});
}

double bat_log10(double x)
{
    return scaled_logarithm(x, (bat_twin){BAT_LOG10_E_1, BAT_LOG10_E_2});
}
