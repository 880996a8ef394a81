/*
 * The cubic spline of least energy through points with directions, but not lengths, of the
 * derivative given at some of them; a banded system yields the slopes. Source: [SL] III.7,
 * [Nielson74].
 */
#include "base/plural.h"
#include "numeric/banded.h"
#include "numeric/vector.h"
#include <batten/local.h>

#include <string.h>

/*
 * With slopes m the energy of the span from P0 to P1 of length h is
 *
 *     4 (m0^2 + m0 m1 + m1^2) / h - 12 (m0 + m1) (P1 - P0) / h^2 + 12 |P1 - P0|^2 / h^3.
 *
 * A slope is a vector of d unknowns, or one unknown times a direction. The gradient is linear,
 * its matrix positive definite with blocks next to the diagonal.
 */
typedef struct {
    int dimension, count;
    const double *points, *tension;
    double *steps;      /* [count - 1] */
    double *direction;  /* [count][3] unit vectors; zeros where there is none */
    int *first;         /* [count + 1] the first unknown of each point */
    double *fixed;      /* [count] 0, or the length that a clamped slope has */
    double *matrix, *b; /* the equations */
    double *slopes;     /* [count][d] */
    batten_curve_directed_report report;
} direction_search;

batten_curve_directed_options batten_curve_directed_defaults(void)
{
    return (batten_curve_directed_options){.size = sizeof(batten_curve_directed_options),
                                           .parameters = BATTEN_CHORD};
}

static bool is_directed(const direction_search *w, int i)
{
    const double *u = w->direction + 3 * i;
    return u[0] != 0 || u[1] != 0 || u[2] != 0;
}

static int unknowns_of(const direction_search *w, int i)
{
    return w->fixed[i] > 0 ? 0 : is_directed(w, i) ? 1 : w->dimension;
}

/* The vector by which unknown k of point i moves its slope. */
static void basis(const direction_search *w, int i, int k, double *out)
{
    for (int c = 0; c < 3; c++)
        out[c] = is_directed(w, i) ? w->direction[3 * i + c] : c == k;
}

enum { LOWER = 5, WIDTH = LOWER + 1 }; /* two points of 3 unknowns each */

/* Add factor (basis of a) . (basis of b) to the lower half. */
static void add_block(direction_search *w, int i, int j, double factor)
{
    for (int a = w->first[i]; a < w->first[i + 1]; a++)
        for (int b = w->first[j]; b < w->first[j + 1]; b++) {
            double u[3], v[3];
            basis(w, i, a - w->first[i], u);
            basis(w, j, b - w->first[j], v);
            if (b <= a)
                w->matrix[a * WIDTH + (b - a + LOWER)] += factor * bat_dot(3, u, v);
        }
}

static void add_right(direction_search *w, int i, double factor, const double *vector)
{
    for (int a = w->first[i]; a < w->first[i + 1]; a++) {
        double u[3];
        basis(w, i, a - w->first[i], u);
        w->b[a] += factor * bat_dot(w->dimension, u, vector);
    }
}

static void add_span(direction_search *w, int i)
{
    const int d = w->dimension;
    const double h = w->steps[i];
    double chord[3] = {0}, fixed[2][3] = {{0}};
    for (int k = 0; k < d; k++) {
        chord[k] = w->points[(i + 1) * d + k] - w->points[i * d + k];
        for (int e = 0; e < 2; e++)
            fixed[e][k] = w->fixed[i + e] * w->direction[3 * (i + e) + k];
    }
    add_block(w, i, i, 4 / h);
    add_block(w, i + 1, i + 1, 4 / h);
    add_block(w, i + 1, i, 2 / h);
    for (int e = 0; e < 2; e++) {
        add_right(w, i + e, 6 / (h * h), chord);
        add_right(w, i + e, -4 / h, fixed[e]); /* 0 unless it has no unknown itself */
        add_right(w, i + e, -2 / h, fixed[!e]);
    }
}

