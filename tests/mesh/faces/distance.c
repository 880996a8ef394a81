/* Distances from segments and triangles, in the positions where another part of them is nearest,
 * and of any size. */
#include "mesh/faces/meshing.h"
#include "support/test.h"

#include <math.h>

static const double SIZES[] = {1, 1e100, 1e-100, 0x1p-500};

TEST(a_segment_is_as_far_as_its_nearest_point)
{
    static const struct {
        double p[3], distance;
    } cases[] = {{{1, 0, 0}, 0}, {{1, 3, 4}, 5}, {{0, 0, 2}, 2}, {{-3, 4, 0}, 5},
                 {{7, 0, 0}, 3}, {{4, 1, 0}, 1}, {{2, 0, 0}, 0}, {{6, 1, 2}, 3}};
    for (int s = 0; s < COUNT(SIZES); s++)
        for (int i = 0; i < COUNT(cases); i++) {
            const double f = SIZES[s], a[3] = {0, 0, 0}, b[3] = {4 * f, 0, 0};
            const double p[3] = {f * cases[i].p[0], f * cases[i].p[1], f * cases[i].p[2]};
            CHECK_NEAR(bat_distance_to_segment(p, a, b) / f, cases[i].distance, 1e-14);
            CHECK_NEAR(bat_distance_to_segment(p, b, a) / f, cases[i].distance, 1e-14);
            CHECK_NEAR(bat_distance_to_segment(p, p, p) / f, 0, 0);
        }
}

/* (0, 0), (4, 0), (0, 3) in the plane z = 0: the least height is 12 / 5. */
TEST(a_triangle_is_as_far_as_its_plane_over_it_and_a_little_beside)
{
    static const struct {
        double p[3], distance;
    } cases[] = {{{1, 1, 2}, 2},    {{1, 1, -2}, 2},    {{0, 0, 5}, 5},        {{2, 1.5, 1}, 1},
                 {{1, -1, 2}, 2},   {{1, -1.19, 0}, 0}, {{1, -1.21, 0}, 1.21}, {{-2, 1, 0}, 2},
                 {{-3, -4, 0}, 5},  {{4, -3, 4}, 5},    {{7, 0, 4}, 5},        {{0, 6, 4}, 5},
                 {{5, 4.5, 0}, 4.2}};
    for (int s = 0; s < COUNT(SIZES); s++)
        for (int i = 0; i < COUNT(cases); i++) {
            const double f = SIZES[s];
            const double at[3][3] = {{0, 0, 0}, {4 * f, 0, 0}, {0, 3 * f, 0}};
            const double p[3] = {f * cases[i].p[0], f * cases[i].p[1], f * cases[i].p[2]};
            for (int k = 0; k < 3; k++) {
                const double *a = at[k], *b = at[(k + 1) % 3], *c = at[(k + 2) % 3];
                CHECK_NEAR(bat_distance_to_triangle(p, a, b, c) / f, cases[i].distance, 1e-13);
                CHECK_NEAR(bat_distance_to_triangle(p, a, c, b) / f, cases[i].distance, 1e-13);
            }
        }
}

TEST(a_triangle_without_area_is_its_longest_edge)
{
    const double a[3] = {0, 0, 0}, b[3] = {4, 0, 0}, c[3] = {1, 0, 0}, p[3] = {2, 3, 4};
    CHECK_NEAR(bat_distance_to_triangle(p, a, b, c), 5, 1e-15);
    CHECK_NEAR(bat_distance_to_triangle(p, c, a, b), 5, 1e-15);
    CHECK_NEAR(bat_distance_to_triangle(p, a, a, a), sqrt(29), 1e-15);
}
