/* Intervals that are halved until their pieces are good. */
#include "numeric/halving.h"
#include "support/test.h"

TEST(pieces_of_a_halved_interval_follow_one_another_and_are_the_largest_good_ones)
{
    /* A piece is good when it is no longer than its distance from 0, or 1/64. */
    bat_halving h = bat_halving_of(0, 1, 10);
    double end = 0;
    int count = 0;
    while (h.waiting > 0) {
        const double length = h.b - h.a;
        if (length > 1.0 / 64 && length > h.a) {
            CHECK(bat_halving_split(&h));
            continue;
        }
        CHECK_NEAR(h.a, end, 0);
        end = h.b;
        count++;
        bat_halving_accept(&h);
    }
    CHECK_NEAR(end, 1, 0);
    CHECK_INT(count, 7); /* 1/64, and 1/64, 1/32 ... 1/2 */
}

TEST(a_piece_is_halved_as_often_as_was_allowed_at_either_end)
{
    for (int right = 0; right < 2; right++) {
        bat_halving h = bat_halving_of(0, 1, 7);
        int splits = 0;
        for (; h.waiting > 0; bat_halving_accept(&h))
            while ((!right || h.b == 1) && bat_halving_split(&h))
                splits++;
        CHECK_INT(splits, right ? 7 : 127);
    }
}

TEST(an_interval_without_a_number_between_its_ends_is_not_halved)
{
    bat_halving h = bat_halving_of(1, nextafter(1, 2), 40);
    CHECK(!bat_halving_split(&h));
    CHECK_INT(h.waiting, 1);
}
