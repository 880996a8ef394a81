#include <batten/interpolate.h>

#include "support/faults.h"
#include "support/test.h"

/* What functions the curves shall meet: value and derivatives of t^3 - 2 t^2 + 1. */
static double cubic(double t, int order)
{
    return order == 0   ? t * t * t - 2 * t * t + 1
           : order == 1 ? 3 * t * t - 4 * t
           : order == 2 ? 6 * t - 4
                        : 6;
}

static double value_of(const batten_curve *curve, double u, int order)
{
    double out[8];
    CHECK_OK(batten_curve_evaluate(curve, u, order, out));
    return out[order];
}

static batten_curve_interpolate_options given(const double *parameters)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = parameters;
    return options;
}

static void check_passes(const batten_curve *curve, int d, int count, const double *points,
                         const double *parameters)
{
    double size = 1;
    for (int i = 0; i < batten_curve_point_count(curve) * d; i++)
        size = fmax(size, fabs(batten_curve_points(curve)[i]));
    for (int i = 0; i < count; i++) {
        double point[3];
        CHECK_OK(batten_curve_evaluate(curve, parameters[i], 0, point));
        for (int k = 0; k < d; k++)
            CHECK_NEAR(point[k], points[i * d + k], 1e-13 * size);
    }
}

static void fill(test_random *random, int count, double *points)
{
    for (int i = 0; i < count; i++)
        points[i] = test_random_in(random, -1, 1) + (i % 3 == 0 ? i : 0);
}

TEST(a_spline_passes_its_points_and_is_smooth_between_whatever_its_ends)
{
    test_random random = test_random_begin("ends");
    for (int c = 0; c < test_cases(100); c++) {
        const int count = 3 + c / 10 % 7, d = 2 + c % 2;
        double points[30], u[10], left[12], right[12];
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = (batten_parametrization)(c % 5);
        options.start = (batten_end){(batten_end_kind)(c % 10), {0.5, 0.25, -0.5}};
        options.end = (batten_end){(batten_end_kind)((c / 10 + c) % 10), {0.3, 0.1, 0.2}};
        fill(&random, count * d, points);
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){d, count, points}, &options, u, &curve));
        check_passes(curve, d, count, points, u);
        for (int i = 1; i < count - 1; i++) {
            CHECK_OK(batten_curve_evaluate_side(curve, u[i], BATTEN_FROM_LEFT, 2, left));
            CHECK_OK(batten_curve_evaluate_side(curve, u[i], BATTEN_FROM_RIGHT, 2, right));
            for (int k = 0; k < 3 * d; k++)
                CHECK_NEAR(left[k], right[k], 1e-9 * (1 + fabs(left[k])));
        }
        batten_curve_unref(curve);
    }
}

TEST(cubics_are_reproduced_by_every_end_that_knows_them)
{
    const double t[] = {0, 0.5, 0.75, 2, 3.5, 4};
    const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_CLAMPED,
                                     BATTEN_END_SECOND, BATTEN_END_FAIR};
    double y[6], u[6];
    for (int i = 0; i < 6; i++)
        y[i] = cubic(t[i], 0);
    for (int c = 0; c < 16; c++) {
        batten_curve_interpolate_options options = given(t);
        const int order_a = kinds[c / 4] == BATTEN_END_SECOND ? 2 : 1;
        const int order_b = kinds[c % 4] == BATTEN_END_SECOND ? 2 : 1;
        options.start = (batten_end){kinds[c / 4], {cubic(0, order_a)}};
        options.end = (batten_end){kinds[c % 4], {cubic(4, order_b)}};
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){1, 6, y}, &options, u, &curve));
        for (int i = 0; i <= 40; i++)
            CHECK_NEAR(value_of(curve, i / 10.0, 0), cubic(i / 10.0, 0), 1e-13 * 33);
        CHECK_NEAR(value_of(curve, 0, 1), 0, 1e-12);
        CHECK_NEAR(value_of(curve, 4, 1), 32, 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(parabolas_are_reproduced_by_parabolic_and_bessel_ends)
{
    const double t[] = {0, 0.5, 0.75, 2, 3.5};
    const batten_end_kind kinds[] = {BATTEN_END_PARABOLIC, BATTEN_END_BESSEL, BATTEN_END_FAIR};
    double y[5];
    for (int i = 0; i < 5; i++)
        y[i] = t[i] * t[i] - 2 * t[i];
    for (int c = 0; c < 36; c++) {
        const int count = 2 + c / 9;
        batten_curve_interpolate_options options = given(t);
        options.start.kind = kinds[c % 3];
        options.end.kind = kinds[c / 3 % 3];
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &curve));
        CHECK_INT(batten_curve_degree(curve), count == 2 ? 1 : 3);
        for (int i = 0; i <= 20 && count > 2; i++) {
            const double at = t[count - 1] * i / 20;
            CHECK_NEAR(value_of(curve, at, 0), at * at - 2 * at, 1e-13 * 6);
        }
        batten_curve_unref(curve);
    }
}

