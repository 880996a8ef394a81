/* Decides which layout a table of offsets has, and reads it. */
#include "exchange/csv/columns.h"
#include "exchange/csv/csv.h"

static bat_offsets_dialect dialect_of(const bat_separated *table)
{
    bool along = false, breadth = false, height = false;
    for (int k = 0; k < table->count; k++) {
        const bat_column_kind kind = bat_column_of(table->fields[k].text).kind;
        along |= kind == BAT_COLUMN_X || kind == BAT_COLUMN_STATION;
        breadth |= kind == BAT_COLUMN_Y;
        height |= kind == BAT_COLUMN_Z;
    }
    if (along && breadth && height)
        return BAT_OFFSETS_LONG;
    if (table->count > 1 && bat_is_matrix_corner(table->fields[0].text))
        return BAT_OFFSETS_MATRIX;
    if (table->count > 1 && bat_same_word(table->fields[0].text, "axis") &&
        bat_same_word(table->fields[1].text, "name"))
        return BAT_OFFSETS_LOFT;
    if (table->count > 1 && (bat_same_word(table->fields[0].text, "stations") ||
                             bat_same_word(table->fields[0].text, "station")))
        return BAT_OFFSETS_LOFTING;
    return BAT_OFFSETS_NONE;
}

bool bat_is_offsets_header(const bat_separated *table)
{
    const bat_offsets_dialect dialect = dialect_of(table);
    bool is_of_hull = false;
    for (int k = 0; k < table->count; k++)
        is_of_hull |= bat_column_of(table->fields[k].text).is_of_hull;
    return dialect == BAT_OFFSETS_LONG ? is_of_hull : dialect != BAT_OFFSETS_NONE;
}

static batten_status read_table(bat_separated *table, bat_gathering *gathering)
{
    bool more = false;
    batten_status status = bat_separated_next(table, &more);
    if (status != BATTEN_OK)
        return status;
    switch (more ? dialect_of(table) : BAT_OFFSETS_NONE) {
    case BAT_OFFSETS_LONG:
        return bat_offsets_long(table, gathering);
    case BAT_OFFSETS_MATRIX:
        return bat_offsets_matrix(table, gathering);
    case BAT_OFFSETS_LOFT:
        return bat_offsets_loft(table, gathering);
    case BAT_OFFSETS_LOFTING:
        return bat_offsets_lofting(table, gathering);
    case BAT_OFFSETS_NONE:
        break;
    }
    return bat_input_fail(
        table->input, BATTEN_BAD_FORMAT, table->line,
        "no table of offsets: the first row must name columns for station, "
        "height and half-breadth, or begin with station\\height, axis,name or stations");
}

batten_status bat_read_offsets(bat_input *input, batten_model **out)
{
    bat_separated table;
    bat_gathering gathering;
    bat_separated_begin(&table, input);
    bat_gather_begin(&gathering, input);
    bool are_frames = false;
    batten_status status = bat_are_frames(input, &are_frames);
    if (status == BATTEN_OK)
        status =
            are_frames ? bat_offsets_frames(input, &gathering) : read_table(&table, &gathering);
    if (status == BATTEN_OK)
        status = bat_gather_finish(&gathering, out);
    if (status == BATTEN_OK && table.comments)
        batten_notes_remark(input->notes, input->file, 0, "",
                            "%d line%s comment%s, which no table keeps", table.comments,
                            table.comments == 1 ? " is a" : "s are",
                            table.comments == 1 ? "" : "s");
    bat_gather_end(&gathering);
    bat_separated_end(&table);
    return status;
}
