/* Definitions become models, each made once; what is placed in them becomes instances. */
#include "exchange/step/read/product.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bat_step_representation *definition(const bat_step_import *import, uint32_t index)
{
    return (bat_step_representation *)import->representations.items + index;
}

/* ---- names ---- */

static bool string_at(const bat_step_file *file, const bat_step_instance *instance, int k,
                      char name[BAT_STEP_NAME])
{
    const bat_step_record *record = bat_step_first(file, instance);
    return bat_step_value_at(file, bat_step_argument(file, record, k)).kind ==
               BAT_STEP_STRING &&
           bat_step_get_string(file, record, k, BAT_STEP_NAME, name) == BATTEN_OK && name[0];
}

/* The name of the product that a definition is the shape of, or its id. */
static void product_name(const bat_step_import *import, const bat_step_representation *of,
                         char name[BAT_STEP_NAME])
{
    const bat_step_file *file = &import->file;
    const bat_step_instance *formation = NULL, *product = NULL;
    name[0] = '\0';
    if (of->product &&
        bat_step_get_reference(file, bat_step_first(file, of->product), 2, &formation) ==
            BATTEN_OK &&
        bat_step_get_reference(file, bat_step_first(file, formation), 2, &product) ==
            BATTEN_OK &&
        !string_at(file, product, 1, name) && !string_at(file, product, 0, name))
        name[0] = '\0';
}

/* An occurrence has a name and an id; else it is called as what it places. */
static void placing_name(const bat_step_import *import, const bat_step_placing *placing,
                         char name[BAT_STEP_NAME])
{
    const bat_step_file *file = &import->file;
    name[0] = '\0';
    if (placing->occurrence) {
        if (string_at(file, placing->occurrence, 1, name) ||
            string_at(file, placing->occurrence, 0, name))
            return;
    } else if (bat_step_as(file, placing->styled, "MAPPED_ITEM")) {
        bat_step_name_of(file, placing->styled, name);
    }
    if (!name[0])
        product_name(import, definition(import, placing->child), name);
}

/* ---- the objects of a definition ---- */

/* An item or a placing, in the order of the file. */
typedef struct {
    uint32_t instance, representation;
    const bat_step_placing *placing; /* or NULL */
} part;

static int compare_parts(const void *a, const void *b)
{
    const part *x = a, *y = b;
    return (x->instance > y->instance) - (x->instance < y->instance);
}

static batten_status add_items(bat_step_import *import, uint32_t index, bat_list *parts)
{
    const bat_step_representation *of = definition(import, index);
    const bat_step_instance *instance =
        (const bat_step_instance *)import->file.instances.items + of->instance;
    int count = 0;
    size_t at = 0;
    batten_status status = bat_step_items_of(import, of, &count, &at);
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const bat_step_instance *item = NULL;
        status = bat_step_item_reference(&import->file, of->record, &at, &item);
        if (status != BATTEN_OK) {
            status = bat_step_leave_out(&import->file, &import->census, instance, status);
            continue;
        }
        const part found = {bat_step_index(&import->file, item), index, NULL};
        if (!bat_step_as(&import->file, item, "MAPPED_ITEM"))
            status = bat_list_add(import->input, parts, &found);
    }
    return status == BATTEN_OK
               ? status
               : bat_step_leave_out(&import->file, &import->census, instance, status);
}

/* Is the representation or one of its definition hidden as a whole? */
static bool is_hidden(const bat_step_import *import, uint32_t index)
{
    const bat_step_instance *instances = import->file.instances.items;
    return bat_step_is_hidden(&import->styles, &instances[definition(import, index)->instance]);
}

static batten_status add_item(bat_step_import *import, const part *of, bat_step_target *target)
{
    const bat_step_instance *item =
        (const bat_step_instance *)import->file.instances.items + of->instance;
    if (import->taken[of->instance])
        return BATTEN_OK;
    import->taken[of->instance] = true;
    bat_step_scale_of(import, definition(import, of->representation), &target->scale);
    target->is_hidden = is_hidden(import, of->representation);
    return bat_step_read_item(target, item);
}

