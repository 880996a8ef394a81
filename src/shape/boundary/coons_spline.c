/*
 * A Coons patch as one tensor B-spline. All that depends on u is brought to one degree and one
 * knot vector, so is all that depends on v; then the sums of the formula are sums of control
 * points.
 *
 * Rational lines along a direction that share their weight function w are multiplied by it, and
 * so are the blending functions there: the formula times w(u) w'(v) is polynomial.
 */
#include "shape/boundary/coons_formula.h"

#include "numeric/vector.h"
#include "shape/points/near_knots.h"
#include "spline/curve/curve.h"
#include "spline/curve/product.h"
#include "spline/surface/surface.h"

#include <float.h>
#include <string.h>

/* Everything along one direction on common knots: blends, lines, and the weight (NULL: 1). */
typedef struct {
    int blend_count, line_count, count; /* of curves */
    batten_curve **curves;              /* blends, lines that are there, the weight */
    int *line;                          /* [line_count] index into curves, or -1 */
    batten_curve *weight;
} strip;

static void strip_release(strip *s)
{
    for (int i = 0; i < s->count && s->curves; i++)
        batten_curve_unref(s->curves[i]);
    bat_release(s->curves);
    bat_release(s->line);
}

/* ---- the common weight ---- */

/* Do the curves, on common knots, have the same weights but for a factor? */
static bool weights_agree(const batten_curve *a, const batten_curve *b)
{
    const double factor = a->weights[0] / b->weights[0];
    for (int i = 0; i < a->count; i++)
        if (fabs(a->weights[i] - factor * b->weights[i]) > 64 * DBL_EPSILON * a->weights[i])
            return false;
    return true;
}

/* The rational lines along direction k on common knots; *agree: they share their weights. */
static batten_status gather_rational(const bat_coons *coons, int k, batten_curve **out,
                                     int *count, bool *agree)
{
    const int most = coons->count[1 - k];
    const batten_curve **given = bat_array((size_t)most, sizeof *given);
    if (!given)
        return BATTEN_OUT_OF_MEMORY;
    *count = 0;
    *agree = true;
    for (int i = 0; i < most; i++)
        if (coons->line[1 - k][i] && coons->line[1 - k][i]->weights)
            given[(*count)++] = coons->line[1 - k][i];
    const batten_status status = batten_curves_unify(*count, given, out);
    for (int i = 1; status == BATTEN_OK && i < *count; i++)
        *agree = *agree && weights_agree(out[0], out[i]);
    bat_release(given);
    return status;
}

static void unref_all(int count, batten_curve **curves)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(curves[i]);
}

static batten_status direction_is_exact(const bat_coons *coons, int k, bool *exact)
{
    int count = 0, degree = 0;
    bool agree = false;
    for (int i = 0; i < coons->count[k]; i++)
        degree = bat_max_int(degree, coons->blend[k][i]->degree);
    for (int i = 0; i < coons->count[k]; i++)
        if (coons->blend[k][i]->weights) {
            *exact = false;
            return BATTEN_OK;
        }
    batten_curve **unified = bat_array((size_t)coons->count[1 - k], sizeof *unified);
    if (!unified)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = gather_rational(coons, k, unified, &count, &agree);
    if (status == BATTEN_OK) {
        for (int i = 0; count && i < coons->count[1 - k]; i++)
            if (coons->line[1 - k][i] && !coons->line[1 - k][i]->weights)
                degree = bat_max_int(degree, coons->line[1 - k][i]->degree);
        *exact = agree && (count == 0 || degree + unified[0]->degree <= BATTEN_MAX_DEGREE);
        unref_all(count, unified);
    }
    bat_release(unified);
    return status;
}

batten_status bat_coons_is_exact(const bat_coons *coons, bool *exact)
{
    *exact = false;
    if (coons->gregory)
        return BATTEN_OK;
    batten_status status = direction_is_exact(coons, 0, exact);
    if (status == BATTEN_OK && *exact)
        status = direction_is_exact(coons, 1, exact);
    return status;
}

/* ---- polynomial strips ---- */

/* Numerators of a rational curve whose weights are `factor` times the common ones, over the
 * latter; or the weights themselves, with dimension 1. */
