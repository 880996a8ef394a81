/* SISL on the workloads. Its surfaces run u fastest. */
#include "bench.h"

#include <math.h>
#include <sisl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const bench_work *work;
    SISLCurve *curve;
    SISLSurf *surface;
    SISLCurve **sections;
    double *out, *normals, *data, *parameters;
} contest;

static void must(int status)
{
    if (status >= 0)
        return;
    fprintf(stderr, "bench: sisl: status %d\n", status);
    exit(1);
}

/* Homogeneous rows for rational shapes. */
static void weigh(const double *point, const double *weight, double *row)
{
    for (int k = 0; k < 3; k++)
        row[k] = point[k] * (weight ? *weight : 1);
    if (weight)
        row[3] = *weight;
}

static void *open_curve(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const bench_curve *curve = &work->curve;
    const int width = curve->weights ? 4 : 3, n = curve->count;
    c->work = work;
    c->out = bench_numbers(9 * work->count);
    c->data = bench_numbers((size_t)(width * n));
    for (int i = 0; i < n; i++)
        weigh(curve->points + 3 * i, curve->weights ? curve->weights + i : NULL,
              c->data + width * i);
    c->curve =
        newCurve(n, curve->degree + 1, curve->knots, c->data, curve->weights ? 2 : 1, 3, 1);
    return c;
}

static void *open_surface(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const bench_surface *s = &work->surface;
    const int width = s->weights ? 4 : 3, n = s->count;
    const size_t points = work->kind == SURFACE_GRID ? work->count * work->count : work->count;
    c->work = work;
    c->out = bench_numbers(9 * points);
    c->normals = bench_numbers(3 * points);
    c->data = bench_numbers((size_t)(width * n * n));
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++)
            weigh(s->points + 3 * (i * n + j), s->weights ? s->weights + i * n + j : NULL,
                  c->data + width * (j * n + i));
    c->surface = newSurf(n, n, s->degree + 1, s->degree + 1, s->knots[0], s->knots[1], c->data,
                         s->weights ? 2 : 1, 3, 1);
    return c;
}

static void *open_curve_data(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    c->work = work;
    return c;
}

static void *open_grid_data(const bench_work *work)
{
    contest *c = calloc(1, sizeof *c);
    const size_t n = work->count;
    c->work = work;
    c->data = bench_numbers(3 * n * n);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            memcpy(c->data + 3 * (j * n + i), work->data + 3 * (i * n + j),
                   3 * sizeof *c->data);
    return c;
}

static void *open_sections(const bench_work *work)
{
    contest *c = open_curve_data(work);
    c->sections = malloc(work->count * sizeof *c->sections);
    for (size_t i = 0; i < work->count; i++) {
        const bench_curve *section = &work->sections[i];
        c->sections[i] = newCurve(section->count, section->degree + 1, section->knots,
                                  section->points, 1, 3, 1);
    }
    return c;
}

static void close_contest(void *object)
{
    contest *c = object;
    if (c->curve)
        freeCurve(c->curve);
    if (c->surface)
        freeSurf(c->surface);
    for (size_t i = 0; c->sections && i < c->work->count; i++)
        freeCurve(c->sections[i]);
    free(c->sections);
    free(c->parameters);
    free(c->out);
    free(c->normals);
    free(c->data);
    free(c);
}

static void run_curve(void *object)
{
    contest *c = object;
    const int order = c->work->order;
    int left = 0, status = 0;
    for (size_t i = 0; i < c->work->count; i++)
        s1227(c->curve, order, c->work->u[i], &left, c->out + 3 * (size_t)(order + 1) * i,
              &status);
    must(status);
}

/* Points alone, in rising order, not rational. */
static void *open_sorted_curve(const bench_work *work)
{
    return work->random || work->order > 0 || work->rational ? NULL : open_curve(work);
}

static void run_curve_sorted(void *object)
{
    contest *c = object;
    int status = 0;
    s1542(c->curve, (int)c->work->count, c->work->u, c->out, &status);
    must(status);
}

static void gather_curve(void *object, double *result)
{
    contest *c = object;
    const size_t rows = (size_t)c->work->order + 1;
    for (size_t i = 0; i < c->work->count * rows; i++)
        for (size_t k = 0; k < 3; k++)
            result[3 * i + k] = c->out[3 * i + k] * (i % rows == 0   ? 1
                                                     : i % rows == 1 ? 1e-3
                                                                     : 1e-6);
}

/* Its normals are not of unit length. */
static void make_unit(double *normal)
{
    const double length =
        sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    for (int k = 0; k < 3; k++)
        normal[k] /= length;
}

static void run_grid(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    int status = 0;
    s1506(c->surface, c->work->order, n, c->work->u, n, c->work->v, c->out, c->normals,
          &status);
    must(status);
    for (size_t i = 0; c->work->order > 0 && i < c->work->count * c->work->count; i++)
        make_unit(c->normals + 3 * i);
}

