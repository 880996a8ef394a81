/*
 * The order of the curves of a network and their directions.
 *
 * One curve of each family says in which order those of the other family stand; every other
 * curve must meet them in that order, or in the reverse. On closed curves the order goes round,
 * and begins with the curve that comes first in the list.
 */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include <batten/curvature.h>

#include <stdlib.h>
#include <string.h>

typedef enum { FORWARD, BACKWARD, EITHER, NEITHER } direction;

typedef struct {
    bat_network *net;
    const bat_network_pairs *pairs;
    int *order[2];      /* [count] of each family, across */
    direction *runs[2]; /* [count] */
    double *ranked;     /* [count of the other] scratch */
} ordering;

static const bat_network_family *family_of(const ordering *t, int family)
{
    return &t->net->family[family];
}

/* The parameter, on curve k of a family, of its node with curve l of the other. */
static double at(const ordering *t, int family, int k, int l)
{
    const int j = family == 0 ? k : l, i = family == 0 ? l : k;
    return t->pairs->at[family][j * family_of(t, 1)->room + i];
}

/* The curve that says how the others stand. */
static int reference(const bat_network_family *f)
{
    for (int k = 0; k < f->count; k++)
        if (!f->curves[k].point && (f->closed || !f->curves[k].closed))
            return k;
    return -1;
}

/* Positions of the others on curve k, in their order: rising when it runs forward. On closed
 * curves they count from the first; on one among open ones the seam is either end. */
static void rank(const ordering *t, int family, int k, bool backward, double *ranked)
{
    const bat_network_family *f = family_of(t, family);
    const int count = family_of(t, 1 - family)->count;
    const int *order = t->order[1 - family];
    const double first = at(t, family, k, order[0]);
    for (int i = 0; i < count; i++) {
        double x = at(t, family, k, order[i]);
        if (f->closed) {
            x = backward ? first - x : x - first;
            ranked[i] = x < 0 ? x + 1 : x;
        } else {
            if (f->curves[k].closed && x == 0 && (i == count - 1) != backward)
                x = 1;
            ranked[i] = backward ? 1 - x : x;
        }
    }
}

/* The first place where numbers do not rise, or count. */
static int first_fall(int count, const double *x)
{
    int i = 1;
    while (i < count && x[i] > x[i - 1] + BAT_MEANT_SAME)
        i++;
    return i;
}

static direction find_direction(const ordering *t, int family, int k)
{
    const int count = family_of(t, 1 - family)->count;
    bool rises[2];
    for (int backward = 0; backward < 2; backward++) {
        rank(t, family, k, backward, t->ranked);
        rises[backward] = first_fall(count, t->ranked) == count;
    }
    if (rises[0])
        return rises[1] ? EITHER : FORWARD;
    return rises[1] ? BACKWARD : NEITHER;
}

static batten_status other_order(const ordering *t, int family, int k, int ref)
{
    char names[4][BAT_NETWORK_LABEL];
    const bat_network_family *f = family_of(t, family), *across = family_of(t, 1 - family);
    const int *order = t->order[1 - family];
    rank(t, family, k, at(t, family, k, order[0]) > at(t, family, k, order[across->count - 1]),
         t->ranked);
    const int i = bat_min_int(first_fall(across->count, t->ranked), across->count - 1);
    bat_network_label(t->net, family, &f->curves[k], names[0]);
    bat_network_label(t->net, 1 - family, &across->curves[order[i - 1]], names[1]);
    bat_network_label(t->net, 1 - family, &across->curves[order[i]], names[2]);
    bat_network_label(t->net, family, &f->curves[ref], names[3]);
    if (k == ref)
        return bat_fail(BATTEN_COINCIDENT, "%s meets %s and %s in the same point", names[0],
                        names[1], names[2]);
    return bat_fail(BATTEN_NOT_COMPATIBLE, "%s meets %s and %s in another order than %s does",
                    names[0], names[1], names[2], names[3]);
}

