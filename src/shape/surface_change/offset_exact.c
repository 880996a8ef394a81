/*
 * The offset in the space of the surface itself. The offset of a sphere, cone, torus and so on
 * has the knots and weights of the surface; so w (S + d n) is interpolated at Greville's
 * abscissae with them, and the result is compared with the truth.
 */
#include "numeric/rounding.h"
#include "shape/surface_change/offset.h"

#include "numeric/banded.h"
#include "numeric/vector.h"
#include "spline/spline.h"
#include "spline/surface/change.h"

#include <float.h>
#include <string.h>

enum { PROBES = 3, MOST_POINTS = 1000000 };

static const double probes[PROBES] = {0.13, 0.5, 0.81};

typedef struct {
    const batten_surface *surface; /* clamped */
    const bat_nurbs *nurbs;
    double distance, size;
    double *greville[2]; /* [count of the axis] */
    double *lu[2];       /* [count][2 degree + 1] */
    double *rows;        /* [count_u][count_v][3] */
} exact_offset;

static batten_status factor_direction(exact_offset *t, int k)
{
    const bat_axis *axis = &t->nurbs->axes[k];
    const int p = axis->degree, n = axis->count, width = 2 * p + 1;
    double basis[BATTEN_MAX_DEGREE + 1];
    t->greville[k] = bat_array((size_t)n, sizeof(double));
    t->lu[k] = bat_array3((size_t)n, (size_t)width, sizeof(double));
    if (!t->greville[k] || !t->lu[k])
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++) {
        const double at = bat_greville(p, axis->knots, i);
        const int span = bat_knots_span(p, n, axis->knots, at, BATTEN_FROM_RIGHT);
        bat_basis(p, axis->knots, span, at, 0, basis);
        t->greville[k][i] = at;
        for (int j = 0; j <= p; j++) {
            const int column = span - p + j - i + p;
            if (column >= 0 && column < width)
                t->lu[k][i * width + column] = basis[j];
        }
    }
    return bat_banded_factor(n, p, p, t->lu[k]);
}

/* The weight function where the surface is evaluated. */
static double weight_at(const bat_nurbs *nurbs, double u, double v)
{
    const double at[2] = {u, v};
    double basis[2][BATTEN_MAX_DEGREE + 1], sum = 0;
    int first[2];
    if (!nurbs->weights)
        return 1;
    for (int k = 0; k < 2; k++) {
        const bat_axis *axis = &nurbs->axes[k];
        const int span =
            bat_knots_span(axis->degree, axis->count, axis->knots, at[k], BATTEN_FROM_RIGHT);
        bat_basis(axis->degree, axis->knots, span, at[k], 0, basis[k]);
        first[k] = span - axis->degree;
    }
    for (int i = 0; i <= nurbs->axes[0].degree; i++)
        for (int j = 0; j <= nurbs->axes[1].degree; j++)
            sum += basis[0][i] * basis[1][j] *
                   nurbs->weights[(first[0] + i) * nurbs->axes[1].count + first[1] + j];
    return sum;
}

static batten_status sample(exact_offset *t)
{
    const int m = t->nurbs->axes[0].count, n = t->nurbs->axes[1].count;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < m && status == BATTEN_OK; i++)
        for (int j = 0; j < n && status == BATTEN_OK; j++) {
            const double u = t->greville[0][i], v = t->greville[1][j];
            double *row = t->rows + ((size_t)i * (size_t)n + (size_t)j) * 3;
            const bat_surface_place at = bat_surface_place_at(u, v);
            status = bat_offset_point(t->surface, t->distance, &at, 0, row);
            const double w = weight_at(t->nurbs, u, v);
            for (int c = 0; c < 3; c++)
                row[c] *= w;
        }
    return status;
}

static void solve_both(exact_offset *t)
{
    const bat_axis *u = &t->nurbs->axes[0], *v = &t->nurbs->axes[1];
    bat_banded_solve(u->count, u->degree, u->degree, t->lu[0], (size_t)v->count * 3, t->rows);
    for (int i = 0; i < u->count; i++)
        bat_banded_solve(v->count, v->degree, v->degree, t->lu[1], 3,
                         t->rows + (size_t)i * (size_t)v->count * 3);
}

