/* Bilinear patches and surfaces of revolution. Source: [PT97] ch. 8.5; all are exact to
 * rounding. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"
#include <batten/standard.h>

#include <string.h>

enum { CIRCLE = 9 }; /* points of a full circle */

static batten_status unit(batten_vec3 a, batten_vec3 *out)
{
    const double norm = bat_vec3_norm(a);
    if (!isfinite(norm))
        return bat_fail(BATTEN_NOT_FINITE, "the axis is (%g, %g, %g)", a.x, a.y, a.z);
    if (norm == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the axis has no length");
    *out = (batten_vec3){a.x / norm, a.y / norm, a.z / norm};
    return BATTEN_OK;
}

/* ---- profiles ---- */

/* A profile seen from the axis: for each control point its foot on the axis and the way from
 * there. */
typedef struct {
    int count;
    double size;      /* of the coordinates seen from the origin of the axis */
    batten_vec3 axis; /* unit */
    batten_vec3 *feet, *radii;
} profile_view;

/* A point within roundoff of the axis is a pole. */
static void set_poles(profile_view *view)
{
    for (int i = 0; i < view->count; i++)
        if (bat_vec3_norm(view->radii[i]) <= 16 * 0x1p-52 * view->size)
            view->radii[i] = (batten_vec3){0, 0, 0};
}

static void view_profile(const batten_curve *profile, batten_vec3 origin, profile_view *view)
{
    const double *P = batten_curve_points(profile);
    for (int i = 0; i < view->count; i++) {
        const batten_vec3 point = {P[3 * i], P[3 * i + 1], P[3 * i + 2]};
        const batten_vec3 way = bat_vec3_subtract(point, origin);
        const double height = bat_vec3_dot(way, view->axis);
        view->feet[i] = bat_vec3_along(origin, height, view->axis);
        view->radii[i] = bat_vec3_subtract(point, view->feet[i]);
        view->size = bat_max(view->size, bat_vec3_norm(way) + bat_vec3_norm(point));
    }
    set_poles(view);
}

/* The direction from the axis of the control point that is farthest from it. */
static batten_status find_outward(const profile_view *view, batten_vec3 *outward)
{
    double farthest = 0;
    for (int i = 0; i < view->count; i++) {
        const double distance = bat_vec3_norm(view->radii[i]);
        if (distance > farthest) {
            farthest = distance;
            *outward = bat_vec3_scale(view->radii[i], 1 / distance);
        }
    }
    if (farthest == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the profile lies on the axis");
    return BATTEN_OK;
}

/* The least and largest signed distance from the axis of points of the profile. */
static batten_status measure_sides(const batten_curve *profile, batten_vec3 origin,
                                   batten_vec3 outward, double *least, double *largest)
{
    enum { PLACES = 64 }; /* to a span */
    const int p = batten_curve_degree(profile), n = batten_curve_point_count(profile);
    const double *U = batten_curve_knots(profile);
    for (int k = p; k < n; k++)
        for (int i = 0; i <= PLACES && U[k] < U[k + 1]; i++) {
            const double u = bat_min(U[k] + (U[k + 1] - U[k]) * i / PLACES, U[k + 1]);
            double at[3];
            const batten_status status = batten_curve_evaluate(profile, u, 0, at);
            if (status != BATTEN_OK)
                return status;
            const batten_vec3 way =
                bat_vec3_subtract((batten_vec3){at[0], at[1], at[2]}, origin);
            const double side = bat_vec3_dot(way, outward);
            *least = bat_min(*least, side);
            *largest = bat_max(*largest, side);
        }
    return BATTEN_OK;
}

/* A profile in a plane with the axis must stay on one side of it. One that lies in no such
 * plane may pass the axis, but cannot cross it. */
static batten_status check_sides(const batten_curve *profile, batten_vec3 origin,
                                 const profile_view *view)
{
    batten_vec3 outward = {0, 0, 0};
    batten_status status = find_outward(view, &outward);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 normal = bat_vec3_cross(view->axis, outward);
    bool may_cross = false;
    for (int i = 0; i < view->count; i++) {
        if (fabs(bat_vec3_dot(view->radii[i], normal)) > 64 * 0x1p-52 * view->size)
            return BATTEN_OK;
        may_cross |= bat_vec3_dot(view->radii[i], outward) < 0;
    }
    if (!may_cross)
        return BATTEN_OK;
    double least = 0, largest = 0;
    const double roundoff = 64 * 0x1p-52 * view->size;
    status = measure_sides(profile, origin, outward, &least, &largest);
    if (status == BATTEN_OK && least < -roundoff && largest > roundoff)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the profile crosses the axis: it reaches from %g to %g across it",
                        least, largest);
    return status;
}

/* ---- revolution ---- */

static void fill_revolved(const batten_curve *profile, const profile_view *view,
                          const batten_curve *arc, bat_nurbs *made)
{
    const double *w = batten_curve_weights(profile);
    double *point = made->points, *weight = made->weights;
    for (int i = 0; i < arc->count; i++)
        for (int j = 0; j < view->count; j++) {
            const batten_vec3 r = view->radii[j], t = bat_vec3_cross(view->axis, r);
            const batten_vec3 at =
                bat_vec3_along(bat_vec3_along(view->feet[j], arc->points[2 * i], r),
                               arc->points[2 * i + 1], t);
            *point++ = at.x;
            *point++ = at.y;
            *point++ = at.z;
            *weight++ = arc->weights[i] * (w ? w[j] : 1);
        }
    memcpy(made->axes[BATTEN_U].knots, arc->knots,
           ((size_t)arc->count + 3) * sizeof *arc->knots);
    memcpy(made->axes[BATTEN_V].knots, batten_curve_knots(profile),
           (size_t)batten_curve_knot_count(profile) * sizeof(double));
}

static batten_status revolve(const batten_curve *profile, const profile_view *view,
                             const batten_curve *arc, batten_surface **out)
{
    const bat_nurbs_shape shape = {3,
                                   {2, batten_curve_degree(profile)},
                                   {arc->count, view->count},
                                   {false, batten_curve_is_periodic(profile)},
                                   true};
    bat_nurbs *made;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    fill_revolved(profile, view, arc, made);
    return bat_nurbs_finish(made, out);
}

static batten_status revolve_about(const batten_curve *profile, batten_vec3 origin,
                                   batten_vec3 axis, const batten_curve *arc,
                                   batten_surface **out)
{
    const size_t count = (size_t)batten_curve_point_count(profile);
    profile_view view = {.count = (int)count, .axis = axis};
    view.feet = bat_array(count, sizeof *view.feet);
    view.radii = bat_array(count, sizeof *view.radii);
    batten_status status = view.feet && view.radii ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        view_profile(profile, origin, &view);
        status = check_sides(profile, origin, &view);
    }
    if (status == BATTEN_OK)
        status = revolve(profile, &view, arc, out);
    bat_release(view.feet);
    bat_release(view.radii);
    return status;
}

