/* Objects of the model: what they are called and look like, and those that are left out. */
#include "exchange/step/read/import.h"

#include <string.h>

void bat_step_name_of(const bat_step_file *file, const bat_step_instance *instance,
                      char name[BAT_STEP_NAME])
{
    const bat_step_record *record = bat_step_as(file, instance, "REPRESENTATION_ITEM");
    if (!record)
        record = bat_step_first(file, instance);
    name[0] = '\0';
    if (bat_step_value_at(file, bat_step_argument(file, record, 0)).kind != BAT_STEP_STRING ||
        bat_step_get_string(file, record, 0, BAT_STEP_NAME, name) != BATTEN_OK)
        name[0] = '\0';
}

/* Curves take the colour of strokes, if there is one, other things that of fills. */
static void colour(batten_object *object, const bat_step_colours *look)
{
    const bool is_line =
        object->kind == BATTEN_OBJECT_CURVE || object->kind == BATTEN_OBJECT_POINTS;
    if (object->has_colour || !look || !(look->has_fill || is_line))
        return;
    object->has_colour = true;
    memcpy(object->colour, is_line && look->has_stroke ? look->stroke : look->fill,
           sizeof object->colour);
}

void bat_step_dress(const bat_step_target *target, int count,
                    const bat_step_instance *const *from, batten_object *object,
                    char name[BAT_STEP_NAME])
{
    const bat_step_styles *styles = &target->import->styles;
    name[0] = '\0';
    object->name = name;
    object->is_hidden = target->is_hidden;
    for (int k = 0; k < count; k++) {
        if (!from[k])
            continue;
        if (!name[0])
            bat_step_name_of(&target->import->file, from[k], name);
        if (!object->layer)
            object->layer = bat_step_layer_of(styles, from[k]);
        if (!object->group &&
            bat_step_group_of(&target->import->groups, from[k], target->import->path))
            object->group = target->import->path;
        object->is_hidden |= bat_step_is_hidden(styles, from[k]);
        colour(object, bat_step_colours_of(styles, from[k]));
    }
    if (!name[0])
        object->name = target->product;
}

batten_status bat_step_leave_item(const bat_step_target *target, const bat_step_instance *item,
                                  batten_status reason)
{
    return bat_step_leave_out(&target->import->file, &target->import->census, item, reason);
}

batten_status bat_step_add_object(const bat_step_target *target, const bat_step_instance *item,
                                  const batten_object *object)
{
    bat_step_import *import = target->import;
    char keyword[BAT_STEP_KEYWORD_SIZE];
    batten_status status = batten_model_add(target->model, object);
    if (status == BATTEN_OK)
        return bat_census_read(import->input, &import->census,
                               bat_step_keyword(&import->file, item, keyword));
    if (status != BATTEN_OUT_OF_MEMORY)
        status = bat_step_fail(&import->file, item, status, "%.300s", batten_message());
    return bat_step_leave_item(target, item, status);
}

batten_status bat_step_give_up(const bat_step_target *target, const bat_step_instance *item,
                               batten_status reason)
{
    bat_builder_end(&target->import->topology.builder);
    return bat_step_leave_item(target, item, reason);
}
