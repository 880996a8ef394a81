/* The integral over what lies between a piece of a loop and the edge of the parameters. */
#include "body/measure/face_piece.h"
#include "base/list.h"
#include "body/measure/face_integral.h"
#include "numeric/vector.h"

#include <string.h>

/* ---- one place ---- */

static void add_integrands(const bat_face_work *w, const double jet[9], double weight,
                           double sums[BAT_FACE_INTEGRALS])
{
    const bat_face_rules *rules = w->rules;
    const double s = 1 / rules->size;
    const double x[3] = {(jet[0] - rules->centre.x) * s, (jet[1] - rules->centre.y) * s,
                         (jet[2] - rules->centre.z) * s};
    const batten_vec3 n = bat_vec3_cross(bat_vec3_scale(bat_vec3_of(3, jet + 3), s),
                                         bat_vec3_scale(bat_vec3_of(3, jet + 6), s));
    const double normal[3] = {n.x, n.y, n.z}, area = bat_vec3_norm(n);
    sums[BAT_AREA] += weight * area;
    for (int k = 0; k < 3; k++) {
        sums[BAT_AREA_MOMENT + k] += weight * x[k] * area;
        sums[BAT_VOLUME + k] += weight * x[k] * normal[k];
        sums[BAT_VOLUME_MOMENT + k] += weight * x[k] * x[k] / 2 * normal[k];
    }
}

/* ---- across: G ---- */

static batten_status make_room(bat_face_work *w, size_t count)
{
    if (count <= w->inner_room)
        return BATTEN_OK;
    bat_release(w->at);
    bat_release(w->jets);
    w->inner_room = 0;
    w->at = bat_array3(2, count, sizeof *w->at);
    w->jets = bat_array3(count, 9, sizeof *w->jets);
    if (!w->at || !w->jets)
        return BATTEN_OUT_OF_MEMORY;
    w->inner_room = count;
    w->weight = w->at + count;
    return BATTEN_OK;
}