/* The integral of s''^2, exact for a cubic spline. */
static double energy(const batten_curve *curve)
{
    double knots[64], sum = 0;
    const int count = batten_curve_spans(curve, knots);
    for (int i = 0; i + 1 < count; i++) {
        double a[3], b[3];
        CHECK_OK(batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_RIGHT, 2, a));
        CHECK_OK(batten_curve_evaluate_side(curve, knots[i + 1], BATTEN_FROM_LEFT, 2, b));
        sum += (knots[i + 1] - knots[i]) / 3 * (a[2] * a[2] + a[2] * b[2] + b[2] * b[2]);
    }
    return sum;
}

TEST(the_natural_spline_has_the_least_energy)
{
    test_random random = test_random_begin("energy");
    const double t[] = {0, 1, 1.5, 3, 4, 6};
    for (int c = 0; c < test_cases(40); c++) {
        double y[6];
        fill(&random, 6, y);
        batten_curve_interpolate_options options = given(t);
        options.start.kind = options.end.kind = BATTEN_END_NATURAL;
        batten_curve *natural = NULL, *other = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){1, 6, y}, &options, NULL, &natural));
        options.start = (batten_end){BATTEN_END_CLAMPED, {test_random_in(&random, -5, 5)}};
        options.end = (batten_end){BATTEN_END_SECOND, {test_random_in(&random, -5, 5)}};
        CHECK_OK(batten_curve_interpolate((batten_points){1, 6, y}, &options, NULL, &other));
        CHECK(energy(natural) <= energy(other) * (1 + 1e-12));
        CHECK_NEAR(value_of(natural, 0, 2), 0, 1e-11);
        CHECK_NEAR(value_of(natural, 6, 2), 0, 1e-11);
        batten_curve_unref(natural);
        batten_curve_unref(other);
    }
}

/* The forces of the ducks: jumps of the third derivative, at the ends its values. */
TEST(the_forces_on_a_natural_spline_are_in_equilibrium)
{
    const double t[] = {0, 1, 1.5, 3, 4}, y[] = {0, 2, 1, 1, 3};
    batten_curve_interpolate_options options = given(t);
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 5, y}, &options, NULL, &curve));
    double force = 0, moment = 0, work = 0, before = 0;
    for (int i = 0; i < 5; i++) {
        double out[4] = {0, 0, 0, 0};
        if (i < 4)
            CHECK_OK(batten_curve_evaluate(curve, t[i], 3, out));
        const double jump = out[3] - before;
        before = out[3];
        force += jump;
        moment += jump * t[i];
        work += jump * y[i];
    }
    CHECK_NEAR(force, 0, 1e-11);
    CHECK_NEAR(moment, 0, 1e-11);
    CHECK_NEAR(work, energy(curve), 1e-11);
    batten_curve_unref(curve);
}

TEST(clamped_splines_keep_the_bounds_of_hall_and_meyer)
{
    double t[21], y[21];
    for (int i = 0; i <= 20; i++) {
        t[i] = i / 20.0 + (i % 2 && i < 20 ? 0.01 : 0);
        y[i] = sin(3 * t[i]);
    }
    const double h = 0.06, bound[3] = {5.0 / 384 * h * h * h * h * 81, h * h * h / 24 * 81,
                                       3.0 / 8 * h * h * 81};
    batten_curve_interpolate_options options = given(t);
    options.start = (batten_end){BATTEN_END_CLAMPED, {3}};
    options.end = (batten_end){BATTEN_END_CLAMPED, {3 * cos(3)}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 21, y}, &options, NULL, &curve));
    for (int i = 0; i <= 1000; i++) {
        const double x = i / 1000.0;
        CHECK_NEAR(value_of(curve, x, 0), sin(3 * x), bound[0]);
        CHECK_NEAR(value_of(curve, x, 1), 3 * cos(3 * x), bound[1]);
        CHECK_NEAR(value_of(curve, x, 2), -9 * sin(3 * x), bound[2]);
    }
    batten_curve_unref(curve);
}

