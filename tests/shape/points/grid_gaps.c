/* Grids with gaps: what has no energy comes back, and nothing else has less. */
#include "shape/points/grid_gaps.h"
#include "support/test.h"

enum { NU = 6, NV = 5 };

/* Lines along both directions with all their places, a closed direction with the one after the
 * last: in lengths of which the longer direction has one in all, as the fill counts them. */
typedef struct {
    bat_gaps gaps;
    double at[2][NU + 1];
} lines;

static const double *point_of(const lines *l, int i, int j)
{
    const bat_gaps *g = &l->gaps;
    return g->points +
           (size_t)(i % g->count[0] * g->count[1] + j % g->count[1]) * (size_t)g->dimension;
}

static double distance_of(int d, const double *a, const double *b)
{
    double sum = 0;
    for (int k = 0; k < d; k++)
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sqrt(sum);
}

static void find_lines(lines *l)
{
    const bat_gaps *g = &l->gaps;
    double length[2];
    for (int k = 0; k < 2; k++) {
        double sum = 0;
        int steps = 0;
        for (int i = 0; i + (k == 0) < g->count[0]; i++)
            for (int j = 0; j + (k == 1) < g->count[1]; j++) {
                const int next_i = i + (k == 0), next_j = j + (k == 1);
                if (g->missing[i * g->count[1] + j] ||
                    g->missing[next_i * g->count[1] + next_j])
                    continue;
                sum +=
                    distance_of(g->dimension, point_of(l, i, j), point_of(l, next_i, next_j));
                steps++;
            }
        length[k] = sum / steps * (g->periodic[k] ? g->count[k] : g->count[k] - 1);
    }
    for (int k = 0; k < 2; k++) {
        const int n = g->count[k] + g->periodic[k];
        const double *u = g->parameters[k];
        for (int i = 0; i < n; i++)
            l->at[k][i] = length[k] / fmax(length[0], length[1]) *
                          (u ? (u[i] - u[0]) / (u[n - 1] - u[0]) : i / (n - 1.0));
    }
}

static double mean_width(const lines *l, int k, int i)
{
    const double *at = l->at[k];
    const int n = l->gaps.count[k];
    if (l->gaps.periodic[k])
        return (at[i + 1] - at[i] + (i ? at[i] - at[i - 1] : at[n] - at[n - 1])) / 2;
    return ((i + 1 < n ? at[i + 1] - at[i] : 0) + (i ? at[i] - at[i - 1] : 0)) / 2;
}

/* The sum of Suu^2 + 2 Suv^2 + Svv^2 over the grid, by divided differences. */
static double energy(const lines *l)
{
    const bat_gaps *g = &l->gaps;
    double sum = 0;
    for (int c = 0; c < g->dimension; c++) {
        for (int k = 0; k < 2; k++)
            for (int i = 0; i < (g->periodic[k] ? g->count[k] : g->count[k] - 2); i++)
                for (int j = 0; j < g->count[1 - k]; j++) {
                    const double *at = l->at[k];
                    const int n = g->count[k];
                    const double h = at[i + 1] - at[i];
                    const double m =
                        i + 2 <= n - !g->periodic[k] ? at[i + 2] - at[i + 1] : at[1] - at[0];
                    double p[3];
                    for (int e = 0; e < 3; e++)
                        p[e] = k == 0 ? point_of(l, i + e, j)[c] : point_of(l, j, i + e)[c];
                    const double bend = ((p[2] - p[1]) / m - (p[1] - p[0]) / h) / ((h + m) / 2);
                    sum += bend * bend * (h + m) / 2 * mean_width(l, 1 - k, j);
                }
        for (int i = 0; i < g->count[0] - !g->periodic[0]; i++)
            for (int j = 0; j < g->count[1] - !g->periodic[1]; j++) {
                const double h = l->at[0][i + 1] - l->at[0][i];
                const double m = l->at[1][j + 1] - l->at[1][j];
                const double twist = (point_of(l, i + 1, j + 1)[c] - point_of(l, i + 1, j)[c] -
                                      point_of(l, i, j + 1)[c] + point_of(l, i, j)[c]) /
                                     (h * m);
                sum += 2 * twist * twist * h * m;
            }
    }
    return sum;
}

static const double u_lines[NU + 1] = {2, 2.5, 3.6, 4.1, 5.3, 6, 7.2};
static const double v_lines[NU + 1] = {-1, -0.4, 0.7, 1.1, 2.2, 3};

/* All energies are quadratic: least where a step up and a step down cost the same. */
static void check_least(const lines *l)
{
    const bat_gaps *g = &l->gaps;
    const double whole = energy(l);
    for (int at = 0; at < g->count[0] * g->count[1]; at++)
        for (int c = 0; g->missing[at] && c < g->dimension; c++) {
            double *x = &g->points[at * g->dimension + c];
            const double kept = *x, step = 0.5;
            *x = kept + step;
            const double up = energy(l);
            *x = kept - step;
            const double down = energy(l);
            *x = kept;
            CHECK(up > whole && down > whole);
            CHECK_NEAR(up, down, 1e-10 * up);
        }
}

