/* Writes offsets, points and aerofoils as rows of text. */
#include "exchange/csv/csv.h"

#include <batten/text.h>
#include <string.h>

/* Curves count as the points they were made from, when they have them. */
static bool is_of_kind(const batten_object *object, batten_object_kind kind)
{
    return object->kind == kind || (kind == BATTEN_OBJECT_POINTS &&
                                    object->kind == BATTEN_OBJECT_CURVE && object->point_count);
}

/* A table counts as the points of its stations, where there may be several rows of points. */
static bool has_rows(const batten_object *object)
{
    return is_of_kind(object, BATTEN_OBJECT_POINTS) ||
           object->kind == BATTEN_OBJECT_OFFSET_TABLE;
}

/* A note for each object that a format with one kind of object cannot hold. */
static void note_left_out(const batten_model *model, batten_notes *notes,
                          batten_object_kind kind, bool only_first)
{
    bool first = true;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const bool rows = !only_first && kind == BATTEN_OBJECT_POINTS && has_rows(object);
        const bool fits = rows || (is_of_kind(object, kind) && (first || !only_first));
        first &= !is_of_kind(object, kind);
        if (fits && object->kind == BATTEN_OBJECT_CURVE)
            batten_notes_add(
                notes, "", 0, object->name,
                "the format has no curves; the points it was made from are written");
        if (!fits)
            batten_notes_add(notes, "", 0, object->name,
                             "left out: the format cannot hold this %s",
                             batten_object_kind_name(object->kind));
    }
}

static const batten_object *first_of_kind(const batten_model *model, batten_object_kind kind)
{
    for (int i = 0; i < batten_model_count(model); i++)
        if (is_of_kind(batten_model_object(model, i), kind))
            return batten_model_object(model, i);
    return NULL;
}

static batten_status nothing(const char *what)
{
    return bat_fail(BATTEN_NOT_COMPATIBLE, "the model has no %s to write", what);
}

/* "_mm"; "" without a unit. */
static void put_unit(batten_text *text, double metres)
{
    const char *name = metres > 0 ? batten_unit_name(metres) : NULL;
    if (name)
        batten_text_add(text, "_%s", name);
}

static void note_unit(double metres, batten_notes *notes)
{
    if (metres > 0 && !batten_unit_name(metres))
        batten_notes_add(notes, "", 0, "", "a unit of %g m has no name; it is not written",
                         metres);
}

/* ---- offsets ---- */

/* Which of the columns that are not always there the table needs. */
typedef struct {
    bool station, line, section;
} columns;

/* Is the point on the waterline of its height, under the name that reading would give it? */
static bool is_plain(const batten_offset_table *offsets, const batten_table_point *point)
{
    char name[BATTEN_NUMBER_SIZE + 2] = "z=";
    if (point->line < 0)
        return false;
    const batten_table_line *line = batten_offset_table_line(offsets, point->line);
    batten_number_write(point->z + 0.0, name + 2);
    return line->is_waterline && strcmp(line->name, name) == 0;
}

static void add_needs(columns *needed, const batten_offset_table *offsets,
                      const batten_table_station *station)
{
    char name[BATTEN_NUMBER_SIZE];
    batten_number_write(station->x + 0.0, name);
    needed->section |= station->name[0] && strcmp(station->name, name) != 0;
    for (int k = 0; k < station->point_count; k++) {
        needed->station |= station->points[k].x != station->x;
        needed->line |= !is_plain(offsets, &station->points[k]);
    }
}

static columns needed_columns(const batten_offset_table *offsets)
{
    columns needed = {false, false, false};
    for (int i = 0; i < batten_offset_table_station_count(offsets); i++)
        add_needs(&needed, offsets, batten_offset_table_station(offsets, i));
    return needed;
}