TEST(a_bump_dies_out_by_root_three_minus_two_for_each_interval)
{
    double y[41] = {0}, t[41];
    y[20] = 1;
    for (int i = 0; i < 41; i++)
        t[i] = i;
    batten_curve_interpolate_options options = given(t);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 41, y}, &options, NULL, &curve));
    for (int i = 22; i < 30; i++)
        CHECK_NEAR(value_of(curve, i + 1, 1) / value_of(curve, i, 1), sqrt(3) - 2, 1e-7);
    batten_curve_unref(curve);
}

TEST(fair_ends_find_the_slopes_of_a_sine)
{
    double y[21], t[21];
    for (int i = 0; i <= 20; i++)
        y[i] = sin(3 * (t[i] = i / 20.0));
    batten_curve_interpolate_options options = given(t);
    options.start.kind = options.end.kind = BATTEN_END_FAIR;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 21, y}, &options, NULL, &curve));
    CHECK_NEAR(value_of(curve, 0, 1), 3.00015, 5e-6);
    CHECK_NEAR(value_of(curve, 1, 1), -2.97031, 5e-6);
    batten_curve_unref(curve);
}

static double jumps(const batten_curve *curve, int count, const double *t)
{
    double sum = 0;
    for (int i = 1; i < count - 1; i++) {
        double left[4], right[4];
        CHECK_OK(batten_curve_evaluate_side(curve, t[i], BATTEN_FROM_LEFT, 3, left));
        CHECK_OK(batten_curve_evaluate_side(curve, t[i], BATTEN_FROM_RIGHT, 3, right));
        sum += (right[3] - left[3]) * (right[3] - left[3]);
    }
    return sum;
}

TEST(fair_ends_make_the_jumps_least)
{
    test_random random = test_random_begin("fair");
    const double t[] = {0, 1, 1.5, 3, 4, 6};
    for (int c = 0; c < test_cases(20); c++) {
        const int count = 3 + c % 4;
        double y[6];
        fill(&random, 6, y);
        batten_curve_interpolate_options options = given(t);
        options.start.kind = options.end.kind = BATTEN_END_FAIR;
        if (c % 2)
            options.start = (batten_end){BATTEN_END_CLAMPED, {1}};
        batten_curve *fair = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &fair));
        const double least = jumps(fair, count, t), a = value_of(fair, 0, 1),
                     b = value_of(fair, t[count - 1], 1);
        for (int s = 0; s < 4; s++) {
            batten_curve *other = NULL;
            options.start = (batten_end){BATTEN_END_CLAMPED,
                                         {a + (c % 2   ? 0
                                               : s < 2 ? 0.01
                                                       : -0.01)}};
            options.end = (batten_end){BATTEN_END_CLAMPED, {b + (s % 2 ? 0.01 : -0.01)}};
            CHECK_OK(
                batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &other));
            CHECK(least <= jumps(other, count, t) + 1e-12);
            batten_curve_unref(other);
        }
        batten_curve_unref(fair);
    }
}

/* Points of the circle of radius r. */
static void circle_points(double r, double from, double to, int count, bool closed,
                          double *points)
{
    for (int i = 0; i < count; i++) {
        const double angle = from + (to - from) * i / (closed ? count : count - 1);
        points[2 * i] = r * cos(angle);
        points[2 * i + 1] = r * sin(angle);
    }
}

static double radius_error(const batten_curve *curve, double r)
{
    const batten_interval domain = batten_curve_domain(curve);
    double worst = 0;
    for (int i = 0; i <= 2000; i++) {
        double point[2];
        CHECK_OK(batten_curve_evaluate(curve, domain.a + (domain.b - domain.a) * i / 2000, 0,
                                       point));
        worst = fmax(worst, fabs(hypot(point[0], point[1]) / r - 1));
    }
    return worst;
}

