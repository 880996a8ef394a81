/* A model as an IGES file. */
#include "exchange/iges/write/writing.h"
#include "exchange/shapes/prepare.h"

#include <stdlib.h>
#include <string.h>

/* ---- objects ---- */

/* What was written belongs to the definition at work, or to its group. Groups of parts of
 * definitions are not written: other programs take them for what they hold, once more. */
static batten_status keep_entity(bat_iges_writing *w, const char *path, int id)
{
    if (w->is_inside)
        return bat_members_add(&w->items, "", id);
    return path[0] ? bat_members_add(&w->groups, path, id) : BATTEN_OK;
}

static batten_status write_curve(bat_iges_writing *w, const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_status status = bat_prepare_curve(object, &curve);
    if (status != BATTEN_OK)
        return status;
    const bat_iges_look look = bat_iges_look_of(w, object);
    const int id = bat_iges_put_curve(w, curve, bat_iges_put_name(w, object->name), look);
    batten_curve_unref(curve);
    return keep_entity(w, object->group, id);
}

static batten_status write_surface(bat_iges_writing *w, const batten_object *object)
{
    batten_surface *surface = NULL;
    batten_status status = bat_prepare_surface(object, w->tolerance, w->notes, &surface);
    if (status != BATTEN_OK)
        return status;
    const bat_iges_look look = bat_iges_look_of(w, object);
    const int id = bat_iges_put_surface(w, surface, bat_iges_put_name(w, object->name), look);
    batten_surface_unref(surface);
    return keep_entity(w, object->group, id);
}

static batten_status write_points(bat_iges_writing *w, const batten_object *object)
{
    const bat_iges_look look = bat_iges_look_of(w, object);
    const int id = bat_iges_put_points(w, object->points, object->point_count,
                                       bat_iges_put_name(w, object->name), look);
    return keep_entity(w, object->group, id);
}

/* ---- bodies ---- */

/* The group that the faces of a body become: its name within its own group. It is kept till the
 * end of the writing. */
static batten_status path_of_body(bat_iges_writing *w, const batten_object *object,
                                  const char **path)
{
    batten_text joined = BATTEN_TEXT;
    char **paths = bat_resize(w->paths, (size_t)w->path_count + 1, sizeof *paths);
    if (!paths)
        return BATTEN_OUT_OF_MEMORY;
    w->paths = paths;
    batten_text_add(&joined, "%s%s%s", object->group, object->group[0] ? "/" : "",
                    object->name[0] ? object->name : "body");
    const batten_status status = batten_text_take(&joined, &paths[w->path_count], NULL);
    if (status == BATTEN_OK)
        *path = paths[w->path_count++];
    return status;
}

/* "ship" for the only face of a body, "ship.3" for the third of several that has no name. */
static batten_status put_face_name(bat_iges_writing *w, const batten_object *object, int count,
                                   int f, int *name)
{
    const char *own = batten_body_view(object->body)->faces[f].name;
    batten_text text = BATTEN_TEXT;
    if (count == 1)
        batten_text_add(&text, "%s", object->name[0] ? object->name : own);
    else if (own[0] || !object->name[0])
        batten_text_add(&text, "%s", own);
    else
        batten_text_add(&text, "%s.%d", object->name, f + 1);
    *name = text.failed ? 0 : bat_iges_put_name(w, text.bytes);
    const batten_status status = text.failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
    batten_text_free(&text);
    return status;
}

static batten_status write_faces(bat_iges_writing *w, const batten_object *object,
                                 const batten_body_parts *parts, const char *group)
{
    batten_status status = BATTEN_OK;
    for (int f = 0; status == BATTEN_OK && f < parts->face_count; f++) {
        const batten_body_face *face = &parts->faces[f];
        batten_object coloured = *object;
        int name = 0, id = 0;
        if (face->has_colour) {
            coloured.has_colour = true;
            memcpy(coloured.colour, face->colour, sizeof face->colour);
        }
        const bat_iges_look look = bat_iges_look_of(w, &coloured);
        status = bat_iges_check_room(w);
        if (status == BATTEN_OK)
            status = put_face_name(w, object, parts->face_count, f, &name);
        if (status == BATTEN_OK)
            status = bat_iges_put_face(w, parts, f, name, &look, &id);
        if (status == BATTEN_OK)
            status = keep_entity(w, group, id);
    }
    return status;
}

