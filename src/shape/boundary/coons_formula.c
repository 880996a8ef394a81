/* The surface of kind "coons": the formula evaluated as it stands. */
#include "shape/boundary/coons_formula.h"
#include "base/sort.h"

#include "numeric/jet.h"
#include "numeric/vector.h"
#include "shape/formula/formula.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum { ORDERS = 4, MOST_LINES = 6 };

batten_status bat_coons_begin(int dimension, int count_u, int count_v, bat_coons *out)
{
    *out = (bat_coons){.dimension = dimension, .count = {count_u, count_v}};
    out->corner =
        bat_array3((size_t)count_u * (size_t)count_v, (size_t)dimension, sizeof *out->corner);
    bool made = out->corner;
    for (int k = 0; k < 2; k++) {
        out->blend[k] = bat_array((size_t)out->count[k], sizeof(batten_curve *));
        out->line[k] = bat_array((size_t)out->count[k], sizeof(batten_curve *));
        made = made && out->blend[k] && out->line[k];
    }
    return made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

void bat_coons_clear(bat_coons *coons)
{
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < coons->count[k]; i++) {
            if (coons->blend[k])
                batten_curve_unref(coons->blend[k][i]);
            if (coons->line[k])
                batten_curve_unref(coons->line[k][i]);
        }
        bat_release(coons->blend[k]);
        bat_release(coons->line[k]);
    }
    bat_release(coons->corner);
}

/* ---- one point ---- */

/* All that depends on one parameter: blends of one direction and lines along it. */
typedef struct {
    double blend[MOST_LINES][ORDERS];
    double line[MOST_LINES][ORDERS * 3];
} section;

static batten_status evaluate_section(const bat_coons *coons, int k, double t, batten_side side,
                                      int order, section *out)
{
    batten_status status = BATTEN_OK;
    memset(out, 0, sizeof *out);
    for (int i = 0; status == BATTEN_OK && i < coons->count[k]; i++)
        status = batten_curve_evaluate_side(coons->blend[k][i], t, side, order, out->blend[i]);
    for (int i = 0; status == BATTEN_OK && i < coons->count[1 - k]; i++)
        if (coons->line[1 - k][i])
            status =
                batten_curve_evaluate_side(coons->line[1 - k][i], t, side, order, out->line[i]);
    return status;
}

/* The derivative k times in u, l times in v. */
static void combine_terms(const bat_coons *coons, const section *u, const section *v, int k,
                          int l, double *out)
{
    const int d = coons->dimension;
    for (int x = 0; x < d; x++)
        out[x] = 0;
    for (int j = 0; j < coons->count[1]; j++)
        for (int x = 0; x < d; x++)
            out[x] += u->line[j][k * d + x] * v->blend[j][l];
    for (int i = 0; i < coons->count[0]; i++) {
        double sum[3] = {0};
        for (int x = 0; x < d; x++)
            sum[x] = v->line[i][l * d + x];
        for (int j = 0; j < coons->count[1]; j++)
            for (int x = 0; x < d; x++)
                sum[x] += coons->corner[(i * coons->count[1] + j) * d + x] * v->blend[j][l];
        for (int x = 0; x < d; x++)
            out[x] += u->blend[i][k] * sum[x];
    }
}

/* - A B (p - q) / (p + q) times half the difference of the twists, p and q being the distances
 * from the corner in u and v: on p = 0 it is one twist, on q = 0 the other. At the corner all
 * derivatives are taken as 0, the mean of what they are around it. */
static void turn_twists(const bat_coons *coons, double u, double v, const section *su,
                        const section *sv, int order, double *out)
{
    const int d = coons->dimension;
    for (int c = 0; c < 4; c++) {
        const int i = c / 2, j = c % 2;
        const bat_jet one = bat_jet_constant(1);
        const bat_jet p = i ? bat_jet_subtract(one, bat_jet_u(u)) : bat_jet_u(u);
        const bat_jet q = j ? bat_jet_subtract(one, bat_jet_v(v)) : bat_jet_v(v);
        if (p.d[0] + q.d[0] == 0)
            continue;
        const bat_jet share = bat_jet_divide(bat_jet_subtract(p, q), bat_jet_add(p, q));
        const bat_jet a = bat_jet_compose(su->blend[2 + i], bat_jet_u(u));
        const bat_jet b = bat_jet_compose(sv->blend[2 + j], bat_jet_v(v));
        const bat_jet term = bat_jet_multiply(bat_jet_multiply(a, b), share);
        for (int n = 0; n < BATTEN_SURFACE_DERIVATIVES(order); n++)
            for (int x = 0; x < d; x++)
                out[n * d + x] -= term.d[n] * coons->turn[i][j][x];
    }
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const bat_coons *coons = data;
    const int needed = coons->gregory ? 3 : order;
    section along_u, along_v;
    batten_status status = evaluate_section(coons, 0, at->u, at->sides.u, needed, &along_u);
    if (status == BATTEN_OK)
        status = evaluate_section(coons, 1, at->v, at->sides.v, needed, &along_v);
    if (status != BATTEN_OK)
        return status;
    for (int n = 0; n <= order; n++)
        for (int l = 0; l <= n; l++)
            combine_terms(coons, &along_u, &along_v, n - l, l,
                          out + BATTEN_SURFACE_DERIVATIVE(n - l, l) * coons->dimension);
    if (coons->gregory)
        turn_twists(coons, at->u, at->v, &along_u, &along_v, order, out);
    if (bat_first_not_finite(out,
                             (size_t)(BATTEN_SURFACE_DERIVATIVES(order) * coons->dimension)) <
        (size_t)(BATTEN_SURFACE_DERIVATIVES(order) * coons->dimension))
        return bat_fail(BATTEN_OVERFLOW, "the patch is beyond all numbers at (%g, %g)", at->u,
                        at->v);
    return BATTEN_OK;
}

