#include "fair/crossed/battens.h"
#include "support/test.h"

#include <math.h>

enum { NU = 9, NV = 7, NODES = NU * NV };

static const double u[] = {0, 0.1, 0.25, 0.35, 0.5, 0.6, 0.8, 0.9, 1};
static const double v[] = {0, 0.2, 0.3, 0.5, 0.7, 0.8, 1};

/* Every coordinate is cubic in u and in v. */
static void bicubic(double *z)
{
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = z + 3 * (i * NV + j);
            p[0] = 5 * u[i] + v[j] * v[j] * u[i];
            p[1] = 3 * v[j] - pow(u[i], 3) * v[j];
            p[2] = (1 + u[i] - 2 * pow(u[i], 3)) * (2 - v[j] + pow(v[j], 3));
        }
}

static void find(const double *given, double within, double *mended, bat_fair_tally *tally)
{
    const bool closed[2] = {false, false};
    double bounds[NODES];
    bat_crossed battens;
    for (int k = 0; k < NODES; k++)
        bounds[k] = within;
    CHECK_OK(bat_crossed_begin((batten_grid){3, NU, NV, given}, bounds, (batten_uv){u, v},
                               closed, &battens));
    memcpy(mended, given, 3 * NODES * sizeof *mended);
    *tally = (bat_fair_tally){0};
    CHECK_OK(bat_crossed_blunders(&battens, mended, tally));
    bat_crossed_end(&battens);
}

TEST(one_wrong_point_of_a_bicubic_net_is_named_alone_and_mended_exactly)
{
    double exact[3 * NODES], given[3 * NODES], mended[3 * NODES];
    bat_fair_tally tally;
    bicubic(exact);
    for (int n = 0; n < NODES; n++) {
        memcpy(given, exact, sizeof given);
        given[3 * n] += 0.02;
        given[3 * n + 2] -= 0.3;
        find(given, 0.001, mended, &tally);
        CHECK_INT(tally.report.suspect_count, 1);
        const batten_fair_move *found = tally.report.suspects;
        CHECK_INT(found->index, n / NV);
        CHECK_INT(found->set, n % NV);
        for (int c = 0; c < 3; c++) {
            CHECK_BITS(found->from[c], given[3 * n + c]);
            CHECK_NEAR(found->to[c], exact[3 * n + c], 1e-12);
        }
        for (int k = 0; k < 3 * NODES; k++)
            CHECK_NEAR(mended[k], exact[k], 1e-12);
        bat_tally_end(&tally);
    }
}

TEST(of_several_wrong_points_the_worst_is_named_first)
{
    static const int wrong[] = {2 * NV + 3, 6 * NV + 1, 5 * NV + 5};
    static const double by[] = {0.2, 0.4, 0.1};
    static const int order[] = {1, 0, 2};
    double given[3 * NODES], mended[3 * NODES];
    bat_fair_tally tally;
    bicubic(given);
    for (int k = 0; k < 3; k++)
        given[3 * wrong[k] + 2] += by[k];
    find(given, 0.001, mended, &tally);
    CHECK_INT(tally.report.suspect_count, 3);
    for (int k = 0; k < 3; k++) {
        CHECK_INT(tally.report.suspects[k].index, wrong[order[k]] / NV);
        CHECK_INT(tally.report.suspects[k].set, wrong[order[k]] % NV);
    }
    bat_tally_end(&tally);
}

TEST(what_fairing_nearly_mends_is_no_blunder)
{
    double given[3 * NODES], mended[3 * NODES];
    bat_fair_tally tally;
    bicubic(given);
    given[3 * (4 * NV + 3) + 2] += 0.1;
    find(given, 0.06, mended, &tally);
    CHECK_INT(tally.report.suspect_count, 0);
    for (int k = 0; k < 3 * NODES; k++)
        CHECK_BITS(mended[k], given[k]);
    bat_tally_end(&tally);
}

TEST(a_rough_net_has_no_blunders)
{
    double given[3 * NODES], mended[3 * NODES];
    bat_fair_tally tally;
    bicubic(given);
    for (int n = 0; n < NODES; n += 11) /* six of 63 */
        given[3 * n + 2] += 0.2;
    find(given, 0.001, mended, &tally);
    CHECK_INT(tally.report.suspect_count, 0);
    for (int k = 0; k < 3 * NODES; k++)
        CHECK_BITS(mended[k], given[k]);
    bat_tally_end(&tally);
}

/* A torus: rows and columns close. */
TEST(closed_nets_have_blunders_anywhere)
{
    enum { N = 24, M = 20 };
    const bool closed[2] = {true, true};
    static double a[N + 1], b[M + 1], given[3 * N * M], mended[3 * N * M], bounds[N * M];
    for (int i = 0; i <= N; i++)
        a[i] = (double)i / N;
    for (int j = 0; j <= M; j++)
        b[j] = (double)j / M;
    for (int n = 0; n < N * M; n += 37) {
        bat_crossed battens;
        bat_fair_tally tally = {0};
        for (int k = 0; k < N * M; k++) {
            const double p = 2 * acos(-1) * a[k / M], q = 2 * acos(-1) * b[k % M];
            given[3 * k] = (5 + cos(q)) * cos(p);
            given[3 * k + 1] = (5 + cos(q)) * sin(p);
            given[3 * k + 2] = sin(q);
            bounds[k] = 0.01;
        }
        given[3 * n] += 0.5;
        CHECK_OK(bat_crossed_begin((batten_grid){3, N, M, given}, bounds, (batten_uv){a, b},
                                   closed, &battens));
        memcpy(mended, given, sizeof mended);
        CHECK_OK(bat_crossed_blunders(&battens, mended, &tally));
        CHECK_INT(tally.report.suspect_count, 1);
        CHECK_INT(tally.report.suspects[0].index, n / M);
        CHECK_INT(tally.report.suspects[0].set, n % M);
        CHECK_NEAR(mended[3 * n], given[3 * n] - 0.5, 0.02);
        bat_tally_end(&tally);
        bat_crossed_end(&battens);
    }
}