/* An edge whose control points are one stays so, to the bit, where that is the truth. */
static void keep_poles(const exact_offset *t, double *points)
{
    const int m = t->nurbs->axes[0].count, n = t->nurbs->axes[1].count;
    for (int e = 0; e < 4; e++) {
        const int count = e < 2 ? m : n, step = e < 2 ? n : 1;
        const int first = e == 1 ? n - 1 : e == 3 ? (m - 1) * n : 0;
        bool pole = true;
        for (int i = 1; i < count && pole; i++) {
            const size_t a = 3 * (size_t)first, b = 3 * (size_t)(first + i * step);
            pole = bat_distance(3, t->nurbs->points + a, t->nurbs->points + b) <=
                       8 * DBL_EPSILON * t->size &&
                   bat_distance(3, points + a, points + b) <= BAT_ROUNDING * t->size;
        }
        for (int i = 1; i < count && pole; i++)
            memcpy(points + 3 * (size_t)(first + i * step), points + 3 * (size_t)first,
                   3 * sizeof *points);
    }
}

static batten_status make_surface(const exact_offset *t, batten_surface **out)
{
    bat_nurbs *made = NULL;
    const batten_status status = bat_nurbs_copy(t->nurbs, t->nurbs->weights != NULL, &made);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)made->axes[0].count * (size_t)made->axes[1].count;
    for (size_t i = 0; i < count; i++)
        for (size_t c = 0; c < 3; c++)
            made->points[3 * i + c] =
                t->rows[3 * i + c] / (made->weights ? made->weights[i] : 1);
    keep_poles(t, made->points);
    return bat_nurbs_finish(made, out);
}

/* Is it the offset, at places between the abscissae of every patch? */
static batten_status verify_offset(const exact_offset *t, const batten_surface *made,
                                   bool *exact)
{
    const bat_axis *axes = t->nurbs->axes;
    batten_status status = BATTEN_OK;
    *exact = true;
    for (int i = 0; i < axes[0].span_count * PROBES && *exact && status == BATTEN_OK; i++)
        for (int j = 0; j < axes[1].span_count * PROBES && *exact; j++) {
            double at[2], truth[3], point[3];
            const int index[2] = {i, j};
            for (int k = 0; k < 2; k++) {
                const double *b = axes[k].breaks + index[k] / PROBES;
                at[k] = b[0] + probes[index[k] % PROBES] * (b[1] - b[0]);
            }
            const bat_surface_place place = bat_surface_place_at(at[0], at[1]);
            status = bat_offset_point(t->surface, t->distance, &place, 0, truth);
            if (status == BATTEN_OK)
                status = batten_surface_evaluate(made, at[0], at[1], 0, point);
            if (status != BATTEN_OK)
                break;
            *exact = bat_distance(3, truth, point) <= BAT_ROUNDING * t->size;
        }
    return status;
}

static batten_status try_exact(exact_offset *t, batten_surface **out)
{
    const size_t count = (size_t)t->nurbs->axes[0].count * (size_t)t->nurbs->axes[1].count;
    batten_surface *made = NULL;
    bool exact = false;
    t->rows = bat_array3(count, 3, sizeof *t->rows);
    batten_status status = t->rows ? factor_direction(t, 0) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = factor_direction(t, 1);
    if (status == BATTEN_SINGULAR_SYSTEM)
        return BATTEN_OK; /* knots that leave nothing to interpolate: no exact surface */
    if (status == BATTEN_OK)
        status = sample(t);
    if (status != BATTEN_OK)
        return status;
    solve_both(t);
    status = make_surface(t, &made);
    if (status == BATTEN_OK)
        status = verify_offset(t, made, &exact);
    if (status == BATTEN_OK && exact)
        *out = batten_surface_ref(made);
    batten_surface_unref(made);
    return status;
}

batten_status bat_offset_exact(const batten_surface *surface, double distance,
                               batten_surface **out)
{
    exact_offset t = {.surface = surface, .distance = distance};
    t.nurbs = bat_surface_nurbs(surface);
    t.size = t.nurbs->largest + fabs(distance);
    *out = NULL;
    if (t.nurbs->axes[0].count > MOST_POINTS / t.nurbs->axes[1].count)
        return BATTEN_OK;
    const batten_status status = try_exact(&t, out);
    for (int k = 0; k < 2; k++) {
        bat_release(t.greville[k]);
        bat_release(t.lu[k]);
    }
    bat_release(t.rows);
    return status;
}
