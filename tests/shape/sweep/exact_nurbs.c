#include "support/faults.h"
#include "support/test.h"

#include <batten/measure.h>
#include <batten/standard.h>
#include <batten/sweep.h>

static batten_curve *arc(double radius, double angle)
{
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_arc(radius, angle, &curve));
    return curve;
}

/* A conic of space that touches no plane of the axes. */
static batten_curve *bow(void)
{
    const double a[3] = {0.3, 0.2, -0.1}, b[3] = {1.1, 2, 0.7}, c[3] = {2.4, 1.7, 1.9};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_conic(3, a, b, c, 2.5, &curve));
    return curve;
}

static void point_of(const batten_curve *curve, double u, double *out)
{
    out[1] = out[2] = 0;
    CHECK_OK(batten_curve_evaluate(curve, u, 0, out));
}

TEST(a_translational_surface_is_the_sum_of_its_curves_also_when_both_are_rational)
{
    batten_curve *curve = arc(2, 1.9), *path = bow();
    batten_surface *surface = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_translational(curve, path, &surface));
    double start[3];
    point_of(path, 0, start);
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double c[3], p[3], s[30];
            point_of(curve, i / 20.0, c);
            point_of(path, j / 20.0, p);
            CHECK_OK(batten_surface_evaluate(surface, i / 20.0, j / 20.0, 2, s));
            for (int k = 0; k < 3; k++) {
                CHECK_NEAR(s[k], c[k] + p[k] - start[k], 4e-15);
                CHECK_NEAR(s[3 * BATTEN_SURFACE_DERIVATIVE(1, 1) + k], 0, 1e-13);
            }
        }
    batten_surface_unref(surface);
    batten_curve_unref(path);
    batten_curve_unref(curve);
}

TEST(a_swing_along_the_unit_circle_is_the_surface_of_revolution)
{
    const double a[3] = {0.5, 0, -1}, b[3] = {2, 0, 0.2}, c[3] = {1, 0, 2};
    batten_curve *profile = NULL, *circle = arc(1, 2 * acos(-1));
    batten_surface *swung = NULL, *turned = NULL;
    batten_surface_swung_report report;
    CHECK_OK(batten_curve_conic(3, a, b, c, 0.8, &profile));
    CHECK_EACH_ALLOCATION(batten_surface_swung(profile, circle, 1, &report, &swung));
    CHECK_OK(batten_surface_revolved(profile, (batten_vec3){0, 0, 0}, (batten_vec3){0, 0, 1},
                                     2 * acos(-1), &turned));
    for (int i = 0; i <= 16; i++)
        for (int j = 0; j <= 32; j++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(swung, i / 16.0, j / 32.0, 0, p));
            CHECK_OK(batten_surface_evaluate(turned, j / 32.0, i / 16.0, 0, q));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(p[k], q[k], 1e-14);
        }
    CHECK_NEAR(report.least_x, 0.5, 0);
    CHECK_NEAR(report.least_radius, 1, 1e-15);
    batten_surface_unref(turned);
    batten_surface_unref(swung);
    batten_curve_unref(circle);
    batten_curve_unref(profile);
}

TEST(a_swing_follows_its_formula_for_rational_curves_of_the_plane)
{
    const double a[2] = {1, 0}, b[2] = {2, 1}, c[2] = {0.5, 2};
    batten_curve *profile = NULL, *trajectory = arc(3, 2);
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_conic(2, a, b, c, 3, &profile));
    CHECK_OK(batten_surface_swung(profile, trajectory, 0.25, NULL, &surface));
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3], t[3], s[3];
            point_of(profile, i / 20.0, p);
            point_of(trajectory, j / 20.0, t);
            CHECK_OK(batten_surface_evaluate(surface, i / 20.0, j / 20.0, 0, s));
            CHECK_NEAR(s[0], 0.25 * p[0] * t[0], 3e-15);
            CHECK_NEAR(s[1], 0.25 * p[0] * t[1], 3e-15);
            CHECK_NEAR(s[2], p[1], 3e-15);
        }
    batten_surface_unref(surface);
    batten_curve_unref(trajectory);
    batten_curve_unref(profile);
}

