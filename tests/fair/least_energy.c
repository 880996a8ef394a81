#include "fair/elastic_batten.h"
#include "support/test.h"

enum { MOST = 2000 };

typedef struct {
    double t[MOST], y[3 * MOST], z[3 * MOST], within[MOST], frames[9 * MOST];
    double moments[3 * MOST], forces[3 * MOST];
    int freedom[MOST];
    bat_batten batten;
    bat_ducks ducks;
} bench;

/* Noisy points of a wave, all free but the ends. */
static bench *noisy_wave(int count, int width, double noise, double within, uint64_t seed)
{
    bench *b = test_array(1, sizeof *b);
    test_random random = test_random_begin("noisy wave");
    random.state += seed * 2654435761u;
    for (int i = 0; i < count; i++) {
        b->t[i] = 10.0 * (i + 0.3 * test_random_unit(&random)) / count;
        b->freedom[i] = i > 0 && i < count - 1 ? width : 0;
        b->within[i] = within;
        for (int k = 0; k < width; k++) {
            b->y[i * width + k] = sin(b->t[i] + k) + noise * test_random_in(&random, -1, 1);
            b->frames[(i * width + k) * width + k] = 1;
        }
    }
    b->ducks = (bat_ducks){.width = width,
                           .centre = b->y,
                           .within = b->within,
                           .freedom = b->freedom,
                           .frames = b->frames};
    return b;
}

/* Inside its bound a duck feels no force; at the bound the force points outwards along the
 * move. */
static void check_optimal(bench *b, int count, double tolerance)
{
    const int width = b->ducks.width;
    double to[3];
    bat_batten_bend(&b->batten, width, b->z, b->moments, b->forces);
    for (int i = 0; i < count; i++) {
        const double *z = b->z + i * width;
        CHECK(bat_distance(width, z, b->y + i * width) <= b->within[i]);
        if (b->freedom[i] == 0) {
            CHECK(bat_distance(width, z, b->y + i * width) == 0);
            continue;
        }
        bat_duck_release(&b->batten, &b->ducks, i, z, b->forces + i * width, 1, to);
        CHECK_NEAR(bat_distance(width, z, to), 0, tolerance * b->within[i]);
    }
}

TEST(no_released_duck_wants_to_move)
{
    static const struct {
        int count, width;
        double noise, within;
    } cases[] = {{5, 1, 0.05, 0.05},    {40, 1, 0.05, 0.05},  {400, 1, 0.05, 0.05},
                 {2000, 1, 0.05, 0.05}, {300, 2, 0.05, 0.02}, {300, 3, 0.01, 0.02},
                 {400, 1, 0.05, 3},     {400, 1, 0, 0.05},    {500, 1, 0.05, 1e-6}};
    for (int c = 0; c < COUNT(cases); c++) {
        bench *b =
            noisy_wave(cases[c].count, cases[c].width, cases[c].noise, cases[c].within, c);
        double residual;
        CHECK_OK(bat_batten_begin(cases[c].count, b->t, &b->batten));
        CHECK_OK(bat_batten_least(&b->batten, &b->ducks, NULL, b->z, &residual));
        CHECK(residual <= 1e-8);
        check_optimal(b, cases[c].count, 1e-7);
        bat_batten_end(&b->batten);
    }
}

TEST(the_least_energy_is_the_limit_of_endless_sweeps)
{
    enum { N = 12 };
    bench *b = noisy_wave(N, 1, 0.3, 0.1, 5);
    double swept[N], residual;
    CHECK_OK(bat_batten_begin(N, b->t, &b->batten));
    CHECK_OK(bat_batten_least(&b->batten, &b->ducks, NULL, b->z, &residual));
    memcpy(swept, b->y, sizeof swept);
    for (int sweep = 0; sweep < 5000; sweep++)
        for (int i = 1; i < N - 1; i++) {
            bat_batten_bend(&b->batten, 1, swept, b->moments, b->forces);
            bat_duck_release(&b->batten, &b->ducks, i, swept + i, b->forces + i, 1, swept + i);
        }
    for (int i = 0; i < N; i++)
        CHECK_NEAR(b->z[i], swept[i], 1e-8);
    bat_batten_end(&b->batten);
}

