/* The tensor product of two linear methods for curves. */
#include "shape/grid/tensor.h"
#include "shape/points/grid_parameters.h"
#include "spline/data_check.h"

#include "base/work.h"
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

/* ---- grids ---- */

batten_status bat_grid_check(int dimension, int count_u, int count_v, const double *points,
                             bool closed_u, bool closed_v)
{
    const int least_u = closed_u ? 3 : 2, least_v = closed_v ? 3 : 2;
    if (count_u < least_u || count_v < least_v)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the grid has %d x %d points, and needs %d x %d",
                        count_u, count_v, least_u, least_v);
    if ((long long)count_u * count_v > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the grid has %lld points; the limit is %d",
                        (long long)count_u * count_v, BAT_MAX_POINTS);
    return bat_points_check(dimension, count_u * count_v, points, 4);
}

batten_status bat_grid_parameters_of(batten_grid points, batten_parametrization kind,
                                     const bool closed[2], const double *const given[2],
                                     bat_grid_parameters *out)
{
    const int nu = points.count_u, nv = points.count_v;
    const size_t d = (size_t)points.dimension, row = (size_t)nv * d;
    *out = (bat_grid_parameters){bat_array((size_t)nu + 1, sizeof(double)),
                                 bat_array((size_t)nv + 1, sizeof(double)),
                                 {0, 0}};
    if (!out->u || !out->v)
        return BATTEN_OUT_OF_MEMORY;
    const bat_family u = {"u grid lines", points.dimension, nu,      nv, row, d,
                          closed[0],      points.at,        given[0]};
    const bat_family v = {"v grid lines", points.dimension, nv,      nu, d, row,
                          closed[1],      points.at,        given[1]};
    batten_status status =
        bat_family_parametrize(&u, given[0] ? BATTEN_GIVEN : kind, out->u, &out->spread[0]);
    if (status == BATTEN_OK)
        status =
            bat_family_parametrize(&v, given[1] ? BATTEN_GIVEN : kind, out->v, &out->spread[1]);
    return status;
}

void bat_grid_parameters_release(bat_grid_parameters *parameters)
{
    bat_release(parameters->u);
    bat_release(parameters->v);
}

batten_status batten_grid_parametrize(batten_grid points, batten_parametrization kind,
                                      bool closed_u, bool closed_v, double *spread,
                                      batten_uv_out uv)
{
    assert(points.at && uv.u && uv.v);
    bat_grid_parameters at = {NULL, NULL, {0, 0}};
    batten_status status = bat_grid_check(points.dimension, points.count_u, points.count_v,
                                          points.at, closed_u, closed_v);
    if (status == BATTEN_OK)
        status = bat_grid_parameters_of(points, kind, (const bool[2]){closed_u, closed_v},
                                        (const double *const[2]){NULL, NULL}, &at);
    if (status == BATTEN_OK) {
        memcpy(uv.u, at.u, ((size_t)points.count_u + closed_u) * sizeof *uv.u);
        memcpy(uv.v, at.v, ((size_t)points.count_v + closed_v) * sizeof *uv.v);
        if (spread)
            memcpy(spread, at.spread, sizeof at.spread);
    }
    bat_grid_parameters_release(&at);
    return status;
}

batten_status bat_line_fails(batten_status status, const char *direction, int line)
{
    char message[256];
    snprintf(message, sizeof message, "%s", batten_message());
    return bat_fail(status, "along %s, line %d: %s", direction, line + 1, message);
}

/* ---- one stage: a method along all lines ---- */

/* What the curves of a method have in common. */
typedef struct {
    int degree, count; /* of the control points of one period */
    bool periodic;
    double *knots; /* as batten_axis wants them */
} line_shape;

typedef struct {
    const char *direction;
    const batten_line_method *method;
    int dimension, count; /* of points on a line */
    size_t lines;
    const double *parameters;
    line_shape shape;
    double *control; /* [shape.count][lines][dimension] */
} stage;

static int knots_needed(const line_shape *s)
{
    return s->periodic ? s->count + 1 : s->count + s->degree + 1;
}

static line_shape shape_of(const batten_curve *curve)
{
    const int p = batten_curve_degree(curve);
    const bool periodic = batten_curve_is_periodic(curve);
    return (line_shape){p, batten_curve_point_count(curve) - (periodic ? p : 0), periodic,
                        NULL};
}

static const double *own_knots(const batten_curve *curve)
{
    const double *knots = batten_curve_knots(curve);
    return batten_curve_is_periodic(curve) ? knots + batten_curve_degree(curve) : knots;
}

/* The first curve says what all are like, and how much room they need. */
static batten_status learn_shape(stage *s, const batten_curve *curve)
{
    s->shape = shape_of(curve);
    const int count = knots_needed(&s->shape);
    const long long total = (long long)s->shape.count * (long long)s->lines;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there would be %lld control points; the limit is %d",
                        total, BAT_MAX_POINTS);
    s->shape.knots = bat_array((size_t)count, sizeof *s->shape.knots);
    s->control =
        bat_array3((size_t)s->shape.count * s->lines, (size_t)s->dimension, sizeof *s->control);
    if (!s->shape.knots || !s->control)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(s->shape.knots, own_knots(curve), (size_t)count * sizeof *s->shape.knots);
    return BATTEN_OK;
}

