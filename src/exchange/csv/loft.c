/* Reads a table of offsets in feet, inches and eighths, as lofts write it. */
#include "exchange/csv/csv.h"

#include <batten/text.h>

/*
 * The boat builder's table: after the names of the stations come blocks of rows, each begun by
 * a word in the first column, in which every row is one line:
 *
 *     axis,    name,    stem,  1,     2
 *     length,  station, 0,     24,    48
 *     heights, sheer,   2-8-6, 2-6-1, 2-3-5
 *     ,        chine,   1-2-0, 1-1-0, 0-11-1
 *     widths,  sheer,   0-0-7, 1-1-3, 1-11-0
 *
 * 2-8-6 is feet, inches and eighths of an inch. When it occurs, plain numbers are inches.
 */
typedef enum { NO_BLOCK, LENGTHS, HEIGHTS, WIDTHS, OTHERS } block;

static const struct {
    const char *name;
    block block;
} blocks[] = {
    {"length", LENGTHS},       {"lengths", LENGTHS},      {"station", LENGTHS},
    {"stations", LENGTHS},     {"height", HEIGHTS},       {"heights", HEIGHTS},
    {"width", WIDTHS},         {"widths", WIDTHS},        {"half-breadth", WIDTHS},
    {"half-breadths", WIDTHS}, {"half breadths", WIDTHS}, {"half-widths", WIDTHS},
};

/* One line of the hull; NaN where the table has none. */
typedef struct {
    const char *name;
    double *values[WIDTHS + 1]; /* [LENGTHS] is unused; NULL, or [count] */
    int row[WIDTHS + 1];        /* lines of the file */
} hull_line;

typedef struct {
    bat_separated *table;
    bat_gathering *gathering;
    int count;          /* stations */
    const char **names; /* [count] */
    double *x;          /* [count], NULL before the lengths */
    int x_row;
    bat_list lines; /* of hull_line */
    bool has_feet;
    block block;
} loft;

/* Two columns stand before those of the stations. */
#define FIRST_STATION 2

static batten_status read_names(loft *l)
{
    bat_separated *table = l->table;
    l->count = bat_row_length(table) - FIRST_STATION;
    if (l->count < 1)
        return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line,
                              "the first row names no station");
    batten_status status =
        bat_input_array(table->input, (size_t)l->count, sizeof *l->names, &l->names);
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        status =
            bat_gather_name(l->gathering, table->fields[FIRST_STATION + k].text, &l->names[k]);
    return status;
}

/* ---- values ---- */

static batten_status read_values(loft *l, double **values)
{
    bat_input *input = l->table->input;
    batten_status status =
        bat_input_limit(input, l->table->line, l->lines.count * (size_t)l->count,
                        input->limits.points, "values in the table");
    double *made = NULL;
    if (status == BATTEN_OK)
        status = bat_input_array(input, (size_t)l->count, sizeof *made, &made);
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        status = bat_field_length(l->table, FIRST_STATION + k, &l->has_feet, &made[k]);
    if (status == BATTEN_OK)
        *values = made;
    else
        bat_release(made);
    return status;
}

/* ---- rows ---- */

static void read_block(loft *l)
{
    const char *text = l->table->fields[0].text;
    if (text[0] == '\0')
        return;
    l->block = OTHERS;
    for (size_t k = 0; k < sizeof blocks / sizeof blocks[0]; k++)
        if (bat_same_word(text, blocks[k].name))
            l->block = blocks[k].block;
}

static batten_status read_lengths(loft *l)
{
    if (l->x)
        return bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, l->table->line,
                              "the lengths were given before, in line %d", l->x_row);
    batten_status status = read_values(l, &l->x);
    l->x_row = l->table->line;
    for (int k = 0; status == BATTEN_OK && k < l->count; k++)
        if (isnan(l->x[k]))
            status = bat_field_fail(l->table, FIRST_STATION + k,
                                    "station '%.40s' has no length", l->names[k]);
    return status;
}

/* The line of the current row's name, made when it is new. */
static batten_status find_line(loft *l, hull_line **line)
{
    const char *name = l->table->fields[1].text;
    hull_line *lines = l->lines.items, fresh = {.name = NULL};
    for (size_t i = 0; i < l->lines.count; i++)
        if (bat_same_word(lines[i].name, name)) {
            *line = &lines[i];
            return BATTEN_OK;
        }
    /* Each line is looked for among all: this keeps the work linear in the file. */
    batten_status status =
        bat_input_limit(l->table->input, l->table->line, l->lines.count + 1, 1000, "lines");
    if (status == BATTEN_OK)
        status = bat_gather_name(l->gathering, name, &fresh.name);
    if (status == BATTEN_OK)
        status = bat_list_add(l->table->input, &l->lines, &fresh);
    if (status == BATTEN_OK)
        *line = (hull_line *)l->lines.items + l->lines.count - 1;
    return status;
}

