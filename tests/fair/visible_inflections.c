#include <batten/fair.h>

#include "support/test.h"

#include <math.h>

TEST(visible_inflections_ignore_low_bulges)
{
    double points[2 * 101];
    for (int i = 0; i <= 100; i++) {
        points[2 * i] = i;
        points[2 * i + 1] = sin(i * 0.2); /* 20 radians: 6 zeros inside (0, 20) */
    }
    CHECK_INT(batten_polyline_inflections(101, points, 0.05), 6);
    CHECK_INT(batten_polyline_inflections(101, points, 3.0), 0);
    for (int i = 0; i <= 100; i++)
        points[2 * i + 1] = 1e-3 * i * i + 0.001 * (i % 2);
    CHECK_INT(batten_polyline_inflections(101, points, 0.01), 0);
    CHECK(batten_polyline_inflections(101, points, 0) > 10);
    CHECK_INT(batten_polyline_inflections(2, points, 0), 0);
}
