#include "shape/plate/plates.h"

#include "support/faults.h"

#include <batten/skin.h>

static const double pi = 3.14159265358979323846;

TEST(the_condition_between_coaxial_circles_holds_for_equal_angles_and_opposite_ones)
{
    batten_curve *a = arc(1, 0, 2 * pi, 0), *b = arc(2, 0, 2 * pi, 1);
    double condition, warp;
    const batten_interval d = batten_curve_domain(a), e = batten_curve_domain(b);
    for (int k = 0; k <= 8; k++) {
        const double f = k / 8.0;
        CHECK_EACH_ALLOCATION(batten_ruling_condition(
            a, d.a + f * (d.b - d.a), b, e.a + f * (e.b - e.a), &condition, &warp));
        CHECK_NEAR(condition, 0, 1e-12);
        CHECK_NEAR(warp, 0, 1e-7);
    }
    /* On the far side the tangents are parallel too, but the surface would turn over. */
    CHECK_OK(batten_ruling_condition(a, d.a, b, (e.a + e.b) / 2, &condition, &warp));
    CHECK_NEAR(condition, 0, 1e-12);
    CHECK_NEAR(warp, pi, 1e-7);
    drop(a, b);
}

/* With the angle for the parameter the condition is h r1 r2 sin of the difference. */
TEST(the_condition_between_coaxial_circles_is_0_2_at_a_tenth_of_a_radian)
{
    const double first[6] = {1, 0, 0, 1, 1, 0};
    const double second[6] = {2 * cos(0.1),
                              2 * sin(0.1),
                              1,
                              2 * cos(0.1) - 2 * sin(0.1),
                              2 * sin(0.1) + 2 * cos(0.1),
                              1};
    batten_curve *a = line(first), *b = line(second); /* the tangents, with their speed */
    const double s = batten_curve_domain(a).a, t = batten_curve_domain(b).a;
    const double la = batten_curve_domain(a).b - s, lb = batten_curve_domain(b).b - t;
    double condition, warp;
    CHECK_OK(batten_ruling_condition(a, s, b, t, &condition, &warp));
    CHECK_NEAR(fabs(condition) * la * lb, 2 * sin(0.1), 1e-12);
    drop(a, b);
}

TEST(between_coaxial_circles_lies_a_cone_with_its_apex_at_minus_1)
{
    batten_curve *a = arc(1, 0, 2 * pi, 0), *b = arc(2, 0, 2 * pi, 1);
    batten_developable made = {0};
    CHECK_OK(develop(a, b, 1e-6, &made));
    CHECK(made.is_developable && !made.has_regression && !made.cone[0] && !made.cone[1]);
    CHECK(made.warp < 1e-7 && made.error == 0);
    double low[9], high[9];
    CHECK_OK(batten_surface_evaluate(made.surface, 0.3, 0, 1, low));
    CHECK_OK(batten_surface_evaluate(made.surface, 0.3, 1, 1, high));
    /* S_u = (1 - v) low + v high is 0 at v = -1. */
    for (int c = 0; c < 3; c++)
        CHECK_NEAR(2 * low[3 + c] - high[3 + c], 0, 1e-10);
    batten_developable_release(&made);
    drop(a, b);
}

TEST(a_curve_and_its_translate_have_parallel_rulings)
{
    batten_curve *a = space_cubic(0, 0, 0), *b = space_cubic(0.2, 0.3, 1);
    for (int k = 0; k < 2; k++) {
        batten_developable made = {0};
        CHECK_OK(develop(a, b, 1e-6, &made));
        CHECK(made.is_developable && !made.cone[0] && !made.cone[1]);
        CHECK(made.error <= 1e-6);
        CHECK(k > 0 || made.error == 0);
        for (int i = 0; i < made.count; i++) {
            double p[3], q[3];
            CHECK_OK(batten_curve_evaluate(a, made.rulings[i].s, 0, p));
            CHECK_OK(batten_curve_evaluate(b, made.rulings[i].t, 0, q));
            CHECK_NEAR(q[0] - p[0], 0.2, 1e-7);
            CHECK_NEAR(q[1] - p[1], 0.3, 1e-7);
            CHECK(made.rulings[i].warp < 1e-7);
        }
        batten_developable_release(&made);
        b = reparametrised(b);
    }
    drop(a, b);
}

