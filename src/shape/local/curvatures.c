/* Plane cubics with tangents and curvatures given. */
#include "numeric/vector.h"
#include "shape/local/curvature_ends.h"
#include "shape/local/hermite_data.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"

#include <string.h>

typedef struct {
    int count;
    bool closed;
    const double *points, *curvatures;
    double *t;                  /* [count], closed [count + 1] */
    double *unit;               /* [count][2] directions */
    double *leaving, *arriving; /* [count][2] */
    int *solutions;             /* of each span */
    batten_curve_from_curvatures_report report;
} curvature_fit;

static double cross(const double *u, const double *v)
{
    return u[0] * v[1] - u[1] * v[0];
}

static batten_status make_units(curvature_fit *t, const double *tangents)
{
    for (int i = 0; i < t->count; i++) {
        const double size = bat_norm(2, tangents + 2 * i);
        if (!(size > 0))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the tangent at point %d has no length",
                            i + 1);
        /* Twice, for that of a denormal vector is far from a unit. */
        const double near[2] = {tangents[2 * i] / size, tangents[2 * i + 1] / size};
        const double rest = bat_norm(2, near);
        t->unit[2 * i] = near[0] / rest;
        t->unit[2 * i + 1] = near[1] / rest;
    }
    return BATTEN_OK;
}

/* How far the curvature at the start of a span is from k0, times the chord. */
static double curvature_off(const double *t0, const double *t1, const double *q, double start,
                            double end, double k0)
{
    const double l = bat_norm(2, q), d[2] = {q[0] / l, q[1] / l}, x = start / l, y = end / l;
    return fabs((cross(t0, d) - cross(t0, t1) * y) / (1.5 * x * x) - k0 * l);
}

static void make_span(curvature_fit *t, int i)
{
    const int j = bat_around(t->count, i + 1);
    const double *a = t->points + 2 * i, *b = t->points + 2 * j;
    const double *t0 = t->unit + 2 * i, *t1 = t->unit + 2 * j;
    const double q[2] = {b[0] - a[0], b[1] - a[1]}, step = t->t[i + 1] - t->t[i];
    const double k0 = t->curvatures[i], k1 = t->curvatures[j], l = bat_norm(2, q);
    bat_legs legs[BAT_DBHS_SOLUTIONS];
    const int count = bat_dbhs(t0, t1, q, k0, k1, legs);
    t->solutions[i] = count;
    if (count == 0) {
        const double u[2] = {q[0] / l, q[1] / l}, leg = l * bat_middle_leg(2, u, t0, t1);
        legs[0] = (bat_legs){leg, leg};
        if (t->report.fallen_back++ == 0)
            t->report.first_fallen_back = i;
    } else {
        const double back0[2] = {-t1[0], -t1[1]}, back1[2] = {-t0[0], -t0[1]};
        const double back[2] = {-q[0], -q[1]}, x = legs[0].start, y = legs[0].end;
        t->report.several += count > 1;
        t->report.error = bat_max(t->report.error, curvature_off(t0, t1, q, x, y, k0));
        t->report.error =
            bat_max(t->report.error, curvature_off(back0, back1, back, y, x, -k1));
    }
    for (int k = 0; k < 2; k++) {
        t->leaving[2 * i + k] = 3 * legs[0].start / step * t0[k];
        t->arriving[2 * j + k] = 3 * legs[0].end / step * t1[k];
    }
}

static batten_status make_quintic(curvature_fit *t, const double *tangents,
                                  batten_curve **curve)
{
    batten_status status =
        bat_parametrize((batten_points){2, t->count, t->points}, BATTEN_CHORD, t->closed, t->t);
    if (status == BATTEN_OK)
        status = make_units(t, tangents);
    if (status != BATTEN_OK)
        return status;
    const int spans = t->closed ? t->count : t->count - 1;
    t->report.first_fallen_back = -1;
    for (int i = 0; i < spans; i++)
        make_span(t, i);
    return batten_curve_from_tangents((batten_points){2, t->count, t->points}, t->t, t->leaving,
                                      t->arriving, t->closed, curve);
}

