#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"atan", bat_atan, oracle_atan, -2, 2, false},
    {"atan", bat_atan, oracle_atan, 1e-9, 1e20, true},
    {"atan", bat_atan, oracle_atan, 1e-4, 0.02, true},
};

TEST(arc_tangents_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

TEST(angles_of_points_are_within_0_55_units_of_the_last_place)
{
#ifndef __SIZEOF_FLOAT128__
    SKIP("no numbers of 113 bits");
#endif
    test_random random = test_random_begin("atan2");
    for (int n = test_cases(8000); n > 0; n--) {
        const int size = test_random_int(&random, -1000, 1000),
                  more = n % 2 ? 0 : test_random_int(&random, -60, 20);
        const double x = ldexp(test_random_in(&random, -1, 1), size),
                     y = ldexp(test_random_in(&random, -1, 1), size + more);
        const double units = oracle_units(bat_atan2(y, x), oracle_atan2(y, x));
        if (!(units <= 0.55))
            printf("atan2(%a, %a): %.4f units\n", y, x, units);
        CHECK(units <= 0.55);
    }
}

#define QUARTER 0x1.921fb54442d18p0 /* pi/2 rounded */

static const oracle_value tangents[] = {{0, 0},
                                        {-0.0, -0.0},
                                        {INFINITY, QUARTER},
                                        {-INFINITY, -QUARTER},
                                        {NAN, NAN},
                                        {0x1p-1074, 0x1p-1074},
                                        {-0x1p-1022, -0x1p-1022},
                                        {1, QUARTER / 2},
                                        {-1, -QUARTER / 2},
                                        {1e300, QUARTER}};
static const oracle_value2 points[] = {{0, 1, 0},
                                       {-0.0, 1, -0.0},
                                       {0, -1, 2 * QUARTER},
                                       {-0.0, -1, -2 * QUARTER},
                                       {0, 0, 0},
                                       {-0.0, 0, -0.0},
                                       {0, -0.0, 2 * QUARTER},
                                       {-0.0, -0.0, -2 * QUARTER},
                                       {1, 0, QUARTER},
                                       {-1, -0.0, -QUARTER},
                                       {INFINITY, 1, QUARTER},
                                       {-INFINITY, -1, -QUARTER},
                                       {1, INFINITY, 0},
                                       {-1, INFINITY, -0.0},
                                       {1, -INFINITY, 2 * QUARTER},
                                       {INFINITY, INFINITY, QUARTER / 2},
                                       {-INFINITY, INFINITY, -QUARTER / 2},
                                       {INFINITY, -INFINITY, 0x1.2d97c7f3321d2p1},
                                       {-INFINITY, -INFINITY, -0x1.2d97c7f3321d2p1},
                                       {NAN, 1, NAN},
                                       {1, NAN, NAN},
                                       {NAN, INFINITY, NAN},
                                       {0x1p-1074, 1, 0x1p-1074},
                                       {0x1p-1074, 2, 0},
                                       {3e-310, -1e300, 2 * QUARTER},
                                       {1e300, 1e-310, QUARTER},
                                       {DBL_MAX, DBL_MAX, QUARTER / 2},
                                       {0x1p-1074, 0x1p-1074, QUARTER / 2},
                                       {1, -1, 0x1.2d97c7f3321d2p1},
                                       {-5, 5, -QUARTER / 2}};

TEST(arc_tangents_follow_annex_f_of_c)
{
    oracle_check_values(bat_atan, tangents, COUNT(tangents));
    oracle_check_values2(bat_atan2, points, COUNT(points));
}

static double angle_below_axis(double x)
{
    return bat_atan2(-1, x);
}

/* Where the table changes and where the fraction is turned over. */
static const double seams[] = {0, 0x1p-27, 0x1p-8, 0x1.8p-7, 0.5, 1, 1.00390625, 256, 0x1p60};

TEST(arc_tangents_rise)
{
    oracle_check_order(bat_atan, seams, COUNT(seams), 1);
    oracle_check_order(angle_below_axis, seams, COUNT(seams), 1);
}
