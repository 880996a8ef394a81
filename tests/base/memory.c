#include "base/base.h"

#include "support/test.h"

TEST(S1_products_that_wrap_are_refused)
{
    CHECK(bat_array(SIZE_MAX / 2 + 1, 2) == NULL);
    CHECK(bat_array3(SIZE_MAX / 4, 8, 1) == NULL);
    CHECK(bat_array((size_t)PTRDIFF_MAX + 1, 1) == NULL);
    CHECK_MESSAGE("no memory");
}

static batten_status make(double **array)
{
    double *made = bat_array(3, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    *array = made;
    return BATTEN_OK;
}

TEST(arrays_begin_with_zeros)
{
    double *array = NULL;
    CHECK_OK(make(&array));
    CHECK(array[0] == 0 && array[1] == 0 && array[2] == 0);
    bat_release(array);
}

TEST(an_array_of_nothing_may_be_released)
{
    void *nothing = bat_array(0, 8);
    if (nothing)
        bat_release(nothing);
    bat_release(NULL);
}
