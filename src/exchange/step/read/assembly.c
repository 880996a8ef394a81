/* What is placed in what: mapped items, and occurrences in assemblies. */
#include "exchange/step/read/product.h"

#include <stdlib.h>

/* ---- relationships with a placement ---- */

/* The product definition that argument k of an occurrence relates; NULL when it is broken. */
static const bat_step_instance *product_at(const bat_step_import *import,
                                           const bat_step_instance *occurrence, int k)
{
    const bat_step_instance *product = NULL;
    const bat_step_record *record = bat_step_first(&import->file, occurrence);
    return bat_step_get_reference(&import->file, record, k, &product) == BATTEN_OK ? product
                                                                                   : NULL;
}

/* The first is the part and the second the assembly, but some write it the other way about: the
 * products tell. */
static bool is_swapped(const bat_step_import *import, const bat_step_instance *occurrence,
                       const uint32_t definitions[2])
{
    const bat_step_representation *all = import->representations.items;
    if (!occurrence)
        return false;
    const bat_step_instance *assembly = product_at(import, occurrence, 3);
    const bat_step_instance *part = product_at(import, occurrence, 4);
    return assembly && part && all[definitions[0]].product == assembly &&
           all[definitions[1]].product == part;
}

/* ---- in which representation items stand ---- */

enum { NOWHERE = 0 };
static const uint32_t MANY = UINT32_MAX;

/* Of each instance the definition among whose items it stands, counted from 1. */
static batten_status find_homes(bat_step_import *import)
{
    const bat_step_representation *all = import->representations.items;
    batten_status status = bat_input_array(import->input, import->file.instances.count + 1,
                                           sizeof *import->homes, &import->homes);
    for (size_t k = 0; status == BATTEN_OK && k < import->representations.count; k++) {
        int count = 0;
        size_t at = 0;
        if (bat_step_items_of(import, &all[k], &count, &at) != BATTEN_OK)
            continue; /* noted when it is read */
        for (int i = 0; i < count; i++) {
            const bat_step_instance *item = NULL;
            if (bat_step_item_reference(&import->file, all[k].record, &at, &item) != BATTEN_OK)
                break;
            uint32_t *home = &import->homes[bat_step_index(&import->file, item)];
            *home = *home == NOWHERE || *home == all[k].first + 1 ? all[k].first + 1 : MANY;
        }
    }
    return status;
}

/* 1 when the item stands in the one, -1 when it stands in the other, 0 when that cannot be
 * told. */
static int stands_in(const bat_step_import *import, const bat_step_instance *item,
                     const bat_step_representation *one, const bat_step_representation *other)
{
    const uint32_t home = import->homes[bat_step_index(&import->file, item)];
    return home == one->first + 1 ? 1 : home == other->first + 1 ? -1 : 0;
}

/* The placements of a transformation, that of the first representation first: some write them
 * the other way about than the representations. */
static batten_status find_items(const bat_step_import *import,
                                const bat_step_instance *transform,
                                const bat_step_record *record,
                                bat_step_representation *const pair[2],
                                const bat_step_instance *items[2])
{
    const bat_step_file *file = &import->file;
    batten_status status = bat_step_get_reference(file, record, 2, &items[0]);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 3, &items[1]);
    if (status != BATTEN_OK || stands_in(import, items[0], pair[0], pair[1]) +
                                       stands_in(import, items[1], pair[1], pair[0]) >=
                                   0)
        return status;
    const bat_step_instance *first = items[0];
    items[0] = items[1];
    items[1] = first;
    bat_step_warn(file, transform,
                  "the items of its relation belong to the opposite representations; each is "
                  "used where it belongs");
    return BATTEN_OK;
}

/* ---- relationships ---- */

static batten_status read_transform(bat_step_import *import, const bat_step_instance *transform,
                                    bat_step_representation *const pair[2], bool swapped,
                                    batten_affine *place)
{
    const bat_step_file *file = &import->file;
    const bat_step_record *record = bat_step_as(file, transform, "ITEM_DEFINED_TRANSFORMATION");
    const bat_step_instance *items[2] = {NULL, NULL};
    batten_affine at[2];
    if (!record)
        return bat_step_fail(file, transform, BATTEN_UNSUPPORTED,
                             "it is not an ITEM_DEFINED_TRANSFORMATION");
    batten_status status = find_items(import, transform, record, pair, items);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        bat_step_scale scale;
        bat_step_scale_of(import, pair[k], &scale);
        status = bat_step_read_place(file, items[k], &scale, &at[k]);
    }
    if (status == BATTEN_OK)
        *place = swapped ? bat_step_move(&at[1], &at[0]) : bat_step_move(&at[0], &at[1]);
    return status;
}

