/*
 * Few common knots for many curves.
 *
 * Sections that were faired one by one have knots of their own, and their union is a dense comb
 * of slivers. Here all are refitted, by least squares with their ends held, upon one vector: it
 * begins with the average of their own knots, or with none, gains the middles of the spans in
 * which some section is too far off, and loses every knot that is not needed. The better of the
 * two beginnings is kept. How far a section moved is bounded by the control points of the
 * difference on the common refinement, and that bound is what is compared with the tolerance.
 */
#include "numeric/vector.h"
#include "shape/skin.h"
#include "spline/curve.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* Knots that all sections shall have, `inner` of them inside (0, 1). */
typedef struct {
    int inner, capacity;
    double *knots; /* [capacity] rising, p times where a corner is */
    bool *held;    /* [capacity] that of a corner: it stays */
} comb;

typedef struct {
    int count, degree, dimension;
    size_t width;
    bool rational;
    double tolerance;
    bat_spline *given;  /* [count] homogeneous rows over [0, 1] */
    bat_spline *fitted; /* [count] upon the comb */
    double *deviation;  /* [count] */
    double *error;      /* [capacity + 1] largest of all sections in each span of the comb */
    int limit;          /* inner knots of all sections together: more are not worth it */
    bat_work *work;
} fitting;

/* ---- speed along a section ---- */

/* Tangents that differ by more than this angle, in radians, are a corner and not an inaccuracy.
 */
static const double corner_angle = 0.01;

/* At a knot that stands p times, its first at i: by how much the curve is faster behind it,
 * when its tangent goes on; 0 at a corner, 1 at other knots. */
static double speed_ratio(const batten_curve *curve, int i)
{
    const int p = batten_curve_degree(curve), d = batten_curve_dimension(curve);
    const double *U = batten_curve_knots(curve);
    if (U[i] != U[i + p - 1])
        return 1;
    const double *on = batten_curve_points(curve) + (size_t)(i - 1) * (size_t)d;
    double before[3], after[3];
    for (int c = 0; c < d; c++) {
        before[c] = on[c] - on[c - d];
        after[c] = on[c + d] - on[c];
    }
    const double a = bat_norm(d, before), b = bat_norm(d, after);
    if (!(a > 0 && b > 0) || bat_dot(d, before, after) < cos(corner_angle) * a * b)
        return 0;
    const double ratio = (b / (U[i + p] - U[i])) / (a / (U[i] - U[i - 1]));
    return ratio > 1.0 / 64 && ratio < 64 ? ratio
                                          : 0; /* beyond, stretching would leave slivers */
}

/* Stretch the spans between two corners, or ends, U[first] and U[last], by the speeds there:
 * `stretched` begins with the knots in [first, last) and is made to end where they do. */
static void restore_length(const double *U, int first, int last, double *stretched)
{
    const double given = U[last] - U[first], found = stretched[last] - stretched[first];
    for (int i = first; i <= last; i++)
        stretched[i] = U[first] + (stretched[i] - stretched[first]) * (given / found);
    stretched[last] = U[last];
}

static void stretch(const batten_curve *curve, double *knots)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *U = batten_curve_knots(curve);
    double factor = 1;
    memcpy(knots, U, (size_t)(n + p + 1) * sizeof *knots);
    int corner = p;
    for (int i = p + 1; i <= n; i++) {
        knots[i] = U[i] == U[i - 1] ? knots[i - 1] : knots[i - 1] + factor * (U[i] - U[i - 1]);
        if (i < n && U[i] == U[i - 1])
            continue;
        const double ratio = i < n ? speed_ratio(curve, i) : 0;
        factor *= ratio;
        if (ratio == 0) {
            restore_length(U, corner, i, knots);
            corner = i;
            factor = 1;
        }
    }
}

