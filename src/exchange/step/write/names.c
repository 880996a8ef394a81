/* What products are called. Programs show the id of a product, or its name, and some take two
 * of one id for the same. */
#include "exchange/step/write/writing.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *name;
    int index;
} called;

static int compare_names(const void *left, const void *right)
{
    return strcmp(((const called *)left)->name, ((const called *)right)->name);
}

static int compare(const void *left, const void *right)
{
    const called *a = left, *b = right;
    const int by_name = compare_names(a, b);
    return by_name ? by_name : (a->index > b->index) - (a->index < b->index);
}

/* The first of a name has it as its id; the others have a number behind it, and such a one that
 * nothing is called so. */
static batten_status number_all(const called *all, int count, int *numbers)
{
    batten_text id = BATTEN_TEXT;
    int number = 1;
    for (int i = 1; i < count && !id.failed; i++) {
        called wanted = {NULL, 0};
        if (strcmp(all[i].name, all[i - 1].name) != 0) {
            number = 1;
            continue;
        }
        do {
            id.length = 0;
            batten_text_add(&id, "%s.%d", all[i].name, ++number);
            wanted.name = id.bytes;
        } while (!id.failed &&
                 bsearch(&wanted, all, (size_t)count, sizeof *all, compare_names));
        numbers[all[i].index] = number;
    }
    const bool failed = id.failed;
    batten_text_free(&id);
    return failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
}

batten_status bat_step_name_products(bat_step_writing *w)
{
    const int count = w->parts.count;
    w->names = bat_array((size_t)count, sizeof *w->names);
    w->numbers = bat_array((size_t)count, sizeof *w->numbers);
    called *all = bat_array((size_t)count, sizeof *all);
    if (!w->names || !w->numbers || !all) {
        bat_release(all);
        return BATTEN_OUT_OF_MEMORY;
    }
    bat_definitions_names(&w->parts, w->names);
    w->names[0] = w->options->name;
    for (int i = 0; i < count; i++) {
        w->names[i] = w->names[i][0] ? w->names[i] : "part";
        all[i] = (called){w->names[i], i};
    }
    qsort(all, (size_t)count, sizeof *all, compare);
    const batten_status status = number_all(all, count, w->numbers);
    bat_release(all);
    return status;
}

batten_status bat_step_add_product_id(const bat_step_writing *w, int index, batten_text *id)
{
    batten_text_add(id, "%s", w->names[index]);
    if (w->numbers[index])
        batten_text_add(id, ".%d", w->numbers[index]);
    return id->failed ? BATTEN_OUT_OF_MEMORY : BATTEN_OK;
}
