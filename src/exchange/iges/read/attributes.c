/* Names (406 form 15 and labels), colours (314) and groups (402) of entities. */
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/references.h"

#include <stdio.h>
#include <string.h>

/* ---- names ---- */

static batten_status copy_text(bat_input *input, bat_span text, char **out)
{
    char *copied = NULL;
    batten_status status = bat_input_array(input, text.length + 1, 1, &copied);
    if (status != BATTEN_OK)
        return status;
    memcpy(copied, text.bytes, text.length);
    *out = copied;
    return BATTEN_OK;
}

batten_status bat_iges_call(bat_input *input, const bat_iges_parameters *parameters,
                            size_t index, batten_model *model)
{
    char *name = NULL;
    bool is_string = false;
    bat_span text = bat_iges_text(parameters, index, &is_string);
    while (text.length > 0 && text.bytes[text.length - 1] == ' ')
        text.length--;
    if (!is_string || text.length == 0)
        return BATTEN_OK;
    batten_status status = copy_text(input, text, &name);
    if (status == BATTEN_OK)
        status = batten_model_set_name(model, name);
    bat_release(name);
    return status;
}

/* The name of a property 406 form 15, copied; *name stays NULL when `id` is something else. */
static batten_status read_name_property(const bat_iges_item *owner, int id, char **name)
{
    bat_iges_reading *reading = owner->reading;
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    bool is_string = false;
    if (bat_iges_find(reading, id, &entry) != BATTEN_OK) {
        bat_iges_note(reading, owner->entry, "a property of it: %.300s", batten_message());
        return BATTEN_OK;
    }
    if (entry->type != 406 || entry->form != 15)
        return BATTEN_OK;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK) {
        const bat_span text = bat_iges_text(item.parameters, 2, &is_string);
        if (is_string && text.length > 0)
            status = copy_text(reading->input, text, name);
        else if (!is_string && text.length > 0)
            status = bat_fail(BATTEN_BAD_FORMAT, "parameter 2 is not a string");
    }
    bat_iges_close(&item);
    if (bat_iges_is_fault_of_data(status)) {
        bat_iges_note(reading, owner->entry, "its name, D%d, cannot be read: %.300s", id,
                      batten_message());
        return BATTEN_OK;
    }
    return status;
}

/* After the item's own parameters stand a count and as many associativities, then a count and
 * properties. */
static batten_status read_properties(bat_iges_item *item, char **name)
{
    const bat_iges_parameters *parameters = item->parameters;
    const size_t have = bat_iges_count_of(parameters);
    int count = 0, id = 0;
    size_t at = item->own;
    if (at >= have || bat_iges_integer(parameters, at, &count) != BATTEN_OK || count < 0)
        return BATTEN_OK;
    at += 1 + (size_t)count;
    if (at >= have || bat_iges_integer(parameters, at, &count) != BATTEN_OK || count < 1 ||
        (size_t)count > have - at - 1)
        return BATTEN_OK;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < count && !*name; k++)
        if (bat_iges_integer(parameters, at + 1 + (size_t)k, &id) == BATTEN_OK)
            status = read_name_property(item, id, name);
    return status;
}

/* The name of an entry that has no property for it: its label, or its kind and number. */
static void default_name(const bat_iges_item *item, char *name, size_t size)
{
    static const char *const words[] = {
        [BAT_IGES_AUXILIARY] = "group",   [BAT_IGES_PART] = "face",
        [BAT_IGES_POINTS] = "points",     [BAT_IGES_CURVE] = "curve",
        [BAT_IGES_SURFACE] = "surface",   [BAT_IGES_BODY] = "body",
        [BAT_IGES_INSTANCE] = "instance", [BAT_IGES_UNKNOWN] = "entity"};
    const bat_iges_entry *entry = item->entry;
    if (entry->label[0] && entry->subscript)
        snprintf(name, size, "%s %d", entry->label, entry->subscript);
    else if (entry->label[0])
        snprintf(name, size, "%s", entry->label);
    else
        snprintf(name, size, "%s D%d", words[item->row->kind], entry->id);
}

batten_status bat_iges_given_name(bat_iges_item *item, char **name)
{
    const char *label = item->entry->label;
    batten_status status = read_properties(item, name);
    if (status == BATTEN_OK && !*name && label[0])
        status = copy_text(item->reading->input, (bat_span){label, strlen(label)}, name);
    return status;
}

batten_status bat_iges_name(bat_iges_item *item, char **name)
{
    char plain[32], *found = NULL;
    batten_status status = read_properties(item, &found);
    if (status == BATTEN_OK && !found) {
        default_name(item, plain, sizeof plain);
        status = copy_text(item->reading->input, (bat_span){plain, strlen(plain)}, &found);
    }
    if (status == BATTEN_OK)
        *name = found;
    return status;
}

/* ---- colours ---- */

