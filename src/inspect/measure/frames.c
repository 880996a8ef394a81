/* Frames along curves: those that turn least, those of Frenet, and the turn of closed ones. */
#include "inspect/measure/frames.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"
#include <batten/curvature.h>
#include <batten/measure.h>

#include <float.h>
#include <string.h>

/* How finely a span is walked: the error of double reflections falls with the fourth power of
 * the step; for a quarter of a helix 64 steps leave 1e-7 radians. */
enum { STEPS_PER_SPAN = 64, MOST_STEPS = 1 << 14 };

typedef struct {
    batten_vec3 point, tangent, second;
} spine_place;

static batten_status place_at(const batten_curve *spine, double u, spine_place *out)
{
    const int d = batten_curve_dimension(spine);
    double values[9];
    const batten_status status = batten_curve_evaluate(spine, u, 2, values);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 first = bat_vec3_of(d, values + d);
    const double speed = bat_vec3_norm(first);
    if (!(speed > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the spine has no tangent at %.17g", u);
    *out = (spine_place){bat_vec3_of(d, values), bat_vec3_scale(first, 1 / speed),
                         bat_vec3_scale(bat_vec3_of(d, values + 2 * d), 1 / speed)};
    return BATTEN_OK;
}

/* v without what lies along the unit vector t, of length one; zero stays zero. */
static batten_vec3 across(batten_vec3 v, batten_vec3 t)
{
    const batten_vec3 rest = bat_vec3_along(v, -bat_vec3_dot(v, t), t);
    const double length = bat_vec3_norm(rest);
    return length > 0 ? bat_vec3_scale(rest, 1 / length) : rest;
}

/* The first frame: x is the axis of the world that lies most across the tangent, the first of
 * equals. */
static batten_vec3 first_axis(batten_vec3 t)
{
    const double x = fabs(t.x), y = fabs(t.y), z = fabs(t.z);
    if (x <= y && x <= z)
        return across((batten_vec3){1, 0, 0}, t);
    return across(y <= z ? (batten_vec3){0, 1, 0} : (batten_vec3){0, 0, 1}, t);
}

/* v mirrored in the plane at right angles to n, whose square need be no number. */
static batten_vec3 reflect(batten_vec3 v, batten_vec3 n)
{
    const double length = bat_vec3_norm(n);
    if (!(length > 0))
        return v;
    const batten_vec3 unit = {n.x / length, n.y / length, n.z / length};
    return bat_vec3_along(v, -2 * bat_vec3_dot(unit, v), unit);
}

/* One step of the double reflection: the axis at `to` that turned least from `x` at `from`. */
batten_vec3 bat_frame_carry(batten_vec3 from, batten_vec3 from_tangent, batten_vec3 to,
                            batten_vec3 to_tangent, batten_vec3 x)
{
    const batten_vec3 chord = bat_vec3_subtract(to, from);
    const batten_vec3 axis = reflect(x, chord), tangent = reflect(from_tangent, chord);
    const batten_vec3 carried = reflect(axis, bat_vec3_subtract(to_tangent, tangent));
    return across(carried, to_tangent); /* rounding does not add up */
}

static batten_vec3 carry(const spine_place *from, const spine_place *to, batten_vec3 x)
{
    return bat_frame_carry(from->point, from->tangent, to->point, to->tangent, x);
}

/* Walk from *at to `to` in equal steps, so many in each part of a span; `x` turns with it. */
static batten_status walk(const batten_curve *spine, const double *knots, int knot_count,
                          int steps, double from, double to, spine_place *here, batten_vec3 *x)
{
    for (int span = 0; span + 1 < knot_count; span++) {
        const double a = bat_max(from, knots[span]), b = bat_min(to, knots[span + 1]);
        for (int i = 1; i <= steps && a < b; i++) {
            spine_place next;
            const double s = (double)i / steps;
            const batten_status status = place_at(spine, (1 - s) * a + s * b, &next);
            if (status != BATTEN_OK)
                return status;
            *x = carry(here, &next, *x);
            *here = next;
        }
    }
    return BATTEN_OK;
}

static batten_status minimising(const batten_curve *spine, int steps, int count,
                                const double *at, batten_frame *frames)
{
    const int knot_count = batten_curve_spans(spine, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(spine, knots);
    double u = knots[0];
    spine_place here;
    batten_status status = place_at(spine, u, &here);
    batten_vec3 x = {0, 0, 0};
    if (status == BATTEN_OK)
        x = first_axis(here.tangent);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = walk(spine, knots, knot_count, steps, u, at[k], &here, &x);
        u = at[k];
        frames[k] = (batten_frame){here.point, x, here.tangent};
    }
    bat_release(knots);
    return status;
}

static batten_status frenet(const batten_curve *spine, double u, batten_frame *frame)
{
    spine_place here;
    const batten_status status = place_at(spine, u, &here);
    if (status != BATTEN_OK)
        return status;
    /* Where the spine bends little the first difference has few digits left: once more. */
    const batten_vec3 x = across(across(here.second, here.tangent), here.tangent);
    const batten_vec3 bent = bat_vec3_cross(here.tangent, here.second);
    /* Below, the direction of the normal is the rounding of the second derivative. */
    if (!(bat_vec3_norm(bent) > 64 * DBL_EPSILON * bat_vec3_norm(here.second)))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the spine is straight at %.17g: it has no Frenet frame there", u);
    *frame = (batten_frame){here.point, x, here.tangent};
    return BATTEN_OK;
}

static batten_status fixed(const batten_curve *spine, int count, const double *at,
                           batten_frame *frames)
{
    spine_place first, here;
    batten_status status = place_at(spine, batten_curve_domain(spine).a, &first);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = place_at(spine, at[k], &here);
        frames[k] = (batten_frame){here.point, first_axis(first.tangent), first.tangent};
    }
    return status;
}

/* ---- closed spines ---- */

/* The angle about z from the x of one frame to that of another, (-pi, pi]. */
static double angle_between(const batten_frame *from, const batten_frame *to)
{
    const batten_vec3 y = bat_vec3_cross(to->z, from->x);
    return bat_atan2(bat_vec3_dot(to->x, y), bat_vec3_dot(to->x, from->x));
}

static void turn_frame(batten_frame *frame, double angle)
{
    const batten_vec3 y = bat_vec3_cross(frame->z, frame->x);
    frame->x = bat_vec3_along(bat_vec3_scale(frame->x, bat_cos(angle)), bat_sin(angle), y);
}

/* Ends that meet with one tangent. */
static batten_status check_round(const batten_curve *spine)
{
    const batten_interval domain = batten_curve_domain(spine);
    const int d = batten_curve_dimension(spine);
    const double size =
        bat_largest(batten_curve_point_count(spine) * d, batten_curve_points(spine));
    spine_place a, b;
    batten_status status = place_at(spine, domain.a, &a);
    if (status == BATTEN_OK)
        status = place_at(spine, domain.b, &b);
    if (status != BATTEN_OK)
        return status;
    const double gap = bat_vec3_norm(bat_vec3_subtract(a.point, b.point));
    const double bend = bat_vec3_norm(bat_vec3_subtract(a.tangent, b.tangent));
    /* Ends that are one are so to rounding; a tangent loses half of the digits to a knot. */
    if (gap > 1e-9 * size || bend > 1e-6)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the spine does not close smoothly: its ends are %g apart, their "
                        "directions %g radians",
                        gap, bend);
    return BATTEN_OK;
}