TEST(where_an_edge_ends_first_the_surface_ends_in_a_cone)
{
    batten_curve *a = arc(1, 0, 2, 0), *b = arc(1, 0.3, 1.8, 1);
    batten_developable made = {0};
    CHECK_OK(develop(a, b, 1e-7, &made));
    CHECK(made.cone[0] && made.cone[1] && made.error <= 1e-7);
    CHECK(made.warp < 1e-3 && made.is_developable);
    for (int i = 0; i < made.count; i++) {
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(a, made.rulings[i].s, 0, p));
        CHECK_OK(batten_curve_evaluate(b, made.rulings[i].t, 0, q));
        const double angle = atan2(p[1], p[0]);
        const double other = angle < 0.3 ? 0.3 : angle > 1.8 ? 1.8 : angle;
        CHECK_NEAR(atan2(q[1], q[0]), other, 1e-6);
        CHECK(i == 0 || made.rulings[i].u > made.rulings[i - 1].u);
        /* The surface has this ruling at this u. */
        double low[3], high[3];
        CHECK_OK(batten_surface_evaluate(made.surface, made.rulings[i].u, 0, 0, low));
        CHECK_OK(batten_surface_evaluate(made.surface, made.rulings[i].u, 1, 0, high));
        CHECK_NEAR(hypot(q[0] - high[0], q[1] - high[1]), 0, 1e-2);
        CHECK_NEAR(hypot(p[0] - low[0], p[1] - low[1]), 0, 1e-2);
    }
    batten_developable_release(&made);
    drop(a, b);
}

/* Two rails of the tangent surface of a helix, so far along its tangents. */
static void tangents_of_a_helix(double from, double to, batten_curve *edges[2])
{
    enum { COUNT = 40 };
    static double t[COUNT], values[COUNT][3][3];
    for (int e = 0; e < 2; e++) {
        const double w = e ? to : from;
        for (int i = 0; i < COUNT; i++) {
            t[i] = 2.0 * i / (COUNT - 1);
            const double c = cos(t[i]), s = sin(t[i]);
            const double rows[3][3] = {{c - w * s, s + w * c, 0.7 * (t[i] + w)},
                                       {-s - w * c, c - w * s, 0.7},
                                       {-c + w * s, -s - w * c, 0}};
            memcpy(values[i], rows, sizeof rows);
        }
        CHECK_OK(batten_curve_from_hermite(3, COUNT, 3, t, &values[0][0][0], &edges[e]));
    }
}

TEST(the_tangents_of_a_helix_are_found_and_unroll_without_strain)
{
    batten_curve *edges[2] = {NULL, NULL};
    tangents_of_a_helix(0.5, 1.5, edges);
    edges[1] = reparametrised(edges[1]);
    batten_developable made = {0};
    batten_unrolled flat = {0};
    CHECK_OK(develop(edges[0], edges[1], 1e-6, &made));
    CHECK(made.is_developable && made.error <= 1e-6 && !made.cone[0] && !made.cone[1]);
    CHECK(made.warp < 5e-4);
    batten_surface_unroll_options options = batten_surface_unroll_defaults();
    options.tolerance = 1e-5;
    CHECK_EACH_ALLOCATION(batten_surface_unroll(made.surface, &options, &flat));
    CHECK(flat.strain < 1e-7);
    CHECK_NEAR(flat.area[0], flat.area[1], 1e-6);
    CHECK_NEAR(fabs(flat.turn), 2 / sqrt(1.49), 1e-4);
    batten_unrolled_release(&flat);
    batten_developable_release(&made);
    drop(edges[0], edges[1]);
}

TEST(an_edge_of_regression_inside_the_plate_is_seen_with_its_place)
{
    batten_curve *edges[2] = {NULL, NULL};
    tangents_of_a_helix(-0.5, 1, edges);
    batten_developable made = {0};
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.keep_matching = true;
    CHECK_EACH_ALLOCATION(batten_surface_developable(edges[0], edges[1], &options, &made));
    CHECK(made.has_regression && !made.is_developable);
    CHECK_NEAR(made.regression_share, 1.0 / 3, 1e-6);
    CHECK_NEAR(made.warp, pi, 1e-4);
    batten_developable_release(&made);
    drop(edges[0], edges[1]);
}

TEST(a_flat_plate_is_developable)
{
    batten_curve *a = arc(1, 0, 1.5, 0), *b = arc(2, 0, 1.5, 0);
    batten_developable made = {0};
    CHECK_OK(develop(a, b, 1e-6, &made));
    CHECK(made.is_developable && made.warp < 1e-10);
    batten_developable_release(&made);
    drop(a, b);
}

