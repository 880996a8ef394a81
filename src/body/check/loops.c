/* Whether the loops of a face touch or cross, themselves or each other, in its parameters. */
#include "body/check/parts.h"
#include "inspect/nearest/self_crossings.h"
#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

/* A use of the face as its loop runs. */
typedef struct {
    int loop, use, next;   /* which loop of the face; which use of the body; what follows */
    batten_curve *curve;   /* (u, v), from where it begins */
    double start[2];       /* where it begins */
    double before, length; /* in space: of its loop so far, and its own; only for doubts */
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

static void release_passages(passages *all)
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

/* Those that are no joints; release `at`. */
static batten_status find_crossings(const passages *all, bat_crossings *out)
{
    const batten_curve **curves = bat_array((size_t)all->count + 1, sizeof *curves);
    bat_crossings found = {0};
    if (!curves)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < all->count; i++)
        curves[i] = all->at[i].curve;
    batten_status status = bat_crossings_find(all->count, curves, false, &found);
    int kept = 0;
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        double at[2];
        status = batten_curve_evaluate(curves[found.at[i].curve[0]], found.at[i].u[0], 0, at);
        if (status == BATTEN_OK && !is_joint(all, &found.at[i], at))
            found.at[kept++] = found.at[i];
    }
    found.count = kept;
    bat_release(curves);
    if (status == BATTEN_OK)
        *out = found;
    else
        bat_release(found.at);
    return status;
}

static batten_status report_crossings(bat_check *check, int face, passages *all)
{
    bat_crossings found = {0};
    batten_status status = find_crossings(all, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        const bat_crossing *one = &found.at[i];
        double at[2];
        status = batten_curve_evaluate(all->at[one->curve[0]].curve, one->u[0], 0, at);
        if (status == BATTEN_OK)
            report(check, face, all, one->curve[0], one->curve[1], at, "cross");
    }
    bat_release(found.at);
    return status;
}

/* A beginning of a use, in the cell of a grid. */
typedef struct {
    long long cell[2];
    int index;
} in_cell;

static int by_cell(const void *a, const void *b)
{
    const in_cell *x = a, *y = b;
    for (int k = 0; k < 2; k++)
        if (x->cell[k] != y->cell[k])
            return x->cell[k] < y->cell[k] ? -1 : 1;
    return (x->index > y->index) - (x->index < y->index);
}

/* Grid 0 .. 3 is shifted by half a cell in u, in v, in both: of places that are nearer to each
 * other than half a cell one of them has both in a cell. */
static in_cell cell_of(const passages *all, int index, int grid)
{
    const double *start = all->at[index].start, side = 2 * NEAR;
    return (in_cell){{(long long)floor(start[0] / side + 0.5 * (grid & 1)),
                      (long long)floor(start[1] / side + 0.5 * (grid >> 1))},
                     index};
}

static bool share_earlier_cell(const passages *all, int a, int b, int grid)
{
    for (int g = 0; g < grid; g++) {
        const in_cell x = cell_of(all, a, g), y = cell_of(all, b, g);
        if (x.cell[0] == y.cell[0] && x.cell[1] == y.cell[1])
            return true;
    }
    return false;
}

/* Loops that come twice to the same place touch there; at a seam or a pole the places of a
 * vertex differ. */
static batten_status find_touches(bat_check *check, int face, passages *all)
{
    in_cell *sorted = bat_array((size_t)all->count + 1, sizeof *sorted);
    if (!sorted)
        return BATTEN_OUT_OF_MEMORY;
    for (int grid = 0; grid < 4; grid++) {
        for (int i = 0; i < all->count; i++)
            sorted[i] = cell_of(all, i, grid);
        qsort(sorted, (size_t)all->count, sizeof *sorted, by_cell);
        for (int i = 1; i < all->count; i++) {
            const int a = sorted[i - 1].index, b = sorted[i].index;
            if (sorted[i].cell[0] == sorted[i - 1].cell[0] &&
                sorted[i].cell[1] == sorted[i - 1].cell[1] &&
                bat_distance(2, all->at[a].start, all->at[b].start) <= NEAR &&
                !share_earlier_cell(all, a, b, grid))
                report(check, face, all, a, b, all->at[b].start, "touch");
        }
    }
    bat_release(sorted);
    return BATTEN_OK;
}

batten_status bat_check_loops(bat_check *check, int face)
{
    passages all;
    batten_status status = gather(check->parts, face, &all);
    if (status == BATTEN_OK)
        status = report_crossings(check, face, &all);
    if (status == BATTEN_OK)
        status = find_touches(check, face, &all);
    release_passages(&all);
    return status;
}

/* ---- what crossings leave open ---- */

/* How long the loops are up to each use, by chords of the edges. */
static batten_status set_lengths(const batten_body_parts *p, passages *all)
{
    enum { STEPS = 8 };
    double sum = 0;
    for (int i = 0; i < all->count; i++) {
        passage *one = &all->at[i];
        const batten_curve *curve = p->edges[p->uses[one->use].edge].curve;
        sum = i > 0 && all->at[i - 1].loop == one->loop ? sum : 0;
        one->before = sum;
        double last[3], here[3];
        for (int k = 0; curve && k <= STEPS; k++, memcpy(last, here, sizeof last)) {
            const batten_interval on = batten_curve_domain(curve);
            const double t = k < STEPS ? on.a + (on.b - on.a) * k / STEPS : on.b;
            const batten_status status = batten_curve_evaluate(curve, t, 0, here);
            if (status != BATTEN_OK)
                return status;
            one->length += k > 0 ? bat_distance(3, last, here) : 0;
        }
        sum += one->length;
    }
    return BATTEN_OK;
}

static double length_of_loop(const passages *all, int of)
{
    int last = of;
    while (last + 1 < all->count && all->at[last + 1].loop == all->at[of].loop)
        last++;
    return all->at[last].before + all->at[last].length;
}

/* A crossing divides its loop in two; of two loops it is the shorter that is in doubt. */
static double doubtful_length(const passages *all, const bat_crossing *crossing)
{
    double place[2], total[2];
    for (int k = 0; k < 2; k++) {
        const passage *one = &all->at[crossing->curve[k]];
        const batten_interval on = batten_curve_domain(one->curve);
        place[k] = one->before + one->length * (crossing->u[k] - on.a) / (on.b - on.a);
        total[k] = length_of_loop(all, crossing->curve[k]);
    }
    if (all->at[crossing->curve[0]].loop != all->at[crossing->curve[1]].loop)
        return bat_min(total[0], total[1]);
    const double part = fabs(place[1] - place[0]);
    return bat_min(part, total[0] - part);
}

batten_status bat_loops_doubt(const batten_body_parts *parts, int face, double *area)
{
    passages all;
    bat_crossings found = {0};
    *area = 0;
    batten_status status = gather(parts, face, &all);
    if (status == BATTEN_OK)
        status = find_crossings(&all, &found);
    if (status == BATTEN_OK && found.count > 0)
        status = set_lengths(parts, &all);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++) {
        const double length = doubtful_length(&all, &found.at[i]);
        *area += length * length / acos(-1);
    }
    bat_release(found.at);
    release_passages(&all);
    return status;
}
