/* Arcs of a given radius between two curves, or in the corners of one. */
#include "base/plural.h"
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/curve_change/cut_corners.h"
#include "shape/curve_change/extend.h"
#include "spline/curve/curve.h"
#include <batten/blend.h>

#include <float.h>

/* ---- the plane of two curves ---- */

/* The control point farthest from the line through o along x (0: from o), across it. */
static batten_vec3 farthest(const batten_curve *const curves[2], batten_vec3 o, batten_vec3 x)
{
    batten_vec3 most = {0, 0, 0};
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < curves[k]->count; i++) {
            batten_vec3 way =
                bat_vec3_subtract(bat_vec3_of(3, curves[k]->points + 3 * (size_t)i), o);
            way = bat_vec3_along(way, -bat_vec3_dot(way, x), x);
            if (bat_vec3_norm(way) > bat_vec3_norm(most))
                most = way;
        }
    return most;
}

static batten_status plane_of(const batten_curve *const curves[2], double size,
                              double tolerance, batten_frame *out)
{
    *out = batten_frame_world();
    if (curves[0]->dimension == 2)
        return BATTEN_OK;
    const batten_vec3 o = bat_vec3_of(3, curves[0]->points);
    const batten_vec3 along = farthest(curves, o, (batten_vec3){0, 0, 0});
    if (!(bat_vec3_norm(along) > 0))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves are a point");
    const batten_vec3 x = bat_vec3_scale(along, 1 / bat_vec3_norm(along));
    const batten_vec3 across = farthest(curves, o, x);
    if (!(bat_vec3_norm(across) > BAT_EXACT * size))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves lie on one straight line");
    *out = (batten_frame){o, x, bat_vec3_cross(x, across)};
    const batten_vec3 z = bat_vec3_scale(out->z, 1 / bat_vec3_norm(out->z));
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < curves[k]->count; i++) {
            const batten_vec3 p = bat_vec3_of(3, curves[k]->points + 3 * (size_t)i);
            const double off = fabs(bat_vec3_dot(z, bat_vec3_subtract(p, o)));
            if (off > tolerance)
                return bat_fail(BATTEN_NOT_COMPATIBLE,
                                "the curves do not lie in one plane: a control point is %g off",
                                off);
        }
    return BATTEN_OK;
}

/* The curve in the coordinates of the plane. */
static batten_status flatten(const batten_curve *curve, const batten_frame *frame,
                             batten_curve **out)
{
    batten_frame square;
    batten_vec3 y;
    batten_curve *turned = NULL;
    if (curve->dimension == 2)
        return batten_curve_clamp(curve, out);
    batten_status status = bat_frame_square(frame, &square, &y);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 rows[3] = {square.x, y, square.z};
    batten_affine map = batten_affine_identity();
    for (int i = 0; i < 3; i++) {
        map.m[i][0] = rows[i].x;
        map.m[i][1] = rows[i].y;
        map.m[i][2] = rows[i].z;
        map.t[i] = -bat_vec3_dot(rows[i], square.origin);
    }
    batten_curve *clamped = NULL;
    status = batten_curve_clamp(curve, &clamped);
    if (status == BATTEN_OK)
        status = batten_curve_transform(clamped, &map, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(turned, 2, out);
    batten_curve_unref(turned);
    batten_curve_unref(clamped);
    return status;
}

/* ---- one arc ---- */

static batten_status point_and_slope(const batten_curve *curve, double u, batten_vec3 *p,
                                     batten_vec3 *slope)
{
    const int d = curve->dimension;
    double c[2 * 3];
    const batten_status status = batten_curve_evaluate(curve, u, 1, c);
    *p = bat_vec3_of(d, c);
    *slope = bat_vec3_of(d, c + d);
    return status;
}

typedef struct {
    batten_curve *curve;
    batten_curves_fillet_report report;
} fillet_arc;

static batten_status make_arc(const batten_curve *const curves[2], const batten_frame *frame,
                              double radius, const bat_fillet_place *place, fillet_arc *out)
{
    const batten_vec3 z = bat_vec3_scale(frame->z, place->side / bat_vec3_norm(frame->z));
    batten_vec3 p[2], slope[2];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = point_and_slope(curves[k], place->u[k], &p[k], &slope[k]);
    if (status != BATTEN_OK)
        return status;
    const double speed = bat_vec3_norm(slope[0]);
    const bat_tip tip = {.dimension = curves[0]->dimension,
                         .u = place->u[0],
                         .p = p[0],
                         .t = bat_vec3_scale(slope[0], 1 / speed),
                         .n = bat_vec3_cross(z, bat_vec3_scale(slope[0], 1 / speed)),
                         .speed = speed,
                         .curvature = 1 / radius};
    const double sine = bat_vec3_dot(z, bat_vec3_cross(slope[0], slope[1]));
    const double angle = bat_atan2(sine, bat_vec3_dot(slope[0], slope[1]));
    double none, last[3];
    batten_curve *made = NULL;
    status = bat_tip_piece(&tip, (batten_lengthening){BATTEN_EXTEND_ARC, 1}, radius * angle,
                           &none, &made);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(made, batten_curve_domain(made).b, 0, last);
    if (status != BATTEN_OK) {
        batten_curve_unref(made);
        return status;
    }
    out->report = (batten_curves_fillet_report){
        .u = {place->u[0], place->u[1]},
        .center = bat_vec3_along(p[0], radius, tip.n),
        .angle = angle,
        .gap = bat_vec3_norm(bat_vec3_subtract(bat_vec3_of(tip.dimension, last), p[1])),
        .found = place->found,
        .complete = place->complete};
    out->curve = made;
    return BATTEN_OK;
}

/* How an arc joins what is left of a curve; nothing left joins well. */
static batten_status verify_join(const batten_curve *curve, const batten_curve *arc, double u,
                                 bool before, double tolerance)
{
    const batten_interval domain = batten_curve_domain(curve);
    const double rounding = BAT_ROUNDING * (domain.b - domain.a);
    batten_curve *rest = NULL;
    batten_continuity join;
    if (before ? u <= domain.a + rounding : u >= domain.b - rounding)
        return BATTEN_OK;
    batten_curve_continuity_options options = batten_curve_continuity_defaults();
    options.gap = tolerance;
    batten_status status = before ? batten_curve_subrange(curve, domain.a, u, &rest)
                                  : batten_curve_subrange(curve, u, domain.b, &rest);
    if (status == BATTEN_OK)
        status = before ? batten_curves_continuity(rest, BATTEN_CURVE_END, arc,
                                                   BATTEN_CURVE_START, &options, &join)
                        : batten_curves_continuity(arc, BATTEN_CURVE_END, rest,
                                                   BATTEN_CURVE_START, &options, &join);
    if (status == BATTEN_OK && join.geometric < 1)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the arc joins the %s curve with a gap of %g and an angle of %g",
                          before ? "first" : "second", join.gap, join.angle);
    batten_curve_unref(rest);
    return status;
}

