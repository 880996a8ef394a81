/* The surfaces of faces: those of the file as they are, elementary ones over their edges. */
#include "base/plural.h"
#include "exchange/step/read/geometry.h"
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

#include <limits.h>

static batten_status add_point(bat_step_topology *t, const double point[3])
{
    return bat_list_add(t->file->input, &t->points, point);
}

static batten_status add_controls(bat_step_topology *t, const batten_curve *curve)
{
    const double *points = batten_curve_points(curve);
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_curve_point_count(curve); i++)
        status = add_point(t, &points[3 * (size_t)i]);
    return status;
}

/* Points on the curve, some in each of its spans. */
static batten_status add_samples(bat_step_topology *t, const batten_curve *curve)
{
    enum { EACH = 6 };
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    batten_status status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (knots)
        batten_curve_spans(curve, knots);
    for (int k = 0; status == BATTEN_OK && k + 1 < count; k++)
        for (int i = k ? 1 : 0; status == BATTEN_OK && i <= EACH; i++) {
            double point[3];
            const double s = (double)i / EACH;
            const double at =
                i == EACH ? knots[k + 1] : knots[k] + s * (knots[k + 1] - knots[k]);
            status = batten_curve_evaluate_side(curve, at, BATTEN_FROM_LEFT, 0, point);
            if (status == BATTEN_OK)
                status = add_point(t, point);
        }
    bat_release(knots);
    return status;
}

/* Where the edges of the face go. Of planes and cylinders the control points hold them in. */
static batten_status gather_points(bat_step_topology *t, const bat_step_instance *instance,
                                   bat_elementary_kind kind)
{
    const bat_step_use *uses = t->uses.items;
    const batten_body_parts *p = &t->builder.parts;
    batten_status status = BATTEN_OK;
    t->points.count = 0;
    for (size_t k = 0; status == BATTEN_OK && k < t->uses.count; k++) {
        const batten_body_edge *edge = &p->edges[uses[k].edge];
        if (!edge->curve)
            status = add_point(t, &p->vertices[3 * (size_t)edge->vertices[0]]);
        else if (kind == BAT_PLANE || kind == BAT_CYLINDER)
            status = add_controls(t, edge->curve);
        else
            status = add_samples(t, edge->curve);
    }
    if (status == BATTEN_OK && t->points.count > INT_MAX)
        status = bat_step_fail(t->file, instance, BATTEN_TOO_LARGE, "the face has %zu point%s",
                               t->points.count, bat_plural(t->points.count));
    return status;
}

/* Do the loops leave the face open on one side? */
static batten_status look_around(bat_step_topology *t, bat_elementary *elementary)
{
    const bat_step_use *uses = t->uses.items;
    const batten_body_edge *edges = t->builder.parts.edges;
    bat_around around;
    batten_status status = bat_around_begin(elementary, t->scale.tolerance, &around);
    for (size_t k = 0; status == BATTEN_OK && k < t->uses.count; k++)
        if (edges[uses[k].edge].curve)
            status = bat_around_add(&around, edges[uses[k].edge].curve, uses[k].reversed);
    elementary->goes_on = status == BATTEN_OK && bat_around_is_once(&around);
    return status;
}

/* A loop that is a vertex says where a cone has its apex. */
static void check_apex(const bat_step_topology *t, const bat_step_instance *instance,
                       const bat_elementary *cone)
{
    const batten_vec3 apex =
        bat_vec3_along(cone->frame.origin, -cone->a / bat_tan(cone->b), cone->frame.z);
    const double *at = &t->builder.parts.vertices[3 * (size_t)t->vertex_loop];
    const double gap = bat_vec3_norm(bat_vec3_subtract(bat_vec3_of(3, at), apex));
    if (gap > t->scale.tolerance)
        bat_step_warn(t->file, instance,
                      "the loop of its face that is a vertex is %g from its apex; the face "
                      "ends at the apex",
                      gap);
}

static batten_status elementary_surface(bat_step_topology *t, const bat_step_instance *instance,
                                        bat_elementary *elementary, batten_surface **out)
{
    double error = 0;
    batten_status status = gather_points(t, instance, elementary->kind);
    if (status != BATTEN_OK)
        return status;
    status = look_around(t, elementary);
    if (status != BATTEN_OK)
        return bat_step_blame(t->file, instance, status);
    if (elementary->goes_on && elementary->kind == BAT_CONE && t->vertex_loop >= 0)
        check_apex(t, instance, elementary);
    status = bat_elementary_surface(elementary, (int)t->points.count, t->points.items,
                                    t->scale.tolerance, out, &error);
    if (status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    if (status != BATTEN_OK)
        return bat_step_fail(t->file, instance, status, "%.300s", batten_message());
    if (error > 0)
        bat_step_warn(t->file, instance, "an offset; a B-spline within %g stands for it",
                      error);
    return BATTEN_OK;
}

/* A surface of the file itself, made once for all its faces. */
static batten_status own_surface(bat_step_topology *t, const bat_step_instance *instance,
                                 batten_surface **out)
{
    bat_step_made *made = bat_step_made_of(t, instance);
    batten_surface *surface = NULL;
    if (made->stamp == bat_step_stamp(t, BAT_STEP_SURFACE)) {
        if (made->index < 0)
            return bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                                 "the surface could not be read before");
        *out = batten_surface_ref(((batten_surface **)t->surfaces.items)[made->index]);
        return BATTEN_OK;
    }
    batten_status status = bat_step_read_surface(t->file, instance, &t->scale, &surface);
    if (status == BATTEN_OK) {
        status = bat_list_add(t->file->input, &t->surfaces, &surface);
        if (status != BATTEN_OK)
            batten_surface_unref(surface);
    }
    if (status == BATTEN_OK) {
        *made =
            (bat_step_made){bat_step_stamp(t, BAT_STEP_SURFACE), (int)t->surfaces.count - 1};
        *out = batten_surface_ref(surface);
    } else if (status != BATTEN_OUT_OF_MEMORY && status != BATTEN_CANCELLED) {
        *made = (bat_step_made){bat_step_stamp(t, BAT_STEP_SURFACE), -1};
    }
    return status;
}

