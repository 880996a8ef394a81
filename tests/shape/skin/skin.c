#include "shape/sections.h"

#include <batten/grid.h>
#include <batten/standard.h>

#include "support/faults.h"

typedef const batten_curve *const *curves;

static double distance_on(const batten_surface *a, const batten_surface *b)
{
    const batten_interval u = batten_surface_domain(a, BATTEN_U),
                          v = batten_surface_domain(a, BATTEN_V);
    double worst = 0;
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3], q[3];
            const double x = u.a + (u.b - u.a) * i / 20, y = v.a + (v.b - v.a) * j / 20;
            CHECK_OK(batten_surface_evaluate(a, x, y, 0, p));
            CHECK_OK(batten_surface_evaluate(b, x, y, 0, q));
            worst = fmax(worst, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
        }
    return worst;
}

TEST(a_skin_through_isocurves_of_a_bicubic_surface_is_that_surface)
{
    double points[7 * 6 * 3], v[6];
    test_random random = test_random_begin("isocurves");
    for (int i = 0; i < 42; i++) {
        points[3 * i] = i / 6;
        points[3 * i + 1] = i % 6 + test_random_in(&random, -0.2, 0.2);
        points[3 * i + 2] = test_random_unit(&random);
    }
    batten_surface_interpolate_options grid = batten_surface_interpolate_defaults();
    grid.knots_at_data = true;
    batten_surface *surface = NULL, *skin = NULL;
    CHECK_OK(batten_surface_interpolate((batten_grid){3, 7, 6, points}, &grid, NULL,
                                        (batten_uv_out){NULL, v}, NULL, &surface));
    batten_curve *sections[6];
    for (int k = 0; k < 6; k++) {
        sections[k] = NULL;
        CHECK_OK(batten_surface_isocurve(surface, BATTEN_V, v[k], &sections[k]));
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = v;
    batten_surface_skin_report report;
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)sections}, &options, NULL, NULL,
                                 &report, &skin));
    CHECK(distance_on(surface, skin) < 1e-12 * 6);
    CHECK(report.error == 0 && report.knot_count == report.exact_knot_count);
    batten_surface_unref(skin);
    batten_surface_unref(surface);
    unref_all(6, sections);
}

/* A circle about the z-axis at height z. */
static batten_curve *circle_at(double radius, double z)
{
    batten_curve *flat = NULL, *space = NULL, *moved = NULL;
    const batten_affine map = batten_affine_translation(0, 0, z);
    CHECK_OK(batten_curve_circle(radius, BATTEN_CIRCLE_SQUARE_9, &flat));
    CHECK_OK(batten_curve_to_dimension(flat, 3, &space));
    CHECK_OK(batten_curve_transform(space, &map, &moved));
    batten_curve_unref(space);
    batten_curve_unref(flat);
    return moved;
}

TEST(circles_of_linear_radius_make_a_cone_exactly)
{
    for (int degree = 1; degree <= 4; degree++) {
        batten_curve *sections[6];
        double given[6];
        for (int k = 0; k < 6; k++) {
            given[k] = k * k + k;
            sections[k] = circle_at(1 + given[k] / 10, given[k]);
        }
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.degree = degree;
        options.parameters = BATTEN_GIVEN;
        options.given = given;
        batten_surface *cone = NULL;
        CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)sections}, &options, NULL,
                                     NULL, NULL, &cone));
        CHECK(batten_surface_is_rational(cone));
        for (int i = 0; i <= 200; i++) {
            double out[3];
            CHECK_OK(
                batten_surface_evaluate(cone, i / 200.0, 30.0 * (i * 7 % 200) / 200, 0, out));
            CHECK_NEAR(hypot(out[0], out[1]), 1 + out[2] / 10, 1e-13);
        }
        batten_surface_unref(cone);
        unref_all(6, sections);
    }
}

