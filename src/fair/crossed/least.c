/*
 * The least energy of crossed battens within its balls, by projected gradients with momentum: all ducks
 * step at once, so that what is symmetric stays so, each by its force over its own stiffness;
 * momentum is dropped whenever it leads uphill. No eigenvalue of D^-1 H is above the
 * `spread` of the battens, so that steps of one part of it never overshoot.
 * Source: [BT09]; the rule of dropping [OC15].
 */
#include "base/work.h"
#include "fair/crossed/battens.h"

#include <string.h>

enum { STEPS = 3000, STEPS_BETWEEN_LOOKS = 10 };

static const double at_rest = 1e-3;
/* Where no duck goes farther than this part of the coordinates at the start, there is nothing to gain. */
static const double least_reach = 1e-9;

typedef struct {
    bat_crossed *battens;
    double *z, *ahead, *next, *forces; /* [count_u][count_v][3] */
    double reach; /* how far a duck that is released alone goes at the start, at most */
} descent;

static double stiffness_at(const bat_crossed *l, int i, int j)
{
    return l->u.stiffness[i] + l->v.stiffness[j];
}

/* Where the ducks go from `from`, each by `share` of the way of its release. */
static void step_all(const bat_crossed *l, const double *from, const double *forces,
                     double share, double *to)
{
    for (int i = 0; i < l->count_u; i++)
        for (int j = 0; j < l->count_v; j++) {
            const size_t k = (size_t)i * (size_t)l->count_v + (size_t)j, at = 3 * k;
            const double part = share / stiffness_at(l, i, j);
            for (size_t c = 0; c < 3; c++)
                to[at + c] = from[at + c] - part * forces[at + c];
            if (l->within[k] > 0)
                bat_clip(3, l->given + at, l->within[k], to + at);
            else
                memcpy(to + at, l->given + at, 3 * sizeof *to);
        }
}

/* Does the step from `ahead` to `next` go against what was gained from z to `next`? */
static bool leads_uphill(const descent *d)
{
    const bat_crossed *l = d->battens;
    double sum = 0;
    for (int i = 0; i < l->count_u; i++)
        for (int j = 0; j < l->count_v; j++) {
            const size_t at = 3 * ((size_t)i * (size_t)l->count_v + (size_t)j);
            double dot = 0;
            for (size_t c = at; c < at + 3; c++)
                dot += (d->ahead[c] - d->next[c]) * (d->next[c] - d->z[c]);
            sum += stiffness_at(l, i, j) * dot;
        }
    return sum > 0;
}

/* One step; `age` counts those since momentum was dropped. */
static batten_status descend(descent *d, int *age)
{
    const bat_crossed *l = d->battens;
    const size_t total = 3 * (size_t)l->count_u * (size_t)l->count_v;
    const double share = 1 / bat_max(l->u.spread, l->v.spread);
    double energy;
    const batten_status status = bat_crossed_bend(d->battens, d->ahead, d->forces, &energy);
    if (status != BATTEN_OK)
        return status;
    step_all(l, d->ahead, d->forces, share, d->next);
    *age = leads_uphill(d) ? 0 : *age + 1;
    const double momentum = *age / (*age + 3.);
    for (size_t k = 0; k < total; k++) {
        d->ahead[k] = d->next[k] + momentum * (d->next[k] - d->z[k]);
        d->z[k] = d->next[k];
    }
    return BATTEN_OK;
}

/* How far a duck that is released alone goes at most, as a part of the lesser of its bound and the
 * reach, so that a wider bound is no reason to end earlier. The first time that sets the reach. */
static batten_status find_residual(descent *d, double *residual)
{
    const bat_crossed *l = d->battens;
    const size_t nodes = (size_t)l->count_u * (size_t)l->count_v;
    const bool is_first = !(d->reach > 0);
    double energy, farthest = 0;
    const batten_status status = bat_crossed_bend(d->battens, d->z, d->forces, &energy);
    if (status != BATTEN_OK)
        return status;
    step_all(l, d->z, d->forces, 1, d->next);
    for (size_t k = 0; k < nodes && is_first; k++)
        d->reach = bat_max(d->reach, bat_distance(3, d->z + 3 * k, d->next + 3 * k));
    if (is_first)
        d->reach = bat_max(d->reach, least_reach * bat_largest(3 * (int)nodes, l->given));
    for (size_t k = 0; k < nodes; k++)
        if (l->within[k] > 0)
            farthest = bat_max(farthest, bat_distance(3, d->z + 3 * k, d->next + 3 * k) /
                                             bat_min(l->within[k], d->reach));
    *residual = farthest;
    return BATTEN_OK;
}

batten_status bat_crossed_least(bat_crossed *battens, const batten_job *job, double *z,
                                double *residual)
{
    const size_t nodes = (size_t)battens->count_u * (size_t)battens->count_v, total = 3 * nodes;
    bat_work work = {.job = job};
    double *room = bat_array3(nodes, 9, sizeof *room);
    if (!room)
        return BATTEN_OUT_OF_MEMORY;
    descent d = {battens, z, room, room + total, room + 2 * total, 0};
    memcpy(d.ahead, z, total * sizeof *z);
    batten_status status = find_residual(&d, residual);
    for (int k = 0, age = 0; k < STEPS && status == BATTEN_OK && *residual > at_rest; k++) {
        status = descend(&d, &age);
        if (status == BATTEN_OK && k % STEPS_BETWEEN_LOOKS == STEPS_BETWEEN_LOOKS - 1) {
            status = find_residual(&d, residual);
            if (status == BATTEN_OK)
                status = bat_work_step(&work, STEPS_BETWEEN_LOOKS, k / (double)STEPS,
                                       "fairing the net");
        }
    }
    bat_release(room);
    return status;
}
