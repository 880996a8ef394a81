/* The graph of what needs what: an order without recursion, rings, and all that one thing needs. */
#include "design/text/document.h"

#include <string.h>

/* ---- order: depth first with a stack of our own ---- */

typedef enum { UNSEEN, OPEN, DONE } mark;

typedef struct {
    const bat_graph *graph;
    mark *marks; /* [count] */
    int *stack;  /* [count] */
    int *next;   /* [count] which need of each open thing comes next */
    int depth;
} search;

static batten_status begin_search(search *s, const bat_graph *graph)
{
    const size_t count = (size_t)graph->count;
    *s = (search){.graph = graph};
    s->marks = bat_array(count, sizeof *s->marks);
    s->stack = bat_array(count, sizeof *s->stack);
    s->next = bat_array(count, sizeof *s->next);
    return s->marks && s->stack && s->next ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void end_search(search *s)
{
    bat_release(s->marks);
    bat_release(s->stack);
    bat_release(s->next);
}

static void open_thing(search *s, int i)
{
    s->marks[i] = OPEN;
    s->next[i] = s->graph->begin[i];
    s->stack[s->depth++] = i;
}

/* From the open thing `again` to the top of the stack, and back to it. */
static int copy_cycle(const search *s, int again, int *cycle)
{
    int first = s->depth - 1;
    while (s->stack[first] != again)
        first--;
    const int count = s->depth - first;
    memcpy(cycle, s->stack + first, (size_t)count * sizeof *cycle);
    cycle[count] = again;
    return count;
}

/* Visit `from` and what it needs; the length of a ring, or 0. */
static int order_from(search *s, int from, int *order, int *done, int *cycle)
{
    open_thing(s, from);
    while (s->depth > 0) {
        const int i = s->stack[s->depth - 1];
        if (s->next[i] == s->graph->begin[i + 1]) {
            s->marks[i] = DONE;
            s->depth--;
            order[(*done)++] = i;
            continue;
        }
        const int need = s->graph->needs[s->next[i]++];
        if (s->marks[need] == OPEN)
            return copy_cycle(s, need, cycle);
        if (s->marks[need] == UNSEEN)
            open_thing(s, need);
    }
    return 0;
}

int bat_graph_order(const bat_graph *graph, int *order, int *cycle)
{
    search s;
    int ring = begin_search(&s, graph) == BATTEN_OK ? 0 : -1;
    for (int i = 0, done = 0; ring == 0 && i < graph->count; i++)
        if (s.marks[i] == UNSEEN)
            ring = order_from(&s, i, order, &done, cycle);
    end_search(&s);
    return ring;
}

batten_status bat_graph_mark(const bat_graph *graph, int from, bool *marked)
{
    int *stack = bat_array((size_t)graph->count, sizeof *stack);
    if (!stack)
        return BATTEN_OUT_OF_MEMORY;
    int depth = 0;
    if (!marked[from])
        stack[depth++] = from;
    marked[from] = true;
    while (depth > 0) {
        const int i = stack[--depth];
        for (int k = graph->begin[i]; k < graph->begin[i + 1]; k++) {
            const int need = graph->needs[k];
            if (!marked[need])
                stack[depth++] = need;
            marked[need] = true;
        }
    }
    bat_release(stack);
    return BATTEN_OK;
}

/* ---- the graph of a document ---- */

bool bat_item_is_feature(batten_value_kind kind, const bat_item *item)
{
    return kind == BATTEN_VALUE_MODEL || (kind == BATTEN_VALUE_POINTS && item->text);
}

void bat_entry_inputs(const bat_entry *entry, void (*visit)(void *user, int feature),
                      void *user)
{
    if (!entry->feature || !entry->arguments)
        return;
    const batten_feature *f = &entry->feature->shown;
    for (int i = 0; i < f->parameter_count; i++) {
        const batten_value_kind kind = f->parameters[i].kind;
        const bool may_name = kind == BATTEN_VALUE_MODEL || kind == BATTEN_VALUE_POINTS;
        for (int k = 0; may_name && k < entry->arguments[i].count; k++) {
            const bat_item *item = &entry->arguments[i].items[k];
            if (bat_item_is_feature(kind, item) && item->count >= 0)
                visit(user, item->count);
        }
    }
}

static void count_need(void *user, int feature)
{
    (void)feature;
    ++*(int *)user;
}

static void add_need(void *user, int feature)
{
    int **place = user;
    *(*place)++ = feature;
}

batten_status bat_document_graph(const bat_document *document, bat_graph *out)
{
    const int count = document->feature_count;
    int need_count = 0;
    for (int i = 0; i < count; i++)
        bat_entry_inputs(&document->features[i], count_need, &need_count);
    int *begin = bat_array((size_t)count + 1, sizeof *begin);
    int *needs = bat_array((size_t)need_count, sizeof *needs);
    if (!begin || !needs) {
        bat_release(begin);
        bat_release(needs);
        return BATTEN_OUT_OF_MEMORY;
    }
    int *place = needs;
    for (int i = 0; i < count; i++) {
        begin[i] = (int)(place - needs);
        bat_entry_inputs(&document->features[i], add_need, &place);
    }
    begin[count] = (int)(place - needs);
    *out = (bat_graph){count, begin, needs};
    return BATTEN_OK;
}

void bat_graph_release(bat_graph *graph)
{
    bat_release(graph->begin);
    bat_release(graph->needs);
    *graph = (bat_graph){0, NULL, NULL};
}