TEST(points_at_the_ends_are_poles)
{
    const double radii[] = {0, 1, 1.3, 1, 0};
    batten_curve *sections[5];
    for (int k = 0; k < 5; k++) {
        sections[k] = circle_at(radii[k] ? radii[k] : 1, k);
        if (radii[k] == 0) {
            const batten_affine flat = batten_affine_scaling(0, 0, 1);
            batten_curve *point = NULL;
            CHECK_OK(batten_curve_transform(sections[k], &flat, &point));
            batten_curve_unref(sections[k]);
            sections[k] = point;
        }
    }
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){5, (curves)sections}, NULL, NULL, NULL,
                                 NULL, &surface));
    const int across = batten_surface_point_count(surface, BATTEN_V);
    const double *P = batten_surface_points(surface);
    for (int i = 0; i < batten_surface_point_count(surface, BATTEN_U); i++) {
        CHECK(P[i * across * 3] == 0 && P[i * across * 3 + 1] == 0 &&
              P[i * across * 3 + 2] == 0);
        CHECK_NEAR(P[(i * across + across - 1) * 3 + 2], 4, 0);
    }
    batten_surface_unref(surface);
    unref_all(5, sections);
}

TEST(ends_hold_what_they_promise)
{
    test_random random = test_random_begin("ends");
    const batten_end_kind kinds[] = {
        BATTEN_END_NATURAL, BATTEN_END_CLAMPED, BATTEN_END_DIRECTION, BATTEN_END_SECOND,
        BATTEN_END_BESSEL,  BATTEN_END_FAIR,    BATTEN_END_PARABOLIC};
    batten_curve *sections[5];
    for (int k = 0; k < 5; k++)
        sections[k] = jittered(&random, 8, k, airfoil);
    for (int c = 0; c < COUNT(kinds); c++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.start = options.end = (batten_end){kinds[c], {1, 0.5, 0.25}};
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_skin((batten_curve_row){5, (curves)sections}, &options, NULL,
                                     NULL, NULL, &surface));
        for (int i = 0; i <= 10; i++) {
            double out[18];
            CHECK_OK(batten_surface_evaluate(surface, i / 10.0, i % 2, 2, out));
            const double *first = out + 3 * BATTEN_SURFACE_DERIVATIVE(0, 1);
            const double *second = out + 3 * BATTEN_SURFACE_DERIVATIVE(0, 2);
            if (c == 0)
                CHECK_NEAR(hypot(hypot(second[0], second[1]), second[2]), 0, 1e-9);
            if (c == 1)
                CHECK_NEAR(hypot(hypot(first[0] - 1, first[1] - 0.5), first[2] - 0.25), 0,
                           1e-10);
            if (c == 2)
                CHECK_NEAR(fabs(first[1] - first[0] / 2) + fabs(first[2] - first[0] / 4), 0,
                           1e-9);
            if (c == 3)
                CHECK_NEAR(hypot(hypot(second[0] - 1, second[1] - 0.5), second[2] - 0.25), 0,
                           1e-9);
        }
        batten_surface_unref(surface);
    }
    unref_all(5, sections);
}

TEST(a_periodic_skin_closes_smoothly_in_both_directions)
{
    batten_curve *rings[8];
    for (int k = 0; k < 8; k++) {
        double points[24];
        const double a = k * acos(0) / 2;
        for (int i = 0; i < 8; i++) {
            const double b = i * acos(0) / 2, r = 3 + cos(b);
            points[3 * i] = r * cos(a), points[3 * i + 1] = r * sin(a),
                       points[3 * i + 2] = sin(b);
        }
        batten_curve_interpolate_options ring = batten_curve_interpolate_defaults();
        ring.closed = true;
        rings[k] = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){3, 8, points}, &ring, NULL, &rings[k]));
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.closed = true;
    options.tolerance = 1e-3; /* their knots are common already */
    double v[8];
    batten_surface_skin_report report;
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){8, (curves)rings}, &options, NULL, v,
                                 &report, &torus));
    CHECK(batten_surface_is_periodic(torus, BATTEN_U) &&
          batten_surface_is_periodic(torus, BATTEN_V));
    CHECK(report.error == 0);
    double low[18], high[18];
    CHECK_OK(batten_surface_evaluate_side(
        torus, 0.3, 0, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT}, 2, low));
    CHECK_OK(batten_surface_evaluate_side(
        torus, 0.3, 1, (batten_sides){BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT}, 2, high));
    for (int k = 0; k < 18; k++)
        CHECK_NEAR(low[k], high[k], 1e-10);
    batten_surface_unref(torus);
    unref_all(8, rings);
}

