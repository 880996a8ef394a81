/* Colours, layers, groups, and what is hidden. */
#include "base/list.h"
#include "exchange/step/write/writing.h"

#include <string.h>

batten_status bat_step_bag_add(bat_step_bag *bag, int id)
{
    return BAT_LIST_ADD(bag->ids, bag->count, bag->capacity, id);
}

/* ---- looks ---- */

static int put_fill(bat_step *step, int colour)
{
    int id = bat_step_add(step, "FILL_AREA_STYLE_COLOUR", "'',#%d", colour);
    id = bat_step_add(step, "FILL_AREA_STYLE", "'',(#%d)", id);
    id = bat_step_add(step, "SURFACE_STYLE_FILL_AREA", "#%d", id);
    id = bat_step_add(step, "SURFACE_SIDE_STYLE", "'',(#%d)", id);
    return bat_step_add(step, "SURFACE_STYLE_USAGE", ".BOTH.,#%d", id);
}

static int put_stroke(bat_step *step, int colour)
{
    const int font = bat_step_add(step, "DRAUGHTING_PRE_DEFINED_CURVE_FONT", "'continuous'");
    return bat_step_add(step, "CURVE_STYLE", "'',#%d,POSITIVE_LENGTH_MEASURE(0.1),#%d", font,
                        colour);
}

static int put_marker(bat_step *step, int colour)
{
    return bat_step_add(step, "POINT_STYLE",
                        "'',MARKER_TYPE(.DOT.),POSITIVE_LENGTH_MEASURE(1.),#%d", colour);
}

/* The PRESENTATION_STYLE_ASSIGNMENT of a colour: one that was written before, if it is among
 * the last. */
static int put_look(bat_step_writing *w, batten_object_kind kind, const double colour[3])
{
    bat_step *step = &w->step;
    for (int k = 0; k < w->look_count && k < BAT_STEP_LOOKS; k++)
        if (w->looks[k].kind == kind &&
            memcmp(w->looks[k].colour, colour, sizeof w->looks[k].colour) == 0)
            return w->looks[k].assignment;
    const int rgb = bat_step_open(step, "COLOUR_RGB");
    bat_step_token(step, "'',");
    for (int k = 0; k < 3; k++)
        bat_step_real(step, colour[k], k < 2 ? "," : "");
    bat_step_close(step);
    const int look = kind == BATTEN_OBJECT_CURVE    ? put_stroke(step, rgb)
                     : kind == BATTEN_OBJECT_POINTS ? put_marker(step, rgb)
                                                    : put_fill(step, rgb);
    bat_step_look *made = &w->looks[w->look_count++ % BAT_STEP_LOOKS];
    made->kind = kind;
    memcpy(made->colour, colour, sizeof made->colour);
    made->assignment = bat_step_add(step, "PRESENTATION_STYLE_ASSIGNMENT", "(#%d)", look);
    return made->assignment;
}

static bool note_bare(bat_step_writing *w)
{
    if (w->is_bare && !w->has_noted_bare)
        batten_notes_add(w->step.notes, "", 0, "",
                         "AP203 has no colours, layers, groups or hidden objects; left out");
    w->has_noted_bare |= w->is_bare;
    return w->is_bare;
}

static batten_status put_styled(bat_step_writing *w, int assignment, int item, int *styled)
{
    *styled = bat_step_add(&w->step, "STYLED_ITEM", "'',(#%d),#%d", assignment, item);
    return bat_step_bag_add(&w->styled, *styled);
}

/* The kinds that look alike have one name here. */
static batten_object_kind kind_of_look(batten_object_kind kind)
{
    return kind == BATTEN_OBJECT_CURVE || kind == BATTEN_OBJECT_POINTS ? kind
                                                                       : BATTEN_OBJECT_BODY;
}

batten_status bat_step_put_colour(bat_step_writing *w, batten_object_kind kind,
                                  const double colour[3], int item)
{
    int styled;
    return note_bare(w) ? BATTEN_OK
                        : put_styled(w, put_look(w, kind_of_look(kind), colour), item, &styled);
}

