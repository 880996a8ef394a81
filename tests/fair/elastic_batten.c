#include "fair/elastic_batten.h"
#include "support/test.h"

enum { MOST = 40 };

/* A batten over random increasing parameters. */
static int random_ducks(test_random *random, double *t, double *z)
{
    const int count = test_random_int(random, 2, MOST);
    t[0] = test_random_in(random, -5, 5);
    for (int i = 0; i < count; i++) {
        if (i > 0)
            t[i] = t[i - 1] + test_random_in(random, 0.1, 2);
        z[i] = test_random_in(random, -1, 1);
    }
    return count;
}

static double force_of_unit(const bat_batten *batten, int i, int j)
{
    double z[MOST] = {0}, moments[MOST], forces[MOST];
    z[j] = 1;
    bat_batten_bend(batten, 1, z, moments, forces);
    return forces[i];
}

TEST(the_stiffness_is_symmetric_and_its_diagonal_is_what_bending_gives)
{
    test_random random = test_random_begin("stiffness");
    for (int n = test_cases(50); n > 0; n--) {
        double t[MOST], z[MOST];
        bat_batten batten;
        const int count = random_ducks(&random, t, z);
        CHECK_OK(bat_batten_begin(count, t, &batten));
        for (int i = 0; i < count; i++) {
            const double diagonal = force_of_unit(&batten, i, i);
            CHECK_NEAR(batten.diagonal[i], diagonal, 1e-12 * diagonal);
            const int j = test_random_int(&random, 0, count - 1);
            CHECK_NEAR(force_of_unit(&batten, i, j), force_of_unit(&batten, j, i),
                       1e-11 * (diagonal + batten.diagonal[j]));
        }
        bat_batten_end(&batten);
    }
}

TEST(forces_on_a_line_vanish_and_are_in_balance_everywhere)
{
    test_random random = test_random_begin("balance");
    for (int n = test_cases(50); n > 0; n--) {
        double t[MOST], z[MOST], line[MOST], moments[MOST], forces[MOST];
        bat_batten batten;
        const int count = random_ducks(&random, t, z);
        CHECK_OK(bat_batten_begin(count, t, &batten));
        for (int i = 0; i < count; i++)
            line[i] = 3 - 2 * t[i];
        CHECK_NEAR(bat_batten_bend(&batten, 1, line, moments, forces), 0, 1e-22);
        double force = 0, moment = 0, work = 0, largest = 0;
        const double energy = bat_batten_bend(&batten, 1, z, moments, forces);
        for (int i = 0; i < count; i++) {
            force += forces[i];
            moment += forces[i] * t[i];
            work += forces[i] * z[i];
            largest = fmax(largest, fabs(forces[i]));
        }
        CHECK_NEAR(force, 0, 1e-12 * largest + 1e-300);
        CHECK_NEAR(moment, 0, 1e-11 * largest * (1 + fabs(t[count - 1])) + 1e-300);
        CHECK_NEAR(work, energy, 1e-12 * count * largest + 1e-300);
        bat_batten_end(&batten);
    }
}

TEST(a_released_duck_takes_its_place_on_the_batten_through_the_others)
{
    test_random random = test_random_begin("release");
    for (int n = test_cases(50); n > 0; n--) {
        double t[MOST], z[MOST], others_t[MOST], others_z[MOST], moments[MOST], forces[MOST];
        bat_batten batten, others;
        const int count = random_ducks(&random, t, z), i = count / 2;
        if (count < 4)
            continue;
        for (int j = 0, k = 0; j < count; j++)
            if (j != i) {
                others_t[k] = t[j];
                others_z[k++] = z[j];
            }
        CHECK_OK(bat_batten_begin(count, t, &batten));
        CHECK_OK(bat_batten_begin(count - 1, others_t, &others));
        bat_batten_bend(&batten, 1, z, moments, forces);
        batten_curve *curve = NULL;
        double expected, to;
        CHECK_OK(bat_batten_curve(&others, 1, others_z, &curve));
        CHECK_OK(batten_curve_evaluate(curve, t[i], 0, &expected));
        const double far = 1e9, one = 1;
        const int free = 1;
        const bat_ducks duck = {
            .width = 1, .centre = z + i, .within = &far, .freedom = &free, .frames = &one};
        bat_batten shifted = batten;
        shifted.diagonal += i;
        bat_duck_release(&shifted, &duck, 0, z + i, forces + i, 1, &to);
        CHECK_NEAR(to, expected, 1e-9);
        batten_curve_unref(curve);
        bat_batten_end(&others);
        bat_batten_end(&batten);
    }
}

TEST(the_curve_of_a_batten_passes_its_ducks_and_has_its_moments)
{
    test_random random = test_random_begin("curve");
    for (int n = test_cases(20); n > 0; n--) {
        double t[MOST], z[MOST], moments[MOST], at[3];
        bat_batten batten;
        batten_curve *curve = NULL;
        const int count = random_ducks(&random, t, z);
        CHECK_OK(bat_batten_begin(count, t, &batten));
        CHECK_OK(bat_batten_curve(&batten, 1, z, &curve));
        bat_batten_bend(&batten, 1, z, moments, NULL);
        for (int i = 0; i < count; i++) {
            CHECK_OK(batten_curve_evaluate(curve, t[i], 2, at));
            CHECK_NEAR(at[0], z[i], 1e-13);
            CHECK_NEAR(at[2], moments[i], 1e-9);
        }
        batten_curve_unref(curve);
        bat_batten_end(&batten);
    }
}

TEST(clipping_ends_within_the_bound_in_exact_arithmetic)
{
    test_random random = test_random_begin("clip");
    for (int n = test_cases(3000); n > 0; n--) {
        const int width = test_random_int(&random, 1, 3);
        const double size = pow(10, test_random_in(&random, -3, 9));
        const double within = pow(10, test_random_in(&random, -12, 3));
        double centre[3], z[3];
        long double square = 0;
        for (int k = 0; k < width; k++) {
            centre[k] = test_random_in(&random, -size, size);
            z[k] = centre[k] + test_random_in(&random, -2, 2) * within;
        }
        bat_clip(width, centre, within, z);
        for (int k = 0; k < width; k++)
            square += ((long double)z[k] - centre[k]) * ((long double)z[k] - centre[k]);
        CHECK(square <= (long double)within * within);
    }
}
