#include "shape/boundary/coons_formula.h"

#include <batten/curvature.h>
#include <batten/standard.h>

#include "support/faults.h"

static const batten_blending families[] = {BATTEN_BLENDING_LINEAR, BATTEN_BLENDING_CUBIC,
                                           BATTEN_BLENDING_QUINTIC, BATTEN_BLENDING_COONS};
static const int orders[] = {1, 2, 3, 3};

static batten_surface *patch(const batten_ribbon *sides, int order, batten_blending u,
                             batten_blending v, batten_surface_coons_report *report)
{
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface *surface = NULL;
    options.order = order;
    options.blending_u = u;
    options.blending_v = v;
    CHECK_EACH_ALLOCATION(batten_surface_coons(sides, &options, report, &surface));
    return surface;
}

TEST(the_spline_of_a_patch_is_the_patch_for_every_kind_and_blend)
{
    test_random random = test_random_begin("coons");
    const int count = test_cases(100) < 100 ? 8 : 100;
    for (int f = 0; f < 4; f++)
        for (int order = 1; order <= orders[f]; order++) {
            frame_of_surface frame;
            frame_surface(bumpy(&random, 3, 2 + f % 3, 3, 2 + f), &frame);
            batten_surface_coons_report report;
            const batten_blending other = order == 1 ? BATTEN_BLENDING_LINEAR : families[f];
            batten_surface *coons = patch(frame.sides, order, families[f], other, &report);
            batten_surface *nurbs = NULL;
            double error = 1;
            CHECK(report.exact);
            CHECK_TEXT(batten_surface_kind(coons), "coons");
            CHECK_OK(batten_surface_to_nurbs(coons, 0, &error, &nurbs));
            CHECK(error == 0);
            CHECK(!batten_surface_is_rational(nurbs));
            CHECK_NEAR(apart(coons, nurbs, count, 0, 0, false), 0, 1e-13);
            CHECK_NEAR(apart(coons, nurbs, 12, 1, 1, false), 0, 1e-11);
            batten_surface_unref(nurbs);
            batten_surface_unref(coons);
            frame_release(&frame);
        }
}

TEST(a_patch_has_the_edges_slopes_and_curvatures_that_it_is_given)
{
    test_random random = test_random_begin("edges");
    for (int f = 0; f < 4; f++)
        for (int order = 1; order <= orders[f]; order++) {
            frame_of_surface frame;
            frame_surface(bumpy(&random, 4, 3, 2, 3), &frame);
            batten_surface_coons_report report;
            batten_surface *coons =
                patch(frame.sides, order, families[f], families[f], &report);
            for (int k = 0; k < order; k++) {
                const double tolerance = k < 2 ? 1e-12 : 1e-11;
                for (int i = 0; i <= 40; i++)
                    for (int e = 0; e < 4; e++) {
                        const double t = i / 40.0;
                        const double u = e % 2 ? e == 1 : t, v = e % 2 ? t : e == 2;
                        const int at = 3 * (e % 2 ? BATTEN_SURFACE_DERIVATIVE(k, 0)
                                                  : BATTEN_SURFACE_DERIVATIVE(0, k));
                        double p[18], q[18];
                        CHECK_OK(batten_surface_evaluate(coons, u, v, 2, p));
                        CHECK_OK(batten_surface_evaluate(frame.surface, u, v, 2, q));
                        for (int x = 0; x < 3; x++)
                            CHECK_NEAR(p[at + x], q[at + x],
                                       tolerance * fmax(1, fabs(q[at + x])));
                    }
            }
            for (int e = 0; e < 4; e++)
                for (int k = 0; k < 3; k++)
                    CHECK_NEAR(report.missed[e][k], 0, 1e-11);
            batten_surface_unref(coons);
            frame_release(&frame);
        }
}

/* Any surface that is a cubic in one of the variables comes back. */
TEST(a_surface_cubic_along_one_parameter_is_reproduced)
{
    test_random random = test_random_begin("cubic");
    for (int turn = 0; turn < 2; turn++) {
        frame_of_surface frame;
        frame_surface(bumpy(&random, turn ? 3 : 5, turn ? 4 : 3, turn ? 1 : 3, turn ? 3 : 1),
                      &frame);
        batten_surface *coons =
            patch(frame.sides, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, NULL);
        CHECK_NEAR(apart(coons, frame.surface, 20, 0, 0, false), 0, 1e-13);
        batten_surface_unref(coons);
        frame_release(&frame);
    }
}

static batten_curve *line(double x0, double y0, double z0, double x1, double y1, double z1)
{
    const double points[] = {x0, y0, z0, x1, y1, z1}, knots[] = {0, 0, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &curve));
    return curve;
}

