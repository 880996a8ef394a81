#include "spline/curve/curve.h"

#include "support/test.h"

#include <batten/standard.h>

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

TEST(N1_each_coordinate_of_a_frame_must_be_a_number)
{
    for (int i = 0; i < 9; i++) {
        double v[9] = {1, 2, 3, 1, 0, 0, 0, 0, 1};
        v[i] = i % 2 ? NAN : INFINITY;
        const batten_frame frame = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7], v[8]}};
        batten_curve *none = NULL;
        CHECK_STATUS(batten_curve_arc_in(&frame, 1, 0, 1, &none), BATTEN_NOT_FINITE);
        CHECK(none == NULL);
    }
}