/* What a round is missed by is turned back evenly by arc length. */
static batten_status closing(const batten_curve *spine, int count, const double *at,
                             batten_frame *frames)
{
    const batten_interval domain = batten_curve_domain(spine);
    const double ends[2] = {domain.a, domain.b};
    batten_frame round[2];
    double length = 0, so_far = 0, step = 0;
    batten_status status = check_round(spine);
    if (status == BATTEN_OK)
        status = minimising(spine, STEPS_PER_SPAN, 2, ends, round);
    if (status == BATTEN_OK)
        status = minimising(spine, STEPS_PER_SPAN, count, at, frames);
    const double size =
        bat_largest(batten_curve_point_count(spine) * batten_curve_dimension(spine),
                    batten_curve_points(spine));
    /* Lengths to twelve digits: the angle is shared out in proportion to them. */
    const double fine = 1e-12 * size;
    if (status == BATTEN_OK)
        status = batten_curve_length(spine, fine, NULL, &length);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = batten_curve_length_between(spine, k ? at[k - 1] : domain.a, at[k], fine, NULL,
                                             &step);
        so_far += step;
        turn_frame(&frames[k], -angle_between(&round[0], &round[1]) * (so_far / length));
    }
    return status;
}

static batten_status check_places(const batten_curve *spine, int count, const double *at)
{
    const batten_interval domain = batten_curve_domain(spine);
    if (count < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d frames are asked for", count);
    const batten_status status = bat_parameters_check(count, at);
    if (status == BATTEN_OK && (at[0] < domain.a || at[count - 1] > domain.b))
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "the places %g to %g are not all on the spine, %g to %g", at[0],
                        at[count - 1], domain.a, domain.b);
    return status;
}