static batten_status add_placing(const bat_step_placing *placing, bat_step_target *target)
{
    bat_step_import *import = target->import;
    const bat_step_representation *child = definition(import, placing->child);
    const bat_step_instance *item =
        (const bat_step_instance *)import->file.instances.items + placing->instance;
    const bat_step_instance *from[] = {placing->styled};
    char name[BAT_STEP_NAME], kept[BAT_STEP_NAME];
    if (child->is_entered && !child->is_made)
        return bat_step_leave_out(&import->file, &import->census, item,
                                  bat_step_fail(&import->file, item, BATTEN_BAD_FORMAT,
                                                "it places a shape within itself"));
    if (!child->model || batten_model_count(child->model) == 0)
        return BATTEN_OK; /* what is missing there is noted there */
    batten_object object = {
        .kind = BATTEN_OBJECT_INSTANCE, .definition = child->model, .place = placing->place};
    target->is_hidden = false;
    bat_step_dress(target, 1, from, &object, kept);
    placing_name(import, placing, name);
    object.name = name;
    return bat_step_add_object(target, placing->occurrence ? placing->occurrence : item,
                               &object);
}

/* All representations of the definition; the list of parts is used again and again. */
static batten_status gather(bat_step_import *import, uint32_t index, const uint32_t *next,
                            bat_list *parts)
{
    const bat_step_representation *of = definition(import, index);
    const bat_step_placing *placings = import->placings.items;
    batten_status status = BATTEN_OK;
    parts->count = 0;
    for (uint32_t k = index; status == BATTEN_OK && k != UINT32_MAX; k = next[k])
        status = add_items(import, k, parts);
    for (uint32_t k = 0; status == BATTEN_OK && k < of->placing_count; k++) {
        const bat_step_placing *placing = &placings[of->placing + k];
        const part found = {placing->instance, index, placing};
        status = bat_list_add(import->input, parts, &found);
    }
    if (parts->count > 1)
        qsort(parts->items, parts->count, sizeof(part), compare_parts);
    return status;
}

static batten_status make_model(bat_step_import *import, uint32_t index, const uint32_t *next,
                                bat_list *parts)
{
    bat_step_representation *of = definition(import, index);
    char product[BAT_STEP_NAME];
    product_name(import, of, product);
    bat_step_target target = {.import = import, .product = product};
    batten_status status = batten_model_create(import->units.unit_metres, &of->model);
    if (status == BATTEN_OK)
        status = batten_model_set_name(of->model, product);
    if (status == BATTEN_OK)
        status = gather(import, index, next, parts);
    target.model = of->model;
    const part *all = parts->items;
    for (size_t k = 0; status == BATTEN_OK && k < parts->count; k++)
        status = all[k].placing ? add_placing(all[k].placing, &target)
                                : add_item(import, &all[k], &target);
    of->is_made = true;
    return status;
}

/* ---- all definitions, those that are placed before those that place them ---- */

typedef struct {
    bat_step_import *import;
    const uint32_t *next; /* representation of the same definition; UINT32_MAX at the end */
    bat_list way;         /* level: the definitions that are being gone through */
    bat_list parts;
} making;

typedef struct {
    uint32_t index, at; /* the next placing to look at */
} level;

static batten_status enter(making *m, uint32_t index)
{
    const level made = {index, 0};
    definition(m->import, index)->is_entered = true;
    return bat_list_add(m->import->input, &m->way, &made);
}

static batten_status make_with_children(making *m, uint32_t root)
{
    const bat_step_placing *placings = m->import->placings.items;
    batten_status status = enter(m, root);
    while (status == BATTEN_OK && m->way.count) {
        level *top = (level *)m->way.items + m->way.count - 1;
        const bat_step_representation *of = definition(m->import, top->index);
        if (top->at < of->placing_count) {
            const uint32_t child = placings[of->placing + top->at++].child;
            if (!definition(m->import, child)->is_entered)
                status = enter(m, child);
            continue;
        }
        m->way.count--;
        status = make_model(m->import, top->index, m->next, &m->parts);
    }
    return status;
}

