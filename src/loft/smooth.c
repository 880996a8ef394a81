/*
 * One smooth surface of a table: by the girths of its stations, or as a graph where the table is a grid of
 * waterlines whose lowest or highest points are not on lines of the hull.
 */
#include "loft/hull.h"

/* The stations as cuts see them: their points of the hull. */
static batten_status take_stations(const bat_hull_grid *grid, bat_hull_table *out)
{
    const size_t lines = (size_t)grid->line_count;
    out->table = grid->table;
    out->station_count = grid->station_count;
    out->stations =
        bat_arena_array(&out->arena, (size_t)grid->station_count, sizeof *out->stations);
    if (!out->stations)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < grid->station_count; k++) {
        bat_hull_station *s = out->stations + k;
        *s = (bat_hull_station){.x = grid->x[k]};
        s->points = bat_arena_array(&out->arena, lines, sizeof *s->points);
        if (!s->points)
            return BATTEN_OUT_OF_MEMORY;
        for (int l = 0; l < grid->line_count; l++)
            if (bat_hull_grid_says(grid, k, l) == BAT_GRID_HULL)
                s->points[s->count++] = (batten_table_point){
                    grid->x[k], bat_hull_grid_y(grid, k, l), grid->z[l], -1};
        s->is_stem = s->count == 0;
    }
    bat_hull_count(out);
    return BATTEN_OK;
}

static int count_zeros(const bat_hull_grid *grid)
{
    int zeros = 0;
    for (int k = 0; k < grid->station_count * grid->line_count; k++)
        zeros += grid->y[k] == 0;
    return zeros;
}

static batten_status set_scales_and_cuts(const bat_hull_grid *grid,
                                         const bat_hull_table *stations, bat_loft *loft)
{
    loft->breadth = stations->breadth;
    loft->height = 1e-6 * 2 * loft->breadth; /* of the breadth, as of girths */
    loft->one_side = true;
    loft->trimmed = count_zeros(grid);
    return bat_hull_cuts(stations, NULL, loft);
}

/* The frame of the hull itself; that of the whole grid where no graph over it keeps the bound: then
 * none does, and its points tell why. */
static batten_status find_frame(const bat_hull_grid *grid, double within, double breadth,
                                const batten_job *job, bat_arena *arena, bat_graph_frame *frame)
{
    bat_loft all = {0};
    batten_status status = bat_graph_frame_all(grid, arena, frame);
    if (status == BATTEN_OK)
        status = bat_graph_patch(grid, frame, within, &all);
    all.job = job;
    all.breadth = breadth;
    if (status == BATTEN_OK)
        status = bat_graph_limit_outside(grid, &all);
    if (status == BATTEN_OK)
        status = bat_graph_find_lines(grid, &all, within, arena, frame);
    if (status == BATTEN_NOT_COMPATIBLE)
        status = bat_graph_frame_all(grid, arena, frame);
    bat_hull_release(&all);
    return status;
}

static batten_status make_graph(const bat_hull_grid *grid, double within, const batten_job *job,
                                bat_loft *out)
{
    bat_hull_table stations = {0};
    bat_graph_frame frame;
    bat_loft loft = {0};
    batten_status status = bat_hull_grid_check(grid);
    if (status == BATTEN_OK)
        status = take_stations(grid, &stations);
    if (status == BATTEN_OK)
        status = bat_hull_check_bound(&stations, within);
    if (status == BATTEN_OK)
        status = find_frame(grid, within, stations.breadth, job, &stations.arena, &frame);
    if (status == BATTEN_OK)
        status = bat_graph_patch(grid, &frame, within, &loft);
    if (status == BATTEN_OK)
        status = set_scales_and_cuts(grid, &stations, &loft);
    if (status == BATTEN_OK)
        *out = loft;
    else
        bat_hull_release(&loft);
    bat_arena_free(&stations.arena);
    return status;
}

batten_status bat_hull_smooth(const batten_offset_table *table, double within,
                              const batten_job *job, bat_loft *out)
{
    bat_hull_grid grid;
    batten_status status = bat_hull_grid_make(table, &grid);
    if (status == BATTEN_OK)
        status = bat_hull_grid_is_graph(&grid) ? make_graph(&grid, within, job, out)
                                               : bat_hull_make(table, within, out);
    bat_arena_free(&grid.arena);
    return status;
}
