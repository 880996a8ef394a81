#include "scenes.h"

TEST(default_options_draw)
{
    batten_model *model = scene_of(scene_wigley(10, 2, 1, 1));
    const batten_draw_options options = batten_draw_defaults();
    const batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    CHECK_INT(options.size, sizeof options);
    CHECK_INT(plan.size, sizeof plan);
    CHECK(isnan(plan.design_waterline));
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw(model, &options, &data, &size));
    batten_release(data);
    const batten_draw_lines_plan_options few = scene_plan(10);
    CHECK_OK(batten_draw_lines_plan(model, test_cases(10) < 10 ? &few : &plan, &options, NULL,
                                    &data, &size));
    batten_release(data);
    CHECK_OK(batten_draw_shaded(model, &options, NULL, &data, &size));
    batten_release(data);
    batten_model_unref(model);
}

/* The defaults that the header states beside each field. */
TEST(defaults_are_those_of_the_header)
{
    const batten_draw_options o = batten_draw_defaults();
    const double degree = acos(-1) / 180;
    CHECK_INT(o.format, BATTEN_PICTURE_PNG);
    CHECK_INT(o.width, 1200);
    CHECK_INT(o.height, 800);
    CHECK_TEXT(o.title, "");
    CHECK_INT(o.view, BATTEN_VIEW_AUTO);
    CHECK_NEAR(o.azimuth, 28 * degree, 1e-15);
    CHECK_NEAR(o.elevation, 12 * degree, 1e-15);
    CHECK(!o.control_polygon && !o.data_points && !o.comb && !o.silhouettes && !o.contours);
    CHECK_NEAR(o.comb_scale, 0, 0);
    CHECK_INT(o.shading, BATTEN_SHADING_PLAIN);
    CHECK_INT(o.isolines, 10);
    CHECK_NEAR(o.stripes, 24, 0);
    CHECK_INT(o.hidden, BATTEN_HIDDEN_SHOWN);
    CHECK_INT(o.contour_field.kind, BATTEN_FIELD_HEIGHT);
    CHECK_NEAR(o.contour_field.direction.x, 0, 0);
    CHECK_NEAR(o.contour_field.direction.y, 0, 0);
    CHECK_NEAR(o.contour_field.direction.z, 1, 0);
    CHECK_NEAR(o.contour_spacing, 0, 0);
    CHECK_INT(o.sheet, BATTEN_SHEET_ONE);
    CHECK_NEAR(o.distance, 0, 0);
    CHECK_NEAR(o.stereo_angle, 5 * degree, 1e-15);
    CHECK(o.notes == NULL);
}