/* z = u v over the unit square. */
static void saddle(batten_curve *curves[4], batten_ribbon sides[4])
{
    curves[BATTEN_EDGE_V0] = line(0, 0, 0, 1, 0, 0);
    curves[BATTEN_EDGE_U1] = line(1, 0, 0, 1, 1, 1);
    curves[BATTEN_EDGE_V1] = line(0, 1, 0, 1, 1, 1);
    curves[BATTEN_EDGE_U0] = line(0, 0, 0, 0, 1, 0);
    for (int e = 0; e < 4; e++)
        sides[e] = (batten_ribbon){curves[e], NULL, NULL};
}

static void release(batten_curve **curves, int count)
{
    for (int i = 0; i < count; i++)
        batten_curve_unref(curves[i]);
}

TEST(flat_spots_are_what_the_formula_says_and_twists_cure_them)
{
    batten_curve *curves[4];
    batten_ribbon sides[4];
    saddle(curves, sides);
    batten_surface *bilinear =
        patch(sides, 1, BATTEN_BLENDING_LINEAR, BATTEN_BLENDING_LINEAR, NULL);
    batten_surface *flat = patch(sides, 1, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, NULL);
    batten_surface *cured = patch(sides, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, NULL);
    batten_surface_coons_options options = batten_surface_coons_defaults();
    const double none[12] = {0};
    batten_surface *zero = NULL;
    options.order = 2;
    options.blending_u = options.blending_v = BATTEN_BLENDING_CUBIC;
    options.twists = none;
    CHECK_EACH_ALLOCATION(batten_surface_coons(sides, &options, NULL, &zero));
    for (int i = 0; i <= 16; i++)
        for (int j = 0; j <= 16; j++) {
            const double u = i / 16.0, v = j / 16.0;
            const double f = u - u * u * (3 - 2 * u), g = v - v * v * (3 - 2 * v);
            double out[18];
            CHECK_OK(batten_surface_evaluate(bilinear, u, v, 0, out));
            CHECK_NEAR(out[2], u * v, 1e-16);
            CHECK_OK(batten_surface_evaluate(flat, u, v, 0, out));
            CHECK_NEAR(out[2], u * v - f * g, 1e-15);
            CHECK_OK(batten_surface_evaluate(zero, u, v, 0, out));
            CHECK_NEAR(out[2], u * v - f * g, 1e-15);
            CHECK_OK(batten_surface_evaluate(cured, u, v, 2, out));
            CHECK_NEAR(out[2], u * v, 1e-15);
            if (i % 16 == 0 && j % 16 == 0)
                CHECK_NEAR(out[3 * BATTEN_SURFACE_DERIVATIVE(1, 1) + 2], 1, 1e-15);
        }
    batten_surface_unref(zero);
    batten_surface_unref(cured);
    batten_surface_unref(flat);
    batten_surface_unref(bilinear);
    release(curves, 4);
}

/* Of z = u v the Gaussian curvature is -1 / (1 + u^2 + v^2)^2; without twists it is 0 at the
 * corners. */
TEST(the_curvature_at_the_corners_tells_flat_spots)
{
    batten_curve *curves[4];
    batten_ribbon sides[4];
    saddle(curves, sides);
    batten_surface *flat = patch(sides, 1, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, NULL);
    batten_surface *cured = patch(sides, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, NULL);
    for (int c = 0; c < 4; c++) {
        const double u = c / 2, v = c % 2, w = 1 + u * u + v * v;
        batten_surface_local local;
        CHECK_OK(batten_surface_local_at(flat, u, v, &local));
        CHECK_NEAR(local.gaussian, 0, 1e-14);
        CHECK_OK(batten_surface_local_at(cured, u, v, &local));
        CHECK_NEAR(local.gaussian, -1 / (w * w), 1e-13);
    }
    batten_surface_unref(cured);
    batten_surface_unref(flat);
    release(curves, 4);
}