static void put_head(batten_text *text, columns needed, double unit)
{
    static const char *const names[] = {"station", "x", "z", "half_breadth"};
    for (int k = needed.station ? 0 : 1; k < 4; k++) {
        batten_text_add(text, "%s", names[k]);
        put_unit(text, unit);
        batten_text_add(text, "%s", k < 3 ? "," : "");
    }
    batten_text_add(text, "%s%s\n", needed.line ? ",line" : "",
                    needed.section ? ",section" : "");
}

static void put_point(batten_text *text, columns needed, const batten_offset_table *offsets,
                      const batten_table_station *station, const batten_table_point *point)
{
    if (needed.station) {
        batten_text_number(text, station->x);
        batten_text_bytes(text, ",", 1);
    }
    batten_text_number(text, point->x);
    batten_text_bytes(text, ",", 1);
    batten_text_number(text, point->z);
    batten_text_bytes(text, ",", 1);
    batten_text_number(text, point->y);
    if (needed.line) {
        batten_text_bytes(text, ",", 1);
        bat_put_quoted(
            text, point->line >= 0 ? batten_offset_table_line(offsets, point->line)->name : "");
    }
    if (needed.section) {
        batten_text_bytes(text, ",", 1);
        bat_put_quoted(text, station->name);
    }
    batten_text_bytes(text, "\n", 1);
}

batten_status bat_write_offsets(const batten_model *model, const batten_write_options *options,
                                batten_notes *notes, batten_text *text)
{
    const batten_object *object = first_of_kind(model, BATTEN_OBJECT_OFFSET_TABLE);
    if (!object)
        return nothing("table of offsets");
    if (options->eighths) {
        note_left_out(model, notes, BATTEN_OBJECT_OFFSET_TABLE, true);
        return bat_write_loft(object, batten_model_unit_metres(model), notes, text);
    }
    const batten_offset_table *offsets = object->offset_table;
    const double own = batten_offset_table_unit_metres(offsets);
    const double unit = own > 0 ? own : batten_model_unit_metres(model);
    const columns needed = needed_columns(offsets);
    note_left_out(model, notes, BATTEN_OBJECT_OFFSET_TABLE, true);
    note_unit(unit, notes);
    put_head(text, needed, unit);
    for (int i = 0; i < batten_offset_table_station_count(offsets); i++) {
        const batten_table_station *station = batten_offset_table_station(offsets, i);
        for (int k = 0; k < station->point_count; k++)
            put_point(text, needed, offsets, station, &station->points[k]);
    }
    return BATTEN_OK;
}

/* ---- points ---- */

static void put_coordinates(batten_text *text, const double *point, int count,
                            const char *separator)
{
    for (int k = 0; k < count; k++) {
        if (k > 0)
            batten_text_bytes(text, separator, 1);
        batten_text_number(text, point[k]);
    }
    batten_text_bytes(text, "\n", 1);
}

typedef struct {
    batten_text *text;
    const char *separator; /* of coordinates */
    double unit;           /* metres; 0: not stated */
    bool any;              /* rows so far: an empty line parts them */
} rows;

static void begin_row(rows *r)
{
    if (r->any)
        batten_text_bytes(r->text, "\n", 1);
    r->any = true;
}

static void put_row(rows *r, const batten_object *object)
{
    if (object->point_count == 0)
        return;
    begin_row(r);
    for (int k = 0; k < object->point_count; k++)
        put_coordinates(r->text, &object->points[3 * (size_t)k], 3, r->separator);
}

static void put_station(rows *r, const batten_table_station *station, double scale)
{
    begin_row(r);
    for (int k = 0; k < station->point_count; k++) {
        const batten_table_point *p = &station->points[k];
        const double point[3] = {scale * p->x, scale * p->y, scale * p->z};
        put_coordinates(r->text, point, 3, r->separator);
    }
}

