/* Reads a table of offsets with one point in each row. */
#include "exchange/csv/columns.h"
#include "exchange/csv/csv.h"

#include <string.h>

/* Which column holds what; -1 for none. */
typedef struct {
    int count;
    int at[BAT_COLUMN_SECTION + 1];
} layout;

static batten_status read_header(bat_separated *table, layout *columns, double *unit_metres)
{
    bat_column *kinds = NULL;
    columns->count = bat_row_length(table);
    for (int kind = 0; kind <= BAT_COLUMN_SECTION; kind++)
        columns->at[kind] = -1;
    batten_status status =
        bat_input_array(table->input, (size_t)columns->count, sizeof *kinds, &kinds);
    for (int k = 0; status == BATTEN_OK && k < columns->count; k++) {
        const char *text = table->fields[k].text;
        kinds[k] = bat_column_of(text);
        const bat_column_kind kind = kinds[k].kind;
        if (kind == BAT_COLUMN_OTHER)
            batten_notes_add(table->input->notes, table->input->file, table->line, "",
                             "column '%.40s' is not read", text);
        else if (columns->at[kind] >= 0)
            status = bat_field_fail(table, k, "'%.40s' repeats '%.40s'", text,
                                    table->fields[columns->at[kind]].text);
        columns->at[kind] = k;
    }
    if (status == BATTEN_OK)
        status = bat_columns_unit(table, kinds, columns->count, unit_metres);
    bat_release(kinds);
    return status;
}

/* A name of a column, or NULL; neighbouring rows share one copy. */
static batten_status read_name(const bat_separated *table, bat_gathering *gathering, int column,
                               const char **name)
{
    const char *text = column >= 0 ? table->fields[column].text : "";
    if (text[0] == '\0')
        *name = NULL;
    else if (!*name || strcmp(*name, text) != 0)
        return bat_gather_name(gathering, text, name);
    return BATTEN_OK;
}

static batten_status read_numbers(const bat_separated *table, const layout *columns,
                                  bat_gathered *point)
{
    const int x = columns->at[BAT_COLUMN_X], station = columns->at[BAT_COLUMN_STATION];
    const int y = columns->at[BAT_COLUMN_Y], z = columns->at[BAT_COLUMN_Z];
    batten_status status = bat_field_number(table, x >= 0 ? x : station, &point->x);
    point->station = point->x;
    if (status == BATTEN_OK && x >= 0 && station >= 0)
        status = bat_field_number(table, station, &point->station);
    point->is_absent = bat_field_is_absent(table, y);
    if (status == BATTEN_OK && !point->is_absent)
        status = bat_field_number(table, y, &point->y);
    if (status == BATTEN_OK)
        status = bat_field_number(table, z, &point->z);
    return status;
}

batten_status bat_offsets_long(bat_separated *table, bat_gathering *gathering)
{
    layout columns;
    bat_gathered point = {.line = NULL};
    batten_status status = read_header(table, &columns, &gathering->unit_metres);
    bool more = true;
    gathering->by_height = columns.at[BAT_COLUMN_LINE] < 0;
    gathering->as_listed = !gathering->by_height;
    while (status == BATTEN_OK) {
        status = bat_separated_next(table, &more);
        if (status != BATTEN_OK || !more)
            break;
        point.row = table->line;
        status = bat_row_check(table, columns.count);
        if (status == BATTEN_OK)
            status = read_numbers(table, &columns, &point);
        if (status == BATTEN_OK)
            status = read_name(table, gathering, columns.at[BAT_COLUMN_LINE], &point.line);
        if (status == BATTEN_OK)
            status = read_name(table, gathering, columns.at[BAT_COLUMN_SECTION],
                               &point.station_name);
        if (status == BATTEN_OK)
            status = bat_gather_point(gathering, &point);
    }
    return status;
}
