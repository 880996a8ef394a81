/* The class of Catmull and Rom, span by span in Bernstein form. */
#include "numeric/vector.h"
#include "shape/points/mirrored_ends.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

batten_curve_catmull_rom_options batten_curve_catmull_rom_defaults(void)
{
    return (batten_curve_catmull_rom_options){
        .size = sizeof(batten_curve_catmull_rom_options), .blend = 2, .local = 1, .alpha = 0.5};
}

/* The curve on its way; k, m as in the sources. */
typedef struct {
    int k, m, degree;
    int before;   /* points of a local polynomial before the first inner knot of its B-spline */
    int multiple; /* how often a knot stands at each parameter */
    int spans;
    bat_row_beyond row;
    double *pieces;  /* [spans][degree + 1][d], Bezier points */
    double *pyramid; /* [m + k][degree + 1][d] */
    double largest;  /* coordinate met on the way: what rounding is measured by */
} blended_curve;

static double parameter(const blended_curve *t, int i)
{
    return bat_parameter_beyond(&t->row, i);
}

static double *row_of(blended_curve *t, int a)
{
    return t->pyramid + (size_t)a * (size_t)(t->degree + 1) * (size_t)t->row.d;
}

/* ---- one span ---- */

/* A linear function of t by its values at both ends of the span. */
typedef struct {
    double start, end;
} linear;

/* (t - from) / (to - from) on the span of the parameters a, b. */
static linear rising(double from, double to, double a, double b)
{
    return (linear){(a - from) / (to - from), (b - from) / (to - from)};
}

/* The line from a at 0 to b at 1, at w: exact at both, and where a and b are near to each other
 * w may be large. */
static double between(double a, double b, double w)
{
    return w < 0.5 ? a + w * (b - a) : b - (1 - w) * (b - a);
}

/* In place: A of degree q becomes (1 - w) A + w B, of degree q + 1. */
static void blend(blended_curve *t, int q, linear w, double *A, const double *B)
{
    const int d = t->row.d;
    for (int j = q + 1; j >= 0; j--) {
        const double high = (double)j / (q + 1), low = 1 - high;
        for (int c = 0; c < d; c++) {
            double sum = 0;
            if (j <= q)
                sum += low * between(A[j * d + c], B[j * d + c], w.start);
            if (j > 0)
                sum += high * between(A[(j - 1) * d + c], B[(j - 1) * d + c], w.end);
            A[j * d + c] = sum;
            t->largest = bat_max(t->largest, fabs(sum));
        }
    }
}

/* The pyramid of Barry and Goldman: m levels of Neville's make the local polynomials, k - 1 of
 * de Boor's blend them. */
static void make_span(blended_curve *t, int i)
{
    const int k = t->k, m = t->m, first = i - k + 2 - t->before;
    const double a = parameter(t, i), b = parameter(t, i + 1);
    for (int r = 0; r < k + m; r++) {
        bat_point_beyond(&t->row, first + r, row_of(t, r));
        t->largest = bat_max(t->largest, bat_largest(t->row.d, row_of(t, r)));
    }
    for (int l = 1; l <= m; l++)
        for (int r = 0; r + l < k + m; r++) {
            const double from = parameter(t, first + r), to = parameter(t, first + r + l);
            blend(t, l - 1, rising(from, to, a, b), row_of(t, r), row_of(t, r + 1));
        }
    for (int l = 1; l < k; l++)
        for (int r = 0; r + l < k; r++) {
            const int j = i - k + 1 + r + l;
            const double from = parameter(t, j), to = parameter(t, j + k - l);
            blend(t, m + l - 1, rising(from, to, a, b), row_of(t, r), row_of(t, r + 1));
        }
    const size_t size = (size_t)(t->degree + 1) * (size_t)t->row.d;
    memcpy(t->pieces + (size_t)i * size, t->pyramid, size * sizeof *t->pieces);
}

/* ---- control points: blossoms of the spans ---- */