TEST(chosen_twists_are_those_of_the_patch_and_leave_its_edges)
{
    test_random random = test_random_begin("twists");
    frame_of_surface frame;
    frame_surface(bumpy(&random, 3, 3, 2, 2), &frame);
    for (int e = 0; e < 4; e++)
        frame.sides[e].slope = frame.sides[e].curvature = NULL;
    double twists[12];
    for (int i = 0; i < 12; i++)
        twists[i] = test_random_in(&random, -2, 2);
    batten_surface_coons_options options = batten_surface_coons_defaults();
    options.order = 2;
    options.twists = twists;
    for (int f = 1; f < 4; f++) {
        batten_surface *coons = NULL, *plain = NULL;
        options.blending_u = options.blending_v = families[f];
        CHECK_OK(batten_surface_coons(frame.sides, &options, NULL, &coons));
        plain = patch(frame.sides, 1, families[f], families[f], NULL);
        for (int c = 0; c < 4; c++) {
            double out[18];
            CHECK_OK(batten_surface_evaluate(coons, c == 1 || c == 2, c / 2, 2, out));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(out[3 * BATTEN_SURFACE_DERIVATIVE(1, 1) + x], twists[3 * c + x],
                           1e-13);
        }
        CHECK_NEAR(apart(coons, plain, 20, 0, 0, true), 0, 1e-14);
        CHECK(apart(coons, plain, 20, 0, 0, false) > 1e-3);
        batten_surface_unref(plain);
        batten_surface_unref(coons);
    }
    frame_release(&frame);
}

/* ---- what does not fit ---- */

TEST(G7_gaps_at_corners_are_named_and_small_ones_shared)
{
    batten_curve *curves[4];
    batten_ribbon sides[4];
    saddle(curves, sides);
    batten_curve_unref(curves[BATTEN_EDGE_V1]);
    curves[BATTEN_EDGE_V1] = line(0, 1, 0, 1, 1, 1.125);
    sides[BATTEN_EDGE_V1].curve = curves[BATTEN_EDGE_V1];
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface_coons_report report;
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_coons(sides, &options, &report, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 3, between edges v = 1 and u = 1: the boundary curves differ by "
                  "0.125, more than 1e-06");
    options.tolerance = 0.2;
    CHECK_OK(batten_surface_coons(sides, &options, &report, &surface));
    CHECK_NEAR(report.corner_gap, 0.125, 1e-15);
    CHECK_INT(report.corner, 3);
    CHECK_NEAR(report.missed[BATTEN_EDGE_V1][0], 0.0625, 1e-15);
    double out[3];
    CHECK_OK(batten_surface_evaluate(surface, 1, 1, 0, out));
    CHECK_NEAR(out[2], 1.0625, 1e-15);
    batten_surface_unref(surface);
    release(curves, 4);
}

static void tilt(frame_of_surface *frame, int edge, double x0, double x1)
{
    batten_curve *curve = frame->curves[edge][1], *tilted = NULL, *again = NULL;
    double point[3];
    const int last = batten_curve_point_count(curve) - 1;
    memcpy(point, batten_curve_points(curve), sizeof point);
    point[2] += x0;
    CHECK_OK(batten_curve_with_point(curve, 0, point, &tilted));
    memcpy(point, batten_curve_points(curve) + 3 * last, sizeof point);
    point[2] += x1;
    CHECK_OK(batten_curve_with_point(tilted, last, point, &again));
    batten_curve_unref(tilted);
    batten_curve_unref(curve);
    frame->curves[edge][1] = again;
    frame->sides[edge].slope = again;
}

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = a[(c + 1) % 3] * b[(c + 2) % 3] - a[(c + 2) % 3] * b[(c + 1) % 3];
}

static double cosine(const double a[3], const double b[3])
{
    double ab = 0, aa = 0, bb = 0;
    for (int c = 0; c < 3; c++) {
        ab += a[c] * b[c];
        aa += a[c] * a[c];
        bb += b[c] * b[c];
    }
    return ab / sqrt(aa * bb);
}

/* The normal that side u = 1 asks for at its parameter t. */
static void ribbon_normal(const frame_of_surface *frame, double t, double out[3])
{
    double along[2][3], slope[3];
    CHECK_OK(batten_curve_evaluate(frame->sides[BATTEN_EDGE_U1].curve, t, 1, along[0]));
    CHECK_OK(batten_curve_evaluate(frame->sides[BATTEN_EDGE_U1].slope, t, 0, slope));
    cross(along[1], slope, out);
}

/* Between the end of the curve v = 1 and the plane of side u = 1. */
static double angle_at_corner(const frame_of_surface *frame)
{
    double normal[3], curve[2][3];
    ribbon_normal(frame, 1, normal);
    CHECK_OK(batten_curve_evaluate(frame->sides[BATTEN_EDGE_V1].curve, 1, 1, curve[0]));
    return asin(fabs(cosine(normal, curve[1])));
}

static double largest_angle_u1(const batten_surface *surface, const frame_of_surface *frame)
{
    double largest = 0;
    for (int k = 0; k <= 1000; k++) {
        double d[3][3], n[3], m[3];
        CHECK_OK(batten_surface_evaluate(surface, 1, k / 1000.0, 1, d[0]));
        cross(d[1], d[2], n); /* along, into: the other way round */
        ribbon_normal(frame, k / 1000.0, m);
        largest = fmax(largest, acos(fmin(1, fabs(cosine(n, m)))));
    }
    return largest;
}