static void run_points(void *object)
{
    contest *c = object;
    const int order = c->work->order;
    int left_u = 0, left_v = 0, status = 0;
    for (size_t i = 0; i < c->work->count; i++) {
        double at[2] = {c->work->u[i], c->work->v[i]}, *normal = c->normals + 3 * i;
        s1421(c->surface, order, at, &left_u, &left_v, c->out + (order ? 9 : 3) * i, normal,
              &status);
        if (order > 0)
            make_unit(normal);
    }
    must(status);
}

static void gather_surface(void *object, double *result)
{
    contest *c = object;
    const bool grid = c->work->kind == SURFACE_GRID;
    const size_t n = c->work->count, count = grid ? n * n : n, step = c->work->order ? 9 : 3;
    for (size_t i = 0; i < count; i++) {
        const size_t from = grid ? i % n * n + i / n : i;
        bench_lay_point(c->work, (bench_place){i, count}, c->out + step * from,
                        c->normals + 3 * from, result);
    }
}

static void run_curve_through(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    int *types = malloc((size_t)n * sizeof *types), count, status = 0;
    double end, *parameters = NULL;
    for (int i = 0; i < n; i++)
        types[i] = 1;
    if (c->curve)
        freeCurve(c->curve);
    c->curve = NULL;
    s1357(c->work->data, n, 3, types, c->work->u, 0, 0, 1, 4, 0.0, &end, &c->curve, &parameters,
          &count, &status);
    free(types);
    free(parameters);
    must(status);
}

/* In one call: one by one it takes minutes for 1e6 points. */
static void gather_curve_through(void *object, double *result)
{
    contest *c = object;
    int status = 0;
    s1542(c->curve, (int)c->work->count, c->work->u, result, &status);
    must(status);
}

static void run_surface_through(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    int status = 0;
    if (c->surface)
        freeSurf(c->surface);
    c->surface = NULL;
    s1537(c->data, n, n, 3, c->work->u, c->work->v, 0, 0, 0, 0, 4, 4, 1, 1, &c->surface,
          &status);
    must(status);
}

static void gather_surface_through(void *object, double *result)
{
    contest *c = object;
    const size_t n = c->work->count;
    int left_u = 0, left_v = 0, status = 0;
    double normal[3];
    for (size_t i = 0; i < n * n; i++) {
        double at[2] = {c->work->u[i / n], c->work->v[i % n]};
        s1421(c->surface, 0, at, &left_u, &left_v, result + 3 * i, normal, &status);
    }
    must(status);
}

static void run_skin(void *object)
{
    contest *c = object;
    const int n = (int)c->work->count;
    int *types = malloc((size_t)n * sizeof *types), status = 0;
    for (int i = 0; i < n; i++)
        types[i] = 1;
    if (c->surface)
        freeSurf(c->surface);
    free(c->parameters);
    s1538(n, c->sections, types, 0.0, 1, 4, 0, &c->surface, &c->parameters, &status);
    free(types);
    must(status);
}

static void gather_skin(void *object, double *result)
{
    contest *c = object;
    int left_u = 0, left_v = 0, status = 0;
    double normal[3];
    for (size_t k = 0; k < c->work->count; k++)
        for (size_t i = 0; i < BENCH_PLACES; i++, result += 3) {
            double at[2] = {c->work->u[i], c->parameters[k]};
            s1421(c->surface, 0, at, &left_u, &left_v, result, normal, &status);
        }
    must(status);
}

/* It calls a length done when the last step changed it by less than the tolerance. */
static void run_length(void *object)
{
    contest *c = object;
    int status;
    s1240(c->curve, 1e-11, c->out, &status);
    must(status);
}

static void gather_length(void *object, double *result)
{
    contest *c = object;
    *result = *c->out / 1e3;
}

#define ENTRY(name, kind, open, run, gather)               \
    {                                                      \
        name, kind, open, run, gather, close_contest, NULL \
    }

const bench_entry bench_sisl[] = {
    ENTRY("s1227", CURVE_POINTS, open_curve, run_curve, gather_curve),
    ENTRY("s1542", CURVE_POINTS, open_sorted_curve, run_curve_sorted, gather_curve),
    ENTRY("s1227", CURVE_SINGLE, open_curve, run_curve, gather_curve),
    ENTRY("s1506", SURFACE_GRID, open_surface, run_grid, gather_surface),
    ENTRY("s1421", SURFACE_POINTS, open_surface, run_points, gather_surface),
    ENTRY("s1421", SURFACE_SINGLE, open_surface, run_points, gather_surface),
    ENTRY("s1357", CURVE_THROUGH, open_curve_data, run_curve_through, gather_curve_through),
    ENTRY("s1537", SURFACE_THROUGH, open_grid_data, run_surface_through,
          gather_surface_through),
    ENTRY("s1538", SKIN, open_sections, run_skin, gather_skin),
    ENTRY("s1240", CURVE_LENGTH, open_curve, run_length, gather_length),
    {.way = NULL},
};
