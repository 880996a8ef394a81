#include "spline/curve.h"

#include "support/test.h"

TEST(a_frame_is_made_square_and_keeps_its_z_axis)
{
    const batten_frame frame = {{1, 2, 3}, {0, 3, 1}, {0, 0, 2}};
    batten_frame square;
    batten_vec3 y;
    CHECK_OK(bat_frame_square(&frame, &square, &y));
    CHECK(square.origin.x == 1 && square.z.x == 0 && square.z.z == 1);
    CHECK_NEAR(square.x.y, 1, 1e-15);
    CHECK_NEAR(square.x.z, 0, 1e-15);
    CHECK_NEAR(y.x, -1, 1e-15);
    const batten_frame world = batten_frame_world();
    CHECK(world.x.x == 1 && world.z.z == 1 && world.origin.y == 0);
}
