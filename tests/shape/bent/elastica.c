#include "shape/bent/two_angle.h"
#include "spline/chain/chain.h"

#include "support/test.h"

static const bat_span_family *const family = &bat_family_elastica;

static void check_span(double alpha, double beta, double l)
{
    bat_end_curvatures k;
    batten_span span;
    int count = 0;
    double out[8];
    CHECK_OK(family->curvatures(alpha, beta, l, 0, &k));
    CHECK_OK(family->spans(alpha, beta, l, 0, &span, &count));
    CHECK_INT(count, 1);
    CHECK_NEAR(span.angle, alpha, 0);
    CHECK_NEAR(span.curvature[0], k.k0, 0);
    bat_span_elastica(2, &span, span.length, 2, out);
    const double size = fabs(alpha) + fabs(beta);
    CHECK_NEAR(out[0], l, 1e-13 * l);
    CHECK_NEAR(out[1], 0, 1e-13 * l * size);
    CHECK_NEAR(sin(atan2(out[3], out[2]) - beta), 0, 1e-12 * size);
    CHECK_NEAR(out[2] * out[5] - out[3] * out[4], k.k1, 1e-11 * size / l);
}

TEST(elastica_spans_reach_their_ends)
{
    test_random random = test_random_begin("elastica family");
    for (int c = 0; c < test_cases(300); c++) {
        const double l = pow(10, test_random_in(&random, -3, 3));
        const double size = c % 3 == 0 ? pow(10, test_random_in(&random, -12, 0)) : 1.5;
        check_span(size * test_random_in(&random, -1, 1), size * test_random_in(&random, -1, 1),
                   l);
    }
}

TEST(elastica_spans_reach_their_ends_at_large_angles)
{
    /* Both ways of bending, and one angle only. */
    const double pairs[][2] = {{1.7, 1.7},  {1.95, 0},  {1.2, -1.8}, {1.56, -1.56},
                               {1.8, -1.2}, {-1.6, -1}, {1.8, -0.9}, {2, 1}};
    for (int i = 0; i < COUNT(pairs); i++) {
        check_span(pairs[i][0], pairs[i][1], 1);
        check_span(-pairs[i][0], -pairs[i][1], 3);
    }
}

TEST(derivatives_of_the_end_curvatures_of_elastica_are_limits_of_differences)
{
    test_random random = test_random_begin("elastica derivatives");
    for (int c = 0; c < test_cases(100); c++) {
        const double size = c % 2 == 0 ? 1.3 : 1e-3;
        const double a = size * test_random_in(&random, -1, 1), l = 2;
        const double b = size * test_random_in(&random, -1, 1), h = 1e-5 * size;
        bat_end_curvatures k, more, less;
        CHECK_OK(family->curvatures(a, b, l, 0, &k));
        CHECK_OK(family->curvatures(a + h, b, l, 0, &more));
        CHECK_OK(family->curvatures(a - h, b, l, 0, &less));
        const double near = 1e-5 * (fabs(k.k0_alpha) + fabs(k.k1_beta));
        CHECK_NEAR(k.k0_alpha, (more.k0 - less.k0) / (2 * h), near);
        CHECK_NEAR(k.k1_alpha, (more.k1 - less.k1) / (2 * h), near);
        CHECK_OK(family->curvatures(a, b + h, l, 0, &more));
        CHECK_OK(family->curvatures(a, b - h, l, 0, &less));
        CHECK_NEAR(k.k0_beta, (more.k0 - less.k0) / (2 * h), near);
        CHECK_NEAR(k.k1_beta, (more.k1 - less.k1) / (2 * h), near);
    }
}

TEST(small_angles_bend_an_elastica_like_a_cubic)
{
    for (double a = 1e-4; a > 1e-200; a *= 1e-3) {
        bat_end_curvatures k;
        CHECK_OK(family->curvatures(a, -0.3 * a, 1, 0, &k));
        CHECK_NEAR(k.k0 / a, -4 + 0.6, 1e-7);
        CHECK_NEAR(k.k1 / a, 2 - 1.2, 1e-7);
    }
    bat_end_curvatures k;
    CHECK_OK(family->curvatures(0, 0, 1, 0, &k));
    CHECK_NEAR(fabs(k.k0) + fabs(k.k1), 0, 0);
    CHECK_NEAR(k.k0_alpha, -4, 1e-14);
    CHECK_NEAR(k.k1_beta, 4, 1e-14);
}

TEST(elastica_between_parallel_tangents_is_the_arch_of_least_energy)
{
    /* Towards the right angle the curvature at the ends vanishes: the rectangular elastica. */
    const double A = 0.5990701173677961, angle = 1.57079632679;
    batten_span span;
    int count = 0;
    bat_elastica at;
    CHECK_OK(family->spans(angle, -angle, 2, 0, &span, &count));
    bat_elastica_at(span.curvature[0], span.curvature[1], span.length, &at);
    CHECK_NEAR(at.energy, 8 * A * A, 1e-9);
    CHECK_NEAR(at.energy, 2.8710800442, 1e-9);
    CHECK_NEAR(span.curvature[0], 0, 1e-4);
}

TEST(g10_a_reversed_elastica_is_the_same)
{
    bat_end_curvatures k, back;
    CHECK_OK(family->curvatures(0.9, -0.4, 1, 0, &k));
    CHECK_OK(family->curvatures(0.4, -0.9, 1, 0, &back));
    CHECK_NEAR(back.k0, k.k1, 1e-14);
    CHECK_NEAR(back.k1, k.k0, 1e-14);
    CHECK_NEAR(back.k0_alpha, -k.k1_beta, 1e-13);
}

TEST(g9_elastica_that_do_not_exist_are_refused)
{
    /* A free beam never turns by more than half a circle. */
    bat_end_curvatures k = {7, 7, 7, 7, 7, 7};
    CHECK_STATUS(family->curvatures(1.8, -1.8, 1, 0, &k), BATTEN_SINGULAR_SYSTEM);
    CHECK_MESSAGE("no free beam");
    CHECK_NEAR(k.k0, 7, 0);
}