TEST(no_point_of_a_filled_gap_can_move_without_more_energy)
{
    test_random random = test_random_begin("gaps");
    for (int turn = 0; turn < 16; turn++) {
        double points[NU * NU * 3];
        bool missing[NU * NU];
        lines l = {{.dimension = 1 + turn % 3,
                    .count = {turn & 8 ? NV : NU, turn & 8 ? NU : NV},
                    .periodic = {turn & 1, (turn & 2) != 0},
                    .parameters = {turn & 4 ? u_lines : NULL, turn & 4 ? v_lines : NULL},
                    .missing = missing,
                    .points = points},
                   {{0}, {0}}};
        if (turn & 8) /* as many places as there are lines */
            l.gaps.parameters[0] = l.gaps.parameters[1] = NULL;
        for (int i = 0; i < NU * NV; i++)
            missing[i] = test_random_int(&random, 0, 2) == 0;
        for (int i = 0; i < NU * NV * l.gaps.dimension; i++)
            points[i] = test_random_in(&random, -3, 3);
        find_lines(&l);
        CHECK_OK(bat_gaps_fill(&l.gaps));
        check_least(&l);
    }
}

TEST(gaps_of_a_plane_are_filled_with_points_of_the_plane)
{
    double points[NU * NV * 3], expected[NU * NV * 3];
    bool missing[NU * NV] = {false};
    for (int i = 0; i < NU; i++)
        for (int j = 0; j < NV; j++) {
            double *p = &expected[3 * (i * NV + j)];
            p[0] = 3 * u_lines[i] - v_lines[j] + 5;
            p[1] = u_lines[i] + 7 * v_lines[j];
            p[2] = 2;
            missing[i * NV + j] = (i + 2 * j) % 3 != 0;
        }
    memcpy(points, expected, sizeof points);
    for (int i = 0; i < NU * NV; i++)
        for (int k = 0; missing[i] && k < 3; k++)
            points[3 * i + k] = NAN; /* never looked at */
    const bat_gaps gaps = {3, {NU, NV}, {false, false}, {u_lines, v_lines}, missing, points};
    CHECK_OK(bat_gaps_fill(&gaps));
    for (int i = 0; i < NU * NV * 3; i++)
        CHECK_NEAR(points[i], expected[i], 1e-11);
}

TEST(points_on_one_line_of_a_grid_do_not_determine_its_gaps)
{
    for (int kind = 0; kind < 5; kind++) {
        double points[NU * NV];
        bool missing[NU * NV];
        for (int i = 0; i < NU; i++)
            for (int j = 0; j < NV; j++) {
                points[i * NV + j] = 1.5 * i;
                missing[i * NV + j] = kind == 0   ? true             /* nothing is there */
                                      : kind == 1 ? i != 2 || j != 3 /* one point */
                                      : kind == 2 ? j != 2           /* one line */
                                                  : i != j;          /* a diagonal */
            }
        bat_gaps gaps = {1, {NU, NV}, {false, false}, {NULL, NULL}, missing, points};
        double kept[NU * NV];
        if (kind < 4) {
            memcpy(kept, points, sizeof kept);
            CHECK_STATUS(bat_gaps_fill(&gaps), BATTEN_SINGULAR_SYSTEM);
            CHECK(!memcmp(kept, points, sizeof kept));
        } else { /* one point beside the diagonal is enough */
            missing[4 * NV + 1] = false;
            CHECK_OK(bat_gaps_fill(&gaps));
            for (int i = 0; i < NU * NV; i++)
                CHECK_NEAR(points[i], 1.5 * (i / NV), 1e-11);
        }
    }
}

TEST(a_closed_direction_cannot_tilt_so_that_fewer_points_determine_its_gaps)
{
    for (int closed = 1; closed < 4; closed++)
        for (int there = 0; there < 3; there++) {
            double points[NU * NV] = {0};
            bool missing[NU * NV];
            for (int i = 0; i < NU * NV; i++)
                missing[i] = true;
            /* none, one, or two on different lines of both directions */
            for (int n = 0; n < there; n++) {
                missing[(1 + 2 * n) * NV + 1 + 2 * n] = false;
                points[(1 + 2 * n) * NV + 1 + 2 * n] = 4;
            }
            const bat_gaps gaps = {1,       {NU, NV}, {closed & 1, closed > 1}, {NULL, NULL},
                                   missing, points};
            const bool enough = there == 2 || (there == 1 && closed == 3);
            CHECK_STATUS(bat_gaps_fill(&gaps), enough ? BATTEN_OK : BATTEN_SINGULAR_SYSTEM);
            for (int i = 0; enough && i < NU * NV; i++)
                CHECK_NEAR(points[i], 4, 1e-10);
        }
}

TEST(more_gaps_than_can_be_solved_are_refused)
{
    const int n = 700;
    double *points = test_array((size_t)n * (size_t)n, sizeof *points);
    bool *missing = test_array((size_t)n * (size_t)n, sizeof *missing);
    for (int i = 1; i < n * n - 1; i++)
        missing[i] = i != 3;
    const bat_gaps gaps = {1, {n, n}, {false, false}, {NULL, NULL}, missing, points};
    CHECK_STATUS(bat_gaps_fill(&gaps), BATTEN_TOO_LARGE);
    CHECK_MESSAGE("489997 gaps");
}
