/* Batten on the workloads. */
#include "bench.h"

#include <batten/bent.h>
#include <batten/interpolate.h>
#include <batten/local.h>
#include <batten/measure.h>
#include <batten/scattered.h>
#include <batten/skin.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const bench_work *work;
    batten_curve *curve;
    batten_chain *chain;
    batten_surface *surface;
    batten_triangles *triangles;
    batten_plane_triangles plane;
    batten_curve **sections;
    double *uv, *out, *normals;
} contest;

static void must(batten_status status)
{
    if (status == BATTEN_OK)
        return;
    fprintf(stderr, "bench: batten: %s\n", batten_message());
    exit(1);
}

static size_t point_count(const bench_work *work)
{
    return work->kind == SURFACE_GRID || work->kind == SURFACE_THROUGH
               ? work->count * work->count
               : work->count;
}

static void *open_curve(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const bench_curve *curve = &work->curve;
    c->work = work;
    c->out = bench_numbers(work->result_count);
    must(batten_curve_create((batten_points){3, curve->count, curve->points}, curve->degree,
                             curve->weights, curve->knots, &c->curve));
    return c;
}

static void *open_surface(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const bench_surface *surface = &work->surface;
    c->work = work;
    c->out = bench_numbers(9 * point_count(work));
    c->normals = bench_numbers(3 * point_count(work));
    c->uv = bench_numbers(2 * work->count);
    for (size_t i = 0; i < work->count; i++) {
        c->uv[2 * i] = work->u[i];
        c->uv[2 * i + 1] = work->v[i];
    }
    const batten_axis u = {surface->degree, surface->count, surface->knots[0], false};
    const batten_axis v = {surface->degree, surface->count, surface->knots[1], false};
    must(batten_surface_create(3, &u, &v, surface->points, surface->weights, &c->surface));
    return c;
}

static void *open_data(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    c->work = work;
    return c;
}

static void *open_sections(const bench_work *work)
{
    contest *c = open_data(work);
    c->sections = calloc(work->count, sizeof *c->sections);
    c->uv = bench_numbers(work->count);
    for (size_t i = 0; i < work->count; i++) {
        const bench_curve *section = &work->sections[i];
        must(batten_curve_create((batten_points){3, section->count, section->points},
                                 section->degree, NULL, section->knots, &c->sections[i]));
    }
    return c;
}

static void close_contest(void *object)
{
    contest *c = object;
    for (size_t i = 0; c->sections && i < c->work->count; i++)
        batten_curve_unref(c->sections[i]);
    free(c->sections);
    batten_curve_unref(c->curve);
    batten_chain_unref(c->chain);
    batten_surface_unref(c->surface);
    batten_triangles_unref(c->triangles);
    batten_plane_triangles_release(&c->plane);
    free(c->uv);
    free(c->out);
    free(c->normals);
    free(c);
}

/* ---- curves ---- */

static void run_curve(void *object)
{
    contest *c = object;
    must(batten_curve_evaluate_many(c->curve, c->work->count, c->work->u, c->work->order, NULL,
                                    c->out));
}

static void run_curve_single(void *object)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        must(batten_curve_evaluate(c->curve, c->work->u[i], 0, c->out + 3 * i));
}

static void gather_curve(void *object, double *result)
{
    contest *c = object;
    const size_t rows = (size_t)c->work->order + 1;
    for (size_t i = 0; i < c->work->count * rows; i++) {
        const double scale = i % rows == 0 ? 1 : i % rows == 1 ? 1e-3 : 1e-6;
        for (size_t k = 0; k < 3; k++)
            result[3 * i + k] = scale * c->out[3 * i + k];
    }
}

/* ---- surfaces ---- */

static void run_grid(void *object)
{
    contest *c = object;
    const size_t n = c->work->count;
    if (c->work->order == 0)
        must(batten_surface_evaluate_grid(
            c->surface, (batten_uv_grid){n, n, c->work->u, c->work->v}, 0, NULL, c->out));
    else
        must(batten_surface_normal_grid(c->surface,
                                        (batten_uv_grid){n, n, c->work->u, c->work->v}, NULL,
                                        c->out, c->normals));
}

/* The normals of scattered points are their caller's work. */
static void run_points(void *object)
{
    contest *c = object;
    const int order = c->work->order;
    must(batten_surface_evaluate_many(c->surface, c->work->count, c->uv, order, NULL, c->out));
    for (size_t i = 0; order > 0 && i < c->work->count; i++)
        bench_unit_normal(c->out + 9 * i + 3, c->out + 9 * i + 6, c->normals + 3 * i);
}

