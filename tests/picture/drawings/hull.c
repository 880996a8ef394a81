#include "picture/drawings/hull.h"

#include "picture/scenes.h"

static const double L = 10, B = 2, T = 1;

static double breadth(double x, double z)
{
    const double X = 2 * x / L, Z = z / T;
    return 0.5 * B * (1 - X * X) * (1 - Z * Z);
}

static void check_lines(const bat_cut *cut, int axis)
{
    for (size_t i = 0; i < cut->lines.count; i++)
        for (size_t k = 0; k < cut->lines.strokes[i].count; k++) {
            const double *p = cut->lines.strokes[i].points + 3 * k;
            CHECK_NEAR(p[axis], cut->at, 1e-6);
            CHECK_NEAR(p[1], breadth(p[0], p[2]), 1e-5);
        }
}

TEST(all_lines_of_a_wigley_hull_lie_on_it)
{
    static const double sides[] = {1, -1}; /* a hull at y < 0 is drawn mirrored */
    for (int s = 0; s < test_cases(COUNT(sides)); s++) {
        batten_model *model = scene_of(scene_wigley(L, B, T, sides[s]));
        batten_draw_lines_plan_options plan = scene_plan(L);
        plan.design_waterline = -0.33;
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
        CHECK_NEAR(hull.low[0], -0.5 * L, 1e-12);
        CHECK_NEAR(hull.high[1], 0.5 * B, 1e-12);
        CHECK_NEAR(hull.low[2], -T, 1e-12);
        for (int f = 0; f < BAT_AXES; f++) {
            for (int i = 0; i < hull.families[f].count; i++)
                check_lines(&hull.families[f].cuts[i], f);
        }
        bat_hull_free(&hull);
        batten_model_unref(model);
    }
}

TEST(of_a_whole_hull_one_half_is_drawn)
{
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    scene_add_surface(model, "starboard", scene_wigley(L, B, T, -1));
    const batten_draw_lines_plan_options plan = scene_plan(L);
    bat_hull hull;
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
    for (int f = 0; f < BAT_FAMILIES; f++)
        for (int i = 0; i < hull.families[f].count; i++) {
            const bat_cut *cut = &hull.families[f].cuts[i];
            for (size_t k = 0; k < cut->lines.count; k++)
                for (size_t n = 0; n < cut->lines.strokes[k].count; n++)
                    CHECK(cut->lines.strokes[k].points[3 * n + 1] >= -1e-6);
        }
    CHECK_NEAR(hull.low[1], 0, 0);
    bat_hull_free(&hull);
    batten_model_unref(model);
}

TEST(what_is_no_hull_is_refused)
{
    const batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    bat_hull hull;
    batten_model *empty = scene_empty();
    CHECK_STATUS(bat_hull_cut(empty, &plan, NULL, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("surface");
    batten_model_unref(empty);
    /* Flat in the centre plane: no breadth. */
    const double points[] = {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1};
    batten_model *flat = scene_of(scene_net(1, 2, 1, 2, points));
    CHECK_STATUS(bat_hull_cut(flat, &plan, NULL, &hull), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("breadth");
    batten_model_unref(flat);
}

TEST(a_polyline_is_cut_exactly_at_the_plane)
{
    const double zigzag[] = {-1, 0, 0, 1, 2, 4, 3, 0, 0, -1, 2, 0, -2, 2, 0, 0, 0, 1, -1, 5, 5};
    double copy[21];
    memcpy(copy, zigzag, sizeof copy);
    const bat_stroke stroke = {7, copy};
    bat_strokes above = {0, 0, NULL};
    CHECK_OK(bat_strokes_add_part(&above, &stroke, 0, 1, 0));
    /* In at the middle of the first segment, out three quarters along the third; the corner
     * that only touches the plane is a point and no line. */
    CHECK_INT(above.count, 1);
    const bat_stroke *s = &above.strokes[0];
    CHECK_INT(s->count, 4);
    CHECK_NEAR(s->points[1], 1, 1e-15);
    CHECK_NEAR(s->points[2], 2, 1e-15);
    CHECK_BITS(s->points[9], 0);
    CHECK_NEAR(s->points[10], 1.5, 1e-15);
    bat_strokes_free(&above);
}
