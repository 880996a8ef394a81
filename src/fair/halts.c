/*
 * The joints between the spans of a curve, and the places at which it stands still: there the
 * first derivative that is not 0 has the direction, and curvature may have no bound.
 */
#include "fair/fairness.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/spline.h"

/* Double roots, as of the squared speed, are known to half of the digits. */
#define HALF_OF_THE_DIGITS 1e-7

/* `left` and `right` are the parameters that stand for the two sides: the same, but for the
 * seam of a closed curve. */
static batten_status add_joint(bat_judged_curve *j, double left, double right)
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
static void add_halt(bat_judged_curve *j, double turn)
{
    j->found.halts++;
    j->found.corners += turn > j->options->angle;
    /* Directions of rounded control points turn back to some digits less. */
    j->found.cusps += turn > BAT_PI - HALF_OF_THE_DIGITS;
    j->found.largest_turn = bat_max(j->found.largest_turn, turn);
}

/* Beside a halt: curvature with and without a bound, and without one and of infinite energy. */
typedef enum { CURVATURE_BOUNDED, CURVATURE_UNBOUNDED, ENERGY_UNBOUNDED } halt_curvature;

/*
 * With the m-th derivative the first that is not 0 and the j-th the first beside it, curvature
 * goes like t^(j - 2 m) and its square by arc length like t^(2 j - 3 m - 1). A rational curve
 * less its point at u is a polynomial of the same degree over its weight: m and j do not exceed
 * the degree.
 */
static batten_status curvature_beside_halt(const bat_judged_curve *j, double u,
                                           batten_side side, halt_curvature *out)
{
    const int d = batten_curve_dimension(j->curve), order = batten_curve_degree(j->curve);
    const double h = bat_span_width(j->curve, u, side);
    double c[(BATTEN_MAX_DEGREE + 1) * 3], across[3];
    const batten_status status = batten_curve_evaluate_side(j->curve, u, side, order, c);
    if (status != BATTEN_OK)
        return status;
    *out = CURVATURE_BOUNDED;
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
    if (beside <= order && beside < 2 * first)
        *out = 2 * beside <= 3 * first ? ENERGY_UNBOUNDED : CURVATURE_UNBOUNDED;
    return BATTEN_OK;
}

static void add_halt_curvature(bat_judged_curve *j, halt_curvature worst)
{
    j->found.unbounded += worst != CURVATURE_BOUNDED;
    if (worst == ENERGY_UNBOUNDED)
        j->found.energy = HUGE_VAL;
}

/* A cusp is counted as such; what is left to say of it is whether its curvature has a bound. */
static void add_cusp_curvature(bat_judged_curve *j, halt_curvature worst)
{
    j->is_endless |= worst != CURVATURE_BOUNDED;
}

static batten_status note_curvature_at_halt(bat_judged_curve *j, double u, batten_side side)
{
    halt_curvature found;
    const batten_status status = curvature_beside_halt(j, u, side, &found);
    if (status == BATTEN_OK)
        add_halt_curvature(j, found);
    return status;
}

/* One of two pieces may stand still where they meet, and the other not: of that one curvature
 * has a bound. */
static batten_status curvature_beside_knot(const bat_judged_curve *j, double u,
                                           batten_side side, halt_curvature *out)
{
    const int d = batten_curve_dimension(j->curve);
    const double h = bat_span_width(j->curve, u, side);
    double c[3 * 3];
    const batten_status status = batten_curve_evaluate_side(j->curve, u, side, 2, c);
    *out = CURVATURE_BOUNDED;
    if (status != BATTEN_OK)
        return status;
    const double still = HALF_OF_THE_DIGITS * h * bat_norm(d, c + 2 * d) +
                         bat_derivative_roundoff(j->curve, 1, j->size, h);
    if (bat_norm(d, c + d) > still)
        return BATTEN_OK;
    return curvature_beside_halt(j, u, side, out);
}

/* The worse of both sides, counted once. */
static batten_status note_curvature_at_knot(bat_judged_curve *j, double left, double right,
                                            bool turns)
{
    halt_curvature before, after;
    batten_status status = curvature_beside_knot(j, left, BATTEN_FROM_LEFT, &before);
    if (status == BATTEN_OK)
        status = curvature_beside_knot(j, right, BATTEN_FROM_RIGHT, &after);
    if (status == BATTEN_OK)
        (turns ? add_cusp_curvature : add_halt_curvature)(j, before > after ? before : after);
    return status;
}

static batten_status tangent_at(const bat_judged_curve *j, double u, batten_side side,
                                batten_vec3 *out)
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
static batten_status add_halt_at_knot(bat_judged_curve *j, double left, double right)
{
    batten_vec3 before, after;
    batten_status status = tangent_at(j, left, BATTEN_FROM_LEFT, &before);
    if (status == BATTEN_OK)
        status = tangent_at(j, right, BATTEN_FROM_RIGHT, &after);
    if (status != BATTEN_OK)
        return status;
    const double turn =
        bat_atan2(bat_vec3_norm(bat_vec3_cross(before, after)), bat_vec3_dot(before, after));
    add_halt(j, turn);
    return note_curvature_at_knot(j, left, right, turn > j->options->angle);
}

/* Inside a span a curve that stands still either goes on or turns back: its direction is that
 * of a polynomial. */
static batten_status add_halt_inside(bat_judged_curve *j, double u, double aside)
{
    batten_vec3 before, after;
    batten_status status = tangent_at(j, u - aside, BATTEN_FROM_RIGHT, &before);
    if (status == BATTEN_OK)
        status = tangent_at(j, u + aside, BATTEN_FROM_RIGHT, &after);
    if (status != BATTEN_OK)
        return status;
    const bool turns_back = bat_vec3_dot(before, after) < 0;
    add_halt(j, turns_back ? BAT_PI : 0);
    halt_curvature found;
    status = curvature_beside_halt(j, u, BATTEN_FROM_RIGHT, &found);
    if (status == BATTEN_OK)
        (turns_back ? add_cusp_curvature : add_halt_curvature)(j, found);
    return status;
}

/* Does the curve stand still at u? Halts and places asked for rise. */
static bool is_halt(const bat_judged_curve *j, int *next, double u, double near)
{
    while (*next < j->halts.count && j->halts.at[*next] < u - near)
        ++*next;
    return *next < j->halts.count && j->halts.at[*next] <= u + near;
}

/* The halts between two knots, none of them at one. */
static batten_status add_halts_between(bat_judged_curve *j, int *next, double a, double b)
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

batten_status bat_judge_joints(bat_judged_curve *j)
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
