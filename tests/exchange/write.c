#include "exchange/meshes/meshes.h"
#include "exchange/shapes.h"

#include <batten/standard.h>

TEST(a_model_is_written_in_the_format_of_its_name)
{
    const struct {
        const char *name, *begins;
    } cases[] = {{"a.igs", "Written by Batten"},
                 {"a.step", "ISO-10303-21;"},
                 {"a.xyz", "x_m"},
                 {"a.csv", "x_m"},
                 {"a.dat", "aerofoil"}};
    const double points[] = {1, 0.1, 0, 0, 0, 0, 1, 0, 0};
    test_random random = test_random_begin(__func__);
    batten_model *model = NULL;
    batten_curve *curve = random_curve(&random);
    CHECK_OK(batten_model_create(1, &model));
    add_curve(model, "keel", curve);
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 3,
                                                      .points = points}));
    for (int i = 0; i < COUNT(cases); i++) {
        size_t size = 0;
        const char *path = test_scratch(cases[i].name);
        CHECK_OK(batten_write_file(model, path, NULL, NULL));
        CHECK(strncmp(load_bytes(path, &size), cases[i].begins, strlen(cases[i].begins)) == 0);
    }
    CHECK_STATUS(batten_write_file(model, "/tmp/a.foo", NULL, NULL), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("the ending of '/tmp/a.foo' names no format");
    batten_curve_unref(curve);
    batten_model_unref(model);
}

TEST(bad_options_are_refused)
{
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    batten_write_options options = batten_write_defaults();
    CHECK_OK(batten_model_create(1, &model));
    CHECK_STATUS(batten_write_memory(model, &options, NULL, &data, &size), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_write_memory(model, NULL, NULL, &data, &size), BATTEN_BAD_ARGUMENT);
    options.format = BATTEN_FORMAT_STEP;
    const double tolerances[] = {-1, NAN, INFINITY};
    for (int i = 0; i < COUNT(tolerances); i++) {
        options.tolerance = tolerances[i];
        CHECK_STATUS(batten_write_memory(model, &options, NULL, &data, &size),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE("the tolerance is");
    }
    options.tolerance = 0;
    options.name = "";
    const double origin[3] = {0, 0, 0};
    CHECK_OK(batten_model_add(
        model,
        &(batten_object){.kind = BATTEN_OBJECT_POINTS, .point_count = 1, .points = origin}));
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_CONTAINS(data, "FILE_NAME('batten','2000-01-01T00:00:00'");
    batten_release(data);
    batten_model_unref(model);
}

/* A model without objects, and one that only places such a model. */
static batten_model *empty_model(bool placed)
{
    batten_model *model = NULL, *none = NULL;
    CHECK_OK(batten_model_create(1, &model));
    if (!placed)
        return model;
    CHECK_OK(batten_model_create(1, &none));
    CHECK_OK(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = none,
                                                      .place = batten_affine_identity()}));
    batten_model_unref(none);
    return model;
}

TEST(a_file_with_nothing_in_it_is_not_written_in_any_format)
{
    for (int placed = 0; placed < 2; placed++) {
        batten_model *model = empty_model(placed);
        for (int format = 1; format <= BATTEN_FORMAT_OFF; format++) {
            batten_write_options options = batten_write_defaults();
            char *data = NULL;
            size_t size = 0;
            options.format = (batten_format)format;
            options.schema = BATTEN_STEP_AP242;
            CHECK_STATUS(batten_write_memory(model, &options, NULL, &data, &size),
                         BATTEN_UNSUPPORTED);
            CHECK(!data);
        }
        batten_model_unref(model);
    }
}

/* A mesh and a line side by side in what is placed, the instance hidden. */
static batten_model *hidden_model(void)
{
    const batten_mesh_parts parts = tetrahedron();
    batten_model *inner = NULL, *model = NULL;
    CHECK_OK(batten_model_create(0.001, &inner));
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(inner, "tip", &parts);
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "seen" : "away",
                                                          .is_hidden = i == 0,
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = inner,
                                                          .place = batten_affine_identity()}));
    batten_model_unref(inner);
    return model;
}

