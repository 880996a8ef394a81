#include <batten/scattered.h>

#include "support/faults.h"
#include "support/test.h"

#include <stdlib.h>

static double franke(double x, double y)
{
    return 0.75 * exp(-(pow(9 * x - 2, 2) + pow(9 * y - 2, 2)) / 4) +
           0.75 * exp(-pow(9 * x + 1, 2) / 49 - (9 * y + 1) / 10) +
           0.5 * exp(-(pow(9 * x - 7, 2) + pow(9 * y - 3, 2)) / 4) -
           0.2 * exp(-pow(9 * x - 4, 2) - pow(9 * y - 7, 2));
}

static double plane(double x, double y)
{
    return 3 + 2 * x - 5 * y;
}

static double cubic(double x, double y)
{
    return x * x * x - 2 * x * y * y + y * y + 1;
}

/* Random places in the unit square and the function there. */
static void scatter(int count, double (*f)(double, double), double *uv, double *z)
{
    test_random random = test_random_begin("scattered data");
    for (int i = 0; i < count; i++) {
        for (int k = 0; k < 2; k++)
            uv[2 * i + k] = test_random_unit(&random);
        z[i] = f(uv[2 * i], uv[2 * i + 1]);
    }
}

static double value(const batten_surface *s, double u, double v)
{
    double out;
    CHECK_OK(batten_surface_evaluate(s, u, v, 0, &out));
    return out;
}

enum { MANY = 2000 };
static double uv[2 * MANY], z[MANY];

/* ---- penalised ---- */

TEST(polynomials_of_the_degree_are_found_without_a_penalty)
{
    for (int degree = 3; degree <= 5; degree++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        scatter(600, cubic, uv, z);
        options.degree_u = degree;
        options.degree_v = 8 - degree;
        options.spans_u = options.spans_v = 5;
        options.by = BATTEN_SMOOTH_BY_LAMBDA;
        if (degree == 5)
            options.degree_v = 4;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, 600, z}, &options, NULL,
                                          &report, &s));
        CHECK(report.error < 1e-10 && report.lambda == 0 && report.iterations == 0);
        CHECK_NEAR(value(s, 0.37, 0.61), cubic(0.37, 0.61), 1e-10);
        batten_surface_unref(s);
    }
}

/* How the squares and the energy change with a control point: 0 at the least; the energy by
 * second differences of the surface on a fine grid is not exact, so lambda is 0. */
TEST(residuals_are_square_to_the_basis_and_weights_count)
{
    enum { N = 300 };
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL, *moved = NULL;
    double weights[N];
    scatter(N, franke, uv, z);
    for (int i = 0; i < N; i++)
        weights[i] = 1 + i % 4;
    options.weights = weights;
    options.spans_u = 4;
    options.spans_v = 3;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    CHECK_OK(batten_surface_scattered(uv, (batten_points){1, N, z}, &options, NULL, NULL, &s));
    for (int i = 0; i < 7; i += 2)
        for (int j = 0; j < 6; j += 2) {
            const double up = batten_surface_points(s)[i * 6 + j] + 1;
            double sum = 0;
            CHECK_OK(batten_surface_with_point(s, i, j, &up, &moved));
            for (int t = 0; t < N; t++) {
                const double here = value(s, uv[2 * t], uv[2 * t + 1]);
                sum += weights[t] * (here - z[t]) *
                       (value(moved, uv[2 * t], uv[2 * t + 1]) - here);
            }
            CHECK_NEAR(sum, 0, 1e-10);
            batten_surface_unref(moved);
        }
    batten_surface_unref(s);
}

TEST(an_infinite_penalty_leaves_the_plane)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter(500, plane, uv, z);
    for (int i = 0; i < 500; i++)
        z[i] += 0.1 * sin(1000.0 * i);
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    options.amount = HUGE_VAL;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 500, z}, &options, NULL, &report, &s));
    CHECK_NEAR(report.freedom, 3, 2); /* an estimate from eight probes */
    for (int k = 1; k < 10; k++)
        CHECK_NEAR(value(s, 0.1 * k, 0.5), plane(0.1 * k, 0.5), 0.03);
    CHECK_NEAR(value(s, 0.2, 0.2) + value(s, 0.6, 0.8), 2 * value(s, 0.4, 0.5), 1e-6);
    batten_surface_unref(s);
}