/* Does it become several entities, also where solids are written? */
static bool is_many(const batten_body_parts *parts)
{
    return !parts->is_solid && parts->shell_count > 1;
}

typedef struct {
    bat_iges_writing *w;
    const char *group;
} keeping;

static batten_status keep_shell(void *context, int id)
{
    const keeping *k = context;
    return keep_entity(k->w, k->group, id);
}

static batten_status write_solid(bat_iges_writing *w, const batten_object *object,
                                 const batten_body_parts *parts, const char *group)
{
    const bat_iges_look look = bat_iges_look_of(w, object);
    keeping context = {w, group};
    return bat_iges_put_body(w, parts, object->name, &look, keep_shell, &context);
}

static void note_losses(bat_iges_writing *w, const batten_object *object)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    if (parts->face_count > 1 && !w->has_solids)
        batten_notes_add(w->notes, "", 0, object->name,
                         "its %d faces are written as trimmed surfaces, which do not share "
                         "their edges%s",
                         parts->face_count,
                         parts->is_solid ? "; that it is a solid is lost" : "");
    bat_iges_note_ends(w, parts, object->name);
}

static batten_status write_body(bat_iges_writing *w, const batten_object *object)
{
    batten_object traced = *object;
    batten_body *body = NULL;
    const char *group = object->group;
    batten_status status =
        bat_prepare_body(object, w->tolerance, w->unit_metres, w->notes, &body);
    if (status != BATTEN_OK)
        return status;
    traced.body = body;
    const batten_body_parts *parts = batten_body_view(body);
    const bool are_many = w->has_solids ? is_many(parts) : parts->face_count > 1;
    if (are_many && !w->is_inside)
        status = path_of_body(w, object, &group);
    if (status == BATTEN_OK)
        status = w->has_solids ? write_solid(w, &traced, parts, group)
                               : write_faces(w, &traced, parts, group);
    if (status == BATTEN_OK)
        note_losses(w, &traced);
    batten_body_unref(body);
    return status;
}

static batten_status write_instance(bat_iges_writing *w, const batten_object *object)
{
    const int subfigure =
        w->subfigures[bat_definitions_index(&w->definitions, object->definition)];
    const bat_iges_look look = bat_iges_look_of(w, object);
    const int id = bat_iges_put_instance(w, subfigure, &object->place,
                                         bat_iges_put_name(w, object->name), look);
    return keep_entity(w, object->group, id);
}

static batten_status write_object(bat_iges_writing *w, const batten_object *object)
{
    batten_status status = bat_iges_check_room(w);
    if (status != BATTEN_OK)
        return status;
    if (w->is_inside && object->group[0])
        batten_notes_add(w->notes, "", 0, object->name,
                         "its group is left out, as it lies in what is placed");
    switch (object->kind) {
    case BATTEN_OBJECT_INSTANCE:
        return write_instance(w, object);
    case BATTEN_OBJECT_CURVE:
        return write_curve(w, object);
    case BATTEN_OBJECT_SURFACE:
        return write_surface(w, object);
    case BATTEN_OBJECT_BODY:
        return write_body(w, object);
    default: /* points; what the format does not hold was taken out before */
        return write_points(w, object);
    }
}

/* ---- groups ---- */

/* The groups that are entered, with the ids of what is in each. */
typedef struct {
    bat_iges_writing *w;
    int names[BAT_GROUPS_DEEPEST];
    bat_members items[BAT_GROUPS_DEEPEST];
} open_groups;

static batten_status enter_group(void *context, int depth, const char *name)
{
    open_groups *open = context;
    open->names[depth] = bat_iges_put_name(open->w, name);
    open->items[depth].count = 0;
    return BATTEN_OK;
}

static batten_status take_items(void *context, int depth, const bat_member *members, int count)
{
    open_groups *open = context;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = bat_members_add(&open->items[depth], "", members[i].item);
    return status;
}

