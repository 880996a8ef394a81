/* Slopes of functions at points from a few neighbours. */
#include "numeric/vector.h"
#include "shape/local/hermite_data.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

batten_status bat_chords_make(int count, const double *x, const double *y, bat_chords *out)
{
    batten_status status = bat_points_check(1, count, y, 2);
    if (status == BATTEN_OK)
        status = bat_parameters_check(count, x);
    if (status != BATTEN_OK)
        return status;
    bat_chords made = {.count = count, .x = x, .y = y};
    made.h = bat_array((size_t)count, sizeof *made.h);
    made.d = bat_array((size_t)count, sizeof *made.d);
    status = made.h && made.d ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i + 1 < count && status == BATTEN_OK; i++) {
        made.h[i] = x[i + 1] - x[i];
        made.d[i] = (y[i + 1] - y[i]) / made.h[i];
        if (!isfinite(made.h[i]) || fabs(made.d[i]) > DBL_MAX / 8)
            status = bat_fail(BATTEN_OVERFLOW,
                              "the slope between points %d and %d is too large", i + 1, i + 2);
    }
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_chords_free(&made);
    return status;
}

void bat_chords_free(bat_chords *chords)
{
    bat_release(chords->h);
    bat_release(chords->d);
}

double bat_chord_rounding(const bat_chords *c, int i)
{
    const double y = bat_max(fabs(c->y[i]), fabs(c->y[i + 1]));
    const double x = bat_max(fabs(c->x[i]), fabs(c->x[i + 1]));
    return 4 * DBL_EPSILON * (y / c->h[i] + fabs(c->d[i]) * (x / c->h[i]));
}

/* ---- Bessel ---- */

/* The mean of the slopes before and after, the shorter chord counting more. */
static double bessel_inside(const bat_chords *c, int i)
{
    const double part = c->h[i - 1] / (c->h[i - 1] + c->h[i]);
    return c->d[i - 1] + part * (c->d[i] - c->d[i - 1]);
}

/* At an end the parabola through three points has as far beyond the slope of the chord as
 * inside. */
static double bessel(const bat_chords *c, int i)
{
    const int last = c->count - 1;
    if (i == 0)
        return 2 * c->d[0] - bessel_inside(c, 1);
    if (i == last)
        return 2 * c->d[last - 1] - bessel_inside(c, last - 1);
    return bessel_inside(c, i);
}

/* ---- Akima ---- */

/* The slope of chord i, also beyond the ends. */
static double slope_beyond(const bat_chords *c, int i)
{
    const int last = c->count - 2;
    if (i < 0)
        return c->d[0] - i * (c->d[0] - c->d[1]);
    if (i > last)
        return c->d[last] + (i - last) * (c->d[last] - c->d[last - 1]);
    return c->d[i];
}

/* How much the slope changes from chord i to the next, but for rounding; `modified`: and how
 * steep both are together. */
static double change(const bat_chords *c, int i, bool modified)
{
    const double a = slope_beyond(c, i), b = slope_beyond(c, i + 1);
    const double by = fabs(b - a) + (modified ? fabs(a + b) / 2 : 0);
    const int last = c->count - 2, at = bat_max_int(0, bat_min_int(i, last - 1));
    const double zero = bat_chord_rounding(c, at) + bat_chord_rounding(c, at + 1);
    return by <= zero ? 0 : by;
}

static double weighted_by_changes(const bat_chords *c, int i, bool modified)
{
    const double before = change(c, i - 2, modified), after = change(c, i, modified);
    const double part = before + after > 0 ? before / (before + after) : 0.5;
    return (1 - part) * slope_beyond(c, i - 1) + part * slope_beyond(c, i);
}

static double akima(const bat_chords *c, int i)
{
    return weighted_by_changes(c, i, false);
}

static double makima(const bat_chords *c, int i)
{
    return weighted_by_changes(c, i, true);
}

/* ---- rules that keep data monotone ---- */

static bool same_sign(double a, double b)
{
    return (a > 0 && b > 0) || (a < 0 && b < 0);
}

