#include "design/text/document.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The newest version of the format that we know. */
#define FORMAT_VERSION 1

/* ---- complaints ---- */

static void complain_at(bat_complaints *c, int line, int column, const char *sentence)
{
    char entity[32] = "";
    if (line > 0)
        snprintf(entity, sizeof entity, "column %d", column);
    batten_notes_add(c->notes, c->file, line, entity, "%s", sentence);
    if (c->count++ > 0)
        return;
    if (line > 0)
        snprintf(c->first, sizeof c->first, "%s:%d:%d: %s", c->file, line, column, sentence);
    else
        snprintf(c->first, sizeof c->first, "%s: %s", c->file, sentence);
}

void bat_complain(bat_document *document, int node, const char *format, ...)
{
    char sentence[600];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    const bat_node *at = node >= 0 ? &document->tree.nodes[node] : NULL;
    complain_at(document->complaints, at ? at->line : 0, at ? at->column : 0, sentence);
}

/* ---- the head: version, units, tolerance, title ---- */

static const char *const sections[] = {"batten",     "units",    "tolerance", "title",
                                       "parameters", "features", "outputs"};
#define SECTION_COUNT ((int)(sizeof sections / sizeof sections[0]))

static void check_sections(bat_document *d)
{
    const bat_node *nodes = d->tree.nodes;
    for (int i = nodes[0].first; i >= 0; i = nodes[i].next) {
        const char *word = nodes[nodes[i].key].word;
        int known = 0, best = 99;
        while (known < SECTION_COUNT && strcmp(word, sections[known]) != 0)
            known++;
        if (known < SECTION_COUNT)
            continue;
        const char *near = NULL;
        for (int k = 0; k < SECTION_COUNT; k++)
            if (bat_is_nearer(word, sections[k], &best))
                near = sections[k];
        bat_complain(d, nodes[i].key, "a design has no section '%s'%s%s%s", word,
                     near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
    }
}

/* The word of a section, or NULL: absent, or not a word, which is said. */
static const char *head_word(bat_document *d, const char *section, int *node)
{
    *node = bat_tree_find(&d->tree, 0, section);
    if (*node < 0)
        return NULL;
    const bat_node *at = &d->tree.nodes[*node];
    if (at->kind == BAT_NODE_WORD && *at->word)
        return at->word;
    bat_complain(d, *node, "'%s' needs a value", section);
    return NULL;
}

static void read_version(bat_document *d)
{
    int node, version = 0;
    const char *word = head_word(d, "batten", &node);
    if (node < 0)
        bat_complain(d, 0, "the line 'batten: %d', the version of the format, is missing",
                     FORMAT_VERSION);
    if (!word)
        return;
    if (bat_count_read(word, &version) != BATTEN_OK)
        bat_complain(d, node, "the version of the format: %s", batten_message());
    else if (version > FORMAT_VERSION)
        bat_complain(d, node, "the format has version %d; this Batten knows up to %d", version,
                     FORMAT_VERSION);
    else if (version < 1)
        bat_complain(d, node, "the format has no version %d; the first is 1", version);
}

static void read_tolerance(bat_document *d)
{
    int node;
    const char *word = head_word(d, "tolerance", &node);
    d->tolerance = 1e-4 / d->unit_metres;
    if (!word)
        return;
    const bat_names names = bat_document_names(d);
    bat_quantity value;
    char text[48];
    if (bat_quantity_read(word, &names, NULL, &value) != BATTEN_OK)
        bat_complain(d, node, "%s", batten_message());
    else if (value.angle || value.length > 1 || value.length < 0)
        bat_complain(d, node, "the tolerance must be a length, not %s",
                     bat_dimension_name(value.length, value.angle, text));
    else if (value.value <= 0)
        bat_complain(d, node, "the tolerance must be above 0, not %s", word);
    else
        d->tolerance = value.value;
}

static void read_units(bat_document *d)
{
    int node;
    d->unit_metres = 1;
    const char *word = head_word(d, "units", &node);
    d->has_units = word != NULL;
    if (!word)
        return;
    const double metres = batten_unit_metres(word);
    if (metres > 0)
        d->unit_metres = metres;
    else
        bat_complain(d, node, "'%s' is no unit of length; known are m mm cm km um in ft mil mi",
                     word);
}

/* ---- names ---- */

static int section(bat_document *d, const char *name, int *count)
{
    *count = 0;
    const int node = bat_tree_find(&d->tree, 0, name);
    if (node < 0)
        return -1;
    const bat_node *at = &d->tree.nodes[node];
    if (at->kind == BAT_NODE_MAP) {
        *count = at->count;
        return node;
    }
    if (at->kind != BAT_NODE_WORD || *at->word)
        bat_complain(d, node, "'%s' needs lines of the form 'name: value'", name);
    return -1;
}

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
    static const char *const taken[] = {"pi", "sin", "cos", "tan", "sqrt", "abs", "min", "max"};
    const bat_node *at = &d->tree.nodes[node];
    const char *name = d->tree.nodes[at->key].word;
    bool ok = is_plain_name(name);
    for (int i = 0; i < (int)(sizeof taken / sizeof taken[0]); i++)
        ok &= strcmp(name, taken[i]) != 0;
    if (!ok)
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

static void complain_of_ring(bat_document *d, int node, const char *what, int count,
                             const char **names)
{
    char ring[400];
    size_t used = 0;
    for (int i = 0; i <= count && used < sizeof ring; i++) {
        const int more =
            snprintf(ring + used, sizeof ring - used, "%s%s", i ? " -> " : "", names[i]);
        used += (size_t)more;
    }
    bat_complain(d, node, "%s need each other in a ring: %s", what, ring);
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
    /* One error is enough: what uses it shall not complain too. */
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
        complain_of_ring(d, d->parameters[cycle[0]].node, "parameters", ring, names);
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

static batten_status read_parameters(bat_document *d)
{
    int count;
    const int node = section(d, "parameters", &count);
    d->parameters = bat_arena_array(&d->arena, (size_t)count, sizeof *d->parameters);
    if (!d->parameters)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = node < 0 ? -1 : d->tree.nodes[node].first; i >= 0; i = d->tree.nodes[i].next)
        list_parameter(d, i);
    return evaluate_parameters(d);
}

/* ---- features and outputs ---- */

static void unknown_operation(bat_document *d, int key, bool is_output)
{
    const bat_node *nodes = d->tree.nodes;
    const char *word = nodes[key].word, *near = NULL;
    int best = 99;
    for (int i = 0; i < batten_feature_count(); i++) {
        const batten_feature *f = batten_feature_at(i);
        if (f->is_output == is_output && bat_is_nearer(word, f->name, &best))
            near = f->name;
    }
    const bat_feature *other = bat_feature_find(word);
    if (other && other->shown.is_output != is_output)
        bat_complain(d, key, "'%s' stands under '%s'", word,
                     is_output ? "features" : "outputs");
    else
        bat_complain(d, key, "there is no operation '%s'%s%s%s", word,
                     near ? "; did you mean '" : "", near ? near : "",
                     near ? "'?" : "; the first key names the operation");
}

/* The operation of an entry that is a map: its first key. */
static void find_operation(bat_document *d, bat_entry *entry, bool is_output)
{
    const bat_node *at = &d->tree.nodes[entry->node];
    if (at->kind != BAT_NODE_MAP || at->first < 0) {
        bat_complain(d, entry->node, "%s '%s' needs the form {operation: input, ...}",
                     is_output ? "the output" : "the feature", entry->name);
        return;
    }
    const int key = d->tree.nodes[at->first].key;
    const bat_feature *feature = bat_feature_find(d->tree.nodes[key].word);
    if (feature && feature->shown.is_output == is_output)
        entry->feature = feature;
    else
        unknown_operation(d, key, is_output);
}

/* The operation of "hull.step: hull". */
static const bat_feature *operation_by_ending(const char *file)
{
    batten_picture_format format;
    const char *dot = strrchr(file, '.');
    if (batten_picture_format_from_name(file, &format))
        return bat_feature_find("picture");
    return bat_feature_find(dot && strcmp(dot, ".json") == 0 ? "check" : "write");
}

static void list_output(bat_document *d, bat_entry *entry)
{
    if (!d->allow_outside && bat_path_leaves(entry->name))
        bat_complain(d, entry->key,
                     "the output %s leads out of the folder of the design; --allow-outside "
                     "allows it",
                     entry->name);
    const bat_node *at = &d->tree.nodes[entry->node];
    if (at->kind == BAT_NODE_LIST || (at->kind == BAT_NODE_WORD && *at->word))
        entry->feature = operation_by_ending(entry->name);
    else
        find_operation(d, entry, true);
    if (!entry->feature && at->kind != BAT_NODE_MAP)
        bat_complain(d, entry->key, "no operation writes '%s'", entry->name);
}

static batten_status list_entries(bat_document *d, const char *name, bat_entry **entries,
                                  int *entry_count)
{
    int count;
    const bool is_output = strcmp(name, "outputs") == 0;
    const int node = section(d, name, &count);
    *entries = bat_arena_array(&d->arena, (size_t)count, sizeof **entries);
    if (!*entries)
        return BATTEN_OUT_OF_MEMORY;
    const bat_node *nodes = d->tree.nodes;
    for (int i = node < 0 ? -1 : nodes[node].first; i >= 0; i = nodes[i].next) {
        bat_entry *entry = &(*entries)[(*entry_count)++];
        *entry = (bat_entry){.name = nodes[nodes[i].key].word, .key = nodes[i].key, .node = i};
        if (!*entry->name)
            bat_complain(d, entry->key, "a name is missing before ':'");
        else if (is_output)
            list_output(d, entry);
        else
            find_operation(d, entry, false);
    }
    return BATTEN_OK;
}

typedef struct {
    const char *name;
    int index;
} named;

static int compare_names(const void *a, const void *b)
{
    return strcmp(((const named *)a)->name, ((const named *)b)->name);
}

static batten_status sort_names(bat_document *d)
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

static batten_status order_features(bat_document *d)
{
    const size_t count = (size_t)d->feature_count;
    bat_graph graph = {0, NULL, NULL};
    d->order = bat_arena_array(&d->arena, count, sizeof *d->order);
    int *cycle = bat_arena_array(&d->arena, count + 1, sizeof *cycle);
    const char **names = bat_arena_array(&d->arena, count + 1, sizeof *names);
    batten_status status =
        d->order && cycle && names ? bat_document_graph(d, &graph) : BATTEN_OUT_OF_MEMORY;
    if (status != BATTEN_OK)
        return status;
    const int ring = bat_graph_order(&graph, d->order, cycle);
    bat_graph_release(&graph);
    if (ring < 0)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; ring > 0 && i <= ring; i++)
        names[i] = d->features[cycle[i]].name;
    if (ring > 0)
        complain_of_ring(d, d->features[cycle[0]].key, "features", ring, names);
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status read_sections(bat_document *d)
{
    if (d->tree.nodes[0].kind != BAT_NODE_MAP) {
        bat_complain(d, 0, "a design begins with 'batten: %d' and has sections 'name: ...'",
                     FORMAT_VERSION);
        return BATTEN_OK;
    }
    int node;
    read_version(d);
    check_sections(d);
    read_units(d);
    d->title = head_word(d, "title", &node);
    batten_status status = read_parameters(d);
    if (status == BATTEN_OK) {
        read_tolerance(d);
        status = list_entries(d, "features", &d->features, &d->feature_count);
    }
    if (status == BATTEN_OK)
        status = list_entries(d, "outputs", &d->outputs, &d->output_count);
    if (status == BATTEN_OK)
        status = sort_names(d);
    for (int i = 0; i < d->feature_count && status == BATTEN_OK; i++)
        status = bat_arguments_read(d, &d->features[i]);
    for (int i = 0; i < d->output_count && status == BATTEN_OK; i++)
        status = bat_arguments_read(d, &d->outputs[i]);
    return status == BATTEN_OK ? order_features(d) : status;
}

batten_status bat_document_parse(const char *text, size_t length,
                                 const batten_design_options *options, batten_notes *notes,
                                 bat_document *out)
{
    bat_complaints complaints = {.notes = notes};
    bat_place place = {0, 0};
    *out = (bat_document){.allow_outside = options->allow_outside, .complaints = &complaints};
    out->limits = options->limits ? *options->limits : batten_limits_defaults();
    out->provided_file = options->provided ? options->provided_file : NULL;
    out->provided = options->provided;
    const char *file = options->file_name ? options->file_name : "";
    out->file_name = complaints.file = bat_arena_copy(&out->arena, file, strlen(file));
    if (!out->file_name)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status =
        bat_tree_parse(text, length, out->limits.nesting, &out->tree, &place);
    if (status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY) {
        char sentence[600];
        snprintf(sentence, sizeof sentence, "%s", batten_message());
        complain_at(&complaints, place.line, place.column, sentence);
        return bat_fail(status, "%s", complaints.first);
    }
    if (status == BATTEN_OK)
        status = read_sections(out);
    out->complaints = NULL;
    if (status == BATTEN_OK && complaints.count > 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "%s", complaints.first);
    return status;
}

void bat_document_free(bat_document *document)
{
    bat_tree_free(&document->tree);
    bat_arena_free(&document->arena);
}
