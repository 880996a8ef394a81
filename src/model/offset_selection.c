/* The part of a table of offsets inside a box, moved and scaled. */
#include "model/offset_table.h"

#include <stdio.h>
#include <string.h>

batten_offset_table_selection batten_offset_table_everything(void)
{
    const batten_interval all = {-INFINITY, INFINITY};
    return (batten_offset_table_selection){.size = sizeof(batten_offset_table_selection),
                                           .scale = 1,
                                           .x = all,
                                           .y = all,
                                           .z = all};
}

static batten_status check_interval(batten_interval interval, const char *name)
{
    if (interval.a <= interval.b)
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT, "the part %s = %g to %g is empty", name, interval.a,
                    interval.b);
}

static batten_status check_selection(const batten_offset_table_selection *selection)
{
    if (!isfinite(selection->scale))
        return bat_fail(BATTEN_NOT_FINITE, "the scale is %g", selection->scale);
    if (selection->scale <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the scale is %g, not above 0", selection->scale);
    batten_status status = check_interval(selection->x, "x");
    if (status == BATTEN_OK)
        status = check_interval(selection->y, "y");
    if (status == BATTEN_OK)
        status = check_interval(selection->z, "z");
    if (status == BATTEN_OK &&
        (selection->line_count < 0 || (selection->line_count > 0 && !selection->lines)))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "%d lines are to be kept; their number must be 0 or above, and each has "
            "a name",
            selection->line_count);
    return status;
}

/* What is on its way from the old table to the new one. */
typedef struct {
    const batten_offset_table_selection *selection;
    int line_count, station_count;
    bool *is_kept;     /* [lines of the old table] */
    int *line_numbers; /* from old lines to new ones; -1 for a line without points */
    batten_table_line *lines;
    batten_table_station *stations;
    batten_table_point *points; /* room for all; each station's begin where they began */
} selected;

/* 0 - x and not -x: the origin stays 0 and does not become -0. */
static double new_x(const selected *work, double x)
{
    return work->selection->scale * (work->selection->reverse ? 0 - x : x);
}

static double new_z(const selected *work, double z)
{
    return work->selection->scale * (work->selection->upside_down ? 0 - z : z);
}

static bool is_inside(batten_interval interval, double value)
{
    return interval.a <= value && value <= interval.b;
}

static batten_table_point moved_point(const selected *work, batten_table_point point)
{
    point.x = new_x(work, point.x);
    point.y *= work->selection->scale;
    point.z = new_z(work, point.z);
    return point;
}

static bool is_selected(const batten_offset_table_selection *selection,
                        const batten_table_point *point)
{
    return is_inside(selection->x, point->x) && is_inside(selection->y, point->y) &&
           is_inside(selection->z, point->z);
}

static int keep_points(const selected *work, const batten_table_station *station,
                       batten_table_point *kept)
{
    int count = 0;
    for (int i = 0; i < station->point_count; i++) {
        const batten_table_point point = moved_point(work, station->points[i]);
        const bool kept_line =
            point.line >= 0 ? work->is_kept[point.line] : work->selection->line_count == 0;
        if (kept_line && is_selected(work->selection, &point))
            kept[count++] = point;
    }
    return count;
}

/* Of the points on the centre line at the lower end leave the highest; return the new count. */
static int trim_centre(int count, batten_table_point *points)
{
    const bool upward = points[0].z <= points[count - 1].z;
    int run = 0;
    while (run < count && points[upward ? run : count - 1 - run].y == 0)
        run++;
    if (run < 2)
        return count;
    if (upward)
        memmove(points, points + run - 1, (size_t)(count - run + 1) * sizeof *points);
    return count - run + 1;
}

static void select_stations(const batten_offset_table *offsets, selected *work)
{
    const int n = offsets->station_count;
    for (int i = 0; i < n; i++) {
        batten_table_station station =
            offsets->stations[work->selection->reverse ? n - 1 - i : i];
        batten_table_point *kept = work->points + (station.points - offsets->points);
        station.x = new_x(work, station.x);
        station.point_count = keep_points(work, &station, kept);
        station.points = kept;
        if (station.point_count > 0 && work->selection->trim_centre)
            station.point_count = trim_centre(station.point_count, kept);
        if (station.point_count > 0)
            work->stations[work->station_count++] = station;
    }
}

