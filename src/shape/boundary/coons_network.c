/*
 * Networks of Coons patches as one spline. With blending functions that run from cell to cell,
 * F_I being 1 and G_I rising with slope 1 at line I of the net,
 *
 *     S = sum F_I f_I(v) + sum g_J(u) F_J - sum F_I x_IJ F_J + sum G_I T_IJ G_J:
 *
 * slopes blended from those of the curves leave no other terms (see coons_patch.c).
 */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "shape/boundary/coons_formula.h"
#include "shape/grid/net_twists.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <float.h>
#include <string.h>

enum { MOST_CELLS = 4, MOST_VALUES = 6 };

typedef struct {
    const batten_surface_coons_network_options *options;
    int dimension, order; /* 1: F alone, 2: and G */
    int count[2];
    const double *at[2];
    const batten_curve *const *curves[2]; /* [0] along u, [1] along v */
    double *points, *tangents[2], *twists;
    double gap;
} network;

batten_surface_coons_network_options batten_surface_coons_network_defaults(void)
{
    return (batten_surface_coons_network_options){
        .size = sizeof(batten_surface_coons_network_options),
        .blending = BATTEN_BLENDING_COONS,
        .twists = BATTEN_TWISTS_ADINI,
        .tolerance = 1e-6, /* with metres, a micrometre */
        .parameters = BATTEN_CENTRIPETAL,
        .ends = BATTEN_END_NOT_A_KNOT};
}

/* ---- blending functions of a line of the net ---- */

/* The pieces from the start of the net to its end: 0 as far as nothing happens. */
typedef struct {
    int degree, cells, count, knot_count;
    double ends[MOST_CELLS + 1];
    double values[MOST_CELLS * MOST_VALUES], knots[MOST_CELLS * MOST_VALUES + 2 * MOST_VALUES];
} piecewise;

/* Add a cell that ends at b: a function of the family (NULL: 0) times `scale`. */
static void add_cell(piecewise *p, double b, const batten_curve *function, double scale)
{
    const double a = p->ends[p->cells];
    const int own = p->degree, n = function ? function->count : own + 1;
    for (int i = p->cells ? 1 : 0; i < n; i++)
        p->values[p->count++] = function ? scale * function->points[i] : 0;
    for (int i = own + 1; i < n; i++)
        p->knots[p->knot_count++] = a + function->knots[i] * (b - a);
    p->ends[++p->cells] = b;
}

static void add_knots(piecewise *p, double knot, int times)
{
    for (int i = 0; i < times; i++)
        p->knots[p->knot_count++] = knot;
}

/* The function of line i that is `left` (times its cell) before and `right` after it. */
static void pieces_of(int count, const double *t, int i, const batten_curve *left,
                      const batten_curve *right, bool scaled, piecewise *p)
{
    const int first = i > 0 ? i - 1 : 0, last = i + 1 < count ? i + 1 : count - 1;
    *p = (piecewise){.degree = left->degree, .ends = {t[0]}};
    add_knots(p, t[0], p->degree + 1);
    for (int stop = 0; stop < 4; stop++) {
        const int line = stop == 0 ? first : stop == 1 ? i : stop == 2 ? last : count - 1;
        const double a = p->ends[p->cells], b = t[line];
        if (b <= a)
            continue;
        if (p->cells)
            add_knots(p, a, p->degree);
        add_cell(p, b, stop == 1 ? left : stop == 2 ? right : NULL, scaled ? b - a : 1);
    }
    add_knots(p, t[count - 1], p->degree + 1);
}

/* Only the knots that its smoothness asks for: `smooth` derivatives are continuous at lines of the net.
 */
static batten_status remove_free_knots(const piecewise *p, int smooth, batten_curve *full,
                                       batten_curve **out)
{
    batten_status status = BATTEN_OK;
    const double largest = bat_largest(p->count, p->values);
    *out = batten_curve_ref(full);
    for (int c = 1; status == BATTEN_OK && c < p->cells; c++) {
        batten_curve *thinner = NULL;
        int removed = 0;
        status = batten_curve_remove_knot(*out, (batten_knot){p->ends[c], smooth},
                                          BAT_ROUNDING * largest, &removed, NULL, &thinner);
        if (status == BATTEN_OK && removed < smooth)
            status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                              "a blending function is not smooth at parameter %g", p->ends[c]);
        batten_curve_unref(*out);
        *out = thinner;
    }
    if (status != BATTEN_OK) {
        batten_curve_unref(*out);
        *out = NULL;
    }
    return status;
}

