#include "spline/spline.h"

#include "support/splines.h"

TEST(K1_equal_knots_are_refused)
{
    const double equal[] = {1, 1, 1, 1, 1, 1};
    CHECK_STATUS(bat_knots_check(2, 3, equal, "knot"), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("the domain is empty");
}

TEST(K3_a_decreasing_knot_is_refused_by_its_index)
{
    const double knots[] = {0, 0, 2, 1, 3, 3};
    CHECK_STATUS(bat_knots_check(1, 4, knots, "knot in u"), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot in u 4 is 1, below knot in u 3, which is 2");
}

TEST(K4_multiplicity_is_limited_inside_and_at_the_ends)
{
    const double inside[] = {0, 0, 0, 1, 1, 1, 2, 2, 2}, fine[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double ends[] = {0, 0, 0, 0, 1, 2, 2};
    CHECK_STATUS(bat_knots_check(2, 6, inside, "knot"), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot 6, 1, stands more than 2 times");
    CHECK_OK(bat_knots_check(2, 5, fine, "knot"));
    CHECK_STATUS(bat_knots_check(1, 5, ends, "knot"), BATTEN_BAD_KNOTS);
}

TEST(N1_knots_that_are_no_numbers_are_refused)
{
    double knots[] = {0, 0, 1, 1};
    knots[2] = NAN;
    CHECK_STATUS(bat_knots_check(1, 2, knots, "knot"), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("knot 3");
    const double wide[] = {-1e308, -1e308, 1e308, 1e308};
    CHECK_STATUS(bat_knots_check(1, 2, wide, "knot"), BATTEN_BAD_KNOTS);
}

TEST(spans_are_closed_on_the_side_asked_for)
{
    const double knots[] = {0, 0, 0, 1, 1, 2, 3, 3, 3};
    CHECK_INT(bat_knots_span(2, 6, knots, 0, BATTEN_FROM_RIGHT), 2);
    CHECK_INT(bat_knots_span(2, 6, knots, 0, BATTEN_FROM_LEFT), 2);
    CHECK_INT(bat_knots_span(2, 6, knots, 1, BATTEN_FROM_RIGHT), 4);
    CHECK_INT(bat_knots_span(2, 6, knots, 1, BATTEN_FROM_LEFT), 2);
    CHECK_INT(bat_knots_span(2, 6, knots, 2.5, BATTEN_FROM_LEFT), 5);
    CHECK_INT(bat_knots_span(2, 6, knots, 3, BATTEN_FROM_RIGHT), 5);
    CHECK_INT(bat_knots_span(2, 6, knots, 3, BATTEN_FROM_LEFT), 5);
}

TEST(spans_are_not_empty_where_the_ends_are)
{
    const double knots[] = {0, 1, 1, 1,
                            2, 2, 2, 3}; /* degree 2: the domain [1, 2], U[2] = U[3] */
    CHECK_INT(bat_knots_span(2, 5, knots, 1, BATTEN_FROM_RIGHT), 3);
    CHECK_INT(bat_knots_span(2, 5, knots, 2, BATTEN_FROM_LEFT), 3);
}

TEST(multiplicities_are_counted)
{
    const double knots[] = {0, 0, 0, 1, 1, 2, 3, 3, 3};
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, 0), 3);
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, 1), 2);
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, 2), 1);
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, 1.5), 0);
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, -1), 0);
    CHECK_INT(bat_knots_multiplicity(2, 6, knots, 4), 0);
}

TEST(N7_four_ulps_outside_are_the_end)
{
    const double b = 3, ulp = nextafter(b, 4) - b;
    double u = b + 4 * ulp;
    CHECK_OK(bat_knots_clip(-1, b, &u));
    CHECK_BITS(u, b);
    u = -1 - 4 * ulp;
    CHECK_OK(bat_knots_clip(-1, b, &u));
    CHECK_BITS(u, -1);
    u = b + 5 * ulp;
    CHECK_STATUS(bat_knots_clip(-1, b, &u), BATTEN_OUT_OF_DOMAIN);
    CHECK_BITS(u, b + 5 * ulp);
    u = -1 - 5 * ulp;
    CHECK_STATUS(bat_knots_clip(-1, b, &u), BATTEN_OUT_OF_DOMAIN);
    u = NAN;
    CHECK_STATUS(bat_knots_clip(-1, b, &u), BATTEN_NOT_FINITE);
}