TEST(a_slope_that_does_not_fit_is_refused_or_repaired)
{
    test_random random = test_random_begin("slopes");
    frame_of_surface frame;
    frame_surface(bumpy(&random, 3, 3, 2, 2), &frame);
    tilt(&frame, BATTEN_EDGE_U1, 0, 0.25);
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface_coons_report report;
    batten_surface *surface = NULL;
    options.order = 2;
    options.blending_u = options.blending_v = BATTEN_BLENDING_CUBIC;
    CHECK_STATUS(batten_surface_coons(frame.sides, &options, &report, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 3, between edges v = 1 and u = 1: slope and boundary curve differ by "
                  "0.25 per unit of the parameter");
    CHECK_MESSAGE(" degrees");
    /* The report is there, with the angle between the curve v = 1 and the slope's plane. */
    CHECK_NEAR(report.slope_angle, angle_at_corner(&frame), 1e-12);
    CHECK(report.slope_angle > 0.01);
    options.repair = true;
    options.twist = BATTEN_TWIST_KEEP_U;
    CHECK_OK(batten_surface_coons(frame.sides, &options, &report, &surface));
    CHECK_NEAR(report.slope_gap, 0.25, 1e-12);
    CHECK_INT(report.slope_corner, 3);
    /* All boundary curves hold. */
    CHECK_NEAR(apart(surface, frame.surface, 20, 0, 0, true), 0, 1e-13);
    CHECK(report.missed[BATTEN_EDGE_U1][1] >= 0.25 - 1e-12);
    /* In the corner the surface has the plane of both curves. */
    CHECK(report.angle[BATTEN_EDGE_U1] >= report.slope_angle - 1e-9);
    CHECK_NEAR(report.angle[BATTEN_EDGE_U1], largest_angle_u1(surface, &frame), 1e-3);
    for (int e = 0; e < 4; e++)
        CHECK_NEAR(report.missed[e][0], 0, 1e-13);
    batten_surface_unref(surface);
    frame_release(&frame);
}

/* The twist alone is changed: the second control point of a slope. */
static void wring(frame_of_surface *frame, int edge, double by)
{
    batten_curve *curve = frame->curves[edge][1], *wrung = NULL;
    double point[3];
    memcpy(point, batten_curve_points(curve) + 3, sizeof point);
    point[2] += by;
    CHECK_OK(batten_curve_with_point(curve, 1, point, &wrung));
    batten_curve_unref(curve);
    frame->curves[edge][1] = wrung;
    frame->sides[edge].slope = wrung;
}

/* How far the slopes across each edge are from those given. */
static void slope_misses(const batten_surface *surface, const frame_of_surface *frame,
                         double misses[4])
{
    for (int e = 0; e < 4; e++) {
        misses[e] = 0;
        for (int i = 0; i <= 64; i++) {
            const double t = i / 64.0, u = e % 2 ? e == 1 : t, v = e % 2 ? t : e == 2;
            double p[9], q[3], sum = 0;
            CHECK_OK(batten_surface_evaluate(surface, u, v, 1, p));
            CHECK_OK(batten_curve_evaluate(frame->sides[e].slope, t, 0, q));
            for (int x = 0; x < 3; x++) {
                const double slope = (e == 1 || e == 2 ? -1 : 1) * p[(e % 2 ? 3 : 6) + x];
                sum += (slope - q[x]) * (slope - q[x]);
            }
            misses[e] = fmax(misses[e], sqrt(sum));
        }
    }
}

TEST(twists_that_differ_go_by_the_policy_and_the_report_is_the_truth)
{
    test_random random = test_random_begin("policies");
    frame_of_surface frame;
    frame_surface(bumpy(&random, 3, 3, 1, 1), &frame);
    wring(&frame, BATTEN_EDGE_V0, 0.1);
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface *surface = NULL;
    options.order = 2;
    options.blending_u = options.blending_v = BATTEN_BLENDING_CUBIC;
    for (int policy = BATTEN_TWIST_KEEP_U; policy <= BATTEN_TWIST_GREGORY; policy++) {
        batten_surface_coons_report report;
        double misses[4];
        options.twist = (batten_twist_policy)policy;
        CHECK_OK(batten_surface_coons(frame.sides, &options, &report, &surface));
        CHECK_NEAR(report.twist_gap, 0.3, 1e-12);
        CHECK_INT(report.twist_corner, 1);
        slope_misses(surface, &frame, misses);
        const double most = 0.3 * 4 / 27;
        for (int e = 0; e < 4; e++) {
            const bool v = e == BATTEN_EDGE_V0, u = e == BATTEN_EDGE_U0;
            const double wanted = policy == BATTEN_TWIST_KEEP_U && v        ? most
                                  : policy == BATTEN_TWIST_KEEP_V && u      ? most
                                  : policy == BATTEN_TWIST_MEAN && (u || v) ? most / 2
                                                                            : 0;
            CHECK_NEAR(misses[e], wanted, wanted ? 1e-4 : 1e-12);
            CHECK_NEAR(misses[e], report.missed[e][1], 1e-12);
        }
        CHECK_INT(report.exact, policy != BATTEN_TWIST_GREGORY);
        batten_surface_unref(surface);
        surface = NULL;
    }
    options.twist = BATTEN_TWIST_REFUSE;
    CHECK_STATUS(batten_surface_coons(frame.sides, &options, NULL, &surface),
                 BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("corner 1, between edges v = 0 and u = 0: the twists differ by 0.3");
    frame_release(&frame);
}

TEST(gregorys_twists_leave_a_patch_that_is_smooth_inside_and_near_a_spline)
{
    test_random random = test_random_begin("gregory");
    frame_of_surface frame;
    frame_surface(bumpy(&random, 3, 3, 1, 1), &frame);
    wring(&frame, BATTEN_EDGE_V0, 0.1);
    batten_surface_coons_report report;
    batten_surface *coons =
        patch(frame.sides, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, &report);
    batten_surface *nurbs = NULL;
    double error = 0, a[30], b[30], c[30];
    const double h = 1e-5;
    CHECK_OK(batten_surface_evaluate(coons, 0.3 - h, 0.2, 2, a));
    CHECK_OK(batten_surface_evaluate(coons, 0.3 + h, 0.2, 2, b));
    CHECK_OK(batten_surface_evaluate(coons, 0.3, 0.2, 3, c));
    for (int n = 0; n < 6; n++)
        for (int x = 0; x < 3; x++) {
            const int l = n == 0 ? 0 : n < 3 ? n - 1 : n - 3, k = (n > 2 ? 2 : n > 0) - l;
            CHECK_NEAR((b[3 * n + x] - a[3 * n + x]) / (2 * h),
                       c[3 * BATTEN_SURFACE_DERIVATIVE(k + 1, l) + x], 1e-7);
        }
    CHECK_OK(batten_surface_to_nurbs(coons, 1e-4, &error, &nurbs));
    CHECK(error > 0 && error <= 1e-4);
    CHECK_NEAR(apart(coons, nurbs, 25, 0, 0, false), 0, 1.5e-4);
    batten_surface_unref(nurbs);
    batten_surface_unref(coons);
    frame_release(&frame);
}

/* ---- rational sides ---- */

/* A quarter of a circle in a plane z = h, radius r about (0, 0); from the x-axis to the y-axis.
 */
static batten_curve *quarter(double r, double h)
{
    const double points[] = {r, 0, h, r, r, h, 0, r, h}, weights[] = {1, sqrt(0.5), 1};
    const double knots[] = {0, 0, 0, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 3, points}, 2, weights, knots, &curve));
    return curve;
}

