/* The representations of a file and the definitions that they form. */
#include "exchange/step/read/product.h"

#include <stdlib.h>

bat_step_representation *bat_step_representation_of(const bat_step_import *import,
                                                    const bat_step_instance *instance)
{
    bat_step_representation *all = import->representations.items;
    const uint32_t wanted = bat_step_index(&import->file, instance);
    size_t low = 0, high = import->representations.count;
    while (low < high) {
        const size_t middle = low + (high - low) / 2;
        if (all[middle].instance < wanted)
            low = middle + 1;
        else
            high = middle;
    }
    return low < import->representations.count && all[low].instance == wanted ? &all[low]
                                                                              : NULL;
}

void bat_step_scale_of(bat_step_import *import, bat_step_representation *of,
                       bat_step_scale *scale)
{
    if (!of->has_context) /* else the context stays NULL */
        bat_step_get_reference(&import->file, of->record, 2, &of->context);
    of->has_context = true;
    bat_step_units_of(&import->file, &import->units, of->context, scale);
}

void bat_step_first_scale(bat_step_import *import, bat_step_scale *scale)
{
    if (import->representations.count)
        bat_step_scale_of(import, import->representations.items, scale);
    else
        bat_step_units_of(&import->file, &import->units, NULL, scale);
}

batten_status bat_step_items_of(const bat_step_import *import,
                                const bat_step_representation *of, int *count, size_t *at)
{
    return bat_step_get_list(&import->file, of->record, 1, count, at);
}

/* ---- finding ---- */

/* Its name, items and context are in the part REPRESENTATION of a complex instance. */
static batten_status add_to_outline(bat_step_import *import, const bat_step_instance *instance,
                                    bool is_shape)
{
    const bat_step_record *record = bat_step_as(&import->file, instance, "REPRESENTATION");
    const bat_step_representation made = {
        .instance = bat_step_index(&import->file, instance),
        .record = record ? record : bat_step_first(&import->file, instance),
        .is_shape = is_shape};
    return bat_list_add(import->input, &import->representations, &made);
}

/* By instance; of the same one that which is a shape first. */
static int compare(const void *a, const void *b)
{
    const bat_step_representation *x = a, *y = b;
    if (x->instance != y->instance)
        return x->instance < y->instance ? -1 : 1;
    return (int)y->is_shape - (int)x->is_shape;
}

static void sort_out_doubles(bat_list *list)
{
    bat_step_representation *all = list->items;
    size_t kept = 0;
    if (list->count > 1)
        qsort(all, list->count, sizeof *all, compare);
    for (size_t k = 0; k < list->count; k++)
        if (kept == 0 || all[kept - 1].instance != all[k].instance)
            all[kept++] = all[k];
    list->count = kept;
    for (size_t k = 0; k < kept; k++)
        all[k].first = (uint32_t)k;
}

static batten_status find_all(bat_step_import *import)
{
    const bat_step_outline *outline = &import->outline;
    const bat_step_instance *instances = import->file.instances.items;
    const uint32_t *shapes = outline->representations.items, *maps = outline->maps.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < outline->representations.count; k++)
        status = add_to_outline(import, &instances[shapes[k]], true);
    for (size_t k = 0; status == BATTEN_OK && k < outline->maps.count; k++) {
        const bat_step_instance *mapped = NULL;
        const bat_step_record *map =
            bat_step_as(&import->file, &instances[maps[k]], "REPRESENTATION_MAP");
        /* A bad one is noted where it is used. */
        if (bat_step_get_reference(&import->file, map, 1, &mapped) == BATTEN_OK)
            status = add_to_outline(import, mapped, false);
    }
    sort_out_doubles(&import->representations);
    return status;
}

/* ---- tying together ---- */

/* The two of a relationship, which stand in its second-last arguments; NULL for others. */
static batten_status read_pair(const bat_step_import *import, uint32_t relation,
                               bat_step_representation *pair[2])
{
    const bat_step_instance *instance =
        (const bat_step_instance *)import->file.instances.items + relation;
    const bat_step_record *record =
        bat_step_as(&import->file, instance, "REPRESENTATION_RELATIONSHIP");
    const bat_step_instance *ends[2] = {NULL, NULL};
    batten_status status = BATTEN_OK;
    if (!record)
        record = bat_step_first(&import->file, instance);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = bat_step_get_reference(&import->file, record, 2 + k, &ends[k]);
        pair[k] = status == BATTEN_OK ? bat_step_representation_of(import, ends[k]) : NULL;
    }
    return status;
}

