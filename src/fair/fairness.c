/*
 * The numbers behind the word "fair", of a curve: corners, jumps and extremes of curvature, and
 * inflections.
 */
#include "fair/fairness.h"
#include "base/plural.h"
#include "inspect/inflections.h"
#include "inspect/singular.h"
#include "numeric/quadrature.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* Curvature and its rate at one parameter; of a function (dimension 1) its second and third
 * derivative, and du for ds. Where the curve is singular it counts as straight. */
typedef struct {
    double curvature, rate, speed;
} bend;

static batten_status bend_at(const batten_curve *curve, double u, batten_side side, bend *out)
{
    if (batten_curve_dimension(curve) == 1) {
        double values[4];
        batten_status status = batten_curve_evaluate_side(curve, u, side, 3, values);
        if (status == BATTEN_OK)
            *out = (bend){values[2], values[3], 1};
        return status;
    }
    batten_curve_local at;
    const batten_status status = batten_curve_local_at(curve, u, side, &at);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = (bend){at.curvature, at.curvature_rate, at.speed};
    return BATTEN_OK;
}

/* ---- integrals ---- */

enum { NODES = 16 };

typedef struct {
    double nodes[NODES], weights[NODES];
} rule;

static batten_status add_span(const batten_curve *curve, const rule *r, double a, double b,
                              batten_fairness *out)
{
    const double half = (b - a) / 2;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < NODES; i++) {
        bend at;
        status = bend_at(curve, a + half * (1 + r->nodes[i]), BATTEN_FROM_RIGHT, &at);
        if (status != BATTEN_OK)
            return status;
        const double weight = half * r->weights[i] * at.speed;
        out->energy += weight * at.curvature * at.curvature;
        out->variation += weight * at.rate * at.rate;
        out->max_curvature = bat_max(out->max_curvature, fabs(at.curvature));
    }
    return status;
}

static batten_status note_curvature(const batten_curve *curve, double u, batten_fairness *out)
{
    for (int side = 0; side < 2; side++) {
        bend at;
        batten_status status = bend_at(curve, u, (batten_side)side, &at);
        if (status != BATTEN_OK)
            return status;
        out->max_curvature = bat_max(out->max_curvature, fabs(at.curvature));
    }
    return BATTEN_OK;
}

/* ---- joints ---- */

/*
 * The derivative of the curvature vector with respect to arc length, across the tangent; of a
 * function the third derivative. With v = |C'| and the part across C' marked by x:
 * (C'''x - 3 (C' . C'') / v^2 C''x) / v^3.
 */
static void third_across(int d, const double *c, double out[3])
{
    const double v2 = bat_dot(d, c + d, c + d), a = bat_dot(d, c + d, c + 2 * d);
    const double b = bat_dot(d, c + d, c + 3 * d), cube = v2 * sqrt(v2);
    for (int k = 0; k < d; k++) {
        const double second = v2 > 0 ? c[2 * d + k] - a / v2 * c[d + k] : 0;
        const double third = v2 > 0 ? c[3 * d + k] - b / v2 * c[d + k] : 0;
        out[k] = d == 1 ? c[3] : v2 > 0 ? (third - 3 * a / v2 * second) / cube : 0;
    }
}

/* Direction and curvature vector; of a function its first and second derivative. */
static bool bend_across(int d, const double *c, double direction[3], double curvature[3])
{
    const double v2 = d == 1 ? 1 : bat_dot(d, c + d, c + d), v = sqrt(v2);
    const double a = d == 1 ? 0 : bat_dot(d, c + d, c + 2 * d);
    for (int k = 0; k < d && v2 > 0; k++) {
        direction[k] = c[d + k] / v;
        curvature[k] = (c[2 * d + k] - a / v2 * c[d + k]) / v2;
    }
    return v2 > 0;
}

/* What differs by less than this part is the same: constructions join their spans to some 1e-9.
 */
#define SAME 1e-6

static void add_step(int d, const double *before, const double *after,
                     const bat_joint_scale *scale, batten_fairness *out)
{
    double t[2][3], k[2][3];
    if (!bend_across(d, before, t[0], k[0]) || !bend_across(d, after, t[1], k[1]))
        return;
    const double steepest = d == 1 ? bat_max(fabs(t[0][0]), fabs(t[1][0])) : 1;
    const double bent = bat_max(bat_norm(d, k[0]), bat_norm(d, k[1]));
    if (bat_distance(d, t[0], t[1]) > SAME * steepest + scale->direction_noise)
        out->corners++;
    /* Nine digits: what is left of curvatures of points given with twelve. */
    else if (bat_distance(d, k[0], k[1]) >
             SAME * bent + 1e-9 * scale->largest + scale->curvature_noise)
        out->curvature_jumps++;
}

