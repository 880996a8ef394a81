#include "exchange/shapes.h"

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
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_CONTAINS(data, "FILE_NAME('batten','2000-01-01T00:00:00'");
    batten_release(data);
    batten_model_unref(model);
}
