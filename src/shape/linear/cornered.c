/* Curves through points with corners and straight lines: smooth runs are interpolated one by one. */
#include "base/plural.h"
#include "numeric/vector.h"
#include <batten/local.h>

#include <string.h>

batten_curve_cornered_options batten_curve_cornered_defaults(void)
{
    return (batten_curve_cornered_options){.size = sizeof(batten_curve_cornered_options),
                                           .parameters = BATTEN_CHORD,
                                           .ends = BATTEN_END_NATURAL};
}

/* One run: points first .. last, straight or smooth, with a straight run before or behind it
 * into which it passes. */
typedef struct {
    int first, last;
    bool straight;
    bool meets[2]; /* a straight run at its start, at its end */
} smooth_run;

typedef struct {
    const batten_curve_cornered_options *options;
    int dimension, count;
    const double *points;
    bool *corner; /* [count] */
    bool *line;   /* [count] straight from here to the next point */
    int run_count;
    smooth_run *runs;    /* [count] */
    double *parameters;  /* [count] */
    batten_curve **made; /* [run_count] */
} cornered_fit;

static const double *point(const cornered_fit *w, int i)
{
    return w->points + (size_t)i * (size_t)w->dimension;
}

/* ---- runs ---- */

/* Places that the options name. */
typedef struct {
    const char *what;
    int count, last; /* how many, and the highest index that is allowed */
    const int *at;
} named_places;

static batten_status mark(const cornered_fit *w, const named_places *named, bool *marks)
{
    const int *at = named->at;
    for (int k = 0; k < named->count; k++) {
        if (at[k] < 0 || at[k] > named->last || (k > 0 && at[k] <= at[k - 1]))
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "%s %d is point %d; of %d points it may be 1 to %d, and they rise",
                named->what, k + 1, at[k] + 1, w->count, named->last + 1);
        marks[at[k]] = true;
    }
    return BATTEN_OK;
}

static void add_run(cornered_fit *w, int from, int to)
{
    smooth_run *r = &w->runs[w->run_count++];
    *r = (smooth_run){.first = from, .last = to, .straight = w->line[to - 1]};
    if (!r->straight) {
        r->meets[0] = from > 0 && !w->corner[from] && w->line[from - 1];
        r->meets[1] = !w->corner[to] && w->line[to];
    }
}

static void find_runs(cornered_fit *w)
{
    int from = 0;
    for (int i = 1; i < w->count; i++) {
        const bool ends = i == w->count - 1 || w->corner[i] || w->line[i - 1] || w->line[i];
        if (!ends)
            continue;
        add_run(w, from, i);
        from = i;
    }
}

/* ---- one run ---- */

/* The direction of the straight run at an end of a smooth one. */
static void direction_of_line(const cornered_fit *w, const smooth_run *r, int end, double *out)
{
    const int a = end ? r->last : r->first - 1;
    const double length = bat_distance(w->dimension, point(w, a), point(w, a + 1));
    for (int k = 0; k < w->dimension; k++)
        out[k] = (point(w, a + 1)[k] - point(w, a)[k]) / length;
}

/* Direction and second derivative 0 where straight runs are met; NATURAL at the other end. */
static batten_status make_flat(const cornered_fit *w, const smooth_run *r, const double *t,
                               batten_curve **out)
{
    const int count = r->last - r->first + 1;
    batten_derivative conditions[4];
    int n = 0;
    for (int end = 0; end < 2; end++) {
        const int index = end ? count - 1 : 0;
        if (r->meets[end]) {
            conditions[n] = (batten_derivative){.index = index, .order = 1};
            direction_of_line(w, r, end, conditions[n++].value);
        }
        if (r->meets[end] || w->options->ends == BATTEN_END_NATURAL)
            conditions[n++] = (batten_derivative){.index = index, .order = 2};
    }
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = t;
    o.knots_at_data = false;
    o.derivative_count = n;
    o.derivatives = conditions;
    return batten_curve_interpolate((batten_points){w->dimension, count, point(w, r->first)},
                                    &o, NULL, out);
}

static batten_status make_smooth(const cornered_fit *w, const smooth_run *r, const double *t,
                                 batten_curve **out)
{
    batten_curve_interpolate_options o = batten_curve_interpolate_defaults();
    o.parameters = BATTEN_GIVEN;
    o.given = t;
    o.knots_at_data = true;
    batten_end *ends[2] = {&o.start, &o.end};
    for (int end = 0; end < 2; end++) {
        ends[end]->kind = w->options->ends;
        if (!r->meets[end])
            continue;
        ends[end]->kind = BATTEN_END_CLAMPED;
        direction_of_line(w, r, end, ends[end]->vector);
    }
    return batten_curve_interpolate(
        (batten_points){w->dimension, r->last - r->first + 1, point(w, r->first)}, &o, NULL,
        out);
}

static batten_status make_line(const cornered_fit *w, const smooth_run *r, const double *t,
                               batten_curve **out)
{
    const int d = w->dimension;
    double values[12];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < d; k++) {
            values[2 * i * d + k] = point(w, r->first + i)[k];
            values[(2 * i + 1) * d + k] =
                (point(w, r->last)[k] - point(w, r->first)[k]) / (t[1] - t[0]);
        }
    return batten_curve_from_hermite(d, 2, 2, t, values, out);
}

