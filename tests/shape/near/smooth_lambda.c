#include "shape/near/smooth.h"

#include "support/test.h"

/* A valley around 10^-3.3, and how often its height was asked for. */
static batten_status valley(void *user, double lambda, double *score)
{
    const double x = log10(lambda) + 3.3;
    ++*(int *)user;
    *score = 2 + x * x / (1 + fabs(x));
    return BATTEN_OK;
}

static double find(double near, int *asked)
{
    bat_lambda_search search = {.by = BATTEN_SMOOTH_BY_VALIDATION,
                                .scale = 1,
                                .last = 12,
                                .near = near,
                                .user = asked,
                                .score = valley};
    double lambda = 0;
    *asked = 0;
    CHECK_OK(bat_lambda_choose(&search, &lambda));
    return log10(lambda);
}

/* A robust fit and a cloud choose lambda again and again: it hardly moves. */
TEST(a_search_near_the_last_lambda_asks_for_few_scores)
{
    int far, near;
    CHECK_NEAR(find(0, &far), -3.3, 0.02);
    CHECK_NEAR(find(1e-3, &near), -3.3, 0.02);
    CHECK(3 * near < far);
    CHECK_NEAR(find(1e4, &near), -3.3, 0.02); /* downhill, however far */
    CHECK_NEAR(find(1e-9, &near), -3.3, 0.02);
}