TEST(G9_where_data_leave_the_surface_open_a_small_penalty_decides)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter(400, plane, uv, z);
    for (int i = 0; i < 400; i++)
        uv[2 * i] *= uv[2 * i] < 0.5 ? 0.5 : 1; /* a gap from 0.25 to 0.5 */
    for (int i = 0; i < 400; i++)
        z[i] = plane(uv[2 * i], uv[2 * i + 1]);
    options.spans_u = options.spans_v = 40;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 400, z}, &options, NULL, &report, &s));
    CHECK(report.lambda > 0 && report.empty > 400);
    CHECK_NEAR(value(s, 0.4, 0.5), plane(0.4, 0.5), 1e-6);
    batten_surface_unref(s);
}

TEST(validation_and_the_target_see_the_noise)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    double truth = 0, before = 0;
    test_random random = test_random_begin("noise");
    scatter(MANY, franke, uv, z);
    for (int i = 0; i < MANY; i++)
        z[i] += test_random_in(&random, -0.1, 0.1);
    for (int c = 0; c < 2; c++) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.by = c ? BATTEN_SMOOTH_BY_RMS : BATTEN_SMOOTH_BY_VALIDATION;
        options.amount = 0.06;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, MANY, z}, &options, NULL,
                                          &report, &s));
        if (c)
            CHECK_NEAR(report.rms, 0.06, 1e-7);
        CHECK_NEAR(report.rms, 0.1 / sqrt(3), 0.004);
        truth = before = 0;
        for (int i = 0; i < MANY; i++) {
            const double w = franke(uv[2 * i], uv[2 * i + 1]);
            truth += pow(value(s, uv[2 * i], uv[2 * i + 1]) - w, 2);
            before += pow(z[i] - w, 2);
        }
        CHECK(truth < before / (c ? 5 : 20)); /* the target is above the noise */
        batten_surface_unref(s);
    }
}

TEST(outliers_draw_a_robust_fit_less)
{
    double off[2] = {0, 0};
    for (int huber = 0; huber < 2; huber++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        test_random random = test_random_begin("outliers");
        scatter(1000, franke, uv, z);
        for (int i = 0; i < 1000; i++)
            z[i] += test_random_in(&random, -0.01, 0.01) + (i % 20 == 0 ? 2 : 0);
        options.huber = huber;
        options.spans_u = options.spans_v = 10;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, 1000, z}, &options, NULL,
                                          &report, &s));
        for (int i = 0; i < 1000; i++)
            off[huber] +=
                fabs(value(s, uv[2 * i], uv[2 * i + 1]) - franke(uv[2 * i], uv[2 * i + 1]));
        CHECK((report.reweightings > 0) == (huber == 1));
        batten_surface_unref(s);
    }
    CHECK(off[1] < off[0] / 5);
}

TEST(conjugate_gradients_give_what_the_band_gives)
{
    /* More control points than a band is made for; data of a surface that both know. */
    enum { N = 8200 };
    double *at = test_array(2 * N, sizeof *at), *h = test_array(N, sizeof *h);
    test_random random = test_random_begin("gradients");
    for (int i = 0; i < N; i++) {
        at[2 * i] = test_random_unit(&random);
        at[2 * i + 1] = test_random_unit(&random);
        h[i] = franke(at[2 * i], at[2 * i + 1]);
    }
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s[2] = {NULL, NULL};
    batten_surface_fit_report report;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    options.amount = 1e-6;
    options.spans_u = options.spans_v = 125;
    CHECK_OK(
        batten_surface_scattered(at, (batten_points){1, N, h}, &options, NULL, &report, &s[0]));
    CHECK(report.iterations > 0);
    options.spans_u = options.spans_v = 60;
    CHECK_OK(
        batten_surface_scattered(at, (batten_points){1, N, h}, &options, NULL, &report, &s[1]));
    CHECK_INT(report.iterations, 0);
    options.spans_u = options.spans_v = 140;
    batten_surface *none = NULL;
    CHECK_STATUS(
        batten_surface_scattered(at, (batten_points){1, N / 2, h}, &options, NULL, NULL, &none),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("20449 control points for 4100 data");
    for (int k = 1; k < 50; k++)
        CHECK_NEAR(value(s[0], 0.02 * k, 0.5), value(s[1], 0.02 * k, 0.5), 1e-5);
    batten_surface_unref(s[0]);
    batten_surface_unref(s[1]);
}

TEST(swapped_parameters_give_the_swapped_surface)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL, *t = NULL;
    double vu[2 * 500];
    scatter(500, franke, uv, z);
    for (int i = 0; i < 1000; i++)
        vu[i] = uv[i ^ 1];
    options.spans_u = 7;
    options.spans_v = 12;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    options.amount = 1e-6;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 500, z}, &options, NULL, NULL, &s));
    options.spans_u = 12;
    options.spans_v = 7;
    CHECK_OK(
        batten_surface_scattered(vu, (batten_points){1, 500, z}, &options, NULL, NULL, &t));
    for (int k = 1; k < 20; k++)
        CHECK_NEAR(value(s, 0.05 * k, 0.3), value(t, 0.3, 0.05 * k), 1e-10);
    batten_surface_unref(s);
    batten_surface_unref(t);
}

