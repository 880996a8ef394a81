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
