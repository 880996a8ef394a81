/*
 * Points and derivatives of NURBS surfaces: first along u, line by line of the net, then along
 * v. One point, many points and grids add the same products in the same order, hence the same
 * bits.
 */
#include "spline/surface/surface.h"

#include "base/work.h"
#include "spline/curve/curve.h"
#include "spline/surface/kernel.h"

#include <string.h>

enum {
    SMALL_ORDER = 3, /* highest order that needs no allocation */
    SMALL_DERIVATIVES = BATTEN_SURFACE_DERIVATIVES(SMALL_ORDER),
    MAX_POINTS = BATTEN_MAX_DEGREE + 1,
    CHUNK = 1024
};

/* ---- room to work in ---- */

typedef struct {
    double *basis[2]; /* [order + 1][degree + 1] */
    double *line;     /* [q + 1][width]: the net combined along u */
    double *rows;     /* [BATTEN_SURFACE_DERIVATIVES(order)][width]: homogeneous derivatives */
} workspace;

enum {
    SMALL_BASIS = (SMALL_ORDER + 1) * MAX_POINTS,
    LINE = MAX_POINTS * BAT_MAX_WIDTH,
    SMALL_ROOM = 2 * SMALL_BASIS + LINE + SMALL_DERIVATIVES * BAT_MAX_WIDTH
};

static workspace divide_room(double *room, int order)
{
    const size_t basis = ((size_t)order + 1) * MAX_POINTS;
    return (workspace){{room, room + basis}, room + 2 * basis, room + 2 * basis + LINE};
}

static double *make_room(int order)
{
    const size_t basis = ((size_t)order + 1) * MAX_POINTS, n = (size_t)order;
    return bat_array(2 * basis + LINE + (n + 1) * (n + 2) / 2 * BAT_MAX_WIDTH, sizeof(double));
}

/* ---- one point ---- */

/* The homogeneous derivatives; `corner` is the first control point that bears on the spans. */
BAT_INLINE void contract(const int p, const int q, const size_t width, const double *corner,
                         size_t stride, const int order, const workspace *room, double *rows)
{
    for (int k = 0; k <= order; k++) {
        if (k <= p)
            bat_combine_rows(p + 1, ((size_t)q + 1) * width, room->basis[0] + k * (p + 1),
                             corner, stride, room->line);
        for (int l = 0; k + l <= order; l++) {
            double *row = rows + (size_t)BATTEN_SURFACE_DERIVATIVE(k, l) * width;
            if (k <= p && l <= q)
                bat_combine_rows(q + 1, width, room->basis[1] + l * (q + 1), room->line, width,
                                 row);
            else
                memset(row, 0, width * sizeof *row);
        }
    }
}

/* The same for a bicubic patch without weights, and order 0 or 1. */
BAT_INLINE void contract_cubic(const double *corner, const size_t stride, const int order,
                               const double *u, const double *v, double *rows)
{
    bat_triple point, along_u, along_v;
    for (int j = 0; j < 4; j++) {
        const bat_triple at = bat_combine_triples(u, corner + 3 * j, stride);
        const bat_triple term = bat_scale_triple(v[j], at);
        point = j == 0 ? term : bat_add_triples(point, term);
        if (order == 0)
            continue;
        const bat_triple rate = bat_combine_triples(u + 4, corner + 3 * j, stride);
        const bat_triple term_u = bat_scale_triple(v[j], rate),
                         term_v = bat_scale_triple(v[4 + j], at);
        along_u = j == 0 ? term_u : bat_add_triples(along_u, term_u);
        along_v = j == 0 ? term_v : bat_add_triples(along_v, term_v);
    }
    bat_store_triple(rows, point);
    if (order == 0)
        return;
    bat_store_triple(rows + 3, along_u);
    bat_store_triple(rows + 6, along_v);
}

static void evaluate_on(const bat_nurbs *nurbs, const int span[2], const double at[2],
                        int order, const workspace *room, double *out)
{
    const bat_axis *u = &nurbs->axes[BATTEN_U], *v = &nurbs->axes[BATTEN_V];
    const int p = u->degree, q = v->degree;
    const size_t width = nurbs->width, stride = (size_t)v->count * width;
    const double *corner = nurbs->net + (size_t)bat_axis_first_point(u, span[0]) * stride +
                           (size_t)bat_axis_first_point(v, span[1]) * width;
    double *rows = nurbs->weights ? room->rows : out;
    bat_axis_basis(u, span[0], at[0], order, room->basis[0]);
    bat_axis_basis(v, span[1], at[1], order, room->basis[1]);
    if (p == 3 && q == 3 && width == 3 && order == 0)
        contract_cubic(corner, stride, 0, room->basis[0], room->basis[1], rows);
    else if (p == 3 && q == 3 && width == 3 && order == 1)
        contract_cubic(corner, stride, 1, room->basis[0], room->basis[1], rows);
    else if (p == 3 && q == 3 && width == 3)
        contract(3, 3, 3, corner, stride, order, room, rows);
    else if (p == 3 && q == 3 && width == 4)
        contract(3, 3, 4, corner, stride, order, room, rows);
    else
        contract(p, q, width, corner, stride, order, room, rows);
    if (nurbs->weights)
        bat_surface_divide(nurbs->base.dimension, order, rows, out);
}

