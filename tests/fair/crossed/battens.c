#include "fair/crossed/battens.h"
#include "support/test.h"

#include <math.h>

enum { NU = 7, NV = 5, NUMBERS = 3 * NU * NV };

static const double u[] = {0, 0.1, 0.3, 0.4, 0.65, 0.8, 1}, v[] = {0, 0.3, 0.5, 0.9, 1};
static const double within[NU * NV] = {0};

static void fill(test_random *random, double *z)
{
    for (int k = 0; k < NUMBERS; k++)
        z[k] = test_random_in(random, -1, 1);
}

/* The same by one batten after another. */
static double bend_one_by_one(const double *z, double *forces)
{
    static const struct {
        const double *t;
        int count, lines, step, next;
    } side[2] = {{u, NU, NV, NV, 1}, {v, NV, NU, 1, NV}};
    double energy = 0, line[3 * NU], moments[3 * NU], pressed[3 * NU];
    memset(forces, 0, NUMBERS * sizeof *forces);
    for (int s = 0; s < 2; s++) {
        bat_batten batten;
        const double weight = pow(side[s].count - 1, -3);
        CHECK_OK(bat_batten_begin(side[s].count, side[s].t, &batten));
        for (int l = 0; l < side[s].lines; l++) {
            for (int k = 0; k < 3 * side[s].count; k++)
                line[k] = z[3 * (l * side[s].next + k / 3 * side[s].step) + k % 3];
            energy += weight * bat_batten_bend(&batten, 3, line, moments, pressed);
            for (int k = 0; k < 3 * side[s].count; k++)
                forces[3 * (l * side[s].next + k / 3 * side[s].step) + k % 3] +=
                    weight * pressed[k];
        }
        bat_batten_end(&batten);
    }
    return energy;
}

TEST(forces_and_energy_are_the_sums_of_those_of_all_battens)
{
    test_random random = test_random_begin("crossed battens");
    const bool closed[2] = {false, false};
    double z[NUMBERS], forces[NUMBERS], expected[NUMBERS], energy;
    bat_crossed battens;
    fill(&random, z);
    CHECK_OK(bat_crossed_begin((batten_grid){3, NU, NV, z}, within, (batten_uv){u, v}, closed,
                               &battens));
    CHECK_OK(bat_crossed_bend(&battens, z, forces, &energy));
    CHECK_NEAR(energy, bend_one_by_one(z, expected), 1e-12 * energy);
    for (int k = 0; k < NUMBERS; k++)
        CHECK_NEAR(forces[k], expected[k], 1e-11 * energy);
    bat_crossed_end(&battens);
}

TEST(the_stiffness_is_the_force_of_a_unit_move_and_no_eigenvalue_is_above_the_spread)
{
    const bool closed[2] = {false, false};
    double z[NUMBERS], forces[NUMBERS], energy;
    bat_crossed battens;
    memset(z, 0, sizeof z);
    CHECK_OK(bat_crossed_begin((batten_grid){3, NU, NV, z}, within, (batten_uv){u, v}, closed,
                               &battens));
    for (int k = 0; k < NU * NV; k++) {
        z[3 * k + 1] = 1;
        CHECK_OK(bat_crossed_bend(&battens, z, forces, &energy));
        CHECK_NEAR(forces[3 * k + 1], battens.u.stiffness[k / NV] + battens.v.stiffness[k % NV],
                   1e-12);
        z[3 * k + 1] = 0;
    }
    CHECK(battens.u.spread >= 1 && battens.v.spread >= 1);
    bat_crossed_end(&battens);
}

/* Waves are eigenvectors of closed battens with even spacing h: the third derivative of the wave of
 * the angle a jumps by 3 (2 - 2 cos a)^2 / ((2 + cos a) h^3) of it. */
TEST(closed_battens_answer_waves_with_waves)
{
    enum { N = 8, M = 6 };
    const bool closed[2] = {true, true};
    double a[N + 1], b[M + 1], z[3 * N * M], forces[3 * N * M], energy;
    const double room[N * M] = {0};
    bat_crossed battens;
    for (int i = 0; i <= N; i++)
        a[i] = (double)i / N;
    for (int j = 0; j <= M; j++)
        b[j] = (double)j / M;
    CHECK_OK(bat_crossed_begin((batten_grid){3, N, M, z}, room, (batten_uv){a, b}, closed,
                               &battens));
    for (int wave = 1; wave <= N / 2; wave++) {
        const double angle = 2 * acos(-1) * wave / N;
        double square = 0;
        for (int k = 0; k < 3 * N * M; k++) {
            z[k] = (k % 3 + 1) * cos(angle * (k / (3 * M)));
            square += z[k] * z[k];
        }
        const double value = 3 * pow(2 - 2 * cos(angle), 2) / (2 + cos(angle));
        CHECK_OK(bat_crossed_bend(&battens, z, forces, &energy));
        CHECK_NEAR(energy, value * square, 1e-11 * square);
        for (int k = 0; k < 3 * N * M; k++)
            CHECK_NEAR(forces[k], value * z[k], 1e-10);
    }
    CHECK_NEAR(battens.u.spread * battens.u.stiffness[3], 48, 1e-9); /* at the angle pi */
    bat_crossed_end(&battens);
}
