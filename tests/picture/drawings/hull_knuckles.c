/* Edges at which the stations turn are knuckles; those where the surface goes on smoothly are none. */
#include "picture/drawings/hull.h"

#include "picture/scenes.h"
#include <batten/hull.h>

/* A panel from x to x + 5 between two points of the section, each (y, z). */
static batten_surface *panel(double x, const double a[2], const double b[2])
{
    const double points[] = {x,     a[0], a[1], x,     b[0], b[1],
                             x + 5, a[0], a[1], x + 5, b[0], b[1]};
    return scene_net(1, 2, 1, 2, points);
}

/* A prism with these corners of its section, (y, z), and a length of 5 or of twice 5. */
static batten_model *prism(int count, const double (*corners)[2], int pieces)
{
    batten_model *model = scene_empty();
    for (int p = 0; p < pieces; p++)
        for (int i = 0; i + 1 < count; i++)
            scene_add_surface(model, "panel", panel(5 * p, corners[i], corners[i + 1]));
    return model;
}

/* Two of its names belong to a knuckle, and one runs beside it. */
static batten_model *table_of(double y, double z)
{
    const batten_table_line lines[] = {{"beside", false, 0}, {"chine", false, 0}};
    const batten_table_point points[] = {
        {1, y - 0.1, z, 0}, {1, y, z, 1}, {4, y - 0.1, z, 0}, {4, y, z, 1}};
    const batten_table_station stations[] = {{"1", 1, 2, points}, {"2", 4, 2, points + 2}};
    batten_offset_table *table = NULL;
    batten_model *model = scene_empty();
    CHECK_OK(batten_offset_table_create(1, 2, lines, 2, stations, &table));
    const batten_object object = {.name = "table",
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                  .offset_table = table};
    CHECK_OK(batten_model_add(model, &object));
    batten_offset_table_unref(table);
    return model;
}

/* The last corner turns by 8 degrees and is none. */
static const double corners[][2] = {{0, 0}, {1, 0}, {1.5, 0.5}, {1.5, 1}, {1.43, 1.5}};

TEST(corners_of_the_stations_are_knuckles_from_the_lowest_up)
{
    for (int pieces = 1; pieces <= test_cases(2); pieces++) {
        batten_model *model = prism(COUNT(corners), corners, pieces);
        batten_model *data = table_of(1.5, 0.5);
        batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
        plan.stations = 1;
        plan.data = data;
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
        CHECK_INT(hull.knuckle_count, 2);
        CHECK_TEXT(hull.knuckles[0].name, "knuckle 1");
        CHECK_TEXT(hull.knuckles[1].name, "chine");
        CHECK_INT(hull.families[BAT_DIAGONALS].count, 0);
        for (int i = 0; i < 2; i++) {
            CHECK_INT(hull.knuckles[i].lines.count, pieces);
            for (double x = 0; x <= 5 * pieces; x += 0.5) {
                double yz[2] = {0};
                CHECK(bat_knuckle_at(&hull.knuckles[i], x, 1e-9, yz));
                CHECK_NEAR(yz[0], corners[i + 1][0], 1e-12);
                CHECK_NEAR(yz[1], corners[i + 1][1], 1e-12);
            }
            double yz[2];
            CHECK(!bat_knuckle_at(&hull.knuckles[i], -0.1, 1e-9, yz));
        }
        bat_hull_free(&hull);
        batten_model_unref(data);
        batten_model_unref(model);
    }
}

TEST(ten_degrees_make_a_knuckle)
{
    static const struct {
        double degrees;
        int knuckles;
    } rows[] = {{0, 0}, {9.9, 0}, {10.1, 1}, {-30, 1}, {90, 1}, {135, 1}};
    for (int i = 0; i < test_cases(COUNT(rows)); i++) {
        const double turn = rows[i].degrees * BAT_PI / 180;
        const double up = atan2(0.3, 1);
        const double turned[][2] = {
            {0, 0}, {1, 0.3}, {1 + cos(turn + up), 0.3 + sin(turn + up)}};
        batten_model *model = prism(3, turned, 1);
        batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
        plan.stations = 1;
        bat_hull hull;
        CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
        CHECK_INT(hull.knuckle_count, rows[i].knuckles);
        bat_hull_free(&hull);
        batten_model_unref(model);
    }
}

TEST(edges_in_the_centre_plane_across_the_hull_or_alone_are_no_knuckles)
{
    /* A keel where both halves meet, a sheer, and the joint of two lengths. */
    static const double flare[][2] = {{0, 0}, {1, 1}};
    batten_model *model = prism(2, flare, 2);
    static const double other[2][2] = {{0, 0}, {-1, 1}};
    scene_add_surface(model, "starboard", panel(0, other[0], other[1]));
    batten_draw_lines_plan_options plan = batten_draw_lines_plan_defaults();
    plan.stations = 1;
    bat_hull hull;
    CHECK_OK(bat_hull_cut(model, &plan, NULL, &hull));
    CHECK_INT(hull.knuckle_count, 0);
    bat_hull_free(&hull);
    batten_model_unref(model);
}
