/* Reads a table of offsets with a column for each station and a row for each line. */
#include "exchange/csv/columns.h"
#include "exchange/csv/csv.h"

#include <string.h>

/* The corner cell: "station\height" says rows\columns. */
typedef struct {
    bool rows_are_stations;
    double unit_metres;
} corner;

static bool is_along(bat_column column)
{
    return column.kind == BAT_COLUMN_X || column.kind == BAT_COLUMN_STATION;
}

static bool read_corner(const char *text, corner *out)
{
    char rows[64];
    const char *slash = strpbrk(text, "\\/");
    if (!slash || (size_t)(slash - text) >= sizeof rows)
        return false;
    memcpy(rows, text, (size_t)(slash - text));
    rows[slash - text] = '\0';
    const char *columns = slash + 1 + strspn(slash + 1, " ");
    for (size_t end = strlen(rows); end > 0 && rows[end - 1] == ' '; end--)
        rows[end - 1] = '\0';
    const bat_column row = bat_column_of(rows), column = bat_column_of(columns);
    out->rows_are_stations = is_along(row);
    out->unit_metres = column.unit_metres > 0 ? column.unit_metres : row.unit_metres;
    if (row.unit_metres > 0 && row.unit_metres != out->unit_metres)
        return false;
    return (is_along(row) && column.kind == BAT_COLUMN_Z) ||
           (row.kind == BAT_COLUMN_Z && is_along(column));
}

bool bat_is_matrix_corner(const char *text)
{
    corner unused;
    return read_corner(text, &unused);
}

/* The numbers of the first row, from its second field on. */
static batten_status read_heads(bat_separated *table, int count, double **heads)
{
    batten_status status = bat_input_array(table->input, (size_t)count, sizeof **heads, heads);
    for (int k = 1; status == BATTEN_OK && k < count; k++)
        status = bat_field_number(table, k, &(*heads)[k]);
    return status;
}

static batten_status read_row(bat_separated *table, bat_gathering *gathering, int row,
                              bool rows_are_stations, const double *heads, int count)
{
    double head = 0;
    batten_status status = bat_row_check(table, count);
    if (status == BATTEN_OK)
        status = bat_field_number(table, 0, &head);
    for (int k = 1; status == BATTEN_OK && k < count; k++) {
        bat_gathered point = {.station = rows_are_stations ? head : heads[k],
                              .z = rows_are_stations ? heads[k] : head,
                              .row = table->line,
                              .source = rows_are_stations ? row : k,
                              .is_absent = bat_field_is_absent(table, k)};
        point.x = point.station;
        if (!point.is_absent)
            status = bat_field_number(table, k, &point.y);
        if (status == BATTEN_OK)
            status = bat_gather_point(gathering, &point);
    }
    return status;
}

batten_status bat_offsets_matrix(bat_separated *table, bat_gathering *gathering)
{
    corner corner_cell = {false, 0};
    read_corner(table->fields[0].text, &corner_cell);
    gathering->by_height = true;
    gathering->unit_metres = corner_cell.unit_metres;

    const int count = bat_row_length(table);
    double *heads = NULL;
    bool more = true;
    batten_status status = read_heads(table, count, &heads);
    for (int row = 1; status == BATTEN_OK; row++) {
        status = bat_separated_next(table, &more);
        if (status != BATTEN_OK || !more)
            break;
        status = read_row(table, gathering, row, corner_cell.rows_are_stations, heads, count);
    }
    bat_release(heads);
    return status;
}
