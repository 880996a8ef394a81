#include "shape/bent/spiral.h"
#include <batten/bent.h>

#include "support/test.h"

static const double pi = 3.14159265358979323846;

TEST(clothoids_reach_random_poses_in_few_steps)
{
    test_random random = test_random_begin("clothoids");
    int most = 0;
    double worst = 0;
    for (int n = 0; n < test_cases(2000); n++) {
        const double a = test_random_in(&random, -pi, pi), b = test_random_in(&random, -pi, pi);
        if (fabs(a) > 0.98 * pi && fabs(b) > 0.98 * pi)
            continue;
        const double from[2] = {0, 0}, to[2] = {1, 0};
        batten_span span;
        int steps = 0;
        double error = 0;
        CHECK_OK(batten_spiral_hermite((batten_heading){from, a}, (batten_heading){to, b},
                                       &steps, &error, &span));
        most = steps > most ? steps : most;
        worst = fmax(worst, error);
        batten_chain *chain = NULL;
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain));
        double end[4];
        CHECK_OK(batten_chain_evaluate(chain, span.length, 1, end));
        CHECK(hypot(end[0] - 1, end[1]) <= 1e-12);
        CHECK(hypot(end[2] - cos(b), end[3] - sin(b)) <= 1e-12);
        batten_chain_unref(chain);
    }
    CHECK(most <= 5);
    CHECK(worst <= 1e-12);
}

TEST(partial_derivatives_of_clothoids_are_those_of_differences)
{
    test_random random = test_random_begin("clothoid derivatives");
    for (int n = 0; n < test_cases(200); n++) {
        const double a = test_random_in(&random, -2.5, 2.5),
                     b = test_random_in(&random, -2.5, 2.5), h = 1e-5;
        bat_clothoid at, low, high;
        CHECK_OK(bat_clothoid_solve(a, b, &at));
        CHECK_OK(bat_clothoid_solve(a - h, b, &low));
        CHECK_OK(bat_clothoid_solve(a + h, b, &high));
        CHECK_NEAR((high.A - low.A) / (2 * h), at.A_alpha, 1e-7);
        CHECK_NEAR((high.chord - low.chord) / (2 * h), at.chord_alpha, 1e-7);
        CHECK_OK(bat_clothoid_solve(a, b - h, &low));
        CHECK_OK(bat_clothoid_solve(a, b + h, &high));
        CHECK_NEAR((high.A - low.A) / (2 * h), at.A_beta, 1e-7);
        CHECK_NEAR((high.chord - low.chord) / (2 * h), at.chord_beta, 1e-7);
    }
}

TEST(clothoids_between_symmetric_directions_are_arcs_and_lines)
{
    const double from[2] = {3, 4}, to[2] = {3, 6};
    for (double a = -3; a <= 3; a += 0.25) {
        batten_span span;
        CHECK_OK(batten_spiral_hermite((batten_heading){from, pi / 2 + a},
                                       (batten_heading){to, pi / 2 - a}, NULL, NULL, &span));
        CHECK_NEAR(span.curvature[0], -sin(a), 1e-14);
        CHECK_NEAR(span.curvature[1], 0, 1e-14);
        CHECK_NEAR(span.length, a == 0 ? 2 : 2 * a / sin(a), 1e-12);
    }
}

TEST(n1_g1_clothoids_refuse_bad_ends)
{
    const double a[2] = {0, 0}, b[2] = {1, 0}, bad[2] = {NAN, 0};
    const double far[2][2] = {{-1e308, 0}, {1e308, 0}};
    batten_span span;
    CHECK_STATUS(batten_spiral_hermite((batten_heading){a, 0}, (batten_heading){bad, 0}, NULL,
                                       NULL, &span),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_spiral_hermite((batten_heading){a, INFINITY}, (batten_heading){b, 0},
                                       NULL, NULL, &span),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_spiral_hermite((batten_heading){a, 0}, (batten_heading){a, 0}, NULL,
                                       NULL, &span),
                 BATTEN_COINCIDENT);
    CHECK_STATUS(batten_spiral_hermite((batten_heading){far[0], 0}, (batten_heading){far[1], 0},
                                       NULL, NULL, &span),
                 BATTEN_OVERFLOW);
    CHECK_STATUS(batten_spiral_hermite((batten_heading){a, pi}, (batten_heading){b, pi}, NULL,
                                       NULL, &span),
                 BATTEN_TOLERANCE_NOT_MET);
    CHECK_MESSAGE("one must stay below");
}

TEST(n2_clothoids_have_any_size)
{
    const double sizes[] = {1e-150, 1e-9, 1, 1e9, 1e150};
    for (int n = 0; n < COUNT(sizes); n++) {
        const double from[2] = {0, 0}, to[2] = {sizes[n], sizes[n]};
        batten_span span;
        double error = 0;
        CHECK_OK(batten_spiral_hermite((batten_heading){from, 1}, (batten_heading){to, 2}, NULL,
                                       &error, &span));
        CHECK(error <= 1e-13 * sizes[n]);
    }
}
