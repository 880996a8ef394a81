#include "base/arena.h"

#include "support/test.h"

static batten_status take(bat_arena *arena, size_t count, size_t size, unsigned char **out)
{
    unsigned char *memory = bat_arena_array(arena, count, size);
    if (memory)
        *out = memory;
    return bat_arena_status(arena);
}

TEST(arrays_of_an_arena_are_zero_and_apart_and_aligned)
{
    bat_arena arena = {0};
    unsigned char *pieces[200];
    for (int i = 0; i < 200; i++) {
        const size_t size = (size_t)(1 + i * 7);
        CHECK_OK(take(&arena, size, 1, &pieces[i]));
        CHECK((uintptr_t)pieces[i] % _Alignof(max_align_t) == 0);
        for (size_t k = 0; k < size; k++)
            CHECK(pieces[i][k] == 0);
        memset(pieces[i], i, size);
    }
    for (int i = 0; i < 200; i++)
        for (int k = 0; k < 1 + i * 7; k++)
            CHECK(pieces[i][k] == i);
    bat_arena_free(&arena);
}

TEST(an_array_may_be_larger_than_any_block)
{
    bat_arena arena = {0};
    unsigned char *small, *large, *next;
    CHECK_OK(take(&arena, 1, 1, &small));
    CHECK_OK(take(&arena, 3, 100000, &large));
    CHECK_OK(take(&arena, 0, 8, &next));
    memset(large, 255, 300000);
    CHECK(*small == 0);
    bat_arena_free(&arena);
}

TEST(many_small_arrays_share_few_blocks)
{
    bat_arena arena = {0};
    unsigned char *piece;
    for (int i = 0; i < 1000; i++)
        CHECK_OK(take(&arena, 2, 8, &piece));
    int blocks = 0;
    for (const bat_arena_block *block = arena.last; block; block = block->before)
        blocks++;
    CHECK(blocks <= 5);
    bat_arena_free(&arena);
    CHECK(arena.last == NULL);
    CHECK_OK(take(&arena, 2, 8, &piece));
    bat_arena_free(&arena);
}

TEST(an_arena_refuses_sizes_that_wrap_and_is_asked_once)
{
    bat_arena arena = {0};
    CHECK(bat_arena_array(&arena, SIZE_MAX / 2, 4) == NULL);
    CHECK_MESSAGE("no memory");
    CHECK_INT(bat_arena_status(&arena), BATTEN_OUT_OF_MEMORY);
    CHECK_OK(bat_arena_status(&arena));
    bat_arena_free(&arena);
}

TEST(a_copy_ends_with_a_zero_byte)
{
    bat_arena arena = {0};
    const char *copy = bat_arena_copy(&arena, "keelson", 4),
               *none = bat_arena_copy(&arena, "", 0);
    if (bat_arena_status(&arena) == BATTEN_OK) {
        CHECK_TEXT(copy, "keel");
        CHECK_TEXT(none, "");
    }
    bat_arena_free(&arena);
}
