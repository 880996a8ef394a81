#include "design/evaluate.h"
#include "support/process.h"
#include <batten/exchange.h>
#include <batten/text.h>

static const char *in_folder(const char *text, batten_design **out)
{
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("exchange.yaml");
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, out));
    return text;
}

static void write_output(batten_design *design, int index)
{
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_design_output(design, index, NULL, NULL, &data, &size));
    CHECK_OK(
        batten_save_file(test_scratch(batten_design_output_name(design, index)), data, size));
    batten_release(data);
}

TEST(designs_name_every_format)
{
    static const char *const features[] = {"read", "write"};
    for (int f = 0; f < COUNT(features); f++) {
        const batten_feature *feature = batten_feature_find(features[f]);
        const char *words = NULL;
        for (int i = 0; i < feature->parameter_count; i++)
            if (strcmp(feature->parameters[i].name, "format") == 0)
                words = feature->parameters[i].words;
        for (int k = 0; *batten_format_name((batten_format)k) != '?'; k++) {
            const char *name = batten_format_name((batten_format)k);
            CHECK(words && strncmp(words, name, strlen(name)) == 0);
            words += strlen(name);
            CHECK(*words == ' ' || *words == 0);
            words += *words == ' ';
        }
        CHECK_TEXT(words, "");
    }
}

TEST(meshes_of_files_are_scaled_moved_and_written)
{
    batten_design *design = NULL;
    in_folder("batten: 1\nunits: mm\nfeatures:\n  ball: {sphere: 10}\noutputs:\n"
              "  ball.stl: {write: ball, chord: 0.05, angle: 60 deg, text: yes}\n",
              &design);
    write_output(design, 0);
    batten_design_free(design);
    CHECK_CONTAINS(test_content(test_scratch("ball.stl")), "solid");

    in_folder("batten: 1\nunits: mm\nfeatures:\n  ball: {read: ball.stl, unit: cm}\n"
              "  moved: {move: ball, by: [1000, 0, 0]}\noutputs:\n  moved.ply: moved\n",
              &design);
    CHECK_OK(batten_design_evaluate(design, "moved", NULL, NULL));
    const batten_model *model = batten_design_result(design, "moved")->value;
    CHECK_INT(batten_model_count(model), 1);
    CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_MESH);
    batten_box box;
    CHECK(batten_model_box(model, &box));
    CHECK_NEAR(box.high.z, 100, 1);
    CHECK_NEAR(box.low.x, 900, 1);
    write_output(design, 0);
    CHECK_CONTAINS(test_content(test_scratch("moved.ply")), "ply");
    batten_design_free(design);
}

static void write_assembly(const char *name)
{
    const double row[6] = {0, 0, 0, 1, 2, 3};
    batten_model *part = NULL, *model = NULL;
    const batten_object points = {
        .name = "row", .kind = BATTEN_OBJECT_POINTS, .point_count = 2, .points = row};
    CHECK_OK(batten_model_create(1, &part));
    for (int k = 0; k < 2; k++)
        CHECK_OK(batten_model_add(part, &points));
    const batten_object placed = {.name = "left",
                                  .kind = BATTEN_OBJECT_INSTANCE,
                                  .definition = part,
                                  .place = batten_affine_translation(10, 0, 0)};
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &placed));
    CHECK_OK(batten_write_file(model, test_scratch(name), NULL, NULL));
    batten_model_unref(part);
    batten_model_unref(model);
}

TEST(what_instances_place_is_put_there)
{
    batten_design *design = NULL;
    write_assembly("assembly.step");
    in_folder("batten: 1\nunits: mm\nfeatures:\n  a: {read: assembly.step}\n", &design);
    CHECK_OK(batten_design_evaluate(design, "a", NULL, NULL));
    const batten_model *model = batten_design_result(design, "a")->value;
    CHECK(batten_model_count(model) > 0);
    CHECK_INT(batten_model_depth(model), 0);
    CHECK_CONTAINS(batten_model_object(model, 0)->name, "left/");
    batten_box box;
    CHECK(batten_model_box(model, &box));
    CHECK_NEAR(box.low.x, 10000, 1e-6);
    CHECK_NEAR(box.high.z, 3000, 1e-6);
    batten_design_free(design);
}

TEST(formats_that_are_not_read_are_refused_by_name)
{
    batten_design *design = NULL;
    test_write(test_scratch("path.nc"), "G1 X1\n");
    in_folder("batten: 1\nfeatures:\n  a: {read: path.nc, format: g-code}\n", &design);
    CHECK_STATUS(batten_design_evaluate(design, "a", NULL, NULL), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("G-code files cannot be read");
    batten_design_free(design);
}
