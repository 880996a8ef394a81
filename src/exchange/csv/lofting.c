/* Reads the loftsman's table: heights on buttocks and half-breadths on waterlines, block by block. */
#include "exchange/csv/csv.h"

#include <batten/text.h>
#include <stdio.h>
#include <stdlib.h>

/*
 * After the names of the stations come blocks of rows, each begun by its title alone. A row whose
 * name is a length is a buttock in the block of heights, and a waterline in that of breadths:
 *
 *     Stations, Stem,  1,     2
 *     FORE-AFT POSITION
 *     Sheer,    0-0-0, 2-2-2, 3-6-3
 *     0-27-0,   1-6-5, 2-2-2, 3-6-3
 *     HEIGHT
 *     Sheer,    5-3-2, 5-0-3, 4-10-5
 *     0-9-0,    x,     3-3-6, 1-10-7
 *     BREADTH
 *     Sheer,    0-0-6, 1-6-7, 2-3-7
 *     0-27-0,   0-0-6, 0-4-1, 0-10-0
 *
 * Positions differ within a column at stem and post alone, which rake.
 */
typedef enum { NO_BLOCK, POSITIONS, HEIGHTS, BREADTHS, OTHERS } block;

static const struct {
    const char *name;
    block block;
} titles[] = {
    {"fore-aft position", POSITIONS},
    {"fore-aft positions", POSITIONS},
    {"position", POSITIONS},
    {"positions", POSITIONS},
    {"length", POSITIONS},
    {"lengths", POSITIONS},
    {"height", HEIGHTS},
    {"heights", HEIGHTS},
    {"breadth", BREADTHS},
    {"breadths", BREADTHS},
    {"half-breadth", BREADTHS},
    {"half-breadths", BREADTHS},
    {"width", BREADTHS},
    {"widths", BREADTHS},
};

typedef struct {
    block block;
    const char *name;
    bool has_length; /* the name is one */
    double length;
    double *values; /* [stations]; NaN where the row has no number */
    int line;
} lofted_row;

typedef struct {
    bat_separated *table;
    bat_gathering *gathering;
    int count;          /* stations */
    const char **names; /* [count] */
    double *x;          /* [count] */
    bat_list rows;      /* of lofted_row */
    bool has_feet;
    block block;
    int skipped; /* rows of blocks that are not read */
} lofting;

static batten_status read_stations(lofting *l)
{
    bat_input *input = l->table->input;
    l->count = bat_row_length(l->table) - 1;
    batten_status status =
        bat_input_array(input, (size_t)l->count, sizeof *l->names, &l->names);
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)l->count, sizeof *l->x, &l->x);
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        status = bat_gather_name(l->gathering, l->table->fields[1 + k].text, &l->names[k]);
    return status;
}

static block block_of(const char *title)
{
    for (size_t k = 0; k < sizeof titles / sizeof titles[0]; k++)
        if (bat_same_word(title, titles[k].name))
            return titles[k].block;
    return OTHERS;
}

static batten_status read_values(lofting *l, lofted_row *row)
{
    bat_separated *table = l->table;
    const char *name = table->fields[0].text;
    *row = (lofted_row){.block = l->block, .line = table->line};
    row->has_length = bat_read_feet(name, true, &row->length);
    l->has_feet |= row->has_length;
    batten_status status = BATTEN_OK;
    if (!row->has_length && bat_field_is_number(table, 0)) {
        row->has_length = true;
        status = bat_field_number(table, 0, &row->length);
    }
    if (status == BATTEN_OK)
        status = bat_gather_name(l->gathering, name, &row->name);
    if (status == BATTEN_OK)
        status =
            bat_input_array(table->input, (size_t)l->count, sizeof *row->values, &row->values);
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        status = bat_field_length(table, 1 + k, &l->has_feet, &row->values[k]);
    return status;
}

static batten_status add_row(lofting *l)
{
    bat_input *input = l->table->input;
    lofted_row row = {.values = NULL};
    batten_status status = bat_row_check(l->table, 1 + l->count);
    if (status == BATTEN_OK)
        status = bat_input_limit(input, l->table->line, (l->rows.count + 1) * (size_t)l->count,
                                 input->limits.points, "values in the table");
    if (status == BATTEN_OK)
        status = bat_input_limit(input, l->table->line, l->rows.count + 1, 1000, "rows");
    if (status == BATTEN_OK)
        status = read_values(l, &row);
    if (status == BATTEN_OK)
        status = bat_list_add(input, &l->rows, &row);
    if (status != BATTEN_OK)
        bat_release(row.values);
    return status;
}