TEST(sections_that_run_backwards_are_reversed_on_request_and_named)
{
    test_random random = test_random_begin("align");
    batten_curve *sections[4], *turned[4];
    for (int k = 0; k < 4; k++) {
        sections[k] = jittered(&random, 9, k / 4.0, hull);
        turned[k] = NULL;
        if (k == 2)
            CHECK_OK(batten_curve_reverse(sections[k], &turned[k]));
        else
            turned[k] = batten_curve_ref(sections[k]);
    }
    batten_surface_skin_options options = batten_surface_skin_defaults();
    batten_surface *right = NULL, *aligned = NULL, *crossed = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)sections}, &options, NULL, NULL,
                                 NULL, &right));
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)turned}, &options, NULL, NULL,
                                 NULL, &crossed));
    options.align = true;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, (curves)turned}, &options, NULL, NULL,
                                 NULL, &aligned));
    CHECK_MESSAGE("section 3 was reversed");
    CHECK(distance_on(right, aligned) < 1e-13 * 25);
    CHECK(distance_on(right, crossed) > 0.1);
    batten_surface_unref(crossed);
    batten_surface_unref(aligned);
    batten_surface_unref(right);
    unref_all(4, sections);
    unref_all(4, turned);
}

TEST(G10_sections_in_reverse_order_reverse_v)
{
    test_random random = test_random_begin("order");
    batten_curve *sections[6], *backward[6];
    for (int k = 0; k < 6; k++)
        backward[5 - k] = sections[k] = jittered(&random, 8, k, airfoil);
    batten_surface *a = NULL, *b = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)sections}, NULL, NULL, NULL,
                                 NULL, &a));
    CHECK_OK(batten_surface_skin((batten_curve_row){6, (curves)backward}, NULL, NULL, NULL,
                                 NULL, &b));
    for (int i = 0; i <= 20; i++)
        for (int j = 0; j <= 20; j++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(a, i / 20.0, j / 20.0, 0, p));
            CHECK_OK(batten_surface_evaluate(b, i / 20.0, (20 - j) / 20.0, 0, q));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(p[k], q[k], 1e-12);
        }
    batten_surface_unref(b);
    batten_surface_unref(a);
    unref_all(6, sections);
}

TEST(equal_sections_on_a_straight_spine_make_a_cylinder)
{
    batten_curve *circle = NULL, *spine = NULL;
    const double a[] = {1, 2, 3}, b[] = {1, 2, 13};
    CHECK_OK(batten_curve_circle(2, BATTEN_CIRCLE_SQUARE_9, &circle));
    CHECK_OK(batten_curve_line(3, a, b, &spine));
    const batten_curve *sections[] = {circle, circle, circle, circle};
    const double twist[] = {0, 0.5, 1, 1.5}, scale[] = {1, 1, 1, 1};
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.spine = spine;
    batten_surface *cylinder = NULL, *screw = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, sections}, &options, NULL, NULL, NULL,
                                 &cylinder));
    options.twist = twist;
    options.scale = scale;
    CHECK_OK(batten_surface_skin((batten_curve_row){4, sections}, &options, NULL, NULL, NULL,
                                 &screw));
    for (int i = 0; i <= 50; i++) {
        double out[3];
        CHECK_OK(batten_surface_evaluate(cylinder, i / 50.0, (i * 7 % 50) / 50.0, 0, out));
        CHECK_NEAR(hypot(out[0] - 1, out[1] - 2), 2, 1e-13);
        CHECK_NEAR(out[2], 3 + 10 * (i * 7 % 50) / 50.0, 1e-13);
    }
    double p[3];
    CHECK_OK(batten_surface_evaluate(screw, 0, 1, 0, p));
    CHECK_NEAR(atan2(p[1] - 2, p[0] - 1), 1.5, 1e-13);
    batten_surface_unref(screw);
    batten_surface_unref(cylinder);
    batten_curve_unref(spine);
    batten_curve_unref(circle);
}

