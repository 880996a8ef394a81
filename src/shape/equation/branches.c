/* Pieces linked across sides of cells and across singular points. */
#include "shape/equation/branches.h"

#include "base/list.h"
#include "numeric/vector.h"
#include "shape/equation/pieces.h"
#include <stdlib.h>

static const bat_cell_end *end_of(const bat_branches *b, int end)
{
    return &b->cells->pieces[end / 2].end[end % 2];
}

/* The direction in which a piece leaves by an end. */
static void leaving(const bat_branches *b, int end, double *out)
{
    const bat_cell_piece *piece = &b->cells->pieces[end / 2];
    const double *here = piece->end[end % 2].point, *there = piece->end[1 - end % 2].point;
    const double sense = here[piece->graph] > there[piece->graph] ? 1 : -1;
    bat_segment_tangent(b->cells->system, here, piece->graph, sense, out);
}

/* ---- across sides ---- */

typedef struct {
    int axis, end;
    double at, along;
} entry;

static int compare_entries(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->axis != y->axis)
        return x->axis - y->axis;
    if (x->at != y->at)
        return x->at < y->at ? -1 : 1;
    if (x->along != y->along)
        return x->along < y->along ? -1 : 1;
    return x->end - y->end;
}

/* Do two ends on opposite sides of one plane meet? */
static bool do_meet(const bat_branches *b, int one, int other, double spare)
{
    const bat_cell_end *a = end_of(b, one), *c = end_of(b, other);
    if (a->side == c->side)
        return false;
    for (int k = 0; k < b->cells->system->dimension; k++)
        if (fabs(a->point[k] - c->point[k]) > a->radius + c->radius + spare)
            return false;
    return true;
}

static void link_sorted(bat_branches *b, const entry *order, int count, double spare)
{
    for (int i = 0; i < count; i++)
        for (int k = i + 1; k < count && b->mate[order[i].end] < 0; k++) {
            const double reach =
                end_of(b, order[i].end)->radius + end_of(b, order[k].end)->radius + spare;
            if (order[k].axis != order[i].axis || order[k].at != order[i].at ||
                order[k].along > order[i].along + reach)
                break;
            if (b->mate[order[k].end] < 0 && do_meet(b, order[i].end, order[k].end, spare)) {
                b->mate[order[i].end] = order[k].end;
                b->mate[order[k].end] = order[i].end;
            }
        }
}

static batten_status link_sides(bat_branches *b)
{
    const int count = 2 * (int)b->cells->count;
    entry *order = bat_array((size_t)count, sizeof *order);
    double size = 0;
    if (!order)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        const bat_cell_end *end = end_of(b, i);
        order[i] = (entry){end->axis, i, end->at, end->point[end->axis == 0 ? 1 : 0]};
    }
    for (int k = 0; k < b->cells->system->dimension; k++)
        size = bat_max(size, bat_interval_size(b->cells->whole.at[k]));
    qsort(order, (size_t)count, sizeof *order, compare_entries);
    link_sorted(b, order, count, 8 * DBL_EPSILON * size);
    bat_release(order);
    return BATTEN_OK;
}

/* ---- across clusters ---- */

static bool is_on_rim(const bat_branches *b, const bat_cell_end *end)
{
    const bat_interval whole = b->cells->whole.at[end->axis];
    return end->at == whole.lo || end->at == whole.hi;
}

/* Which cluster an end without a mate enters: it lies on a cell of it. */
static int cluster_at(const bat_branches *b, const bat_cell_end *end)
{
    const bat_cell_list *all = &b->cells->undecided;
    for (size_t i = 0; i < all->count; i++) {
        bool inside = b->clusters->of != NULL;
        for (int k = 0; k < b->cells->system->dimension && inside; k++)
            inside = end->point[k] >= all->items[i].at[k].lo - end->radius &&
                     end->point[k] <= all->items[i].at[k].hi + end->radius;
        if (inside)
            return b->clusters->of[i];
    }
    return -1;
}

static double opposition(const bat_branches *b, int one, int other)
{
    double u[BAT_SPACE], v[BAT_SPACE], dot = 0;
    leaving(b, one, u);
    leaving(b, other, v);
    for (int k = 0; k < b->cells->system->dimension; k++)
        dot += u[k] * v[k];
    return -dot;
}

/* Pair the ends at a cluster so that each continues its mate; false where one has none. */
static bool pair_ends(bat_branches *b, const int *ends, int count)
{
    /* Tangents that turn by more than 25 degrees within the tolerance are no continuation. */
    const double least = 0.9;
    for (int i = 0; i < count; i++) {
        double best = least;
        int mate = -1;
        for (int k = i + 1; k < count && b->mate[ends[i]] < 0; k++)
            if (b->mate[ends[k]] < 0 && opposition(b, ends[i], ends[k]) > best) {
                best = opposition(b, ends[i], ends[k]);
                mate = ends[k];
            }
        if (mate >= 0) {
            b->mate[ends[i]] = mate;
            b->mate[mate] = ends[i];
        }
    }
    for (int i = 0; i < count; i++)
        if (b->mate[ends[i]] < 0)
            return false;
    return true;
}

