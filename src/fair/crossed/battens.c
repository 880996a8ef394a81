/* Crossed battens: what they weigh, and how they press on their ducks. */
#include "fair/crossed/battens.h"

#include <string.h>

/* ---- closed battens ---- */

static double span(const bat_crossed_side *side, int i)
{
    const int k = (i + side->count) % side->count;
    return side->t[k + 1] - side->t[k];
}

static batten_status factor_wrap(bat_crossed_side *side)
{
    double *band = bat_array3((size_t)side->count, 3, sizeof *band);
    if (!band)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < side->count; i++) {
        band[3 * i] = span(side, i - 1) / 6;
        band[3 * i + 1] = (span(side, i - 1) + span(side, i)) / 3;
        band[3 * i + 2] = span(side, i) / 6;
    }
    const batten_status status = bat_cyclic_factor(side->count, 1, 1, band, &side->wrap);
    bat_release(band);
    return status;
}

/* As bat_batten_bend, of a batten that closes. */
static batten_status bend_closed(const bat_crossed_side *side, const double *z, double *moments,
                                 double *forces, double *energy)
{
    const int n = side->count;
    for (int i = 0; i < n; i++) {
        const double *here = z + 3 * i, *next = z + 3 * ((i + 1) % n),
                     *last = z + 3 * ((i + n - 1) % n);
        for (int c = 0; c < 3; c++)
            moments[3 * i + c] =
                (next[c] - here[c]) / span(side, i) - (here[c] - last[c]) / span(side, i - 1);
    }
    const batten_status status = bat_cyclic_solve(side->wrap, 3, moments);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < n; i++) {
        const double *here = moments + 3 * i, *next = moments + 3 * ((i + 1) % n),
                     *last = moments + 3 * ((i + n - 1) % n);
        for (int c = 0; c < 3; c++) {
            forces[3 * i + c] =
                (next[c] - here[c]) / span(side, i) - (here[c] - last[c]) / span(side, i - 1);
            *energy +=
                span(side, i) * (here[c] * here[c] + here[c] * next[c] + next[c] * next[c]) / 3;
        }
    }
    return BATTEN_OK;
}

static batten_status bend(const bat_crossed_side *side, const double *z, double *moments,
                          double *forces, double *energy)
{
    *energy = 0;
    if (side->wrap)
        return bend_closed(side, z, moments, forces, energy);
    *energy = bat_batten_bend(&side->open, 3, z, moments, forces);
    return BATTEN_OK;
}

/* ---- one direction ---- */

/* One duck after another is pushed by a unit: a column of K. */
static batten_status weigh(bat_crossed_side *side, double *room)
{
    const int n = side->count;
    double *z = room, *moments = z + 3 * n, *forces = moments + 3 * n, energy;
    memset(z, 0, 3 * (size_t)n * sizeof *z);
    for (int i = 0; i < n; i++) {
        double sum = 0;
        z[3 * i] = 1;
        const batten_status status = bend(side, z, moments, forces, &energy);
        if (status != BATTEN_OK)
            return status;
        z[3 * i] = 0;
        for (int j = 0; j < n; j++)
            sum += fabs(forces[3 * j]);
        side->spread = bat_max(side->spread, sum / forces[3 * i]);
        side->stiffness[i] = side->weight * forces[3 * i];
    }
    return BATTEN_OK;
}

static batten_status side_begin(int count, const double *t, bool closed, double *room,
                                bat_crossed_side *side)
{
    const int spans = closed ? count : count - 1;
    const double mean = (t[spans] - t[0]) / spans;
    *side = (bat_crossed_side){.count = count, .t = t, .weight = mean * mean * mean};
    side->stiffness = bat_array((size_t)count, sizeof *side->stiffness);
    batten_status status = side->stiffness ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = closed ? factor_wrap(side) : bat_batten_begin(count, t, &side->open);
    return status == BATTEN_OK ? weigh(side, room) : status;
}

static void side_end(bat_crossed_side *side)
{
    bat_batten_end(&side->open);
    bat_cyclic_free(side->wrap);
    bat_release(side->stiffness);
}

/* ---- both directions ---- */

batten_status bat_crossed_begin(batten_grid points, const double *within, batten_uv parameters,
                                const bool closed[2], bat_crossed *out)
{
    const int longest = bat_max_int(points.count_u, points.count_v);
    bat_crossed made = {points.count_u, points.count_v, points.at, within, {0}, {0}, NULL};
    made.room = bat_array3((size_t)longest, 9, sizeof *made.room);
    batten_status status = made.room ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = side_begin(points.count_u, parameters.u, closed[0], made.room, &made.u);
    if (status == BATTEN_OK)
        status = side_begin(points.count_v, parameters.v, closed[1], made.room, &made.v);
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_crossed_end(&made);
    return status;
}

void bat_crossed_end(bat_crossed *battens)
{
    side_end(&battens->u);
    side_end(&battens->v);
    bat_release(battens->room);
    *battens = (bat_crossed){0};
}

/* The batten whose duck k is point first + k step adds its forces to those of the points. */
static batten_status bend_line(const bat_crossed *battens, const bat_crossed_side *side,
                               const double *z, size_t step, double *forces, double *energy)
{
    const size_t n = (size_t)side->count;
    double *line = battens->room, *moments = line + 3 * n, *pressed = moments + 3 * n, own;
    for (size_t k = 0; k < n; k++)
        memcpy(line + 3 * k, z + 3 * k * step, 3 * sizeof *z);
    const batten_status status = bend(side, line, moments, pressed, &own);
    for (size_t k = 0; k < n && status == BATTEN_OK; k++)
        for (size_t c = 0; c < 3; c++)
            forces[3 * k * step + c] += side->weight * pressed[3 * k + c];
    *energy += side->weight * own;
    return status;
}

batten_status bat_crossed_bend(bat_crossed *battens, const double *z, double *forces,
                               double *energy)
{
    const size_t nu = (size_t)battens->count_u, nv = (size_t)battens->count_v;
    batten_status status = BATTEN_OK;
    *energy = 0;
    memset(forces, 0, 3 * nu * nv * sizeof *forces);
    for (size_t j = 0; j < nv && status == BATTEN_OK; j++)
        status = bend_line(battens, &battens->u, z + 3 * j, nv, forces + 3 * j, energy);
    for (size_t i = 0; i < nu && status == BATTEN_OK; i++)
        status =
            bend_line(battens, &battens->v, z + 3 * i * nv, 1, forces + 3 * i * nv, energy);
    return status;
}
