#include "shape/bent/energy.h"

#include "support/test.h"

/* The weighted density alone. */
static double value(const bat_energy_weights *weights, int d, const double *P)
{
    bat_energy_density at;
    bat_energy_density_at(weights, d, P, false, &at);
    return weights->energy * at.energy + weights->length * at.length;
}

TEST(densities_of_energy_are_those_of_a_circle_and_a_helix)
{
    /* Both run through at speed 3 with an acceleration along them, which changes nothing. */
    const double r = 2, c = 0.5, w2 = r * r + c * c, k = r / w2, torsion = c / w2;
    const double v = 3 * sqrt(w2), a = 0.7;
    const double t1[3] = {0, r, c}, t2[3] = {-r, 0, 0}, t3[3] = {0, -r, 0};
    /* The parameter is 3 u + a u^2 / 2 of the angle. */
    double P[9];
    for (int i = 0; i < 3; i++) {
        P[i] = 3 * t1[i];
        P[3 + i] = 9 * t2[i] + a * t1[i];
        P[6 + i] = 27 * t3[i] + 9 * a * t2[i];
    }
    bat_energy_density at;
    bat_energy_weights weights = {BATTEN_ENERGY_BENDING, 1, 0};
    bat_energy_density_at(&weights, 3, P, false, &at);
    CHECK_NEAR(at.energy, k * k * v, 1e-14);
    CHECK_NEAR(at.length, v, 1e-14);
    weights.kind = BATTEN_ENERGY_VARIATION;
    bat_energy_density_at(&weights, 3, P, false, &at);
    CHECK_NEAR(at.energy, k * k * torsion * torsion * v, 1e-14);
}

TEST(derivatives_of_densities_are_limits_of_differences)
{
    test_random random = test_random_begin("densities");
    for (int c = 0; c < test_cases(40); c++) {
        const int d = 2 + c % 2, n = 3 * d;
        const bat_energy_weights weights = {(batten_energy)(c / 2 % 2), 1.3, 0.4};
        double P[9], h = 1e-5;
        for (int i = 0; i < n; i++)
            P[i] = test_random_in(&random, -1, 1) + (i == 0 ? 2 : 0);
        bat_energy_density at, more, less;
        bat_energy_density_at(&weights, d, P, true, &at);
        for (int i = 0; i < n; i++) {
            const double kept = P[i];
            P[i] = kept + h;
            const double up = value(&weights, d, P);
            bat_energy_density_at(&weights, d, P, true, &more);
            P[i] = kept - h;
            const double down = value(&weights, d, P);
            bat_energy_density_at(&weights, d, P, true, &less);
            P[i] = kept;
            CHECK_NEAR(at.gradient[i], (up - down) / (2 * h), 1e-7);
            for (int j = 0; j < n; j++)
                CHECK_NEAR(at.hessian[i * n + j],
                           (more.gradient[j] - less.gradient[j]) / (2 * h), 1e-7);
        }
    }
}
