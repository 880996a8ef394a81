#include "base/elementary/pair.h"

#include "oracle.h"

#include <float.h>

/* Just above and below half a unit of the last place of subnormal numbers: rounding the sum first and its multiple then
 * would take the wrong side. */
TEST(what_becomes_subnormal_is_rounded_once)
{
    /* 1.5 units of 2^-1074 and a bit more or less. */
    const double low = 0x1p-52;
    CHECK_BITS(bat_twin_scaled((bat_twin){1.5, low}, -1074), 0x2p-1074);
    CHECK_BITS(bat_twin_scaled((bat_twin){1.5, -low}, -1074), 0x1p-1074);
    CHECK_BITS(bat_twin_scaled((bat_twin){0.5, low}, -1074), 0x1p-1074);
    CHECK_BITS(bat_twin_scaled((bat_twin){-0.5, low}, -1074), -0.0);
    CHECK_BITS(bat_twin_scaled((bat_twin){0.75, 0}, -2000), 0);
    CHECK_BITS(bat_twin_scaled((bat_twin){1, 0}, -1023), 0x1p-1023);
    CHECK_BITS(bat_twin_scaled((bat_twin){1, 0}, -1022), DBL_MIN);
    CHECK_BITS(bat_twin_scaled((bat_twin){1, 0}, 1023), 0x1p1023);
    CHECK_BITS(bat_twin_scaled((bat_twin){1, 0}, 1024), INFINITY);
}
