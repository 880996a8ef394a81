/*
 * Two arcs that meet with a common tangent, between points with given directions: where the
 * joint goes for each rule, and the arcs themselves.
 */
#include "shape/arcs/biarc.h"
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"

/* An arc of nearly a full turn is lost in rounding: its radius is c / (2 sin half), and with it
 * its ends are uncertain by eps c / (pi - |half|). This keeps that below 1e-12 c. */
static const double nearly_full = BAT_PI - 0x1p-12;

/* ---- one arc ---- */

void bat_arc_span(const double start[2], double chord, double direction, double half,
                  batten_span *out)
{
    const double sine = bat_sin(half);
    *out = (batten_span){.kind = BATTEN_SPAN_ARC,
                         .length = half == 0 ? chord : chord * (half / sine),
                         .start = {start[0], start[1]},
                         .angle = direction - half,
                         .curvature = {2 * sine / chord}};
}

double bat_turn(const double from[2], const double to[2])
{
    const double turn = bat_atan2(from[0] * to[1] - from[1] * to[0], bat_dot(2, from, to));
    return turn == -BAT_PI ? BAT_PI : turn;
}

/* ---- where the joint is ---- */

/* The ends of a biarc turn by alpha and beta from the chord. With D = (alpha - beta) / 2 the
 * angles at start and end between chord and joint, w and v, have the sum D; the place is v / D,
 * and the direction at the joint is 2 w - alpha from the chord. */

/* The joint at which the radii of an S are equal: there the direction tau has cos tau =
 * (cos alpha + cos beta) / 2, written so that nothing cancels. */
static double equal_radii(double alpha, double beta)
{
    const double a = bat_sin(alpha / 2), b = bat_sin(beta / 2), D = (alpha - beta) / 2;
    const double sum = (alpha + beta) / 2;
    const double tau = (sum > 0 ? -2 : 2) * bat_asin(bat_min(1, sqrt((a * a + b * b) / 2)));
    if (D == 0)
        return 0.5;
    return 1 - bat_asin(bat_sin(sum) * bat_sin(D) / (2 * bat_sin((alpha - tau) / 2))) / D;
}

/* Both legs d: J is the middle of P0 + d T0 and P1 - d T1. */
static double equal_legs(double alpha, double beta)
{
    const double D = (alpha - beta) / 2, S = (alpha + beta) / 2;
    const double b = bat_cos(S) * bat_cos(D), root = sqrt(b * b + bat_sin(D) * bat_sin(D));
    const double d = b > 0 ? 1 / (2 * (b + root)) : (root - b) / (2 * bat_sin(D) * bat_sin(D));
    const double x = 0.5 - d * bat_sin(S) * bat_sin(D), y = d * bat_cos(S) * bat_sin(D);
    const double place = 1 - bat_atan2(y, x) / D;
    return place > 0 && place < 1 ? place : 0.5;
}

/* The place of the joint for a choice other than GIVEN. */
static double joint_place(double alpha, double beta, batten_biarc_joint joint)
{
    static const double margin = 1e-6;
    const double D = (alpha - beta) / 2, a = fabs(alpha), b = fabs(beta);
    const bool is_c = (alpha > 0 && beta < 0) || (alpha < 0 && beta > 0);
    double place = 0.5;
    switch (joint) {
    case BATTEN_JOINT_AUTOMATIC:
        if (is_c && (a > 3 * b || b > 3 * a))
            place = 1 - alpha / 2 / D;
        break;
    case BATTEN_JOINT_EQUAL_LEGS:
        place = equal_legs(alpha, beta);
        break;
    case BATTEN_JOINT_LEAST_RATIO:
        place = is_c ? 1 - alpha / 2 / D : equal_radii(alpha, beta);
        break;
    case BATTEN_JOINT_LEAST_CURVATURE:
        /* Of a C: the arc at the end with the smaller angle is a line. */
        place = !is_c ? equal_radii(alpha, beta) : b < a ? -beta / D : 1 - alpha / D;
        break;
    case BATTEN_JOINT_EQUAL_CHORD:
    case BATTEN_JOINT_GIVEN:
        break;
    }
    return bat_max(margin, bat_min(1 - margin, place));
}

