/* The numbers behind the word "fair", of a chain. */
#include "base/list.h"
#include "base/plural.h"
#include "fair/fairness.h"
#include "inspect/local.h"
#include "numeric/polynomial.h"
#include "numeric/quadrature.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

/* ---- where curvature turns on a span ---- */

enum { SAMPLES = 64 };

/* Places to look between: evenly over the span, and where it is in tension also near its ends,
 * where it bends within 1 / tension. In [0, 1], rising; both ends are among them. */
static int places(const batten_span *span, double at[3 * SAMPLES])
{
    const double z = span->tension * span->length;
    const double margin = z > SAMPLES ? SAMPLES / (4 * z) : 0;
    int count = 0;
    for (int i = 0; i < SAMPLES && margin > 0; i++)
        at[count++] = margin * i / SAMPLES;
    for (int i = 0; i <= SAMPLES; i++)
        at[count++] = margin + (1 - 2 * margin) * i / SAMPLES;
    for (int i = 1; i < SAMPLES && margin > 0; i++)
        at[count++] = 1 - margin + margin * i / SAMPLES;
    return count;
}

/* Where the rate changes its sign between a and b, by halving. */
static double refine_extreme(int d, const batten_span *span, double a, double b, double rate_a)
{
    for (int k = 0; k < 60; k++) {
        const double middle = a + (b - a) / 2;
        bat_bend at;
        bat_span_bend(d, span, middle, &at);
        if (at.rate * rate_a > 0)
            a = middle;
        else
            b = middle;
    }
    return a;
}

/* All curvatures that matter, in order: at the ends of each span and where it turns there. */
typedef struct {
    int count, capacity;
    double *curvature;
    double largest;
} profile;

static batten_status append_curvature(profile *p, double curvature)
{
    const batten_status status = BAT_LIST_ADD(p->curvature, p->count, p->capacity, curvature);
    if (status != BATTEN_OK)
        return status;
    p->largest = bat_max(p->largest, fabs(curvature));
    return BATTEN_OK;
}

static batten_status note_at(profile *p, int d, const batten_span *span, double t, double scale)
{
    bat_bend at;
    bat_span_bend(d, span, t, &at);
    return append_curvature(p, scale * at.curvature);
}

static batten_status note_turns(profile *p, int d, const batten_span *span, double scale)
{
    const double *k = span->curvature;
    batten_status status = BATTEN_OK;
    if (span->kind == BATTEN_SPAN_SPIRAL) {
        const double rate[3] = {k[1], k[2], k[3] / 2};
        double roots[2];
        const int count = bat_polynomial_roots(2, rate, 0, span->length, roots);
        for (int i = 0; i < count && status == BATTEN_OK; i++)
            status = note_at(p, d, span, roots[i], scale);
    }
    if (span->kind != BATTEN_SPAN_ELASTICA && span->kind != BATTEN_SPAN_TENSION)
        return status; /* of arcs and geometric spans curvature rises or falls */
    double at[3 * SAMPLES], last = 0, rate = 0;
    const int count = places(span, at);
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        const double t = at[i] * span->length;
        bat_bend here;
        bat_span_bend(d, span, t, &here);
        if (rate * here.rate < 0)
            status = note_at(p, d, span, refine_extreme(d, span, last, t, rate), scale);
        if (here.rate != 0) {
            rate = here.rate;
            last = t;
        }
    }
    return status;
}

/* ---- the sums ---- */

/* One step of the parameter of a function may be several of its span's. */
static double pace(const batten_chain *chain, int i)
{
    if (chain->dimension > 1)
        return 1;
    return chain->spans[i].length / (chain->breaks[i + 1] - chain->breaks[i]);
}

static batten_status add_joints(const batten_chain *chain,
                                const batten_fairness_options *options, double length,
                                double largest, batten_fairness *out)
{
    const int d = batten_chain_dimension(chain), n = chain->count;
    /* Slopes of a function have no size of their own. */
    const bat_joint_scale scale = {options->angle, options->curvature, largest,
                                   d == 1 ? BAT_MEANT_SAME * largest * length : 0, 0};
    batten_status status = BATTEN_OK;
    for (int i = !chain->closed; i < n && status == BATTEN_OK; i++) {
        double before[4 * 3], after[4 * 3];
        status = batten_chain_evaluate_side(chain, chain->breaks[i > 0 ? i : n],
                                            BATTEN_FROM_LEFT, 3, before);
        if (status == BATTEN_OK)
            status = batten_chain_evaluate_side(chain, chain->breaks[i], BATTEN_FROM_RIGHT, 3,
                                                after);
        if (status == BATTEN_OK)
            bat_add_joint(d, before, after, &scale, out);
    }
    return status;
}

