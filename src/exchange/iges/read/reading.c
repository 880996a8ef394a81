#include "exchange/iges/read/reading.h"
#include "base/plural.h"
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/references.h"

#include <stdio.h>
#include <string.h>

bool bat_iges_is_fault_of_data(batten_status status)
{
    return status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY &&
           status != BATTEN_CANCELLED && status != BATTEN_INCOMPLETE &&
           status != BATTEN_TOO_LARGE;
}

double bat_iges_tolerance(const bat_iges_reading *reading, double size)
{
    /* The largest coordinate that the file names is believed when it may be true. */
    const double extent =
        reading->extent >= size && reading->extent <= 1e4 * size ? reading->extent : size;
    const double tolerance =
        bat_min(bat_max(reading->resolution, 1e-9 * extent), 1e-3 * extent);
    return tolerance > 0 && isfinite(tolerance) ? tolerance : 1e-9;
}

/* ---- what is said of an entity ---- */

enum { WHAT = BAT_IGES_TYPE_NAME + 16, SENTENCE = 400 };

static void say_what(const bat_iges_entry *entry, char what[WHAT])
{
    char name[BAT_IGES_TYPE_NAME];
    bat_iges_name_of_type(entry->type, name);
    snprintf(what, WHAT, "#%d %s", entry->id, name);
}

batten_status bat_iges_fault_in(batten_status status, int id)
{
    char said[140];
    if (!bat_iges_is_fault_of_data(status))
        return status;
    snprintf(said, sizeof said, "%.139s", batten_message());
    return bat_fail(status, "D%d: %s", id, said);
}

void bat_iges_count_odd(bat_iges_odd *odd, const bat_iges_entry *entry, int value)
{
    if (odd->count++)
        return;
    odd->first = entry;
    odd->value = value;
}

batten_status bat_iges_forgive(batten_status status, bat_iges_odd *odd,
                               const bat_iges_entry *entry, int value)
{
    if (!bat_iges_is_fault_of_data(status))
        return status;
    if (odd->count == 0)
        snprintf(odd->why, sizeof odd->why, "%.159s", batten_message());
    bat_iges_count_odd(odd, entry, value);
    return BATTEN_OK;
}

void bat_iges_note(const bat_iges_reading *reading, const bat_iges_entry *entry,
                   const char *format, ...)
{
    char what[WHAT], sentence[SENTENCE];
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    say_what(entry, what);
    batten_notes_add(reading->input->notes, reading->input->file, entry->line, what, "%s",
                     sentence);
}

void bat_iges_remark(const bat_iges_reading *reading, const bat_iges_entry *entry,
                     const char *format, ...)
{
    char what[WHAT], sentence[SENTENCE];
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    say_what(entry, what);
    batten_notes_remark(reading->input->notes, reading->input->file, entry->line, what, "%s",
                        sentence);
}

/* ---- opening and closing ---- */

/* The store of parameters of the next depth. */
static batten_status frame(bat_iges_reading *reading, bat_iges_parameters **out)
{
    const size_t depth = (size_t)reading->depth;
    bat_iges_parameters *made = NULL;
    if (depth == reading->frames.count) {
        batten_status status = bat_input_array(reading->input, 1, sizeof *made, &made);
        if (status != BATTEN_OK)
            return status;
        bat_iges_parameters_begin(made);
        status = bat_list_add(reading->input, &reading->frames, &made);
        if (status != BATTEN_OK) {
            bat_release(made);
            return status;
        }
    }
    *out = ((bat_iges_parameters **)reading->frames.items)[depth];
    return BATTEN_OK;
}

/* Say it once, however often the entity is opened. */
static void note_vanished(bat_iges_item *item)
{
    const bat_iges_parameters *parameters = item->parameters;
    bat_iges_shape *shape = bat_iges_shape_of(item->reading, item->entry);
    char shown[BAT_SHOWN_SIZE];
    bool is_string;
    if (parameters->vanished == 0 || shape->has_vanished)
        return;
    const bat_span text = bat_iges_text(parameters, parameters->vanished, &is_string);
    bat_iges_note(item->reading, item->entry,
                  "parameter %zu, %.40s, is too small for a double; read as 0",
                  parameters->vanished, bat_shown(text.bytes, text.length, shown));
    shape->has_vanished = true;
}

