/*
 * The method of Farin and Sapidis for cubic curves: a knot is taken out and put in again, which moves one control point so that
 * the third derivative no longer jumps there; the knot with the largest jump first.
 *
 * Control point D_j belongs to the knot t_j in the middle of the five on which its B-spline stands. The two points before it and
 * the two after, seen as those of a spline without t_j, each say where the two points should be that replace the three: l and
 * r; D_j goes where inserting t_j puts it.
 * Source: [FS90].
 */
#include "fair/fair_curve.h"

#include <string.h>

enum { P = 3, MIDDLE = 2 };

typedef struct {
    const bat_fair_net *net;
    double *third; /* [spans][dimension]: C''' on each, knots U[i] to U[i + 1] from U[3] on */
} knots_of;

/* Of a periodic curve the knots go on over both ends. */
static double knot(const bat_fair_net *net, int i)
{
    const batten_curve *curve = net->curve;
    const int m = net->count;
    if (!curve->periodic || (i >= 0 && i < curve->count + P + 1))
        return curve->knots[i];
    const double period = curve->knots[P + m] - curve->knots[P];
    return i < 0 ? curve->knots[i + m] - period : curve->knots[i - m] + period;
}

/* Whether point i has a knot of its own inside the curve, and two points on both sides. */
static bool has_knot(const bat_fair_net *net, int i)
{
    const bool inside = net->curve->periodic || (i >= 2 && i < net->count - 2);
    if (!inside)
        return false;
    const double t = knot(net, i + MIDDLE);
    return knot(net, i + MIDDLE - 1) < t && t < knot(net, i + MIDDLE + 1);
}

static const double *point(const bat_fair_net *net, const double *z, int i)
{
    const int m = net->count;
    return z + (i + m) % m * net->dimension;
}

static void find_third(knots_of *k, const double *z)
{
    const bat_fair_net *net = k->net;
    const int d = net->dimension;
    double basis[(P + 1) * (P + 1)];
    for (int span = P; span < net->curve->count; span++) {
        double *out = k->third + (span - P) * d;
        memset(out, 0, (size_t)d * sizeof *out);
        if (!(net->curve->knots[span] < net->curve->knots[span + 1]))
            continue;
        bat_basis(P, net->curve->knots, span, net->curve->knots[span], P, basis);
        for (int j = 0; j <= P; j++)
            for (int c = 0; c < d; c++)
                out[c] += basis[P * (P + 1) + j] * point(net, z, span - P + j)[c];
    }
}

/* The span that begins at the knot of point i, and the one before. */
static double jump_at(const knots_of *k, int i)
{
    const bat_fair_net *net = k->net;
    const int spans = net->curve->count - P, d = net->dimension;
    const int after = (i + MIDDLE - P + spans) % spans, before = (after + spans - 1) % spans;
    return bat_distance(d, k->third + after * d, k->third + before * d);
}

static double sum_of_jumps(void *state, const double *z, double *unfairness)
{
    knots_of *k = state;
    double sum = 0;
    find_third(k, z);
    for (int i = 0; i < k->net->count; i++) {
        unfairness[i] = has_knot(k->net, i) ? jump_at(k, i) : 0;
        sum += unfairness[i];
    }
    return sum;
}

static void take_out(void *state, const double *z, int i, double *to)
{
    const bat_fair_net *net = ((const knots_of *)state)->net;
    double t[7]; /* t_j-3 .. t_j+3 */
    for (int k = 0; k < 7; k++)
        t[k] = knot(net, i + MIDDLE - 3 + k);
    for (int c = 0; c < net->dimension; c++) {
        const double l = ((t[4] - t[0]) * point(net, z, i - 1)[c] -
                          (t[4] - t[3]) * point(net, z, i - 2)[c]) /
                         (t[3] - t[0]);
        const double r = ((t[6] - t[2]) * point(net, z, i + 1)[c] -
                          (t[3] - t[2]) * point(net, z, i + 2)[c]) /
                         (t[6] - t[3]);
        to[c] = ((t[5] - t[3]) * l + (t[3] - t[1]) * r) / (t[5] - t[1]);
    }
}

batten_status bat_fair_by_knots(const bat_fair_net *net, double *z)
{
    if (net->degree != P)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "knots are taken out of cubics, and this is of degree %d", net->degree);
    knots_of k = {net, bat_array3((size_t)(net->curve->count - P), (size_t)net->dimension,
                                  sizeof *k.third)};
    if (!k.third)
        return BATTEN_OUT_OF_MEMORY;
    const bat_one_by_one method = {.state = &k,
                                   .measure = sum_of_jumps,
                                   .propose = take_out,
                                   .is_done = NULL,
                                   .count = net->count,
                                   .ducks = &net->ducks,
                                   .most = net->options->max_moves,
                                   .job = net->job};
    const batten_status status = bat_move_one_by_one(&method, z);
    bat_release(k.third);
    return status;
}
