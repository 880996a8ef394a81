/* The square frame of an elementary surface, and how far points reach along it. */
#include "body/elementary/parts.h"
#include "numeric/vector.h"
#include "support/test.h"

static void check_vector(batten_vec3 v, double x, double y, double z)
{
    CHECK_NEAR(v.x, x, 1e-15);
    CHECK_NEAR(v.y, y, 1e-15);
    CHECK_NEAR(v.z, z, 1e-15);
}

/* Extrusions and revolutions have no x of their own: it is that of the world where z leaves room
 * for it, else y. */
TEST(the_frame_of_an_elementary_surface_is_square)
{
    static const struct {
        bat_elementary_kind kind;
        batten_vec3 x, z, due[3];
    } cases[] = {
        {BAT_CYLINDER, {2, 0, 0}, {0, 0, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {BAT_CYLINDER, {2, 0, 5}, {0, 0, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {BAT_PLANE, {0, 0, 2}, {0, -3, 0}, {{0, 0, 1}, {-1, 0, 0}, {0, -1, 0}}},
        {BAT_EXTRUSION, {9, 9, 9}, {0, 0, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        {BAT_EXTRUSION, {9, 9, 9}, {4, 0, 0}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
        {BAT_EXTRUSION, {9, 9, 9}, {0, -2, 0}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}},
        {BAT_REVOLUTION, {9, 9, 9}, {-4, 0, 0}, {{0, 1, 0}, {0, 0, -1}, {-1, 0, 0}}},
        {BAT_REVOLUTION, {9, 9, 9}, {0, 3, 4}, {{1, 0, 0}, {0, 0.8, -0.6}, {0, 0.6, 0.8}}},
        /* 0.6 of z along x is not yet too much, 0.8 is */
        {BAT_EXTRUSION, {9, 9, 9}, {3, 0, 4}, {{0.8, 0, -0.6}, {0, 1, 0}, {0.6, 0, 0.8}}},
        {BAT_EXTRUSION, {9, 9, 9}, {4, 0, 3}, {{0, 1, 0}, {-0.6, 0, 0.8}, {0.8, 0, 0.6}}},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        const bat_elementary e = {.kind = cases[i].kind,
                                  .frame = {{1, 2, 3}, cases[i].x, cases[i].z}};
        batten_frame square;
        batten_vec3 y;
        CHECK_OK(bat_elementary_frame(&e, &square, &y));
        const batten_vec3 *due = cases[i].due;
        check_vector(square.x, due[0].x, due[0].y, due[0].z);
        check_vector(y, due[1].x, due[1].y, due[1].z);
        check_vector(square.z, due[2].x, due[2].y, due[2].z);
        check_vector(square.origin, 1, 2, 3);
    }
}

TEST(points_reach_from_their_least_to_their_largest_coordinate)
{
    static const double points[] = {1, 2, 3, -4, 9, 3.5, 0, 2, -1};
    static const double due[3][2] = {{-5, 0}, {0, 7}, {-4, 0.5}};
    bat_stand stand = {.frame = {{1, 2, 3}, {1, 0, 0}, {0, 0, 1}},
                       .y = {0, 1, 0},
                       .count = 3,
                       .points = points};
    for (int axis = 0; axis < 3; axis++) {
        const batten_interval range = bat_stand_range(&stand, axis);
        CHECK_BITS(range.a, due[axis][0]);
        CHECK_BITS(range.b, due[axis][1]);
    }
    stand.count = 0;
    CHECK(bat_stand_range(&stand, 0).a > bat_stand_range(&stand, 0).b);
}