/* Does a cluster reach the side of the box? What happens there is not the curve's doing. */
static bool is_at_rim(const bat_branches *b, int which)
{
    const bat_cell *box = &b->clusters->items[which].box, *whole = &b->cells->whole;
    for (int k = 0; k < b->cells->system->dimension; k++)
        if (box->at[k].lo == whole->at[k].lo || box->at[k].hi == whole->at[k].hi)
            return true;
    return false;
}

/* How far the cell of a piece reaches from a point. */
static double reach_of(const bat_branches *b, int piece, const double *point)
{
    const bat_cell *cell = &b->cells->pieces[piece].cell;
    double far[BAT_SPACE] = {0, 0, 0};
    for (int k = 0; k < b->cells->system->dimension; k++)
        far[k] = bat_max(point[k] - cell->at[k].lo, cell->at[k].hi - point[k]);
    return bat_norm(BAT_SPACE, far);
}

/* Pieces that leave a singular point and come back to it within the tolerance are the point. */
static void absorb_pieces(bat_branches *b, int which, double tolerance, double *error)
{
    const int all = 2 * (int)b->cells->count;
    const double *point = b->points + 3 * (size_t)which;
    for (int i = 0; i < all; i++) {
        if (b->cluster[i] != which)
            continue;
        double reach = reach_of(b, i / 2, point);
        int last = i ^ 1;
        for (; b->mate[last] >= 0 && reach <= tolerance; last = b->mate[last] ^ 1)
            reach = bat_max(reach, reach_of(b, b->mate[last] / 2, point));
        if (!(reach <= tolerance) || b->cluster[last] != which)
            continue;
        for (int end = i; end >= 0; end = b->mate[end ^ 1])
            b->used[end / 2] = true;
        b->cluster[i] = b->cluster[last] = -1;
        *error = bat_max(*error, reach);
    }
}

/* Link the ends at one singular point and say what it is. */
static batten_status link_cluster(bat_branches *b, int which, double tolerance,
                                  batten_equation_curves *out)
{
    enum { MOST = 16 };
    int ends[MOST], count = 0;
    const int all = 2 * (int)b->cells->count;
    double *point = b->points + 3 * (size_t)which;
    bat_cluster_point(b->cells->system, &b->clusters->items[which], point);
    absorb_pieces(b, which, tolerance, &out->error);
    for (int i = 0; i < all; i++)
        if (b->cluster[i] == which && count < MOST)
            ends[count++] = i;
    bool paired = pair_ends(b, ends, count);
    for (int i = 0; i < count && !paired; i++)
        b->mate[ends[i]] = -1;
    /* The two sides of a cusp are one branch. */
    if (!paired && count == 2) {
        b->mate[ends[0]] = ends[1];
        b->mate[ends[1]] = ends[0];
    }
    if (count < 2 && is_at_rim(b, which))
        return BATTEN_OK;
    const batten_equation_point_kind kind = count == 0            ? BATTEN_EQUATION_ISOLATED
                                            : paired && count > 2 ? BATTEN_EQUATION_NODE
                                                                  : BATTEN_EQUATION_SINGULAR;
    return bat_equation_add_point(
        out, (batten_equation_point){kind, {point[0], point[1], point[2]}, 0, count});
}

static batten_status link_clusters(bat_branches *b, double tolerance,
                                   batten_equation_curves *out)
{
    const int count = 2 * (int)b->cells->count;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < count; i++)
        if (b->mate[i] < 0 && !is_on_rim(b, end_of(b, i))) {
            b->cluster[i] = cluster_at(b, end_of(b, i));
            b->loose += b->cluster[i] < 0;
        }
    for (int i = 0; i < b->clusters->count && status == BATTEN_OK; i++)
        if (b->clusters->items[i].extent <= tolerance)
            status = link_cluster(b, i, tolerance, out);
        else
            for (int k = 0; k < count; k++)
                b->cluster[k] = b->cluster[k] == i ? -1 : b->cluster[k];
    return status;
}

batten_status bat_branches_link(bat_branches *branches, const bat_cells *cells,
                                const bat_clusters *clusters, double tolerance,
                                batten_equation_curves *out)
{
    const size_t ends = 2 * cells->count;
    *branches = (bat_branches){.cells = cells, .clusters = clusters};
    branches->mate = bat_array(ends, sizeof *branches->mate);
    branches->cluster = bat_array(ends, sizeof *branches->cluster);
    branches->used = bat_array(cells->count, sizeof *branches->used);
    branches->points = bat_array3((size_t)clusters->count, 3, sizeof *branches->points);
    batten_status status =
        branches->mate && branches->cluster && branches->used && branches->points
            ? BATTEN_OK
            : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < ends && status == BATTEN_OK; i++)
        branches->mate[i] = branches->cluster[i] = -1;
    for (size_t i = 0; i < cells->count && status == BATTEN_OK; i++)
        branches->used[i] = false;
    for (size_t i = 0; i < 3 * (size_t)clusters->count && status == BATTEN_OK; i++)
        branches->points[i] = 0;
    if (status == BATTEN_OK)
        status = link_sides(branches);
    if (status == BATTEN_OK)
        status = link_clusters(branches, tolerance, out);
    if (status != BATTEN_OK)
        bat_branches_release(branches);
    return status;
}

