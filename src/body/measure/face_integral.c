/* Area, volume and centroid of one face by the theorem of Green, with two rules for the error.
 */
#include "body/measure/face_integral.h"
#include "base/list.h"
#include "body/edge_box.h"

#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include <batten/nearest.h>

#include <stdlib.h>
#include <string.h>

/* Along the loops and across them Gauss-Legendre rules of two lengths: the long one is exact up
 * to degree 17, and the short one, up to 11, tells which of both is not enough. */
enum { SHORT = 6, LONG = 9, NODES = SHORT + LONG, FINEST = 10 };

/* The face in work. */
typedef struct {
    const batten_body_parts *parts;
    const bat_face_rules *rules;
    const batten_surface *surface;
    batten_interval range[2]; /* of u and v: the box of the loops, inside the domain */
    int inner;                /* along which G is made: 0 u, 1 v */
    double from;              /* G is 0 there */
    int knot_counts[2];       /* distinct knots of the surface */
    double *knots[2];         /* in u and v */
    double nodes[NODES], weights[NODES]; /* short, long */
    size_t inner_room;
    double *at, *weight, *jets; /* inner nodes; [inner_room][3][3] */
    size_t evaluations;
} face_work;

/* A part of a loop between knot lines of the surface. */
typedef struct {
    const batten_curve *curve; /* (u, v) */
    bool reversed;
    double a, b;
    int fine; /* each span of G is cut in 2^fine parts */
    double values[BAT_FACE_INTEGRALS];
    double gross[2];     /* sizes of the terms of area and volume, for their rounding */
    double errors[2][2]; /* of area and volume; across (by G), along */
} piece;

typedef struct {
    size_t count, room;
    piece *items;
} pieces;

/* ---- one place ---- */

