#include "loft/data.h"

#include "support/test.h"

/* S = (4 u, v^2 + u / 2, v), of 5 x 5 control points. */
static void make_bowl(bat_loft_patch *patch)
{
    static const double inner[] = {0.5};
    double knots[5 + BAT_LOFT_SUPPORT];
    bat_loft_knots(1, inner, knots);
    CHECK_OK(bat_loft_patch_make(5, knots, 5, knots, patch));
    for (int i = 0; i < 5; i++)
        for (int j = 0; j < 5; j++) {
            const double *a = knots + i + 1, *b = knots + j + 1;
            double *p = patch->points + 3 * (i * 5 + j);
            p[0] = 4 * (a[0] + a[1] + a[2]) / 3;
            p[1] = (b[0] * b[1] + b[1] * b[2] + b[2] * b[0]) / 3 + p[0] / 8;
            p[2] = (b[0] + b[1] + b[2]) / 3;
        }
}

/* Points beside the patch: inside, in a station, at edges and corners; feet begin nearby. */
static const bat_loft_datum given[] = {
    {.point = {1.1, 0.5, 0.45}, .within = 0.05, .u = 0.3, .v = 0.4},
    {.point = {2, 0.9, 0.7}, .within = 0.02, .in_station = true, .u = 0.45, .v = 0.75},
    {.point = {3, 0.3, 0.05}, .within = 0.04, .on_v_edge = true, .u = 0.7, .v = 0},
    {.point = {3.1, 0.45, 0.05},
     .within = 0.04,
     .on_v_edge = true,
     .in_station = true,
     .u = 0.7,
     .v = 0},
    {.point = {0.05, 0.5, 0.66}, .within = 0.03, .on_u_edge = true, .u = 0, .v = 0.6},
    {.point = {4.03, 0.52, -0.04},
     .within = 0.04,
     .on_u_edge = true,
     .on_v_edge = true,
     .u = 1,
     .v = 0},
};

TEST(feet_are_where_the_offset_is_square_to_what_may_slide)
{
    bat_loft_patch patch;
    bat_loft_datum data[COUNT(given)];
    bat_loft_moves moves;
    double squares = 0, largest = 0, part = 0;
    make_bowl(&patch);
    memcpy(data, given, sizeof data);
    bat_loft_find_feet(&patch, COUNT(data), data, &moves);
    for (int k = 0; k < COUNT(data); k++) {
        const bat_loft_datum *d = &data[k];
        bat_loft_place place;
        double along[2] = {0}, off[3], distance = 0;
        bat_loft_place_at(&patch, d->u, d->v, &place);
        for (int c = 0; c < 3; c++) {
            off[c] = d->point[c] - place.s[0][0][c];
            distance += off[c] * off[c];
            along[0] += off[c] * place.s[1][0][c];
            along[1] += off[c] * place.s[0][1][c];
        }
        CHECK_NEAR(d->move, sqrt(distance), 1e-14);
        if (d->on_u_edge || d->on_v_edge) { /* along its edge, or not at all */
            CHECK(!d->on_u_edge || d->u == given[k].u);
            CHECK(!d->on_v_edge || d->v == given[k].v);
        } else if (!d->in_station) {
            CHECK_NEAR(along[1], 0, 1e-9);
            CHECK_NEAR(along[0], 0, 1e-9);
        } else { /* in the plane of the station S_v is in it */
            CHECK_NEAR(along[1], 0, 1e-6);
        }
        if (d->in_station)
            CHECK_NEAR(off[0], 0, 1e-6);
        else if (d->on_v_edge && !d->on_u_edge)
            CHECK_NEAR(along[0], 0, 1e-9);
        else if (d->on_u_edge && !d->on_v_edge)
            CHECK_NEAR(along[1], 0, 1e-9);
        squares += distance;
        largest = fmax(largest, d->move);
        part = fmax(part, d->move / d->within);
    }
    CHECK_NEAR(moves.largest, largest, 1e-15);
    CHECK_NEAR(moves.largest_part, part, 1e-13);
    CHECK_NEAR(moves.rms, sqrt(squares / COUNT(data)), 1e-15);
    bat_loft_find_feet(&patch, 0, data, &moves);
    CHECK(moves.largest == 0 && moves.rms == 0 && moves.largest_part == 0);
    bat_loft_patch_free(&patch);
}

/* One round: all control points are free, and the energy is small. */
static void move_round(bat_loft_patch *patch, const bat_loft_datum *data, int count,
                       bool attract)
{
    static const bool held[5 * 5 * 3];
    bat_loft_program program;
    bat_convex_report report;
    double slack = 0;
    CHECK_OK(bat_loft_program_make(patch, held, 0.05, &program));
    CHECK_OK(bat_loft_add_energy(&program, 1));
    for (int k = 0; k < count; k++)
        if (attract)
            bat_loft_attract_datum(&program, &data[k]);
        else
            CHECK_OK(bat_loft_add_datum(&program, &data[k]));
    CHECK_OK(bat_loft_program_move(&program, patch->points, &slack, &report));
    bat_loft_program_free(&program);
}

TEST(rounds_bring_all_points_within_their_bounds)
{
    bat_loft_patch patch;
    bat_loft_datum data[COUNT(given)];
    bat_loft_moves moves;
    make_bowl(&patch);
    memcpy(data, given, sizeof data);
    bat_loft_find_feet(&patch, COUNT(data), data, &moves);
    CHECK(moves.largest_part > 1);
    for (int round = 0; round < 4; round++) {
        move_round(&patch, data, COUNT(data), false);
        bat_loft_find_feet(&patch, COUNT(data), data, &moves);
    }
    CHECK(moves.largest_part <= 1);
    bat_loft_patch_free(&patch);
}

TEST(a_first_fit_draws_the_patch_to_all_points)
{
    bat_loft_patch patch;
    bat_loft_datum data[COUNT(given)];
    bat_loft_moves before, after;
    make_bowl(&patch);
    memcpy(data, given, sizeof data);
    bat_loft_find_feet(&patch, COUNT(data), data, &before);
    move_round(&patch, data, COUNT(data), true);
    bat_loft_find_feet(&patch, COUNT(data), data, &after);
    CHECK(before.largest_part > 1);
    CHECK(after.largest < 0.05 * before.largest && after.rms < 0.05 * before.rms);
    bat_loft_patch_free(&patch);
}