TEST(g5_an_edge_that_is_a_point_makes_a_cone)
{
    const double apex[6] = {0, 0, 3, 0, 0, 3}, knots[4] = {0, 0, 1, 1};
    batten_curve *a = space_cubic(0, 0, 0), *b = NULL;
    batten_developable made = {0};
    CHECK_OK(batten_curve_create((batten_points){3, 2, apex}, 1, NULL, knots, &b));
    CHECK_OK(develop(a, b, 1e-6, &made));
    CHECK(made.is_developable && made.warp == 0 && made.error == 0);
    batten_developable_release(&made);
    CHECK_STATUS(develop(b, b, 1e-6, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("both edges are points");
    drop(a, b);
}

/* A line and a curve: one plane touches both; the rest are cones about the ends of the line. */
TEST(a_line_and_an_arc_are_joined_by_a_plane_and_cones)
{
    const double ends[6] = {1.5, 0.2, 1, 0.4, 1.4, 1};
    batten_curve *a = line(ends), *b = arc(1, 0, pi / 2, 0);
    batten_developable made = {0};
    CHECK_OK(develop(a, b, 1e-6, &made));
    CHECK(made.cone[0] && made.cone[1] && made.is_developable);
    CHECK(made.warp < 1e-3);
    batten_developable_release(&made);
    drop(a, b);
}

TEST(the_warp_of_skew_lines_is_reported)
{
    const double first[6] = {0, 0, 0, 1, 0, 0}, second[6] = {0, 1, 0, 1, 1, 0.1};
    batten_curve *a = line(first), *b = line(second);
    batten_developable made = {0};
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.keep_matching = true;
    CHECK_OK(batten_surface_developable(a, b, &options, &made));
    CHECK(!made.is_developable);
    CHECK_NEAR(made.warp, atan(0.1), 1e-12);
    CHECK_NEAR(made.warp_at, 0, 1e-12);
    batten_developable_release(&made);
    /* The best there is: two triangles and the crease between them. */
    CHECK_OK(develop(a, b, 1e-6, &made));
    CHECK(!made.is_developable && made.warp > 0.05 && made.warp < 0.11);
    batten_developable_release(&made);
    drop(a, b);
}

TEST(g7_edges_that_run_against_each_other_have_corners_or_touch_are_refused)
{
    const double corner[9] = {0, 0, 1, 1, 1, 1, 3, 0, 1};
    const double first[6] = {0, 0, 0, 1, 1, 0}, second[6] = {0, 1, 0, 1, 0.13, 0};
    batten_curve *a = space_cubic(0, 0, 0), *b = space_cubic(0, 0, 1), *back = NULL;
    batten_curve *broken = NULL, *p = line(first), *q = line(second);
    batten_developable made = {0};
    CHECK_OK(batten_curve_reverse(b, &back));
    CHECK_STATUS(develop(a, back, 1e-6, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("run against each other");
    CHECK_OK(batten_curve_polyline((batten_points){3, 3, corner}, &broken));
    CHECK_STATUS(develop(a, broken, 1e-6, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the second edge has a corner at");
    CHECK_STATUS(develop(a, a, 1e-6, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("the edges touch at");
    CHECK_STATUS(develop(p, q, 1e-6, &made), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("folds back");
    CHECK_STATUS(develop(a, b, 0, &made), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("not above 0");
    drop(a, b);
    drop(back, broken);
    drop(p, q);
}

TEST(g4_edges_without_a_tangent_are_refused)
{
    const double points[12] = {0, 0, 1, 0, 0, 1, 2, 0, 1, 3, 1, 1};
    const double knots[8] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *a = space_cubic(0, 0, 0), *b = NULL;
    batten_developable made = {0};
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 3, NULL, knots, &b));
    CHECK_STATUS(develop(a, b, 1e-6, &made), BATTEN_SINGULAR_HERE);
    CHECK_MESSAGE("the second edge has no tangent at 0");
    drop(a, b);
}

TEST(huge_and_tiny_plates_are_alike)
{
    const double scales[2] = {1e80, 1e-80};
    for (int k = 0; k < 2; k++) {
        const double r = scales[k];
        batten_curve *a = arc(r, 0, 2, 0), *b = arc(2 * r, 0.3, 1.8, r);
        batten_developable made = {0};
        CHECK_OK(develop(a, b, 1e-6 * r, &made));
        CHECK(made.cone[0] && made.cone[1] && made.is_developable);
        batten_developable_release(&made);
        drop(a, b);
    }
}

TEST(tolerances_and_warps_out_of_bounds_are_refused_with_their_number)
{
    const struct {
        double tolerance, warp;
        const char *message;
    } rows[] = {{0, 0.1, "the tolerance is 0, not above 0"},
                {-2, 0.1, "the tolerance is -2, not above 0"},
                {HUGE_VAL, 0.1, "the tolerance is inf, not above 0"},
                {1e-4, 0, "the warp is 0; it must be above 0 and below a right angle"},
                {1e-4, 1.6, "the warp is 1.6; it must be above 0 and below a right angle"},
                {1e-4, NAN, "the warp is nan; it must be above 0 and below a right angle"}};
    batten_curve *a = space_cubic(0, 0, 0), *b = space_cubic(0, 0, 1);
    batten_developable made = {.count = 7};
    for (int i = 0; i < COUNT(rows); i++) {
        batten_surface_developable_options options = batten_surface_developable_defaults();
        options.tolerance = rows[i].tolerance;
        options.warp = rows[i].warp;
        CHECK_STATUS(batten_surface_developable(a, b, &options, &made), BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(rows[i].message);
        CHECK(made.count == 7 && !made.surface);
    }
    drop(a, b);
}

/* From (x, 0, 0) to (x, 1, c x): the normals at the ends are (0, -c x, 1) and (-c, -c x, 1), so the
 * tangent of the angle between them is c / sqrt(1 + c^2 x^2), which is largest at x = 0. */
TEST(the_rulings_of_matching_parameters_have_them_and_the_warp_of_their_lines)
{
    const double first[6] = {0, 0, 0, 1, 0, 0}, second[6] = {0, 1, 0, 1, 1, 0.5};
    batten_curve *a = line(first), *b = line(second);
    batten_developable made = {0};
    batten_surface_developable_options options = batten_surface_developable_defaults();
    options.keep_matching = true;
    options.warp = 0.47; /* the warp is atan(0.5) = 0.4636 */
    const batten_interval s = batten_curve_domain(a), t = batten_curve_domain(b);
    CHECK_OK(batten_surface_developable(a, b, &options, &made));
    CHECK_INT(made.count, 65);
    for (int i = 0; i < made.count; i++) {
        const double x = i / 64.0;
        CHECK_NEAR(made.rulings[i].u, x, 0);
        CHECK_NEAR(made.rulings[i].s, s.a + x * (s.b - s.a), 1e-15);
        CHECK_NEAR(made.rulings[i].t, t.a + x * (t.b - t.a), 1e-15);
        CHECK_NEAR(made.rulings[i].warp, atan(0.5 / sqrt(1 + 0.25 * x * x)), 1e-14);
    }
    CHECK(made.is_developable && !made.has_regression && made.error == 0);
    CHECK(!made.cone[0] && !made.cone[1]);
    CHECK_NEAR(made.warp, atan(0.5), 1e-14);
    batten_developable_release(&made);
    CHECK(!made.surface && !made.rulings && made.count == 0);
    drop(a, b);
}

/* Along (0, 0) to (3, 0) from the origin to (x, y): det((3, 0, 0), D, P). */
TEST(the_condition_is_a_determinant_also_in_the_plane_and_has_no_warp_without_planes)
{
    const double first[6] = {0, 0, 0, 3, 0, 0}, second[6] = {1, 2, 5, 1, 6, 2};
    const double ahead[6] = {5, 0, 0, 6, 1, 0};
    batten_curve *a = line(first), *b = line(second), *c = line(ahead), *flat = NULL;
    double condition = 7, warp = 7;
    CHECK_OK(batten_curve_line(2, first, first + 3, &flat));
    const double s = batten_curve_domain(a).a, t = batten_curve_domain(b).a;
    const double speeds =
        (batten_curve_domain(a).b - s) * (batten_curve_domain(b).b - t); /* of the parameters */
    CHECK_OK(batten_ruling_condition(a, s, b, t, &condition, &warp));
    CHECK_NEAR(condition * speeds, 3 * (4 * 5 + 3 * 2),
               1e-13); /* (3,0,0) x (0,4,-3) . (1,2,5) */
    CHECK_OK(batten_ruling_condition(a, s, c, batten_curve_domain(c).a, &condition, &warp));
    CHECK(condition == 0 && isnan(warp)); /* the line runs along the first */
    CHECK_OK(batten_ruling_condition(flat, s, b, t, &condition, &warp));
    CHECK_NEAR(condition * speeds, 3 * (4 * 5 + 3 * 2), 1e-13);
    CHECK_STATUS(batten_ruling_condition(a, s - 1, b, t, &condition, &warp),
                 BATTEN_OUT_OF_DOMAIN);
    drop(a, b);
    drop(c, flat);
}
