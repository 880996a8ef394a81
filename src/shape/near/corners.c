/* Corners of a row of points: where it turns sharply, within a given distance. */
#include "shape/near/corners.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

/* ---- corners ---- */

/* Corners are looked for no farther than so many points to either side. */
enum { REACH = 1000 };

/* The nearest point of the row on one side that is `far` away, or the end. */
static int far_point(const bat_within_fit *t, int from, int step, double far)
{
    const double *points = t->points;
    const int d = t->dimension, n = t->count;
    int i = from;
    for (int k = 0; k < bat_min_int(n - 1, REACH); k++) {
        const int next = i + step;
        if (!t->options->closed && (next < 0 || next >= n))
            break;
        i = (next + n) % n;
        if (bat_distance(d, points + (size_t)i * (size_t)d, points + (size_t)from * (size_t)d) >
            far)
            break;
    }
    return i;
}

/* By how much the row turns at a point, between directions to points that are `far` away; 0 at
 * the ends. */
static double turn_at(const bat_within_fit *t, int i, double far)
{
    const int d = t->dimension, before = far_point(t, i, -1, far),
              after = far_point(t, i, 1, far);
    double a[3], b[3];
    for (int k = 0; k < d; k++) {
        a[k] = t->points[i * d + k] - t->points[before * d + k];
        b[k] = t->points[after * d + k] - t->points[i * d + k];
    }
    const double la = bat_norm(d, a), lb = bat_norm(d, b);
    if (!(la > 0 && lb > 0))
        return 0;
    double sum = 0, difference = 0;
    for (int k = 0; k < d; k++) {
        sum += (a[k] / la + b[k] / lb) * (a[k] / la + b[k] / lb);
        difference += (b[k] / lb - a[k] / la) * (b[k] / lb - a[k] / la);
    }
    return 2 * bat_atan2(sqrt(difference), sqrt(sum));
}

/* Where no point nearer than that turns more; of equal ones the first. */
static bool is_sharpest(const bat_within_fit *t, const double *turns, int i, double far)
{
    const int n = t->count;
    for (int step = -1; step <= 1; step += 2) {
        const int end = far_point(t, i, step, far);
        for (int k = (i + step + n) % n; k != end; k = (k + step + n) % n)
            if (turns[k] > turns[i] || (turns[k] == turns[i] && step < 0))
                return false;
    }
    return true;
}

static batten_status detect_corners(bat_within_fit *t)
{
    const batten_curve_within_options *o = t->options;
    const double far = 4 * o->tolerance;
    if (o->corner == 0)
        return BATTEN_OK;
    double *turns = bat_array((size_t)t->count, sizeof *turns);
    if (!turns)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->count; i++)
        turns[i] = turn_at(t, i, far);
    for (int i = 0; i < t->count; i++)
        t->corner[i] = turns[i] > o->corner && is_sharpest(t, turns, i, far);
    bat_release(turns);
    return BATTEN_OK;
}

batten_status bat_find_corners(bat_within_fit *t)
{
    const batten_curve_within_options *o = t->options;
    t->corner = bat_array((size_t)t->count, sizeof *t->corner);
    if (!t->corner)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = detect_corners(t);
    for (int k = 0; status == BATTEN_OK && k < o->corner_count; k++) {
        const int i = o->corners[k];
        if (i < 0 || i >= t->count || (k > 0 && i <= o->corners[k - 1]))
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "corner %d is point %d; of %d points it may be 1 to %d, and they rise", k + 1,
                i + 1, t->count, t->count);
        t->corner[i] = true;
    }
    if (!o->closed)
        t->corner[0] = t->corner[t->count - 1] = false; /* ends are ends */
    for (int i = 0; i < t->count; i++)
        t->corner_count += t->corner[i];
    return status;
}