TEST(a_tabulated_cylinder_has_its_lengths_as_parameters)
{
    batten_curve *curve = bow();
    batten_surface *surface = NULL;
    CHECK_EACH_ALLOCATION(
        batten_surface_tabulated(curve, (batten_vec3){0, 3, 4}, -2, 5, &surface));
    CHECK_NEAR(batten_surface_domain(surface, BATTEN_V).a, -2, 0);
    CHECK_NEAR(batten_surface_domain(surface, BATTEN_V).b, 5, 0);
    for (int i = 0; i <= 8; i++) {
        double c[3], s[9];
        point_of(curve, i / 8.0, c);
        CHECK_OK(batten_surface_evaluate(surface, i / 8.0, 1.5, 1, s));
        CHECK_NEAR(s[1], c[1] + 0.6 * 1.5, 4e-15);
        CHECK_NEAR(s[2], c[2] + 0.8 * 1.5, 4e-15);
        CHECK_NEAR(s[7], 0.6, 4e-15);
    }
    batten_surface_unref(surface);
    batten_curve_unref(curve);
}

TEST(G5_a_cone_to_an_apex_has_a_pole_with_a_normal)
{
    batten_curve *circle = arc(1, 2 * acos(-1)), *point = NULL;
    batten_surface *surface = NULL;
    const batten_vec3 apex = {0, 0, 2};
    CHECK_EACH_ALLOCATION(batten_surface_conical(circle, apex, &surface));
    for (int i = 0; i <= 8; i++) {
        double s[3];
        batten_vec3 normal;
        CHECK_OK(batten_surface_evaluate(surface, i / 8.0, 1, 0, s));
        CHECK_NEAR(hypot(s[0], s[1]), 0, 0);
        CHECK_NEAR(s[2], 2, 0);
        CHECK_OK(batten_surface_normal(surface, i / 8.0, 0.5, NULL, &normal));
        CHECK_NEAR(normal.z, 1 / sqrt(5), 1e-14);
    }
    const double same[6] = {0, 0, 2, 0, 0, 2}, knots[4] = {0, 0, 1, 1};
    CHECK_OK(batten_curve_create((batten_points){3, 2, same}, 1, NULL, knots, &point));
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_conical(point, apex, &none), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_surface_translational(circle, point, &none), BATTEN_COINCIDENT);
    CHECK_MESSAGE("the path is a point, (0, 0, 2)");
    CHECK(none == NULL);
    batten_curve_unref(point);
    batten_surface_unref(surface);
    batten_curve_unref(circle);
}