batten_status bat_skin_even_speed(const batten_curve *section, batten_curve **out)
{
    batten_curve *clamped = NULL;
    batten_status status = batten_curve_clamp(section, &clamped);
    if (status != BATTEN_OK || batten_curve_is_rational(clamped)) {
        if (status == BATTEN_OK)
            *out = clamped;
        return status;
    }
    const int p = batten_curve_degree(clamped), n = batten_curve_point_count(clamped);
    double *knots = bat_array((size_t)(n + p + 1), sizeof *knots);
    status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        stretch(clamped, knots);
        for (int i = n + 1; i <= n + p; i++)
            knots[i] = knots[n];
        status = batten_curve_create(batten_curve_dimension(clamped), p, n,
                                     batten_curve_points(clamped), NULL, knots, out);
    }
    bat_release(knots);
    batten_curve_unref(clamped);
    return status;
}

/* ---- the sections over [0, 1] ---- */

static batten_status normalise(const batten_curve *section, int degree, batten_curve **out)
{
    batten_curve *clamped = NULL, *raised = NULL;
    batten_status status = batten_curve_clamp(section, &clamped);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(clamped, degree - batten_curve_degree(clamped), &raised);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(raised, 0, 1, out);
    batten_curve_unref(raised);
    batten_curve_unref(clamped);
    return status;
}

static batten_status take_rows(const fitting *f, const batten_curve *curve, bat_spline *out)
{
    const size_t d = (size_t)f->dimension;
    const int n = batten_curve_point_count(curve);
    const batten_status status = bat_spline_make(f->degree, n, f->width, out);
    if (status != BATTEN_OK)
        return status;
    const double *P = batten_curve_points(curve), *w = batten_curve_weights(curve);
    memcpy(out->knots, batten_curve_knots(curve),
           (size_t)(n + f->degree + 1) * sizeof *out->knots);
    for (size_t i = 0; i < (size_t)n; i++) {
        for (size_t c = 0; c < d; c++)
            out->values[i * f->width + c] = (w ? w[i] : 1) * P[i * d + c];
        if (f->rational)
            out->values[i * f->width + d] = w ? w[i] : 1;
    }
    return BATTEN_OK;
}

static batten_status take_sections(fitting *f, const batten_curve *const *sections)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < f->count; k++) {
        f->degree = bat_max_int(f->degree, batten_curve_degree(sections[k]));
        f->rational = f->rational || batten_curve_is_rational(sections[k]);
    }
    f->dimension = batten_curve_dimension(sections[0]);
    f->width = (size_t)f->dimension + f->rational;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        batten_curve *curve = NULL;
        status = normalise(sections[k], f->degree, &curve);
        if (status == BATTEN_OK)
            status = take_rows(f, curve, &f->given[k]);
        batten_curve_unref(curve);
    }
    return status;
}

static batten_status check_tolerance(const fitting *f)
{
    double size = 0;
    for (int k = 0; k < f->count; k++)
        for (size_t i = 0; i < (size_t)f->given[k].count * f->width; i++)
            size = bat_max(size, fabs(f->given[k].values[i]));
    if (f->tolerance < 64 * DBL_EPSILON * size)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the tolerance %g is lost in the rounding of coordinates of %g; 0 asks "
                        "for the exact skin",
                        f->tolerance, size);
    return BATTEN_OK;
}

/* ---- combs ---- */

static void comb_insert(comb *c, double u, bool held)
{
    int i = c->inner++;
    for (; i > 0 && c->knots[i - 1] > u; i--) {
        c->knots[i] = c->knots[i - 1];
        c->held[i] = c->held[i - 1];
    }
    c->knots[i] = u;
    c->held[i] = held;
}

static void comb_remove(comb *c, int at)
{
    c->inner--;
    for (int i = at; i < c->inner; i++) {
        c->knots[i] = c->knots[i + 1];
        c->held[i] = c->held[i + 1];
    }
}

static void comb_copy(const comb *from, comb *to)
{
    to->inner = from->inner;
    memcpy(to->knots, from->knots, (size_t)from->inner * sizeof *to->knots);
    memcpy(to->held, from->held, (size_t)from->inner * sizeof *to->held);
}

static bool comb_has(const comb *c, double u)
{
    for (int i = 0; i < c->inner; i++)
        if (fabs(c->knots[i] - u) <= 16 * DBL_EPSILON)
            return true;
    return false;
}

/* The whole knot vector [inner + 2 p + 2]. */
static void comb_write(const comb *c, int p, double *U)
{
    for (int i = 0; i <= p; i++) {
        U[i] = 0;
        U[p + 1 + c->inner + i] = 1;
    }
    memcpy(U + p + 1, c->knots, (size_t)c->inner * sizeof *U);
}

