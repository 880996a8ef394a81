/* The arguments of a feature or an output: words of the text become typed values. */
#include "base/plural.h"
#include "design/text/argument_words.h"
#include "design/text/document.h"
#include "design/text/spelling.h"

#include <stdio.h>
#include <string.h>

/* ---- numbers ---- */

static const char *kind_name(batten_value_kind kind)
{
    static const char *const names[] = {"the name of a feature",
                                        "a length",
                                        "an angle with its unit (30 deg, 0.5 rad)",
                                        "a number",
                                        "a whole number",
                                        "a word",
                                        "a text",
                                        "the name of a file",
                                        "yes or no",
                                        "a point [x, y, z]",
                                        "a range [a, b]",
                                        "a point [x, y, z], or the name of a feature",
                                        "a move [i, j, k, dx, dy, dz]"};
    return names[kind];
}

static bool fits(batten_value_kind kind, const bat_quantity *q)
{
    const bool is_number = q->length == 0 && q->angle == 0;
    if (kind == BATTEN_VALUE_ANGLE)
        return (q->angle == 1 && q->length == 0) || (is_number && q->value == 0);
    if (kind == BATTEN_VALUE_NUMBER || kind == BATTEN_VALUE_COUNT)
        return is_number;
    return is_number || (q->length == 1 && q->angle == 0);
}

static bool read_quantity(const bat_reading *r, batten_value_kind kind, const char *word,
                          bat_quantity *out)
{
    const bat_names names = bat_document_names(r->document);
    bool vanished = false;
    char what[700], text[48];
    if (bat_quantity_read(word, &names, &vanished, out) != BATTEN_OK) {
        snprintf(what, sizeof what, "needs %s: %s", kind_name(kind), batten_message());
        bat_complain_of(r, what);
        return false;
    }
    if (!fits(kind, out)) {
        snprintf(what, sizeof what, "needs %s; '%.60s' is %s", kind_name(kind), word,
                 bat_dimension_name(out->length, out->angle, text));
        bat_complain_of(r, what);
        return false;
    }
    if (vanished)
        batten_notes_add(r->document->complaints->notes, r->document->file_name,
                         r->document->tree.nodes[r->at].line, r->entry->name,
                         "%s is too small for a number and became 0", word);
    return true;
}

static void read_count(const bat_reading *r, const char *word, bat_item *item)
{
    char what[200];
    bat_quantity q;
    if (*word != '=') {
        if (bat_count_read(word, &item->count) != BATTEN_OK) {
            snprintf(what, sizeof what, "is wrong: %.150s", batten_message());
            bat_complain_of(r, what);
        }
        return;
    }
    if (!read_quantity(r, BATTEN_VALUE_COUNT, word, &q))
        return;
    /* Fits an int. */
    if (q.value >= 0 && q.value <= 1e9 && q.value == floor(q.value)) {
        item->count = (int)q.value;
        return;
    }
    snprintf(what, sizeof what, "must be a whole number, 0 or more, not '%.60s'", word);
    bat_complain_of(r, what);
}

/* "x", "-z", "origin": directions and the origin have names. */
static bool named_point(const char *word, double *out)
{
    const bool minus = *word == '-';
    const char *rest = minus ? word + 1 : word;
    if (strcmp(word, "origin") == 0) {
        memset(out, 0, 3 * sizeof *out);
        return true;
    }
    if (*rest < 'x' || *rest > 'z' || rest[1])
        return false;
    memset(out, 0, 3 * sizeof *out);
    out[*rest - 'x'] = minus ? -1 : 1;
    return true;
}

/* The coordinates of a list of words. */
static void read_coordinates(bat_reading r, const bat_node *node, int least, int most,
                             bat_item *item)
{
    const bat_node *nodes = r.document->tree.nodes;
    char what[120];
    if (node->count < least || node->count > most) {
        snprintf(what, sizeof what, "needs %s, not %d value%s", kind_name(r.parameter->kind),
                 node->count, bat_plural(node->count));
        bat_complain_of(&r, what);
        return;
    }
    int k = 0;
    for (int i = node->first; i >= 0; i = nodes[i].next, k++) {
        bat_quantity q;
        r.at = i;
        if (nodes[i].kind != BAT_NODE_WORD)
            bat_complain_of(&r, "has a list where a length is expected");
        else if (read_quantity(&r, BATTEN_VALUE_LENGTH, nodes[i].word, &q))
            item->number[k] = q.value;
    }
}