batten_status batten_curve_frames(const batten_curve *spine, int count, const double *at,
                                  batten_frame_kind kind, batten_frame *frames)
{
    batten_status status = check_places(spine, count, at);
    if (status != BATTEN_OK)
        return status;
    batten_frame *made = bat_array((size_t)count, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    if (kind == BATTEN_FRAME_FIXED)
        status = fixed(spine, count, at, made);
    else if (kind == BATTEN_FRAME_ROTATION_MINIMISING)
        status = minimising(spine, STEPS_PER_SPAN, count, at, made);
    else if (kind == BATTEN_FRAME_CLOSING)
        status = closing(spine, count, at, made);
    else
        for (int k = 0; status == BATTEN_OK && k < count; k++)
            status = frenet(spine, at[k], &made[k]);
    if (status == BATTEN_OK)
        memcpy(frames, made, (size_t)count * sizeof *frames);
    bat_release(made);
    return status;
}

batten_status batten_curve_minimising_frames(const batten_curve *spine, int count,
                                             const double *at, double tolerance, double *error,
                                             batten_frame *frames)
{
    batten_status status = check_places(spine, count, at);
    if (status == BATTEN_OK && !(tolerance > 0 && isfinite(tolerance)))
        status = bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    if (status != BATTEN_OK)
        return status;
    batten_frame *both = bat_array(2 * (size_t)count, sizeof *both);
    if (!both)
        return BATTEN_OUT_OF_MEMORY;
    batten_frame *fine = both, *coarse = both + count;
    double miss = HUGE_VAL;
    status = minimising(spine, 8, count, at, fine);
    for (int steps = 16; status == BATTEN_OK && miss > tolerance && steps <= MOST_STEPS;
         steps *= 2) {
        batten_frame *const before = fine;
        fine = coarse;
        coarse = before;
        status = minimising(spine, steps, count, at, fine);
        miss = 0;
        for (int k = 0; status == BATTEN_OK && k < count; k++)
            miss = bat_max(miss, fabs(angle_between(&coarse[k], &fine[k])));
    }
    if (status == BATTEN_OK && miss > tolerance)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the frames still turn by %g with %d steps for each span", miss,
                          MOST_STEPS);
    if (status == BATTEN_OK) {
        memcpy(frames, fine, (size_t)count * sizeof *frames);
        if (error)
            *error = miss;
    }
    bat_release(both);
    return status;
}

batten_status batten_curve_holonomy(const batten_curve *curve, double tolerance, double *error,
                                    double *angle)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double ends[2] = {domain.a, domain.b};
    batten_frame frames[2];
    double miss;
    batten_status status = check_round(curve);
    if (status == BATTEN_OK)
        status = batten_curve_minimising_frames(curve, 2, ends, tolerance, &miss, frames);
    if (status != BATTEN_OK)
        return status;
    *angle = angle_between(&frames[0], &frames[1]);
    if (error)
        *error = miss;
    return BATTEN_OK;
}