static batten_status read_percents(bat_iges_reading *reading, int id, double rgb[3])
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    double read[3] = {0};
    batten_status status = bat_iges_find_type(reading, id, 314, &entry);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item.parameters, 1, 3, read);
    bat_iges_close(&item);
    for (int k = 0; status == BATTEN_OK && k < 3; k++)
        if (!(read[k] >= 0 && read[k] <= 100))
            status = bat_fail(BATTEN_BAD_FORMAT, "part %d is %g percent", k + 1, read[k]);
    for (int k = 0; status == BATTEN_OK && k < 3; k++)
        rgb[k] = read[k] / 100;
    return bat_iges_fault_in(status, id);
}

batten_status bat_iges_colour(bat_iges_reading *reading, const bat_iges_entry *entry, bool *has,
                              double rgb[3])
{
    static const double named[9][3] = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1},
                                       {1, 1, 0}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};
    const int colour = entry->colour;
    batten_status status = BATTEN_OK;
    *has = false;
    if (colour < 0)
        status = read_percents(reading, -colour, rgb);
    else if (colour > 8)
        status = bat_fail(BATTEN_BAD_FORMAT, "colours have the numbers 0 to 8");
    else
        memcpy(rgb, named[colour], sizeof named[colour]);
    *has = status == BATTEN_OK && colour != 0;
    return bat_iges_forgive(status, &reading->wrong_colours, entry, colour);
}

/* ---- groups ---- */

typedef struct {
    size_t place; /* of its entry */
    char *name;
} group;

void bat_iges_start_groups(bat_iges_reading *reading)
{
    reading->groups = (bat_list){.size = sizeof(group)};
}

static bool is_group(const bat_iges_entry *entry)
{
    return entry->type == 402 && !entry->is_broken &&
           (entry->form == 1 || entry->form == 7 || entry->form == 14 || entry->form == 15);
}

/* Give its members their group; the first that claims one has it. */
static batten_status read_group(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    bat_iges_item item;
    group made = {.place = bat_iges_place_of(reading, entry)};
    int count = 0;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(&item, 1, 2, 1, &count);
    if (status == BATTEN_OK) {
        item.own = 2 + (size_t)count;
        status = bat_iges_name(&item, &made.name);
    }
    if (status == BATTEN_OK)
        status = bat_list_add(reading->input, &reading->groups, &made);
    if (status != BATTEN_OK)
        bat_release(made.name);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_iges_entry *member = NULL;
        int id = 0;
        if (bat_iges_integer(item.parameters, 2 + (size_t)k, &id) != BATTEN_OK ||
            bat_iges_find(reading, id, &member) != BATTEN_OK)
            bat_iges_note(reading, entry, "its member %d is left out: %.300s", k + 1,
                          batten_message());
        else if (member != entry && bat_iges_shape_of(reading, member)->group == 0)
            bat_iges_shape_of(reading, member)->group = (int)reading->groups.count;
    }
    if (status == BATTEN_BAD_FORMAT)
        bat_iges_note(reading, entry, "%.300s; it groups nothing", batten_message());
    bat_iges_close(&item);
    return bat_iges_is_fault_of_data(status) ? BATTEN_OK : status;
}

batten_status bat_iges_read_groups(bat_iges_reading *reading)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < reading->file.entries.count; k++)
        if (is_group(bat_iges_entry_at(reading, k)))
            status = read_group(reading, bat_iges_entry_at(reading, k));
    return status;
}

void bat_iges_end_groups(bat_iges_reading *reading)
{
    group *groups = reading->groups.items;
    for (size_t k = 0; k < reading->groups.count; k++)
        bat_release(groups[k].name);
    bat_release(reading->groups.items);
}

batten_status bat_iges_group(bat_iges_reading *reading, const bat_iges_entry *entry, char **out)
{
    const group *groups = reading->groups.items;
    const int first = bat_iges_shape_of(reading, entry)->group;
    size_t length = 0;
    int depth = 0;
    for (int g = first; g != 0; g = reading->shapes[groups[g - 1].place].group) {
        length += strlen(groups[g - 1].name) + 1;
        if (++depth > reading->input->limits.nesting ||
            length > reading->input->limits.string_bytes) {
            bat_iges_note(reading, entry,
                          "its groups contain one another in a ring, or more than %d deep; "
                          "taken as in none",
                          reading->input->limits.nesting);
            return copy_text(reading->input, (bat_span){"", 0}, out);
        }
    }
    char *path = NULL;
    batten_status status = bat_input_array(reading->input, length + 1, 1, &path);
    if (status != BATTEN_OK)
        return status;
    /* From the innermost at the end to the outermost at the beginning. */
    size_t at = length ? length - 1 : 0;
    for (int g = first; g != 0; g = reading->shapes[groups[g - 1].place].group) {
        const size_t name = strlen(groups[g - 1].name);
        at -= name;
        memcpy(path + at, groups[g - 1].name, name);
        if (at > 0)
            path[--at] = '/';
    }
    *out = path;
    return BATTEN_OK;
}