/* Does a knot of full multiplicity bend the section visibly? A bend of the derivative by j,
 * rounded off over the spans beside it, h, moves the curve by at least j h / 32. */
static bool is_corner(const fitting *f, const bat_spline *s, int i)
{
    const int p = s->degree;
    const double *U = s->knots;
    const double before = U[i] - U[i - 1], after = U[i + p] - U[i + p - 1];
    const double *row = s->values + (size_t)(i - 1) * f->width; /* the point on the knot */
    double jump[4];
    for (size_t c = 0; c < f->width; c++)
        jump[c] = p * ((row[f->width + c] - row[c]) / after -
                       (row[c] - *(row - f->width + c)) / before);
    return bat_norm((int)f->width, jump) * bat_min(before, after) / 32 > f->tolerance / 4;
}

/* Knots i .. i + p - 1 of each section that are one corner; false when they are too many. */
static bool find_corners(const fitting *f, comb *c)
{
    const int p = f->degree;
    for (int k = 0; k < f->count; k++) {
        const bat_spline *s = &f->given[k];
        for (int i = p + 1; i + p <= s->count; i++) {
            if (s->knots[i] == s->knots[i - 1] || s->knots[i] != s->knots[i + p - 1] ||
                comb_has(c, s->knots[i]) || !is_corner(f, s, i))
                continue;
            if (c->inner + p > f->limit)
                return false;
            for (int times = 0; times < p; times++)
                comb_insert(c, s->knots[i], true);
        }
    }
    return true;
}

/* The x-quantile of a section's simple inner knots: a rising function of x in [0, 1] from 0
 * to 1. */
static double quantile(const bat_spline *s, double x)
{
    const int p = s->degree, spans = s->count - p;
    const double place = x * spans;
    const int i = bat_min_int((int)place, spans - 1);
    return s->knots[p + i] + (place - i) * (s->knots[p + i + 1] - s->knots[p + i]);
}

/* As many knots as the median section has, each the average of those at its place. */
static void average_knots(const fitting *f, int wanted, comb *c)
{
    for (int j = 1; j <= wanted && c->inner < f->limit; j++) {
        double sum = 0;
        for (int k = 0; k < f->count; k++)
            sum += quantile(&f->given[k], (double)j / (wanted + 1));
        const double u = sum / f->count;
        if (u > 0 && u < 1 && !comb_has(c, u))
            comb_insert(c, u, false);
    }
}

static int by_count(const void *a, const void *b)
{
    return *(const int *)a - *(const int *)b;
}

static batten_status median_knots(const fitting *f, int *median)
{
    int *counts = bat_array((size_t)f->count, sizeof *counts);
    if (!counts)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->count; k++)
        counts[k] = f->given[k].count - f->degree - 1;
    qsort(counts, (size_t)f->count, sizeof *counts, by_count);
    *median = counts[f->count / 2];
    bat_release(counts);
    return BATTEN_OK;
}

/* ---- one section upon a comb ---- */

/* The banded normal equations of the inner control points. */
typedef struct {
    const bat_spline *given;
    bat_spline *fit;
    double *gram; /* [count - 2][p + 1] */
    int span_given, span_fit;
} normal;

static void add_sample(normal *e, double u, double weight)
{
    const int p = e->fit->degree, n = e->fit->count;
    const size_t w = e->fit->width;
    double own[BATTEN_MAX_DEGREE + 1], basis[BATTEN_MAX_DEGREE + 1], value[4] = {0};
    bat_basis(p, e->given->knots, e->span_given, u, 0, own);
    bat_basis(p, e->fit->knots, e->span_fit, u, 0, basis);
    for (int j = 0; j <= p; j++)
        for (size_t c = 0; c < w; c++)
            value[c] += own[j] * e->given->values[(size_t)(e->span_given - p + j) * w + c];
    const int first = e->span_fit - p;
    for (int j = 0; j <= p; j++) /* what the held ends give */
        if (first + j == 0 || first + j == n - 1)
            for (size_t c = 0; c < w; c++)
                value[c] -=
                    basis[j] *
                    e->given
                        ->values[(first + j == 0 ? 0 : (size_t)e->given->count - 1) * w + c];
    for (int j = 0; j <= p; j++) {
        const int row = first + j - 1;
        if (row < 0 || row >= n - 2)
            continue;
        for (int k = 0; k <= j; k++)
            if (first + k - 1 >= 0)
                e->gram[(size_t)row * (size_t)(p + 1) + (size_t)(p - j + k)] +=
                    weight * basis[j] * basis[k];
        for (size_t c = 0; c < w; c++)
            e->fit->values[(size_t)(row + 1) * w + c] += weight * basis[j] * value[c];
    }
}