TEST(a_ruled_surface_by_length_joins_equal_shares_of_length)
{
    /* A polyline that is run at uneven speed, and a straight line. */
    const double low[9] = {0, 0, 0, 1, 0, 0, 4, 0, 0}, high[6] = {0, 1, 0, 4, 1, 2};
    const double knots[5] = {0, 0, 0.7, 1, 1}, line[4] = {0, 0, 1, 1};
    batten_curve *first = NULL, *second = NULL;
    batten_surface *surface = NULL;
    double error = 1;
    CHECK_OK(batten_curve_create((batten_points){3, 3, low}, 1, NULL, knots, &first));
    CHECK_OK(batten_curve_create((batten_points){3, 2, high}, 1, NULL, line, &second));
    CHECK_EACH_ALLOCATION(
        batten_surface_ruled_by_length(first, second, 1e-9, &error, &surface));
    CHECK_NEAR(error, 0, 0);
    for (int i = 0; i <= 16; i++) {
        double s[9];
        CHECK_OK(batten_surface_evaluate(surface, i / 16.0, 0, 1, s));
        CHECK_NEAR(s[0], 4 * i / 16.0, 2e-15);
        CHECK_NEAR(s[6], 0, 2e-15); /* so the lines are square to the first curve */
    }
    batten_surface_unref(surface);
    batten_curve *bent = bow(), *round = arc(1, 2);
    CHECK_OK(batten_surface_ruled_by_length(bent, round, 1e-7, &error, &surface));
    CHECK(error > 0 && error <= 1e-7);
    double length, part;
    batten_curve *rim = NULL;
    CHECK_OK(batten_surface_isocurve(surface, BATTEN_V, 0, &rim));
    CHECK_OK(batten_curve_length(rim, 1e-9, NULL, &length));
    CHECK_OK(batten_curve_length_between(rim, 0, 0.3, 1e-9, NULL, &part));
    CHECK_NEAR(part / length, 0.3, 1e-6);
    batten_curve_unref(rim);
    batten_surface_unref(surface);
    batten_curve_unref(round);
    batten_curve_unref(bent);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(exact_sweeps_without_area_are_refused)
{
    static const double tiny = 1e-80, huge = 1e80, sizes[3] = {1, tiny, huge};
    for (int i = 0; i < 3; i++) {
        const double h = sizes[i];
        const double a[3] = {0, 0, h}, b[3] = {0, 0, 3 * h}, out[3] = {2 * h, 0, h};
        const batten_vec3 up = {0, 0, 1}, aside = {1, 0, 1}, tip = {0, 0, 7 * h};
        batten_curve *line = NULL, *level = NULL;
        batten_surface *made = NULL;
        CHECK_OK(batten_curve_line(3, a, b, &line));
        CHECK_OK(batten_curve_line(3, a, out, &level));
        CHECK_STATUS(batten_surface_translational(line, line, &made), BATTEN_COINCIDENT);
        CHECK_MESSAGE("no area: the curve and the path lie along one line");
        CHECK_STATUS(batten_surface_tabulated(line, up, 0, h, &made), BATTEN_COINCIDENT);
        CHECK_MESSAGE("no area: the curve lies along its lines");
        CHECK_STATUS(batten_surface_conical(line, tip, &made), BATTEN_COINCIDENT);
        CHECK_MESSAGE("no area: the curve lies on a line through the apex");
        CHECK(made == NULL);
        CHECK_OK(batten_surface_translational(line, level, &made));
        batten_surface_unref(made);
        CHECK_OK(batten_surface_tabulated(line, aside, 0, h, &made));
        batten_surface_unref(made);
        CHECK_OK(batten_surface_conical(level, tip, &made));
        batten_surface_unref(made);
        batten_curve_unref(level);
        batten_curve_unref(line);
    }
}

TEST(a_swing_without_area_is_refused)
{
    const double a[3] = {1e-17, 0, 0}, b[3] = {0, 0, 3}, c[3] = {2, 0, 0}, d[3] = {4, 0, 0};
    batten_curve *axis = NULL, *flat = NULL, *circle = arc(1, 2);
    batten_surface *made = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &axis));
    CHECK_OK(batten_curve_line(3, c, d, &flat));
    CHECK_STATUS(batten_surface_swung(axis, circle, 1, NULL, &made), BATTEN_COINCIDENT);
    CHECK_STATUS(batten_surface_swung(flat, flat, 1, NULL, &made), BATTEN_COINCIDENT);
    CHECK_MESSAGE("no area: the profile lies on the axis, or swings within one line");
    CHECK_OK(batten_surface_swung(flat, circle, 1, NULL, &made));
    batten_surface_unref(made);
    batten_curve_unref(circle);
    batten_curve_unref(flat);
    batten_curve_unref(axis);
}