/* a(k, l) less the products of lower derivatives of the surface with derivatives of the weight.
 */
static void subtract_products(int dimension, int k, int l, const double *a, double *out)
{
    const int d = dimension;
    double *row = out + BATTEN_SURFACE_DERIVATIVE(k, l) * d, choose_i = 1;
    for (int i = 0; i <= k; i++) {
        double choose_j = 1;
        for (int j = 0; j <= l; j++) {
            if (i + j > 0) {
                const double w = a[BATTEN_SURFACE_DERIVATIVE(i, j) * (d + 1) + d];
                const double *lower = out + BATTEN_SURFACE_DERIVATIVE(k - i, l - j) * d;
                for (int c = 0; c < d; c++)
                    row[c] -= choose_i * choose_j * w * lower[c];
            }
            choose_j = choose_j * (l - j) / (j + 1);
        }
        choose_i = choose_i * (k - i) / (i + 1);
    }
}

void bat_surface_divide(int dimension, int order, const double *a, double *out)
{
    const int d = dimension;
    for (int n = 0; n <= order; n++)
        for (int l = 0; l <= n; l++) {
            const int at = BATTEN_SURFACE_DERIVATIVE(n - l, l);
            double *row = out + at * d;
            memcpy(row, a + at * (d + 1), (size_t)d * sizeof *row);
            subtract_products(d, n - l, l, a, out);
            for (int c = 0; c < d; c++)
                row[c] /= a[d];
        }
}

bool bat_all_finite(const double *values, size_t count)
{
    /* 0 times a number is 0 when it is finite, else NaN. */
    double sums[4] = {0};
    size_t i = 0;
    for (; i + 4 <= count; i += 4)
        for (int k = 0; k < 4; k++)
            sums[k] += 0 * values[i + (size_t)k];
    for (; i < count; i++)
        sums[0] += 0 * values[i];
    return sums[0] + sums[1] + sums[2] + sums[3] == 0;
}

static batten_status overflow(double u, double v)
{
    return bat_fail(BATTEN_OVERFLOW,
                    "the point or a derivative at (%.17g, %.17g) is too large for a number", u,
                    v);
}

/* Through a buffer, so that an overflow leaves `out` alone. */
static batten_status evaluate_checked(const bat_nurbs *nurbs, const int span[2],
                                      const double at[2], int order, const workspace *room,
                                      double *buffer, double *out)
{
    const size_t n = (size_t)order,
                 count = (n + 1) * (n + 2) / 2 * (size_t)nurbs->base.dimension;
    evaluate_on(nurbs, span, at, order, room, buffer);
    if (!bat_all_finite(buffer, count))
        return overflow(at[0], at[1]);
    memcpy(out, buffer, count * sizeof *out);
    return BATTEN_OK;
}

static batten_status evaluate_large(const bat_nurbs *nurbs, const int span[2],
                                    const double at[2], int order, double *out)
{
    const size_t n = (size_t)order;
    double *memory = make_room(order),
           *buffer = bat_array((n + 1) * (n + 2) / 2 * 3, sizeof *buffer);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (memory && buffer) {
        const workspace room = divide_room(memory, order);
        status = evaluate_checked(nurbs, span, at, order, &room, buffer, out);
    }
    bat_release(memory);
    bat_release(buffer);
    return status;
}

batten_status bat_nurbs_evaluate(const batten_surface *surface, double u, double v,
                                 batten_side side_u, batten_side side_v, int order, double *out)
{
    const bat_nurbs *nurbs = bat_nurbs_of(surface);
    batten_status status = bat_axis_place(&nurbs->axes[0], side_u, &u);
    if (status == BATTEN_OK)
        status = bat_axis_place(&nurbs->axes[1], side_v, &v);
    if (status != BATTEN_OK)
        return status;
    const double at[2] = {u, v};
    const int span[2] = {bat_axis_span(&nurbs->axes[0], u, side_u),
                         bat_axis_span(&nurbs->axes[1], v, side_v)};
    if (order > SMALL_ORDER)
        return evaluate_large(nurbs, span, at, order, out);
    double memory[SMALL_ROOM], buffer[3 * SMALL_DERIVATIVES];
    const workspace room = divide_room(memory, order);
    return evaluate_checked(nurbs, span, at, order, &room, buffer, out);
}

