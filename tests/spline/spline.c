#include "spline/spline.h"

#include "support/test.h"

TEST(a_spline_begins_with_zeros_and_ends_empty)
{
    bat_spline spline;
    CHECK_OK(bat_spline_make(3, 5, 2, &spline));
    CHECK(spline.degree == 3 && spline.count == 5 && spline.width == 2);
    CHECK(spline.knots[8] == 0 && spline.values[9] == 0);
    bat_spline_free(&spline);
    CHECK(spline.knots == NULL && spline.values == NULL);
    CHECK(spline.degree == 0 && spline.count == 0 && spline.width == 0);
}

TEST(S1_a_spline_too_wide_for_memory_is_refused)
{
    bat_spline spline = {0};
    CHECK_STATUS(bat_spline_make(3, 5, SIZE_MAX / 4, &spline), BATTEN_OUT_OF_MEMORY);
    CHECK(spline.values == NULL);
}