TEST(what_a_format_cannot_hide_is_written_and_counted)
{
    static const batten_format formats[] = {BATTEN_FORMAT_STL, BATTEN_FORMAT_PLY,
                                            BATTEN_FORMAT_OBJ, BATTEN_FORMAT_GLTF,
                                            BATTEN_FORMAT_3MF, BATTEN_FORMAT_STEP};
    batten_model *model = hidden_model();
    for (int i = 0; i < COUNT(formats); i++) {
        batten_write_options options = batten_write_defaults();
        batten_model *prepared = NULL;
        batten_notes *notes = NULL;
        const bool hides = formats[i] == BATTEN_FORMAT_STEP;
        options.format = formats[i];
        options.schema = BATTEN_STEP_AP242;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_write_prepare(model, &options, notes, &prepared));
        CHECK_INT(batten_model_count(prepared), 2);
        CHECK(batten_model_object(prepared, 0)->is_hidden == hides);
        if (!batten_notes_dropped(notes)) {
            CHECK_INT(count_warnings(notes), hides ? 0 : 1);
            CHECK(has_note(notes, "hidden objects: 1; ") == !hides);
        }
        batten_model_unref(prepared);
        batten_notes_free(notes);
    }
    batten_model_unref(model);
}

TEST(formats_that_hide_keep_what_is_hidden)
{
    static const batten_format formats[] = {BATTEN_FORMAT_STEP, BATTEN_FORMAT_IGES,
                                            BATTEN_FORMAT_DXF, BATTEN_FORMAT_SVG};
    const double a[3] = {0, 0, 0}, b[3] = {1, 2, 0};
    batten_model *model = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "seen" : "away",
                                                          .layer = "lines",
                                                          .is_hidden = i == 0,
                                                          .kind = BATTEN_OBJECT_CURVE,
                                                          .curve = line}));
    for (int i = 0; i < COUNT(formats); i++) {
        char *data = NULL;
        size_t size = 0;
        batten_model *back = NULL;
        CHECK_OK(write_bytes(model, formats[i], &data, &size));
        CHECK_OK(read_bytes(data, size, formats[i], NULL, &back));
        CHECK_INT(batten_model_count(back), 2);
        for (int k = 0; k < 2; k++)
            CHECK(batten_model_object(back, k)->is_hidden == (k == 0));
        batten_release(data);
        batten_model_unref(back);
    }
    batten_curve_unref(line);
    batten_model_unref(model);
}

/* An instance of an instance of a line and, if asked for, of a mesh. */
static batten_model *nested_line(bool with_mesh)
{
    const batten_mesh_parts parts = tetrahedron();
    const double a[3] = {0, 0, 0}, b[3] = {1, 2, 0};
    batten_model *inner = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_model_create(0.001, &inner));
    add_curve(inner, "line", line);
    for (int depth = 0; depth < 2; depth++) {
        batten_model *outer = NULL;
        CHECK_OK(batten_model_create(0.001, &outer));
        CHECK_OK(batten_model_add(outer, &(batten_object){.name = depth ? "arm" : "hand",
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = inner,
                                                          .place = batten_affine_identity()}));
        batten_model_unref(inner);
        inner = outer;
    }
    if (with_mesh)
        add_mesh(inner, "tip", &parts);
    batten_curve_unref(line);
    return inner;
}

