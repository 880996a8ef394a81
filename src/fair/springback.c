/* Springback: ducks are released one by one, every second, or all until none wants to move. */
#include "base/work.h"
#include "fair/fair_points.h"

#include <string.h>

/* Which duck is under the largest force of those that would move; -1 for none. `to` is where.
 */
static int worst_duck(const bat_batten *batten, const bat_ducks *ducks, const double *z,
                      const double *forces, double relaxation, double *to)
{
    const int w = ducks->width;
    const double zero[3] = {0};
    double worst = 0;
    int found = -1;
    for (int i = 0; i < batten->count; i++) {
        double place[3];
        const double force = bat_distance(w, forces + i * w, zero);
        if (ducks->freedom[i] == 0 || force <= worst)
            continue;
        /* A thousandth part of what the sweeps stop at: to release less is no gain. */
        bat_duck_release(batten, ducks, i, z + i * w, forces + i * w, relaxation, place);
        if (bat_distance(w, z + i * w, place) > 1e-9 * ducks->within[i]) {
            worst = force;
            found = i;
            memcpy(to, place, (size_t)w * sizeof *to);
        }
    }
    return found;
}

static batten_status worst_first(const bat_fair_piece *piece, double *z)
{
    const batten_fair_options *options = piece->options;
    const bat_batten *batten = piece->batten;
    const bat_ducks *ducks = &piece->ducks;
    const int n = batten->count, w = ducks->width;
    const int most = options->max_moves > 0 ? options->max_moves : 20 * n;
    bat_work work = {piece->job, 0};
    double *moments = bat_array3((size_t)n, 2 * (size_t)w, sizeof *moments);
    if (!moments)
        return BATTEN_OUT_OF_MEMORY;
    double *forces = moments + (size_t)n * (size_t)w, to[3];
    batten_status status = BATTEN_OK;
    bool done = false;
    if (options->stop_when_fair)
        status = bat_piece_is_fair(piece, z, &done);
    for (int k = 0; status == BATTEN_OK && !done && k < most; k++) {
        bat_batten_bend(batten, w, z, moments, forces);
        const int i = worst_duck(batten, ducks, z, forces, options->relaxation, to);
        done = i < 0;
        if (!done)
            memcpy(z + i * w, to, (size_t)w * sizeof *z);
        if (!done && options->stop_when_fair)
            status = bat_piece_is_fair(piece, z, &done);
        if (status == BATTEN_OK)
            status = bat_work_step(&work, (uint64_t)n, k / (double)most, "fairing");
    }
    bat_release(moments);
    return status;
}

/* Let every second duck go, from `parity` on, and hold the others where they are. */
static batten_status release_half(const bat_fair_piece *piece, int parity, double *centre,
                                  int *freedom, double *z, double *change)
{
    const int n = piece->batten->count, w = piece->ducks.width;
    const size_t row = (size_t)w * sizeof *z;
    bat_ducks ducks = piece->ducks;
    for (int i = 0; i < n; i++) {
        const bool free = i % 2 == parity;
        freedom[i] = free ? ducks.freedom[i] : 0;
        memcpy(centre + i * w, free ? ducks.centre + i * w : z + i * w, row);
    }
    ducks.centre = centre;
    ducks.freedom = freedom;
    double *next = bat_array((size_t)n, row), residual;
    if (!next)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = bat_batten_least(piece->batten, &ducks, piece->job, next, &residual);
    for (int i = 0; status == BATTEN_OK && i < n; i++)
        if (freedom[i] > 0)
            *change =
                bat_max(*change, bat_distance(w, z + i * w, next + i * w) / ducks.within[i]);
    if (status == BATTEN_OK)
        memcpy(z, next, (size_t)n * row);
    bat_release(next);
    return status;
}

static batten_status alternate(const bat_fair_piece *piece, double *z)
{
    const int n = piece->batten->count, most = piece->options->max_moves;
    const int rounds = most > 0 ? bat_max_int(1, most / n) : 100;
    double *centre = bat_array3((size_t)n, (size_t)piece->ducks.width, sizeof *centre);
    int *freedom = bat_array((size_t)n, sizeof *freedom);
    batten_status status = centre && freedom ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    double change = HUGE_VAL;
    for (int k = 0; status == BATTEN_OK && k < rounds && change > BAT_DUCK_AT_REST; k++) {
        change = 0;
        for (int parity = 0; status == BATTEN_OK && parity < 2; parity++)
            status = release_half(piece, parity, centre, freedom, z, &change);
    }
    bat_release(freedom);
    bat_release(centre);
    return status;
}

batten_status bat_fair_springback(const bat_fair_piece *piece, double *z)
{
    double residual;
    if (piece->options->order == BATTEN_FAIR_WORST_FIRST)
        return worst_first(piece, z);
    if (piece->options->order == BATTEN_FAIR_ALTERNATE)
        return alternate(piece, z);
    return bat_batten_least(piece->batten, &piece->ducks, piece->job, z, &residual);
}
