#include "loft/patch.h"

#include "support/test.h"

#include <math.h>

static const double inner[] = {0.3, 0.6};

/* A patch of random control points. */
static void make_patch(test_random *random, bat_loft_patch *out)
{
    double u[10], v[9];
    bat_loft_knots(2, inner, u);
    bat_loft_knots(1, inner, v);
    CHECK_OK(bat_loft_patch_make(6, u, 5, v, out));
    for (int k = 0; k < 3 * 6 * 5; k++)
        out->points[k] = test_random_in(random, -1, 1);
}

TEST(derivatives_of_a_place_are_those_of_its_differences)
{
    test_random random = test_random_begin("loft patch");
    const double h = 1e-4;
    for (int t = 0; t < test_cases(20); t++) {
        bat_loft_patch patch;
        bat_loft_place at, low, high;
        make_patch(&random, &patch);
        const double u = test_random_in(&random, 0.31, 0.59),
                     v = test_random_in(&random, 0.4, 0.9);
        bat_loft_place_at(&patch, u, v, &at);
        for (int axis = 0; axis < 2; axis++) {
            const double du = axis == 0 ? h : 0, dv = axis == 1 ? h : 0;
            bat_loft_place_at(&patch, u - du, v - dv, &low);
            bat_loft_place_at(&patch, u + du, v + dv, &high);
            for (int c = 0; c < 3; c++) {
                const double *first = axis == 0 ? at.s[1][0] : at.s[0][1];
                const double *second = axis == 0 ? at.s[2][0] : at.s[0][2];
                CHECK_NEAR((high.s[0][0][c] - low.s[0][0][c]) / (2 * h), first[c], 1e-4);
                CHECK_NEAR((high.s[0][0][c] - 2 * at.s[0][0][c] + low.s[0][0][c]) / (h * h),
                           second[c], 1e-4);
                CHECK_NEAR(axis == 0 ? (high.s[0][1][c] - low.s[0][1][c]) / (2 * h)
                                     : (high.s[1][0][c] - low.s[1][0][c]) / (2 * h),
                           at.s[1][1][c], 1e-4);
            }
        }
        bat_loft_patch_free(&patch);
    }
}

TEST(normals_are_unit_vectors_across_both_directions)
{
    test_random random = test_random_begin("loft normal");
    bat_loft_patch patch;
    bat_loft_place at;
    double n[3];
    make_patch(&random, &patch);
    bat_loft_place_at(&patch, 0.2, 1.7, &at); /* moved to the edge */
    CHECK(at.v == 1);
    CHECK(bat_loft_normal(&at, n) > 0);
    double length = 0, along = 0, across = 0;
    for (int c = 0; c < 3; c++) {
        length += n[c] * n[c];
        along += n[c] * at.s[1][0][c];
        across += n[c] * at.s[0][1][c];
    }
    CHECK_NEAR(length, 1, 1e-14);
    CHECK_NEAR(along, 0, 1e-13);
    CHECK_NEAR(across, 0, 1e-13);
    bat_loft_patch_free(&patch);
}

TEST(a_patch_that_was_released_is_empty_and_may_be_released_again)
{
    test_random random = test_random_begin("empty patch");
    bat_loft_patch patch;
    make_patch(&random, &patch);
    for (int times = 0; times < 2; times++) {
        bat_loft_patch_free(&patch);
        CHECK(patch.nu == 0 && patch.nv == 0);
        CHECK(!patch.u_knots && !patch.v_knots && !patch.points);
    }
}