TEST(closed_splines_approach_the_circle_with_the_fourth_power)
{
    double error[3], points[256];
    for (int s = 0; s < 3; s++) {
        const int count = 16 << s;
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.parameters = BATTEN_CHORD;
        options.closed = true;
        circle_points(2, 0, 4 * acos(0), count, true, points);
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){2, count, points}, &options, NULL,
                                          &curve));
        error[s] = radius_error(curve, 2);
        batten_curve_unref(curve);
    }
    CHECK_NEAR(log2(error[0] / error[1]), 4, 0.1);
    CHECK_NEAR(log2(error[1] / error[2]), 4, 0.1);
}

TEST(ends_of_circles_and_of_given_curvature_know_the_circle)
{
    double points[2 * 33], error[2];
    for (int kind = 0; kind < 4; kind++) {
        for (int s = 0; s < 2; s++) {
            const int count = 17 + 16 * s;
            batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
            options.parameters = BATTEN_CHORD;
            circle_points(5, 0, 2, count, false, points);
            if (kind == 0)
                options.start.kind = options.end.kind = BATTEN_END_CIRCLE;
            if (kind == 1 || kind == 3)
                options.start = (batten_end){BATTEN_END_CURVATURE, {-0.2, 0}};
            if (kind == 1)
                options.end =
                    (batten_end){BATTEN_END_CURVATURE, {-0.2 * cos(2), -0.2 * sin(2)}};
            if (kind == 2)
                options.start = (batten_end){BATTEN_END_DIRECTION, {0, 7}};
            batten_curve *curve = NULL;
            CHECK_OK(batten_curve_interpolate((batten_points){2, count, points}, &options, NULL,
                                              &curve));
            error[s] = radius_error(curve, 5);
            double out[6];
            CHECK_OK(batten_curve_evaluate(curve, 0, 2, out));
            if (kind == 0 || kind == 2)
                CHECK_NEAR(atan2(out[3], out[2]), acos(0), 1e-14);
            if (kind == 2)
                CHECK_NEAR(hypot(out[2], out[3]), 1, 1e-12);
            if (kind == 1 || kind == 3)
                CHECK_NEAR((out[2] * out[5] - out[3] * out[4]) / pow(hypot(out[2], out[3]), 3),
                           0.2, 1e-5);
            batten_curve_unref(curve);
        }
        if (kind < 2)
            CHECK(error[0] / error[1] > 12);
    }
}

TEST(curvature_ends_give_the_curvature_across_the_tangent)
{
    const double points[] = {0, 0, 0, 1, 0, 0.5, 2, 1, 0, 4, 1, 1};
    const double wanted[3] = {0, 0, 0.5};
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.start = (batten_end){BATTEN_END_CURVATURE, {wanted[0], wanted[1], wanted[2]}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){3, 4, points}, &options, NULL, &curve));
    double out[9];
    CHECK_OK(batten_curve_evaluate(curve, 0, 2, out));
    const double *T = out + 3, *S = out + 6;
    const double square = T[0] * T[0] + T[1] * T[1] + T[2] * T[2], along = T[2] * 0.5 / square;
    CHECK_NEAR(S[0] * T[0] + S[1] * T[1] + S[2] * T[2], 0, 1e-12);
    for (int k = 0; k < 3; k++)
        CHECK_NEAR(S[k] / square, wanted[k] - along * T[k], 1e-12);
    batten_curve_unref(curve);
    options.start = (batten_end){BATTEN_END_CURVATURE, {0, 0, 1e308}};
    batten_curve *wild = NULL;
    CHECK_STATUS(batten_curve_interpolate((batten_points){3, 4, points}, &options, NULL, &wild),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK(wild == NULL);
}

