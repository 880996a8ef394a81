/* Vertices and edges, shared as the file shares them. */
#include "exchange/step/read/topology.h"
#include "numeric/vector.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Gaps of up to so many tolerances are closed; above, those of a curve that is this many times
 * as large as the gap are borne. */
enum { SNAP = 100, BORNE = 4 };

/* ---- the curve of an edge ---- */

typedef struct {
    const bat_step_instance *instance, *geometry;
    int vertices[2];
    double p[3], q[3]; /* where the vertices are */
    bool forward;      /* same_sense */
    bat_step_edge source;
    batten_curve *curve;
} edge;

static batten_status blame(const bat_step_topology *t, const edge *e, batten_status status)
{
    if (status == BATTEN_OK || status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED)
        return status;
    return bat_step_fail(t->file, e->instance, status, "%.300s", batten_message());
}

static void warn_sense(const bat_step_topology *t, const edge *e)
{
    bat_step_warn(t->file, e->instance,
                  "its curve runs %s its vertices, the file says otherwise; turned",
                  e->forward ? "against" : "with");
}

/* The edge has no length: its vertices are one. */
static batten_status take_as_point(bat_step_topology *t, edge *e)
{
    batten_status status = BATTEN_OK;
    if (e->vertices[0] != e->vertices[1]) {
        bat_step_warn(t->file, e->instance, "its vertices coincide; taken as one");
        status = bat_step_unite(t, e->vertices[0], e->vertices[1]);
    }
    e->vertices[1] = e->vertices[0];
    return status;
}

static batten_status conic_part(bat_step_topology *t, const bat_conic *conic, edge *e)
{
    if (conic->kind == BAT_LINE) {
        if (bat_distance(3, e->p, e->q) <= 1e-3 * t->scale.tolerance)
            return take_as_point(t, e);
        const double a = bat_conic_parameter(conic, e->p), b = bat_conic_parameter(conic, e->q);
        if (e->forward != (a < b))
            warn_sense(t, e);
    }
    /* Different vertices that lie very near bound a short arc and not the whole. */
    const double same =
        e->vertices[0] == e->vertices[1] ? t->scale.tolerance : 1e-3 * t->scale.tolerance;
    return blame(t, e, bat_conic_part(conic, e->p, e->q, e->forward, same, &e->curve));
}

static batten_status ends_of(const batten_curve *curve, double start[3], double end[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, start);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(curve, domain.b, BATTEN_FROM_LEFT, 0, end);
    return status;
}

/* Does it begin near q and end near p, and not the other way about? */
static batten_status is_against(const batten_curve *curve, const double p[3], const double q[3],
                                double tolerance, bool *against)
{
    double a[3], b[3];
    batten_status status = ends_of(curve, a, b);
    *against = status == BATTEN_OK && bat_distance(3, a, q) <= tolerance &&
               bat_distance(3, b, p) <= tolerance && bat_distance(3, a, p) > tolerance &&
               bat_distance(3, b, q) > tolerance;
    return status;
}

/* All control points in one place. */
static bool is_point(const batten_curve *curve, const double at[3], double tolerance)
{
    const double *points = batten_curve_points(curve);
    for (int i = 0; i < batten_curve_point_count(curve); i++)
        if (bat_distance(3, &points[3 * (size_t)i], at) > tolerance)
            return false;
    return true;
}

static batten_status spline_part(bat_step_topology *t, edge *e)
{
    const double tolerance = t->scale.tolerance;
    const double *p = e->forward ? e->p : e->q, *q = e->forward ? e->q : e->p;
    batten_curve *whole = NULL;
    double miss = 0;
    bool against = false;
    batten_status status = bat_step_read_curve(t->file, e->geometry, &t->scale, &whole);
    if (status == BATTEN_OK)
        status = bat_step_spend(t, e->instance, (size_t)batten_curve_point_count(whole));
    if (status == BATTEN_OK && e->vertices[0] == e->vertices[1] &&
        is_point(whole, e->p, tolerance)) {
        batten_curve_unref(whole);
        return BATTEN_OK;
    }
    if (status == BATTEN_OK)
        status = is_against(whole, p, q, tolerance, &against);
    if (status == BATTEN_OK && against)
        warn_sense(t, e);
    if (status == BATTEN_OK)
        status = blame(
            t, e, bat_curve_part(whole, e->p, e->q, e->forward, tolerance, &e->curve, &miss));
    if (status == BATTEN_OK) {
        e->source.is_turned = e->forward == against;
        e->source.is_whole =
            batten_curve_point_count(e->curve) == batten_curve_point_count(whole) &&
            (e->source.is_turned || e->curve == whole);
    }
    batten_curve_unref(whole);
    return status;
}

