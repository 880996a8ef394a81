/* Parameters that all lines of a family share: the rows of a grid, the sections of a skin. */
#include "shape/points/grid_parameters.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"

#include <string.h>

static int step_count(const bat_family *g)
{
    return g->periodic ? g->count : g->count - 1;
}

/* By their sum; false when that is 0. */
static bool make_shares(int count, double *steps)
{
    double total = 0;
    for (int i = 0; i < count; i++)
        total += steps[i];
    for (int i = 0; i < count && total != 0; i++)
        steps[i] /= total;
    return total != 0;
}

/* The steps of one line as shares of its length; false when it has none. */
static bool line_shares(const bat_family *g, int line, batten_parametrization kind,
                        double *points, double *shares)
{
    const size_t d = (size_t)g->dimension;
    const double *from = g->points + (size_t)line * g->line_step;
    for (size_t i = 0; i < (size_t)g->count; i++)
        memcpy(points + i * d, from + i * g->point_step, d * sizeof *points);
    bat_steps((batten_points){g->dimension, g->count, points}, kind, g->periodic, shares);
    return make_shares(step_count(g), shares); /* an overflow is found by accumulate */
}

/* From average shares to parameters 0 .. 1. */
static batten_status accumulate(const bat_family *g, int used, double *u)
{
    const int n = step_count(g);
    if (used == 0)
        return bat_fail(BATTEN_COINCIDENT,
                        "all %s coincide: every line across them is a single point", g->name);
    u[0] = 0;
    for (int i = 0; i < n; i++) {
        const double share = u[i + 1] / used;
        if (!isfinite(share))
            return bat_fail(BATTEN_OVERFLOW, "%s %d and %d are too far apart", g->name, i + 1,
                            (i + 1) % g->count + 1);
        /* A millionth of the mean step would leave a crease, not a surface. */
        if (share * n < 1e-6)
            return bat_fail(BATTEN_COINCIDENT,
                            "%s %d and %d coincide: the step is %g of the length", g->name,
                            i + 1, (i + 1) % g->count + 1, share);
        u[i + 1] = u[i] + share;
    }
    u[n] = 1;
    return BATTEN_OK;
}

/* How far the parameters of one line are from u, in steps. */
static double line_spread(const bat_family *g, const double *shares, const double *u)
{
    double at = 0, spread = 0;
    for (int i = 1; i < step_count(g); i++) {
        at += shares[i - 1];
        spread = bat_max(spread, fabs(at - u[i]) / bat_min(u[i] - u[i - 1], u[i + 1] - u[i]));
    }
    return spread;
}

static batten_status average(const bat_family *g, batten_parametrization kind, double *u,
                             double *spread)
{
    const size_t n = (size_t)step_count(g);
    double *points = bat_array3((size_t)g->count, (size_t)g->dimension, sizeof *points);
    double *shares = bat_array(n, sizeof *shares);
    batten_status status = points && shares ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int used = 0;
    *spread = 0;
    memset(u, 0, (n + 1) * sizeof *u);
    for (int line = 0; status == BATTEN_OK && line < g->lines; line++)
        if (line_shares(g, line, kind, points, shares)) {
            used++;
            for (size_t i = 0; i < n; i++)
                u[i + 1] += shares[i];
        }
    if (status == BATTEN_OK)
        status = accumulate(g, used, u);
    for (int line = 0; status == BATTEN_OK && line < g->lines; line++)
        if (line_shares(g, line, kind, points, shares))
            *spread = bat_max(*spread, line_spread(g, shares, u));
    bat_release(shares);
    bat_release(points);
    return status;
}

batten_status bat_family_parametrize(const bat_family *g, batten_parametrization kind,
                                     double *u, double *spread)
{
    if ((int)kind < 0 || kind > BATTEN_GIVEN)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown parametrization %d", (int)kind);
    if (kind != BATTEN_GIVEN)
        return average(g, kind, u, spread);
    if (!g->given)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the parameters of the %s must be given, and are missing", g->name);
    memcpy(u, g->given, ((size_t)g->count + g->periodic) * sizeof *u);
    return bat_parameters_check(g->count + g->periodic, u);
}
