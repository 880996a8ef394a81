/* Cylinders, cones, spheres, tori and revolutions that reach over what is on them. */
#include "body/elementary/parts.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <batten/standard.h>

static const double MARGIN = 0.05; /* of the extent */

/* u from 0 to 2 pi, v from `low` to `high`. */
static batten_status with_domain(batten_surface *made, double low, double high,
                                 batten_surface **out)
{
    batten_surface *around = NULL;
    batten_status status = batten_surface_set_domain(made, BATTEN_U, 0, 2 * BAT_PI, &around);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(around, BATTEN_V, low, high, out);
    batten_surface_unref(around);
    return status;
}

static batten_status check_radius(double radius, const char *what)
{
    if (!(radius > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the radius of the %s is %g; it must be positive",
                        what, radius);
    return BATTEN_OK;
}

/* The frame at a height above the origin. */
static batten_frame at_height(const bat_stand *stand, double height)
{
    batten_frame frame = stand->frame;
    frame.origin = bat_vec3_along(frame.origin, height, frame.z);
    return frame;
}

/* ---- cylinders and cones ---- */

batten_status bat_stand_cylinder(const bat_stand *stand, batten_surface **out)
{
    const double radius = stand->of->a;
    const batten_interval z = bat_stand_range(stand, 2);
    const double more = MARGIN * (z.b > z.a ? z.b - z.a : radius);
    const double low = z.a - more, high = z.b + more;
    const batten_frame base = at_height(stand, low);
    batten_surface *made = NULL;
    batten_status status = check_radius(radius, "cylinder");
    if (status == BATTEN_OK)
        status = batten_surface_cylinder(&base, radius, high - low, &made);
    if (status == BATTEN_OK)
        status = with_domain(made, low, high, out);
    batten_surface_unref(made);
    return status;
}

/* Heights, and the radii there with their sign: the one half of the cone where it is +. */
typedef struct {
    double low, high, at_low, at_high;
} slant;

/* The half on which the points lie, as far as they reach; to the apex when they or the face
 * reach it, else not so far, for there the surface has no normal. */
static batten_status slant_over(const bat_stand *stand, slant *over)
{
    const double a = stand->of->a, slope = bat_tan(stand->of->b);
    const batten_interval z = bat_stand_range(stand, 2);
    *over = (slant){z.a, z.b, a + z.a * slope, a + z.b * slope};
    const double half = over->at_low + over->at_high < 0 ? -1 : 1;
    over->at_low *= half;
    over->at_high *= half;
    const bool low_is_near = half * slope > 0;
    const double nearest = low_is_near ? over->at_low : over->at_high;
    if (nearest < -stand->tolerance)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the points lie on both halves of the cone: the radius runs from %g "
                        "to %g",
                        over->at_low, over->at_high);
    const bool to_apex = (nearest <= stand->tolerance || stand->of->goes_on) && slope != 0;
    const double apex = slope != 0 ? -a / slope : HUGE_VAL;
    const double extent = to_apex     ? bat_max(fabs(z.a - apex), fabs(z.b - apex))
                          : z.b > z.a ? z.b - z.a
                                      : bat_max(over->at_low, stand->tolerance);
    const double more = MARGIN * extent;
    /* From the near end toward the apex half the way at most. */
    const double less = bat_min(more, fabs((low_is_near ? z.a : z.b) - apex) / 2);
    over->low = low_is_near ? (to_apex ? apex : z.a - less) : z.a - more;
    over->high = low_is_near ? z.b + more : to_apex ? apex : z.b + less;
    over->at_low = low_is_near && to_apex ? 0 : half * (a + over->low * slope);
    over->at_high = !low_is_near && to_apex ? 0 : half * (a + over->high * slope);
    return BATTEN_OK;
}

batten_status bat_stand_cone(const bat_stand *stand, batten_surface **out)
{
    const double b = stand->of->b;
    slant over;
    batten_surface *made = NULL;
    if (!(fabs(b) < BAT_PI / 2))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the half angle of the cone is %g; it must be below a right angle", b);
    batten_status status = slant_over(stand, &over);
    if (status != BATTEN_OK)
        return status;
    const batten_frame base = at_height(stand, over.low);
    status = batten_surface_cone(&base, over.at_low, over.at_high, over.high - over.low, &made);
    if (status == BATTEN_OK)
        status = with_domain(made, over.low / bat_cos(b), over.high / bat_cos(b), out);
    batten_surface_unref(made);
    return status;
}

/* ---- spheres and tori ---- */

