/* Stations, waterlines and buttocks stand where they are asked for. */
#include "picture/drawings/hull.h"

#include "picture/scenes.h"

static const double L = 10, B = 2, T = 1;

TEST(eleven_stations_divide_the_length)
{
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.waterlines = plan.buttocks = 10;
    bat_hull hull;
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
    const bat_cuts *cuts = &hull.families[BAT_STATIONS];
    CHECK_INT(cuts->count, 11);
    for (int i = 0; i < cuts->count; i++) {
        CHECK_NEAR(cuts->cuts[i].at, L * (0.1 * i - 0.5), 1e-12);
        /* The two at the ends only touch the hull. */
        CHECK_INT(cuts->cuts[i].lines.count, i > 0 && i < 10);
    }
    bat_hull_free(&hull);
    batten_model_unref(model);
}

TEST(the_design_waterline_is_one_of_the_waterlines)
{
    static const struct {
        double at;
        int count;
    } rows[] = {{-0.5, 3}, {-0.6, 4}, {0.5, 3}}; /* on a line, between two, above the hull */
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    for (int i = 0; i < test_cases(COUNT(rows)); i++) {
        batten_draw_lines_plan_options plan = scene_plan(L);
        plan.waterlines = 0.25;
        plan.design_waterline = rows[i].at;
        batten_notes *notes = NULL;
        CHECK_OK(batten_notes_create(10, &notes));
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, notes, &hull));
        const bat_cuts *cuts = &hull.families[BAT_WATERLINES];
        CHECK_INT(cuts->count, rows[i].count);
        int designs = 0;
        for (int k = 0; k < cuts->count; k++) {
            designs += cuts->cuts[k].is_design;
            CHECK(k == 0 || cuts->cuts[k].at > cuts->cuts[k - 1].at);
        }
        CHECK_INT(designs, rows[i].at < 0);
        CHECK_INT(batten_notes_count(notes) + batten_notes_dropped(notes), rows[i].at > 0);
        bat_hull_free(&hull);
        batten_notes_free(notes);
    }
    batten_model_unref(model);
}

TEST(stations_stand_where_they_are_given)
{
    static const double at[] = {-3, 0.5, 4, 90};
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    batten_draw_lines_plan_options plan = scene_plan(L);
    plan.station_at = at;
    plan.station_count = COUNT(at);
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    bat_hull hull;
    CHECK_OK(bat_hull_cut(model, &plan, notes, &hull));
    for (int i = 0; i < COUNT(at); i++)
        CHECK_BITS(hull.families[BAT_STATIONS].cuts[i].at, at[i]);
    CHECK_NEAR(hull.families[BAT_STATIONS].spacing, 0, 0);
    /* The last one misses the hull, and that is said. */
    CHECK_INT(hull.families[BAT_STATIONS].cuts[3].lines.count, 0);
    if (batten_notes_count(notes) > 0)
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "x = 90");
    bat_hull_free(&hull);
    batten_notes_free(notes);
    batten_model_unref(model);
}

TEST(plans_that_make_no_sense_are_refused)
{
    batten_model *model = scene_of(scene_wigley(L, B, T, 1));
    static const double falling[] = {1, 0}, endless[] = {0, INFINITY};
    const batten_draw_lines_plan_options usual = batten_draw_lines_plan_defaults();
    batten_draw_lines_plan_options rows[] = {usual, usual, usual, usual, usual, usual};
    rows[0].stations = -1;
    rows[1].waterlines = NAN;
    rows[2].buttocks = 1e-9; /* a unit was confused */
    rows[3].station_at = falling;
    rows[3].station_count = 2;
    rows[4].station_at = endless;
    rows[4].station_count = 2;
    rows[5].station_at = falling;
    rows[5].station_count = -2;
    static const batten_status expected[] = {BATTEN_BAD_ARGUMENT, BATTEN_BAD_ARGUMENT,
                                             BATTEN_TOO_LARGE,    BATTEN_NOT_INCREASING,
                                             BATTEN_NOT_FINITE,   BATTEN_TOO_LARGE};
    for (int i = 0; i < COUNT(rows); i++) {
        bat_hull hull;
        CHECK_STATUS(bat_hull_cut(model, &rows[i], NULL, &hull), expected[i]);
    }
    batten_model_unref(model);
}