static batten_status read_row(lofting *l)
{
    if (bat_row_length(l->table) == 1) {
        l->block = block_of(l->table->fields[0].text);
        return BATTEN_OK;
    }
    if (l->block == NO_BLOCK)
        return bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, l->table->line,
                              "a title such as HEIGHT or BREADTH must stand before this row");
    if (l->block != OTHERS)
        return add_row(l);
    l->skipped++;
    return BATTEN_OK;
}

/* ---- where stations and points are ---- */

static const lofted_row *find_row(const lofting *l, block of, const char *name)
{
    const lofted_row *rows = l->rows.items;
    for (size_t i = 0; i < l->rows.count; i++)
        if (rows[i].block == of && bat_same_word(rows[i].name, name))
            return &rows[i];
    return NULL;
}

/* A station stands where the first row of positions has it. */
static batten_status place_stations(lofting *l)
{
    const lofted_row *rows = l->rows.items;
    for (int k = 0; k < l->count; k++) {
        l->x[k] = (double)NAN;
        for (size_t i = 0; i < l->rows.count && isnan(l->x[k]); i++)
            if (rows[i].block == POSITIONS)
                l->x[k] = rows[i].values[k];
        if (isnan(l->x[k]))
            return bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, 0,
                                  "station '%.40s' has no position: a block FORE-AFT POSITION "
                                  "must say where it is",
                                  l->names[k]);
    }
    return BATTEN_OK;
}

/* The height of a row of positions at a station: its own, or that of the line of its name. */
static double height_of(const lofting *l, const lofted_row *row, int station)
{
    const lofted_row *named = find_row(l, HEIGHTS, row->name);
    return row->has_length ? row->length : named ? named->values[station] : (double)NAN;
}

/* The position at a height: between those of the rows next below and above. */
static double position_at(const lofting *l, int station, double z)
{
    const lofted_row *rows = l->rows.items;
    double below = -HUGE_VAL, above = HUGE_VAL, x_below = l->x[station],
           x_above = l->x[station];
    for (size_t i = 0; i < l->rows.count; i++) {
        const double x = rows[i].values[station];
        const double height =
            rows[i].block == POSITIONS ? height_of(l, &rows[i], station) : (double)NAN;
        if (isnan(x) || isnan(height))
            continue;
        if (height <= z && height > below) {
            below = height;
            x_below = x;
        }
        if (height >= z && height < above) {
            above = height;
            x_above = x;
        }
    }
    if (isinf(below) || isinf(above) || above == below)
        return isinf(below) ? x_above : x_below;
    return x_below + (z - below) / (above - below) * (x_above - x_below);
}

/* ---- points ---- */

/* The point of a row at a station; false where the table has none. */
static bool point_of(const lofting *l, const lofted_row *row, int station, bat_gathered *point)
{
    const lofted_row *breadth = row->has_length ? NULL : find_row(l, BREADTHS, row->name);
    const double value = row->values[station];
    if (row->has_length) {
        point->y = row->block == HEIGHTS ? row->length : value;
        point->z = row->block == HEIGHTS ? value : row->length;
    } else {
        point->y = breadth ? breadth->values[station] : (double)NAN;
        point->z = value;
    }
    if (isnan(point->y) || isnan(point->z))
        return false;
    const lofted_row *at = find_row(l, POSITIONS, row->name);
    const bool is_there = at && row->block == BREADTHS && !isnan(at->values[station]);
    point->x = is_there ? at->values[station] : position_at(l, station, point->z);
    return true;
}

static int compare_points(const void *a, const void *b)
{
    const bat_gathered *p = a, *q = b;
    if (p->z != q->z)
        return p->z < q->z ? -1 : 1;
    if (p->y != q->y)
        return p->y < q->y ? -1 : 1;
    return (p->row > q->row) - (p->row < q->row);
}

