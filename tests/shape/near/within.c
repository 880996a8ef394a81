#include <batten/approximate.h>
#include <batten/nearest.h>

#include "shape/published.h"

static const double PI = 3.14159265358979323846;

/* Fit, and measure by other means: at the parameters that are told, and to the nearest place.
 * Returns the number of control points. */
static int check_within(int d, int n, const double *q,
                        const batten_curve_within_options *options)
{
    batten_curve_within_report report;
    batten_curve *curve = NULL;
    batten_deviation deviation;
    double *u = test_array((size_t)n, sizeof *u);
    CHECK_OK(batten_curve_within((batten_points){d, n, q}, options, u, &report, &curve));
    CHECK_INT(batten_curve_degree(curve), options->degree);
    CHECK_INT(batten_curve_dimension(curve), d);
    for (int i = 0; i < n; i++) {
        double at[3], sum = 0;
        CHECK_OK(batten_curve_evaluate(curve, u[i], 0, at));
        for (int k = 0; k < d; k++)
            sum += (at[k] - q[i * d + k]) * (at[k] - q[i * d + k]);
        CHECK(sqrt(sum) <= options->tolerance);
        CHECK(sqrt(sum) <= report.error * (1 + 1e-12));
    }
    if (d > 1) {
        CHECK_OK(batten_curve_deviation(curve,
                                        (batten_points){batten_curve_dimension(curve), n, q}, u,
                                        NULL, NULL, &deviation));
        CHECK(deviation.max <= report.error * (1 + 1e-9));
    }
    const int points = batten_curve_point_count(curve),
              wrapped = batten_curve_is_periodic(curve) ? options->degree : 0;
    CHECK_INT(report.points, points - wrapped);
    batten_curve_unref(curve);
    return points - wrapped;
}

TEST(no_point_of_any_row_is_farther_than_the_tolerance_by_any_method)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(48); c++) {
        const int d = 2 + c % 2, n = 4 + test_random_int(&random, 0, 60);
        batten_curve_within_options options = batten_curve_within_defaults();
        double q[3 * 64];
        for (int i = 0; i < n; i++)
            for (int k = 0; k < d; k++)
                q[i * d + k] = 4 * sin(i * 0.13 * (k + 1) + k) + 0.1 * i * (k == 0) +
                               test_random_in(&random, -0.02, 0.02);
        options.method = (batten_within_method)(c % 4);
        options.closed = c / 4 % 2;
        options.degree = options.method == BATTEN_WITHIN_BEZIER ? 3 : 1 + c / 8 % 6;
        options.parameters = (batten_parametrization)(c / 3 % 3);
        int before = 1000;
        for (options.tolerance = 0.01; options.tolerance < 1; options.tolerance *= 10) {
            const int points = check_within(d, n, q, &options);
            CHECK(points <= before);
            before = points;
        }
        CHECK(before < 4 * n);
    }
}

TEST(data_of_a_polynomial_take_no_inner_knot)
{
    for (int p = 1; p <= 5; p++) {
        double t[40], f[40];
        batten_curve_within_options options = batten_curve_within_defaults();
        for (int i = 0; i < 40; i++) {
            t[i] = i / 10.0;
            f[i] = pow(t[i] - 1, p) - t[i];
        }
        options.parameters = BATTEN_GIVEN;
        options.given = t;
        options.degree = p;
        options.tolerance = 1e-10;
        CHECK_INT(check_within(1, 40, f, &options), p + 1);
    }
}

TEST(points_of_a_line_take_as_few_control_points_as_the_degree_allows)
{
    double q[3 * 30];
    batten_curve_within_options options = batten_curve_within_defaults();
    options.tolerance = 1e-9;
    for (int i = 0; i < 30; i++)
        for (int k = 0; k < 3; k++)
            q[3 * i + k] = (k + 1) * i * i;
    for (int m = 0; m < 4; m++) {
        options.method = (batten_within_method)m;
        CHECK_INT(check_within(3, 30, q, &options), 4);
    }
}

/* The error of cubics falls with the fourth power of their spans. */
TEST(a_sixteenth_of_the_tolerance_takes_twice_the_spans)
{
    double t[800], f[800], spans[3];
    batten_curve_within_options options = batten_curve_within_defaults();
    for (int i = 0; i < 800; i++) {
        t[i] = i / 20.0;
        f[i] = sin(t[i]);
    }
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    for (int i = 0; i < 3; i++) {
        options.tolerance = 1e-2 / pow(16, i);
        spans[i] = check_within(1, 800, f, &options) - 3;
    }
    for (int i = 1; i < 3; i++)
        CHECK_NEAR(spans[i] / spans[i - 1], 2, 0.35);
}

