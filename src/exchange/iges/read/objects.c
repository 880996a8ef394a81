/* Adds what each entity stands for to the model, with its name, colour and layer. */
#include "exchange/iges/read/objects.h"
#include "base/plural.h"
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/levels.h"
#include "exchange/iges/read/references.h"

#include <stdio.h>
#include <string.h>

/* Count an entity as left out, and say why unless that is NULL. */
static batten_status leave_out(bat_iges_reading *reading, const bat_iges_entry *entry,
                               const char *why)
{
    if (why)
        bat_iges_note(reading, entry, "%.300s; left out", why);
    reading->input->left_out++;
    return bat_iges_count_left_out(reading, entry->type);
}

static batten_object_kind kind_of(const bat_iges_item *item)
{
    return item->curve        ? BATTEN_OBJECT_CURVE
           : item->surface    ? BATTEN_OBJECT_SURFACE
           : item->body       ? BATTEN_OBJECT_BODY
           : item->definition ? BATTEN_OBJECT_INSTANCE
                              : BATTEN_OBJECT_POINTS;
}

static batten_status add_object(bat_iges_item *item, batten_model *model)
{
    const bat_iges_entry *entry = item->entry;
    char *name = NULL, *group = NULL, *layer = NULL;
    bool has_colour = false;
    double rgb[3] = {0};
    batten_status status = bat_iges_name(item, &name);
    if (status == BATTEN_OK)
        status = bat_iges_group(item->reading, entry, &group);
    if (status == BATTEN_OK)
        status = bat_iges_layer(item->reading, entry, &layer);
    if (status == BATTEN_OK)
        status = bat_iges_colour(item->reading, entry, &has_colour, rgb);
    if (status == BATTEN_OK) {
        const batten_object object = {.name = name,
                                      .layer = layer,
                                      .has_colour = has_colour,
                                      .colour = {rgb[0], rgb[1], rgb[2]},
                                      .group = group,
                                      .is_hidden = entry->hidden != 0,
                                      .kind = kind_of(item),
                                      .curve = item->curve,
                                      .surface = item->surface,
                                      .body = item->body,
                                      .definition = item->definition,
                                      .place = item->place,
                                      .point_count = item->point_count,
                                      .points = item->points};
        status = batten_model_add(model, &object);
    }
    bat_release(layer);
    bat_release(group);
    bat_release(name);
    return status;
}

batten_status bat_iges_add(bat_iges_reading *reading, const bat_iges_entry *entry,
                           batten_model *model)
{
    bat_iges_item item;
    bat_iges_shape *shape = bat_iges_shape_of(reading, entry);
    if (bat_iges_row_of(reading, entry->type)->kind == BAT_IGES_PART)
        return leave_out(reading, entry, "it is not geometry by itself");
    if (shape->state == BAT_IGES_BUSY) {
        bat_fail(BATTEN_BAD_FORMAT, "it is a part of itself");
        return leave_out(reading, entry, batten_message());
    }
    const bat_iges_state before = shape->state;
    shape->state = BAT_IGES_BUSY;
    batten_status status = bat_iges_decode(reading, entry, &item);
    if (status == BATTEN_OK)
        status = add_object(&item, model);
    const char *name = item.row->name;
    bat_iges_close(&item);
    shape->state = before == BAT_IGES_READ ? before
                   : status == BATTEN_OK   ? BAT_IGES_READ
                                           : BAT_IGES_BAD;
    if (status == BATTEN_OK)
        return bat_census_read(reading->input, &reading->census, name);
    return bat_iges_is_fault_of_data(status) ? leave_out(reading, entry, batten_message())
                                             : status;
}

/* ---- roots ---- */

/* Is it the first that is left out for this? Drawings have thousands of such entities. */
static bool is_first_for(bat_iges_reading *reading, int reason)
{
    enum { MOST = sizeof reading->reasons / sizeof reading->reasons[0] };
    for (int k = 0; k < reading->reason_count; k++)
        if (reading->reasons[k] == reason)
            return false;
    if (reading->reason_count == MOST)
        return false;
    reading->reasons[reading->reason_count++] = reason;
    return true;
}

static batten_status leave_out_type(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    return leave_out(reading, entry,
                     is_first_for(reading, entry->type)
                         ? "entities of this type are not read; this is the first of them"
                         : NULL);
}

/* What the directory says that an entity of a drawing or of a definition is for. */
static batten_status leave_out_use(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    static const char *const uses[] = {"geometry",    "annotation",         "a definition",
                                       "other",       "logic and position", "parameters",
                                       "construction"};
    const bool is_known = entry->use < (int)(sizeof uses / sizeof uses[0]);
    if (is_first_for(reading, -1 - entry->use))
        bat_iges_note(reading, entry,
                      "its use is %d, %s, and not geometry; left out, the first such entity",
                      entry->use, is_known ? uses[entry->use] : "unknown");
    return leave_out(reading, entry, NULL);
}

