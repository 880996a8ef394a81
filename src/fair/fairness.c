/*
 * The numbers behind the word "fair", of a curve: corners, jumps and extremes of curvature, and
 * inflections.
 */
#include "fair/fairness.h"
#include "base/plural.h"
#include "fair/bend.h"
#include "inspect/inflections.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

/* A curve that is judged. */
typedef struct {
    const batten_curve *curve;
    const batten_fairness_options *options;
    double size;
    batten_parameters knots, halts, extrema;
    batten_fairness found;
} judged;

/* Curvature is largest at its extrema, at the ends, and on either side of knots. */
static batten_status note_curvatures(judged *j, const batten_parameters *at)
{
    for (int k = 0; k < at->count; k++)
        for (int side = 0; side < 2; side++) {
            bat_curve_bend bend;
            const batten_status status =
                bat_curve_bend_at(j->curve, j->size, at->at[k], (batten_side)side, &bend);
            if (status != BATTEN_OK)
                return status;
            j->found.max_curvature = bat_max(j->found.max_curvature, fabs(bend.curvature));
        }
    return BATTEN_OK;
}

/* ---- joints ---- */

/* Double roots, as of the squared speed, are known to half of the digits. */
#define HALF_OF_THE_DIGITS 1e-7

/* `left` and `right` are the parameters that stand for the two sides: the same, but for the
 * seam of a closed curve. */
static batten_status add_joint(judged *j, double left, double right)
{
    const batten_curve *curve = j->curve;
    const int d = batten_curve_dimension(curve);
    double before[4 * 3], after[4 * 3];
    batten_status status = batten_curve_evaluate_side(curve, left, BATTEN_FROM_LEFT, 3, before);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, right, BATTEN_FROM_RIGHT, 3, after);
    if (status != BATTEN_OK)
        return status;
    const double h = bat_min(bat_span_width(curve, left, BATTEN_FROM_LEFT),
                             bat_span_width(curve, right, BATTEN_FROM_RIGHT));
    const double v = d == 1 ? 1 : bat_min(bat_norm(d, before + d), bat_norm(d, after + d));
    const bat_joint_scale scale = {j->options->angle, j->options->curvature,
                                   j->found.max_curvature,
                                   2 * bat_derivative_roundoff(curve, 1, j->size, h) / v,
                                   2 * bat_derivative_roundoff(curve, 2, j->size, h) / (v * v)};
    bat_add_joint(d, before, after, &scale, &j->found);
    return BATTEN_OK;
}

/* Count a place where the curve stands still and its direction turns by `turn`. */
static void add_halt(judged *j, double turn)
{
    j->found.halts++;
    j->found.corners += turn > j->options->angle;
    /* Directions of rounded control points turn back to some digits less. */
    j->found.cusps += turn > BAT_PI - HALF_OF_THE_DIGITS;
    j->found.largest_turn = bat_max(j->found.largest_turn, turn);
}

/*
 * With the m-th derivative the first that is not 0 and the j-th the first beside it, curvature
 * goes like t^(j - 2 m) and its square by arc length like t^(2 j - 3 m - 1).
 */
static batten_status note_curvature_at_halt(judged *j, double u, batten_side side)
{
    const int d = batten_curve_dimension(j->curve), order = batten_curve_degree(j->curve);
    const double h = bat_span_width(j->curve, u, side);
    double c[(BATTEN_MAX_DEGREE + 1) * 3], across[3];
    const batten_status status = batten_curve_evaluate_side(j->curve, u, side, order, c);
    if (status != BATTEN_OK)
        return status;
    int first = 2, beside;
    while (first <= order &&
           bat_norm(d, c + first * d) <= bat_derivative_roundoff(j->curve, first, j->size, h))
        first++;
    const double *along = c + first * d;
    for (beside = first + 1; beside <= order; beside++) {
        const double *other = c + beside * d;
        const double part = bat_dot(d, other, along) / bat_dot(d, along, along);
        for (int k = 0; k < d; k++)
            across[k] = other[k] - part * along[k];
        if (bat_norm(d, across) > bat_derivative_roundoff(j->curve, beside, j->size, h) +
                                      HALF_OF_THE_DIGITS * bat_norm(d, other))
            break;
    }
    if (beside > order || beside >= 2 * first)
        return BATTEN_OK;
    j->found.unbounded++;
    j->found.max_curvature = HUGE_VAL;
    if (2 * beside <= 3 * first)
        j->found.energy = HUGE_VAL;
    return BATTEN_OK;
}

