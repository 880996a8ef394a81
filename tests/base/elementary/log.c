#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static double positive_log(double x)
{
    return bat_log(fabs(x));
}

static quad oracle_log_of_size(quad x)
{
    return oracle_log(x < 0 ? -x : x);
}

static const oracle_stretch stretches[] = {
    {"log", bat_log, oracle_log, 0.3, 3, false},
    {"log", bat_log, oracle_log, 0.97, 1.03, false},
    {"log near 1", bat_log, oracle_log, 1 - 1e-9, 1 + 1e-9, false},
    {"log of all", positive_log, oracle_log_of_size, 1e-320, 1e308, true},
    {"log2", bat_log2, oracle_log2, 0.3, 3, false},
    {"log2", bat_log2, oracle_log2, 0.97, 1.03, false},
    {"log2", bat_log2, oracle_log2, 1e-300, 1e300, false},
    {"log10", bat_log10, oracle_log10, 0.3, 3, false},
    {"log10", bat_log10, oracle_log10, 0.97, 1.03, false},
    {"log10", bat_log10, oracle_log10, 1e-300, 1e300, false},
};

TEST(logarithms_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

static const oracle_value strange[] = {
    {0, -INFINITY}, {-0.0, -INFINITY}, {1, 0},     {INFINITY, INFINITY},
    {-1, NAN},      {-INFINITY, NAN},  {NAN, NAN}, {-0x1p-1074, NAN}};

TEST(logarithms_follow_annex_f_of_c)
{
    oracle_check_values(bat_log, strange, COUNT(strange));
    oracle_check_values(bat_log2, strange, COUNT(strange));
    oracle_check_values(bat_log10, strange, COUNT(strange));
}

TEST(logarithms_of_powers_of_two_and_ten_are_whole)
{
    for (int n = -1074; n < 1024; n++)
        CHECK_BITS(bat_log2(ldexp(1, n)), n);
    double power = 1;
    for (int n = 0; n <= 22; n++, power *= 10)
        CHECK_BITS(bat_log10(power), n);
}

/* Where the octave begins, where the table changes, about 1, and at the least numbers. */
static const double seams[] = {0.6875, 1.375, 1,     1 - 0x1p-8, 1 + 0x1p-7, 1 + 0x1p-6,
                               0.75,   2,     1e300, DBL_MIN,    1e-310};

TEST(logarithms_rise)
{
    oracle_check_order(bat_log, seams, COUNT(seams), 1);
    oracle_check_order(bat_log2, seams, COUNT(seams), 1);
    oracle_check_order(bat_log10, seams, COUNT(seams), 1);
}
