#include "design/outputs/fairness.h"

#include "design/outputs/checked.h"

#include <batten/standard.h>

#define DATA "  p: {points: [[0, 0, 0]]}\n  flat: {fit-grid: p}\n"

/* The plane over [0, 2] x [0, 1]. */
static void put_plane(checked_design *d, const char *feature, double from, double to)
{
    batten_surface *plane = NULL;
    CHECK_OK(batten_surface_bilinear((batten_vec3){from, 0, 0}, (batten_vec3){to, 0, 0},
                                     (batten_vec3){from, 1, 0}, (batten_vec3){to, 1, 0},
                                     &plane));
    checked_put_surface(d, feature, plane);
}

static const double given[][3] = {{0, 0, 0.001}, {2, 0, 0},        {0.5, 0.5, -0.003},
                                  {1, 1, 0.001}, {1, 0.5, -0.002}, {2, 1, 0.001}};

TEST(the_distances_of_points_from_their_surface_are_those_of_geometry)
{
    static const double bounds[] = {0.00301, 0.00299};
    for (int i = 0; i < 2; i++) {
        checked_design d;
        checked_open(DATA, "flat", &d);
        checked_put_points(&d, "p", COUNT(given), given[0]);
        put_plane(&d, "flat", 0, 2);
        const bat_checked *c = checked_run(&d, bounds[i]);
        CHECK_INT(c->distance_count, 1);
        CHECK_TEXT(c->distances[0].feature, "p");
        CHECK_INT(c->distances[0].count, 6);
        CHECK_INT(c->distances[0].left_out, 0);
        CHECK(!c->distances[0].is_faired);
        CHECK_NEAR(c->distances[0].max, 0.003, 1e-12);
        CHECK_NEAR(c->distances[0].rms, sqrt(16e-6 / 6), 1e-12);
        for (int k = 0; k < 3; k++)
            CHECK(c->distances[0].worst[k] == given[2][k]);
        CHECK_INT(d.check.bounded_count, 1);
        CHECK(d.check.ok == (i == 0));
        checked_close(&d);
    }
}

/* Several rows of points are one cloud: none of them is dropped, and none counted twice. */
TEST(rows_of_points_are_measured_together)
{
    checked_design d;
    checked_open(DATA, "flat", &d);
    checked_put_points(&d, "p", 2, given[0]);
    checked_put_points(&d, "p", 3, given[2]);
    checked_put_points(&d, "p", 1, given[5]);
    put_plane(&d, "flat", 0, 2);
    const bat_checked *c = checked_run(&d, HUGE_VAL);
    CHECK_INT(c->distances[0].count, 6);
    CHECK_NEAR(c->distances[0].max, 0.003, 1e-12);
    CHECK_NEAR(c->distances[0].rms, sqrt(16e-6 / 6), 1e-12);
    CHECK(c->distances[0].worst[0] == 0.5 && c->distances[0].worst[2] == -0.003);
    checked_close(&d);
}

/* Both planes come from the same points, each of which counts by the one that is near. */
TEST(of_two_surfaces_from_the_same_points_the_nearer_one_counts)
{
    checked_design d;
    checked_open(DATA "  right: {fit-grid: p}\n", "[flat, right]", &d);
    checked_put_points(&d, "p", COUNT(given), given[0]);
    put_plane(&d, "flat", 0, 0.75);
    put_plane(&d, "right", 0.75, 2);
    const bat_checked *c = checked_run(&d, 0.0031);
    for (int i = 0; i < 2; i++) {
        CHECK_INT(c[i].distance_count, 1);
        CHECK_NEAR(c[i].distances[0].max, 0.003, 1e-12);
        CHECK_NEAR(c[i].distances[0].rms, sqrt(16e-6 / 6), 1e-12);
    }
    CHECK(d.check.ok);
    CHECK_INT(d.check.bounded_count, 2);
    checked_close(&d);
}

/* ---- a curve and its own points ---- */

TEST(a_curve_is_measured_against_its_own_points_in_its_own_dimension)
{
    static const double points[][3] = {{0, 0, 0}, {1, 0.004, 0}, {2, -0.003, 0}, {3, 0, 0}};
    static const double ends[2][2] = {{0, 0}, {3, 0}};
    static const double bounds[] = {0.00401, 0.00399};
    for (int i = 0; i < 2; i++) {
        checked_design d;
        batten_curve *line = NULL;
        checked_open("  c: {interpolate: q}\n  q: {points: [[0, 0]]}\n", "c", &d);
        CHECK_OK(batten_curve_line(2, ends[0], ends[1], &line));
        checked_put(&d, "c",
                    &(batten_object){.name = "c",
                                     .kind = BATTEN_OBJECT_CURVE,
                                     .curve = line,
                                     .point_count = COUNT(points),
                                     .points = points[0]});
        batten_curve_unref(line);
        const bat_checked *c = checked_run(&d, bounds[i]);
        CHECK_INT(c->distance_count, 1);
        CHECK_INT(c->distances[0].count, 4);
        CHECK_NEAR(c->distances[0].max, 0.004, 1e-12);
        CHECK_NEAR(c->distances[0].rms, 0.0025, 1e-12);
        CHECK(c->distances[0].worst[0] == 1 && c->distances[0].worst[1] == 0.004);
        CHECK_INT(d.check.bounded_count, 1);
        CHECK(d.check.ok == (i == 0));
        checked_close(&d);
    }
}
