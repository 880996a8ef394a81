/* Whether the loops of a face touch or cross, themselves or each other, in its parameters. */
#include "body/check/parts.h"
#include "body/trace/passages.h"
#include "numeric/vector.h"

#include <stdlib.h>

/* ---- faults ---- */

static void report(bat_check *check, int face, bat_passages *all, int a, int b,
                   const double at[2], const char *what)
{
    const bat_passage *first = &all->at[a], *second = &all->at[b];
    char name[BAT_CHECK_NAME];
    for (int k = 0; k < 2; k++) {
        bool *bad = &all->is_bad[k ? second->loop : first->loop];
        check->faults->crossing_loops += !*bad;
        *bad = true;
    }
    batten_notes_add(check->notes, "", 0, bat_check_face_name(check, face, name),
                     "edges %d and %d of its loops %d and %d %s at (u, v) = (%.9g, %.9g)",
                     check->parts->uses[first->use].edge + 1,
                     check->parts->uses[second->use].edge + 1, first->loop + 1,
                     second->loop + 1, what, all->low[0] + at[0] * all->size[0],
                     all->low[1] + at[1] * all->size[1]);
}

static batten_status report_crossing(bat_check *check, int face, bat_passages *all,
                                     const bat_crossing *one)
{
    double at[2];
    const batten_status status =
        batten_curve_evaluate(all->at[one->curve[0]].curve, one->u[0], 0, at);
    if (status == BATTEN_OK)
        report(check, face, all, one->curve[0], one->curve[1], at, "cross");
    return status;
}

static batten_status report_crossings(bat_check *check, int face, bat_passages *all)
{
    bat_crossings found = {0};
    batten_status status = bat_passages_cross(all, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        status = report_crossing(check, face, all, &found.at[i]);
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
static in_cell cell_of(const bat_passages *all, int index, int grid)
{
    const double *start = all->at[index].start, side = 2 * BAT_ONE_PLACE;
    return (in_cell){{(long long)floor(start[0] / side + 0.5 * (grid & 1)),
                      (long long)floor(start[1] / side + 0.5 * (grid >> 1))},
                     index};
}

static bool share_earlier_cell(const bat_passages *all, int a, int b, int grid)
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
static batten_status find_touches(bat_check *check, int face, bat_passages *all)
{
    in_cell *sorted = bat_array((size_t)all->count, sizeof *sorted);
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
                bat_distance(2, all->at[a].start, all->at[b].start) <= BAT_ONE_PLACE &&
                !share_earlier_cell(all, a, b, grid))
                report(check, face, all, a, b, all->at[b].start, "touch");
        }
    }
    bat_release(sorted);
    return BATTEN_OK;
}

batten_status bat_check_loops(bat_check *check, int face)
{
    bat_passages all;
    batten_status status = bat_passages_gather(check->parts, face, &all);
    if (status == BATTEN_OK)
        status = report_crossings(check, face, &all);
    if (status == BATTEN_OK)
        status = find_touches(check, face, &all);
    bat_passages_release(&all);
    return status;
}
