/*
 * Beyond an edge along the circles of curvature of the lines across it: with the vector of
 * curvature k and the length s = |Sv| t,
 *   C + Sv t sin(x) / x + k s^2 (1 - cos x) / x^2,  x = |k| s,
 * and both functions are power series of q = x^2, so that straight lines are nothing special.
 */
#include "shape/surface_change/extend.h"

#include "numeric/jet.h"
#include "numeric/vector.h"
#include "shape/formula/formula.h"

enum { TERMS = 34, MOST_VALUES = BATTEN_SURFACE_DERIVATIVES(5) * 3 };

typedef struct {
    batten_surface *surface;
    double end;
} arcs;

/* Sum of (-q)^k / (2 k + first)! and its derivatives; q up to 4 pi^2. */
static void series(double q, int first, double out[4])
{
    double c[TERMS], factorial = 1;
    for (int k = 2; k <= first; k++)
        factorial *= k;
    for (int k = 0; k < TERMS; k++) {
        c[k] = (k % 2 ? -1 : 1) / factorial;
        factorial *= (2.0 * k + first + 1) * (2.0 * k + first + 2);
    }
    for (int r = 0; r < 4; r++) {
        double sum = 0;
        for (int k = TERMS - 1; k >= r; k--) {
            double factor = c[k];
            for (int i = 0; i < r; i++)
                factor *= k - i;
            sum = factor + sum * q;
        }
        out[r] = sum;
    }
}

/* Derivative l across the edge as a function of u alone, divided by `scale`. */
static void along_edge(const double *values, int l, int order, double scale, bat_jet out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = bat_jet_constant(0);
        for (int k = 0; k <= order; k++)
            out[c].d[BATTEN_SURFACE_DERIVATIVE(k, 0)] =
                values[3 * BATTEN_SURFACE_DERIVATIVE(k, l) + c] / scale;
    }
}

static bat_jet dot_jets(const bat_jet a[3], const bat_jet b[3])
{
    return bat_jet_add(bat_jet_add(bat_jet_multiply(a[0], b[0]), bat_jet_multiply(a[1], b[1])),
                       bat_jet_multiply(a[2], b[2]));
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const arcs *a = data;
    double values[MOST_VALUES], f[4], g[4];
    bat_jet edge[3], slope[3], bend[3];
    const batten_status status = batten_surface_evaluate_side(
        a->surface, at->u, a->end, (batten_sides){at->sides.u, BATTEN_FROM_LEFT}, order + 2,
        values);
    if (status != BATTEN_OK)
        return status;
    const double scale = bat_norm(3, values + 3 * BATTEN_SURFACE_DERIVATIVE(0, 1));
    if (!(scale > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "at u = %.9g the surface stands still", at->u);
    along_edge(values, 0, order, 1, edge);
    along_edge(values, 1, order, scale, slope);
    along_edge(values, 2, order, scale, bend);
    /* Lengths and k s^2 in units of `scale`: k s^2 = (bend - (bend . T) T) t^2. */
    const bat_jet speed2 = dot_jets(slope, slope);
    const bat_jet part = bat_jet_divide(dot_jets(bend, slope), speed2);
    const bat_jet t = bat_jet_subtract(bat_jet_v(at->v), bat_jet_constant(a->end));
    const bat_jet t2 = bat_jet_multiply(t, t);
    for (int c = 0; c < 3; c++)
        bend[c] = bat_jet_subtract(bend[c], bat_jet_multiply(part, slope[c]));
    const bat_jet q = bat_jet_multiply(bat_jet_divide(dot_jets(bend, bend), speed2), t2);
    series(q.d[0], 1, f);
    series(q.d[0], 2, g);
    const bat_jet along = bat_jet_multiply(bat_jet_compose(f, q), t);
    const bat_jet aside = bat_jet_multiply(bat_jet_compose(g, q), t2);
    for (int c = 0; c < 3; c++) {
        const bat_jet added =
            bat_jet_add(bat_jet_multiply(slope[c], along), bat_jet_multiply(bend[c], aside));
        const bat_jet sum = bat_jet_add(edge[c], bat_jet_scale(scale, added));
        for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
            out[3 * i + c] = sum.d[i];
    }
    return BATTEN_OK;
}

static void free_arcs(void *data)
{
    arcs *a = data;
    batten_surface_unref(a->surface);
    bat_release(a);
}

static const bat_formula formula = {"arcs", evaluate, NULL, free_arcs};

static batten_status make_arcs(const batten_surface *surface, double way, batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *along = &nurbs->axes[BATTEN_U];
    const bat_formula_axis u = {
        along->span_count + 1, along->breaks,
        bat_knots_smoothness(along->degree, along->count, along->knots, 2)};
    const double end = nurbs->axes[BATTEN_V].breaks[nurbs->axes[BATTEN_V].span_count];
    const double ends[2] = {end, end + way};
    const bat_formula_axis v = {2, ends, 2};
    arcs *a = bat_array(1, sizeof *a);
    if (!a)
        return BATTEN_OUT_OF_MEMORY;
    *a = (arcs){batten_surface_ref(surface), end};
    const batten_status status =
        bat_formula_create(&formula, a, 3, &u, &v, nurbs->largest, out);
    if (status != BATTEN_OK)
        free_arcs(a);
    return status;
}

/* The old edge has one weight, so that a polynomial patch can follow. */
static batten_status check_weights(const bat_nurbs *nurbs)
{
    const int m = nurbs->axes[0].count, n = nurbs->axes[1].count;
    /* Weights that were given equal, but for some units in the last place. */
    for (int i = 1; nurbs->weights && i < m; i++)
        if (fabs(nurbs->weights[i * n + n - 1] / nurbs->weights[n - 1] - 1) > 1e-14)
            return bat_fail(BATTEN_UNSUPPORTED,
                            "the edge has different weights: 'natural' or 'line' extend it, "
                            "or make the surface polynomial first");
    return BATTEN_OK;
}

batten_status bat_surface_arc_on(const batten_surface *surface, double way, double tolerance,
                                 double *error, batten_surface **out)
{
    batten_surface *truth = NULL, *patch = NULL;
    batten_status status = check_weights(bat_surface_nurbs(surface));
    if (status == BATTEN_OK)
        status = make_arcs(surface, way, &truth);
    if (status == BATTEN_OK)
        status = batten_surface_to_nurbs(truth, tolerance, error, &patch);
    if (status == BATTEN_OK)
        status = batten_surface_join(surface, patch, BATTEN_V, 4 * tolerance, out);
    batten_surface_unref(truth);
    batten_surface_unref(patch);
    return status;
}