static batten_status read_placed(bat_step_import *import, const bat_step_instance *instance,
                                 const bat_step_instance *occurrence,
                                 const bat_step_instance *styled, bat_step_placing *placing)
{
    const bat_step_file *file = &import->file;
    const bat_step_record *relation =
        bat_step_as(file, instance, "REPRESENTATION_RELATIONSHIP");
    const bat_step_record *with =
        bat_step_as(file, instance, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION");
    const int at = relation ? 0 : 4; /* of the transformation */
    const bat_step_instance *transform = NULL;
    bat_step_representation *pair[2] = {NULL, NULL};
    uint32_t definitions[2] = {0, 0};
    batten_status status = BATTEN_OK;
    if (!relation)
        relation = with;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const bat_step_instance *end = NULL;
        status = bat_step_get_reference(file, relation, 2 + k, &end);
        pair[k] = status == BATTEN_OK ? bat_step_representation_of(import, end) : NULL;
        if (status == BATTEN_OK && !pair[k])
            status = bat_step_fail(file, end, BATTEN_BAD_FORMAT,
                                   "it stands where the representation of a shape should");
        if (status == BATTEN_OK)
            definitions[k] = pair[k]->first;
    }
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, with, at, &transform);
    if (status != BATTEN_OK)
        return status;
    const bool swapped = is_swapped(import, occurrence, definitions);
    *placing = (bat_step_placing){.parent = definitions[swapped ? 0 : 1],
                                  .child = definitions[swapped ? 1 : 0],
                                  .instance = bat_step_index(file, instance),
                                  .styled = styled,
                                  .occurrence = occurrence};
    return read_transform(import, transform, pair, swapped, &placing->place);
}

/* Add what could be read of a placing; leave it out when that failed. */
static batten_status add_instance(bat_step_import *import, const bat_step_instance *instance,
                                  batten_status status, const bat_step_placing *placing)
{
    if (status != BATTEN_OK)
        return bat_step_leave_out(&import->file, &import->census, instance, status);
    ((bat_step_representation *)import->representations.items)[placing->child].is_placed = true;
    return bat_list_add(import->input, &import->placings, placing);
}

/* An occurrence says which relationship places it. */
static batten_status read_occurrence(bat_step_import *import, const bat_step_instance *instance)
{
    const bat_step_file *file = &import->file;
    const bat_step_record *record = bat_step_first(file, instance);
    const bat_step_instance *relation = NULL, *shape = NULL, *occurrence = NULL;
    bat_step_placing placing;
    batten_status status = bat_step_get_reference(file, record, 0, &relation);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, 1, &shape);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, bat_step_first(file, shape), 2, &occurrence);
    if (status == BATTEN_OK &&
        !bat_step_as(file, relation, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"))
        status = bat_step_fail(file, relation, BATTEN_UNSUPPORTED, "it has no transformation");
    if (status == BATTEN_OK)
        import->taken[bat_step_index(file, relation)] = true;
    if (status == BATTEN_OK)
        status = read_placed(import, relation, occurrence, instance, &placing);
    return add_instance(import, instance, status, &placing);
}

static batten_status read_occurrences(bat_step_import *import)
{
    const bat_step_instance *instances = import->file.instances.items;
    const uint32_t *occurrences = import->outline.occurrences.items,
                   *placed = import->outline.placed.items;
    bat_step_placing placing;
    batten_status status = import->outline.placed.count ? find_homes(import) : BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < import->outline.occurrences.count; k++)
        status = read_occurrence(import, &instances[occurrences[k]]);
    /* Relationships that place without being named as an occurrence. */
    for (size_t k = 0; status == BATTEN_OK && k < import->outline.placed.count; k++) {
        const bat_step_instance *relation = &instances[placed[k]];
        if (import->taken[placed[k]])
            continue;
        status = read_placed(import, relation, NULL, relation, &placing);
        status = add_instance(import, relation, status, &placing);
    }
    return status;
}

