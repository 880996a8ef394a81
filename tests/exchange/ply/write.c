/* Meshes and points as PLY files. */
#include "exchange/meshes/meshes.h"

TEST(ply_is_written_so)
{
    batten_model *model = NULL;
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = tetrahedron_points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, NULL, &data, &size));
    CHECK_TEXT(data, "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty "
                     "double y\nproperty double z\nelement face 1\nproperty list uchar int "
                     "vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    batten_release(data);
    batten_model_unref(model);
}

TEST(objects_become_one_mesh_in_ply_with_their_colours)
{
    batten_model *model = NULL;
    batten_mesh *mesh = NULL;
    const batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "plain", &parts);
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "red",
                                                      .has_colour = true,
                                                      .colour = {1, 0, 0},
                                                      .kind = BATTEN_OBJECT_MESH,
                                                      .mesh = mesh}));
    batten_mesh_unref(mesh);
    batten_model *back = check_second(model, BATTEN_FORMAT_PLY, false);
    const batten_mesh_parts *p = mesh_at(back, 0);
    CHECK_INT(p->vertex_count, 8);
    CHECK_INT(p->triangle_count, 8);
    CHECK_INT(p->corners[12], 4);
    CHECK(p->colours[12] == 1 && p->colours[13] == 0);
    CHECK_NEAR(p->colours[0], 0.8, 1e-15);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(normals_that_differ_at_a_vertex_are_left_out_of_ply_with_a_note)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    double normals[36] = {0};
    batten_mesh_parts parts = tetrahedron();
    char *data = NULL;
    size_t size = 0;
    for (int i = 0; i < 12; i++)
        normals[3 * i + i / 3 % 3] = 1;
    parts.normals = normals;
    CHECK_OK(batten_model_create(0, &model));
    add_mesh(model, "s", &parts);
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, notes, &data, &size));
    CHECK(strstr(data, "nx") == NULL);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, "they differ between the faces at a vertex"));
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* Of two objects none, one or both have normals at their corners. */
TEST(normals_are_written_when_all_objects_have_them)
{
    for (int k = 0; k < 4; k++) {
        batten_model *model = NULL;
        batten_notes *notes = NULL;
        double normals[36] = {0};
        char *data = NULL;
        size_t size = 0;
        for (int i = 0; i < 12; i++)
            normals[3 * i + 2] = 1;
        CHECK_OK(batten_model_create(1, &model));
        CHECK_OK(batten_notes_create(10, &notes));
        for (int i = 0; i < 2; i++) {
            batten_mesh_parts parts = tetrahedron();
            parts.normals = k >> i & 1 ? normals : NULL;
            add_mesh(model, "s", &parts);
        }
        CHECK_OK(write_form(model, BATTEN_FORMAT_PLY, true, notes, &data, &size));
        CHECK((strstr(data, "property double nx") != NULL) == (k == 3));
        CHECK((strstr(data, "\n1 0 0 0 0 1\n") != NULL) == (k == 3));
        if (batten_notes_dropped(notes) == 0)
            CHECK(has_note(notes, "the normals are left out: not all objects have them") ==
                  (k == 1 || k == 2));
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(faces_have_colours_that_come_back)
{
    const char *text = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\n"
                       "property double y\nproperty double z\nelement face 2\n"
                       "property list uchar int vertex_indices\nproperty uchar red\n"
                       "property uchar green\nproperty uchar blue\nproperty uchar flags\n"
                       "end_header\n0 0 0\n1 0 0\n1 1 0\n0 0 1\n4 0 1 2 3 255 0 51 1\n"
                       "3 0 1 3 0 255 0 2\n";
    batten_model *model =
        read_noting(text, BATTEN_FORMAT_AUTO, "property 'flags' of the faces is left out");
    batten_model *back = check_second(model, BATTEN_FORMAT_PLY, true);
    for (int m = 0; m < 2; m++) {
        const batten_mesh_parts *p = mesh_at(m ? back : model, 0);
        CHECK_INT(p->triangle_count, 3);
        CHECK(p->triangle_colours != NULL && !p->colours);
        for (int i = 0; p->triangle_colours && i < 3; i++) {
            CHECK_NEAR(p->triangle_colours[3 * i], i < 2 ? 1 : 0, 1e-15);
            CHECK_NEAR(p->triangle_colours[3 * i + 2], i < 2 ? 0.2 : 0, 1e-15);
        }
    }
    batten_model_unref(back);
    batten_model_unref(model);
}