static void take_slopes(direction_search *w)
{
    for (int i = 0; i < w->count; i++) {
        double slope[3] = {0};
        for (int k = 0; k < 3; k++)
            slope[k] = w->fixed[i] * w->direction[3 * i + k];
        for (int a = w->first[i]; a < w->first[i + 1]; a++) {
            double u[3];
            basis(w, i, a - w->first[i], u);
            for (int k = 0; k < 3; k++)
                slope[k] += w->b[a] * u[k];
        }
        memcpy(w->slopes + i * w->dimension, slope, (size_t)w->dimension * sizeof *slope);
    }
}

static batten_status solve(direction_search *w)
{
    for (int i = 0; i < w->count; i++)
        w->first[i + 1] = w->first[i] + unknowns_of(w, i);
    const int n = w->first[w->count];
    memset(w->matrix, 0, (size_t)n * WIDTH * sizeof *w->matrix);
    memset(w->b, 0, (size_t)n * sizeof *w->b);
    for (int i = 0; i + 1 < w->count; i++)
        add_span(w, i);
    for (int i = 0; w->tension && i < w->count; i++)
        add_block(w, i, i, w->tension[i]);
    batten_status status = n > 0 ? bat_symmetric_factor(n, LOWER, w->matrix) : BATTEN_OK;
    if (status != BATTEN_OK)
        return status;
    if (n > 0)
        bat_symmetric_solve(n, LOWER, w->matrix, 1, w->b);
    take_slopes(w);
    return BATTEN_OK;
}

/* The mean speed of the chords next to a point. */
static double mean_speed(const direction_search *w, int i)
{
    const int d = w->dimension, n = w->count;
    double length = 0, time = 0;
    for (int s = bat_max_int(i - 1, 0); s < bat_min_int(i + 1, n - 1); s++) {
        length += bat_distance(d, w->points + s * d, w->points + (s + 1) * d);
        time += w->steps[s];
    }
    return length / time;
}

/* Directions whose length came out 0 or negative get a small one; each is clamped once, so
 * there are at most as many rounds as directions. */
static int clamp(direction_search *w)
{
    int clamped = 0;
    for (int i = 0; i < w->count; i++)
        if (is_directed(w, i) && w->fixed[i] == 0 && !(w->b[w->first[i]] > 0)) {
            w->fixed[i] = mean_speed(w, i) / 10;
            clamped++;
        }
    return clamped;
}

static void measure_chords(direction_search *w)
{
    const int d = w->dimension;
    w->report.first_clamped = -1;
    for (int i = w->count - 1; i >= 0; i--) {
        const double *m = w->slopes + i * d;
        if (w->fixed[i] > 0) {
            w->report.clamped++;
            w->report.first_clamped = i;
        }
        if (w->tension)
            w->report.energy += w->tension[i] * bat_dot(d, m, m);
        for (int k = 0; i + 1 < w->count && k < d; k++) {
            const double h = w->steps[i], a = m[k], b = m[d + k];
            const double chord = (w->points[(i + 1) * d + k] - w->points[i * d + k]) / h;
            /* The same energy about the chord: nothing cancels when the curve is straight. */
            const double p = a - chord, q = b - chord;
            w->report.energy += 4 / h * (p * p + p * q + q * q);
        }
    }
}

/* ---- input ---- */

