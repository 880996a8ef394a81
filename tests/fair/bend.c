#include "fair/fairness.h"

#include "support/test.h"

/* Parabola y = x^2 / (2 r) over |x| <= 1: curvature 1 / r at the middle, where no knot is. */
static batten_curve *sharp_parabola(double r)
{
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const double points[] = {-1, 0.5 / r, 0, -0.5 / r, 1, 0.5 / r};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_create((batten_points){2, 3, points}, 2, NULL, knots, &curve));
    return curve;
}

/* With x = r tan(a) energy is the integral of cos(a)^3 / r over |a| <= atan(1 / r), and with
 * dk/ds = -3 sin(a) cos(a)^5 / r^2 variation that of 9 sin(a)^2 cos(a)^7 / r^3. */
TEST(the_energy_of_a_sharp_bend_is_its_integral_however_sharp)
{
    for (double r = 10; r > 1e-6; r /= 10) {
        batten_fairness found;
        batten_curve *curve = sharp_parabola(r);
        const double s = 1 / hypot(1, r), s3 = s * s * s, s5 = s3 * s * s;
        const double energy = 2 * (s - s3 / 3) / r;
        const double variation =
            18 * (s3 / 3 - 3 * s5 / 5 + 3 * s5 * s * s / 7 - s5 * s3 * s / 9) / (r * r * r);
        CHECK_OK(batten_curve_fairness(curve, (batten_points){2, 0, NULL}, NULL, &found));
        CHECK_NEAR(found.energy, energy, 2e-9 * energy);
        CHECK_NEAR(found.variation, variation, 2e-9 * variation);
        CHECK_NEAR(found.max_curvature, 1 / r, 1e-9 / r);
        CHECK(found.energy_error <= 2e-9 * energy && found.variation_error <= 2e-9 * variation);
        CHECK(found.fair);
        batten_curve_unref(curve);
    }
}
