/* Which entities are parts of others, and so do not stand for themselves. */
#include "exchange/iges/read/references.h"

/* A part of a pattern that is being repeated. */
typedef struct {
    const char *begin;
    int left;
} repeated;

/* Behind the ')' that belongs to the '(' at c. */
static const char *past_group(const char *c)
{
    int open = 0;
    do {
        open += (*c == '(') - (*c == ')');
        c++;
    } while (open > 0);
    return c;
}

static void mark(bat_iges_item *item, size_t index)
{
    const bat_iges_entry *entry = NULL;
    int id = 0;
    if (bat_iges_integer(item->parameters, index, &id) == BATTEN_OK && id > 0 &&
        id != item->entry->id && bat_iges_find(item->reading, id, &entry) == BATTEN_OK)
        bat_iges_shape_of(item->reading, entry)->is_part = true;
}

static void mark_parts_of(bat_iges_item *item)
{
    enum { DEEPEST = 4 };
    repeated stack[DEEPEST];
    int depth = 0, count = 0;
    size_t at = 1;
    for (const char *c = item->row->references; *c && at < bat_iges_count_of(item->parameters);)
        if (*c == '(' && count <= 0) {
            c = past_group(c);
        } else if (*c == '(') {
            assert(depth < DEEPEST);
            stack[depth++] = (repeated){++c, count};
        } else if (*c == ')') {
            c = --stack[depth - 1].left > 0 ? stack[depth - 1].begin : c + 1;
            depth -= stack[depth - 1].left == 0;
        } else {
            if (*c == 'p')
                mark(item, at);
            if (*c == 'n' && bat_iges_integer(item->parameters, at, &count) != BATTEN_OK)
                return;
            at++;
            c++;
        }
}

batten_status bat_iges_mark_parts(bat_iges_reading *reading)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < reading->file.entries.count; k++) {
        const bat_iges_entry *entry = bat_iges_entry_at(reading, k);
        bat_iges_item item;
        if (entry->is_broken || !bat_iges_row_of(reading, entry->type)->references)
            continue;
        status = bat_iges_open(reading, entry, &item);
        if (status == BATTEN_OK)
            mark_parts_of(&item);
        bat_iges_close(&item);
        if (bat_iges_is_fault_of_data(status))
            status = BATTEN_OK; /* it is said when the entity is read */
    }
    return status;
}
