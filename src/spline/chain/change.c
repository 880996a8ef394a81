/* Parts of chains, chains run backwards and end to end: every span stays of its kind. */
#include "numeric/vector.h"
#include "spline/chain/chain.h"
#include "spline/curve/curve.h"

#include <string.h>

/* ---- one span ---- */

/* Point and derivatives at t; out [4][3] whatever the dimension. */
static void span_derivatives(int d, const batten_span *span, double t, double out[4][3])
{
    double values[4 * 3];
    bat_span_type_of(span->kind)->evaluate(d, span, t, BAT_CHAIN_ORDER, values);
    memset(out, 0, 4 * sizeof *out);
    for (int m = 0; m <= BAT_CHAIN_ORDER; m++)
        memcpy(out[m], values + m * d, (size_t)d * sizeof *values);
}

/* A cubic's value and derivatives at t, from those at 0. */
static void shift_curvature(const double k[4], double t, double out[4])
{
    out[0] = k[0] + t * (k[1] + t * (k[2] / 2 + t * (k[3] / 6)));
    out[1] = k[1] + t * (k[2] + t * (k[3] / 2));
    out[2] = k[2] + t * k[3];
    out[3] = k[3];
}

/* Curvature fields of a plane span begun at t, where its derivatives are v. */
static void shift(batten_span *span, const batten_span *from, double t, double v[4][3])
{
    double k[4];
    switch (from->kind) {
    case BATTEN_SPAN_ARC:
        return;
    case BATTEN_SPAN_SPIRAL:
        shift_curvature(from->curvature, t, k);
        memcpy(span->curvature, k, sizeof k);
        return;
    case BATTEN_SPAN_GEOMETRIC:
        span->curvature[0] = from->curvature[0] + t * from->curvature[1];
        return;
    case BATTEN_SPAN_ELASTICA:
        /* By arc length P' = T, P'' = k N, P''' = k' N - k^2 T. */
        span->curvature[0] = v[1][0] * v[2][1] - v[1][1] * v[2][0];
        span->curvature[1] = v[1][0] * v[3][1] - v[1][1] * v[3][0];
        return;
    case BATTEN_SPAN_TENSION:
        return;
    }
}

/* The part from a to b of its own parameter. */
static batten_span part_of(int d, const batten_span *from, double a, double b)
{
    batten_span span = *from;
    double v[4][3], w[4][3];
    span_derivatives(d, from, a, v);
    span_derivatives(d, from, b, w);
    span.length = b - a;
    if (a > 0) {
        memcpy(span.start, v[0], sizeof span.start);
        memcpy(span.bend[0], v[2], sizeof span.bend[0]);
        span.angle = bat_atan2(v[1][1], v[1][0]);
        shift(&span, from, a, v);
    }
    memcpy(span.end, w[0], sizeof span.end);
    memcpy(span.bend[1], w[2], sizeof span.bend[1]);
    if (a > 0 && b == from->length) {
        memcpy(span.end, from->end, sizeof span.end);
        memcpy(span.bend[1], from->bend[1], sizeof span.bend[1]);
    }
    return span;
}

/* What the kind does not use is 0, as in the span it comes from. */
static batten_span tidy(const batten_span *from, batten_span span)
{
    if (from->kind == BATTEN_SPAN_TENSION) {
        span.angle = 0;
        return span;
    }
    memset(span.end, 0, sizeof span.end);
    memset(span.bend, 0, sizeof span.bend);
    return span;
}

static batten_span reversed(int d, const batten_span *from)
{
    batten_span span = part_of(d, from, 0, from->length);
    double v[4][3];
    span_derivatives(d, from, from->length, v);
    shift(&span, from, from->length, v);
    /* Backwards curvature changes its sign, and so does every second of its derivatives. */
    span.curvature[0] = -span.curvature[0];
    span.curvature[2] = -span.curvature[2];
    span.angle = bat_atan2(-v[1][1], -v[1][0]);
    if (from->kind == BATTEN_SPAN_GEOMETRIC)
        span.chord = from->chord > 0 ? from->chord - BAT_PI : from->chord + BAT_PI;
    memcpy(span.start, v[0], sizeof span.start);
    memcpy(span.end, from->start, sizeof span.end);
    memcpy(span.bend[0], from->bend[1], sizeof span.bend[0]);
    memcpy(span.bend[1], from->bend[0], sizeof span.bend[1]);
    if (from->kind == BATTEN_SPAN_TENSION)
        memcpy(span.start, from->end, sizeof span.start);
    return tidy(from, span);
}

/* ---- chains ---- */

/* A chain of these spans, where the given one stands; gaps were let pass before. */
static batten_status make_like(const batten_chain *like, int count, const batten_span *spans,
                               const double *breaks, bool closed, batten_chain **out)
{
    batten_chain *made = NULL;
    const batten_status status = batten_chain_create(
        &(batten_chain_parts){like->dimension, count, spans, breaks, closed}, HUGE_VAL, &made);
    if (status != BATTEN_OK)
        return status;
    made->placed = like->placed;
    made->frame = like->frame;
    made->y = like->y;
    *out = made;
    return BATTEN_OK;
}

