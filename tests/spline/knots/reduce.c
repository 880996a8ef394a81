#include "spline/spline.h"

#include "support/test.h"

TEST(a_parabola_elevated_twice_is_found_again)
{
    bat_spline spline = {0}, high = {0}, made = {0};
    const double knots[] = {0, 0, 0, 1, 1, 2.5, 4, 4, 4}, values[] = {1, 4, -2, 0, 5, 3};
    double error = -1;
    CHECK_OK(bat_spline_make(2, 6, 1, &spline));
    memcpy(spline.knots, knots, sizeof knots);
    memcpy(spline.values, values, sizeof values);
    CHECK_OK(bat_spline_elevate(&spline, 2, &high));
    CHECK_OK(bat_spline_reduce(&high, 2, 1, 1e-12, &error, &made));
    CHECK_INT(made.count, 6);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(made.knots[i], knots[i]);
    for (int i = 0; i < 6; i++)
        CHECK_NEAR(made.values[i], values[i], 1e-13);
    bat_spline_free(&made);
    CHECK_STATUS(bat_spline_reduce(&spline, 1, 1, 1e-3, &error, &made),
                 BATTEN_TOLERANCE_NOT_MET);
    bat_spline_free(&high);
    bat_spline_free(&spline);
}