static batten_status check_curve(const stage *s, const batten_curve *curve)
{
    const line_shape own = shape_of(curve);
    if (batten_curve_is_rational(curve))
        return bat_fail(BATTEN_UNSUPPORTED, "the method gives rational curves");
    if (batten_curve_dimension(curve) != s->dimension || own.degree != s->shape.degree ||
        own.count != s->shape.count || own.periodic != s->shape.periodic ||
        memcmp(own_knots(curve), s->shape.knots,
               (size_t)knots_needed(&own) * sizeof *s->shape.knots) != 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the curve has other knots than that of the first line");
    return BATTEN_OK;
}

static batten_status make_line(stage *s, size_t line, const double *points)
{
    const size_t d = (size_t)s->dimension;
    batten_curve *curve = NULL;
    batten_status status =
        s->method->make(s->method->user, s->dimension, s->count, points, s->parameters, &curve);
    if (status == BATTEN_OK && line == 0)
        status = learn_shape(s, curve);
    if (status == BATTEN_OK)
        status = check_curve(s, curve);
    for (int i = 0; status == BATTEN_OK && i < s->shape.count; i++)
        memcpy(s->control + ((size_t)i * s->lines + line) * d,
               batten_curve_points(curve) + (size_t)i * d, d * sizeof *s->control);
    batten_curve_unref(curve);
    return status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY
               ? status
               : bat_line_fails(status, s->direction, (int)line);
}

/* From data [count][lines][dimension]. */
static batten_status run_stage(stage *s, bat_work *work, const double *data)
{
    const size_t d = (size_t)s->dimension;
    double *points = bat_array3((size_t)s->count, d, sizeof *points);
    batten_status status = points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t line = 0; status == BATTEN_OK && line < s->lines; line++) {
        for (size_t i = 0; i < (size_t)s->count; i++)
            memcpy(points + i * d, data + (i * s->lines + line) * d, d * sizeof *points);
        status = make_line(s, line, points);
        if (status == BATTEN_OK && line % 64 == 63)
            status = bat_work_step(work, 64 * (uint64_t)s->count,
                                   (double)line / (double)s->lines, s->direction);
    }
    bat_release(points);
    return status;
}

static void release_stage(stage *s)
{
    bat_release(s->shape.knots);
    bat_release(s->control);
}

/* ---- the surface ---- */

/* Rows become columns: [rows][columns][d] to [columns][rows][d]. */
static double *transposed(int rows, size_t columns, size_t d, const double *from)
{
    double *to = bat_array3((size_t)rows * columns, d, sizeof *to);
    if (to)
        bat_transpose(rows, (int)columns, d, from, to);
    return to;
}

static batten_status make_surface(const stage *along_u, const stage *along_v,
                                  batten_surface **out)
{
    const line_shape *u = &along_u->shape, *v = &along_v->shape;
    const size_t d = (size_t)along_v->dimension;
    const batten_axis axes[2] = {{u->degree, u->count, u->knots, u->periodic},
                                 {v->degree, v->count, v->knots, v->periodic}};
    double *net = transposed(v->count, along_v->lines, d, along_v->control);
    const batten_status status =
        net ? batten_surface_create(along_v->dimension, &axes[0], &axes[1], net, NULL, out)
            : BATTEN_OUT_OF_MEMORY;
    bat_release(net);
    return status;
}

static batten_status find_off(const batten_surface *surface, int dimension, int count_u,
                              int count_v, const double *points, const double *u,
                              const double *v, double *off)
{
    const size_t d = (size_t)dimension, total = (size_t)count_u * (size_t)count_v;
    double *there = bat_array3(total, d, sizeof *there);
    if (!there)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_surface_evaluate_grid(
        surface, (batten_uv_grid){(size_t)count_u, (size_t)count_v, u, v}, 0, NULL, there);
    double largest = 0;
    for (size_t i = 0; status == BATTEN_OK && i < total; i++)
        largest = bat_max(largest, bat_distance(dimension, points + i * d, there + i * d));
    bat_release(there);
    if (status == BATTEN_OK)
        *off = largest;
    return status;
}

batten_status batten_surface_tensor(batten_grid points, batten_uv uv,
                                    const batten_line_method *const along[2],
                                    const batten_job *job, double *off, batten_surface **out)
{
    assert(points.at && uv.u && uv.v && along[0] && along[1] && out);
    bat_work work = {job, 0};
    stage first = {.direction = "u",
                   .method = along[0],
                   .dimension = points.dimension,
                   .count = points.count_u,
                   .lines = (size_t)points.count_v,
                   .parameters = uv.u};
    stage second = {.direction = "v",
                    .method = along[1],
                    .dimension = points.dimension,
                    .count = points.count_v,
                    .parameters = uv.v};
    batten_surface *surface = NULL;
    double *turned = NULL;
    batten_status status = bat_grid_check(points.dimension, points.count_u, points.count_v,
                                          points.at, along[0]->closed, along[1]->closed);
    if (status == BATTEN_OK)
        status = bat_parameters_check(points.count_u + along[0]->closed, uv.u);
    if (status == BATTEN_OK)
        status = bat_parameters_check(points.count_v + along[1]->closed, uv.v);
    if (status == BATTEN_OK)
        status = run_stage(&first, &work, points.at);
    if (status == BATTEN_OK) {
        turned =
            transposed(first.shape.count, first.lines, (size_t)points.dimension, first.control);
        second.lines = (size_t)first.shape.count;
        status = turned ? run_stage(&second, &work, turned) : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        status = make_surface(&first, &second, &surface);
    if (status == BATTEN_OK && off)
        status = find_off(surface, points.dimension, points.count_u, points.count_v, points.at,
                          uv.u, uv.v, off);
    if (status == BATTEN_OK)
        *out = batten_surface_ref(surface);
    batten_surface_unref(surface);
    bat_release(turned);
    release_stage(&first);
    release_stage(&second);
    return status;
}
