/* What the options of a spine may be. */
#include "support/test.h"

#include <batten/standard.h>
#include <batten/sweep.h>

static batten_curve *straight(int dimension, const double *ends)
{
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(dimension, ends, ends + dimension, &line));
    return line;
}

static const batten_vec3 nowhere = {0, 0, 0}, infinite = {0, INFINITY, 1}, upward = {0, 0, 1};

static void change_options(int which, const batten_curve *plane, const batten_curve *law,
                           batten_surface_sweep_options *o)
{
    o->scale = which == 0 ? plane : which == 1 ? law : NULL;
    o->scale_y = which == 1 ? plane : which == 3 ? law : NULL;
    o->twist = which == 2 ? plane : NULL;
    o->up = which == 4 || which == 7 ? &upward
            : which == 5             ? &infinite
            : which == 6             ? &nowhere
                                     : NULL;
    o->guide = which == 4 ? plane : NULL;
    if (which == 7)
        o->degree = 0;
    if (which == 8)
        o->degree = BATTEN_MAX_DEGREE + 1;
    if (which == 9)
        o->tolerance = -1;
    if (which == 10)
        o->x = (batten_vec3){NAN, 2, 3};
    if (which == 11)
        o->x = (batten_vec3){2, 0, 0};
}

static const struct {
    batten_status status;
    const char *message;
} refused[] = {
    {BATTEN_BAD_ARGUMENT, "the law of the scale has dimension 2, not 1"},
    {BATTEN_BAD_ARGUMENT, "the law of the scale in y has dimension 2, not 1"},
    {BATTEN_BAD_ARGUMENT, "the law of the twist has dimension 2, not 1"},
    {BATTEN_BAD_ARGUMENT, "there is a scale in y, and none in x"},
    {BATTEN_BAD_ARGUMENT, "the frames cannot look both upward and at a guide"},
    {BATTEN_NOT_FINITE, "upward is (0, inf, 1)"},
    {BATTEN_BAD_ARGUMENT, "the upward direction has no length"},
    {BATTEN_BAD_DEGREE, "the degree along the path is 0, not 1 to "},
    {BATTEN_BAD_DEGREE, "the degree along the path is "},
    {BATTEN_BAD_ARGUMENT, "the tolerance is -1, not above 0"},
    {BATTEN_NOT_FINITE, "the first x-axis is (nan, 2, 3)"},
    {BATTEN_SINGULAR_HERE, "the first x-axis, (2, 0, 0), lies along the spine"},
};

TEST(options_of_sweeps_that_cannot_be_are_named)
{
    const double plane_ends[4] = {0, 0, 1, 1}, spine_ends[6] = {0, 0, 0, 5, 0, 0};
    const double law_ends[2] = {1, 2}, section_ends[4] = {-1, 0, 1, 0};
    batten_curve *plane = straight(2, plane_ends), *spine = straight(3, spine_ends);
    batten_curve *law = NULL, *section = straight(2, section_ends);
    const double knots[4] = {0, 0, 1, 1};
    CHECK_OK(batten_curve_create((batten_points){1, 2, law_ends}, 1, NULL, knots, &law));
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        batten_surface *none = NULL;
        change_options(i, plane, law, &options);
        CHECK_STATUS(
            batten_surface_sweep((batten_curve_row){1, (const batten_curve *const *)&section},
                                 spine, &options, NULL, NULL, &none),
            refused[i].status);
        CHECK_MESSAGE(refused[i].message);
        CHECK(!none);
    }
    batten_curve_unref(section);
    batten_curve_unref(law);
    batten_curve_unref(spine);
    batten_curve_unref(plane);
}

/* A section from (1, 0) to (0, 1) on a straight spine of length 4 whose first x-axis looks along
 * (0, 0, 3), scaled from 1 to 3 in x and to 2 in y and turned by up to a right angle. */