/* ---- within a tolerance ---- */

TEST(frankes_function_is_met_within_the_tolerance)
{
    const double tolerances[] = {1e-2, 1e-3, 1e-4};
    int last = 0;
    scatter(MANY, franke, uv, z);
    for (int c = 0; c < 3; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.tolerance = tolerances[c];
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, MANY, z}, &options, NULL,
                                          &report, &s));
        double most = 0;
        for (int i = 0; i < MANY; i++)
            most = fmax(most, fabs(value(s, uv[2 * i], uv[2 * i + 1]) - z[i]));
        CHECK_NEAR(most, report.error, 1e-12);
        CHECK(report.error <= tolerances[c] && report.points_u * report.points_v > last);
        CHECK_NEAR(report.where[2], z[report.worst], 0);
        last = report.points_u * report.points_v;
        batten_surface_unref(s);
    }
    CHECK(last < MANY);
}

static double ridge(double x, double y)
{
    return exp(-pow(20 * (x - 0.4), 2)) + 0.1 * y;
}

TEST(knots_go_across_the_direction_that_needs_them)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter(MANY, ridge, uv, z);
    options.tolerance = 1e-3;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, MANY, z}, &options, NULL, &report, &s));
    CHECK(report.points_u > 2 * report.points_v);
    batten_surface_unref(s);
}

TEST(a_tolerance_that_noise_forbids_is_not_claimed)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    scatter(200, franke, uv, z);
    for (int i = 0; i < 200; i++)
        z[i] += i % 2 ? 0.1 : -0.1;
    for (int i = 0; i < 100; i++) { /* two values at one place */
        uv[4 * i] = uv[4 * i + 2];
        uv[4 * i + 1] = uv[4 * i + 3];
    }
    options.tolerance = 1e-3;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 200, z}, &options, NULL, NULL, &s),
        BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("is missed by");
    CHECK(s == NULL);
}

/* ---- where no data are ---- */

/* A paraboloid over the unit disc, off by up to `noise`: the corners of the square are empty.
 */
static void scatter_disc(int count, double noise)
{
    test_random random = test_random_begin("disc");
    for (int i = 0; i < count; i++) {
        double x, y;
        do {
            x = test_random_in(&random, -1, 1);
            y = test_random_in(&random, -1, 1);
        } while (x * x + y * y > 1);
        uv[2 * i] = x;
        uv[2 * i + 1] = y;
        z[i] = 0.1 * (x * x + y * y) + test_random_in(&random, -noise, noise);
    }
}

TEST(a_tolerance_near_the_noise_leaves_empty_corners_calm)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter_disc(400, 0.0025);
    options.tolerance = 0.002;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 400, z}, &options, NULL, &report, &s));
    CHECK(report.error <= 0.002 && report.empty > 0);
    CHECK(report.outside_share < 4);
    for (int i = 0; i < 4; i++) /* 0.2, were the paraboloid to go on */
        CHECK_NEAR(value(s, i % 2 ? 0.95 : -0.95, i / 2 ? 0.95 : -0.95), 0.15, 0.25);
    batten_surface_unref(s);
}

