/* The GNU Scientific Library on what it offers: basis functions, which the caller combines, and
 * functions through values. A curve through points would be three of these and no B-spline. */
#include "bench.h"

#include <gsl/gsl_bspline.h>
#include <gsl/gsl_matrix.h>
#include <gsl/gsl_spline.h>
#include <gsl/gsl_vector.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const bench_work *work;
    gsl_bspline_workspace *bases[2];
    gsl_vector *values[2];
    gsl_matrix *derivatives;
    gsl_spline *spline;
    gsl_interp_accel *place;
    double *out;
} contest;

static gsl_bspline_workspace *make_basis(const double *knots, int count, int degree)
{
    const size_t breaks = (size_t)(count - degree + 1);
    gsl_bspline_workspace *basis = gsl_bspline_alloc((size_t)degree + 1, breaks);
    gsl_vector *points = gsl_vector_alloc(breaks);
    for (size_t i = 0; i < breaks; i++)
        gsl_vector_set(points, i, knots[(size_t)degree + i]);
    gsl_bspline_knots(points, basis);
    gsl_vector_free(points);
    return basis;
}

static contest *begin(const bench_work *work, const double *knots_u, const double *knots_v,
                      int count)
{
    contest *c = calloc(1, sizeof *c);
    c->work = work;
    c->out = bench_numbers(9 * work->count);
    c->bases[0] = make_basis(knots_u, count, 3);
    c->bases[1] = make_basis(knots_v, count, 3);
    c->values[0] = gsl_vector_alloc(4);
    c->values[1] = gsl_vector_alloc(4);
    c->derivatives = gsl_matrix_alloc(4, 3);
    return c;
}

static void *open_curve(const bench_work *work)
{
    if (work->rational)
        return NULL;
    return begin(work, work->curve.knots, work->curve.knots, work->curve.count);
}

static void *open_surface(const bench_work *work)
{
    if (work->rational || work->order > 0)
        return NULL;
    return begin(work, work->surface.knots[0], work->surface.knots[1], work->surface.count);
}

static void close_contest(void *object)
{
    contest *c = object;
    for (int k = 0; k < 2; k++) {
        gsl_bspline_free(c->bases[k]);
        gsl_vector_free(c->values[k]);
    }
    gsl_matrix_free(c->derivatives);
    free(c->out);
    free(c);
}

static void run_curve(void *object)
{
    contest *c = object;
    const size_t rows = (size_t)c->work->order + 1;
    size_t first, last;
    for (size_t i = 0; i < c->work->count; i++) {
        double *out = c->out + 3 * rows * i;
        gsl_bspline_deriv_eval_nonzero(c->work->u[i], rows - 1, c->derivatives, &first, &last,
                                       c->bases[0]);
        for (size_t d = 0; d < rows; d++)
            for (size_t k = 0; k < 3; k++) {
                out[3 * d + k] = 0;
                for (size_t r = 0; r < 4; r++)
                    out[3 * d + k] += gsl_matrix_get(c->derivatives, r, d) *
                                      c->work->curve.points[3 * (first + r) + k];
            }
    }
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

static void run_surface(void *object)
{
    contest *c = object;
    const size_t n = (size_t)c->work->surface.count;
    size_t a, b, last;
    for (size_t i = 0; i < c->work->count; i++) {
        double *out = c->out + 3 * i;
        gsl_bspline_eval_nonzero(c->work->u[i], c->values[0], &a, &last, c->bases[0]);
        gsl_bspline_eval_nonzero(c->work->v[i], c->values[1], &b, &last, c->bases[1]);
        memset(out, 0, 3 * sizeof *out);
        for (size_t r = 0; r < 4; r++)
            for (size_t s = 0; s < 4; s++) {
                const double f =
                    gsl_vector_get(c->values[0], r) * gsl_vector_get(c->values[1], s);
                for (size_t k = 0; k < 3; k++)
                    out[k] += f * c->work->surface.points[3 * ((a + r) * n + b + s) + k];
            }
    }
}

static void gather_surface(void *object, double *result)
{
    contest *c = object;
    memcpy(result, c->out, 3 * c->work->count * sizeof *result);
}

static void *open_function(const bench_work *work)
{
    const gsl_interp_type *type = work->method == NATURAL_CUBIC ? gsl_interp_cspline
                                  : work->method == AKIMA       ? gsl_interp_akima
                                                                : gsl_interp_steffen;
    contest *c = calloc(1, sizeof *c);
    c->work = work;
    c->spline = gsl_spline_alloc(type, work->count);
    c->place = gsl_interp_accel_alloc();
    c->out = bench_numbers(work->count);
    return c;
}

static void run_function(void *object)
{
    contest *c = object;
    gsl_spline_init(c->spline, c->work->u, c->work->data, c->work->count);
    for (size_t i = 0; i + 1 < c->work->count; i++)
        c->out[i] = gsl_spline_eval(c->spline, c->work->v[i], c->place);
}

static void gather_function(void *object, double *result)
{
    const contest *c = object;
    memcpy(result, c->out + 2, c->work->result_count * sizeof *result);
}

static void close_function(void *object)
{
    contest *c = object;
    gsl_spline_free(c->spline);
    gsl_interp_accel_free(c->place);
    free(c->out);
    free(c);
}

const bench_entry bench_gsl[] = {
    {"gsl_bspline_deriv_eval_nonzero", CURVE_POINTS, open_curve, run_curve, gather_curve,
     close_contest, NULL},
    {"gsl_bspline_eval_nonzero", SURFACE_POINTS, open_surface, run_surface, gather_surface,
     close_contest, NULL},
    {"gsl_spline", FUNCTION_THROUGH, open_function, run_function, gather_function,
     close_function, NULL},
    {.way = NULL},
};