batten_status batten_surface_revolved(const batten_curve *profile, batten_vec3 origin,
                                      batten_vec3 axis, double angle, batten_surface **out)
{
    assert(profile && out);
    batten_curve *arc = NULL;
    if (batten_curve_dimension(profile) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a profile of dimension %d cannot be turned about an axis in space",
                        batten_curve_dimension(profile));
    if (!isfinite(bat_vec3_norm(origin)))
        return bat_fail(BATTEN_NOT_FINITE, "the origin of the axis is (%g, %g, %g)", origin.x,
                        origin.y, origin.z);
    batten_status status = unit(axis, &axis);
    if (status == BATTEN_OK)
        status = batten_curve_arc(1, angle, &arc);
    if (status == BATTEN_OK)
        status = revolve_about(profile, origin, axis, arc, out);
    batten_curve_unref(arc);
    return status;
}

/* ---- standard surfaces ---- */

static batten_status check_length(double value, const char *what, bool may_vanish)
{
    if (!isfinite(value))
        return bat_fail(BATTEN_NOT_FINITE, "the %s is %g", what, value);
    if (value < 0 || (value == 0 && !may_vanish))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s is %g; it must be positive", what, value);
    return BATTEN_OK;
}

/* Turn the curve through (r, z) pairs, in the frame's xz-plane, about the frame's normal. */
static batten_status revolve_profile(const batten_frame *frame, int degree, int count,
                                     double (*rz)[2], const double *weights,
                                     const double *knots, batten_surface **out)
{
    double points[CIRCLE * 3];
    batten_frame squared = *frame;
    batten_vec3 y;
    batten_curve *profile = NULL;
    batten_status status = bat_frame_square(frame, &squared, &y);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < count; i++) {
        const batten_vec3 at = bat_vec3_along(
            bat_vec3_along(squared.origin, rz[i][0], squared.x), rz[i][1], squared.z);
        memcpy(points + 3 * i, (const double[3]){at.x, at.y, at.z}, 3 * sizeof *points);
    }
    status = batten_curve_create((batten_points){3, count, points}, degree, weights, knots,
                                 &profile);
    if (status == BATTEN_OK)
        status = batten_surface_revolved(profile, squared.origin, squared.z, 2 * BAT_PI, out);
    batten_curve_unref(profile);
    return status;
}

