/* The division of a box into cells, each free of the curve or with graphs in it. */
#include "shape/equation/cells.h"

#include "base/list.h"

/* Where cells are cut along each axis: not in the middle, and not alike, since curves of round numbers and diagonals
 * would cross corners. */
static const double cuts[BAT_SPACE] = {0.4871236894, 0.5193746021, 0.4612893557};

static int compare_ends(const bat_cell_end *a, const bat_cell_end *b, int graph)
{
    return (a->point[graph] > b->point[graph]) - (a->point[graph] < b->point[graph]);
}

static void sort_ends(bat_cell_end *ends, int count, int graph)
{
    for (int i = 1; i < count; i++)
        for (int k = i; k > 0 && compare_ends(&ends[k - 1], &ends[k], graph) > 0; k--) {
            const bat_cell_end end = ends[k];
            ends[k] = ends[k - 1];
            ends[k - 1] = end;
        }
}

/* The crossings of all sides; -1 when those of one are not known. */
static int find_ends(bat_system *s, const bat_cell *cell, bat_cell_end ends[2 * BAT_SPACE])
{
    int count = 0;
    for (int k = 0; k < s->dimension; k++)
        for (int side = -1; side <= 1; side += 2) {
            bat_cell_end *end = &ends[count];
            *end = (bat_cell_end){.axis = k, .side = side};
            end->at = side < 0 ? cell->at[k].lo : cell->at[k].hi;
            const bat_crossing_count found =
                bat_find_crossing(s, cell, k, end->at, end->point, &end->radius);
            if (found == BAT_CROSSINGS_UNKNOWN)
                return -1;
            count += found == BAT_ONE_CROSSING;
        }
    return count;
}

/* A graph enters and leaves: its crossings, in order along the axis, are ends of pieces in pairs. */
static batten_status take_pieces(bat_cells *cells, const bat_cell *cell, const bat_enclosure *e,
                                 bool *done)
{
    bat_system *s = cells->system;
    bat_regularity regularity;
    bat_cell_end ends[2 * BAT_SPACE + 1];
    int graph = -1;
    double best = 0;
    for (int k = 0; k < s->dimension; k++)
        if (bat_is_graph(s, e, k, &regularity) && regularity.strength > best) {
            best = regularity.strength;
            graph = k;
        }
    *done = false;
    const int count = graph < 0 ? -1 : find_ends(s, cell, ends);
    if (count < 0 || count % 2)
        return BATTEN_OK;
    batten_status status = BATTEN_OK;
    sort_ends(ends, count, graph);
    for (int i = 0; i < count && status == BATTEN_OK; i += 2)
        status = BAT_LIST_ADD(
            cells->pieces, cells->count, cells->room,
            (bat_cell_piece){.cell = *cell, .graph = graph, .end = {ends[i], ends[i + 1]}});
    *done = true;
    return status;
}

static batten_status cut_cell(const bat_system *s, const bat_cell *cell, bat_cell_list *out)
{
    const int k = bat_cell_longest(s, cell);
    bat_cell low = *cell, high = *cell;
    const double at = cell->at[k].lo + cuts[k] * bat_interval_width(cell->at[k]);
    low.at[k].hi = high.at[k].lo = at;
    const batten_status status = BAT_LIST_ADD(out->items, out->count, out->room, low);
    if (status != BATTEN_OK)
        return status;
    return BAT_LIST_ADD(out->items, out->count, out->room, high);
}

static batten_status examine(bat_cells *cells, const bat_cell *cell, double least,
                             bat_cell_list *next)
{
    bat_system *s = cells->system;
    bat_cell_list *undecided = &cells->undecided;
    bat_enclosure e;
    bool done = false;
    bat_system_over(s, cell, &e);
    cells->examined++;
    if (bat_cell_is_free(s, cell, &e))
        return BATTEN_OK;
    const batten_status status = take_pieces(cells, cell, &e, &done);
    if (status != BATTEN_OK || done)
        return status;
    if (bat_cell_extent(s, cell) < least || cells->examined > cells->most)
        return BAT_LIST_ADD(undecided->items, undecided->count, undecided->room, *cell);
    return cut_cell(s, cell, next);
}

batten_status bat_cells_divide(bat_cells *cells, bat_cell_list *list, double least)
{
    bat_cell_list next = {NULL, 0, 0};
    batten_status status = BATTEN_OK;
    while (list->count > 0 && status == BATTEN_OK) {
        for (size_t i = 0; i < list->count && status == BATTEN_OK; i++) {
            status = examine(cells, &list->items[i], least, &next);
            if (status == BATTEN_OK)
                status = bat_work_step(&cells->work, 1, 0, "implicit curve");
        }
        const bat_cell_list used = *list;
        *list = next;
        next = used;
        next.count = 0;
    }
    bat_release(next.items);
    bat_release(list->items);
    *list = (bat_cell_list){NULL, 0, 0};
    return status;
}

void bat_cells_release(bat_cells *cells)
{
    bat_release(cells->pieces);
    bat_release(cells->undecided.items);
    cells->pieces = NULL;
    cells->undecided.items = NULL;
}
