/* Unbounded surfaces as NURBS that reach over what is on them: planes, extrusions, offsets. */
#include "body/elementary/parts.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"
#include <batten/nearest.h>
#include <batten/offset.h>
#include <batten/skin.h>

#include <string.h>

/* So much of its extent a surface reaches farther than its points. */
static const double MARGIN = 0.05;

/* ---- planes ---- */

static batten_status plane(const bat_stand *stand, batten_surface **out)
{
    batten_interval r[2] = {bat_stand_range(stand, 0), bat_stand_range(stand, 1)};
    double more = MARGIN * bat_max(r[0].b - r[0].a, r[1].b - r[1].a);
    if (!(more > 0)) /* one point: any size will do that can be told from it */
        more = bat_max(stand->tolerance, 1e-6 * bat_max(fabs(r[0].a), fabs(r[1].a)));
    if (!(more > 0))
        more = 1;
    double knots[2][4], points[12];
    for (int k = 0; k < 2; k++) {
        knots[k][0] = knots[k][1] = r[k].a - more;
        knots[k][2] = knots[k][3] = r[k].b + more;
    }
    for (int i = 0; i < 4; i++) {
        const batten_vec3 p =
            bat_vec3_along(bat_vec3_along(stand->frame.origin, knots[0][i & 2], stand->frame.x),
                           knots[1][2 * (i & 1)], stand->y);
        memcpy(points + 3 * i, (const double[3]){p.x, p.y, p.z}, 3 * sizeof *points);
    }
    const batten_axis u = {1, 2, knots[0], false}, v = {1, 2, knots[1], false};
    return batten_surface_create(3, &u, &v, points, NULL, out);
}

/* ---- extrusions ---- */

/* curve + v z with v as far as any point can ask for: the curve may lie anywhere along z. */
static batten_status extrusion(const bat_stand *stand, batten_surface **out)
{
    const batten_curve *curve = stand->of->curve;
    const batten_vec3 z = stand->of->frame.z;
    const double length = bat_vec3_norm(z);
    const bat_stand ends = {.frame = stand->frame,
                            .y = stand->y,
                            .count = batten_curve_point_count(curve),
                            .points = batten_curve_points(curve)};
    const batten_interval over = bat_stand_range(stand, 2), of = bat_stand_range(&ends, 2);
    double low = (over.a - of.b) / length, high = (over.b - of.a) / length;
    const double more = high > low ? MARGIN * (high - low) : 1;
    low -= more;
    high += more;

    const batten_affine start = batten_affine_translation(low * z.x, low * z.y, low * z.z);
    const batten_interval domain = batten_curve_domain(curve);
    batten_curve *base = NULL;
    batten_surface *made = NULL, *along = NULL;
    batten_status status = batten_curve_transform(curve, &start, &base);
    if (status == BATTEN_OK)
        status = batten_surface_extruded(base, bat_vec3_scale(z, high - low), &made);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(made, BATTEN_U, domain.a, domain.b, &along);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(along, BATTEN_V, low, high, out);
    batten_surface_unref(along);
    batten_surface_unref(made);
    batten_curve_unref(base);
    return status;
}

/* ---- offsets ---- */

/* The part of a surface that is below the points: it may be offset where the whole cannot. */
static batten_status part_below(const batten_surface *surface, int count, const double *points,
                                batten_surface **out)
{
    double *uv = bat_array3((size_t)count, 2, sizeof *uv);
    batten_deviation deviation;
    batten_surface *part = batten_surface_ref(surface);
    batten_status status =
        uv ? batten_surface_project(surface, (batten_points){3, count, points}, NULL, NULL,
                                    (batten_feet){uv, NULL}, &deviation)
           : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        const batten_direction direction = k == 0 ? BATTEN_U : BATTEN_V;
        const batten_interval domain = batten_surface_domain(surface, direction);
        batten_interval over = {domain.b, domain.a};
        for (int i = 0; i < count; i++) {
            over.a = bat_min(over.a, uv[2 * (size_t)i + (size_t)k]);
            over.b = bat_max(over.b, uv[2 * (size_t)i + (size_t)k]);
        }
        const double more = bat_max(MARGIN * (over.b - over.a), 1e-3 * (domain.b - domain.a));
        batten_surface *cut = NULL;
        status = batten_surface_subrange(part, direction, bat_max(domain.a, over.a - more),
                                         bat_min(domain.b, over.b + more), &cut);
        status = bat_surface_replace(status, &part, &cut);
    }
    bat_release(uv);
    if (status == BATTEN_OK)
        *out = part;
    else
        batten_surface_unref(part);
    return status;
}