static batten_status check_curves(const batten_curve *const curves[2], double radius,
                                  double tolerance)
{
    if (curves[0]->dimension == 1 || curves[1]->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "functions have no corners; make their graphs");
    if (curves[0]->dimension != curves[1]->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                        curves[0]->dimension, curves[1]->dimension);
    if (!(radius > 0 && isfinite(radius)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the radius is %g, not above 0", radius);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

batten_status batten_curves_fillet(const batten_curve *first, const batten_curve *second,
                                   double radius, double tolerance,
                                   batten_curves_fillet_report *report, batten_curve **arc)
{
    assert(first && second && arc);
    const batten_curve *const curves[2] = {first, second};
    batten_curve *flat[2] = {NULL, NULL};
    fillet_arc made = {.curve = NULL};
    batten_frame frame;
    bat_fillet_place place = {{0, 0}, 1, 0, false};
    batten_status status = check_curves(curves, radius, tolerance);
    if (status != BATTEN_OK)
        return status;
    const double size = bat_max(bat_curve_size(first), bat_curve_size(second));
    status = plane_of(curves, size, tolerance, &frame);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = flatten(curves[k], &frame, &flat[k]);
    if (status == BATTEN_OK)
        status = bat_fillet_search((const batten_curve *const *)flat, radius, &place);
    if (status == BATTEN_OK)
        status = make_arc(curves, &frame, radius, &place, &made);
    const double gap = tolerance + 64 * DBL_EPSILON * (size + radius);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = verify_join(curves[k], made.curve, place.u[k], k == 0, gap);
    if (status == BATTEN_OK) {
        if (report)
            *report = made.report;
        *arc = made.curve;
    } else {
        batten_curve_unref(made.curve);
    }
    batten_curve_unref(flat[1]);
    batten_curve_unref(flat[0]);
    return status;
}

/* ---- all corners ---- */

typedef struct {
    int count;
    const double *radii;
    double tolerance;
    batten_corners_report report;
} rounding;

static batten_status round_corner(void *context, const bat_corner *corner, bat_corner_cut *out)
{
    rounding *r = context;
    const double radius = r->radii[r->count > 1 ? corner->index : 0];
    batten_curves_fillet_report report;
    if (radius == 0)
        return BATTEN_OK;
    const batten_status status = batten_curves_fillet(corner->before, corner->behind, radius,
                                                      r->tolerance, &report, &out->link);
    if (status != BATTEN_OK)
        return status;
    out->u[0] = report.u[0];
    out->u[1] = report.u[1];
    r->report.cut++;
    r->report.gap = bat_max(r->report.gap, report.gap);
    r->report.complete = r->report.complete && report.complete;
    return BATTEN_OK;
}

static batten_status check_radii(int count, const double *radii, int corners)
{
    if (count != 1 && count != corners)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there %s %d %s for %d corner%s",
                        bat_one_or_many(count, "is", "are"), count,
                        bat_one_or_many(count, "radius", "radii"), corners,
                        bat_plural(corners));
    for (int i = 0; i < count; i++)
        if (!(radii[i] >= 0 && isfinite(radii[i])))
            return bat_fail(BATTEN_BAD_ARGUMENT, "radius %d is %g, below 0", i + 1, radii[i]);
    return BATTEN_OK;
}

batten_status batten_curve_fillet(const batten_curve *curve, int radius_count,
                                  const double *radii, double tolerance,
                                  batten_corners_report *report, batten_curve **out)
{
    assert(curve && radii && out);
    const batten_curve *const curves[2] = {curve, curve};
    rounding r = {radius_count, radii, tolerance, {.complete = true}};
    const bat_cutter cutter = {round_corner, &r,
                               2 * tolerance + BAT_ROUNDING * bat_curve_size(curve)};
    batten_status status = check_curves(curves, 1, tolerance);
    if (status == BATTEN_OK)
        status = bat_curve_corner_count(curve, &r.report.corners);
    if (status == BATTEN_OK)
        status = check_radii(radius_count, radii, r.report.corners);
    if (status == BATTEN_OK)
        status = bat_curve_cut_corners(curve, &cutter, out);
    if (status == BATTEN_OK && report)
        *report = r.report;
    return status;
}
