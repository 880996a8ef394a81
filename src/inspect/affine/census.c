/* All special points of the spans of a curve, counted exactly: inflections, cusps, crossings.
 */
#include "base/list.h"
#include "inspect/affine/census_double.h"
#include "inspect/affine/exact_span.h"
#include "numeric/bernstein.h"
#include "numeric/vector.h"
#include <batten/invariants.h>

const char *batten_special_name(batten_special_kind kind, bool plural)
{
#define WORD(name, word, plural) {word, plural},
    static const char *const words[][2] = {BATTEN_SPECIAL_TABLE(WORD)};
#undef WORD
    return (unsigned)kind < BATTEN_SPECIAL_COUNT ? words[kind][plural] : "unknown";
}

/* ---- what is found ---- */

/* The point at t + s i; its real part, which is all there is of a double point. */

/* ---- roots in t ---- */

static bat_whole_poly linear(bat_wholes *pool, int constant, int slope)
{
    bat_whole_poly p = bat_poly_make(pool, 1);
    if (p.degree == 1) {
        p.c[0] = bat_whole_of_int(pool, constant);
        p.c[1] = bat_whole_of_int(pool, slope);
    }
    return bat_poly_trim(p);
}

static batten_status add_roots(bat_wholes *pool, bat_whole_poly p, batten_special_kind kind,
                               int multiplicity, bat_census_finding *f)
{
    int count = 0;
    bat_whole_root *roots = bat_wholes_take(pool, (size_t)p.degree + 2, sizeof *roots);
    if (!roots || p.degree < 1)
        return pool->effort->status;
    bat_poly_isolate(pool, p, roots, &count);
    for (int i = 0; i < count && pool->effort->status == BATTEN_OK; i++) {
        const bool inside = bat_poly_sign_at(pool, linear(pool, 0, 1), p, &roots[i]) > 0 &&
                            bat_poly_sign_at(pool, linear(pool, 1, -1), p, &roots[i]) > 0;
        bat_poly_refine(pool, p, 70, &roots[i]);
        const batten_special special = {.kind = kind,
                                        .inside = inside,
                                        .multiplicity = multiplicity,
                                        .t = bat_whole_root_value(pool, &roots[i]),
                                        .s = NAN};
        const batten_status status =
            pool->effort->status == BATTEN_OK ? bat_census_add(f, special) : BATTEN_OK;
        if (status != BATTEN_OK)
            return status;
    }
    return pool->effort->status;
}

/* Roots of odd multiplicity are of one kind, those of even of another; roots of `except` are
 * none of both. */
static batten_status add_all_roots(bat_wholes *pool, bat_whole_poly p, bat_whole_poly except,
                                   batten_special_kind odd, batten_special_kind even,
                                   bat_census_finding *f)
{
    if (p.degree < 1)
        return pool->effort->status;
    bat_whole_poly *parts = bat_wholes_take(pool, (size_t)p.degree + 1, sizeof *parts);
    if (!parts)
        return pool->effort->status;
    const int highest = bat_poly_squarefree(pool, bat_poly_primitive(pool, p), parts);
    batten_status status = pool->effort->status;
    for (int k = 1; k <= highest && status == BATTEN_OK; k++) {
        const bat_whole_poly part =
            bat_poly_quotient(pool, parts[k], bat_poly_gcd(pool, parts[k], except));
        status = add_roots(pool, part, k % 2 ? odd : even, k, f);
    }
    return status;
}

/* ---- margin ---- */

/* How far from a root more or less x'y'' - x''y' is in [0, 1], by its size: its values at the
 * ends and where it turns. */
static batten_status bending_margin(bat_wholes *pool, bat_whole_poly bending, double *margin)
{
    enum { MOST = 2 * BATTEN_MAX_DEGREE };
    double b[MOST], slope[MOST];
    bat_root turns[MOST];
    const int d = bending.degree;
    int count = 0;
    bat_poly_bernstein(pool, bending, b);
    *margin = bat_min(fabs(b[0]), fabs(b[d]));
    for (int k = 0; k < d; k++)
        slope[k] = d * (b[k + 1] - b[k]);
    if (d < 2)
        return BATTEN_OK;
    /* Where slopes vanish along a part the value there is as good as at its ends. */
    const batten_status status = bat_bernstein_roots(d - 1, slope, 0, turns, &count);
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        *margin = bat_min(*margin, fabs(bat_bernstein_value(d, b, turns[k].t)));
    return status == BATTEN_INCOMPLETE ? BATTEN_OK : status;
}