/* The name of the line of a buttock; a waterline is known by its height. */
static batten_status line_of(const lofting *l, const lofted_row *row, const char **line)
{
    char text[80];
    *line = row->name;
    if (!row->has_length)
        return BATTEN_OK;
    *line = NULL;
    snprintf(text, sizeof text, "buttock %.60s", row->name);
    return row->block == HEIGHTS ? bat_gather_name(l->gathering, text, line) : BATTEN_OK;
}

/* All points of a station from the keel up, which is their order along it. */
static batten_status gather_station(lofting *l, int station, const char *const *lines,
                                    bat_gathered *points)
{
    const lofted_row *rows = l->rows.items;
    batten_status status = BATTEN_OK;
    size_t count = 0;
    for (size_t i = 0; i < l->rows.count; i++) {
        bat_gathered point = {.station = l->x[station],
                              .station_name = l->names[station][0] ? l->names[station] : NULL,
                              .line = lines[i],
                              .row = rows[i].line,
                              .source = station + 1};
        const bool is_line =
            rows[i].block == HEIGHTS || (rows[i].block == BREADTHS && rows[i].has_length);
        if (is_line && point_of(l, &rows[i], station, &point))
            points[count++] = point;
    }
    if (count > 1)
        qsort(points, count, sizeof *points, compare_points);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_gather_point(l->gathering, &points[i]);
    return status;
}

static batten_status gather_points(lofting *l)
{
    bat_input *input = l->table->input;
    const lofted_row *rows = l->rows.items;
    const char **lines = NULL;
    bat_gathered *points = NULL;
    batten_status status = place_stations(l);
    if (status == BATTEN_OK)
        status = bat_input_array(input, l->rows.count + 1, sizeof *lines, &lines);
    if (status == BATTEN_OK)
        status = bat_input_array(input, l->rows.count + 1, sizeof *points, &points);
    for (size_t i = 0; status == BATTEN_OK && i < l->rows.count; i++)
        status = line_of(l, &rows[i], &lines[i]);
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        status = gather_station(l, k, lines, points);
    bat_release(points);
    bat_release(lines);
    return status;
}

/* At how many stations a named line has a value in this row and none in that of the other block. */
static int count_halves(const lofting *l, const lofted_row *row)
{
    const lofted_row *other =
        find_row(l, row->block == HEIGHTS ? BREADTHS : HEIGHTS, row->name);
    int count = 0;
    for (int k = 0; k < l->count; k++)
        count += !isnan(row->values[k]) && (!other || isnan(other->values[k]));
    return count;
}

/* What makes no points: half of what says where a line is, and rows of other blocks. */
static void note_left_out(const lofting *l)
{
    const lofted_row *rows = l->rows.items;
    bat_input *input = l->table->input;
    for (size_t i = 0; i < l->rows.count; i++) {
        const bool is_line = !rows[i].has_length && rows[i].block != POSITIONS;
        const int halves = is_line ? count_halves(l, &rows[i]) : 0;
        if (halves)
            batten_notes_add(input->notes, input->file, rows[i].line, rows[i].name,
                             "stations that have a %s and no %s: %d; these points are left out",
                             rows[i].block == HEIGHTS ? "height" : "breadth",
                             rows[i].block == HEIGHTS ? "breadth" : "height", halves);
    }
    if (l->skipped)
        batten_notes_add(
            input->notes, input->file, 0, "",
            "%d row%s of diagonals and other blocks left out: only positions, heights "
            "and breadths are read",
            l->skipped, l->skipped == 1 ? " is" : "s are");
}

batten_status bat_offsets_lofting(bat_separated *table, bat_gathering *gathering)
{
    lofting l = {.table = table, .gathering = gathering, .rows = {.size = sizeof(lofted_row)}};
    bool more = true;
    batten_status status = read_stations(&l);
    while (status == BATTEN_OK) {
        status = bat_separated_next(table, &more);
        if (status != BATTEN_OK || !more)
            break;
        status = read_row(&l);
    }
    gathering->as_listed = gathering->by_height = true;
    if (status == BATTEN_OK)
        status = gather_points(&l);
    if (status == BATTEN_OK)
        note_left_out(&l);
    gathering->unit_metres = l.has_feet ? 0.0254 : 0;
    lofted_row *rows = l.rows.items;
    for (size_t i = 0; i < l.rows.count; i++)
        bat_release(rows[i].values);
    bat_release(rows);
    bat_release(l.names);
    bat_release(l.x);
    return status;
}