batten_status bat_stand_sphere(const bat_stand *stand, batten_surface **out)
{
    batten_surface *made = NULL;
    batten_status status = check_radius(stand->of->a, "sphere");
    if (status == BATTEN_OK)
        status = batten_surface_sphere(&stand->frame, stand->of->a, &made);
    if (status == BATTEN_OK)
        status = with_domain(made, -BAT_PI / 2, BAT_PI / 2, out);
    batten_surface_unref(made);
    return status;
}

/* Do the points of a torus whose tube reaches over the axis lie on its inner part, the lemon?
 * Measured by the sums of their distances from both circles of a half plane; these are alike
 * where there are no points, or they are the poles. */
static bool is_lemon(const bat_stand *stand)
{
    double apple = 0, lemon = 0;
    const double a = fabs(stand->of->a);
    for (int i = 0; i < stand->count; i++) {
        const double *p = stand->points + 3 * (size_t)i;
        const double r = bat_hypot(bat_stand_coordinate(stand, p, 0),
                                   bat_stand_coordinate(stand, p, 1)),
                     z = bat_stand_coordinate(stand, p, 2);
        apple += fabs(bat_hypot(r - a, z) - stand->of->b);
        lemon += fabs(bat_hypot(r + a, z) - stand->of->b);
    }
    /* Points on the circle where both sheets meet fit either, to the tolerance or rounding. */
    const double near = bat_max(stand->tolerance, 1e-9 * stand->of->b) * stand->count;
    const bool is_inner = stand->of->is_inner || stand->of->a < 0;
    return fabs(lemon - apple) <= near ? is_inner : lemon < apple;
}

static batten_status turn_normal(batten_surface **made)
{
    batten_surface *down = NULL;
    const batten_status status = batten_surface_reverse(*made, BATTEN_V, &down);
    return bat_surface_replace(status, made, &down);
}

/* The arc of the tube on one side of the axis, from pole to pole, turned. */
static batten_status spindle(const bat_stand *stand, batten_surface **out)
{
    const double a = fabs(stand->of->a), b = stand->of->b;
    const double to_centre = is_lemon(stand) ? -a : a, half = bat_acos(-to_centre / b);
    bat_conic tube = {.kind = BAT_ELLIPSE, .frame = stand->frame, .a = b, .b = b};
    tube.frame.origin = bat_vec3_along(stand->frame.origin, to_centre, stand->frame.x);
    tube.frame.z = bat_vec3_scale(stand->y, -1); /* so that its second axis points up */
    batten_curve *arc = NULL;
    batten_surface *made = NULL;
    batten_status status = bat_conic_between(&tube, -half, half, &arc);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(arc, stand->frame.origin, stand->frame.z, 2 * BAT_PI,
                                         &made);
    /* The normal of the parametrisation of ISO 10303-42, a + b cos v from the axis, points to
     * the axis where that is negative, and files count on it. */
    if (status == BATTEN_OK && to_centre * stand->of->a < 0)
        status = turn_normal(&made);
    if (status == BATTEN_OK)
        status = with_domain(made, -half, half, out);
    batten_surface_unref(made);
    batten_curve_unref(arc);
    return status;
}

batten_status bat_stand_torus(const bat_stand *stand, batten_surface **out)
{
    const double a = stand->of->a, b = stand->of->b;
    batten_surface *made = NULL;
    batten_status status = check_radius(b, "tube of the torus");
    if (status == BATTEN_OK && fabs(a) <= b)
        return spindle(stand, out);
    if (status == BATTEN_OK)
        status = batten_surface_torus(&stand->frame, fabs(a), b, &made);
    if (status == BATTEN_OK && a < 0)
        status = turn_normal(&made);
    if (status == BATTEN_OK)
        status = with_domain(made, 0, 2 * BAT_PI, out);
    batten_surface_unref(made);
    return status;
}

/* ---- revolutions ---- */

batten_status bat_stand_revolution(const bat_stand *stand, batten_surface **out)
{
    batten_curve *profile = batten_curve_ref(stand->of->curve);
    batten_surface *made = NULL;
    batten_status status = batten_surface_revolved(profile, stand->frame.origin, stand->frame.z,
                                                   2 * BAT_PI, &made);
    if (status == BATTEN_BAD_ARGUMENT) { /* it crosses the axis */
        batten_curve_unref(profile);
        profile = NULL;
        status = bat_stand_cut(stand, &profile);
        if (status == BATTEN_OK)
            status = batten_surface_revolved(profile, stand->frame.origin, stand->frame.z,
                                             2 * BAT_PI, &made);
    }
    if (status == BATTEN_OK) {
        const batten_interval v = batten_curve_domain(profile);
        status = with_domain(made, v.a, v.b, out);
    }
    batten_surface_unref(made);
    batten_curve_unref(profile);
    return status;
}
