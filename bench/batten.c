/* Batten on curves and surfaces: points, interpolation, skins. */
#include "batten_contest.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

void contest_must(batten_status status)
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

void *contest_open_curve(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const bench_curve *curve = &work->curve;
    c->work = work;
    c->out = bench_numbers(work->result_count);
    contest_must(batten_curve_create((batten_points){3, curve->count, curve->points},
                                     curve->degree, curve->weights, curve->knots, &c->curve));
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
    contest_must(
        batten_surface_create(3, &u, &v, surface->points, surface->weights, &c->surface));
    return c;
}

void *contest_open(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    c->work = work;
    return c;
}

static void *open_sections(const bench_work *work)
{
    contest *c = contest_open(work);
    c->sections = calloc(work->count, sizeof *c->sections);
    c->uv = bench_numbers(work->count);
    for (size_t i = 0; i < work->count; i++) {
        const bench_curve *section = &work->sections[i];
        contest_must(batten_curve_create((batten_points){3, section->count, section->points},
                                         section->degree, NULL, section->knots,
                                         &c->sections[i]));
    }
    return c;
}

void contest_close(void *object)
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
    contest_must(batten_curve_evaluate_many(c->curve, c->work->count, c->work->u,
                                            c->work->order, NULL, c->out));
}

static void run_curve_single(void *object)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        contest_must(batten_curve_evaluate(c->curve, c->work->u[i], 0, c->out + 3 * i));
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

static void run_normal_grid(void *object)
{
    contest *c = object;
    const size_t n = c->work->count;
    contest_must(batten_surface_normal_grid(
        c->surface, (batten_uv_grid){n, n, c->work->u, c->work->v}, NULL, c->out, c->normals));
}

static void add_normals(contest *c, size_t count)
{
    for (size_t i = 0; c->work->order > 0 && i < count; i++)
        bench_unit_normal(c->out + 9 * i + 3, c->out + 9 * i + 6, c->normals + 3 * i);
}

/* With derivatives the normals are their caller's work. */
static void run_grid(void *object)
{
    contest *c = object;
    const size_t n = c->work->count;
    contest_must(batten_surface_evaluate_grid(c->surface,
                                              (batten_uv_grid){n, n, c->work->u, c->work->v},
                                              c->work->order, NULL, c->out));
    add_normals(c, n * n);
}

static void run_points(void *object)
{
    contest *c = object;
    contest_must(batten_surface_evaluate_many(c->surface, c->work->count, c->uv, c->work->order,
                                              NULL, c->out));
    add_normals(c, c->work->count);
}

static void run_surface_single(void *object)
{
    contest *c = object;
    for (size_t i = 0; i < c->work->count; i++)
        contest_must(batten_surface_evaluate(c->surface, c->uv[2 * i], c->uv[2 * i + 1], 0,
                                             c->out + 3 * i));
}

static void gather_surface(void *object, double *result)
{
    contest *c = object;
    const size_t count = point_count(c->work),
                 step = c->work->normals_only || c->work->order == 0 ? 3 : 9;
    for (size_t i = 0; i < count; i++)
        bench_lay_point(c->work, (bench_place){i, count}, c->out + step * i, c->normals + 3 * i,
                        result);
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
    contest_must(batten_curve_interpolate(
        (batten_points){3, (int)c->work->count, c->work->data}, &options, NULL, &c->curve));
}

static void gather_curve_through(void *object, double *result)
{
    contest *c = object;
    contest_must(
        batten_curve_evaluate_many(c->curve, c->work->count, c->work->u, 0, NULL, result));
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
    contest_must(batten_surface_interpolate((batten_grid){3, n, n, c->work->data}, &options,
                                            NULL, (batten_uv_out){NULL, NULL}, NULL,
                                            &c->surface));
}

static void gather_surface_through(void *object, double *result)
{
    contest *c = object;
    const size_t n = c->work->count;
    contest_must(batten_surface_evaluate_grid(
        c->surface, (batten_uv_grid){n, n, c->work->u, c->work->v}, 0, NULL, result));
}

static void run_skin(void *object)
{
    contest *c = object;
    batten_surface_unref(c->surface);
    c->surface = NULL;
    contest_must(batten_surface_skin(
        (batten_curve_row){(int)c->work->count, (const batten_curve *const *)c->sections}, NULL,
        NULL, c->uv, NULL, &c->surface));
}

static void gather_skin(void *object, double *result)
{
    contest *c = object;
    for (size_t k = 0; k < c->work->count; k++)
        for (size_t i = 0; i < BENCH_PLACES; i++, result += 3)
            contest_must(
                batten_surface_evaluate(c->surface, c->work->u[i], c->uv[k], 0, result));
}

static void *open_normal_grid(const bench_work *work)
{
    return work->normals_only ? open_surface(work) : NULL;
}

static void *open_grid(const bench_work *work)
{
    return work->normals_only ? NULL : open_surface(work);
}

#define CURVE(name, kind, run)                                                 \
    {                                                                          \
        name, kind, contest_open_curve, run, gather_curve, contest_close, NULL \
    }
#define SURFACE(name, kind, open, run)                             \
    {                                                              \
        name, kind, open, run, gather_surface, contest_close, NULL \
    }

const bench_entry bench_batten[] = {
    CURVE("batten_curve_evaluate_many", CURVE_POINTS, run_curve),
    CURVE("batten_curve_evaluate", CURVE_SINGLE, run_curve_single),
    SURFACE("batten_surface_evaluate_grid", SURFACE_GRID, open_grid, run_grid),
    SURFACE("batten_surface_normal_grid", SURFACE_GRID, open_normal_grid, run_normal_grid),
    SURFACE("batten_surface_evaluate_many", SURFACE_POINTS, open_surface, run_points),
    SURFACE("batten_surface_evaluate", SURFACE_SINGLE, open_surface, run_surface_single),
    {"batten_curve_interpolate", CURVE_THROUGH, contest_open, run_curve_through,
     gather_curve_through, contest_close, NULL},
    {"batten_surface_interpolate", SURFACE_THROUGH, contest_open, run_surface_through,
     gather_surface_through, contest_close, NULL},
    {"batten_surface_skin", SKIN, open_sections, run_skin, gather_skin, contest_close, NULL},
    {.way = NULL},
};