static const double line_knots[4] = {0, 0, 1, 1};

batten_status batten_surface_cylinder(const batten_frame *frame, double radius, double height,
                                      batten_surface **out)
{
    const batten_status status = check_length(radius, "radius", false);
    return status == BATTEN_OK ? batten_surface_cone(frame, radius, radius, height, out)
                               : status;
}

batten_status batten_surface_cone(const batten_frame *frame, double r0, double r1,
                                  double height, batten_surface **out)
{
    assert(frame && out);
    batten_status status = check_length(r0, "radius at the origin", true);
    if (status == BATTEN_OK)
        status = check_length(r1, "radius at the height", r0 > 0);
    if (status == BATTEN_OK)
        status = check_length(height, "height", false);
    double rz[2][2] = {{r0, 0}, {r1, height}};
    return status == BATTEN_OK ? revolve_profile(frame, 1, 2, rz, NULL, line_knots, out)
                               : status;
}

batten_status batten_surface_sphere(const batten_frame *frame, double radius,
                                    batten_surface **out)
{
    assert(frame && out);
    static const double knots[8] = {0, 0, 0, 0.5, 0.5, 1, 1, 1};
    const double r = radius, s = sqrt(0.5), weights[5] = {1, s, 1, s, 1};
    double rz[5][2] = {{0, -r}, {r, -r}, {r, 0}, {r, r}, {0, r}};
    const batten_status status = check_length(radius, "radius", false);
    return status == BATTEN_OK ? revolve_profile(frame, 2, 5, rz, weights, knots, out) : status;
}

batten_status batten_surface_torus(const batten_frame *frame, double major, double minor,
                                   batten_surface **out)
{
    assert(frame && out);
    batten_status status = check_length(major, "major radius", false);
    if (status == BATTEN_OK)
        status = check_length(minor, "minor radius", false);
    if (status == BATTEN_OK && !(major > minor))
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the major radius is %g, not above the minor one, %g", major, minor);
    batten_curve *arc = NULL;
    if (status == BATTEN_OK)
        status = batten_curve_circle(1, BATTEN_CIRCLE_SQUARE_9, &arc);
    if (status != BATTEN_OK)
        return status;
    double rz[CIRCLE][2];
    for (int i = 0; i < CIRCLE; i++) {
        rz[i][0] = major + minor * arc->points[2 * i];
        rz[i][1] = minor * arc->points[2 * i + 1];
    }
    status = revolve_profile(frame, 2, CIRCLE, rz, arc->weights, arc->knots, out);
    batten_curve_unref(arc);
    return status;
}

batten_status batten_surface_bilinear(batten_vec3 p00, batten_vec3 p10, batten_vec3 p01,
                                      batten_vec3 p11, batten_surface **out)
{
    assert(out);
    const double points[12] = {p00.x, p00.y, p00.z, p01.x, p01.y, p01.z,
                               p10.x, p10.y, p10.z, p11.x, p11.y, p11.z};
    const batten_axis axis = {1, 2, line_knots, false};
    return batten_surface_create(3, &axis, &axis, points, NULL, out);
}