/* ---- the surface ---- */

static batten_status to_nurbs(const void *data, double tolerance, batten_surface **out,
                              double *error)
{
    double moved = 0;
    const batten_status status = bat_coons_to_spline(data, bat_max(0, tolerance), &moved, out);
    if (status == BATTEN_OK && error)
        *error = moved;
    return status;
}

static void free_coons(void *data)
{
    bat_coons_clear(data);
    bat_release(data);
}

/* What has an equal NURBS surface, and what has not. */
static const bat_formula exact_formula = {"coons", evaluate, to_nurbs, free_coons};
static const bat_formula near_formula = {"coons", evaluate, NULL, free_coons};

typedef struct {
    int count, smoothness;
    double *spans;
} breaks;

/* All spans of what runs along direction k; those that rounding alone tells apart are one. */
static batten_status find_breaks(const bat_coons *coons, int k, breaks *out)
{
    const batten_curve *curves[2 * MOST_LINES];
    int count = 0, most = 0;
    for (int i = 0; i < coons->count[k]; i++)
        curves[count++] = coons->blend[k][i];
    for (int i = 0; i < coons->count[1 - k]; i++)
        if (coons->line[1 - k][i])
            curves[count++] = coons->line[1 - k][i];
    for (int i = 0; i < count; i++)
        most += curves[i]->count + 1;
    *out = (breaks){.smoothness = 2, .spans = bat_array((size_t)most, sizeof *out->spans)};
    if (!out->spans)
        return BATTEN_OUT_OF_MEMORY;
    int all = 0;
    for (int i = 0; i < count; i++) {
        all += batten_curve_spans(curves[i], out->spans + all);
        out->smoothness = bat_knots_smoothness(curves[i]->degree, curves[i]->count,
                                               curves[i]->knots, out->smoothness);
    }
    bat_sort_doubles((size_t)all, out->spans);
    for (int i = 0; i < all; i++)
        if (out->count == 0 || out->spans[i] - out->spans[out->count - 1] > 16 * DBL_EPSILON)
            out->spans[out->count++] = out->spans[i];
    out->spans[out->count - 1] = 1;
    return BATTEN_OK;
}

static double largest_coordinate(const bat_coons *coons)
{
    const int d = coons->dimension;
    double largest = bat_largest(coons->count[0] * coons->count[1] * d, coons->corner);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < coons->count[k]; i++)
            if (coons->line[k][i])
                largest = bat_max(largest, bat_largest(coons->line[k][i]->count * d,
                                                       coons->line[k][i]->points));
    return largest;
}

batten_status bat_coons_surface(bat_coons *coons, bool *exact, batten_surface **out)
{
    breaks axes[2] = {{0}, {0}};
    bat_coons *data = bat_array(1, sizeof *data);
    batten_status status = data ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_coons_is_exact(coons, exact);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = find_breaks(coons, k, &axes[k]);
    if (status == BATTEN_OK) {
        *data = *coons;
        const bat_formula_axis u = {axes[0].count, axes[0].spans, axes[0].smoothness};
        const bat_formula_axis v = {axes[1].count, axes[1].spans, axes[1].smoothness};
        status = bat_formula_create(*exact ? &exact_formula : &near_formula, data,
                                    coons->dimension, &u, &v, largest_coordinate(coons), out);
    }
    if (status == BATTEN_OK)
        *coons = (bat_coons){0};
    else
        bat_release(data);
    bat_release(axes[0].spans);
    bat_release(axes[1].spans);
    return status;
}
