#include "spline/spline.h"

#include "support/test.h"

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
    CHECK_MESSAGE("knot in u 3 is 1, below knot in u 2, which is 2");
}

TEST(K4_multiplicity_is_limited_inside_and_at_the_ends)
{
    const double inside[] = {0, 0, 0, 1, 1, 1, 2, 2, 2}, fine[] = {0, 0, 0, 1, 1, 2, 2, 2};
    const double ends[] = {0, 0, 0, 0, 1, 2, 2};
    CHECK_STATUS(bat_knots_check(2, 6, inside, "knot"), BATTEN_BAD_KNOTS);
    CHECK_MESSAGE("knot 5, 1, stands more than 2 times");
    CHECK_OK(bat_knots_check(2, 5, fine, "knot"));
    CHECK_STATUS(bat_knots_check(1, 5, ends, "knot"), BATTEN_BAD_KNOTS);
}

TEST(N1_knots_that_are_no_numbers_are_refused)
{
    double knots[] = {0, 0, 1, 1};
    knots[2] = NAN;
    CHECK_STATUS(bat_knots_check(1, 2, knots, "knot"), BATTEN_NOT_FINITE);
    CHECK_MESSAGE("knot 2");
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
