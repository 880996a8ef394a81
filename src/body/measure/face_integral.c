/* Area, volume and centroid of one face by the theorem of Green, with two rules for the error.
 */
#include "body/measure/face_integral.h"
#include "base/list.h"
#include "body/edge_box.h"
#include "body/measure/face_piece.h"

#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include <batten/nearest.h>

#include <stdlib.h>
#include <string.h>

/* Along the loops and across them Gauss-Legendre rules of two lengths: the long one is exact up
 * to degree 17, and the short one, up to 11, tells which of both is not enough. */
enum { FINEST = 10 };

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
static batten_status cut_at_knots(const bat_face_work *w, const batten_curve *curve, cuts *list)
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

static batten_status cut_use(bat_face_work *w, const batten_body_use *use,
                             bat_face_pieces *list)
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
        bat_face_piece p = {
            .curve = curve, .reversed = use->reversed, .a = at.at[i - 1], .b = at.at[i]};
        status = bat_face_measure_piece(w, &p);
        if (status == BATTEN_OK)
            status = bat_face_add_piece(list, &p);
    }
    bat_release(at.at);
    return status;
}

/* ---- the face ---- */

static batten_status begin_integral(const batten_body_parts *parts,
                                    const batten_body_face *face, const bat_face_rules *rules,
                                    bat_face_work *w)
{
    *w = (bat_face_work){.parts = parts, .rules = rules, .surface = face->surface};
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
        met[k] = bat_face_knots_between(w, w->range[k].a, w->range[k].b, &first);
    }
    /* G is cheaper where it meets fewer knots. */
    w->inner = met[1] < met[0];
    w->from = w->range[w->inner].a + (w->range[w->inner].b - w->range[w->inner].a) / 2;
    bat_gauss(BAT_FACE_SHORT, w->nodes, w->weights);
    bat_gauss(BAT_FACE_LONG, w->nodes + BAT_FACE_SHORT, w->weights + BAT_FACE_SHORT);
    return BATTEN_OK;
}

/* The area between an edge and its curve on the face. */
static batten_status add_slack(const bat_face_work *w, const batten_body_use *use,
                               double *slack)
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

static batten_status take_use(bat_face_work *w, const batten_body_use *use,
                              bat_face_pieces *list, bat_face_sums *out)
{
    const batten_status status = cut_use(w, use, list);
    return status == BATTEN_OK ? add_slack(w, use, &out->slack) : status;
}

static batten_status first_pieces(bat_face_work *w, const batten_body_face *face,
                                  bat_face_pieces *list, bat_face_sums *out)
{
    const batten_body_parts *parts = w->parts;
    for (int l = face->first; l < face->first + face->count; l++)
        for (int u = 0; u < parts->loops[l].count; u++) {
            const batten_status status =
                take_use(w, &parts->uses[parts->loops[l].first + u], list, out);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}

static void add_piece(const bat_face_piece *p, bat_face_sums *out, double gross[2])
{
    for (int k = 0; k < BAT_FACE_INTEGRALS; k++)
        out->values[k] += p->values[k];
    out->area_error += p->errors[0][0] + p->errors[0][1];
    out->volume_error += p->errors[1][0] + p->errors[1][1];
    gross[0] += p->gross[0];
    gross[1] += p->gross[1];
}

static void sum_up(const bat_face_pieces *list, bat_face_sums *out, double gross[2])
{
    memset(out->values, 0, sizeof out->values);
    out->area_error = out->volume_error = gross[0] = gross[1] = 0;
    for (size_t i = 0; i < list->count; i++)
        add_piece(&list->items[i], out, gross);
}

/* Halve the piece, or its parts of G, whichever the larger error asks for. */
static batten_status improve(bat_face_work *w, bat_face_pieces *list, size_t index, bool *done)
{
    bat_face_piece low = list->items[index];
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
        const batten_status status = bat_face_measure_piece(w, &low);
        list->items[index] = low;
        return status;
    }
    if (!(low.a < middle && middle < low.b)) {
        *done = false;
        return BATTEN_OK;
    }
    bat_face_piece high = low;
    low.b = high.a = middle;
    batten_status status = bat_face_measure_piece(w, &low);
    if (status == BATTEN_OK)
        status = bat_face_measure_piece(w, &high);
    list->items[index] = low;
    return status == BATTEN_OK ? bat_face_add_piece(list, &high) : status;
}

/* Round after round all pieces whose error is above their share. */
static batten_status refine(bat_face_work *w, bat_face_pieces *list, bat_face_sums *out)
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
            const bat_face_piece *p = &list->items[i];
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
    bat_face_pieces list = {0};
    bat_face_work w;
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
