/* Which format is chosen, and what is said when it holds nothing of a model. */
#include "exchange/meshes/meshes.h"
#include "exchange/shapes.h"

TEST(kinds_that_a_format_holds_are_listed_in_words)
{
    static const struct {
        batten_format format;
        const char *words;
    } cases[] = {{BATTEN_FORMAT_IGES,
                  "IGES files hold points, curves, surfaces and bodies, and none of"},
                 {BATTEN_FORMAT_STL, "left out: STL files"}};
    const batten_mesh_parts parts = tetrahedron();
    batten_model *model = NULL;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_model_create(1, &model));
    add_mesh(model, "m", &parts);
    CHECK_STATUS(write_bytes(model, cases[0].format, &data, &size), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE(cases[0].words);
    CHECK_MESSAGE("of the 1 object ('m' first) is of that kind");
    CHECK_STATUS(write_bytes(model, BATTEN_FORMAT_DXF, &data, &size), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("DXF files hold points and curves, and none of the 1 object ('m' first)");
    CHECK(data == NULL);
    batten_model_unref(model);
}

TEST(commas_are_chosen_by_the_ending_alone)
{
    static const struct {
        const char *path;
        bool commas;
        batten_format format;
    } cases[] = {
        {"a.csv", true, BATTEN_FORMAT_POINTS},    {"A.CSV", true, BATTEN_FORMAT_POINTS},
        {"csv.xyz", false, BATTEN_FORMAT_POINTS}, {"a.tsv", false, BATTEN_FORMAT_POINTS},
        {"csv", false, BATTEN_FORMAT_AUTO},       {"", false, BATTEN_FORMAT_AUTO},
        {"a.igs", false, BATTEN_FORMAT_IGES}};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < COUNT(cases); i++) {
        batten_write_options options = batten_write_defaults();
        CHECK_INT(batten_write_choose(cases[i].path, model, &options),
                  cases[i].format != BATTEN_FORMAT_AUTO);
        CHECK_INT(options.format, cases[i].format);
        if (cases[i].format != BATTEN_FORMAT_AUTO || cases[i].commas)
            CHECK_INT(options.commas, cases[i].commas);
    }
    batten_model_unref(model);
}

/* IGES, STEP and OBJ as well, whose article is another one. */
TEST(an_empty_model_is_not_written)
{
    static const struct {
        batten_format format;
        const char *words;
    } cases[] = {
        {BATTEN_FORMAT_IGES, "the model has no objects; an empty IGES file is not written"},
        {BATTEN_FORMAT_STEP, "the model has no objects; an empty STEP file is not written"},
        {BATTEN_FORMAT_OBJ, "the model has no objects; an empty OBJ file is not written"}};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < COUNT(cases); i++) {
        char *data = NULL;
        size_t size = 0;
        CHECK_STATUS(write_bytes(model, cases[i].format, &data, &size), BATTEN_UNSUPPORTED);
        CHECK_MESSAGE(cases[i].words);
        CHECK(data == NULL);
    }
    batten_model_unref(model);
}
