/* Sweeps that are NURBS surfaces: every control point is made of one of each curve. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"
#include <batten/approximate.h>
#include <batten/skin.h>
#include <batten/sweep.h>

#include <string.h>

/* ---- products of curves ---- */

/* How control points of two curves make one of the surface. */
typedef batten_vec3 (*blend)(batten_vec3 p, batten_vec3 q, const void *context);

static void copy_knots(const batten_curve *curve, bat_nurbs *made, batten_direction direction)
{
    memcpy(made->axes[direction].knots, batten_curve_knots(curve),
           (size_t)batten_curve_knot_count(curve) * sizeof(double));
}

/* The surface with control points product(P[i], Q[j]) and weights w[i] w[j]. */
static batten_status multiply_curves(const batten_curve *along_u, const batten_curve *along_v,
                                     blend product, const void *context, batten_surface **out)
{
    const double *P = along_u->points, *Q = along_v->points;
    const double *wp = along_u->weights, *wq = along_v->weights;
    const double size = (double)along_u->count * along_v->count;
    if (size > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d by %d control points make a surface of %.3g; the limit is %d",
                        along_u->count, along_v->count, size, (int)BAT_MAX_POINTS);
    const bat_nurbs_shape shape = {3,
                                   {along_u->degree, along_v->degree},
                                   {along_u->count, along_v->count},
                                   {along_u->periodic, along_v->periodic},
                                   wp || wq};
    bat_nurbs *made;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    double *point = made->points, *weight = made->weights;
    for (int i = 0; i < along_u->count; i++)
        for (int j = 0; j < along_v->count; j++) {
            const batten_vec3 at =
                product(bat_vec3_of(along_u->dimension, P + i * along_u->dimension),
                        bat_vec3_of(along_v->dimension, Q + j * along_v->dimension), context);
            *point++ = at.x;
            *point++ = at.y;
            *point++ = at.z;
            if (weight)
                *weight++ = (wp ? wp[i] : 1) * (wq ? wq[j] : 1);
        }
    copy_knots(along_u, made, BATTEN_U);
    copy_knots(along_v, made, BATTEN_V);
    return bat_nurbs_finish(made, out);
}

/* A curve all of whose control points are the same leaves no surface. */
static batten_status check_extent(const batten_curve *curve, const char *name)
{
    const int d = curve->dimension;
    for (int i = 1; i < curve->count; i++)
        if (bat_distance(d, curve->points, curve->points + i * d) > 0)
            return BATTEN_OK;
    return bat_fail(BATTEN_COINCIDENT, "the %s is a point, (%g, %g, %g)", name,
                    curve->points[0], d > 1 ? curve->points[1] : 0,
                    d > 2 ? curve->points[2] : 0);
}

static double width(const batten_surface *s, batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(s, direction);
    return domain.b - domain.a;
}

/* Does the surface have area here? By the sine of the angle between its directions, neither of
 * which may be nothing beside the whole. */
static batten_status has_area(const batten_surface *s, double u, double v, bool *found)
{
    double d[9];
    const batten_status status = batten_surface_evaluate(s, u, v, 1, d);
    const double a = bat_norm(3, d + 3), b = bat_norm(3, d + 6);
    const batten_box box = batten_surface_box(s);
    const double least = BAT_ROUNDING * bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    if (status != BATTEN_OK ||
        !(a * width(s, BATTEN_U) > least && b * width(s, BATTEN_V) > least))
        return status;
    for (int c = 0; c < 3; c++) {
        d[3 + c] /= a;
        d[6 + c] /= b;
    }
    *found = bat_vec3_norm(bat_vec3_cross(bat_vec3_of(3, d + 3), bat_vec3_of(3, d + 6))) >
             BAT_LEAST_SINE;
    return BATTEN_OK;
}

/* Takes back a surface whose directions are parallel wherever they are looked at: at 9 places
 * of each span that no symmetry prefers. */
static batten_status check_area(batten_surface **surface, const char *why)
{
    static const double places[3] = {0.2371, 0.5219, 0.8443};
    const batten_surface *s = *surface;
    const int m = batten_surface_spans(s, BATTEN_U, NULL),
              n = batten_surface_spans(s, BATTEN_V, NULL);
    double *u = bat_array((size_t)m, sizeof *u), *v = bat_array((size_t)n, sizeof *v);
    batten_status status = u && v ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    bool found = false;
    if (status == BATTEN_OK) {
        batten_surface_spans(s, BATTEN_U, u);
        batten_surface_spans(s, BATTEN_V, v);
    }
    for (int i = 0; i < 3 * (m - 1) && !found && status == BATTEN_OK; i++)
        for (int j = 0; j < 3 * (n - 1) && !found && status == BATTEN_OK; j++) {
            const double x = places[i % 3], y = places[j % 3];
            status = has_area(s, (1 - x) * u[i / 3] + x * u[i / 3 + 1],
                              (1 - y) * v[j / 3] + y * v[j / 3 + 1], &found);
        }
    bat_release(v);
    bat_release(u);
    if (status == BATTEN_OK && !found)
        status = bat_fail(BATTEN_COINCIDENT, "the surface has no area: %s", why);
    if (status != BATTEN_OK) {
        batten_surface_unref(*surface);
        *surface = NULL;
    }
    return status;
}