TEST(exact_sweeps_refuse_what_they_cannot_do)
{
    batten_curve *circle = arc(1, 2), *curve = bow();
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_swung(curve, circle, 1, NULL, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("control point 1 of the profile has y = 0.2");
    CHECK_STATUS(batten_surface_swung(circle, curve, 1, NULL, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("of the trajectory has z");
    CHECK_STATUS(batten_surface_swung(circle, circle, 0, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_swung(circle, circle, NAN, NULL, &none), BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_tabulated(curve, (batten_vec3){0, 0, 0}, 0, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_tabulated(curve, (batten_vec3){0, 0, 1}, 1, 1, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_tabulated(curve, (batten_vec3){0, NAN, 1}, 0, 1, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_conical(curve, (batten_vec3){0, HUGE_VAL, 1}, &none),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_surface_ruled_by_length(curve, circle, 0, NULL, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK(none == NULL);
    batten_curve_unref(curve);
    batten_curve_unref(circle);
}

TEST(affine_maps_of_both_curves_make_the_mapped_translational_surface)
{
    const batten_affine map = {{{1, 2, -1}, {0.5, 1, 3}, {2, -1, 0.3}}, {4, 5, 6}};
    batten_curve *flat = arc(2, 1.9), *curve = NULL, *path = bow(), *images[2] = {NULL, NULL};
    batten_surface *plain = NULL, *image = NULL, *expected = NULL;
    CHECK_OK(batten_curve_to_dimension(flat, 3, &curve));
    CHECK_OK(batten_curve_transform(curve, &map, &images[0]));
    CHECK_OK(batten_curve_transform(path, &map, &images[1]));
    CHECK_OK(batten_surface_translational(curve, path, &plain));
    CHECK_OK(batten_surface_translational(images[0], images[1], &image));
    CHECK_OK(batten_surface_transform(plain, &map, &expected));
    for (int i = 0; i <= 64; i++) {
        double p[3], q[3];
        CHECK_OK(batten_surface_evaluate(image, (i % 9) / 8.0, i / 64.0, 0, p));
        CHECK_OK(batten_surface_evaluate(expected, (i % 9) / 8.0, i / 64.0, 0, q));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(p[k], q[k], 2e-14);
    }
    batten_surface_unref(expected);
    batten_surface_unref(image);
    batten_surface_unref(plain);
    for (int k = 0; k < 2; k++)
        batten_curve_unref(images[k]);
    batten_curve_unref(path);
    batten_curve_unref(curve);
    batten_curve_unref(flat);
}

TEST(numbers_that_exact_sweeps_cannot_use_are_named)
{
    static const struct {
        batten_vec3 direction;
        double from, to;
        batten_status status;
        const char *message;
    } lines[] = {
        {{0, NAN, 1},
         0,
         1,
         BATTEN_NOT_FINITE,
         "the lines cannot go along (0, nan, 1) from 0 to 1"},
        {{0, 2, 1},
         -INFINITY,
         1,
         BATTEN_NOT_FINITE,
         "the lines cannot go along (0, 2, 1) from -inf to 1"},
        {{0, 2, 1},
         3,
         INFINITY,
         BATTEN_NOT_FINITE,
         "the lines cannot go along (0, 2, 1) from 3 to inf"},
        {{0, 0, 0}, 3, 4, BATTEN_BAD_ARGUMENT, "the direction of the lines has no length"},
        {{0, 2, 1}, 3, 3, BATTEN_BAD_ARGUMENT, "the lines begin at 3 and end at 3"},
        {{0, 2, 1}, 3, 2, BATTEN_BAD_ARGUMENT, "the lines begin at 3 and end at 2"},
    };
    static const double factors[] = {NAN, INFINITY, 0, -2};
    static const char *const messages[COUNT(factors)] = {
        "the factor is nan", "the factor is inf", "the factor is 0, not above 0",
        "the factor is -2, not above 0"};
    batten_curve *curve = bow(), *circle = arc(1, 2);
    batten_surface *none = NULL;
    for (int i = 0; i < COUNT(lines); i++) {
        CHECK_STATUS(batten_surface_tabulated(curve, lines[i].direction, lines[i].from,
                                              lines[i].to, &none),
                     lines[i].status);
        CHECK_MESSAGE(lines[i].message);
    }
    for (int i = 0; i < COUNT(factors); i++) {
        CHECK_STATUS(batten_surface_swung(circle, circle, factors[i], NULL, &none),
                     i < 2 ? BATTEN_NOT_FINITE : BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(messages[i]);
    }
    CHECK_STATUS(batten_surface_conical(curve, (batten_vec3){0, INFINITY, 1}, &none),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the apex is (0, inf, 1)");
    CHECK(!none);
    batten_curve_unref(circle);
    batten_curve_unref(curve);
}

/* A polygon of a profile that passes the axis, and a trajectory that passes the origin by 0.6. */
TEST(the_report_of_a_swing_says_how_far_its_curves_reach)
{
    const double profile_points[6] = {-0.5, 0, 2, 1, 1.25, 3},
                 path_points[4] = {1, -0.75, 1, 3};
    const double function[2] = {1, 2}, knots[4] = {0, 0, 1, 1};
    batten_curve *profile = NULL, *path = NULL, *law = NULL;
    batten_surface *surface = NULL;
    batten_surface_swung_report report = {0};
    CHECK_OK(batten_curve_polyline((batten_points){2, 3, profile_points}, &profile));
    CHECK_OK(batten_curve_line(2, path_points, path_points + 2, &path));
    CHECK_OK(batten_surface_swung(profile, path, 1, &report, &surface));
    CHECK(report.least_x == -0.5 && report.largest_x == 2);
    CHECK_NEAR(report.least_radius, 1, 1e-3); /* at (1, 0), near one of 65 places */
    CHECK(report.least_radius >= 1);
    CHECK_OK(batten_curve_create((batten_points){1, 2, function}, 1, NULL, knots, &law));
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_swung(law, path, 1, NULL, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the profile has 1 coordinate, and needs 2");
    CHECK_STATUS(batten_surface_swung(profile, law, 1, NULL, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the trajectory has 1 coordinate, and needs 2");
    CHECK(!none);
    batten_surface_unref(surface);
    batten_curve_unref(law);
    batten_curve_unref(path);
    batten_curve_unref(profile);
}