/* The points of each station are a row. */
static void put_stations(rows *r, const batten_object *object, batten_notes *notes)
{
    const batten_offset_table *offsets = object->offset_table;
    const double own = batten_offset_table_unit_metres(offsets);
    const double scale = own > 0 && r->unit > 0 && own != r->unit ? own / r->unit : 1;
    for (int i = 0; i < batten_offset_table_station_count(offsets); i++)
        put_station(r, batten_offset_table_station(offsets, i), scale);
    batten_notes_remark(notes, "", 0, object->name,
                        "the format has no tables; its points are written, a row for each of "
                        "%d stations",
                        batten_offset_table_station_count(offsets));
}

static void put_points_head(const rows *r)
{
    const char *name = r->unit > 0 ? batten_unit_name(r->unit) : NULL;
    if (name)
        batten_text_add(r->text, "x_%s%sy_%s%sz_%s\n", name, r->separator, name, r->separator,
                        name);
}

/* The unit of the model; else that of its first table which has one. */
static double unit_of_points(const batten_model *model)
{
    double unit = batten_model_unit_metres(model);
    for (int i = 0; unit == 0 && i < batten_model_count(model); i++)
        if (batten_model_object(model, i)->kind == BATTEN_OBJECT_OFFSET_TABLE)
            unit = batten_offset_table_unit_metres(batten_model_object(model, i)->offset_table);
    return unit;
}

batten_status bat_write_points(const batten_model *model, const batten_write_options *options,
                               batten_notes *notes, batten_text *text)
{
    rows r = {text, options->commas ? "," : " ", unit_of_points(model), false};
    const int count = batten_model_count(model);
    int first = 0;
    while (first < count && !has_rows(batten_model_object(model, first)))
        first++;
    if (first == count)
        return nothing("points");
    note_left_out(model, notes, BATTEN_OBJECT_POINTS, false);
    note_unit(r.unit, notes);
    put_points_head(&r);
    for (int i = first; i < count; i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->kind == BATTEN_OBJECT_OFFSET_TABLE)
            put_stations(&r, object, notes);
        else if (has_rows(object))
            put_row(&r, object);
    }
    return BATTEN_OK;
}

/* ---- aerofoils ---- */

/* A name that could be taken for a byte order mark, a comment, points or nothing is not
 * written. */
static bool is_good_name(const char *name)
{
    static const char *const marks[] = {"\xef\xbb\xbf", "\xff\xfe", "\xfe\xff"};
    const char first = name[strspn(name, " \t\v\f")];
    for (size_t k = 0; k < sizeof marks / sizeof marks[0]; k++)
        if (strncmp(name, marks[k], strlen(marks[k])) == 0)
            return false;
    return first != '\0' && !strchr("#\"+-.0123456789", first) && !strpbrk(name, "\r\n");
}

batten_status bat_write_aerofoil(const batten_model *model, const batten_write_options *options,
                                 batten_notes *notes, batten_text *text)
{
    (void)options;
    const batten_object *object = first_of_kind(model, BATTEN_OBJECT_POINTS);
    if (!object || object->point_count < 3)
        return nothing("row of 3 points or more");
    const double *points = object->points;
    if (bat_are_aerofoil_counts(&points[0], &points[3]))
        return bat_fail(
            BATTEN_NOT_COMPATIBLE,
            "an aerofoil that begins with the point (%g, %g) would be taken for one "
            "that begins with counts",
            points[0], points[1]);
    bool flat = true;
    for (int k = 0; k < object->point_count; k++)
        flat &= points[3 * (size_t)k + 2] == 0;
    note_left_out(model, notes, BATTEN_OBJECT_POINTS, true);
    if (!flat)
        batten_notes_add(notes, "", 0, object->name, "the format has no z: it is not written");
    if (!is_good_name(object->name))
        batten_notes_add(notes, "", 0, object->name, "the format cannot hold this name");
    batten_text_add(text, "%s\n", is_good_name(object->name) ? object->name : "aerofoil");
    for (int k = 0; k < object->point_count; k++)
        put_coordinates(text, &points[3 * (size_t)k], 2, " ");
    return BATTEN_OK;
}