TEST(periodic_curves_of_every_degree_close_smoothly_from_any_start)
{
    test_random random = test_random_begin("periodic");
    for (int c = 0; c < test_cases(90); c++) {
        const int degree = 1 + c % 9, count = 2 + c / 9 % 10, d = 2;
        double points[24], turned[24], u[12], v[12];
        circle_points(1, 0, 4 * acos(0), count, true, points);
        for (int i = 0; i < 2 * count; i++)
            points[i] += test_random_in(&random, -0.2, 0.2);
        for (int i = 0; i < 2 * count; i++)
            turned[i] = points[(i + 2) % (2 * count)];
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.degree = degree;
        options.closed = true;
        batten_curve *curve = NULL, *other = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){d, count, points}, &options, u, &curve));
        CHECK_OK(
            batten_curve_interpolate((batten_points){d, count, turned}, &options, v, &other));
        CHECK(batten_curve_is_periodic(curve) && batten_curve_degree(curve) == degree);
        check_passes(curve, d, count, points, u);
        const batten_interval domain = batten_curve_domain(curve);
        double left[26], right[26];
        CHECK_OK(
            batten_curve_evaluate_side(curve, domain.b, BATTEN_FROM_LEFT, degree - 1, left));
        CHECK_OK(
            batten_curve_evaluate_side(curve, domain.a, BATTEN_FROM_RIGHT, degree - 1, right));
        for (int k = 0; k < 2 * (degree < 3 ? degree : 3); k++)
            CHECK_NEAR(left[k], right[k], 1e-11 * (1 + fabs(left[k])));
        for (int i = 0; i < 20; i++) {
            const double at = i * 0.05 * (domain.b - domain.a);
            CHECK_OK(batten_curve_evaluate(curve, u[1] + at, 0, left));
            CHECK_OK(batten_curve_evaluate(other, at, 0, right));
            CHECK_NEAR(left[0], right[0], 1e-11);
            CHECK_NEAR(left[1], right[1], 1e-11);
        }
        batten_curve_unref(other);
        batten_curve_unref(curve);
    }
}

TEST(averaged_knots_reproduce_polynomials_of_their_degree)
{
    test_random random = test_random_begin("averaged");
    for (int c = 0; c < test_cases(60); c++) {
        const int degree = 1 + c % 12, count = degree + 1 + c % 7;
        double t[20], y[20];
        for (int i = 0; i < count; i++) {
            t[i] = i == 0 ? 0 : t[i - 1] + test_random_in(&random, 0.05, 0.2);
            y[i] = pow(t[i], degree);
        }
        batten_curve_interpolate_options options = given(t);
        options.knots_at_data = false;
        options.degree = degree;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){1, count, y}, &options, NULL, &curve));
        CHECK_INT(batten_curve_degree(curve), degree);
        CHECK_INT(batten_curve_point_count(curve), count);
        for (int i = 0; i <= 50; i++) {
            const double at = t[count - 1] * i / 50;
            CHECK_NEAR(value_of(curve, at, 0), pow(at, degree), 1e-11 * (1 + y[count - 1]));
        }
        batten_curve_unref(curve);
    }
}

TEST(derivatives_at_any_data_points_are_met)
{
    test_random random = test_random_begin("derivatives");
    for (int c = 0; c < test_cases(60); c++) {
        const int count = 6, degree = 3 + c % 3;
        double points[18], u[6];
        batten_derivative wanted[12];
        int wanted_count = 0;
        for (int i = 0; i < count; i++)
            for (int order = 1; order <= 1 + (degree > 3 && c % 2); order++)
                if (c % 4 == 0 || test_random_unit(&random) < 0.5) {
                    if (order == 2 &&
                        (wanted_count == 0 || wanted[wanted_count - 1].index != i))
                        continue;
                    wanted[wanted_count] = (batten_derivative){i, order, {0, 0, 0}};
                    fill(&random, 3, wanted[wanted_count++].value);
                }
        fill(&random, 18, points);
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        options.degree = degree;
        options.knots_at_data = false;
        options.derivatives = wanted;
        options.derivative_count = wanted_count;
        batten_curve *curve = NULL;
        CHECK_OK(
            batten_curve_interpolate((batten_points){3, count, points}, &options, u, &curve));
        CHECK_INT(batten_curve_point_count(curve), count + wanted_count);
        check_passes(curve, 3, count, points, u);
        for (int i = 0; i < wanted_count; i++) {
            double out[9];
            CHECK_OK(batten_curve_evaluate(curve, u[wanted[i].index], wanted[i].order, out));
            for (int k = 0; k < 3; k++)
                CHECK_NEAR(out[3 * wanted[i].order + k], wanted[i].value[k], 1e-8);
        }
        batten_curve_unref(curve);
    }
}

