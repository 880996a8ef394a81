/*
 * One list of curves as two families.
 *
 * Curves that meet, but not in end points of both, are of different families; this colours the
 * curves in a forest whose links say "as" or "other than". Pairs with a gap are asked after
 * those that meet, narrow gaps first, and only where the others say nothing: both sides of a
 * thin edge may be within the tolerance. Meetings of two ends, corners of the network or poles,
 * are asked last.
 */
#include "base/plural.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"

#include <stdio.h>
#include <stdlib.h>

/* A pair with a gap. */
typedef struct {
    double distance;
    int a, b;
} gap;

typedef struct {
    int count;
    bat_network_curve *curves;
    const char *const *names;
    double scale, tolerance, given_tolerance, same;
    bat_work work;
    int *parent; /* [count] */
    int *other;  /* [count] 1: of another family than the parent */
    int *met;    /* [count] how many others it meets */
    char *ends;  /* [count][count] the pair meets in ends alone */
    int gap_count;
    gap *gaps; /* [count (count - 1) / 2] */
} splitting;

static const char *label(const splitting *t, int k, char text[BAT_NETWORK_LABEL])
{
    if (t->names)
        snprintf(text, BAT_NETWORK_LABEL, "'%.100s' (%d of %d)", t->names[k], k + 1, t->count);
    else
        snprintf(text, BAT_NETWORK_LABEL, "curve %d", k + 1);
    return text;
}

/* The root of k, and whether k is of its family: 0, or 1. Paths are halved on the way. */
static int root_of(const splitting *t, int k, int *other)
{
    *other = 0;
    while (t->parent[k] != k) {
        const int up = t->parent[k];
        t->other[k] = (t->other[k] + t->other[up]) % 2;
        t->parent[k] = t->parent[up];
        *other = (*other + t->other[k]) % 2;
        k = t->parent[k];
    }
    return k;
}

/* a and b are of different families; false when they are known to be of one. */
static bool set_apart(const splitting *t, int a, int b)
{
    int other_a, other_b;
    const int root_a = root_of(t, a, &other_a), root_b = root_of(t, b, &other_b);
    if (root_a == root_b)
        return other_a != other_b;
    t->parent[bat_max_int(root_a, root_b)] = bat_min_int(root_a, root_b);
    t->other[bat_max_int(root_a, root_b)] = (other_a + other_b + 1) % 2;
    return true;
}

static bool is_end(const splitting *t, const bat_network_curve *c, const double *point)
{
    for (int end = 0; end < 2 && !c->closed; end++) {
        const double *here = c->trace.points + (end ? 3 * c->trace.count : 0);
        if (bat_distance(3, here, point) <= 2 * t->tolerance)
            return true;
    }
    return false;
}

static batten_status crosses_its_own(const splitting *t, int a, int b, const bat_meeting *m)
{
    char names[2][BAT_NETWORK_LABEL];
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "%s and %s cross at (%g, %g, %g), and by what else they cross they are of "
                    "one family",
                    label(t, a, names[0]), label(t, b, names[1]), m->point[0][0] / t->scale,
                    m->point[0][1] / t->scale, m->point[0][2] / t->scale);
}

/* Do both run along each other? Then they are one curve given twice. */
static bool run_along(const splitting *t, int a, int b, const bat_meetings *m)
{
    double worst = 0;
    const bat_trace *along = &t->curves[a].trace, *other = &t->curves[b].trace;
    if (!m->more && m->count < 2)
        return false;
    for (int i = 0; i <= along->count; i += bat_max_int(1, along->count / 16)) {
        double nearest = HUGE_VAL;
        for (int k = 0; k < other->count; k++)
            nearest = bat_min(nearest, bat_segment_distance(3, other->points + 3 * k,
                                                            other->points + 3 * k + 3,
                                                            along->points + 3 * i) -
                                           other->sag[k]);
        worst = bat_max(worst, nearest);
    }
    return worst <= 2 * t->tolerance;
}

/* Where two curves meet as closely as they do anywhere, but for a factor. */
static batten_status find_closest(splitting *t, int a, int b, bat_meetings *m)
{
    const bat_trace *one = &t->curves[a].trace, *other = &t->curves[b].trace;
    const batten_status status = bat_meetings_find(one, other, t->same, &t->work, m);
    if (status != BATTEN_OK || m->count > 0 || m->nearest.distance > t->tolerance)
        return status;
    t->gaps[t->gap_count++] = (gap){m->nearest.distance, a, b};
    return bat_meetings_find(one, other, bat_min(t->tolerance, 4 * m->nearest.distance),
                             &t->work, m);
}

static batten_status find_meetings(splitting *t, int a, int b, double *nearest, int *neighbour)
{
    bat_meetings m;
    const int gaps = t->gap_count;
    const batten_status status = find_closest(t, a, b, &m);
    if (status != BATTEN_OK)
        return status;
    if (m.count == 0) {
        for (int k = 0; k < 2; k++)
            if (m.nearest.distance < nearest[k ? b : a]) {
                nearest[k ? b : a] = m.nearest.distance;
                neighbour[k ? b : a] = k ? a : b;
            }
        return BATTEN_OK;
    }
    const bool has_gap = t->gap_count > gaps;
    if (run_along(t, a, b, &m)) {
        t->gap_count = gaps;
        return BATTEN_OK;
    }
    t->met[a]++;
    t->met[b]++;
    bool ends = true;
    for (int i = 0; i < m.count; i++)
        ends = ends && is_end(t, &t->curves[a], m.found[i].point[0]) &&
               is_end(t, &t->curves[b], m.found[i].point[1]);
    t->ends[a * t->count + b] = ends;
    if (ends)
        t->gap_count = gaps;
    return ends || has_gap || set_apart(t, a, b) ? BATTEN_OK
                                                 : crosses_its_own(t, a, b, &m.found[0]);
}

