/* What is true of a chain: curvature, length, and how much it bends. */
#include "inspect/local.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"

#include <batten/measure.h>
#include <float.h>

/* ---- one point ---- */

/* Only a span in tension can stand still. */
static bool stands_still(const batten_span *span, double speed, double width)
{
    const double size = bat_max(bat_largest(3, span->start), bat_largest(3, span->end));
    return span->kind == BATTEN_SPAN_TENSION && speed * width <= 16 * DBL_EPSILON * size;
}

batten_status batten_chain_local_at(const batten_chain *chain, double u, batten_side side,
                                    batten_curve_local *out)
{
    assert(chain && out);
    const int d = batten_chain_dimension(chain);
    double values[(BAT_CHAIN_ORDER + 1) * 3], t;
    int i;
    batten_status status = batten_chain_evaluate_side(chain, u, side, 3, values);
    if (status == BATTEN_OK)
        status = bat_chain_locate(chain, u, side, &i, &t);
    if (status != BATTEN_OK)
        return status;
    const double speed = bat_norm(d, values + d), second = bat_norm(d, values + 2 * d);
    if (!stands_still(&chain->spans[i], speed, chain->breaks[i + 1] - chain->breaks[i])) {
        bat_local_of(d, values, side, out);
        return BATTEN_OK;
    }
    *out = (batten_curve_local){.point = bat_vec3_of(d, values)};
    /* Seen from the left the second derivative points backwards. */
    if (second > 0)
        out->tangent = bat_vec3_scale(bat_vec3_of(d, values + 2 * d),
                                      (side == BATTEN_FROM_LEFT ? -1 : 1) / second);
    return bat_fail(BATTEN_SINGULAR_HERE, "the first derivative vanishes at u = %.17g", u);
}

/* ---- spans ---- */

void bat_span_bend(int d, const batten_span *span, double t, bat_bend *out)
{
    const double *k = span->curvature;
    if (span->kind == BATTEN_SPAN_ARC || span->kind == BATTEN_SPAN_SPIRAL) {
        *out = (bat_bend){1, k[0] + t * (k[1] + t * (k[2] / 2 + t * (k[3] / 6))),
                          k[1] + t * (k[2] + t * (k[3] / 2))};
        return;
    }
    double values[(BAT_CHAIN_ORDER + 1) * 3];
    bat_span_type_of(span->kind)->evaluate(d, span, t, BAT_CHAIN_ORDER, values);
    if (d == 1) {
        *out = (bat_bend){1, values[2], values[3]};
        return;
    }
    batten_curve_local at;
    *out = (bat_bend){bat_norm(d, values + d), 0, 0};
    if (stands_still(span, out->speed, span->length))
        return;
    bat_local_of(d, values, BATTEN_FROM_RIGHT, &at);
    out->curvature = at.curvature;
    out->rate = at.curvature_rate;
}

enum { DEPTH = 40 };

static bool goes_by_length(const batten_span *span)
{
    return span->kind != BATTEN_SPAN_TENSION && span->kind != BATTEN_SPAN_GEOMETRIC;
}

static bat_span_sums rule(int d, const batten_span *span, const bat_ruler *r, double a,
                          double b)
{
    bat_span_sums sums = {0};
    for (int i = 0; i < BAT_RULER_NODES; i++) {
        bat_bend at;
        bat_span_bend(d, span, a + (b - a) * (0.5 + 0.5 * r->nodes[i]), &at);
        const double ds = (b - a) / 2 * r->weights[i] * at.speed;
        sums.length += ds;
        sums.energy += ds * at.curvature * at.curvature;
        sums.variation += ds * at.rate * at.rate;
    }
    return sums;
}

static bat_span_sums add_sums(bat_span_sums a, bat_span_sums b)
{
    return (bat_span_sums){a.length + b.length, a.energy + b.energy, a.variation + b.variation};
}

