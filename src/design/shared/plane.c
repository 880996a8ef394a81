/* The plane of points and curves, wherever it lies in space. */
#include "design/shared/plane.h"

#include "numeric/vector.h"
#include <float.h>

static batten_vec3 point_of(const double *points, int i)
{
    return (batten_vec3){points[3 * i], points[3 * i + 1], points[3 * i + 2]};
}

/* Off the origin, and off the line along a unit vector where there is one. */
static batten_vec3 offset_of(const double *points, int i, const batten_vec3 *along)
{
    const batten_vec3 off = bat_vec3_subtract(point_of(points, i), point_of(points, 0));
    return along ? bat_vec3_subtract(off, bat_vec3_scale(*along, bat_vec3_dot(off, *along)))
                 : off;
}

/* The longest of these; all are finite. */
static batten_vec3 find_farthest(int count, const double *points, const batten_vec3 *along)
{
    batten_vec3 farthest = {0, 0, 0};
    for (int i = 1; i < count; i++) {
        const batten_vec3 off = offset_of(points, i, along);
        if (bat_vec3_norm(off) > bat_vec3_norm(farthest))
            farthest = off;
    }
    return farthest;
}

static void set_row(batten_affine *map, int row, batten_vec3 way, batten_vec3 origin)
{
    map->m[row][0] = way.x;
    map->m[row][1] = way.y;
    map->m[row][2] = way.z;
    map->t[row] = -bat_vec3_dot(way, origin);
}

bool bat_plane_find(int count, const double *points, batten_affine *to_plane)
{
    double largest = 0;
    for (int i = 0; i < 3 * count; i++)
        largest = bat_max(largest, fabs(points[i]));
    /* Points that were turned into the plane are off it by some roundings of their coordinates. */
    const double rounding = 64 * DBL_EPSILON * largest;
    const batten_vec3 longest = find_farthest(count, points, NULL);
    if (!(bat_vec3_norm(longest) > rounding) || isinf(bat_vec3_norm(longest)))
        return false;
    const batten_vec3 x = bat_vec3_scale(longest, 1 / bat_vec3_norm(longest));
    const batten_vec3 widest = find_farthest(count, points, &x);
    if (!(bat_vec3_norm(widest) > rounding))
        return false;
    const batten_vec3 y = bat_vec3_scale(widest, 1 / bat_vec3_norm(widest));
    const batten_vec3 z = bat_vec3_cross(x, y);
    for (int i = 1; i < count; i++)
        if (fabs(bat_vec3_dot(z, offset_of(points, i, NULL))) > rounding)
            return false;
    *to_plane = batten_affine_identity();
    set_row(to_plane, 0, x, point_of(points, 0));
    set_row(to_plane, 1, y, point_of(points, 0));
    set_row(to_plane, 2, z, point_of(points, 0));
    return true;
}

void bat_plane_points(const batten_affine *to_plane, int count, const double *points,
                      double *plane)
{
    for (int i = 0; i < count; i++) {
        const batten_vec3 at = batten_affine_apply(*to_plane, point_of(points, i));
        plane[2 * i] = at.x;
        plane[2 * i + 1] = at.y;
    }
}

batten_status bat_plane_curve(const batten_affine *to_plane, const batten_curve *curve,
                              batten_curve **out)
{
    batten_curve *turned = NULL;
    batten_status status = batten_curve_transform(curve, to_plane, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(turned, 2, out);
    batten_curve_unref(turned);
    return status;
}
