#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"exp", bat_exp, oracle_exp, -1, 1, false},
    {"exp", bat_exp, oracle_exp, -707, 709.7, false},
    {"exp", bat_exp, oracle_exp, -745, -708, false},
    {"exp", bat_exp, oracle_exp, 1e-18, 1, true},
    {"expm1", bat_expm1, oracle_expm1, -1, 1, false},
    {"expm1", bat_expm1, oracle_expm1, 1e-17, 43, true},
    {"expm1", bat_expm1, oracle_expm1, 1e-3, 0.1, true},
    {"expm1", bat_expm1, oracle_expm1, 0.002, 0.006, true},
    {"expm1", bat_expm1, oracle_expm1, 0.68, 0.7, true},
    {"expm1", bat_expm1, oracle_expm1, 40, 709.7, false},
};

TEST(powers_of_e_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

static const oracle_value powers[] = {{0, 1},
                                      {-0.0, 1},
                                      {INFINITY, INFINITY},
                                      {-INFINITY, 0},
                                      {NAN, NAN},
                                      {0x1p-54, 1},
                                      {-0x1p-60, 1},
                                      {710, INFINITY},
                                      {DBL_MAX, INFINITY},
                                      {-746, 0},
                                      {-745.13, 0x1p-1074},
                                      {-DBL_MAX, 0},
                                      {0x1p-1074, 1}};
static const oracle_value less_one[] = {
    {0, 0},     {-0.0, -0.0},           {INFINITY, INFINITY}, {-INFINITY, -1},
    {NAN, NAN}, {0x1p-1074, 0x1p-1074}, {-0x1p-60, -0x1p-60}, {710, INFINITY},
    {-50, -1},  {-DBL_MAX, -1}};

TEST(powers_of_e_follow_annex_f_of_c)
{
    oracle_check_values(bat_exp, powers, COUNT(powers));
    oracle_check_values(bat_expm1, less_one, COUNT(less_one));
}

/* Where the table changes, where a power of two does, and where results become subnormal. */
static const double seams[] = {0,
                               0x1.62e42fefa39efp-9,
                               0x1.0a2b23f3bab73p-7,
                               0x1p-8,
                               0.6875,
                               -0.6875,
                               0x1.62e42fefa39efp-2,
                               1,
                               -708,
                               -708.3964185322641,
                               -745,
                               709};

TEST(powers_of_e_rise)
{
    oracle_check_order(bat_exp, seams, COUNT(seams), 1);
    oracle_check_order(bat_expm1, seams, COUNT(seams), 1);
}
