/* A design read from its text: the head, the parameters, then features and outputs with their
 * arguments, and the order in which features are evaluated. */
#include "design/text/document.h"
#include "design/text/spelling.h"

#include <stdio.h>
#include <string.h>

/* The node of a section of names and the number of its lines; -1 when there is none. */
static int find_section(bat_document *d, const char *name, int *count)
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

/* ---- features and outputs ---- */

static void unknown_operation(bat_document *d, int key, bool is_output)
{
    const bat_node *nodes = d->tree.nodes;
    const char *word = nodes[key].word, *near = NULL;
    int best = 99;
    for (int i = 0; i < d->operations->count; i++) {
        const batten_feature *f = &d->operations->at[i]->shown;
        if (f->is_output == is_output && bat_is_nearer(word, f->name, &best))
            near = f->name;
    }
    const bat_feature *other = bat_features_find(d->operations, word);
    if (other && other->shown.is_output != is_output)
        bat_complain(d, key, "'%s' belongs under '%s'", word,
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
    const bat_feature *feature = bat_features_find(d->operations, d->tree.nodes[key].word);
    if (feature && feature->shown.is_output == is_output)
        entry->feature = feature;
    else
        unknown_operation(d, key, is_output);
}

/* The operation of "hull.step: hull". */
static const bat_feature *operation_by_ending(const bat_features *all, const char *file)
{
    const bat_feature *found = NULL;
    for (int i = 0; i < all->count; i++)
        if (all->at[i]->takes_file && all->at[i]->takes_file(file))
            found = all->at[i];
    return found;
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
        entry->feature = operation_by_ending(d->operations, entry->name);
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
    const int node = find_section(d, name, &count);
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
        bat_complain_of_ring(d, d->features[cycle[0]].key, "features", ring, names);
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status read_sections(bat_document *d)
{
    if (d->tree.nodes[0].kind != BAT_NODE_MAP) {
        bat_complain(d, 0, "a design begins with 'batten: %d' and has sections 'name: ...'",
                     BAT_FORMAT_VERSION);
        return BATTEN_OK;
    }
    int count;
    bat_head_read(d);
    const int parameters = find_section(d, "parameters", &count);
    batten_status status = bat_parameters_read(d, parameters, count);
    if (status == BATTEN_OK) {
        bat_tolerance_read(d);
        status = list_entries(d, "features", &d->features, &d->feature_count);
    }
    if (status == BATTEN_OK)
        status = list_entries(d, "outputs", &d->outputs, &d->output_count);
    if (status == BATTEN_OK)
        status = bat_names_sort(d);
    for (int i = 0; i < d->feature_count && status == BATTEN_OK; i++)
        status = bat_arguments_read(d, &d->features[i]);
    for (int i = 0; i < d->output_count && status == BATTEN_OK; i++)
        status = bat_arguments_read(d, &d->outputs[i]);
    return status == BATTEN_OK ? order_features(d) : status;
}

batten_status bat_document_parse(const char *text, size_t length,
                                 const batten_design_options *options,
                                 const bat_features *operations, batten_notes *notes,
                                 bat_document *out)
{
    bat_complaints complaints = {.notes = notes};
    bat_place place = {0, 0};
    *out = (bat_document){.allow_outside = options->allow_outside,
                          .complaints = &complaints,
                          .operations = operations};
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
        bat_complain_at(&complaints, place.line, place.column, sentence);
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