/* Only a corner of some cells is held: without the penalty the rest swings far away. */
TEST(open_places_are_held_and_the_data_keep_their_fit)
{
    double rms[2], share[2];
    for (int c = 0; c < 2; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        scatter_disc(1500, 0);
        for (int i = 0; i < 1500; i++) /* more than nine control points a side can follow */
            z[i] += 0.02 * sin(9 * uv[2 * i]) * sin(9 * uv[2 * i + 1]);
        options.spans_u = options.spans_v = 9;
        options.by = c ? BATTEN_SMOOTH_BY_VALIDATION : BATTEN_SMOOTH_BY_LAMBDA;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, 1500, z}, &options, NULL,
                                          &report, &s));
        rms[c] = report.rms;
        share[c] = report.outside_share;
        const double *at = report.outside_at;
        CHECK(at[0] * at[0] + at[1] * at[1] > 1);
        CHECK_NEAR(at[2], value(s, at[0], at[1]), 1e-9 * fabs(at[2]));
        batten_surface_unref(s);
    }
    CHECK(share[0] > 5 && share[1] < 1.5);
    CHECK(rms[1] < 1.1 * rms[0]);
}

TEST(a_target_that_cannot_be_met_lets_nothing_go)
{
    double share[2];
    for (int c = 0; c < 2; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        scatter_disc(400, 0.002);
        options.spans_u = options.spans_v = 8;
        options.by = c ? BATTEN_SMOOTH_BY_RMS : BATTEN_SMOOTH_BY_LAMBDA;
        options.amount = c ? 1e-5 : 0;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, 400, z}, &options, NULL,
                                          &report, &s));
        CHECK(report.rms > 1e-4);
        share[c] = report.outside_share;
        batten_surface_unref(s);
    }
    CHECK(share[1] < 3 && share[0] > 4 * share[1]);
}

TEST(a_surface_within_the_box_of_its_data_is_said_to_be)
{
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter(MANY, plane, uv, z);
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, MANY, z}, NULL, NULL, &report, &s));
    CHECK(report.outside_share < 0.1);
    batten_surface_unref(s);
}

/* ---- multilevel ---- */

TEST(one_point_of_a_lattice_is_met_exactly)
{
    const double at[] = {0, 0, 1, 1, 0.3, 0.6}, h[] = {0, 0, 7};
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    options.method = BATTEN_SCATTERED_MULTILEVEL;
    options.spans_u = options.spans_v = 20;
    options.levels = 1;
    CHECK_OK(batten_surface_scattered(at, (batten_points){1, 3, h}, &options, NULL, NULL, &s));
    CHECK_NEAR(value(s, 0.3, 0.6), 7, 1e-14);
    CHECK_NEAR(value(s, 0, 0), 0, 1e-14);
    batten_surface_unref(s);
}

TEST(every_level_leaves_less_of_frankes_function)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    double last = HUGE_VAL;
    scatter(500, franke, uv, z);
    options.method = BATTEN_SCATTERED_MULTILEVEL;
    for (int levels = 1; levels <= 8; levels++) {
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.levels = levels;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, 500, z}, &options, NULL,
                                          &report, &s));
        CHECK(report.rms < last);
        CHECK_INT(report.points_u, (1 << (levels - 1)) + 3);
        last = report.rms;
        batten_surface_unref(s);
    }
    CHECK(last < 1e-3);
    options.tolerance = 0.02;
    options.levels = 0;
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 500, z}, &options, NULL, &report, &s));
    CHECK(report.error <= 0.02 && report.rounds < 9);
    batten_surface_unref(s);
    options.levels = 2;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 500, z}, &options, NULL, &report, &s),
        BATTEN_TOLERANCE_NOT_MET);
}

TEST(levels_end_when_the_data_are_few_and_the_report_says_so)
{
    const int counts[] = {52, 400, MANY};
    for (int c = 0; c < 3; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        scatter(counts[c], franke, uv, z);
        options.method = BATTEN_SCATTERED_MULTILEVEL;
        CHECK_OK(batten_surface_scattered(uv, (batten_points){1, counts[c], z}, &options, NULL,
                                          &report, &s));
        CHECK_INT(report.end, BATTEN_LEVELS_FEW);
        CHECK(report.points_u * report.points_v <= 8 * counts[c] && report.rms < 0.03);
        batten_surface_unref(s);
    }
}

TEST(levels_end_when_they_bring_nothing)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    scatter(1000, plane, uv, z);
    for (int i = 0; i < 500; i++) { /* two values at one place stay apart */
        uv[4 * i + 2] = uv[4 * i];
        uv[4 * i + 3] = uv[4 * i + 1];
        z[2 * i] = 1;
        z[2 * i + 1] = -1;
    }
    options.method = BATTEN_SCATTERED_MULTILEVEL;
    CHECK_OK(
        batten_surface_scattered(uv, (batten_points){1, 1000, z}, &options, NULL, &report, &s));
    CHECK_INT(report.end, BATTEN_LEVELS_NO_GAIN);
    CHECK_INT(report.rounds, 3);
    batten_surface_unref(s);
}

