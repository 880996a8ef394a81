#include "shape/plate/flat_step.h"

#include "support/test.h"

#include <math.h>

/* t^power integrated from 0 to `to`. */
static double integral(int power, double to)
{
    return pow(to, power + 1) / (power + 1);
}

TEST(the_rule_integrates_to_its_nodes_with_degree_3_and_over_the_step_with_degree_7)
{
    bat_flat_rule rule;
    bat_flat_rule_make(&rule);
    for (int power = 0; power <= 7; power++) {
        double whole = 0;
        for (int j = 0; j < BAT_FLAT_NODES; j++)
            whole += rule.weights[j] * pow(rule.c[j], power);
        CHECK_NEAR(whole, integral(power, 1), 1e-15);
        for (int i = 0; i < BAT_FLAT_NODES && power <= 3; i++) {
            double part = 0;
            for (int j = 0; j < BAT_FLAT_NODES; j++)
                part += rule.A[i][j] * pow(rule.c[j], power);
            CHECK_NEAR(part, integral(power, rule.c[i]), 1e-15);
        }
    }
}

/* With the direction phi = 0.4 + 0.3 t the point moves by 2 along it and by 0.5 to its left. */
TEST(a_step_of_constant_rates_is_an_arc)
{
    enum { STEPS = 2 };
    bat_flat_rule rule;
    bat_flat_rates rates;
    double phi = 0.4, x = 3, y = -1;
    bat_flat_rule_make(&rule);
    for (int j = 0; j < BAT_FLAT_NODES; j++) {
        rates.turn[j] = 0.3;
        rates.along[j] = 2;
        rates.across[j] = 0.5;
    }
    for (int k = 1; k <= STEPS; k++) {
        const double end = 0.4 + 0.3 * k;
        const double c = (sin(end) - sin(0.4)) / 0.3, s = (cos(0.4) - cos(end)) / 0.3;
        bat_flat_step(&rule, &rates, &phi, &x, &y);
        CHECK_NEAR(phi, end, 1e-15);
        CHECK_NEAR(x, 3 + 2 * c - 0.5 * s, 1e-11);
        CHECK_NEAR(y, -1 + 2 * s + 0.5 * c, 1e-11);
    }
}

/* phi = t^4 / 4: what turns with the third power of t is integrated exactly to every node. */
TEST(a_step_of_cubic_turn_turns_exactly)
{
    bat_flat_rule rule;
    bat_flat_rates rates;
    double phi = 0, x = 0, y = 0;
    bat_flat_rule_make(&rule);
    for (int j = 0; j < BAT_FLAT_NODES; j++) {
        const double t = rule.c[j];
        rates.turn[j] = t * t * t;
        rates.along[j] = cos(t * t * t * t / 4);
        rates.across[j] = -sin(t * t * t * t / 4);
    }
    bat_flat_step(&rule, &rates, &phi, &x, &y); /* so the velocity is (1, 0) */
    CHECK_NEAR(phi, 0.25, 1e-15);
    CHECK_NEAR(x, 1, 1e-15);
    CHECK_NEAR(y, 0, 1e-15);
}