/* Between all neighbouring knots of both vectors, at as many Gauss-like places as the degree
 * needs. */
static void add_samples(normal *e)
{
    const int p = e->fit->degree, per_span = p + 1;
    const double *U = e->given->knots, *V = e->fit->knots;
    e->span_given = e->span_fit = p;
    for (double at = 0; at < 1;) {
        while (U[e->span_given + 1] <= at)
            e->span_given++;
        while (V[e->span_fit + 1] <= at)
            e->span_fit++;
        const double next = bat_min(U[e->span_given + 1], V[e->span_fit + 1]);
        for (int i = 0; i < per_span; i++)
            add_sample(e, at + (next - at) * ((i + 0.5) / per_span), (next - at) / per_span);
        at = next;
    }
}

static batten_status fit_section(const fitting *f, int k, const comb *c, bat_spline *out)
{
    const int p = f->degree, n = c->inner + p + 1;
    const bat_spline *given = &f->given[k];
    bat_spline fit;
    batten_status status = bat_spline_make(p, n, f->width, &fit);
    if (status != BATTEN_OK)
        return status;
    comb_write(c, p, fit.knots);
    double *gram = bat_array3((size_t)n, (size_t)(p + 1), sizeof *gram);
    normal e = {given, &fit, gram, 0, 0};
    if (gram)
        add_samples(&e);
    status = gram ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && n > 2) {
        status = bat_symmetric_factor(n - 2, p, gram);
        if (status == BATTEN_OK)
            bat_symmetric_solve(n - 2, p, gram, f->width, fit.values + f->width);
    }
    bat_release(gram);
    if (status != BATTEN_OK) {
        bat_spline_free(&fit);
        return status;
    }
    const size_t row = f->width * sizeof *fit.values;
    memcpy(fit.values, given->values, row);
    memcpy(fit.values + (size_t)(n - 1) * f->width,
           given->values + (size_t)(given->count - 1) * f->width, row);
    *out = fit;
    return BATTEN_OK;
}

/* ---- how far it moved ---- */

/* What `s` lacks of the knots of `other`, both over [0, 1], and with `halve` the middles of all
 * spans. */
static int missing_knots(const bat_spline *s, const bat_spline *other, bool halve,
                         double *missing)
{
    const int p = s->degree, end = s->count, other_end = other->count;
    int count = 0;
    double last = 0;
    for (int i = p + 1, j = p + 1; i < end || j < other_end || last < 1;) {
        const double a = i < end ? s->knots[i] : 1, b = j < other_end ? other->knots[j] : 1;
        const double next = bat_min(a, b);
        const double middle = last + (next - last) / 2;
        if (halve && middle > last && middle < next)
            missing[count++] = middle;
        last = next;
        if (next >= 1)
            break;
        int own = 0, wanted = 0;
        for (; i < end && s->knots[i] == next; i++)
            own++;
        for (; j < other_end && other->knots[j] == next; j++)
            wanted++;
        for (; own < wanted; own++)
            missing[count++] = next;
    }
    return count;
}

static batten_status refine_both(const bat_spline *a, const bat_spline *b, bat_spline *fine_a,
                                 bat_spline *fine_b)
{
    double *missing = bat_array(2 * ((size_t)a->count + (size_t)b->count), sizeof *missing);
    if (!missing)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status =
        bat_spline_insert(a, missing_knots(a, b, true, missing), missing, fine_a);
    if (status == BATTEN_OK)
        status = bat_spline_insert(b, missing_knots(b, a, true, missing), missing, fine_b);
    bat_release(missing);
    return status;
}

