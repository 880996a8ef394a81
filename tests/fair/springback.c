#include "fair/fair_points.h"
#include "support/test.h"

enum { N = 7, W = 2 };

/* A piece of seven ducks in the plane with held ends, uneven, and free in all directions. */
typedef struct {
    double t[N], given[W * N], within[N], frames[W * W * N];
    int freedom[N];
    bat_batten batten;
    batten_fair_options options;
    bat_fair_piece piece;
} bench;

static batten_status begin_bench(batten_fair_order order, bench *b)
{
    static const double t[N] = {0, 1, 1.5, 3, 4, 6, 6.5};
    static const double given[W * N] = {0,   0.1, 1, 0.3, 1.4, -0.2, 3.1,
                                        0.5, 4,   1, 6.2, 0.4, 6.5,  0};
    memset(b->frames, 0, sizeof b->frames);
    memcpy(b->t, t, sizeof t);
    memcpy(b->given, given, sizeof given);
    for (int i = 0; i < N; i++) {
        b->within[i] = 10;
        b->freedom[i] = i == 0 || i == N - 1 ? 0 : W;
        b->frames[W * W * i] = b->frames[W * W * i + 3] = 1;
    }
    b->options = batten_fair_defaults(10);
    b->options.order = order;
    b->piece = (bat_fair_piece){.batten = &b->batten,
                                .ducks = {.width = W,
                                          .centre = b->given,
                                          .within = b->within,
                                          .freedom = b->freedom,
                                          .frames = b->frames},
                                .options = &b->options};
    return bat_batten_begin(N, b->t, &b->batten);
}

static batten_status fair_given(const bench *b, double *z)
{
    memcpy(z, b->given, sizeof b->given);
    return bat_fair_springback(&b->piece, z);
}

/* Of the free ducks of the piece, the one under the largest force; its force. */
static int largest_force(const bench *b, const double *z, double force[W])
{
    double moments[W * N], forces[W * N], largest = 0;
    int found = -1;
    bat_batten_bend(&b->batten, W, z, moments, forces);
    for (int i = 0; i < N; i++) {
        const double size = hypot(forces[W * i], forces[W * i + 1]);
        if (b->freedom[i] > 0 && size > largest) {
            largest = size;
            found = i;
            memcpy(force, forces + W * i, W * sizeof *force);
        }
    }
    return found;
}

/* ---- worst first ---- */

TEST(the_ducks_under_the_largest_force_are_released_one_by_one)
{
    static const double relaxations[] = {1, 0.5};
    for (int moves = 1; moves <= 2 * N; moves++)
        for (int r = 0; r < 2; r++) {
            bench b;
            double z[W * N], expected[W * N], force[W];
            CHECK_OK(begin_bench(BATTEN_FAIR_WORST_FIRST, &b));
            b.options.max_moves = moves;
            b.options.relaxation = relaxations[r];
            memcpy(expected, b.given, sizeof z);
            for (int move = 0; move < moves; move++) {
                const int i = largest_force(&b, expected, force);
                for (int k = 0; k < W; k++)
                    expected[W * i + k] -= relaxations[r] * force[k] / b.batten.diagonal[i];
            }
            CHECK_OK(fair_given(&b, z));
            for (int i = 0; i < W * N; i++)
                CHECK_NEAR(z[i], expected[i], 1e-13);
            bat_batten_end(&b.batten);
        }
}

TEST(without_a_limit_there_are_20_moves_for_each_duck)
{
    double z[2][W * N];
    for (int given = 0; given < 2; given++) {
        bench b;
        CHECK_OK(begin_bench(BATTEN_FAIR_WORST_FIRST, &b));
        b.options.max_moves = given ? 20 * N : 0;
        b.options.relaxation = 0.05; /* slow: the last moves are still large */
        CHECK_OK(fair_given(&b, z[given]));
        bat_batten_end(&b.batten);
    }
    CHECK(memcmp(z[0], z[1], sizeof z[0]) == 0);
}

TEST(a_duck_at_its_bound_lets_the_next_go)
{
    bench b;
    double z[W * N], force[W];
    CHECK_OK(begin_bench(BATTEN_FAIR_WORST_FIRST, &b));
    const int worst = largest_force(&b, b.given, force);
    const double size = hypot(force[0], force[1]);
    b.within[worst] = 1e-3;
    b.options.max_moves = 1;
    CHECK_OK(fair_given(&b, z));
    for (int k = 0; k < W; k++)
        CHECK_NEAR(z[W * worst + k], b.given[W * worst + k] - 1e-3 * force[k] / size, 1e-15);
    b.options.max_moves = 2; /* it is still the worst, and would not move */
    CHECK_OK(fair_given(&b, z));
    int moved = 0;
    for (int i = 0; i < N; i++)
        moved += memcmp(z + W * i, b.given + W * i, W * sizeof *z) != 0;
    CHECK_INT(moved, 2);
    bat_batten_end(&b.batten);
}

