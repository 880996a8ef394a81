#include "base/list.h"

#include "support/test.h"

typedef struct {
    double *items;
    int count, room;
} numbers;

typedef struct {
    struct pair {
        int one, other;
    } * items;
    size_t count, room;
} pairs;

TEST(a_list_keeps_its_items_as_it_grows)
{
    numbers list = {NULL, 0, 0};
    for (int i = 0; i < 1000; i++)
        CHECK_OK(BAT_LIST_ADD(list.items, list.count, list.room, i / 2.0));
    CHECK_INT(list.count, 1000);
    CHECK(list.room >= 1000 && list.room < 2000);
    for (int i = 0; i < 1000; i++)
        CHECK_BITS(list.items[i], i / 2.0);
    batten_release(list.items);
}

TEST(a_list_of_structs_is_counted_in_sizes_just_as_well)
{
    pairs list = {NULL, 0, 0};
    for (int i = 0; i < 100; i++)
        CHECK_OK(BAT_LIST_ADD(list.items, list.count, list.room, (struct pair){i, -i}));
    for (int i = 0; i < 100; i++)
        CHECK(list.items[i].one == i && list.items[i].other == -i);
    CHECK_INT((long long)list.count, 100);
    batten_release(list.items);
}

TEST(room_for_many_is_made_at_once_and_never_too_early)
{
    numbers list = {NULL, 0, 0};
    CHECK_OK(BAT_LIST_GROW(list.items, list.count, list.room, 1000));
    CHECK(list.room >= 1000);
    double *const items = list.items;
    const int room = list.room;
    list.count = room - 7;
    CHECK_OK(BAT_LIST_GROW(list.items, list.count, list.room, 7));
    CHECK(list.items == items && list.room == room);
    CHECK_OK(BAT_LIST_GROW(list.items, list.count, list.room, 8));
    CHECK(list.room > room);
    batten_release(list.items);
}

TEST(rooms_double_until_that_cannot_be_counted)
{
    CHECK_INT((long long)bat_list_next_room(0, 1), BAT_LIST_FIRST_ROOM);
    CHECK_INT((long long)bat_list_next_room(8, 9), 16);
    CHECK_INT((long long)bat_list_next_room(24, 100), 192);
    CHECK(bat_list_next_room(8, SIZE_MAX) == SIZE_MAX);
    CHECK(bat_list_next_room(SIZE_MAX / 2 + 1, SIZE_MAX / 2 + 2) == SIZE_MAX / 2 + 2);
}

TEST(what_cannot_be_counted_is_refused_and_the_list_stays_as_it_was)
{
    numbers list = {NULL, 0, 0};
    CHECK_OK(BAT_LIST_ADD(list.items, list.count, list.room, 3.5));
    double *const items = list.items;
    const int room = list.room;
    CHECK_INT(BAT_LIST_GROW(list.items, list.count, list.room, INT_MAX), BATTEN_OUT_OF_MEMORY);
    CHECK_MESSAGE("2147483647 items more than 1");
    CHECK(list.items == items && list.count == 1 && list.room == room);
    pairs wide = {NULL, 0, 0};
    CHECK_INT(BAT_LIST_GROW(wide.items, wide.count, wide.room, SIZE_MAX), BATTEN_OUT_OF_MEMORY);
    CHECK_INT(BAT_LIST_GROW(wide.items, wide.count, wide.room, SIZE_MAX / 8),
              BATTEN_OUT_OF_MEMORY);
    CHECK(wide.items == NULL && wide.room == 0);
    batten_release(list.items);
}
