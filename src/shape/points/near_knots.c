/*
 * Nearly equal knots of several curves made equal, so that merging them leaves no tiny spans. A
 * curve is changed only if it stays within the tolerance.
 */
#include "shape/points/near_knots.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <string.h>

/* All knots known so far, rising. */
typedef struct {
    int count;
    double *at;
} pool;

/* Where t stands, or would. */
static int find(const pool *p, double t)
{
    int low = 0, high = p->count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (p->at[middle] < t)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static double nearest(const pool *p, double t)
{
    const int i = find(p, t);
    const double above = i < p->count ? p->at[i] : HUGE_VAL;
    const double below = i > 0 ? p->at[i - 1] : -HUGE_VAL;
    return above - t < t - below ? above : below;
}

static void insert(pool *p, double t)
{
    const int i = find(p, t);
    if (i < p->count && p->at[i] == t)
        return;
    memmove(p->at + i + 1, p->at + i, (size_t)(p->count - i) * sizeof *p->at);
    p->at[i] = t;
    p->count++;
}

static void insert_all(const batten_curve *curve, pool *p)
{
    for (int i = curve->degree + 1; i < curve->count; i++)
        insert(p, curve->knots[i]);
}

/* How far two curves are apart at most, by their control points on common knots. */
static batten_status distance(const batten_curve *a, const batten_curve *b, double *out)
{
    const batten_curve *const given[2] = {a, b};
    batten_curve *common[2] = {NULL, NULL};
    const batten_status status = batten_curves_unify(2, given, common);
    const int d = a->dimension;
    *out = 0;
    for (int i = 0; status == BATTEN_OK && i < common[0]->count; i++)
        *out = bat_max(*out, bat_distance(d, common[0]->points + (size_t)i * (size_t)d,
                                          common[1]->points + (size_t)i * (size_t)d));
    batten_curve_unref(common[0]);
    batten_curve_unref(common[1]);
    return status;
}

/* The curve with knots moved onto near ones of the pool; *moved: whether any did. No two of its
 * own come together. */
static batten_status move_knots(const batten_curve *curve, const pool *p, bool *moved,
                                batten_curve **out)
{
    batten_curve *made = NULL;
    const batten_status status = bat_curve_copy(curve, &made);
    if (status != BATTEN_OK)
        return status;
    *moved = false;
    for (int i = curve->degree + 1, end; i < curve->count; i = end) {
        const double t = curve->knots[i], to = nearest(p, t);
        for (end = i + 1; end < curve->count && curve->knots[end] == t;)
            end++;
        if (to == t || !(fabs(to - t) <= BAT_NEAR_KNOTS) || to <= made->knots[i - 1] ||
            to >= curve->knots[end])
            continue;
        for (int k = i; k < end; k++)
            made->knots[k] = to;
        *moved = true;
    }
    return bat_curve_finish(made, out);
}

static batten_status join_one(pool *p, batten_curve **curve, double tolerance, double *error)
{
    batten_curve *made = NULL;
    bool moved = false;
    double far = 0;
    batten_status status = move_knots(*curve, p, &moved, &made);
    if (status == BATTEN_OK && moved)
        status = distance(*curve, made, &far);
    if (status == BATTEN_OK && moved && far <= tolerance) {
        batten_curve *given = *curve;
        *curve = made;
        made = given;
        *error += far;
    }
    if (status == BATTEN_OK)
        insert_all(*curve, p);
    batten_curve_unref(made);
    return status;
}

batten_status bat_near_knots_join(int fixed, int count, batten_curve **curves, double tolerance,
                                  double *error)
{
    size_t most = 1;
    for (int i = 0; i < count; i++)
        most += (size_t)curves[i]->count;
    pool p = {0, bat_array(most, sizeof *p.at)};
    batten_status status = p.at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        if (i < fixed)
            insert_all(curves[i], &p);
        else
            status = join_one(&p, &curves[i], tolerance, error);
    }
    bat_release(p.at);
    return status;
}
