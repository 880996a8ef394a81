#include "loft/faired.h"

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

static const batten_table_line wl = {"wl", true, 0.5};

/* Points with feet nearby, and where they are read off. */
static const struct {
    bat_loft_datum datum;
    const batten_table_line *waterline;
    double to[3];
} given[] = {
    /* station and waterline */
    {{.point = {1, 0.4, 0.5}, .u = 0.3, .v = 0.4}, &wl, {1, 0.375, 0.5}},
    /* the keel and the sheer in a station: y and z are those of the edge */
    {{.point = {3, 0.3, 0.05}, .on_v_edge = true, .u = 0.7, .v = 0}, NULL, {3, 0.375, 0}},
    {{.point = {3, 1.3, 0.9}, .on_v_edge = true, .u = 0.7, .v = 1}, &wl, {3, 1.375, 1}},
    /* the end of the hull on a waterline */
    {{.point = {4, 0.7, 0.5}, .on_u_edge = true, .u = 1, .v = 0.6}, &wl, {4, 0.75, 0.5}},
    /* a corner */
    {{.point = {4.1, 0.6, 0}, .on_u_edge = true, .on_v_edge = true, .u = 1}, &wl, {4, 0.5, 0}},
    /* on no line: the foot as it is */
    {{.point = {2, 0.5, 0.6}, .u = 0.5, .v = 0.5}, NULL, {2, 0.5, 0.5}},
};

TEST(points_are_read_off_where_stations_waterlines_and_edges_meet_the_surface)
{
    bat_loft_patch patch;
    make_bowl(&patch);
    for (int k = 0; k < COUNT(given); k++) {
        double to[3];
        const double off = bat_loft_read_off(&patch, &given[k].datum, given[k].waterline, to);
        CHECK(off <= 1e-14);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(to[c], given[k].to[c], 1e-14);
    }
    bat_loft_patch_free(&patch);
}

TEST(a_waterline_that_does_not_meet_the_surface_leaves_the_nearest_point_and_says_how_far)
{
    static const batten_table_line above = {"wl", true, 1.25};
    const bat_loft_datum datum = {.point = {2, 1.3, 1.25}, .u = 0.5, .v = 1};
    bat_loft_patch patch;
    double to[3];
    make_bowl(&patch);
    CHECK_NEAR(bat_loft_read_off(&patch, &datum, &above, to), 0.25, 1e-14);
    CHECK_NEAR(to[0], 2, 1e-14);
    CHECK_NEAR(to[1], 1.25, 1e-14);
    CHECK_NEAR(to[2], 1, 1e-14);
    bat_loft_patch_free(&patch);
}
