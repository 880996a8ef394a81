#include "spline/spline.h"

#include "support/test.h"

TEST(binomials_are_pascals)
{
    for (int p = 1; p <= BATTEN_MAX_DEGREE; p++)
        for (int i = 1; i < p; i++)
            CHECK_BITS(bat_binomials[p][i],
                       bat_binomials[p - 1][i - 1] + bat_binomials[p - 1][i]);
}

TEST(bernstein_polynomials_sum_to_one_and_give_x_squared_its_bernstein_form)
{
    double b[BATTEN_MAX_DEGREE + 1];
    for (int n = 1; n <= BATTEN_MAX_DEGREE; n++)
        for (double x = 0; x <= 1; x += 0.125) {
            double sum = 0, square = 0;
            bat_bernstein(n, x, 1 - x, b);
            for (int i = 0; i <= n; i++) {
                CHECK(b[i] >= 0);
                sum += b[i];
                square += b[i] * i * i / n / n;
            }
            CHECK_NEAR(sum, 1, 4 * n * 0x1p-53);
            CHECK_NEAR(square, x * x + x * (1 - x) / n, 1e-14); /* B_n(x^2) [S] */
        }
    bat_bernstein(5, 1, 0, b);
    CHECK(b[5] == 1 && b[4] == 0 && b[0] == 0);
}

TEST(unisurf_functions_are_sums_of_bernstein_polynomials)
{
    /* f_i = (-t)^i / (i - 1)! d^(i-1)/dt^(i-1) [((1 - t)^n - 1) / t]; n = 3: f_1 = 3t - 3t^2 +
     * t^3, f_2 = 3t^2 - 2t^3, f_3 = t^3. */
    double b[4];
    for (double t = 0; t <= 1; t += 0.125) {
        bat_bernstein(3, t, 1 - t, b);
        CHECK_NEAR(b[1] + b[2] + b[3], 3 * t - 3 * t * t + t * t * t, 1e-15);
        CHECK_NEAR(b[2] + b[3], 3 * t * t - 2 * t * t * t, 1e-15);
        CHECK_NEAR(b[3], t * t * t, 1e-15);
    }
}

TEST(rows_and_their_derivatives_agree_either_way)
{
    const double knots[] = {0, 0, 1, 1.5, 3, 4, 4, 6};
    double bezier[4] = {1, 3, -2, 5}, rows[4] = {1, 3, -2, 5};
    bat_piece_from_rows(3, knots, 3, 1, bezier);
    bat_piece_derive(3, 1.5, 1, bezier);
    bat_rows_derive(3, knots, 3, 1, rows);
    bat_piece_from_rows(2, knots, 3, 1, rows);
    for (int i = 0; i < 3; i++)
        CHECK_NEAR(rows[i], bezier[i], 1e-14);
}

TEST(K6_a_span_much_narrower_than_its_neighbours_is_tight)
{
    const double knots[] = {0, 1, 1 + 1e-9, 2, 3};
    CHECK(bat_span_is_tight(1, (const double[]){0, 1, 2, 3}, 1) == false);
    CHECK(bat_span_is_tight(2, knots, 1));
    CHECK(!bat_span_is_tight(2, knots, 2));
}