/* ---- clouds ---- */

TEST(a_closed_body_is_said_to_lie_in_layers)
{
    enum { N = 2000 };
    double *points = test_array(3 * N, sizeof *points);
    for (int c = 0; c < 2; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        test_random random = test_random_begin("ellipsoid");
        for (int i = 0; i < N; i++) {
            const double h = test_random_in(&random, -1, 1), a = test_random_in(&random, -4, 4);
            const double r = sqrt(1 - h * h);
            const double p[] = {3 * r * cos(a), 2 * r * sin(a), c ? h : fabs(h)};
            memcpy(points + 3 * i, p, sizeof p);
        }
        options.spans_u = options.spans_v = 6;
        options.corrections = 1;
        CHECK_OK(batten_surface_cloud(&(batten_cloud){{3, N, points}, NULL}, &options, NULL,
                                      NULL, &report, &s));
        if (c)
            CHECK(report.layered > 0.3 && report.layers_apart > 0.5);
        else
            CHECK(report.layered < 0.02);
        batten_surface_unref(s);
    }
}

static void cylinder_points(int count, double *points, double *at)
{
    test_random random = test_random_begin("cylinder");
    for (int i = 0; i < count; i++) {
        const double a = test_random_in(&random, -1, 1), h = test_random_in(&random, 0, 3);
        const double p[] = {2 * sin(a), h, 2 * cos(a)};
        memcpy(points + 3 * i, p, sizeof p);
        at[2 * i] = 2 * a;
        at[2 * i + 1] = h;
    }
}

TEST(corrected_parameters_are_as_good_as_true_ones)
{
    enum { N = 1500 };
    double *points = test_array(3 * N, sizeof *points), *at = test_array(2 * N, sizeof *at),
           *found = test_array(2 * N, sizeof *found);
    cylinder_points(N, points, at);
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL, *t = NULL;
    batten_surface_fit_report with_true, cloud;
    options.spans_u = 4;
    options.spans_v = 2;
    options.by = BATTEN_SMOOTH_BY_LAMBDA;
    CHECK_OK(batten_surface_scattered(at, (batten_points){3, N, points}, &options, NULL,
                                      &with_true, &s));
    CHECK_OK(batten_surface_cloud(&(batten_cloud){{3, N, points}, NULL}, &options, NULL, found,
                                  &cloud, &t));
    /* Steps to the feet move parameters along the surface alone, and slowly. */
    CHECK(cloud.rms <= 1.5 * with_true.rms && cloud.corrections > 0);
    for (int i = 0; i < N; i += 50) { /* what is reported is what is there */
        double p[9];
        CHECK_OK(batten_surface_evaluate(t, found[2 * i], found[2 * i + 1], 1, p));
        const double r[] = {p[0] - points[3 * i], p[1] - points[3 * i + 1],
                            p[2] - points[3 * i + 2]};
        CHECK(sqrt(r[0] * r[0] + r[1] * r[1] + r[2] * r[2]) <= cloud.error * (1 + 1e-9));
    }
    batten_surface_unref(s);
    batten_surface_unref(t);
}

TEST(clouds_are_fitted_over_corners_and_within_a_tolerance)
{
    enum { N = 1200 };
    double *points = test_array(3 * N, sizeof *points), *at = test_array(2 * N, sizeof *at);
    const double x = 2 * sin(1), c = 2 * cos(1);
    const double corners[] = {-x, 0, c, x, 0, c, -x, 3, c, x, 3, c};
    batten_surface *base = NULL, *s = NULL;
    batten_surface_fit_report report;
    cylinder_points(N, points, at);
    CHECK_EACH_ALLOCATION(batten_surface_from_corners(corners, &base));
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    options.tolerance = 1e-4;
    CHECK_OK(batten_surface_cloud(&(batten_cloud){{3, N, points}, base}, &options, NULL, NULL,
                                  &report, &s));
    CHECK(report.error <= 1e-4 && report.points_u > report.points_v);
    CHECK_NEAR(batten_surface_domain(s, BATTEN_U).b, 1, 0);
    batten_surface_unref(s);
    batten_surface_unref(base);
}