TEST(ruled_and_extruded_surfaces_are_exact)
{
    test_random random = test_random_begin("ruled");
    batten_curve *first = jittered(&random, 7, 0, airfoil),
                 *second = jittered(&random, 9, 1, airfoil);
    batten_surface *ruled = NULL, *extruded = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_ruled(first, second, &ruled));
    CHECK_EACH_ALLOCATION(batten_surface_extruded(first, (batten_vec3){0, 1, 2}, &extruded));
    CHECK_INT(batten_surface_degree(ruled, BATTEN_V), 1);
    for (int i = 0; i <= 20; i++) {
        double a[3], b[3], out[3];
        CHECK_OK(batten_curve_evaluate(first, i / 20.0, 0, a));
        CHECK_OK(batten_curve_evaluate(second, i / 20.0, 0, b));
        CHECK_OK(batten_surface_evaluate(ruled, i / 20.0, 0.25, 0, out));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(out[k], 0.75 * a[k] + 0.25 * b[k], 1e-14);
        CHECK_OK(batten_surface_evaluate(extruded, i / 20.0, 0.25, 0, out));
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(out[k], a[k] + 0.25 * k, 1e-14);
    }
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_extruded(first, (batten_vec3){0, 0, 0}, &none),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_surface_extruded(first, (batten_vec3){0, NAN, 0}, &none),
                 BATTEN_NOT_FINITE);
    CHECK(none == NULL);
    batten_surface_unref(extruded);
    batten_surface_unref(ruled);
    batten_curve_unref(second);
    batten_curve_unref(first);
}

TEST(weights_that_would_fall_below_zero_are_refused_with_their_number)
{
    const double weights[] = {1, 1, 30, 1e-3, 1, 1}, knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *sections[6];
    for (int k = 0; k < 6; k++) {
        const double points[] = {k, 0, 0, k, 1, 1, k, 2, 0}, w[] = {1, weights[k], 1};
        sections[k] = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, w, knots, &sections[k]));
    }
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin((batten_curve_row){6, (curves)sections}, NULL, NULL, NULL,
                                     NULL, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the weight of control point (2, ");
    CHECK(surface == NULL);
    unref_all(6, sections);
}

TEST(K7_the_knots_of_all_sections_are_in_the_union)
{
    test_random random = test_random_begin("union");
    batten_curve *sections[3];
    for (int k = 0; k < 3; k++)
        sections[k] = jittered(&random, 10, k, airfoil);
    batten_surface_skin_report report;
    batten_surface *surface = NULL;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, NULL, NULL, NULL,
                                 &report, &surface));
    CHECK(report.knot_count == 18 && report.exact_knot_count == 18);
    CHECK(report.span_ratio > 0 && report.span_ratio < 1 && report.normal_jump == 0);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

TEST(G1_sections_that_coincide_are_named)
{
    test_random random = test_random_begin("same");
    batten_curve *one = jittered(&random, 8, 0, airfoil),
                 *two = jittered(&random, 8, 1, airfoil);
    const batten_curve *sections[] = {one, two, two};
    batten_surface *surface = NULL;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){3, sections}, NULL, NULL, NULL, NULL, &surface),
        BATTEN_COINCIDENT);
    CHECK_MESSAGE("sections 2 and 3 coincide");
    batten_curve_unref(two);
    batten_curve_unref(one);
}

TEST(S5_skins_that_would_be_too_large_are_refused_before_the_work)
{
    batten_curve *section = NULL;
    const double a[] = {0, 0, 0}, b[] = {1, 0, 0};
    CHECK_OK(batten_curve_line(3, a, b, &section));
    const int count = test_cases(3) < 3 ? 10 : 600000;
    const batten_curve **sections = test_array((size_t)count, sizeof *sections);
    for (int k = 0; k < count; k++)
        sections[k] = section;
    batten_surface *surface = NULL;
    batten_surface_skin_options options = batten_surface_skin_defaults();
    options.parameters = BATTEN_UNIFORM;
    if (count > 10) {
        CHECK_STATUS(batten_surface_skin((batten_curve_row){count, sections}, &options, NULL,
                                         NULL, NULL, &surface),
                     BATTEN_TOO_LARGE);
        CHECK_STATUS(batten_surface_skin((batten_curve_row){2000000, sections}, &options, NULL,
                                         NULL, NULL, &surface),
                     BATTEN_TOO_LARGE);
    }
    CHECK(surface == NULL);
    batten_curve_unref(section);
}

