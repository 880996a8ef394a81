#include "numeric/vector.h"

#include "support/test.h"

TEST(N2_norms_are_right_for_the_smallest_and_largest_numbers)
{
    static const double scales[] = {1e-320, 1e-300, 1e-160, 1e-9, 1, 1e9, 1e160, 1e300};
    for (int i = 0; i < COUNT(scales); i++) {
        const double s = scales[i], row[4] = {s, -2 * s, 2 * s, 4 * s};
        CHECK_NEAR(bat_norm(4, row) / (5 * s), 1, 4 * DBL_EPSILON);
        CHECK_NEAR(bat_vec3_norm((batten_vec3){s, -2 * s, 2 * s}) / (3 * s), 1,
                   4 * DBL_EPSILON);
    }
    CHECK_BITS(bat_norm(2, (const double[2]){0, -0.0}), 0);
    CHECK(isinf(bat_norm(2, (const double[2]){1, -INFINITY})));
}

TEST(vectors_obey_their_identities)
{
    const batten_vec3 a = {1, 2, 3}, b = {-4, 5, 6};
    const batten_vec3 c = bat_vec3_cross(a, b);
    CHECK_BITS(bat_vec3_dot(c, a), 0);
    CHECK_BITS(bat_vec3_dot(c, b), 0);
    CHECK_BITS(c.z, 13);
    const batten_vec3 sum = bat_vec3_add(a, bat_vec3_scale(b, 2)),
                      along = bat_vec3_along(a, 2, b);
    CHECK_BITS(bat_vec3_norm(bat_vec3_subtract(sum, along)), 0);
    CHECK_BITS(along.x, -7);
    CHECK_BITS(bat_distance(2, (const double[2]){1, 1}, (const double[2]){4, 5}), 5);
    CHECK_BITS(bat_vec3_of(1, &a.x).y, 0);
    CHECK_BITS(bat_vec3_of(2, (const double[2]){4, 5}).y, 5);
    CHECK_BITS(bat_vec3_of(3, (const double[3]){4, 5, 6}).z, 6);
}

TEST(the_cross_product_of_rows_may_replace_one_of_them)
{
    double a[3] = {1, 2, 3}, b[3] = {-4, 5, 7}, out[3];
    bat_cross(a, b, out);
    CHECK(out[0] == -1 && out[1] == -19 && out[2] == 13);
    bat_cross(a, b, a);
    CHECK(a[0] == -1 && a[1] == -19 && a[2] == 13);
    bat_cross((const double[3]){1, 2, 3}, b, b);
    CHECK(b[0] == -1 && b[1] == -19 && b[2] == 13);
}

TEST(the_angle_of_rows_does_not_depend_on_their_lengths_and_vanishes_with_one)
{
    const double a[3] = {3, 0, 4}, nothing[3] = {0, 0, 0};
    const double with[][4] = {/* and the angle */
                              {30, 0, 40, 0},
                              {-3, 0, -4, 3.14159265358979324},
                              {0, 2, 0, 1.57079632679489662},
                              {-4, 0, 3, 1.57079632679489662},
                              {4, -5, -3, 1.57079632679489662},
                              {3, 5, 4, 0.785398163397448310}};
    for (int i = 0; i < COUNT(with); i++) {
        CHECK_NEAR(bat_angle(a, with[i]), with[i][3], 4 * DBL_EPSILON);
        CHECK_NEAR(bat_angle(with[i], a), with[i][3], 4 * DBL_EPSILON);
    }
    CHECK(bat_angle(a, nothing) == 0 && bat_angle(nothing, a) == 0);
}

TEST(the_distance_of_a_segment_is_that_of_its_nearest_point)
{
    const double a[3] = {0, 0, 0}, b[3] = {4, 0, 3};
    const double before[3] = {-3, 4, 0}, beside[3] = {2, 7, 1.5}, beyond[3] = {4, 2, 4};
    CHECK_NEAR(bat_segment_distance(3, a, b, before), 5, 0);
    CHECK_NEAR(bat_segment_distance(3, a, b, beside), 7, 1e-15);
    CHECK_NEAR(bat_segment_distance(3, a, b, beyond), sqrt(5), 1e-15);
    CHECK_NEAR(bat_segment_distance(3, b, a, beyond), sqrt(5), 1e-15);
    CHECK_NEAR(bat_segment_distance(3, b, b, a), 5, 0); /* a point */
    CHECK_NEAR(bat_segment_distance(2, a, b, (const double[2]){3, -2}), 2, 0);
    CHECK_NEAR(bat_segment_distance(1, a, b, (const double[1]){6}), 2, 0);
}
