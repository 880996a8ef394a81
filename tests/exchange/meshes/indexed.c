#include "exchange/meshes/indexed.h"

#include "exchange/meshes/meshes.h"

/* A mesh of a unit square in the plane z = 0, and a point above it. */
static bat_indexed square(bat_input *input, batten_notes *notes)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.5, 0.5, 1};
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, notes, input));
    input->file = "f";
    bat_indexed mesh = bat_indexed_begin(input);
    mesh.count = 5;
    CHECK_OK(bat_input_array(input, 15, sizeof(double), &mesh.points));
    memcpy(mesh.points, points, sizeof points);
    return mesh;
}

static void add_polygon(bat_indexed *mesh, int line, int count, const int *corners)
{
    for (int k = 0; k < count; k++)
        CHECK_OK(bat_list_add(mesh->input, &mesh->polygon, &(int64_t){corners[k]}));
    CHECK_OK(bat_indexed_polygon(mesh, line));
    CHECK_INT((long long)mesh->polygon.count, 0);
}
#define POLYGON(mesh, line, ...) \
    add_polygon(mesh, line, COUNT(((const int[]){__VA_ARGS__})), (const int[]){__VA_ARGS__})

static batten_model *finish(bat_indexed *mesh)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0, &model));
    CHECK_OK(bat_indexed_add(mesh, "hull", model));
    bat_indexed_end(mesh);
    return model;
}

static void only_once(void)
{
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
}

TEST(polygons_become_triangles_with_one_colour_each)
{
    static const int due[] = {0, 1, 4, 0, 1, 2, 0, 2, 3};
    static const double colours[][3] = {{1, 0, 0.5}, {0, 0.25, 1}};
    bat_input input;
    only_once();
    bat_indexed mesh = square(&input, NULL);
    POLYGON(&mesh, 1, 0, 1, 4);
    CHECK_OK(bat_indexed_colour(&mesh, colours[0]));
    POLYGON(&mesh, 2, 0, 1, 2, 3);
    CHECK_OK(bat_indexed_colour(&mesh, colours[1]));
    CHECK_INT((long long)mesh.cut_up, 1);
    CHECK_INT((long long)mesh.polygons, 2);
    batten_model *model = finish(&mesh);
    CHECK_INT(input.left_out, 0);
    CHECK_TEXT(batten_model_object(model, 0)->name, "hull");
    const batten_mesh_parts *parts = mesh_at(model, 0);
    CHECK_INT(parts->triangle_count, 3);
    CHECK_INT(parts->vertex_count, 5);
    for (int i = 0; i < 9; i++) {
        CHECK_INT(parts->corners[i], due[i]);
        CHECK_BITS(parts->triangle_colours[i], colours[i > 2][i % 3]);
    }
    batten_model_unref(model);
}

TEST(a_face_of_bad_corners_is_left_out_with_its_line_and_number)
{
    static const struct {
        int count, corners[4];
        const char *words;
    } cases[] = {
        {2, {0, 1}, "face 2 is left out: it has 2 corners"},
        {1, {0}, "face 2 is left out: it has 1 corner"},
        {3, {0, 5, 2}, "face 2 is left out: its corner 2 is vertex 6, which does not exist"},
        {3, {0, 1, -1}, "face 2 is left out: its corner 3 is vertex 0, which does not exist"},
        {4,
         {3, 1, 2, 0},
         "face 2 is left out: its corner 1 is vertex 4, which could not be read"},
        {3, {1, 3, 0}, "face 2 is left out: its corner 2 is vertex 4, which could not be read"},
        {3, {1, 5, 0}, "face 2 is left out: its corner 2 is vertex 6, which does not exist"},
    };
    only_once();
    for (int i = 0; i < COUNT(cases); i++) {
        batten_notes *notes = NULL;
        bat_input input;
        CHECK_OK(batten_notes_create(9, &notes));
        bat_indexed mesh = square(&input, notes);
        mesh.points[3 * 3 + 1] = NAN;
        POLYGON(&mesh, 6, 0, 1, 2);
        add_polygon(&mesh, 7, cases[i].count, cases[i].corners);
        CHECK_INT(input.left_out, 1);
        CHECK_INT(batten_notes_count(notes), 1);
        CHECK_TEXT(batten_notes_at(notes, 0)->text, cases[i].words);
        CHECK_INT(batten_notes_at(notes, 0)->line, 7);
        CHECK_TEXT(batten_notes_at(notes, 0)->file, "f");
        CHECK_INT((long long)mesh.triangles.count, 1);
        bat_indexed_end(&mesh);
        batten_notes_free(notes);
    }
}

