#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"cbrt", bat_cbrt, oracle_cbrt, 1, 8, false},
    {"cbrt", bat_cbrt, oracle_cbrt, 1e-320, 1e308, true},
    {"cbrt", bat_cbrt, oracle_cbrt, 1e-3, 1e3, true},
};

TEST(cube_roots_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

TEST(hypotenuses_are_within_0_55_units_of_the_last_place)
{
#ifndef __SIZEOF_FLOAT128__
    SKIP("no numbers of 113 bits");
#endif
    test_random random = test_random_begin("hypot");
    for (int n = test_cases(8000); n > 0; n--) {
        const int size = test_random_int(&random, -1070, 1022),
                  more = n % 2 ? 0 : test_random_int(&random, -60, 0);
        const double x = ldexp(test_random_in(&random, -1, 1), size),
                     y = ldexp(test_random_in(&random, -1, 1), size + more);
        const double units = oracle_units(bat_hypot(x, y), oracle_hypot(x, y));
        if (!(units <= 0.55))
            printf("hypot(%a, %a): %.4f units\n", x, y, units);
        CHECK(units <= 0.55);
        CHECK_BITS(bat_hypot(y, x), bat_hypot(x, y));
    }
}

static const oracle_value roots[] = {
    {0, 0},     {-0.0, -0.0},          {INFINITY, INFINITY},   {-INFINITY, -INFINITY},
    {NAN, NAN}, {0x1p-1074, 0x1p-358}, {-0x1p-1023, -0x1p-341}};
static const oracle_value2 hypotenuses[] = {{0, 0, 0},
                                            {-0.0, -0.0, 0},
                                            {-3, 0, 3},
                                            {0, -0x1p-1074, 0x1p-1074},
                                            {INFINITY, NAN, INFINITY},
                                            {NAN, -INFINITY, INFINITY},
                                            {NAN, 0, NAN},
                                            {1, NAN, NAN},
                                            {DBL_MAX, DBL_MAX, INFINITY},
                                            {DBL_MAX, 1, DBL_MAX},
                                            {3e300, 4e300, 5e300},
                                            {0x3p-1074, 0x4p-1074, 0x5p-1074}};

TEST(roots_follow_annex_f_of_c)
{
    oracle_check_values(bat_cbrt, roots, COUNT(roots));
    oracle_check_values2(bat_hypot, hypotenuses, COUNT(hypotenuses));
}

TEST(roots_of_cubes_and_hypotenuses_of_whole_triangles_are_exact)
{
    for (int n = -2000; n <= 2000; n++)
        CHECK_BITS(bat_cbrt((double)n * n * n), n);
    for (int m = 2; m < 60; m++)
        for (int n = 1; n < m; n++)
            CHECK_BITS(bat_hypot(m * m - n * n, 2 * m * n), m * m + n * n);
}

/* Where the table changes and where octaves begin. */
static const double seams[] = {1, 1 + 1.0 / 32, 2, 3, 4, 8, 1e-310};

TEST(cube_roots_rise)
{
    oracle_check_order(bat_cbrt, seams, COUNT(seams), 1);
}
