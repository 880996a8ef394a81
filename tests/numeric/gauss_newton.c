#include "numeric/gauss_newton.h"

#include "support/test.h"

/* Rosenbrock's valley, whose one minimum lies at (1, 1). */
static bool valley(void *context, const double *x, double *r, double *d)
{
    (void)context;
    r[0] = 10 * (x[1] - x[0] * x[0]);
    r[1] = 1 - x[0];
    if (d) {
        d[0] = -20 * x[0];
        d[1] = 10;
        d[2] = -1;
        d[3] = 0;
    }
    return true;
}

static bool valley_of_three(void *context, const double *x, double *r, double *d)
{
    double two[4];
    valley(context, x, r, d ? two : NULL);
    for (int i = 0; d && i < 2; i++) {
        d[3 * i] = two[2 * i];
        d[3 * i + 1] = two[2 * i + 1];
        d[3 * i + 2] = 0;
    }
    return true;
}

/* log x, which exists for x > 0 alone. */
static bool logarithm(void *context, const double *x, double *r, double *d)
{
    (void)context;
    if (!(x[0] > 0))
        return false;
    r[0] = log(x[0]);
    if (d)
        d[0] = 1 / x[0];
    return true;
}

static bool two_numbers(void *context, const double *x, double *r, double *d)
{
    (void)context;
    r[0] = x[0] - 1;
    r[1] = x[0] - 4;
    if (d)
        d[0] = d[1] = 1;
    return true;
}

static bool nowhere(void *context, const double *x, double *r, double *d)
{
    (void)context, (void)x, (void)r, (void)d;
    return false;
}

TEST(the_bottom_of_a_bent_valley_is_found)
{
    double x[2] = {-1.2, 1};
    int rounds;
    CHECK_OK(bat_gauss_newton(2, 2, valley, NULL, 200, x, &rounds));
    CHECK_NEAR(x[0], 1, 1e-12);
    CHECK_NEAR(x[1], 1, 1e-12);
    CHECK(rounds < 150);
    CHECK_STATUS(bat_gauss_newton(2, 2, nowhere, NULL, 200, x, &rounds), BATTEN_BAD_ARGUMENT);
}

TEST(an_unknown_without_influence_stays_where_it_was)
{
    /* The valley in the first two unknowns; the third appears nowhere. */
    double x[3] = {-1.2, 1, 7};
    int rounds;
    CHECK_OK(bat_gauss_newton(2, 3, valley_of_three, NULL, 200, x, &rounds));
    CHECK_NEAR(x[0], 1, 1e-12);
    CHECK_NEAR(x[1], 1, 1e-12);
    CHECK_NEAR(x[2], 7, 0);
}

TEST(the_limit_of_rounds_is_kept)
{
    double x[2] = {-1.2, 1};
    int rounds;
    CHECK_OK(bat_gauss_newton(2, 2, valley, NULL, 3, x, &rounds));
    CHECK_INT(rounds, 3);
    CHECK(fabs(x[0] - 1) > 1e-3);
    CHECK_OK(bat_gauss_newton(2, 2, valley, NULL, 0, x, &rounds));
    CHECK_INT(rounds, 0);
}

TEST(steps_into_a_place_without_residuals_are_shortened)
{
    /* log x = 0 from x = 40: the whole step leads to 40 - 40 log 40 < 0. */
    double x[1] = {40};
    int rounds;
    CHECK_OK(bat_gauss_newton(1, 1, logarithm, NULL, 200, x, &rounds));
    CHECK_NEAR(x[0], 1, 1e-14);
    x[0] = -1;
    CHECK_STATUS(bat_gauss_newton(1, 1, logarithm, NULL, 200, x, &rounds), BATTEN_BAD_ARGUMENT);
    CHECK_NEAR(x[0], -1, 0);
}

TEST(a_minimum_with_residuals_is_where_it_stops)
{
    /* Two numbers, 1 and 4, by one: their mean; from the mean there is nothing to gain. */
    double x[1] = {100};
    int rounds;
    CHECK_OK(bat_gauss_newton(2, 1, two_numbers, NULL, 200, x, &rounds));
    CHECK_NEAR(x[0], 2.5, 1e-7); /* where sums differ by rounding alone */
    CHECK(rounds < 5);
    x[0] = 2.5;
    CHECK_OK(bat_gauss_newton(2, 1, two_numbers, NULL, 200, x, &rounds));
    CHECK_NEAR(x[0], 2.5, 0);
    CHECK_INT(rounds, 0);
}