static void copy_curvature_results(const curvature_fit *t, double *parameters, int *solutions,
                                   batten_curve_from_curvatures_report *report)
{
    const size_t spans = (size_t)(t->closed ? t->count : t->count - 1);
    if (parameters)
        memcpy(parameters, t->t, (size_t)(t->count + t->closed) * sizeof *parameters);
    if (solutions)
        memcpy(solutions, t->solutions, spans * sizeof *solutions);
    if (report)
        *report = t->report;
}

batten_status batten_curve_from_curvatures(const batten_curved_points *data, double *parameters,
                                           int *solutions,
                                           batten_curve_from_curvatures_report *report,
                                           batten_curve **out)
{
    if (data->points.dimension != 2)
        return bat_wrong_dimension(data->points, 2);
    assert(data->points.at && data->tangents && data->curvatures && out);
    batten_status status =
        bat_points_check(2, data->points.count, data->points.at, data->closed ? 3 : 2);
    if (status == BATTEN_OK)
        status = bat_local_check_rows(2, data->points.count, data->tangents, "tangent");
    if (status == BATTEN_OK)
        status = bat_local_check_rows(1, data->points.count, data->curvatures, "curvature");
    if (status != BATTEN_OK)
        return status;
    curvature_fit t = {.count = data->points.count,
                       .closed = data->closed,
                       .points = data->points.at,
                       .curvatures = data->curvatures};
    const size_t n = (size_t)data->points.count;
    batten_curve *curve = NULL;
    t.t = bat_array(n + 1, sizeof *t.t);
    t.unit = bat_array3(n, 2, sizeof *t.unit);
    t.leaving = bat_array3(n, 2, sizeof *t.leaving);
    t.arriving = bat_array3(n, 2, sizeof *t.arriving);
    t.solutions = bat_array(n, sizeof *t.solutions);
    status = BATTEN_OUT_OF_MEMORY;
    if (t.t && t.unit && t.leaving && t.arriving && t.solutions)
        status = make_quintic(&t, data->tangents, &curve);
    if (status == BATTEN_OK) {
        copy_curvature_results(&t, parameters, solutions, report);
        *out = curve;
    }
    bat_release(t.t);
    bat_release(t.unit);
    bat_release(t.leaving);
    bat_release(t.arriving);
    bat_release(t.solutions);
    return status;
}

/* ---- curvatures from the points ---- */

static double circle_curvature(const double *a, const double *b, const double *c)
{
    const double u[2] = {b[0] - a[0], b[1] - a[1]}, v[2] = {c[0] - b[0], c[1] - b[1]};
    const double lu = bat_norm(2, u), lv = bat_norm(2, v), w = bat_distance(2, a, c);
    const double p[2] = {u[0] / lu, u[1] / lu}, q[2] = {v[0] / lv, v[1] / lv};
    return w > 0 ? 2 * cross(p, q) / w : 0;
}

batten_status batten_circle_curvatures(batten_points points, bool closed, double *curvatures)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    assert(points.at && curvatures);
    batten_status status = bat_points_check(2, points.count, points.at, closed ? 3 : 2);
    if (status != BATTEN_OK)
        return status;
    double *made = bat_array((size_t)points.count + 1, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    status = bat_parametrize(points, BATTEN_CHORD, closed, made);
    for (int i = 0; i < points.count && status == BATTEN_OK; i++) {
        const int at = closed ? i : bat_max_int(1, bat_min_int(i, points.count - 2));
        const double *a = points.at + 2 * bat_around(points.count, at - 1);
        made[i] = points.count == 2
                      ? 0
                      : circle_curvature(a, points.at + 2 * at,
                                         points.at + 2 * bat_around(points.count, at + 1));
        if (!isfinite(made[i]))
            status = bat_fail(BATTEN_OVERFLOW, "the curvature at point %d is too large", i + 1);
    }
    if (status == BATTEN_OK)
        memcpy(curvatures, made, (size_t)points.count * sizeof *curvatures);
    bat_release(made);
    return status;
}