TEST(a_circle_is_closed_smoothly_with_few_control_points)
{
    double q[2 * 100];
    batten_curve_within_options options = batten_curve_within_defaults();
    for (int i = 0; i < 100; i++) {
        q[2 * i] = cos(2 * PI * i / 100);
        q[2 * i + 1] = sin(2 * PI * i / 100);
    }
    options.closed = true;
    options.tolerance = 1e-3;
    /* Twelve equal spans of a cubic are 1.5e-5 off, eight 1.6e-4, six 7e-4. */
    CHECK(check_within(2, 100, q, &options) <= 8);
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_within((batten_points){2, 100, q}, &options, NULL, NULL, &curve));
    CHECK(batten_curve_is_periodic(curve));
    batten_curve_unref(curve);
}

/* A square with rounded data: corners found by their angle, and the same when they are named.
 */
TEST(corners_are_kept_exactly_open_and_closed)
{
    static const double corners[5][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}};
    static const int named[] = {0, 20, 40, 60};
    double q[2 * 81];
    for (int i = 0; i < 81; i++)
        for (int k = 0; k < 2; k++) {
            const double *a = corners[i / 20], *b = corners[i < 80 ? i / 20 + 1 : 4];
            q[2 * i + k] = a[k] + i % 20 / 20.0 * (b[k] - a[k]);
        }
    for (int c = 0; c < 12; c++) {
        batten_curve_within_options options = batten_curve_within_defaults();
        batten_curve_within_report report;
        batten_curve *curve = NULL;
        double u[81];
        options.tolerance = 1e-3;
        options.closed = c % 2;
        options.method = (batten_within_method)(c / 2 % 3 + c / 6);
        if (c < 6) {
            options.corner = 0.7;
        } else {
            options.corner_count = 4;
            options.corners = named;
        }
        const int n = 81 - options.closed;
        CHECK_OK(batten_curve_within((batten_points){2, n, q}, &options, u, &report, &curve));
        CHECK_INT(report.corners, options.closed ? 4 : 3);
        CHECK_INT(report.points, 13); /* four straight cubics */
        for (int i = 0; i < 80; i += 20) {
            double at[2];
            CHECK_OK(batten_curve_evaluate(curve, u[i], 0, at));
            CHECK_NEAR(hypot(at[0] - q[2 * i], at[1] - q[2 * i + 1]), 0, 1e-14);
        }
        batten_curve_unref(curve);
    }
}

TEST(the_curve_does_not_swing_between_data)
{
    /* A step: through all points a polynomial would swing. */
    double t[24], f[24];
    batten_curve_within_options options = batten_curve_within_defaults();
    for (int i = 0; i < 24; i++) {
        t[i] = i;
        f[i] = i < 12 ? 0 : 1;
    }
    options.parameters = BATTEN_GIVEN;
    options.given = t;
    options.tolerance = 1e-6;
    for (int m = 0; m < 3; m++) {
        batten_curve_within_report report;
        batten_curve *curve = NULL;
        options.method = (batten_within_method)m;
        CHECK_OK(
            batten_curve_within((batten_points){1, 24, f}, &options, NULL, &report, &curve));
        CHECK(report.apart < 0.6);
        for (int i = 0; i <= 2300; i++) {
            double at;
            CHECK_OK(batten_curve_evaluate(curve, i / 100.0, 0, &at));
            CHECK(at > -0.6 && at < 1.6);
        }
        batten_curve_unref(curve);
    }
}

TEST(G2_two_and_three_points_and_coincident_ones)
{
    const double two[] = {0, 0, 1, 2}, three[] = {0, 0, 1, 2, 3, 0},
                 doubled[] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 0, 2, 0}, one[] = {1, 1, 1, 1, 1, 1};
    batten_curve_within_options options = batten_curve_within_defaults();
    options.tolerance = 1e-6;
    for (int m = 0; m < 4; m++) {
        options.method = (batten_within_method)m;
        CHECK_INT(check_within(2, 2, two, &options), 4);
        CHECK(check_within(2, 3, three, &options) <= 6);
        CHECK(check_within(2, 6, doubled, &options) <= 6);
        batten_curve *curve = NULL;
        CHECK_STATUS(
            batten_curve_within((batten_points){2, 3, one}, &options, NULL, NULL, &curve),
            BATTEN_COINCIDENT);
        CHECK_STATUS(
            batten_curve_within((batten_points){2, 1, one}, &options, NULL, NULL, &curve),
            BATTEN_TOO_FEW_POINTS);
    }
}

