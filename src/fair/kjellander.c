/*
 * Kjellander's method: a point is put where the cubic with the positions and tangents of its two neighbours is at its parameter;
 * one_by_one.c keeps the bound and tries a half of the way, a quarter, an eighth.
 *
 * That is P - F (h k / (h + k))^3 / 3, for the force F, the jump of the third derivative, between spans of h and k: of the
 * batten only the truncated power F (t - t_j)^3_+ / 6 is no cubic there, and the cubic with its values and slopes at both
 * neighbours is -F (h k / (h + k))^3 / 3 at t_j.
 * Source: [Kje83].
 */
#include "fair/fair_points.h"

typedef struct {
    const bat_fair_piece *piece;
    double *moments, *forces; /* [count][width] */
} kjellander;

/* The part of the forces along which points may move. */
static double free_square(const bat_ducks *ducks, int i, const double *force)
{
    const int w = ducks->width;
    double square = 0;
    for (int row = 0; row < ducks->freedom[i]; row++) {
        const double along =
            bat_dot(w, ducks->frames + (size_t)(i * w + row) * (size_t)w, force);
        square += along * along;
    }
    return square;
}

static double sum_of_squared_jumps(void *state, const double *z, double *unfairness)
{
    kjellander *k = state;
    const bat_ducks *ducks = &k->piece->ducks;
    const int n = k->piece->batten->count, w = ducks->width;
    double sum = 0;
    bat_batten_bend(k->piece->batten, w, z, k->moments, k->forces);
    for (int i = 0; i < n; i++) {
        const double *force = k->forces + i * w;
        unfairness[i] = i > 0 && i < n - 1 ? free_square(ducks, i, force) : 0;
        sum += bat_dot(w, force, force);
    }
    return sum;
}

static void put_on_cubic(void *state, const double *z, int i, double *to)
{
    const kjellander *k = state;
    const int w = k->piece->ducks.width;
    const double *t = k->piece->batten->t;
    const double before = t[i] - t[i - 1], after = t[i + 1] - t[i];
    const double length = before * (after / (before + after));
    bat_batten_bend(k->piece->batten, w, z, k->moments, k->forces);
    for (int c = 0; c < w; c++)
        to[c] -= k->forces[i * w + c] * length * length * length / 3;
}

batten_status bat_fair_kjellander(const bat_fair_piece *piece, double *z)
{
    const size_t numbers = (size_t)piece->batten->count * (size_t)piece->ducks.width;
    kjellander k = {piece, bat_array(numbers, 2 * sizeof *k.moments), NULL};
    if (!k.moments)
        return BATTEN_OUT_OF_MEMORY;
    k.forces = k.moments + numbers;
    bat_one_by_one method = bat_piece_one_by_one(piece);
    method.state = &k;
    method.measure = sum_of_squared_jumps;
    method.propose = put_on_cubic;
    const batten_status status = bat_move_one_by_one(&method, z);
    bat_release(k.moments);
    return status;
}
