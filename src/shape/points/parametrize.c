/*
 * Parameters for data points: uniform, chordal, centripetal, and Foley's, which weighs in the
 * angles and may use Nielson's affine invariant metric.
 */
#include "shape/points/parametrize.h"
#include "base/plural.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* How long a step between points is: Euclidean, or after Nielson |L^-1 (S^-1 v)|, where S
 * scales each coordinate by its spread and L L^T is the correlation of the points. Then
 * lengths, and angles made of lengths, do not change under affine maps. Points that fill only a
 * plane or a line are measured within it: L has `rank` columns, and its rows are taken in the
 * order `row`. */
typedef struct {
    int dimension, rank; /* rank 0: Euclidean */
    int row[3];
    double scale[3];
    double l[3][3];
} metric;

static double length_of(int d, const double *v)
{
    double sum = 0, size = 0;
    for (int k = 0; k < d; k++)
        sum += v[k] * v[k];
    if (sum > 0x1p-900 && sum < 0x1p900)
        return sqrt(sum);
    for (int k = 0; k < d; k++)
        size = bat_max(size, fabs(v[k]));
    if (size == 0)
        return 0;
    sum = 0;
    for (int k = 0; k < d; k++)
        sum += (v[k] / size) * (v[k] / size);
    return size * sqrt(sum);
}

/* The step in the coordinates in which its length is Euclidean; their count is returned. */
static int step_in(const metric *m, const double *from, const double *to, double *y)
{
    if (m->rank == 0) {
        for (int k = 0; k < m->dimension; k++)
            y[k] = to[k] - from[k];
        return m->dimension;
    }
    for (int i = 0; i < m->rank; i++) {
        const int k = m->row[i];
        y[i] = (to[k] - from[k]) / m->scale[k];
        for (int j = 0; j < i; j++)
            y[i] -= m->l[i][j] * y[j];
        y[i] /= m->l[i][i];
    }
    return m->rank;
}

static double step_length(const metric *m, const double *from, const double *to)
{
    double y[3];
    return length_of(step_in(m, from, to, y), y);
}

/* ---- the metric of Nielson ---- */

/* Mean and standard deviation of coordinate k; scaled by its range, so nothing overflows. */
static void find_spread(batten_points points, int k, double *mean, double *spread)
{
    const int count = points.count;
    const double *at = points.at + k;
    const size_t d = (size_t)points.dimension;
    double low = at[0], high = at[0], sum = 0, squares = 0;
    for (int i = 0; i < count; i++) {
        low = bat_min(low, at[(size_t)i * d]);
        high = bat_max(high, at[(size_t)i * d]);
    }
    const double range = high > low ? high - low : 1;
    for (int i = 0; i < count; i++)
        sum += (at[(size_t)i * d] - low) / range;
    *mean = low + sum / count * range;
    for (int i = 0; i < count; i++) {
        const double off = (at[(size_t)i * d] - *mean) / range;
        squares += off * off;
    }
    *spread = high > low ? range * sqrt(squares / count) : 0;
}

static double correlation(batten_points points, const double *mean, const double *spread, int a,
                          int b)
{
    const int count = points.count;
    double sum = 0;
    for (int i = 0; i < count && spread[a] > 0 && spread[b] > 0; i++) {
        const double *point = points.at + (size_t)i * (size_t)points.dimension;
        sum += (point[a] - mean[a]) / spread[a] * ((point[b] - mean[b]) / spread[b]);
    }
    return sum / count;
}

static void swap_rows(metric *m, int a, int b)
{
    const int row = m->row[a];
    m->row[a] = m->row[b];
    m->row[b] = row;
    for (int j = 0; j < m->dimension; j++) {
        const double kept = m->l[a][j];
        m->l[a][j] = m->l[b][j];
        m->l[b][j] = kept;
    }
}

/* Cholesky of the correlation c, the largest remaining pivot first. */
static void factor_metric(double c[3][3], metric *m)
{
    const int d = m->dimension;
    for (int r = 0; r < d; r++) {
        int best = r;
        for (int i = r + 1; i < d; i++)
            if (c[m->row[i]][m->row[i]] > c[m->row[best]][m->row[best]])
                best = i;
        const double pivot = c[m->row[best]][m->row[best]];
        /* The diagonal began as 1, and each step rounded it a few times. */
        if (!(pivot > 64 * DBL_EPSILON))
            return;
        swap_rows(m, r, best);
        m->l[r][r] = sqrt(pivot);
        for (int i = r + 1; i < d; i++)
            m->l[i][r] = c[m->row[i]][m->row[r]] / m->l[r][r];
        for (int i = r + 1; i < d; i++)
            for (int j = r + 1; j < d; j++)
                c[m->row[i]][m->row[j]] -= m->l[i][r] * m->l[j][r];
        m->rank = r + 1;
    }
}

static metric metric_of(batten_points points)
{
    const int d = points.dimension;
    metric m = {.dimension = d, .row = {0, 1, 2}};
    double mean[3], c[3][3] = {{0}};
    for (int k = 0; k < d; k++)
        find_spread(points, k, &mean[k], &m.scale[k]);
    for (int a = 0; a < d; a++)
        for (int b = 0; b < d; b++)
            c[a][b] = correlation(points, mean, m.scale, a, b);
    factor_metric(c, &m);
    return m;
}

/* ---- steps ---- */

/* How much a corner lengthens the steps beside it: 3/2 min(turning angle, pi/2). The angle
 * between unit vectors u, v is 2 atan2(|u - v|, |u + v|), accurate for small and for large
 * ones. */
