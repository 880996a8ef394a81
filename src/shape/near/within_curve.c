/*
 * Curves near other curves, at equal parameters. The spline is fitted to samples that are taken
 * anew for each choice of knots, and its distance is proved: on each span that the two have in
 * common both are Bezier curves, P with weights w of degree a and S of degree b, and
 *
 *     w (P - S) has the points  sum over i of C(a, i) C(b, k - i) w_i (P_i - S_(k-i)) / C(a +
 * b, k),
 *
 * in whose hull it lies; halved until the bound is close to a value that is taken.
 */
#include "numeric/vector.h"
#include "shape/near/within.h"
#include "shape/near/within_proof.h"
#include "spline/curve/curve.h"

#include <float.h>

static void release_samples(bat_within_source *s)
{
    bat_release(s->common);
    bat_release(s->bounds);
    bat_release(s->span_of);
    bat_release(s->points);
    bat_release(s->weights);
    bat_release(s->parameters);
    s->common = s->bounds = s->points = s->weights = s->parameters = NULL;
    s->span_of = NULL;
}

/* ---- samples ---- */

/* Two rising rows as one without doubles; out [a_count + b_count]. */
static int merge(int a_count, const double *a, int b_count, const double *b, double *out)
{
    int count = 0;
    for (int i = 0, j = 0; i < a_count || j < b_count;) {
        const double next = j == b_count || (i < a_count && a[i] <= b[j]) ? a[i++] : b[j++];
        if (count == 0 || next > out[count - 1])
            out[count++] = next;
    }
    return count;
}

static batten_status make_room(bat_within_source *s, int inner_count, const double *inner,
                               int each, int d, int *count)
{
    release_samples(s);
    s->common = bat_array((size_t)(s->break_count + inner_count), sizeof *s->common);
    if (!s->common)
        return BATTEN_OUT_OF_MEMORY;
    s->span_count = merge(s->break_count, s->breaks, inner_count, inner, s->common) - 1;
    *count = s->span_count * each + 2;
    const size_t n = (size_t)*count;
    s->bounds = bat_array((size_t)s->span_count, sizeof *s->bounds);
    s->span_of = bat_array(n, sizeof *s->span_of);
    s->points = bat_array3(n, (size_t)d, sizeof *s->points);
    s->weights = bat_array(n, sizeof *s->weights);
    s->parameters = bat_array(n + 1, sizeof *s->parameters);
    return s->bounds && s->span_of && s->points && s->weights && s->parameters
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* Evenly on each common span, each weighing as much as the length it stands for; and both ends.
 */
static batten_status sample(bat_within *w, int inner_count, const double *inner)
{
    bat_within_source *s = w->context;
    const int each = w->degree + 3;
    int count = 0;
    batten_status status = make_room(s, inner_count, inner, each, w->dimension, &count);
    if (status != BATTEN_OK)
        return status;
    const double whole = w->domain.b - w->domain.a;
    s->parameters[0] = w->domain.a;
    s->parameters[count - 1] = s->parameters[count] = w->domain.b;
    for (int j = 0, i = 1; j < s->span_count; j++)
        for (int k = 0; k < each; k++, i++) {
            const double a = s->common[j], h = s->common[j + 1] - a;
            s->parameters[i] = a + (k + 0.5) / each * h;
            s->weights[i] = h / (each * whole);
            s->span_of[i] = j;
        }
    s->weights[0] = s->weights[1];
    s->weights[count - 1] = s->weights[count - 2];
    s->span_of[count - 1] = s->span_count - 1;
    /* The end of a ring is its begin, which is there. */
    w->count = w->periodic ? count - 1 : count;
    w->points = s->points;
    w->weights = s->weights;
    w->start = w->parameters = s->parameters;
    return batten_curve_evaluate_many(s->curve, (size_t)count, s->parameters, 0, NULL,
                                      s->points);
}

/* ---- one part ---- */

static batten_status approximate_part(batten_curve *part, bool ring, int degree,
                                      double tolerance, double *error, batten_curve **out)
{
    const int d = batten_curve_dimension(part);
    bat_within_source s = {.curve = part, .break_count = batten_curve_spans(part, NULL)};
    bat_within w = {.dimension = d,
                    .degree = degree,
                    .periodic = ring,
                    .tolerance = tolerance,
                    .domain = batten_curve_domain(part),
                    .sample = sample,
                    .measure = bat_within_curve_error,
                    .context = &s,
                    .error = HUGE_VAL};
    s.breaks = bat_array((size_t)s.break_count, sizeof *s.breaks);
    batten_status status = s.breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(part, s.breaks);
        w.breaks = s.breaks;
        w.break_count = s.break_count;
        status = bat_within_insert(&w);
    }
    if (status == BATTEN_OK && !(w.error <= tolerance))
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the nearest curve of degree %d that was found is %g away; the "
                          "tolerance is %g",
                          degree, w.error, tolerance);
    if (status == BATTEN_OK) {
        *error = bat_max(*error, w.error);
        *out = batten_curve_ref(w.curve);
    }
    bat_within_end(&w);
    release_samples(&s);
    bat_release(s.breaks);
    return status;
}