TEST(circles_that_share_their_weights_are_met_exactly_by_a_rational_surface)
{
    batten_curve *curves[4] = {quarter(2, 0), line(0, 2, 0, 0, 1, 1), quarter(1, 1),
                               line(2, 0, 0, 1, 0, 1)};
    batten_ribbon sides[4];
    for (int e = 0; e < 4; e++)
        sides[e] = (batten_ribbon){curves[e], NULL, NULL};
    for (int f = 0; f < 4; f++) {
        batten_surface_coons_report report;
        batten_surface *coons = patch(sides, 1, families[f], families[f], &report),
                       *nurbs = NULL;
        double error = 1;
        CHECK(report.exact);
        CHECK_OK(batten_surface_to_nurbs(coons, 0, &error, &nurbs));
        CHECK(error == 0);
        CHECK(batten_surface_is_rational(nurbs));
        CHECK_NEAR(apart(coons, nurbs, 30, 0, 0, false), 0, 1e-13);
        if (f == 0) {
            CHECK_INT(batten_surface_degree(nurbs, BATTEN_U), 3);
            for (int i = 0; i <= 20; i++) {
                double out[3];
                CHECK_OK(batten_surface_evaluate(nurbs, i / 20.0, 0, 0, out));
                CHECK_NEAR(hypot(out[0], out[1]), 2, 1e-14);
            }
        }
        batten_surface_unref(nurbs);
        batten_surface_unref(coons);
    }
    /* Another weight on one side: no common denominator is tried. */
    batten_curve *other = NULL;
    CHECK_OK(batten_curve_moebius(curves[2], 2, 0, 1, 1, &other));
    sides[2].curve = other;
    batten_surface_coons_report report;
    batten_surface *coons =
        patch(sides, 1, BATTEN_BLENDING_LINEAR, BATTEN_BLENDING_LINEAR, &report);
    batten_surface *nurbs = NULL;
    double error = 0;
    CHECK(!report.exact);
    CHECK_OK(batten_surface_to_nurbs(coons, 1e-5, &error, &nurbs));
    CHECK(error > 0 && error <= 1e-5);
    CHECK_NEAR(apart(coons, nurbs, 30, 0, 0, false), 0, 1.2e-5);
    batten_surface_unref(nurbs);
    batten_surface_unref(coons);
    batten_curve_unref(other);
    release(curves, 4);
}

