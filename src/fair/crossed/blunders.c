/* Wrong points of a net: those that agree neither with their row nor with their column. */
#include "base/list.h"
#include "fair/crossed/battens.h"
#include "numeric/select.h"

#include <string.h>

/* A cubic is laid through so many others on each side of a point, at an end all on one side. */
enum { BESIDE = 2, OTHERS = 2 * BESIDE };

/* A blunder sticks out by so many medians of what points stick out, and so many of its bounds:
 * what fairing nearly mends by itself is none. */
static const double most_medians = 6, most_bounds = 2;

/* Where its neighbours along one direction put a point; the weights of others sum to 1. */
typedef struct {
    int other[OTHERS]; /* indices in the line */
    double weight[OTHERS];
    double variance; /* of the point against its place, when all err by 1 */
} stencil;

/* The parameter of duck i of a side that closes, whichever round it is in. */
static double parameter(const bat_crossed_side *side, int i)
{
    const int n = side->count, round = side->wrap ? (i < 0 ? -1 : i >= n ? 1 : 0) : 0;
    const double period = side->wrap ? side->t[n] - side->t[0] : 0;
    return side->t[i - round * n] + round * period;
}

static stencil stencil_at(const bat_crossed_side *side, int i)
{
    const int n = side->count, length = bat_min_int(OTHERS, n - 1);
    stencil s = {.variance = 1};
    int first = i - BESIDE;
    if (!side->wrap)
        first = bat_max_int(0, bat_min_int(first, n - 1 - length));
    int place[OTHERS];
    for (int k = 0, at = first; k < length; at++)
        if (at != i)
            place[k++] = at;
    const double t = parameter(side, i);
    for (int k = 0; k < length; k++) {
        double w = 1;
        for (int m = 0; m < length; m++)
            if (m != k)
                w *= (t - parameter(side, place[m])) /
                     (parameter(side, place[k]) - parameter(side, place[m]));
        s.other[k] = (place[k] + n) % n;
        s.weight[k] = w;
        s.variance += w * w;
    }
    return s;
}

/* How far the point sticks out from its neighbours' cubic. */
static void stick_out(const stencil *s, const double *line, size_t step, int i, double out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = line[3 * step * (size_t)i + (size_t)c];
        for (int k = 0; k < OTHERS; k++)
            out[c] -= s->weight[k] * line[3 * step * (size_t)s->other[k] + (size_t)c];
    }
}

typedef struct {
    const bat_crossed *battens;
    stencil *u, *v;
    double *points; /* [count_u][count_v][3] */
    double
        *sizes; /* [count_u][count_v]: what both directions agree on, over what they err by */
} search;

/* What row and column say together: 0 where they do not agree on the sense; `out` is the better
 * known mean of both. */
static double agreed(const search *s, int i, int j, double out[3])
{
    const size_t nv = (size_t)s->battens->count_v;
    double a[3], b[3], dot = 0, square[2] = {0};
    stick_out(s->u + i, s->points + 3 * (size_t)j, nv, i, a);
    stick_out(s->v + j, s->points + 3 * (size_t)i * nv, 1, j, b);
    const double share = s->v[j].variance / (s->u[i].variance + s->v[j].variance);
    for (int c = 0; c < 3; c++) {
        dot += a[c] * b[c];
        square[0] += a[c] * a[c];
        square[1] += b[c] * b[c];
        out[c] = share * a[c] + (1 - share) * b[c];
    }
    return dot > 0 ? sqrt(bat_min(square[0] / s->u[i].variance, square[1] / s->v[j].variance))
                   : 0;
}

static int measure_all(search *s)
{
    int worst = 0;
    double out[3];
    for (int i = 0; i < s->battens->count_u; i++)
        for (int j = 0; j < s->battens->count_v; j++) {
            const int k = i * s->battens->count_v + j;
            s->sizes[k] = agreed(s, i, j, out);
            if (s->sizes[k] > s->sizes[worst])
                worst = k;
        }
    return worst;
}

/* The point where it was given, and where its neighbours put it; from now on it is there. */
static batten_status mend(search *s, int k, bat_fair_tally *tally)
{
    const int i = k / s->battens->count_v, j = k % s->battens->count_v;
    batten_fair_move move = {.set = j, .index = i};
    double out[3], *point = s->points + 3 * (size_t)k;
    agreed(s, i, j, out);
    memcpy(move.from, s->battens->given + 3 * (size_t)k, sizeof move.from);
    for (int c = 0; c < 3; c++)
        move.to[c] = point[c] -= out[c];
    return BAT_LIST_ADD(tally->report.suspects, tally->report.suspect_count,
                        tally->suspect_room, move);
}

/* Of more than one point in this many none is wrong: the net is rough. */
enum { FEWEST_TO_ONE = 20 };

/* The median is of the net as it was given. */
static batten_status find_all(search *s, double *sorted, bat_fair_tally *tally)
{
    const int nodes = s->battens->count_u * s->battens->count_v;
    int worst = measure_all(s), found = 0;
    memcpy(sorted, s->sizes, (size_t)nodes * sizeof *sorted);
    const double least = most_medians * bat_select((size_t)nodes, sorted, (size_t)nodes / 2);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && found <= nodes / FEWEST_TO_ONE &&
           s->sizes[worst] > bat_max(least, most_bounds * s->battens->within[worst])) {
        status = mend(s, worst, tally);
        worst = measure_all(s);
        found++;
    }
    if (status != BATTEN_OK || found > nodes / FEWEST_TO_ONE) {
        tally->report.suspect_count = 0;
        memcpy(s->points, s->battens->given, 3 * (size_t)nodes * sizeof *s->points);
    }
    return status;
}

batten_status bat_crossed_blunders(const bat_crossed *battens, double *mended,
                                   bat_fair_tally *tally)
{
    const size_t nu = (size_t)battens->count_u, nv = (size_t)battens->count_v;
    search s = {battens, bat_array(nu, sizeof *s.u), bat_array(nv, sizeof *s.v), mended, NULL};
    double *sorted = bat_array3(nu, nv, sizeof *sorted);
    s.sizes = bat_array3(nu, nv, sizeof *s.sizes);
    batten_status status = s.u && s.v && s.sizes && sorted ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (size_t i = 0; i < nu; i++)
            s.u[i] = stencil_at(&battens->u, (int)i);
        for (size_t j = 0; j < nv; j++)
            s.v[j] = stencil_at(&battens->v, (int)j);
        status = find_all(&s, sorted, tally);
    }
    bat_release(s.u);
    bat_release(s.v);
    bat_release(s.sizes);
    bat_release(sorted);
    return status;
}
