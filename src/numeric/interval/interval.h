/*
 * Intervals: every operation encloses what it yields for all numbers of its operands. Ends move
 * outward after each rounding, by a unit in the last place and no more than two; 0 is exact, so
 * what vanishes stays gone. Nothing known is [-infinity, infinity].
 */
#ifndef BAT_INTERVAL_H
#define BAT_INTERVAL_H
#include "base/base.h"

#include <float.h>

typedef struct {
    double lo, hi;
} bat_interval;

#define BAT_EVERYTHING ((bat_interval){-INFINITY, INFINITY})

static inline bat_interval bat_interval_at(double x)
{
    return (bat_interval){x, x};
}

/* A number below, and one above, what was rounded to x; |x| eps is at least half a unit of its
 * last place. */
static inline double bat_below(double x)
{
    if (x == 0)
        return 0;
    if (!isfinite(x))
        return x > 0 ? DBL_MAX : (double)-INFINITY;
    return x - (fabs(x) * DBL_EPSILON + DBL_MIN);
}

static inline double bat_above(double x)
{
    return -bat_below(-x);
}

static inline bool bat_interval_is_finite(bat_interval a)
{
    return isfinite(a.lo) && isfinite(a.hi);
}

static inline bool bat_interval_holds_zero(bat_interval a)
{
    return a.lo <= 0 && a.hi >= 0;
}

static inline double bat_interval_width(bat_interval a)
{
    return a.hi - a.lo;
}

static inline double bat_interval_middle(bat_interval a)
{
    return 0.5 * a.lo + 0.5 * a.hi;
}

/* The largest, and the least, absolute value. */
static inline double bat_interval_size(bat_interval a)
{
    return bat_max(fabs(a.lo), fabs(a.hi));
}

static inline double bat_interval_least_size(bat_interval a)
{
    return bat_interval_holds_zero(a) ? 0 : bat_min(fabs(a.lo), fabs(a.hi));
}

static inline bat_interval bat_interval_hull(bat_interval a, bat_interval b)
{
    return (bat_interval){bat_min(a.lo, b.lo), bat_max(a.hi, b.hi)};
}

/* What both have; lo > hi when that is nothing. */
static inline bat_interval bat_interval_common(bat_interval a, bat_interval b)
{
    return (bat_interval){bat_max(a.lo, b.lo), bat_min(a.hi, b.hi)};
}

static inline bat_interval bat_interval_negative(bat_interval a)
{
    return (bat_interval){-a.hi, -a.lo};
}

/* A number below a + b; the sum itself when Knuth's remainder says that it is exact. */
static inline double bat_sum_below(double a, double b)
{
    const double sum = a + b, more = sum - a;
    return (a - (sum - more)) + (b - more) == 0 ? sum : bat_below(sum);
}

static inline bat_interval bat_interval_add(bat_interval a, bat_interval b)
{
    if (b.lo == 0 && b.hi == 0)
        return a;
    if (a.lo == 0 && a.hi == 0)
        return b;
    return (bat_interval){bat_sum_below(a.lo, b.lo), -bat_sum_below(-a.hi, -b.hi)};
}

static inline bat_interval bat_interval_subtract(bat_interval a, bat_interval b)
{
    return bat_interval_add(a, bat_interval_negative(b));
}

/* 0 times anything is 0, also times infinity: that stands for numbers without a known bound. */
static inline double bat_end_product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : a * b;
}

/* Are they whole, and their product small enough to be exact? */
static inline bool bat_is_whole_product(bat_interval a, bat_interval b)
{
    return a.lo == a.hi && b.lo == b.hi && fabs(a.lo * b.lo) < 1 / DBL_EPSILON &&
           a.lo == floor(a.lo) && b.lo == floor(b.lo);
}

static inline bat_interval bat_interval_multiply(bat_interval a, bat_interval b)
{
    if (bat_is_whole_product(a, b))
        return bat_interval_at(a.lo * b.lo);
    const double p = bat_end_product(a.lo, b.lo), q = bat_end_product(a.lo, b.hi),
                 r = bat_end_product(a.hi, b.lo), s = bat_end_product(a.hi, b.hi);
    const double lo = bat_min(bat_min(p, q), bat_min(r, s));
    const double hi = bat_max(bat_max(p, q), bat_max(r, s));
    /* A product may vanish below the least number though its factors do not. */
    const bool exact = (a.lo == 0 && a.hi == 0) || (b.lo == 0 && b.hi == 0);
    const double spare =
        exact || a.lo == 0 || a.hi == 0 || b.lo == 0 || b.hi == 0 ? 0 : DBL_MIN;
    return exact ? bat_interval_at(0)
                 : (bat_interval){bat_below(lo) - (lo == 0 ? spare : 0),
                                  bat_above(hi) + (hi == 0 ? spare : 0)};
}

static inline bat_interval bat_interval_scale(double factor, bat_interval a)
{
    return bat_interval_multiply(bat_interval_at(factor), a);
}

/* Everything when b holds 0. */
static inline bat_interval bat_interval_divide(bat_interval a, bat_interval b)
{
    if (bat_interval_holds_zero(b) || !bat_interval_is_finite(b))
        return a.lo == 0 && a.hi == 0 && !bat_interval_holds_zero(b) ? a : BAT_EVERYTHING;
    const bat_interval inverse = {bat_below(1 / b.hi), bat_above(1 / b.lo)};
    return bat_interval_multiply(a, inverse);
}

/* a^n, tight also where a holds 0; n >= 0. */
bat_interval bat_interval_power(bat_interval a, int n);

/* a >= 0, p any number; a > 0 where p < 0. */
bat_interval bat_interval_real_power(bat_interval a, double p);

bat_interval bat_interval_sin(bat_interval a);
bat_interval bat_interval_cos(bat_interval a);

/* Of functions that rise: what `f` makes of the ends, which errs by less than four units in the last place. */
bat_interval bat_interval_of_rising(double (*f)(double), bat_interval a);

#endif
