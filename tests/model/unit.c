#include <batten/model.h>

#include "support/test.h"

static batten_model *make_model(double unit_metres, double offsets_unit)
{
    const double points[] = {0, 0, 0, 1, 2, 3}, knots[] = {0, 0, 1, 1};
    const double corners[] = {-1, 0, 0, 0, 0, 4, 2, 0, 0, 2, 5, 0};
    const batten_axis axis = {1, 2, knots, false};
    const batten_table_point sides[] = {{1, 0, -2, -1}, {1, 3, 1, -1}};
    const batten_table_station station = {"1", 1, 2, sides};
    batten_object curve = {.name = "keel", .kind = BATTEN_OBJECT_CURVE, .point_count = 2};
    batten_object surface = {.name = "side", .kind = BATTEN_OBJECT_SURFACE};
    batten_object table = {.name = "table", .kind = BATTEN_OBJECT_OFFSET_TABLE};
    batten_curve *made_curve = NULL;
    batten_surface *made_surface = NULL;
    batten_offset_table *made_offsets = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(unit_metres, &model));
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &made_curve));
    CHECK_OK(batten_surface_create(3, &axis, &axis, corners, NULL, &made_surface));
    CHECK_OK(batten_offset_table_create(offsets_unit, 0, NULL, 1, &station, &made_offsets));
    curve.curve = made_curve;
    curve.points = points;
    surface.surface = made_surface;
    table.offset_table = made_offsets;
    CHECK_OK(batten_model_add(model, &curve));
    CHECK_OK(batten_model_add(model, &surface));
    CHECK_OK(batten_model_add(model, &table));
    batten_offset_table_unref(made_offsets);
    batten_surface_unref(made_surface);
    batten_curve_unref(made_curve);
    return model;
}

/* The largest coordinate of each object, which is that of the given one times `factor`. */
static void check_sizes(const batten_model *model, double factor)
{
    const batten_object *curve = batten_model_object(model, 0);
    CHECK_NEAR(batten_curve_points(curve->curve)[5], 3 * factor, 1e-12 * factor);
    CHECK_NEAR(curve->points[4], 2 * factor, 1e-12 * factor);
    const batten_surface *surface = batten_model_object(model, 1)->surface;
    CHECK_NEAR(batten_surface_points(surface)[10], 5 * factor, 1e-12 * factor);
    const batten_offset_table *offsets = batten_model_object(model, 2)->offset_table;
    CHECK_NEAR(batten_offset_table_station(offsets, 0)->points[1].y, 3 * factor,
               1e-12 * factor);
    CHECK_BITS(batten_offset_table_unit_metres(offsets), batten_model_unit_metres(model));
}

TEST(geometry_is_scaled_to_another_unit)
{
    const struct {
        double from, to, factor;
    } cases[] = {{1, 0.001, 1000},
                 {0.001, 1, 0.001},
                 {0.0254, 0.001, 25.4},
                 {0.3048, 0.0254, 12},
                 {1, 1, 1}};
    for (int i = 0; i < COUNT(cases); i++) {
        batten_model *model = make_model(cases[i].from, cases[i].from), *scaled = NULL;
        CHECK_OK(batten_model_to_unit(model, cases[i].to, &scaled));
        CHECK_BITS(batten_model_unit_metres(scaled), cases[i].to);
        check_sizes(scaled, cases[i].factor);
        CHECK_TEXT(batten_model_object(scaled, 1)->name, "side");
        batten_model_unref(scaled);
        batten_model_unref(model);
    }
}

TEST(a_model_without_a_unit_is_taken_to_be_in_the_new_one)
{
    batten_model *model = make_model(0, 0), *scaled = NULL;
    CHECK_OK(batten_model_to_unit(model, 0.001, &scaled));
    check_sizes(scaled, 1);
    batten_model_unref(scaled);
    batten_model_unref(model);
}

TEST(a_table_that_says_its_own_unit_is_scaled_from_that)
{
    batten_model *model = make_model(0, 0.0254), *scaled = NULL;
    CHECK_OK(batten_model_to_unit(model, 0.001, &scaled));
    const batten_offset_table *offsets = batten_model_object(scaled, 2)->offset_table;
    CHECK_NEAR(batten_offset_table_station(offsets, 0)->points[1].y, 76.2, 1e-12);
    batten_model_unref(scaled);
    batten_model_unref(model);
}

TEST(N2_a_unit_that_makes_the_numbers_too_large_is_refused)
{
    batten_model *model = make_model(1, 1), *scaled = NULL;
    CHECK(batten_model_to_unit(model, 1e-308, &scaled) != BATTEN_OK);
    CHECK(scaled == NULL);
    CHECK_STATUS(batten_model_to_unit(model, 0, &scaled), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_model_to_unit(model, -1, &scaled), BATTEN_BAD_ARGUMENT);
    batten_model_unref(model);
}