static batten_status add_spans(const batten_chain *chain, profile *p, double *length,
                               batten_fairness *out)
{
    const int d = chain->dimension;
    bat_ruler ruler;
    bat_gauss(BAT_RULER_NODES, ruler.nodes, ruler.weights);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < chain->count && status == BATTEN_OK; i++) {
        const batten_span *span = &chain->spans[i];
        const double q = pace(chain, i);
        bat_span_sums sums;
        bat_span_integrate(d, span, &ruler, &sums);
        *length += sums.length;
        out->energy += q * q * q * sums.energy;
        out->variation += q * q * q * q * q * sums.variation;
        out->energy_error += BAT_SPAN_SUMS_ERROR * q * q * q * sums.energy;
        out->variation_error += BAT_SPAN_SUMS_ERROR * q * q * q * q * q * sums.variation;
        status = note_at(p, d, span, 0, q * q);
        if (status == BATTEN_OK)
            status = note_turns(p, d, span, q * q);
        if (status == BATTEN_OK)
            status = note_at(p, d, span, span->length, q * q);
    }
    return status;
}

/* ---- counting ---- */

static void count_inflections(const batten_chain *chain, const profile *p, double length,
                              batten_fairness *out)
{
    const double small = BAT_MEANT_SAME * p->largest;
    /* A turn of 1e-14 over the whole length is rounding. */
    const double zero = chain->dimension > 1 ? bat_max(small, 1e-14 / length) : small;
    bat_scan s = {.from = p->curvature[0]};
    bat_scan_walk(p->count, p->curvature, zero, zero, &s);
    if (chain->closed) { /* once more around, now knowing where it came from */
        s.inflections = s.extrema = 0;
        bat_scan_walk(p->count, p->curvature, zero, zero, &s);
    }
    out->inflections = chain->dimension < 3 ? s.inflections : 0;
    out->curvature_extrema = s.extrema;
    out->max_curvature = p->largest;
}

/* ---- the verdict ---- */

/* Points in the plane of a placed chain, [count][2]; NULL when memory is exhausted. */
static double *into_plane(const batten_chain *chain, int count, const double *points)
{
    const batten_vec3 o = chain->frame.origin, x = chain->frame.x, y = chain->y;
    double *plane = bat_array((size_t)count, 2 * sizeof *plane);
    for (int i = 0; plane && i < count; i++) {
        const batten_vec3 from = bat_vec3_subtract(bat_vec3_of(3, points + 3 * (size_t)i), o);
        plane[2 * i] = bat_vec3_dot(from, x);
        plane[2 * i + 1] = bat_vec3_dot(from, y);
    }
    return plane;
}

static batten_status required_by(const batten_chain *chain, int n, const double *points,
                                 double within, int *required)
{
    const int d = chain->dimension;
    const size_t numbers = (size_t)bat_max_int(n, 0) * (size_t)batten_chain_dimension(chain);
    *required = 0;
    if (n < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there %s %d point%s",
                        bat_one_or_many(n, "is", "are"), n, bat_plural(n));
    const size_t bad = bat_first_not_finite(points, numbers);
    if (bad < numbers)
        return bat_fail(BATTEN_NOT_FINITE, "point %zu is not finite",
                        bad / (size_t)batten_chain_dimension(chain) + 1);
    if (d == 1 && n != chain->count + 1)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "%d value%s, but the function has %d breaks", n,
                        bat_plural(n), chain->count + 1);
    double *plane = chain->placed ? into_plane(chain, n, points) : NULL;
    if (chain->placed && !plane)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status =
        bat_required_within(d, n, chain->breaks, plane ? plane : points, within, required);
    bat_release(plane);
    return status;
}

batten_status batten_chain_fairness(const batten_chain *chain, batten_points points,
                                    const batten_fairness_options *options,
                                    batten_fairness *out)
{
    batten_fairness_options chosen;
    batten_status status = bat_fairness_take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    if (points.dimension != batten_chain_dimension(chain))
        return bat_wrong_dimension(points, batten_chain_dimension(chain));
    assert(chain && out);
    batten_fairness found = {0};
    profile p = {0};
    int required = 0;
    double length = 0;
    if (points.at)
        status = required_by(chain, points.count, points.at, chosen.within, &required);
    if (status == BATTEN_OK)
        status = add_spans(chain, &p, &length, &found);
    if (status == BATTEN_OK)
        status = add_joints(chain, &chosen, length, p.largest, &found);
    if (status == BATTEN_OK) {
        count_inflections(chain, &p, length, &found);
        found.excess_inflections = bat_max_int(0, found.inflections - required);
        bat_conclude_fairness(&found);
        *out = found;
    }
    bat_release(p.curvature);
    return status;
}
