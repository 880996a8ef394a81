/* Which knots a row of points can have, and which of them others have already. [PT00] */
#include "shape/skin/rows_of_points.h"

#include <string.h>

static void insert(bat_shared_knots *shared, int at, double knot)
{
    memmove(shared->knots + at + 1, shared->knots + at,
            (size_t)(shared->count - at) * sizeof *shared->knots);
    shared->knots[at] = knot;
    shared->count++;
}

/* A new knot near `wished` in [low, high] that is no sliver beside its neighbours, as far as
 * there is room: `apart` from them. */
static double place_apart(const bat_shared_knots *shared, double wished, double low,
                          double high, double apart)
{
    int at = 0;
    while (at < shared->count && shared->knots[at] < wished)
        at++;
    const double before = at > 0 ? shared->knots[at - 1] : 0;
    const double after = at < shared->count ? shared->knots[at] : 1;
    if (after - before < 2 * apart) /* the middle is the best there is */
        return bat_min(high, bat_max(low, before + (after - before) / 2));
    return bat_min(high, bat_max(low, bat_min(after - apart, bat_max(before + apart, wished))));
}

/* The first free knot that lies nearest to `wished` in [low, high], or -1. */
static int find_knot(const bat_shared_knots *shared, int from, double wished, double low,
                     double high)
{
    int best = -1;
    for (int i = from; i < shared->count && shared->knots[i] <= high; i++)
        if (shared->knots[i] >= low &&
            (best < 0 || fabs(shared->knots[i] - wished) < fabs(shared->knots[best] - wished)))
            best = i;
    return best;
}

/*
 * Knot j = 1 .. n - p - 1 of a row of n parameters must lie between u[j - 1] and u[j + p]: then
 * each parameter is inside the support of its basis function. The mean of p parameters between
 * is such a knot.
 */
void bat_shared_knots_take(bat_shared_knots *shared, int p, int count, const double *u,
                           double margin)
{
    int from = 0; /* knots before it are taken, or too far left */
    double last = 0;
    for (int j = 1; j < count - p; j++) {
        const double slack = margin * (u[j + p] - u[j - 1]);
        double low = u[j - 1] + slack, wished = 0;
        const double high = u[j + p] - slack;
        for (int i = j; i < j + p; i++)
            wished += u[i] / p;
        wished = bat_min(high, bat_max(low, wished));
        int at = find_knot(shared, from, wished, low, high);
        if (at < 0) {
            if (last >= low) /* there is room: last is below the high of its own interval */
                low = last + (high - last) / 4;
            const double apart = (u[j + p] - u[j - 1]) / (8 * (p + 1));
            const double knot = place_apart(shared, wished, low, high, apart);
            at = from;
            while (at < shared->count && shared->knots[at] < knot)
                at++;
            insert(shared, at, knot);
        }
        last = shared->knots[at];
        from = at + 1;
    }
}
