/* Decimal numbers that a change of the unit has moved by a last place. */
#include "model/short_decimal.h"
#include "support/test.h"

#include <stdlib.h>

static double moved(double x, int places)
{
    for (; places > 0; places--)
        x = nextafter(x, INFINITY);
    for (; places < 0; places++)
        x = nextafter(x, -INFINITY);
    return x;
}

TEST(a_number_within_two_last_places_of_a_short_decimal_is_it)
{
    static const double decimals[] = {0.1,   25.4, 1234.5678, 1e-9,   -0.3,      7,
                                      1e15,  3e20, -123456e9, 1e-300, 0.0000123, 1e22,
                                      30.48, 1e12, 1e13,      1e14,   9.999,     1.0000000001};
    for (int i = 0; i < COUNT(decimals); i++)
        for (int k = -2; k <= 2; k++) {
            const double x = moved(decimals[i], k);
            /* below 1e-10 and above 1e34 powers of ten are no doubles: nothing is done */
            const bool is_done = fabs(x) > 1e-9 * (1 - 1e-9);
            CHECK_BITS(bat_near_decimal(x), is_done ? decimals[i] : x);
        }
}

TEST(a_number_farther_away_stays_to_the_bit)
{
    static const double decimals[] = {0.1, 25.4, 1234.5678, -0.3, 7, 3e20};
    for (int i = 0; i < COUNT(decimals); i++) {
        CHECK_BITS(bat_near_decimal(moved(decimals[i], 5)), moved(decimals[i], 5));
        CHECK_BITS(bat_near_decimal(moved(decimals[i], -5)), moved(decimals[i], -5));
    }
    CHECK_BITS(bat_near_decimal(1.0 / 3), 1.0 / 3);
    CHECK_BITS(bat_near_decimal(acos(-1)), acos(-1));
    CHECK_BITS(bat_near_decimal(1e5 * acos(-1)), 1e5 * acos(-1));
}

TEST(nothing_infinity_and_what_is_no_number_stay)
{
    CHECK_BITS(bat_near_decimal(0.0), 0.0);
    CHECK_BITS(bat_near_decimal(-0.0), -0.0);
    CHECK_BITS(bat_near_decimal(INFINITY), INFINITY);
    CHECK(isnan(bat_near_decimal(NAN)));
    CHECK_BITS(bat_near_decimal(5e-324), 5e-324);
    CHECK_BITS(bat_near_decimal(DBL_MAX), DBL_MAX);
}
