#include "shape/bent/two_angle.h"
#include "spline/chain/chain.h"

#include "support/test.h"

static const bat_span_family *const family = &bat_family_geometric;

TEST(geometric_spans_reach_their_ends)
{
    test_random random = test_random_begin("geometric family");
    for (int c = 0; c < test_cases(300); c++) {
        const double l = pow(10, test_random_in(&random, -3, 3));
        const double size = c % 3 == 0 ? pow(10, test_random_in(&random, -12, 0)) : 1.55;
        const double alpha = size * test_random_in(&random, -1, 1);
        const double beta = size * test_random_in(&random, -1, 1);
        bat_end_curvatures k;
        batten_span span;
        int count = 0;
        double out[8];
        CHECK_OK(family->curvatures(alpha, beta, l, 0, &k));
        CHECK_OK(family->spans(alpha, beta, l, 0, &span, &count));
        CHECK_INT(count, 1);
        bat_span_geometric(2, &span, l, 2, out);
        CHECK_NEAR(out[0], l, 0);
        CHECK_NEAR(out[1], 0, 1e-13 * l * size / cos(alpha) / cos(beta));
        CHECK_NEAR(sin(atan(out[3])), sin(beta), 1e-13 * size);
        CHECK_NEAR(span.curvature[0], k.k0, 0);
        CHECK_NEAR(span.curvature[0] + l * span.curvature[1], k.k1, 1e-13 * size / l);
    }
}

TEST(geometric_spans_with_opposite_angles_are_arcs)
{
    for (double a = -1.5; a <= 1.5; a += 0.25) {
        bat_end_curvatures k;
        CHECK_OK(family->curvatures(a, -a, 2, 0, &k));
        CHECK_NEAR(k.k0, -sin(a), 1e-15);
        CHECK_NEAR(k.k1, -sin(a), 1e-15);
    }
}

TEST(derivatives_of_the_end_curvatures_of_geometric_spans_are_limits_of_differences)
{
    test_random random = test_random_begin("geometric derivatives");
    for (int c = 0; c < test_cases(100); c++) {
        const double size = c % 2 == 0 ? 1.3 : 1e-3;
        const double a = size * test_random_in(&random, -1, 1), l = 2;
        const double b = size * test_random_in(&random, -1, 1), h = 1e-5 * size;
        bat_end_curvatures k, more, less;
        CHECK_OK(family->curvatures(a, b, l, 0, &k));
        CHECK_OK(family->curvatures(a + h, b, l, 0, &more));
        CHECK_OK(family->curvatures(a - h, b, l, 0, &less));
        const double near = 1e-6 * (fabs(k.k0_alpha) + fabs(k.k1_beta));
        CHECK_NEAR(k.k0_alpha, (more.k0 - less.k0) / (2 * h), near);
        CHECK_NEAR(k.k1_alpha, (more.k1 - less.k1) / (2 * h), near);
        CHECK_OK(family->curvatures(a, b + h, l, 0, &more));
        CHECK_OK(family->curvatures(a, b - h, l, 0, &less));
        CHECK_NEAR(k.k0_beta, (more.k0 - less.k0) / (2 * h), near);
        CHECK_NEAR(k.k1_beta, (more.k1 - less.k1) / (2 * h), near);
    }
}

TEST(small_angles_bend_a_geometric_span_like_a_cubic)
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

TEST(geometric_spans_exist_up_to_the_right_angle)
{
    const double steep[] = {1.5533, -1.5533};
    for (int i = 0; i < 4; i++) {
        bat_end_curvatures k;
        CHECK_OK(family->curvatures(steep[i / 2], steep[i % 2], 1, 0, &k));
        CHECK(isfinite(k.k0) && isfinite(k.k1));
    }
}

TEST(g10_a_reversed_geometric_span_is_the_same)
{
    bat_end_curvatures k, back;
    CHECK_OK(family->curvatures(0.9, -0.4, 1, 0, &k));
    CHECK_OK(family->curvatures(0.4, -0.9, 1, 0, &back));
    CHECK_NEAR(back.k0, k.k1, 1e-14);
    CHECK_NEAR(back.k1, k.k0, 1e-14);
    CHECK_NEAR(back.k0_alpha, -k.k1_beta, 1e-13);
}