/* The lines with a point that is kept get the number 0, the others -1. */
static void mark_lines(int line_count, selected *work)
{
    for (int i = 0; i < line_count; i++)
        work->line_numbers[i] = -1;
    for (int i = 0; i < work->station_count; i++)
        for (int j = 0; j < work->stations[i].point_count; j++)
            if (work->stations[i].points[j].line >= 0)
                work->line_numbers[work->stations[i].points[j].line] = 0;
}

/* Number the lines that still have a point. */
static void select_lines(const batten_offset_table *offsets, selected *work)
{
    mark_lines(offsets->line_count, work);
    for (int i = 0; i < offsets->line_count; i++)
        if (work->line_numbers[i] == 0) {
            work->lines[work->line_count] = offsets->lines[i];
            work->lines[work->line_count].z = new_z(work, offsets->lines[i].z);
            work->line_numbers[i] = work->line_count++;
        }
}

/* The names of the first lines, for a message. */
static void list_names(const batten_offset_table *offsets, size_t size, char *out)
{
    size_t used = 0;
    out[0] = 0;
    for (int k = 0; k < offsets->line_count && used < size; k++)
        used += (size_t)snprintf(out + used, size - used, "%s'%.30s'", k ? ", " : "",
                                 offsets->lines[k].name);
}

batten_status bat_offset_table_find_line(const batten_offset_table *offsets, const char *name,
                                         int *out)
{
    char names[200];
    for (int k = 0; k < offsets->line_count; k++)
        if (strcmp(offsets->lines[k].name, name) == 0) {
            *out = k;
            return BATTEN_OK;
        }
    list_names(offsets, sizeof names, names);
    return bat_fail(BATTEN_NOT_FOUND, "the table has no line '%.60s'; %s%s", name,
                    names[0] ? "its lines are " : "its points are on no lines", names);
}

static batten_status mark_kept(const batten_offset_table *offsets, selected *work)
{
    const int count = work->selection->line_count;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < offsets->line_count; i++)
        work->is_kept[i] = count == 0;
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        int line;
        status = bat_offset_table_find_line(offsets, work->selection->lines[k], &line);
        if (status == BATTEN_OK)
            work->is_kept[line] = true;
    }
    return status;
}

static batten_status select_into(const batten_offset_table *offsets, selected *work,
                                 batten_offset_table **out)
{
    const size_t point_count = bat_offset_table_points(offsets);
    const batten_status status = mark_kept(offsets, work);
    if (status != BATTEN_OK)
        return status;
    /* Places that no point comes to keep a zero: line 0, which is harmless below. */
    select_stations(offsets, work);
    if (work->station_count == 0)
        return bat_fail(BATTEN_NOT_FOUND, "none of the %zu points lies inside the selection",
                        point_count);
    select_lines(offsets, work);
    for (size_t i = 0; i < point_count && offsets->line_count > 0; i++)
        if (work->points[i].line >= 0)
            work->points[i].line = work->line_numbers[work->points[i].line];
    const double unit = work->selection->unit_metres;
    return batten_offset_table_create(unit == 0 ? offsets->unit_metres : unit, work->line_count,
                                      work->lines, work->station_count, work->stations, out);
}

batten_status batten_offset_table_select(const batten_offset_table *offsets,
                                         const batten_offset_table_selection *selection,
                                         batten_offset_table **out)
{
    batten_offset_table_selection chosen = batten_offset_table_everything();
    batten_status status = BAT_TAKE_OPTIONS(batten_offset_table_selection, selection, &chosen);
    if (status == BATTEN_OK)
        status = check_selection(&chosen);
    if (status != BATTEN_OK)
        return status;
    selected work = {.selection = &chosen};
    work.is_kept = bat_array((size_t)offsets->line_count, sizeof *work.is_kept);
    work.line_numbers = bat_array((size_t)offsets->line_count, sizeof *work.line_numbers);
    work.lines = bat_array((size_t)offsets->line_count, sizeof *work.lines);
    work.stations = bat_array((size_t)offsets->station_count, sizeof *work.stations);
    work.points = bat_array(bat_offset_table_points(offsets), sizeof *work.points);
    status = BATTEN_OUT_OF_MEMORY;
    if (work.is_kept && work.line_numbers && work.lines && work.stations && work.points)
        status = select_into(offsets, &work, out);
    bat_release(work.points);
    bat_release(work.stations);
    bat_release(work.lines);
    bat_release(work.line_numbers);
    bat_release(work.is_kept);
    return status;
}
