/* Whether the loops of a face touch or cross, themselves or each other, in its parameters. */
#include "body/check_parts.h"
#include "inspect/self_crossings.h"
#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

/* A use of the face as its loop runs. */
typedef struct {
    int loop, use, next; /* which loop of the face; which use of the body; what follows here */
    batten_curve *curve; /* (u, v), from where it begins */
    int vertex;          /* where it begins */
    double start[2];
} passage;

typedef struct {
    int count;
    passage *at;
    double low[2], size[2]; /* of the box of all in (u, v); curves are as seen in its unit */
    bool *is_bad;           /* of each loop */
} passages;

/* In the unit of the box places nearer than this are one: rounding, and the misses of traced
 * curves. */
static const double NEAR = 1e-7;

static void release(passages *all)
{
    for (int i = 0; i < all->count; i++)
        batten_curve_unref(all->at[i].curve);
    bat_release(all->at);
    bat_release(all->is_bad);
}

/* ---- the loops as they run ---- */

static batten_status pass(const batten_body_parts *p, int use, passage *out)
{
    const batten_body_use *of = &p->uses[use];
    out->use = use;
    out->vertex = p->edges[of->edge].vertices[of->reversed];
    if (of->reversed)
        return batten_curve_reverse(of->parameters, &out->curve);
    out->curve = batten_curve_ref(of->parameters);
    return BATTEN_OK;
}

/* Both parameters from 0 to 1, whatever their units. */
static batten_status bring_to_unit(passages *all)
{
    batten_affine map = batten_affine_identity();
    for (int k = 0; k < 2; k++) {
        map.m[k][k] = 1 / all->size[k];
        map.t[k] = -all->low[k] / all->size[k];
    }
    for (int i = 0; i < all->count; i++) {
        passage *one = &all->at[i];
        batten_curve *moved = NULL;
        batten_status status = batten_curve_transform(one->curve, &map, &moved);
        if (status != BATTEN_OK)
            return status;
        batten_curve_unref(one->curve);
        one->curve = moved;
        status = batten_curve_evaluate(moved, batten_curve_domain(moved).a, 0, one->start);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

static batten_status gather(const batten_body_parts *p, int face, passages *all)
{
    const batten_body_face *of = &p->faces[face];
    int uses = 0;
    for (int l = 0; l < of->count; l++)
        uses += p->loops[of->first + l].count;
    *all = (passages){0};
    all->at = bat_array((size_t)uses + 1, sizeof *all->at);
    all->is_bad = bat_array((size_t)of->count + 1, sizeof *all->is_bad);
    if (!all->at || !all->is_bad)
        return BATTEN_OUT_OF_MEMORY;
    memset(all->at, 0, ((size_t)uses + 1) * sizeof *all->at);
    memset(all->is_bad, 0, ((size_t)of->count + 1) * sizeof *all->is_bad);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (int l = 0; l < of->count; l++) {
        const batten_body_loop *loop = &p->loops[of->first + l];
        const int first = all->count;
        for (int i = 0; i < loop->count; i++) {
            passage *one = &all->at[all->count];
            one->loop = l;
            const batten_status status = pass(p, loop->first + i, one);
            all->count += one->curve != NULL;
            if (status != BATTEN_OK)
                return status;
            one->next = i + 1 < loop->count ? all->count : first;
            const batten_box box = batten_curve_box(one->curve);
            low[0] = bat_min(low[0], box.low.x);
            low[1] = bat_min(low[1], box.low.y);
            high[0] = bat_max(high[0], box.high.x);
            high[1] = bat_max(high[1], box.high.y);
        }
    }
    for (int k = 0; k < 2; k++) {
        all->low[k] = low[k];
        all->size[k] = high[k] > low[k] ? high[k] - low[k] : 1;
    }
    return bring_to_unit(all);
}

/* ---- faults ---- */

static void report(bat_check *check, int face, passages *all, int a, int b, const double at[2],
                   const char *what)
{
    const passage *first = &all->at[a], *second = &all->at[b];
    char name[BAT_CHECK_NAME];
    for (int k = 0; k < 2; k++) {
        bool *bad = &all->is_bad[k ? second->loop : first->loop];
        check->faults->crossing_loops += !*bad;
        *bad = true;
    }
    batten_notes_add(check->notes, "", 0, bat_check_face_name(check, face, name),
                     "edges %d and %d of its loops %d and %d %s at (u, v) = (%.9g, %.9g)",
                     check->parts->uses[first->use].edge, check->parts->uses[second->use].edge,
                     first->loop, second->loop, what, all->low[0] + at[0] * all->size[0],
                     all->low[1] + at[1] * all->size[1]);
}

/* Where one use ends and the next begins they meet; a crossing there is a miss of tracing. */
static bool is_joint(const passages *all, const bat_crossing *crossing, const double at[2])
{
    const int a = crossing->curve[0], b = crossing->curve[1];
    const double *joint = all->at[a].next == b   ? all->at[b].start
                          : all->at[b].next == a ? all->at[a].start
                                                 : NULL;
    if (joint && bat_distance(2, at, joint) <= NEAR)
        return true;
    return all->at[a].next == b && all->at[b].next == a &&
           bat_distance(2, at, all->at[a].start) <= NEAR;
}

static batten_status find_crossings(bat_check *check, int face, passages *all)
{
    const batten_curve **curves = bat_array((size_t)all->count + 1, sizeof *curves);
    bat_crossings found = {0};
    if (!curves)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count; i++)
        curves[i] = all->at[i].curve;
    batten_status status = bat_crossings_find(all->count, curves, false, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        const bat_crossing *one = &found.at[i];
        double at[2];
        status = batten_curve_evaluate(curves[one->curve[0]], one->u[0], 0, at);
        if (status == BATTEN_OK && !is_joint(all, one, at))
            report(check, face, all, one->curve[0], one->curve[1], at, "cross");
    }
    bat_release(found.at);
    bat_release(curves);
    return status;
}

static int by_vertex(const void *a, const void *b)
{
    const passage *x = *(const passage *const *)a, *y = *(const passage *const *)b;
    if (x->vertex != y->vertex)
        return x->vertex < y->vertex ? -1 : 1;
    return x < y ? -1 : x > y;
}

/* Loops that come twice to the same vertex in the same place of the parameters touch; at a seam
 * or a pole the places differ. */
static batten_status find_touches(bat_check *check, int face, passages *all)
{
    const passage **sorted = bat_array((size_t)all->count + 1, sizeof *sorted);
    if (!sorted)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count; i++)
        sorted[i] = &all->at[i];
    qsort(sorted, (size_t)all->count, sizeof *sorted, by_vertex);
    for (int i = 1; i < all->count; i++)
        if (sorted[i]->vertex == sorted[i - 1]->vertex &&
            bat_distance(2, sorted[i]->start, sorted[i - 1]->start) <= NEAR)
            report(check, face, all, (int)(sorted[i - 1] - all->at), (int)(sorted[i] - all->at),
                   sorted[i]->start, "touch");
    bat_release(sorted);
    return BATTEN_OK;
}

batten_status bat_check_loops(bat_check *check, int face)
{
    passages all;
    batten_status status = gather(check->parts, face, &all);
    if (status == BATTEN_OK)
        status = find_crossings(check, face, &all);
    if (status == BATTEN_OK)
        status = find_touches(check, face, &all);
    release(&all);
    return status;
}