TEST(odd_degrees_stand_on_knots_at_the_data)
{
    double t[12], y[12];
    for (int i = 0; i < 12; i++) {
        t[i] = i * 0.1 + 0.02 * (i % 3);
        y[i] = pow(t[i], 5) - t[i];
    }
    const double T = t[11];
    const batten_derivative ends[] = {{0, 2, {0}}, {11, 1, {5 * pow(T, 4) - 1}}, {0, 1, {-1}}};
    for (int given_count = 0; given_count <= 3; given_count++) {
        batten_curve_interpolate_options options = given(t);
        options.degree = 5;
        options.derivatives = ends;
        options.derivative_count = given_count;
        batten_curve *curve = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){1, 12, y}, &options, NULL, &curve));
        CHECK_INT(batten_curve_spans(curve, NULL), 12 - 4 + given_count);
        for (int i = 0; i <= 50; i++)
            CHECK_NEAR(value_of(curve, T * i / 50, 0), pow(T * i / 50, 5) - T * i / 50, 1e-12);
        batten_curve_unref(curve);
    }
}

TEST(G2_few_points_give_a_line_a_parabola_and_lower_degrees)
{
    const double points[] = {0, 0, 1, 2, 3, 1, 4, 4, 5, 0};
    for (int count = 2; count <= 5; count++)
        for (int averaged = 0; averaged < 2; averaged++)
            for (int degree = 1; degree <= 7; degree++) {
                batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
                options.degree = degree;
                options.knots_at_data = !averaged;
                double u[5];
                batten_curve *curve = NULL;
                if (!averaged && degree % 2 == 0) {
                    CHECK_STATUS(batten_curve_interpolate((batten_points){2, count, points},
                                                          &options, u, &curve),
                                 BATTEN_BAD_DEGREE);
                    continue;
                }
                CHECK_OK(batten_curve_interpolate((batten_points){2, count, points}, &options,
                                                  u, &curve));
                CHECK_INT(batten_curve_degree(curve), degree < count ? degree : count - 1);
                check_passes(curve, 2, count, points, u);
                batten_curve_unref(curve);
            }
    batten_curve *line = NULL, *hermite = NULL;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 2, points}, &options, NULL, &line));
    CHECK_INT(batten_curve_degree(line), 1);
    options.start = options.end = (batten_end){BATTEN_END_CLAMPED, {1, 0}};
    CHECK_OK(batten_curve_interpolate((batten_points){2, 2, points}, &options, NULL, &hermite));
    CHECK_INT(batten_curve_degree(hermite), 3);
    batten_curve_unref(line);
    batten_curve_unref(hermite);
    CHECK_STATUS(batten_curve_interpolate((batten_points){2, 1, points}, NULL, NULL, &line),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("there is 1 point, and at least 2");
}

TEST(G1_coincident_points_are_named)
{
    const double points[] = {0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_interpolate((batten_points){2, 3, points}, NULL, NULL, &curve),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("points 2 and 3");
    CHECK(curve == NULL);
}

TEST(G9_schoenberg_and_whitney_speak_with_numbers)
{
    /* Four conditions at one point of a parabola's system leave others without a knot. */
    const double t[] = {0, 1, 2, 3, 4, 5}, y[] = {0, 1, 0, 1, 0, 1};
    const batten_derivative wanted[] = {{2, 1, {0}}, {2, 2, {0}}};
    batten_curve_interpolate_options options = given(t);
    options.degree = 2;
    options.knots_at_data = false;
    options.derivatives = wanted;
    options.derivative_count = 2;
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_interpolate((batten_points){1, 6, y}, &options, NULL, &curve),
                 BATTEN_SINGULAR_SYSTEM);
    CHECK(curve == NULL);
}

