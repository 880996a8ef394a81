/*
 * Gaps of a grid are filled by least energy: the sums that stand for the integral of Suu^2 + 2
 * Suv^2
 * + Svv^2 over the grid, in lengths along its lines, become least over the missing points.
 * Every term touches three or four points; the equations of the missing ones form a band.
 */
#include "shape/points/grid_gaps.h"
#include "numeric/banded.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

typedef struct {
    const bat_gaps *gaps;
    double *at[2]; /* [count + 1] places of the lines, in average lengths */
    int *number;   /* [count u][count v] of a missing point, or -1 */
    int unknowns, lower;
    double *matrix; /* [unknowns][lower + 1] */
    double *right;  /* [unknowns][d] */
} filling;

/* ---- places ---- */

static size_t node(const bat_gaps *g, int i, int j)
{
    return (size_t)(i % g->count[0]) * (size_t)g->count[1] + (size_t)(j % g->count[1]);
}

/* The average length of the lines along direction k, as far as points are neighbours. */
static double average_length(const bat_gaps *g, int k)
{
    const size_t d = (size_t)g->dimension;
    double sum = 0;
    long long steps = 0;
    for (int i = 0; i + (k == 0) < g->count[0]; i++)
        for (int j = 0; j + (k == 1) < g->count[1]; j++) {
            const size_t a = node(g, i, j), b = node(g, i + (k == 0), j + (k == 1));
            if (g->missing[a] || g->missing[b])
                continue;
            sum += bat_distance(g->dimension, g->points + a * d, g->points + b * d);
            steps++;
        }
    return steps > 0 && sum > 0 ? sum / (double)steps * (g->count[k] - !g->periodic[k]) : 1;
}

/* Relative to the longer direction: only shares matter. */
static batten_status find_places(filling *f)
{
    const bat_gaps *g = f->gaps;
    double length[2];
    for (int k = 0; k < 2; k++)
        length[k] = average_length(g, k);
    const double longest = bat_max(length[0], length[1]);
    for (int k = 0; k < 2; k++) {
        const int n = g->count[k] + g->periodic[k];
        f->at[k] = bat_array((size_t)n + 1, sizeof *f->at[k]);
        if (!f->at[k])
            return BATTEN_OUT_OF_MEMORY;
        const double *u = g->parameters[k];
        const double scale = bat_max(length[k] / longest, 1e-6) / (u ? u[n - 1] - u[0] : n - 1);
        for (int i = 0; i < n; i++)
            f->at[k][i] = scale * (u ? u[i] - u[0] : i);
    }
    return BATTEN_OK;
}

/* ---- equations ---- */

/* Points along the shorter direction have neighbouring numbers. */
static void number_points(filling *f)
{
    const bat_gaps *g = f->gaps;
    const int inner = g->count[1] <= g->count[0] ? 1 : 0;
    for (int a = 0; a < g->count[1 - inner]; a++)
        for (int b = 0; b < g->count[inner]; b++) {
            const size_t at = inner == 1 ? node(g, a, b) : node(g, b, a);
            f->number[at] = g->missing[at] ? f->unknowns++ : -1;
        }
}

/* A term: weight (sum of c p)^2 over `count` points. */
typedef void (*term_action)(filling *f, int count, const size_t *nodes, const double *c,
                            double weight);

static void measure_band(filling *f, int count, const size_t *nodes, const double *c,
                         double weight)
{
    (void)c;
    (void)weight;
    for (int a = 0; a < count; a++)
        for (int b = 0; b < count; b++) {
            const int i = f->number[nodes[a]], j = f->number[nodes[b]];
            if (i >= 0 && j >= 0)
                f->lower = bat_max_int(f->lower, i - j);
        }
}

static void add_term(filling *f, int count, const size_t *nodes, const double *c, double weight)
{
    const size_t d = (size_t)f->gaps->dimension, wide = (size_t)f->lower + 1;
    for (int a = 0; a < count; a++)
        for (int b = 0; b < count; b++) {
            const int i = f->number[nodes[a]], j = f->number[nodes[b]];
            const double value = weight * c[a] * c[b];
            if (i >= 0 && j >= 0 && j <= i)
                f->matrix[(size_t)i * wide + (size_t)(f->lower - i + j)] += value;
            for (size_t k = 0; i >= 0 && j < 0 && k < d; k++)
                f->right[(size_t)i * d + k] -= value * f->gaps->points[nodes[b] * d + k];
        }
}

/* The width of the strip around line i. */
static double strip(const bat_gaps *g, const double *at, int k, int i)
{
    const int last = g->count[k] - 1;
    if (g->periodic[k])
        return (at[i + 1] - at[i] + (i > 0 ? at[i] - at[i - 1] : at[last + 1] - at[last])) / 2;
    return (at[bat_min_int(i + 1, last)] - at[bat_max_int(i - 1, 0)]) / 2;
}