/* Move the control point at an end, where the curve begins or ends in it, to the vertex. */
static batten_status move_end(edge *e, int index, const double from[3], const double to[3])
{
    const double *point = batten_curve_points(e->curve) + 3 * (size_t)index;
    batten_curve *moved = NULL;
    /* The gap must be of the end itself: rounding of it beside the gap. */
    if (bat_distance(3, point, from) > 1e-9 * bat_distance(3, from, to))
        return BATTEN_OK;
    batten_status status = batten_curve_with_point(e->curve, index, to, &moved);
    if (status == BATTEN_OK) {
        batten_curve_unref(e->curve);
        e->curve = moved;
    }
    return status;
}

/* Close small gaps between the ends of the curve and the vertices, and speak of larger ones. */
static batten_status close_gaps(bat_step_topology *t, edge *e)
{
    const double tolerance = t->scale.tolerance;
    double start[3], end[3];
    batten_status status = ends_of(e->curve, start, end);
    if (status != BATTEN_OK)
        return status;
    const double gaps[2] = {bat_distance(3, start, e->p), bat_distance(3, end, e->q)};
    const double gap = bat_max(gaps[0], gaps[1]);
    if (gap <= tolerance)
        return BATTEN_OK;
    const bool snap = gap <= SNAP * tolerance;
    const batten_box box = batten_curve_box(e->curve);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    if (!snap && !(BORNE * gap <= size))
        return bat_step_fail(t->file, e->instance, BATTEN_BAD_FORMAT,
                             "its curve, %g large, misses its vertices by %g", size, gap);
    bat_step_warn(t->file, e->instance,
                  "its curve misses its vertices by %g, the tolerance is %g; %s", gap,
                  tolerance, snap ? "its ends are moved to them" : "kept so");
    if (!snap)
        return BATTEN_OK;
    e->source.is_whole = false;
    if (gaps[0] > tolerance)
        status = move_end(e, 0, start, e->p);
    if (status == BATTEN_OK && gaps[1] > tolerance)
        status = move_end(e, batten_curve_point_count(e->curve) - 1, end, e->q);
    return status;
}

/* ---- edges ---- */

static batten_status find_parts(bat_step_topology *t, edge *e)
{
    const bat_step_record *record = bat_step_as(t->file, e->instance, "EDGE_CURVE");
    const bat_step_instance *ends[2] = {NULL, NULL};
    if (!record)
        return bat_step_fail(t->file, e->instance, BATTEN_BAD_FORMAT,
                             "it is given where an EDGE_CURVE is expected");
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = bat_step_get_reference(t->file, record, 1 + k, &ends[k]);
        if (status == BATTEN_OK)
            status = bat_step_read_vertex(t, ends[k], &e->vertices[k]);
    }
    if (status == BATTEN_OK)
        status = bat_step_get_reference(t->file, record, 3, &e->geometry);
    if (status == BATTEN_OK)
        status = bat_step_get_logical(t->file, record, 4, &e->forward);
    if (status != BATTEN_OK)
        return status;
    for (int k = 0; k < 2; k++)
        memcpy(k ? e->q : e->p, bat_step_vertex_point(t, e->vertices[k]), sizeof e->p);
    return BATTEN_OK;
}

static batten_status put_edge(bat_step_topology *t, const edge *e, int *index)
{
    batten_status status =
        bat_builder_edge(&t->builder, e->curve, e->vertices[0], e->vertices[1], index);
    return status == BATTEN_OK ? bat_list_add(t->file->input, &t->edges, &e->source) : status;
}