TEST(basis_functions_sum_to_one_and_their_derivatives_to_zero)
{
    const double knots[] = {0, 0, 0, 0, 1, 1, 2.5, 4, 4, 4, 4};
    double out[6 * 4];
    for (double u = 0; u <= 4; u += 0.125) {
        const int k = bat_knots_span(3, 7, knots, u, BATTEN_FROM_RIGHT);
        bat_basis(3, knots, k, u, 5, out);
        for (int m = 0; m <= 5; m++) {
            double sum = 0;
            for (int j = 0; j <= 3; j++) {
                sum += out[m * 4 + j];
                if (m == 0)
                    CHECK(out[j] >= 0);
                if (m > 3)
                    CHECK_BITS(out[m * 4 + j], 0);
            }
            CHECK_NEAR(sum, m == 0, m == 0 ? 1e-15 : 1e-13);
        }
    }
}

TEST(a_period_wraps_with_equal_knots_equal)
{
    const double period[] = {0.1, 0.1, 0.3, 0.7};
    double U[8];
    bat_knots_wrap(2, 3, period, U);
    CHECK_BITS(U[2], 0.1);
    CHECK_BITS(U[5], 0.7);
    CHECK_BITS(U[6], U[5]);
    CHECK_NEAR(U[7], 0.9, 1e-15);
    CHECK_NEAR(U[1], -0.3, 1e-15);
    CHECK_NEAR(U[0], -0.5, 1e-15);
}

TEST(basis_functions_and_their_derivatives_are_those_of_cox_and_de_boor)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(60); c++) {
        const int p = test_random_int(&random, 1, 5);
        bat_spline spline = {0};
        CHECK_OK(random_spline(&random, p, 1, &spline));
        const double a = spline.knots[p], b = spline.knots[spline.count];
        for (int i = 0; i < 10; i++) {
            const double u = a + (b - a) * test_random_unit(&random);
            const int k = bat_knots_span(p, spline.count, spline.knots, u, BATTEN_FROM_RIGHT);
            double out[4 * 6];
            CHECK(spline.knots[k] <= u && u < spline.knots[k + 1]);
            bat_basis(p, spline.knots, k, u, 3, out);
            for (int m = 0; m <= 3; m++)
                for (int j = 0; j <= p; j++) {
                    const double expected =
                        (double)basis_by_definition(p, spline.knots, k, k - p + j, u, m);
                    CHECK_NEAR(out[m * (p + 1) + j], expected, 1e-12 * (1 + fabs(expected)));
                }
        }
        bat_spline_free(&spline);
    }
}

TEST(the_span_of_a_knot_is_the_one_on_the_side_asked_for)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(100); c++) {
        bat_spline s = {0};
        const int p = test_random_int(&random, 1, 4);
        CHECK_OK(random_spline(&random, p, 1, &s));
        for (int i = p; i <= s.count; i++) {
            const double u = s.knots[i];
            const int right = bat_knots_span(p, s.count, s.knots, u, BATTEN_FROM_RIGHT),
                      left = bat_knots_span(p, s.count, s.knots, u, BATTEN_FROM_LEFT);
            CHECK(right >= p && right < s.count && s.knots[right] < s.knots[right + 1]);
            CHECK(left >= p && left < s.count && s.knots[left] < s.knots[left + 1]);
            CHECK(u < s.knots[s.count] ? s.knots[right] == u : s.knots[right + 1] == u);
            CHECK(u > s.knots[p] ? s.knots[left + 1] == u : s.knots[left] == u);
        }
        bat_spline_free(&s);
    }
}

TEST(reversed_knots_rise_and_come_back_to_the_bit)
{
    const double knots[7] = {0.1, 0.1, 0.1, 0.7, 2, 2, 2};
    double back[7], again[7];
    bat_knots_reverse(2, 4, knots, back);
    CHECK_OK(bat_knots_check(2, 4, back, "knot"));
    for (int i = 0; i < 7; i++)
        CHECK_BITS(back[i], -knots[6 - i]);
    bat_knots_reverse(2, 4, back, again);
    for (int i = 0; i < 7; i++)
        CHECK_BITS(again[i], knots[i]);
}