/* ---- translational ---- */

static batten_vec3 translate(batten_vec3 p, batten_vec3 q, const void *context)
{
    const batten_vec3 *start = context;
    return bat_vec3_add(p, bat_vec3_subtract(q, *start));
}

batten_status batten_surface_translational(const batten_curve *curve, const batten_curve *path,
                                           batten_surface **out)
{
    assert(curve && path && out);
    double start[3];
    batten_status status = check_extent(curve, "curve");
    if (status == BATTEN_OK)
        status = check_extent(path, "path");
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(path, batten_curve_domain(path).a, 0, start);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 from = bat_vec3_of(path->dimension, start);
    status = multiply_curves(curve, path, translate, &from, out);
    return status == BATTEN_OK ? check_area(out, "the curve and the path lie along one line")
                               : status;
}

/* ---- swung ---- */

static batten_status check_dimension(const batten_curve *curve, const char *name)
{
    if (curve->dimension < 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the %s has %d coordinate, and needs 2", name,
                        curve->dimension);
    return BATTEN_OK;
}

/* Does coordinate `axis` of a curve in space vanish all along? */
static batten_status check_plane(const batten_curve *curve, int axis, const char *name)
{
    const double size = bat_largest(3 * curve->count, curve->points);
    for (int i = 0; i < curve->count; i++)
        if (fabs(curve->points[3 * i + axis]) > BAT_ROUNDING * size)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "control point %d of the %s has %c = %g: it must lie in the "
                            "%s-plane",
                            i + 1, name, axis == 1 ? 'y' : 'z', curve->points[3 * i + axis],
                            axis == 1 ? "xz" : "xy");
    return BATTEN_OK;
}

/* A profile as a curve of space in the xz-plane. */
static batten_status to_profile(const batten_curve *curve, batten_curve **out)
{
    static const batten_affine rise = {{{1, 0, 0}, {0, 0, 0}, {0, 1, 0}}, {0, 0, 0}};
    if (curve->dimension == 3) {
        *out = batten_curve_ref(curve);
        return BATTEN_OK;
    }
    batten_curve *space = NULL;
    batten_status status = batten_curve_to_dimension(curve, 3, &space);
    if (status == BATTEN_OK)
        status = batten_curve_transform(space, &rise, out);
    batten_curve_unref(space);
    return status;
}

static batten_vec3 swing(batten_vec3 p, batten_vec3 q, const void *context)
{
    const double *factor = context;
    return (batten_vec3){*factor * p.x * q.x, *factor * p.x * q.y, p.z};
}

static batten_status look_at_axis(const batten_curve *profile, const batten_curve *trajectory,
                                  batten_surface_swung_report *out)
{
    enum { PLACES = 64 };
    const double *P = profile->points, *T = trajectory->knots;
    batten_surface_swung_report found = {P[0], P[0], HUGE_VAL};
    for (int i = 0; i < profile->count; i++) {
        found.least_x = bat_min(found.least_x, P[3 * i]);
        found.largest_x = bat_max(found.largest_x, P[3 * i]);
    }
    for (int k = trajectory->degree; k < trajectory->count; k++)
        for (int i = 0; i <= PLACES && T[k] < T[k + 1]; i++) {
            double at[3];
            const double s = (double)i / PLACES;
            const batten_status status =
                batten_curve_evaluate(trajectory, (1 - s) * T[k] + s * T[k + 1], 0, at);
            if (status != BATTEN_OK)
                return status;
            found.least_radius = bat_min(found.least_radius, bat_norm(2, at));
        }
    *out = found;
    return BATTEN_OK;
}

static batten_status swing_both(const batten_curve *profile, const batten_curve *trajectory,
                                double factor, batten_surface_swung_report *report,
                                batten_surface **out)
{
    batten_surface_swung_report found;
    batten_status status = check_plane(profile, 1, "profile");
    if (status == BATTEN_OK)
        status = check_plane(trajectory, 2, "trajectory");
    if (status == BATTEN_OK)
        status = check_extent(profile, "profile");
    if (status == BATTEN_OK)
        status = check_extent(trajectory, "trajectory");
    if (status == BATTEN_OK)
        status = look_at_axis(profile, trajectory, &found);
    if (status == BATTEN_OK && found.least_x == 0 && found.largest_x == 0)
        status = bat_fail(BATTEN_COINCIDENT, "the profile lies on the axis");
    if (status == BATTEN_OK)
        status = multiply_curves(profile, trajectory, swing, &factor, out);
    if (status == BATTEN_OK)
        status = check_area(out, "the profile lies on the axis, or swings within one line");
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}