/* Which parameter stands at a knot. A closed curve is given by its knots from the first
 * parameter on; an open one has that degree + 1 times. */
static int node_of_knot(const blended_curve *t, int knot)
{
    const int s = t->multiple;
    if (t->row.closed)
        return knot >= 0 ? knot / s : -((s - 1 - knot) / s);
    return knot <= t->degree ? 0 : bat_min_int(t->spans, 1 + (knot - t->degree - 1) / s);
}

/* A span between the nodes, the longest: so knots lie at most as many spans outside it as there
 * are. */
static int longest_span(const blended_curve *t, int first, int last)
{
    int best = first == t->spans && !t->row.closed ? first - 1 : first;
    for (int i = first; i < last; i++)
        if (parameter(t, i + 1) - parameter(t, i) > parameter(t, best + 1) - parameter(t, best))
            best = i;
    return best;
}

/* The blossom of a span at the `degree` knots from `knot` on. */
static void control_point(blended_curve *t, int knot, double *out)
{
    const int p = t->degree, d = t->row.d;
    const int span = longest_span(t, node_of_knot(t, knot), node_of_knot(t, knot + p - 1));
    const double a = parameter(t, span), b = parameter(t, span + 1);
    const int at = t->row.closed ? (span % t->spans + t->spans) % t->spans : span;
    const size_t size = (size_t)(p + 1) * (size_t)d;
    double *P = t->pyramid;
    memcpy(P, t->pieces + (size_t)at * size, size * sizeof *P);
    for (int l = 0; l < p; l++) {
        const double u = parameter(t, node_of_knot(t, knot + l)), w = (u - a) / (b - a);
        for (int j = 0; j < (p - l) * d; j++) {
            P[j] = between(P[j], P[j + d], w);
            t->largest = bat_max(t->largest, fabs(P[j]));
        }
    }
    memcpy(out, P, (size_t)d * sizeof *out);
}

static batten_status make_curve(blended_curve *t, double *points, double *knots,
                                batten_curve **out)
{
    const int p = t->degree, d = t->row.d;
    if (t->row.closed) {
        const int m = t->spans * t->multiple;
        for (int i = 0; i < m; i++)
            control_point(t, i - p + 1, points + (size_t)i * (size_t)d);
        for (int i = 0; i <= m; i++)
            knots[i] = parameter(t, i / t->multiple);
        return batten_curve_create_periodic((batten_points){d, m, points}, p, NULL, knots, out);
    }
    const int n = p + 1 + (t->spans - 1) * t->multiple;
    for (int i = 0; i < n; i++)
        control_point(t, i + 1, points + (size_t)i * (size_t)d);
    for (int i = 0; i < n + p + 1; i++)
        knots[i] = parameter(t, node_of_knot(t, i));
    return batten_curve_create((batten_points){d, n, points}, p, NULL, knots, out);
}

/* ---- the whole ---- */

static batten_status check_blending(const batten_curve_catmull_rom_options *o)
{
    if (o->blend < 1)
        return bat_fail(BATTEN_BAD_DEGREE, "the blending degree is %d; it must be 1 or more",
                        o->blend);
    if (o->local < 0)
        return bat_fail(BATTEN_BAD_DEGREE, "the local degree is %d; it must be 0 or more",
                        o->local);
    if (o->blend > BATTEN_MAX_DEGREE || o->local > BATTEN_MAX_DEGREE - o->blend)
        return bat_fail(BATTEN_BAD_DEGREE, "the degrees %d and %d make more than the limit, %d",
                        o->blend, o->local, BATTEN_MAX_DEGREE);
    return BATTEN_OK;
}

