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