batten_status batten_chain_subrange(const batten_chain *chain, double a, double b,
                                    batten_chain **out)
{
    assert(chain && out);
    const batten_interval domain = batten_chain_domain(chain);
    int first = 0, last = 0;
    double from = 0, to = 0;
    batten_status status = bat_knots_clip(domain.a, domain.b, &a);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &b);
    if (status == BATTEN_OK && a >= b)
        status = bat_fail(BATTEN_OUT_OF_DOMAIN, "the part from %.17g to %.17g is empty", a, b);
    if (status == BATTEN_OK && a == domain.a && b == domain.b) {
        *out = batten_chain_ref(chain);
        return BATTEN_OK;
    }
    if (status == BATTEN_OK)
        status = bat_chain_locate(chain, a, BATTEN_FROM_RIGHT, &first, &from);
    if (status == BATTEN_OK)
        status = bat_chain_locate(chain, b, BATTEN_FROM_LEFT, &last, &to);
    if (status != BATTEN_OK)
        return status;
    if (b == domain.b) { /* of a closed chain that is its start as well */
        last = chain->count - 1;
        to = chain->spans[last].length;
    }
    const int n = last - first + 1;
    batten_span *spans = bat_array((size_t)n, sizeof *spans);
    double *breaks = bat_array((size_t)n + 1, sizeof *breaks);
    status = spans && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const batten_span *span = &chain->spans[first + i];
        const double begin = i ? 0 : from, end = i < n - 1 ? span->length : to;
        breaks[i] = i ? chain->breaks[first + i] : a;
        spans[i] = begin > 0 || end < span->length
                       ? tidy(span, part_of(chain->dimension, span, begin, end))
                       : *span;
    }
    if (status == BATTEN_OK) {
        breaks[n] = b;
        status = make_like(chain, n, spans, breaks, false, out);
    }
    bat_release(breaks);
    bat_release(spans);
    return status;
}

batten_status batten_chain_reverse(const batten_chain *chain, batten_chain **out)
{
    assert(chain && out);
    const int n = chain->count;
    batten_span *spans = bat_array((size_t)n, sizeof *spans);
    double *breaks = bat_array((size_t)n + 1, sizeof *breaks);
    batten_status status = spans && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        spans[i] = reversed(chain->dimension, &chain->spans[n - 1 - i]);
    for (int i = 0; status == BATTEN_OK && i <= n; i++)
        breaks[i] = -chain->breaks[n - i];
    if (status == BATTEN_OK)
        status = make_like(chain, n, spans, breaks, chain->closed, out);
    bat_release(breaks);
    bat_release(spans);
    return status;
}

static bool same_frame(const batten_chain *a, const batten_chain *b)
{
    return a->placed == b->placed &&
           (!a->placed || memcmp(&a->frame, &b->frame, sizeof a->frame) == 0);
}

static batten_status check_join(const batten_chain *first, const batten_chain *second,
                                double tolerance)
{
    double end[3], start[3];
    if (!(tolerance >= 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g", tolerance);
    if (first->dimension != second->dimension || !same_frame(first, second))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the chains do not lie in one plane");
    if (first->closed || second->closed)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a closed chain has no end to join");
    batten_status status = batten_chain_evaluate(first, batten_chain_domain(first).b, 0, end);
    if (status == BATTEN_OK)
        status = batten_chain_evaluate(second, batten_chain_domain(second).a, 0, start);
    if (status != BATTEN_OK)
        return status;
    const double gap = bat_distance(batten_chain_dimension(first), end, start);
    if (gap > tolerance)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the end of the first chain and the start of the second are %g apart, "
                        "more than %g",
                        gap, tolerance);
    return BATTEN_OK;
}

batten_status batten_chain_join(const batten_chain *first, const batten_chain *second,
                                double tolerance, batten_chain **out)
{
    assert(first && second && out);
    const int n = first->count, m = second->count;
    batten_status status = check_join(first, second, tolerance);
    if (status != BATTEN_OK)
        return status;
    batten_span *spans = bat_array((size_t)n + (size_t)m, sizeof *spans);
    double *breaks = bat_array((size_t)n + (size_t)m + 1, sizeof *breaks);
    status = spans && breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        memcpy(spans, first->spans, (size_t)n * sizeof *spans);
        memcpy(spans + n, second->spans, (size_t)m * sizeof *spans);
        memcpy(breaks, first->breaks, ((size_t)n + 1) * sizeof *breaks);
        for (int i = 1; i <= m; i++)
            breaks[n + i] = first->breaks[n] == second->breaks[0]
                                ? second->breaks[i]
                                : first->breaks[n] + (second->breaks[i] - second->breaks[0]);
        status = make_like(first, n + m, spans, breaks, false, out);
    }
    bat_release(breaks);
    bat_release(spans);
    return status;
}