static batten_status prepare(blended_curve *t)
{
    const int c = t->m - t->k + 2;
    const size_t d = (size_t)t->row.d, rows = (size_t)t->degree + 1;
    if ((double)(t->row.count + 1) * (t->degree + 1) > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d points would need too many pieces of degree %d",
                        t->row.count, t->degree);
    t->before = c >= 0 ? c / 2 : -((1 - c) / 2);
    t->multiple = bat_max_int(1, t->m + (t->m < t->k));
    t->spans = t->row.count - !t->row.closed;
    t->pieces = bat_array3((size_t)t->spans, rows * d, sizeof *t->pieces);
    t->pyramid = bat_array3((size_t)(t->m + t->k), rows * d, sizeof *t->pyramid);
    return t->pieces && t->pyramid ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status blend_pieces(blended_curve *t, batten_curve **out)
{
    const size_t size = (size_t)(t->degree + 1) * (size_t)t->row.d;
    for (int i = 0; i < t->spans; i++) {
        make_span(t, i);
        if (bat_first_not_finite(t->pieces + (size_t)i * size, size) < size)
            return bat_fail(BATTEN_OVERFLOW, "the points near span %d are too far apart",
                            i + 1);
    }
    const size_t most = (size_t)(t->spans + 1) * (size_t)(t->degree + 1);
    double *points = bat_array3(most, (size_t)t->row.d, sizeof *points);
    double *knots = bat_array(most + (size_t)t->degree + 1, sizeof *knots);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (points && knots)
        status = make_curve(t, points, knots, out);
    bat_release(points);
    bat_release(knots);
    return status;
}

/* The largest distance of a point from the curve; what rounding allows is refused beyond. */
static batten_status verify(const blended_curve *t, const batten_curve *curve, double *off)
{
    const bool through = t->m >= t->k - 2;
    /* Each level of the pyramid and of the blossom rounds four times. */
    const double zero = 8 * t->degree * DBL_EPSILON * t->largest * sqrt(t->row.d);
    for (int i = 0; i < t->row.count; i++) {
        double at[3];
        const batten_status status = batten_curve_evaluate(curve, t->row.t[i], 0, at);
        if (status != BATTEN_OK)
            return status;
        const double by =
            bat_distance(t->row.d, at, t->row.points + (size_t)i * (size_t)t->row.d);
        if (through && !(by <= zero))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the curve misses point %d by %g", i + 1,
                            by);
        *off = bat_max(*off, by);
    }
    return BATTEN_OK;
}

static batten_status find(blended_curve *t, double *parameters,
                          batten_curve_catmull_rom_report *report, batten_curve **out)
{
    batten_curve *curve = NULL;
    double off = 0;
    batten_status status = prepare(t);
    if (status == BATTEN_OK)
        status = blend_pieces(t, &curve);
    if (status == BATTEN_OK)
        status = verify(t, curve, &off);
    if (status != BATTEN_OK) {
        batten_curve_unref(curve);
        return status;
    }
    if (parameters)
        memcpy(parameters, t->row.t,
               ((size_t)t->row.count + t->row.closed) * sizeof *parameters);
    if (report)
        *report =
            (batten_curve_catmull_rom_report){t->degree - t->multiple, t->m >= t->k - 2, off};
    *out = curve;
    return BATTEN_OK;
}

batten_status batten_curve_catmull_rom(batten_points points,
                                       const batten_curve_catmull_rom_options *options,
                                       double *parameters,
                                       batten_curve_catmull_rom_report *report,
                                       batten_curve **out)
{
    assert(points.at && out);
    batten_curve_catmull_rom_options chosen = batten_curve_catmull_rom_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_curve_catmull_rom_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_curve_catmull_rom_options *o = &chosen;
    status = check_blending(o);
    if (status != BATTEN_OK)
        return status;
    blended_curve t = {.k = o->blend + 1, .m = o->local, .degree = o->blend + o->local};
    const bat_beyond_rule rule = {.alpha = o->alpha,
                                  .given = o->given,
                                  .closed = o->closed,
                                  .kind = o->phantoms,
                                  .degree = bat_max_int(o->blend, o->local)};
    status = bat_row_beyond_make(points, &rule, &t.row);
    if (status == BATTEN_OK)
        status = find(&t, parameters, report, out);
    bat_release(t.pieces);
    bat_release(t.pyramid);
    bat_release(t.row.t);
    return status;
}