/* The order of the other family along this one. */
static void sort_across(const ordering *t, int family, int ref)
{
    const bat_network_family *f = family_of(t, family);
    const int count = family_of(t, 1 - family)->count;
    int *order = t->order[1 - family];
    for (int i = 0; i < count; i++) {
        const double start = f->closed ? at(t, family, ref, 0) : 0;
        const double x = at(t, family, ref, i) - start, place = x < 0 ? x + 1 : x;
        int k = i;
        for (; k > 0; k--) {
            const double y = at(t, family, ref, order[k - 1]) - start;
            if ((y < 0 ? y + 1 : y) <= place)
                break;
            order[k] = order[k - 1];
        }
        order[k] = i;
    }
}

static batten_status order_along(ordering *t, int family)
{
    const bat_network_family *f = family_of(t, family);
    const int ref = reference(f);
    if (ref < 0)
        return bat_fail(BATTEN_COINCIDENT, "all %ss are points", f->what);
    if (family_of(t, 1 - family)->count + f->closed < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "there is 1 %s; a network whose %ss are open needs 2",
                        family_of(t, 1 - family)->what, f->what);
    sort_across(t, family, ref);
    for (int k = 0; k < f->count; k++) {
        t->runs[family][k] = f->curves[k].point ? FORWARD : find_direction(t, family, k);
        if (t->runs[family][k] == NEITHER)
            return other_order(t, family, k, ref);
    }
    t->runs[family][ref] = FORWARD;
    return BATTEN_OK;
}

/* ---- closed curves that meet only one or two others ---- */

/* How the directions of curves k and `before` of a family agree where they cross curve l of the
 * other: the cosine of the angle between their tangents when that of `before` is carried along
 * l without turning; 0 where there are no such curves. */
static batten_status carried_cosine(const ordering *t, int family, int k, int before, int l,
                                    double *cosine)
{
    const bat_network_curve *along = &family_of(t, 1 - family)->curves[l];
    const int pair[2] = {before, k};
    double places[2], seen[2][3];
    batten_frame frames[2];
    for (int i = 0; i < 2; i++)
        places[i] = at(t, 1 - family, l, pair[i]);
    const bool swapped = places[0] > places[1];
    const double rising[2] = {places[swapped], places[!swapped]};
    *cosine = 0;
    if (along->point || !(rising[0] < rising[1]))
        return BATTEN_OK;
    batten_status status =
        batten_curve_frames(along->curve, 2, rising, BATTEN_FRAME_ROTATION_MINIMISING, frames);
    if (status != BATTEN_OK) /* a standstill or a cusp: this curve does not tell */
        return status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
    for (int i = 0; i < 2; i++) {
        double rows[6];
        const batten_frame *frame = &frames[i == 0 ? swapped : !swapped];
        const batten_vec3 y = bat_vec3_cross(frame->z, frame->x);
        status = batten_curve_evaluate(family_of(t, family)->curves[pair[i]].curve,
                                       at(t, family, pair[i], l), 1, rows);
        if (status != BATTEN_OK)
            return status;
        const batten_vec3 tangent = {rows[3], rows[4], rows[5]};
        seen[i][0] = bat_vec3_dot(tangent, frame->x);
        seen[i][1] = bat_vec3_dot(tangent, y);
        seen[i][2] = bat_vec3_dot(tangent, frame->z);
    }
    const double size = bat_norm(3, seen[0]) * bat_norm(3, seen[1]);
    *cosine = size > 0 ? bat_dot(3, seen[0], seen[1]) / size : 0;
    return BATTEN_OK;
}

/* Such a curve runs as its neighbour does, by the crossing that says so most clearly. */
static batten_status follow_directions(ordering *t, int family, int k, int before)
{
    const int count = family_of(t, 1 - family)->count;
    double clearest = 0;
    for (int l = 0; l < count; l++) {
        double cosine;
        const batten_status status = carried_cosine(t, family, k, before, l, &cosine);
        if (status != BATTEN_OK)
            return status;
        if (fabs(cosine) > fabs(clearest))
            clearest = cosine;
    }
    const bool backward = (t->runs[family][before] == BACKWARD) != (clearest < 0);
    t->runs[family][k] = backward ? BACKWARD : FORWARD;
    return BATTEN_OK;
}

