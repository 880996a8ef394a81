#include <batten/geometry.h>

#include "support/test.h"

static const double pi = 3.14159265358979323846;

static void check_point(batten_vec3 p, double x, double y, double z, double tolerance)
{
    CHECK_NEAR(p.x, x, tolerance);
    CHECK_NEAR(p.y, y, tolerance);
    CHECK_NEAR(p.z, z, tolerance);
}

TEST(simple_maps_do_what_they_are_called)
{
    const batten_vec3 p = {1, 2, 3};
    check_point(batten_affine_apply(batten_affine_identity(), p), 1, 2, 3, 0);
    check_point(batten_affine_apply(batten_affine_translation(10, 20, 30), p), 11, 22, 33, 0);
    check_point(batten_affine_apply(batten_affine_scaling(2, 3, 4), p), 2, 6, 12, 0);
}

TEST(a_quarter_turn_about_an_axis_through_a_point)
{
    const batten_vec3 origin = {1, 1, 5}, up = {0, 0, 1e-200}, p = {2, 1, 7};
    const batten_affine quarter = batten_affine_rotation(origin, up, pi / 2);
    check_point(batten_affine_apply(quarter, p), 1, 2, 7, 4 * DBL_EPSILON);
    /* The cyclic change of axes is a third of a turn about the diagonal. */
    const batten_affine third = batten_affine_rotation(
        (batten_vec3){0, 0, 0}, (batten_vec3){1e300, 1e300, 1e300}, 2 * pi / 3);
    check_point(batten_affine_apply(third, (batten_vec3){1, 2, 3}), 3, 1, 2, 16 * DBL_EPSILON);
}

TEST(a_mirror_fixes_its_plane_and_is_its_own_inverse)
{
    const batten_vec3 origin = {3, 0, 0};
    const batten_affine side = batten_affine_mirror(origin, (batten_vec3){-7, 0, 0});
    check_point(batten_affine_apply(side, (batten_vec3){5, 1, 2}), 1, 1, 2, 0);
    const batten_affine slanted = batten_affine_mirror(origin, (batten_vec3){1, 2, -3});
    const batten_affine twice = batten_affine_compose(slanted, slanted);
    check_point(batten_affine_apply(twice, (batten_vec3){5, 1, 2}), 5, 1, 2, 32 * DBL_EPSILON);
    check_point(batten_affine_apply(slanted, (batten_vec3){5, -1, 0}), 5, -1, 0,
                32 * DBL_EPSILON);
}

TEST(composed_maps_act_one_after_the_other)
{
    const batten_affine first = batten_affine_translation(1, 0, 0);
    const batten_affine then = batten_affine_scaling(2, 2, 2);
    check_point(batten_affine_apply(batten_affine_compose(first, then), (batten_vec3){1, 1, 1}),
                4, 2, 2, 0);
    check_point(batten_affine_apply(batten_affine_compose(then, first), (batten_vec3){1, 1, 1}),
                3, 2, 2, 0);
}
