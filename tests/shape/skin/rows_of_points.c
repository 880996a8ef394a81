#include <batten/skin.h>

#include "shape/sections.h"
#include "shape/skin/rows_of_points.h"

#include "support/faults.h"

/* Rows of airfoil points, each with a number of its own at jittered places. */
static int make_rows(const char *name, int row_count, int least, int most, int *counts,
                     double *points)
{
    test_random random = test_random_begin(name);
    int total = 0;
    for (int k = 0; k < row_count; k++) {
        counts[k] = test_random_int(&random, least, most);
        for (int i = 0; i < counts[k]; i++) {
            const bool inner = i > 0 && i < counts[k] - 1;
            const double jitter = inner ? test_random_in(&random, -0.3, 0.3) : 0;
            airfoil((i + jitter) / (counts[k] - 1), 0.2 * k, points + 3 * (total + i));
        }
        total += counts[k];
    }
    return total;
}

TEST(a_surface_passes_all_points_of_uneven_rows_with_few_knots)
{
    enum { ROWS = 30 };
    int counts[ROWS];
    double points[3 * 30 * ROWS], u[30 * ROWS], v[ROWS];
    const int rows = test_cases(ROWS) < ROWS ? 4 : ROWS;
    for (int degree = 1; degree <= 4; degree++) {
        const int total = make_rows("rows", rows, 18, 26, counts, points);
        batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
        options.degree = degree;
        batten_surface_skin_rows_report report;
        batten_surface *surface = NULL;
        CHECK_EACH_ALLOCATION(batten_surface_skin_rows((batten_rows){3, rows, counts, points},
                                                       &options, NULL, (batten_uv_out){u, v},
                                                       &report, &surface));
        for (int k = 0, i = 0; k < rows; k++)
            for (int j = 0; j < counts[k]; j++, i++) {
                double p[3];
                CHECK_OK(batten_surface_evaluate(surface, u[i], v[k], 0, p));
                for (int c = 0; c < 3; c++)
                    CHECK_NEAR(p[c], points[3 * i + c], 6e-11);
            }
        CHECK(report.error < 6e-11);
        CHECK_INT(report.separate_knot_count, total - rows * (degree + 1));
        CHECK_INT(batten_surface_spans(surface, BATTEN_U, NULL) - 2, report.knot_count);
        if (rows == ROWS && degree == 3) {
            CHECK(report.knot_count < 60 && report.separate_knot_count > 450);
            CHECK(report.span_ratio > 0.02 && report.free_rows > 25);
        }
        batten_surface_unref(surface);
    }
}

/* Schoenberg and Whitney: U_i < u_i < U_(i + p + 1) for a subset of the knots. Rising greedily
 * through all of them finds one. */
TEST(the_shared_knots_are_admissible_for_every_row)
{
    test_random random = test_random_begin("admissible");
    for (int run = 0; run < test_cases(50); run++) {
        const int p = test_random_int(&random, 1, 5);
        double knots[200], u[10][20];
        int counts[10];
        bat_shared_knots shared = {0, 200, knots};
        for (int k = 0; k < 10; k++) {
            counts[k] = test_random_int(&random, p + 1, 20);
            double sum = 0;
            for (int i = 0; i < counts[k]; i++) {
                u[k][i] = sum;
                sum += pow(10, test_random_in(&random, -2, 0));
            }
            for (int i = 0; i < counts[k]; i++)
                u[k][i] /= u[k][counts[k] - 1];
            bat_shared_knots_take(&shared, p, counts[k], u[k], 0.25);
        }
        for (int k = 0; k < 10; k++) {
            int at = 0;
            for (int j = 1; j < counts[k] - p; j++) {
                while (at < shared.count && shared.knots[at] <= u[k][j - 1])
                    at++;
                CHECK(at < shared.count && shared.knots[at] < u[k][j + p]);
                at++;
            }
        }
        for (int i = 0; i <= shared.count; i++)
            CHECK((i > 0 ? knots[i - 1] : 0) < (i < shared.count ? knots[i] : 1));
    }
}

