#include "design/text/pool.h"

#include "support/test.h"

static batten_status take(bat_pool *pool, size_t count, size_t size, unsigned char **out)
{
    unsigned char *memory = bat_pool_array(pool, count, size);
    if (!memory)
        return BATTEN_OUT_OF_MEMORY;
    *out = memory;
    return BATTEN_OK;
}

TEST(pieces_of_a_pool_are_zero_and_apart)
{
    bat_pool pool = {NULL};
    unsigned char *pieces[200];
    for (int i = 0; i < 200; i++) {
        const size_t size = (size_t)(1 + i * 7);
        CHECK_OK(take(&pool, size, 1, &pieces[i]));
        for (size_t k = 0; k < size; k++)
            CHECK(pieces[i][k] == 0);
        memset(pieces[i], i, size);
    }
    for (int i = 0; i < 200; i++)
        for (int k = 0; k < 1 + i * 7; k++)
            CHECK(pieces[i][k] == i);
    bat_pool_free(&pool);
}

TEST(a_pool_refuses_sizes_that_wrap)
{
    bat_pool pool = {NULL};
    CHECK(bat_pool_array(&pool, SIZE_MAX / 2, 4) == NULL);
    CHECK_MESSAGE("no memory");
    bat_pool_free(&pool);
}
