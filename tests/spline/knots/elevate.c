#include "numeric/dense.h"
#include "spline/spline.h"

#include "support/test.h"

TEST(bezier_rows_are_elevated_as_in_the_notes)
{
    /* b^_i = sum over j of b_j C(n, j) C(r, i - j) / C(n + r, i) */
    const int n = 4, r = 3;
    bat_spline spline = {0}, made = {0};
    CHECK_OK(bat_spline_make(n, n + 1, 1, &spline));
    for (int i = 0; i <= n; i++) {
        spline.knots[n + 1 + i] = 1;
        spline.values[i] = (i * i * 7) % 5;
    }
    CHECK_OK(bat_spline_elevate(&spline, r, &made));
    CHECK_INT(made.count, n + r + 1);
    for (int i = 0; i <= n + r; i++) {
        double expected = 0;
        for (int j = 0; j <= n; j++)
            if (i - j >= 0 && i - j <= r)
                expected += spline.values[j] * bat_binomials[n][j] * bat_binomials[r][i - j] /
                            bat_binomials[n + r][i];
        CHECK_NEAR(made.values[i], expected, 4e-15);
    }
    bat_spline_free(&made);
    bat_spline_free(&spline);
}

TEST(knots_outside_an_unclamped_domain_are_kept_as_far_as_needed)
{
    const double knots[] = {0, 1, 2, 3, 4, 5, 6, 7}; /* degree 2: the domain [2, 5] */
    const double expected[] = {1, 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6};
    bat_spline spline, made;
    CHECK_OK(bat_spline_make(2, 5, 1, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    CHECK_OK(bat_spline_elevate(&spline, 1, &made));
    CHECK_INT(made.count, 8);
    for (int i = 0; i < COUNT(expected); i++)
        CHECK_BITS(made.knots[i], expected[i]);
    bat_spline_free(&made);
    bat_spline_free(&spline);
}

/* The entries of the matrix that raises a Bernstein polynomial from degree n - 1 to n. */
static double elevation(int n, int i, int j)
{
    return j == i ? 1 - i / (double)n : j == i - 1 ? i / (double)n : 0;
}

/* The product of two Bernstein polynomials of degree n, integrated over [0, 1]. */
static double gram(int n, int i, int j)
{
    return bat_binomials[n][i] * bat_binomials[n][j] /
           ((2 * n + 1) * bat_binomials[2 * n][i + j]);
}

/* Lutterkort, Peters and Reif: the least squares of coefficients, E x near b, are the least
 * squares of functions: what is left stands at right angles to all of lower degree. */
TEST(the_best_coefficients_of_a_lower_degree_are_the_best_polynomial)
{
    test_random random = test_random_begin(__func__);
    for (int n = 1; n <= 9; n++) {
        double a[10 * 9], b[10], rest[10];
        for (int i = 0; i <= n; i++) {
            rest[i] = b[i] = test_random_in(&random, -1, 1);
            for (int j = 0; j < n; j++)
                a[i * n + j] = elevation(n, i, j);
        }
        CHECK_OK(bat_dense_least_squares(n + 1, n, a, 1, b));
        for (int i = 0; i <= n; i++)
            for (int j = 0; j < n; j++)
                rest[i] -= elevation(n, i, j) * b[j];
        for (int k = 0; k < n; k++) { /* against each Bernstein polynomial of degree n - 1 */
            double product = 0;
            for (int i = 0; i <= n; i++)
                for (int j = 0; j <= n; j++)
                    product += rest[i] * gram(n, i, j) * elevation(n, j, k);
            CHECK_NEAR(product, 0, 1e-15);
        }
    }
}
