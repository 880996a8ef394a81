/* Clothoids near points: Gauss and Newton on the place, direction, curvature and its rate at
 * one point of the curve, with distances at right angles. */
#include "base/work.h"
#include "numeric/dense.h"
#include "numeric/fresnel.h"
#include "numeric/gauss_newton.h"
#include "numeric/vector.h"
#include "shape/near/primitives.h"
#include "spline/data_check.h"

#include <string.h>

enum { X, Y, ANGLE, CURVATURE, RATE, UNKNOWNS };

/* The first guess looks at so many means of neighbouring data. */
enum { GROUPS = 16 };

typedef struct {
    int count;
    const double *points;
    double *kept;    /* [count] arc lengths of the feet for unknowns that were taken */
    double *lengths; /* [count] of those just tried */
    bat_work work;
    int rounds;           /* in which the residuals were asked for */
    batten_status status; /* of the work: once it is not OK there are no more residuals */
} clothoid_fit;

/* Is s a length at which a clothoid beside the data may have a foot? One that goes around
 * between all data is not what they show; a foot that is sought may run away on a curve that
 * winds up, and the farther it turns, the longer takes each of its points. */
static bool is_near(const clothoid_fit *t, const double *x, double s)
{
    const double turn = 50 + 7.0 * t->count;
    return fabs(x[CURVATURE] * s) + fabs(x[RATE] * s * s) < turn && fabs(s) < 1e4;
}

static double angle_at(const double *x, double s)
{
    return x[ANGLE] + s * (x[CURVATURE] + s * x[RATE] / 2);
}

/* The point at s, and the moments u, v [3] of its direction. */
static void evaluate(const double *x, double s, double point[2], double u[3], double v[3])
{
    const double c[BAT_FRESNEL_DEGREE + 1] = {x[ANGLE], x[CURVATURE] * s, x[RATE] * s * s / 2};
    bat_fresnel(c, 3, u, v);
    point[0] = x[X] + s * u[0];
    point[1] = x[Y] + s * v[0];
}

/* The foot of q near *s; false when the search leaves the lengths beside the data. */
static bool find_foot(const clothoid_fit *t, const double *x, const double *q, double *s)
{
    double point[2], u[3], v[3];
    for (int i = 0; i < 20; i++) {
        if (!is_near(t, x, *s))
            return false;
        evaluate(x, *s, point, u, v);
        const double angle = angle_at(x, *s), c = bat_cos(angle), d = bat_sin(angle);
        const double off[2] = {point[0] - q[0], point[1] - q[1]};
        const double bend = 1 + (x[CURVATURE] + x[RATE] * *s) * (d * -off[0] + c * off[1]);
        const double step = (c * off[0] + d * off[1]) / bat_max(bend, 0.5);
        *s -= step;
        if (fabs(step) <= 1e-15 * (1 + fabs(*s)))
            break;
    }
    return is_near(t, x, *s);
}

/* Rounds that converge are few. */
enum { MOST_ROUNDS = 200, USUAL_ROUNDS = 8, POINTS_A_STEP = 256 };

/* May the round continue with point i? */
static bool may_go_on(clothoid_fit *t, int i)
{
    if (t->status == BATTEN_OK && i % POINTS_A_STEP == 0) {
        const double rounds = t->rounds + (double)i / t->count;
        t->status = bat_work_step(&t->work, POINTS_A_STEP, rounds / (USUAL_ROUNDS + rounds),
                                  "the nearest clothoid");
    }
    return t->status == BATTEN_OK;
}

static bool residuals(void *context, const double *x, double *r, double *derivatives)
{
    clothoid_fit *t = context;
    for (int i = 0; i < t->count; i++) {
        double *s = t->lengths + i, point[2], u[3], v[3];
        *s = t->kept[i]; /* a step that was refused leaves no trace */
        const double *q = t->points + 2 * (size_t)i;
        if (!may_go_on(t, i) || !find_foot(t, x, q, s))
            return false;
        evaluate(x, *s, point, u, v);
        const double angle = angle_at(x, *s), n[2] = {-bat_sin(angle), bat_cos(angle)};
        r[i] = n[0] * (q[0] - point[0]) + n[1] * (q[1] - point[1]);
        if (!derivatives)
            continue;
        double *d = derivatives + (size_t)UNKNOWNS * (size_t)i;
        const double by[3] = {*s, *s * *s, *s * *s * *s / 2};
        d[X] = -n[0];
        d[Y] = -n[1];
        for (int k = 0; k < 3; k++)
            d[ANGLE + k] = -by[k] * (n[1] * u[k] - n[0] * v[k]);
    }
    t->rounds++;
    if (derivatives)
        memcpy(t->kept, t->lengths, (size_t)t->count * sizeof *t->kept);
    return true;
}

/* ---- the first guess ---- */

/* Means of groups of neighbours, and the lengths of their polygon from its middle. */
typedef struct {
    int count;
    double points[2 * GROUPS], lengths[GROUPS];
} groups;

