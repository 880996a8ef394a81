#include "support/faults.h"
#include "support/test.h"

#include <batten/interpolate.h>
#include <batten/standard.h>
#include <batten/sweep.h>
#include <stdlib.h>

#define PI 3.14159265358979323846

typedef const batten_curve *const *curves;

/* A circle of space about the z-axis. */
static batten_curve *circle(double radius)
{
    batten_curve *curve = NULL;
    const batten_frame world = batten_frame_world();
    CHECK_OK(batten_curve_arc_in(&world, radius, 0, 2 * PI, &curve));
    return curve;
}

static batten_curve *through(int count, const double *points)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, count, points}, NULL, NULL, &curve));
    return curve;
}

static const double bend_points[15] = {0, 0, 0, 2, 1, 0.3, 4, 0.5, 1.5, 5, -1, 2, 7, -1, 1};

static double distance(const double *a, const double *b)
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* The largest distance of two surfaces at equal parameters. */
static double deviation(const batten_surface *a, const batten_surface *b, int count)
{
    const batten_interval u = batten_surface_domain(a, BATTEN_U),
                          v = batten_surface_domain(a, BATTEN_V);
    double worst = 0;
    for (int i = 0; i <= count; i++)
        for (int j = 0; j <= count; j++) {
            double p[3], q[3];
            const double x = u.a + (u.b - u.a) * i / count, y = v.a + (v.b - v.a) * j / count;
            CHECK_OK(batten_surface_evaluate(a, x, y, 0, p));
            CHECK_OK(batten_surface_evaluate(b, x, y, 0, q));
            worst = fmax(worst, distance(p, q));
        }
    return worst;
}

TEST(a_circle_along_a_circle_is_a_torus_within_the_tolerance)
{
    static const double tolerances[] = {1e-3, 1e-5, 1e-7};
    batten_curve *section = circle(0.5), *spine = circle(2);
    int sections = 0;
    for (int k = 0; k < COUNT(tolerances); k++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        options.tolerance = tolerances[k];
        batten_surface_sweep_report report;
        batten_surface *surface = NULL;
        CHECK_EACH_ALLOCATION(batten_surface_sweep((batten_curve_row){1, (curves)&section},
                                                   spine, &options, NULL, &report, &surface));
        double worst = 0;
        for (int i = 0; i <= 16; i++)
            for (int j = 0; j <= 64; j++) {
                double p[3];
                CHECK_OK(batten_surface_evaluate(surface, i / 16.0, j / 64.0, 0, p));
                worst = fmax(worst, fabs(hypot(hypot(p[0], p[1]) - 2, p[2]) - 0.5));
            }
        CHECK(worst <= report.error && report.error <= tolerances[k]);
        CHECK(report.section_count > sections);
        CHECK_NEAR(report.clearance, 0.75, 1e-12);
        CHECK_NEAR(report.length, 4 * PI, 1e-10);
        sections = report.section_count;
        batten_surface_unref(surface);
    }
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(a_section_on_a_straight_spine_is_a_cylinder_to_rounding)
{
    const double a[3] = {1, 2, 3}, b[3] = {1, 2, 8};
    batten_curve *section = circle(1.5), *spine = NULL;
    batten_surface *surface = NULL;
    batten_surface_sweep_report report;
    CHECK_OK(batten_curve_line(3, a, b, &spine));
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, NULL, NULL,
                                  &report, &surface));
    CHECK_INT(report.section_count, 2);
    CHECK_INT(batten_surface_degree(surface, BATTEN_V), 1);
    for (int i = 0; i <= 16; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 16.0, i / 16.0, 0, p));
        CHECK_NEAR(hypot(p[0] - 1, p[1] - 2), 1.5, 2e-15);
        CHECK_NEAR(p[2], 3 + 5 * i / 16.0, 4e-15);
    }
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

static batten_curve *law(int count, const double *values)
{
    double at[16];
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = at;
    for (int i = 0; i < count; i++)
        at[i] = i;
    CHECK_OK(
        batten_curve_interpolate((batten_points){1, count, values}, &options, NULL, &curve));
    return curve;
}

TEST(the_surface_keeps_its_tolerance_with_all_frames_and_laws)
{
    static const double scales[5] = {1, 0.7, 0.8, 1.1, 0.9}, wide[3] = {1, 1.4, 1},
                        turns[2] = {0, 2};
    batten_curve *section = circle(0.3), *spine = through(5, bend_points);
    batten_curve *scale = law(5, scales), *flat = law(3, wide), *twist = law(2, turns);
    const batten_vec3 up = {0, 0, 1};
    for (int kind = 0; kind < 7; kind++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        options.tolerance = 1e-5;
        options.degree = kind == 6 ? 5 : 3;
        if (kind == 1)
            options.frames = BATTEN_FRAME_FIXED;
        options.up = kind == 2 ? &up : NULL;
        options.scale = kind >= 3 ? scale : NULL;
        options.scale_y = kind >= 4 ? flat : NULL;
        options.twist = kind >= 5 ? twist : NULL;
        batten_surface_sweep_report report;
        batten_surface *surface = NULL, *truth = NULL;
        CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, &report, &surface));
        CHECK_EACH_ALLOCATION(batten_surface_sweep_procedural(
            (batten_curve_row){1, (curves)&section}, spine, &options, &truth));
        CHECK(deviation(surface, truth, 40) <= 1e-5);
        CHECK(report.error <= 1e-5 && report.section_count < 300);
        batten_surface_unref(truth);
        batten_surface_unref(surface);
    }
    batten_curve_unref(twist);
    batten_curve_unref(flat);
    batten_curve_unref(scale);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

/* Some numbers in -1 .. 1, always the same ones. */
static double next_number(unsigned *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / (1 << 23) - 1;
}

/* The largest distance of a surface from the true sweep, looked for densely
 * along the way. */
