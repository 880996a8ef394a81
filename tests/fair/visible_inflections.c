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

static const struct {
    int count;
    double points[16];
    double height;
    int inflections;
} waves[] = {
    /* bulges of 1 to one side and to the other, with a straight point between them */
    {5, {0, 0, 1, 1, 2, 0, 3, -1, 4, 0}, 0, 1},
    {5, {0, 0, 1, 1, 2, 0, 3, -1, 4, 0}, 0.999, 1},
    {5, {0, 0, 1, 1, 2, 0, 3, -1, 4, 0}, 1, 0},     /* only what is higher counts */
    {5, {0, 0, 1, 1, 0, 2, -1, 3, 0, 4}, 0.999, 1}, /* upright */
    /* bulges of 2, then 1, then 2: the low one goes, and with it both inflections */
    {8, {0, 0, 1, 2, 2, 2, 3, 0, 4, -1, 5, 0, 6, 2, 7, 0}, 0, 2},
    /* a bulge whose chord has no length is as high as its farthest point, sqrt 10; the next is 1 */
    {5, {0, 0, 3, 0, 3, 1, 0, 0, 0, 1}, 0.99, 1},
    {5, {0, 0, 3, 0, 3, 1, 0, 0, 0, 1}, 1, 0},
    {3, {0, 0, 1, 1, 2, 0}, 0, 0},
    {0, {0}, 0, 0},
};

TEST(bulges_count_when_they_are_higher_than_the_height)
{
    for (int i = 0; i < COUNT(waves); i++)
        CHECK_INT(batten_polyline_inflections(waves[i].count, waves[i].points, waves[i].height),
                  waves[i].inflections);
}