static batten_status make_edge(bat_step_topology *t, edge *e, int *index)
{
    bat_conic conic;
    bool is_conic = false;
    batten_status status = find_parts(t, e);
    if (status == BATTEN_OK)
        status = bat_step_as_conic(t->file, e->geometry, &t->scale, &conic, &is_conic);
    if (status == BATTEN_OK)
        status = is_conic ? conic_part(t, &conic, e) : spline_part(t, e);
    if (status == BATTEN_OK && e->curve)
        status = close_gaps(t, e);
    if (status != BATTEN_OK)
        return status;
    e->source.instance = bat_step_index(t->file, e->instance);
    e->source.geometry = bat_step_index(t->file, e->geometry);
    return put_edge(t, e, index);
}

batten_status bat_step_read_edge(bat_step_topology *t, const bat_step_instance *instance,
                                 int *index)
{
    bat_step_made *made = bat_step_made_of(t, instance);
    if (made->stamp == bat_step_stamp(t, BAT_STEP_EDGE)) {
        *index = made->index;
        return made->index >= 0 ? BATTEN_OK
                                : bat_step_fail(t->file, instance, BATTEN_BAD_FORMAT,
                                                "the edge could not be read before");
    }
    edge e = {.instance = instance};
    batten_status status = make_edge(t, &e, index);
    batten_curve_unref(e.curve);
    if (status == BATTEN_OK)
        *made = (bat_step_made){bat_step_stamp(t, BAT_STEP_EDGE), *index};
    else if (status != BATTEN_OUT_OF_MEMORY)
        *made = (bat_step_made){bat_step_stamp(t, BAT_STEP_EDGE), -1};
    return status;
}

batten_status bat_step_add_edge(bat_step_topology *t, const bat_step_instance *instance,
                                batten_curve *curve, int *index)
{
    edge e = {.instance = instance, .curve = curve};
    batten_status status = ends_of(curve, e.p, e.q);
    if (status == BATTEN_OK)
        status = bat_builder_vertex(&t->builder, e.p, &e.vertices[0]);
    e.vertices[1] = e.vertices[0];
    if (status == BATTEN_OK && bat_distance(3, e.p, e.q) > t->scale.tolerance)
        status = bat_builder_vertex(&t->builder, e.q, &e.vertices[1]);
    e.source.instance = e.source.geometry = bat_step_index(t->file, instance);
    return status == BATTEN_OK ? put_edge(t, &e, index) : status;
}

/* ---- edges of polygons ---- */

static size_t slot_of(const bat_list *pairs, const batten_body_edge *edges, int low, int high)
{
    const int *slots = pairs->items;
    const uint64_t mixed =
        ((uint64_t)(uint32_t)low << 32 | (uint32_t)high) * UINT64_C(0x9e3779b97f4a7c15);
    size_t at = (size_t)(mixed >> 32) % pairs->count;
    while (slots[at] >= 0 &&
           !(bat_min_int(edges[slots[at]].vertices[0], edges[slots[at]].vertices[1]) == low &&
             bat_max_int(edges[slots[at]].vertices[0], edges[slots[at]].vertices[1]) == high))
        at = at + 1 == pairs->count ? 0 : at + 1;
    return at;
}

/* Room for one more, half of the slots free at least. */
static batten_status grow_pairs(bat_step_topology *t)
{
    if (2 * (t->pair_count + 1) <= t->pairs.count)
        return BATTEN_OK;
    bat_list larger = {.size = sizeof(int)};
    const size_t count = 64 + 2 * t->pairs.count;
    batten_status status = bat_input_array(t->file->input, count, sizeof(int), &larger.items);
    if (status != BATTEN_OK)
        return status;
    larger.count = larger.capacity = count;
    memset(larger.items, 0xff, count * sizeof(int));
    const int *old = t->pairs.items;
    const batten_body_edge *edges = t->builder.parts.edges;
    for (size_t k = 0; k < t->pairs.count; k++)
        if (old[k] >= 0) {
            const int *ends = edges[old[k]].vertices;
            ((int *)larger.items)[slot_of(&larger, edges, bat_min_int(ends[0], ends[1]),
                                          bat_max_int(ends[0], ends[1]))] = old[k];
        }
    bat_release(t->pairs.items);
    t->pairs = larger;
    return BATTEN_OK;
}