TEST(G10_reversed_points_give_the_reversed_curve)
{
    test_random random = test_random_begin("reversed");
    for (int c = 0; c < test_cases(20); c++) {
        double points[16], backward[16], u[8], v[8];
        fill(&random, 16, points);
        for (int i = 0; i < 8; i++)
            for (int k = 0; k < 2; k++)
                backward[2 * i + k] = points[2 * (7 - i) + k];
        batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
        const batten_end_kind kinds[] = {BATTEN_END_NOT_A_KNOT, BATTEN_END_NATURAL,
                                         BATTEN_END_PARABOLIC,  BATTEN_END_BESSEL,
                                         BATTEN_END_CIRCLE,     BATTEN_END_FAIR};
        options.start.kind = kinds[c % 6];
        options.end.kind = kinds[c / 6 % 6];
        options.parameters = (batten_parametrization)(c % 5);
        batten_curve *curve = NULL, *other = NULL;
        CHECK_OK(batten_curve_interpolate((batten_points){2, 8, points}, &options, u, &curve));
        const batten_end kept = options.start;
        options.start = options.end;
        options.end = kept;
        CHECK_OK(
            batten_curve_interpolate((batten_points){2, 8, backward}, &options, v, &other));
        for (int i = 0; i <= 20; i++) {
            double a[2], b[2];
            CHECK_OK(batten_curve_evaluate(curve, u[7] * i / 20, 0, a));
            CHECK_OK(batten_curve_evaluate(other, v[7] * (20 - i) / 20, 0, b));
            CHECK_NEAR(a[0], b[0], 1e-11);
            CHECK_NEAR(a[1], b[1], 1e-11);
        }
        batten_curve_unref(other);
        batten_curve_unref(curve);
    }
}

TEST(N1_what_is_not_finite_is_refused)
{
    const double points[] = {0, 0, 1, 1, 2, 0}, bad[] = {0, 0, INFINITY, 1}, t[] = {0, NAN, 1};
    batten_curve *curve = NULL;
    CHECK_STATUS(batten_curve_interpolate((batten_points){2, 2, bad}, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("coordinate 1 of point 2 is inf");
    batten_curve_interpolate_options options = given(t);
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 3, points}, &options, NULL, &curve),
        BATTEN_NOT_FINITE);
    options = batten_curve_interpolate_defaults();
    options.end = (batten_end){BATTEN_END_CLAMPED, {0, NAN}};
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 3, points}, &options, NULL, &curve),
        BATTEN_NOT_FINITE);
    const batten_derivative derivative = {0, 1, {NAN}};
    options = batten_curve_interpolate_defaults();
    options.derivatives = &derivative;
    options.derivative_count = 1;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 3, points}, &options, NULL, &curve),
        BATTEN_NOT_FINITE);
}

TEST(N2_size_does_not_matter_and_what_overflows_is_refused)
{
    const double unit[] = {0, 0, 1, 2, 3, 1, 4, 4, 5, 0};
    const double scales[] = {1e-9, 1e9, 1e-300, 1e300};
    double expected[2], out[2], u[5];
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 5, unit}, NULL, u, &curve));
    CHECK_OK(batten_curve_evaluate(curve, u[4] * 0.3, 0, expected));
    batten_curve_unref(curve);
    for (int s = 0; s < COUNT(scales); s++) {
        double points[10];
        for (int i = 0; i < 10; i++)
            points[i] = unit[i] * scales[s];
        CHECK_OK(batten_curve_interpolate((batten_points){2, 5, points}, NULL, u, &curve));
        CHECK_OK(batten_curve_evaluate(curve, u[4] * 0.3, 0, out));
        CHECK_NEAR(out[0] / scales[s], expected[0], 1e-13);
        CHECK_NEAR(out[1] / scales[s], expected[1], 1e-13);
        batten_curve_unref(curve);
    }
    const double huge[] = {1.7e308, -1.7e308, 1.7e308, -1.7e308, 1.7e308},
                 t[] = {0, 1, 2, 3, 4};
    batten_curve_interpolate_options options = given(t);
    batten_curve *none = NULL;
    CHECK_STATUS(batten_curve_interpolate((batten_points){1, 5, huge}, &options, NULL, &none),
                 BATTEN_OVERFLOW);
    CHECK(none == NULL);
}