static double worst_of(const batten_surface *surface, const batten_surface *truth)
{
    const batten_interval v = batten_surface_domain(truth, BATTEN_V);
    double worst = 0;
    for (int j = 0; j <= 1500; j++)
        for (int i = 0; i < 4; i++) {
            double p[3], q[3];
            const double at = j < 1500 ? v.a + (v.b - v.a) * j / 1500 : v.b;
            CHECK_OK(batten_surface_evaluate(surface, i / 4.0, at, 0, p));
            CHECK_OK(batten_surface_evaluate(truth, i / 4.0, at, 0, q));
            worst = fmax(worst, distance(p, q));
        }
    return worst;
}

TEST(the_error_that_a_sweep_reports_is_not_below_the_truth)
{
    static const double turns[2] = {0, 1.5}, tolerances[3] = {1e-2, 1e-3, 1e-5};
    const batten_vec3 up = {0, 0, 1};
    batten_curve *section = circle(0.05), *twist = law(2, turns);
    unsigned state = 7;
    for (int n = 0; n < 3; n++) {
        double points[18], scales[6];
        for (int i = 0; i < 6; i++) {
            points[3 * i] = 2 * i + 0.4 * next_number(&state);
            points[3 * i + 1] = 0.7 * next_number(&state);
            points[3 * i + 2] = 0.7 * next_number(&state);
            scales[i] = 2 + 0.4 * next_number(&state);
        }
        batten_curve *spine = through(6, points), *scale = law(6, scales);
        for (int kind = 1; kind < 6; kind += kind == 1 ? 2 : 1) {
            batten_surface_sweep_options options = batten_surface_sweep_defaults();
            options.tolerance = tolerances[(n + kind) % 3];
            options.degree = kind == 3 ? 5 : kind == 4 ? 2 : 3;
            options.up = kind == 1 || kind == 5 ? &up : NULL;
            options.scale = kind >= 2 ? scale : NULL;
            options.twist = kind >= 4 ? twist : NULL;
            options.allow_folds = true;
            batten_surface_sweep_report report;
            batten_surface *surface = NULL, *truth = NULL;
            CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine,
                                          &options, NULL, &report, &surface));
            CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section},
                                                     spine, &options, &truth));
            const double worst = worst_of(surface, truth);
            CHECK(worst <= report.error && report.error <= options.tolerance);
            batten_surface_unref(truth);
            batten_surface_unref(surface);
        }
        batten_curve_unref(scale);
        batten_curve_unref(spine);
    }
    batten_curve_unref(twist);
    batten_curve_unref(section);
}

TEST(the_derivatives_of_the_true_sweep_are_those_of_its_points)
{
    static const double scales[3] = {1, 0.7, 0.9}, turns[3] = {0, 1, -1};
    batten_curve *section = circle(0.3), *spine = through(5, bend_points);
    batten_curve *scale = law(3, scales), *twist = law(3, turns);
    for (int kind = 0; kind < 3; kind++) {
        const batten_vec3 up = {0.1, 0, 1};
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        options.scale = scale;
        options.twist = twist;
        options.up = kind == 1 ? &up : NULL;
        options.guide = kind == 2 ? section : NULL;
        options.allow_folds = true;
        batten_surface *truth = NULL;
        CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, spine,
                                                 &options, &truth));
        CHECK_TEXT(batten_surface_kind(truth), "sweep");
        const batten_interval v = batten_surface_domain(truth, BATTEN_V);
        const double at = v.a + 0.37 * (v.b - v.a), h = 1e-4 * (v.b - v.a);
        double low[30], here[30], high[30];
        CHECK_OK(batten_surface_evaluate(truth, 0.3, at - h, 3, low));
        CHECK_OK(batten_surface_evaluate(truth, 0.3, at, 3, here));
        CHECK_OK(batten_surface_evaluate(truth, 0.3, at + h, 3, high));
        for (int k = 0; k < 3; k++)
            for (int l = 0; k + l < 3; l++)
                for (int c = 0; c < 3; c++) {
                    const int from = 3 * BATTEN_SURFACE_DERIVATIVE(k, l) + c,
                              to = 3 * BATTEN_SURFACE_DERIVATIVE(k, l + 1) + c;
                    const double slope = (high[from] - low[from]) / (2 * h);
                    CHECK_NEAR(here[to], slope, 1e-4 * (1 + fabs(slope)));
                }
        batten_surface_unref(truth);
    }
    batten_curve_unref(twist);
    batten_curve_unref(scale);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(a_pipe_has_the_area_of_its_torus)
{
    batten_curve *spine = circle(2);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.tolerance = 1e-7;
    batten_surfaces made = {0, NULL};
    CHECK_EACH_ALLOCATION(batten_surfaces_pipe(0.5, spine, &options, NULL, NULL, &made));
    CHECK_INT(made.count, 1);
    /* Midpoints at two steps: their errors are as 4 to 1. */
    double area[2] = {0, 0};
    for (int k = 0; k < 2; k++)
        for (int n = 32 << k, i = 0; i < n * n; i++) {
            double s[9];
            CHECK_OK(batten_surface_evaluate(made.at[0], (i / n + 0.5) / n, (i % n + 0.5) / n,
                                             1, s));
            const double x = s[4] * s[8] - s[5] * s[7], y = s[5] * s[6] - s[3] * s[8],
                         z = s[3] * s[7] - s[4] * s[6];
            area[k] += hypot(hypot(x, y), z) / n / n;
        }
    CHECK_NEAR((4 * area[1] - area[0]) / 3, 4 * PI * PI * 2 * 0.5, 1e-4);
    double first[3], last[3];
    CHECK_OK(batten_surface_evaluate(made.at[0], 0.2, 0, 0, first));
    CHECK_OK(batten_surface_evaluate(made.at[0], 0.2, 1, 0, last));
    CHECK_NEAR(distance(first, last), 0, 0);
    batten_surfaces_release(&made);
    CHECK_STATUS(batten_surfaces_pipe(2, spine, &options, NULL, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("run into each other from 0 to 1 of the spine");
    options.allow_folds = true;
    batten_surface_sweep_report report;
    CHECK_OK(batten_surfaces_pipe(2.5, spine, &options, NULL, &report, &made));
    CHECK_NEAR(report.clearance, -0.25, 1e-12);
    batten_surfaces_release(&made);
    batten_curve_unref(spine);
}

TEST(another_parameter_of_the_spine_leaves_the_image_alone)
{
    static const double scales[4] = {1, 0.6, 0.8, 1.2};
    batten_curve *section = circle(0.3), *spine = through(5, bend_points), *other = NULL;
    batten_curve *scale = law(4, scales);
    batten_surface *truth[2] = {NULL, NULL};
    CHECK_OK(batten_curve_moebius(spine, 2, 0, 0.1, 1.7, &other));
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.scale = scale;
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, spine,
                                             &options, &truth[0]));
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, other,
                                             &options, &truth[1]));
    const batten_interval v = batten_curve_domain(spine);
    for (int j = 0; j <= 20; j++) {
        const double at = v.a + (v.b - v.a) * j / 20;
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(truth[0], 0.7, at, 0, p));
        const batten_interval w = batten_curve_domain(other);
        const double moved = fmin(w.b, fmax(w.a, 2 * at / (0.1 * at + 1.7)));
        CHECK_OK(batten_surface_evaluate(truth[1], 0.7, moved, 0, q));
        CHECK_NEAR(distance(p, q), 0, 1e-9);
    }
    batten_surface_unref(truth[1]);
    batten_surface_unref(truth[0]);
    batten_curve_unref(scale);
    batten_curve_unref(other);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(a_moved_and_turned_spine_makes_the_moved_and_turned_surface)
{
    batten_affine map =
        batten_affine_rotation((batten_vec3){1, 0, 2}, (batten_vec3){1, 2, -1}, 2);
    map = batten_affine_compose(map, batten_affine_scaling(3, 3, 3));
    batten_curve *section = circle(0.3), *large = circle(0.9);
    batten_curve *spine = through(5, bend_points), *other = NULL;
    batten_surface *plain = NULL, *image = NULL, *expected = NULL;
    CHECK_OK(batten_curve_transform(spine, &map, &other));
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.x = (batten_vec3){0, 0, 1};
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, NULL, &plain));
    const double *m = map.m[0];
    options.x = (batten_vec3){m[2], m[5], m[8]};
    options.tolerance = 3e-6;
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&large}, other, &options, NULL,
                                  NULL, &image));
    CHECK_OK(batten_surface_transform(plain, &map, &expected));
    CHECK_NEAR(deviation(expected, image, 20), 0, 1e-8);
    batten_surface_unref(expected);
    batten_surface_unref(image);
    batten_surface_unref(plain);
    batten_curve_unref(other);
    batten_curve_unref(spine);
    batten_curve_unref(large);
    batten_curve_unref(section);
}

