#include <batten/curve.h>

#include "support/test.h"

TEST(a_bezier_cubic_is_its_polynomial)
{
    /* The example of the notes: x = 4t^3 + 10t^2 - 30t + 2 on [0, 1] in Bernstein form. */
    const double points[] = {2, -8, -44. / 3, -14}, knots[] = {0, 0, 0, 0, 1, 1, 1, 1};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create(1, 3, 4, points, NULL, knots, &curve));
    for (int i = 0; i <= 16; i++) {
        const double t = i / 16.0;
        double out[6];
        CHECK_OK(batten_curve_evaluate(curve, t, 5, out));
        CHECK_NEAR(out[0], ((4 * t + 10) * t - 30) * t + 2, 1e-14);
        CHECK_NEAR(out[1], (12 * t + 20) * t - 30, 1e-13);
        CHECK_NEAR(out[2], 24 * t + 20, 1e-13);
        CHECK_NEAR(out[3], 24, 1e-13);
        CHECK_BITS(out[4], 0);
        CHECK_BITS(out[5], 0);
    }
    batten_curve_unref(curve);
}
