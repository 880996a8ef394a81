/* Parameters and knots of curves near points. */
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"
#include "shape/near/approximate.h"
#include "shape/points/parametrize.h"
#include "spline/curve/curve.h"

#include <string.h>

batten_status bat_weights_check(int count, const double *weights)
{
    for (int i = 0; weights && i < count; i++) {
        if (!isfinite(weights[i]))
            return bat_fail(BATTEN_NOT_FINITE, "the weight of point %d is %g", i + 1,
                            weights[i]);
        if (weights[i] < 0)
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "the weight of point %d is %g; it must be 0 or more", i + 1,
                            weights[i]);
    }
    return BATTEN_OK;
}

/* ---- parameters ---- */

static batten_status check_given(int count, const double *given)
{
    for (int i = 0; i < count; i++) {
        if (!isfinite(given[i]))
            return bat_fail(BATTEN_NOT_FINITE, "parameter %d is %g", i + 1, given[i]);
        if (i > 0 && given[i] < given[i - 1])
            return bat_fail(BATTEN_NOT_INCREASING,
                            "parameter %d is %g, below parameter %d, which is %g", i + 1,
                            given[i], i - 1 + 1, given[i - 1]);
    }
    return BATTEN_OK;
}

batten_status bat_fit_parameters(int dimension, int count, const double *points,
                                 batten_parametrization kind, const double *given,
                                 bool periodic, double *parameters)
{
    const int wanted = count + periodic;
    if (kind == BATTEN_GIVEN) {
        if (!given)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the parameters must be given, and are missing");
        const batten_status status = check_given(wanted, given);
        if (status != BATTEN_OK)
            return status;
        memcpy(parameters, given, (size_t)wanted * sizeof *parameters);
    } else {
        bat_steps((batten_points){dimension, count, points}, kind, periodic, parameters + 1);
        parameters[0] = 0;
        for (int i = 1; i < wanted; i++)
            parameters[i] += parameters[i - 1];
    }
    const double first = parameters[0], last = parameters[wanted - 1];
    if (!isfinite(last - first))
        return bat_fail(BATTEN_OVERFLOW, "the parameters leave the numbers");
    if (!(last > first))
        return bat_fail(BATTEN_COINCIDENT, "all %d points have the same parameter", count);
    return BATTEN_OK;
}

/* ---- knots by data ---- */

/* The parameters that differ, of data that count; one more at the end of a period. */
typedef struct {
    int count;
    double *at;
} places;

static batten_status find_places(const bat_fit_request *r, places *out)
{
    out->count = 0;
    out->at = bat_array((size_t)r->data_count + 1, sizeof *out->at);
    if (!out->at)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < r->data_count; i++) {
        const bool counts = !r->weights || r->weights[i] > 0;
        if (counts && (out->count == 0 || r->parameters[i] > out->at[out->count - 1]))
            out->at[out->count++] = r->parameters[i];
    }
    const double end = r->parameters[r->data_count];
    if (r->periodic && out->count > 0) {
        out->count -= out->at[out->count - 1] >= end;
        out->at[out->count] = end;
    }
    if (out->count >= r->count)
        return BATTEN_OK;
    bat_release(out->at);
    return bat_fail(BATTEN_TOO_FEW_POINTS,
                    "%d control points need as many data; %d of the %d data count and have "
                    "parameters of their own",
                    r->count, out->count, r->data_count);
}

/* The parameter at place x, where places are numbered from 0. */
static double at_place(const places *p, double x)
{
    const int i = (int)x;
    return i >= p->count ? p->at[p->count] : p->at[i] + (x - i) * (p->at[i + 1] - p->at[i]);
}

static double place_of(const places *p, int last, double u)
{
    int low = 0, high = last;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (p->at[middle] <= u)
            low = middle;
        else
            high = middle;
    }
    return low + (u - p->at[low]) / (p->at[high] - p->at[low]);
}

/* Ends and, of clamped knots, the multiplicity there; inner knots are filled in by others. */
static int frame_knots(const bat_fit_request *r, double *knots, double **inner)
{
    const int p = r->degree, n = r->count;
    const double a = r->parameters[0],
                 b = r->parameters[r->periodic ? r->data_count : r->data_count - 1];
    if (r->periodic) {
        knots[0] = a;
        knots[n] = b;
        *inner = knots + 1;
        return n - 1;
    }
    for (int i = 0; i <= p; i++) {
        knots[i] = a;
        knots[n + i] = b;
    }
    *inner = knots + p + 1;
    return n - p - 1;
}

/* Where knot j of `inner` stands, in places. Clamped after Piegl and Tiller: c = M / (n - p)
 * data for each span, and knot j between the data floor(j c) - 1 and floor(j c). */
static double even_place(const bat_fit_request *r, const places *p, int inner, int j)
{
    const double c = (double)p->count / (inner + 1), x = (j + 1) * c;
    return r->periodic ? x : bat_max(0, x - 1);
}

batten_status bat_fit_knots(const bat_fit_request *r, double *knots)
{
    places p;
    const batten_status status = find_places(r, &p);
    if (status != BATTEN_OK)
        return status;
    double *inner;
    const int count = frame_knots(r, knots, &inner);
    for (int j = 0; j < count; j++)
        inner[j] = at_place(&p, even_place(r, &p, count, j));
    bat_release(p.at);
    return BATTEN_OK;
}

/* ---- knots by curvature ---- */

/* How dense knots are to be on each span of the first curve: the (p + 1)th root of the next
 * derivative, which the jumps of the p-th at the knots tell. */