static batten_status make_run(const cornered_fit *w, const smooth_run *r, batten_curve **out)
{
    const double *t = w->parameters + r->first;
    batten_curve *made = NULL;
    batten_status status;
    if (r->straight || (r->last == r->first + 1 && !r->meets[0] && !r->meets[1]))
        status = make_line(w, r, t, &made);
    else if (w->options->transition == BATTEN_TRANSITION_CURVATURE &&
             (r->meets[0] || r->meets[1]))
        status = make_flat(w, r, t, &made);
    else
        status = make_smooth(w, r, t, &made);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(made, 3 - batten_curve_degree(made), out);
    batten_curve_unref(made);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return status;
    return bat_fail(status, "points %d to %d: %s", r->first + 1, r->last + 1, batten_message());
}

/* ---- all runs as one curve ---- */

/* All runs are clamped cubics that share their ends: knots three times at the joins, the last
 * point of each replaced by the first of the next. */
static batten_status join(const cornered_fit *w, batten_curve **out)
{
    const int d = w->dimension;
    int total = 1;
    for (int i = 0; i < w->run_count; i++)
        total += batten_curve_point_count(w->made[i]) - 1;
    double *points = bat_array3((size_t)total, (size_t)d, sizeof *points);
    double *knots = bat_array((size_t)total + 4, sizeof *knots);
    batten_status status = points && knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int at = 0;
    for (int i = 0; status == BATTEN_OK && i < w->run_count; i++) {
        const int n = batten_curve_point_count(w->made[i]);
        const double *from = batten_curve_points(w->made[i]);
        memcpy(points + (size_t)at * (size_t)d, from, (size_t)n * (size_t)d * sizeof *points);
        /* Both have the knot of the join four times; three of them stay. */
        const int skip = i > 0;
        memcpy(knots + at + skip, batten_curve_knots(w->made[i]) + skip,
               (size_t)(n + 4 - skip) * sizeof *knots);
        at += n - 1;
    }
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){d, total, points}, 3, NULL, knots, out);
    bat_release(points);
    bat_release(knots);
    return status;
}

static batten_status prepare(cornered_fit *w)
{
    const size_t n = (size_t)w->count;
    const batten_curve_cornered_options *o = w->options;
    w->corner = bat_array(n, sizeof *w->corner);
    w->line = bat_array(n, sizeof *w->line);
    w->runs = bat_array(n, sizeof *w->runs);
    w->parameters = bat_array(n, sizeof *w->parameters);
    w->made = bat_array(n, sizeof *w->made);
    if (!w->corner || !w->line || !w->runs || !w->parameters || !w->made)
        return BATTEN_OUT_OF_MEMORY;
    const named_places corners = {"corner", o->corner_count, w->count - 1, o->corners};
    const named_places lines = {"line", o->line_count, w->count - 2, o->lines};
    batten_status status = mark(w, &corners, w->corner);
    if (status == BATTEN_OK)
        status = mark(w, &lines, w->line);
    if (status == BATTEN_OK)
        status = batten_parametrize((batten_points){w->dimension, w->count, w->points},
                                    o->parameters, false, w->parameters);
    return status;
}

static batten_status check_cornered_options(int dimension, int count,
                                            const batten_curve_cornered_options *o)
{
    if (dimension != 2 && dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a curve with corners has 2 or 3 dimensions, not %d", dimension);
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d point%s %s given; 2 are needed", count,
                        bat_plural(count), bat_one_or_many(count, "is", "are"));
    if (o->parameters == BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "parameters cannot be given to curves with corners");
    if (o->ends == BATTEN_END_CLAMPED || o->ends == BATTEN_END_DIRECTION ||
        o->ends == BATTEN_END_SECOND || o->ends == BATTEN_END_CURVATURE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "ends at corners cannot have a vector of their own");
    return BATTEN_OK;
}

batten_status batten_curve_cornered(batten_points points,
                                    const batten_curve_cornered_options *options,
                                    double *parameters, batten_curve **out)
{
    batten_curve_cornered_options chosen = batten_curve_cornered_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_cornered_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    cornered_fit w = {.options = &chosen,
                      .dimension = points.dimension,
                      .count = points.count,
                      .points = points.at};
    status = check_cornered_options(points.dimension, points.count, w.options);
    if (status == BATTEN_OK)
        status = prepare(&w);
    if (status == BATTEN_OK)
        find_runs(&w);
    for (int i = 0; status == BATTEN_OK && i < w.run_count; i++)
        status = make_run(&w, &w.runs[i], &w.made[i]);
    if (status == BATTEN_OK)
        status = join(&w, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, w.parameters, (size_t)points.count * sizeof *parameters);
    for (int i = 0; i < w.run_count; i++)
        batten_curve_unref(w.made[i]);
    bat_release(w.corner);
    bat_release(w.line);
    bat_release(w.runs);
    bat_release(w.parameters);
    bat_release(w.made);
    return status;
}