static batten_status numerator(const batten_curve *curve, const batten_curve *common,
                               bool weights, batten_curve **out)
{
    const int d = weights ? 1 : curve->dimension;
    batten_curve *made = NULL;
    const batten_status status = bat_curve_make(d, curve->degree, curve->count, false, &made);
    if (status != BATTEN_OK)
        return status;
    /* Scaled such that the largest weight of a curve is about 1. */
    for (int i = 0; i < curve->count; i++) {
        const double w = common->weights[i] / common->weights[0];
        for (int x = 0; x < d; x++)
            made->points[i * d + x] = weights ? w : w * curve->points[i * d + x];
    }
    memcpy(made->knots, curve->knots,
           ((size_t)curve->count + (size_t)curve->degree + 1) * sizeof *made->knots);
    made->periodic = curve->periodic;
    return bat_curve_finish(made, out);
}

/* A curve times the weight, with no more knots than it needs. */
static batten_status weighted(const batten_curve *curve, const batten_curve *weight,
                              batten_curve **out)
{
    batten_curve *unit = NULL, *product = NULL;
    batten_status status = batten_curve_set_domain(curve, 0, 1, &unit);
    if (status == BATTEN_OK)
        status = bat_curve_product(weight, unit, &product);
    if (status == BATTEN_OK) {
        const double size = bat_largest(product->count * product->dimension, product->points);
        status = batten_curve_remove_knots(product, 32 * DBL_EPSILON * size, NULL, NULL, out);
    }
    batten_curve_unref(product);
    batten_curve_unref(unit);
    return status;
}

/* The curves of a direction, polynomial: multiplied by the common weight where there is one. */
static batten_status list_curves(const bat_coons *coons, int k, int rational,
                                 batten_curve *const *unified, strip *s)
{
    batten_status status = BATTEN_OK;
    batten_curve *weight = NULL;
    int taken = 0;
    if (rational)
        status = numerator(unified[0], unified[0], true, &weight);
    for (int i = 0; status == BATTEN_OK && i < s->blend_count + s->line_count; i++) {
        const bool blend = i < s->blend_count;
        const int l = i - s->blend_count;
        const batten_curve *curve = blend ? coons->blend[k][i] : coons->line[1 - k][l];
        if (!blend)
            s->line[l] = curve ? s->count : -1;
        if (!curve)
            continue;
        if (curve->weights)
            status = numerator(unified[taken++], unified[0], false, &s->curves[s->count]);
        else if (weight)
            status = weighted(curve, weight, &s->curves[s->count]);
        else
            s->curves[s->count] = batten_curve_ref(curve);
        s->count += status == BATTEN_OK;
    }
    if (status == BATTEN_OK && weight)
        s->curves[s->count++] = weight;
    else
        batten_curve_unref(weight);
    return status;
}

static batten_status strip_unify(strip *s, bool rational)
{
    batten_curve **common = bat_array((size_t)s->count, sizeof *common);
    if (!common)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status =
        batten_curves_unify(s->count, (const batten_curve *const *)s->curves, common);
    if (status != BATTEN_OK) {
        bat_release(common);
        return status;
    }
    unref_all(s->count, s->curves);
    bat_release(s->curves);
    s->curves = common;
    s->weight = rational ? common[s->count - 1] : NULL;
    return BATTEN_OK;
}

static batten_status strip_make(const bat_coons *coons, int k, double tolerance, double *error,
                                strip *out)
{
    const int lines = coons->count[1 - k], most = coons->count[k] + lines + 1;
    int rational = 0;
    bool agree = true;
    *out = (strip){.blend_count = coons->count[k], .line_count = lines};
    out->curves = bat_array((size_t)most, sizeof *out->curves);
    out->line = bat_array((size_t)lines, sizeof *out->line);
    batten_curve **unified = bat_array((size_t)lines, sizeof *unified);
    batten_status status =
        out->curves && out->line && unified ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = gather_rational(coons, k, unified, &rational, &agree);
    if (status == BATTEN_OK) {
        assert(agree);
        status = list_curves(coons, k, rational, unified, out);
        unref_all(rational, unified);
    }
    if (status == BATTEN_OK && rational == 0 && tolerance > 0)
        status =
            bat_near_knots_join(out->blend_count, out->count, out->curves, tolerance, error);
    if (status == BATTEN_OK)
        status = strip_unify(out, rational > 0);
    bat_release(unified);
    return status;
}

/* ---- the net ---- */

