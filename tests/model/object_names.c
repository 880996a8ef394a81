/* What models and their definitions are called, through changes and files. */
#include "exchange/reading.h"
#include "model/rebuild.h"

#include "support/test.h"

#include <stdio.h>
#include <string.h>

static batten_model *new_model(const char *name)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_set_name(model, name));
    return model;
}

static batten_model *curve_of(const char *name, double length)
{
    batten_model *model = new_model(name);
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, (double[]){0, 0, 0, length, 0, 0}}, 1,
                                 NULL, (double[]){0, 0, 1, 1}, &line));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = "line", .kind = BATTEN_OBJECT_CURVE, .curve = line}));
    batten_curve_unref(line);
    return model;
}

static void place(batten_model *model, const char *name, const batten_model *definition)
{
    CHECK_OK(batten_model_add(model, &(batten_object){.name = name,
                                                      .kind = BATTEN_OBJECT_INSTANCE,
                                                      .definition = definition,
                                                      .place = batten_affine_identity()}));
}

/* Two definitions of one name, one without, and one that is called as the second of a name
 * might be. */
static batten_model *assembly(void)
{
    static const char *const names[] = {"bolt", "bolt", "", "bolt.2"};
    batten_model *model = new_model("as1 <\xc3\xa4>");
    for (int i = 0; i < COUNT(names); i++) {
        char instance[32];
        snprintf(instance, sizeof instance, "placed_%d", i);
        batten_model *part = curve_of(names[i], i + 1);
        place(model, instance, part);
        batten_model_unref(part);
    }
    return model;
}

static void check_names(const batten_model *model)
{
    static const char *const names[] = {"bolt", "bolt", "placed_2", "bolt.2"};
    CHECK_TEXT(batten_model_name(model), "as1 <\xc3\xa4>");
    CHECK_INT(batten_model_count(model), 4);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        CHECK_TEXT(batten_model_name(object->definition), names[i]);
        CHECK_INT(object->name[7] - '0', i);
        const batten_curve *line = batten_model_object(object->definition, 0)->curve;
        CHECK_NEAR(batten_curve_points(line)[3], i + 1, 0);
    }
}

TEST(a_model_has_a_name_or_none)
{
    batten_model *model = new_model(NULL);
    CHECK_TEXT(batten_model_name(model), "");
    CHECK_OK(batten_model_set_name(model, "hull"));
    CHECK_OK(batten_model_set_name(model, batten_model_name(model)));
    CHECK_TEXT(batten_model_name(model), "hull");
    CHECK_OK(batten_model_set_name(model, ""));
    CHECK_TEXT(batten_model_name(model), "");
    batten_model_unref(model);
}

TEST(changed_models_and_their_definitions_keep_their_names)
{
    batten_model *model = assembly(), *made = NULL, *flat = NULL;
    CHECK_OK(batten_model_to_unit(model, 1, &made));
    CHECK_TEXT(batten_model_name(made), batten_model_name(model));
    CHECK_TEXT(batten_model_name(batten_model_object(made, 3)->definition), "bolt.2");
    CHECK_OK(batten_model_flat(model, &flat));
    CHECK_TEXT(batten_model_name(flat), batten_model_name(model));
    batten_model_unref(made);
    CHECK_OK(batten_model_meshed(model, NULL, NULL, NULL, &made));
    CHECK_TEXT(batten_model_name(batten_model_object(made, 0)->definition), "bolt");
    batten_model_unref(flat);
    batten_model_unref(made);
    batten_model_unref(model);
}

/* Write, read and write again: the bytes are the same. */
static void go_twice(batten_format format)
{
    batten_write_options options = batten_write_defaults();
    batten_model *model = assembly(), *back = NULL;
    char *data[2] = {NULL, NULL};
    size_t size[2] = {0, 0};
    options.format = format;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data[0], &size[0]));
    CHECK_OK(batten_read_memory(data[0], size[0], NULL, NULL, NULL, &back));
    if (back) {
        check_names(back);
        CHECK_OK(batten_write_memory(back, &options, NULL, &data[1], &size[1]));
    }
    CHECK(size[0] == size[1] && size[0] && memcmp(data[0], data[1], size[0]) == 0);
    if (format == BATTEN_FORMAT_STEP && data[0]) {
        CHECK_CONTAINS(data[0], "PRODUCT('bolt','bolt'");
        CHECK_CONTAINS(data[0], "PRODUCT('bolt.3','bolt'"); /* 'bolt.2' is another's name */
        CHECK_CONTAINS(data[0], "PRODUCT('bolt.2','bolt.2'");
        CHECK_CONTAINS(data[0], "PRODUCT('placed_2','placed_2'");
    }
    batten_release(data[0]);
    batten_release(data[1]);
    batten_model_unref(back);
    batten_model_unref(model);
}

TEST(STEP_keeps_the_names_of_products)
{
    go_twice(BATTEN_FORMAT_STEP);
}

TEST(IGES_keeps_the_names_of_subfigures_and_of_the_product)
{
    go_twice(BATTEN_FORMAT_IGES);
}

TEST(blocks_of_DXF_are_definitions_with_a_name)
{
    static const char text[] =
        "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nrib\n70\n0\n10\n0\n20\n0\n30\n0\n0\nLINE\n8\n0\n"
        "10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n0\nENDBLK\n0\nENDSEC\n0\nSECTION\n2\n"
        "ENTITIES\n0\nINSERT\n8\nframes\n2\nrib\n10\n5\n20\n0\n30\n0\n0\nENDSEC\n0\nEOF\n";
    batten_model *model = NULL;
    CHECK_OK(batten_read_memory(text, sizeof text - 1, NULL, NULL, NULL, &model));
    if (!model)
        return;
    CHECK_INT(batten_model_count(model), 1);
    CHECK_TEXT(batten_model_name(batten_model_object(model, 0)->definition), "rib");
    batten_model_unref(model);
}

TEST(scenes_of_glTF_and_components_of_3MF_are_called_as_models)
{
    static const batten_format formats[] = {BATTEN_FORMAT_GLTF, BATTEN_FORMAT_3MF};
    static const char *const said[] = {"\"scenes\":[{\"name\":\"ship\",\"nodes\"",
                                       "type=\"surface\" name=\"bolt\">\n<components>"};
    batten_mesh *mesh = NULL;
    batten_model *part = new_model("bolt"), *model = new_model("ship");
    CHECK_OK(
        batten_mesh_create(&(batten_mesh_parts){.vertex_count = 3,
                                                .points = (double[]){0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                .triangle_count = 1,
                                                .corners = (int[]){0, 1, 2}},
                           &mesh));
    CHECK_OK(batten_model_add(
        part, &(batten_object){.name = "head", .kind = BATTEN_OBJECT_MESH, .mesh = mesh}));
    place(model, "one", part);
    for (int i = 0; i < COUNT(formats); i++) {
        batten_write_options options = batten_write_defaults();
        char *data = NULL;
        size_t size = 0;
        options.format = formats[i];
        CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
        bool found = false;
        for (size_t at = 0; data && at + strlen(said[i]) <= size; at++)
            found |= memcmp(data + at, said[i], strlen(said[i])) == 0;
        CHECK(found);
        batten_release(data);
    }
    batten_mesh_unref(mesh);
    batten_model_unref(model);
    batten_model_unref(part);
}