/* ---- corners ---- */

/* So little may the derivative jump, against its size, where a curve counts as smooth. */
#define SMOOTH 1e-6

static batten_status is_smooth(const batten_curve *curve, double before, double after,
                               bool *smooth)
{
    const int d = batten_curve_dimension(curve);
    double left[6], right[6];
    batten_status status = batten_curve_evaluate_side(curve, before, BATTEN_FROM_LEFT, 1, left);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, after, BATTEN_FROM_RIGHT, 1, right);
    if (status == BATTEN_OK) {
        const double speed = bat_max(bat_norm(d, left + d), bat_norm(d, right + d));
        *smooth = bat_distance(d, left + d, right + d) <= SMOOTH * speed;
    }
    return status;
}

/* Where parts begin: the domain's ends and the breaks at which the derivative jumps. */
static batten_status find_parts(const batten_curve *curve, double *ends, int *part_count)
{
    const int count = batten_curve_spans(curve, NULL);
    double *breaks = bat_array((size_t)count, sizeof *breaks);
    batten_status status = breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int found = 0;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, breaks);
        ends[found++] = breaks[0];
    }
    for (int i = 1; status == BATTEN_OK && i < count; i++) {
        bool smooth = false;
        if (i < count - 1)
            status = is_smooth(curve, breaks[i], breaks[i], &smooth);
        if (!smooth)
            ends[found++] = breaks[i];
    }
    bat_release(breaks);
    *part_count = found - 1;
    return status;
}

static batten_status approximate_parts(const batten_curve *curve, int degree, double tolerance,
                                       double *error, int count, const double *ends,
                                       batten_curve **out)
{
    batten_curve **made = bat_array((size_t)count, sizeof(batten_curve *));
    batten_status status = made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int done = 0;
    for (; status == BATTEN_OK && done < count; done += status == BATTEN_OK) {
        batten_curve *part = NULL;
        status = batten_curve_subrange(curve, ends[done], ends[done + 1], &part);
        if (status == BATTEN_OK)
            status = approximate_part(part, false, degree, tolerance, error, &made[done]);
        batten_curve_unref(part);
    }
    if (status == BATTEN_OK)
        status = bat_curve_chained(count, made, out);
    for (int i = 0; i < done; i++)
        batten_curve_unref(made[i]);
    bat_release(made);
    return status;
}

/* ---- the whole ---- */

/* Polynomial curves of this degree and lower ones need no samples. */
static batten_status reduce(const batten_curve *curve, int degree, double tolerance,
                            double *error, batten_curve **out)
{
    batten_curve *raised = NULL;
    batten_status status =
        batten_curve_elevate(curve, degree - batten_curve_degree(curve), &raised);
    if (status == BATTEN_OK)
        status = batten_curve_remove_knots(raised, tolerance, NULL, error, out);
    batten_curve_unref(raised);
    return status;
}