/* ---- given functions ---- */

TEST(given_blending_functions_are_used_and_checked)
{
    batten_curve *curves[4], *functions[2] = {NULL, NULL};
    batten_ribbon sides[4];
    saddle(curves, sides);
    const double knots[] = {0, 0, 0.5, 1, 1}, f0[] = {1, 0.25, 0}, f1[] = {0, 0.75, 1};
    CHECK_OK(batten_curve_create((batten_points){1, 3, f0}, 1, NULL, knots, &functions[0]));
    CHECK_OK(batten_curve_create((batten_points){1, 3, f1}, 1, NULL, knots, &functions[1]));
    batten_surface_coons_options options = batten_surface_coons_defaults();
    batten_surface *coons = NULL, *nurbs = NULL;
    options.blending_u = BATTEN_BLENDING_GIVEN;
    CHECK_STATUS(batten_surface_coons(sides, &options, NULL, &coons), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("in u are missing");
    options.given_u = (const batten_curve *const *)functions;
    CHECK_OK(batten_surface_coons(sides, &options, NULL, &coons));
    CHECK_OK(batten_surface_to_nurbs(coons, 0, NULL, &nurbs));
    CHECK_NEAR(apart(coons, nurbs, 30, 0, 0, false), 0, 1e-15);
    const batten_curve *wrong[2] = {functions[1], functions[0]};
    options.given_u = wrong;
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_coons(sides, &options, NULL, &none), BATTEN_NOT_COMPATIBLE);
    CHECK_MESSAGE("F0: the value at 0 is 0, not 1");
    batten_surface_unref(nurbs);
    batten_surface_unref(coons);
    release(functions, 2);
    release(curves, 4);
}

/* ---- what should make no difference ---- */

TEST(maps_and_the_exchange_of_u_and_v_commute_with_the_construction)
{
    test_random random = test_random_begin("maps");
    frame_of_surface frame;
    frame_surface(bumpy(&random, 3, 4, 2, 1), &frame);
    const batten_affine map = {{{2, 0.3, 0}, {-0.5, 1, 0.2}, {0.1, 0, 3}}, {1, 4, -2}};
    const batten_affine linear = {{{2, 0.3, 0}, {-0.5, 1, 0.2}, {0.1, 0, 3}}, {0, 0, 0}};
    batten_ribbon moved[4], turned[4];
    static const int across[4] = {BATTEN_EDGE_U0, BATTEN_EDGE_V1, BATTEN_EDGE_U1,
                                  BATTEN_EDGE_V0};
    batten_curve *curves[4][2];
    for (int e = 0; e < 4; e++) {
        for (int k = 0; k < 2; k++) {
            curves[e][k] = NULL;
            CHECK_OK(
                batten_curve_transform(frame.curves[e][k], k ? &linear : &map, &curves[e][k]));
        }
        moved[e] = (batten_ribbon){curves[e][0], curves[e][1], NULL};
        turned[across[e]] = frame.sides[e];
    }
    batten_surface *coons =
        patch(frame.sides, 2, BATTEN_BLENDING_COONS, BATTEN_BLENDING_CUBIC, NULL);
    batten_surface *mapped =
        patch(moved, 2, BATTEN_BLENDING_COONS, BATTEN_BLENDING_CUBIC, NULL);
    batten_surface *exchanged =
        patch(turned, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_COONS, NULL);
    batten_surface *image = NULL;
    CHECK_OK(batten_surface_transform(coons, &map, &image));
    CHECK_NEAR(apart(mapped, image, 15, 0, 0, false), 0, 1e-13);
    for (int i = 0; i <= 10; i++)
        for (int j = 0; j <= 10; j++) {
            double p[3], q[3];
            CHECK_OK(batten_surface_evaluate(coons, i / 10.0, j / 10.0, 0, p));
            CHECK_OK(batten_surface_evaluate(exchanged, j / 10.0, i / 10.0, 0, q));
            for (int x = 0; x < 3; x++)
                CHECK_NEAR(p[x], q[x], 1e-14);
        }
    batten_surface_unref(image);
    batten_surface_unref(exchanged);
    batten_surface_unref(mapped);
    batten_surface_unref(coons);
    for (int e = 0; e < 4; e++)
        release(curves[e], 2);
    frame_release(&frame);
}

