/* Which ends of curves meet which: the smallest gaps first, whatever the order of the curves. */
#include "shape/curve_change/loose_ends.h"
#include "base/list.h"
#include "base/sets.h"
#include "numeric/vector.h"

#include <stdlib.h>

/* Two ends within the tolerance of each other, a < b. */
typedef struct {
    double gap;
    int a, b;
} candidate;

typedef struct {
    double along; /* its coordinate along the axis of the sweep */
    int end;
} place;

typedef struct {
    bat_loose_ends *ends;
    double tolerance;
    place *sorted;    /* [2 count] */
    int *chain;       /* [count], of the chains so far: a curve that stands for it, by steps */
    double *total;    /* [count], lengths of chains, where they stand for themselves */
    candidate *items; /* grown */
    int count, room;
} linking;

static int compare_places(const void *a, const void *b)
{
    const place *p = a, *q = b;
    if (p->along != q->along)
        return p->along < q->along ? -1 : 1;
    return p->end - q->end;
}

static int compare_candidates(const void *a, const void *b)
{
    const candidate *p = a, *q = b;
    if (p->gap != q->gap)
        return p->gap < q->gap ? -1 : 1;
    return p->a != q->a ? p->a - q->a : p->b - q->b;
}

static batten_status find_places(const batten_curve_row *curves, bat_loose_ends *ends)
{
    const int d = batten_curve_dimension(curves->at[0]);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < curves->count && status == BATTEN_OK; i++) {
        const batten_curve *curve = curves->at[i];
        const double *points = batten_curve_points(curve);
        const batten_interval domain = batten_curve_domain(curve);
        if (batten_curve_dimension(curve) != d)
            return bat_fail(BATTEN_NOT_COMPATIBLE, "curves 1 and %d have %d and %d dimensions",
                            i + 1, d, batten_curve_dimension(curve));
        for (int k = 1; k < batten_curve_point_count(curve); k++)
            ends->length[i] += bat_distance(d, points + (size_t)d * (size_t)(k - 1),
                                            points + (size_t)d * (size_t)k);
        status = batten_curve_evaluate(curve, domain.a, 0, ends->at[2 * i]);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(curve, domain.b, 0, ends->at[2 * i + 1]);
    }
    return status;
}

/* The axis along which ends spread most, so that few of them stand side by side. */
static int find_widest_axis(const bat_loose_ends *ends)
{
    int widest = 0;
    double width = -1;
    for (int k = 0; k < 3; k++) {
        double low = ends->at[0][k], high = low;
        for (int e = 1; e < 2 * ends->count; e++) {
            low = bat_min(low, ends->at[e][k]);
            high = bat_max(high, ends->at[e][k]);
        }
        if (high - low > width) {
            width = high - low;
            widest = k;
        }
    }
    return widest;
}

static batten_status find_candidates(linking *l)
{
    const int count = 2 * l->ends->count, axis = find_widest_axis(l->ends);
    batten_status status = BATTEN_OK;
    for (int e = 0; e < count; e++)
        l->sorted[e] = (place){l->ends->at[e][axis], e};
    qsort(l->sorted, (size_t)count, sizeof *l->sorted, compare_places);
    for (int i = 0; i < count; i++)
        for (int k = i + 1; k < count && status == BATTEN_OK; k++) {
            if (l->sorted[k].along - l->sorted[i].along > l->tolerance)
                break;
            const int a = bat_min_int(l->sorted[i].end, l->sorted[k].end),
                      b = bat_max_int(l->sorted[i].end, l->sorted[k].end);
            const double gap = bat_distance(3, l->ends->at[a], l->ends->at[b]);
            if (gap > l->tolerance)
                continue;
            status = BAT_LIST_ADD(l->items, l->count, l->room, (candidate){gap, a, b});
            l->ends->several[a] += a / 2 != b / 2;
            l->ends->several[b] += a / 2 != b / 2;
        }
    return status;
}

/* A chain closes where it has come back, not where it is shorter than the tolerance. */
static void link_ends(linking *l)
{
    if (l->count > 1)
        qsort(l->items, (size_t)l->count, sizeof *l->items, compare_candidates);
    for (int i = 0; i < l->count; i++) {
        const candidate *c = &l->items[i];
        if (l->ends->partner[c->a] >= 0 || l->ends->partner[c->b] >= 0)
            continue;
        const int first = bat_sets_root(l->chain, c->a / 2),
                  second = bat_sets_root(l->chain, c->b / 2);
        if (first == second && !(c->gap < l->total[first] / 2))
            continue;
        l->ends->partner[c->a] = c->b;
        l->ends->partner[c->b] = c->a;
        if (first == second)
            continue;
        const double total = l->total[first] + l->total[second];
        bat_sets_join(l->chain, first, second);
        l->total[bat_min_int(first, second)] = total;
    }
}

batten_status bat_loose_ends_link(const batten_curve_row *curves, double tolerance,
                                  bat_loose_ends *ends)
{
    const size_t count = (size_t)curves->count;
    linking l = {.ends = ends, .tolerance = tolerance};
    ends->count = curves->count;
    ends->at = bat_array(2 * count, sizeof *ends->at);
    ends->length = bat_array(count, sizeof *ends->length);
    ends->partner = bat_array(2 * count, sizeof *ends->partner);
    ends->several = bat_array(2 * count, sizeof *ends->several);
    l.sorted = bat_array(2 * count, sizeof *l.sorted);
    l.chain = bat_array(count, sizeof *l.chain);
    l.total = bat_array(count, sizeof *l.total);
    batten_status status = ends->at && ends->length && ends->partner && ends->several &&
                                   l.sorted && l.chain && l.total
                               ? find_places(curves, ends)
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_candidates(&l);
    for (int i = 0; status == BATTEN_OK && i < curves->count; i++) {
        ends->partner[2 * i] = ends->partner[2 * i + 1] = -1;
        l.total[i] = ends->length[i];
    }
    if (status == BATTEN_OK) {
        bat_sets_begin(curves->count, l.chain);
        link_ends(&l);
    }
    bat_release(l.sorted);
    bat_release(l.chain);
    bat_release(l.total);
    bat_release(l.items);
    return status;
}

void bat_loose_ends_release(bat_loose_ends *ends)
{
    bat_release(ends->at);
    bat_release(ends->length);
    bat_release(ends->partner);
    bat_release(ends->several);
}
