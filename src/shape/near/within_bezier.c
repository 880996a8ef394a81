/*
 * Cubic Bezier curves through a row of points [Schneider90]: a piece has given end tangents;
 * the lengths of its two arms are those of least squares; parameters move to the feet while
 * that helps; a piece that is still too far off is divided at its worst point, where the
 * tangent is that of the neighbours. Parts whose spans can be paced so that the pieces meet
 * with one derivative become cubics with double knots.
 */
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"
#include "shape/linear/linear_solve.h"
#include "shape/near/within.h"

#include <string.h>

/* Points from .. to of the row, with the directions at both ends, inwards. */
typedef struct {
    int from, to;
    double ends[2][3];
    double arms[2];
} bezier_piece;

typedef struct {
    int dimension, count; /* of points that differ from those before them */
    double tolerance;
    double *points, *parameters; /* of these */
    int *place;                  /* [all] which of these */
    bool closed;
    double *local; /* [count] parameters in a piece */
    int done_count;
    bezier_piece *done, *waiting; /* [count] */
} bezier_fit;

static const double *point_at(const bezier_fit *t, int i)
{
    return t->points + (size_t)i * (size_t)t->dimension;
}

/* ---- directions ---- */

static bool direction(const bezier_fit *t, int from, int to, double *out)
{
    const int d = t->dimension;
    for (int k = 0; k < d; k++)
        out[k] = point_at(t, to)[k] - point_at(t, from)[k];
    const double length = bat_norm(d, out);
    for (int k = 0; k < d && length > 0; k++)
        out[k] /= length;
    return length > 0;
}

/* The direction along the row at a point: that between its neighbours; at an end that of the
 * parabola through three points. */
static void tangent_at(const bezier_fit *t, int i, double *out)
{
    const int last = t->count - 1, d = t->dimension;
    const bool inside = i > 0 && i < last, ring = t->closed && !inside;
    if ((inside && direction(t, i - 1, i + 1, out)) ||
        (ring && last > 1 && direction(t, last - 1, 1, out)))
        return;
    if (inside || last == 1) {
        direction(t, i == last ? i - 1 : i, i == last ? i : i + 1, out);
        return;
    }
    const int step = i == 0 ? 1 : -1;
    const double h[2] = {t->parameters[i + step] - t->parameters[i],
                         t->parameters[i + 2 * step] - t->parameters[i + step]};
    const double *const points[] = {point_at(t, i), point_at(t, i + step),
                                    point_at(t, i + 2 * step)};
    bat_bessel_slope((size_t)d, h, points, out);
    const double length = bat_norm(d, out);
    if (!(length > 0))
        direction(t, i == 0 ? 0 : i - 1, i == 0 ? 1 : i, out);
    for (int k = 0; k < d && length > 0; k++)
        out[k] /= length;
}

/* ---- one piece ---- */

static void control_points(const bezier_fit *t, const bezier_piece *p, double b[4][3])
{
    for (int k = 0; k < t->dimension; k++) {
        b[0][k] = point_at(t, p->from)[k];
        b[3][k] = point_at(t, p->to)[k];
        b[1][k] = b[0][k] + p->arms[0] * p->ends[0][k];
        b[2][k] = b[3][k] + p->arms[1] * p->ends[1][k];
    }
}

/* The 2 x 2 normal equations of the arms; a third of the chord when they make no sense. */
static void find_arms(const bezier_fit *t, bezier_piece *p)
{
    const int d = t->dimension;
    const double *a = point_at(t, p->from), *z = point_at(t, p->to);
    const double chord = bat_distance(d, a, z);
    double c[3] = {0}, x[2] = {0}, way = bat_distance(d, point_at(t, p->to - 1), z);
    for (int i = p->from + 1; i < p->to; i++) {
        way += bat_distance(d, point_at(t, i - 1), point_at(t, i));
        const double u = t->local[i], v = 1 - u, b1 = 3 * u * v * v, b2 = 3 * u * u * v;
        const double start = v * v * v + b1, end = u * u * u + b2;
        double rest[3];
        for (int k = 0; k < d; k++)
            rest[k] = point_at(t, i)[k] - start * a[k] - end * z[k];
        const double cosine = bat_dot(d, p->ends[0], p->ends[1]);
        c[0] += b1 * b1;
        c[1] += b1 * b2 * cosine;
        c[2] += b2 * b2;
        x[0] += b1 * bat_dot(d, p->ends[0], rest);
        x[1] += b2 * bat_dot(d, p->ends[1], rest);
    }
    const double det = c[0] * c[2] - c[1] * c[1];
    p->arms[0] = (x[0] * c[2] - x[1] * c[1]) / det;
    p->arms[1] = (c[0] * x[1] - c[1] * x[0]) / det;
    /* Much shorter arms are cusps in the making, longer ones than the way itself loops. */
    for (int e = 0; e < 2; e++)
        if (!(p->arms[e] > 1e-3 * chord && p->arms[e] < way)) {
            p->arms[0] = p->arms[1] = chord / 3;
            return;
        }
}

