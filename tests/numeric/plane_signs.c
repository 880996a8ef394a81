#include "numeric/plane_signs.h"

#include "support/test.h"

__extension__ typedef __int128 wide;

static int sign_of(wide value)
{
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

static wide circle(long long p[4][2])
{
    wide x[3], y[3], s[3];
    for (int i = 0; i < 3; i++) {
        x[i] = p[i][0] - p[3][0];
        y[i] = p[i][1] - p[3][1];
        s[i] = x[i] * x[i] + y[i] * y[i];
    }
    return s[0] * (x[1] * y[2] - x[2] * y[1]) + s[1] * (x[2] * y[0] - x[0] * y[2]) +
           s[2] * (x[0] * y[1] - x[1] * y[0]);
}

TEST(sides_of_circles_and_lines_are_those_of_whole_numbers)
{
    test_random random = test_random_begin(__func__);
    for (int n = test_cases(3000); n > 0; n--) {
        /* four points near one circle, or on one grid */
        const double angle = test_random_in(&random, 0, 3), radius = n % 3 ? 1e8 : 5;
        long long p[4][2];
        double q[4][2];
        for (int i = 0; i < 4; i++) {
            p[i][0] = (long long)(radius * cos(angle + i));
            p[i][1] = (long long)(radius * sin(angle + i));
            for (int k = 0; k < 2; k++)
                q[i][k] = (double)p[i][k] * 0x1p-30;
        }
        const wide side = (wide)(p[0][0] - p[2][0]) * (p[1][1] - p[2][1]) -
                          (wide)(p[0][1] - p[2][1]) * (p[1][0] - p[2][0]);
        CHECK_INT(bat_orientation(q[0], q[1], q[2]), sign_of(side));
        CHECK_INT(bat_in_circle(q[0], q[1], q[2], q[3]), sign_of(circle(p)));
    }
}

TEST(tiny_steps_beside_large_coordinates_decide)
{
    const double a[2] = {0, 0}, b[2] = {1, 1}, c[2] = {0x1p-60, 0x1p-60};
    const double above[2] = {0x1p-60, 0x1p-60 + 0x1p-112},
                 below[2] = {0x1p-60 + 0x1p-112, 0x1p-60};
    CHECK_INT(bat_orientation(a, b, c), 0);
    CHECK_INT(bat_orientation(a, b, above), 1);
    CHECK_INT(bat_orientation(a, b, below), -1);
    const double east[2] = {1, 0}, corner[2] = {1, 1}, north[2] = {0, 1},
                 inside[2] = {0, 0x1p-200};
    CHECK_INT(bat_in_circle(east, corner, north, a), 0);
    CHECK_INT(bat_in_circle(east, corner, north, inside), 1);
}