/* Whatever the principal axes of a square are, its domain has no corners beyond it. */
TEST(a_square_cloud_has_a_square_domain)
{
    enum { N = 3000 };
    double *points = test_array(3 * N, sizeof *points);
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    test_random random = test_random_begin("square");
    for (int i = 0; i < N; i++) {
        const double x = test_random_in(&random, -1, 1), y = test_random_in(&random, -1, 1);
        /* a little more along a diagonal, and the square turned by half a radian */
        const double p[] = {x * cos(0.5) - y * sin(0.5), x * sin(0.5) + y * cos(0.5),
                            0.3 * sin(2 * x) + 0.1 * y};
        const bool other = x * y < 0 && i % 8 == 0;
        for (int c = 0; c < 3; c++)
            points[3 * i + c] = other ? 0.5 * p[c] : p[c];
    }
    options.spans_u = options.spans_v = 8;
    CHECK_OK(batten_surface_cloud(&(batten_cloud){{3, N, points}, NULL}, &options, NULL, NULL,
                                  &report, &s));
    CHECK(report.outside_share < 0.05 && report.empty == 0);
    batten_surface_unref(s);
}

TEST(G2_points_on_a_line_have_no_plane)
{
    double points[30];
    batten_surface *s = NULL;
    for (int i = 0; i < 10; i++)
        for (int k = 0; k < 3; k++)
            points[3 * i + k] = i * (k + 1);
    CHECK_STATUS(batten_surface_cloud(&(batten_cloud){{3, 10, points}, NULL}, NULL, NULL, NULL,
                                      NULL, &s),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("lie on a line");
}

/* ---- graphs ---- */

TEST(a_graph_has_its_parameters_as_coordinates)
{
    batten_surface *s = NULL, *graph = NULL;
    scatter(300, franke, uv, z);
    CHECK_EACH_ALLOCATION(
        batten_surface_scattered(uv, (batten_points){1, 300, z}, NULL, NULL, NULL, &s));
    CHECK_EACH_ALLOCATION(batten_surface_from_function(s, &graph));
    const batten_interval u = batten_surface_domain(s, BATTEN_U);
    for (int k = 0; k <= 10; k++) {
        const double x = u.a + (u.b - u.a) * k / 10;
        double p[3];
        CHECK_OK(batten_surface_evaluate(graph, x, 0.5, 0, p));
        CHECK_NEAR(p[0], x, 1e-15);
        CHECK_NEAR(p[1], 0.5, 1e-15);
        CHECK_NEAR(p[2], value(s, x, 0.5), 1e-14);
    }
    batten_surface *none = NULL;
    CHECK_STATUS(batten_surface_from_function(graph, &none), BATTEN_BAD_ARGUMENT);
    batten_surface_unref(graph);
    batten_surface_unref(s);
}

/* ---- published data ---- */

static int read_table(const char *name, int columns, double *numbers, int most)
{
    FILE *file = fopen(test_data(name), "r");
    char line[200];
    int rows = 0;
    CHECK(file && fgets(line, sizeof line, file));
    while (rows < most && fgets(line, sizeof line, file)) {
        char *at = line;
        for (int k = 0; k < columns; k++) {
            numbers[rows * columns + k] = strtod(at, &at);
            at += *at == ',';
        }
        rows++;
    }
    fclose(file);
    return rows;
}

TEST(the_eighty_data_of_dierckx_are_smoothed_to_their_noise)
{
    double table[240], at[160], h[80];
    CHECK_INT(read_table("scattered/dierckx_surfit80.csv", 3, table, 80), 80);
    for (int i = 0; i < 80; i++) {
        at[2 * i] = table[3 * i];
        at[2 * i + 1] = table[3 * i + 1];
        h[i] = table[3 * i + 2];
    }
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    batten_surface_fit_report report;
    /* s = 80 with the weights 1 / 0.010257 of the published test: rms = 0.010257. */
    options.by = BATTEN_SMOOTH_BY_RMS;
    options.amount = 0.010257;
    CHECK_OK(
        batten_surface_scattered(at, (batten_points){1, 80, h}, &options, NULL, &report, &s));
    CHECK_NEAR(report.rms, 0.010257, 1e-9);
    /* The data are exp(-x^2 - y^2) and noise. */
    double off = 0;
    for (int i = 0; i < 80; i++) {
        const double x = at[2 * i], y = at[2 * i + 1];
        off = fmax(off, fabs(value(s, x, y) - exp(-x * x - y * y)));
    }
    CHECK(off < 0.05);
    batten_surface_unref(s);
}

TEST(measured_points_of_akima_are_met_within_a_tolerance)
{
    double table[150], at[100], h[50];
    CHECK_INT(read_table("scattered/akima526.csv", 3, table, 50), 50);
    for (int i = 0; i < 50; i++) {
        at[2 * i] = table[3 * i];
        at[2 * i + 1] = table[3 * i + 1];
        h[i] = table[3 * i + 2];
    }
    for (int c = 0; c < 2; c++) {
        batten_surface_scattered_options options = batten_surface_scattered_defaults();
        batten_surface *s = NULL;
        batten_surface_fit_report report;
        options.method = c ? BATTEN_SCATTERED_MULTILEVEL : BATTEN_SCATTERED_PENALISED;
        options.tolerance = 0.01;
        if (!c) { /* as many control points as data allow, by the target */
            options.tolerance = 0;
            options.by = BATTEN_SMOOTH_BY_RMS;
            options.amount = 0.005;
            options.spans_u = options.spans_v = 12;
        }
        CHECK_OK(batten_surface_scattered(at, (batten_points){1, 50, h}, &options, NULL,
                                          &report, &s));
        CHECK(report.error <= (c ? 0.01 : 0.05));
        batten_surface_unref(s);
    }
}

/* ---- bad input ---- */

TEST(N1_bad_scattered_data_are_refused)
{
    batten_surface_scattered_options options = batten_surface_scattered_defaults();
    batten_surface *s = NULL;
    scatter(100, franke, uv, z);
    CHECK_STATUS(batten_surface_scattered(uv, (batten_points){1, 2, z}, NULL, NULL, NULL, &s),
                 BATTEN_TOO_FEW_POINTS);
    uv[41] = NAN;
    CHECK_STATUS(batten_surface_scattered(uv, (batten_points){1, 100, z}, NULL, NULL, NULL, &s),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("parameter v of datum 21");
    scatter(100, franke, uv, z);
    z[7] = HUGE_VAL;
    CHECK_STATUS(batten_surface_scattered(uv, (batten_points){1, 100, z}, NULL, NULL, NULL, &s),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("datum 8");
    scatter(100, franke, uv, z);
    options.domain[0][1] = options.domain[1][1] = 0.5;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 100, z}, &options, NULL, NULL, &s),
        BATTEN_OUT_OF_DOMAIN);
    options = batten_surface_scattered_defaults();
    options.degree_u = 1;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 100, z}, &options, NULL, NULL, &s),
        BATTEN_BAD_DEGREE);
    options = batten_surface_scattered_defaults();
    options.spans_u = options.spans_v = 100000;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 100, z}, &options, NULL, NULL, &s),
        BATTEN_TOO_LARGE);
    options = batten_surface_scattered_defaults();
    options.tolerance = -1;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 100, z}, &options, NULL, NULL, &s),
        BATTEN_BAD_ARGUMENT);
    options = batten_surface_scattered_defaults();
    double weights[100] = {0};
    options.weights = weights;
    CHECK_STATUS(
        batten_surface_scattered(uv, (batten_points){1, 100, z}, &options, NULL, NULL, &s),
        BATTEN_BAD_WEIGHT);
    for (int i = 0; i < 100; i++)
        uv[2 * i] = 3;
    CHECK_STATUS(batten_surface_scattered(uv, (batten_points){1, 100, z}, NULL, NULL, NULL, &s),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("along u, which encloses no area");
    CHECK(s == NULL);
}

TEST(N2_scattered_data_of_any_size_are_fitted)
{
    const double sizes[][2] = {{1, 1e80}, {1, 1e-80}, {1e60, 1}, {1e-60, 1}};
    scatter(200, franke, uv, z);
    for (int c = 0; c < 4; c++)
        for (int method = 0; method < 2; method++) {
            batten_surface_scattered_options options = batten_surface_scattered_defaults();
            batten_surface *s = NULL;
            batten_surface_fit_report report;
            double at[400], h[200];
            for (int i = 0; i < 400; i++)
                at[i] = uv[i] * sizes[c][0];
            for (int i = 0; i < 200; i++)
                h[i] = z[i] * sizes[c][1];
            options.method = (batten_scattered_method)method;
            CHECK_OK(batten_surface_scattered(at, (batten_points){1, 200, h}, &options, NULL,
                                              &report, &s));
            CHECK(report.rms < 0.02 * sizes[c][1]);
            batten_surface_unref(s);
        }
}