/* What belongs to vertex i is 10 i + k. */
static double *numbered(bat_input *input, int width)
{
    double *rows = NULL;
    CHECK_OK(bat_input_array(input, 5 * (size_t)width, sizeof *rows, &rows));
    for (int i = 0; i < 5 * width; i++)
        rows[i] = 10 * (i / width) + i % width;
    return rows;
}

TEST(a_vertex_that_could_not_be_read_is_gone_with_all_that_it_carries)
{
    static const int kept[] = {0, 2, 3, 4}, due[] = {0, 1, 2, 1, 2, 3};
    bat_input input;
    only_once();
    bat_indexed mesh = square(&input, NULL);
    mesh.points[3] = NAN;
    double *colours = numbered(&input, 3), *values = numbered(&input, 1);
    for (int i = 0; i < 15; i++)
        colours[i] /= 100;
    mesh.colours = colours;
    mesh.normals = numbered(&input, 3);
    for (int i = 0; i < 5; i++)
        memcpy(mesh.normals + 3 * i, (const double[]){i == 3, i == 2, i != 3 && i != 2},
               3 * sizeof(double));
    CHECK_OK(bat_indexed_attribute(&mesh, (bat_span){"heights", 6}, &values));
    CHECK(values == NULL);
    POLYGON(&mesh, 1, 0, 2, 3);
    POLYGON(&mesh, 1, 2, 3, 4);
    batten_model *model = finish(&mesh);
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->vertex_count, 4);
    CHECK_INT(p->attribute_count, 1);
    CHECK_TEXT(p->attributes[0].name, "height");
    for (int i = 0; i < 4; i++) {
        CHECK_BITS(p->attributes[0].values[i], 10 * kept[i]);
        for (int k = 0; k < 3; k++)
            CHECK_BITS(p->colours[3 * i + k], (10 * kept[i] + k) / 100.0);
    }
    CHECK_BITS(p->points[3 * 1 + 1], 1); /* was vertex 2 */
    CHECK_BITS(p->points[3 * 3 + 2], 1); /* was vertex 4 */
    for (int i = 0; i < 6; i++) {
        CHECK_INT(p->corners[i], due[i]);
        const int vertex = kept[due[i]];
        CHECK_BITS(p->normals[3 * i], vertex == 3);
        CHECK_BITS(p->normals[3 * i + 1], vertex == 2);
        CHECK_BITS(p->normals[3 * i + 2], vertex != 3 && vertex != 2);
    }
    batten_model_unref(model);
}

/* One number of what vertices carry is bent; the note, or NULL when it is good. */
static void check_bent(char which, int at, double value, const char *words)
{
    batten_notes *notes = NULL;
    bat_input input;
    CHECK_OK(batten_notes_create(9, &notes));
    bat_indexed mesh = square(&input, notes);
    double *values = numbered(&input, 1);
    mesh.colours = numbered(&input, 3);
    mesh.normals = numbered(&input, 3);
    for (int i = 0; i < 15; i++) {
        mesh.colours[i] = (i % 3) / 2.0;
        mesh.normals[i] = i % 3 == 1;
    }
    if (which == 'v')
        values[at] = value;
    CHECK_OK(bat_indexed_attribute(&mesh, (bat_span){"h", 1}, &values));
    POLYGON(&mesh, 1, 0, 1, 2);
    POLYGON(&mesh, 1, 0, 2, 3);
    CHECK_OK(bat_indexed_colour(&mesh, (const double[]){0, 0.5, 1}));
    if (which == 'c')
        mesh.colours[at] = value;
    if (which == 't')
        ((double *)mesh.triangle_colours.items)[at] = value;
    if (which == 'n')
        mesh.normals[at] = value;
    batten_model *model = finish(&mesh);
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->colours == NULL, words && which == 'c');
    CHECK_INT(p->triangle_colours == NULL, words && which == 't');
    CHECK_INT(p->normals == NULL, words && which == 'n');
    CHECK_INT(p->attribute_count, !(words && which == 'v'));
    CHECK_INT(input.left_out, words != NULL);
    CHECK_INT(batten_notes_count(notes), words != NULL);
    if (words) {
        const batten_note *note = batten_notes_at(notes, 0);
        CHECK_TEXT(note->text, words);
        CHECK_INT(note->line, 0);
        CHECK_TEXT(note->entity, which == 'v' ? "h" : "");
    }
    batten_model_unref(model);
    batten_notes_free(notes);
}

