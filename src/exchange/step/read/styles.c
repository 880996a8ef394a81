/* Collects colours, layers and invisible items from presentation styles. */
#include "exchange/step/read/styles.h"
#include "exchange/step/read/marks.h"

#include <string.h>

typedef struct {
    uint32_t item, styled; /* instances */
    bool overrides;
    bat_step_colours look;
} look_row;

typedef struct {
    uint32_t item, layer, order; /* the layer by its place in the list */
} member_row;

typedef struct {
    uint32_t instance;
    char name[256];
} layer_row;

void bat_step_styles_begin(const bat_step_file *file, bat_step_styles *styles)
{
    *styles = (bat_step_styles){.file = file,
                                .looks = {.size = sizeof(look_row)},
                                .members = {.size = sizeof(member_row)},
                                .layers = {.size = sizeof(layer_row)},
                                .hidden = {.size = sizeof(uint32_t)}};
}

void bat_step_styles_end(bat_step_styles *styles)
{
    bat_release(styles->looks.items);
    bat_release(styles->members.items);
    bat_release(styles->layers.items);
    bat_release(styles->hidden.items);
}

/* ---- colours ---- */

static bool named_colour(const char *name, double rgb[3])
{
    static const struct {
        const char *name;
        double rgb[3];
    } colours[] = {{"black", {0, 0, 0}}, {"red", {1, 0, 0}},    {"green", {0, 1, 0}},
                   {"blue", {0, 0, 1}},  {"yellow", {1, 1, 0}}, {"magenta", {1, 0, 1}},
                   {"cyan", {0, 1, 1}},  {"white", {1, 1, 1}}};
    for (size_t k = 0; k < sizeof colours / sizeof colours[0]; k++)
        if (strcmp(name, colours[k].name) == 0) {
            memcpy(rgb, colours[k].rgb, sizeof colours[k].rgb);
            return true;
        }
    return false;
}

/* COLOUR_RGB or one of the named. */
static bool read_colour(const bat_step_file *file, const bat_step_instance *instance,
                        double rgb[3])
{
    const bat_step_record *record = bat_step_as(file, instance, "COLOUR_RGB");
    char name[32] = "";
    bool clamped = false;
    if (!record) {
        record = bat_step_as(file, instance, "DRAUGHTING_PRE_DEFINED_COLOUR");
        if (!record)
            record = bat_step_as(file, instance, "PRE_DEFINED_COLOUR");
        return record && bat_step_get_string(file, record, 0, sizeof name, name) == BATTEN_OK &&
               named_colour(name, rgb);
    }
    for (int k = 0; k < 3; k++) {
        double part = 0;
        if (bat_step_get_real(file, record, k + 1, &part) != BATTEN_OK)
            return false;
        clamped |= !(part >= 0 && part <= 1);
        rgb[k] = bat_max(0, bat_min(1, part));
    }
    if (clamped)
        bat_step_warn(file, instance, "parts of the colour are not in 0..1; cut to that");
    return true;
}

/* What of a style leads on to its colour: keyword and argument, a reference or a list. */
static const struct {
    const char *keyword;
    int argument;
    bool is_stroke;
} ways[] = {{"PRESENTATION_STYLE_ASSIGNMENT", 0, false},
            {"PRESENTATION_STYLE_BY_CONTEXT", 0, false},
            {"SURFACE_STYLE_USAGE", 1, false},
            {"SURFACE_SIDE_STYLE", 1, false},
            {"SURFACE_STYLE_FILL_AREA", 0, false},
            {"FILL_AREA_STYLE", 1, false},
            {"FILL_AREA_STYLE_COLOUR", 1, false},
            {"SURFACE_STYLE_RENDERING", 1, false},
            {"SURFACE_STYLE_RENDERING_WITH_PROPERTIES", 1, false},
            {"CURVE_STYLE", 3, true},
            {"POINT_STYLE", 3, true}};

/* The search for colours from a style on. */
enum { MOST_STEPS = 64 };
typedef struct {
    const bat_step_instance *instance;
    bool is_stroke;
} step;
typedef struct {
    step steps[MOST_STEPS];
    int count;
    bat_step_colours look;
} search;

