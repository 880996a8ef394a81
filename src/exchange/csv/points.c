/* Reads rows of coordinates as points. */
#include "exchange/csv/columns.h"
#include "exchange/csv/csv.h"

#include <stdio.h>
#include <string.h>

/* Where the coordinates stand, and what has been read. */
typedef struct {
    bat_separated table;
    int columns; /* fields of a row */
    int at[3];   /* the columns of x, y, z; z may be -1 */
    double unit_metres;
    bat_list points; /* of double[3] */
    bat_list starts; /* of size_t: where each object begins */
} reading;

static int axis_of(bat_column column)
{
    return !column.is_letter             ? -1
           : column.kind == BAT_COLUMN_X ? 0
           : column.kind == BAT_COLUMN_Y ? 1
                                         : 2;
}

bool bat_is_points_header(const bat_separated *table)
{
    const int count = bat_row_length(table);
    bool found[3] = {false, false, false};
    for (int k = 0; k < count; k++) {
        const int axis = axis_of(bat_column_of(table->fields[k].text));
        if (axis >= 0 && found[axis])
            return false;
        if (axis >= 0)
            found[axis] = true;
    }
    return found[0] && found[1];
}

/* The columns that are no coordinates: names of the first few, "" without a header. */
static void note_others(const reading *r, int others, const char *names)
{
    const bat_separated *table = &r->table;
    if (others > 0)
        batten_notes_add(table->input->notes, table->input->file, table->line, "",
                         "%d column%s left out%s%s: points have x, y and z", others,
                         others == 1 ? " is" : "s are", names[0] ? ", " : "", names);
}

static batten_status read_header(reading *r)
{
    const bat_separated *table = &r->table;
    bat_column columns[3];
    bat_separated letters = *table; /* the columns that are read, for their units */
    bat_field fields[3];
    char names[120] = "";
    int used = 0;
    r->columns = bat_row_length(table);
    for (int k = 0; k < r->columns; k++) {
        const bat_column column = bat_column_of(table->fields[k].text);
        const int axis = axis_of(column);
        if (axis >= 0) {
            columns[used] = column;
            fields[used++] = table->fields[k];
            r->at[axis] = k;
        } else if (strlen(names) < 60) {
            snprintf(names + strlen(names), sizeof names - strlen(names), "%s'%.40s'",
                     names[0] ? ", " : "", table->fields[k].text);
        }
    }
    letters.fields = fields;
    note_others(r, r->columns - used, names);
    return bat_columns_unit(&letters, columns, used, &r->unit_metres);
}

/* Without a header the first three columns are x, y and z. */
static batten_status read_shape(reading *r)
{
    const bat_separated *table = &r->table;
    r->columns = bat_row_length(table);
    if (r->columns < 2)
        return bat_input_fail(table->input, BATTEN_BAD_FORMAT, table->line,
                              "a point has 2 or 3 coordinates, not %d", r->columns);
    for (int k = 0; k < r->columns && k < 3; k++)
        r->at[k] = k;
    note_others(r, r->columns - 3, "");
    return BATTEN_OK;
}

static batten_status read_point(reading *r)
{
    double point[3] = {0, 0, 0};
    const bat_separated *table = &r->table;
    batten_status status = bat_row_check(table, r->columns);
    if (status == BATTEN_OK && (table->after_gap || r->points.count == 0)) {
        status = bat_input_limit(table->input, table->line, r->starts.count + 1,
                                 table->input->limits.entities, "objects");
        if (status == BATTEN_OK)
            status = bat_list_add(table->input, &r->starts, &r->points.count);
    }
    for (int axis = 0; status == BATTEN_OK && axis < 3; axis++)
        if (r->at[axis] >= 0)
            status = bat_field_number(table, r->at[axis], &point[axis]);
    if (status == BATTEN_OK)
        status = bat_input_limit(table->input, table->line, r->points.count + 1,
                                 table->input->limits.points, "points");
    if (status == BATTEN_OK)
        status = bat_list_add(table->input, &r->points, point);
    return status;
}

static batten_status read_rows(reading *r)
{
    bool more = false, first = true;
    batten_status status = bat_separated_next(&r->table, &more);
    for (; status == BATTEN_OK && more; first = false) {
        const bool header =
            first && !bat_field_is_number(&r->table, 0) && bat_is_points_header(&r->table);
        if (header)
            status = read_header(r);
        else if (first)
            status = read_shape(r);
        if (status == BATTEN_OK && !header)
            status = read_point(r);
        if (status == BATTEN_OK)
            status = bat_separated_next(&r->table, &more);
    }
    if (status == BATTEN_OK && r->points.count == 0)
        status = bat_input_fail(r->table.input, BATTEN_BAD_FORMAT, 0, "there is no point");
    return status;
}

static batten_status make_model(const reading *r, batten_model **out)
{
    const double(*points)[3] = r->points.items;
    const size_t *starts = r->starts.items, count = r->starts.count;
    batten_model *model = NULL;
    batten_status status = batten_model_create(r->unit_metres, &model);
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        char name[32] = "points";
        if (count > 1)
            snprintf(name, sizeof name, "points %zu", k + 1);
        const size_t end = k + 1 < count ? starts[k + 1] : r->points.count;
        const batten_object object = {.name = name,
                                      .kind = BATTEN_OBJECT_POINTS,
                                      .point_count = (int)(end - starts[k]),
                                      .points = points[starts[k]]};
        status = batten_model_add(model, &object);
    }
    return bat_input_hand_over(status, model, out);
}

batten_status bat_read_points(bat_input *input, batten_model **out)
{
    reading r = {.at = {-1, -1, -1},
                 .points = {.size = 3 * sizeof(double)},
                 .starts = {.size = sizeof(size_t)}};
    bat_separated_begin(&r.table, input);
    r.table.tabs_are_blanks = true;
    batten_status status = read_rows(&r);
    if (status == BATTEN_OK)
        status = make_model(&r, out);
    bat_separated_end(&r.table);
    bat_release(r.points.items);
    bat_release(r.starts.items);
    return status;
}
