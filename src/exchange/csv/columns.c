/* Headings of columns: which coordinate, and in which unit. */
#include "exchange/csv/columns.h"

#include <batten/model.h>
#include <string.h>

static const struct {
    const char *name;
    bat_column_kind kind;
    bool is_of_hull;
} names[] = {
    {"x", BAT_COLUMN_X, false},
    {"y", BAT_COLUMN_Y, false},
    {"half-breadth", BAT_COLUMN_Y, true},
    {"half-breadths", BAT_COLUMN_Y, true},
    {"halfbreadth", BAT_COLUMN_Y, true},
    {"half-width", BAT_COLUMN_Y, true},
    {"z", BAT_COLUMN_Z, false},
    {"height", BAT_COLUMN_Z, false},
    {"heights", BAT_COLUMN_Z, false},
    {"waterline", BAT_COLUMN_Z, true},
    {"waterlines", BAT_COLUMN_Z, true},
    {"station", BAT_COLUMN_STATION, true},
    {"stations", BAT_COLUMN_STATION, true},
    {"line", BAT_COLUMN_LINE, true},
    {"name", BAT_COLUMN_LINE, false},
    {"section", BAT_COLUMN_SECTION, true},
};

#define LONGEST 48

/* "Height (mm)" -> "height", "mm"; "z_m" -> "z", "m". Letters are made small, and '_' and
 * blanks become '-'. */
static void normalise(const char *text, char *name)
{
    size_t length = 0;
    for (; text[length] && length < LONGEST - 1; length++) {
        const char c = text[length];
        name[length] = c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
        if (c == '_' || c == ' ')
            name[length] = '-';
    }
    name[length] = '\0';
}

/* The unit in brackets at the end: "z [mm]", "z-(mm)". */
static double cut_brackets(char *name, char *open)
{
    name[strlen(name) - 1] = '\0';
    const double metres = batten_unit_metres(open + 1);
    *open = '\0';
    if (open[-1] == '-')
        open[-1] = '\0';
    return metres;
}

/* Cut the unit off a name and say it. */
static double cut_unit(char *name)
{
    const size_t length = strlen(name);
    char *open = strpbrk(name, "[(");
    char *last = strrchr(name, '-');
    if (open && open > name && length > 0 && strchr("])", name[length - 1]))
        return cut_brackets(name, open);
    const double metres = last ? batten_unit_metres(last + 1) : 0;
    if (metres > 0)
        *last = '\0';
    return metres;
}

static void find_kind(const char *name, bat_column *column)
{
    for (size_t k = 0; k < sizeof names / sizeof names[0]; k++)
        if (strcmp(name, names[k].name) == 0) {
            column->kind = names[k].kind;
            column->is_of_hull = names[k].is_of_hull;
        }
}

bat_column bat_column_of(const char *text)
{
    char name[LONGEST];
    normalise(text, name);
    bat_column column = {.kind = BAT_COLUMN_OTHER, .unit_metres = cut_unit(name)};
    find_kind(name, &column);
    column.is_letter = column.kind != BAT_COLUMN_OTHER && name[1] == '\0';
    return column;
}

static bool has_unit(bat_column_kind kind)
{
    return kind == BAT_COLUMN_X || kind == BAT_COLUMN_Y || kind == BAT_COLUMN_Z ||
           kind == BAT_COLUMN_STATION;
}

batten_status bat_columns_unit(const bat_separated *table, const bat_column *columns, int count,
                               double *unit_metres)
{
    double unit = 0;
    int said = 0, silent = 0;
    for (int k = 0; k < count; k++) {
        if (!has_unit(columns[k].kind))
            continue;
        const double own = columns[k].unit_metres;
        const char *text = table->fields[k].text;
        if (own == 0 && strpbrk(text, "[("))
            batten_notes_add(table->input->notes, table->input->file, table->line, "",
                             "unknown unit in '%.40s'", text);
        if (own > 0 && unit > 0 && own != unit)
            return bat_field_fail(table, k,
                                  "'%.40s' is in another unit than the columns before",
                                  table->fields[k].text);
        unit = own > 0 ? own : unit;
        said += own > 0;
        silent += own == 0;
    }
    if (said && silent)
        batten_notes_add(table->input->notes, table->input->file, table->line, "",
                         "only some columns give a unit; all are taken to be in %g m", unit);
    *unit_metres = unit;
    return BATTEN_OK;
}
