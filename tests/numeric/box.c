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