/* ---- mapped items ---- */

static batten_status read_mapped(bat_step_import *import, bat_step_representation *parent,
                                 const bat_step_instance *item, bat_step_placing *placing)
{
    const bat_step_file *file = &import->file;
    const bat_step_record *record = bat_step_as(file, item, "MAPPED_ITEM");
    const int at = bat_step_argument_count(file, record) > 2 ? 1 : 0;
    const bat_step_instance *map = NULL, *target = NULL, *origin = NULL, *mapped = NULL;
    bat_step_scale inner, outer;
    batten_affine from, to;
    batten_status status = bat_step_get_reference(file, record, at, &map);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, record, at + 1, &target);
    const bat_step_record *source =
        status == BATTEN_OK ? bat_step_as(file, map, "REPRESENTATION_MAP") : NULL;
    if (status == BATTEN_OK && !source)
        status = bat_step_fail(file, map, BATTEN_BAD_FORMAT,
                               "it is given where a REPRESENTATION_MAP is expected");
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, source, 0, &origin);
    if (status == BATTEN_OK)
        status = bat_step_get_reference(file, source, 1, &mapped);
    bat_step_representation *child =
        status == BATTEN_OK ? bat_step_representation_of(import, mapped) : NULL;
    if (status != BATTEN_OK || !child)
        return status != BATTEN_OK
                   ? status
                   : bat_step_fail(file, mapped, BATTEN_BAD_FORMAT,
                                   "it is given where a representation is expected");
    bat_step_scale_of(import, child, &inner);
    bat_step_scale_of(import, parent, &outer);
    status = bat_step_read_place(file, origin, &inner, &from);
    if (status == BATTEN_OK)
        status = bat_step_read_place(file, target, &outer, &to);
    if (status != BATTEN_OK)
        return status;
    *placing = (bat_step_placing){.parent = parent->first,
                                  .child = child->first,
                                  .instance = bat_step_index(file, item),
                                  .styled = item,
                                  .place = bat_step_move(&from, &to)};
    return BATTEN_OK;
}

static batten_status read_all_mapped(bat_step_import *import)
{
    bat_step_representation *all = import->representations.items;
    batten_status status = BATTEN_OK;
    /* Without maps no list of items needs to be looked through. */
    for (size_t k = 0; import->outline.maps.count && k < import->representations.count; k++) {
        int count = 0;
        size_t at = 0;
        if (bat_step_items_of(import, &all[k], &count, &at) != BATTEN_OK)
            continue; /* noted when it is read */
        for (int i = 0; status == BATTEN_OK && i < count; i++) {
            const bat_step_instance *item = NULL;
            bat_step_placing placing;
            if (bat_step_item_reference(&import->file, all[k].record, &at, &item) != BATTEN_OK)
                break;
            if (!bat_step_as(&import->file, item, "MAPPED_ITEM"))
                continue;
            status = read_mapped(import, &all[k], item, &placing);
            status = add_instance(import, item, status, &placing);
        }
    }
    return status;
}

/* ---- order ---- */

static int compare(const void *a, const void *b)
{
    const bat_step_placing *x = a, *y = b;
    if (x->parent != y->parent)
        return x->parent < y->parent ? -1 : 1;
    return (x->instance > y->instance) - (x->instance < y->instance);
}

batten_status bat_step_find_placings(bat_step_import *import)
{
    bat_step_representation *all = import->representations.items;
    import->placings = (bat_list){.size = sizeof(bat_step_placing)};
    batten_status status = read_occurrences(import);
    if (status == BATTEN_OK)
        status = read_all_mapped(import);
    if (status != BATTEN_OK)
        return status;
    bat_step_placing *placings = import->placings.items;
    if (import->placings.count > 1)
        qsort(placings, import->placings.count, sizeof *placings, compare);
    for (size_t k = 0; k < import->placings.count; k++) {
        bat_step_representation *parent = &all[placings[k].parent];
        if (parent->placing_count++ == 0)
            parent->placing = (uint32_t)k;
    }
    return BATTEN_OK;
}