static batten_status find_groups(const bat_cloud *c, groups *g)
{
    g->count = bat_min_int(c->count, GROUPS);
    memset(g->points, 0, sizeof g->points);
    for (int k = 0; k < g->count; k++) {
        const int begin = (int)((long long)c->count * k / g->count),
                  end = (int)((long long)c->count * (k + 1) / g->count);
        for (int i = begin; i < end; i++)
            for (int a = 0; a < 2; a++)
                g->points[2 * k + a] += c->points[2 * i + a] / (end - begin);
    }
    g->lengths[0] = 0;
    for (int k = 1; k < g->count; k++) {
        const double step = bat_distance(2, g->points + 2 * k, g->points + 2 * k - 2);
        if (!(step > 0))
            return bat_fail(BATTEN_COINCIDENT, "points about number %d coincide",
                            (int)((long long)c->count * k / g->count) + 1);
        g->lengths[k] = g->lengths[k - 1] + step;
    }
    const double half = g->lengths[g->count - 1] / 2;
    for (int k = 0; k < g->count; k++)
        g->lengths[k] -= half;
    return BATTEN_OK;
}

/* Directions of the chords, as a parabola of arc length. */
static batten_status guess_angles(const groups *g, double *x)
{
    double a[3 * GROUPS], b[GROUPS], before = 0;
    for (int k = 0; k + 1 < g->count; k++) {
        const double s = (g->lengths[k] + g->lengths[k + 1]) / 2;
        double angle = bat_atan2(g->points[2 * k + 3] - g->points[2 * k + 1],
                                 g->points[2 * k + 2] - g->points[2 * k]);
        if (k > 0)
            angle -= (2 * BAT_PI) * round((angle - before) / (2 * BAT_PI));
        before = angle;
        a[3 * k] = 1;
        a[3 * k + 1] = s;
        a[3 * k + 2] = s * s / 2;
        b[k] = angle;
    }
    const batten_status status = bat_dense_least_squares(g->count - 1, 3, a, 1, b);
    memcpy(x + ANGLE, b, 3 * sizeof *b);
    return status;
}

static batten_status guess(const bat_cloud *c, double *x, double *lengths)
{
    groups g;
    batten_status status = find_groups(c, &g);
    x[X] = x[Y] = 0;
    if (status == BATTEN_OK)
        status = guess_angles(&g, x);
    if (status != BATTEN_OK)
        return status;
    double mean[2] = {0}, point[2], u[3], v[3];
    for (int k = 0; k < g.count; k++) {
        evaluate(x, g.lengths[k], point, u, v);
        mean[0] += (g.points[2 * k] - point[0]) / g.count;
        mean[1] += (g.points[2 * k + 1] - point[1]) / g.count;
    }
    x[X] = mean[0];
    x[Y] = mean[1];
    for (int i = 0; i < c->count; i++) {
        const double at = (i + 0.5) * g.count / c->count - 0.5;
        const int k = bat_max_int(0, bat_min_int((int)floor(at), g.count - 2));
        lengths[i] = g.lengths[k] + (at - k) * (g.lengths[k + 1] - g.lengths[k]);
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status report_clothoid(const bat_cloud *c, const double *x, double *lengths,
                                     batten_span *out)
{
    const double s = lengths[0], whole = lengths[c->count - 1] - s;
    double point[2], u[3], v[3];
    if (!(whole > 0))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "no clothoid was found that runs from the first point to the last");
    evaluate(x, s, point, u, v);
    *out = (batten_span){
        .kind = BATTEN_SPAN_SPIRAL,
        .length = whole * c->size,
        .start = {c->mean[0] + c->size * point[0], c->mean[1] + c->size * point[1]},
        .angle = angle_at(x, s),
        .curvature = {(x[CURVATURE] + s * x[RATE]) / c->size, x[RATE] / (c->size * c->size)}};
    for (int i = 0; i < c->count; i++)
        lengths[i] = (lengths[i] - s) * c->size;
    lengths[0] = 0;
    return BATTEN_OK;
}

static batten_status fit(const bat_cloud *c, const batten_job *job, batten_span *span,
                         double *lengths, batten_primitive_report *report)
{
    double x[UNKNOWNS];
    const size_t n = (size_t)c->count;
    double *distances = bat_array(n, sizeof *distances), *kept = bat_array(n, sizeof *kept);
    clothoid_fit t = {.count = c->count,
                      .points = c->points,
                      .kept = kept,
                      .lengths = lengths,
                      .work = {job, 0}};
    batten_status status = distances && kept ? guess(c, x, kept) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_gauss_newton(bat_max_int(c->count, UNKNOWNS), UNKNOWNS, residuals, &t,
                                  MOST_ROUNDS, x, &report->rounds);
    if (status == BATTEN_OK)
        residuals(&t, x, distances, NULL);
    if (t.status != BATTEN_OK)
        status = t.status;
    if (status == BATTEN_OK) {
        bat_primitive_measure(c->count, distances, c->size, report);
        status = report_clothoid(c, x, lengths, span);
    }
    bat_release(kept);
    bat_release(distances);
    return status;
}

batten_status batten_clothoid_fit(batten_points points, const batten_job *job, double *lengths,
                                  batten_primitive_report *report, batten_span *span)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    bat_cloud cloud;
    batten_primitive_report reached = {0};
    batten_status status = bat_points_check(2, points.count, points.at, 4);
    if (status == BATTEN_OK)
        status = bat_cloud_make(2, points.count, points.at, &cloud);
    if (status != BATTEN_OK)
        return status;
    double *feet = bat_array((size_t)points.count, sizeof *feet);
    status = feet ? fit(&cloud, job, span, feet, &reached) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && lengths)
        memcpy(lengths, feet, (size_t)points.count * sizeof *feet);
    if (status == BATTEN_OK && report)
        *report = reached;
    bat_release(feet);
    bat_cloud_free(&cloud);
    return status;
}
