/* Meshes under affine maps: points by the map, normals by its inverse transposed. */
#include "support/test.h"

#include <batten/mesh.h>

static const double points[] = {1, 0, 0, 0, 2, 0, 0, 0, 3, 4, 5, 6};
static const int corners[] = {0, 1, 2, 3, 2, 1};
static const int faces[] = {7, 8};
static const double heights[] = {1, 2, 3, 4};

static batten_mesh *two_triangles(const double *normals)
{
    const batten_mesh_attribute attribute = {"height", heights};
    batten_mesh *mesh = NULL;
    const batten_mesh_parts parts = {.vertex_count = 4,
                                     .points = points,
                                     .triangle_count = 2,
                                     .corners = corners,
                                     .normals = normals,
                                     .faces = faces,
                                     .attribute_count = 1,
                                     .attributes = &attribute};
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    return mesh;
}

/* Normals of the sides of the planes x, y and z, and one oblique one. */
static const double normals[18] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0.6, 0.8, 0};

/* Directions in the plane of a normal stay square to the image of the normal. */
static void check_normal(const batten_affine *map, const double n[3], const double made[3],
                         double side)
{
    const double across[2][3] = {{n[1] + n[2], -n[0], -n[0]}, {-n[1], n[0] + n[2], -n[1]}};
    double up = 0;
    for (int k = 0; k < 2; k++) {
        double dot = 0;
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                dot += made[i] * map->m[i][j] * across[k][j];
        CHECK_NEAR(dot, 0, 1e-14);
    }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            up += made[i] * map->m[i][j] * n[j];
    CHECK(side * up > 0);
    CHECK_NEAR(hypot(hypot(made[0], made[1]), made[2]), 1, 1e-15);
}

static const batten_affine maps[] = {
    {{{2, 0.5, 0.3}, {-0.4, 1, 0.2}, {0.1, 0.6, 3}}, {10, 20, 30}},
    {{{0, 2, 0}, {1, 0, 0}, {0.3, 0.1, 1}}, {-1, 0, 5}}, /* x and y change places: a mirror */
    {{{-1, 0, 0.2}, {0, -1, 0}, {0, 0, -4}}, {0, 0, 0}},
};

TEST(points_move_by_the_map_and_normals_stay_square_to_the_outside)
{
    batten_mesh *mesh = two_triangles(normals);
    for (int m = 0; m < COUNT(maps); m++) {
        const bool turned = m > 0;
        batten_mesh *made = NULL;
        CHECK_OK(batten_mesh_transform(mesh, &maps[m], &made));
        const batten_mesh_parts *p = batten_mesh_view(made);
        for (int i = 0; i < 4; i++)
            for (int c = 0; c < 3; c++) {
                double wanted = maps[m].t[c];
                for (int j = 0; j < 3; j++)
                    wanted += maps[m].m[c][j] * points[3 * i + j];
                CHECK_NEAR(p->points[3 * i + c], wanted, 1e-14);
            }
        for (int i = 0; i < 6; i++) {
            const int from = turned && i % 3 ? i - i % 3 + 3 - i % 3 : i;
            CHECK_INT(p->corners[i], corners[from]);
            check_normal(&maps[m], normals + 3 * from, p->normals + 3 * i, 1);
        }
        CHECK_INT(p->faces[1], 8);
        CHECK_NEAR(p->attributes[0].values[3], 4, 0);
        batten_mesh_unref(made);
    }
    batten_mesh_unref(mesh);
}

TEST(normals_that_are_missing_stay_missing_and_those_of_length_0_stay_0)
{
    static const double none[18] = {0};
    batten_mesh *bare = two_triangles(NULL), *flat = two_triangles(none), *made = NULL;
    CHECK_OK(batten_mesh_transform(bare, &maps[0], &made));
    CHECK(!batten_mesh_view(made)->normals);
    batten_mesh_unref(made);
    CHECK_OK(batten_mesh_transform(flat, &maps[1], &made));
    for (int i = 0; i < 18; i++)
        CHECK_NEAR(batten_mesh_view(made)->normals[i], 0, 0);
    batten_mesh_unref(made);
    batten_mesh_unref(bare);
    batten_mesh_unref(flat);
}

TEST(maps_that_make_a_mesh_flat_or_are_not_finite_are_refused)
{
    batten_affine bad[3] = {maps[0], maps[0], maps[0]};
    batten_mesh *mesh = two_triangles(normals), *made = NULL;
    memcpy(bad[0].m[2], bad[0].m[1], sizeof bad[0].m[2]);
    bad[1].m[2][2] = NAN;
    bad[2].m[0][0] = INFINITY;
    for (int i = 0; i < 3; i++) {
        CHECK_STATUS(batten_mesh_transform(mesh, &bad[i], &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the map is singular or not finite");
    }
    CHECK(!made);
    batten_mesh_unref(mesh);
}
