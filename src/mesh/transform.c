/* Meshes in other places, and with shared vertices. */
#include "base/base.h"

#include <batten/mesh.h>
#include <stdint.h>
#include <string.h>

/* The cofactors of the map's matrix: how normals go. Their sum with the rows is the
 * determinant.
 */
static double cofactors(const batten_affine *map, double c[3][3])
{
    const double(*m)[3] = map->m;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int a = (i + 1) % 3, b = (i + 2) % 3, d = (j + 1) % 3, e = (j + 2) % 3;
            c[i][j] = m[a][d] * m[b][e] - m[a][e] * m[b][d];
        }
    return m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
}

static void map_points(const batten_affine *map, size_t count, const double *from, double *to)
{
    for (size_t i = 0; i < count; i++) {
        const batten_vec3 p = batten_affine_apply(
            *map, (batten_vec3){from[3 * i], from[3 * i + 1], from[3 * i + 2]});
        to[3 * i] = p.x;
        to[3 * i + 1] = p.y;
        to[3 * i + 2] = p.z;
    }
}

static void map_normal(double c[3][3], double sign, const double *n, double *made)
{
    double length = 0;
    for (int i = 0; i < 3; i++) {
        made[i] = c[i][0] * n[0] + c[i][1] * n[1] + c[i][2] * n[2];
        length = bat_hypot(length, made[i]);
    }
    for (int i = 0; i < 3; i++)
        made[i] *= length > 0 ? sign / length : 0;
}

/* Unit normals, of triangles whose corners 1 and 2 change places when `turned`. */
static void map_normals(double c[3][3], bool turned, size_t triangles, const double *from,
                        double *to)
{
    for (size_t t = 0; t < triangles; t++)
        for (size_t k = 0; k < 3; k++) {
            const double *n = &from[9 * t + 3 * (turned ? (3 - k) % 3 : k)];
            map_normal(c, turned ? -1 : 1, n, &to[9 * t + 3 * k]);
        }
}

batten_status batten_mesh_transform(const batten_mesh *mesh, const batten_affine *map,
                                    batten_mesh **out)
{
    batten_mesh_parts parts = *batten_mesh_view(mesh);
    const size_t vertices = (size_t)parts.vertex_count,
                 triangles = (size_t)parts.triangle_count;
    double c[3][3];
    const double scale = cofactors(map, c);
    const bool turned = scale < 0;
    if (scale == 0 || !isfinite(scale))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the map is singular or not finite");
    double *points = bat_array3(vertices, 3, sizeof *points);
    int *corners = bat_array3(triangles, 3, sizeof *corners);
    double *normals = bat_array3(parts.normals ? triangles : 0, 9, sizeof *normals);
    batten_status status = points && corners && normals ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        map_points(map, vertices, parts.points, points);
        for (size_t i = 0; i < 3 * triangles; i++)
            corners[i] = parts.corners[turned ? 3 * (i / 3) + (3 - i % 3) % 3 : i];
        if (parts.normals)
            map_normals(c, turned, triangles, parts.normals, normals);
        parts.points = points;
        parts.corners = corners;
        parts.normals = parts.normals ? normals : NULL;
        status = batten_mesh_create(&parts, out);
    }
    bat_release(points);
    bat_release(corners);
    bat_release(normals);
    return status;
}