static batten_status read_line(loft *l)
{
    hull_line *line = NULL;
    if (!l->table->fields[1].text[0])
        return bat_field_fail(l->table, 1, "a line has no name");
    batten_status status = find_line(l, &line);
    if (status != BATTEN_OK)
        return status;
    if (line->values[l->block])
        return bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, l->table->line,
                              "line '%.40s' was given before, in line %d", line->name,
                              line->row[l->block]);
    line->row[l->block] = l->table->line;
    return read_values(l, &line->values[l->block]);
}

/* Angles of stations, diagonals and such are no points. */
static batten_status skip_row(const loft *l)
{
    const char *of = l->table->fields[0].text, *name = l->table->fields[1].text;
    batten_notes_add(
        l->table->input->notes, l->table->input->file, l->table->line, "",
        "the row '%.40s%s%.40s' is left out: only length, heights and widths are read", of,
        of[0] && name[0] ? ", " : "", name);
    return BATTEN_OK;
}

static batten_status read_row(loft *l)
{
    read_block(l);
    if (l->block == OTHERS ||
        (l->block == LENGTHS && l->x && bat_same_word(l->table->fields[1].text, "angle")))
        return skip_row(l);
    batten_status status = bat_row_check(l->table, FIRST_STATION + l->count);
    if (status == BATTEN_OK && l->block == NO_BLOCK)
        status = bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, l->table->line,
                                "the first column must be length, heights or widths here");
    if (status == BATTEN_OK)
        status = l->block == LENGTHS ? read_lengths(l) : read_line(l);
    return status;
}

/* ---- points ---- */

static void note_half(const loft *l, const hull_line *line, int station)
{
    const bool has_height = line->values[HEIGHTS] && !isnan(line->values[HEIGHTS][station]);
    batten_notes_add(
        l->table->input->notes, l->table->input->file, line->row[has_height ? HEIGHTS : WIDTHS],
        line->name, "station '%.40s' has a %s and no %s; the point is left out",
        l->names[station], has_height ? "height" : "width", has_height ? "width" : "height");
}

static batten_status gather_line(const loft *l, const hull_line *line)
{
    const double *heights = line->values[HEIGHTS], *widths = line->values[WIDTHS];
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < l->count; k++) {
        const double z = heights ? heights[k] : (double)NAN,
                     y = widths ? widths[k] : (double)NAN;
        bat_gathered point = {.station = l->x[k],
                              .x = l->x[k],
                              .y = y,
                              .z = z,
                              .station_name = l->names[k][0] ? l->names[k] : NULL,
                              .line = line->name,
                              .row = line->row[heights ? HEIGHTS : WIDTHS],
                              .source = k + 1,
                              .is_absent = isnan(y) || isnan(z)};
        if (isnan(y) != isnan(z))
            note_half(l, line, k);
        status = bat_gather_point(l->gathering, &point);
    }
    return status;
}

static batten_status gather_all(loft *l)
{
    const hull_line *lines = l->lines.items;
    if (!l->x)
        return bat_input_fail(l->table->input, BATTEN_BAD_FORMAT, 0,
                              "the table has no row of lengths");
    batten_status status = BATTEN_OK;
    for (size_t i = 0; status == BATTEN_OK && i < l->lines.count; i++)
        status = gather_line(l, &lines[i]);
    l->gathering->unit_metres = l->has_feet ? 0.0254 : 0;
    return status;
}

static void release(loft *l)
{
    hull_line *lines = l->lines.items;
    for (size_t i = 0; i < l->lines.count; i++) {
        bat_release(lines[i].values[HEIGHTS]);
        bat_release(lines[i].values[WIDTHS]);
    }
    bat_release(lines);
    bat_release(l->x);
    bat_release(l->names);
}

static batten_status read_rows(loft *l)
{
    bool more = true;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK) {
        status = bat_separated_next(l->table, &more);
        if (status != BATTEN_OK || !more)
            break;
        status = read_row(l);
    }
    return status;
}

batten_status bat_offsets_loft(bat_separated *table, bat_gathering *gathering)
{
    loft l = {.table = table, .gathering = gathering, .lines = {.size = sizeof(hull_line)}};
    batten_status status = read_names(&l);
    if (status == BATTEN_OK)
        status = read_rows(&l);
    if (status == BATTEN_OK)
        status = gather_all(&l);
    release(&l);
    return status;
}