static batten_status make_straight(bat_step_topology *t, const bat_step_instance *from, int a,
                                   int b, int *index)
{
    static const double knots[] = {0, 0, 1, 1};
    edge e = {.instance = from, .vertices = {a, b}};
    double points[6];
    memcpy(points, bat_step_vertex_point(t, a), 3 * sizeof *points);
    memcpy(points + 3, bat_step_vertex_point(t, b), 3 * sizeof *points);
    e.source.instance = e.source.geometry = bat_step_index(t->file, from);
    batten_status status =
        batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, &e.curve);
    if (status == BATTEN_OK)
        status = put_edge(t, &e, index);
    batten_curve_unref(e.curve);
    return status;
}

batten_status bat_step_straight_edge(bat_step_topology *t, const bat_step_instance *from,
                                     const bat_step_instance *to, bat_step_use *use)
{
    int a = 0, b = 0;
    batten_status status = bat_step_vertex_at(t, from, &a);
    if (status == BATTEN_OK)
        status = bat_step_vertex_at(t, to, &b);
    if (status == BATTEN_OK && a == b)
        return bat_step_fail(t->file, from, BATTEN_BAD_FORMAT,
                             "the polygon has it twice in a row");
    if (status == BATTEN_OK)
        status = grow_pairs(t);
    if (status != BATTEN_OK)
        return status;
    const size_t slot =
        slot_of(&t->pairs, t->builder.parts.edges, bat_min_int(a, b), bat_max_int(a, b));
    int *found = (int *)t->pairs.items + slot;
    if (*found < 0) {
        int made = 0;
        status = make_straight(t, from, a, b, &made);
        if (status != BATTEN_OK)
            return status;
        *found = made;
        t->pair_count++;
    }
    *use = (bat_step_use){*found, t->builder.parts.edges[*found].vertices[0] != a};
    return BATTEN_OK;
}

/* ---- in the order of the file, so that what is written again has them as they were ---- */

typedef struct {
    uint32_t instance;
    int index;
} place;

static int compare_edges(const void *a, const void *b)
{
    const place *x = a, *y = b;
    return x->instance != y->instance
               ? (x->instance > y->instance) - (x->instance < y->instance)
               : (x->index > y->index) - (x->index < y->index);
}

static bool are_sorted(const bat_step_edge *edges, int count)
{
    for (int i = 1; i < count; i++)
        if (edges[i].instance < edges[i - 1].instance)
            return false;
    return true;
}

batten_status bat_step_sort_edges(bat_step_topology *t)
{
    const batten_body_parts *p = &t->builder.parts;
    const bat_step_edge *sources = t->edges.items;
    const int count = p->edge_count;
    if (are_sorted(sources, count))
        return BATTEN_OK;
    place *places = bat_array((size_t)count, sizeof *places);
    batten_body_edge *sorted = bat_array((size_t)count, sizeof *sorted);
    int *numbers = bat_array((size_t)count, sizeof *numbers);
    const batten_status status = places && sorted && numbers ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_body_edge *edges = (batten_body_edge *)(uintptr_t)p->edges;
        batten_body_use *uses = (batten_body_use *)(uintptr_t)p->uses;
        for (int i = 0; i < count; i++)
            places[i] = (place){sources[i].instance, i};
        qsort(places, (size_t)count, sizeof *places, compare_edges);
        for (int i = 0; i < count; i++) {
            sorted[i] = edges[places[i].index];
            numbers[places[i].index] = i;
        }
        for (int i = 0; i < count; i++)
            edges[i] = sorted[i];
        for (int i = 0; i < p->use_count; i++)
            uses[i].edge = numbers[uses[i].edge];
    }
    bat_release(places);
    bat_release(sorted);
    bat_release(numbers);
    return status;
}