/* L_i + sum over j of K_ij B_j, as control points along v. */
static void line_of(const bat_coons *coons, int i, const strip *v, double *out)
{
    const int d = coons->dimension, n = v->curves[0]->count;
    memset(out, 0, (size_t)n * (size_t)d * sizeof *out);
    if (v->line[i] >= 0)
        memcpy(out, v->curves[v->line[i]]->points, (size_t)n * (size_t)d * sizeof *out);
    for (int j = 0; j < coons->count[1]; j++) {
        const double *corner =
            coons->corner + ((size_t)i * (size_t)coons->count[1] + (size_t)j) * (size_t)d;
        if (bat_largest(d, corner) == 0)
            continue;
        for (int k = 0; k < n; k++)
            for (int x = 0; x < d; x++)
                out[k * d + x] += corner[x] * v->curves[j]->points[k];
    }
}

static void fill_net(const bat_coons *coons, const strip *u, const strip *v, double *line,
                     double *net)
{
    const int d = coons->dimension, n = u->curves[0]->count, m = v->curves[0]->count;
    const size_t row = (size_t)m * (size_t)d;
    for (int i = 0; i < coons->count[0]; i++) {
        line_of(coons, i, v, line);
        for (int r = 0; r < n; r++) {
            const double a = u->curves[i]->points[r];
            for (size_t x = 0; a != 0 && x < row; x++)
                net[(size_t)r * row + x] += a * line[x];
        }
    }
    for (int j = 0; j < coons->count[1]; j++)
        for (int s = 0; u->line[j] >= 0 && s < m; s++) {
            const double b = v->curves[j]->points[s];
            const double *points = u->curves[u->line[j]]->points;
            for (int r = 0; b != 0 && r < n; r++)
                for (int x = 0; x < d; x++)
                    net[(size_t)r * row + (size_t)(s * d + x)] += b * points[r * d + x];
        }
}

static void project(int d, const strip *u, const strip *v, bat_nurbs *nurbs)
{
    const int n = u->curves[0]->count, m = v->curves[0]->count;
    for (int r = 0; r < n; r++)
        for (int s = 0; s < m; s++) {
            const double w =
                (u->weight ? u->weight->points[r] : 1) * (v->weight ? v->weight->points[s] : 1);
            nurbs->weights[r * m + s] = w;
            for (int x = 0; x < d; x++)
                nurbs->points[(r * m + s) * d + x] /= w;
        }
}

static batten_status assemble(const bat_coons *coons, const strip *u, const strip *v,
                              batten_surface **out)
{
    const batten_curve *a = u->curves[0], *b = v->curves[0];
    const double total = (double)a->count * b->count;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "the surface would have %d x %d control points; the limit is %d",
                        a->count, b->count, BAT_MAX_POINTS);
    const bat_nurbs_shape shape = {.dimension = coons->dimension,
                                   .degree = {a->degree, b->degree},
                                   .count = {a->count, b->count},
                                   .rational = u->weight || v->weight};
    bat_nurbs *nurbs = NULL;
    double *line = bat_array3((size_t)b->count, (size_t)coons->dimension, sizeof *line);
    batten_status status = line ? bat_nurbs_make(&shape, &nurbs) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(nurbs->axes[0].knots, a->knots,
               ((size_t)a->count + (size_t)a->degree + 1) * sizeof *a->knots);
        memcpy(nurbs->axes[1].knots, b->knots,
               ((size_t)b->count + (size_t)b->degree + 1) * sizeof *b->knots);
        fill_net(coons, u, v, line, nurbs->points);
        if (shape.rational)
            project(coons->dimension, u, v, nurbs);
        status = bat_nurbs_finish(nurbs, out);
    }
    bat_release(line);
    return status;
}

batten_status bat_coons_to_spline(const bat_coons *coons, double tolerance, double *error,
                                  batten_surface **out)
{
    strip u = {0}, v = {0};
    const int lines = coons->count[0] + coons->count[1];
    *error = 0;
    /* No blending function is above 1: errors of lines add up at most. */
    batten_status status = strip_make(coons, 0, tolerance / lines, error, &u);
    if (status == BATTEN_OK)
        status = strip_make(coons, 1, tolerance / lines, error, &v);
    if (status == BATTEN_OK)
        status = assemble(coons, &u, &v, out);
    strip_release(&v);
    strip_release(&u);
    return status;
}
