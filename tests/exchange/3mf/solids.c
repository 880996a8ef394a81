/* What is a solid and what a surface, and how objects share their numbers. */
#include "exchange/meshes/meshes.h"

#include "exchange/3mf/3mf.h"

/* The text of the model, which is stored as it is. */
static const char *xml_of(const batten_model *model, batten_notes *notes)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(write_form(model, BATTEN_FORMAT_3MF, false, notes, &data, &size));
    char *copy = test_array(size + 1, 1);
    for (size_t i = 0; i < size; i++)
        copy[i] = data[i] ? data[i] : ' ';
    batten_release(data);
    const char *xml = strstr(copy, "<model unit");
    CHECK(xml != NULL);
    return xml;
}

static int count_of(const char *text, const char *part)
{
    int count = 0;
    for (; (text = strstr(text, part)); text += strlen(part))
        count++;
    return count;
}

TEST(a_mesh_inside_out_or_open_is_a_surface)
{
    static const int turned[] = {0, 1, 2, 0, 3, 1, 1, 3, 2, 0, 2, 3};
    batten_model *model = NULL;
    batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_model_create(0.001, &model));
    add_mesh(model, "solid", &parts);
    parts.corners = turned;
    add_mesh(model, "turned", &parts);
    parts.corners = tetrahedron_corners;
    parts.triangle_count = 3;
    add_mesh(model, "open", &parts);
    const char *xml = xml_of(model, NULL);
    CHECK_CONTAINS(xml, "type=\"model\" name=\"solid\"");
    CHECK_CONTAINS(xml, "type=\"surface\" name=\"turned\"");
    CHECK_CONTAINS(xml, "type=\"surface\" name=\"open\"");
    batten_model_unref(model);
}

TEST(each_vertex_has_its_three_coordinates_in_the_unit_of_the_file)
{
    static const struct {
        double metres;
        const char *unit;
        double scale;
    } cases[] = {{1e-6, "micron", 1},      {0.001, "millimeter", 1}, {0.01, "centimeter", 1},
                 {0.0254, "inch", 1},      {0.3048, "foot", 1},      {1, "meter", 1},
                 {0.5, "millimeter", 500}, {0, "millimeter", 1}};
    static const double points[] = {1, 2, 3, 5, 7, 11, 13, 17, 19};
    const batten_mesh_parts parts = {.vertex_count = 3,
                                     .points = points,
                                     .triangle_count = 1,
                                     .corners = (const int[]){0, 1, 2}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = NULL;
        char words[400];
        const double s = cases[i].scale;
        CHECK_OK(batten_model_create(cases[i].metres, &model));
        add_mesh(model, "m", &parts);
        const char *xml = xml_of(model, NULL);
        snprintf(words, sizeof words, "<model unit=\"%s\"", cases[i].unit);
        CHECK_CONTAINS(xml, words);
        snprintf(words, sizeof words,
                 "<vertices>\n<vertex x=\"%g\" y=\"%g\" z=\"%g\"/>\n<vertex x=\"%g\" y=\"%g\" "
                 "z=\"%g\"/>\n<vertex x=\"%g\" y=\"%g\" z=\"%g\"/>\n</vertices>\n<triangles>\n"
                 "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>\n</triangles>\n",
                 s, 2 * s, 3 * s, 5 * s, 7 * s, 11 * s, 13 * s, 17 * s, 19 * s);
        CHECK_CONTAINS(xml, words);
        batten_model_unref(model);
    }
}

TEST(a_definition_of_open_meshes_is_a_surface_at_every_depth)
{
    /* None of the two, the last, the first is open. */
    for (int open = 0; open < 3; open++) {
        batten_model *inner = NULL, *middle = NULL, *model = NULL;
        batten_mesh_parts parts = tetrahedron();
        parts.triangle_count = 4 - (open == 2);
        CHECK_OK(batten_model_create(1, &inner));
        CHECK_OK(batten_model_create(1, &middle));
        CHECK_OK(batten_model_create(1, &model));
        add_mesh(inner, "first", &parts);
        parts.triangle_count = 4 - (open == 1);
        add_mesh(inner, "last", &parts);
        CHECK_OK(batten_model_add(middle, &(batten_object){.name = "i",
                                                           .kind = BATTEN_OBJECT_INSTANCE,
                                                           .definition = inner,
                                                           .place = batten_affine_identity()}));
        for (int k = 0; k < 2; k++)
            CHECK_OK(batten_model_add(
                model, &(batten_object){.name = "j",
                                        .kind = BATTEN_OBJECT_INSTANCE,
                                        .definition = middle,
                                        .place = batten_affine_translation(k, 2, 3)}));
        const char *xml = xml_of(model, NULL);
        CHECK_INT(count_of(xml, "<mesh>"), 2); /* however often they are placed */
        CHECK_INT(count_of(xml, "<components>"), 2);
        CHECK_INT(count_of(xml, "<component "), 3);
        CHECK_INT(count_of(xml, "<item "), 2);
        CHECK_INT(count_of(xml, "type=\"surface\""), open ? 3 : 0);
        CHECK_CONTAINS(xml, "transform=\"1 0 0 0 1 0 0 0 1 1 2 3\"");
        batten_model_unref(inner);
        batten_model_unref(middle);
        batten_model_unref(model);
    }
}