batten_status batten_surface_swung(const batten_curve *profile, const batten_curve *trajectory,
                                   double factor, batten_surface_swung_report *report,
                                   batten_surface **out)
{
    assert(profile && trajectory && out);
    if (!isfinite(factor))
        return bat_fail(BATTEN_NOT_FINITE, "the factor is %g", factor);
    if (factor <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the factor is %g, not above 0", factor);
    batten_curve *raised = NULL, *level = NULL;
    batten_status status = check_dimension(profile, "profile");
    if (status == BATTEN_OK)
        status = check_dimension(trajectory, "trajectory");
    if (status == BATTEN_OK)
        status = to_profile(profile, &raised);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(trajectory, 3, &level);
    if (status == BATTEN_OK)
        status = swing_both(raised, level, factor, report, out);
    batten_curve_unref(level);
    batten_curve_unref(raised);
    return status;
}

/* ---- straight lines through a curve ---- */

static batten_status moved(const batten_curve *curve, batten_vec3 along, double by,
                           batten_curve **out)
{
    const batten_affine map =
        batten_affine_translation(by * along.x, by * along.y, by * along.z);
    return batten_curve_transform(curve, &map, out);
}

/* The surface between two copies of a curve, with v from a to b. */
static batten_status surface_between(const batten_curve *low, const batten_curve *high,
                                     double a, double b, batten_surface **out)
{
    batten_surface *plain = NULL;
    batten_status status = batten_surface_ruled(low, high, &plain);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(plain, BATTEN_V, a, b, out);
    batten_surface_unref(plain);
    return status;
}

batten_status batten_surface_tabulated(const batten_curve *curve, batten_vec3 direction,
                                       double from, double to, batten_surface **out)
{
    assert(curve && out);
    const double norm = bat_vec3_norm(direction);
    if (!isfinite(norm) || !isfinite(from) || !isfinite(to))
        return bat_fail(BATTEN_NOT_FINITE,
                        "the lines cannot go along (%g, %g, %g) from %g to %g", direction.x,
                        direction.y, direction.z, from, to);
    if (norm == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the direction of the lines has no length");
    if (from >= to)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the lines begin at %g and end at %g", from, to);
    const batten_vec3 along = bat_vec3_scale(direction, 1 / norm);
    batten_curve *space = NULL, *low = NULL, *high = NULL;
    batten_status status = check_extent(curve, "curve");
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(curve, 3, &space);
    if (status == BATTEN_OK)
        status = moved(space, along, from, &low);
    if (status == BATTEN_OK)
        status = moved(space, along, to, &high);
    if (status == BATTEN_OK)
        status = surface_between(low, high, from, to, out);
    if (status == BATTEN_OK)
        status = check_area(out, "the curve lies along its lines");
    batten_curve_unref(high);
    batten_curve_unref(low);
    batten_curve_unref(space);
    return status;
}

batten_status batten_surface_conical(const batten_curve *curve, batten_vec3 apex,
                                     batten_surface **out)
{
    assert(curve && out);
    if (!isfinite(bat_vec3_norm(apex)))
        return bat_fail(BATTEN_NOT_FINITE, "the apex is (%g, %g, %g)", apex.x, apex.y, apex.z);
    const batten_affine collapse = {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
                                    {apex.x, apex.y, apex.z}};
    batten_curve *space = NULL, *tip = NULL;
    batten_status status = check_extent(curve, "curve");
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(curve, 3, &space);
    if (status == BATTEN_OK)
        status = batten_curve_transform(space, &collapse, &tip);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(space, tip, out);
    if (status == BATTEN_OK)
        status = check_area(out, "the curve lies on a line through the apex");
    batten_curve_unref(tip);
    batten_curve_unref(space);
    return status;
}

/* ---- ruled, by arc length ---- */

batten_status batten_surface_ruled_by_length(const batten_curve *first,
                                             const batten_curve *second, double tolerance,
                                             double *error, batten_surface **out)
{
    assert(first && second && out);
    const int d = bat_max_int(first->dimension, second->dimension);
    batten_curve *given[2] = {NULL, NULL}, *even[2] = {NULL, NULL};
    batten_curve_even_speed_report report[2] = {{.error = 0}, {.error = 0}};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = batten_curve_to_dimension(k == 0 ? first : second, d, &given[k]);
        if (status == BATTEN_OK)
            status = batten_curve_even_speed(given[k], tolerance, &report[k], &even[k]);
    }
    if (status == BATTEN_OK)
        status = batten_surface_ruled(even[0], even[1], out);
    if (status == BATTEN_OK && error)
        *error = bat_max(report[0].error, report[1].error);
    for (int k = 0; k < 2; k++) {
        batten_curve_unref(even[k]);
        batten_curve_unref(given[k]);
    }
    return status;
}