TEST(G6_closing_frames_close_a_sweep_along_a_closed_space_curve)
{
    double points[3 * 12];
    for (int i = 0; i < 12; i++) {
        const double t = 2 * PI * i / 12;
        points[3 * i] = 3 * cos(t) + 0.8 * cos(2 * t);
        points[3 * i + 1] = 3 * sin(t);
        points[3 * i + 2] = sin(2 * t + 0.7) + 0.5 * cos(3 * t);
    }
    batten_curve *spine = NULL, *section = NULL;
    batten_curve_interpolate_options periodic = batten_curve_interpolate_defaults();
    periodic.closed = true;
    CHECK_OK(batten_curve_interpolate((batten_points){3, 12, points}, &periodic, NULL, &spine));
    CHECK_OK(batten_curve_ellipse(0.5, 0.2, 0, 2 * PI, &section));
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.frames = BATTEN_FRAME_CLOSING;
    options.tolerance = 1e-4;
    batten_surface_sweep_report report;
    batten_surface *surface = NULL;
    double angle;
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, &report, &surface));
    CHECK_OK(batten_curve_holonomy(spine, 1e-9, NULL, &angle));
    CHECK_NEAR(report.turn, angle, 1e-8);
    CHECK(fabs(angle) > 0.1);
    CHECK(batten_surface_is_closed(surface, BATTEN_V, 0));
    batten_surface_unref(surface);
    batten_curve_unref(section);
    batten_curve_unref(spine);
}

/* ---- corners ---- */

static batten_curve *frame_around(void)
{
    static const double points[15] = {0, 0, 0, 4, 0, 0, 4, 3, 0, 0, 3, 0, 0, 0, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_polyline((batten_points){3, 5, points}, &curve));
    return curve;
}

TEST(mitred_corners_of_straight_sides_are_exact_and_close)
{
    static const double square[15] = {0.2, 0.2, 0,    -0.2, 0.2, 0,   -0.2, -0.2,
                                      0,   0.2, -0.2, 0,    0.2, 0.2, 0};
    batten_curve *section = NULL, *spine = frame_around();
    CHECK_OK(batten_curve_polyline((batten_points){3, 5, square}, &section));
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *surface = NULL;
    batten_surface_sweep_report report;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("a corner of 90 degrees at");
    options.corners = BATTEN_CORNER_MITRE;
    options.x = (batten_vec3){0, 0, 1};
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, &report, &surface));
    CHECK_INT(report.section_count, 5);
    CHECK(report.error < 1e-14);
    CHECK(batten_surface_is_closed(surface, BATTEN_V, 1e-14));
    /* Outside it is the box from -0.2 to 4.2 and 3.2. */
    const batten_box box = batten_surface_box(surface);
    CHECK_NEAR(box.low.x, -0.2, 1e-14);
    CHECK_NEAR(box.high.x, 4.2, 1e-14);
    CHECK_NEAR(box.high.y, 3.2, 1e-14);
    CHECK_NEAR(box.high.z, 0.2, 1e-14);
    batten_surface_unref(surface);
    options.corners = BATTEN_CORNER_SPLIT;
    batten_surfaces made = {0, NULL};
    CHECK_EACH_ALLOCATION(batten_surfaces_sweep((batten_curve_row){1, (curves)&section}, spine,
                                                &options, NULL, &report, &made));
    CHECK_INT(made.count, 4);
    batten_surfaces_release(&made);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

