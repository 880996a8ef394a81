#include <batten/model.h>

#include "support/test.h"

static const double line_points[] = {0, 0, 0, 1, 2, 3};
static const double line_knots[] = {0, 0, 1, 1};

static batten_curve *make_line(void)
{
    batten_curve *curve = NULL;
    CHECK_OK(
        batten_curve_create((batten_points){3, 2, line_points}, 1, NULL, line_knots, &curve));
    return curve;
}

static batten_surface *make_patch(void)
{
    const double points[] = {-1, 0, 0, 0, 0, 4, 2, 0, 0, 2, 5, 0};
    const batten_axis axis = {1, 2, line_knots, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &axis, &axis, points, NULL, &surface));
    return surface;
}

static batten_offset_table *make_offsets(double unit_metres)
{
    const batten_table_point points[] = {{1, 0, -2, -1}, {1, 3, 1, -1}};
    const batten_table_station station = {"1", 1, 2, points};
    batten_offset_table *offsets = NULL;
    CHECK_OK(batten_offset_table_create(unit_metres, 0, NULL, 1, &station, &offsets));
    return offsets;
}

static void add_curve(batten_model *model, const char *name)
{
    batten_curve *curve = make_line();
    CHECK_OK(batten_model_add(
        model, &(batten_object){.name = name, .kind = BATTEN_OBJECT_CURVE, .curve = curve}));
    batten_curve_unref(curve);
}

TEST(an_object_is_copied_into_the_model)
{
    double points[] = {1, 2, 3, 4, 5, 6}, parameters[] = {0, 1};
    char name[] = "keel \xff line", layer[] = "hull";
    const batten_object object = {.name = name,
                                  .layer = layer,
                                  .has_colour = true,
                                  .colour = {0, 0.5, 1},
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = 2,
                                  .points = points,
                                  .parameters = parameters};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(0.001, &model));
    CHECK_OK(batten_model_add(model, &object));
    name[0] = layer[0] = 'x';
    points[0] = parameters[1] = 9;

    const batten_object *kept = batten_model_object(model, 0);
    CHECK_TEXT(kept->name, "keel \xff line");
    CHECK_TEXT(kept->layer, "hull");
    CHECK(kept->has_colour && kept->colour[1] == 0.5 && kept->curve == NULL);
    CHECK_INT(kept->point_count, 2);
    CHECK(kept->points[0] == 1 && kept->points[5] == 6 && kept->parameters[1] == 1);
    CHECK_BITS(batten_model_unit_metres(model), 0.001);
    batten_model_unref(model);
}

TEST(the_first_object_of_a_name_is_found)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_INT(batten_model_find(model, ""), -1);
    for (int i = 0; i < 20; i++)
        add_curve(model, i % 2 ? "odd" : NULL);
    CHECK_INT(batten_model_count(model), 20);
    CHECK_INT(batten_model_find(model, "odd"), 1);
    CHECK_INT(batten_model_find(model, ""), 0);
    CHECK_INT(batten_model_find(model, "even"), -1);
    batten_model_unref(model);
}

TEST(a_model_lives_as_long_as_someone_holds_it)
{
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    add_curve(model, "keel");
    batten_model *second = batten_model_ref(model);
    batten_model_unref(model);
    CHECK_INT(batten_curve_degree(batten_model_object(second, 0)->curve), 1);
    batten_model_unref(second);
    batten_model_unref(NULL);
}

TEST(the_box_holds_every_kind_of_object)
{
    batten_model *model = NULL;
    batten_surface *surface = make_patch();
    batten_offset_table *offsets = make_offsets(1);
    batten_box box = {{7, 7, 7}, {7, 7, 7}};
    const double point[] = {0.5, -6, 0};
    CHECK_OK(batten_model_create(1, &model));
    CHECK(!batten_model_box(model, &box));
    CHECK(box.low.x == 7);

    add_curve(model, "keel");
    CHECK(batten_model_box(model, &box));
    CHECK(box.low.x == 0 && box.high.x == 1 && box.high.z == 3);
    CHECK_OK(batten_model_add(
        model, &(batten_object){.kind = BATTEN_OBJECT_SURFACE, .surface = surface}));
    CHECK_OK(batten_model_add(
        model, &(batten_object){.kind = BATTEN_OBJECT_OFFSET_TABLE, .offset_table = offsets}));
    CHECK_OK(batten_model_add(
        model,
        &(batten_object){.kind = BATTEN_OBJECT_POINTS, .point_count = 1, .points = point}));
    CHECK(batten_model_box(model, &box));
    CHECK(box.low.x == -1 && box.low.y == -6 && box.low.z == -2);
    CHECK(box.high.x == 2 && box.high.y == 5 && box.high.z == 4);
    batten_offset_table_unref(offsets);
    batten_surface_unref(surface);
    batten_model_unref(model);
}

TEST(N1_points_that_are_not_finite_are_refused)
{
    const double points[] = {0, 0, 0, 0, NAN, 0}, good[6] = {0}, parameters[] = {0, INFINITY};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    CHECK_STATUS(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 2,
                                                          .points = points}),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 2 of point 2");
    CHECK_STATUS(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 2,
                                                          .points = good,
                                                          .parameters = parameters}),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("parameter 2");
    CHECK_STATUS(batten_model_add(model, &(batten_object){.kind = BATTEN_OBJECT_POINTS,
                                                          .has_colour = true,
                                                          .colour = {0, 0, 1.5}}),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("colour part 3 is 1.5");
    CHECK_INT(batten_model_count(model), 0);
    batten_model_unref(model);
}

TEST(a_unit_below_zero_is_refused)
{
    batten_model *model = NULL;
    CHECK_STATUS(batten_model_create(-1, &model), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_model_create(NAN, &model), BATTEN_BAD_ARGUMENT);
    CHECK(model == NULL);
}