static batten_status tangent_at(const judged *j, double u, batten_side side, batten_vec3 *out)
{
    batten_curve_local at;
    const batten_status status = bat_curve_local_at(j->curve, j->size, u, side, &at);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = at.tangent;
    return BATTEN_OK;
}

/* At a knot, or at the seam where `left` and `right` are the ends: the first derivative that is
 * not 0 has the direction. */
static batten_status add_halt_at_knot(judged *j, double left, double right)
{
    batten_vec3 before, after;
    batten_status status = tangent_at(j, left, BATTEN_FROM_LEFT, &before);
    if (status == BATTEN_OK)
        status = tangent_at(j, right, BATTEN_FROM_RIGHT, &after);
    if (status != BATTEN_OK)
        return status;
    const double turn =
        atan2(bat_vec3_norm(bat_vec3_cross(before, after)), bat_vec3_dot(before, after));
    add_halt(j, turn);
    return turn > j->options->angle ? BATTEN_OK
                                    : note_curvature_at_halt(j, right, BATTEN_FROM_RIGHT);
}

/* Inside a span a curve that stands still either goes on or turns back: its direction is that
 * of a polynomial. */
static batten_status add_halt_inside(judged *j, double u, double aside)
{
    batten_vec3 before, after;
    batten_status status = tangent_at(j, u - aside, BATTEN_FROM_RIGHT, &before);
    if (status == BATTEN_OK)
        status = tangent_at(j, u + aside, BATTEN_FROM_RIGHT, &after);
    if (status != BATTEN_OK)
        return status;
    const bool turns_back = bat_vec3_dot(before, after) < 0;
    add_halt(j, turns_back ? BAT_PI : 0);
    return turns_back ? BATTEN_OK : note_curvature_at_halt(j, u, BATTEN_FROM_RIGHT);
}

/* Does the curve stand still at u? Halts and places asked for rise. */
static bool is_halt(const judged *j, int *next, double u, double near)
{
    while (*next < j->halts.count && j->halts.at[*next] < u - near)
        ++*next;
    return *next < j->halts.count && j->halts.at[*next] <= u + near;
}

/* The halts between two knots, none of them at one. */
static batten_status add_halts_between(judged *j, int *next, double a, double b)
{
    const double near = HALF_OF_THE_DIGITS * (b - a);
    batten_status status = BATTEN_OK;
    while (*next < j->halts.count && j->halts.at[*next] <= a + near)
        ++*next;
    for (double last = a; status == BATTEN_OK && *next < j->halts.count; ++*next) {
        const double u = j->halts.at[*next];
        if (u >= b - near)
            break;
        const double then = *next + 1 < j->halts.count ? bat_min(b, j->halts.at[*next + 1]) : b;
        /* Far enough for a speed above rounding, and no farther than to another halt. */
        status =
            add_halt_inside(j, u, bat_min(1e-3 * (b - a), bat_min(u - last, then - u) / 2));
        last = u;
    }
    return status;
}