TEST(laws_scale_and_turn_the_section_about_a_straight_spine)
{
    static const double knots[4] = {2, 2, 6, 6}; /* whatever the domain of a law */
    static const double factors[3][2] = {{1, 3}, {1, 2}, {0, 1.5707963267948966}};
    const double spine_ends[6] = {0, 0, 0, 4, 0, 0}, section_ends[4] = {1, 0, 0, 1};
    batten_curve *spine = straight(3, spine_ends), *section = straight(2, section_ends);
    batten_curve *laws[3];
    for (int k = 0; k < 3; k++) {
        laws[k] = NULL;
        CHECK_OK(
            batten_curve_create((batten_points){1, 2, factors[k]}, 1, NULL, knots, &laws[k]));
    }
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface_sweep_report report;
    batten_surface *surface = NULL;
    options.x = (batten_vec3){7, 0, 3};
    options.scale = laws[0];
    options.scale_y = laws[1];
    options.twist = laws[2];
    options.tolerance = 1e-5;
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (const batten_curve *const *)&section},
                                  spine, &options, NULL, &report, &surface));
    CHECK(report.error <= 1e-5 && report.reversed == -1 && report.turned == -1);
    CHECK_NEAR(report.length, 4, 1e-12);
    CHECK(report.clearance == 1 && report.turn == 0);
    for (int j = 0; j <= 8; j++) {
        const double v = j / 8.0, turn = factors[2][1] * v;
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(surface, 0, v, 0, p));
        CHECK_OK(batten_surface_evaluate(surface, 1, v, 0, q));
        /* X looks along z, Y = (1, 0, 0) x (0, 0, 1) = (0, -1, 0). */
        const double x[3] = {4 * v, -(1 + 2 * v) * sin(turn), (1 + 2 * v) * cos(turn)};
        const double y[3] = {4 * v, -(1 + v) * cos(turn), -(1 + v) * sin(turn)};
        for (int c = 0; c < 3; c++) {
            CHECK_NEAR(p[c], x[c], 1e-5);
            CHECK_NEAR(q[c], y[c], 1e-5);
        }
    }
    batten_surface_unref(surface);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(laws[k]);
    batten_curve_unref(section);
    batten_curve_unref(spine);
}

static const double shares[][3] = {{0, 0.5, 0.9}, {0.1, 0.5, 1}};

TEST(sections_must_stand_from_the_start_of_the_spine_to_its_end)
{
    const double spine_ends[6] = {0, 0, 0, 4, 0, 0}, section_ends[4] = {1, 0, 0, 1};
    batten_curve *spine = straight(3, spine_ends), *section = straight(2, section_ends);
    const batten_curve *sections[3] = {section, section, section};
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *none = NULL;
    for (int i = 0; i < COUNT(shares); i++) {
        options.at = shares[i];
        CHECK_STATUS(batten_surface_sweep((batten_curve_row){3, sections}, spine, &options,
                                          NULL, NULL, &none),
                     BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(i == 0
                          ? "the sections stand from 0 to 0.9 of the spine, not from 0 to 1"
                          : "the sections stand from 0.1 to 1 of the spine, not from 0 to 1");
    }
    CHECK_STATUS(
        batten_surface_sweep((batten_curve_row){0, sections}, spine, NULL, NULL, NULL, &none),
        BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there are 0 sections, and a sweep needs 1");
    batten_curve_unref(section);
    batten_curve_unref(spine);
}

TEST(corners_that_split_a_sweep_make_more_than_one_surface)
{
    const double corner[9] = {0, 0, 0, 4, 0, 0, 4, 4, 0}, section_ends[4] = {0.1, 0, 0, 0.1};
    batten_curve *spine = NULL, *section = straight(2, section_ends);
    const batten_curve_row row = {1, (const batten_curve *const *)&section};
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *none = NULL;
    batten_surfaces parts = {0, NULL};
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, corner}, &spine));
    options.corners = BATTEN_CORNER_SPLIT;
    CHECK_OK(batten_surfaces_sweep(row, spine, &options, NULL, NULL, &parts));
    CHECK_INT(parts.count, 2);
    batten_surfaces_release(&parts);
    CHECK_STATUS(batten_surface_sweep(row, spine, &options, NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corners split the sweep into 2 surfaces");
    CHECK_STATUS(batten_surface_sweep_procedural(row, spine, &options, &none),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the sections do not meet at the corner of the spine at ");
    CHECK(!none);
    batten_curve_unref(section);
    batten_curve_unref(spine);
}