static batten_status fit(const batten_curve *curve, int degree, double tolerance, double *error,
                         batten_curve **out)
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_curve *clamped = NULL;
    int part_count = 0;
    bool ring = false;
    double *ends = bat_array((size_t)batten_curve_spans(curve, NULL), sizeof *ends);
    batten_status status = ends ? batten_curve_clamp(curve, &clamped) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_parts(clamped, ends, &part_count);
    if (status == BATTEN_OK && part_count == 1 &&
        batten_curve_is_closed(clamped, tolerance / 64))
        status = is_smooth(clamped, domain.b, domain.a, &ring);
    if (status == BATTEN_OK)
        status =
            ring ? approximate_part(clamped, true, degree, tolerance, error, out)
                 : approximate_parts(clamped, degree, tolerance, error, part_count, ends, out);
    batten_curve_unref(clamped);
    bat_release(ends);
    return status;
}

batten_status batten_curve_approximate(const batten_curve *curve, int degree, double tolerance,
                                       double *error, batten_curve **out)
{
    assert(curve && out);
    const int d = batten_curve_dimension(curve);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(isnan(tolerance) ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT,
                        "the tolerance is %g; it must be above 0", tolerance);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    /* Points of both curves and their differences are rounded a few times. */
    const double rounding =
        64 * DBL_EPSILON * bat_largest(d * curve->count, batten_curve_points(curve));
    if (!(tolerance > 2 * rounding))
        return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                        "the tolerance is %g, below the rounding of the points, %g", tolerance,
                        2 * rounding);
    double found = 0;
    /* Removal would open a ring. */
    const bool plain = !batten_curve_is_rational(curve) && !batten_curve_is_periodic(curve) &&
                       batten_curve_degree(curve) <= degree;
    const batten_status status =
        (plain ? reduce : fit)(curve, degree, tolerance - rounding, &found, out);
    if (status == BATTEN_OK && error)
        *error = found + rounding;
    return status;
}

/* The same chain with arcs as clothoids of constant curvature: as a curve these run by arc
 * length, so that joints without a corner are smooth, as those of rational arcs are not. */
static batten_status evenly_paced(const batten_chain *chain, batten_chain **out)
{
    const int n = batten_chain_span_count(chain);
    batten_span *spans = bat_array((size_t)n, sizeof *spans);
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++) {
        spans[i] = *batten_chain_span(chain, i);
        if (spans[i].kind == BATTEN_SPAN_ARC)
            spans[i].kind = BATTEN_SPAN_SPIRAL;
    }
    batten_frame frame;
    batten_chain *flat = NULL;
    const bool placed = batten_chain_frame(chain, &frame);
    const int dimension = placed ? 2 : batten_chain_dimension(chain);
    batten_status status = batten_chain_create(
        &(batten_chain_parts){dimension, n, spans, batten_chain_breaks(chain),
                              batten_chain_is_closed(chain)},
        HUGE_VAL, &flat);
    if (status == BATTEN_OK && placed)
        status = batten_chain_place(flat, &frame, out);
    else if (status == BATTEN_OK)
        *out = batten_chain_ref(flat);
    batten_chain_unref(flat);
    bat_release(spans);
    return status;
}

batten_status batten_chain_approximate(const batten_chain *chain, int degree, double tolerance,
                                       double *error, batten_curve **out)
{
    assert(chain && out);
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g; it must be above 0",
                        tolerance);
    batten_chain *paced = NULL;
    batten_curve *curve = NULL;
    double first = 0, second = 0;
    batten_status status = evenly_paced(chain, &paced);
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(paced, tolerance / 16, &first, &curve);
    if (status == BATTEN_OK)
        status = batten_curve_approximate(curve, degree, tolerance - first, &second, out);
    batten_curve_unref(curve);
    batten_chain_unref(paced);
    if (status == BATTEN_OK && error)
        *error = first + second;
    return status;
}