batten_status batten_biarc_place(batten_vec2 start, batten_vec2 end, batten_vec2 point,
                                 double *place)
{
    const double start_xy[2] = {start.x, start.y};
    const double end_xy[2] = {end.x, end.y};
    const double point_xy[2] = {point.x, point.y};
    assert(place);
    const double chord[2] = {end_xy[0] - start_xy[0], end_xy[1] - start_xy[1]};
    const double out[2] = {point_xy[0] - start_xy[0], point_xy[1] - start_xy[1]};
    const double on[2] = {end_xy[0] - point_xy[0], end_xy[1] - point_xy[1]};
    const double w = bat_turn(chord, out), v = bat_turn(on, chord);
    double found = v / (w + v);
    if (w == 0 && v == 0)
        found = bat_norm(2, out) / (bat_norm(2, out) + bat_norm(2, on));
    if (!(found > 0 && found < 1))
        return bat_fail(BATTEN_NOT_FOUND,
                        "the point (%g, %g) does not lie between the ends of the biarc",
                        point_xy[0], point_xy[1]);
    *place = found;
    return BATTEN_OK;
}

/* ---- the biarc ---- */

static batten_status check_arcs(const batten_biarc *made)
{
    for (int i = 0; i < made->count; i++) {
        const batten_span *arc = &made->arcs[i];
        if (!isfinite(arc->length) || !isfinite(arc->curvature[0]) || !(arc->length > 0) ||
            !isfinite(arc->start[0]) || !isfinite(arc->start[1]))
            return bat_fail(BATTEN_OVERFLOW,
                            "an arc of the length %g with the curvature %g leaves the numbers",
                            arc->length, arc->curvature[0]);
    }
    return BATTEN_OK;
}

static double leg(double chord, double half)
{
    return fabs(fabs(half) - BAT_PI / 2) < DBL_EPSILON ? HUGE_VAL : chord / (2 * bat_cos(half));
}

/* One arc from end to end: its two halves are the arcs that it might have been. */
static void make_single(const bat_arc_chord *chord, double half, double place,
                        batten_biarc *made)
{
    const double l = chord->length, phi = chord->angle;
    batten_span first;
    made->count = 1;
    bat_arc_span(chord->start, l, phi, half, &made->arcs[0]);
    made->turn[0] = 2 * half;
    made->is_long = fabs(made->turn[0]) > BAT_PI;
    /* The joint belongs to the equal angles of the circle over its chord. */
    const double share = half == 0 ? 1 - place : bat_sin(half * (1 - place)) / bat_sin(half);
    bat_arc_span(chord->start, l * (half == 0 ? place : bat_sin(half * place) / bat_sin(half)),
                 phi - half * (1 - place), half * place, &first);
    bat_arc_at(&first, first.length, made->joint);
    made->legs[0] =
        leg(l * (half == 0 ? place : bat_sin(half * place) / bat_sin(half)), half * place);
    made->legs[1] = leg(l * share, half * (1 - place));
}

/* Two arcs, by half of what each turns: D is half of what the directions at both ends differ,
 * and v and w are the shares of it that the chords of the arcs turn away from the whole. */
static void make_two(const bat_arc_chord *whole, double D, const double half[2],
                     batten_biarc *made)
{
    const double place = made->place, w = D * (1 - place), v = D * place;
    const double *start = whole->start, l = whole->length, phi = whole->angle;
    const double chord[2] = {l * (D == 0 ? place : bat_sin(v) / bat_sin(D)),
                             l * (D == 0 ? 1 - place : bat_sin(w) / bat_sin(D))};
    bat_arc_span(start, chord[0], phi + w, half[0], &made->arcs[0]);
    made->joint[0] = start[0] + chord[0] * bat_cos(phi + w);
    made->joint[1] = start[1] + chord[0] * bat_sin(phi + w);
    bat_arc_span(made->joint, chord[1], phi - v, half[1], &made->arcs[1]);
    for (int i = 0; i < 2; i++) {
        made->turn[i] = 2 * half[i];
        made->legs[i] = leg(chord[i], half[i]);
    }
    made->is_long = bat_max(fabs(half[0]), fabs(half[1])) > BAT_PI / 2;
}