/* Rational curves A / a and B / b differ by |(A - B) - (B / b) (a - b)| / a; coordinates from a
 * point near by. */
static double point_difference(const fitting *f, const double *A, const double *B,
                               const double *origin, double radius, double least_weight)
{
    const int d = f->dimension;
    double difference[3];
    if (!f->rational)
        return bat_distance(d, A, B);
    const double dw = A[d] - B[d];
    for (int c = 0; c < d; c++)
        difference[c] = A[c] - B[c] - origin[c] * dw;
    return (bat_norm(d, difference) + radius * fabs(dw)) / least_weight;
}

static void find_extent(const fitting *f, const bat_spline *s, const double *origin,
                        double *radius, double *least_weight)
{
    const int d = f->dimension;
    *radius = 0;
    *least_weight = INFINITY;
    for (int i = 0; f->rational && i < s->count; i++) {
        const double *row = s->values + (size_t)i * f->width;
        double off[3];
        for (int c = 0; c < d; c++)
            off[c] = row[c] / row[d] - origin[c];
        *radius = bat_max(*radius, bat_norm(d, off));
        *least_weight = bat_min(*least_weight, row[d]);
    }
}

/* Bounds in each span of the comb (`error` grows, may be NULL), and of the whole. */
static double compare(const fitting *f, const bat_spline *given, const bat_spline *fit,
                      const bat_spline *fine_a, const bat_spline *fine_b, double *error)
{
    const int p = f->degree;
    double origin[3] = {0, 0, 0}, radius, weight, other_radius, other_weight, worst = 0;
    for (int c = 0; c < f->dimension && f->rational; c++)
        origin[c] = given->values[c] / given->values[f->dimension];
    find_extent(f, given, origin, &other_radius, &weight);
    find_extent(f, fit, origin, &radius, &other_weight);
    if (f->rational && !(other_weight > 0))
        return INFINITY;
    for (int i = 0, span = p; i < fine_a->count; i++) {
        double greville = 0;
        for (int j = 1; j <= p; j++)
            greville += fine_a->knots[i + j] / p;
        while (span < fit->count - 1 && fit->knots[span + 1] <= greville)
            span++;
        const double off =
            point_difference(f, fine_a->values + (size_t)i * f->width,
                             fine_b->values + (size_t)i * f->width, origin, radius, weight);
        worst = bat_max(worst, off);
        if (error)
            error[span - p] = bat_max(error[span - p], off);
    }
    return worst;
}

static batten_status deviate(const fitting *f, const bat_spline *given, const bat_spline *fit,
                             double *error, double *deviation)
{
    bat_spline fine_a = {0}, fine_b = {0};
    const batten_status status = refine_both(given, fit, &fine_a, &fine_b);
    if (status == BATTEN_OK)
        *deviation = compare(f, given, fit, &fine_a, &fine_b, error);
    bat_spline_free(&fine_b);
    bat_spline_free(&fine_a);
    return status;
}

/* ---- all sections upon a comb ---- */

static void forget_fits(fitting *f)
{
    for (int k = 0; k < f->count; k++)
        bat_spline_free(&f->fitted[k]);
}

/* One step for each control point of each section. */
static uint64_t fit_steps(const fitting *f, const comb *c)
{
    return (uint64_t)f->count * (uint64_t)(c->inner + f->degree + 1);
}

static batten_status fit_all(fitting *f, const comb *c, double *worst)
{
    batten_status status = bat_work_step(f->work, fit_steps(f, c), 0.1, "common knots");
    *worst = 0;
    memset(f->error, 0, (size_t)(f->limit + 2) * sizeof *f->error);
    forget_fits(f);
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        status = fit_section(f, k, c, &f->fitted[k]);
        if (status == BATTEN_OK)
            status = deviate(f, &f->given[k], &f->fitted[k], f->error, &f->deviation[k]);
        *worst = bat_max(*worst, f->deviation[k]);
    }
    return status;
}

