#include <batten/text.h>

#include "support/test.h"

TEST(units_have_their_lengths)
{
    CHECK_BITS(batten_unit_metres("m"), 1);
    CHECK_BITS(batten_unit_metres("mm"), 0.001);
    CHECK_BITS(batten_unit_metres("inches"), 0.0254);
    CHECK_BITS(batten_unit_metres("foot"), 0.3048);
    CHECK_BITS(batten_unit_metres("micron"), 1e-6);
    CHECK_BITS(batten_unit_metres("yards"), 0.9144);
    CHECK_BITS(batten_unit_metres("furlong"), 0);
    CHECK_BITS(batten_unit_metres(""), 0);
}

TEST(every_unit_knows_its_short_name)
{
    static const char *const names[] = {"m",   "mm",  "cm", "km",       "um",  "in",
                                        "ft",  "mil", "mi", "uin",      "yd",  "dm",
                                        "dam", "hm",  "nm", "angstrom", "usft"};
    for (int i = 0; i < COUNT(names); i++)
        CHECK_TEXT(batten_unit_name(batten_unit_metres(names[i])), names[i]);
    CHECK_TEXT(batten_unit_name(0.0254 / 1000), "mil");
    CHECK(batten_unit_name(0.5) == NULL);
    CHECK(batten_unit_name(0) == NULL);
    CHECK(batten_unit_name(NAN) == NULL);
}
