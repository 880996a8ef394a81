/* The first pass over a DXF file: unit, layers, and where the blocks are. */
#include "exchange/dxf/survey.h"
#include "exchange/dxf/colours.h"

#include <stdlib.h>
#include <string.h>

static bool is_unit(const bat_dxf_group *group)
{
    return group->code == 9 && group->value.length == 9 &&
           memcmp(group->value.bytes, "$INSUNITS", 9) == 0;
}

static batten_status read_header(bat_dxf_reading *r, const bat_dxf_pairs *pairs)
{
    const bat_dxf_group *groups = pairs->groups.items;
    for (size_t i = 0; i + 1 < pairs->groups.count; i++) {
        double code = 0;
        if (is_unit(&groups[i]) && bat_dxf_number(pairs, &groups[i + 1], &code) == BATTEN_OK)
            r->unit_metres = bat_dxf_unit_of((int)bat_max(0, bat_min(100, code)));
    }
    if (r->unit_metres == 0)
        batten_notes_add(r->input->notes, r->input->file, 0, "", "the file gives no unit");
    return BATTEN_OK;
}

/* Bad numbers of a layer are as if they were not there. */
static batten_status read_layer(bat_dxf_reading *r, const bat_dxf_pairs *pairs)
{
    bat_dxf_layer_entry made = {.is.at = pairs->next_at};
    int colour = 7, flags = 0, full = -1;
    bat_dxf_get_text(pairs, 2, sizeof made.is.name, made.is.name);
    (void)bat_dxf_get_integer(pairs, 62, 7, &colour);
    (void)bat_dxf_get_integer(pairs, 70, 0, &flags);
    (void)bat_dxf_get_integer(pairs, 420, -1, &full);
    made.is_hidden = colour < 0 || (flags & 1);
    colour = abs(bat_max_int(colour, -255));
    made.has_colour = bat_dxf_colour(colour, made.colour) && colour != BAT_DXF_PLAIN;
    if (full >= 0) {
        bat_dxf_true_colour(full, made.colour);
        made.has_colour = true;
    }
    return bat_list_add(r->input, &r->layers, &made);
}

static batten_status read_base(const bat_dxf_reading *r, const bat_dxf_pairs *pairs,
                               batten_vec3 *base)
{
    const batten_vec3 zero = {0, 0, 0};
    const batten_status status = bat_dxf_get_point(pairs, 10, zero, base);
    if (status != BATTEN_BAD_FORMAT)
        return status;
    batten_notes_add(r->input->notes, r->input->file, pairs->line, "BLOCK",
                     "%s; its base is taken as 0", batten_message());
    *base = zero;
    return BATTEN_OK;
}

static batten_status read_block(bat_dxf_reading *r, const bat_dxf_pairs *pairs)
{
    bat_dxf_block made = {.is.at = pairs->next_at, .line = pairs->next_line};
    bat_dxf_get_text(pairs, 2, sizeof made.is.name, made.is.name);
    const batten_status status = read_base(r, pairs, &made.base);
    return status == BATTEN_OK ? bat_list_add(r->input, &r->blocks, &made) : status;
}

static batten_status survey_entity(bat_dxf_reading *r, const bat_dxf_pairs *pairs)
{
    char name[32] = "";
    if (bat_dxf_is(pairs, "LAYER"))
        return read_layer(r, pairs);
    if (bat_dxf_is(pairs, "BLOCK"))
        return read_block(r, pairs);
    if (!bat_dxf_is(pairs, "SECTION"))
        return BATTEN_OK;
    bat_dxf_get_text(pairs, 2, sizeof name, name);
    if (strcmp(name, "HEADER") == 0)
        return read_header(r, pairs);
    if (strcmp(name, "ENTITIES") == 0 && pairs->has_next) {
        r->entities_at = pairs->next_at;
        r->entities_line = pairs->next_line;
    }
    return BATTEN_OK;
}

static int lower(char c)
{
    return c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : (unsigned char)c;
}

static int compare_like(const char *a, const char *b)
{
    while (*a && lower(*a) == lower(*b)) {
        a++;
        b++;
    }
    return lower(*a) - lower(*b);
}

/* Names that differ in capitals alone stand together. */
static int compare_names(const char *a, const char *b)
{
    const int order = compare_like(a, b);
    return order ? order : strcmp(a, b);
}

static int compare(const void *a, const void *b)
{
    const bat_dxf_named *one = a, *other = b;
    const int order = compare_names(one->name, other->name);
    return order ? order : (one->at > other->at) - (one->at < other->at);
}

batten_status bat_dxf_survey(bat_dxf_reading *r)
{
    bat_dxf_pairs pairs;
    bool more = true, ended = false;
    bat_dxf_pairs_begin(&pairs, r->input, 0, 0);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && more && !ended) {
        status = bat_dxf_next(&pairs, &more);
        if (status == BATTEN_OK && more)
            status = bat_input_step(r->input, pairs.at / 2);
        if (status == BATTEN_OK && more)
            status = survey_entity(r, &pairs);
        ended = status == BATTEN_OK && more && bat_dxf_is(&pairs, "EOF");
    }
    r->input->is_cut = !ended;
    bat_dxf_pairs_end(&pairs);
    if (r->layers.count)
        qsort(r->layers.items, r->layers.count, sizeof(bat_dxf_layer_entry), compare);
    if (r->blocks.count)
        qsort(r->blocks.items, r->blocks.count, sizeof(bat_dxf_block), compare);
    return status;
}

typedef int comparison(const char *a, const char *b);

static bat_dxf_named *named_at(const bat_list *list, size_t index)
{
    return (void *)((unsigned char *)list->items + index * list->size);
}

/* How many of a sorted list come before the name. */
static size_t count_before(const bat_list *list, const char *name, comparison *order)
{
    size_t low = 0, high = list->count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (order(named_at(list, middle)->name, name) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* The first of a sorted list that has the name. */
static void *first_of(const bat_list *list, const char *name, comparison *order)
{
    const size_t low = count_before(list, name, order);
    if (low == list->count)
        return NULL;
    bat_dxf_named *found = named_at(list, low);
    return order(found->name, name) == 0 ? found : NULL;
}

static void *find(const bat_list *list, const char *name)
{
    void *found = first_of(list, name, compare_names);
    return found ? found : first_of(list, name, compare_like);
}

const bat_dxf_layer_entry *bat_dxf_find_layer(const bat_dxf_reading *r, const char *name)
{
    return find(&r->layers, name);
}

bat_dxf_block *bat_dxf_find_block(const bat_dxf_reading *r, const char *name)
{
    return find(&r->blocks, name);
}