/* As many moves as it takes, and not one more. */
TEST(it_stops_with_the_first_move_that_makes_the_batten_fair)
{
    bench b;
    double z[W * N], stopped[W * N];
    bool fair = false;
    CHECK_OK(begin_bench(BATTEN_FAIR_WORST_FIRST, &b));
    b.options.stop_when_fair = true;
    CHECK_OK(fair_given(&b, stopped));
    b.options.stop_when_fair = false;
    for (int moves = 1; !fair && moves <= 20 * N; moves++) {
        b.options.max_moves = moves;
        CHECK_OK(fair_given(&b, z));
        CHECK_OK(bat_piece_is_fair(&b.piece, z, &fair));
    }
    CHECK(memcmp(z, stopped, sizeof z) == 0);
    bat_batten_end(&b.batten);
}

/* ---- alternate ---- */

/* Ducks of one parity where none of them is under a force, by releases one after another. */
static void settle_half(const bench *b, int parity, double *z)
{
    double moments[W * N], forces[W * N];
    for (int times = 0; times < 400; times++)
        for (int i = parity; i < N; i += 2) {
            bat_batten_bend(&b->batten, W, z, moments, forces);
            for (int k = 0; k < W && b->freedom[i] > 0; k++)
                z[W * i + k] -= forces[W * i + k] / b->batten.diagonal[i];
        }
}

TEST(even_ducks_then_odd_ones_are_released_in_as_many_rounds_as_the_moves_allow)
{
    static const struct {
        int max_moves, rounds;
    } rows[] = {{1, 1}, {N - 1, 1}, {N, 1}, {2 * N - 1, 1}, {2 * N, 2}, {3 * N + 1, 3}};
    for (int r = 0; r < COUNT(rows); r++) {
        bench b;
        double z[W * N], expected[W * N];
        CHECK_OK(begin_bench(BATTEN_FAIR_ALTERNATE, &b));
        b.options.max_moves = rows[r].max_moves;
        memcpy(expected, b.given, sizeof z);
        for (int half = 0; half < 2 * rows[r].rounds; half++)
            settle_half(&b, half % 2, expected);
        CHECK_OK(fair_given(&b, z));
        for (int i = 0; i < W * N; i++)
            CHECK_NEAR(z[i], expected[i], 1e-5);
        bat_batten_end(&b.batten);
    }
}

TEST(without_a_limit_there_are_100_rounds)
{
    static const int max_moves[3] = {0, 100 * N, 99 * N};
    double z[3][W * N];
    for (int k = 0; k < 3; k++) {
        bench b;
        CHECK_OK(begin_bench(BATTEN_FAIR_ALTERNATE, &b));
        b.options.max_moves = max_moves[k];
        CHECK_OK(fair_given(&b, z[k]));
        bat_batten_end(&b.batten);
    }
    CHECK(memcmp(z[0], z[1], sizeof z[0]) == 0);
    CHECK(memcmp(z[0], z[2], sizeof z[0]) != 0);
}

TEST(all_orders_but_for_limits_end_at_the_least_energy_within_the_bounds)
{
    for (int tight = 0; tight < 2; tight++) {
        double z[3][W * N];
        for (int order = 0; order < 3; order++) {
            bench b;
            CHECK_OK(begin_bench((batten_fair_order)order, &b));
            for (int i = 0; i < N; i++)
                b.within[i] = tight ? 0.1 + 0.02 * i : 2;
            b.options.max_moves = 1000 * N;
            CHECK_OK(fair_given(&b, z[order]));
            for (int i = 0; i < N; i++)
                CHECK(bat_distance(W, z[order] + W * i, b.given + W * i) <=
                      (b.freedom[i] > 0 ? b.within[i] : 0));
            bat_batten_end(&b.batten);
        }
        for (int i = 0; i < W * N; i++) {
            /* Rounds end with moves of 1e-6 of a bound; each is some hundredths less than the one before. */
            CHECK_NEAR(z[BATTEN_FAIR_WORST_FIRST][i], z[BATTEN_FAIR_SWEEPS][i], 5e-4);
            CHECK_NEAR(z[BATTEN_FAIR_ALTERNATE][i], z[BATTEN_FAIR_SWEEPS][i], 5e-4);
        }
    }
}

static bool is_cancelled(void *user)
{
    (void)user;
    return true;
}

TEST(springback_that_is_cancelled_says_so_in_every_order)
{
    for (int order = 0; order < 3; order++) {
        bench b;
        double z[W * N];
        batten_job job = BATTEN_JOB;
        CHECK_OK(begin_bench((batten_fair_order)order, &b));
        job.is_cancelled = is_cancelled;
        b.piece.job = &job;
        CHECK_STATUS(fair_given(&b, z), BATTEN_CANCELLED);
        bat_batten_end(&b.batten);
    }
}
