#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"sinh", bat_sinh, oracle_sinh, -1, 1, false},
    {"sinh", bat_sinh, oracle_sinh, 0.24, 0.26, false},
    {"sinh", bat_sinh, oracle_sinh, 1e-17, 700, true},
    {"sinh", bat_sinh, oracle_sinh, -30, 30, false},
    {"cosh", bat_cosh, oracle_cosh, -1, 1, false},
    {"cosh", bat_cosh, oracle_cosh, 1e-17, 700, true},
    {"cosh", bat_cosh, oracle_cosh, -30, 30, false},
};

TEST(hyperbolic_functions_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

static const oracle_value sines[] = {{0, 0},
                                     {-0.0, -0.0},
                                     {INFINITY, INFINITY},
                                     {-INFINITY, -INFINITY},
                                     {NAN, NAN},
                                     {0x1p-1074, 0x1p-1074},
                                     {-1000, -INFINITY},
                                     {710.4758600739440, INFINITY},
                                     {710.4758600739439, 0x1.ffffffffffd3bp1023}};
static const oracle_value cosines[] = {{0, 1},
                                       {-0.0, 1},
                                       {INFINITY, INFINITY},
                                       {-INFINITY, INFINITY},
                                       {NAN, NAN},
                                       {0x1p-1074, 1},
                                       {-1000, INFINITY},
                                       {710.4758600739440, INFINITY},
                                       {710.4758600739439, 0x1.ffffffffffd3bp1023}};

TEST(hyperbolic_functions_follow_annex_f_of_c)
{
    oracle_check_values(bat_sinh, sines, COUNT(sines));
    oracle_check_values(bat_cosh, cosines, COUNT(cosines));
}

static const double seams[] = {0.25, 0.3, 1, 23, 700};

TEST(hyperbolic_functions_rise)
{
    oracle_check_order(bat_sinh, seams, COUNT(seams), 1);
    oracle_check_order(bat_cosh, seams, COUNT(seams), 1);
}