/* ---- several sections ---- */

TEST(several_sections_are_met_where_they_stand)
{
    batten_curve *sections[3] = {circle(0.5), NULL, circle(0.3)}, *spine = circle(3);
    CHECK_OK(batten_curve_ellipse(0.7, 0.3, 0, 2 * PI, &sections[1]));
    static const double at[3] = {0, 0.25, 1};
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.at = at;
    options.tolerance = 1e-5;
    options.x = (batten_vec3){0, 0, 1};
    batten_surface *surface = NULL, *truth = NULL;
    CHECK_OK(batten_surface_sweep((batten_curve_row){3, (curves)sections}, spine, &options,
                                  NULL, NULL, &surface));
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){3, (curves)sections}, spine,
                                             &options, &truth));
    CHECK(deviation(surface, truth, 24) <= 1e-5);
    for (int i = 0; i <= 16; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(sections[1], i / 16.0, 0, q));
        CHECK_OK(batten_surface_evaluate(truth, i / 16.0, 0.25, 0, p));
        /* A quarter round, the tangent is -x; y = t cross z. */
        const double expected[3] = {0, 3 + q[1], q[0]};
        CHECK_NEAR(distance(p, expected), 0, 1e-9);
    }
    batten_surface_unref(truth);
    batten_surface_unref(surface);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(sections[k]);
    batten_curve_unref(spine);
}

/* Straight sections of half-lengths 1, 3 and 2: 1 + 7 v - 6 v^2 between. */
TEST(sections_without_places_stand_evenly_along_the_spine)
{
    static const double halves[3] = {1, 3, 2}, spine_ends[2][3] = {{0, 0, 0}, {0, 0, 8}};
    batten_curve *sections[3] = {NULL}, *spine = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *surface = NULL;
    for (int k = 0; k < 3; k++)
        CHECK_OK(batten_curve_line(2, (double[]){-halves[k], 0}, (double[]){halves[k], 0},
                                   &sections[k]));
    CHECK_OK(batten_curve_line(3, spine_ends[0], spine_ends[1], &spine));
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){3, (curves)sections}, spine,
                                             &options, &surface));
    const batten_interval v = batten_surface_domain(surface, BATTEN_V);
    for (int i = 0; i <= 8; i++) {
        double p[3];
        const double s = i / 8.0;
        CHECK_OK(batten_surface_evaluate(surface, 1, v.a + s * (v.b - v.a), 0, p));
        CHECK_NEAR(hypot(p[0], p[1]), 1 + 7 * s - 6 * s * s, 1e-12);
        CHECK_NEAR(p[2], 8 * s, 1e-12);
    }
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    for (int k = 0; k < 3; k++)
        batten_curve_unref(sections[k]);
}

/* ---- screws ---- */

TEST(a_helical_surface_is_its_formula_within_the_tolerance)
{
    const double a[3] = {1, 0, 0}, b[3] = {3, 0, 0.5};
    batten_curve *line = NULL;
    batten_surface *surface = NULL, *none = NULL;
    batten_surface_sweep_report report;
    const batten_vec3 origin = {0, 0, 0}, axis = {0, 0, 2};
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_EACH_ALLOCATION(batten_surface_helical(
        line, (batten_screw){origin, axis, 1.5, 5 * PI}, 1e-6, NULL, &report, &surface));
    CHECK_INT(batten_surface_degree(surface, BATTEN_V), 3);
    CHECK(report.clearance == 1 && report.error > 0 && report.error <= 1e-6);
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= 80; j++) {
            const double r = 1 + 2 * i / 8.0, v = 5 * PI * j / 80;
            const double expected[3] = {r * cos(v), r * sin(v),
                                        0.5 * i / 8.0 + 1.5 * v / 2 / PI};
            double p[3];
            CHECK_OK(batten_surface_evaluate(surface, i / 8.0, v, 0, p));
            CHECK_NEAR(distance(p, expected), 0, 1e-6);
        }
    CHECK(report.error <= 1e-6 && report.section_count < 200);
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, axis, 1, 0}, 1e-6, NULL,
                                        NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, origin, 1, 1}, 1e-6, NULL,
                                        NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, axis, NAN, 1}, 1e-6, NULL,
                                        NULL, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, axis, 1, 1e5}, 1e-6, NULL,
                                        NULL, &none),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, axis, 1, 6000}, 1e-6, NULL,
                                        NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the limit is 2000");
    CHECK(none == NULL);
    batten_surface_unref(surface);
    batten_curve_unref(line);
}

/* ---- bad input ---- */