TEST(N1_N6_K9_bad_input_is_refused)
{
    static const int falling[] = {2, 1}, far[] = {9};
    const double q[] = {0, 1, 1, 1, 2, 0, 3, 1}, bad[] = {0, 0, 1, NAN, 2, 0, 3, 1},
                 same[] = {0, 0, 1, 2};
    batten_curve *curve = NULL;
    batten_curve_within_options options = batten_curve_within_defaults(), with;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the tolerance is 0");
    options.tolerance = NAN;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    options.tolerance = 0.1;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, bad}, &options, NULL, NULL, &curve),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2");
    with = options;
    with.degree = 26;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &with, NULL, NULL, &curve),
                 BATTEN_BAD_DEGREE);
    with = options;
    with.degree = 4;
    with.method = BATTEN_WITHIN_BEZIER;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &with, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    with = options;
    with.corners = falling;
    with.corner_count = 2;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &with, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("corner 2 is point 2");
    with.corners = far;
    with.corner_count = 1;
    CHECK_STATUS(batten_curve_within((batten_points){2, 4, q}, &with, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_within((batten_points){1, 4, q}, &options, NULL, NULL, &curve),
                 BATTEN_BAD_ARGUMENT);
    with = options;
    with.parameters = BATTEN_GIVEN;
    with.given = same;
    CHECK_STATUS(batten_curve_within((batten_points){1, 4, q}, &with, NULL, NULL, &curve),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("the nearest curve that was found is");
    CHECK(curve == NULL);
}

/* How few control points real aerofoils take, of chord 1. */
TEST(published_aerofoils_take_few_control_points)
{
    static const struct {
        const char *file;
        double tolerance;
        int of, fewest, bezier;
    } rows[] = {{"airfoils/e423.dat", 1e-3, 72, 12, 24},
                {"airfoils/e423.dat", 1e-4, 72, 25, 44},
                {"airfoils/s1223.dat", 1e-3, 300, 15, 26},
                {"airfoils/s1223.dat", 1e-4, 300, 29, 48},
                {"airfoils/naca0012_sharp.dat", 1e-3, 153, 12, 26},
                {"airfoils/naca0012_sharp.dat", 1e-4, 153, 19, 48},
                {"airfoils/tp29-5.dat", 1e-3, 260, 11, 18},
                {"airfoils/tp29-5.dat", 1e-4, 260, 26, 42}};
    for (int r = 0; r < COUNT(rows); r++) {
        FILE *file = fopen(test_data(rows[r].file), "r");
        CHECK(file != NULL);
        char line[200];
        double *q = test_array(600, sizeof *q);
        int n = 0;
        while (n < 300 && fgets(line, sizeof line, file))
            n += sscanf(line, "%lf %lf", &q[2 * n], &q[2 * n + 1]) == 2;
        fclose(file);
        CHECK_INT(n, rows[r].of);
        batten_curve_within_options options = batten_curve_within_defaults();
        options.tolerance = rows[r].tolerance;
        CHECK(check_within(2, n, q, &options) <= rows[r].fewest);
        options.method = BATTEN_WITHIN_BEZIER;
        CHECK(check_within(2, n, q, &options) <= rows[r].bezier);
    }
}

TEST(published_contours_take_a_tenth_of_their_points_within_a_millimetre)
{
    double *table = test_array(4 * 5000, sizeof *table), *q = test_array(3 * 5000, sizeof *q);
    const int n = published_table("contours/heart_contours.csv", 4, 5000, table);
    int all = 0, points = 0;
    batten_curve_within_options options = batten_curve_within_defaults();
    options.tolerance = 1;
    options.closed = true;
    for (int i = 0; i < n;) {
        int m = 0;
        for (const double contour = table[4 * i]; i < n && table[4 * i] == contour; i++, m++)
            memcpy(q + 3 * m, table + 4 * i + 1, 3 * sizeof *q);
        all += m;
        points += check_within(3, m, q, &options);
    }
    CHECK_INT(all, 4732);
    CHECK(points <= all / 10);
}
