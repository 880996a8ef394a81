/* Features by their names: those of a design, sorted, and the operations of a table. */
#include "design/text/document.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    const char *name;
    int index;
} named;

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const named *)a)->name, ((const named *)b)->name);
}

batten_status bat_names_sort(bat_document *d)
{
    const size_t count = (size_t)d->feature_count;
    d->names = bat_arena_array(&d->arena, count, sizeof *d->names);
    d->named = bat_arena_array(&d->arena, count, sizeof *d->named);
    named *sorted = bat_array(count, sizeof *sorted);
    if (!d->names || !d->named || !sorted) {
        bat_release(sorted);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (size_t i = 0; i < count; i++)
        sorted[i] = (named){d->features[i].name, (int)i};
    qsort(sorted, count, sizeof *sorted, compare_names);
    for (size_t i = 0; i < count; i++) {
        d->names[i] = sorted[i].name;
        d->named[i] = sorted[i].index;
    }
    bat_release(sorted);
    return BATTEN_OK;
}

int bat_document_feature(const bat_document *document, const char *name)
{
    int low = 0, high = document->feature_count;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        const int order = strcmp(document->names[middle], name);
        if (order == 0)
            return document->named[middle];
        if (order < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return -1;
}

const bat_feature *bat_features_find(const bat_features *features, const char *name)
{
    for (int i = 0; i < features->count; i++)
        if (strcmp(features->at[i]->shown.name, name) == 0)
            return features->at[i];
    return NULL;
}
