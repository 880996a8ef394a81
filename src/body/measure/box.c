/* The box around a body: of its edges, and of the parts of surfaces that swell beyond them. */
#include "body/measure/box.h"
#include "numeric/box.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"

#include <string.h>

/* ---- boxes ---- */

/* One side; what is beyond by less than the tolerance is not: feet are not exact. */
static void widen_side(double *low, double *high, double a, double b, double tolerance)
{
    if (a < *low - tolerance)
        *low = a;
    if (b > *high + tolerance)
        *high = b;
}

static void widen_by_face(batten_box *box, batten_box by, double tolerance)
{
    widen_side(&box->low.x, &box->high.x, by.low.x, by.high.x, tolerance);
    widen_side(&box->low.y, &box->high.y, by.low.y, by.high.y, tolerance);
    widen_side(&box->low.z, &box->high.z, by.low.z, by.high.z, tolerance);
}

static bool is_within(batten_box inner, batten_box outer, double tolerance)
{
    const batten_box kept = outer;
    widen_by_face(&outer, inner, tolerance);
    return bat_vec3_norm(bat_vec3_subtract(outer.low, kept.low)) == 0 &&
           bat_vec3_norm(bat_vec3_subtract(outer.high, kept.high)) == 0;
}

/* ---- faces ---- */

static batten_vec3 point_at(const batten_surface *surface, int i)
{
    return bat_vec3_of(3, batten_surface_points(surface) + 3 * (size_t)i);
}

/* Are all control points in a plane? A face on it lies between its edges then. */
static bool is_flat(const batten_surface *surface, double tolerance)
{
    if (strcmp(batten_surface_kind(surface), "nurbs") != 0)
        return false;
    const int count = batten_surface_point_count(surface, BATTEN_U) *
                      batten_surface_point_count(surface, BATTEN_V);
    const batten_vec3 o = point_at(surface, 0);
    batten_vec3 x = {0, 0, 0}, z = {0, 0, 0};
    for (int i = 1; i < count; i++) {
        const batten_vec3 way = bat_vec3_subtract(point_at(surface, i), o);
        if (bat_vec3_norm(way) > bat_vec3_norm(x))
            x = way;
    }
    for (int i = 1; i < count; i++) {
        const batten_vec3 normal =
            bat_vec3_cross(x, bat_vec3_subtract(point_at(surface, i), o));
        if (bat_vec3_norm(normal) > bat_vec3_norm(z))
            z = normal;
    }
    const double length = bat_vec3_norm(z);
    for (int i = 1; length > 0 && i < count; i++)
        if (fabs(bat_vec3_dot(z, bat_vec3_subtract(point_at(surface, i), o))) >
            tolerance * length)
            return false;
    return true;
}

static batten_status widen_by_part(const batten_surface *surface, batten_interval u,
                                   batten_interval v, double tolerance, batten_box *box)
{
    batten_surface *strip = NULL, *part = NULL;
    batten_status status = batten_surface_subrange(surface, BATTEN_U, u.a, u.b, &strip);
    if (status == BATTEN_OK)
        status = batten_surface_subrange(strip, BATTEN_V, v.a, v.b, &part);
    if (status == BATTEN_OK)
        widen_by_face(box, batten_surface_box(part), tolerance);
    batten_surface_unref(strip);
    batten_surface_unref(part);
    return status;
}

static batten_status add_face(const batten_body_parts *parts, int face, double size,
                              batten_box *box)
{
    const batten_surface *surface = parts->faces[face].surface;
    const batten_box whole = batten_surface_box(surface);
    bat_face_range range = {0};
    if (is_within(whole, *box, parts->tolerance) || is_flat(surface, parts->tolerance))
        return BATTEN_OK;
    batten_status status = bat_face_range_find(parts, face, size, &range);
    for (int i = 0; status == BATTEN_OK && i < range.count[0]; i++)
        for (int k = 0; status == BATTEN_OK && k < range.count[1]; k++)
            status = widen_by_part(range.surface, range.at[0][i], range.at[1][k],
                                   parts->tolerance, box);
    batten_surface_unref(range.surface);
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY)
        return status;
    widen_by_face(box, whole, parts->tolerance);
    return BATTEN_OK;
}

batten_status bat_body_find_box(const batten_body *body, batten_box *out)
{
    const batten_body_parts *parts = batten_body_view(body);
    bat_kept_box *kept = bat_body_kept_box(body);
    if (bat_kept_box_get(kept, out))
        return BATTEN_OK;
    batten_box box = bat_body_edge_box(body);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < parts->face_count; i++)
        if (parts->faces[i].count > 0)
            status = add_face(parts, i, size, &box);
    if (status != BATTEN_OK)
        return status;
    bat_kept_box_put(kept, box);
    *out = box;
    return BATTEN_OK;
}

batten_box bat_body_wide_box(const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    batten_box box = bat_body_edge_box(body);
    for (int i = 0; i < parts->face_count; i++)
        if (!is_flat(parts->faces[i].surface, parts->tolerance))
            widen_by_face(&box, batten_surface_box(parts->faces[i].surface), 0);
    return box;
}

batten_box batten_body_box(const batten_body *body)
{
    batten_box box;
    return bat_body_find_box(body, &box) == BATTEN_OK ? box : bat_body_wide_box(body);
}
