#include <batten/exchange.h>

#include "support/test.h"
#include "support/triangles.h"

/* A model of a row of points and two triangles, the second object. */
static batten_model *make_model(test_random *random)
{
    static const double row[] = {0, 0, 0, 1, 2, 3};
    batten_triangles *triangles = NULL;
    batten_model *model = NULL;
    CHECK_OK(random_triangles(random, 3, 3, 2, true, NULL, &triangles));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "row",
                                                      .kind = BATTEN_OBJECT_POINTS,
                                                      .point_count = 2,
                                                      .points = row}));
    CHECK_OK(batten_model_add(model, &(batten_object){.name = "sail",
                                                      .layer = "top",
                                                      .has_colour = true,
                                                      .colour = {1, 0, 0.5},
                                                      .kind = BATTEN_OBJECT_TRIANGLES,
                                                      .triangles = triangles}));
    batten_triangles_unref(triangles);
    return model;
}

TEST(triangles_become_named_patches_and_the_rest_stays)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = make_model(&random), *patches = NULL, *same = NULL;
    for (int form = 0; form < 2; form++) {
        CHECK_OK(batten_model_with_patches(model, (batten_patches)form, &patches));
        CHECK_INT(batten_model_count(patches), form == BATTEN_PATCHES_REGULAR ? 7 : 3);
        CHECK_INT(batten_model_object(patches, 0)->kind, BATTEN_OBJECT_POINTS);
        const batten_object *second = batten_model_object(patches, 2);
        CHECK_TEXT(second->name, "sail.2");
        CHECK_TEXT(second->layer, "top");
        CHECK(second->has_colour && second->colour[2] == 0.5);
        CHECK(second->kind == BATTEN_OBJECT_SURFACE && !second->triangles);
        CHECK_OK(batten_model_with_patches(patches, BATTEN_PATCHES_POLE, &same));
        CHECK(same == patches);
        batten_model_unref(same);
        batten_model_unref(patches);
    }
    batten_model_unref(model);
}

TEST(triangles_take_part_in_boxes_and_units)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = make_model(&random), *scaled = NULL;
    batten_box box, large;
    CHECK(batten_model_box(model, &box));
    CHECK_OK(batten_model_to_unit(model, 0.001, &scaled));
    CHECK(batten_model_box(scaled, &large));
    CHECK_NEAR(large.low.z, 1000 * box.low.z, 1e-9);
    CHECK_INT(batten_model_object(scaled, 1)->kind, BATTEN_OBJECT_TRIANGLES);
    batten_model_unref(model);
    batten_model_unref(scaled);
}

TEST(files_of_nurbs_hold_three_patches_for_a_triangle)
{
    test_random random = test_random_begin(__func__);
    batten_model *model = make_model(&random), *read = NULL;
    batten_write_options options = batten_write_defaults();
    char *data = NULL;
    size_t size = 0;
    options.format = BATTEN_FORMAT_IGES;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    CHECK_OK(batten_read_memory(data, size, NULL, NULL, NULL, &read));
    batten_release(data);
    CHECK_INT(batten_model_count(read), 7); /* points, and what the triangles became */
    const batten_triangles *triangles = batten_model_object(model, 1)->triangles;
    for (int i = 0; i < 6; i++) {
        const double corner[3] = {i % 3 == 0, i % 3 == 1, i % 3 == 2};
        double a[3], b[3];
        const batten_surface *patch = batten_model_object(read, i + 1)->surface;
        CHECK_OK(batten_surface_evaluate(patch, 0, 0, 0, a));
        CHECK_OK(batten_triangles_evaluate(triangles, i / 3, corner, 0, b));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(a[k], b[k], 1e-14);
    }
    batten_model_unref(read);

    options.format = BATTEN_FORMAT_STEP;
    CHECK_OK(batten_write_memory(model, &options, NULL, &data, &size));
    int count = 0;
    for (const char *at = data; (at = strstr(at, "RATIONAL_B_SPLINE_SURFACE(")); at++)
        count++;
    batten_release(data);
    CHECK_INT(count, 6);
    batten_model_unref(model);
}

TEST(a_model_holds_triangles_in_space_only)
{
    test_random random = test_random_begin(__func__);
    batten_triangles *triangles = NULL;
    batten_model *model = NULL;
    CHECK_OK(random_triangles(&random, 1, 3, 2, false, NULL, &triangles));
    CHECK_OK(batten_model_create(1, &model));
    CHECK_STATUS(batten_model_add(model, &(batten_object){.name = "f",
                                                          .kind = BATTEN_OBJECT_TRIANGLES,
                                                          .triangles = triangles}),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("triangles of dimension 1");
    CHECK_INT(batten_model_count(model), 0);
    batten_triangles_unref(triangles);
    batten_model_unref(model);
}
