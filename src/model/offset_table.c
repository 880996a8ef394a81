/* Tables of offsets: stations and named lines of points, and which of them are selected. */
#include "base/base.h"
#include "base/plural.h"
#include <batten/offset_table.h>

#include <string.h>

struct batten_offset_table {
    bat_references references;
    double unit_metres;
    int line_count, station_count;
    batten_table_line *lines;
    batten_table_station *stations;
    batten_table_point *points; /* of all stations, one after another */
    char *names;
};

/* ---- checks ---- */

static const char *text_of(const char *name)
{
    return name ? name : "";
}

static batten_status check_counts(double unit_metres, int line_count, int station_count)
{
    if (!isfinite(unit_metres))
        return bat_fail(BATTEN_NOT_FINITE, "the unit of the offsets is %g metres", unit_metres);
    if (unit_metres < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the unit of the offsets is %g metres, below 0",
                        unit_metres);
    if (line_count < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the offsets have %d line%s", line_count,
                        bat_plural(line_count));
    if (station_count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "the offsets have %d station%s, and need one",
                        station_count, bat_plural(station_count));
    return BATTEN_OK;
}

static batten_status check_point(const batten_table_station *station, int index, int line_count)
{
    const batten_table_point *point = &station->points[index];
    if (!isfinite(point->x) || !isfinite(point->y) || !isfinite(point->z))
        return bat_fail(BATTEN_NOT_FINITE, "point %d of station \"%s\" is (%g, %g, %g)", index,
                        text_of(station->name), point->x, point->y, point->z);
    if (point->line < -1 || point->line >= line_count)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "point %d of station \"%s\" is on line %d, but there %s %d line%s",
                        index, text_of(station->name), point->line,
                        bat_one_or_many(line_count, "is", "are"), line_count,
                        bat_plural(line_count));
    return BATTEN_OK;
}

static batten_status check_station(const batten_table_station *stations, int index,
                                   int line_count)
{
    const batten_table_station *station = &stations[index];
    const char *name = text_of(station->name);
    if (!isfinite(station->x))
        return bat_fail(BATTEN_NOT_FINITE, "station %d, \"%s\", stands at x = %g", index, name,
                        station->x);
    if (index > 0 && station->x <= stations[index - 1].x)
        return bat_fail(
            BATTEN_NOT_INCREASING,
            "station %d, \"%s\", stands at x = %g, not beyond the one before, at %g", index,
            name, station->x, stations[index - 1].x);
    if (station->point_count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "station %d, \"%s\", has %d point%s, and needs one", index, name,
                        station->point_count, bat_plural(station->point_count));
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < station->point_count; i++)
        status = check_point(station, i, line_count);
    return status;
}

static batten_status check_all(double unit_metres, int line_count,
                               const batten_table_line *lines, int station_count,
                               const batten_table_station *stations)
{
    batten_status status = check_counts(unit_metres, line_count, station_count);
    for (int i = 0; status == BATTEN_OK && i < line_count; i++)
        if (!isfinite(lines[i].z))
            status = bat_fail(BATTEN_NOT_FINITE, "line %d, \"%s\", has the height %g", i,
                              text_of(lines[i].name), lines[i].z);
    for (int i = 0; status == BATTEN_OK && i < station_count; i++)
        status = check_station(stations, i, line_count);
    return status;
}

/* ---- making, keeping ---- */

static void destroy(batten_offset_table *offsets)
{
    bat_release(offsets->lines);
    bat_release(offsets->stations);
    bat_release(offsets->points);
    bat_release(offsets->names);
    bat_release(offsets);
}

/* The arrays, of the sizes that these lines and stations need. */
static batten_status allocate(int line_count, const batten_table_line *lines, int station_count,
                              const batten_table_station *stations,
                              batten_offset_table *offsets)
{
    size_t characters = 0, points = 0;
    for (int i = 0; i < line_count; i++)
        characters += strlen(text_of(lines[i].name)) + 1;
    for (int i = 0; i < station_count; i++) {
        characters += strlen(text_of(stations[i].name)) + 1;
        points += (size_t)stations[i].point_count;
    }
    offsets->line_count = line_count;
    offsets->station_count = station_count;
    offsets->lines = bat_array((size_t)line_count, sizeof *offsets->lines);
    offsets->stations = bat_array((size_t)station_count, sizeof *offsets->stations);
    offsets->points = bat_array(points, sizeof *offsets->points);
    offsets->names = bat_array(characters, 1);
    return offsets->lines && offsets->stations && offsets->points && offsets->names
               ? BATTEN_OK
               : BATTEN_OUT_OF_MEMORY;
}

/* Copy a name to the place where the next one goes. */
static const char *keep_name(char **place, const char *name)
{
    char *kept = *place;
    const size_t size = strlen(text_of(name)) + 1;
    memcpy(kept, text_of(name), size);
    *place += size;
    return kept;
}

static void copy_points(const batten_table_line *lines, const batten_table_station *stations,
                        batten_offset_table *offsets)
{
    char *name = offsets->names;
    batten_table_point *point = offsets->points;
    for (int i = 0; i < offsets->line_count; i++) {
        offsets->lines[i] = lines[i];
        offsets->lines[i].name = keep_name(&name, lines[i].name);
    }
    for (int i = 0; i < offsets->station_count; i++) {
        offsets->stations[i] = stations[i];
        offsets->stations[i].name = keep_name(&name, stations[i].name);
        offsets->stations[i].points = point;
        memcpy(point, stations[i].points, (size_t)stations[i].point_count * sizeof *point);
        point += stations[i].point_count;
    }
}