void bat_branches_release(bat_branches *branches)
{
    bat_release(branches->mate);
    bat_release(branches->cluster);
    bat_release(branches->used);
    bat_release(branches->points);
    *branches = (bat_branches){0};
}

/* ---- branches ---- */

/* Travel through a piece, in by `end`. */
static bat_segment travel(const bat_branches *b, int end)
{
    const bat_cell_piece *piece = &b->cells->pieces[end / 2];
    const bat_cell_end *in = end_of(b, end), *out = end_of(b, end ^ 1);
    bat_segment s = {.cell = piece->cell, .graph = piece->graph};
    leaving(b, end ^ 1, s.arrive);
    leaving(b, end, s.leave);
    for (int k = 0; k < b->cells->system->dimension; k++) {
        s.from[k] = in->point[k];
        s.to[k] = out->point[k];
        s.leave[k] = -s.leave[k];
    }
    return s;
}

static batten_status add_line(const bat_branches *b, const double *from, const double *to,
                              bat_segments *out)
{
    bat_segment s = {.is_link = true, .is_line = true};
    bool apart = false;
    for (int k = 0; k < b->cells->system->dimension; k++) {
        s.from[k] = from[k];
        s.to[k] = to[k];
        apart = apart || from[k] != to[k];
    }
    return apart ? BAT_LIST_ADD(out->items, out->count, out->room, s) : BATTEN_OK;
}

/* From the end by which a piece was left to where the next begins: nothing across a side, a bend across a node,
 * two lines over a cusp, one to the point where branches end. */
static batten_status add_link(const bat_branches *b, int left, bat_segments *out)
{
    const int next = b->mate[left];
    if (b->cluster[left] < 0)
        return BATTEN_OK;
    const double *point = b->points + 3 * (size_t)b->cluster[left];
    const double *from = end_of(b, left)->point;
    if (next >= 0 && opposition(b, left, next) > 0) {
        bat_segment s = {.is_link = true};
        leaving(b, left, s.leave);
        leaving(b, next, s.arrive);
        for (int k = 0; k < b->cells->system->dimension; k++) {
            s.from[k] = from[k];
            s.to[k] = end_of(b, next)->point[k];
            s.arrive[k] = -s.arrive[k];
        }
        return BAT_LIST_ADD(out->items, out->count, out->room, s);
    }
    batten_status status = add_line(b, from, point, out);
    if (status == BATTEN_OK && next >= 0)
        status = add_line(b, point, end_of(b, next)->point, out);
    return status;
}

/* Where neighbours meet, they have one point and one tangent, to the bit. */
static void tie_segments(int dimension, bat_segments *branch, bool closed)
{
    for (int i = closed ? 0 : 1; i < branch->count; i++) {
        bat_segment *s = &branch->items[i];
        const bat_segment *before = &branch->items[i ? i - 1 : branch->count - 1];
        for (int k = 0; k < dimension; k++) {
            s->from[k] = before->to[k];
            if (!s->is_line && !before->is_line)
                s->leave[k] = before->arrive[k];
        }
    }
}

static batten_status follow(bat_branches *b, int start, bat_segments *out)
{
    batten_status status = BATTEN_OK;
    int end = start;
    if (b->mate[start] < 0 && b->cluster[start] >= 0)
        status = add_line(b, b->points + 3 * (size_t)b->cluster[start], end_of(b, start)->point,
                          out);
    while (status == BATTEN_OK && end >= 0 && !b->used[end / 2]) {
        const bat_segment s = travel(b, end);
        b->used[end / 2] = true;
        status = BAT_LIST_ADD(out->items, out->count, out->room, s);
        if (status == BATTEN_OK)
            status = add_link(b, end ^ 1, out);
        end = b->mate[end ^ 1];
    }
    tie_segments(b->cells->system->dimension, out, end == start);
    for (int i = 0; i < out->count && status == BATTEN_OK; i++)
        if (!out->items[i].is_link)
            bat_segment_tighten(b->cells->system, &out->items[i]);
    return status;
}

batten_status bat_branches_next(bat_branches *branches, bat_segments *out)
{
    const int ends = 2 * (int)branches->cells->count;
    out->count = 0;
    for (int i = 0; i < ends; i++)
        if (!branches->used[i / 2] && branches->mate[i] < 0)
            return follow(branches, i, out);
    for (int i = 0; i < ends; i += 2)
        if (!branches->used[i / 2])
            return follow(branches, i, out);
    return BATTEN_OK;
}
