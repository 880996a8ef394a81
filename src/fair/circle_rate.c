/*
 * The circle-rate method: no spline, only the curvature of the circle through each three points. A point is moved at right angles
 * to the chord of its neighbours until its circle rate lies on the straight line, over the length of the chords, between those
 * beside it; the largest departure from that line first.
 *
 * A move d to the left changes the rates k by -2 / (h_i-1 h_i) at the point itself and by 2 / (h_i-1 (h_i-2 + h_i-1)) and
 * 2 / (h_i (h_i + h_i+1)) beside it, to the first order; what is measured after the move are the rates themselves.
 * Source: [SL] section VII.2.
 */
#include "fair/fair_points.h"

#include <float.h>

typedef struct {
    const bat_fair_piece *piece;
    double *rate, *chord; /* [count], at the points inside; from each to the next */
    double noise;         /* departures that rounding makes */
} circle_rates;

static void find_rates(const circle_rates *c, const double *z)
{
    const int n = c->piece->batten->count;
    for (int i = 0; i + 1 < n; i++)
        c->chord[i] = bat_distance(2, z + 2 * i, z + 2 * i + 2);
    for (int i = 1; i + 1 < n; i++) {
        const double *p = z + 2 * i;
        const double turn = (p[0] - p[-2]) * (p[3] - p[1]) - (p[1] - p[-1]) * (p[2] - p[0]);
        const double sides = c->chord[i - 1] * c->chord[i] * bat_distance(2, p - 2, p + 2);
        c->rate[i] = sides > 0 ? 2 * turn / sides : 0; /* a hairpin has no side */
    }
}

/* By how much the rate at i lies beside the line between its neighbours. */
static double departure(const circle_rates *c, int i)
{
    const double part = c->chord[i] / (c->chord[i - 1] + c->chord[i]);
    return part * c->rate[i - 1] + (1 - part) * c->rate[i + 1] - c->rate[i];
}

static double sum_of_departures(void *state, const double *z, double *unfairness)
{
    circle_rates *c = state;
    const int n = c->piece->batten->count;
    double sum = 0;
    find_rates(c, z);
    for (int i = 0; i < n; i++) {
        /* Without a rate beside it on both sides there is no line. */
        const double off = i >= 2 && i < n - 2 ? fabs(departure(c, i)) : 0;
        unfairness[i] = off > c->noise ? off : 0;
        sum += off;
    }
    return sum;
}

static void put_on_line(void *state, const double *z, int i, double *to)
{
    const circle_rates *c = state;
    find_rates(c, z);
    const double *h = c->chord + i, part = h[0] / (h[-1] + h[0]);
    const double own = -2 / (h[-1] * h[0]), before = 2 / (h[-1] * (h[-2] + h[-1])),
                 after = 2 / (h[0] * (h[0] + h[1]));
    const double move = departure(c, i) / (own - part * before - (1 - part) * after);
    const double *left = c->piece->ducks.frames + 4 * i;
    for (int k = 0; k < 2; k++)
        to[k] += move * left[k];
}

/* Of a rate, from coordinates that are right to their last place. */
static double rounding(const bat_fair_piece *piece, const double *z)
{
    double size = 0, least = HUGE_VAL;
    for (int i = 0; i < piece->batten->count; i++) {
        size = bat_max(size, bat_max(fabs(z[2 * i]), fabs(z[2 * i + 1])));
        if (i > 0)
            least = bat_min(least, bat_distance(2, z + 2 * i - 2, z + 2 * i));
    }
    return 64 * DBL_EPSILON * size / (least * least);
}

batten_status bat_fair_circle_rate(const bat_fair_piece *piece, double *z)
{
    const size_t n = (size_t)piece->batten->count;
    circle_rates c = {piece, bat_array(n, 2 * sizeof *c.rate), NULL, rounding(piece, z)};
    if (!c.rate)
        return BATTEN_OUT_OF_MEMORY;
    c.chord = c.rate + n;
    bat_one_by_one method = bat_piece_one_by_one(piece);
    method.state = &c;
    method.measure = sum_of_departures;
    method.propose = put_on_line;
    const batten_status status = bat_move_one_by_one(&method, z);
    bat_release(c.rate);
    return status;
}