/* The one that stands for all tied to it; ways to it become shorter. */
static uint32_t find(bat_step_representation *all, uint32_t at)
{
    while (all[at].first != at) {
        all[at].first = all[all[at].first].first;
        at = all[at].first;
    }
    return at;
}

static batten_status tie(bat_step_import *import)
{
    const uint32_t *relations = import->outline.relations.items;
    const bat_step_instance *instances = import->file.instances.items;
    bat_step_representation *all = import->representations.items;
    for (size_t k = 0; k < import->outline.relations.count; k++) {
        bat_step_representation *pair[2];
        batten_status status = read_pair(import, relations[k], pair);
        if (status != BATTEN_OK)
            status = bat_step_leave_out(&import->file, &import->census,
                                        &instances[relations[k]], status);
        if (status != BATTEN_OK)
            return status;
        if (!pair[0] || !pair[1])
            continue;
        const uint32_t a = find(all, (uint32_t)(pair[0] - all));
        const uint32_t b = find(all, (uint32_t)(pair[1] - all));
        all[a].first = all[b].first = a < b ? a : b;
    }
    /* The first of a definition comes before the others. */
    for (size_t k = 0; k < import->representations.count; k++)
        all[k].first = all[all[k].first].first;
    return BATTEN_OK;
}

/* ---- what they are the shape of ---- */

/* The last failure, which costs a name alone. */
static void note_nameless(const bat_step_file *file)
{
    const bat_input *input = file->input;
    int line = 0;
    const char *reason = bat_input_reason(input, &line);
    batten_notes_add(input->notes, input->file, line, "", "%.400s; a product loses its name",
                     reason);
}

/* From the definition over its formation to the product, which has the name. */
static void check_product(const bat_step_file *file, const bat_step_instance *definition)
{
    const bat_step_instance *formation = NULL, *product = NULL;
    if (bat_step_get_reference(file, bat_step_first(file, definition), 2, &formation) !=
            BATTEN_OK ||
        bat_step_get_reference(file, bat_step_first(file, formation), 2, &product) != BATTEN_OK)
        note_nameless(file);
}

static void read_definition(bat_step_import *import, const bat_step_instance *instance)
{
    const bat_step_file *file = &import->file;
    const bat_step_record *record = bat_step_first(file, instance);
    const bat_step_instance *property = NULL, *shape = NULL, *of = NULL;
    char keyword[BAT_STEP_KEYWORD_SIZE];
    if (bat_step_get_reference(file, record, 0, &property) != BATTEN_OK ||
        bat_step_get_reference(file, record, 1, &shape) != BATTEN_OK) {
        note_nameless(file);
        return;
    }
    bat_step_representation *representation = bat_step_representation_of(import, shape);
    if (!representation)
        return;
    if (bat_step_get_reference(file, bat_step_first(file, property), 2, &of) != BATTEN_OK) {
        note_nameless(file);
        return;
    }
    bat_step_representation *definition =
        (bat_step_representation *)import->representations.items + representation->first;
    bat_step_keyword(file, of, keyword);
    if (bat_step_as(file, of, "PRODUCT_DEFINITION") ||
        bat_step_as(file, of, "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS")) {
        definition->is_product = true;
        if (!definition->product) {
            definition->product = of;
            check_product(file, of);
        }
    } else if (bat_step_as(file, of, "SHAPE_ASPECT") || bat_step_as(file, of, "DATUM") ||
               bat_step_as(file, of, "DATUM_FEATURE")) {
        definition->is_aspect = true;
    }
}

batten_status bat_step_find_representations(bat_step_import *import)
{
    const uint32_t *definitions = import->outline.definitions.items;
    const bat_step_instance *instances = import->file.instances.items;
    bat_step_scale scale;
    import->representations = (bat_list){.size = sizeof(bat_step_representation)};
    batten_status status = find_all(import);
    if (status == BATTEN_OK)
        status = tie(import);
    if (status != BATTEN_OK)
        return status;
    for (size_t k = 0; k < import->outline.definitions.count; k++)
        read_definition(import, &instances[definitions[k]]);
    /* The unit of the model is that of the first. */
    if (import->representations.count)
        bat_step_scale_of(import, import->representations.items, &scale);
    return BATTEN_OK;
}
