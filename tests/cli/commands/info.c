#include "support/process.h"

#include <batten/exchange.h>
#include <stdio.h>
#include <string.h>

/* A tetrahedron without its last face, and a triangle without area, as a file. */
static const char *write_mesh(const char *name)
{
    const char *path = test_scratch(name);
    test_write(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 5 5\n"
                     "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 1 2 2\n");
    return path;
}

static const char face[] = "210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n"
                           "0 0 1\n4 0 1\n0 4 1\n4 4 1\n1\n3 1e-6\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n1 1\n3 1\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n3 1\n2 3\n"
                           "1 100 0\n2 0\n2 2\n0 0 1 1\n2 3\n1 1\n"
                           "100 1 0 0\n3 0\n4 2\n0 0 1e-9 1 2 2\n0 0 0\n1 0 0\n2 0 0\n3 0 0\n";

TEST(info_tells_of_meshes_and_what_is_odd_with_them)
{
    const char *path = write_mesh("open.obj");
    test_process run = RUN("batten", "info", path);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "4 triangles, 4 vertices");
    CHECK_CONTAINS(run.out, "not watertight");
    CHECK_CONTAINS(run.errors, "triangles without area: 1");
    CHECK_CONTAINS(run.errors, "edges of one triangle, its rim: 3");
    run = RUN("batten", "info", path, "--no-lint");
    CHECK(strstr(run.errors, "without area") == NULL);
    run = RUN("batten", "info", path, "--json");
    CHECK_CONTAINS(run.out, "\"triangles\": 4");
    CHECK_CONTAINS(run.out, "\"watertight\": false");
}

TEST(info_tells_of_faces_and_near_knots)
{
    const char *path = test_scratch("face.g2");
    test_write(path, face);
    test_process run = RUN("batten", "info", path);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "2 objects (1 curve, 1 sheet), unit not stated");
    CHECK_CONTAINS(run.out, "bounded surface 1: sheet, 1 face, 3 edges, 3 vertices, 1 shell");
    CHECK_CONTAINS(run.errors, "spline curve 2: two knots are only 5e-10 of the domain apart");
    run = RUN("batten", "info", path, "--json");
    CHECK_CONTAINS(run.out, "\"type\": \"sheet\", \"kind\": \"body\"");
    CHECK_CONTAINS(run.out, "\"faces\": 1, \"edges\": 3, \"vertices\": 3, \"shells\": 1");
    CHECK_CONTAINS(run.out, "\"hidden\": false");
    CHECK_CONTAINS(run.out, "\"coloured_faces\": 0");
}

/* A point cloud within two instances, and an instance beside them, as a STEP file. */
static const char *write_assembly(void)
{
    static const double points[] = {1, 2, 3};
    const char *path = test_scratch("assembly.step");
    static const char *const names[] = {"bolt", "arm #2", "crane"};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = names[0],
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 1,
                                                      .points = points}));
    for (int i = 1; i < 3; i++) {
        batten_model *outer = NULL;
        CHECK_OK(batten_model_create(0.001, &outer));
        CHECK_OK(batten_model_add(
            outer, &(batten_object){.name = names[i],
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = model,
                                    .place = batten_affine_translation(10, 0, 0)}));
        batten_model_unref(model);
        model = outer;
    }
    CHECK_OK(batten_write_file(model, path, NULL, NULL));
    batten_model_unref(model);
    return path;
}

TEST(names_that_info_shows_name_objects)
{
    static const char *const names[] = {"crane/arm #2/bolt", "crane", "crane/arm #2"};
    const char *path = write_assembly();
    CHECK_CONTAINS(RUN("batten", "info", path).out, "\ncrane/arm #2/bolt: points");
    for (int i = 0; i < COUNT(names); i++) {
        char word[4096];
        snprintf(word, sizeof word, "%s#%s", path, names[i]);
        test_process run = RUN("batten", "info", word);
        CHECK_INT(run.exit, 0);
        CHECK_CONTAINS(run.out, ": 1 object, unit mm\ncrane/arm #2/bolt: points, 1\n");
        CHECK_CONTAINS(run.out, "box 21 2 3");
        CHECK_INT(RUN("batten", "convert", word, test_scratch("bolt.xyz")).exit, 0);
        CHECK_TEXT(test_content(test_scratch("bolt.xyz")), "x_mm y_mm z_mm\n21 2 3\n");
        strcat(word, "t");
        run = RUN("batten", "info", word);
        CHECK_INT(run.exit, 1);
        CHECK_CONTAINS(run.errors, "' in the file; there is 'crane/arm #2/bolt'");
    }
}

