/* Intervals of powers and of elementary functions. */
#include "numeric/interval/interval.h"

/* Elementary functions are taken to err by less than four units in the last place; those of the
 * usual libraries err by less than two. */
#define UNITS 4

static double well_below(double x)
{
    return isfinite(x) ? x - UNITS * (fabs(x) * DBL_EPSILON + DBL_MIN) : bat_below(x);
}

static double well_above(double x)
{
    return -well_below(-x);
}

/* x^n for x >= 0, outward. */
static bat_interval power_of_end(double x, int n)
{
    bat_interval result = bat_interval_at(1), square = bat_interval_at(x);
    for (; n > 0; n /= 2) {
        if (n % 2)
            result = bat_interval_multiply(result, square);
        if (n > 1)
            square = bat_interval_multiply(square, square);
    }
    return result;
}

bat_interval bat_interval_power(bat_interval a, int n)
{
    if (n == 0)
        return bat_interval_at(1);
    if (n % 2 == 0)
        return (bat_interval){bat_max(power_of_end(bat_interval_least_size(a), n).lo, 0),
                              power_of_end(bat_interval_size(a), n).hi};
    const bat_interval left = power_of_end(fabs(a.lo), n), right = power_of_end(fabs(a.hi), n);
    return (bat_interval){a.lo < 0 ? -left.hi : left.lo, a.hi < 0 ? -right.lo : right.hi};
}

bat_interval bat_interval_real_power(bat_interval a, double p)
{
    const double low = bat_pow(a.lo, p), high = bat_pow(a.hi, p);
    return (bat_interval){bat_max(well_below(bat_min(low, high)), 0),
                          a.hi == 0 ? 0 : well_above(bat_max(low, high))};
}

/* Is phase + 2 pi k in the interval, for a whole k? Yes when rounding leaves it open. */
static bool meets(bat_interval a, double phase)
{
    const double turn = 2 * BAT_PI;
    const double first = (a.lo - phase) / turn, last = (a.hi - phase) / turn;
    const double spare = UNITS * DBL_EPSILON * (1 + bat_max(fabs(first), fabs(last)));
    return floor(last + spare) >= ceil(first - spare);
}

bat_interval bat_interval_sin(bat_interval a)
{
    if (!(a.hi - a.lo < 2 * BAT_PI))
        return (bat_interval){-1, 1};
    if (a.lo == 0 && a.hi == 0)
        return a;
    const double first = bat_sin(a.lo), last = bat_sin(a.hi);
    const double lo = meets(a, -0.5 * BAT_PI) ? -1 : well_below(bat_min(first, last));
    const double hi = meets(a, 0.5 * BAT_PI) ? 1 : well_above(bat_max(first, last));
    return (bat_interval){bat_max(lo, -1), bat_min(hi, 1)};
}

bat_interval bat_interval_cos(bat_interval a)
{
    if (!(a.hi - a.lo < 2 * BAT_PI))
        return (bat_interval){-1, 1};
    const double first = bat_cos(a.lo), last = bat_cos(a.hi);
    const double lo = meets(a, BAT_PI) ? -1 : well_below(bat_min(first, last));
    const double hi = meets(a, 0) ? 1 : well_above(bat_max(first, last));
    return (bat_interval){bat_max(lo, -1), bat_min(hi, 1)};
}

bat_interval bat_interval_of_rising(double (*f)(double), bat_interval a)
{
    return (bat_interval){well_below(f(a.lo)), well_above(f(a.hi))};
}
