/* Tables of offsets: stations and named lines of points. */
#include "model/offset_table.h"
#include "base/plural.h"
#include <batten/text.h>

#include <string.h>

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
        return bat_fail(BATTEN_NOT_FINITE, "point %d of station \"%s\" is (%g, %g, %g)",
                        index + 1, text_of(station->name), point->x, point->y, point->z);
    if (point->line < -1 || point->line >= line_count)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "point %d of station \"%s\" is on line %d, but there %s %d line%s",
                        index + 1, text_of(station->name), point->line + 1,
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
        return bat_fail(BATTEN_NOT_FINITE, "station %d, \"%s\", stands at x = %g", index + 1,
                        name, station->x);
    if (index > 0 && station->x <= stations[index - 1].x)
        return bat_fail(
            BATTEN_NOT_INCREASING,
            "station %d, \"%s\", stands at x = %g, not beyond the one before, at %g", index + 1,
            name, station->x, stations[index - 1].x);
    if (station->point_count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "station %d, \"%s\", has %d point%s, and needs one", index + 1, name,
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
            status = bat_fail(BATTEN_NOT_FINITE, "line %d, \"%s\", has the height %g", i + 1,
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

size_t bat_offset_table_points(const batten_offset_table *offsets)
{
    const batten_table_station *last = &offsets->stations[offsets->station_count - 1];
    return (size_t)(last->points - offsets->points) + (size_t)last->point_count;
}

batten_box batten_offset_table_box(const batten_offset_table *offsets)
{
    const batten_table_point *first = offsets->points;
    batten_vec3 low = {first->x, first->y, first->z}, high = low;
    for (size_t i = 1; i < bat_offset_table_points(offsets); i++) {
        const batten_table_point *point = &offsets->points[i];
        low = (batten_vec3){bat_min(low.x, point->x), bat_min(low.y, point->y),
                            bat_min(low.z, point->z)};
        high = (batten_vec3){bat_max(high.x, point->x), bat_max(high.y, point->y),
                             bat_max(high.z, point->z)};
    }
    return (batten_box){low, high};
}

batten_station_label batten_offset_table_label(const batten_offset_table *offsets, int station)
{
    const batten_table_station *s = batten_offset_table_station(offsets, station);
    batten_station_label label;
    char name[60];
    double number;
    if (!*s->name ||
        (batten_number_read(s->name, strlen(s->name), &number, NULL) == BATTEN_OK &&
         number == s->x))
        batten_text_print(name, sizeof name, "%d", station + 1);
    else
        batten_text_print(name, sizeof name, "'%.40s'", s->name);
    batten_text_print(label.text, sizeof label.text, "station %s (x = %g)", name, s->x);
    return label;
}