static batten_status offset(const bat_elementary *elementary, int count, const double *points,
                            double tolerance, batten_surface **out, double *error)
{
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_surface *part = NULL;
    if (!(tolerance > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of the offset is %g", tolerance);
    if (elementary->a == 0) {
        *out = batten_surface_ref(elementary->surface);
        return BATTEN_OK;
    }
    options.tolerance = tolerance;
    options.most_points = elementary->most;
    batten_status status =
        batten_surface_offset(elementary->surface, elementary->a, &options, &report, out);
    if ((status == BATTEN_SINGULAR_HERE || status == BATTEN_NOT_COMPATIBLE) && count > 0) {
        status = part_below(elementary->surface, count, points, &part);
        if (status == BATTEN_OK)
            status = batten_surface_offset(part, elementary->a, &options, &report, out);
        batten_surface_unref(part);
    }
    if (status == BATTEN_OK)
        *error = report.error;
    return status;
}

/* ---- all ---- */

static batten_status check_elementary(const bat_elementary *elementary, int count,
                                      const double *points)
{
    static const char *const names[] = {"plane", "cylinder",  "cone",       "sphere",
                                        "torus", "extrusion", "revolution", "offset"};
    const bat_elementary_kind kind = elementary->kind;
    const bool is_unbounded =
        kind == BAT_PLANE || kind == BAT_CYLINDER || kind == BAT_CONE || kind == BAT_EXTRUSION;
    const bool has_curve = kind == BAT_EXTRUSION || kind == BAT_REVOLUTION;
    if (is_unbounded && count < 1)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a %s without any edge reaches to infinity",
                        names[kind]);
    const size_t bad = bat_first_not_finite(points, 3 * (size_t)count);
    if (bad < 3 * (size_t)count)
        return bat_fail(BATTEN_NOT_FINITE, "point %d on the %s has the coordinate %g",
                        (int)(bad / 3) + 1, names[kind], points[bad]);
    if (!isfinite(elementary->a) || !isfinite(elementary->b))
        return bat_fail(BATTEN_NOT_FINITE, "the %s has the measures %g and %g", names[kind],
                        elementary->a, elementary->b);
    const bool has_apex = kind == BAT_CONE && elementary->b != 0;
    if (elementary->goes_on && is_unbounded && !has_apex)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "one loop goes around the %s, and nothing bounds it on the other side",
                        names[kind]);
    if (has_curve && batten_curve_dimension(elementary->curve) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s is of a curve of dimension %d",
                        names[kind], batten_curve_dimension(elementary->curve));
    return BATTEN_OK;
}

static batten_status make_surface(const bat_stand *stand, batten_surface **out)
{
    switch (stand->of->kind) {
    case BAT_PLANE:
        return plane(stand, out);
    case BAT_CYLINDER:
        return bat_stand_cylinder(stand, out);
    case BAT_CONE:
        return bat_stand_cone(stand, out);
    case BAT_SPHERE:
        return bat_stand_sphere(stand, out);
    case BAT_TORUS:
        return bat_stand_torus(stand, out);
    case BAT_EXTRUSION:
        return extrusion(stand, out);
    case BAT_REVOLUTION:
        return bat_stand_revolution(stand, out);
    case BAT_OFFSET_SURFACE:
        break;
    }
    return bat_fail(BATTEN_BAD_ARGUMENT, "unknown kind of surface: %d", (int)stand->of->kind);
}

batten_status bat_elementary_surface(const bat_elementary *elementary, int count,
                                     const double *points, double tolerance,
                                     batten_surface **out, double *error)
{
    assert(elementary && (points || count == 0) && out && error);
    batten_status status = check_elementary(elementary, count, points);
    if (status != BATTEN_OK)
        return status;
    double reached = 0;
    if (elementary->kind == BAT_OFFSET_SURFACE) {
        status = offset(elementary, count, points, tolerance, out, &reached);
    } else {
        bat_stand stand = {.of = elementary,
                           .count = count,
                           .points = points,
                           .tolerance = bat_max(0, tolerance)};
        status = bat_elementary_frame(elementary, &stand.frame, &stand.y);
        if (status == BATTEN_OK)
            status = make_surface(&stand, out);
    }
    if (status == BATTEN_OK)
        *error = reached;
    return status;
}
