#include <batten/coons.h>

#include "support/test.h"

TEST(dimensions_and_numbers_of_corner_patches_are_checked)
{
    double corners[48] = {0};
    batten_surface *made = NULL;
    CHECK_STATUS(batten_surface_corner_patch(0, corners, BATTEN_BLENDING_CUBIC, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the dimension is 0; it must be 1, 2 or 3");
    CHECK_STATUS(batten_surface_corner_patch(4, corners, BATTEN_BLENDING_CUBIC, &made),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the dimension is 4; it must be 1, 2 or 3");
    corners[47] = NAN;
    CHECK_STATUS(batten_surface_corner_patch(3, corners, BATTEN_BLENDING_CUBIC, &made),
                 BATTEN_NOT_FINITE);
    CHECK_MESSAGE("number 48 of the corners is not finite");
    CHECK(!made);
    CHECK_OK(batten_surface_corner_patch(2, corners, BATTEN_BLENDING_CUBIC, &made));
    batten_surface_unref(made);
}