static double limited(double slope, double most)
{
    return copysign(bat_min(fabs(slope), most), slope);
}

/* Of the parabola through three points, but of the sign of the first chord, and where the data
 * turn, no steeper than 3 of it. */
static double monotone_end(const bat_chords *c, int i)
{
    const int near = i == 0 ? 0 : i - 1, next = i == 0 ? 1 : i - 2;
    const double slope = bessel(c, i);
    if (!same_sign(slope, c->d[near]))
        return 0;
    return same_sign(c->d[near], c->d[next]) ? slope : limited(slope, 3 * fabs(c->d[near]));
}

static bool is_end(const bat_chords *c, int i)
{
    return i == 0 || i == c->count - 1;
}

static double harmonic(const bat_chords *c, int i)
{
    if (is_end(c, i))
        return monotone_end(c, i);
    const double a = c->d[i - 1], b = c->d[i];
    if (!same_sign(a, b))
        return 0;
    const double w = (2 * c->h[i] + c->h[i - 1]) / (c->h[i] + c->h[i - 1]) / 3;
    /* 1 / (w / a + (1 - w) / b) without dividing by what may be tiny. */
    return fabs(a) < fabs(b) ? a / (w + (1 - w) * (a / b)) : b / (w * (b / a) + (1 - w));
}

static double steffen(const bat_chords *c, int i)
{
    const double slope = bessel(c, i);
    if (is_end(c, i)) {
        const double d = c->d[i == 0 ? 0 : i - 1];
        return same_sign(slope, d) ? limited(slope, 2 * fabs(d)) : 0;
    }
    const double a = c->d[i - 1], b = c->d[i];
    return same_sign(a, b) ? limited(slope, 2 * bat_min(fabs(a), fabs(b))) : 0;
}

/* By which both slopes of span i must be multiplied so that they lie in the circle of radius 3
 * slopes of its chord, where every cubic is monotone. */
static double shortening(const bat_chords *c, int i, const double *slopes)
{
    if (i < 0 || i > c->count - 2 || c->d[i] == 0)
        return 1;
    const double size = bat_hypot(slopes[i] / c->d[i], slopes[i + 1] / c->d[i]);
    return size > 3 ? 3 / size : 1;
}

static void fritsch_carlson(const bat_chords *c, double *slopes)
{
    double before = 1;
    for (int i = 0; i < c->count; i++) {
        const bool turns = !is_end(c, i) && !same_sign(c->d[i - 1], c->d[i]);
        slopes[i] = turns ? 0 : is_end(c, i) ? monotone_end(c, i) : bessel(c, i);
    }
    for (int i = 0; i < c->count; i++) {
        const double after = shortening(c, i, slopes);
        slopes[i] *= bat_min(before, after);
        before = after;
    }
}

void bat_slopes(const bat_chords *c, batten_slope_rule rule, double *slopes)
{
    if (c->count == 2) {
        slopes[0] = slopes[1] = c->d[0];
        return;
    }
    if (rule == BATTEN_SLOPE_FRITSCH_CARLSON) {
        fritsch_carlson(c, slopes);
        return;
    }
    double (*const at)(const bat_chords *, int) = rule == BATTEN_SLOPE_BESSEL    ? bessel
                                                  : rule == BATTEN_SLOPE_AKIMA   ? akima
                                                  : rule == BATTEN_SLOPE_MAKIMA  ? makima
                                                  : rule == BATTEN_SLOPE_STEFFEN ? steffen
                                                                                 : harmonic;
    for (int i = 0; i < c->count; i++)
        slopes[i] = at(c, i);
}

batten_status batten_slopes(int count, const double *x, const double *y, batten_slope_rule rule,
                            double *slopes)
{
    assert(x && y && slopes);
    if ((int)rule < 0 || rule > BATTEN_SLOPE_MAKIMA)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown rule %d for slopes", (int)rule);
    bat_chords chords;
    const batten_status status = bat_chords_make(count, x, y, &chords);
    if (status != BATTEN_OK)
        return status;
    bat_slopes(&chords, rule, slopes);
    bat_chords_free(&chords);
    return BATTEN_OK;
}