static batten_status find_density(const batten_curve *first, int spans, const double *breaks,
                                  double *density)
{
    const int d = batten_curve_dimension(first), p = batten_curve_degree(first);
    double left[3 * (BATTEN_MAX_DEGREE + 1)], right[3 * (BATTEN_MAX_DEGREE + 1)], mean = 0;
    for (int i = 1; i < spans; i++) {
        batten_status status =
            batten_curve_evaluate_side(first, breaks[i], BATTEN_FROM_LEFT, p, left);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(first, breaks[i], p, right);
        if (status != BATTEN_OK)
            return status;
        const double jump = bat_distance(d, left + p * d, right + p * d);
        const double slope = jump / (breaks[i + 1] - breaks[i - 1]);
        density[i - 1] += slope;
        density[i] += slope;
    }
    for (int i = 0; i < spans; i++) {
        density[i] = bat_pow(density[i], 1.0 / (p + 1));
        mean += density[i] * (breaks[i + 1] - breaks[i]) / (breaks[spans] - breaks[0]);
    }
    /* Every fifth knot is spread evenly, so that no part is left without. */
    for (int i = 0; i < spans; i++)
        density[i] = mean > 0 ? density[i] / mean + 0.25 : 1;
    return BATTEN_OK;
}

/* Places of the inner knots at equal integrals of the density. */
static void equal_parts(int spans, const double *breaks, const double *density, const places *p,
                        int last, int count, double *place)
{
    double total = 0, before = 0;
    for (int i = 0; i < spans; i++)
        total += density[i] * (breaks[i + 1] - breaks[i]);
    for (int j = 0, i = 0; j < count; j++) {
        const double wanted = total * (j + 1) / (count + 1);
        while (i < spans - 1 && before + density[i] * (breaks[i + 1] - breaks[i]) < wanted) {
            before += density[i] * (breaks[i + 1] - breaks[i]);
            i++;
        }
        place[j] = place_of(p, last, breaks[i] + (wanted - before) / density[i]);
    }
}

/* Has each value a datum of its own, after Schoenberg and Whitney? Value i bears on the places
 * between knots i and i + p + 1; each takes the next datum there is. A ring is safe when every
 * span has one. */
static bool data_suffice(const bat_fit_request *r, const places *p, int count,
                         const double *place)
{
    if (r->periodic) {
        for (int j = 0; j <= count; j++)
            if ((j == count ? p->count : place[j]) - (j == 0 ? 0 : place[j - 1]) < 1)
                return false;
        return true;
    }
    const int last = p->count - 1;
    for (int i = 0, datum = 0; i < r->count; i++, datum++) {
        const int before = i - r->degree - 1; /* the inner knot at which value i begins */
        const double begin = before < 0 ? -1 : place[before],
                     end = i < count ? place[i] : last + 1;
        datum = bat_max_int(datum, (int)floor(begin) + 1);
        if (!(datum < end))
            return false;
    }
    return true;
}

batten_status bat_fit_knots_by_curvature(const bat_fit_request *r, const batten_curve *first,
                                         double *knots)
{
    places p;
    batten_status status = find_places(r, &p);
    if (status != BATTEN_OK)
        return status;
    const int spans = batten_curve_spans(first, NULL) - 1,
              last = r->periodic ? p.count : p.count - 1;
    double *inner;
    const int count = frame_knots(r, knots, &inner);
    double *breaks = bat_array((size_t)batten_curve_point_count(first) + 1, sizeof *breaks);
    double *density = bat_array((size_t)spans, sizeof *density);
    double *place = bat_array((size_t)bat_max_int(count, 1), sizeof *place);
    if (!breaks || !density || !place)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(first, breaks);
        status = find_density(first, spans, breaks, density);
    }
    if (status == BATTEN_OK) {
        equal_parts(spans, breaks, density, &p, last, count, place);
        /* Half way back to knots by data, until every part has data enough. */
        for (int round = 0; round < 8 && !data_suffice(r, &p, count, place); round++)
            for (int j = 0; j < count; j++)
                place[j] = round == 7 ? even_place(r, &p, count, j)
                                      : (place[j] + even_place(r, &p, count, j)) / 2;
        for (int j = 0; j < count; j++)
            inner[j] = at_place(&p, place[j]);
    }
    bat_release(place);
    bat_release(density);
    bat_release(breaks);
    bat_release(p.at);
    return status;
}

/* ---- parameter correction ---- */

batten_status bat_fit_correct(int dimension, int count, const double *points,
                              const batten_curve *curve, double *parameters)
{
    const size_t d = (size_t)dimension, n = (size_t)count;
    const batten_interval domain = batten_curve_domain(curve);
    double *at = bat_array3(n, 3 * d, sizeof *at), *moved = bat_array(n, sizeof *moved),
           *then = bat_array3(n, d, sizeof *then);
    batten_status status = at && moved && then ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_many(curve, n, parameters, 2, NULL, at);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        const double u =
            parameters[i] + bat_foot_curve_step(dimension, at + 3 * i * d, points + i * d);
        moved[i] = bat_min(domain.b, bat_max(domain.a, u));
    }
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_many(curve, n, moved, 0, NULL, then);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        const double *q = points + i * d;
        if (bat_distance(dimension, then + i * d, q) <
            bat_distance(dimension, at + 3 * i * d, q))
            parameters[i] = moved[i];
        if (i > 0)
            parameters[i] = bat_max(parameters[i], parameters[i - 1]);
    }
    bat_release(then);
    bat_release(moved);
    bat_release(at);
    return status;
}
