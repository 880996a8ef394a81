/* What the report of a skin says, for sections whose jumps have closed forms. */
#include "shape/sections.h"

static const double pi = 3.14159265358979323846;

/* Two legs at right angles of length 1 at height z; the corner stands at the parameter `at`. */
static batten_curve *angle_at(double z, double at)
{
    const double points[9] = {0, 0, z, 1, 0, z, 1, 1, z}, knots[5] = {0, 0, at, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 1, NULL, knots, &curve));
    return curve;
}

static const struct {
    double corner[2];
    int knots;
    double span_ratio, speed_jump;
} rows[] = {
    {{0.25, 0.25}, 1, 1.0 / 3, 2.0 / 3}, /* speeds 4 and 4 / 3 */
    {{0.5, 0.5}, 1, 1, 0},
    {{0.8, 0.8}, 1, 0.25, 0.75},
    {{0.25, 0.5}, 2, 1, 0}, /* spans 1/4, 1/4, 1/2 */
};

TEST(knots_spans_and_jumps_of_angles_are_those_of_their_legs)
{
    for (int i = 0; i < COUNT(rows); i++) {
        batten_curve *sections[2] = {angle_at(0, rows[i].corner[0]),
                                     angle_at(2, rows[i].corner[1])};
        batten_surface_skin_report report = {.worst_section = 9};
        batten_surface *surface = NULL;
        CHECK_OK(
            batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                NULL, NULL, NULL, &report, &surface));
        CHECK_INT(report.knot_count, rows[i].knots);
        CHECK_INT(report.exact_knot_count, rows[i].knots);
        CHECK_NEAR(report.span_ratio, rows[i].span_ratio, 1e-14);
        if (rows[i].knots == 1) {
            CHECK_NEAR(report.speed_jump, rows[i].speed_jump, 1e-14);
            CHECK_NEAR(report.normal_jump, pi / 2, 1e-14);
        }
        CHECK(report.crease == 0 && report.error < 1e-15 && report.worst_section >= 0);
        CHECK(report.worst_section < 2 && report.cure == BATTEN_CURE_NONE);
        CHECK(report.reversed_count == 0 && report.turned_count == 0);
        CHECK(report.reversed == -1 && report.turned == -1);
        CHECK(report.crossing_count == 0 && report.crossing == -1);
        CHECK(report.disorder_count == 0 && report.disorder == -1);
        batten_surface_unref(surface);
        unref_all(2, sections);
    }
}

/* A straight section whose speed is 1 up to 1/2 and f from there on. */
static batten_curve *line_of_speeds(double z, double f)
{
    const double points[9] = {0, 0, z, 0.5, 0, z, 0.5 + f / 2, 0, z};
    const double knots[5] = {0, 0, 0.5, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 1, NULL, knots, &curve));
    return curve;
}

/* Flat sections of one plane: speeds jump, normals do not, whatever the factors. */
TEST(speeds_that_jump_in_a_plane_make_no_crease)
{
    batten_curve *sections[2] = {line_of_speeds(0, 4), line_of_speeds(1, 2)};
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){2, (const batten_curve *const *)sections},
                                 NULL, NULL, NULL, &report, &surface));
    CHECK_NEAR(report.speed_jump, 0.75, 1e-14);
    CHECK(report.normal_jump < 1e-15 && report.crease < 1e-15);
    batten_surface_unref(surface);
    unref_all(2, sections);
}