TEST(mapped_knots_keep_their_proportions_and_end_exactly)
{
    const double knots[9] = {-0.5, 0, 0, 0.1, 0.1, 0.4, 0.7, 0.7, 0.9}; /* [0, 0.7] */
    double out[9];
    CHECK_OK(bat_knots_map(2, 6, knots, -3, 4, out));
    CHECK_BITS(out[2], -3);
    CHECK_BITS(out[6], 4);
    for (int i = 0; i < 9; i++)
        CHECK_NEAR(out[i], -3 + knots[i] * 10, 1e-14);
    CHECK_BITS(out[3], out[4]);
    CHECK_BITS(out[1], out[2]);
    CHECK_OK(bat_knots_map(2, 6, knots, 0, 0.7, out));
    for (int i = 0; i < 9; i++)
        CHECK_BITS(out[i], knots[i]);
    CHECK_STATUS(bat_knots_map(2, 6, knots, NAN, 1, out), BATTEN_NOT_FINITE);
    CHECK_STATUS(bat_knots_map(2, 6, knots, 0, INFINITY, out), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("the domain [0, inf] is not finite");
    CHECK_STATUS(bat_knots_map(2, 6, knots, 1, 1, out), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_knots_map(2, 6, knots, 1, 0, out), BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(bat_knots_map(2, 6, knots, 1, nextafter(1, 2), out), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("cannot be told apart in [1, 1.0000000000000002]");
}

TEST(knots_are_inserted_as_often_as_the_degree_allows)
{
    const double knots[9] = {0, 0, 0, 1, 1, 2, 3, 3, 3}; /* degree 2 */
    const struct {
        double added[3];
        int count;
        bool periodic;
        batten_status status;
    } tries[] = {{{2}, 1, false, BATTEN_OK},
                 {{2, 2}, 2, false, BATTEN_BAD_KNOTS},
                 {{1}, 1, false, BATTEN_BAD_KNOTS},
                 {{0.5, 0.5}, 2, false, BATTEN_OK},
                 {{0.5, 0.5, 0.5}, 3, false, BATTEN_BAD_KNOTS},
                 {{0.5, 0.5, 2}, 3, false, BATTEN_OK},
                 {{0.5, 0.7, 0.7}, 3, false, BATTEN_OK},
                 {{0}, 1, false, BATTEN_BAD_KNOTS},
                 {{3}, 1, false, BATTEN_BAD_KNOTS},
                 {{0.7, 0.5}, 2, false, BATTEN_NOT_INCREASING},
                 {{-0.1}, 1, false, BATTEN_OUT_OF_DOMAIN},
                 {{2.5, 3.1}, 2, false, BATTEN_OUT_OF_DOMAIN},
                 {{0.5, NAN}, 2, false, BATTEN_NOT_FINITE},
                 {{INFINITY}, 1, false, BATTEN_NOT_FINITE},
                 {{0}, 0, false, BATTEN_OK}};
    for (int i = 0; i < COUNT(tries); i++)
        CHECK_STATUS(bat_knots_check_insertion(2, 6, knots, tries[i].periodic, tries[i].count,
                                               tries[i].added),
                     tries[i].status);
    /* Loose ends: the domain [1, 2] of degree 1 takes its ends once more, not when periodic. */
    const double loose[6] = {0, 1, 1.5, 2, 3, 4};
    const double ends[3] = {1, 2, 2};
    CHECK_OK(bat_knots_check_insertion(1, 3, loose, false, 2, ends));
    CHECK_STATUS(bat_knots_check_insertion(1, 3, loose, false, 3, ends), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot 2 would stand 3 times; 2 are allowed");
    CHECK_STATUS(bat_knots_check_insertion(1, 3, loose, true, 1, ends), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot 1 would stand 2 times; 1 are allowed");
}

TEST(wrapped_knots_repeat_with_the_period_and_keep_their_multiplicities)
{
    test_random random = test_random_begin(__func__);
    for (int c = 0; c < test_cases(100); c++) {
        const int p = test_random_int(&random, 1, 5), m = p + test_random_int(&random, 1, 4);
        double period[12], U[24];
        /* Far from 0, where a period rounds; the last knot equals the first of the next one. */
        period[0] = c % 3 ? test_random_in(&random, -1, 1) : 1e16;
        for (int i = 1; i <= m; i++)
            period[i] = period[i - 1] + (test_random_int(&random, 0, 2) && i > 1 && i < m
                                             ? 0
                                             : 2.0 * test_random_int(&random, 1, 3));
        bat_knots_wrap(p, m, period, U);
        const double length = period[m] - period[0];
        for (int i = 0; i <= m; i++)
            CHECK_BITS(U[p + i], period[i]);
        for (int i = 0; i + m <= m + 2 * p; i++) {
            CHECK_NEAR(U[i + m] - U[i], length, 8 * DBL_EPSILON * fabs(U[i + m]));
            CHECK(i == 0 || (U[i] == U[i - 1]) == (U[i + m] == U[i + m - 1]));
        }
        for (int i = 1; i <= m + 2 * p; i++)
            CHECK(U[i] >= U[i - 1]);
    }
}

TEST(parameters_inside_stay_and_the_ulps_are_those_of_the_larger_end)
{
    double u = 0.5;
    CHECK_OK(bat_knots_clip(0, 1024, &u));
    CHECK_BITS(u, 0.5);
    u = -4 * 0x1p-42; /* ulps of 1024, far beyond those of 0 */
    CHECK_OK(bat_knots_clip(0, 1024, &u));
    CHECK_BITS(u, 0);
    u = -5 * 0x1p-42;
    CHECK_STATUS(bat_knots_clip(0, 1024, &u), BATTEN_OUT_OF_DOMAIN);
    u = 1 + 4 * 0x1p-42;
    CHECK_OK(bat_knots_clip(-1024, 1, &u));
    CHECK_BITS(u, 1);
    u = -INFINITY;
    CHECK_STATUS(bat_knots_clip(0, 1, &u), BATTEN_NOT_FINITE);
}

TEST(multiplicity_is_counted_at_the_ends_of_loose_domains_too)
{
    const double ends[] = {0, 1, 1, 2, 3, 3, 4}, many[] = {0, 0, 0, 1, 1, 1};
    CHECK_OK(bat_knots_check(1, 5, ends, "knot"));
    CHECK_OK(bat_knots_check(2, 3, many, "knot"));
    CHECK_INT(bat_knots_multiplicity(1, 5, ends, 0), 1);
    CHECK_INT(bat_knots_multiplicity(1, 5, ends, 4), 1);
    CHECK_INT(bat_knots_multiplicity(2, 3, many, 1), 3);
    const double far[] = {0, 0, 0, 1, 2, 3}; /* degree 1, domain [0, 2]: 0 stands thrice */
    CHECK_STATUS(bat_knots_check(1, 4, far, "knot"), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("more than 2 times, too often for degree 1");
}

TEST(the_smoothness_of_knots_is_that_of_their_most_frequent_inner_one)
{
    static const struct {
        int degree, count, most, smoothness;
        double knots[12];
    } rows[] = {
        {3, 4, 2, 2, {0, 0, 0, 0, 1, 1, 1, 1}}, /* no inner knot: what is asked for */
        {3, 4, 9, 9, {0, 0, 0, 0, 1, 1, 1, 1}},
        {3, 5, 9, 2, {0, 0, 0, 0, 1, 2, 2, 2, 2}},
        {3, 5, 1, 1, {0, 0, 0, 0, 1, 2, 2, 2, 2}},
        {3, 8, 9, 0, {0, 0, 0, 0, 1, 2, 2, 2, 3, 4, 4, 4}},
        {2, 8, 9, 0, {0, 0, 0, 1, 2, 3, 4, 4, 5, 5, 5}},
        {2, 5, 9, 1, {0, 0, 0, 1, 2, 3, 3, 3}},
        {2, 6, 9, 0, {0, 0, 0, 1, 1, 1, 3, 3, 3}},   /* a jump is not smoother than none */
        {2, 6, 9, 1, {-2, -2, 0, 1, 2, 3, 4, 6, 6}}, /* outside of the domain all is allowed */
        {1, 3, 9, 0, {0, 0, 1, 2, 2}},
    };
    for (int i = 0; i < COUNT(rows); i++)
        CHECK_INT(
            bat_knots_smoothness(rows[i].degree, rows[i].count, rows[i].knots, rows[i].most),
            rows[i].smoothness);
}

/* The mean of the knots that a control point has of its own; equal ones give themselves. */
static const struct {
    int degree, i;
    double knots[8], mean;
} abscissae[] = {
    {1, 0, {-1, 0.1, 3}, 0.1},
    {1, 1, {-1, 0.1, 3, 7}, 3},
    {2, 0, {0, 0, 1, 3}, 0.5},
    {2, 1, {0, 0, 1, 3}, 2},
    {3, 0, {-9, 1, 2, 6, 90}, 3},
    {3, 1, {-9, -9, 1, 2, 6, 90}, 3},
    {3, 1, {0, 0, 0.1, 0.1, 0.1, 7}, 0.1},
    {5, 2, {0, 0, 0, 1, 2, 3, 5, 9}, 4},
};

TEST(grevilles_abscissa_is_the_mean_of_a_control_points_own_knots)
{
    for (size_t k = 0; k < sizeof abscissae / sizeof *abscissae; k++)
        CHECK_BITS(bat_greville(abscissae[k].degree, abscissae[k].knots, abscissae[k].i),
                   abscissae[k].mean);
}

TEST(grevilles_abscissa_stays_within_its_knots)
{
    for (int p = 1; p <= BATTEN_MAX_DEGREE; p++) {
        double knots[BATTEN_MAX_DEGREE + 2];
        for (int k = 0; k <= p; k++)
            knots[k] = k < p ? 0.3 : nextafter(0.3, 1);
        const double at = bat_greville(p, knots, 0);
        CHECK(at >= 0.3 && at <= knots[p]);
    }
}