TEST(rows_that_share_their_parameters_share_all_knots)
{
    int counts[6];
    double points[6 * 12 * 3];
    for (int k = 0; k < 6; k++) {
        counts[k] = 12;
        for (int i = 0; i < 12; i++)
            airfoil(i / 11.0, 0, points + 3 * (12 * k + i));
        for (int i = 0; i < 12; i++)
            points[3 * (12 * k + i)] = k;
    }
    batten_surface_skin_rows_report report;
    batten_surface *surface = NULL;
    CHECK_EACH_ALLOCATION(batten_surface_skin_rows((batten_rows){3, 6, counts, points}, NULL,
                                                   NULL, (batten_uv_out){NULL, NULL}, &report,
                                                   &surface));
    CHECK(report.knot_count == 8 && report.free_rows == 0 && report.separate_knot_count == 48);
    batten_surface_unref(surface);
}

/* With fewer points the curve of least energy is the natural cubic spline, when the knots have
 * room for it. */
TEST(what_points_leave_open_has_the_least_energy)
{
    const double places[] = {0, 0.3, 0.55, 1}, values[] = {0, 1, -0.5, 0.3};
    double knots[14];
    bat_shared_knots shared = {0, 14, knots};
    for (int i = 1; i <= 14; i++) /* among them the places of the points */
        knots[shared.count++] = i < 6     ? i * 0.05
                                : i == 6  ? 0.3
                                : i < 11  ? 0.3 + (i - 6) * 0.05
                                : i == 11 ? 0.55
                                          : 0.55 + (i - 11) * 0.1;
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = places;
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    batten_curve *natural = NULL, *found = NULL;
    bool is_free = false;
    CHECK_OK(batten_curve_interpolate((batten_points){1, 4, values}, &options, NULL, &natural));
    CHECK_OK(bat_row_through(&shared, 3, 1, 4, places, values, &is_free, &found));
    CHECK(is_free);
    for (int i = 0; i <= 100; i++) {
        double a, b;
        CHECK_OK(batten_curve_evaluate(natural, i / 100.0, 0, &a));
        CHECK_OK(batten_curve_evaluate(found, i / 100.0, 0, &b));
        CHECK_NEAR(b, a, 1e-11);
    }
    batten_curve_unref(found);
    batten_curve_unref(natural);
}

TEST(short_rows_between_long_ones_stay_calm)
{
    const int counts[] = {20, 2, 3, 20};
    double points[3 * 45];
    int at = 0;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < counts[k]; i++, at++) {
            const double s = (double)i / (counts[k] - 1);
            points[3 * at] = k, points[3 * at + 1] = s, points[3 * at + 2] = s * s;
        }
    batten_surface *surface = NULL;
    batten_surface_skin_rows_report report;
    double v[4];
    CHECK_OK(batten_surface_skin_rows((batten_rows){3, 4, counts, points}, NULL, NULL,
                                      (batten_uv_out){NULL, v}, &report, &surface));
    CHECK_INT(report.free_rows, 2);
    for (int i = 0; i <= 20; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 20.0, v[1], 0, p));
        CHECK_NEAR(p[1], p[2], 1e-12); /* two points: the straight line */
        CHECK_OK(batten_surface_evaluate(surface, i / 20.0, v[2], 0, p));
        CHECK(p[2] > -0.1 && p[2] < 1.001);
    }
    batten_surface_unref(surface);
}

TEST(G9_rows_of_points_that_are_bad_are_named)
{
    const int counts[] = {4, 3}, few[] = {4, 1};
    double points[] = {0, 0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 1, 0, 0, 1, 1, 0, 1, 2, 1};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 1, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, few, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_TOO_FEW_POINTS);
    CHECK_MESSAGE("row 2 has 1 point, and needs 2");
    points[16] = 0; /* the second point of row 1 on its first */
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_COINCIDENT);
    CHECK_MESSAGE("row 2: ");
    points[16] = NAN;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("point 2 of row 2 is not finite");
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    options.degree = 0;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, &options, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_BAD_DEGREE);
    options.degree = 3;
    options.margin = 0.5;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, &options, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    options.margin = 0.25;
    options.parameters = BATTEN_GIVEN;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, &options, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK(surface == NULL);
}

