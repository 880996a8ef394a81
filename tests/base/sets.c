#include "base/sets.h"

#include "support/test.h"

TEST(sets_that_are_joined_have_their_lowest_number_as_root)
{
    enum { COUNT = 7 };
    int of[COUNT];
    bat_sets_begin(COUNT, of);
    for (int i = 0; i < COUNT; i++)
        CHECK_INT(bat_sets_root(of, i), i);
    CHECK(bat_sets_join(of, 6, 4));
    CHECK(bat_sets_join(of, 2, 3));
    CHECK_INT(bat_sets_root(of, 6), 4);
    CHECK_INT(bat_sets_root(of, 3), 2);
    CHECK(bat_sets_join(of, 3, 6));
    CHECK(!bat_sets_join(of, 4, 2));
    CHECK(!bat_sets_join(of, 5, 5));
    static const int roots[COUNT] = {0, 1, 2, 2, 2, 5, 2};
    for (int i = 0; i < COUNT; i++)
        CHECK_INT(bat_sets_root(of, i), roots[i]);
}

/* Each joined to the one before it from the end on, so that nothing is halved but by the last call. */
TEST(a_long_path_becomes_short_by_asking)
{
    enum { COUNT = 1000 };
    int of[COUNT];
    bat_sets_begin(COUNT, of);
    for (int i = COUNT - 1; i > 0; i--)
        CHECK(bat_sets_join(of, i - 1, i));
    CHECK_INT(of[COUNT - 1], COUNT - 2);
    CHECK_INT(bat_sets_root(of, COUNT - 1), 0);
    /* Every second one on the path leads two on. */
    CHECK_INT(of[COUNT - 1], COUNT - 3);
    CHECK_INT(of[COUNT - 2], COUNT - 3);
    CHECK_INT(of[COUNT - 3], COUNT - 5);
}
