#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"sin", bat_sin, oracle_sin, -10, 10, false},
    {"sin", bat_sin, oracle_sin, 1e-9, 1, true},
    {"sin", bat_sin, oracle_sin, 1, 1e6, true},
    {"cos", bat_cos, oracle_cos, -10, 10, false},
    {"cos", bat_cos, oracle_cos, 1e-9, 1, true},
    {"cos", bat_cos, oracle_cos, 1, 1e6, true},
    {"tan", bat_tan, oracle_tan, -10, 10, false},
    {"tan", bat_tan, oracle_tan, 1e-9, 1, true},
    {"tan", bat_tan, oracle_tan, 1, 1e6, true},
    {"tan", bat_tan, oracle_tan, 0.77, 0.8, false},
};

TEST(sines_cosines_and_tangents_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

static const oracle_value sines[] = {
    {0, 0},     {-0.0, -0.0},           {INFINITY, NAN},         {-INFINITY, NAN},
    {NAN, NAN}, {0x1p-1074, 0x1p-1074}, {-0x1p-1022, -0x1p-1022}};
static const oracle_value cosines[] = {{0, 1},           {-0.0, 1},  {INFINITY, NAN},
                                       {-INFINITY, NAN}, {NAN, NAN}, {0x1p-1074, 1},
                                       {0x1p-28, 1}};

TEST(sines_cosines_and_tangents_follow_annex_f_of_c)
{
    oracle_check_values(bat_sin, sines, COUNT(sines));
    oracle_check_values(bat_tan, sines, COUNT(sines));
    oracle_check_values(bat_cos, cosines, COUNT(cosines));
}

TEST(sine_and_cosine_made_together_are_those_made_alone)
{
    test_random random = test_random_begin("sincos");
    for (int n = test_cases(5000); n > 0; n--) {
        const double x =
            ldexp(test_random_in(&random, -1, 1), test_random_int(&random, -40, 1023));
        double sine, cosine;
        bat_sincos(x, &sine, &cosine);
        CHECK_BITS(sine, bat_sin(x));
        CHECK_BITS(cosine, bat_cos(x));
        CHECK_BITS(bat_sin(-x), -bat_sin(x));
        CHECK_BITS(bat_cos(-x), bat_cos(x));
        CHECK_BITS(bat_tan(-x), -bat_tan(x));
    }
}

/* Where a step of the table begins, in both octaves. */
static const double rising[] = {
    0, 0x1.921fb54442d18p-7, 0x1.921fb54442d18p-6, 0x1.2d97c7f3321d2p-5, 0.25, 0.5, 1, 1.5};

TEST(sines_and_tangents_rise_and_cosines_fall)
{
    oracle_check_order(bat_sin, rising, COUNT(rising), 1);
    oracle_check_order(bat_tan, rising, COUNT(rising), 1);
    oracle_check_order(bat_cos, rising + 1, COUNT(rising) - 1, -1);
}
