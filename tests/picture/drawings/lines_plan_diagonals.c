/* Diagonals in the sheet: named in both views, said in the table. */
#include "picture/drawings/lines_plan.h"
#include "picture/scenes.h"

static scene_words words_of(batten_surface *surface, const batten_draw_lines_plan_options *plan)
{
    batten_model *model = scene_of(surface);
    batten_draw_options options = batten_draw_defaults();
    options.format = BATTEN_PICTURE_PDF;
    options.width = 1684;
    options.height = 1191;
    char *data = NULL;
    size_t size = 0;
    CHECK_OK(batten_draw_lines_plan(model, plan, &options, NULL, &data, &size));
    batten_model_unref(model);
    char *copy = test_array(size, 1);
    memcpy(copy, data, size);
    batten_release(data);
    return scene_read_pdf(copy, size);
}

static int count_words(const scene_words *words, const char *text)
{
    int count = 0;
    for (int i = 0; i < words->count; i++)
        count += strcmp(words->words[i].text, text) == 0;
    return count;
}

TEST(a_diagonal_is_named_in_body_plan_true_shape_and_table)
{
    static const double at[] = {-0.1}, angle[] = {45 * BAT_PI / 180};
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.waterlines = plan.buttocks = 0.5;
    plan.diagonal_at = at;
    plan.diagonal_angle = angle;
    plan.diagonal_count = 1;
    const scene_words with = words_of(scene_wigley(10, 2, 1, 1), &plan);
    /* Twice in the body plan, once in its true shape, once over its column, once where it is said how it lies. */
    CHECK_INT(count_words(&with, "D1"), 5);
    CHECK(scene_find(&with, "45\u00b0") != NULL);
    CHECK(scene_find(&with, "shape") != NULL);
    CHECK(scene_find(&with, "along") != NULL);
    scene_check_words(&with, 1684, 1191);

    plan.diagonal_at = NULL;
    plan.diagonals = 0;
    const scene_words without = words_of(scene_wigley(10, 2, 1, 1), &plan);
    CHECK_INT(count_words(&without, "D1"), 0);
    CHECK(scene_find(&without, "shape") == NULL);
    CHECK(scene_find(&without, "none") != NULL);
}