TEST(huge_and_tiny_patches_are_as_exact)
{
    for (int turn = 0; turn < 2; turn++) {
        const double s = turn ? 1e80 : 1e-80;
        batten_curve *curves[4] = {line(0, 0, 0, s, 0, 0), line(s, 0, 0, s, s, s),
                                   line(0, s, 0, s, s, s), line(0, 0, 0, 0, s, 0)};
        batten_ribbon sides[4];
        for (int e = 0; e < 4; e++)
            sides[e] = (batten_ribbon){curves[e], NULL, NULL};
        batten_surface *coons =
            patch(sides, 2, BATTEN_BLENDING_COONS, BATTEN_BLENDING_CUBIC, NULL);
        batten_surface *nurbs = NULL;
        CHECK_OK(batten_surface_to_nurbs(coons, 0, NULL, &nurbs));
        CHECK_NEAR(apart(coons, nurbs, 9, 0, 0, false) / s, 0, 1e-14);
        double out[3];
        CHECK_OK(batten_surface_evaluate(nurbs, 0.3, 0.7, 0, out));
        CHECK_NEAR(out[2] / s, 0.21, 1e-14);
        batten_surface_unref(nurbs);
        batten_surface_unref(coons);
        release(curves, 4);
    }
}

/* ---- knots that nearly coincide ---- */

static batten_curve *bent(double x0, double y0, double x1, double y1, double knot)
{
    const double points[] = {x0,
                             y0,
                             0,
                             (2 * x0 + x1) / 3,
                             (2 * y0 + y1) / 3,
                             0.3,
                             (x0 + 2 * x1) / 3,
                             (y0 + 2 * y1) / 3,
                             -0.1,
                             x1,
                             y1,
                             0};
    const double knots[] = {0, 0, 0, knot, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 4, points}, 2, NULL, knots, &curve));
    return curve;
}

TEST(K7_near_knots_leave_no_slivers_within_a_tolerance)
{
    const double third = 1 / 3.0;
    batten_curve *curves[4] = {bent(0, 0, 1, 0, third + 3e-10), bent(1, 0, 1, 1, 0.5),
                               bent(0, 1, 1, 1, third - 2e-10), bent(0, 0, 0, 1, 0.5 + 1e-10)};
    batten_ribbon sides[4];
    for (int e = 0; e < 4; e++)
        sides[e] = (batten_ribbon){curves[e], NULL, NULL};
    batten_surface *coons = patch(sides, 1, BATTEN_BLENDING_COONS, BATTEN_BLENDING_COONS, NULL);
    batten_surface *exact = NULL, *near = NULL;
    double error = 1;
    CHECK_OK(batten_surface_to_nurbs(coons, 0, &error, &exact));
    CHECK(error == 0);
    CHECK_INT(batten_surface_spans(exact, BATTEN_U, NULL), 6);
    CHECK_INT(batten_surface_spans(exact, BATTEN_V, NULL), 6);
    CHECK_OK(batten_surface_to_nurbs(coons, 1e-6, &error, &near));
    CHECK(error > 0 && error < 1e-9);
    CHECK_INT(batten_surface_spans(near, BATTEN_U, NULL), 4);
    CHECK_INT(batten_surface_spans(near, BATTEN_V, NULL), 5);
    CHECK_NEAR(apart(coons, near, 50, 0, 0, false), 0, error);
    CHECK_NEAR(apart(coons, exact, 50, 0, 0, false), 0, 1e-14);
    batten_surface_unref(near);
    batten_surface_unref(exact);
    batten_surface_unref(coons);
    release(curves, 4);
}

/* Patches of the second kind with the true slopes of a torus: their error falls with the fourth
 * power of their size. */
