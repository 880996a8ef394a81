#include "numeric/box.h"

#include "support/test.h"

TEST(a_box_of_nothing_becomes_what_joins_it)
{
    batten_box box = bat_box_of_nothing();
    CHECK(bat_box_is_of_nothing(box));
    bat_box_join(&box, bat_box_of_nothing());
    CHECK(bat_box_is_of_nothing(box));
    bat_box_join(&box, bat_box_at((double[]){1, -2, 3}));
    CHECK(!bat_box_is_of_nothing(box));
    bat_box_join(&box, (batten_box){{0, 0, 0}, {0.5, 4, 1}});
    CHECK(box.low.x == 0 && box.low.y == -2 && box.low.z == 0);
    CHECK(box.high.x == 1 && box.high.y == 4 && box.high.z == 3);
}

TEST(its_diagonal_reaches_from_corner_to_corner)
{
    CHECK(bat_box_diagonal((batten_box){{1, -2, 3}, {3, 1, 9}}) == 7);
    CHECK(bat_box_diagonal(bat_box_at((double[]){5, 6, 7})) == 0);
    /* Neither squares that overflow nor such that vanish matter. */
    CHECK(bat_box_diagonal((batten_box){{0, 0, 0}, {0x2p1000, 0x3p1000, 0x6p1000}}) ==
          0x7p1000);
    CHECK(bat_box_diagonal((batten_box){{0, -0x3p-1000, 0}, {0x2p-1000, 0, 0x6p-1000}}) ==
          0x7p-1000);
}