static double corner(const metric *m, const double *a, const double *b, const double *c)
{
    double u[3], v[3], sum[3], difference[3];
    const int n = step_in(m, a, b, u);
    step_in(m, b, c, v);
    const double size_u = length_of(n, u), size_v = length_of(n, v);
    for (int k = 0; k < n; k++) {
        sum[k] = u[k] / size_u + v[k] / size_v;
        difference[k] = u[k] / size_u - v[k] / size_v;
    }
    const double turn = 2 * bat_atan2(length_of(n, difference), length_of(n, sum));
    return 1.5 * bat_min(turn, bat_acos(0));
}

typedef struct {
    int dimension, count;
    bool closed;
    const double *points;
    metric metric;
} polygon;

static const double *vertex(const polygon *p, int i)
{
    return p->points + (size_t)((i + p->count) % p->count) * (size_t)p->dimension;
}

/* Neighbours without length have no corner. */
static double foley_step(const polygon *p, int i)
{
    const metric *m = &p->metric;
    const double *a = vertex(p, i), *b = vertex(p, i + 1);
    const double step = step_length(m, a, b);
    double factor = 1;
    if (step > 0 && (p->closed || i > 0)) {
        const double *before = vertex(p, i - 1);
        const double length = step_length(m, before, a);
        if (length > 0)
            factor += corner(m, before, a, b) * (length / (length + step));
    }
    if (step > 0 && (p->closed || i + 2 < p->count)) {
        const double *after = vertex(p, i + 2);
        const double length = step_length(m, b, after);
        if (length > 0)
            factor += corner(m, a, b, after) * (length / (length + step));
    }
    return step * factor;
}

static double step_of(const polygon *p, batten_parametrization kind, int i)
{
    switch (kind) {
    case BATTEN_UNIFORM:
        return 1;
    case BATTEN_CHORD:
        return step_length(&p->metric, vertex(p, i), vertex(p, i + 1));
    case BATTEN_CENTRIPETAL:
        return sqrt(step_length(&p->metric, vertex(p, i), vertex(p, i + 1)));
    default:
        return foley_step(p, i);
    }
}

/* ---- checks ---- */

static batten_status bad_pair(int count, int i, double step)
{
    const int next = (i + 1) % count;
    if (step == 0)
        return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide", i + 1, next + 1);
    return bat_fail(BATTEN_OVERFLOW, "points %d and %d are too far apart", i + 1, next + 1);
}

void bat_steps(batten_points points, batten_parametrization kind, bool closed, double *steps)
{
    const int d = points.dimension, count = points.count;
    polygon p = {d, count, closed, points.at, {.dimension = d}};
    if (kind == BATTEN_FOLEY)
        p.metric = metric_of(points);
    for (int i = 0; i < (closed ? count : count - 1); i++)
        steps[i] = step_of(&p, kind, i);
}

/* From the steps that stand in parameters[1] and on to their sums. */
static batten_status sum_steps(int count, bool closed, double *parameters)
{
    parameters[0] = 0;
    for (int i = 0; i < (closed ? count : count - 1); i++) {
        const double step = parameters[i + 1];
        if (!(step > 0 && isfinite(parameters[i] + step)))
            return bad_pair(count, i, step);
        parameters[i + 1] = parameters[i] + step;
        if (parameters[i + 1] == parameters[i])
            return bat_fail(BATTEN_COINCIDENT,
                            "points %d and %d coincide: the step %g is lost in %g", i + 1,
                            (i + 1) % count + 1, step, parameters[i]);
    }
    return BATTEN_OK;
}

batten_status bat_parametrize(batten_points points, batten_parametrization kind, bool closed,
                              double *parameters)
{
    bat_steps(points, kind, closed, parameters + 1);
    return sum_steps(points.count, closed, parameters);
}

batten_status bat_parametrize_power(batten_points points, double alpha, bool closed,
                                    double *parameters)
{
    const batten_parametrization kind = alpha == 0     ? BATTEN_UNIFORM
                                        : alpha == 0.5 ? BATTEN_CENTRIPETAL
                                                       : BATTEN_CHORD;
    bat_steps(points, kind, closed, parameters + 1);
    if (kind == BATTEN_CHORD && alpha != 1)
        for (int i = 1; i < points.count + closed; i++)
            parameters[i] = bat_pow(parameters[i], alpha);
    return sum_steps(points.count, closed, parameters);
}

batten_status batten_parametrize(batten_points points, batten_parametrization kind, bool closed,
                                 double *parameters)
{
    batten_status status = bat_points_check(points.dimension, points.count, points.at, 2);
    if (status == BATTEN_OK && ((int)kind < 0 || kind >= BATTEN_GIVEN))
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "parametrization %d cannot be computed from points", (int)kind);
    if (status != BATTEN_OK)
        return status;
    const size_t wanted = (size_t)points.count + closed;
    double *made = bat_array(wanted, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    status = bat_parametrize(points, kind, closed, made);
    if (status == BATTEN_OK)
        memcpy(parameters, made, wanted * sizeof *made);
    bat_release(made);
    return status;
}

batten_status bat_parameters_of(batten_points points, batten_parametrization kind,
                                const double *given, bool closed, double **out)
{
    const int wanted = points.count + closed;
    *out = bat_resize(NULL, (size_t)wanted, sizeof **out);
    if (!*out)
        return BATTEN_OUT_OF_MEMORY;
    if (kind != BATTEN_GIVEN)
        return bat_parametrize(points, kind, closed, *out);
    if (!given)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the parameters must be given, and are missing");
    memcpy(*out, given, (size_t)wanted * sizeof **out);
    return bat_parameters_check(wanted, *out);
}