TEST(patches_with_the_slopes_of_a_torus_converge_with_the_fourth_power)
{
    const batten_frame frame = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
    batten_surface *torus = NULL;
    CHECK_OK(batten_surface_torus(&frame, 3, 1, &torus));
    const batten_interval u = batten_surface_domain(torus, BATTEN_U);
    const batten_interval v = batten_surface_domain(torus, BATTEN_V);
    double before = 0;
    for (int halved = 0; halved < 3; halved++) {
        const double part = 0.2 / (1 << halved);
        batten_surface *strip = NULL, *piece = NULL, *unit = NULL, *square = NULL;
        CHECK_OK(batten_surface_subrange(torus, BATTEN_U, u.a + 0.02 * (u.b - u.a),
                                         u.a + (0.02 + part) * (u.b - u.a), &strip));
        CHECK_OK(batten_surface_subrange(strip, BATTEN_V, v.a + 0.02 * (v.b - v.a),
                                         v.a + (0.02 + part) * (v.b - v.a), &piece));
        CHECK_OK(batten_surface_set_domain(piece, BATTEN_U, 0, 1, &unit));
        CHECK_OK(batten_surface_set_domain(unit, BATTEN_V, 0, 1, &square));
        frame_of_surface around;
        frame_surface(square, &around);
        batten_surface_coons_report report;
        batten_surface *coons =
            patch(around.sides, 2, BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_CUBIC, &report);
        CHECK_NEAR(report.twist_gap, 0, 1e-12);
        const double error = apart(coons, square, 15, 0, 0, false);
        if (halved > 0)
            CHECK(error < before / 14);
        before = error;
        batten_surface_unref(coons);
        frame_release(&around);
        batten_surface_unref(unit);
        batten_surface_unref(piece);
        batten_surface_unref(strip);
    }
    CHECK(before < 1e-4);
    batten_surface_unref(torus);
}

/* Three equal vertices in the middle of a side: a corner to the eye, C2 for the parameters. */
TEST(G5_a_side_with_a_triple_vertex_has_a_corner_with_a_normal)
{
    const double knots[] = {0, 0, 0, 0, 1 / 4.0, 2 / 4.0, 3 / 4.0, 1, 1, 1, 1};
    const double points[] = {0, 1,   0,   0.1, 1.2, 0,   0.5, 1.5, 0, 0.5, 1.5,
                             0, 0.5, 1.5, 0,   0.9, 1.2, 0,   1,   1, 0};
    batten_curve *curves[4] = {line(0, 0, 0, 1, 0, 0), line(1, 0, 0, 1, 1, 0), NULL,
                               line(0, 0, 0, 0, 1, 0)};
    CHECK_OK(batten_curve_create((batten_points){3, 7, points}, 3, NULL, knots, &curves[2]));
    batten_ribbon sides[4];
    for (int e = 0; e < 4; e++)
        sides[e] = (batten_ribbon){curves[e], NULL, NULL};
    batten_surface *coons = patch(sides, 1, BATTEN_BLENDING_COONS, BATTEN_BLENDING_COONS, NULL);
    batten_surface *nurbs = NULL;
    CHECK_OK(batten_surface_to_nurbs(coons, 0, NULL, &nurbs));
    double speed = 1;
    for (int i = 5; i <= 10; i++) {
        double out[9];
        CHECK_OK(batten_surface_evaluate(nurbs, 0.5, i / 10.0, 1, out));
        CHECK(hypot(out[3], out[4]) < speed);
        speed = hypot(out[3], out[4]);
    }
    CHECK_NEAR(speed, 0, 1e-14);
    batten_vec3 normal;
    bool is_limit = false;
    CHECK_OK(batten_surface_normal(nurbs, 0.5, 1, &is_limit, &normal));
    CHECK(is_limit);
    CHECK_NEAR(normal.z, 1, 1e-12);
    batten_surface_unref(nurbs);
    batten_surface_unref(coons);
    release(curves, 4);
}

/* Slopes of a surface of 1e80 fit its edges but for rounding, which is far above any tolerance.
 */
TEST(rounding_of_huge_numbers_is_no_gap)
{
    test_random random = test_random_begin("rounding");
    for (int turn = 0; turn < 2; turn++) {
        const double s = turn ? 1e80 : 1e-80;
        const batten_affine scale = batten_affine_scaling(s, s, s);
        batten_surface *small = bumpy(&random, 3, 3, 2, 2), *scaled = NULL, *nurbs = NULL;
        CHECK_OK(batten_surface_transform(small, &scale, &scaled));
        frame_of_surface frame;
        frame_surface(scaled, &frame);
        batten_surface_coons_report report;
        batten_surface *coons =
            patch(frame.sides, 3, BATTEN_BLENDING_QUINTIC, BATTEN_BLENDING_COONS, &report);
        CHECK(report.exact && report.twist_gap <= 1e-12 * s);
        CHECK_OK(batten_surface_to_nurbs(coons, 0, NULL, &nurbs));
        CHECK_NEAR(apart(coons, nurbs, 15, 0, 0, false) / s, 0, 1e-13);
        batten_surface_unref(nurbs);
        batten_surface_unref(coons);
        frame_release(&frame);
        batten_surface_unref(small);
    }
}