batten_status bat_iges_open(bat_iges_reading *reading, const bat_iges_entry *entry,
                            bat_iges_item *item)
{
    int type = 0;
    *item = (bat_iges_item){
        .reading = reading, .entry = entry, .row = bat_iges_row_of(entry->type)};
    if (reading->depth >= reading->input->limits.nesting)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "entities lie within entities more than %d deep, the limit",
                        reading->input->limits.nesting);
    bat_iges_parameters *parameters = NULL;
    batten_status status = frame(reading, &parameters);
    if (status != BATTEN_OK)
        return status;
    item->parameters = parameters;
    reading->depth++;
    status = bat_iges_read_parameters(&reading->file, entry, item->parameters);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 0, &type);
    if (status == BATTEN_OK && type != entry->type)
        status = bat_fail(BATTEN_BAD_FORMAT, "its parameters are those of type %d", type);
    if (status == BATTEN_OK)
        note_vanished(item);
    return status;
}

void bat_iges_close(bat_iges_item *item)
{
    if (item->parameters)
        item->reading->depth--;
    item->parameters = NULL;
    batten_curve_unref(item->curve);
    batten_surface_unref(item->surface);
    batten_body_unref(item->body);
    batten_model_unref(item->definition);
    bat_release(item->points);
    item->curve = NULL;
    item->surface = NULL;
    item->body = NULL;
    item->definition = NULL;
    item->points = NULL;
}

batten_status bat_iges_need(const bat_iges_item *item, size_t count)
{
    const size_t have = bat_iges_count_of(item->parameters);
    if (count <= have)
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_FORMAT, "%zu parameter%s, need %zu", have, bat_plural(have),
                    count);
}

batten_status bat_iges_reals_or_0(const bat_iges_item *item, size_t first, size_t count,
                                  double *values)
{
    const size_t have = bat_iges_count_of(item->parameters);
    if (have <= first)
        return bat_iges_need(item, first + count);
    if (have < first + count)
        bat_iges_remark(item->reading, item->entry,
                        "%zu parameter%s; those up to %zu are left out and taken as 0", have,
                        bat_plural(have), first + count);
    return bat_iges_reals(item->parameters, first, count, values);
}

batten_status bat_iges_real_array(bat_iges_item *item, size_t first, size_t count, double **out)
{
    double *values = NULL;
    batten_status status = bat_iges_need(item, first + count);
    if (status == BATTEN_OK)
        status = bat_input_array(item->reading->input, count, sizeof *values, &values);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, first, count, values);
    if (status != BATTEN_OK) {
        bat_release(values);
        return status;
    }
    *out = values;
    return BATTEN_OK;
}

batten_status bat_iges_read_count(const bat_iges_item *item, size_t index, size_t first,
                                  size_t width, int *count)
{
    const size_t have = bat_iges_count_of(item->parameters);
    int said = 0;
    batten_status status = bat_iges_integer(item->parameters, index, &said);
    if (status != BATTEN_OK)
        return status;
    if (said < 0)
        return bat_fail(BATTEN_BAD_FORMAT, "parameter %zu, a count, is %d", index, said);
    if (said > 0 && (have < first || (size_t)said > (have - first) / width))
        return bat_fail(BATTEN_BAD_FORMAT, "%zu parameter%s, need %zu", have, bat_plural(have),
                        first + width * (size_t)said);
    *count = said;
    return BATTEN_OK;
}

/* ---- decoding ---- */

static batten_status move_points(bat_iges_item *item, const batten_affine *map)
{
    for (int i = 0; i < item->point_count; i++) {
        double *p = &item->points[3 * i];
        const batten_vec3 q = batten_affine_apply(*map, (batten_vec3){p[0], p[1], p[2]});
        p[0] = q.x;
        p[1] = q.y;
        p[2] = q.z;
    }
    return BATTEN_OK;
}