/* Geometry that stands for itself; what a drawing or a definition needs is none. */
static batten_status add_root(bat_iges_reading *reading, size_t place)
{
    const bat_iges_entry *entry = bat_iges_entry_at(reading, place);
    const bat_iges_row *row = bat_iges_row_of(reading, entry->type);
    if (entry->is_broken)
        return leave_out(reading, entry, "its entry in the directory is damaged");
    if (row->kind == BAT_IGES_AUXILIARY || row->kind == BAT_IGES_PART ||
        reading->shapes[place].is_part || entry->use == 5)
        return BATTEN_OK;
    if (row->kind == BAT_IGES_UNKNOWN)
        return leave_out_type(reading, entry);
    /* Points are often called logical or positional where they are meant as they are. */
    if (entry->use != 0 && !(entry->use == 4 && row->kind == BAT_IGES_POINTS))
        return leave_out_use(reading, entry);
    reading->orphans += entry->subordinate == 1 || entry->subordinate == 3;
    return bat_iges_add(reading, entry, reading->model);
}

/* Can an entity be a part of itself, over others? */
static bool may_be_in_ring(const bat_iges_reading *reading, const bat_iges_entry *entry)
{
    const bat_iges_row *row = bat_iges_row_of(reading, entry->type);
    return !entry->is_broken && row->references &&
           (row->kind == BAT_IGES_CURVE || row->kind == BAT_IGES_SURFACE ||
            row->kind == BAT_IGES_BODY || row->kind == BAT_IGES_INSTANCE);
}

/* What is a part of something but was never reached: a ring of parts, say. */
static batten_status look_for_rings(bat_iges_reading *reading)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < reading->file.entries.count; k++) {
        const bat_iges_entry *entry = bat_iges_entry_at(reading, k);
        bat_iges_item item;
        if (!may_be_in_ring(reading, entry) || reading->shapes[k].state != BAT_IGES_NEW ||
            !reading->shapes[k].is_part || reading->shapes[k].is_met)
            continue;
        reading->shapes[k].state = BAT_IGES_BUSY;
        status = bat_iges_decode(reading, entry, &item);
        bat_iges_close(&item);
        reading->shapes[k].state = BAT_IGES_BAD;
        if (bat_iges_is_fault_of_data(status) && status == BATTEN_BAD_FORMAT)
            status = leave_out(reading, entry, batten_message());
        else if (bat_iges_is_fault_of_data(status))
            status = BATTEN_OK;
    }
    return status;
}

batten_status bat_iges_add_roots(bat_iges_reading *reading)
{
    bat_input *input = reading->input;
    const size_t count = reading->file.entries.count;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        if (k % 64 == 0)
            status = bat_input_step(input, k * input->size / count);
        if (status == BATTEN_OK)
            status = add_root(reading, k);
    }
    if (status == BATTEN_OK)
        status = look_for_rings(reading);
    return status;
}

/* The first entity with such a field, what is to be said of it, and of how many. */
static void note_odd(const bat_iges_reading *reading, const bat_iges_odd *odd,
                     const char *format, ...) BATTEN_PRINTF(3, 4);

static void note_odd(const bat_iges_reading *reading, const bat_iges_odd *odd,
                     const char *format, ...)
{
    char sentence[300], others[48] = "";
    if (odd->count == 0)
        return;
    va_list arguments;
    va_start(arguments, format);
    bat_format(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    if (odd->count > 1)
        snprintf(others, sizeof others, "; so of %d entities in all", odd->count);
    bat_iges_note(reading, odd->first, "%s%s", sentence, others);
}

static void note_fields(const bat_iges_reading *reading)
{
    const bat_iges_odd *colours = &reading->wrong_colours, *levels = &reading->wrong_levels,
                       *many = &reading->many_levels;
    note_odd(reading, colours, "its colour is %d: %s; taken as none", colours->value,
             colours->why);
    note_odd(reading, levels, "its level is %d: %s; taken as none", levels->value, levels->why);
    note_odd(reading, many, "it is on all levels that D%d lists; only the first is kept",
             many->value);
}

void bat_iges_note_oddities(const bat_iges_reading *reading)
{
    batten_notes *notes = reading->input->notes;
    const char *file = reading->input->file;
    note_fields(reading);
    if (reading->orphans)
        batten_notes_add(notes, file, 0, "",
                         "entities declared as parts of others to which nothing refers: %d; "
                         "read on their own",
                         reading->orphans);
    if (reading->swapped_loops)
        batten_notes_add(notes, file, 0, "",
                         "of %d face%s an inner loop comes before the outer one; put in order",
                         reading->swapped_loops, bat_plural(reading->swapped_loops));
    if (reading->turned_loops)
        batten_notes_add(notes, file, 0, "",
                         "%d loop%s of faces %s the wrong way around; turned",
                         reading->turned_loops, bat_plural(reading->turned_loops),
                         bat_one_or_many(reading->turned_loops, "runs", "run"));
    if (reading->gaps)
        batten_notes_add(notes, file, 0, "",
                         "edges of faces that start away from the end of the one before, by "
                         "%g at "
                         "most: %d; put together halfway",
                         reading->largest_gap, reading->gaps);
    if (reading->loose)
        batten_notes_add(notes, file, 0, "",
                         "bodies whose edges miss their surfaces by %g at most, more than the "
                         "resolution of the file, %g: %d; their tolerance is twice that",
                         reading->largest_miss, reading->resolution, reading->loose);
}
