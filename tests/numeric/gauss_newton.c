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