/* Do all sections keep the tolerance? The one that failed last is asked first. */
static batten_status all_keep(const fitting *f, const comb *c, int *suspect, bool *keep)
{
    batten_status status = BATTEN_OK;
    *keep = true;
    for (int i = 0; status == BATTEN_OK && *keep && i < f->count; i++) {
        const int k = (i + *suspect) % f->count;
        bat_spline fit = {0};
        double deviation = 0;
        status = fit_section(f, k, c, &fit);
        if (status == BATTEN_OK)
            status = deviate(f, &f->given[k], &fit, NULL, &deviation);
        bat_spline_free(&fit);
        if (!(deviation <= f->tolerance)) {
            *keep = false;
            *suspect = k;
        }
    }
    return status;
}

/* Halve the spans that are too far off, but for those that are sixteen times better than the
 * worst: a cubic gains that much by one halving. False when the comb is full. */
static bool add_knots(const fitting *f, double worst, comb *c)
{
    const double enough = bat_max(f->tolerance, worst / 16);
    const int inner = c->inner;
    double *added = c->knots + c->capacity; /* scratch behind the knots */
    int count = 0;
    for (int s = 0; s <= inner; s++) {
        const double a = s > 0 ? c->knots[s - 1] : 0, b = s < inner ? c->knots[s] : 1;
        const double middle = a + (b - a) / 2;
        if (f->error[s] > enough && middle > a && middle < b)
            added[count++] = middle;
    }
    if (count == 0 || inner + count > f->limit)
        return false;
    for (int i = 0; i < count; i++)
        comb_insert(c, added[i], false);
    return true;
}

/* *met: the tolerance is kept with fewer knots than the exact union has. */
static batten_status grow(fitting *f, comb *c, bool *met)
{
    for (;;) {
        double worst;
        const batten_status status = fit_all(f, c, &worst);
        *met = worst <= f->tolerance;
        if (status != BATTEN_OK || *met || !isfinite(worst) || !add_knots(f, worst, c))
            return status;
    }
}

/* Take out each knot that is not needed, twice over: what one leaves may free another. */
static batten_status shrink(const fitting *f, comb *c, comb *scratch)
{
    int suspect = 0;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < c->inner;) {
            bool keep = false;
            if (!c->held[i]) {
                comb_copy(c, scratch);
                comb_remove(scratch, i);
                batten_status status =
                    bat_work_step(f->work, fit_steps(f, c),
                                  0.1 + 0.2 * (pass + (double)i / c->inner), "common knots");
                if (status == BATTEN_OK)
                    status = all_keep(f, scratch, &suspect, &keep);
                if (status != BATTEN_OK)
                    return status;
            }
            if (keep)
                comb_copy(scratch, c);
            else
                i++;
        }
    return BATTEN_OK;
}

/* ---- the search ---- */

static batten_status comb_make(int capacity, comb *c)
{
    c->capacity = capacity;
    c->knots = bat_array(2 * (size_t)capacity + 2, sizeof *c->knots);
    c->held = bat_array((size_t)capacity + 1, sizeof *c->held);
    return c->knots && c->held ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void comb_free(comb *c)
{
    bat_release(c->knots);
    bat_release(c->held);
}

/* Try one beginning; *best is replaced when it needs fewer knots. */
static batten_status attempt(fitting *f, int averaged, comb *c, comb *scratch, comb *best,
                             bool *met)
{
    bool reached = false;
    c->inner = 0;
    if (!find_corners(f, c))
        return BATTEN_OK;
    average_knots(f, averaged, c);
    batten_status status = grow(f, c, &reached);
    if (status == BATTEN_OK && reached)
        status = shrink(f, c, scratch);
    if (status == BATTEN_OK && reached && (!*met || c->inner < best->inner)) {
        comb_copy(c, best);
        *met = true;
    }
    return status;
}

static batten_status search(fitting *f, comb *best, bool *met)
{
    comb c = {0}, scratch = {0};
    int median = 0;
    batten_status status = comb_make(f->limit, &c);
    if (status == BATTEN_OK)
        status = comb_make(f->limit, &scratch);
    if (status == BATTEN_OK)
        status = median_knots(f, &median);
    if (status == BATTEN_OK)
        status = attempt(f, 0, &c, &scratch, best, met);
    if (status == BATTEN_OK)
        status = attempt(f, median, &c, &scratch, best, met);
    comb_free(&scratch);
    comb_free(&c);
    return status;
}

/* ---- handing over ---- */

static batten_status to_curve(const fitting *f, const bat_spline *s, batten_curve **out)
{
    const size_t n = (size_t)s->count, d = (size_t)f->dimension;
    double *points = bat_array3(n, d, sizeof *points);
    double *weights = bat_array(n, sizeof *weights);
    batten_status status = points && weights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (size_t i = 0; i < n; i++) {
            const double *row = s->values + i * f->width;
            weights[i] = f->rational ? row[d] : 1;
            for (size_t c = 0; c < d; c++)
                points[i * d + c] = row[c] / weights[i];
        }
        status = batten_curve_create(f->dimension, s->degree, s->count, points,
                                     f->rational ? weights : NULL, s->knots, out);
    }
    bat_release(weights);
    bat_release(points);
    return status;
}