static batten_status add_joints(judged *j)
{
    const int last = j->knots.count - 1;
    const double *knots = j->knots.at;
    batten_status status = BATTEN_OK;
    int next = 0;
    const bool starts_still =
        is_halt(j, &next, knots[0], HALF_OF_THE_DIGITS * (knots[1] - knots[0]));
    for (int k = 0; status == BATTEN_OK && k < last; k++) {
        const double a = knots[k], b = knots[k + 1];
        status = add_halts_between(j, &next, a, b);
        if (status != BATTEN_OK || k + 1 == last)
            break;
        const double near = HALF_OF_THE_DIGITS * bat_min(b - a, knots[k + 2] - b);
        status = is_halt(j, &next, b, near) ? add_halt_at_knot(j, b, b) : add_joint(j, b, b);
    }
    const bool closed = batten_curve_is_periodic(j->curve);
    if (status == BATTEN_OK && !closed && starts_still)
        status = note_curvature_at_halt(j, knots[0], BATTEN_FROM_RIGHT);
    if (status == BATTEN_OK && !closed &&
        is_halt(j, &next, knots[last], HALF_OF_THE_DIGITS * (knots[last] - knots[last - 1])))
        status = note_curvature_at_halt(j, knots[last], BATTEN_FROM_LEFT);
    if (status == BATTEN_OK && closed)
        status = starts_still ? add_halt_at_knot(j, knots[last], knots[0])
                              : add_joint(j, knots[last], knots[0]);
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

/* What differs by less than this part of the largest curvature is no wave. */
#define FLAT 1e-6

/* Of the extrema found, those between which curvature changes by more than `flat`. */
static batten_status count_waves(const judged *j, double flat, int *out)
{
    const batten_interval domain = batten_curve_domain(j->curve);
    const int n = j->extrema.count;
    double *k = bat_array((size_t)n + 2, sizeof *k);
    batten_status status = k ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < n + 2; i++) {
        bat_curve_bend at = {0};
        const double u = i == 0 ? domain.a : i <= n ? j->extrema.at[i - 1] : domain.b;
        status = bat_curve_bend_at(j->curve, j->size, u,
                                   i <= n ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, &at);
        if (status == BATTEN_OK)
            k[i] = at.curvature;
    }
    if (status == BATTEN_OK) {
        bat_scan scan = {.from = k[0]};
        bat_scan_walk(n + 2, k, 0, flat, &scan);
        if (batten_curve_is_periodic(j->curve)) { /* once more, knowing where it came from */
            scan.extrema = 0;
            bat_scan_walk(n + 2, k, 0, flat, &scan);
        }
        *out = bat_min_int(n, scan.extrema);
    }
    bat_release(k);
    return status;
}

static batten_status count_turns(judged *j, int required, double uncertainty)
{
    batten_fairness *found = &j->found;
    batten_parameters inflections = {0};
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(j->curve) < 3)
        status = bat_curve_inflections(j->curve, uncertainty, &inflections);
    found->curvature_extrema = j->extrema.count;
    found->inflections = inflections.count;
    found->excess_inflections = bat_max_int(0, inflections.count - required);
    /* Where curvature jumps, it may come back to the same value without a turn. */
    if (status == BATTEN_OK && found->corners + found->curvature_jumps == 0)
        status = count_waves(j, FLAT * found->max_curvature, &found->curvature_extrema);
    batten_release(inflections.at);
    return status;
}

/* ---- integrals ---- */

/* Between knots, halts and extrema no curvature is larger than at one of the ends. */
static batten_status add_energies(judged *j)
{
    const batten_interval domain = batten_curve_domain(j->curve);
    batten_parameters knots_and_halts = {0}, breaks = {0};
    bat_energies energies = {0};
    batten_status status = bat_parameters_merge(&j->knots, &j->halts, domain, &knots_and_halts);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&knots_and_halts, &j->extrema, domain, &breaks);
    if (status == BATTEN_OK) {
        /* One that all but meets the last knot was taken for it. */
        breaks.at[breaks.count - 1] = domain.b;
        status = bat_curve_energies(j->curve, &breaks, &energies);
    }
    j->found.energy = energies.energy;
    j->found.energy_error = energies.energy_error;
    j->found.variation = energies.variation;
    j->found.variation_error = energies.variation_error;
    bat_release(knots_and_halts.at);
    bat_release(breaks.at);
    return status;
}

/* ---- the verdict ---- */