static void add_integrands(const face_work *w, const double jet[9], double weight,
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

static batten_status make_room(face_work *w, size_t count)
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

/* The inner knots strictly between a and b: first and how many. */
static int knots_between(const face_work *w, double a, double b, int *first)
{
    const double *knots = w->knots[w->inner];
    const int count = w->knot_counts[w->inner];
    int low = 0, high = count;
    while (low < high) { /* the first above a */
        const int middle = (low + high) / 2;
        if (knots[middle] > a)
            high = middle;
        else
            low = middle + 1;
    }
    *first = low;
    while (low < count && knots[low] < b)
        low++;
    return low - *first;
}

/* Nodes and weights of both rules on the parts of [a, b]: [part][NODES]. */
static void put_nodes(face_work *w, double a, double b, int first, int knots, int fine)
{
    const double *U = w->knots[w->inner] + first;
    size_t node = 0;
    for (int k = 0; k <= knots; k++) {
        const double low = k == 0 ? a : U[k - 1], high = k == knots ? b : U[k];
        const int parts = 1 << fine;
        const double half = (high - low) / parts / 2;
        for (int i = 0; i < parts; i++)
            for (int j = 0; j < NODES; j++, node++) {
                w->at[node] =
                    bat_min(bat_max(low + half * (2 * i + 1 + w->nodes[j]), low), high);
                w->weight[node] = half * w->weights[j];
            }
    }
}

/* G at (other, to): by the short rule and by the long one. */
static batten_status across(face_work *w, double other, double to, int fine,
                            double sums[2][BAT_FACE_INTEGRALS])
{
    const double sign = to < w->from ? -1 : 1;
    const double a = bat_min(to, w->from), b = bat_max(to, w->from);
    memset(sums, 0, 2 * sizeof *sums);
    if (!(a < b))
        return BATTEN_OK;
    int first;
    const int knots = knots_between(w, a, b, &first);
    const size_t count = ((size_t)knots + 1) * NODES << fine;
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
        add_integrands(w, w->jets + 9 * i, sign * w->weight[i], sums[i % NODES >= SHORT]);
    return status;
}

/* ---- along: one piece ---- */

static double volume_of(const double sums[BAT_FACE_INTEGRALS])
{
    return (sums[BAT_VOLUME] + sums[BAT_VOLUME + 1] + sums[BAT_VOLUME + 2]) / 3;
}

static void note_errors(piece *p, double sums[2][2][BAT_FACE_INTEGRALS])
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

static batten_status measure_piece(face_work *w, piece *p)
{
    double sums[2][2][BAT_FACE_INTEGRALS] = {{{0}}};
    const int inner = w->inner, outer = 1 - inner;
    const double half = (p->b - p->a) / 2;
    /* Along u G dv, along v minus H du; a use may run against its curve. */
    const double sign = ((inner == 1) != p->reversed) ? -1 : 1;
    const double little = 0x1p-56 * (w->range[outer].b - w->range[outer].a);
    p->gross[0] = p->gross[1] = 0;
    for (int i = 0; i < NODES; i++) {
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
        const int rule = i >= SHORT;
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

static batten_status add_piece(pieces *list, const piece *p)
{
    if (BAT_LIST_GROW(list->items, list->count, list->room, 1) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    list->items[list->count++] = *p;
    return BATTEN_OK;
}

/* ---- cutting loops at knot lines ---- */

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

typedef struct {
    size_t count, room;
    double *at;
} cuts;

static batten_status add_cuts(cuts *list, size_t count, const double *at)
{
    if (list->count + count > list->room) {
        const size_t room = 2 * (list->count + count);
        double *longer = bat_resize(list->at, room, sizeof *longer);
        if (!longer)
            return BATTEN_OUT_OF_MEMORY;
        list->at = longer;
        list->room = room;
    }
    memcpy(list->at + list->count, at, count * sizeof *at);
    list->count += count;
    return BATTEN_OK;
}

/* Where a curve crosses knot lines of the surface. */
static batten_status cut_at_knots(const face_work *w, const batten_curve *curve, cuts *list)
{
    const batten_box box = batten_curve_box(curve);
    const double low[2] = {box.low.x, box.low.y}, high[2] = {box.high.x, box.high.y};
    for (int axis = 0; axis < 2; axis++)
        for (int k = 1; k + 1 < w->knot_counts[axis]; k++) {
            const double knot = w->knots[axis][k];
            batten_parameters found = {0, NULL};
            if (!(low[axis] < knot && knot < high[axis]))
                continue;
            batten_status status = batten_curve_crossings(curve, axis, knot, &found);
            if (status == BATTEN_OK)
                status = add_cuts(list, (size_t)found.count, found.at);
            bat_release(found.at);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}

static batten_status cut_use(face_work *w, const batten_body_use *use, pieces *list)
{
    const batten_curve *curve = use->parameters;
    const int spans = batten_curve_spans(curve, NULL);
    cuts at = {0};
    at.at = bat_array((size_t)spans, sizeof *at.at);
    if (!at.at)
        return BATTEN_OUT_OF_MEMORY;
    at.count = at.room = (size_t)spans;
    batten_curve_spans(curve, at.at);
    batten_status status = cut_at_knots(w, curve, &at);
    qsort(at.at, at.count, sizeof *at.at, by_size);
    for (size_t i = 1; i < at.count && status == BATTEN_OK; i++) {
        if (!(at.at[i - 1] < at.at[i]))
            continue;
        piece p = {.curve = curve, .reversed = use->reversed, .a = at.at[i - 1], .b = at.at[i]};
        status = measure_piece(w, &p);
        if (status == BATTEN_OK)
            status = add_piece(list, &p);
    }
    bat_release(at.at);
    return status;
}

/* ---- the face ---- */

static batten_status begin_integral(const batten_body_parts *parts,
                                    const batten_body_face *face, const bat_face_rules *rules,
                                    face_work *w)
{
    *w = (face_work){.parts = parts, .rules = rules, .surface = face->surface};
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int l = face->first; l < face->first + face->count; l++)
        for (int u = 0; u < parts->loops[l].count; u++) {
            const batten_box box =
                batten_curve_box(parts->uses[parts->loops[l].first + u].parameters);
            low[0] = bat_min(low[0], box.low.x);
            low[1] = bat_min(low[1], box.low.y);
            high[0] = bat_max(high[0], box.high.x);
            high[1] = bat_max(high[1], box.high.y);
        }
    int met[2];
    for (int k = 0; k < 2; k++) {
        const batten_direction d = k == 0 ? BATTEN_U : BATTEN_V;
        const batten_interval domain = batten_surface_domain(face->surface, d);
        w->range[k] = (batten_interval){bat_min(bat_max(low[k], domain.a), domain.b),
                                        bat_max(bat_min(high[k], domain.b), domain.a)};
        w->knot_counts[k] = batten_surface_spans(face->surface, d, NULL);
        w->knots[k] = bat_array((size_t)w->knot_counts[k], sizeof(double));
        if (!w->knots[k])
            return BATTEN_OUT_OF_MEMORY;
        batten_surface_spans(face->surface, d, w->knots[k]);
        int first;
        w->inner = k;
        met[k] = knots_between(w, w->range[k].a, w->range[k].b, &first);
    }
    /* G is cheaper where it meets fewer knots. */
    w->inner = met[1] < met[0];
    w->from = w->range[w->inner].a + (w->range[w->inner].b - w->range[w->inner].a) / 2;
    bat_gauss(SHORT, w->nodes, w->weights);
    bat_gauss(LONG, w->nodes + SHORT, w->weights + SHORT);
    return BATTEN_OK;
}

/* The area between an edge and its curve on the face. */
static batten_status add_slack(const face_work *w, const batten_body_use *use, double *slack)
{
    enum { PLACES = 4 };
    const batten_curve *edge = w->parts->edges[use->edge].curve, *flat = use->parameters;
    double nodes[PLACES], weights[PLACES];
    if (!edge)
        return BATTEN_OK;
    bat_gauss(PLACES, nodes, weights);
    const int count = batten_curve_spans(flat, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(flat, knots);
    batten_status status = BATTEN_OK;
    for (int i = 1; i < count && status == BATTEN_OK; i++)
        for (int j = 0; j < PLACES && status == BATTEN_OK; j++) {
            const double half = (knots[i] - knots[i - 1]) / 2;
            const double t = knots[i - 1] + half * (1 + nodes[j]);
            double at[2], on[3], curve[6];
            status = batten_curve_evaluate(flat, t, 0, at);
            for (int k = 0; k < 2; k++)
                at[k] = bat_min(bat_max(at[k], w->range[k].a), w->range[k].b);
            if (status == BATTEN_OK)
                status = batten_surface_evaluate(w->surface, at[0], at[1], 0, on);
            if (status == BATTEN_OK)
                status = batten_curve_evaluate(edge, t, 1, curve);
            if (status == BATTEN_OK)
                *slack += weights[j] * half * bat_distance(3, on, curve) / w->rules->size *
                          bat_norm(3, curve + 3) / w->rules->size;
        }
    bat_release(knots);
    return status;
}

static batten_status first_pieces(face_work *w, const batten_body_face *face, pieces *list,
                                  bat_face_sums *out)
{
    const batten_body_parts *parts = w->parts;
    for (int l = face->first; l < face->first + face->count; l++)
        for (int u = 0; u < parts->loops[l].count; u++) {
            const batten_body_use *use = &parts->uses[parts->loops[l].first + u];
            batten_status status = cut_use(w, use, list);
            if (status == BATTEN_OK)
                status = add_slack(w, use, &out->slack);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}

static void sum_up(const pieces *list, bat_face_sums *out, double gross[2])
{
    memset(out->values, 0, sizeof out->values);
    out->area_error = out->volume_error = gross[0] = gross[1] = 0;
    for (size_t i = 0; i < list->count; i++) {
        const piece *p = &list->items[i];
        for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
            out->values[k] += p->values[k];
        out->area_error += p->errors[0][0] + p->errors[0][1];
        out->volume_error += p->errors[1][0] + p->errors[1][1];
        gross[0] += p->gross[0];
        gross[1] += p->gross[1];
    }
}

/* Halve the piece, or its parts of G, whichever the larger error asks for. */
static batten_status improve(face_work *w, pieces *list, size_t index, bool *done)
{
    piece low = list->items[index];
    const double wide = bat_max(low.errors[0][0], low.errors[1][0]),
                 far = bat_max(low.errors[0][1], low.errors[1][1]);
    const double middle = low.a + (low.b - low.a) / 2;
    *done = true;
    if (wide >= far) {
        if (low.fine == FINEST) {
            *done = false;
            return BATTEN_OK;
        }
        low.fine++;
        const batten_status status = measure_piece(w, &low);
        list->items[index] = low;
        return status;
    }
    if (!(low.a < middle && middle < low.b)) {
        *done = false;
        return BATTEN_OK;
    }
    piece high = low;
    low.b = high.a = middle;
    batten_status status = measure_piece(w, &low);
    if (status == BATTEN_OK)
        status = measure_piece(w, &high);
    list->items[index] = low;
    return status == BATTEN_OK ? add_piece(list, &high) : status;
}

/* Round after round all pieces whose error is above their share. */
static batten_status refine(face_work *w, pieces *list, bat_face_sums *out)
{
    for (;;) {
        double gross[2], target[2];
        sum_up(list, out, gross);
        const double area = fabs(out->values[BAT_AREA]);
        /* No sum is known better than its rounding. */
        target[0] = bat_max(w->rules->area_precision * area, 0x1p-50 * gross[0]);
        target[1] = bat_max(w->rules->volume_precision * area, 0x1p-50 * gross[1]);
        out->is_met = out->area_error <= target[0] && out->volume_error <= target[1];
        if (out->is_met || w->evaluations > w->rules->most)
            return BATTEN_OK;
        bool any = false;
        const size_t count = list->count;
        for (size_t i = 0; i < count; i++) {
            const piece *p = &list->items[i];
            bool done = false;
            if ((p->errors[0][0] + p->errors[0][1]) * 2 * (double)count <= target[0] &&
                (p->errors[1][0] + p->errors[1][1]) * 2 * (double)count <= target[1])
                continue;
            const batten_status status = improve(w, list, i, &done);
            if (status != BATTEN_OK)
                return status;
            any |= done;
        }
        if (!any)
            return BATTEN_OK;
    }
}

batten_status bat_face_integrate(const batten_body_parts *parts, int face,
                                 const bat_face_rules *rules, bat_face_sums *out)
{
    const batten_body_face *of = &parts->faces[face];
    pieces list = {0};
    face_work w;
    bat_face_sums sums = {.is_met = false};
    batten_status status = begin_integral(parts, of, rules, &w);
    if (status == BATTEN_OK)
        status = first_pieces(&w, of, &list, &sums);
    if (status == BATTEN_OK)
        status = refine(&w, &list, &sums);
    /* The loops of a reversed face run clockwise: that turns N outward, but |N| is to stay. */
    for (int k = 0; k < 4 && of->reversed; k++)
        sums.values[BAT_AREA + k] = -sums.values[BAT_AREA + k];
    if (status == BATTEN_OK)
        *out = sums;
    bat_release(list.items);
    bat_release(w.at);
    bat_release(w.jets);
    bat_release(w.knots[0]);
    bat_release(w.knots[1]);
    return status;
}

/* ---- sums over faces ---- */

bat_face_rules bat_face_rules_of(const batten_body *body)
{
    const batten_box box = bat_body_edge_box(body);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    return (bat_face_rules){.centre =
                                bat_vec3_along(bat_vec3_scale(box.low, 0.5), 0.5, box.high),
                            .size = size > 0 ? size : 1};
}

void bat_face_add(bat_face_sums *sums, const bat_face_sums *face)
{
    for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
        sums->values[k] += face->values[k];
    sums->area_error += face->area_error;
    sums->volume_error += face->volume_error;
    sums->slack += face->slack;
}

double bat_face_volume(const bat_face_sums *sums)
{
    const double *v = sums->values + BAT_VOLUME;
    return (v[0] + v[1] + v[2]) / 3;
}

double bat_face_volume_error(const bat_face_sums *sums)
{
    const double mean = bat_face_volume(sums);
    double spread = 0;
    for (int k = 0; k < 3; k++)
        spread = bat_max(spread, fabs(sums->values[BAT_VOLUME + k] - mean));
    return sums->volume_error + bat_max(sums->slack / 3, spread);
}