/* Is each sum within 1e-13 of what the halves give, or nothing beside the whole? */
static bool agree(bat_span_sums whole, bat_span_sums both, bat_span_sums all)
{
    const double off[3] = {whole.length - both.length, whole.energy - both.energy,
                           whole.variation - both.variation};
    const double size[3] = {both.length, both.energy, both.variation};
    /* 1e-13 of the sums is their rounding over some hundred nodes; 1e-15 of the whole does not
     * show. */
    const double total[3] = {all.length, all.energy, all.variation};
    for (int k = 0; k < 3; k++)
        if (fabs(off[k]) > bat_max(1e-13 * size[k], 1e-15 * total[k]))
            return false;
    return true;
}

/* A part of a span, and its sums by one rule. */
typedef struct {
    double a, b;
    bat_span_sums sums;
    int depth;
} chain_part;

/* Halve until both halves give what the whole gave, of all in `total`. */
static void halve(int d, const batten_span *span, const bat_ruler *r, chain_part first,
                  bat_span_sums all, bat_span_sums *total)
{
    chain_part stack[DEPTH + 2] = {first};
    for (int waiting = 1; waiting > 0;) {
        const chain_part whole = stack[--waiting];
        const double middle = whole.a + (whole.b - whole.a) / 2;
        const chain_part low = {whole.a, middle, rule(d, span, r, whole.a, middle),
                                whole.depth + 1};
        const chain_part high = {middle, whole.b, rule(d, span, r, middle, whole.b),
                                 whole.depth + 1};
        const bat_span_sums both = add_sums(low.sums, high.sums);
        if (whole.depth == DEPTH || agree(whole.sums, both, all)) {
            *total = add_sums(*total, both);
        } else {
            stack[waiting++] = high;
            stack[waiting++] = low;
        }
    }
}

/* A span in tension bends within a few 1 / tension of its ends, where no node of a rule over
 * the whole need come: [0, m], [m, length - m], [length - m, length], or all in one, as without tension. */
static int cut_span(const batten_span *span, double at[4])
{
    const double margin = span->kind == BATTEN_SPAN_TENSION ? 16 / span->tension : span->length;
    const bool is_loose = !(margin < span->length / 4);
    at[0] = 0;
    at[1] = is_loose ? span->length : margin;
    at[2] = span->length - margin;
    at[3] = span->length;
    return is_loose ? 1 : 3;
}

void bat_span_integrate(int d, const batten_span *span, const bat_ruler *r, bat_span_sums *out)
{
    double at[4];
    chain_part parts[3];
    bat_span_sums all = {0}, total = {0};
    const int count = cut_span(span, at);
    for (int i = 0; i < count; i++) {
        parts[i] = (chain_part){at[i], at[i + 1], rule(d, span, r, at[i], at[i + 1]), 0};
        all = add_sums(all, parts[i].sums);
    }
    *out = all;
    if (span->kind != BATTEN_SPAN_ARC &&
        span->kind != BATTEN_SPAN_SPIRAL) { /* no polynomials */
        for (int i = 0; i < count; i++)
            halve(d, span, r, parts[i], all, &total);
        *out = total;
    }
    if (goes_by_length(span))
        out->length = span->length;
}

/* ---- the chain ---- */

batten_status batten_chain_length(const batten_chain *chain, double *error, double *length)
{
    assert(chain && length);
    double sum = 0, off = 0;
    bat_ruler r;
    bat_gauss(BAT_RULER_NODES, r.nodes, r.weights);
    for (int i = 0; i < chain->count; i++) {
        const batten_span *span = &chain->spans[i];
        bat_span_sums sums = {.length = span->length};
        if (!goes_by_length(span))
            bat_span_integrate(chain->dimension, span, &r, &sums);
        sum += sums.length;
        /* Halving stops at 1e-13 of each part; ten times that for all of them. */
        off += (goes_by_length(span) ? DBL_EPSILON : 1e-12) * sums.length;
    }
    if (!isfinite(sum))
        return bat_fail(BATTEN_OVERFLOW, "the length is too large for a number");
    *length = sum;
    if (error)
        *error = off;
    return BATTEN_OK;
}