TEST(an_archive_of_more_than_4_GiB_is_refused_before_it_is_written)
{
    batten_text text = BATTEN_TEXT;
    const bat_zip_member members[2] = {{"a", "x", (size_t)1 << 31},
                                       {"b", "x", (size_t)1 << 31}};
    CHECK_STATUS(bat_zip(2, members, &text), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("a zip archive of 4294969344 bytes; it can have 4 GiB");
    CHECK_INT((long long)text.length, 0);
    batten_text_free(&text);
}

/* One that is open among those that are placed makes a surface of the whole, wherever it stands. */
TEST(a_definition_with_an_open_part_is_a_surface_in_any_order)
{
    for (int open = 0; open < 4; open++) {
        batten_model *parts[3] = {NULL}, *whole = NULL, *model = NULL;
        CHECK_OK(batten_model_create(1, &whole));
        CHECK_OK(batten_model_create(1, &model));
        for (int i = 0; i < 3; i++) {
            batten_mesh_parts shape = tetrahedron();
            shape.triangle_count = 4 - (i == open);
            CHECK_OK(batten_model_create(1, &parts[i]));
            add_mesh(parts[i], "shape", &shape);
            CHECK_OK(batten_model_add(
                whole, &(batten_object){.name = "i",
                                        .kind = BATTEN_OBJECT_INSTANCE,
                                        .definition = parts[i],
                                        .place = batten_affine_translation(i, 0, 0)}));
            batten_model_unref(parts[i]);
        }
        CHECK_OK(batten_model_add(model, &(batten_object){.name = "w",
                                                          .kind = BATTEN_OBJECT_INSTANCE,
                                                          .definition = whole,
                                                          .place = batten_affine_identity()}));
        const char *xml = xml_of(model, NULL);
        /* The mesh, its definition and the whole. */
        CHECK_INT(count_of(xml, "type=\"surface\""), open < 3 ? 3 : 0);
        batten_model_unref(whole);
        batten_model_unref(model);
    }
}

/* Two meshes by turns, one open and one closed, in the model and in a definition: each is written
 * once, and all that look like it refer to it. */
TEST(objects_that_look_alike_are_one_resource)
{
    batten_mesh *meshes[2] = {NULL, NULL};
    batten_model *inner = NULL, *model = NULL;
    batten_notes *notes = NULL;
    for (int i = 0; i < 2; i++) {
        batten_mesh_parts parts = tetrahedron();
        parts.triangle_count = 4 - i;
        CHECK_OK(batten_mesh_create(&parts, &meshes[i]));
    }
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_model_create(0, &inner));
    CHECK_OK(batten_model_create(0, &model));
    for (int i = 0; i < 7; i++)
        CHECK_OK(batten_model_add(i < 2 ? inner : model,
                                  &(batten_object){.name = i % 2 ? "open" : "closed",
                                                   .has_colour = i % 2,
                                                   .colour = {0, 0, 1},
                                                   .kind = BATTEN_OBJECT_MESH,
                                                   .mesh = meshes[i % 2]}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "both",
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = inner,
                                                      .place = batten_affine_identity()}));
    const char *xml = xml_of(model, notes);
    CHECK_INT(count_of(xml, "<mesh>"), 2);
    CHECK_INT(count_of(xml, "<base displaycolor=\"#0000FF\" name=\"open\"/>"), 1);
    CHECK_INT(count_of(xml, "<base "), 1);
    CHECK_CONTAINS(xml, "<object id=\"2\" type=\"model\" name=\"closed\">");
    CHECK_CONTAINS(xml,
                   "<object id=\"3\" type=\"surface\" name=\"open\" pid=\"1\" pindex=\"0\">");
    CHECK_CONTAINS(xml, "<object id=\"4\" type=\"surface\">\n<components>\n<component "
                        "objectid=\"2\"/>\n<component objectid=\"3\"/>\n</components>");
    CHECK_CONTAINS(xml,
                   "<build>\n<item objectid=\"2\"/>\n<item objectid=\"3\"/>\n"
                   "<item objectid=\"2\"/>\n<item objectid=\"3\"/>\n<item objectid=\"2\"/>\n"
                   "<item objectid=\"4\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0\"/>\n</build>");
    if (batten_notes_dropped(notes) == 0) {
        CHECK_TEXT(batten_notes_at(notes, 0)->text,
                   "the model has no unit; its numbers are taken as millimetres");
        for (int i = 0; i < batten_notes_count(notes); i++)
            CHECK_INT(batten_notes_at(notes, i)->line, 0);
    }
    batten_notes_free(notes);
    for (int i = 0; i < 2; i++)
        batten_mesh_unref(meshes[i]);
    batten_model_unref(inner);
    batten_model_unref(model);
}
