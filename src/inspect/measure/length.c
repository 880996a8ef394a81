/* The length of a curve, and of its parts, with a bound on the error. */
#include "inspect/singular.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>

#include <float.h>
#include <string.h>

/* ---- one interval ---- */

/* A curve, and the Gauss-Legendre rules by which it is measured: the long one is exact up to
 * degree 31, and the short one, exact up to 19, tells how far off it may be. */
enum { SHORT = 10, LONG = 16 };

typedef struct {
    double nodes[LONG], weights[LONG];
} gauss;

typedef struct {
    const batten_curve *curve;
    double size; /* its largest coordinate */
    gauss coarse, fine;
} ruler;

static ruler ruler_for(const batten_curve *curve)
{
    ruler r = {.curve = curve, .size = bat_curve_size(curve)};
    bat_gauss(SHORT, r.coarse.nodes, r.coarse.weights);
    bat_gauss(LONG, r.fine.nodes, r.fine.weights);
    return r;
}

/* The integral of |C'| over [a, b] by a rule of n nodes; inside a span. */
static batten_status rule(const batten_curve *curve, const gauss *g, int n, double a, double b,
                          double *sum)
{
    double u[LONG] = {0}, values[LONG * 2 * 3], lengths = 0;
    const int d = curve->dimension;
    for (int i = 0; i < n; i++)
        u[i] = a + (b - a) * (0.5 + 0.5 * g->nodes[i]);
    batten_status status = batten_curve_evaluate_many(curve, (size_t)n, u, 1, NULL, values);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < n; i++)
        lengths += g->weights[i] * bat_norm(d, values + (2 * i + 1) * d);
    *sum = lengths * (b - a) / 2;
    return BATTEN_OK;
}

/* Sixty halvings bring any interval to its last places; the stack holds one waiting half of
 * each. After so many parts the others are not halved: what they are off is in the error. */
enum { DEPTH = 60, MOST_PARTS = 100000 };

typedef struct {
    double a, b;
    int depth;
} length_part;

typedef struct {
    double length, error;
} measure;

static batten_status measure_part(const ruler *r, double a, double b, measure *out)
{
    double coarse = 0, fine = 0;
    batten_status status = rule(r->curve, &r->coarse, SHORT, a, b, &coarse);
    if (status == BATTEN_OK)
        status = rule(r->curve, &r->fine, LONG, a, b, &fine);
    *out = (measure){fine, fabs(fine - coarse)};
    return status;
}

/* Halve until both rules agree, inside a span of that length. What differs by less than its
 * rounding cannot be improved: far from the origin that of the coordinates. */
static batten_status integrate(const ruler *r, double a, double b, double span,
                               double tolerance, measure *out)
{
    const double slip = bat_derivative_roundoff(r->curve, 1, r->size, span);
    length_part stack[DEPTH + 2] = {{a, b, 0}};
    int waiting = 1;
    measure sum = {0, 0};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && waiting > 0; k++) {
        const length_part whole = stack[--waiting];
        const double middle = whole.a + (whole.b - whole.a) / 2;
        measure m;
        status = measure_part(r, whole.a, whole.b, &m);
        const double share = tolerance * ((whole.b - whole.a) / (b - a));
        const double lost = slip * (whole.b - whole.a);
        const double roundoff = LONG * DBL_EPSILON * m.length + lost;
        if (m.error <= bat_max(share, roundoff) || whole.depth == DEPTH || k >= MOST_PARTS) {
            sum.length += m.length;
            sum.error += m.error + DBL_EPSILON * m.length + lost;
        } else {
            stack[waiting++] = (length_part){middle, whole.b, whole.depth + 1};
            stack[waiting++] = (length_part){whole.a, middle, whole.depth + 1};
        }
    }
    if (status == BATTEN_OK)
        *out = sum;
    return status;
}

/* ---- the curve ---- */