/* The residual leaves out what the forces round by, and that grows with the largest ordinate,
 * wherever along the batten and in whatever coordinate it stands. */
TEST(large_ordinates_at_the_far_end_alone_are_faired_to_the_same_rest)
{
    for (int width = 2; width <= 3; width++) {
        enum { N = 45 };
        bench *b = noisy_wave(N, width, 1e-4, 1e-4, 11);
        double residual;
        for (int i = 0; i < N; i++)
            b->y[i * width + width - 1] += 1e9 * pow((double)i / (N - 1), 8);
        CHECK_OK(bat_batten_begin(N, b->t, &b->batten));
        CHECK_OK(bat_batten_least(&b->batten, &b->ducks, NULL, b->z, &residual));
        CHECK(residual <= 1e-10);
        for (int i = 0; i < N; i++)
            CHECK(bat_distance(width, b->z + i * width, b->y + i * width) <= b->within[i]);
        bat_batten_end(&b->batten);
    }
}

TEST(energy_cannot_be_lowered_by_any_allowed_change)
{
    bench *b = noisy_wave(60, 2, 0.05, 0.03, 8);
    test_random random = test_random_begin("allowed change");
    double residual;
    CHECK_OK(bat_batten_begin(60, b->t, &b->batten));
    CHECK_OK(bat_batten_least(&b->batten, &b->ducks, NULL, b->z, &residual));
    const double least = bat_batten_bend(&b->batten, 2, b->z, b->moments, NULL);
    for (int n = 0; n < 200; n++) {
        double *other = test_array(120, sizeof *other);
        const double part = pow(10, -test_random_in(&random, 0, 4));
        for (int i = 0; i < 60; i++) {
            const double r = b->within[i] * sqrt(test_random_unit(&random));
            const double angle = test_random_in(&random, 0, 6.28);
            const double move[2] = {r * cos(angle), r * sin(angle)};
            for (int k = 0; k < 2; k++) {
                const double allowed =
                    b->freedom[i] ? b->y[2 * i + k] + move[k] : b->y[2 * i + k];
                other[2 * i + k] = b->z[2 * i + k] + part * (allowed - b->z[2 * i + k]);
            }
        }
        CHECK(bat_batten_bend(&b->batten, 2, other, b->moments, NULL) >= least * (1 - 1e-10));
    }
    bat_batten_end(&b->batten);
}

TEST(springs_hold_ducks_between_batten_and_anchor)
{
    /* Two free ducks on springs far stiffer than the batten stay at their anchors, on soft ones
     * the batten is straight; the balance is that of forces. */
    bench *b = noisy_wave(5, 1, 0, 10, 1);
    double pull[5] = {0, 1e9, 2, 1e-9, 0}, anchor[5] = {0, 0.7, 0.2, 0, 0}, residual;
    b->ducks.pull = pull;
    b->ducks.anchor = anchor;
    CHECK_OK(bat_batten_begin(5, b->t, &b->batten));
    CHECK_OK(bat_batten_least(&b->batten, &b->ducks, NULL, b->z, &residual));
    bat_batten_bend(&b->batten, 1, b->z, b->moments, b->forces);
    CHECK_NEAR(b->z[1], 0.7, 1e-8);
    for (int i = 1; i < 4; i++)
        CHECK_NEAR(b->forces[i] + pull[i] * (b->z[i] - anchor[i]), 0, 1e-6);
    bat_batten_end(&b->batten);
}

static bool is_cancelled(void *user)
{
    (void)user;
    return true;
}

TEST(I8_fairing_that_is_cancelled_leaves_nothing_behind)
{
    bench *b = noisy_wave(40, 1, 0.05, 0.05, 2);
    batten_job job = BATTEN_JOB;
    double residual = 7;
    job.is_cancelled = is_cancelled;
    CHECK_OK(bat_batten_begin(40, b->t, &b->batten));
    CHECK_STATUS(bat_batten_least(&b->batten, &b->ducks, &job, b->z, &residual),
                 BATTEN_CANCELLED);
    CHECK(b->z[20] == 0 && residual == 7);
    bat_batten_end(&b->batten);
}