batten_status bat_biarc_make(const bat_arc_chord *chord, double alpha, double beta,
                             double place, batten_biarc *out)
{
    /* Angles are known to a few eps of a turn; if no more than that is between them and those
     * of one arc, it misses the directions by no more. */
    static const double known = 16 * DBL_EPSILON;
    batten_biarc made = {.count = 2, .place = place};
    const double D = (alpha - beta) / 2, w = D * (1 - place), v = D * place;
    const double half[2] = {w - alpha, beta + v};
    if (!(fabs(D) < nearly_full && fabs(half[0]) < nearly_full && fabs(half[1]) < nearly_full))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "directions at %g and %g degree%s from the chord ask for a full circle",
                        alpha * 180 / BAT_PI, beta * 180 / BAT_PI,
                        bat_plural_real(beta * 180 / BAT_PI, 6));
    if (fabs(alpha + beta) <= known)
        make_single(chord, -D, place, &made);
    else
        make_two(chord, D, half, &made);
    const batten_status status = check_arcs(&made);
    if (status == BATTEN_OK)
        *out = made;
    return status;
}

batten_status bat_biarc_check_ends(int dimension, const double *start,
                                   const double *start_direction, const double *end,
                                   const double *end_direction)
{
    const int d = dimension;
    const double *const rows[] = {start, start_direction, end, end_direction};
    static const char *const names[] = {"start", "direction at the start", "end",
                                        "direction at the end"};
    for (int i = 0; i < 4; i++) {
        const size_t k = bat_first_not_finite(rows[i], (size_t)d);
        if (k < (size_t)d)
            return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of the %s is %g", k + 1,
                            names[i], rows[i][k]);
        if (i % 2 == 1 && bat_largest(d, rows[i]) == 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "the %s is zero", names[i]);
    }
    const double l = bat_distance(d, start, end);
    if (l == 0)
        return bat_fail(BATTEN_COINCIDENT, "start and end of the biarc coincide");
    if (!isfinite(l))
        return bat_fail(BATTEN_OVERFLOW, "the chord of the biarc is too long for a number");
    return BATTEN_OK;
}

void bat_direction(int dimension, const double *from, double *to)
{
    const int d = dimension;
    const double largest = bat_largest(d, from);
    for (int k = 0; k < d; k++)
        to[k] = from[k] / largest;
    const double norm = bat_norm(d, to);
    for (int k = 0; k < d; k++)
        to[k] /= norm;
}

batten_status batten_biarc_between(batten_ray start, batten_ray end, batten_biarc_joint joint,
                                   double place, batten_biarc *out)
{
    assert(start.point && start.direction && end.point && end.direction && out);
    const batten_status status =
        bat_biarc_check_ends(2, start.point, start.direction, end.point, end.direction);
    if (status != BATTEN_OK)
        return status;
    if (joint == BATTEN_JOINT_GIVEN && !(place > 0 && place < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the place of the joint is %g; it must be between 0 and 1", place);
    const double l = bat_distance(2, start.point, end.point);
    const double along[2] = {(end.point[0] - start.point[0]) / l,
                             (end.point[1] - start.point[1]) / l};
    const bat_arc_chord chord = {
        {start.point[0], start.point[1]}, bat_atan2(along[1], along[0]), l};
    double T0[2], T1[2];
    bat_direction(2, start.direction, T0);
    bat_direction(2, end.direction, T1);
    const double alpha = bat_turn(along, T0), beta = bat_turn(along, T1);
    return bat_biarc_make(&chord, alpha, beta,
                          joint == BATTEN_JOINT_GIVEN ? place : joint_place(alpha, beta, joint),
                          out);
}