static batten_status follow_neighbours(ordering *t, int family)
{
    const bat_network_family *f = family_of(t, family);
    const int ref = reference(f);
    int place = 0;
    while (t->order[family][place] != ref)
        place++;
    batten_status status = BATTEN_OK;
    for (int side = -1; side <= 1; side += 2) {
        int before = ref;
        for (int i = place + side; status == BATTEN_OK && i >= 0 && i < f->count; i += side) {
            const int k = t->order[family][i];
            if (f->curves[k].point)
                continue;
            if (t->runs[family][k] == EITHER)
                status = follow_directions(t, family, k, before);
            before = k;
        }
    }
    return status;
}

/* ---- carrying it out ---- */

static batten_status turn_family(ordering *t, int family)
{
    const bat_network_family *f = family_of(t, family);
    const int count = family_of(t, 1 - family)->count;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        bat_network_curve *c = &t->net->family[family].curves[k];
        for (int i = 0; i < count; i++) {
            const double x = at(t, family, k, t->order[1 - family][i]);
            const bool last = f->curves[k].closed && !f->closed && x == 0 &&
                              (i == count - 1) != (t->runs[family][k] == BACKWARD);
            t->ranked[i] = last ? 1 : x;
        }
        status = bat_network_turn(t->net, family, c, count, t->ranked,
                                  t->runs[family][k] == BACKWARD);
    }
    return status;
}

static batten_status permute(ordering *t, int family)
{
    bat_network_family *f = &t->net->family[family];
    bat_network_curve *sorted = bat_array((size_t)f->room, sizeof *sorted);
    if (!sorted)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < f->count; k++)
        sorted[k] = f->curves[t->order[family][k]];
    bat_release(f->curves);
    f->curves = sorted;
    return BATTEN_OK;
}

/* Where the curves of a family close, the first one of the other family is its last, too. Each
 * curve has room for `nodes` parameters. */
static batten_status repeat_first(bat_network *net, int family, size_t nodes)
{
    bat_network_family *across = &net->family[1 - family];
    if (!net->family[family].closed)
        return BATTEN_OK;
    const bat_network_curve *first = &across->curves[0];
    bat_network_curve *last = &across->curves[across->count];
    *last = (bat_network_curve){.index = first->index,
                                .point = first->point,
                                .closed = first->closed,
                                .moved = first->moved,
                                .gap = first->gap,
                                .curve = batten_curve_ref(first->curve)};
    across->count++;
    last->at = bat_array(nodes, sizeof *last->at);
    if (!last->at)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(last->at, first->at, nodes * sizeof *last->at);
    return BATTEN_OK;
}

static batten_status order(ordering *t)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        bat_network_family *f = &t->net->family[k];
        t->order[k] = bat_array((size_t)f->room, sizeof *t->order[k]);
        t->runs[k] = bat_array((size_t)f->room, sizeof *t->runs[k]);
        status = t->order[k] && t->runs[k] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    const int most = bat_max_int(family_of(t, 0)->room, family_of(t, 1)->room);
    t->ranked = bat_array((size_t)most, sizeof *t->ranked);
    if (!t->ranked)
        status = BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = order_along(t, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = follow_neighbours(t, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = turn_family(t, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = permute(t, k);
    const size_t nodes[2] = {(size_t)family_of(t, 0)->count + 1,
                             (size_t)family_of(t, 1)->count + 1};
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = repeat_first(t->net, k, nodes[k]);
    return status;
}

batten_status bat_network_order(bat_network *net, const bat_network_pairs *pairs)
{
    ordering t = {.net = net, .pairs = pairs};
    const batten_status status = order(&t);
    for (int k = 0; k < 2; k++) {
        bat_release(t.order[k]);
        bat_release(t.runs[k]);
    }
    bat_release(t.ranked);
    return status;
}