/* Move what was made by the matrices of the entry; curves in parameters are not moved. */
static batten_status move(bat_iges_item *item)
{
    batten_affine map;
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    if (item->entry->transform == 0 || item->entry->use == 5)
        return BATTEN_OK;
    batten_status status = bat_iges_transform(item->reading, item->entry->transform, &map);
    if (status != BATTEN_OK)
        return status;
    if (item->curve)
        status = batten_curve_transform(item->curve, &map, &curve);
    else if (item->surface)
        status = batten_surface_transform(item->surface, &map, &surface);
    else if (item->body)
        status = batten_body_transform(item->body, &map, &body);
    else if (item->definition)
        item->place = batten_affine_compose(item->place, map);
    else
        status = move_points(item, &map);
    if (curve) {
        batten_curve_unref(item->curve);
        item->curve = curve;
    }
    if (surface) {
        batten_surface_unref(item->surface);
        item->surface = surface;
    }
    if (body) {
        batten_body_unref(item->body);
        item->body = body;
    }
    return status;
}

batten_status bat_iges_decode(bat_iges_reading *reading, const bat_iges_entry *entry,
                              bat_iges_item *item)
{
    batten_status status = bat_iges_open(reading, entry, item);
    if (status == BATTEN_OK && !item->row->read)
        status = bat_fail(BATTEN_UNSUPPORTED, "entities of this type are not read");
    /* The forms of curves and surfaces often say what the shape happens to be. */
    if (status == BATTEN_OK && (entry->form < item->row->low || entry->form > item->row->high))
        status = bat_fail(BATTEN_UNSUPPORTED, "its form %d is not read", entry->form);
    if (status == BATTEN_OK)
        status = item->row->read(item);
    return status == BATTEN_OK ? move(item) : status;
}

/* Decode a curve or surface that others refer to, once. */
static batten_status keep(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    bat_iges_shape *shape = bat_iges_shape_of(reading, entry);
    bat_iges_item item;
    if (shape->state == BAT_IGES_BUSY)
        return bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a part of itself", entry->id);
    if (shape->state == BAT_IGES_BAD)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which cannot be read",
                        entry->id);
    if (shape->state == BAT_IGES_READ)
        return BATTEN_OK;
    shape->state = BAT_IGES_BUSY;
    batten_status status = bat_iges_decode(reading, entry, &item);
    if (status == BATTEN_OK) {
        shape->curve = item.curve ? batten_curve_ref(item.curve) : NULL;
        shape->surface = item.surface ? batten_surface_ref(item.surface) : NULL;
        status = bat_census_read(reading->input, &reading->census, item.row->name);
    }
    bat_iges_close(&item);
    shape->state = status == BATTEN_OK ? BAT_IGES_READ : BAT_IGES_BAD;
    return status;
}

static batten_status refuse_kind(const bat_iges_entry *entry, bat_iges_kind kind)
{
    char name[BAT_IGES_TYPE_NAME];
    bat_iges_name_of_type(entry->type, name);
    return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d as a %s, which is a %s",
                    entry->id, kind == BAT_IGES_CURVE ? "curve" : "surface", name);
}

/* An entry of a kind, decoded. */
static batten_status keep_kind(bat_iges_reading *reading, int id, bat_iges_kind kind,
                               const bat_iges_shape **out)
{
    const bat_iges_entry *entry = NULL;
    batten_status status = bat_iges_find(reading, id, &entry);
    if (status != BATTEN_OK)
        return status;
    if (bat_iges_row_of(entry->type)->kind != kind)
        return refuse_kind(entry, kind);
    status = keep(reading, entry);
    if (status == BATTEN_OK)
        *out = bat_iges_shape_of(reading, entry);
    return status;
}

batten_status bat_iges_curve(bat_iges_reading *reading, int id, const batten_curve **out)
{
    const bat_iges_shape *shape = NULL;
    batten_status status = keep_kind(reading, id, BAT_IGES_CURVE, &shape);
    if (status == BATTEN_OK && !shape->curve)
        status = bat_fail(BATTEN_BAD_FORMAT, "entity D%d is points and no curve", id);
    if (status == BATTEN_OK)
        *out = shape->curve;
    return status;
}

batten_status bat_iges_surface(bat_iges_reading *reading, int id, const batten_surface **out)
{
    const bat_iges_shape *shape = NULL;
    batten_status status = keep_kind(reading, id, BAT_IGES_SURFACE, &shape);
    if (status == BATTEN_OK && !shape->surface)
        status = bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a face and no surface", id);
    if (status == BATTEN_OK)
        *out = shape->surface;
    return status;
}