/* ---- one span ---- */

/* Numbers [count], two apart, to a size near 1. */
static void scale_to_one(int count, double *x)
{
    double largest = 0;
    int exponent;
    for (int i = 0; i < count; i++)
        largest = bat_max(largest, fabs(x[2 * i]));
    frexp(largest, &exponent);
    for (int i = 0; i < count; i++)
        x[2 * i] = ldexp(x[2 * i], -exponent);
}

/* Two coordinates of the points, from the first one, each of a size near 1: an affine map,
 * which a search for crossings may choose as it likes. */
static void flatten(const bat_census_finding *f, const int *axes, double *plane)
{
    for (int k = 0; k < 2; k++) {
        double *const x = plane + k;
        for (int i = 0; i <= f->degree; i++)
            x[2 * i] = f->points[i * f->dimension + axes[k]];
        scale_to_one(f->degree + 1, x);
        for (int i = f->degree; i >= 0; i--)
            x[2 * i] -= x[0];
        scale_to_one(f->degree + 1, x);
    }
}

static batten_status look_on_line(bat_wholes *pool, bat_whole_poly x, bat_census_finding *f)
{
    f->census.flat_dimension = 1;
    f->census.margin = f->census.flatness = 0;
    return add_all_roots(pool, bat_poly_derivative(pool, x), bat_poly_constant(pool, 1),
                         BATTEN_SPECIAL_CUSP, BATTEN_SPECIAL_PAUSE, f);
}

static batten_status look_in_plane(bat_wholes *pool, const bat_exact_span *span,
                                   const bat_flatness *flat, bat_census_finding *f)
{
    const int *axes = flat->axes;
    const bat_whole_poly x = span->at[axes[0]], y = span->at[axes[1]];
    const bat_whole_poly dx = bat_poly_derivative(pool, x), dy = bat_poly_derivative(pool, y);
    const bat_whole_poly stops = bat_poly_gcd(pool, dx, dy);
    const bat_whole_poly bending =
        bat_poly_combine(pool, 1, bat_poly_multiply(pool, dx, bat_poly_derivative(pool, dy)),
                         -1, bat_poly_multiply(pool, bat_poly_derivative(pool, dx), dy));
    if (bending.degree < 0) /* a line that rounding had made wider than a small tolerance */
        return look_on_line(pool, x.degree > y.degree ? x : y, f);
    /* With x' = s u, y' = s v: x'y'' - x''y' = s^2 (u v' - u' v). */
    const bat_whole_poly turning = bat_poly_quotient(pool, bat_poly_primitive(pool, bending),
                                                     bat_poly_multiply(pool, stops, stops));
    batten_status status = pool->effort->status;
    if (status == BATTEN_OK)
        status = bending_margin(pool, bending, &f->census.margin);
    if (status == BATTEN_OK)
        status = add_all_roots(pool, turning, stops, BATTEN_SPECIAL_INFLECTION,
                               BATTEN_SPECIAL_UNDULATION, f);
    if (status == BATTEN_OK)
        status = add_all_roots(pool, stops, bat_poly_constant(pool, 1), BATTEN_SPECIAL_CUSP,
                               BATTEN_SPECIAL_PAUSE, f);
    if (status != BATTEN_OK)
        return status;
    double plane[2 * (BATTEN_MAX_DEGREE + 1)];
    flatten(f, axes, plane);
    return bat_census_find_double(
        x, y, f->census.whole[BATTEN_SPECIAL_CUSP] + f->census.whole[BATTEN_SPECIAL_PAUSE],
        plane, f);
}

static batten_status look_at_span(bat_wholes *pool, double tolerance, bat_census_finding *f)
{
    batten_census *c = &f->census;
    bat_exact_span span;
    const batten_status status =
        bat_exact_span_read(pool, f->dimension, f->degree, f->points, &span);
    if (status != BATTEN_OK)
        return status;
    const bat_flatness flat =
        bat_exact_span_flatness(pool, &span, f->points, f->degree, tolerance);
    c->degree = span.degree;
    c->flat_dimension = flat.dimension;
    c->margin = c->flatness = flat.flatness;
    c->is_complete = true;
    if (flat.dimension == 2)
        return look_in_plane(pool, &span, &flat, f);
    if (flat.dimension == 1)
        return look_on_line(pool, span.at[flat.axes[0]], f);
    return pool->effort->status;
}

