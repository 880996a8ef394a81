/* Colours, layers, groups, and what is hidden. */
#include "exchange/step/writing.h"

#include <stdlib.h>
#include <string.h>

batten_status bat_step_bag_add(bat_step_bag *bag, int id)
{
    if (bag->count == bag->capacity) {
        const int capacity = bat_max_int(16, 2 * bag->capacity);
        int *ids = bat_resize(bag->ids, (size_t)capacity, sizeof *ids);
        if (!ids)
            return BATTEN_OUT_OF_MEMORY;
        bag->ids = ids;
        bag->capacity = capacity;
    }
    bag->ids[bag->count++] = id;
    return BATTEN_OK;
}

static batten_status add_member(bat_step_members *list, const char *name, int item)
{
    if (list->count == list->capacity) {
        const int capacity = bat_max_int(16, 2 * list->capacity);
        bat_step_member *members = bat_resize(list->members, (size_t)capacity, sizeof *members);
        if (!members)
            return BATTEN_OUT_OF_MEMORY;
        list->members = members;
        list->capacity = capacity;
    }
    list->members[list->count++] = (bat_step_member){name, item};
    return BATTEN_OK;
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
                        "'',MARKER_TYPE(.POINT.),POSITIVE_LENGTH_MEASURE(1.),#%d", colour);
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
                         "AP203 has no colours, layers, groups and hidden objects; left out");
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
        status = add_member(&w->layers, object->layer, item);
    if (status == BATTEN_OK && object->group[0])
        status = add_member(&w->groups, object->group, item);
    return status;
}

/* By name, an outer group before those within it; then by item. */
static int compare_members(const void *a, const void *b)
{
    const bat_step_member *p = a, *q = b;
    const char *s = p->name, *t = q->name;
    while (*s && *s == *t) {
        s++;
        t++;
    }
    const int c = *s == '/' ? 1 : (unsigned char)*s, d = *t == '/' ? 1 : (unsigned char)*t;
    return c != d ? (c > d) - (c < d) : (p->item > q->item) - (p->item < q->item);
}

static void put_members(bat_step *step, const bat_step_member *members, int count)
{
    for (int i = 0; i < count; i++)
        bat_step_id(step, members[i].item, i + 1 < count ? "," : ")");
}

/* How many from the first on have its name. */
static int same_name(const bat_step_member *members, int count)
{
    int same = 1;
    while (same < count && strcmp(members[same].name, members[0].name) == 0)
        same++;
    return same;
}

static void put_layers(bat_step_writing *w)
{
    bat_step *step = &w->step;
    const bat_step_members *list = &w->layers;
    if (list->count)
        qsort(list->members, (size_t)list->count, sizeof *list->members, compare_members);
    for (int i = 0, count; i < list->count; i += count) {
        count = same_name(&list->members[i], list->count - i);
        bat_step_open(step, "PRESENTATION_LAYER_ASSIGNMENT");
        bat_step_string(step, list->members[i].name, ",'',(");
        put_members(step, &list->members[i], count);
        bat_step_close(step);
    }
}

/* ---- groups ---- */

enum { DEEPEST = 64 };

/* The groups that are open: where the name of each ends in the path, and its id. */
typedef struct {
    const char *path;
    size_t ends[DEEPEST];
    int ids[DEEPEST], depth;
} group_path;

/* Close the groups that the path does not lie in. */
static void leave_groups(group_path *open, const char *path)
{
    while (open->depth > 0) {
        const size_t end = open->ends[open->depth - 1];
        if (strncmp(open->path, path, end) == 0 && (path[end] == 0 || path[end] == '/'))
            return;
        open->depth--;
    }
}

/* Open those that it lies in; deeper than DEEPEST the rest of the path is one name. */
static batten_status enter_groups(bat_step *step, group_path *open, const char *path)
{
    size_t at = open->depth ? open->ends[open->depth - 1] : 0;
    batten_status status = BATTEN_OK;
    while (path[at] && open->depth < DEEPEST && status == BATTEN_OK) {
        const size_t from = at + (path[at] == '/');
        const size_t length =
            open->depth + 1 < DEEPEST ? strcspn(path + from, "/") : strlen(path + from);
        batten_text name = BATTEN_TEXT;
        batten_text_bytes(&name, path + from, length);
        status = name.failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
        const int id = bat_step_open(step, "GROUP");
        bat_step_string(step, name.bytes ? name.bytes : "", ",''");
        bat_step_close(step);
        batten_text_free(&name);
        if (open->depth)
            bat_step_add(step, "GROUP_RELATIONSHIP", "'','',#%d,#%d",
                         open->ids[open->depth - 1], id);
        at = from + length;
        open->ends[open->depth] = at;
        open->ids[open->depth++] = id;
    }
    open->path = path;
    return status;
}

static batten_status put_groups(bat_step_writing *w)
{
    bat_step *step = &w->step;
    const bat_step_members *list = &w->groups;
    group_path open = {.depth = 0};
    batten_status status = BATTEN_OK;
    if (list->count)
        qsort(list->members, (size_t)list->count, sizeof *list->members, compare_members);
    for (int i = 0, count; i < list->count && status == BATTEN_OK; i += count) {
        const char *path = list->members[i].name;
        count = same_name(&list->members[i], list->count - i);
        leave_groups(&open, path);
        status = enter_groups(step, &open, path);
        bat_step_open(step, "APPLIED_GROUP_ASSIGNMENT");
        bat_step_id(step, open.depth ? open.ids[open.depth - 1] : 0, ",(");
        put_members(step, &list->members[i], count);
        bat_step_close(step);
    }
    return status;
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
    return put_groups(w);
}
