/* One value of a design's text replaced, and no other byte. */
#include "design/text/edit.h"

#include <batten/text.h>
#include <stdio.h>
#include <string.h>

/* Where a value is, or is to be put. */
typedef struct {
    const char *path;
    int node;          /* the value, or the map that gets a new key */
    const char *key;   /* the new key, or NULL */
    size_t begin, end; /* the bytes that go */
} place;

/* ---- finding ---- */

static batten_status find_place(const bat_tree *tree, const char *path, place *out)
{
    int node = 0;
    const char *rest = path;
    while (*rest) {
        size_t used;
        const int child = bat_tree_find_path(tree, node, rest, &used);
        if (child < 0)
            break;
        node = child;
        rest += used;
        rest += *rest == '.';
    }
    const bat_node *at = &tree->nodes[node];
    *out = (place){path, node, *rest ? rest : NULL, at->begin, at->end};
    if (node == 0 && !*rest)
        return bat_fail(BATTEN_NOT_FOUND, "the path of the value is empty");
    if (*rest && at->kind != BAT_NODE_MAP)
        return bat_fail(BATTEN_NOT_FOUND, "there is no '%s' in the design: '%.*s' has no keys",
                        path, (int)(rest - path), path);
    if (node == 0 && strchr(rest, '.'))
        return bat_fail(BATTEN_NOT_FOUND, "there is no '%s' in the design", path);
    if (!*rest && at->kind != BAT_NODE_WORD && !at->flow)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "'%s' is written in several lines; change one of its values", path);
    return BATTEN_OK;
}

static size_t line_end(const char *text, size_t length, size_t at)
{
    while (at < length && text[at] != '\n' && text[at] != '\r')
        at++;
    return at;
}

/* "\r\n" when the first line of the text ends so. */
static const char *line_break(const char *text, size_t length)
{
    const size_t end = line_end(text, length, 0);
    if (end + 1 < length && text[end] == '\r' && text[end + 1] == '\n')
        return "\r\n";
    return end < length && text[end] == '\r' ? "\r" : "\n";
}

/* ---- writing ---- */

/* A value or key, in single quotes if asked for. */
static void add_word(batten_text *out, const char *word, bool quoted)
{
    if (!quoted) {
        batten_text_bytes(out, word, strlen(word));
        return;
    }
    batten_text_bytes(out, "'", 1);
    for (const char *c = word; *c; c++)
        batten_text_bytes(out, *c == '\'' ? "''" : c, *c == '\'' ? 2 : 1);
    batten_text_bytes(out, "'", 1);
}

/* Everything before the new bytes; `*at` is where the value then begins, `*resume` where the
 * old text continues. */
static void add_before(batten_text *out, const char *text, size_t length, const bat_tree *tree,
                       const place *p, size_t *resume)
{
    const bat_node *nodes = tree->nodes;
    if (!p->key) {
        batten_text_bytes(out, text, p->begin);
        *resume = p->end;
        return;
    }
    const bat_node *map = &nodes[p->node];
    int last = map->first;
    while (last >= 0 && nodes[last].next >= 0)
        last = nodes[last].next;
    size_t at = last >= 0 ? nodes[last].end : map->begin + 1;
    if (!map->flow)
        at = line_end(text, length, at);
    batten_text_bytes(out, text, at);
    *resume = at;
    if (map->flow) {
        batten_text_add(out, "%s", last >= 0 ? ", " : "");
    } else {
        const int indent = nodes[nodes[map->first].key].column - 1;
        batten_text_add(out, "%s%*s", line_break(text, length), indent, "");
    }
    add_word(out, p->key, strpbrk(p->key, ":#,[]{}'\"&*!|>%@` ") != NULL);
    batten_text_add(out, ": ");
}

/* ---- checking ---- */

static bool same_node(const bat_node *a, const bat_node *b)
{
    return a->kind == b->kind && a->flow == b->flow &&
           (a->kind != BAT_NODE_WORD || strcmp(a->word, b->word) == 0);
}

/* Is all but the value as before, and does the value stand in bytes begin .. end? */
static bool only_value_differs(const bat_tree *before, const bat_tree *after, const place *p,
                               size_t begin, size_t end)
{
    place now;
    if (find_place(after, p->path, &now) != BATTEN_OK || now.key)
        return false;
    const bat_node *value = &after->nodes[now.node];
    const bat_node *old = &before->nodes[p->node];
    if (value->begin != begin || value->end != end)
        return false;
    /* A new key and its value come after all nodes of their map. */
    const int from = p->key ? old->after : p->node;
    const int grown = p->key ? 1 : 0;
    if (now.node != from + grown ||
        after->count - value->after != before->count - (p->key ? from : old->after))
        return false;
    for (int i = 0; i < from; i++)
        if (!same_node(&before->nodes[i], &after->nodes[i]))
            return false;
    for (int i = value->after, k = p->key ? from : old->after; i < after->count; i++, k++)
        if (!same_node(&before->nodes[k], &after->nodes[i]))
            return false;
    return true;
}

/* What is edited: the text of a document, and what it means. */
typedef struct {
    const char *text;
    size_t length;
    const bat_tree *tree;
    int nesting;
} edited;

static batten_status splice(const edited *e, const place *p, const char *value, bool quoted,
                            char **out, size_t *out_length)
{
    batten_text made = BATTEN_TEXT;
    size_t resume = 0;
    add_before(&made, e->text, e->length, e->tree, p, &resume);
    const size_t begin = made.length;
    add_word(&made, value, quoted);
    const size_t end = made.length;
    batten_text_bytes(&made, e->text + resume, e->length - resume);
    char *bytes = NULL;
    size_t size = 0;
    batten_status status = batten_text_take(&made, &bytes, &size);
    if (status != BATTEN_OK)
        return status;
    bat_tree after;
    bat_place where;
    status = bat_tree_parse(bytes, size, e->nesting, &after, &where);
    if (status == BATTEN_OK && !only_value_differs(e->tree, &after, p, begin, end))
        status =
            bat_fail(BATTEN_BAD_FORMAT, "\"%.100s\" is not a value for '%s'", value, p->path);
    bat_tree_free(&after);
    if (status == BATTEN_OK) {
        *out = bytes;
        *out_length = size;
    } else {
        bat_release(bytes);
    }
    return status;
}

batten_status bat_edit(const char *text, size_t length, const bat_tree *tree, int nesting,
                       const char *path, const char *value, char **out, size_t *out_length)
{
    const edited e = {text, length, tree, nesting};
    place p;
    batten_status status = find_place(tree, path, &p);
    if (status != BATTEN_OK)
        return status;
    if (!*value || strpbrk(value, "\r\n"))
        return bat_fail(BATTEN_BAD_FORMAT, "the value of '%s' must be one line, and not empty",
                        path);
    status = splice(&e, &p, value, false, out, out_length);
    if (status != BATTEN_OK && status != BATTEN_OUT_OF_MEMORY)
        status = splice(&e, &p, value, true, out, out_length);
    return status;
}