TEST(colours_are_parts_from_0_to_1_or_left_out)
{
    only_once();
    check_bent('c', 7, 0, NULL);
    check_bent('c', 7, 1, NULL);
    check_bent('c', 7, 1.5, "the colours are left out: part 2 of vertex 3 is 1.5 of 1");
    check_bent('c', 14, -0.5, "the colours are left out: part 3 of vertex 5 is -0.5 of 1");
    check_bent('c', 0, NAN, "the colours are left out: part 1 of vertex 1 is nan of 1");
    check_bent('t', 5, 1, NULL);
    check_bent('t', 5, 2, "the colours are left out: part 3 of triangle 2 is 2 of 1");
    check_bent('t', 0, -1, "the colours are left out: part 1 of triangle 1 is -1 of 1");
}

TEST(normals_have_the_length_1_or_0_up_to_the_digits_of_a_file)
{
    only_once();
    check_bent('n', 4, 1.0009, NULL);
    check_bent('n', 4, 0.9991, NULL);
    check_bent('n', 4, 0, NULL);
    check_bent(
        'n', 4, 1.002,
        "the normals are left out: that of vertex 2, (0, 1.002, 0), has not the length 1");
    check_bent('n', 4, 0.9,
               "the normals are left out: that of vertex 2, (0, 0.9, 0), has not the length 1");
    check_bent('n', 2, 1,
               "the normals are left out: that of vertex 1, (0, 1, 1), has not the length 1");
    check_bent('n', 12, NAN,
               "the normals are left out: that of vertex 5, (nan, 1, 0), has not the length 1");
}

TEST(values_of_vertices_are_finite_or_left_out)
{
    only_once();
    check_bent('v', 4, 1e300, NULL);
    check_bent('v', 4, INFINITY, "left out: its value at vertex 5 is not finite");
    check_bent('v', 0, NAN, "left out: its value at vertex 1 is not finite");
}

TEST(of_two_values_the_good_one_stays)
{
    bat_input input;
    only_once();
    bat_indexed mesh = square(&input, NULL);
    double *bad = numbered(&input, 1), *good = numbered(&input, 1);
    bad[2] = NAN;
    CHECK_OK(bat_indexed_attribute(&mesh, (bat_span){"bad", 3}, &bad));
    CHECK_OK(bat_indexed_attribute(&mesh, (bat_span){"good", 4}, &good));
    POLYGON(&mesh, 1, 0, 1, 2);
    batten_model *model = finish(&mesh);
    CHECK_INT(mesh_at(model, 0)->attribute_count, 1);
    CHECK_TEXT(mesh_at(model, 0)->attributes[0].name, "good");
    CHECK_BITS(mesh_at(model, 0)->attributes[0].values[4], 40);
    batten_model_unref(model);
}

TEST(vertices_without_faces_are_points_and_what_they_lose_is_listed)
{
    static const char *const due[] = {"",
                                      "normals",
                                      "colours",
                                      "normals, colours",
                                      "1 further value",
                                      "normals, 1 further value",
                                      "colours, 1 further value",
                                      "normals, colours, 1 further value"};
    only_once();
    for (int bits = 0; bits < 8; bits++) {
        batten_notes *notes = NULL;
        bat_input input;
        char words[200];
        CHECK_OK(batten_notes_create(9, &notes));
        bat_indexed mesh = square(&input, notes);
        double *values = numbered(&input, 1);
        mesh.normals = bits & 1 ? numbered(&input, 3) : NULL;
        mesh.colours = bits & 2 ? numbered(&input, 3) : NULL;
        for (int i = 0; i < 15; i++) {
            if (mesh.normals)
                mesh.normals[i] = i % 3 == 2;
            if (mesh.colours)
                mesh.colours[i] = 0.5;
        }
        if (bits & 4)
            CHECK_OK(bat_indexed_attribute(&mesh, (bat_span){"h", 1}, &values));
        batten_model *model = finish(&mesh);
        const batten_object *object = batten_model_object(model, 0);
        CHECK_INT(object->kind, BATTEN_OBJECT_POINTS);
        CHECK_INT(object->point_count, 5);
        CHECK_BITS(object->points[14], 1);
        CHECK_INT(batten_notes_count(notes), bits > 0);
        snprintf(words, sizeof words,
                 "of points only coordinates are kept; left out of 5 points: %s", due[bits]);
        if (bits) {
            CHECK_TEXT(batten_notes_at(notes, 0)->text, words);
            CHECK_TEXT(batten_notes_at(notes, 0)->entity, "points");
            CHECK_INT(batten_notes_at(notes, 0)->line, 0);
        }
        batten_release(values);
        batten_model_unref(model);
        batten_notes_free(notes);
    }
}