static batten_status leave_group(void *context, int depth)
{
    open_groups *open = context;
    bat_iges_writing *w = open->w;
    const bat_members *items = &open->items[depth];
    const int id = bat_iges_begin_entity(w, 402);
    bat_iges_put_integer(&w->data, items->count, ',');
    for (int i = 0; i < items->count; i++)
        bat_iges_put_integer(&w->data, items->members[i].item, ',');
    bat_iges_put_properties(w, open->names[depth]);
    bat_iges_end_entity(w, &(bat_iges_look){.type = 402, .form = 7, .use = 3});
    const batten_status status = bat_iges_check_room(w);
    return status == BATTEN_OK && depth > 0 ? bat_members_add(&open->items[depth - 1], "", id)
                                            : status;
}

static batten_status put_groups(bat_iges_writing *w)
{
    open_groups open = {.w = w};
    const batten_status status = bat_groups_visit(
        &w->groups, &(bat_group_visitor){&open, enter_group, take_items, leave_group});
    for (int i = 0; i < BAT_GROUPS_DEEPEST; i++)
        bat_members_end(&open.items[i]);
    return status;
}

/* ---- definitions ---- */

/* The objects of one model, and, unless it is the whole, the subfigure that they make. */
static batten_status write_definition(void *context, int index, const char *name)
{
    bat_iges_writing *w = context;
    const batten_model *model = w->definitions.models[index];
    batten_status status = BATTEN_OK;
    w->is_inside = index > 0;
    w->items.count = 0;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = write_object(w, batten_model_object(model, i));
    if (status == BATTEN_OK && w->is_inside && w->items.count > 0)
        w->subfigures[index] =
            bat_iges_put_subfigure(w, name, batten_model_depth(model), &w->items);
    return status;
}

static batten_status write_definitions(bat_iges_writing *w)
{
    w->subfigures = bat_array((size_t)w->definitions.count, sizeof *w->subfigures);
    return w->subfigures ? bat_definitions_each(&w->definitions, write_definition, w)
                         : BATTEN_OUT_OF_MEMORY;
}

/* ---- the file ---- */

/* A unit that IGES can say, into which the model is brought. */
static batten_status choose_unit(const batten_model *model, batten_notes *notes,
                                 batten_model **out)
{
    const double unit = batten_model_unit_metres(model);
    if (unit > 0 && bat_iges_flag_of_unit(unit) != 3) {
        *out = batten_model_ref(model);
        return BATTEN_OK;
    }
    batten_notes_add(notes, "", 0, "",
                     unit > 0 ? "IGES has no name for the unit; written in mm"
                              : "the model has no unit; written as mm");
    return batten_model_to_unit(model, 0.001, out);
}

static void end_writing(bat_iges_writing *w)
{
    for (int i = 0; i < w->path_count; i++)
        bat_release(w->paths[i]);
    bat_release(w->paths);
    bat_members_end(&w->groups);
    bat_members_end(&w->layers);
    bat_members_end(&w->items);
    bat_definitions_end(&w->definitions);
    bat_release(w->subfigures);
    batten_text_free(&w->directory);
}

static batten_status write_whole(const batten_model *model, const batten_write_options *options,
                                 batten_notes *notes, batten_text *text)
{
    const double unit = batten_model_unit_metres(model);
    bat_iges_writing w = {.notes = notes,
                          .unit_metres = unit,
                          .has_solids = options->solids,
                          .tolerance = options->tolerance > 0 ? options->tolerance
                                                              : BAT_WRITE_TOLERANCE / unit};
    bat_iges_section_begin(&w.data, 'P', text);
    bat_text_reserve(text, 100 * bat_count_points(model)); /* mostly enough */
    batten_status status = bat_definitions_find(model, &w.definitions);
    if (status == BATTEN_OK)
        status = bat_iges_put_layers(&w);
    if (status == BATTEN_OK)
        status = write_definitions(&w);
    if (status == BATTEN_OK)
        status = put_groups(&w);
    if (status == BATTEN_OK)
        status = bat_iges_join(&w, options, unit, text);
    end_writing(&w);
    return status;
}

batten_status bat_write_iges(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text)
{
    batten_model *scaled = NULL, *whole = NULL;
    batten_status status = choose_unit(model, notes, &scaled);
    if (status == BATTEN_OK)
        status = bat_iges_make_parts(scaled, options->solids, notes, &whole);
    if (status == BATTEN_OK)
        status = write_whole(whole, options, notes, text);
    batten_model_unref(scaled);
    batten_model_unref(whole);
    return status;
}