static batten_status line_blend(const network *net, int k, int i, int order,
                                batten_curve *const *functions, batten_curve **out)
{
    const int smooth = net->options->blending == BATTEN_BLENDING_LINEAR  ? 0
                       : net->options->blending == BATTEN_BLENDING_CUBIC ? 1
                                                                         : 2;
    piecewise p;
    batten_curve *full = NULL;
    pieces_of(net->count[k], net->at[k], i, functions[2 * order + 1], functions[2 * order],
              order > 0, &p);
    batten_status status = batten_curve_create((batten_points){1, p.count, p.values}, p.degree,
                                               NULL, p.knots, &full);
    if (status == BATTEN_OK)
        status = remove_free_knots(&p, smooth, full, out);
    batten_curve_unref(full);
    return status;
}

static batten_status make_blends(const network *net, bat_coons *coons)
{
    batten_curve *functions[4] = {NULL};
    batten_status status =
        batten_blending_functions(net->options->blending, net->order, functions);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        for (int i = 0; status == BATTEN_OK && i < coons->count[k]; i++)
            status = line_blend(net, k, i % net->count[k], i / net->count[k], functions,
                                &coons->blend[k][i]);
    for (int i = 0; i < 4; i++)
        batten_curve_unref(functions[i]);
    return status;
}

/* ---- crossings ---- */

/* Point and slope of a curve of the net at a line; across a corner the mean of both slopes. */
static batten_status evaluate_line(const batten_curve *curve, double t, double *point,
                                   double *slope)
{
    const int d = curve->dimension;
    double left[6], right[6];
    batten_status status = batten_curve_evaluate_side(curve, t, BATTEN_FROM_LEFT, 1, left);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, t, BATTEN_FROM_RIGHT, 1, right);
    for (int x = 0; status == BATTEN_OK && x < d; x++) {
        point[x] = left[x];
        slope[x] = left[d + x] / 2 + right[d + x] / 2;
    }
    return status;
}

static batten_status settle_crossing(network *net, int i, int j)
{
    const int d = net->dimension;
    const size_t at = ((size_t)i * (size_t)net->count[1] + (size_t)j) * (size_t)d;
    double by_u[3], by_v[3];
    batten_status status =
        evaluate_line(net->curves[0][j], net->at[0][i], by_u, net->tangents[0] + at);
    if (status == BATTEN_OK)
        status = evaluate_line(net->curves[1][i], net->at[1][j], by_v, net->tangents[1] + at);
    if (status != BATTEN_OK)
        return status;
    const double gap = bat_distance(d, by_u, by_v);
    if (!(gap <= net->options->tolerance))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "curve %d along u, at %g, and curve %d along v, at %g, miss each other "
                        "by %g",
                        j + 1, net->at[0][i], i + 1, net->at[1][j], gap);
    net->gap = bat_max(net->gap, gap);
    for (int x = 0; x < d; x++)
        net->points[at + (size_t)x] = by_u[x] / 2 + by_v[x] / 2;
    return BATTEN_OK;
}

static batten_status find_crossings(network *net)
{
    const size_t total = (size_t)net->count[0] * (size_t)net->count[1] * (size_t)net->dimension;
    net->points = bat_array(total, sizeof(double));
    net->twists = bat_array(total, sizeof(double));
    for (int k = 0; k < 2; k++)
        net->tangents[k] = bat_array(total, sizeof(double));
    batten_status status = net->points && net->twists && net->tangents[0] && net->tangents[1]
                               ? BATTEN_OK
                               : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < net->count[0]; i++)
        for (int j = 0; status == BATTEN_OK && j < net->count[1]; j++)
            status = settle_crossing(net, i, j);
    if (status != BATTEN_OK || net->order < 2)
        return status;
    if (net->options->given) {
        memcpy(net->twists, net->options->given, total * sizeof(double));
        return bat_first_not_finite(net->twists, total) < total
                   ? bat_fail(BATTEN_NOT_FINITE, "a given twist is not finite")
                   : BATTEN_OK;
    }
    return batten_net_twists(net->options->twists,
                             &(batten_net){net->dimension, net->count[0], net->count[1],
                                           net->at[0], net->at[1], net->points,
                                           net->tangents[0], net->tangents[1]},
                             NULL, NULL, net->twists);
}

/* ---- the surface ---- */