TEST(sweeps_refuse_what_they_cannot_do_with_the_place)
{
    static const double falling[3] = {1, 0.2, -0.5}, points[6] = {0, 0, 0, 1e-9, 0, 0},
                        still[12] = {0, 0, 0, 0, 0, 0, 1, 1, 0, 2, 1, 1},
                        knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *section = circle(0.3), *spine = through(5, bend_points), *bad = NULL;
    batten_surface *none = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_curve *scale = law(3, falling);
    options.scale = scale;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("it must stay above 0");
    options = batten_surface_sweep_defaults();
    CHECK_OK(batten_curve_line(3, points, points + 3, &bad));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, bad, &options,
                                      NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("the spine is 1e-09 long, no more than the tolerance of 1e-06");
    batten_curve_unref(bad);
    CHECK_OK(batten_curve_create((batten_points){3, 4, still}, 3, NULL, knots, &bad));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, bad, &options,
                                      NULL, NULL, &none),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("no tangent at 0");
    const batten_vec3 up = {1, 0, 0};
    options.up = &up;
    batten_curve *line = NULL;
    CHECK_OK(batten_curve_line(3, (double[3]){0, 0, 0}, (double[3]){3, 0, 0}, &line));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, line, &options,
                                      NULL, NULL, &none),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("runs along its upward direction");
    options = batten_surface_sweep_defaults();
    options.frames = BATTEN_FRAME_FRENET;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, line, &options,
                                      NULL, NULL, &none),
                 BATTEN_SINGULAR_HERE);
    options.frames = BATTEN_FRAME_CLOSING;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, line, &options,
                                      NULL, NULL, &none),
                 BATTEN_NOT_COMPATIBLE);
    options = batten_surface_sweep_defaults();
    options.tolerance = 1e-16;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    options.tolerance = 0;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){0, (curves)&section}, spine, NULL,
                                      NULL, NULL, &none),
                 BATTEN_TOO_FEW_POINTS);
    CHECK(none == NULL);
    batten_curve_unref(line);
    batten_curve_unref(bad);
    batten_curve_unref(scale);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(a_scale_that_touches_zero_is_refused_wherever_it_does)
{
    batten_curve *section = circle(0.3), *spine = through(5, bend_points), *scale = NULL;
    batten_surface *none = NULL;
    for (int i = 1; i < 20; i++) {
        /* (u - c)^2 */
        const double c = i / 20.0 - 0.0137, knots[6] = {0, 0, 0, 1, 1, 1};
        const double points[3] = {c * c, c * c - c, (1 - c) * (1 - c)};
        char place[60];
        CHECK_OK(batten_curve_create((batten_points){1, 3, points}, 2, NULL, knots, &scale));
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        options.scale = scale;
        CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine,
                                          &options, NULL, NULL, &none),
                     BATTEN_BAD_ARGUMENT);
        snprintf(place, sizeof place, "the scale is 0 at %g of the spine", c);
        CHECK_MESSAGE(place);
        batten_curve_unref(scale);
    }
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(N6_a_sweep_within_less_than_rounding_is_refused)
{
    const double a[3] = {1, 0, 0}, b[3] = {3, 0, 0.5};
    const batten_vec3 origin = {0, 0, 0}, axis = {0, 0, 1};
    batten_curve *line = NULL, *section = circle(0.3), *spine = through(5, bend_points);
    batten_surface *none = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &line));
    CHECK_STATUS(batten_surface_helical(line, (batten_screw){origin, axis, 1e300, 9}, 1e-3,
                                        NULL, NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the sweep cannot be within 0.001: its coordinates");
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.tolerance = 1e-16;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the sweep cannot be within 1e-16");
    options.tolerance = 3e-14;
    options.degree = 1;
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("sections, and would need about");
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(section);
    batten_curve_unref(line);
}

TEST(S5_a_sweep_that_would_be_too_large_is_refused_before_the_work)
{
    enum { POINTS = 20000 };
    double *points = test_array(3 * POINTS, sizeof *points);
    for (int i = 0; i < POINTS; i++) {
        points[3 * i] = cos(2 * PI * i / POINTS);
        points[3 * i + 1] = sin(2 * PI * i / POINTS);
    }
    batten_curve *section = NULL, *spine = circle(3);
    batten_surface *none = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.tolerance = 1e-7;
    CHECK_OK(batten_curve_polyline((batten_points){3, POINTS, points}, &section));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_TOO_LARGE);
    CHECK_MESSAGE("sections of 20000 control points make a surface of");
    CHECK_STATUS(batten_surface_translational(section, section, &none), BATTEN_TOO_LARGE);
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(N2_a_sweep_of_huge_or_tiny_size_is_the_scaled_one)
{
    static const double sizes[] = {1e80, 1e-80};
    batten_curve *section = circle(0.3), *spine = through(5, bend_points);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *plain = NULL;
    options.tolerance = 1e-4;
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, NULL, &plain));
    for (int k = 0; k < COUNT(sizes); k++) {
        const batten_affine map = batten_affine_scaling(sizes[k], sizes[k], sizes[k]);
        batten_curve *big = NULL, *way = NULL;
        batten_surface *surface = NULL;
        CHECK_OK(batten_curve_transform(section, &map, &big));
        CHECK_OK(batten_curve_transform(spine, &map, &way));
        options.tolerance = 1e-4 * sizes[k];
        CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&big}, way, &options, NULL,
                                      NULL, &surface));
        const batten_interval v = batten_curve_domain(spine);
        for (int i = 0; i <= 10; i++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(plain, 0.3, v.a + (v.b - v.a) * i / 10, 0, p));
            CHECK_OK(batten_surface_evaluate(surface, 0.3, v.a + (v.b - v.a) * i / 10, 0, q));
            for (int c = 0; c < 3; c++)
                CHECK_NEAR(q[c] / sizes[k], p[c], 1e-9);
        }
        batten_surface_unref(surface);
        batten_curve_unref(way);
        batten_curve_unref(big);
    }
    batten_surface_unref(plain);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(where_a_pipe_is_too_thick_is_said)
{
    /* The least radius of curvature of this ellipse is b b / a = 0.5, at both
     * ends of its length. */
    batten_curve *flat = NULL, *spine = NULL;
    batten_surfaces made = {0, NULL};
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface_sweep_report report;
    options.tolerance = 1e-4;
    CHECK_OK(batten_curve_ellipse(2, 1, -PI / 2, PI, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &spine));
    CHECK_STATUS(batten_surfaces_pipe(0.6, spine, &options, NULL, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("run into each other from 0.4375 to 0.5625 of the spine");
    CHECK_MESSAGE("is up to 1.2 there");
    CHECK_OK(batten_surfaces_pipe(0.45, spine, &options, NULL, &report, &made));
    CHECK_NEAR(report.clearance, 0.1, 1e-9);
    CHECK_NEAR(report.clearance_at, 0.5, 0);
    batten_surfaces_release(&made);
    batten_curve_unref(spine);
    batten_curve_unref(flat);
}

/* The whole ellipse bends so twice, at a quarter and at three quarters of its parameter: the message names
 * the first stretch, the report the least clearance. A radius of 0.6 is too much where 1 + 3 sin^2 is at most 1.2^(2/3),
 * within 0.2087 radians: u from 0.2134 to 0.2866, and places are 1/128 apart. */
TEST(of_several_folds_the_first_is_named_and_they_can_be_allowed)
{
    batten_curve *flat = NULL, *spine = NULL;
    batten_surfaces made = {0, NULL};
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface_sweep_report report;
    options.tolerance = 1e-3;
    CHECK_OK(batten_curve_ellipse(2, 1, -PI / 2, 2 * PI, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &spine));
    CHECK_STATUS(batten_surfaces_pipe(0.6, spine, &options, NULL, NULL, &made),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("run into each other from 0.21875 to 0.28125 of the spine");
    options.allow_folds = true;
    CHECK_OK(batten_surfaces_pipe(0.6, spine, &options, NULL, &report, &made));
    CHECK_NEAR(report.clearance, -0.2, 1e-9);
    CHECK_NEAR(report.clearance_at, 0.25, 0);
    batten_surfaces_release(&made);
    batten_curve_unref(spine);
    batten_curve_unref(flat);
}

/* A parabola that reaches 1 or -1 to the side in the middle of its only span. */
static batten_curve *bulge(double reach)
{
    const double points[6] = {0, -1, 2 * reach, 0, 0, 1}, knots[6] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

TEST(the_clearance_is_one_less_the_curvature_times_the_farthest_reach_inwards)
{
    const batten_vec3 up = {0, 0, 1};
    batten_curve *spine = circle(4);
    double found[2];
    for (int k = 0; k < 2; k++) {
        batten_curve *section = bulge(k ? -1 : 1);
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        batten_surface_sweep_report report;
        batten_surface *surface = NULL;
        options.up = &up;
        options.tolerance = 1e-4;
        CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, &report, &surface));
        found[k] = report.clearance;
        CHECK_NEAR(report.length, 8 * PI, 1e-9);
        batten_surface_unref(surface);
        batten_curve_unref(section);
    }
    CHECK_NEAR(fmin(found[0], found[1]), 0.75, 1e-12);
    CHECK_NEAR(fmax(found[0], found[1]), 1, 1e-12);
    batten_curve_unref(spine);
}

TEST(the_volume_of_a_pipe_around_a_circle_is_that_of_the_torus)
{
    batten_curve *spine = circle(2);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surfaces made = {0, NULL};
    options.tolerance = 1e-7;
    CHECK_OK(batten_surfaces_pipe(0.5, spine, &options, NULL, NULL, &made));
    double volume[2] = {0, 0};
    for (int k = 0; k < 2; k++)
        for (int n = 32 << k, i = 0; i < n * n; i++) {
            double s[9];
            CHECK_OK(batten_surface_evaluate(made.at[0], (i / n + 0.5) / n, (i % n + 0.5) / n,
                                             1, s));
            const double x = s[4] * s[8] - s[5] * s[7], y = s[5] * s[6] - s[3] * s[8],
                         z = s[3] * s[7] - s[4] * s[6];
            volume[k] += (s[0] * x + s[1] * y + s[2] * z) / 3 / n / n;
        }
    CHECK_NEAR(fabs(4 * volume[1] - volume[0]) / 3, 2 * PI * PI * 2 * 0.25, 1e-4);
    batten_surfaces_release(&made);
    batten_curve_unref(spine);
}

TEST(every_degree_along_the_spine_keeps_the_tolerance_with_fewer_sections_the_higher)
{
    batten_curve *section = circle(0.3), *spine = through(5, bend_points);
    batten_surface *truth = NULL;
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, spine,
                                             NULL, &truth));
    int before = 10000;
    for (int degree = 2; degree <= 5; degree++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        batten_surface_sweep_report report;
        batten_surface *surface = NULL;
        options.tolerance = 1e-5;
        options.degree = degree;
        CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, &report, &surface));
        CHECK(deviation(surface, truth, 30) <= 1e-5);
        CHECK(report.section_count < before);
        before = report.section_count;
        batten_surface_unref(surface);
    }
    batten_surface *nurbs = NULL;
    double error = 1;
    CHECK_OK(batten_surface_to_nurbs(truth, 1e-4, &error, &nurbs));
    CHECK(error <= 1e-4);
    CHECK(deviation(nurbs, truth, 30) <= 1e-4);
    batten_surface_unref(nurbs);
    batten_surface_unref(truth);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(sections_stand_across_the_spine_and_look_where_they_are_told)
{
    batten_curve *section = NULL, *spine = through(5, bend_points), *guide = NULL;
    const batten_vec3 up = {0, 0, 1};
    const double a[3] = {0, 0, 0}, b[3] = {0, 0.2, 0};
    CHECK_OK(batten_curve_line(3, a, b, &section)); /* along y */
    CHECK_OK(batten_curve_line(3, (double[3]){0, 0, 9}, (double[3]){7, 0, 9}, &guide));
    for (int kind = 0; kind < 3; kind++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        options.up = kind == 0 ? &up : NULL;
        options.guide = kind == 1 ? guide : NULL;
        if (kind == 2)
            options.frames = BATTEN_FRAME_CLOSING;
        batten_surface *truth = NULL;
        if (kind == 2) {
            CHECK_STATUS(batten_surface_sweep_procedural(
                             (batten_curve_row){1, (curves)&section}, spine, &options, &truth),
                         BATTEN_NOT_COMPATIBLE);
            continue;
        }
        CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, spine,
                                                 &options, &truth));
        const batten_interval v = batten_curve_domain(spine);
        for (int j = 0; j <= 16; j++) {
            const double at = v.a + (v.b - v.a) * j / 16;
            double low[3], high[3], c[6], target[3] = {0, 0, 1};
            CHECK_OK(batten_curve_evaluate(spine, at, 1, c));
            CHECK_OK(batten_surface_evaluate(truth, 0, at, 0, low));
            CHECK_OK(batten_surface_evaluate(truth, 1, at, 0, high));
            CHECK_NEAR(distance(low, c), 0, 1e-14);
            double along = 0, side = 0;
            if (kind == 1)
                for (int k = 0; k < 3; k++)
                    target[k] = (k == 0 ? 7.0 * j / 16 : k == 2 ? 9 : 0) - c[k];
            /* Square to the tangent, and in the plane of tangent and target. */
            const double y[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
            for (int k = 0; k < 3; k++) {
                const int p = (k + 1) % 3, q = (k + 2) % 3;
                along += y[k] * c[3 + k];
                side += y[k] * (c[3 + p] * target[q] - c[3 + q] * target[p]);
            }
            CHECK_NEAR(along, 0, 1e-12);
            CHECK_NEAR(side, 0, 1e-10);
            CHECK_NEAR(distance(low, high), 0.2, 1e-14);
        }
        batten_surface_unref(truth);
    }
    batten_curve_unref(guide);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(mitres_between_bent_parts_meet_in_the_plane_halfway)
{
    /* Two arcs that meet at a corner of 60 degrees. */
    batten_curve *arcs[2] = {NULL, NULL}, *spine = NULL, *section = circle(0.2);
    const batten_frame world = batten_frame_world();
    CHECK_OK(batten_curve_arc_in(&world, 3, 0, PI / 3, &arcs[0]));
    const double x = 3 * cos(PI / 3), y = 3 * sin(PI / 3);
    const batten_frame next = {{x - 3, y, 0}, {1, 0, 0}, {0, 0, 1}};
    CHECK_OK(batten_curve_arc_in(&next, 3, 0, PI / 4, &arcs[1]));
    CHECK_OK(batten_curve_join(arcs[0], arcs[1], 1e-9, &spine));
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *surface = NULL;
    options.corners = BATTEN_CORNER_MITRE;
    options.tolerance = 1e-5;
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, NULL, &surface));
    const batten_interval v = batten_curve_domain(spine);
    const int count = batten_surface_spans(surface, BATTEN_V, NULL);
    double *knots = test_array((size_t)count, sizeof *knots), c[3], corner = v.a;
    batten_surface_spans(surface, BATTEN_V, knots);
    for (int i = 0; i < count; i++) {
        CHECK_OK(batten_curve_evaluate(spine, knots[i], 0, c));
        if (hypot(c[0] - x, c[1] - y) < 1e-9)
            corner = knots[i];
    }
    CHECK(corner > v.a);
    /* Tangents there are at 150 and 90 degrees, the plane's normal at 120. */
    for (int i = 0; i < 8; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 8.0, corner, 0, p));
        CHECK_NEAR((p[0] - x) * cos(2 * PI / 3) + (p[1] - y) * sin(2 * PI / 3), 0, 1e-9);
    }
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    batten_curve_unref(section);
    batten_curve_unref(arcs[0]);
    batten_curve_unref(arcs[1]);
}

