/* Making, keeping, evaluating and moving chains. */
#include "spline/chain/chain.h"
#include "numeric/vector.h"
#include "spline/chain/transform.h"
#include "spline/curve/curve.h"
#include "spline/spline.h"

#include <string.h>

/* ---- making ---- */

batten_status bat_chain_check_span(int dimension, const batten_span *span, int index)
{
    const bat_span_type *type = bat_span_type_of(span->kind);
    if (!type)
        return bat_fail(BATTEN_BAD_ARGUMENT, "span %d has no kind that is known", index + 1);
    if (type->plane && dimension != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "span %d is of kind %s, which is plane, not of %d "
                        "dimensions",
                        index + 1, type->name, dimension);
    const double *const fields[] = {&span->length,   span->start,   &span->angle,
                                    span->curvature, &span->chord,  span->end,
                                    span->bend[0],   span->bend[1], &span->tension};
    static const size_t sizes[] = {1, 3, 1, 4, 1, 3, 3, 3, 1};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++)
        if (bat_first_not_finite(fields[i], sizes[i]) < sizes[i])
            return bat_fail(BATTEN_NOT_FINITE, "span %d has a number that is not finite",
                            index + 1);
    if (!(span->length > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "span %d is %g long; it must be above 0",
                        index + 1, span->length);
    if (span->tension < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "span %d has the tension %g, below 0", index + 1,
                        span->tension);
    return type->check ? type->check(span, index) : BATTEN_OK;
}

static batten_status check_breaks(int count, const double *breaks)
{
    for (int i = 0; i <= count; i++) {
        if (!isfinite(breaks[i]))
            return bat_fail(BATTEN_NOT_FINITE, "break %d is %g", i + 1, breaks[i]);
        if (i > 0 && !(breaks[i] > breaks[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING, "break %d is %g, not above %g before it",
                            i + 1, breaks[i], breaks[i - 1]);
    }
    if (!isfinite(breaks[count] - breaks[0]))
        return bat_fail(BATTEN_OVERFLOW, "the breaks, from %g to %g, are too far apart",
                        breaks[0], breaks[count]);
    return BATTEN_OK;
}

static batten_status check_gaps(const batten_chain *chain, double tolerance)
{
    const int d = chain->dimension, n = chain->count;
    for (int i = 0; i < n; i++) {
        const batten_span *span = &chain->spans[i];
        double end[(BAT_CHAIN_ORDER + 1) * 3];
        bat_span_type_of(span->kind)->evaluate(d, span, span->length, 0, end);
        if (bat_first_not_finite(end, (size_t)d) < (size_t)d)
            return bat_fail(BATTEN_OVERFLOW, "span %d ends beyond the numbers", i + 1);
        if (i == n - 1 && !chain->closed)
            break;
        const double gap = bat_distance(d, end, chain->spans[(i + 1) % n].start);
        if (!(gap <= tolerance))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "span %d ends %g from where span %d begins; the tolerance is %g",
                            i + 1, gap, (i + 1) % n + 1, tolerance);
    }
    return BATTEN_OK;
}

/* A chain with room for its spans, by nobody else seen yet. */
static batten_chain *allocate_chain(int count)
{
    batten_chain *chain = bat_array(1, sizeof *chain);
    if (!chain)
        return NULL;
    bat_references_begin(&chain->references);
    chain->count = count;
    chain->spans = bat_array((size_t)count, sizeof *chain->spans);
    chain->breaks = bat_array((size_t)count + 1, sizeof *chain->breaks);
    if (chain->spans && chain->breaks)
        return chain;
    batten_chain_unref(chain);
    return NULL;
}

static batten_status check_spans(int dimension, int count, const batten_span *spans)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = bat_chain_check_span(dimension, &spans[i], i);
    return status;
}

/* As given, or by the lengths of the spans. */
static void set_breaks(batten_chain *chain, const double *breaks)
{
    const int n = chain->count;
    for (int i = 0; i < n && !breaks; i++)
        chain->breaks[i + 1] = chain->breaks[i] + chain->spans[i].length;
    if (breaks)
        memcpy(chain->breaks, breaks, ((size_t)n + 1) * sizeof *breaks);
}