static batten_status check_arguments(int dimension, int degree, double tolerance)
{
    if (dimension != 2 && dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "special points are counted in 2 or 3 dimensions, not %d", dimension);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d is not in 1 .. %d", degree,
                        BATTEN_MAX_DEGREE);
    if (!(tolerance >= 0 && tolerance < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance %g is not in [0, 1)", tolerance);
    return BATTEN_OK;
}

batten_status batten_census_take(int dimension, int degree, const double *points,
                                 double tolerance, batten_census *out)
{
    batten_status status = check_arguments(dimension, degree, tolerance);
    if (status != BATTEN_OK)
        return status;
    const size_t all = ((size_t)degree + 1) * (size_t)dimension;
    const size_t bad = bat_first_not_finite(points, all);
    if (bad < all)
        return bat_fail(BATTEN_NOT_FINITE, "point %d is not finite", (int)bad / dimension + 1);
    bat_effort effort = {BATTEN_OK, BAT_CENSUS_EFFORT};
    bat_wholes pool = {&effort, NULL, NULL, 0};
    bat_census_finding f = {
        .dimension = dimension, .degree = degree, .points = points, .census = {.to = 1}};
    status = look_at_span(&pool, tolerance, &f);
    bat_wholes_release(&pool);
    if (status == BATTEN_INCOMPLETE && effort.status == BATTEN_INCOMPLETE)
        status =
            bat_fail(status,
                     "degree %d: inflections that coincide or nearly do take too much work "
                     "to be told apart",
                     f.census.degree);
    if (status != BATTEN_OK) {
        bat_release(f.census.specials);
        return status;
    }
    *out = f.census;
    return BATTEN_OK;
}

void batten_census_release(batten_census *census)
{
    bat_release(census->specials);
    census->specials = NULL;
    census->count = 0;
}

/* ---- spans of a curve ---- */

static void shift_parameters(batten_census *c, double a, double b)
{
    c->from = a;
    c->to = b;
    for (int i = 0; i < c->count; i++) {
        batten_special *const special = &c->specials[i];
        special->t = a + (b - a) * special->t;
        special->s = (b - a) * special->s + (special->kind == BATTEN_SPECIAL_ISOLATED ? 0 : a);
    }
}

void batten_censuses_release(batten_censuses *censuses)
{
    for (int i = 0; i < censuses->count && censuses->at; i++)
        batten_census_release(&censuses->at[i]);
    bat_release(censuses->at);
    *censuses = (batten_censuses){0, NULL};
}

batten_status batten_curve_census(const batten_curve *curve, double tolerance,
                                  batten_censuses *out)
{
    const int d = batten_curve_dimension(curve), p = batten_curve_degree(curve);
    const int spans = batten_curve_spans(curve, NULL) - 1;
    if (batten_curve_is_rational(curve))
        return bat_fail(
            BATTEN_UNSUPPORTED,
            "spans are classified of polynomial curves, and this one is rational, as circles "
            "and conics are");
    batten_curve *bezier = NULL;
    batten_census *found = NULL;
    double *breaks = NULL;
    batten_status status = check_arguments(d, p, tolerance);
    if (status == BATTEN_OK)
        status = batten_curve_to_bezier(curve, &bezier);
    if (status == BATTEN_OK) {
        found = bat_array((size_t)spans, sizeof *found);
        breaks = bat_array((size_t)spans + 1, sizeof *breaks);
        status = found && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        batten_curve_spans(curve, breaks);
    for (int i = 0; i < spans && status == BATTEN_OK; i++) {
        status = batten_census_take(d, p, batten_curve_points(bezier) + (size_t)(p * i * d),
                                    tolerance, &found[i]);
        if (status == BATTEN_OK)
            shift_parameters(&found[i], breaks[i], breaks[i + 1]);
        else if (status != BATTEN_OUT_OF_MEMORY)
            status = bat_fail(status, "span %d: %s", i + 1, batten_message());
    }
    bat_release(breaks);
    batten_curve_unref(bezier);
    if (status != BATTEN_OK) {
        batten_censuses_release(&(batten_censuses){spans, found});
        return status;
    }
    *out = (batten_censuses){spans, found};
    return BATTEN_OK;
}
