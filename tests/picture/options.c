/* Options of pictures: the defaults draw, and every size in them is checked. */
#include "support/options.h"
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
    CHECK_INT(o.height, 0);
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

/* ---- the size of options ---- */

static void default_draw(void *options)
{
    const batten_draw_options defaults = batten_draw_defaults();
    memcpy(options, &defaults, sizeof defaults);
}

static void default_lines_plan(void *options)
{
    const batten_draw_lines_plan_options defaults = batten_draw_lines_plan_defaults();
    memcpy(options, &defaults, sizeof defaults);
}

static void default_cubic_plane(void *options)
{
    const batten_draw_cubic_plane_options defaults = batten_draw_cubic_plane_defaults();
    memcpy(options, &defaults, sizeof defaults);
}

/* A model that cannot be drawn, so that calls whose options are good end soon; `o` are the
 * options that are tried. */
#define CALL(name, arguments)                                          \
    static batten_status call_##name(const void *stage, const void *o) \
    {                                                                  \
        const batten_model *empty = stage;                             \
        char *data = NULL;                                             \
        size_t size = 0;                                               \
        (void)empty;                                                   \
        const batten_status status = arguments;                        \
        batten_release(data);                                          \
        return status;                                                 \
    }
CALL(draw, batten_draw(empty, o, &data, &size))
CALL(tool_path, batten_draw_tool_path(empty, o, &data, &size))
CALL(surface_lines, batten_draw_surface_lines(empty, o, NULL, &data, &size))
CALL(panels, batten_draw_panels(0, &(batten_panel){0}, o, &data, &size))
CALL(lines_plan, batten_draw_lines_plan(empty, NULL, o, NULL, &data, &size))
CALL(lines_of_plan, batten_draw_lines_plan(empty, o, NULL, NULL, &data, &size))
CALL(shaded, batten_draw_shaded(empty, o, NULL, &data, &size))
CALL(cubic_plane, batten_draw_cubic_plane(empty, NULL, o, &data, &size))
CALL(plane_of_cubics, batten_draw_cubic_plane(empty, o, NULL, &data, &size))

#define DRAW(name)                                                                           \
    {                                                                                        \
#name, "batten_draw_options", sizeof(batten_draw_options), default_draw, call_##name \
    }
static const options_taker takers[] = {
    DRAW(draw),
    DRAW(tool_path),
    DRAW(surface_lines),
    DRAW(panels),
    DRAW(lines_plan),
    DRAW(shaded),
    DRAW(cubic_plane),
    {"lines_of_plan", "batten_draw_lines_plan_options", sizeof(batten_draw_lines_plan_options),
     default_lines_plan, call_lines_of_plan},
    {"plane_of_cubics", "batten_draw_cubic_plane_options",
     sizeof(batten_draw_cubic_plane_options), default_cubic_plane, call_plane_of_cubics}};

TEST(a_size_that_nobody_set_or_that_is_longer_than_ours_is_refused)
{
    batten_model *empty = scene_empty();
    check_wrong_sizes(COUNT(takers), takers, empty);
    batten_model_unref(empty);
}

TEST(a_shorter_struct_gives_what_the_defaults_give)
{
    batten_model *empty = scene_empty();
    check_shorter_options(test_cases(COUNT(takers)), takers, empty);
    batten_model_unref(empty);
}