static batten_status find_places(judged *j, double uncertainty)
{
    const int count = batten_curve_spans(j->curve, NULL);
    j->knots = (batten_parameters){count, bat_array((size_t)count, sizeof(double))};
    if (!j->knots.at)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(j->curve, j->knots.at);
    batten_status status = bat_curve_curvature_extrema(j->curve, uncertainty, &j->extrema);
    /* A function never stands still: its parameter goes on. */
    if (status == BATTEN_OK && batten_curve_dimension(j->curve) > 1)
        status = batten_curve_standstills(j->curve, &j->halts);
    return status;
}

/* A bend far below what rounding leaves of points, whose energy the quadrature cannot tell. */
static bool is_too_sharp(const judged *j)
{
    const batten_fairness *f = &j->found;
    return f->corners == 0 && f->unbounded == 0 && f->energy_error > 1e-3 * f->energy &&
           f->max_curvature * j->size > 1e9;
}

/* Fairness of a curve when `required` inflections are no fault, and neither are those that
 * would go if its points moved by `uncertainty`. */
static batten_status judge_curve(const batten_curve *curve,
                                 const batten_fairness_options *options, int required,
                                 double uncertainty, batten_fairness *out)
{
    judged j = {.curve = curve, .options = options, .size = bat_curve_size(curve)};
    batten_status status = find_places(&j, uncertainty);
    if (status == BATTEN_OK)
        status = note_curvatures(&j, &j.knots);
    if (status == BATTEN_OK)
        status = note_curvatures(&j, &j.extrema);
    if (status == BATTEN_OK)
        status = add_energies(&j);
    if (status == BATTEN_OK)
        status = add_joints(&j);
    if (status == BATTEN_OK)
        status = count_turns(&j, required, uncertainty);
    if (status == BATTEN_OK) {
        j.found.unbounded += is_too_sharp(&j);
        bat_conclude_fairness(&j.found);
        *out = j.found;
    }
    bat_release(j.knots.at);
    bat_release(j.halts.at);
    bat_release(j.extrema.at);
    return status;
}

/* Waves as small as this part of the bound are where the search for the least energy was ended.
 */
#define SETTLED 1e-6

batten_status bat_batten_fairness(const bat_batten *batten, int width, const double *points,
                                  const double *within, const double *z, batten_fairness *out)
{
    const batten_fairness_options options = batten_fairness_defaults();
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
        status = judge_curve(curve, &options, required, SETTLED * largest, out);
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
    sum->energy_error += one->energy_error;
    sum->variation += one->variation;
    sum->variation_error += one->variation_error;
    sum->max_curvature = bat_max(sum->max_curvature, one->max_curvature);
    sum->corners += one->corners;
    sum->cusps += one->cusps;
    sum->halts += one->halts;
    sum->unbounded += one->unbounded;
    sum->curvature_jumps += one->curvature_jumps;
    sum->largest_turn = bat_max(sum->largest_turn, one->largest_turn);
    sum->largest_jump = bat_max(sum->largest_jump, one->largest_jump);
    sum->fair = sum->fair && one->fair;
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
                                    const batten_fairness_options *options,
                                    batten_fairness *out)
{
    batten_fairness_options chosen;
    batten_status status = bat_fairness_take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    if (points.dimension != batten_curve_dimension(curve))
        return bat_wrong_dimension(points, batten_curve_dimension(curve));
    const int d = batten_curve_dimension(curve);
    int required = 0;
    if (points.at)
        status = check_points(curve, points.count, points.at);
    if (status == BATTEN_OK && points.at && d < 3) {
        double *knots = bat_array((size_t)batten_curve_spans(curve, NULL), sizeof *knots);
        if (!knots)
            return BATTEN_OUT_OF_MEMORY;
        batten_curve_spans(curve, knots);
        status =
            bat_required_within(d, points.count, knots, points.at, chosen.within, &required);
        bat_release(knots);
    }
    return status == BATTEN_OK ? judge_curve(curve, &chosen, required, 0, out) : status;
}