static void run_surface_single(void *object)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        must(batten_surface_evaluate(c->surface, c->uv[2 * i], c->uv[2 * i + 1], 0,
                                     c->out + 3 * i));
}

static void gather_surface(void *object, double *result)
{
    contest *c = object;
    const size_t count = point_count(c->work);
    const size_t step = c->work->kind != SURFACE_GRID && c->work->order > 0 ? 9 : 3;
    for (size_t i = 0; i < count; i++)
        memcpy(result + 3 * i, c->out + step * i, 3 * sizeof *result);
    if (c->work->order > 0)
        memcpy(result + 3 * count, c->normals, 3 * count * sizeof *result);
}

/* ---- interpolation ---- */

static void run_curve_through(void *object)
{
    contest *c = object;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = c->work->u;
    batten_curve_unref(c->curve);
    c->curve = NULL;
    must(batten_curve_interpolate((batten_points){3, (int)c->work->count, c->work->data},
                                  &options, NULL, &c->curve));
}

static void gather_curve_through(void *object, double *result)
{
    contest *c = object;
    must(batten_curve_evaluate_many(c->curve, c->work->count, c->work->u, 0, NULL, result));
}

static void run_surface_through(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given_u = c->work->u;
    options.given_v = c->work->v;
    batten_surface_unref(c->surface);
    c->surface = NULL;
    must(batten_surface_interpolate((batten_grid){3, n, n, c->work->data}, &options, NULL,
                                    (batten_uv_out){NULL, NULL}, NULL, &c->surface));
}

static void gather_surface_through(void *object, double *result)
{
    contest *c = object;
    const size_t n = c->work->count;
    must(batten_surface_evaluate_grid(
        c->surface, (batten_uv_grid){n, n, c->work->u, c->work->v}, 0, NULL, result));
}

static void run_skin(void *object)
{
    contest *c = object;
    batten_surface_unref(c->surface);
    c->surface = NULL;
    must(batten_surface_skin(
        (batten_curve_row){(int)c->work->count, (const batten_curve *const *)c->sections}, NULL,
        NULL, c->uv, NULL, &c->surface));
}

static void gather_skin(void *object, double *result)
{
    contest *c = object;
    for (size_t k = 0; k < c->work->count; k++)
        for (size_t i = 0; i < BENCH_PLACES; i++, result += 3)
            must(batten_surface_evaluate(c->surface, c->work->u[i], c->uv[k], 0, result));
}

/* ---- functions and plane curves by their methods ---- */

static void *open_function(const bench_work *work)
{
    contest *c = open_data(work);
    c->out = bench_numbers(work->count);
    return c;
}

static void run_function(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    const double *x = c->work->u, *y = c->work->data;
    batten_curve_unref(c->curve);
    c->curve = NULL;
    if (c->work->method == NATURAL_CUBIC) {
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = BATTEN_GIVEN;
        options.given = x;
        options.start.kind = options.end.kind = BATTEN_END_NATURAL;
        must(batten_curve_interpolate((batten_points){1, n, y}, &options, NULL, &c->curve));
        return;
    }
    must(batten_slopes(
        n, x, y, c->work->method == AKIMA ? BATTEN_SLOPE_AKIMA : BATTEN_SLOPE_STEFFEN, c->out));
    must(batten_curve_from_tangents((batten_points){1, n, y}, x, c->out, NULL, false,
                                    &c->curve));
}

static void gather_function(void *object, double *result)
{
    contest *c = object;
    for (size_t i = 0; i + 3 < c->work->count; i++)
        must(batten_curve_evaluate(c->curve, (c->work->u[i + 1] + c->work->u[i + 2]) / 2, 0,
                                   result + i));
}

static void run_nonlinear(contest *c, batten_span_family family)
{
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = family;
    must(batten_chain_nonlinear((batten_points){2, (int)c->work->count, c->work->data},
                                &options, NULL, c->uv, NULL, &c->chain));
}

static void run_plane(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    batten_chain_unref(c->chain);
    batten_curve_unref(c->curve);
    c->chain = NULL;
    c->curve = NULL;
    if (c->work->method == TENSION) {
        batten_chain_tension_options options = batten_chain_tension_defaults();
        options.tension = 2;
        must(batten_chain_tension((batten_points){2, n, c->work->data}, &options, c->uv,
                                  &c->chain));
    } else if (c->work->method == NU_SPLINE) {
        batten_curve_weighted_options options = batten_curve_weighted_defaults();
        must(batten_curve_weighted((batten_points){2, n, c->work->data}, &options, c->uv,
                                   &c->curve));
    } else {
        run_nonlinear(c, c->work->method == LOCAL_CUBIC    ? BATTEN_FAMILY_LOCAL_CUBIC
                         : c->work->method == EULER_SPIRAL ? BATTEN_FAMILY_EULER_SPIRAL
                                                           : BATTEN_FAMILY_ELASTICA);
    }
}

