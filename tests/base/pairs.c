/* The table of pairs of numbers. */
#include "base/pairs.h"
#include "support/test.h"

TEST(pairs_keep_the_order_of_their_coming_and_are_found_by_it)
{
    enum { SIDE = 40 };
    bat_pairs pairs;
    CHECK_OK(bat_pairs_begin(&pairs, 4));
    for (int round = 0; round < 2; round++) {
        int number = 0;
        for (int a = 0; a < SIDE; a++)
            for (int b = 0; b < SIDE; b += 3) {
                int index = -1;
                CHECK_INT(bat_pairs_find(&pairs, a, b), -1);
                CHECK_OK(bat_pairs_add(&pairs, a, b, &index));
                CHECK_INT(index, number);
                CHECK_OK(bat_pairs_add(&pairs, a, b, &index)); /* again: the same */
                CHECK_INT(index, number++);
                CHECK_INT(pairs.count, number);
            }
        for (int i = 0; i < number; i++) {
            CHECK_INT(bat_pairs_find(&pairs, pairs.pairs[i][0], pairs.pairs[i][1]), i);
            CHECK_INT(pairs.pairs[i][1] % 3, 0);
        }
        CHECK_INT(bat_pairs_find(&pairs, 0, 1), -1); /* (1, 0) is not (0, 1) */
        CHECK_INT(bat_pairs_find(&pairs, SIDE, 0), -1);
        bat_pairs_clear(&pairs);
        CHECK_INT(pairs.count, 0);
    }
    bat_pairs_end(&pairs);
    CHECK(!pairs.pairs && !pairs.table);
}
