#include "loft/program.h"

#include "support/test.h"

#include <math.h>

enum { NU = 6, NV = 5, COORDINATES = 3 * NU * NV };

static const double inner[] = {0.3, 0.6};

/* The patch (u^a v^b, 0, 0) has at its control points the products of the blossoms. */
static double blossom(int power, const double *t)
{
    if (power == 0)
        return 1;
    if (power == 1)
        return (t[0] + t[1] + t[2]) / 3;
    if (power == 2)
        return (t[0] * t[1] + t[1] * t[2] + t[0] * t[2]) / 3;
    return t[0] * t[1] * t[2];
}

static void make_power(int a, int b, bat_loft_patch *out)
{
    double u[NU + 4], v[NV + 4];
    bat_loft_knots(2, inner, u);
    bat_loft_knots(1, inner, v);
    CHECK_OK(bat_loft_patch_make(NU, u, NV, v, out));
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++)
            out->points[3 * (i * NV + j)] =
                blossom(a, out->u_knots + i + 1) * blossom(b, out->v_knots + j + 1);
}

TEST(the_energy_of_powers_is_that_of_their_third_derivatives)
{
    static const struct {
        int a, b;
        double
            energy; /* sum over k of C(3, k) times the integral of (d^3 / du^k dv^(3 - k))^2 */
    } cases[] = {{0, 0, 0},
                 {2, 0, 0},
                 {1, 1, 0},
                 {3, 0, 36},
                 {0, 3, 36}, /* (d^3 u^3)^2 = 36 */
                 {2, 1, 12}, /* 3 * 2^2 */
                 {3, 1, 36. / 3 + 3 * 36. / 3}};
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; k++) {
        bat_loft_patch patch;
        double energy;
        make_power(cases[k].a, cases[k].b, &patch);
        CHECK_OK(bat_loft_energy(&patch, &energy));
        CHECK_NEAR(energy, cases[k].energy, 1e-10);
        bat_loft_patch_free(&patch);
    }
}

/* A value to be reached at a place by the first coordinate. */
static void attract(bat_loft_program *p, double u, double v, double target)
{
    bat_loft_place at;
    const bat_loft_measure measure = {.weight[0][0] = 1, .vector = {1, 0, 0}};
    bat_loft_place_at(p->patch, u, v, &at);
    bat_loft_add_square(p, &at, &measure, 2, target - at.s[0][0][0]);
}

TEST(a_quadratic_patch_is_reached_with_no_energy)
{
    bat_loft_patch patch;
    bat_loft_program p;
    bat_convex_report report;
    bool held[COORDINATES] = {false};
    double slack, energy;
    make_power(3, 1, &patch);
    for (int k = 0; k < COORDINATES; k++)
        held[k] = k % 3 != 0;
    CHECK_OK(bat_loft_program_make(&patch, held, 0.5, &p));
    CHECK_OK(bat_loft_add_energy(&p, 1));
    for (int i = 0; i <= 4; i++)
        for (int j = 0; j <= 4; j++)
            attract(&p, i / 4., j / 4., i / 4. * i / 4. - i / 4. * j / 4. + 2);
    CHECK_OK(bat_loft_program_move(&p, patch.points, &slack, &report));
    CHECK_OK(bat_loft_energy(&patch, &energy));
    CHECK_NEAR(energy, 0, 1e-8);
    bat_loft_place at;
    bat_loft_place_at(&patch, 0.37, 0.81, &at);
    CHECK_NEAR(at.s[0][0][0], 0.37 * 0.37 - 0.37 * 0.81 + 2, 1e-6);
    CHECK(slack == 0);
    bat_loft_program_free(&p);
    bat_loft_patch_free(&patch);
}

TEST(rows_bound_the_patch_and_moves)
{
    bat_loft_patch patch;
    bat_loft_program p;
    bat_convex_report report;
    bat_loft_place at;
    const bat_loft_measure measure = {.weight[0][0] = 1, .vector = {1, 0, 0}};
    bool held[COORDINATES];
    double slack, before[COORDINATES];
    make_power(1, 0, &patch);
    for (int k = 0; k < COORDINATES; k++) {
        held[k] = k % 3 != 0;
        before[k] = patch.points[k];
    }
    CHECK_OK(bat_loft_program_make(&patch, held, 0.1, &p));
    CHECK_OK(bat_loft_add_energy(&p, 1e-3));
    attract(&p, 0.5, 0.5, 3);
    bat_loft_place_at(&patch, 0.5, 0.5, &at);
    CHECK_OK(bat_loft_add_row(&p, &at, &measure, 0.2, HUGE_VAL));
    CHECK_OK(bat_loft_limit_moves(&p, 0.25));
    CHECK_OK(bat_loft_program_move(&p, patch.points, &slack, &report));
    bat_loft_place_at(&patch, 0.5, 0.5, &at);
    CHECK_NEAR(at.s[0][0][0], 0.7, 1e-6);
    for (int k = 0; k < COORDINATES; k++) {
        CHECK(fabs(patch.points[k] - before[k]) <= 0.25 + 1e-9);
        CHECK(!held[k] || patch.points[k] == before[k]);
    }
    bat_loft_program_free(&p);
    bat_loft_patch_free(&patch);
}