static int by_distance(const void *one, const void *other)
{
    const gap *x = one, *y = other;
    if (x->distance != y->distance)
        return x->distance > y->distance ? 1 : -1;
    return x->a != y->a ? x->a - y->a : x->b - y->b;
}

static batten_status meet_all(splitting *t, double *nearest, int *neighbour)
{
    for (int a = 0; a < t->count; a++)
        nearest[a] = HUGE_VAL;
    for (int a = 0; a < t->count; a++)
        for (int b = a + 1; b < t->count; b++) {
            const batten_status status = find_meetings(t, a, b, nearest, neighbour);
            if (status != BATTEN_OK)
                return status;
        }
    for (int a = 0; a < t->count; a++)
        if (t->met[a] == 0) {
            char names[2][BAT_NETWORK_LABEL];
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "%s meets no other curve; %s is nearest, %g away, more than the "
                            "tolerance %g",
                            label(t, a, names[0]), label(t, neighbour[a], names[1]),
                            nearest[a] / t->scale, t->given_tolerance);
        }
    return BATTEN_OK;
}

static batten_status colour(splitting *t, int *family)
{
    int other;
    qsort(t->gaps, (size_t)t->gap_count, sizeof *t->gaps, by_distance);
    for (int i = 0; i < t->gap_count; i++)
        (void)set_apart(t, t->gaps[i].a, t->gaps[i].b); /* no joint, where they are of one */
    for (int a = 0; a < t->count; a++)
        for (int b = a + 1; b < t->count; b++)
            if (t->ends[a * t->count + b])
                (void)set_apart(t, a, b); /* a pole, where they are of one family already */
    const int root = root_of(t, 0, &other);
    for (int k = 0; k < t->count; k++) {
        int own;
        char names[2][BAT_NETWORK_LABEL];
        if (root_of(t, k, &own) != root)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "the curves are two networks that do not meet: %s is in one, %s in "
                            "the other",
                            label(t, 0, names[0]), label(t, k, names[1]));
        family[k] = (own + other) % 2;
    }
    return BATTEN_OK;
}

static batten_status trace_curves(splitting *t, const batten_curve *const *curves)
{
    batten_status status = bat_network_scale(t->count, curves, &t->scale);
    t->tolerance *= t->scale;
    t->same = bat_network_same_place(
        t->tolerance,
        status == BATTEN_OK ? batten_network_size(t->count, curves) * t->scale : 0);
    for (int k = 0; status == BATTEN_OK && k < t->count; k++) {
        bat_network_curve *c = &t->curves[k];
        t->parent[k] = k;
        status =
            bat_network_take_curve(curves[k], t->scale, t->tolerance, &c->curve, &c->moved);
        if (status == BATTEN_OK)
            status = bat_trace_make(c->curve, &c->trace);
        c->closed = status == BATTEN_OK && batten_curve_is_closed(c->curve, t->tolerance);
    }
    return status;
}

static void release_forest(splitting *t)
{
    for (int k = 0; t->curves && k < t->count; k++) {
        batten_curve_unref(t->curves[k].curve);
        bat_trace_free(&t->curves[k].trace);
    }
    bat_release(t->curves);
    bat_release(t->parent);
    bat_release(t->other);
    bat_release(t->met);
    bat_release(t->ends);
    bat_release(t->gaps);
}

static batten_status colour_curves(splitting *t, const batten_curve *const *curves, int *family)
{
    const size_t n = (size_t)t->count;
    double *nearest = bat_array(n, sizeof *nearest);
    int *neighbour = bat_array(n, sizeof *neighbour);
    t->curves = bat_array(n, sizeof *t->curves);
    t->parent = bat_array(n, sizeof *t->parent);
    t->other = bat_array(n, sizeof *t->other);
    t->met = bat_array(n, sizeof *t->met);
    t->ends = bat_array3(n, n, sizeof *t->ends);
    t->gaps = bat_array(n * (n - 1) / 2, sizeof *t->gaps); /* n is at most 1000 */
    batten_status status = nearest && neighbour && t->curves && t->parent && t->other &&
                                   t->met && t->ends && t->gaps
                               ? trace_curves(t, curves)
                               : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = meet_all(t, nearest, neighbour);
    if (status == BATTEN_OK)
        status = colour(t, family);
    bat_release(neighbour);
    bat_release(nearest);
    return status;
}

batten_status batten_network_split(int count, const batten_curve *const *curves,
                                   double tolerance, const char *const *names,
                                   const batten_job *job, int *family)
{
    splitting t = {.count = count,
                   .names = names,
                   .tolerance = tolerance,
                   .given_tolerance = tolerance,
                   .work = {job, 0}};
    if (!isfinite(tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", tolerance);
    if (tolerance <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    if (count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d curve%s; a network has 2 or more",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    if (count > 1000)
        return bat_fail(BATTEN_TOO_LARGE,
                        "there are %d curves in one list; the limit is 1000: give profiles and "
                        "guides apart",
                        count);
    const batten_status status = colour_curves(&t, curves, family);
    release_forest(&t);
    return status;
}