static batten_status check_tolerance(double tolerance)
{
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

/* Distinct knots of the domain, and the length from the start to each. */
typedef struct {
    int count;
    double *breaks;
    measure *sums; /* [count] */
} length_table;

static void table_end(length_table *t)
{
    bat_release(t->breaks);
    bat_release(t->sums);
}

/* Lengths of the parts of the spans inside [a, b]. */
static batten_status tabulate(const ruler *r, double a, double b, double tolerance,
                              length_table *out)
{
    length_table t = {batten_curve_spans(r->curve, NULL), NULL, NULL};
    t.breaks = bat_array((size_t)t.count, sizeof *t.breaks);
    t.sums = bat_array((size_t)t.count, sizeof *t.sums);
    batten_status status = t.breaks && t.sums ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(r->curve, t.breaks);
    for (int k = 0; status == BATTEN_OK && k + 1 < t.count; k++) {
        const double low = bat_max(a, t.breaks[k]), high = bat_min(b, t.breaks[k + 1]);
        measure one = {0, 0};
        if (low < high)
            status = integrate(r, low, high, t.breaks[k + 1] - t.breaks[k],
                               tolerance * ((high - low) / (b - a)), &one);
        t.sums[k + 1] = (measure){t.sums[k].length + one.length, t.sums[k].error + one.error};
    }
    if (status == BATTEN_OK)
        *out = t;
    else
        table_end(&t);
    return status;
}

batten_status batten_curve_length_between(const batten_curve *curve, double a, double b,
                                          double tolerance, double *error, double *length)
{
    const batten_interval domain = batten_curve_domain(curve);
    if (isnan(a) && isnan(b)) {
        a = domain.a;
        b = domain.b;
    }
    batten_status status = check_tolerance(tolerance);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &a);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &b);
    if (status == BATTEN_OK && a > b)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the part from %g to %g runs backwards", a, b);
    const ruler r = ruler_for(curve);
    length_table t;
    if (status == BATTEN_OK)
        status = tabulate(&r, a, b, tolerance, &t);
    if (status != BATTEN_OK)
        return status;
    *length = t.sums[t.count - 1].length;
    if (error)
        *error = t.sums[t.count - 1].error;
    table_end(&t);
    return BATTEN_OK;
}

batten_status batten_curve_length(const batten_curve *curve, double tolerance, double *error,
                                  double *length)
{
    const batten_interval domain = batten_curve_domain(curve);
    return batten_curve_length_between(curve, domain.a, domain.b, tolerance, error, length);
}

/* ---- from length to parameter ---- */

/* The u in [a, b], inside a span, up to which the length from a is s: Newton's step where it
 * stays inside what is left of the interval, else the middle. */
static batten_status invert(const ruler *r, double a, double b, double s, double whole,
                            double tolerance, double *u)
{
    double low = a, high = b, at = whole > 0 ? a + (b - a) * (s / whole) : a;
    for (int k = 0; k < 2 * DEPTH && low < high; k++) {
        double values[2 * 3];
        measure to = {0, 0};
        batten_status status = BATTEN_OK;
        if (at > a)
            status = integrate(r, a, at, b - a, tolerance / 4, &to);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(r->curve, at, 1, values);
        if (status != BATTEN_OK)
            return status;
        if (fabs(to.length - s) <= tolerance / 2)
            break;
        if (to.length < s)
            low = at;
        else
            high = at;
        const double speed = bat_norm(r->curve->dimension, values + r->curve->dimension);
        const double next = at + (s - to.length) / speed, middle = low + (high - low) / 2;
        const double try = speed > 0 && next > low && next < high ? next : middle;
        if (try == at)
            break;
        at = try;
    }
    *u = at;
    return BATTEN_OK;
}

static batten_status check_lengths(int count, const double *s, double whole, double tolerance)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(s[i]))
            return bat_fail(BATTEN_NOT_FINITE, "length %d is %g", i + 1, s[i]);
        if (i > 0 && s[i] < s[i - 1])
            return bat_fail(BATTEN_NOT_INCREASING, "length %d is %g, below %g before it", i + 1,
                            s[i], s[i - 1]);
        if (s[i] < -tolerance || s[i] > whole + tolerance)
            return bat_fail(BATTEN_OUT_OF_DOMAIN, "length %d is %g, but the curve is %g long",
                            i + 1, s[i], whole);
    }
    return BATTEN_OK;
}

static batten_status invert_all(const ruler *r, const length_table *t, int count,
                                const double *s, double tolerance, double *found)
{
    batten_status status = BATTEN_OK;
    for (int i = 0, k = 0; status == BATTEN_OK && i < count; i++) {
        while (k + 2 < t->count && t->sums[k + 1].length < s[i])
            k++;
        const double from = t->sums[k].length, whole = t->sums[k + 1].length - from;
        if (s[i] - from <= 0)
            found[i] = t->breaks[k];
        else if (s[i] - from >= whole)
            found[i] = t->breaks[k + 1];
        else
            status = invert(r, t->breaks[k], t->breaks[k + 1], s[i] - from, whole,
                            tolerance / 2, &found[i]);
    }
    return status;
}

batten_status batten_curve_at_length(const batten_curve *curve, int count, const double *s,
                                     double tolerance, double *u)
{
    const batten_interval domain = batten_curve_domain(curve);
    const ruler r = ruler_for(curve);
    length_table t = {0};
    double *found = NULL;
    batten_status status = check_tolerance(tolerance);
    if (status == BATTEN_OK)
        status = tabulate(&r, domain.a, domain.b, tolerance / 2, &t);
    if (status == BATTEN_OK)
        status = check_lengths(count, s, t.sums[t.count - 1].length, tolerance);
    if (status == BATTEN_OK && !(found = bat_array((size_t)count, sizeof *found)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = invert_all(&r, &t, count, s, tolerance, found);
    if (status == BATTEN_OK)
        memcpy(u, found, (size_t)count * sizeof *u);
    bat_release(found);
    table_end(&t);
    return status;
}
