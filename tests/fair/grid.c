#include "fair/grid.h"

#include "support/waterlines.h"

static const double five[] = {0, 1, 2, 3, 4};

/* Zeros below the hull at both ends; at x = 4 blanks above it. */
static double with_stairs(double x, double z)
{
    if (x == 4 && z > 2)
        return NAN;
    if (z == 0 || (z == 1 && x != 2))
        return 0;
    return z == 1 ? 0.25 : 1 + 0.1 * x + 0.2 * z;
}

TEST(a_grid_says_where_there_is_hull_where_there_is_none_and_where_it_is_silent)
{
    batten_offset_table *table = make_waterlines(5, five, 5, five, with_stairs);
    bat_hull_grid grid;
    CHECK_OK(bat_hull_grid_make(table, &grid));
    CHECK_INT(grid.station_count, 5);
    CHECK_INT(grid.line_count, 5);
    for (int k = 0; k < 5; k++)
        for (int l = 0; l < 5; l++) {
            const double y = with_stairs(five[k], five[l]);
            CHECK(isnan(y) ? isnan(bat_hull_grid_y(&grid, k, l))
                           : bat_hull_grid_y(&grid, k, l) == y);
            CHECK_INT(bat_hull_grid_says(&grid, k, l), isnan(y) ? BAT_GRID_SILENT
                                                       : y > 0  ? BAT_GRID_HULL
                                                                : BAT_GRID_OUTSIDE);
        }
    CHECK(grid.x[4] == 4 && grid.z[1] == 1);
    CHECK_INT(grid.from[2 * 5 + 3], 3);
    CHECK(bat_hull_grid_is_graph(&grid));
    bat_arena_free(&grid.arena);
    batten_offset_table_unref(table);
}

/* Nothing below z = 2; blanks, not zeros, at the ends on z = 2. */
static double hull_above_two(double x, double z)
{
    if (z < 2)
        return 0;
    if (z == 2 && (x == 0 || x == 4))
        return NAN;
    return 1 + 0.1 * z;
}

TEST(of_lines_below_all_of_the_hull_the_highest_stays_and_a_blank_below_the_hull_is_outside)
{
    batten_offset_table *table = make_waterlines(5, five, 5, five, hull_above_two);
    bat_hull_grid grid;
    CHECK_OK(bat_hull_grid_make(table, &grid));
    CHECK_INT(grid.line_count, 4);
    CHECK(grid.z[0] == 1 && grid.z[3] == 4);
    CHECK_INT(grid.from[2 * 4 + 1], 2);
    CHECK_INT(bat_hull_grid_says(&grid, 0, 1), BAT_GRID_OUTSIDE);
    CHECK_INT(bat_hull_grid_says(&grid, 0, 2), BAT_GRID_HULL);
    CHECK_INT(bat_hull_grid_says(&grid, 1, 1), BAT_GRID_HULL);
    bat_arena_free(&grid.arena);
    batten_offset_table_unref(table);
}

static bool is_graph(int stations, int lines, half_breadth of)
{
    batten_offset_table *table = make_waterlines(stations, five, lines, five, of);
    bat_hull_grid grid;
    CHECK_OK(bat_hull_grid_make(table, &grid));
    const bool answer = bat_hull_grid_is_graph(&grid);
    bat_arena_free(&grid.arena);
    batten_offset_table_unref(table);
    return answer;
}

static double without_stairs(double x, double z)
{
    return x == 4 ? 0 : 0.3 * z; /* a keel on the lowest line, a stem */
}

static double flat(double x, double z)
{
    return with_stairs(x, z) * (z > 2 ? 40 : 1);
}

TEST(a_grid_is_a_graph_when_it_has_stairs_and_is_steep_and_large_enough)
{
    CHECK(is_graph(5, 5, with_stairs));
    CHECK(is_graph(4, 4, with_stairs));
    CHECK(!is_graph(3, 5, with_stairs));
    CHECK(!is_graph(5, 3, with_stairs));
    CHECK(!is_graph(5, 5, without_stairs));
    CHECK(!is_graph(5, 5, flat));
}

TEST(a_table_with_points_beside_its_waterlines_is_no_grid)
{
    static const batten_table_line lines[] = {{"", true, 0}, {"", true, 1}, {"keel", false, 0}};
    static const batten_table_point points[] = {{0, 1, 0, 0}, {0, 2, 1, 1}, {0, 3, 2, 2}};
    const batten_table_station station = {"", 0, 3, points};
    batten_offset_table *table = NULL;
    bat_hull_grid grid;
    CHECK_OK(batten_offset_table_create(1, 3, lines, 1, &station, &table));
    CHECK_OK(bat_hull_grid_make(table, &grid));
    CHECK_INT(grid.line_count, 0);
    CHECK(!bat_hull_grid_is_graph(&grid));
    bat_arena_free(&grid.arena);
    batten_offset_table_unref(table);
}

/* ---- zeros amid the hull ---- */

static double without_zeros(double x, double z)
{
    return 1 + 0.1 * x + 0.2 * z;
}

static double zero_at_a_place(double x, double z)
{
    return x == 2 && z == 3 ? 0 : without_zeros(x, z);
}

static double zero_at_a_station(double x, double z)
{
    return x == 1 ? 0 : without_zeros(x, z);
}

static double zero_on_a_waterline(double x, double z)
{
    return z == 2 ? 0 : without_zeros(x, z);
}

static double blank_at_a_place(double x, double z)
{
    return x == 2 && z == 3 ? NAN : without_zeros(x, z);
}

/* Nothing between a bulb and the stem above it. */
static double over_a_bulb(double x, double z)
{
    return (x >= 3 && z == 2) || (x <= 1 && z == 0) ? 0 : without_zeros(x, z);
}

static const struct {
    half_breadth of;
    const char *said; /* NULL: no contradiction */
} zeros[] = {
    {zero_at_a_place, "station 3 (x = 2) says 0 at z = 3 between points of the hull: "},
    {zero_at_a_station,
     "station 2 (x = 1) says 0 at z = 0 between points of the hull, the first "
     "of such places: "},
    {zero_on_a_waterline, "station 1 (x = 0) says 0 at z = 2 between points of the hull, the "
                          "first of such places: "},
    {blank_at_a_place, NULL},
    {over_a_bulb, NULL},
    {with_stairs, NULL},
    {hull_above_two, NULL},
};

TEST(a_zero_amid_the_hull_is_refused_by_its_station_and_height)
{
    for (int k = 0; k < COUNT(zeros); k++) {
        batten_offset_table *table = make_waterlines(5, five, 5, five, zeros[k].of);
        bat_hull_grid grid;
        CHECK_OK(bat_hull_grid_make(table, &grid));
        if (zeros[k].said) {
            CHECK_STATUS(bat_hull_grid_check(&grid), BATTEN_BAD_ARGUMENT);
            CHECK(strstr(batten_message(), zeros[k].said) != NULL);
        } else {
            CHECK_OK(bat_hull_grid_check(&grid));
        }
        bat_arena_free(&grid.arena);
        batten_offset_table_unref(table);
    }
}
