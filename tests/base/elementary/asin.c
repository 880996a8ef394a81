#include "base/elementary.h"

#include "oracle.h"

#include <float.h>

static const oracle_stretch stretches[] = {
    {"asin", bat_asin, oracle_asin, -1, 1, false},
    {"asin", bat_asin, oracle_asin, 1e-9, 1, true},
    {"asin", bat_asin, oracle_asin, 0.09, 0.1, false},
    {"asin", bat_asin, oracle_asin, 0.5, 0.6, false},
    {"asin", bat_asin, oracle_asin, 0.999, 1, false},
    {"acos", bat_acos, oracle_acos, -1, 1, false},
    {"acos", bat_acos, oracle_acos, 1e-9, 1, true},
    {"acos", bat_acos, oracle_acos, 0.5, 0.6, false},
    {"acos", bat_acos, oracle_acos, 0.98, 0.985, false},
    {"acos", bat_acos, oracle_acos, 0.999, 1, false},
    {"acos", bat_acos, oracle_acos, -1, -0.999, false},
};

TEST(arc_sines_and_cosines_are_within_0_55_units_of_the_last_place)
{
    oracle_check(stretches, COUNT(stretches), 0.55);
}

#define QUARTER 0x1.921fb54442d18p0 /* pi/2 rounded */

static const oracle_value sines[] = {{0, 0},
                                     {-0.0, -0.0},
                                     {1, QUARTER},
                                     {-1, -QUARTER},
                                     {1 + DBL_EPSILON, NAN},
                                     {-2, NAN},
                                     {INFINITY, NAN},
                                     {NAN, NAN},
                                     {0x1p-1074, 0x1p-1074},
                                     {0.5, 0x1.0c152382d7366p-1}};
static const oracle_value cosines[] = {{0, QUARTER},
                                       {-0.0, QUARTER},
                                       {1, 0},
                                       {-1, 2 * QUARTER},
                                       {1 + DBL_EPSILON, NAN},
                                       {-2, NAN},
                                       {-INFINITY, NAN},
                                       {NAN, NAN},
                                       {0x1p-1074, QUARTER},
                                       {0.5, 0x1.0c152382d7366p0}};

TEST(arc_sines_and_cosines_follow_annex_f_of_c)
{
    oracle_check_values(bat_asin, sines, COUNT(sines));
    oracle_check_values(bat_acos, cosines, COUNT(cosines));
}

/* Where the series give way to each other. */
static const double seams[] = {
    0, 0x1p-27, 0.0922, 24.5 / 256, 0.3, 0.5, -0.5, 0.7071067811865476, 0.983, 0.99, -0.99};

TEST(arc_sines_rise_and_arc_cosines_fall)
{
    oracle_check_order(bat_asin, seams, COUNT(seams), 1);
    oracle_check_order(bat_acos, seams, COUNT(seams), -1);
}
