/* Meshes under a deformation. */
#include "numeric/vector.h"
#include "shape/deform/lattice.h"

#include <stdint.h>
#include <string.h>

/* The cofactors of the Jacobian take normals to normals, where volumes keep their sign. */
static void map_normal(const batten_deformation *deformation, const double at[3],
                       const double n[3], double out[3])
{
    double m[3][3], length;
    bat_deformation_jacobian(deformation, at, m);
    for (int i = 0; i < 3; i++) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        out[i] = 0;
        for (int j = 0; j < 3; j++) {
            const int c = (j + 1) % 3, d = (j + 2) % 3;
            out[i] += (m[a][c] * m[b][d] - m[a][d] * m[b][c]) * n[j];
        }
    }
    length = bat_norm(3, out);
    for (int i = 0; i < 3; i++)
        out[i] = length > 0 ? out[i] / length : n[i];
}

/* How far the middle of a side is from the image of the middle it had. */
static double side_error(const batten_deformation *deformation, const batten_mesh_parts *given,
                         const double *moved, int a, int b)
{
    double middle[3], image[3], here[3];
    for (int c = 0; c < 3; c++) {
        const size_t k = (size_t)c;
        middle[c] = (given->points[3 * (size_t)a + k] + given->points[3 * (size_t)b + k]) / 2;
        here[c] = (moved[3 * (size_t)a + k] + moved[3 * (size_t)b + k]) / 2;
    }
    bat_deformation_point(deformation, middle, image);
    return bat_distance(3, here, image);
}

batten_status batten_mesh_deform(const batten_mesh *mesh, const batten_deformation *deformation,
                                 double *error, batten_mesh **out)
{
    assert(mesh && deformation && out);
    const batten_mesh_parts *given = batten_mesh_view(mesh);
    const size_t vertices = (size_t)given->vertex_count,
                 triangles = (size_t)given->triangle_count;
    batten_mesh_parts parts = *given;
    double most = 0;
    batten_status status =
        bat_deformation_check(deformation, batten_mesh_box(mesh), "the mesh");
    if (status != BATTEN_OK)
        return status;
    double *points = bat_array(vertices, 3 * sizeof *points);
    double *normals = bat_array(given->normals ? triangles : 0, 9 * sizeof *normals);
    status = points && normals ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < vertices && status == BATTEN_OK; i++)
        bat_deformation_point(deformation, given->points + 3 * i, points + 3 * i);
    for (size_t i = 0; i < 3 * triangles && status == BATTEN_OK; i++) {
        const int corner = given->corners[i], next = given->corners[i % 3 == 2 ? i - 2 : i + 1];
        most = bat_max(most, side_error(deformation, given, points, corner, next));
        if (given->normals)
            map_normal(deformation, given->points + 3 * (size_t)corner, given->normals + 3 * i,
                       normals + 3 * i);
    }
    if (status == BATTEN_OK) {
        parts.points = points;
        parts.normals = given->normals ? normals : NULL;
        status = batten_mesh_create(&parts, out);
    }
    if (status == BATTEN_OK && error)
        *error = most;
    bat_release(points);
    bat_release(normals);
    return status;
}