static batten_status hand_over(fitting *f, const comb *best, batten_curve **out)
{
    double worst;
    batten_status status = fit_all(f, best, &worst);
    int made = 0;
    for (; status == BATTEN_OK && made < f->count; made++)
        status = to_curve(f, &f->fitted[made], &out[made]);
    for (int k = 0; status != BATTEN_OK && k < made; k++) {
        batten_curve_unref(out[k]);
        out[k] = NULL;
    }
    return status;
}

/* The inner knots that the exact union can have at most. */
static int union_limit(const fitting *f)
{
    double total = 0;
    for (int k = 0; k < f->count; k++)
        total += f->given[k].count - f->degree - 1;
    return (int)bat_min(total, 20000);
}

/* Has the exact union no more knots than these? Only asked when one section alone has as many.
 */
static batten_status prefer_exact(const fitting *f, const batten_curve *const *sections,
                                  const comb *best, bool *prefer)
{
    int most = 0;
    for (int k = 0; k < f->count; k++)
        most = bat_max_int(most, f->given[k].count - f->degree - 1);
    *prefer = false;
    if (best->inner < most)
        return BATTEN_OK;
    batten_curve **unified = bat_array((size_t)f->count, sizeof *unified);
    if (!unified)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_curves_unify(f->count, sections, unified);
    if (status == BATTEN_OK)
        *prefer = batten_curve_point_count(unified[0]) - f->degree - 1 <= best->inner;
    for (int k = 0; k < f->count; k++)
        batten_curve_unref(unified[k]);
    bat_release(unified);
    return status == BATTEN_TOO_LARGE ? BATTEN_OK : status;
}

static batten_status find(fitting *f, const batten_curve *const *sections, bool *met,
                          batten_curve **out)
{
    batten_status status = take_sections(f, sections);
    if (status == BATTEN_OK)
        status = check_tolerance(f);
    if (status != BATTEN_OK)
        return status;
    comb best = {0};
    f->limit = union_limit(f);
    f->error = bat_array((size_t)f->limit + 2, sizeof *f->error);
    status = f->error ? comb_make(f->limit, &best) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = search(f, &best, met);
    bool exact = false;
    if (status == BATTEN_OK && *met)
        status = prefer_exact(f, sections, &best, &exact);
    *met = *met && !exact;
    if (status == BATTEN_OK && *met)
        status = hand_over(f, &best, out);
    comb_free(&best);
    return status;
}

batten_status bat_skin_common_knots(int count, const batten_curve *const *sections,
                                    double tolerance, bat_work *work, batten_curve **out,
                                    double *deviation)
{
    fitting f = {.count = count, .tolerance = tolerance, .deviation = deviation, .work = work};
    f.given = bat_array((size_t)count, sizeof *f.given);
    f.fitted = bat_array((size_t)count, sizeof *f.fitted);
    bool met = false;
    batten_status status =
        f.given && f.fitted ? find(&f, sections, &met, out) : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < count; k++) {
        if (f.given)
            bat_spline_free(&f.given[k]);
        if (f.fitted)
            bat_spline_free(&f.fitted[k]);
    }
    bat_release(f.error);
    bat_release(f.fitted);
    bat_release(f.given);
    if (status != BATTEN_OK || met)
        return status;
    memset(deviation, 0, (size_t)count * sizeof *deviation);
    return batten_curves_unify(count, sections, out);
}