/* What is not placed anywhere is a root; in a ring, where everything is, the first one met. */
static bool is_root(const bat_step_representation *of, bool in_ring)
{
    return of->is_shape && (of->is_product || !of->is_aspect) && !of->is_entered &&
           (in_ring || !of->is_placed);
}

static batten_status make_all(making *m, bat_list *roots)
{
    bat_step_import *import = m->import;
    batten_status status = BATTEN_OK;
    for (int ring = 0; ring < 2; ring++)
        for (uint32_t k = 0; status == BATTEN_OK && k < import->representations.count; k++) {
            const bat_step_representation *of = definition(import, k);
            if (of->first != k || !is_root(of, ring))
                continue;
            status = bat_list_add(import->input, roots, &k);
            if (status == BATTEN_OK)
                status = make_with_children(m, k);
        }
    return status;
}

/* ---- the model ---- */

/* The objects of a root, in a group of the product's name. */
static batten_status add_root(bat_step_import *import, uint32_t index, batten_model *model)
{
    const bat_step_representation *of = definition(import, index);
    char name[BAT_STEP_NAME], *group = import->path;
    batten_status status = BATTEN_OK;
    product_name(import, of, name);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(of->model); i++) {
        batten_object object = *batten_model_object(of->model, i);
        snprintf(group, BAT_STEP_PATH, "%s%s%s", name, name[0] && object.group[0] ? "/" : "",
                 object.group);
        object.group = group;
        status = batten_model_add(model, &object);
    }
    return status;
}

/* One root is the model itself; several are put into one. */
static batten_status join_roots(bat_step_import *import, const bat_list *roots,
                                batten_model **out)
{
    const uint32_t *indices = roots->items;
    size_t full = 0, last = 0;
    for (size_t k = 0; k < roots->count; k++)
        if (batten_model_count(definition(import, indices[k])->model) > 0) {
            full++;
            last = k;
        }
    if (full == 1) {
        *out = batten_model_ref(definition(import, indices[last])->model);
        return BATTEN_OK;
    }
    batten_model *model = NULL;
    batten_status status = batten_model_create(
        import->units.unit_metres > 0 ? import->units.unit_metres : 0.001, &model);
    for (size_t k = 0; status == BATTEN_OK && k < roots->count; k++)
        status = add_root(import, indices[k], model);
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    return status;
}

/* Chains of the representations of each definition, in their order. */
static void link_up(const bat_step_import *import, uint32_t *next)
{
    const size_t count = import->representations.count;
    for (size_t k = count; k-- > 0;)
        next[k] = UINT32_MAX;
    /* From the back, each goes in right behind the first. */
    for (size_t k = count; k-- > 0;) {
        const uint32_t first = definition(import, (uint32_t)k)->first;
        if (first == k)
            continue;
        next[k] = next[first];
        next[first] = (uint32_t)k;
    }
}

batten_status bat_step_read_products(bat_step_import *import, batten_model **out)
{
    making m = {
        .import = import, .way = {.size = sizeof(level)}, .parts = {.size = sizeof(part)}};
    bat_list roots = {.size = sizeof(uint32_t)};
    uint32_t *next = NULL;
    batten_model *model = NULL;
    batten_status status = bat_step_find_representations(import);
    if (status == BATTEN_OK)
        status = bat_step_find_placings(import);
    if (status == BATTEN_OK)
        status = bat_input_array(import->input, import->representations.count + 1, sizeof *next,
                                 &next);
    if (status == BATTEN_OK) {
        link_up(import, next);
        m.next = next;
        status = make_all(&m, &roots);
    }
    if (status == BATTEN_OK)
        status = join_roots(import, &roots, &model);
    if (status == BATTEN_OK)
        status = bat_step_read_roots(import, model);
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    for (size_t k = 0; k < import->representations.count; k++)
        batten_model_unref(definition(import, (uint32_t)k)->model);
    bat_release(next);
    bat_release(m.way.items);
    bat_release(m.parts.items);
    bat_release(roots.items);
    return status;
}