TEST(instances_of_what_a_format_does_not_hold_are_left_out)
{
    static const batten_format formats[] = {BATTEN_FORMAT_GLTF, BATTEN_FORMAT_3MF,
                                            BATTEN_FORMAT_STL};
    for (int i = 0; i < 2 * COUNT(formats); i++) {
        batten_write_options options = batten_write_defaults();
        batten_model *model = nested_line(i % 2), *prepared = NULL;
        batten_notes *notes = NULL;
        options.format = formats[i / 2];
        CHECK_OK(batten_notes_create(10, &notes));
        if (i % 2 == 0) {
            CHECK_STATUS(batten_write_prepare(model, &options, notes, &prepared),
                         BATTEN_UNSUPPORTED);
            CHECK_MESSAGE("files hold meshes, and none of the 1 object ('arm' first) is of "
                          "that kind");
        } else {
            CHECK_OK(batten_write_prepare(model, &options, notes, &prepared));
            CHECK_INT(batten_model_count(prepared), 1);
            CHECK_TEXT(batten_model_object(prepared, 0)->name, "tip");
            if (!batten_notes_dropped(notes))
                CHECK(has_note(notes, "not this curve") &&
                      (formats[i / 2] == BATTEN_FORMAT_STL ||
                       has_note(notes, "left out: this instance places nothing")));
        }
        batten_model_unref(prepared);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(a_mesh_without_triangles_is_left_out_of_formats_of_triangles)
{
    const double point[3] = {0, 0, 0};
    const batten_mesh_parts parts = {.vertex_count = 1, .points = point};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "nothing", &parts);
    batten_write_options options = batten_write_defaults();
    batten_model *prepared = NULL;
    options.format = BATTEN_FORMAT_GLTF;
    CHECK_STATUS(batten_write_prepare(model, &options, NULL, &prepared), BATTEN_UNSUPPORTED);
    batten_model_unref(model);
}

TEST(what_a_format_does_not_keep_of_a_mesh_is_noted)
{
    static const struct {
        batten_format format;
        const char *loses;
    } cases[] = {{BATTEN_FORMAT_PLY, ""},
                 {BATTEN_FORMAT_GLTF, "v"},
                 {BATTEN_FORMAT_OBJ, "tv"},
                 {BATTEN_FORMAT_3MF, "cv"},
                 {BATTEN_FORMAT_STL, "ctv"}};
    const double colours[12] = {1}, values[4] = {1, 2, 3, 4};
    const batten_mesh_attribute attribute = {"quality", values};
    batten_mesh_parts parts = tetrahedron();
    batten_model *model = NULL;
    parts.colours = parts.triangle_colours = colours;
    parts.attribute_count = 1;
    parts.attributes = &attribute;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "tip", &parts);
    for (int i = 0; i < COUNT(cases); i++) {
        batten_write_options options = batten_write_defaults();
        batten_model *prepared = NULL;
        batten_notes *notes = NULL;
        const char *loses = cases[i].loses;
        options.format = cases[i].format;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_write_prepare(model, &options, notes, &prepared));
        const batten_mesh_parts *p = batten_mesh_view(batten_model_object(prepared, 0)->mesh);
        CHECK((p->colours == NULL) == (strchr(loses, 'c') != NULL));
        CHECK((p->triangle_colours == NULL) == (strchr(loses, 't') != NULL));
        CHECK((p->attribute_count == 0) == (strchr(loses, 'v') != NULL));
        if (!batten_notes_dropped(notes)) {
            CHECK(has_note(notes, "colours of its vertices") == (strchr(loses, 'c') != NULL));
            CHECK(has_note(notes, "colours of its faces") == (strchr(loses, 't') != NULL));
            CHECK(has_note(notes, "further values of each vertex: 1;") ==
                  (strchr(loses, 'v') != NULL));
        }
        batten_model_unref(prepared);
        batten_notes_free(notes);
    }
    batten_model_unref(model);
}

