#include "loft/hull.h"

#include "support/waterlines.h"

static const double within = 1e-3;

/* A frame found from a table of this function; the arena is released by the caller. */
static bat_graph_frame find_lines(int stations, const double *x, int lines, const double *z,
                                  half_breadth of, bat_arena *arena)
{
    batten_offset_table *table = make_waterlines(stations, x, lines, z, of);
    bat_hull_grid grid;
    bat_graph_frame frame = {0};
    bat_loft all = {0};
    CHECK_OK(bat_hull_grid_make(table, &grid));
    CHECK(bat_hull_grid_is_graph(&grid));
    CHECK_OK(bat_graph_frame_all(&grid, arena, &frame));
    CHECK_OK(bat_graph_patch(&grid, &frame, within, &all));
    all.breadth = 1;
    CHECK_OK(bat_graph_limit_outside(&grid, &all));
    CHECK_OK(bat_graph_find_lines(&grid, &all, within, arena, &frame));
    bat_hull_release(&all);
    bat_arena_free(&grid.arena);
    batten_offset_table_unref(table);
    return frame;
}

/* The function of these coefficients: its nearest control value for a line that is nearly straight. */
static double coefficient_at(const double *knots, int i)
{
    return (knots[i + 1] + knots[i + 2] + knots[i + 3]) / 3;
}

static double rake(double z)
{
    return 2.65 + 0.7 * z;
}

/* Symmetric about x = 0; its ends rake by 0.7. */
static double raked(double x, double z)
{
    const double part = x / rake(z);
    return bat_max(0, (0.6 + 0.3 * z) * (1 - part * part));
}

TEST(ends_between_stations_are_where_the_graph_meets_the_centre_plane)
{
    static const double x[] = {-3.5, -3, -2.5, -2, -1, 0, 1, 2, 2.5, 3, 3.5},
                        z[] = {0, 0.25, 0.5, 0.75, 1};
    bat_arena arena = {0};
    const bat_graph_frame f = find_lines(11, x, 5, z, raked, &arena);
    CHECK(f.closed[0] && f.closed[1] && !f.closed_foot);
    for (int i = 0; i < f.u_count; i++)
        CHECK(f.low[i] == 0 && f.high[i] == 1);
    for (int j = 0; j < f.v_count; j++) {
        const double v = coefficient_at(f.v_knots, j);
        const double height = (1 - f.bend) * v + f.bend * v * v;
        /* y falls by about 0.6 over 1 at the ends. */
        CHECK_NEAR(f.fore[j], rake(height), 0.02);
        CHECK_NEAR(f.aft[j], -rake(height), 0.02);
    }
    bat_arena_free(&arena);
}

static double foot(double x)
{
    return 0.1 + 0.06 * x * x;
}

/* Its foot is a parabola; the last stations end one line lower. */
static double rising(double x, double z)
{
    return x < 0.5 && z > 1.8 ? NAN : bat_max(0, 0.9 * (z - foot(x)));
}

TEST(a_foot_and_a_top_between_the_lines_are_found)
{
    static const double x[] = {-3, -2, -1, 0, 1, 2, 3}, z[] = {0, 0.4, 0.8, 1.2, 1.6, 2};
    bat_arena arena = {0};
    const bat_graph_frame f = find_lines(7, x, 6, z, rising, &arena);
    CHECK(f.closed_foot && !f.closed[0] && !f.closed[1]);
    for (int i = 0; i < f.u_count; i++) {
        const double u = coefficient_at(f.u_knots, i);
        CHECK_NEAR(f.low[i], foot(-3 + 6 * u), 0.06);
        CHECK(f.high[i] > 1.6 && f.high[i] < 2.01);
    }
    CHECK_NEAR(f.low[0], foot(-3), 4e-3);
    CHECK_NEAR(f.low[f.u_count - 1], foot(3), 4e-3);
    CHECK(f.high[0] < 2 && f.high[f.u_count - 1] >= 2);
    for (int j = 0; j < f.v_count; j++)
        CHECK(f.aft[j] == -3 && f.fore[j] == 3);
    bat_arena_free(&arena);
}