static void push(search *s, const bat_step_instance *instance, bool is_stroke)
{
    if (s->count < MOST_STEPS)
        s->steps[s->count++] = (step){instance, is_stroke};
}

/* Go on to what argument k of the record refers to, or the references in its list. */
static void push_argument(const bat_step_file *file, search *s, const bat_step_record *record,
                          int k, bool is_stroke)
{
    const bat_step_instance *next = NULL;
    int count = 0;
    size_t at = bat_step_argument(file, record, k);
    const bat_step_value value = bat_step_value_at(file, at);
    if (value.kind == BAT_STEP_REFERENCE) {
        if (bat_step_get_reference(file, record, k, &next) == BATTEN_OK)
            push(s, next, is_stroke);
        return;
    }
    if (value.kind != BAT_STEP_LIST ||
        bat_step_get_list(file, record, k, &count, &at) != BATTEN_OK)
        return;
    for (int i = 0; i < count && i < MOST_STEPS; i++) {
        const bat_step_value item = bat_step_value_at(file, at);
        if (item.kind != BAT_STEP_REFERENCE)
            at = bat_step_next(file, at);
        else if (bat_step_item_reference(file, record, &at, &next) == BATTEN_OK)
            push(s, next, is_stroke);
        else
            return;
    }
}

/* The first colour of each sort that the styles of the list lead to. */
static bat_step_colours find_look(const bat_step_file *file, const bat_step_record *record,
                                  int k)
{
    search s = {.count = 0};
    push_argument(file, &s, record, k, false);
    for (int i = 0; i < s.count; i++) {
        const step at = s.steps[i];
        double rgb[3];
        const bat_step_record *found = NULL;
        for (size_t w = 0; w < sizeof ways / sizeof ways[0] && !found; w++) {
            found = bat_step_as(file, at.instance, ways[w].keyword);
            if (found)
                push_argument(file, &s, found, ways[w].argument,
                              at.is_stroke || ways[w].is_stroke);
        }
        bool *has = at.is_stroke ? &s.look.has_stroke : &s.look.has_fill;
        if (!found && !*has && read_colour(file, at.instance, rgb)) {
            *has = true;
            memcpy(at.is_stroke ? s.look.stroke : s.look.fill, rgb, sizeof rgb);
        }
    }
    return s.look;
}

/* ---- taking in ---- */

batten_status bat_step_styles_add(bat_step_styles *styles, const bat_step_instance *instance)
{
    static const char *const keywords[] = {"STYLED_ITEM", "OVER_RIDING_STYLED_ITEM"};
    const bat_step_file *file = styles->file;
    const bat_step_instance *item = NULL;
    const bat_step_record *record = NULL;
    look_row row = {.overrides = false};
    for (size_t k = 0; k < 2 && !record; k++) {
        record = bat_step_as(file, instance, keywords[k]);
        row.overrides = record && k == 1;
    }
    if (!record)
        return BATTEN_OK;
    /* In a complex instance the name stands in another part. */
    const int at = bat_step_argument_count(file, record) > 2 ? 1 : 0;
    batten_status status = bat_step_get_reference(file, record, at + 1, &item);
    if (status != BATTEN_OK)
        return bat_step_mark_failed(file, instance, status);
    row.item = bat_step_index(file, item);
    row.styled = bat_step_index(file, instance);
    row.look = find_look(file, record, at);
    return bat_list_add(file->input, &styles->looks, &row);
}

batten_status bat_step_styles_add_layer(bat_step_styles *styles,
                                        const bat_step_instance *instance)
{
    const bat_step_file *file = styles->file;
    const bat_step_record *record =
        bat_step_as(file, instance, "PRESENTATION_LAYER_ASSIGNMENT");
    layer_row layer = {.instance = bat_step_index(file, instance)};
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_string(file, record, 0, sizeof layer.name, layer.name);
    if (status == BATTEN_OK)
        status = bat_step_get_list(file, record, 2, &count, &at);
    if (status == BATTEN_OK)
        status = bat_list_add(file->input, &styles->layers, &layer);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *item = NULL;
        status = bat_step_item_reference(file, record, &at, &item);
        if (status == BATTEN_OK) {
            const member_row member = {bat_step_index(file, item),
                                       (uint32_t)styles->layers.count - 1,
                                       (uint32_t)styles->members.count};
            status = bat_list_add(file->input, &styles->members, &member);
        }
    }
    return bat_step_mark_failed(file, instance, status);
}