static void read_list_item(const bat_reading *r, const bat_node *node, bat_item *item)
{
    const batten_value_kind kind = r->parameter->kind;
    char what[120];
    if ((kind == BATTEN_VALUE_POINT || kind == BATTEN_VALUE_POINTS) &&
        node->kind == BAT_NODE_LIST) {
        read_coordinates(*r, node, 2, 3, item);
    } else if (kind == BATTEN_VALUE_MOVE && node->kind == BAT_NODE_LIST) {
        read_coordinates(*r, node, 6, 6, item);
    } else if (kind == BATTEN_VALUE_RANGE && node->kind == BAT_NODE_LIST) {
        read_coordinates(*r, node, 2, 2, item);
        if (item->number[0] >= item->number[1])
            bat_complain_of(r, "must have its lower end first, and the other above it");
    } else {
        snprintf(what, sizeof what, "needs %s, not a %s", kind_name(kind),
                 node->kind == BAT_NODE_LIST ? "list" : "map");
        bat_complain_of(r, what);
    }
}

/* One word where coordinates are expected. */
static void read_named_point(const bat_reading *r, const char *word, bat_item *item)
{
    const batten_value_kind kind = r->parameter->kind;
    if (kind == BATTEN_VALUE_POINT && named_point(word, item->number))
        return;
    char what[160];
    snprintf(what, sizeof what, "needs %s%s, not '%.60s'", kind_name(kind),
             kind == BATTEN_VALUE_POINT ? ", or one of origin x y z -x -y -z" : "", word);
    bat_complain_of(r, what);
}

static void read_item(const bat_reading *r, const bat_node *node, bat_item *item)
{
    bat_quantity q;
    const batten_value_kind kind = r->parameter->kind;
    const char *word = node->word;
    if (node->kind != BAT_NODE_WORD) {
        read_list_item(r, node, item);
        return;
    }
    switch (kind) {
    case BATTEN_VALUE_MODEL:
        bat_read_model(r, word, item);
        return;
    case BATTEN_VALUE_WORD:
        bat_read_word(r, word, item);
        return;
    case BATTEN_VALUE_TEXT:
        item->text = word;
        return;
    case BATTEN_VALUE_FILE:
        bat_read_file(r, word, item);
        return;
    case BATTEN_VALUE_YES_NO:
        bat_read_yes_no(r, word, item);
        return;
    case BATTEN_VALUE_COUNT:
        read_count(r, word, item);
        return;
    case BATTEN_VALUE_POINTS:
        /* A feature hides the axis of its name. */
        if (bat_document_feature(r->document, word) >= 0 || !named_point(word, item->number))
            bat_read_model(r, word, item);
        return;
    case BATTEN_VALUE_POINT:
    case BATTEN_VALUE_RANGE:
    case BATTEN_VALUE_MOVE:
        read_named_point(r, word, item);
        return;
    default:
        if (read_quantity(r, kind, word, &q))
            item->number[0] = q.value;
    }
}

/* ---- one argument ---- */

/* Are all words of a list names of features? */
static bool names_features(bat_document *d, const bat_node *list)
{
    for (int i = list->first; i >= 0; i = d->tree.nodes[i].next)
        if (d->tree.nodes[i].kind != BAT_NODE_WORD ||
            bat_document_feature(d, d->tree.nodes[i].word) < 0)
            return false;
    return true;
}

/* Is a list node many values, and not one point? */
static bool is_many(bat_document *d, const batten_parameter *p, const bat_node *node)
{
    const bool has_coordinates = p->kind == BATTEN_VALUE_POINT ||
                                 p->kind == BATTEN_VALUE_POINTS ||
                                 p->kind == BATTEN_VALUE_RANGE || p->kind == BATTEN_VALUE_MOVE;
    if (!p->is_list || node->kind != BAT_NODE_LIST)
        return false;
    if (!has_coordinates || !node->count)
        return true;
    for (int i = node->first; i >= 0; i = d->tree.nodes[i].next)
        if (d->tree.nodes[i].kind == BAT_NODE_LIST)
            return true;
    return p->kind == BATTEN_VALUE_POINTS && names_features(d, node);
}

static batten_status read_argument(bat_reading *r, int node, bat_argument *out)
{
    bat_document *d = r->document;
    const bat_node *at = &d->tree.nodes[node];
    const bool many = is_many(d, r->parameter, at);
    const int count = many ? at->count : 1;
    r->at = node;
    if (count == 0) {
        bat_complain_of(r, "needs at least one value");
        return BATTEN_OK;
    }
    out->items = bat_arena_array(&d->arena, (size_t)count, sizeof *out->items);
    if (!out->items)
        return BATTEN_OUT_OF_MEMORY;
    out->count = count;
    out->given = true;
    int k = 0;
    for (int i = many ? at->first : node; k < count; i = d->tree.nodes[i].next) {
        r->at = i;
        read_item(r, &d->tree.nodes[i], &out->items[k++]);
    }
    return BATTEN_OK;
}

