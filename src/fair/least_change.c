/*
 * Fairing by least change: of all battens that pass the ducks within their bounds and turn no more often than the points require,
 * the one nearest to them, by the sum of the squares of the moves over their bounds. A curve that has no inflection in excess, or of
 * which none can be removed, is not moved at all.
 *
 * Where it may turn is read off the batten of least energy within the bounds. For a function the program is convex and solved
 * once; of a plane curve P' x P'' is a product, which is taken to the first order about the last solution, again and again.
 */
#include "fair/least_change.h"
#include "base/work.h"
#include "fair/fairness.h"
#include "fair/sign_pattern.h"

#include <string.h>

enum { ROUNDS = 20 };

/* Of a step in units of the largest bound, at which rounds end. */
static const double at_rest = 1e-9;

/* The inflections of the batten through z that points within their bounds do not require. */
static batten_status count_excess(const bat_fair_piece *piece, const double *z, int *excess)
{
    const bat_ducks *ducks = &piece->ducks;
    batten_fairness found;
    const batten_status status = bat_batten_fairness(
        piece->batten, &(bat_batten_points){ducks->width, ducks->centre, ducks->within, z},
        &found);
    *excess = status == BATTEN_OK ? found.excess_inflections : 0;
    return status;
}

/* The signs that the batten of least energy has, with no more changes than are required. `least` is where it is. */
static batten_status choose_signs(bat_least_change *c, double *least)
{
    const bat_fair_piece *piece = c->piece;
    const bat_ducks *ducks = &piece->ducks;
    double residual, *turning = bat_arena_array(&c->arena, (size_t)c->ducks, sizeof *turning);
    int required = 0;
    batten_status status = turning ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_batten_least(piece->batten, ducks, piece->job, least, &residual);
    if (status == BATTEN_OK)
        status = bat_required_inflections(c->width, c->ducks, piece->batten->t, ducks->centre,
                                          ducks->within, &required);
    if (status != BATTEN_OK)
        return status;
    bat_change_bend(c, least);
    bat_change_turning(c, turning);
    return bat_sign_pattern(c->ducks, turning, required, c->signs);
}

/* Into the balls to the last place; held ducks where they were. */
static void settle(const bat_ducks *ducks, int count, double *z)
{
    const int w = ducks->width;
    for (int i = 0; i < count; i++)
        if (ducks->freedom[i] > 0)
            bat_clip(w, ducks->centre + i * w, ducks->within[i], z + i * w);
        else
            memcpy(z + i * w, ducks->centre + i * w, (size_t)w * sizeof *z);
}

/*
 * One step. Where bounds leave no room for the signs, the prices of all that miss make a program too hard to solve: `length` is 0
 * then, and z as it was.
 */
static batten_status take_step(bat_least_change *c, double *z, double *length)
{
    const batten_status status = bat_change_step(c, z, length);
    return status == BATTEN_INCOMPLETE || status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status;
}

/* From the least energy on, where all signs are as they should be. */
static batten_status change_least(bat_least_change *c, double *z)
{
    const int rounds = c->width == 1 ? 1 : ROUNDS;
    bat_work work = {c->piece->job, 0};
    double length = HUGE_VAL;
    batten_status status = BATTEN_OK;
    for (int round = 0; status == BATTEN_OK && round < rounds && length > at_rest; round++) {
        status = bat_work_step(&work, (uint64_t)c->ducks, round / (double)rounds, "fairing");
        if (status == BATTEN_OK)
            status = take_step(c, z, &length);
    }
    if (status == BATTEN_OK)
        settle(&c->piece->ducks, c->ducks, z);
    return status;
}

batten_status bat_fair_least_change(const bat_fair_piece *piece, double *z)
{
    const size_t numbers = (size_t)piece->batten->count * (size_t)piece->ducks.width;
    int excess, left_least = 0, left = 0;
    bat_least_change c = {0};
    batten_status status = count_excess(piece, z, &excess);
    if (status != BATTEN_OK || excess == 0)
        return status;
    status = bat_change_begin(piece, &c);
    double *least = bat_arena_array(&c.arena, numbers, sizeof *least);
    double *changed = bat_arena_array(&c.arena, numbers, sizeof *changed);
    if (status == BATTEN_OK)
        status = bat_arena_status(&c.arena);
    if (status == BATTEN_OK)
        status = choose_signs(&c, least);
    if (status == BATTEN_OK) {
        memcpy(changed, least, numbers * sizeof *changed);
        status = change_least(&c, changed);
    }
    if (status == BATTEN_OK)
        status = count_excess(piece, changed, &left);
    if (status == BATTEN_OK && left > 0)
        status = count_excess(piece, least, &left_least);
    if (status == BATTEN_OK && bat_min_int(left, left_least) < excess)
        memcpy(z, left > left_least ? least : changed, numbers * sizeof *z);
    bat_arena_free(&c.arena);
    return status;
}
