/* Quadratic splines that are monotone and convex where the data are. */
#include "shape/local/hermite_data.h"

#include <string.h>

/* ---- slopes ---- */

static bool in_line(const bat_chords *c, int i)
{
    return fabs(c->d[i] - c->d[i - 1]) <=
           bat_chord_rounding(c, i) + bat_chord_rounding(c, i - 1);
}

static double inner_slope(const bat_chords *c, int i)
{
    const double a = c->d[i - 1], b = c->d[i];
    const double la = bat_hypot(c->h[i - 1], c->y[i] - c->y[i - 1]);
    const double lb = bat_hypot(c->h[i], c->y[i + 1] - c->y[i]);
    return a + lb / (la + lb) * (b - a);
}

/* A span of a straight run must be straight, for nothing else is convex there. */
static double straight_slope(const bat_chords *c, int i, double slope)
{
    const int last = c->count - 1;
    const bool before = i > 1 && in_line(c, i - 1), after = i < last - 1 && in_line(c, i + 1);
    const bool here = i > 0 && i < last && in_line(c, i);
    if (here || before == after)
        return slope;
    return before ? c->d[i - 1] : c->d[i];
}

/* 0 where the data turn. */
static double monotone_slope(const bat_chords *c, int i, double slope)
{
    const double a = c->d[i > 0 ? i - 1 : 0], b = c->d[i < c->count - 1 ? i : i - 1];
    return a * slope > 0 && b * slope > 0 ? slope : 0;
}

/* A span can be monotone when not both of its slopes are more than twice its chord's. */
static double most_of_span(const bat_chords *c, int i, double slope, double next)
{
    const double most = 2 * fabs(c->d[i]);
    return fabs(slope) > most && fabs(next) > most ? most : HUGE_VAL;
}

static void limit_slopes(const bat_chords *c, double *slopes)
{
    double before = HUGE_VAL;
    for (int i = 1; i < c->count - 1; i++) {
        const double after =
            i < c->count - 2 ? most_of_span(c, i, slopes[i], slopes[i + 1]) : HUGE_VAL;
        slopes[i] = copysign(bat_min(fabs(slopes[i]), bat_min(before, after)), slopes[i]);
        before = after;
    }
}

static void find_slopes(const bat_chords *c, double *slopes)
{
    const int last = c->count - 1;
    for (int i = 1; i < last; i++)
        slopes[i] = monotone_slope(c, i, straight_slope(c, i, inner_slope(c, i)));
    limit_slopes(c, slopes);
    /* The end spans without a knot of their own, where that is monotone. */
    const double first = last > 1 ? (3 * c->d[0] - slopes[1]) / 2 : c->d[0];
    const double final = last > 1 ? (3 * c->d[last - 1] - slopes[last - 1]) / 2 : c->d[0];
    slopes[0] = monotone_slope(c, 0, straight_slope(c, 0, first));
    slopes[last] = monotone_slope(c, last, straight_slope(c, last, final));
}

/* ---- the spline ---- */

/* In a span that bends twice: the middle, or nearer to the steep end, so that the slope there
 * does not turn: the mean of both slopes, as the parts weigh them, is at most 2 d. */
static double knot_of_bend(double d, double start, double end)
{
    const double most = 2 * fabs(d), a = fabs(start), b = fabs(end);
    if (a + b <= 2 * most)
        return 0.5;
    const double flat = bat_min(a, b), steep = bat_max(a, b);
    const double part = 1 - (most - flat) / (steep - flat) / 2;
    return a < b ? part : 1 - part;
}

/* Where the knot inside span i stands, as a part of it; 0 for none. */
static double knot_of_span(const bat_chords *c, int i, const double *slopes)
{
    /* The square root of the rounding: a knot nearer to an end would lose more digits of the
     * slope there than the convex range gains. */
    const double least = 0x1p-26;
    const double a = slopes[i] - c->d[i], b = slopes[i + 1] - c->d[i];
    if (fabs(a + b) <= bat_chord_rounding(c, i))
        return 0;
    if ((a >= 0) == (b >= 0) || a == 0 || b == 0)
        return knot_of_bend(c->d[i], slopes[i], slopes[i + 1]);
    const double from_start = b / (b - a), from_end = -a / (b - a);
    return from_start < from_end ? bat_max(from_start, least) : 1 - bat_max(from_end, least);
}

typedef struct {
    int count;
    double *knots, *control;
} quadratic;

/* The next break: the control value before it, by the tangent at the one before. */
static void add_break(quadratic *q, double at, double from, double value, double slope)
{
    q->control[q->count] = value + slope * (at - from) / 2;
    q->knots[q->count++ + 2] = at;
}

static void add_span(quadratic *q, const bat_chords *c, int i, const double *slopes)
{
    const double part = knot_of_span(c, i, slopes);
    double from = c->x[i], value = c->y[i], slope = slopes[i];
    const double at = from + part * c->h[i];
    if (part > 0 && at > from && at < c->x[i + 1]) {
        add_break(q, at, from, value, slope);
        const double next = 2 * c->d[i] - (part * slopes[i] + (1 - part) * slopes[i + 1]);
        value += (slope + next) / 2 * (at - from);
        slope = next;
        from = at;
    }
    add_break(q, c->x[i + 1], from, value, slope);
}

/* Knots: the breaks, the first and last three times; q->count counts control values. */
static batten_status make_knots_and_values(const bat_chords *c, const double *slopes,
                                           quadratic *q, batten_curve **out)
{
    const int last = c->count - 1;
    q->control[0] = c->y[0];
    q->knots[0] = q->knots[1] = q->knots[2] = c->x[0];
    q->count = 1;
    for (int i = 0; i < last; i++)
        add_span(q, c, i, slopes);
    q->control[q->count] = c->y[last];
    q->knots[q->count + 2] = q->knots[q->count + 3] = c->x[last];
    return batten_curve_create((batten_points){1, q->count + 1, q->control}, 2, NULL, q->knots,
                               out);
}

batten_status batten_curve_schumaker(int count, const double *x, const double *y,
                                     double *slopes, batten_curve **out)
{
    assert(x && y && out);
    bat_chords chords;
    batten_status status = bat_chords_make(count, x, y, &chords);
    if (status != BATTEN_OK)
        return status;
    double *found = bat_array((size_t)count, sizeof *found);
    quadratic q = {0, bat_array3((size_t)count + 2, 2, sizeof *q.knots),
                   bat_array3((size_t)count, 2, sizeof *q.control)};
    status = BATTEN_OUT_OF_MEMORY;
    if (found && q.knots && q.control) {
        find_slopes(&chords, found);
        status = make_knots_and_values(&chords, found, &q, out);
    }
    if (status == BATTEN_OK && slopes)
        memcpy(slopes, found, (size_t)count * sizeof *slopes);
    bat_release(found);
    bat_release(q.knots);
    bat_release(q.control);
    bat_chords_free(&chords);
    return status;
}
