#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

TEST(powers_are_within_0_55_units_of_the_last_place)
{
#ifndef __SIZEOF_FLOAT128__
    SKIP("no numbers of 113 bits");
#endif
    test_random random = test_random_begin("pow");
    for (int n = test_cases(6000); n > 0; n--) {
        /* Bases of every size, and those near 1 with the exponents that take them as far. */
        const double near = 1 + test_random_in(&random, -1, 1) *
                                    exp(test_random_in(&random, -30, -1)),
                     far = exp(test_random_in(&random, -700, 700)), x = n % 2 ? near : far,
                     y = test_random_in(&random, -744, 709) / log(x);
        if (x == 1)
            continue;
        const double power = bat_pow(x, y), units = oracle_units(power, oracle_pow(x, y));
        if (!(units <= 0.55))
            printf("%a^%a: %.4f units\n", x, y, units);
        CHECK(units <= 0.55);
    }
}

static const oracle_value2 strange[] = {{0, 0, 1},
                                        {NAN, 0, 1},
                                        {1, NAN, 1},
                                        {NAN, 1, NAN},
                                        {2, NAN, NAN},
                                        {0, 3, 0},
                                        {-0.0, 3, -0.0},
                                        {-0.0, 2, 0},
                                        {0, -1, INFINITY},
                                        {-0.0, -1, -INFINITY},
                                        {-0.0, -2, INFINITY},
                                        {-1, INFINITY, 1},
                                        {-1, -INFINITY, 1},
                                        {0.5, INFINITY, 0},
                                        {2, INFINITY, INFINITY},
                                        {0.5, -INFINITY, INFINITY},
                                        {-2, -INFINITY, 0},
                                        {INFINITY, 2, INFINITY},
                                        {-INFINITY, 3, -INFINITY},
                                        {-INFINITY, 2, INFINITY},
                                        {-INFINITY, -3, -0.0},
                                        {INFINITY, -2, 0},
                                        {-2, 0.5, NAN},
                                        {-2, 3, -8},
                                        {-2, 2, 4},
                                        {-1, 0x1p60, 1},
                                        {-1, 0x1.fffffffffffffp52, -1},
                                        {2, 1e300, INFINITY},
                                        {2, -1e300, 0},
                                        {-2, -1e300, 0},
                                        {0.5, 1e300, 0},
                                        {3, 1e-300, 1},
                                        {2, -1074, 0x1p-1074},
                                        {2, -1075.5, 0},
                                        {-2, -1073, -0x1p-1073},
                                        {0x1p-1074, 0.5, 0x1p-537},
                                        {0x1p-1074, -0.5, 0x1p537},
                                        {2, 1024, INFINITY},
                                        {-2, 1025, -INFINITY}};

TEST(powers_follow_annex_f_of_c)
{
    oracle_check_values2(bat_pow, strange, COUNT(strange));
}

/* As long as the power of a whole number is a double, it is that one. */
TEST(powers_of_whole_numbers_are_exact)
{
    for (int base = 2; base < 40; base++) {
        double power = 1;
        for (int n = 0; power < 0x1p53; n++, power *= base) {
            CHECK_BITS(bat_pow(base, n), power);
            CHECK_BITS(bat_pow(-base, n), n % 2 ? -power : power);
        }
    }
    for (int n = 1; n < 1000; n++) {
        CHECK_BITS(bat_pow((double)n * n, 0.5), n);
        CHECK_BITS(bat_pow(n, 2), (double)n * n);
        CHECK_BITS(bat_pow(n / 8.0, 3), n / 8.0 * n / 8.0 * n / 8.0);
    }
    for (int n = -1074; n < 1024; n++)
        CHECK_BITS(bat_pow(2, n), ldexp(1, n));
    double ten = 1;
    for (int n = 0; n <= 22; n++, ten *= 10)
        CHECK_BITS(bat_pow(10, n), ten);
}

static double cube(double x)
{
    return bat_pow(x, 3.3);
}

static const double seams[] = {0.6875, 1.375, 1, 1 + 0x1p-7, 2, 1e-90, 1e-95};

TEST(powers_rise)
{
    oracle_check_order(cube, seams, COUNT(seams), 1);
}