void bat_add_joint(int d, const double *before, const double *after,
                   const bat_joint_scale *scale, batten_fairness *out)
{
    double a[3], b[3];
    third_across(d, before, a);
    third_across(d, after, b);
    for (int k = 0; k < d; k++)
        out->jumps += (b[k] - a[k]) * (b[k] - a[k]);
    add_step(d, before, after, scale, out);
}

void bat_judge_joints(batten_fairness *out)
{
    if (out->corners > 0)
        out->energy = HUGE_VAL;
    if (out->corners > 0 || out->curvature_jumps > 0)
        out->variation = HUGE_VAL;
}

/* `left` and `right` are the parameters that stand for the two sides: the same, but for the
 * seam of a closed curve. */
static batten_status add_joint(const batten_curve *curve, double left, double right,
                               batten_fairness *out)
{
    const int d = batten_curve_dimension(curve);
    double before[4 * 3], after[4 * 3];
    batten_status status = batten_curve_evaluate_side(curve, left, BATTEN_FROM_LEFT, 3, before);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, right, BATTEN_FROM_RIGHT, 3, after);
    if (status != BATTEN_OK)
        return status;
    const double h = bat_min(bat_span_width(curve, left, BATTEN_FROM_LEFT),
                             bat_span_width(curve, right, BATTEN_FROM_RIGHT));
    const double size = bat_curve_size(curve);
    const double v = d == 1 ? 1 : bat_min(bat_norm(d, before + d), bat_norm(d, after + d));
    const bat_joint_scale scale = {out->max_curvature,
                                   2 * bat_derivative_roundoff(curve, 1, size, h) / v,
                                   2 * bat_derivative_roundoff(curve, 2, size, h) / (v * v)};
    bat_add_joint(d, before, after, &scale, out);
    return BATTEN_OK;
}

static batten_status add_joints(const batten_curve *curve, int count, const double *knots,
                                batten_fairness *out)
{
    batten_status status = BATTEN_OK;
    for (int k = 1; status == BATTEN_OK && k + 1 < count; k++)
        status = add_joint(curve, knots[k], knots[k], out);
    if (status == BATTEN_OK && batten_curve_is_periodic(curve))
        status = add_joint(curve, knots[count - 1], knots[0], out);
    if (status == BATTEN_OK)
        bat_judge_joints(out);
    return status;
}

static batten_status add_spans(const batten_curve *curve, batten_fairness *out)
{
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    rule gauss;
    bat_gauss(NODES, gauss.nodes, gauss.weights);
    batten_curve_spans(curve, knots);
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = note_curvature(curve, knots[k], out);
        if (status == BATTEN_OK && k + 1 < count)
            status = add_span(curve, &gauss, knots[k], knots[k + 1], out);
    }
    if (status == BATTEN_OK)
        status = add_joints(curve, count, knots, out);
    bat_release(knots);
    return status;
}

/* ---- counting ---- */

void bat_scan_walk(int count, const double *curvature, double zero, double flat, bat_scan *s)
{
    for (int i = 0; i < count; i++) {
        const double k = curvature[i];
        const int sign = (k > zero) - (k < -zero);
        if (sign * s->sign < 0)
            s->inflections++;
        if (sign != 0)
            s->sign = sign;
        const double change = k - s->from;
        const int direction = (change > flat) - (change < -flat);
        if (direction * s->direction < 0)
            s->extrema++;
        if (direction != 0)
            s->direction = direction;
        if (direction != 0 || change * s->direction > 0)
            s->from = k;
    }
}

/* Of the extrema found, those between which curvature changes by more than `flat`. */
static batten_status count_waves(const batten_curve *curve, const batten_parameters *extrema,
                                 double flat, int *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const int n = extrema->count;
    double *k = bat_array((size_t)n + 2, sizeof *k);
    batten_status status = k ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n + 2; i++) {
        bend at = {0};
        const double u = i == 0 ? domain.a : i <= n ? extrema->at[i - 1] : domain.b;
        status = bend_at(curve, u, i <= n ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &at);
        if (status == BATTEN_OK)
            k[i] = at.curvature;
    }
    if (status == BATTEN_OK) {
        bat_scan scan = {.from = k[0]};
        bat_scan_walk(n + 2, k, 0, flat, &scan);
        if (batten_curve_is_periodic(curve)) { /* once more, knowing where it came from */
            scan.extrema = 0;
            bat_scan_walk(n + 2, k, 0, flat, &scan);
        }
        *out = bat_min_int(n, scan.extrema);
    }
    bat_release(k);
    return status;
}

