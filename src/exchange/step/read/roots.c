/* Solids and such that no product leads to: what stands alone is read all the same, the rest is left out by name. */
#include "exchange/step/read/product.h"

#include "exchange/step/text/scan.h"

#include <stdlib.h>
#include <string.h>

/* What refers to a root. */
typedef enum {
    LOOKS, /* nothing but colours, layers and groups */
    WHOLE, /* an item that it is a part of */
    HOLDER /* a representation; no product leads there, else the root would have been read */
} use;

static use use_by(const bat_step_record *record)
{
    static const char *const looks[] = {"STYLED_ITEM", "INVISIBILITY", "_ASSIGNMENT", "_USAGE"};
    static const char *const holders[] = {"REPRESENTATION", "REPRESENTATION_WITH_PARAMETERS",
                                          "REPRESENTATION_WITH_ACCURACY_PARAMETERS"};
    for (size_t k = 0; k < sizeof looks / sizeof looks[0]; k++)
        if (bat_step_keyword_ends(record, looks[k]))
            return LOOKS;
    for (size_t k = 0; k < sizeof holders / sizeof holders[0]; k++)
        if (bat_step_keyword_ends(record, holders[k]))
            return HOLDER;
    return WHOLE;
}

/* The strongest use of each instance that the record refers to. */
static void mark_references(const bat_step_import *import, const bat_step_record *record,
                            unsigned char *uses)
{
    const char *data = import->input->data;
    const size_t size = import->input->size;
    const use by = use_by(record);
    size_t at = (size_t)(record->keyword - data) + record->arguments;
    const size_t end = bat_step_item_end(data, size, at);
    while (at < end) {
        const size_t next = bat_step_token_end(data, size, at);
        if (data[at] == '#') {
            const bat_step_instance *to =
                bat_step_find(&import->file, strtoull(data + at + 1, NULL, 10));
            unsigned char *known = to ? &uses[bat_step_index(&import->file, to)] : NULL;
            if (known && *known < by)
                *known = (unsigned char)by;
        }
        at = bat_step_blank(data, size, next, NULL);
    }
}

static batten_status mark_all(const bat_step_import *import, unsigned char *uses)
{
    const bat_step_record *records = import->file.records.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < import->file.records.count; k++) {
        mark_references(import, &records[k], uses);
        status =
            bat_input_step(import->input, (size_t)(records[k].keyword - import->input->data));
    }
    return status;
}

static bool is_left(const bat_step_import *import)
{
    const uint32_t *roots = import->outline.roots.items;
    for (size_t k = 0; k < import->outline.roots.count; k++)
        if (!import->taken[roots[k]])
            return true;
    return false;
}

static batten_status take_root(const bat_step_target *target, const bat_step_instance *root,
                               use by)
{
    const bat_step_file *file = &target->import->file;
    if (by == HOLDER)
        return bat_step_leave_item(
            target, root,
            bat_step_fail(file, root, BATTEN_UNSUPPORTED,
                          "it stands in a representation that no product leads to"));
    bat_step_warn(file, root, "no representation lists it; it is read all the same");
    return bat_step_read_item(target, root);
}

static batten_status take_all(const bat_step_target *target, const unsigned char *uses)
{
    bat_step_import *import = target->import;
    const bat_step_instance *instances = import->file.instances.items;
    const uint32_t *roots = import->outline.roots.items;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < import->outline.roots.count; k++) {
        const uint32_t root = roots[k];
        if (import->taken[root] || uses[root] == WHOLE)
            continue;
        import->taken[root] = true;
        status = take_root(target, &instances[root], uses[root]);
    }
    return status;
}

batten_status bat_step_read_roots(bat_step_import *import, batten_model *model)
{
    unsigned char *uses = NULL;
    bat_step_target target = {.import = import, .model = model, .product = ""};
    if (!is_left(import))
        return BATTEN_OK;
    batten_status status =
        bat_input_array(import->input, import->file.instances.count + 1, sizeof *uses, &uses);
    if (status == BATTEN_OK)
        status = mark_all(import, uses);
    if (status == BATTEN_OK) {
        bat_step_first_scale(import, &target.scale);
        status = take_all(&target, uses);
    }
    bat_release(uses);
    return status;
}
