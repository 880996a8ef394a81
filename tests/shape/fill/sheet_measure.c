/* What a sheet is reported to have reached. */
#include "shape/fill/sheet.h"

#include "shape/fill/loops.h"

static const double ends[2] = {0, 1};

static batten_curve *bezier(int dimension, int degree, const double *points)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_bezier(dimension, (batten_pieces){degree, 1, ends}, points, NULL,
                                      &curve));
    return curve;
}

/* The plane z = 0 of the frame over the square of 2 about its centre, in spans of 1. */
static batten_surface *make_floor(void)
{
    const double knots[5] = {-1, -1, 0, 1, 1}, two[4] = {-1, -1, 1, 1};
    const double points[18] = {-1, -1, 0, -1, 1, 0, 0, -1, 0, 0, 1, 0, 1, -1, 0, 1, 1, 0};
    const batten_axis u = {1, 3, knots, false}, v = {1, 2, two, false};
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_create(3, &u, &v, points, NULL, &surface));
    return surface;
}

/* Two sides of a frame of size 2 about (10, 20, 30): an arch 0.25 high along y = -0.5 with a ribbon
 * that rises by 3 in 4 across it, and a level line back along y = 0.5 at the height 0.1. */
static void begin_sides(bat_sheet_outline *out)
{
    static const double arch[3][3] = {{-1, -0.5, 0}, {0, -0.5, 0.5}, {1, -0.5, 0}};
    static const double line[2][3] = {{-1, 0.5, 0.1}, {1, 0.5, 0.1}};
    static const double rise[2][3] = {{0, 4, 3}, {0, 4, 3}},
                        bend[2][3] = {{0, 0, 8}, {0, 0, 8}};
    static const double flat[3][2] = {{-1, -0.5}, {0, -0.5}, {1, -0.5}};
    static const double back[2][2] = {{-1, 0.5}, {1, 0.5}};
    *out = (bat_sheet_outline){.count = 2,
                               .sides = {{.given = 1}, {.given = 0}},
                               .reversed = {false, true},
                               .centre = {10, 20, 30},
                               .axes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               .size = 2};
    out->sides[0].curve = bezier(3, 2, arch[0]);
    out->sides[0].slope = bezier(3, 1, rise[0]);
    out->sides[0].bend = bezier(3, 1, bend[0]);
    out->sides[1].curve = bezier(3, 1, line[0]);
    out->plane[0] = bezier(2, 2, flat[0]);
    out->plane[1] = bezier(2, 1, back[0]);
}

TEST(gaps_angles_and_curvatures_along_sides_are_reported_in_the_model)
{
    bat_sheet_outline outline;
    batten_fill_sheet_report report = {0};
    batten_surface *floor = make_floor();
    const bat_sheet_inside inside = {{0}, {0}};
    begin_sides(&outline);
    CHECK_OK(bat_sheet_measure(&outline, &inside, floor, &report));
    CHECK_INT(report.count, 2);
    CHECK_INT(report.columns, 2);
    CHECK_INT(report.rows, 1);
    const batten_fill_edge *arch = &report.outer[0], *line = &report.outer[1];
    CHECK_INT(arch->curve, 1);
    CHECK_INT(line->curve, 0);
    CHECK(arch->has_slope && arch->has_curvature && !line->has_slope && !line->has_curvature);
    /* 0.25 of the frame at x = 0; the nearest of 65 places is a 65th of the frame beside it */
    CHECK(arch->gap <= 0.5 && arch->gap > 0.4998);
    CHECK_NEAR(arch->gap_at[0], 10, 0.032);
    CHECK_NEAR(arch->gap_at[1], 19, 1e-14);
    CHECK_NEAR(line->gap, 0.2, 1e-15);
    CHECK_NEAR(line->gap_at[1], 21, 1e-14);
    /* At both ends the arch has a slope of 1/2, across it the ribbon one of 3/4. */
    CHECK_NEAR(arch->angle, acos(1 / sqrt(1 + 0.25 + 0.5625)), 1e-12);
    CHECK_NEAR(fabs(arch->angle_at[0] - 10), 2, 1e-12);
    CHECK_NEAR(arch->angle_at[1], 19, 1e-14);
    bat_sheet_outline_free(&outline);
    batten_surface_unref(floor);
}

TEST(what_is_inside_and_missed_most_is_named_by_number_and_place)
{
    static const double points[3][3] = {{10, 20, 30.1}, {11, 20.5, 29.4}, {9, 20, 30.5}};
    static const double lines[2][2][3] = {{{10, 20, 30.3}, {11, 20, 30}},
                                          {{9, 20, 30}, {9, 21, 30.8}}};
    batten_curve *curves[2] = {bezier(3, 1, lines[0][0]), bezier(3, 1, lines[1][0])};
    const batten_curve *const row[2] = {curves[0], curves[1]};
    static const struct {
        int points, curves, inside;
        double gap, at[3];
    } rows[] = {
        {0, 0, 0, 0, {0, 0, 0}},          {1, 0, 1, 0.1, {10, 20, 30.1}},
        {3, 0, 2, 0.6, {11, 20.5, 29.4}}, {0, 1, -1, 0.3, {10, 20, 30.3}},
        {3, 1, 2, 0.6, {11, 20.5, 29.4}}, {3, 2, -2, 0.8, {9, 21, 30.8}},
    };
    bat_sheet_outline outline;
    batten_surface *floor = make_floor();
    begin_sides(&outline);
    for (int i = 0; i < COUNT(rows); i++) {
        const bat_sheet_inside inside = {{3, rows[i].points, points[0]}, {rows[i].curves, row}};
        batten_fill_sheet_report report = {0};
        CHECK_OK(bat_sheet_measure(&outline, &inside, floor, &report));
        CHECK_INT(report.inside, rows[i].inside);
        CHECK_NEAR(report.inside_gap, rows[i].gap, 1e-13);
        for (int c = 0; c < 3; c++)
            CHECK_NEAR(report.inside_at[c], rows[i].at[c], 1e-13);
    }
    bat_sheet_outline_free(&outline);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(curves[k]);
    batten_surface_unref(floor);
}
