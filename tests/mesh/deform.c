/* Meshes under deformations. */
#include "support/faults.h"
#include "support/lattices.h"

static const double corners[] = {0, 0.2, 0, 1, 0.2, 0, 0, 0.8, 1, 1, 0.9, -1},
                    normals[] = {0, 0, 1, 0, 0.6, 0.8, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1};
static const int triangles[] = {0, 1, 2, 1, 3, 2};

TEST(vertices_move_exactly_normals_stay_square_and_the_error_is_that_of_sides)
{
    const batten_lattice l = test_lattice(4, 3);
    test_random random = test_random_begin("mesh");
    double points[3 * 64], q[12], error = -1;
    batten_deformation *d = NULL;
    batten_mesh *mesh = NULL, *made = NULL;
    const batten_mesh_parts given = {.vertex_count = 4,
                                     .points = corners,
                                     .triangle_count = 2,
                                     .corners = triangles,
                                     .normals = normals};
    test_lattice_shaken(&random, &l, 0.2, 0, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_mesh_create(&given, &mesh));
    CHECK_EACH_ALLOCATION(batten_mesh_deform(mesh, d, &error, &made));
    const batten_mesh_parts *parts = batten_mesh_view(made);
    CHECK_OK(batten_deformation_apply(d, (batten_points){3, 4, corners}, q));
    for (int i = 0; i < 12; i++)
        CHECK_NEAR(parts->points[i], q[i], 0);
    /* Steps along the plane of each normal come to be along the plane of the new one. */
    for (int i = 0; i < 6; i++) {
        const double *n = normals + 3 * i, *m = parts->normals + 3 * i;
        const double across[2][3] = {{n[1] + n[2], -n[0], -n[0]}, {-n[1], n[0] + n[2], -n[1]}};
        CHECK_NEAR(hypot(hypot(m[0], m[1]), m[2]), 1, 1e-14);
        for (int k = 0; k < 2; k++) {
            double two[6], moved[6], dot = 0;
            for (int c = 0; c < 3; c++) {
                two[c] = corners[3 * triangles[i] + c] - 1e-5 * across[k][c];
                two[3 + c] = corners[3 * triangles[i] + c] + 1e-5 * across[k][c];
            }
            CHECK_OK(batten_deformation_apply(d, (batten_points){3, 2, two}, moved));
            for (int c = 0; c < 3; c++)
                dot += (moved[3 + c] - moved[c]) * m[c];
            CHECK_NEAR(dot / 2e-5, 0, 1e-8);
        }
    }
    double middle[3], most = 0;
    for (int i = 0; i < 6; i++) {
        const int a = triangles[i], b = triangles[i % 3 == 2 ? i - 2 : i + 1];
        double far = 0;
        for (int c = 0; c < 3; c++)
            middle[c] = (corners[3 * a + c] + corners[3 * b + c]) / 2;
        CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, middle}, middle));
        for (int c = 0; c < 3; c++)
            far = hypot(far, middle[c] - (q[3 * a + c] + q[3 * b + c]) / 2);
        most = fmax(most, far);
    }
    CHECK_NEAR(error, most, 1e-15);
    batten_mesh_unref(made);
    batten_mesh_unref(mesh);
    batten_deformation_unref(d);
}

TEST(a_mesh_that_leaves_the_box_is_refused)
{
    static const double far[] = {0, 0.2, 0, 1, 0.2, 0, 0, 0.8, 3};
    const batten_lattice l = test_lattice(2, 1);
    double points[3 * 8];
    batten_deformation *d = NULL;
    batten_mesh *mesh = NULL, *none = NULL;
    const batten_mesh_parts given = {
        .vertex_count = 3, .points = far, .triangle_count = 1, .corners = triangles};
    CHECK_OK(batten_lattice_home(&l, points));
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_mesh_create(&given, &mesh));
    CHECK_STATUS(batten_mesh_deform(mesh, d, NULL, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("the mesh reaches 1 out of the box where z is largest");
    CHECK(none == NULL);
    batten_mesh_unref(mesh);
    batten_deformation_unref(d);
}
