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

/* All that a mesh may have, with other numbers everywhere. */
typedef struct {
    double points[9], colours[9], normals[18], triangle_colours[6], first[3], second[3];
    int corners[6], faces[2];
    batten_mesh_attribute attributes[2];
    batten_mesh_parts parts;
} full_mesh;

static void fill_full(full_mesh *f)
{
    static const int two[6] = {0, 1, 2, 2, 1, 0};
    for (int i = 0; i < 18; i++) {
        f->normals[i] = 100 + i;
        f->points[i % 9] = 200 + i;
        f->colours[i % 9] = 300 + i;
        f->triangle_colours[i % 6] = 400 + i;
        f->first[i % 3] = 500 + i;
        f->second[i % 3] = 600 + i;
        f->faces[i % 2] = 700 + i;
    }
    memcpy(f->corners, two, sizeof two);
    f->attributes[0] = (batten_mesh_attribute){"first", f->first};
    f->attributes[1] = (batten_mesh_attribute){"second", f->second};
    f->parts = (batten_mesh_parts){.vertex_count = 3,
                                   .points = f->points,
                                   .colours = f->colours,
                                   .triangle_count = 2,
                                   .corners = f->corners,
                                   .normals = f->normals,
                                   .faces = f->faces,
                                   .triangle_colours = f->triangle_colours,
                                   .attribute_count = 2,
                                   .attributes = f->attributes};
}

TEST(everything_is_copied_to_its_last_number)
{
    full_mesh given, wanted;
    batten_mesh *mesh = NULL;
    fill_full(&given);
    fill_full(&wanted);
    CHECK_OK(batten_mesh_create(&given.parts, &mesh));
    memset(&given, 0x7f, sizeof given);
    const batten_mesh_parts *kept = batten_mesh_view(mesh);
    CHECK_INT(kept->vertex_count, 3);
    CHECK_INT(kept->triangle_count, 2);
    CHECK_INT(kept->attribute_count, 2);
    CHECK(memcmp(kept->points, wanted.points, sizeof wanted.points) == 0);
    CHECK(memcmp(kept->colours, wanted.colours, sizeof wanted.colours) == 0);
    CHECK(memcmp(kept->corners, wanted.corners, sizeof wanted.corners) == 0);
    CHECK(memcmp(kept->normals, wanted.normals, sizeof wanted.normals) == 0);
    CHECK(memcmp(kept->faces, wanted.faces, sizeof wanted.faces) == 0);
    CHECK(memcmp(kept->triangle_colours, wanted.triangle_colours,
                 sizeof wanted.triangle_colours) == 0);
    CHECK(memcmp(kept->attributes[0].values, wanted.first, sizeof wanted.first) == 0);
    CHECK(memcmp(kept->attributes[1].values, wanted.second, sizeof wanted.second) == 0);
    CHECK_TEXT(kept->attributes[1].name, "second");
    batten_mesh_unref(mesh);
}

TEST(a_number_that_is_not_finite_is_found_in_every_array_and_counted)
{
    full_mesh f;
    fill_full(&f);
    const struct {
        double *number;
        const char *message;
    } rows[] = {
        {&f.points[0], "number 1 of the points is not finite"},
        {&f.points[8], "number 9 of the points is not finite"},
        {&f.colours[8], "number 9 of the colours is not finite"},
        {&f.normals[17], "number 18 of the normals is not finite"},
        {&f.triangle_colours[5], "number 6 of the colours of triangles is not finite"},
        {&f.first[2], "number 3 of the attributes is not finite"},
        {&f.second[0], "number 1 of the attributes is not finite"},
    };
    batten_mesh *mesh = NULL;
    for (int i = 0; i < COUNT(rows); i++) {
        fill_full(&f);
        *rows[i].number = i % 2 ? NAN : -INFINITY;
        CHECK_STATUS(batten_mesh_create(&f.parts, &mesh), BATTEN_NOT_FINITE);
        CHECK_MESSAGE(rows[i].message);
    }
    CHECK(!mesh);
}

TEST(counts_below_0_and_vertices_that_are_not_there_are_refused_with_their_numbers)
{
    static const int counts[][3] = {{-1, 2, 2}, {3, -1, 2}, {3, 2, -1}};
    static const char *const messages[] = {"-1 vertices, 2 triangles, 2 attributes",
                                           "3 vertices, -1 triangle",
                                           "2 triangles, -1 attributes"};
    full_mesh f;
    batten_mesh *mesh = NULL;
    for (int i = 0; i < 3; i++) {
        fill_full(&f);
        f.parts.vertex_count = counts[i][0];
        f.parts.triangle_count = counts[i][1];
        f.parts.attribute_count = counts[i][2];
        CHECK_STATUS(batten_mesh_create(&f.parts, &mesh), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(messages[i]);
    }
    for (int i = 0; i < 6; i++)
        for (int bad = -1; bad <= 3; bad += 4) {
            char message[64];
            fill_full(&f);
            f.corners[i] = bad;
            snprintf(message, sizeof message, "triangle %d has vertex %d, of 3", i / 3 + 1,
                     bad + 1);
            CHECK_STATUS(batten_mesh_create(&f.parts, &mesh), BATTEN_BAD_ARGUMENT);
            CHECK_MESSAGE(message);
        }
    CHECK(!mesh);
}

TEST(the_box_of_a_mesh_is_that_of_all_its_vertices)
{
    const double spread[] = {2, -3, 4, -1, 5, 6, 1, 1, -7};
    const batten_mesh_parts parts = {.vertex_count = 3, .points = spread},
                            nothing = {.vertex_count = 0, .points = spread};
    const batten_box wanted = {{-1, -3, -7}, {2, 5, 6}}, empty = {{0, 0, 0}, {0, 0, 0}};
    batten_mesh *mesh = NULL, *none = NULL;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_mesh_create(&nothing, &none));
    const batten_box box = batten_mesh_box(mesh), zero = batten_mesh_box(none);
    CHECK(memcmp(&box, &wanted, sizeof box) == 0);
    CHECK(memcmp(&zero, &empty, sizeof box) == 0);
    batten_mesh_unref(none);
    batten_mesh_unref(mesh);
}
