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

/* The control points that bear on a pair of spans. */
typedef struct {
    int p, q;
    size_t width, stride; /* of a row: (q + 1) width are needed; from row to row */
    const double *corner; /* the first of them */
} bearing_points;

/* The homogeneous derivatives. Called with constants for p, q and width where it pays. */
BAT_INLINE void contract(const bearing_points *on, const int order, const workspace *room,
                         double *rows)
{
    const int p = on->p, q = on->q;
    const size_t width = on->width;
    for (int k = 0; k <= order; k++) {
        if (k <= p)
            bat_combine_rows(p + 1, ((size_t)q + 1) * width, room->basis[0] + k * (p + 1),
                             on->corner, on->stride, room->line);
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
BAT_INLINE void contract_cubic(const bearing_points *on, const int order, const workspace *room,
                               double *rows)
{
    const double *u = room->basis[0], *v = room->basis[1];
    bat_triple point, along_u, along_v;
    for (int j = 0; j < 4; j++) {
        const bat_triple at = bat_combine_triples(u, on->corner + 3 * j, on->stride);
        const bat_triple term = bat_scale_triple(v[j], at);
        point = j == 0 ? term : bat_add_triples(point, term);
        if (order == 0)
            continue;
        const bat_triple rate = bat_combine_triples(u + 4, on->corner + 3 * j, on->stride);
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

/* A pair of parameters, each in its domain and with the span that holds it. */
typedef struct {
    int span[2];
    double at[2];
} placed;

BAT_INLINE bearing_points bearing_on(const bat_nurbs *nurbs, const int span[2])
{
    const bat_axis *u = &nurbs->axes[BATTEN_U], *v = &nurbs->axes[BATTEN_V];
    const size_t width = nurbs->width, stride = (size_t)v->count * width;
    const double *corner = nurbs->net + (size_t)bat_axis_first_point(u, span[0]) * stride +
                           (size_t)bat_axis_first_point(v, span[1]) * width;
    return (bearing_points){u->degree, v->degree, width, stride, corner};
}

/* contract(), in the form that is made for the degrees, the width and the order. */
BAT_INLINE void contract_fast(const bearing_points *on, int order, const workspace *room,
                              double *rows)
{
    const bool is_cubic = on->p == 3 && on->q == 3;
    if (is_cubic && on->width == 3 && order == 0)
        contract_cubic(on, 0, room, rows);
    else if (is_cubic && on->width == 3 && order == 1)
        contract_cubic(on, 1, room, rows);
    else if (is_cubic && on->width == 3)
        contract(&(bearing_points){3, 3, 3, on->stride, on->corner}, order, room, rows);
    else if (is_cubic && on->width == 4)
        contract(&(bearing_points){3, 3, 4, on->stride, on->corner}, order, room, rows);
    else
        contract(on, order, room, rows);
}

static void evaluate_on(const bat_nurbs *nurbs, const placed *place, int order,
                        const workspace *room, double *out)
{
    const bearing_points on = bearing_on(nurbs, place->span);
    double *rows = nurbs->weights ? room->rows : out;
    bat_axis_basis(&nurbs->axes[0], place->span[0], place->at[0], order, room->basis[0]);
    bat_axis_basis(&nurbs->axes[1], place->span[1], place->at[1], order, room->basis[1]);
    contract_fast(&on, order, room, rows);
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

static size_t value_count(const bat_nurbs *nurbs, int order)
{
    const size_t n = (size_t)order;
    return (n + 1) * (n + 2) / 2 * (size_t)nurbs->base.dimension;
}

/* Hand `count` numbers over unless one has overflowed, which leaves `out` alone. */
static batten_status hand_over_finite(const placed *place, size_t count, const double *values,
                                      double *out)
{
    if (!bat_all_finite(values, count))
        return overflow(place->at[0], place->at[1]);
    memcpy(out, values, count * sizeof *out);
    return BATTEN_OK;
}

static batten_status evaluate_large(const bat_nurbs *nurbs, const placed *place, int order,
                                    double *out)
{
    const size_t count = value_count(nurbs, order);
    double *memory = make_room(order), *values = bat_array(count, sizeof *values);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (memory && values) {
        const workspace room = divide_room(memory, order);
        evaluate_on(nurbs, place, order, &room, values);
        status = hand_over_finite(place, count, values, out);
    }
    bat_release(memory);
    bat_release(values);
    return status;
}

static batten_status find_place(const bat_nurbs *nurbs, const bat_surface_place *at,
                                placed *out)
{
    *out = (placed){.at = {at->u, at->v}};
    const batten_side sides[2] = {at->sides.u, at->sides.v};
    for (int k = 0; k < 2; k++) {
        const batten_status status = bat_axis_place(&nurbs->axes[k], sides[k], &out->at[k]);
        if (status != BATTEN_OK)
            return status;
        out->span[k] = bat_axis_span(&nurbs->axes[k], out->at[k], sides[k]);
    }
    return BATTEN_OK;
}

batten_status bat_nurbs_evaluate(const batten_surface *surface, const bat_surface_place *at,
                                 int order, double *out)
{
    const bat_nurbs *nurbs = bat_nurbs_of(surface);
    placed place;
    const batten_status status = find_place(nurbs, at, &place);
    if (status != BATTEN_OK)
        return status;
    if (order > SMALL_ORDER)
        return evaluate_large(nurbs, &place, order, out);
    double memory[SMALL_ROOM], values[3 * SMALL_DERIVATIVES];
    const workspace room = divide_room(memory, order);
    evaluate_on(nurbs, &place, order, &room, values);
    return hand_over_finite(&place, value_count(nurbs, order), values, out);
}

batten_status batten_surface_evaluate(const batten_surface *surface, double u, double v,
                                      int order, double *out)
{
    assert(surface && out && order >= 0);
    const bat_surface_place at = bat_surface_place_at(u, v);
    return surface->kind->evaluate(surface, &at, order, out);
}

batten_status batten_surface_evaluate_side(const batten_surface *surface, double u, double v,
                                           batten_sides sides, int order, double *out)
{
    assert(surface && out && order >= 0);
    const bat_surface_place at = {u, v, sides};
    return surface->kind->evaluate(surface, &at, order, out);
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

/* Can the parameters of point i be brought into the domain? */
static batten_status try_place(const bat_axis axes[2], size_t i, const double uv[2])
{
    for (int k = 0; k < 2; k++) {
        double u = uv[k];
        const batten_status status = bat_axis_place(&axes[k], BATTEN_FROM_RIGHT, &u);
        if (status != BATTEN_OK)
            return bat_fail(status, "point %zu: %c = %.17g is not in the domain [%g, %g]",
                            i + 1, k ? 'v' : 'u', u, axes[k].breaks[0],
                            axes[k].breaks[axes[k].span_count]);
    }
    return BATTEN_OK;
}

/* Before anything is written: are all parameters in the domain? */
static batten_status check_parameters(const bat_nurbs *nurbs, size_t count, const double *uv)
{
    const bat_axis *axes = nurbs->axes;
    for (size_t i = 0; i < count; i++, uv += 2) {
        if (is_inside(&axes[0], uv[0]) && is_inside(&axes[1], uv[1]))
            continue;
        const batten_status status = try_place(axes, i, uv);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* Parameters that were checked. */
static inline void place_checked(const bat_axis *axes, const double *uv, placed *out)
{
    for (int k = 0; k < 2; k++) {
        out->at[k] = uv[k];
        if (!is_inside(&axes[k], out->at[k]))
            bat_axis_place(&axes[k], BATTEN_FROM_RIGHT,
                           &out->at[k]); /* has been tried: succeeds */
        out->span[k] = bat_axis_span(&axes[k], out->at[k], BATTEN_FROM_RIGHT);
    }
}

/* Names the first point from i on that has overflowed; there is one. */
static batten_status overflow_from(const batch *work, size_t i)
{
    const size_t size = value_count(work->nurbs, work->order);
    while (bat_all_finite(work->out + i * size, size))
        i++;
    return overflow(work->uv[2 * i], work->uv[2 * i + 1]);
}

static batten_status evaluate_points(const batch *work, const workspace *room, size_t begin,
                                     size_t end)
{
    const size_t size = value_count(work->nurbs, work->order);
    for (size_t i = begin; i < end; i++) {
        placed place;
        place_checked(work->nurbs->axes, work->uv + 2 * i, &place);
        evaluate_on(work->nurbs, &place, work->order, room, work->out + i * size);
    }
    if (bat_all_finite(work->out + begin * size, (end - begin) * size))
        return BATTEN_OK;
    return overflow_from(work, begin);
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

batten_status bat_nurbs_evaluate_many(const batten_surface *surface, batten_batch uv, int order,
                                      const batten_job *job, double *out)
{
    const bat_nurbs *nurbs = bat_nurbs_of(surface);
    batch work = {nurbs, uv.at, order, out};
    const batten_status status = check_parameters(nurbs, uv.count, uv.at);
    return status == BATTEN_OK ? bat_parallel(job, uv.count, CHUNK, evaluate_chunk, &work)
                               : status;
}

batten_status batten_surface_evaluate_many(const batten_surface *surface, size_t count,
                                           const double *uv, int order, const batten_job *job,
                                           double *out)
{
    assert(surface && (count == 0 || (uv && out)) && order >= 0);
    return surface->kind->evaluate_many(surface, (batten_batch){count, uv}, order, job, out);
}
