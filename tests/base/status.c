#include "base/base.h"

#include "support/test.h"

#include <float.h>

TEST(of_many_numbers_the_first_that_is_none_is_found_wherever_it_stands)
{
    enum { COUNT_OF = 67 };
    static const double none[] = {INFINITY, -INFINITY, NAN};
    double values[COUNT_OF];
    for (int at = 0; at < COUNT_OF; at++) {
        for (int i = 0; i < COUNT_OF; i++)
            values[i] = i % 2 ? -DBL_MAX : 0x1p-1074;
        CHECK_INT(bat_first_not_finite(values, COUNT_OF), COUNT_OF);
        values[COUNT_OF - 1] = NAN;
        values[at] = none[at % 3];
        CHECK_INT(bat_first_not_finite(values, COUNT_OF), at);
        CHECK_INT(bat_first_not_finite(values, (size_t)at), at);
    }
}

TEST(every_status_has_a_name_and_a_text)
{
    for (int i = 0; i < BATTEN_STATUS_COUNT; i++) {
        CHECK(*batten_status_name((batten_status)i));
        CHECK(*batten_status_text((batten_status)i));
    }
    CHECK_TEXT(batten_status_name(BATTEN_BAD_KNOTS), "BAD_KNOTS");
    CHECK_TEXT(batten_status_name((batten_status)999), "?");
    CHECK_TEXT(batten_status_text((batten_status)999), "unknown status");
    CHECK_TEXT(batten_version(), "0.1.0");
}

TEST(a_message_may_quote_the_one_before)
{
    CHECK_INT(bat_fail(BATTEN_BAD_KNOTS, "knot %d is %g", 3, 0.5), BATTEN_BAD_KNOTS);
    bat_fail(BATTEN_BAD_FORMAT, "hull.igs:7: %s", batten_message());
    CHECK_TEXT(batten_message(), "hull.igs:7: knot 3 is 0.5");
}

TEST(N1_the_first_number_that_is_not_finite_is_found)
{
    const double values[] = {1, 2, -INFINITY, NAN};
    CHECK_INT(bat_first_not_finite(values, 4), 2);
    CHECK_INT(bat_first_not_finite(values, 2), 2);
    CHECK_INT(bat_first_not_finite(values + 3, 1), 0);
    CHECK_INT(bat_first_not_finite(NULL, 0), 0);
}