/* One point each; a name of one letter is a name, and what an object has not is not said. */
static const batten_object looks[] = {
    {.name = "plain", .kind = BATTEN_OBJECT_POINTS},
    {.name = "both", .layer = "L", .group = "G", .kind = BATTEN_OBJECT_POINTS},
    {.name = "orange", .has_colour = true, .colour = {1, 0.5, 0}, .kind = BATTEN_OBJECT_POINTS},
    {.name = "all",
     .layer = "L",
     .group = "G",
     .is_hidden = true,
     .has_colour = true,
     .kind = BATTEN_OBJECT_POINTS},
};

TEST(info_shows_layer_group_colour_and_what_is_hidden)
{
    static const double point[] = {1, 2, 3};
    const char *path = test_scratch("looks.step");
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(looks); i++) {
        batten_object object = looks[i];
        object.point_count = 1;
        object.points = point;
        CHECK_OK(batten_model_add(model, &object));
    }
    CHECK_OK(batten_write_file(model, path, NULL, NULL));
    batten_model_unref(model);
    const test_process run = RUN("batten", "info", path);
    CHECK_CONTAINS(run.out, "\nplain: points, 1\n    box 1 2 3  to  1 2 3\nboth: points, 1\n");
    CHECK_CONTAINS(run.out, "\n    layer L  group G\n");
    CHECK_CONTAINS(run.out, "\n    colour #ff8000\n");
    CHECK_CONTAINS(run.out, "\n    layer L  group G  colour #000000  hidden\n");
}

TEST(an_instance_within_an_instance_comes_without_those_beside_it)
{
    static const double points[] = {1, 2, 3};
    static const char *const names[] = {"left", "left/of", "right"};
    const char *path = test_scratch("pairs.step");
    batten_model *bolt = NULL, *pair = NULL, *all = NULL;
    CHECK_OK(batten_model_create(0.001, &bolt));
    CHECK_OK(batten_model_create(0.001, &pair));
    CHECK_OK(batten_model_create(0.001, &all));
    CHECK_OK(batten_model_add(bolt, &(batten_object){.name = "tip",
                                                     .kind = BATTEN_OBJECT_POINTS,
                                                     .point_count = 1,
                                                     .points = points}));
    for (int i = 0; i < 3; i++) {
        CHECK_OK(batten_model_add(
            pair, &(batten_object){.name = names[i],
                                   .kind = BATTEN_OBJECT_INSTANCE,
                                   .definition = bolt,
                                   .place = batten_affine_translation(10 * i, 0, 0)}));
    }
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(
            all, &(batten_object){.name = i ? "b" : "a/b",
                                  .kind = BATTEN_OBJECT_INSTANCE,
                                  .definition = pair,
                                  .place = batten_affine_translation(0, 100 * i, 0)}));
    CHECK_OK(batten_write_file(all, path, NULL, NULL));
    batten_model_unref(all);
    batten_model_unref(pair);
    batten_model_unref(bolt);
    static const char *const rows[][2] = {{"b/right", "x_mm y_mm z_mm\n21 102 3\n"},
                                          {"b/left/of", "x_mm y_mm z_mm\n11 102 3\n"},
                                          {"a/b/left", "x_mm y_mm z_mm\n1 2 3\n"},
                                          {"a/b/left/of/tip", "x_mm y_mm z_mm\n11 2 3\n"}};
    for (int i = 0; i < COUNT(rows); i++) {
        char word[4096];
        snprintf(word, sizeof word, "%s#%s", path, rows[i][0]);
        CHECK_INT(RUN("batten", "convert", word, test_scratch("one.xyz")).exit, 0);
        CHECK_TEXT(test_content(test_scratch("one.xyz")), rows[i][1]);
    }
}

TEST(the_format_can_be_told_wherever_a_file_is_read)
{
    const char *path = test_scratch("told");
    test_write(path, "1 0\n0.5 0.1\n0 0\n0.5 -0.1\n1 0\n");
    static const char *const commands[] = {"info", "measure", "check", "eval"};
    for (int i = 0; i < COUNT(commands); i++) {
        test_process run = RUN("batten", commands[i], path, "--from-format", "ply", "--at=0");
        if (i != 3)
            run = RUN("batten", commands[i], path, "--from-format", "ply");
        CHECK_INT(run.exit, 1);
        CHECK_CONTAINS(run.errors, "the first line is not 'ply'");
    }
    CHECK_INT(RUN("batten", "info", path, "--from-format", "points").exit, 0);
    const test_process run = RUN("batten", "measure", path, "--from-format", "plyy");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "did you mean 'ply'?");
}

