#include <batten/chain.h>

#include "support/test.h"

static batten_chain *spiral(const double *curvature, double length)
{
    batten_span span = {.kind = BATTEN_SPAN_SPIRAL, .length = length, .angle = 0.3};
    memcpy(span.curvature, curvature, sizeof span.curvature);
    span.start[0] = 2;
    span.start[1] = -1;
    batten_chain *chain = NULL;
    CHECK_OK(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1e-12, &chain));
    return chain;
}

TEST(a_spiral_without_rate_is_an_arc_and_without_curvature_a_line)
{
    const double curvatures[] = {0, 1e-9, 0.7, -3};
    for (int n = 0; n < COUNT(curvatures); n++) {
        batten_span arc = {.kind = BATTEN_SPAN_ARC, .length = 4, .angle = 0.3};
        arc.start[0] = 2;
        arc.start[1] = -1;
        arc.curvature[0] = curvatures[n];
        batten_chain *round = NULL, *other = spiral(arc.curvature, 4);
        CHECK_OK(
            batten_chain_create(&(batten_chain_parts){2, 1, &arc, NULL, false}, 1e-12, &round));
        for (int i = 0; i <= 20; i++) {
            double a[8], b[8];
            CHECK_OK(batten_chain_evaluate(round, i * 0.2, 3, a));
            CHECK_OK(batten_chain_evaluate(other, i * 0.2, 3, b));
            for (int k = 0; k < 8; k++)
                CHECK_NEAR(a[k], b[k], 1e-14 * (1 + fabs(a[k])));
        }
        batten_chain_unref(round);
        batten_chain_unref(other);
    }
}

TEST(curvature_of_a_spiral_is_its_cubic_in_arc_length)
{
    const double k[4] = {0.5, -0.8, 1.2, -0.9};
    batten_chain *chain = spiral(k, 2.5);
    for (int i = 0; i <= 50; i++) {
        const double s = i * 0.05, h = 1e-5;
        double at[8], before[2], after[2];
        CHECK_OK(batten_chain_evaluate(chain, s, 3, at));
        CHECK_NEAR(hypot(at[2], at[3]), 1, 1e-15);
        const double curvature = k[0] + s * (k[1] + s * (k[2] / 2 + s * k[3] / 6));
        const double rate = k[1] + s * (k[2] + s * k[3] / 2);
        CHECK_NEAR(at[2] * at[5] - at[3] * at[4], curvature, 1e-14);
        CHECK_NEAR(at[2] * at[7] - at[3] * at[6], rate, 1e-14);
        if (i == 0 || i == 50)
            continue;
        CHECK_OK(batten_chain_evaluate(chain, s - h, 0, before));
        CHECK_OK(batten_chain_evaluate(chain, s + h, 0, after));
        for (int c = 0; c < 2; c++)
            CHECK_NEAR((after[c] - before[c]) / (2 * h), at[2 + c], 1e-9);
    }
    batten_chain_unref(chain);
}

TEST(n1_spirals_that_wind_too_often_are_refused)
{
    batten_span span = {.kind = BATTEN_SPAN_SPIRAL, .length = 1e6};
    batten_chain *chain = NULL;
    span.curvature[1] = 1;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_TOO_LARGE);
    CHECK_MESSAGE("span 1 turns by up to 5e+11 radians");
    span.curvature[1] = 1e300;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_TOO_LARGE);
    span.curvature[1] = NAN;
    CHECK_STATUS(
        batten_chain_create(&(batten_chain_parts){2, 1, &span, NULL, false}, 1, &chain),
        BATTEN_NOT_FINITE);
}

TEST(a_spiral_becomes_quintics_within_the_tolerance)
{
    const double k[4] = {0, 2, 0, 0};
    batten_chain *chain = spiral(k, 4);
    batten_curve *curve = NULL;
    double error = 0;
    CHECK_OK(batten_chain_to_curve(chain, 1e-8, &error, &curve));
    CHECK(error > 0 && error <= 1e-8);
    for (int i = 0; i <= 400; i++) {
        double a[2], b[2];
        CHECK_OK(batten_chain_evaluate(chain, i * 0.01, 0, a));
        CHECK_OK(batten_curve_evaluate(curve, i * 0.01, 0, b));
        CHECK(hypot(a[0] - b[0], a[1] - b[1]) <= error);
    }
    batten_curve_unref(curve);
    batten_chain_unref(chain);
}