/* The point at u and two derivatives. */
static void evaluate(int d, double b[4][3], double u, double at[3][3])
{
    const double v = 1 - u;
    for (int k = 0; k < d; k++) {
        at[0][k] = v * v * v * b[0][k] + 3 * u * v * v * b[1][k] + 3 * u * u * v * b[2][k] +
                   u * u * u * b[3][k];
        at[1][k] = 3 * (v * v * (b[1][k] - b[0][k]) + 2 * u * v * (b[2][k] - b[1][k]) +
                        u * u * (b[3][k] - b[2][k]));
        at[2][k] =
            6 * (v * (b[2][k] - 2 * b[1][k] + b[0][k]) + u * (b[3][k] - 2 * b[2][k] + b[1][k]));
    }
}

static double worst_of(const bezier_fit *t, const bezier_piece *p, int *worst)
{
    double b[4][3], at[3][3], largest = 0;
    control_points(t, p, b);
    *worst = (p->from + p->to) / 2;
    for (int i = p->from + 1; i < p->to; i++) {
        evaluate(t->dimension, b, t->local[i], at);
        const double distance = bat_distance(t->dimension, at[0], point_at(t, i));
        if (distance > largest) {
            largest = distance;
            *worst = i;
        }
    }
    return largest;
}

/* One step of Newton towards each foot, in the same order. */
static void correct(const bezier_fit *t, const bezier_piece *p)
{
    const int d = t->dimension;
    double b[4][3], at[3][3], rows[9];
    control_points(t, p, b);
    for (int i = p->from + 1; i < p->to; i++) {
        evaluate(d, b, t->local[i], at);
        for (int row = 0; row < 3; row++)
            memcpy(rows + row * d, at[row], (size_t)d * sizeof *rows);
        const double u = t->local[i] + bat_foot_curve_step(d, rows, point_at(t, i));
        t->local[i] = bat_min(1, bat_max(i > p->from + 1 ? t->local[i - 1] : 0, u));
    }
}

/* Worth moving parameters: so many times the tolerance, and so many rounds. */
enum { NEAR = 4, ROUNDS = 20 };

static bool fit_piece(const bezier_fit *t, bezier_piece *p, int *worst)
{
    const double a = t->parameters[p->from], h = t->parameters[p->to] - a;
    for (int i = p->from; i <= p->to; i++)
        t->local[i] = (t->parameters[i] - a) / h;
    find_arms(t, p);
    double error = worst_of(t, p, worst);
    for (int i = 0; i < ROUNDS && error > t->tolerance && error <= NEAR * t->tolerance; i++) {
        correct(t, p);
        find_arms(t, p);
        error = worst_of(t, p, worst);
    }
    return error <= t->tolerance;
}

/* Ask after so many data at least: some milliseconds. */
enum { DATA_OF_STEP = 10000 };

/* Whole first; halves wait, the left one on top. */
static batten_status divide(bezier_fit *t, const bat_within_row *row)
{
    int waiting = 0, looked_at = 0;
    batten_status status = BATTEN_OK;
    bezier_piece whole = {.from = 0, .to = t->count - 1};
    tangent_at(t, 0, whole.ends[0]);
    tangent_at(t, t->count - 1, whole.ends[1]);
    for (int k = 0; k < t->dimension; k++)
        whole.ends[1][k] = -whole.ends[1][k];
    t->waiting[waiting++] = whole;
    while (waiting > 0 && status == BATTEN_OK) {
        bezier_piece p = t->waiting[--waiting];
        int worst;
        looked_at += p.to - p.from;
        if (looked_at >= DATA_OF_STEP) {
            const double share = (double)p.from / t->count;
            status = bat_work_step(row->work, (uint64_t)looked_at,
                                   row->done[0] + share * (row->done[1] - row->done[0]),
                                   "fitting cubics");
            looked_at = 0;
        }
        if (fit_piece(t, &p, &worst)) {
            t->done[t->done_count++] = p;
            continue;
        }
        bezier_piece left = p, right = p;
        double along[3];
        tangent_at(t, worst, along);
        left.to = right.from = worst;
        for (int k = 0; k < t->dimension; k++) {
            left.ends[1][k] = -along[k];
            right.ends[0][k] = along[k];
        }
        t->waiting[waiting++] = right;
        t->waiting[waiting++] = left;
    }
    return status;
}

/* ---- the curve ---- */

/* A run of pieces is paced so that derivatives agree; it ends where spans would become too
 * different from those of the data. Returns the piece after the last. */