TEST(a_section_that_is_a_point_is_refused)
{
    const double points[6] = {1, 2, 0, 1, 2, 0}, knots[4] = {0, 0, 1, 1};
    batten_curve *point = NULL, *spine = circle(2);
    batten_surface *none = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &point));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&point}, spine, NULL, NULL,
                                      NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("the section is a point, (1, 2, 0)");
    CHECK_STATUS(batten_surface_helical(
                     point,
                     (batten_screw){(batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1}, 1, 1}, 1e-6,
                     NULL, NULL, &none),
                 BATTEN_COINCIDENT);
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(point);
}

TEST(frenet_frames_look_to_the_centre_of_a_circle)
{
    const double a[3] = {0, 0, 0}, b[3] = {0.5, 0, 0};
    batten_curve *section = NULL, *spine = circle(2);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *truth = NULL;
    options.frames = BATTEN_FRAME_FRENET;
    CHECK_OK(batten_curve_line(3, a, b, &section));
    CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){1, (curves)&section}, spine,
                                             &options, &truth));
    for (int j = 0; j <= 16; j++) {
        double p[3], c[3];
        CHECK_OK(batten_curve_evaluate(spine, j / 16.0, 0, c));
        CHECK_OK(batten_surface_evaluate(truth, 1, j / 16.0, 0, p));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(p[k], 0.75 * c[k], 1e-14);
    }
    batten_surface_unref(truth);
    batten_curve_unref(spine);
    batten_curve_unref(section);
    /* At an inflection they turn over. */
    const double wave[12] = {0, 0, 0, 1, 1, 0, 2, -1, 0, 3, 0, 0};
    batten_surface *none = NULL;
    section = circle(0.01);
    spine = through(4, wave);
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_SINGULAR_HERE);
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(G6_a_skew_loop_of_straight_sides_closes_with_mitres_and_closing_frames)
{
    static const double corners[15] = {0, 0, 0, 4, 0, 1, 4, 3, -1, 0, 3, 2, 0, 0, 0};
    batten_curve *section = NULL, *spine = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface_sweep_report report;
    batten_surface *surface = NULL;
    options.corners = BATTEN_CORNER_MITRE;
    options.frames = BATTEN_FRAME_CLOSING;
    options.tolerance = 1e-4;
    CHECK_OK(batten_curve_ellipse(0.3, 0.1, 0, 2 * PI, &section));
    CHECK_OK(batten_curve_polyline((batten_points){3, 5, corners}, &spine));
    CHECK_OK(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                  NULL, &report, &surface));
    CHECK(fabs(report.turn) > 0.1);
    CHECK(report.error <= 1e-4);
    CHECK(batten_surface_is_closed(surface, BATTEN_V, 0));
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(a_spine_that_turns_back_has_no_mitre)
{
    static const double points[9] = {0, 0, 0, 3, 0, 0, 1, 0, 0};
    batten_curve *section = circle(0.2), *spine = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *none = NULL;
    options.corners = BATTEN_CORNER_MITRE;
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, points}, &spine));
    CHECK_STATUS(batten_surface_sweep((batten_curve_row){1, (curves)&section}, spine, &options,
                                      NULL, NULL, &none),
                 BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the spine turns back at 3");
    CHECK(none == NULL);
    batten_curve_unref(spine);
    batten_curve_unref(section);
}

