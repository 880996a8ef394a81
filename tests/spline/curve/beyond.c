#include <batten/curve.h>
#include <batten/standard.h>

#include "support/test.h"

/* f = u^3 - 2 u on [0, 1], then a straight piece up to 2. */
static batten_curve *cubic(void)
{
    const double breaks[] = {0, 1, 2}, powers[] = {0, -2, 0, 1, -1, 1, 0, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_from_power(1, (batten_pieces){3, 2, breaks}, powers, 1e-14, &curve));
    return curve;
}

TEST(beyond_its_ends_a_curve_goes_on_as_asked)
{
    batten_curve *curve = cubic();
    double out[6];
    for (int i = 1; i <= 20; i++) {
        const double u = -i / 4.0;
        CHECK_OK(batten_curve_evaluate_beyond(curve, u, BATTEN_BEYOND_CONTINUE, 5, out));
        const double exact[] = {u * u * u - 2 * u, 3 * u * u - 2, 6 * u, 6, 0, 0};
        for (int k = 0; k <= 5; k++)
            CHECK_NEAR(out[k], exact[k], 1e-13 * (1 + fabs(exact[k])));
        CHECK_OK(batten_curve_evaluate_beyond(curve, u, BATTEN_BEYOND_LINEAR, 2, out));
        CHECK_NEAR(out[0], -2 * u, 1e-14 * 8);
        CHECK_NEAR(out[1], -2, 1e-14);
        CHECK_NEAR(out[2], 0, 0);
        CHECK_OK(batten_curve_evaluate_beyond(curve, 2 + i, BATTEN_BEYOND_CONTINUE, 1, out));
        CHECK_NEAR(out[0], i, 1e-12 * i * i * i);
    }
    batten_curve_unref(curve);
}

TEST(inside_and_at_the_ends_nothing_changes)
{
    batten_curve *curve = cubic();
    for (int rule = 0; rule <= BATTEN_BEYOND_LINEAR; rule++)
        for (int i = 0; i <= 40; i++) {
            double out[3], expected[3];
            CHECK_OK(batten_curve_evaluate(curve, i / 20.0, 2, expected));
            CHECK_OK(
                batten_curve_evaluate_beyond(curve, i / 20.0, (batten_beyond)rule, 2, out));
            for (int k = 0; k < 3; k++)
                CHECK_BITS(out[k], expected[k]);
        }
    batten_curve_unref(curve);
}

TEST(n7_beyond_the_domain_is_refused_unless_asked_for)
{
    batten_curve *curve = cubic(), *circle = NULL;
    double out[2] = {7, 7};
    CHECK_STATUS(batten_curve_evaluate_beyond(curve, 2.1, BATTEN_BEYOND_REFUSE, 0, out),
                 BATTEN_OUT_OF_DOMAIN);
    CHECK_STATUS(batten_curve_evaluate_beyond(curve, 2.1, (batten_beyond)3, 0, out),
                 BATTEN_BAD_ARGUMENT);
    CHECK_STATUS(batten_curve_evaluate_beyond(curve, NAN, BATTEN_BEYOND_LINEAR, 0, out),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_evaluate_beyond(curve, INFINITY, BATTEN_BEYOND_LINEAR, 0, out),
                 BATTEN_NOT_FINITE);
    CHECK_STATUS(batten_curve_evaluate_beyond(curve, -1e200, BATTEN_BEYOND_CONTINUE, 0, out),
                 BATTEN_OVERFLOW);
    CHECK_OK(batten_curve_arc(1, 1, &circle));
    CHECK_STATUS(batten_curve_evaluate_beyond(circle, -1, BATTEN_BEYOND_CONTINUE, 0, out),
                 BATTEN_UNSUPPORTED);
    CHECK_NEAR(out[0], 7, 0);
    CHECK_OK(batten_curve_evaluate_beyond(circle, -1, BATTEN_BEYOND_LINEAR, 0, out));
    CHECK_NEAR(out[0], 1, 1e-14);
    CHECK(out[1] < -0.1);
    batten_curve_unref(circle);
    batten_curve_unref(curve);
}