static batten_status read_standard(bat_reading *r, bat_argument *out)
{
    if (!r->parameter->standard)
        return BATTEN_OK;
    const bat_node node = {.kind = BAT_NODE_WORD, .word = r->parameter->standard};
    out->items = bat_arena_array(&r->document->arena, 1, sizeof *out->items);
    if (!out->items)
        return BATTEN_OUT_OF_MEMORY;
    out->count = 1;
    r->at = r->entry->key;
    read_item(r, &node, out->items);
    return BATTEN_OK;
}

/* ---- all arguments of an entry ---- */

static void unknown_key(bat_document *d, const bat_entry *entry, int key)
{
    const batten_feature *f = &entry->feature->shown;
    const char *word = d->tree.nodes[key].word, *near = NULL;
    int best = 99;
    for (int i = 1; i < f->parameter_count; i++)
        if (bat_is_nearer(word, f->parameters[i].name, &best))
            near = f->parameters[i].name;
    /* In { } a comma ends a value, also inside of min(a, b). */
    const bool is_rest = strchr(word, ')') && !strchr(word, '(');
    char all[512]; /* not allocated, so that the message is whole also where memory is short */
    size_t used = 0;
    for (int i = 1; i < f->parameter_count && used < sizeof all; i++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", i > 1 ? ", " : "",
                                 f->parameters[i].name);
    const bool has_list = used > 0 && !is_rest;
    bat_complain(d, key, "%s has no parameter '%.80s'%s%s%s%s%s%s", f->name, word,
                 near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "",
                 is_rest ? "; put an expression with commas in quotes" : "",
                 !has_list ? ""
                 : near    ? " It has "
                           : "; it has ",
                 has_list ? all : "");
}

static int find_parameter(const batten_feature *f, const char *name)
{
    int p = 0;
    while (p < f->parameter_count && strcmp(f->parameters[p].name, name) != 0)
        p++;
    return p;
}

/* The words that parameters had in older designs; they are read, with a remark. */
static const struct {
    const char *operation, *was, *is;
} renamed[] = {{"sweep", "spine", "path"}, {"swing", "along", "path"}};

/* The parameter that a word of an older design means; the number of parameters when none. */
static int find_renamed(bat_document *d, const bat_entry *entry, int key)
{
    const batten_feature *f = &entry->feature->shown;
    const char *word = d->tree.nodes[key].word;
    for (size_t i = 0; i < sizeof renamed / sizeof renamed[0]; i++) {
        if (strcmp(renamed[i].operation, f->name) != 0 || strcmp(renamed[i].was, word) != 0)
            continue;
        batten_notes_remark(d->complaints->notes, d->file_name, d->tree.nodes[key].line,
                            entry->name, "'%s' of %s is called '%s' now", word, f->name,
                            renamed[i].is);
        return find_parameter(f, renamed[i].is);
    }
    return f->parameter_count;
}

static batten_status read_map(bat_reading *r, bat_entry *entry)
{
    const bat_node *nodes = r->document->tree.nodes;
    const batten_feature *f = &entry->feature->shown;
    batten_status status = BATTEN_OK;
    for (int i = nodes[entry->node].first; i >= 0 && status == BATTEN_OK; i = nodes[i].next) {
        const char *key = nodes[nodes[i].key].word;
        int p = find_parameter(f, key);
        if (p == f->parameter_count)
            p = find_renamed(r->document, entry, nodes[i].key);
        if (p == f->parameter_count) {
            unknown_key(r->document, entry, nodes[i].key);
            continue;
        }
        r->parameter = &f->parameters[p];
        status = read_argument(r, i, &entry->arguments[p]);
    }
    return status;
}

batten_status bat_arguments_read(bat_document *document, bat_entry *entry)
{
    if (!entry->feature)
        return BATTEN_OK;
    const batten_feature *f = &entry->feature->shown;
    bat_reading r = {.document = document, .entry = entry, .parameter = &f->parameters[0]};
    entry->arguments =
        bat_arena_array(&document->arena, (size_t)f->parameter_count, sizeof *entry->arguments);
    if (!entry->arguments)
        return BATTEN_OUT_OF_MEMORY;
    const bool is_bare = document->tree.nodes[entry->node].kind != BAT_NODE_MAP;
    batten_status status =
        is_bare ? read_argument(&r, entry->node, &entry->arguments[0]) : read_map(&r, entry);
    for (int i = 0; i < f->parameter_count && status == BATTEN_OK; i++) {
        r.parameter = &f->parameters[i];
        if (entry->arguments[i].count)
            continue;
        if (f->parameters[i].required && !entry->arguments[i].given)
            bat_complain(document, entry->key, "%s of '%s' needs '%s': %s", f->name,
                         entry->name, f->parameters[i].name, f->parameters[i].summary);
        else
            status = read_standard(&r, &entry->arguments[i]);
    }
    return status;
}