static void fill_formula(const network *net, bat_coons *coons)
{
    const int n = net->count[0], m = net->count[1], d = net->dimension;
    for (int i = 0; i < n; i++)
        coons->line[0][i] = batten_curve_ref(net->curves[1][i]);
    for (int j = 0; j < m; j++)
        coons->line[1][j] = batten_curve_ref(net->curves[0][j]);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            for (int x = 0; x < d; x++) {
                const size_t at = (size_t)(i * m + j) * (size_t)d + (size_t)x;
                const size_t columns = (size_t)coons->count[1], s = (size_t)d;
                coons->corner[((size_t)i * columns + (size_t)j) * s + (size_t)x] =
                    -net->points[at];
                if (net->order > 1)
                    coons->corner[((size_t)(n + i) * columns + (size_t)(m + j)) * s +
                                  (size_t)x] = net->twists[at];
            }
}

static batten_status build_network(network *net, batten_surface **out)
{
    bat_coons coons = {0};
    batten_surface *unit = NULL, *along = NULL;
    double moved;
    batten_status status = find_crossings(net);
    if (status == BATTEN_OK)
        status = bat_coons_begin(net->dimension, net->order * net->count[0],
                                 net->order * net->count[1], &coons);
    if (status == BATTEN_OK)
        status = make_blends(net, &coons);
    if (status == BATTEN_OK) {
        fill_formula(net, &coons);
        status = bat_coons_to_spline(&coons, 0, &moved, &unit);
    }
    const double *u = net->at[0], *v = net->at[1];
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(unit, BATTEN_U, u[0], u[net->count[0] - 1], &along);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(along, BATTEN_V, v[0], v[net->count[1] - 1], out);
    batten_surface_unref(along);
    batten_surface_unref(unit);
    bat_coons_clear(&coons);
    return status;
}

static batten_status check_axis(const network *net, int k)
{
    const char name = k ? 'v' : 'u';
    const double *t = net->at[k];
    const int count = net->count[k];
    const batten_status status = bat_net_check_axis(name, count, t);
    if (status != BATTEN_OK)
        return status;
    for (int j = 0; j < net->count[1 - k]; j++) {
        const batten_curve *curve = net->curves[k][j];
        const batten_interval domain = batten_curve_domain(curve);
        if (curve->dimension != net->dimension)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "curve %d along %c has %d dimension%s, not %d", j + 1, name,
                            curve->dimension, bat_plural(curve->dimension), net->dimension);
        if (curve->weights)
            return bat_fail(BATTEN_UNSUPPORTED,
                            "curve %d along %c is rational; a net of patches is a spline only "
                            "over polynomial curves",
                            j + 1, name);
        if (domain.a != t[0] || domain.b != t[count - 1])
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "curve %d along %c runs over [%g, %g], the net over [%g, %g]",
                            j + 1, name, domain.a, domain.b, t[0], t[count - 1]);
    }
    return BATTEN_OK;
}

static batten_status check_network(const network *net)
{
    const batten_surface_coons_network_options *o = net->options;
    if (!(o->tolerance >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, below 0", o->tolerance);
    if (o->blending < BATTEN_BLENDING_LINEAR || o->blending > BATTEN_BLENDING_COONS)
        return bat_fail(BATTEN_UNSUPPORTED, "a net takes the blending functions of a family");
    batten_status status = check_axis(net, 0);
    if (status == BATTEN_OK)
        status = check_axis(net, 1);
    const double total = 18.0 * 18.0 * net->count[0] * net->count[1];
    if (status == BATTEN_OK && total > 100.0 * BAT_MAX_POINTS)
        status = bat_fail(BATTEN_TOO_LARGE, "a net of %d x %d lines is too large",
                          net->count[0], net->count[1]);
    return status;
}

batten_status batten_surface_coons_network(const batten_curve_net *given,
                                           const batten_surface_coons_network_options *options,
                                           double *gap, batten_surface **out)
{
    assert(given->u && given->v && given->along_u && given->along_v && out);
    batten_surface_coons_network_options chosen = batten_surface_coons_network_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_surface_coons_network_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    network net = {.options = &chosen,
                   .count = {given->count_u, given->count_v},
                   .at = {given->u, given->v},
                   .curves = {given->along_u, given->along_v}};
    net.order = net.options->blending == BATTEN_BLENDING_LINEAR ? 1 : 2;
    net.dimension = given->count_v > 0 ? given->along_u[0]->dimension : 1;
    status = check_network(&net);
    if (status == BATTEN_OK)
        status = build_network(&net, out);
    if (status == BATTEN_OK && gap)
        *gap = net.gap;
    bat_release(net.points);
    bat_release(net.twists);
    bat_release(net.tangents[0]);
    bat_release(net.tangents[1]);
    return status;
}