/* ---- the verdict ---- */

static batten_status count_turns(const batten_curve *curve, int required, double uncertainty,
                                 batten_fairness *out)
{
    batten_parameters extrema = {0}, inflections = {0};
    batten_status status = bat_curve_curvature_extrema(curve, uncertainty, &extrema);
    if (status == BATTEN_OK && batten_curve_dimension(curve) < 3)
        status = bat_curve_inflections(curve, uncertainty, &inflections);
    out->curvature_extrema = extrema.count;
    out->inflections = inflections.count;
    out->excess_inflections = bat_max_int(0, inflections.count - required);
    out->fair = out->excess_inflections == 0;
    for (int k = 0; status == BATTEN_OK && k < extrema.count; k++)
        status = note_curvature(curve, extrema.at[k], out);
    /* Where curvature jumps, it may come back to the same value without a turn. */
    if (status == BATTEN_OK && out->corners + out->curvature_jumps == 0)
        status =
            count_waves(curve, &extrema, SAME * out->max_curvature, &out->curvature_extrema);
    batten_release(extrema.at);
    batten_release(inflections.at);
    return status;
}

/* Fairness of a curve when `required` inflections are no fault, and neither are those that
 * would go if its points moved by `uncertainty`. */
static batten_status judge_curve(const batten_curve *curve, int required, double uncertainty,
                                 batten_fairness *out)
{
    batten_fairness found = {0};
    batten_status status = add_spans(curve, &found);
    if (status == BATTEN_OK)
        status = count_turns(curve, required, uncertainty, &found);
    if (status == BATTEN_OK)
        *out = found;
    return status;
}

/* Waves as small as this part of the bound are where the search for the least energy was ended.
 */
#define SETTLED 1e-6

batten_status bat_batten_fairness(const bat_batten *batten, int width, const double *points,
                                  const double *within, const double *z, batten_fairness *out)
{
    batten_curve *curve = NULL;
    int required = 0;
    double largest = 0;
    for (int i = 0; i < batten->count; i++)
        largest = bat_max(largest, within[i]);
    batten_status status =
        bat_required_inflections(width, batten->count, batten->t, points, within, &required);
    if (status == BATTEN_OK)
        status = bat_batten_curve(batten, width, z, &curve);
    if (status == BATTEN_OK)
        status = judge_curve(curve, required, SETTLED * largest, out);
    batten_curve_unref(curve);
    return status;
}

void bat_fairness_add(batten_fairness *sum, const batten_fairness *one)
{
    sum->inflections += one->inflections;
    sum->excess_inflections += one->excess_inflections;
    sum->curvature_extrema += one->curvature_extrema;
    sum->jumps += one->jumps;
    sum->energy += one->energy;
    sum->variation += one->variation;
    sum->max_curvature = bat_max(sum->max_curvature, one->max_curvature);
    sum->fair = sum->fair && one->fair;
    sum->corners += one->corners;
    sum->curvature_jumps += one->curvature_jumps;
}

/* ---- any curve ---- */

/* The values of a function stand at the distinct knots of its curve. */
static batten_status check_points(const batten_curve *curve, int count, const double *points)
{
    const int d = batten_curve_dimension(curve), spans = batten_curve_spans(curve, NULL);
    const size_t values = (size_t)bat_max_int(count, 0) * (size_t)d;
    if (count < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there %s %d point%s",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (bat_first_not_finite(points, values) < values)
        return bat_fail(BATTEN_NOT_FINITE, "point %zu is not finite",
                        bat_first_not_finite(points, values) / (size_t)d);
    if (d == 1 && count != spans)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "%d value%s, but the function has %d distinct knots", count,
                        bat_plural(count), spans);
    return BATTEN_OK;
}

batten_status batten_curve_fairness(const batten_curve *curve, batten_points points,
                                    batten_fairness *out)
{
    if (points.dimension != batten_curve_dimension(curve))
        return bat_wrong_dimension(points, batten_curve_dimension(curve));
    const int d = batten_curve_dimension(curve);
    int required = 0;
    batten_status status = points.at ? check_points(curve, points.count, points.at) : BATTEN_OK;
    if (status == BATTEN_OK && points.at && d < 3) {
        double *knots = bat_array((size_t)batten_curve_spans(curve, NULL), sizeof *knots);
        if (!knots)
            return BATTEN_OUT_OF_MEMORY;
        batten_curve_spans(curve, knots);
        status = bat_required_inflections(d, points.count, knots, points.at, NULL, &required);
        bat_release(knots);
    }
    return status == BATTEN_OK ? judge_curve(curve, required, 0, out) : status;
}
