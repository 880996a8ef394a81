/* Curves under deformations: near their images, which are those of their points. */
#include "support/faults.h"
#include "support/lattices.h"

#include <batten/measure.h>
#include <batten/standard.h>

static batten_curve *random_curve(test_random *random, int degree, bool rational)
{
    double points[3 * 9], weights[9], knots[9 + 6];
    for (int i = 0; i < 9; i++) {
        points[3 * i] = test_random_in(random, -1, 2);
        points[3 * i + 1] = test_random_unit(random);
        points[3 * i + 2] = test_random_in(random, -2, 2);
        weights[i] = test_random_in(random, 0.5, 2);
    }
    for (int i = 0; i < 9 + degree + 1; i++)
        knots[i] = fmin(fmax(i - degree, 0), 9 - degree);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){3, 9, points}, degree,
                                 rational ? weights : NULL, knots, &curve));
    return curve;
}

/* The largest distance from the images of points at equal parameters. */
static double distance_from_image(const batten_curve *curve, const batten_deformation *d,
                                  const batten_curve *made)
{
    const batten_interval all = batten_curve_domain(curve);
    double most = 0;
    for (int i = 0; i <= 1000; i++) {
        const double u = i < 1000 ? all.a + (all.b - all.a) * i / 1000 : all.b;
        double p[3], q[3];
        CHECK_OK(batten_curve_evaluate(curve, u, 0, p));
        CHECK_OK(batten_deformation_apply(d, (batten_points){3, 1, p}, p));
        CHECK_OK(batten_curve_evaluate(made, u, 0, q));
        most = fmax(most, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
    }
    return most;
}

TEST(curves_are_within_the_tolerance_of_their_images_and_the_error_is_the_largest_distance)
{
    test_random random = test_random_begin("curves");
    static const double tolerances[] = {1e-2, 1e-5, 1e-9};
    for (int trial = 0; trial < 18; trial++) {
        const double tolerance = tolerances[trial % 3];
        const batten_lattice l = trial % 2 ? test_lattice(4, 3) : test_lattice(6, 2);
        double points[3 * LATTICE_MOST], error = -1;
        batten_deformation *d = NULL;
        batten_curve *curve = random_curve(&random, 1 + trial % 5, trial % 4 == 3),
                     *made = NULL;
        test_lattice_shaken(&random, &l, 0.03, 0, points);
        CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
        CHECK_OK(batten_curve_deform(curve, d, tolerance, &error, &made));
        const double truth = distance_from_image(curve, d, made);
        CHECK(error >= 0 && error <= tolerance);
        CHECK(truth <= error + 1e-14);
        const batten_interval a = batten_curve_domain(curve), b = batten_curve_domain(made);
        CHECK(a.a == b.a && a.b == b.b);
        batten_curve_unref(made);
        batten_curve_unref(curve);
        batten_deformation_unref(d);
    }
}

TEST(corners_of_a_polyline_stay_corners_and_its_image_is_not_straight)
{
    static const double corners[] = {-1, 0, -2, 0, 1, 0, 2, 0.5, 2}, knots[] = {0, 0, 1, 2, 2};
    batten_lattice l;
    double points[3 * 27], error = 0;
    batten_curve *line = NULL, *made = NULL;
    batten_deformation *d = NULL;
    test_lattice_sheared(0.05, &l, points);
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_curve_create((batten_points){3, 3, corners}, 1, NULL, knots, &line));
    CHECK_EACH_ALLOCATION(batten_curve_deform(line, d, 1e-6, &error, &made));
    CHECK(error < 1e-14); /* a parabola: one quintic for each side, exact */
    CHECK_INT(batten_curve_spans(made, NULL), 3);
    double left[6], right[6];
    CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_LEFT, 1, left));
    CHECK_OK(batten_curve_evaluate_side(made, 1, BATTEN_FROM_RIGHT, 1, right));
    CHECK(fabs(left[4] - right[4]) > 0.1);
    CHECK(distance_from_image(line, d, made) < 1e-14);
    batten_curve_unref(made);
    batten_curve_unref(line);
    batten_deformation_unref(d);
}

TEST(a_curve_through_a_side_of_the_box_stays_outside_as_it_is)
{
    static const double ends[] = {0, 0.5, 0, 4, 0.5, 0.1}, knots[] = {0, 0, 1, 1};
    const batten_lattice l = test_lattice(6, 3);
    test_random random = test_random_begin("through");
    double points[3 * LATTICE_MOST], p[3];
    batten_deformation_options options = batten_deformation_defaults();
    batten_deformation *d = NULL;
    batten_curve *line = NULL, *made = NULL;
    options.join = BATTEN_BOX_JOIN_TANGENT;
    test_lattice_shaken(&random, &l, 0.1, 2, points);
    CHECK_OK(batten_deformation_create(&l, points, &options, NULL, &d));
    CHECK_OK(batten_curve_create((batten_points){3, 2, ends}, 1, NULL, knots, &line));
    CHECK_OK(batten_curve_deform(line, d, 1e-7, NULL, &made));
    CHECK(distance_from_image(line, d, made) <= 1e-7);
    CHECK_OK(batten_curve_evaluate(made, 0.75, 0, p));
    CHECK_NEAR(p[0], 3, 1e-7);
    CHECK_NEAR(p[1], 0.5, 1e-7);
    batten_curve_unref(made);
    batten_curve_unref(line);
    batten_deformation_unref(d);
}

TEST(curves_that_cannot_be_deformed_are_refused)
{
    static const double flat[] = {0, 0, 1, 1}, out[] = {0, 0.5, 0, 1, 3, 0},
                        knots[] = {0, 0, 1, 1};
    const batten_lattice l = test_lattice(4, 3);
    double points[3 * 64];
    batten_deformation *d = NULL;
    batten_curve *plane = NULL, *outside = NULL, *none = NULL;
    CHECK_OK(batten_lattice_home(&l, points));
    CHECK_OK(batten_deformation_create(&l, points, NULL, NULL, &d));
    CHECK_OK(batten_curve_create((batten_points){2, 2, flat}, 1, NULL, knots, &plane));
    CHECK_OK(batten_curve_create((batten_points){3, 2, out}, 1, NULL, knots, &outside));
    CHECK_STATUS(batten_curve_deform(plane, d, 1e-3, NULL, &none), BATTEN_UNSUPPORTED);
    CHECK_MESSAGE("a curve in 2 dimensions");
    CHECK_STATUS(batten_curve_deform(outside, d, 1e-3, NULL, &none), BATTEN_OUT_OF_DOMAIN);
    CHECK_MESSAGE("the curve reaches 2 out of the box where y is largest");
    CHECK_STATUS(batten_curve_deform(outside, d, 0, NULL, &none), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_deform(outside, d, 1e-18, NULL, &none), BATTEN_TOLERANCE_NOT_MET);
    CHECK(none == NULL);
    batten_curve_unref(plane);
    batten_curve_unref(outside);
    batten_deformation_unref(d);
}
