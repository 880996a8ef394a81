#include "fair/crossed/battens.h"
#include "support/test.h"

#include <math.h>

enum { NU = 8, NV = 6, NODES = NU * NV };

static double u[NU], v[NV];

static void even_parameters(void)
{
    for (int i = 0; i < NU; i++)
        u[i] = i / (NU - 1.);
    for (int j = 0; j < NV; j++)
        v[j] = j / (NV - 1.);
}

static void least_of(const double *given, const double *within, double *z, double *residual)
{
    const bool closed[2] = {false, false};
    bat_crossed battens;
    even_parameters();
    CHECK_OK(bat_crossed_begin((batten_grid){3, NU, NV, given}, within, (batten_uv){u, v},
                               closed, &battens));
    memcpy(z, given, 3 * NODES * sizeof *z);
    CHECK_OK(bat_crossed_least(&battens, NULL, z, residual));
    bat_crossed_end(&battens);
}

static void rough_net(test_random *random, double *given)
{
    for (int k = 0; k < NODES; k++) {
        given[3 * k] = k / NV + test_random_in(random, -0.1, 0.1);
        given[3 * k + 1] = k % NV + test_random_in(random, -0.1, 0.1);
        given[3 * k + 2] = test_random_in(random, -0.1, 0.1);
    }
}

TEST(a_single_free_point_goes_where_its_force_is_none)
{
    test_random random = test_random_begin("single free");
    const bool closed[2] = {false, false};
    double given[3 * NODES], z[3 * NODES], forces[3 * NODES], within[NODES], residual, energy;
    rough_net(&random, given);
    for (int free = 0; free < NODES; free += 5) {
        bat_crossed battens;
        memset(within, 0, sizeof within);
        within[free] = 10;
        least_of(given, within, z, &residual);
        CHECK_OK(bat_crossed_begin((batten_grid){3, NU, NV, given}, within, (batten_uv){u, v},
                                   closed, &battens));
        CHECK_OK(bat_crossed_bend(&battens, z, forces, &energy));
        const double stiffness =
            battens.u.stiffness[free / NV] + battens.v.stiffness[free % NV];
        for (int k = 0; k < 3 * NODES; k++)
            if (k / 3 == free)
                CHECK_NEAR(forces[k] / stiffness, 0, 1e-3 * within[free]);
            else
                CHECK_BITS(z[k], given[k]);
        bat_crossed_end(&battens);
    }
}

TEST(no_point_leaves_its_ball_and_none_that_is_released_goes_far)
{
    test_random random = test_random_begin("balls");
    double given[3 * NODES], z[3 * NODES], within[NODES], residual;
    for (int k = 0; k < test_cases(20); k++) {
        int at_bound = 0;
        rough_net(&random, given);
        for (int n = 0; n < NODES; n++)
            within[n] = test_random_in(&random, 0.01, 0.1);
        least_of(given, within, z, &residual);
        CHECK(residual <= 1e-3);
        for (int n = 0; n < NODES; n++) {
            const double moved = bat_distance(3, given + 3 * n, z + 3 * n);
            CHECK(moved <= within[n]);
            at_bound += moved > 0.999 * within[n];
        }
        CHECK(at_bound > 0);
    }
}

TEST(a_flat_net_stays_bit_for_bit)
{
    double given[3 * NODES], z[3 * NODES], within[NODES], residual;
    for (int n = 0; n < NODES; n++) {
        within[n] = 0.5;
        given[3 * n] = n / NV;
        given[3 * n + 1] = n % NV;
        given[3 * n + 2] = 2 * (n / NV) - n % NV;
    }
    least_of(given, within, z, &residual);
    for (int k = 0; k < 3 * NODES; k++)
        CHECK_BITS(z[k], given[k]);
    CHECK_NEAR(residual, 0, 1e-6);
}

TEST(a_symmetric_net_stays_symmetric)
{
    test_random random = test_random_begin("symmetric net");
    double given[3 * NODES], z[3 * NODES], within[NODES], residual;
    rough_net(&random, given);
    for (int i = 0; i < NU / 2; i++)
        for (int j = 0; j < NV; j++) {
            const int a = 3 * (i * NV + j), b = 3 * ((NU - 1 - i) * NV + j);
            given[b] = NU - 1 - given[a];
            given[b + 1] = given[a + 1];
            given[b + 2] = given[a + 2];
        }
    for (int n = 0; n < NODES; n++)
        within[n] = 0.07;
    least_of(given, within, z, &residual);
    for (int i = 0; i < NU / 2; i++)
        for (int j = 0; j < NV; j++) {
            const int a = 3 * (i * NV + j), b = 3 * ((NU - 1 - i) * NV + j);
            CHECK_NEAR(z[b], NU - 1 - z[a], 1e-12);
            CHECK_NEAR(z[b + 1], z[a + 1], 1e-12);
            CHECK_NEAR(z[b + 2], z[a + 2], 1e-12);
        }
}

TEST(moves_scale_with_the_net)
{
    test_random random = test_random_begin("scaled net");
    double given[3 * NODES], large[3 * NODES], z[3 * NODES], scaled[3 * NODES];
    double within[NODES], bounds[NODES], residual;
    rough_net(&random, given);
    for (int k = 0; k < 3 * NODES; k++)
        large[k] = 1024 * given[k];
    for (int n = 0; n < NODES; n++) {
        within[n] = 0.05;
        bounds[n] = 1024 * within[n];
    }
    least_of(given, within, z, &residual);
    least_of(large, bounds, scaled, &residual);
    for (int k = 0; k < 3 * NODES; k++)
        CHECK_NEAR(scaled[k], 1024 * z[k], 1e-9);
}