/* Curves with all that a file can say of them; those called by readers lose no name. */
static batten_model *looking_model(void)
{
    static const char *const names[] = {"Station 155.000 m", "curve D1", "LINE 12", "keel"};
    const double a[3] = {0, 0, 0}, b[3] = {1, 2, 0};
    batten_model *model = NULL;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_OK(batten_model_create(0.001, &model));
    for (int i = 0; i < COUNT(names); i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = names[i],
                                                          .layer = "lines",
                                                          .group = i ? "" : "frames",
                                                          .has_colour = i > 1,
                                                          .is_hidden = i == 3,
                                                          .kind = BATTEN_OBJECT_CURVE,
                                                          .curve = line}));
    batten_curve_unref(line);
    return model;
}

TEST(what_a_format_cannot_say_of_objects_is_counted_in_one_message_each)
{
    static const struct {
        batten_format format;
        const char *said[5]; /* names, layers, colours, groups, hidden */
    } rows[] = {
        {BATTEN_FORMAT_IGES, {NULL, NULL, NULL, NULL, NULL}},
        {BATTEN_FORMAT_STEP, {NULL, NULL, NULL, NULL, NULL}},
        {BATTEN_FORMAT_DXF,
         {"names left out: 2 ('Station 155.000 m' first); DXF files hold none", NULL, NULL,
          "groups left out: 1 ('Station 155.000 m' first); DXF files hold none", NULL}},
        {BATTEN_FORMAT_SVG, {NULL, NULL, NULL, "groups left out: 1 ", NULL}},
        {BATTEN_FORMAT_G2,
         {"names left out: 2 ", "layers left out: 4 ", NULL, "groups left out: 1 ",
          "hidden objects: 1; G2"}},
        {BATTEN_FORMAT_OBJ,
         {NULL, "layers left out: 4 ", "colours left out: 2 ('LINE 12' first)", NULL,
          "hidden objects: 1; OBJ"}}};
    static const char *const kinds[] = {"names left out", "layers left out", "colours left out",
                                        "groups left out", "hidden objects"};
    batten_model *model = looking_model();
    for (int i = 0; i < COUNT(rows); i++) {
        batten_write_options options = batten_write_defaults();
        batten_notes *notes = NULL;
        char *data = NULL;
        size_t size = 0;
        options.format = rows[i].format;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        for (int k = 0; k < 5 && !batten_notes_dropped(notes); k++)
            CHECK(rows[i].said[k] ? has_note(notes, rows[i].said[k])
                                  : !has_note(notes, kinds[k]));
        batten_release(data);
        batten_notes_free(notes);
    }
    batten_model_unref(model);
}

TEST(what_STEP_cannot_say_of_instances_is_counted)
{
    static const char *const said[] = {
        "layers left out: 2 ('a' first); STEP files hold none for this instance",
        "colours left out: 1 ('b' first); ", "groups left out: 2 ('a' first); ",
        "that objects are hidden is left out: 1 ('a' first); "};
    const double point[3] = {1, 2, 3};
    batten_model *part = NULL, *model = NULL;
    batten_notes *notes = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(0.001, &part));
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(batten_model_add(part, &(batten_object){.name = "tip",
                                                     .layer = "kept",
                                                     .kind = BATTEN_OBJECT_POINTS,
                                                     .point_count = 1,
                                                     .points = point}));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "b" : "a",
                                                          .layer = "parts",
                                                          .group = "set",
                                                          .is_hidden = i == 0,
                                                          .has_colour = i == 1,
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = part,
                                                          .place = batten_affine_identity()}));
    options.format = BATTEN_FORMAT_STEP;
    batten_status status = batten_write_memory(model, &options, notes, &data, &size);
    if (test_memory_failed(status, BATTEN_OK)) { /* what it noted is of no account */
        batten_notes_free(notes);
        notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        status = batten_write_memory(model, &options, notes, &data, &size);
    }
    CHECK_OK(status);
    if (!batten_notes_dropped(notes)) {
        CHECK_INT(batten_notes_count(notes), COUNT(said));
        for (int k = 0; k < COUNT(said); k++)
            CHECK(has_note(notes, said[k]));
    }
    batten_release(data);
    batten_notes_free(notes);
    batten_model_unref(part);
    batten_model_unref(model);
}