batten_status bat_step_styles_add_hidden(bat_step_styles *styles,
                                         const bat_step_instance *instance)
{
    const bat_step_file *file = styles->file;
    const bat_step_record *record = bat_step_as(file, instance, "INVISIBILITY");
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_get_list(file, record, 0, &count, &at);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_step_instance *item = NULL;
        status = bat_step_item_reference(file, record, &at, &item);
        if (status == BATTEN_OK) {
            const uint32_t index = bat_step_index(file, item);
            status = bat_list_add(file->input, &styles->hidden, &index);
        }
    }
    return bat_step_mark_failed(file, instance, status);
}

/* ---- asking ---- */

/* Of one item the overriding style comes first, then the one that stands first. */
static int compare_looks(const void *a, const void *b)
{
    const look_row *x = a, *y = b;
    const int by_item = bat_step_compare_indices(x->item, y->item);
    if (by_item)
        return by_item;
    return x->overrides != y->overrides ? y->overrides - x->overrides
                                        : bat_step_compare_indices(x->styled, y->styled);
}

static int compare_members(const void *a, const void *b)
{
    const member_row *x = a, *y = b;
    const int by_item = bat_step_compare_indices(x->item, y->item);
    return by_item ? by_item : bat_step_compare_indices(x->order, y->order);
}

static int compare_indices(const void *a, const void *b)
{
    return bat_step_compare_indices(*(const uint32_t *)a, *(const uint32_t *)b);
}

void bat_step_styles_sort(bat_step_styles *styles)
{
    bat_step_sort_rows(&styles->looks, compare_looks);
    bat_step_sort_rows(&styles->members, compare_members);
    bat_step_sort_rows(&styles->hidden, compare_indices);
}

/* The next look of the same item, or NULL. */
static const look_row *look_after(const bat_step_styles *styles, const look_row *row)
{
    const look_row *end = (const look_row *)styles->looks.items + styles->looks.count;
    return row + 1 < end && row[1].item == row->item ? row + 1 : NULL;
}

const bat_step_colours *bat_step_colours_of(const bat_step_styles *styles,
                                            const bat_step_instance *item)
{
    const uint32_t key = bat_step_index(styles->file, item);
    const look_row *row = bat_step_first_row(&styles->looks, key);
    while (row && !row->look.has_fill && !row->look.has_stroke)
        row = look_after(styles, row);
    return row ? &row->look : NULL;
}

static const member_row *member_of(const bat_step_styles *styles, uint32_t item)
{
    return bat_step_first_row(&styles->members, item);
}

const char *bat_step_layer_of(const bat_step_styles *styles, const bat_step_instance *item)
{
    const uint32_t key = bat_step_index(styles->file, item);
    const member_row *row = member_of(styles, key);
    const layer_row *layers = styles->layers.items;
    /* A layer may have the styles of items for members. */
    const look_row *look = row ? NULL : bat_step_first_row(&styles->looks, key);
    if (look)
        row = member_of(styles, look->styled);
    return row ? layers[row->layer].name : NULL;
}

bool bat_step_is_hidden(const bat_step_styles *styles, const bat_step_instance *item)
{
    const uint32_t key = bat_step_index(styles->file, item);
    const layer_row *layers = styles->layers.items;
    if (styles->hidden.count == 0)
        return false;
    if (bat_step_first_row(&styles->hidden, key))
        return true;
    const look_row *look = bat_step_first_row(&styles->looks, key);
    for (; look; look = look_after(styles, look))
        if (bat_step_first_row(&styles->hidden, look->styled))
            return true;
    const member_row *member = member_of(styles, key);
    return member && bat_step_first_row(&styles->hidden, layers[member->layer].instance);
}