TEST(K7_sections_of_different_knots_are_blended_exactly_where_they_stand)
{
    static const double arch[12] = {-1, 0, 0, -0.5, 0.7, 0, 0.4, 0.6, 0, 1, 0, 0},
                        hump[15] = {-1, 0.2, 0,   -0.7, 0.8, 0,   0, 0.3,
                                    0,  0.6, 0.9, 0,    1,   0.1, 0};
    batten_curve *sections[2] = {through(4, arch), through(5, hump)}, *spine = circle(5);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surface *surface = NULL;
    options.x = (batten_vec3){1, 0, 0};
    options.tolerance = 1e-5;
    CHECK_OK(batten_surface_sweep((batten_curve_row){2, (curves)sections}, spine, &options,
                                  NULL, NULL, &surface));
    for (int end = 0; end < 2; end++) {
        const batten_interval u = batten_curve_domain(sections[end]);
        for (int i = 0; i <= 16; i++) {
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(sections[end], fmin(u.b, u.a + (u.b - u.a) * i / 16),
                                           0, q));
            CHECK_OK(batten_surface_evaluate(surface, i / 16.0, end, 0, p));
            /* The tangent is y: Y = y cross x. */
            const double expected[3] = {5 + q[0], 0, -q[1]};
            CHECK_NEAR(distance(p, expected), 0, 1e-12);
        }
    }
    batten_surface_unref(surface);
    batten_curve_unref(spine);
    batten_curve_unref(sections[0]);
    batten_curve_unref(sections[1]);
}