batten_status batten_offset_table_create(double unit_metres, int line_count,
                                         const batten_table_line *lines, int station_count,
                                         const batten_table_station *stations,
                                         batten_offset_table **out)
{
    batten_status status = check_all(unit_metres, line_count, lines, station_count, stations);
    if (status != BATTEN_OK)
        return status;
    batten_offset_table *offsets = bat_array(1, sizeof *offsets);
    if (!offsets)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&offsets->references);
    offsets->unit_metres = unit_metres;
    status = allocate(line_count, lines, station_count, stations, offsets);
    if (status != BATTEN_OK) {
        destroy(offsets);
        return status;
    }
    copy_points(lines, stations, offsets);
    *out = offsets;
    return BATTEN_OK;
}

batten_offset_table *batten_offset_table_ref(const batten_offset_table *offsets)
{
    /* The count may change where the value may not. */
    union {
        const batten_offset_table *borrowed;
        batten_offset_table *owned;
    } both = {offsets};
    bat_references_add(&both.owned->references);
    return both.owned;
}

void batten_offset_table_unref(batten_offset_table *offsets)
{
    if (offsets && bat_references_drop(&offsets->references))
        destroy(offsets);
}

/* ---- properties ---- */

double batten_offset_table_unit_metres(const batten_offset_table *offsets)
{
    return offsets->unit_metres;
}

int batten_offset_table_line_count(const batten_offset_table *offsets)
{
    return offsets->line_count;
}

const batten_table_line *batten_offset_table_line(const batten_offset_table *offsets, int line)
{
    assert(line >= 0 && line < offsets->line_count);
    return &offsets->lines[line];
}

int batten_offset_table_station_count(const batten_offset_table *offsets)
{
    return offsets->station_count;
}

const batten_table_station *batten_offset_table_station(const batten_offset_table *offsets,
                                                        int station)
{
    assert(station >= 0 && station < offsets->station_count);
    return &offsets->stations[station];
}

static size_t all_points(const batten_offset_table *offsets)
{
    const batten_table_station *last = &offsets->stations[offsets->station_count - 1];
    return (size_t)(last->points - offsets->points) + (size_t)last->point_count;
}

batten_box batten_offset_table_box(const batten_offset_table *offsets)
{
    const batten_table_point *first = offsets->points;
    batten_vec3 low = {first->x, first->y, first->z}, high = low;
    for (size_t i = 1; i < all_points(offsets); i++) {
        const batten_table_point *point = &offsets->points[i];
        low = (batten_vec3){bat_min(low.x, point->x), bat_min(low.y, point->y),
                            bat_min(low.z, point->z)};
        high = (batten_vec3){bat_max(high.x, point->x), bat_max(high.y, point->y),
                             bat_max(high.z, point->z)};
    }
    return (batten_box){low, high};
}

/* ---- selecting ---- */

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
    return status;
}

/* What is on its way from the old table to the new one. */
typedef struct {
    const batten_offset_table_selection *selection;
    int line_count, station_count;
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

static int keep_points(const selected *work, const batten_table_station *station,
                       batten_table_point *kept)
{
    int count = 0;
    for (int i = 0; i < station->point_count; i++) {
        batten_table_point point = station->points[i];
        point.x = new_x(work, point.x);
        point.y *= work->selection->scale;
        point.z = new_z(work, point.z);
        if (is_inside(work->selection->x, point.x) && is_inside(work->selection->y, point.y) &&
            is_inside(work->selection->z, point.z))
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

/* Number the lines that still have a point. */
static void select_lines(const batten_offset_table *offsets, selected *work)
{
    for (int i = 0; i < offsets->line_count; i++)
        work->line_numbers[i] = -1;
    for (int i = 0; i < work->station_count; i++)
        for (int j = 0; j < work->stations[i].point_count; j++)
            if (work->stations[i].points[j].line >= 0)
                work->line_numbers[work->stations[i].points[j].line] = 0;
    for (int i = 0; i < offsets->line_count; i++)
        if (work->line_numbers[i] == 0) {
            work->lines[work->line_count] = offsets->lines[i];
            work->lines[work->line_count].z = new_z(work, offsets->lines[i].z);
            work->line_numbers[i] = work->line_count++;
        }
}

static batten_status select_into(const batten_offset_table *offsets, selected *work,
                                 batten_offset_table **out)
{
    const size_t point_count = all_points(offsets);
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
    work.line_numbers = bat_array((size_t)offsets->line_count, sizeof *work.line_numbers);
    work.lines = bat_array((size_t)offsets->line_count, sizeof *work.lines);
    work.stations = bat_array((size_t)offsets->station_count, sizeof *work.stations);
    work.points = bat_array(all_points(offsets), sizeof *work.points);
    status = BATTEN_OUT_OF_MEMORY;
    if (work.line_numbers && work.lines && work.stations && work.points)
        status = select_into(offsets, &work, out);
    bat_release(work.points);
    bat_release(work.stations);
    bat_release(work.lines);
    bat_release(work.line_numbers);
    return status;
}
