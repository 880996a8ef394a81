#include "numeric/polynomial.h"

#include "support/test.h"

/* The product of t - at[i], in long doubles so that the coefficients are rounded once. */
static void expand(int count, const double *at, double *c)
{
    long double p[BAT_POLYNOMIAL_DEGREE + 1] = {1};
    for (int n = 0; n < count; n++) {
        p[n + 1] = 0;
        for (int i = n + 1; i > 0; i--)
            p[i] = p[i - 1] - at[n] * p[i];
        p[0] *= -at[n];
    }
    for (int i = 0; i <= count; i++)
        c[i] = (double)p[i];
}

static void check_all(int count, const double *at, double tolerance)
{
    double c[BAT_POLYNOMIAL_DEGREE + 1], roots[BAT_POLYNOMIAL_DEGREE];
    expand(count, at, c);
    CHECK_INT(bat_polynomial_roots(count, c, -INFINITY, INFINITY, roots), count);
    for (int i = 0; i < count; i++)
        CHECK_NEAR(roots[i], at[i], tolerance * fabs(at[i]));
}

TEST(roots_come_back_from_the_expanded_product)
{
    check_all(1, (const double[]){3}, 0);
    check_all(2, (const double[]){-1, 2}, 2 * DBL_EPSILON);
    check_all(2, (const double[]){1e-150, 1e150}, 2 * DBL_EPSILON);
    check_all(2, (const double[]){1e-9, 1e9}, 4 * DBL_EPSILON);
    check_all(2, (const double[]){-0.01, 0.01}, 4 * DBL_EPSILON);
    check_all(3, (const double[]){-3e-5, 1e-5, 2e-5}, 64 * DBL_EPSILON);
    check_all(3, (const double[]){-5, 1e-8, 7e5}, 8 * DBL_EPSILON);
    check_all(4, (const double[]){-1e6, -1, 1, 1e6}, 8 * DBL_EPSILON);
    check_all(4, (const double[]){1, 1.001, 1.002, 1.003}, 1e-6);
    check_all(10, (const double[]){1, 2, 3, 4, 5, 6, 7, 8, 9, 10}, 1e-9);
}

TEST(multiple_roots_are_found_once)
{
    double roots[4];
    CHECK_INT(bat_polynomial_roots(2, (const double[]){1, -2, 1}, -INFINITY, INFINITY, roots),
              1);
    CHECK_NEAR(roots[0], 1, DBL_EPSILON);
    CHECK_INT(
        bat_polynomial_roots(3, (const double[]){-1, 3, -3, 1}, -INFINITY, INFINITY, roots), 1);
    CHECK_NEAR(roots[0], 1, 1e-8);
    /* (t - 0.1)^2 (t - 3): the double root is only as good as the coefficients. */
    CHECK_INT(bat_polynomial_roots(3, (const double[]){-0.03, 0.61, -3.2, 1}, -INFINITY,
                                   INFINITY, roots),
              2);
    CHECK_NEAR(roots[0], 0.1, 1e-8);
    CHECK_NEAR(roots[1], 3, 1e-14);
    CHECK_INT(bat_polynomial_roots(3, (const double[]){0, 0, 0, 5}, -1, 1, roots), 1);
    CHECK_NEAR(roots[0], 0, 0);
}

TEST(polynomials_without_real_roots_have_none)
{
    double roots[4];
    CHECK_INT(bat_polynomial_roots(2, (const double[]){1, 0, 1}, -INFINITY, INFINITY, roots),
              0);
    CHECK_INT(
        bat_polynomial_roots(4, (const double[]){1, 1, 1, 1, 1}, -INFINITY, INFINITY, roots),
        0);
    CHECK_INT(
        bat_polynomial_roots(2, (const double[]){1 + 1e-12, -2, 1}, -INFINITY, INFINITY, roots),
        0);
}

TEST(an_interval_bounds_the_roots)
{
    const double c[4] = {-6, 11, -6, 1}; /* 1, 2, 3 */
    double roots[3];
    CHECK_INT(bat_polynomial_roots(3, c, 1.5, 2.5, roots), 1);
    CHECK_NEAR(roots[0], 2, 4 * DBL_EPSILON);
    CHECK_INT(bat_polynomial_roots(3, c, 1, 3, roots), 3);
    CHECK_INT(bat_polynomial_roots(3, c, 2, 2, roots), 1);
    CHECK_INT(bat_polynomial_roots(3, c, 4, 5, roots), 0);
    CHECK_INT(bat_polynomial_roots(3, c, 100, 101, roots), 0);
}

TEST(degrees_may_be_less_than_they_say)
{
    double roots[4];
    CHECK_INT(
        bat_polynomial_roots(3, (const double[]){-4, 2, 0, 0}, -INFINITY, INFINITY, roots), 1);
    CHECK_BITS(roots[0], 2);
    CHECK_INT(bat_polynomial_roots(2, (const double[]){5, 0, 0}, -INFINITY, INFINITY, roots),
              0);
    CHECK_INT(bat_polynomial_roots(2, (const double[]){0, 0, 0}, -INFINITY, INFINITY, roots),
              -1);
}

TEST(a_value_that_is_lost_in_its_rounding_is_a_root_and_one_beyond_it_is_not)
{
    /* (t - 0.3)^2 (t + 1.7) + lift: near 0.3 it is lift, known to about 1e-16. */
    double c[4] = {0.153, -0.93, 1.1, 1}, roots[3];
    CHECK_INT(bat_polynomial_roots(3, c, 0, 1, roots), 1);
    CHECK_NEAR(roots[0], 0.3, 1e-7);
    c[0] += 1e-14;
    CHECK_INT(bat_polynomial_roots(3, c, 0, 1, roots), 0);
    c[0] -= 2e-14;
    CHECK_INT(bat_polynomial_roots(3, c, 0, 1, roots), 2);
}

TEST(N2_coefficients_of_any_scale_have_roots)
{
    double roots[3];
    CHECK_INT(
        bat_polynomial_roots(2, (const double[]){-4e200, 0, 1e200}, -INFINITY, INFINITY, roots),
        2);
    CHECK_NEAR(roots[1], 2, 2 * DBL_EPSILON);
    CHECK_INT(
        bat_polynomial_roots(3, (const double[]){1e300, 0, 0, 1}, -INFINITY, INFINITY, roots),
        1);
    CHECK_NEAR(roots[0] / -1e100, 1, 2 * DBL_EPSILON);
    CHECK_INT(bat_polynomial_roots(2, (const double[]){-1e300, 1, 1e-300}, -INFINITY, INFINITY,
                                   roots),
              2);
}
