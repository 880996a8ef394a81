/* The parameters of a design: listed, put in the order of their needs, evaluated. */
#include "design/text/document.h"
#include "design/text/spelling.h"

#include <string.h>

/* ---- what expressions may name ---- */

static const bat_quantity *find_parameter(void *user, const char *name, size_t length)
{
    const bat_document *d = user;
    for (int i = 0; i < d->parameter_count; i++) {
        const bat_parameter *p = &d->parameters[i];
        if (p->known && strlen(p->name) == length && memcmp(p->name, name, length) == 0)
            return &p->value;
    }
    return NULL;
}

static const char *nearest_parameter(void *user, const char *name)
{
    const bat_document *d = user;
    const char *near = NULL;
    int best = 99;
    for (int i = 0; i < d->parameter_count; i++)
        if (strcmp(name, d->parameters[i].name) != 0 &&
            bat_is_nearer(name, d->parameters[i].name, &best))
            near = d->parameters[i].name;
    return near;
}

bat_names bat_document_names(bat_document *document)
{
    return (bat_names){document->unit_metres, find_parameter, document, nearest_parameter};
}

/* ---- parameters ---- */

static bool is_plain_name(const char *name)
{
    const size_t length = strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_"
                                       "0123456789");
    return length > 0 && !name[length] && !strchr("0123456789", *name);
}

static void list_parameter(bat_document *d, int node)
{
    const bat_node *at = &d->tree.nodes[node];
    const char *name = d->tree.nodes[at->key].word;
    if (!is_plain_name(name) || bat_expression_has_word(name, strlen(name)))
        bat_complain(
            d, at->key,
            "'%s' cannot name a parameter; use letters, digits and '_', and no function", name);
    else if (at->kind != BAT_NODE_WORD)
        bat_complain(d, node, "the parameter %s must be a number, with or without a unit",
                     name);
    else
        d->parameters[d->parameter_count++] = (bat_parameter){.name = name, .node = node};
}

static int parameter_index(const bat_document *d, const char *name, size_t length)
{
    for (int i = 0; i < d->parameter_count; i++)
        if (strlen(d->parameters[i].name) == length &&
            memcmp(d->parameters[i].name, name, length) == 0)
            return i;
    return -1;
}

/* Fill `begin` and, unless NULL, `needs`; the number of needs. */
static int parameter_needs(const bat_document *d, int *begin, int *needs)
{
    int count = 0;
    for (int i = 0; i < d->parameter_count; i++) {
        const char *word = d->tree.nodes[d->parameters[i].node].word;
        const char *name;
        size_t position = 0, length;
        begin[i] = count;
        while (*word == '=' && bat_expression_next_name(word, &position, &name, &length)) {
            const int need = parameter_index(d, name, length);
            if (need >= 0 && needs)
                needs[count] = need;
            count += need >= 0;
        }
    }
    begin[d->parameter_count] = count;
    return count;
}

static void evaluate_parameter(bat_document *d, bat_parameter *p)
{
    const bat_names names = bat_document_names(d);
    bool vanished = false;
    const char *word = d->tree.nodes[p->node].word;
    p->known = bat_quantity_read(word, &names, &vanished, &p->value) == BATTEN_OK;
    if (!p->known)
        bat_complain(d, p->node, "%s", batten_message());
    if (vanished)
        batten_notes_add(d->complaints->notes, d->file_name, d->tree.nodes[p->node].line,
                         p->name, "%s is too small for a number and became 0", word);
    /* One error is enough: what uses it must not complain too. */
    p->known = true;
}

static batten_status order_parameters(bat_document *d, bat_graph *graph, int *order, int *cycle,
                                      const char **names)
{
    const int ring = bat_graph_order(graph, order, cycle);
    if (ring < 0)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; ring > 0 && i <= ring; i++)
        names[i] = d->parameters[cycle[i]].name;
    if (ring > 0)
        bat_complain_of_ring(d, d->parameters[cycle[0]].node, "parameters", ring, names);
    for (int i = 0; ring == 0 && i < d->parameter_count; i++)
        evaluate_parameter(d, &d->parameters[order[i]]);
    return BATTEN_OK;
}

static batten_status evaluate_parameters(bat_document *d)
{
    const size_t count = (size_t)d->parameter_count;
    bat_graph graph = {d->parameter_count, bat_array(count + 1, sizeof(int)), NULL};
    int *order = bat_array(2 * count + 1, sizeof *order);
    const char **names = bat_array(count + 1, sizeof *names);
    batten_status status = graph.begin && order && names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        const int needs = parameter_needs(d, graph.begin, NULL);
        graph.needs = bat_array((size_t)needs, sizeof *graph.needs);
        status = graph.needs ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        parameter_needs(d, graph.begin, graph.needs);
        status = order_parameters(d, &graph, order, order + count, names);
    }
    bat_release(names);
    bat_release(order);
    bat_graph_release(&graph);
    return status;
}

batten_status bat_parameters_read(bat_document *d, int node, int count)
{
    d->parameters = bat_arena_array(&d->arena, (size_t)count, sizeof *d->parameters);
    if (!d->parameters)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = node < 0 ? -1 : d->tree.nodes[node].first; i >= 0; i = d->tree.nodes[i].next)
        list_parameter(d, i);
    return evaluate_parameters(d);
}