/* A square on a plane, trimmed by two of the three sides of a triangle, or by all. */
TEST(measure_exits_with_3_when_faces_are_not_measured)
{
    static const char open_loop[] = "210 1 0 0\n200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n"
                                    "0 0 1\n4 0 1\n0 4 1\n4 4 1\n1\n2 1e-6\n"
                                    "1 100 0\n2 0\n2 2\n0 0 1 1\n1 1\n3 1\n"
                                    "1 100 0\n2 0\n2 2\n0 0 1 1\n3 1\n2 3\n";
    const char *whole = test_scratch("whole.g2"), *part = test_scratch("part.g2");
    test_write(whole, face);
    test_write(part, open_loop);
    test_process run = RUN("batten", "measure", whole);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "area 2");
    run = RUN("batten", "measure", part);
    CHECK_INT(run.exit, 3);
    CHECK_CONTAINS(run.errors, "1 of 1 faces have no closed loops in their parameters");
    run = RUN("batten", "measure", part, "--json");
    CHECK_INT(run.exit, 3);
    CHECK_CONTAINS(run.out, "\"unmeasured_faces\": 1");
    const char *design = test_scratch("part.yaml");
    test_write(design, "batten: 1\nfeatures:\n  face: {read: part.g2}\noutputs:\n"
                       "  part.txt: {measure: face}\n");
    CHECK_INT(RUN("batten", "build", design).exit, 3);
}

/* A tetrahedron without its floor, and one whose floor is turned. */
static const char open_mesh[] = "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                "3 0 1 3\n3 1 2 3\n3 2 0 3\n";
static const char turned_mesh[] = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                  "3 0 1 3\n3 1 2 3\n3 2 0 3\n3 0 1 2\n";

TEST(meshes_that_are_not_closed_say_why)
{
    const char *rim = test_scratch("rim.off"), *turned = test_scratch("turned.off");
    test_write(rim, open_mesh);
    test_write(turned, turned_mesh);
    CHECK_CONTAINS(RUN("batten", "info", rim, "--no-lint").out,
                   "not watertight: 3 edges at the rim\n");
    CHECK_CONTAINS(RUN("batten", "info", turned, "--no-lint").out,
                   "not watertight: 3 edges between triangles turned against each other\n");
    CHECK_CONTAINS(RUN("batten", "info", rim, "--json").out,
                   "\"watertight\": false, \"rim_edges\": 3, \"wrong_edges\": 0");
    CHECK_CONTAINS(RUN("batten", "measure", rim).out,
                   "\n  not closed for 3 edges at the rim\n");
    CHECK_CONTAINS(RUN("batten", "measure", turned, "--json").out, "\"wrong_edges\": 3");
}

TEST(an_open_mesh_does_not_pass_a_check_with_a_bound)
{
    const char *rim = test_scratch("rim.off"), *whole = test_scratch("whole.yaml");
    test_write(rim, open_mesh);
    test_process run = RUN("batten", "check", rim, "--within", "1 mm");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.out, "the mesh is not closed.\n");
    CHECK(!strstr(run.out, "bodies"));
    CHECK_INT(RUN("batten", "check", rim).exit, 0);
    test_write(whole, "batten: 1\nfeatures:\n  b: {sphere: 1}\n  m: {mesh: b}\n"
                      "outputs:\n  whole.stl: m\n");
    CHECK_INT(RUN("batten", "build", whole, "-q").exit, 0);
    run = RUN("batten", "check", test_scratch("whole.stl"), "--within", "1 mm");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "the mesh is closed.\n");
}

TEST(info_shows_colours)
{
    const double points[3] = {1, 2, 3};
    const char *path = test_scratch("red.step");
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "dot",
                                                      .layer = "marks",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .has_colour = true,
                                                      .colour = {1, 0.5, 0},
                                                      .point_count = 1,
                                                      .points = points}));
    CHECK_OK(batten_write_file(model, path, NULL, NULL));
    batten_model_unref(model);
    CHECK_CONTAINS(RUN("batten", "info", path).out, "\n    layer marks  colour #ff8000\n");
}

TEST(measure_says_the_unit_once)
{
    const char *points = test_scratch("dots.csv"), *mesh = test_scratch("rim.off");
    test_write(points, "x_mm,y_mm,z_mm\n1,2,3\n4,-2,8\n");
    test_write(mesh, open_mesh);
    CHECK(strncmp(RUN("batten", "measure", points).out, "unit mm\n", 8) == 0);
    CHECK_CONTAINS(RUN("batten", "measure", points).out,
                   ": 2 points\n  box 1 -2 3  to  4 2 8\n");
    CHECK_CONTAINS(RUN("batten", "measure", points, "--json").out, "\"unit\": \"mm\",");
    CHECK_CONTAINS(RUN("batten", "measure", points, "--json").out,
                   "\"type\": \"points\", \"count\": 2, \"box\": [[1, -2, 3], [4, 2, 8]]");
    CHECK(strncmp(RUN("batten", "measure", mesh).out, "unit not stated\n", 16) == 0);
    CHECK_CONTAINS(RUN("batten", "measure", mesh, "--json").out, "\"unit\": \"\"");
    CHECK(strncmp(RUN("batten", "measure", mesh, "--unit", "in").out, "unit in\n", 8) == 0);
}