TEST(skins_that_make_no_sense_are_refused)
{
    batten_curve *section = NULL;
    const double a[] = {0, 0, 0}, b[] = {1, 0, 0}, nothing[] = {1, 0},
                 infinite[] = {1, INFINITY};
    CHECK_OK(batten_curve_line(3, a, b, &section));
    const batten_curve *sections[] = {section, section};
    batten_surface *surface = NULL;
    CHECK_STATUS(
        batten_surface_skin((batten_curve_row){1, sections}, NULL, NULL, NULL, NULL, &surface),
        BATTEN_TOO_FEW_POINTS);
    for (int c = 0; c < 10; c++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.spine = c >= 6 ? section : NULL;
        options.degree = c == 0 ? 0 : c == 4 ? 2 : 3;
        if (c == 1)
            options.start.kind = BATTEN_END_CIRCLE;
        if (c == 2)
            options.end.kind = BATTEN_END_CURVATURE;
        if (c == 3)
            options.end.kind = BATTEN_END_DIRECTION;
        if (c == 4)
            options.end.kind = BATTEN_END_NATURAL;
        if (c == 5)
            options.start = (batten_end){BATTEN_END_CLAMPED, {0, NAN, 0}};
        options.scale = c == 6 ? nothing : c == 7 ? infinite : NULL;
        options.twist = c == 8 ? infinite : NULL;
        options.spine_at = c == 9 ? nothing : NULL;
        const batten_status expected = c == 0                       ? BATTEN_BAD_DEGREE
                                       : c == 5 || c == 7 || c == 8 ? BATTEN_NOT_FINITE
                                       : c == 9                     ? BATTEN_NOT_INCREASING
                                                                    : BATTEN_BAD_ARGUMENT;
        CHECK_STATUS(batten_surface_skin((batten_curve_row){2, sections}, &options, NULL, NULL,
                                         NULL, &surface),
                     expected);
    }
    CHECK(surface == NULL);
    batten_curve_unref(section);
}

TEST(curves_far_along_their_parameter_are_extruded)
{
    const double starts[] = {0, -1e3, 1e6, 1e9},
                 points[] = {0, 0, 0, 3, 5, 1, 7, -4, 0, 9, 1, 2, 12, 3, 1};
    for (int i = 0; i < COUNT(starts); i++) {
        const double a = starts[i],
                     knots[] = {a, a, a, a, a + 0.25, a + 1, a + 1, a + 1, a + 1};
        const batten_vec3 up = {0, 0, 10};
        batten_curve *curve = NULL;
        batten_surface *wall = NULL;
        CHECK_OK(batten_curve_create((batten_points){3, 5, points}, 3, NULL, knots, &curve));
        CHECK_EACH_ALLOCATION(batten_surface_extruded(curve, up, &wall));
        for (int k = 0; k <= 32; k++) {
            double given[3], found[3];
            CHECK_OK(batten_curve_evaluate(curve, a + k / 32.0, 0, given));
            CHECK_OK(batten_surface_evaluate(wall, k / 32.0, 1, 0, found));
            for (int c = 0; c < 3;
                 c++) /* quarters are exact at any start, so nothing is lost */
                CHECK_NEAR(found[c], given[c] + (c == 2 ? 10 : 0), 1e-13 * 22);
        }
        batten_surface_unref(wall);
        batten_curve_unref(curve);
    }
}

