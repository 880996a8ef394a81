/*
 * Points moved one at a time, the worst first: each goes where a method wants it, or half, a quarter .. of the way, if that makes
 * the whole fairer by the method's own measure. Where no part of the way does, the point rests until another point has moved.
 */
#include "fair/one_by_one.h"
#include "base/work.h"

#include <string.h>

/* Less of the way than an eighth is no gain worth its price. */
enum { PARTS_OF_WAY = 4, MOVES_OF_POINT = 20 };

/* A move that gains less of the measure is a rounding. */
static const double least_gain = 1e-9;

/* Where point i would go: the part of the way along its free directions, within its bound. */
static void limit(const bat_ducks *ducks, int i, const double *z, const double *wanted,
                  double *to)
{
    const int w = ducks->width;
    memcpy(to, z, (size_t)w * sizeof *to);
    for (int row = 0; row < ducks->freedom[i]; row++) {
        const double *axis = ducks->frames + (size_t)(i * w + row) * (size_t)w;
        double along = 0;
        for (int k = 0; k < w; k++)
            along += axis[k] * (wanted[k] - z[k]);
        for (int k = 0; k < w; k++)
            to[k] += along * axis[k];
    }
    if (ducks->freedom[i] > 0)
        bat_clip(w, ducks->centre + i * w, ducks->within[i], to);
}

typedef struct {
    const bat_one_by_one *method;
    double *z, *unfairness, *tried; /* [count][width], [count], [count] */
    bool *rests;                    /* [count] */
    double measure;
} moving;

static int worst_point(const moving *m)
{
    int found = -1;
    for (int i = 0; i < m->method->count; i++)
        if (m->method->ducks->freedom[i] > 0 && !m->rests[i] && m->unfairness[i] > 0 &&
            (found < 0 || m->unfairness[i] > m->unfairness[found]))
            found = i;
    return found;
}

/* Point i to its place, or part of the way; whether it went. */
static bool move_point(moving *m, int i)
{
    const bat_ducks *ducks = m->method->ducks;
    const int n = m->method->count, w = ducks->width;
    double *z = m->z + i * w, from[3], to[3];
    memcpy(from, z, (size_t)w * sizeof *from);
    memcpy(to, z, (size_t)w * sizeof *to);
    m->method->propose(m->method->state, m->z, i, to);
    for (int part = 0; part < PARTS_OF_WAY; part++) {
        limit(ducks, i, from, to, z);
        if (!(bat_distance(w, from, z) > BAT_DUCK_AT_REST * ducks->within[i]))
            break;
        const double measure = m->method->measure(m->method->state, m->z, m->tried);
        if (measure < m->measure * (1 - least_gain)) {
            m->measure = measure;
            memcpy(m->unfairness, m->tried, (size_t)n * sizeof *m->tried);
            return true;
        }
        for (int k = 0; k < w; k++)
            to[k] = from[k] + (to[k] - from[k]) / 2;
    }
    memcpy(z, from, (size_t)w * sizeof *z);
    return false;
}

static batten_status move_all(moving *m)
{
    const bat_one_by_one *method = m->method;
    const int n = method->count, most = method->most > 0 ? method->most : MOVES_OF_POINT * n;
    bat_work work = {method->job, 0};
    batten_status status = BATTEN_OK;
    bool done = false;
    m->measure = method->measure(method->state, m->z, m->unfairness);
    if (method->is_done)
        status = method->is_done(method->judge, m->z, &done);
    for (int moves = 0; status == BATTEN_OK && !done && moves < most;) {
        const int i = worst_point(m);
        if (i < 0)
            break;
        m->rests[i] = !move_point(m, i);
        if (!m->rests[i]) {
            memset(m->rests, 0, (size_t)n * sizeof *m->rests);
            moves++;
            if (method->is_done)
                status = method->is_done(method->judge, m->z, &done);
        }
        if (status == BATTEN_OK)
            status = bat_work_step(&work, (uint64_t)n, moves / (double)most, "fairing");
    }
    return status;
}

batten_status bat_move_one_by_one(const bat_one_by_one *method, double *z)
{
    const size_t n = (size_t)method->count;
    moving m = {.method = method, .z = z};
    m.unfairness = bat_array(n, 2 * sizeof *m.unfairness);
    m.rests = bat_array(n, sizeof *m.rests);
    batten_status status = m.unfairness && m.rests ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        m.tried = m.unfairness + n;
        memset(m.rests, 0, n * sizeof *m.rests);
        status = move_all(&m);
    }
    bat_release(m.unfairness);
    bat_release(m.rests);
    return status;
}