static int pace(const bezier_fit *t, int first, double *lengths)
{
    double speed = 0;
    int i = first;
    for (; i < t->done_count; i++) {
        const bezier_piece *p = &t->done[i];
        const double own = t->parameters[p->to] - t->parameters[p->from];
        lengths[i] = i == first ? own : 3 * p->arms[0] / speed;
        if (!(lengths[i] > own / 64 && lengths[i] < 64 * own))
            break;
        speed = 3 * p->arms[1] / lengths[i];
    }
    return i;
}

static batten_status make_run(const bezier_fit *t, int first, int last, const double *breaks,
                              batten_curve **out)
{
    const int d = t->dimension, n = last - first + 1;
    double *values = bat_array3((size_t)n, 2 * (size_t)d, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < n; j++) {
        const int i = first + j;
        const bool ends = i == last;
        const bezier_piece *p = &t->done[ends ? i - 1 : i];
        const double h = ends ? breaks[i] - breaks[i - 1] : breaks[i + 1] - breaks[i];
        for (int k = 0; k < d; k++) {
            values[2 * d * j + k] = point_at(t, ends ? p->to : p->from)[k];
            values[2 * d * j + d + k] =
                (ends ? -1 : 1) * 3 * p->arms[ends] * p->ends[ends][k] / h;
        }
    }
    const batten_status status =
        batten_curve_from_hermite(d, n, 2, breaks + first, values, out);
    bat_release(values);
    return status;
}

static batten_status make_curve(const bezier_fit *t, double *breaks, batten_curve **out)
{
    const size_t n = (size_t)t->done_count;
    double *lengths = bat_array(n, sizeof *lengths);
    batten_curve **runs = bat_array(n, sizeof(batten_curve *));
    batten_status status = lengths && runs ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int first = 0, next; status == BATTEN_OK && first < t->done_count; first = next) {
        next = pace(t, first, lengths);
        for (int i = first; i < next; i++)
            breaks[i + 1] = breaks[i] + lengths[i];
        status = make_run(t, first, next, breaks, &runs[count]);
        count += status == BATTEN_OK;
    }
    if (status == BATTEN_OK)
        status = bat_curve_chained(count, runs, out);
    for (int i = 0; i < count; i++)
        batten_curve_unref(runs[i]);
    bat_release(runs);
    bat_release(lengths);
    return status;
}

/* ---- the whole ---- */

static batten_status allocate_pieces(bezier_fit *t, int count, const double *points,
                                     const double *parameters)
{
    const size_t n = (size_t)count, d = (size_t)t->dimension;
    t->points = bat_array3(n, d, sizeof *t->points);
    t->parameters = bat_array(n, sizeof *t->parameters);
    t->local = bat_array(n, sizeof *t->local);
    t->place = bat_array(n, sizeof *t->place);
    t->done = bat_array(n, sizeof *t->done);
    t->waiting = bat_array(n, sizeof *t->waiting);
    if (!t->points || !t->parameters || !t->local || !t->place || !t->done || !t->waiting)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < n; i++) {
        const double *q = points + i * d;
        const bool same = t->count > 0 && !(parameters[i] > t->parameters[t->count - 1]);
        if (!same) {
            memcpy(t->points + (size_t)t->count * d, q, d * sizeof *q);
            t->parameters[t->count++] = parameters[i];
        }
        t->place[i] = t->count - 1;
    }
    return BATTEN_OK;
}

static void release_pieces(bezier_fit *t)
{
    bat_release(t->points);
    bat_release(t->parameters);
    bat_release(t->local);
    bat_release(t->place);
    bat_release(t->done);
    bat_release(t->waiting);
}

/* Parameters on the curve, from those in the pieces. */
static void copy_parameters(bezier_fit *t, int count, const double *breaks, double *parameters)
{
    for (int i = 0; i < t->done_count; i++) {
        const bezier_piece *p = &t->done[i];
        for (int k = p->from; k <= p->to; k++)
            t->parameters[k] = k == p->to
                                   ? breaks[i + 1]
                                   : breaks[i] + t->local[k] * (breaks[i + 1] - breaks[i]);
    }
    for (int i = 0; i < count; i++)
        parameters[i] = t->parameters[t->place[i]];
}

batten_status bat_within_bezier(const bat_within_row *row, double *parameters,
                                batten_curve **out)
{
    bezier_fit t = {
        .dimension = row->dimension, .tolerance = row->tolerance, .closed = row->closed};
    double *breaks = bat_array((size_t)row->count + 1, sizeof *breaks);
    batten_status status = allocate_pieces(&t, row->count, row->points, parameters);
    if (!breaks)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        breaks[0] = parameters[0];
        status = divide(&t, row);
    }
    if (status == BATTEN_OK)
        status = make_curve(&t, breaks, out);
    if (status == BATTEN_OK)
        copy_parameters(&t, row->count, breaks, parameters);
    bat_release(breaks);
    release_pieces(&t);
    return status;
}