TEST(faces_that_cross_themselves_are_noted_with_their_number)
{
    batten_notes *notes = NULL;
    bat_input input;
    only_once();
    CHECK_OK(batten_notes_create(9, &notes));
    bat_indexed mesh = square(&input, notes);
    mesh.points[3 * 3 + 1] = 0.5; /* the two halves of the bow differ, or it had no side */
    POLYGON(&mesh, 1, 0, 2, 1, 3);
    POLYGON(&mesh, 1, 0, 1, 2, 3);
    POLYGON(&mesh, 1, 0, 1, 4);
    batten_model *model = finish(&mesh);
    CHECK(has_note(notes, "faces of more than three corners: 2; read as triangles"));
    CHECK(has_note(notes, "1 of 3 faces cross themselves, or have a bay and more than 100 "
                          "corners: their triangles overlap"));
    batten_model_unref(model);
    batten_notes_free(notes);
}

TEST(a_mesh_of_no_vertex_adds_nothing)
{
    bat_input input;
    batten_model *model = NULL;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    bat_indexed mesh = bat_indexed_begin(&input);
    CHECK_OK(batten_model_create(0, &model));
    CHECK_OK(bat_indexed_add(&mesh, "hull", model));
    CHECK_INT(batten_model_count(model), 0);
    bat_indexed_end(&mesh);
    batten_model_unref(model);
}

TEST(triangles_are_limited_by_the_number_of_entities)
{
    bat_input input;
    only_once();
    bat_indexed mesh = square(&input, NULL);
    input.limits.entities = 2;
    POLYGON(&mesh, 1, 0, 1, 2);
    POLYGON(&mesh, 1, 0, 1, 3);
    for (int k = 0; k < 3; k++)
        CHECK_OK(bat_list_add(&input, &mesh.polygon, &(int64_t){k}));
    CHECK_STATUS(bat_indexed_polygon(&mesh, 9), BATTEN_TOO_LARGE);
    CHECK_TEXT(batten_message(), "f:9: 3 triangles; the limit is 2");
    bat_indexed_end(&mesh);
}

/* A vertex with a colour, a normal and a value; a face of four corners and one of three. Read
 * with every allocation failing once. */
TEST(a_mesh_is_read_with_all_that_its_vertices_carry)
{
    static const char text[] =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
        "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float heat\n"
        "property float age\nelement face 2\nproperty list uchar int vertex_indices\n"
        "end_header\n0 0 0 0 0 1 255 0 0 10 1\n1 0 0 0 0 1 255 0 51 11 2\n"
        "1 1 0 0 0 1 255 51 0 12 3\n0 1 0 0 0 1 0 0 0 13 4\n0 2 0 0 0 1 0 0 0 14 5\n"
        "4 0 1 2 3\n3 3 2 4\n";
    batten_model *model = NULL;
    CHECK_OK(read_text(text, BATTEN_FORMAT_PLY, NULL, &model));
    const batten_mesh_parts *p = mesh_at(model, 0);
    CHECK_INT(p->triangle_count, 3);
    CHECK_INT(p->vertex_count, 5);
    CHECK_INT(p->attribute_count, 2);
    CHECK_TEXT(p->attributes[0].name, "heat");
    CHECK_TEXT(p->attributes[1].name, "age");
    for (int i = 0; i < 5; i++)
        CHECK(p->attributes[0].values[i] == 10 + i && p->attributes[1].values[i] == 1 + i);
    batten_model_unref(model);
}