static void *open_plane(const bench_work *work)
{
    contest *c = open_data(work);
    c->uv = bench_numbers(work->count);
    return c;
}

static void gather_plane(void *object, double *result)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        must(c->chain ? batten_chain_evaluate(c->chain, c->uv[i], 0, result + 2 * i)
                      : batten_curve_evaluate(c->curve, c->uv[i], 0, result + 2 * i));
}

/* ---- length ---- */

static void run_length(void *object)
{
    contest *c = object;
    must(batten_curve_length(c->curve, 1e-9, NULL, c->out));
}

static void gather_length(void *object, double *result)
{
    contest *c = object;
    *result = *c->out / 1e3;
}

static void run_scattered(void *object)
{
    contest *c = object;
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    options.tolerance = 1e-3;
    batten_surface_unref(c->surface);
    c->surface = NULL;
    must(batten_surface_scattered(c->work->u,
                                  (batten_points){1, (int)c->work->count, c->work->data},
                                  &options, NULL, NULL, &c->surface));
}

static void gather_scattered(void *object, double *result)
{
    contest *c = object;
    double most = 0;
    for (size_t i = 0; i < c->work->count; i++) {
        double z;
        must(batten_surface_evaluate(c->surface, c->work->u[2 * i], c->work->u[2 * i + 1], 0,
                                     &z));
        most = fmax(most, fabs(z - c->work->data[i]));
    }
    *result = most <= 1e-3 ? *c->work->data : NAN;
}

static void run_triangulation(void *object)
{
    contest *c = object;
    batten_plane_triangles_release(&c->plane);
    must(batten_triangulate((batten_points){2, (int)c->work->count, c->work->u}, NULL,
                            &c->plane));
}

static void gather_triangulation(void *object, double *result)
{
    const contest *c = object;
    const batten_plane_triangles *t = &c->plane;
    double area = 0;
    for (int i = 0; i < t->count; i++) {
        const double *a = t->vertices + 2 * t->corners[3 * i];
        const double *b = t->vertices + 2 * t->corners[3 * i + 1];
        const double *p = t->vertices + 2 * t->corners[3 * i + 2];
        area += ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / 2;
    }
    *result = fabs(area - 1) < 1e-2 ? *c->work->data : NAN;
}

static void run_triangles(void *object)
{
    contest *c = object;
    batten_triangles_unref(c->triangles);
    c->triangles = NULL;
    must(batten_triangles_scattered((batten_points){2, (int)c->work->count, c->work->u},
                                    c->work->data, NULL, NULL, NULL, &c->triangles));
}

static void gather_triangles(void *object, double *result)
{
    contest *c = object;
    const size_t n = c->work->count;
    double *z = malloc(n * sizeof *z), most = z ? 0 : NAN;
    if (z)
        must(batten_triangles_over(c->triangles, (batten_batch){n, c->work->u}, 0,
                                   (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL,
                                   z));
    for (size_t i = 0; z && i < n; i++)
        most = fmax(most, fabs(z[i] - c->work->data[i]));
    free(z);
    *result = most <= 1e-12 ? *c->work->data : NAN;
}

const bench_entry bench_batten[KIND_COUNT] = {
    [CURVE_POINTS] = {open_curve, run_curve, gather_curve, close_contest},
    [CURVE_SINGLE] = {open_curve, run_curve_single, gather_curve, close_contest},
    [SURFACE_GRID] = {open_surface, run_grid, gather_surface, close_contest},
    [SURFACE_POINTS] = {open_surface, run_points, gather_surface, close_contest},
    [SURFACE_SINGLE] = {open_surface, run_surface_single, gather_surface, close_contest},
    [CURVE_THROUGH] = {open_data, run_curve_through, gather_curve_through, close_contest},
    [SURFACE_THROUGH] = {open_data, run_surface_through, gather_surface_through, close_contest},
    [SKIN] = {open_sections, run_skin, gather_skin, close_contest},
    [FUNCTION_THROUGH] = {open_function, run_function, gather_function, close_contest},
    [PLANE_THROUGH] = {open_plane, run_plane, gather_plane, close_contest},
    [SCATTERED_NEAR] = {open_data, run_scattered, gather_scattered, close_contest},
    [TRIANGULATION] = {open_data, run_triangulation, gather_triangulation, close_contest},
    [TRIANGLES_THROUGH] = {open_data, run_triangles, gather_triangles, close_contest},
    [CURVE_LENGTH] = {open_curve, run_length, gather_length, close_contest},
};
