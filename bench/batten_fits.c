/* Batten on functions, plane curves by their methods, lengths, and surfaces near or over scattered values. */
#include "batten_contest.h"

#include <math.h>
#include <stdlib.h>

/* ---- functions and plane curves by their methods ---- */

static void *open_function(const bench_work *work)
{
    contest *c = contest_open(work);
    c->out = bench_numbers(work->count);
    c->normals = bench_numbers(work->count);
    return c;
}

static void make_function(contest *c)
{
    const int n = (int)c->work->count;
    const double *x = c->work->u, *y = c->work->data;
    if (c->work->method == NATURAL_CUBIC) {
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = BATTEN_GIVEN;
        options.given = x;
        options.start.kind = options.end.kind = BATTEN_END_NATURAL;
        contest_must(
            batten_curve_interpolate((batten_points){1, n, y}, &options, NULL, &c->curve));
        return;
    }
    contest_must(batten_slopes(
        n, x, y, c->work->method == AKIMA ? BATTEN_SLOPE_AKIMA : BATTEN_SLOPE_STEFFEN, c->out));
    contest_must(batten_curve_from_tangents((batten_points){1, n, y}, x, c->out, NULL, false,
                                            &c->curve));
}

static void run_function(void *object)
{
    contest *c = object;
    batten_curve_unref(c->curve);
    c->curve = NULL;
    make_function(c);
    contest_must(batten_curve_evaluate_many(c->curve, c->work->count - 1, c->work->v, 0, NULL,
                                            c->normals));
}

static void gather_function(void *object, double *result)
{
    const contest *c = object;
    for (size_t i = 0; i < c->work->result_count; i++)
        result[i] = c->normals[i + 2];
}

static void run_nonlinear(contest *c, batten_span_family family)
{
    batten_chain_nonlinear_options options = batten_chain_nonlinear_defaults();
    options.family = family;
    contest_must(batten_chain_nonlinear((batten_points){2, (int)c->work->count, c->work->data},
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
        contest_must(batten_chain_tension((batten_points){2, n, c->work->data}, &options, c->uv,
                                          &c->chain));
    } else if (c->work->method == NU_SPLINE) {
        batten_curve_weighted_options options = batten_curve_weighted_defaults();
        contest_must(batten_curve_weighted((batten_points){2, n, c->work->data}, &options,
                                           c->uv, &c->curve));
    } else {
        run_nonlinear(c, c->work->method == LOCAL_CUBIC    ? BATTEN_FAMILY_LOCAL_CUBIC
                         : c->work->method == EULER_SPIRAL ? BATTEN_FAMILY_EULER_SPIRAL
                                                           : BATTEN_FAMILY_ELASTICA);
    }
}

static void *open_plane(const bench_work *work)
{
    contest *c = contest_open(work);
    c->uv = bench_numbers(work->count);
    return c;
}

static void gather_plane(void *object, double *result)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        contest_must(c->chain ? batten_chain_evaluate(c->chain, c->uv[i], 0, result + 2 * i)
                              : batten_curve_evaluate(c->curve, c->uv[i], 0, result + 2 * i));
}

/* ---- length ---- */

static void run_length(void *object)
{
    contest *c = object;
    contest_must(batten_curve_length(c->curve, 1e-9, NULL, c->out));
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
    contest_must(batten_surface_scattered(
        c->work->u, (batten_points){1, (int)c->work->count, c->work->data}, &options, NULL,
        NULL, &c->surface));
}

static void gather_scattered(void *object, double *result)
{
    contest *c = object;
    double most = 0;
    for (size_t i = 0; i < c->work->count; i++) {
        double z;
        contest_must(batten_surface_evaluate(c->surface, c->work->u[2 * i],
                                             c->work->u[2 * i + 1], 0, &z));
        most = fmax(most, fabs(z - c->work->data[i]));
    }
    *result = most <= 1e-3 ? *c->work->data : NAN;
}

static void run_triangulation(void *object)
{
    contest *c = object;
    batten_plane_triangles_release(&c->plane);
    contest_must(batten_triangulate((batten_points){2, (int)c->work->count, c->work->u}, NULL,
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
    result[0] = area;
    result[1] = t->count * 1e-6;
}

static void run_triangles(void *object)
{
    contest *c = object;
    batten_triangles_unref(c->triangles);
    c->triangles = NULL;
    contest_must(batten_triangles_scattered((batten_points){2, (int)c->work->count, c->work->u},
                                            c->work->data, NULL, NULL, NULL, &c->triangles));
}

static void gather_triangles(void *object, double *result)
{
    contest *c = object;
    const size_t n = c->work->count;
    double *z = malloc(n * sizeof *z), most = z ? 0 : NAN;
    if (z)
        contest_must(batten_triangles_over(
            c->triangles, (batten_batch){n, c->work->u}, 0,
            (batten_outside_points){BATTEN_OUTSIDE_REFUSED, NULL}, NULL, z));
    for (size_t i = 0; z && i < n; i++)
        most = fmax(most, fabs(z[i] - c->work->data[i]));
    free(z);
    *result = most <= 1e-12 ? *c->work->data : NAN;
}

#define ENTRY(name, kind, open, run, gather)               \
    {                                                      \
        name, kind, open, run, gather, contest_close, NULL \
    }

const bench_entry bench_batten_fits[] = {
    ENTRY("batten_curve_interpolate or _from_tangents", FUNCTION_THROUGH, open_function,
          run_function, gather_function),
    ENTRY("chains and weighted curves", PLANE_THROUGH, open_plane, run_plane, gather_plane),
    ENTRY("batten_curve_length", CURVE_LENGTH, contest_open_curve, run_length, gather_length),
    ENTRY("batten_surface_scattered", SCATTERED_NEAR, contest_open, run_scattered,
          gather_scattered),
    ENTRY("batten_triangulate", TRIANGULATION, contest_open, run_triangulation,
          gather_triangulation),
    ENTRY("batten_triangles_scattered", TRIANGLES_THROUGH, contest_open, run_triangles,
          gather_triangles),
    {.way = NULL},
};
