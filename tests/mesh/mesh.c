#include <batten/mesh.h>

#include "support/test.h"

/* A tetrahedron at the corner of the axes. */
static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

static batten_mesh_parts tetrahedron(void)
{
    return (batten_mesh_parts){
        .vertex_count = 4, .points = points, .triangle_count = 4, .corners = corners};
}

TEST(a_mesh_keeps_what_it_is_made_of)
{
    const double heights[] = {0, 0, 0, 1}, colours[12] = {0.5};
    const batten_mesh_attribute height = {"height", heights};
    const int faces[] = {0, 1, 2, 3};
    batten_mesh_parts parts = tetrahedron();
    batten_mesh *mesh = NULL;
    parts.colours = parts.triangle_colours = colours;
    parts.faces = faces;
    parts.attribute_count = 1;
    parts.attributes = &height;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    const batten_mesh_parts *kept = batten_mesh_view(mesh);
    CHECK_INT(kept->triangle_count, 4);
    CHECK_BITS(kept->attributes[0].values[3], 1);
    CHECK_TEXT(kept->attributes[0].name, "height");
    CHECK_BITS(kept->colours[0], 0.5);
    CHECK_BITS(kept->triangle_colours[0], 0.5);
    CHECK_INT(kept->faces[3], 3);
    CHECK_BITS(batten_mesh_box(mesh).high.z, 1);
    batten_mesh *again = batten_mesh_ref(mesh);
    batten_mesh_unref(mesh);
    CHECK_INT(batten_mesh_view(again)->vertex_count, 4);
    batten_mesh_unref(again);
    batten_mesh_unref(NULL);
}

TEST(N1_meshes_of_what_is_no_number_are_refused)
{
    double bad_points[12];
    int bad_corners[12];
    batten_mesh_parts parts = tetrahedron();
    batten_mesh *mesh = NULL;
    memcpy(bad_points, points, sizeof points);
    memcpy(bad_corners, corners, sizeof corners);
    bad_points[5] = INFINITY;
    bad_corners[7] = 4;
    parts.points = bad_points;
    CHECK_STATUS(batten_mesh_create(&parts, &mesh), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("number 6 of the points");
    parts.corners = bad_corners;
    CHECK_STATUS(batten_mesh_create(&parts, &mesh), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("triangle 3 has vertex 5, of 4");
    parts = tetrahedron();
    parts.vertex_count = -1;
    CHECK_STATUS(batten_mesh_create(&parts, &mesh), BATTEN_BAD_ARGUMENT);
    CHECK(!mesh);
}

TEST(a_mirror_turns_the_triangles_and_keeps_normals_outside)
{
    const batten_affine mirror =
        batten_affine_mirror((batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1});
    const batten_affine flat = batten_affine_scaling(0, 1, 1);
    double normals[36];
    batten_mesh_parts parts = tetrahedron();
    batten_mesh *mesh = NULL, *mirrored = NULL;
    for (int i = 0; i < 36; i++)
        normals[i] = i % 3 == 2 ? -1 : 0;
    normals[3 * 1 + 0] = 0.6;
    normals[3 * 1 + 2] = -0.8;
    parts.normals = normals;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_mesh_transform(mesh, &mirror, &mirrored));
    const batten_mesh_parts *m = batten_mesh_view(mirrored);
    CHECK_INT(m->corners[0], 0);
    CHECK_INT(m->corners[1], 1);
    CHECK_INT(m->corners[2], 2);
    CHECK_NEAR(m->normals[2], 1, 1e-15);
    CHECK_NEAR(m->normals[3 * 2 + 0], 0.6, 1e-15);
    CHECK_NEAR(m->normals[3 * 2 + 2], 0.8, 1e-15);
    CHECK_STATUS(batten_mesh_transform(mesh, &flat, &mirrored), BATTEN_BAD_ARGUMENT);
    batten_mesh_unref(mirrored);
    batten_mesh_unref(mesh);
}