/* Has it the parameters of the file? */
static bool is_spline(const bat_step_file *file, const bat_step_instance *instance)
{
    static const char *const keywords[] = {"B_SPLINE_SURFACE_WITH_KNOTS", "BEZIER_SURFACE",
                                           "UNIFORM_SURFACE", "QUASI_UNIFORM_SURFACE",
                                           "B_SPLINE_SURFACE"};
    for (size_t k = 0; k < sizeof keywords / sizeof keywords[0]; k++)
        if (bat_step_as(file, instance, keywords[k]))
            return true;
    return false;
}

batten_status bat_step_face_surface(bat_step_topology *t, const bat_step_instance *instance,
                                    batten_surface **out, bool *is_file, bool *is_against)
{
    bat_elementary elementary;
    bat_step_basis basis = {NULL, NULL, false};
    bool is_elementary = false;
    *is_file = is_spline(t->file, instance);
    *is_against = false;
    if (*is_file)
        return own_surface(t, instance, out);
    batten_status status = bat_step_as_elementary(t->file, instance, &t->scale, &elementary,
                                                  &basis, &is_elementary);
    if (status == BATTEN_OK && basis.curve)
        status = bat_step_spend(t, instance, (size_t)batten_curve_point_count(basis.curve));
    if (status == BATTEN_OK)
        status = is_elementary ? elementary_surface(t, instance, &elementary, out)
                               : own_surface(t, instance, out);
    *is_against = is_elementary && basis.is_reversed;
    bat_step_basis_end(&basis);
    return status;
}

/* ---- polygons ---- */

/* Twice the area of the first loop, along its normal (Newell). */
static batten_vec3 polygon_normal(const bat_step_topology *t)
{
    const bat_step_use *uses = t->uses.items;
    const double *points = t->builder.parts.vertices;
    const int count = ((const int *)t->loops.items)[0];
    batten_vec3 sum = {0, 0, 0};
    const batten_vec3 o = bat_vec3_of(3, &points[3 * bat_step_end_of(t, &uses[0], 0)]);
    for (int k = 0; k < count; k++) {
        const int a = bat_step_end_of(t, &uses[k], 0), b = bat_step_end_of(t, &uses[k], 1);
        sum = bat_vec3_add(
            sum, bat_vec3_cross(bat_vec3_subtract(bat_vec3_of(3, &points[3 * a]), o),
                                bat_vec3_subtract(bat_vec3_of(3, &points[3 * b]), o)));
    }
    return sum;
}

batten_status bat_step_polygon_plane(bat_step_topology *t, const bat_step_instance *face,
                                     batten_surface **out)
{
    if (t->loops.count == 0)
        return bat_step_fail(t->file, face, BATTEN_BAD_FORMAT,
                             "the face has neither a surface nor a polygon");
    const bat_step_use *first = t->uses.items;
    const double *points = t->builder.parts.vertices;
    const batten_vec3 o = bat_vec3_of(3, &points[3 * bat_step_end_of(t, first, 0)]);
    const batten_vec3 x =
        bat_vec3_subtract(bat_vec3_of(3, &points[3 * bat_step_end_of(t, first, 1)]), o);
    const batten_vec3 z = polygon_normal(t);
    const double length = bat_vec3_norm(x), area = bat_vec3_norm(z);
    if (!(length > 0) || !(area > 0))
        return bat_step_fail(t->file, face, BATTEN_BAD_FORMAT, "its polygon has no area");
    bat_elementary plane = {.kind = BAT_PLANE};
    plane.frame.origin = o;
    plane.frame.z = bat_vec3_scale(z, 1 / area);
    /* The first side may leave the plane that fits all. */
    plane.frame.x = bat_vec3_along(x, -bat_vec3_dot(x, plane.frame.z), plane.frame.z);
    if (!(bat_vec3_norm(plane.frame.x) > 1e-6 * length))
        return bat_step_fail(t->file, face, BATTEN_BAD_FORMAT, "its polygon is not plane");
    plane.frame.x = bat_vec3_scale(plane.frame.x, 1 / bat_vec3_norm(plane.frame.x));
    return elementary_surface(t, face, &plane, out);
}