TEST(requests_that_make_no_sense_are_refused)
{
    const double points[] = {0, 0, 1, 1, 2, 0, 3, 1}, t[] = {0, 2, 1, 3};
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options = given(t);
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_NOT_INCREASING);
    CHECK_MESSAGE("parameter 3 is 1, not above the one before, 2");
    options = given(NULL);
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options = batten_curve_interpolate_defaults();
    const int degrees[] = {-1, 0, 26};
    for (int i = 0; i < 3; i++) {
        options.degree = degrees[i];
        CHECK_STATUS(
            batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
            BATTEN_BAD_DEGREE);
    }
    options = batten_curve_interpolate_defaults();
    options.degree = 5;
    options.start.kind = BATTEN_END_FAIR;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options = batten_curve_interpolate_defaults();
    options.start.kind = BATTEN_END_DIRECTION;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.start.kind = BATTEN_END_CURVATURE;
    CHECK_STATUS(batten_curve_interpolate((batten_points){1, 4, t}, &options, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK(curve == NULL);
}

TEST(derivatives_that_make_no_sense_are_refused)
{
    const double points[] = {0, 0, 1, 1, 2, 0, 3, 1};
    const batten_derivative wrong[] = {{4, 1, {0}}, {-1, 1, {0}}, {1, 0, {0}}, {1, 4, {0}},
                                       {1, 1, {0}}, {0, 1, {0}},  {0, 1, {0}}};
    batten_curve *curve = NULL;
    batten_curve_interpolate_options options;
    for (int i = 0; i < 5; i++) {
        options = batten_curve_interpolate_defaults();
        options.derivatives = wrong + i;
        options.derivative_count = 1;
        CHECK_STATUS(
            batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
            BATTEN_BAD_ARGUMENT);
    }
    options.knots_at_data = false;
    options.derivatives = wrong + 5;
    options.derivative_count = 2;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("derivative 1 at point 1 is given twice");
    options.knots_at_data = true;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the start has 2 conditions, and degree 3 takes 1");
    options.closed = true;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    options.derivative_count = -1;
    CHECK_STATUS(
        batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve),
        BATTEN_BAD_ARGUMENT);
    CHECK(curve == NULL);
}

TEST(circle_ends_fall_back_where_there_is_no_circle)
{
    const double points[] = {0, 0, 1, 1, 0, 0, 2, 0}, twice[] = {0, 0, 1, 1, 1, 1, 2, 0};
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.start.kind = options.end.kind = BATTEN_END_CIRCLE;
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 4, points}, &options, NULL, &curve));
    batten_curve_unref(curve);
    options.parameters = BATTEN_UNIFORM;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 4, twice}, &options, NULL, &curve));
    batten_curve_unref(curve);
    CHECK_OK(batten_curve_interpolate((batten_points){2, 2, points}, &options, NULL, &curve));
    CHECK_INT(batten_curve_degree(curve), 1);
    batten_curve_unref(curve);
}

TEST(curvatures_that_rounding_keeps_from_the_last_digits_are_reached)
{
    const double points[6] = {8, 4, 6, -9, 7, 8}, wanted[2][2] = {{-1.5, -1.7}, {0.6, 1}};
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_UNIFORM;
    options.start = (batten_end){BATTEN_END_CURVATURE, {wanted[0][0], wanted[0][1]}};
    options.end = (batten_end){BATTEN_END_CURVATURE, {wanted[1][0], wanted[1][1]}};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 3, points}, &options, NULL, &curve));
    const batten_interval domain = batten_curve_domain(curve);
    for (int e = 0; e < 2; e++) {
        double at[3][2];
        CHECK_OK(batten_curve_evaluate(curve, e ? domain.b : domain.a, 2, at[0]));
        const double speed = hypot(at[1][0], at[1][1]);
        const double turn =
            (at[1][0] * at[2][1] - at[1][1] * at[2][0]) / (speed * speed * speed);
        const double across = (at[1][0] * wanted[e][1] - at[1][1] * wanted[e][0]) / speed;
        CHECK_NEAR(turn, across, 1e-8);
    }
    batten_curve_unref(curve);
}

TEST(interpolation_reports_every_lack_of_memory)
{
    static const double points[] = {0, 0, 1, 2, 3, 1, 4, -1, 6, 0, 7, 2, 5, 5};
    for (int degree = 1; degree <= 5; degree += 2)
        for (int closed = 0; closed < 2; closed++) {
            batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
            double parameters[8];
            batten_curve *curve = NULL;
            options.degree = degree;
            options.closed = closed;
            CHECK_EACH_ALLOCATION(batten_curve_interpolate((batten_points){2, 7, points},
                                                           &options, parameters, &curve));
            batten_curve_unref(curve);
        }
}