/* ---- marks ---- */

batten_status bat_step_mark(bat_step_writing *w, const batten_object *object, int item)
{
    batten_status status = BATTEN_OK;
    int styled = 0;
    const bool plain =
        !object->has_colour && !object->is_hidden && !object->layer[0] && !object->group[0];
    if (plain || note_bare(w))
        return BATTEN_OK;
    if (object->has_colour)
        status = put_styled(w, put_look(w, kind_of_look(object->kind), object->colour), item,
                            &styled);
    else if (object->is_hidden) /* only what has a style can be hidden */
        status = put_styled(
            w, bat_step_add(&w->step, "PRESENTATION_STYLE_ASSIGNMENT", "(NULL_STYLE(.NULL.))"),
            item, &styled);
    if (status == BATTEN_OK && object->is_hidden)
        status = bat_step_bag_add(&w->hidden, styled);
    if (status == BATTEN_OK && object->layer[0])
        status = bat_members_add(&w->layers, object->layer, item);
    if (status == BATTEN_OK && object->group[0])
        status = bat_members_add(&w->groups, object->group, item);
    return status;
}

static void put_members(bat_step *step, const bat_member *members, int count)
{
    for (int i = 0; i < count; i++)
        bat_step_id(step, members[i].item, i + 1 < count ? "," : ")");
}

static void put_layer(bat_step *step, const bat_member *members, int count)
{
    bat_step_open(step, "PRESENTATION_LAYER_ASSIGNMENT");
    bat_step_string(step, members->path, ",'',(");
    put_members(step, members, count);
    bat_step_close(step);
}

static void put_layers(bat_step_writing *w)
{
    const bat_members *list = &w->layers;
    bat_members_sort(&w->layers);
    for (int i = 0, count; i < list->count; i += count) {
        count = bat_members_same(list, i);
        put_layer(&w->step, &list->members[i], count);
    }
}

/* ---- groups ---- */

/* The groups that are entered. */
typedef struct {
    bat_step *step;
    int ids[BAT_GROUPS_DEEPEST];
} open_groups;

static batten_status enter_group(void *context, int depth, const char *name)
{
    open_groups *open = context;
    open->ids[depth] = bat_step_open(open->step, "GROUP");
    bat_step_string(open->step, name, ",''");
    bat_step_close(open->step);
    if (depth > 0)
        bat_step_add(open->step, "GROUP_RELATIONSHIP", "'','',#%d,#%d", open->ids[depth - 1],
                     open->ids[depth]);
    return BATTEN_OK;
}

static batten_status put_group_items(void *context, int depth, const bat_member *members,
                                     int count)
{
    open_groups *open = context;
    bat_step_open(open->step, "APPLIED_GROUP_ASSIGNMENT");
    bat_step_id(open->step, open->ids[depth], ",(");
    put_members(open->step, members, count);
    bat_step_close(open->step);
    return BATTEN_OK;
}

static batten_status leave_group(void *context, int depth)
{
    (void)context;
    (void)depth;
    return BATTEN_OK;
}

batten_status bat_step_put_marks(bat_step_writing *w)
{
    bat_step *step = &w->step;
    if (w->styled.count) {
        bat_step_open(step, "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION");
        bat_step_token(step, "'',(");
        bat_step_ids(step, w->styled.ids, w->styled.count, "),");
        bat_step_id(step, w->context, "");
        bat_step_close(step);
    }
    if (w->hidden.count) {
        bat_step_open(step, "INVISIBILITY");
        bat_step_token(step, "(");
        bat_step_ids(step, w->hidden.ids, w->hidden.count, ")");
        bat_step_close(step);
    }
    put_layers(w);
    open_groups open = {.step = step};
    return bat_groups_visit(
        &w->groups, &(bat_group_visitor){&open, enter_group, put_group_items, leave_group});
}