TEST(N2_rows_of_huge_and_tiny_points_are_interpolated)
{
    const double sizes[] = {1e80, 1e-80};
    for (int c = 0; c < 2; c++) {
        int counts[5];
        double points[3 * 5 * 12];
        const int total = make_rows("sizes", 5, 8, 12, counts, points);
        for (int i = 0; i < 3 * total; i++)
            points[i] *= sizes[c];
        batten_surface_skin_rows_report report;
        batten_surface *surface = NULL;
        CHECK_OK(batten_surface_skin_rows((batten_rows){3, 5, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, &report, &surface));
        CHECK(report.error < 1e-11 * sizes[c]);
        batten_surface_unref(surface);
    }
}

TEST(S5_too_many_rows_or_points_are_refused_before_the_work)
{
    const int counts[] = {900000, 900000};
    const double points[6] = {0};
    batten_surface *surface = NULL;
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2000000, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_TOO_LARGE);
    CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, NULL, NULL,
                                          (batten_uv_out){NULL, NULL}, NULL, &surface),
                 BATTEN_TOO_LARGE);
    CHECK(surface == NULL);
}

/* Two rows of a bilinear surface: the given parameters come back as shares of their range, and
 * the points lie there. */
TEST(rows_keep_the_parameters_that_are_given)
{
    const int counts[] = {3, 4};
    const double points[] = {0, 0, 0, 1, 0, 0, 4, 0, 0, 0, 2, 0, 1, 2, 0, 3, 2, 0, 4, 2, 0};
    const double given[] = {2, 3, 6, 0, 0.25, 0.75, 1};
    const double expected[] = {0, 0.25, 1, 0, 0.25, 0.75, 1};
    double u[7], v[2];
    batten_surface_skin_rows_options options = batten_surface_skin_rows_defaults();
    batten_surface_skin_options across = batten_surface_skin_defaults();
    batten_surface_skin_rows_report report;
    batten_surface *surface = NULL;
    across.degree = 1;
    options.degree = 1;
    options.parameters = BATTEN_GIVEN;
    options.given = given;
    options.across = &across;
    CHECK_OK(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, &options, NULL,
                                      (batten_uv_out){u, v}, &report, &surface));
    for (int i = 0; i < 7; i++)
        CHECK_NEAR(u[i], expected[i], 1e-16);
    CHECK(v[0] == 0 && v[1] == 1);
    for (int i = 0; i <= 8; i++) {
        double p[3];
        CHECK_OK(batten_surface_evaluate(surface, i / 8.0, 0.5, 0, p));
        CHECK_NEAR(p[0], i / 2.0, 1e-14);
        CHECK_NEAR(p[1], 1, 1e-14);
    }
    CHECK_INT(report.separate_knot_count, 3); /* 1 and 2 of rows of degree 1 */
    CHECK_INT(report.knot_count, 2);
    CHECK_INT(report.free_rows, 1);
    CHECK(report.error < 1e-14);
    batten_surface_unref(surface);
}

TEST(options_of_rows_out_of_bounds_are_named_with_their_numbers)
{
    const int counts[] = {2, 2};
    const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, falling[] = {0, 1, 1, 0};
    const double starts[] = {0, 0};
    batten_surface_skin_rows_options bad[8];
    batten_surface_skin_options across[2];
    static const char *const messages[COUNT(bad)] = {
        "the degree along the rows is 0, not 1 to ",
        "the degree along the rows is ",
        "the margin of knots is -0.1; it must be 0 or more and below 0.5",
        "the margin of knots is 0.5; it must be 0 or more and below 0.5",
        "no parameters of the points are given",
        "row 2: ",
        "rows of points have no spine, no starts, no tolerance, and are not matched",
        "rows of points have no spine, no starts, no tolerance, and are not matched"};
    batten_surface *surface = NULL;
    for (int i = 0; i < COUNT(bad); i++)
        bad[i] = batten_surface_skin_rows_defaults();
    across[0] = across[1] = batten_surface_skin_defaults();
    across[0].tolerance = 1e-3;
    across[1].starts = starts;
    bad[0].degree = 0;
    bad[1].degree = BATTEN_MAX_DEGREE + 1;
    bad[2].margin = -0.1;
    bad[3].margin = 0.5;
    bad[4].parameters = bad[5].parameters = BATTEN_GIVEN;
    bad[5].given = falling;
    bad[6].across = &across[0];
    bad[7].across = &across[1];
    for (int i = 0; i < COUNT(bad); i++) {
        CHECK_STATUS(batten_surface_skin_rows((batten_rows){3, 2, counts, points}, &bad[i],
                                              NULL, (batten_uv_out){NULL, NULL}, NULL,
                                              &surface),
                     i < 2    ? BATTEN_BAD_DEGREE
                     : i == 5 ? BATTEN_NOT_INCREASING
                              : BATTEN_BAD_ARGUMENT);
        CHECK_MESSAGE(messages[i]);
    }
    CHECK(!surface);
}