/* A periodic curve of the xy-plane with some lobes. */
static batten_curve *flower(double radius)
{
    double points[3 * 10] = {0};
    for (int i = 0; i < 10; i++) {
        const double r = radius * (i % 2 ? 1 : 0.7);
        points[3 * i] = r * cos(2 * PI * i / 10);
        points[3 * i + 1] = r * sin(2 * PI * i / 10);
    }
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.closed = true;
    CHECK_OK(batten_curve_interpolate((batten_points){3, 10, points}, &options, NULL, &curve));
    return curve;
}

TEST(K5_periodic_sections_and_shifted_domains_are_swept_as_they_are)
{
    batten_curve *sections[2] = {flower(0.5), flower(0.3)}, *spine = through(5, bend_points);
    batten_curve *shifted = NULL;
    CHECK_OK(batten_curve_set_domain(spine, -7, -2, &shifted));
    for (int count = 1; count <= 2; count++) {
        batten_surface_sweep_options options = batten_surface_sweep_defaults();
        batten_surface *surface = NULL, *truth = NULL;
        options.tolerance = 1e-4;
        CHECK_OK(batten_surface_sweep((batten_curve_row){count, (curves)sections}, shifted,
                                      &options, NULL, NULL, &surface));
        CHECK_OK(batten_surface_sweep_procedural((batten_curve_row){count, (curves)sections},
                                                 shifted, &options, &truth));
        CHECK(batten_surface_is_periodic(surface, BATTEN_U));
        CHECK_NEAR(batten_surface_domain(surface, BATTEN_V).a, -7, 0);
        CHECK_NEAR(batten_surface_domain(surface, BATTEN_V).b, -2, 0);
        CHECK(deviation(surface, truth, 30) <= 1e-4);
        batten_surface_unref(truth);
        batten_surface_unref(surface);
    }
    batten_curve_unref(shifted);
    batten_curve_unref(spine);
    batten_curve_unref(sections[0]);
    batten_curve_unref(sections[1]);
}

TEST(G10_a_reversed_spine_makes_the_same_pipe)
{
    batten_curve *spine = through(5, bend_points), *back = NULL;
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    batten_surfaces made = {0, NULL};
    options.tolerance = 1e-6;
    CHECK_OK(batten_curve_reverse(spine, &back));
    CHECK_OK(batten_surfaces_pipe(0.3, back, &options, NULL, NULL, &made));
    const batten_interval v = batten_curve_domain(spine);
    for (int j = 0; j <= 32; j++) {
        const double at = v.a + (v.b - v.a) * j / 32;
        double p[3], c[6], along = 0;
        CHECK_OK(batten_curve_evaluate(spine, at, 1, c));
        CHECK_OK(batten_surface_evaluate(made.at[0], j / 32.0, -at, 0, p));
        CHECK_NEAR(distance(p, c), 0.3, 1e-6);
        for (int k = 0; k < 3; k++)
            along += (p[k] - c[k]) * c[3 + k];
        CHECK_NEAR(along, 0, 1e-5);
    }
    batten_surfaces_release(&made);
    batten_curve_unref(back);
    batten_curve_unref(spine);
}
