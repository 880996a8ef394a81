/* Clusters of undecided cells. */
#include "shape/equation/clusters.h"

#include "base/sets.h"
#include "numeric/rounding.h"
#include <stdlib.h>

/* ---- cells that touch ---- */

static bool do_touch(const bat_system *s, const bat_cell *a, const bat_cell *b)
{
    for (int k = 0; k < s->dimension; k++)
        if (a->at[k].hi < b->at[k].lo || b->at[k].hi < a->at[k].lo)
            return false;
    return true;
}

/* The axis along which the cells are spread most. */
static int longest_spread(const bat_cells *cells)
{
    const bat_cell_list *all = &cells->undecided;
    bat_cell hull = all->items[0];
    for (size_t i = 1; i < all->count; i++)
        for (int k = 0; k < cells->system->dimension; k++)
            hull.at[k] = bat_interval_hull(hull.at[k], all->items[i].at[k]);
    return bat_cell_longest(cells->system, &hull);
}

typedef struct {
    double low;
    int cell;
} entry;

static int compare_entries(const void *a, const void *b)
{
    const entry *x = a, *y = b;
    if (x->low != y->low)
        return x->low < y->low ? -1 : 1;
    return (x->cell > y->cell) - (x->cell < y->cell);
}

/* Join all pairs that touch, by a sweep along the axis. */
static batten_status join_touching(const bat_cells *cells, int *of)
{
    const bat_cell_list *all = &cells->undecided;
    const int axis = longest_spread(cells);
    entry *order = bat_array(all->count, sizeof *order);
    if (!order)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < all->count; i++)
        order[i] = (entry){all->items[i].at[axis].lo, (int)i};
    qsort(order, all->count, sizeof *order, compare_entries);
    for (size_t i = 0; i < all->count; i++) {
        const bat_cell *a = &all->items[order[i].cell];
        for (size_t k = i + 1; k < all->count && order[k].low <= a->at[axis].hi; k++)
            if (do_touch(cells->system, a, &all->items[order[k].cell]))
                bat_sets_join(of, order[i].cell, order[k].cell);
    }
    bat_release(order);
    return BATTEN_OK;
}

/* ---- clusters ---- */

/* Number the roots in the order of their first cells, and put boxes about them. */
static void number_clusters(const bat_cells *cells, bat_clusters *out)
{
    for (size_t i = 0; i < cells->undecided.count; i++) {
        const bat_cell *cell = &cells->undecided.items[i];
        /* A root is the least of its cells, so that it has its number before the others ask. */
        if (out->of[i] == (int)i) {
            out->items[out->count].box = *cell;
            out->of[i] = out->count++;
            continue;
        }
        out->of[i] = out->of[out->of[i]];
        bat_cluster *cluster = &out->items[out->of[i]];
        for (int k = 0; k < cells->system->dimension; k++)
            cluster->box.at[k] = bat_interval_hull(cluster->box.at[k], cell->at[k]);
    }
    for (int i = 0; i < out->count; i++)
        out->items[i].extent = bat_cell_diagonal(cells->system, &out->items[i].box);
}

batten_status bat_clusters_gather(const bat_cells *cells, bat_clusters *out)
{
    const size_t count = cells->undecided.count;
    *out = (bat_clusters){NULL, 0, NULL};
    if (count == 0)
        return BATTEN_OK;
    out->of = bat_array(count, sizeof *out->of);
    out->items = bat_array(count, sizeof *out->items);
    batten_status status = out->of && out->items ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        bat_sets_begin((int)count, out->of);
    if (status == BATTEN_OK)
        status = join_touching(cells, out->of);
    if (status != BATTEN_OK) {
        bat_clusters_release(out);
        return status;
    }
    for (size_t i = 0; i < count; i++)
        out->of[i] = bat_sets_root(out->of, (int)i);
    number_clusters(cells, out);
    return BATTEN_OK;
}

void bat_clusters_release(bat_clusters *clusters)
{
    bat_release(clusters->items);
    bat_release(clusters->of);
    *clusters = (bat_clusters){NULL, 0, NULL};
}

/* ---- the point ---- */

/* One step of Newton's method for a vanishing gradient in the plane. */
static bool step_to_flat(const bat_system *s, bat_jet_space *second, double *point)
{
    bat_interval at[2] = {bat_interval_at(point[0]), bat_interval_at(point[1])};
    bat_interval_jet f;
    bat_equation_over(s->equation[0], second, at, &f);
    /* f, fx, fy, fxx / 2, fxy, fyy / 2 */
    double d[6];
    for (int i = 0; i < 6; i++)
        d[i] = bat_interval_middle(f.c[i]) * (i == 3 || i == 5 ? 2 : 1);
    const double determinant = d[3] * d[5] - d[4] * d[4];
    const double x = (d[1] * d[5] - d[2] * d[4]) / determinant;
    const double y = (d[2] * d[3] - d[1] * d[4]) / determinant;
    point[0] -= x;
    point[1] -= y;
    return isfinite(x) && isfinite(y);
}

void bat_cluster_point(const bat_system *system, const bat_cluster *cluster, double *point)
{
    enum { STEPS = 40 };
    bat_jet_space second;
    double start[BAT_SPACE] = {0, 0, 0}, off = 0;
    for (int k = 0; k < system->dimension; k++)
        point[k] = start[k] = bat_interval_middle(cluster->box.at[k]);
    if (system->dimension != 2)
        return;
    bat_jet_space_begin(&second, 2, 2);
    bool good = true;
    for (int i = 0; i < STEPS && good; i++)
        good = step_to_flat(system, &second, point);
    for (int k = 0; k < 2; k++)
        off = bat_max(off, fabs(point[k] - start[k]));
    for (int k = 0; k < 2 && !(good && off <= cluster->extent); k++)
        point[k] = start[k];
    /* What is left of 0 by rounding. */
    for (int k = 0; k < 2; k++)
        point[k] = fabs(point[k]) < BAT_MEANT_SAME * cluster->extent ? 0 : point[k];
}
