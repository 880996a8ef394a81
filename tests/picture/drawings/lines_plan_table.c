/* The table of offsets says what the hull measures. */
#include "picture/drawings/lines_plan.h"
#include "picture/scenes.h"

enum { LENGTH = 10, BEAM = 2, DRAUGHT = 1 };

/* The half-breadth of the Wigley hull. */
static double breadth_at(double x, double z)
{
    return 0.5 * BEAM * (1 - pow(2 * x / LENGTH, 2)) * (1 - pow(z / DRAUGHT, 2));
}

TEST(offsets_are_those_of_the_hull)
{
    batten_model *model = scene_of(scene_wigley(LENGTH, BEAM, DRAUGHT, 1));
    batten_draw_lines_plan_options plan = scene_plan(LENGTH);
    plan.waterlines = 0.25;
    plan.buttocks = 0.25;
    bat_lines_sheet s = {.model = model, .plan = &plan};
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &s.hull));
    int found = 0;
    for (int i = 0; i < s.hull.families[BAT_STATIONS].count; i++) {
        const double x = s.hull.families[BAT_STATIONS].cuts[i].at;
        for (int k = 0; k < s.hull.families[BAT_WATERLINES].count; k++) {
            const double y = bat_lines_offset(&s, i, BAT_WATERLINES, k);
            if (isnan(y))
                continue;
            CHECK_NEAR(y, breadth_at(x, s.hull.families[BAT_WATERLINES].cuts[k].at), 2e-4);
            found++;
        }
        for (int k = 0; k < s.hull.families[BAT_BUTTOCKS].count; k++) {
            const double z = bat_lines_offset(&s, i, BAT_BUTTOCKS, k);
            if (isnan(z))
                continue;
            CHECK_NEAR(breadth_at(x, z), s.hull.families[BAT_BUTTOCKS].cuts[k].at, 2e-4);
            found++;
        }
    }
    CHECK(found > 5);
    bat_hull_free(&s.hull);
    batten_model_unref(model);
}

TEST(a_table_without_room_is_noted)
{
    static const double spacings[] = {0.25, 0.01};
    batten_model *model = scene_of(scene_wigley(LENGTH, BEAM, DRAUGHT, 1));
    for (int i = 0; i < 2; i++) {
        batten_draw_lines_plan_options plan = scene_plan(LENGTH);
        plan.waterlines = spacings[i];
        batten_draw_options options = batten_draw_defaults();
        options.format = BATTEN_PICTURE_SVG;
        options.width = 1684;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_draw_lines_plan(model, &plan, &options, notes, &data, &size));
        CHECK((batten_notes_count(notes) + batten_notes_dropped(notes) > 0) == (i > 0));
        batten_notes_free(notes);
        batten_release(data);
    }
    batten_model_unref(model);
}

TEST(lengths_along_diagonals_are_measured_in_their_planes)
{
    static const double at[] = {-0.2, 0.3}, angle[] = {0.4, 1};
    batten_model *model = scene_of(scene_wigley(LENGTH, BEAM, DRAUGHT, 1));
    batten_draw_lines_plan_options plan = scene_plan(LENGTH);
    plan.diagonal_at = at;
    plan.diagonal_angle = angle;
    plan.diagonal_count = 2;
    bat_lines_sheet s = {.model = model, .plan = &plan};
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &s.hull));
    int found = 0;
    for (int i = 0; i < s.hull.families[BAT_STATIONS].count; i++)
        for (int k = 0; k < 2; k++) {
            const double way = bat_lines_offset(&s, i, BAT_DIAGONALS, k);
            const double x = s.hull.families[BAT_STATIONS].cuts[i].at;
            if (isnan(way))
                continue;
            CHECK_NEAR(breadth_at(x, at[k] - way * sin(angle[k])), way * cos(angle[k]), 2e-4);
            CHECK(way <= s.hull.reach + 1e-4);
            found++;
        }
    CHECK(found >= 2);
    bat_hull_free(&s.hull);
    batten_model_unref(model);
}

TEST(a_knuckle_is_measured_where_it_reaches)
{
    const double points[2][12] = {{0, 0, 0, 0, 1, 0.5, 4, 0, 0, 4, 1.2, 0.7},
                                  {0, 1, 0.5, 0, 1, 2, 4, 1.2, 0.7, 4, 1.2, 2}};
    batten_model *model = scene_of(scene_net(1, 2, 1, 2, points[0]));
    scene_add_surface(model, "side", scene_net(1, 2, 1, 2, points[1]));
    static const double stations[] = {-1, 0, 1, 3, 4};
    batten_draw_lines_plan_options plan = scene_plan(LENGTH);
    plan.stations = 0;
    plan.station_at = stations;
    plan.station_count = 5;
    bat_lines_sheet s = {.model = model, .plan = &plan};
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &s.hull));
    CHECK_INT(s.hull.knuckle_count, 1);
    for (int i = 0; i < 5; i++) {
        double yz[2];
        bat_lines_knuckle_offsets(&s, i, 0, yz);
        CHECK(isnan(yz[0]) == (i == 0) && isnan(yz[1]) == (i == 0));
        if (i > 0) {
            CHECK_NEAR(yz[0], 1 + 0.05 * stations[i], 1e-12);
            CHECK_NEAR(yz[1], 0.5 + 0.05 * stations[i], 1e-12);
        }
    }
    bat_hull_free(&s.hull);
    batten_model_unref(model);
}
