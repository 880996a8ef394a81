/* An entity opened: its parameters, and how they are read in many. */
#include "base/plural.h"
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/reading.h"
#include "exchange/iges/read/references.h"

#include <stdio.h>
#include <string.h>

double bat_iges_tolerance(const bat_iges_reading *reading, double size)
{
    /* The largest coordinate that the file names is believed when it may be true. */
    const double extent =
        reading->extent >= size && reading->extent <= 1e4 * size ? reading->extent : size;
    const double judged = bat_judged_accuracy(reading->resolution, extent, 1e-3, BAT_WRITTEN);
    const double tolerance = bat_max(judged, BAT_WRITTEN * extent);
    return tolerance > 0 && isfinite(tolerance) ? tolerance : BAT_WRITTEN;
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
        .reading = reading, .entry = entry, .row = bat_iges_row_of(reading, entry->type)};
    if (reading->depth >= reading->input->limits.nesting)
        return bat_fail(BATTEN_BAD_FORMAT, "entities are nested more than %d deep, the limit",
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