static int first_above(const double *knots, int count, double a)
{
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (knots[middle] > a)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

int bat_face_knots_between(const bat_face_work *w, double a, double b, int *first)
{
    const double *knots = w->knots[w->inner];
    const int count = w->knot_counts[w->inner];
    int low = first_above(knots, count, a);
    *first = low;
    while (low < count && knots[low] < b)
        low++;
    return low - *first;
}

static void put_span_nodes(bat_face_work *w, double low, double high, int fine, size_t *node)
{
    const int parts = 1 << fine;
    const double half = (high - low) / parts / 2;
    for (int i = 0; i < parts; i++)
        for (int j = 0; j < BAT_FACE_NODES; j++, ++*node) {
            const double at = low + half * (2 * i + 1 + w->nodes[j]);
            w->at[*node] = bat_min(bat_max(at, low), high);
            w->weight[*node] = half * w->weights[j];
        }
}

/* Nodes and weights of both rules on the parts of [a, b]: [part][NODES]. */
static void put_nodes(bat_face_work *w, double a, double b, int first, int knots, int fine)
{
    const double *U = w->knots[w->inner] + first;
    size_t node = 0;
    for (int k = 0; k <= knots; k++) {
        const double low = k == 0 ? a : U[k - 1], high = k == knots ? b : U[k];
        put_span_nodes(w, low, high, fine, &node);
    }
}

/* G at (other, to): by the short rule and by the long one. */
static batten_status across(bat_face_work *w, double other, double to, int fine,
                            double sums[2][BAT_FACE_INTEGRALS])
{
    const double sign = to < w->from ? -1 : 1;
    const double a = bat_min(to, w->from), b = bat_max(to, w->from);
    memset(sums, 0, 2 * sizeof *sums);
    if (!(a < b))
        return BATTEN_OK;
    int first;
    const int knots = bat_face_knots_between(w, a, b, &first);
    const size_t count = ((size_t)knots + 1) * BAT_FACE_NODES << fine;
    batten_status status = make_room(w, count);
    if (status != BATTEN_OK)
        return status;
    put_nodes(w, a, b, first, knots, fine);
    w->evaluations += count;
    status = w->inner == 0
                 ? batten_surface_evaluate_grid(
                       w->surface, (batten_uv_grid){count, 1, w->at, &other}, 1, NULL, w->jets)
                 : batten_surface_evaluate_grid(
                       w->surface, (batten_uv_grid){1, count, &other, w->at}, 1, NULL, w->jets);
    for (size_t i = 0; i < count && status == BATTEN_OK; i++)
        add_integrands(w, w->jets + 9 * i, sign * w->weight[i],
                       sums[i % BAT_FACE_NODES >= BAT_FACE_SHORT]);
    return status;
}

/* ---- along: one piece ---- */

static double volume_of(const double sums[BAT_FACE_INTEGRALS])
{
    return (sums[BAT_VOLUME] + sums[BAT_VOLUME + 1] + sums[BAT_VOLUME + 2]) / 3;
}

static void note_errors(bat_face_piece *p, double sums[2][2][BAT_FACE_INTEGRALS])
{
    const double *best = sums[1][1]; /* along, across: the long rules */
    memcpy(p->values, best, sizeof p->values);
    for (int k = 0; k < 2; k++) { /* 0: the rule across is short, 1: the one along */
        const double *worse = k == 0 ? sums[1][0] : sums[0][1];
        p->errors[0][k] = fabs(best[BAT_AREA] - worse[BAT_AREA]);
        p->errors[1][k] = fabs(volume_of(best) - volume_of(worse));
        for (int i = 0; i < 3; i++)
            p->errors[1][k] = bat_max(p->errors[1][k],
                                      fabs(best[BAT_VOLUME + i] - worse[BAT_VOLUME + i]) / 3);
    }
}

batten_status bat_face_measure_piece(bat_face_work *w, bat_face_piece *p)
{
    double sums[2][2][BAT_FACE_INTEGRALS] = {{{0}}};
    const int inner = w->inner, outer = 1 - inner;
    const double half = (p->b - p->a) / 2;
    /* Along u G dv, along v minus H du; a use may run against its curve. */
    const double sign = ((inner == 1) != p->reversed) ? -1 : 1;
    const double little = 0x1p-56 * (w->range[outer].b - w->range[outer].a);
    p->gross[0] = p->gross[1] = 0;
    for (int i = 0; i < BAT_FACE_NODES; i++) {
        double jet[4], g[2][BAT_FACE_INTEGRALS];
        const double t = p->a + half * (1 + w->nodes[i]);
        batten_status status = batten_curve_evaluate(p->curve, t, 1, jet);
        if (status != BATTEN_OK)
            return status;
        if (fabs(jet[2 + outer]) * half <= little)
            continue; /* it runs along the lines on which G is made, but for rounding */
        const batten_interval *r = w->range;
        status = across(w, bat_min(bat_max(jet[outer], r[outer].a), r[outer].b),
                        bat_min(bat_max(jet[inner], r[inner].a), r[inner].b), p->fine, g);
        if (status != BATTEN_OK)
            return status;
        const double weight = sign * half * w->weights[i] * jet[2 + outer];
        const int rule = i >= BAT_FACE_SHORT;
        for (int k = 0; k < BAT_FACE_INTEGRALS; k++) {
            sums[rule][0][k] += weight * g[0][k];
            sums[rule][1][k] += weight * g[1][k];
        }
        if (rule) {
            p->gross[0] += fabs(weight * g[1][BAT_AREA]);
            for (int k = 0; k < 3; k++)
                p->gross[1] += fabs(weight * g[1][BAT_VOLUME + k]) / 3;
        }
    }
    note_errors(p, sums);
    return BATTEN_OK;
}

batten_status bat_face_add_piece(bat_face_pieces *list, const bat_face_piece *p)
{
    if (BAT_LIST_GROW(list->items, list->count, list->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    list->items[list->count++] = *p;
    return BATTEN_OK;
}