TEST(sections_with_rounded_parameters_are_skinned)
{
    const double thirds[] = {1e6,     1e6,     1e6,     1e6,    1e6 + 1 / 3.0,
                             1e6 + 1, 1e6 + 1, 1e6 + 1, 1e6 + 1};
    const double sevenths[] = {0, 0, 0, 0, 2 / 7.0, 1, 1, 1, 1};
    const double points[] = {0, 0, 3, 5, 7, -4, 9, 1, 12, 3};
    batten_curve *sections[3] = {NULL};
    for (int k = 0; k < 3; k++) {
        double placed[15];
        for (int i = 0; i < 5; i++) {
            placed[3 * i] = points[2 * i];
            placed[3 * i + 1] = points[2 * i + 1];
            placed[3 * i + 2] = k;
        }
        CHECK_OK(batten_curve_create((batten_points){3, 5, placed}, 3, NULL,
                                     k == 1 ? sevenths : thirds, &sections[k]));
    }
    batten_surface *surface = NULL;
    batten_surface_skin_report report;
    CHECK_OK(batten_surface_skin((batten_curve_row){3, (curves)sections}, NULL, NULL, NULL,
                                 &report, &surface));
    CHECK_INT(report.knot_count, 2);
    batten_surface_unref(surface);
    unref_all(3, sections);
}

static const struct {
    int count, degree;
    batten_end start, end;
    double tolerance;
    batten_status status;
    const char *message;
} refused[] = {
    {0, 3, .status = BATTEN_TOO_FEW_POINTS,
     .message = "there are 0 sections, and a skin needs 2"},
    {1, 3, .status = BATTEN_TOO_FEW_POINTS,
     .message = "there is 1 section, and a skin needs 2"},
    {2, 0, .status = BATTEN_BAD_DEGREE,
     .message = "the degree across the sections is 0, not 1 to"},
    {2, BATTEN_MAX_DEGREE + 1, .status = BATTEN_BAD_DEGREE,
     .message = "the degree across the sections is"},
    {2, 3, .tolerance = NAN, .status = BATTEN_NOT_FINITE, .message = "the tolerance is nan"},
    {2, 3, .tolerance = -1, .status = BATTEN_BAD_ARGUMENT,
     .message = "the tolerance is -1, below 0"},
    {2, 3, .start = {BATTEN_END_CIRCLE, {0}}, .status = BATTEN_BAD_ARGUMENT,
     .message = "a skin cannot have a circle or a curvature at its start"},
    {2, 3, .end = {BATTEN_END_CURVATURE, {0}}, .status = BATTEN_BAD_ARGUMENT,
     .message = "a skin cannot have a circle or a curvature at its end"},
    {2, 4, .end = {BATTEN_END_NATURAL, {0}}, .status = BATTEN_BAD_ARGUMENT,
     .message = "conditions at the end need an odd degree, and it is 4"},
    {2, 3, .start = {BATTEN_END_CLAMPED, {0, 0, NAN}}, .status = BATTEN_NOT_FINITE,
     .message = "the vector at the start is not finite"},
    {2, 3, .end = {BATTEN_END_DIRECTION, {0}}, .status = BATTEN_BAD_ARGUMENT,
     .message = "the direction at the end has no length"},
};

TEST(options_of_skins_out_of_bounds_are_named_with_their_numbers)
{
    const double a[] = {0, 0, 0}, b[] = {1, 0, 0}, c[] = {0, 1, 0}, d[] = {1, 1, 0};
    batten_curve *sections[2] = {NULL, NULL};
    batten_surface *surface = NULL;
    CHECK_OK(batten_curve_line(3, a, b, &sections[0]));
    CHECK_OK(batten_curve_line(3, c, d, &sections[1]));
    for (int i = 0; i < COUNT(refused); i++) {
        batten_surface_skin_options options = batten_surface_skin_defaults();
        options.degree = refused[i].degree;
        options.start = refused[i].start;
        options.end = refused[i].end;
        options.tolerance = refused[i].tolerance;
        CHECK_STATUS(batten_surface_skin((batten_curve_row){refused[i].count, (curves)sections},
                                         &options, NULL, NULL, NULL, &surface),
                     refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
    CHECK(!surface);
    unref_all(2, sections);
}