static batten_status check_directions(direction_search *w,
                                      const batten_curve_directed_options *o)
{
    for (int k = 0; k < o->direction_count; k++) {
        const batten_direction_at *at = &o->directions[k];
        const int d = w->dimension;
        if (at->index < 0 || at->index >= w->count ||
            (k > 0 && at->index <= o->directions[k - 1].index))
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "direction %d belongs to point %d; points must rise from 1 to %d",
                            k + 1, at->index + 1, w->count);
        if (bat_first_not_finite(at->vector, (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_NOT_FINITE, "the direction at point %d is not finite",
                            at->index + 1);
        const double length = bat_norm(d, at->vector);
        if (!(length > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the direction at point %d has length 0",
                            at->index + 1);
        for (int c = 0; c < d; c++)
            w->direction[3 * at->index + c] = at->vector[c] / length;
    }
    for (int i = 0; o->tension && i < w->count; i++)
        if (!(o->tension[i] >= 0 && isfinite(o->tension[i])))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tension %g at point %d is below 0",
                            o->tension[i], i + 1);
    return BATTEN_OK;
}

static batten_status find_parameters(direction_search *w,
                                     const batten_curve_directed_options *o, double *t)
{
    if (o->parameters != BATTEN_GIVEN) {
        const batten_status status = batten_parametrize(
            (batten_points){w->dimension, w->count, w->points}, o->parameters, false, t);
        if (status != BATTEN_OK)
            return status;
    } else {
        const size_t n = (size_t)w->count, d = (size_t)w->dimension;
        if (bat_first_not_finite(w->points, n * d) < n * d)
            return bat_fail(BATTEN_NOT_FINITE, "point %d is not finite",
                            (int)(bat_first_not_finite(w->points, n * d) / d) + 1);
        memcpy(t, o->given, n * sizeof *t);
    }
    for (int i = 0; i + 1 < w->count; i++) {
        w->steps[i] = t[i + 1] - t[i];
        if (!(w->steps[i] > 0 && isfinite(w->steps[i])))
            return bat_fail(BATTEN_NOT_INCREASING, "parameter %d is %g, parameter %d is %g",
                            i + 1, t[i], i + 2, t[i + 1]);
    }
    return BATTEN_OK;
}

static batten_status allocate(direction_search *w)
{
    const size_t n = (size_t)w->count;
    w->steps = bat_array(n, sizeof *w->steps);
    w->direction = bat_array(3 * n, sizeof *w->direction);
    w->first = bat_array(n + 1, sizeof *w->first);
    w->fixed = bat_array(n, sizeof *w->fixed);
    w->matrix = bat_array3(3 * n, WIDTH, sizeof *w->matrix);
    w->b = bat_array(3 * n, sizeof *w->b);
    w->slopes = bat_array3(n, 3, sizeof *w->slopes);
    return w->steps && w->direction && w->first && w->fixed && w->matrix && w->b && w->slopes
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

static void release(direction_search *w)
{
    bat_release(w->steps);
    bat_release(w->direction);
    bat_release(w->first);
    bat_release(w->fixed);
    bat_release(w->matrix);
    bat_release(w->b);
    bat_release(w->slopes);
}

static batten_status make_curve(const direction_search *w, const double *t, batten_curve **out)
{
    const size_t d = (size_t)w->dimension;
    double *values = bat_array3((size_t)w->count, 2 * d, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < (size_t)w->count; i++) {
        memcpy(values + 2 * d * i, w->points + d * i, d * sizeof *values);
        memcpy(values + 2 * d * i + d, w->slopes + d * i, d * sizeof *values);
    }
    const batten_status status =
        batten_curve_from_hermite(w->dimension, w->count, 2, t, values, out);
    bat_release(values);
    return status;
}

batten_status batten_curve_directed(batten_points points,
                                    const batten_curve_directed_options *options,
                                    double *parameters, batten_curve_directed_report *report,
                                    batten_curve **out)
{
    batten_curve_directed_options o = batten_curve_directed_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_directed_options, options, &o);
    if (status != BATTEN_OK)
        return status;
    direction_search w = {.dimension = points.dimension,
                          .count = points.count,
                          .points = points.at,
                          .tension = o.tension};
    if (points.dimension < 1 || points.dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve cannot have dimension %d",
                        points.dimension);
    if (points.count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d point%s %s given; 2 are needed",
                        points.count, bat_plural(points.count),
                        bat_one_or_many(points.count, "is", "are"));
    double *t = bat_array((size_t)points.count, sizeof *t);
    status = t ? allocate(&w) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_parameters(&w, &o, t);
    if (status == BATTEN_OK)
        status = check_directions(&w, &o);
    do {
        if (status == BATTEN_OK)
            status = solve(&w);
    } while (status == BATTEN_OK && clamp(&w) > 0);
    if (status == BATTEN_OK)
        status = make_curve(&w, t, out);
    if (status == BATTEN_OK) {
        measure_chords(&w);
        if (report)
            *report = w.report;
        if (parameters)
            memcpy(parameters, t, (size_t)points.count * sizeof *t);
    }
    release(&w);
    bat_release(t);
    return status;
}