static batten_status fill(batten_chain *chain, const batten_span *spans, const double *breaks,
                          double tolerance)
{
    batten_status status = check_spans(chain->dimension, chain->count, spans);
    if (status != BATTEN_OK)
        return status;
    memcpy(chain->spans, spans, (size_t)chain->count * sizeof *spans);
    set_breaks(chain, breaks);
    status = check_breaks(chain->count, chain->breaks);
    if (status == BATTEN_OK)
        status = check_gaps(chain, tolerance);
    return status;
}

batten_status batten_chain_create(const batten_chain_parts *parts, double tolerance,
                                  batten_chain **out)
{
    assert(parts->spans && out);
    if (parts->dimension < 1 || parts->dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        parts->dimension);
    if (parts->count < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a chain of %d spans", parts->count);
    if (parts->count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d spans; the limit is %d", parts->count,
                        BAT_MAX_POINTS);
    if (!(tolerance >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not 0 or more", tolerance);
    batten_chain *chain = allocate_chain(parts->count);
    if (!chain)
        return BATTEN_OUT_OF_MEMORY;
    chain->dimension = parts->dimension;
    chain->closed = parts->closed;
    const batten_status status = fill(chain, parts->spans, parts->breaks, tolerance);
    if (status == BATTEN_OK)
        *out = chain;
    else
        batten_chain_unref(chain);
    return status;
}

batten_status bat_chain_copy(const batten_chain *chain, batten_chain **out)
{
    batten_chain *copied = allocate_chain(chain->count);
    if (!copied)
        return BATTEN_OUT_OF_MEMORY;
    copied->dimension = chain->dimension;
    copied->closed = chain->closed;
    copied->placed = chain->placed;
    copied->frame = chain->frame;
    copied->y = chain->y;
    memcpy(copied->spans, chain->spans, (size_t)chain->count * sizeof *chain->spans);
    memcpy(copied->breaks, chain->breaks, ((size_t)chain->count + 1) * sizeof *chain->breaks);
    *out = copied;
    return BATTEN_OK;
}

batten_status batten_chain_place(const batten_chain *chain, const batten_frame *frame,
                                 batten_chain **out)
{
    assert(chain && frame && out);
    batten_frame square;
    batten_vec3 y;
    batten_chain *placed = NULL;
    if (chain->dimension != 2 || chain->placed)
        return bat_fail(BATTEN_BAD_ARGUMENT, "only a chain in the plane can be placed");
    batten_status status = bat_frame_square(frame, &square, &y);
    if (status == BATTEN_OK)
        status = bat_chain_copy(chain, &placed);
    if (status != BATTEN_OK)
        return status;
    placed->placed = true;
    placed->frame = square;
    placed->y = y;
    *out = placed;
    return BATTEN_OK;
}

batten_chain *batten_chain_ref(const batten_chain *chain)
{
    batten_chain *counted = (batten_chain *)(uintptr_t)chain;
    bat_references_add(&counted->references);
    return counted;
}

void batten_chain_unref(batten_chain *chain)
{
    if (!chain || !bat_references_drop(&chain->references))
        return;
    bat_release(chain->spans);
    bat_release(chain->breaks);
    bat_release(chain);
}

/* ---- properties ---- */

int batten_chain_dimension(const batten_chain *chain)
{
    return chain->placed ? 3 : chain->dimension;
}

int batten_chain_span_count(const batten_chain *chain)
{
    return chain->count;
}

const batten_span *batten_chain_span(const batten_chain *chain, int index)
{
    assert(index >= 0 && index < chain->count);
    return &chain->spans[index];
}

const double *batten_chain_breaks(const batten_chain *chain)
{
    return chain->breaks;
}

batten_interval batten_chain_domain(const batten_chain *chain)
{
    return (batten_interval){chain->breaks[0], chain->breaks[chain->count]};
}

bool batten_chain_is_closed(const batten_chain *chain)
{
    return chain->closed;
}

bool batten_chain_frame(const batten_chain *chain, batten_frame *frame)
{
    if (chain->placed)
        *frame = chain->frame;
    return chain->placed;
}

bool batten_chain_is_arcs(const batten_chain *chain)
{
    for (int i = 0; i < chain->count; i++)
        if (chain->spans[i].kind != BATTEN_SPAN_ARC)
            return false;
    return true;
}

/* ---- evaluation ---- */

/* The last break that is not above u (from the left: below u); by halving. */
static int find_span(const batten_chain *chain, double u, batten_side side)
{
    int low = 0, high = chain->count;
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        const double at = chain->breaks[middle];
        if (side == BATTEN_FROM_LEFT ? at < u : at <= u)
            low = middle;
        else
            high = middle;
    }
    return low;
}

batten_status bat_chain_locate(const batten_chain *chain, double u, batten_side side, int *span,
                               double *t)
{
    const double a = chain->breaks[0], b = chain->breaks[chain->count];
    if (chain->closed && isfinite(u) && (u < a || u >= b)) {
        u = a + fmod(u - a, b - a);
        if (u < a)
            u += b - a;
        if (!(u >= a && u < b))
            u = a;
    }
    if (chain->closed && u == a && side == BATTEN_FROM_LEFT)
        u = b;
    const batten_status status = bat_knots_clip(a, b, &u);
    if (status != BATTEN_OK)
        return status;
    const int i = find_span(chain, u, side);
    const double low = chain->breaks[i], high = chain->breaks[i + 1];
    *span = i;
    /* The ends are exact. */
    *t = u == high ? chain->spans[i].length : (u - low) / (high - low) * chain->spans[i].length;
    return BATTEN_OK;
}

/* From the plane into space: the first row is a point, the others are directions. */
static void put_in_frame(const batten_chain *chain, int order, const double *plane, double *out)
{
    const batten_vec3 o = chain->frame.origin, x = chain->frame.x, y = chain->y;
    for (int k = 0; k <= order; k++) {
        const double a = plane[2 * k], b = plane[2 * k + 1];
        const double one = k == 0;
        out[3 * k] = one * o.x + (a * x.x + b * y.x);
        out[3 * k + 1] = one * o.y + (a * x.y + b * y.y);
        out[3 * k + 2] = one * o.z + (a * x.z + b * y.z);
    }
}

batten_status batten_chain_evaluate_side(const batten_chain *chain, double u, batten_side side,
                                         int order, double *out)
{
    assert(chain && out);
    if (order < 0 || order > BAT_CHAIN_ORDER)
        return bat_fail(BATTEN_BAD_ARGUMENT, "derivative %d of a chain; there are %d", order,
                        BAT_CHAIN_ORDER);
    int i = 0;
    double t = 0, values[(BAT_CHAIN_ORDER + 1) * 3], placed[(BAT_CHAIN_ORDER + 1) * 3];
    const batten_status status = bat_chain_locate(chain, u, side, &i, &t);
    if (status != BATTEN_OK)
        return status;
    const int d = chain->dimension;
    const batten_span *span = &chain->spans[i];
    bat_span_type_of(span->kind)->evaluate(d, span, t, order, values);
    /* One step of the chain's parameter may be several of the span's. */
    const double pace = span->length / (chain->breaks[i + 1] - chain->breaks[i]);
    double power = pace;
    for (int k = 1; k <= order; k++, power *= pace)
        for (int c = 0; c < d; c++)
            values[k * d + c] *= power;
    if (chain->placed)
        put_in_frame(chain, order, values, placed);
    const size_t count = ((size_t)order + 1) * (size_t)batten_chain_dimension(chain);
    const double *result = chain->placed ? placed : values;
    if (bat_first_not_finite(result, count) < count)
        return bat_fail(BATTEN_OVERFLOW,
                        "the point or a derivative at %.17g is too large for a number", u);
    memcpy(out, result, count * sizeof *out);
    return BATTEN_OK;
}

batten_status batten_chain_evaluate(const batten_chain *chain, double u, int order, double *out)
{
    return batten_chain_evaluate_side(chain, u, BATTEN_FROM_RIGHT, order, out);
}