/* The second differences along direction k. */
static void second_terms(filling *f, int k, term_action act)
{
    const bat_gaps *g = f->gaps;
    const double *at = f->at[k];
    const int terms = g->periodic[k] ? g->count[k] : g->count[k] - 2;
    for (int i = 0; i < terms; i++) {
        const int n = g->count[k], next = i + 2 > n ? 1 : 0;
        const double h0 = at[i + 1] - at[i];
        const double h1 = next ? at[1] - at[0] : at[bat_min_int(i + 2, n)] - at[i + 1];
        if (!(h0 > 0 && h1 > 0))
            continue;
        const double c[3] = {2 / (h0 * (h0 + h1)), -2 / (h0 * h1), 2 / (h1 * (h0 + h1))};
        for (int j = 0; j < g->count[1 - k]; j++) {
            size_t nodes[3];
            for (int e = 0; e < 3; e++)
                nodes[e] = k == 0 ? node(g, i + e, j) : node(g, j, i + e);
            act(f, 3, nodes, c, (h0 + h1) / 2 * strip(g, f->at[1 - k], 1 - k, j));
        }
    }
}

/* The mixed differences, one for each cell. */
static void mixed_terms(filling *f, term_action act)
{
    const bat_gaps *g = f->gaps;
    const int nu = g->count[0] - !g->periodic[0], nv = g->count[1] - !g->periodic[1];
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const double h = f->at[0][i + 1] - f->at[0][i], k = f->at[1][j + 1] - f->at[1][j];
            const size_t nodes[4] = {node(g, i, j), node(g, i + 1, j), node(g, i, j + 1),
                                     node(g, i + 1, j + 1)};
            const double c[4] = {1 / (h * k), -1 / (h * k), -1 / (h * k), 1 / (h * k)};
            act(f, 4, nodes, c, 2 * h * k);
        }
}

static void each_term(filling *f, term_action act)
{
    for (int k = 0; k < 2; k++)
        second_terms(f, k, act);
    mixed_terms(f, act);
}

/* ---- solving ---- */

static batten_status make_equations(filling *f)
{
    number_points(f);
    each_term(f, measure_band);
    const double size = (double)f->unknowns * (f->lower + 1);
    if (size > 4e7 || size * (f->lower + 1) > 2e10)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d gaps, with up to %d between neighbours: too many to fill",
                        f->unknowns, f->lower);
    f->matrix = bat_array3((size_t)f->unknowns, (size_t)f->lower + 1, sizeof *f->matrix);
    f->right = bat_array3((size_t)f->unknowns, (size_t)f->gaps->dimension, sizeof *f->right);
    if (!f->matrix || !f->right)
        return BATTEN_OUT_OF_MEMORY;
    each_term(f, add_term);
    return BATTEN_OK;
}

/* How far the points that are there reach from the first; with `way`, across it: the largest
 * cross product. *far is where. */
static double reach(const filling *f, const double way[2], double far[2])
{
    const bat_gaps *g = f->gaps;
    double most = 0, first[2] = {-1, -1};
    for (int i = 0; i < g->count[0]; i++)
        for (int j = 0; j < g->count[1]; j++) {
            if (g->missing[node(g, i, j)])
                continue;
            /* Along a direction that closes nothing can tilt. */
            const double at[2] = {g->periodic[0] ? 0 : f->at[0][i],
                                  g->periodic[1] ? 0 : f->at[1][j]};
            if (first[0] < 0)
                memcpy(first, at, sizeof first);
            const double off[2] = {at[0] - first[0], at[1] - first[1]};
            const double size =
                way ? fabs(way[0] * off[1] - way[1] * off[0]) : bat_hypot(off[0], off[1]);
            if (size > most) {
                most = size;
                memcpy(far, off, sizeof off);
            }
        }
    return first[0] < 0 ? -1 : most;
}

/* Nothing but planes has no energy, so what is there must not lie on one line. */
static bool is_determined(const filling *f)
{
    const bool *closes = f->gaps->periodic;
    double way[2] = {0, 0}, across[2];
    const double length = reach(f, NULL, way);
    if (length < 0 || (closes[0] && closes[1]))
        return length >= 0;
    if (closes[0] || closes[1])
        return length > 0;
    return length > 0 && reach(f, way, across) > 1e-9 * length * length;
}

static void put_points(const filling *f)
{
    const bat_gaps *g = f->gaps;
    const size_t d = (size_t)g->dimension;
    for (size_t at = 0; at < (size_t)g->count[0] * (size_t)g->count[1]; at++)
        if (f->number[at] >= 0)
            memcpy(g->points + at * d, f->right + (size_t)f->number[at] * d,
                   d * sizeof *g->points);
}

static batten_status solve(filling *f)
{
    if (!is_determined(f) ||
        bat_symmetric_factor(f->unknowns, f->lower, f->matrix) != BATTEN_OK)
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "the points that are there do not determine the %d gaps", f->unknowns);
    bat_symmetric_solve(f->unknowns, f->lower, f->matrix, (size_t)f->gaps->dimension, f->right);
    put_points(f);
    return BATTEN_OK;
}

batten_status bat_gaps_fill(const bat_gaps *gaps)
{
    filling f = {.gaps = gaps};
    f.number = bat_array3((size_t)gaps->count[0], (size_t)gaps->count[1], sizeof *f.number);
    batten_status status = f.number ? find_places(&f) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = make_equations(&f);
    if (status == BATTEN_OK)
        status = solve(&f);
    bat_release(f.right);
    bat_release(f.matrix);
    bat_release(f.number);
    bat_release(f.at[1]);
    bat_release(f.at[0]);
    return status;
}