batten_status batten_surface_evaluate(const batten_surface *surface, double u, double v,
                                      int order, double *out)
{
    return batten_surface_evaluate_side(
        surface, u, v, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, order, out);
}

batten_status batten_surface_evaluate_side(const batten_surface *surface, double u, double v,
                                           batten_sides sides, int order, double *out)
{
    assert(surface && out && order >= 0);
    return surface->kind->evaluate(surface, u, v, sides.u, sides.v, order, out);
}

/* ---- many points ---- */

typedef struct {
    const bat_nurbs *nurbs;
    const double *uv;
    int order;
    double *out;
} batch;

static bool is_inside(const bat_axis *axis, double u)
{
    return u >= axis->breaks[0] && u < axis->breaks[axis->span_count];
}

/* Before anything is written: are all parameters in the domain? */
static batten_status check_parameters(const bat_nurbs *nurbs, size_t count, const double *uv)
{
    const bat_axis *axes = nurbs->axes;
    for (size_t i = 0; i < count; i++, uv += 2) {
        if (is_inside(&axes[0], uv[0]) && is_inside(&axes[1], uv[1]))
            continue;
        for (int k = 0; k < 2; k++) {
            double u = uv[k];
            const batten_status status = bat_axis_place(&axes[k], BATTEN_FROM_RIGHT, &u);
            if (status != BATTEN_OK)
                return bat_fail(status, "point %zu: %c = %.17g is not in the domain [%g, %g]",
                                i, k ? 'v' : 'u', u, axes[k].breaks[0],
                                axes[k].breaks[axes[k].span_count]);
        }
    }
    return BATTEN_OK;
}

static batten_status evaluate_points(const batch *work, const workspace *room, size_t begin,
                                     size_t end)
{
    const bat_nurbs *nurbs = work->nurbs;
    const bat_axis *axes = nurbs->axes;
    const size_t n = (size_t)work->order, d = (size_t)nurbs->base.dimension;
    const size_t size = (n + 1) * (n + 2) / 2 * d;
    for (size_t i = begin; i < end; i++) {
        double at[2] = {work->uv[2 * i], work->uv[2 * i + 1]};
        int span[2];
        for (int k = 0; k < 2; k++) {
            if (!is_inside(&axes[k], at[k]))
                bat_axis_place(&axes[k], BATTEN_FROM_RIGHT,
                               &at[k]); /* has been tried: succeeds */
            span[k] = bat_axis_span(&axes[k], at[k], BATTEN_FROM_RIGHT);
        }
        evaluate_on(nurbs, span, at, work->order, room, work->out + i * size);
    }
    if (bat_all_finite(work->out + begin * size, (end - begin) * size))
        return BATTEN_OK;
    size_t i = begin;
    while (bat_all_finite(work->out + i * size, size))
        i++;
    return overflow(work->uv[2 * i], work->uv[2 * i + 1]);
}

static batten_status evaluate_chunk(void *context, size_t begin, size_t end)
{
    const batch *work = context;
    if (work->order <= SMALL_ORDER) {
        double memory[SMALL_ROOM];
        const workspace room = divide_room(memory, work->order);
        return evaluate_points(work, &room, begin, end);
    }
    double *memory = make_room(work->order);
    if (!memory)
        return BATTEN_OUT_OF_MEMORY;
    const workspace room = divide_room(memory, work->order);
    const batten_status status = evaluate_points(work, &room, begin, end);
    bat_release(memory);
    return status;
}

batten_status bat_nurbs_evaluate_many(const batten_surface *surface, size_t count,
                                      const double *uv, int order, const batten_job *job,
                                      double *out)
{
    const bat_nurbs *nurbs = bat_nurbs_of(surface);
    batch work = {nurbs, uv, order, out};
    const batten_status status = check_parameters(nurbs, count, uv);
    return status == BATTEN_OK ? bat_parallel(job, count, CHUNK, evaluate_chunk, &work)
                               : status;
}

batten_status batten_surface_evaluate_many(const batten_surface *surface, size_t count,
                                           const double *uv, int order, const batten_job *job,
                                           double *out)
{
    assert(surface && (count == 0 || (uv && out)) && order >= 0);
    return surface->kind->evaluate_many(surface, count, uv, order, job, out);
}
