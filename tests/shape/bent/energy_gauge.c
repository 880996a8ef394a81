/* The parameter of a curve of least energy is its length. */
#include "shape/bent/energy.h"

#include "support/test.h"

/* A parabola (t, t^2) over [0, 1] and [1, 2], twice as fast in the second span. */
static const double parabola[] = {0, 0, 1, 0, 0, 2, 1, 1, 1, 2, 0, 2, 2, 4, 1, 4, 0, 2};

/* The length of y = x^2 from 0. */
static double length_to(double x)
{
    return x / 2 * sqrt(1 + 4 * x * x) + log(2 * x + sqrt(1 + 4 * x * x)) / 4;
}

TEST(the_length_of_quintics_is_that_of_their_polynomials)
{
    double x[18], step[] = {1, 1};
    memcpy(x, parabola, sizeof x);
    const bat_energy_curve curve = {.d = 2, .count = 3, .spans = 2, .x = x, .step = step};
    CHECK_NEAR(bat_energy_length(&curve), length_to(2), 1e-7);
}

TEST(by_length_steps_are_lengths_speeds_are_1_and_second_derivatives_are_curvatures)
{
    double x[18], step[] = {1, 1};
    memcpy(x, parabola, sizeof x);
    bat_energy_curve curve = {.d = 2, .count = 3, .spans = 2, .x = x, .step = step};
    CHECK(bat_energy_by_length(&curve));
    CHECK_NEAR(step[0], length_to(1), 1e-7);
    CHECK_NEAR(step[1], length_to(2) - length_to(1), 1e-7);
    for (int i = 0; i < 3; i++) {
        const double slope = 2 * i, speed = sqrt(1 + slope * slope),
                     k = 2 / (speed * speed * speed);
        CHECK(x[6 * i] == parabola[6 * i] && x[6 * i + 1] == parabola[6 * i + 1]);
        CHECK_NEAR(x[6 * i + 2], 1 / speed, 1e-15);
        CHECK_NEAR(x[6 * i + 3], slope / speed, 1e-15);
        CHECK_NEAR(x[6 * i + 4], -k * slope / speed, 1e-15);
        CHECK_NEAR(x[6 * i + 5], k / speed, 1e-15);
    }
}

TEST(a_curve_that_stands_still_at_a_node_keeps_its_parameter)
{
    for (int node = 0; node < 3; node++) {
        double x[18], step[] = {1, 1};
        memcpy(x, parabola, sizeof x);
        x[6 * node + 2] = 1e-7;
        x[6 * node + 3] = 0;
        bat_energy_curve curve = {.d = 2, .count = 3, .spans = 2, .x = x, .step = step};
        CHECK(!bat_energy_by_length(&curve));
        CHECK(step[0] == 1 && step[1] == 1);
        CHECK(x[6 * node + 2] == 1e-7);
    }
}
