/* Points as a grid: rows of equal length from lists, files and tables of offsets. */
#include "design/shared/grid.h"
#include "base/plural.h"

/* Put the rows of an object after those that are there; the first row of all says how long they
 * are. */
static batten_status add_rows(const batten_object *object, bat_rows *all)
{
    bat_rows more = {0, NULL};
    batten_status status = bat_rows_of(object, false, &more);
    if (status != BATTEN_OK)
        return status;
    const int first = all->count ? all->rows[0].count : more.count ? more.rows[0].count : 0;
    for (int i = 0; i < more.count && status == BATTEN_OK; i++)
        if (more.rows[i].count != first)
            status = bat_fail(
                BATTEN_NOT_COMPATIBLE, "'%s' has %d point%s, and the first row has %d",
                more.rows[i].name, more.rows[i].count, bat_plural(more.rows[i].count), first);
    bat_row *grown =
        status == BATTEN_OK
            ? bat_resize(all->rows, (size_t)(all->count + more.count), sizeof *grown)
            : NULL;
    if (!grown) {
        bat_rows_release(&more);
        return status == BATTEN_OK ? BATTEN_OUT_OF_MEMORY : status;
    }
    all->rows = grown;
    for (int i = 0; i < more.count; i++)
        grown[all->count++] = more.rows[i];
    bat_release(more.rows);
    return BATTEN_OK;
}

/* The points are turned: u runs along the rows. */
static batten_status transpose_rows(const bat_rows *all, bat_grid *out)
{
    const int count_u = all->rows[0].count, count_v = all->count;
    double *points = bat_array3((size_t)count_u, (size_t)count_v, 3 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count_u; i++)
        for (int j = 0; j < count_v; j++)
            for (int k = 0; k < 3; k++)
                points[((size_t)i * (size_t)count_v + (size_t)j) * 3 + (size_t)k] =
                    all->rows[j].points[3 * i + k];
    *out = (bat_grid){count_u, count_v, points};
    return BATTEN_OK;
}

/* The most uneven line of the grid along one direction: its number and distances. */
static int find_uneven(const bat_grid *grid, bool along_rows, bat_spread *worst)
{
    int line = -1;
    const int lines = along_rows ? grid->count_v : grid->count_u;
    const int count = along_rows ? grid->count_u : grid->count_v;
    const size_t step = along_rows ? (size_t)grid->count_v : 1,
                 next = along_rows ? 1 : (size_t)grid->count_v;
    for (int l = 0; l < lines; l++) {
        const bat_spread spread =
            bat_spread_of(count, grid->points + 3 * (size_t)l * next, step);
        if (bat_spread_is_uneven(&spread) &&
            spread.most * worst->least > worst->most * spread.least) {
            *worst = spread;
            line = l;
        }
    }
    return line;
}

/* As of rows of points, once for the rows and once for the columns. */
static void note_grid(const bat_run *run, const char *parameter, const bat_grid *grid)
{
    for (int k = 0; k < 2; k++) {
        bat_spread worst = {.least = 1};
        const int line = find_uneven(grid, k == 0, &worst);
        if (line >= 0)
            bat_note(
                run,
                "'%s': points %d and %d of %s %d are %.3g apart, others of it up to %.3g; a "
                "surface through such points may turn sharply between them",
                parameter, worst.at + 1, worst.at + 2, k == 0 ? "row" : "column", line + 1,
                worst.least, worst.most);
    }
    bat_note_reach(run, parameter, grid->count_u * grid->count_v, grid->points);
}

batten_status bat_grid_of(const bat_run *run, const char *parameter, bat_grid *out)
{
    bat_objects objects;
    bat_rows all = {0, NULL};
    batten_status status = bat_gather(run, parameter, BAT_POINTS | BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = add_rows(objects.at[i], &all);
    if (status == BATTEN_OK)
        status = transpose_rows(&all, out);
    if (status == BATTEN_OK)
        status = bat_points_check_size(out->count_u * out->count_v, out->points);
    if (status == BATTEN_OK)
        note_grid(run, parameter, out);
    bat_rows_release(&all);
    bat_objects_release(&objects);
    return status;
}

void bat_grid_release(bat_grid *grid)
{
    bat_release(grid->points);
    grid->points = NULL;
}

batten_status bat_grid_surface(bat_run *run, const char *parameter,
                               batten_status (*make)(bat_run *run, const bat_grid *grid,
                                                     batten_surface **out))
{
    bat_grid grid = {0, 0, NULL};
    batten_surface *surface = NULL;
    batten_status status = bat_grid_of(run, parameter, &grid);
    if (status == BATTEN_OK)
        status = make(run, &grid, &surface);
    bat_grid_release(&grid);
    return bat_put_surface(run, status, surface);
}
