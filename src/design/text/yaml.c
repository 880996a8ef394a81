/* The text of a design as a tree of words, lists and maps with their places; aliases, tags and
 * repeated keys are refused. */
#include "design/text/yaml.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* Deeper than any limit that a caller may set. */
#define MOST_NESTING 128

/* libyaml counts characters; we walk from one count to the next, either way. */
typedef struct {
    const char *text;
    size_t length, byte, character;
} walker;

typedef struct {
    bat_tree *tree;
    bat_place *place;
    walker walk;
    size_t skipped; /* the byte order mark */
    int capacity;
    int nesting, depth;
    int open[MOST_NESTING]; /* the lists and maps that are not closed yet */
    int last[MOST_NESTING]; /* the last item of each, or -1 */
    int key[MOST_NESTING];  /* of a map: the key that waits for its value, or -1 */
    bool seen_document;
} builder;

static bool continues_character(char byte)
{
    return ((unsigned char)byte & 0xC0) == 0x80;
}

static void step_forward(walker *walk)
{
    do
        walk->byte++;
    while (walk->byte < walk->length && continues_character(walk->text[walk->byte]));
    walk->character++;
}

static void step_back(walker *walk)
{
    do
        walk->byte--;
    while (walk->byte > 0 && continues_character(walk->text[walk->byte]));
    walk->character--;
}

static size_t byte_of(walker *walk, size_t character)
{
    while (walk->character < character && walk->byte < walk->length)
        step_forward(walk);
    while (walk->character > character && walk->byte > 0)
        step_back(walk);
    return walk->byte;
}

static batten_status refuse(builder *b, const yaml_mark_t *mark, const char *what)
{
    *b->place = (bat_place){(int)mark->line + 1, (int)mark->column + 1};
    return bat_fail(BATTEN_BAD_FORMAT, "%s", what);
}

/* ---- building ---- */

static int *pending_key(builder *b)
{
    return &b->key[b->depth - 1];
}

static bool expects_key(const builder *b)
{
    return b->depth > 0 && b->tree->nodes[b->open[b->depth - 1]].kind == BAT_NODE_MAP &&
           b->key[b->depth - 1] < 0;
}

/* A new node; the key of a map is not linked as an item. */
static batten_status add_node(builder *b, const bat_node *made, int *index)
{
    bat_tree *tree = b->tree;
    if (tree->count == b->capacity) {
        const int capacity = b->capacity ? 2 * b->capacity : 64;
        bat_node *grown = bat_resize(tree->nodes, (size_t)capacity, sizeof *grown);
        if (!grown)
            return BATTEN_OUT_OF_MEMORY;
        tree->nodes = grown;
        b->capacity = capacity;
    }
    const int i = tree->count++;
    bat_node *node = &tree->nodes[i];
    *node = *made;
    node->first = node->next = node->key = -1;
    node->after = i + 1;
    *index = i;
    if (b->depth == 0)
        return BATTEN_OK;
    if (expects_key(b)) {
        *pending_key(b) = i;
        return BATTEN_OK;
    }
    bat_node *parent = &tree->nodes[b->open[b->depth - 1]];
    int *last = &b->last[b->depth - 1];
    *(*last < 0 ? &parent->first : &tree->nodes[*last].next) = i;
    *last = i;
    parent->count++;
    if (parent->kind == BAT_NODE_MAP) {
        node->key = *pending_key(b);
        *pending_key(b) = -1;
    }
    return BATTEN_OK;
}

static bat_node node_at(builder *b, const yaml_event_t *event, bat_node_kind kind)
{
    return (bat_node){.kind = kind,
                      .begin = byte_of(&b->walk, event->start_mark.index) + b->skipped,
                      .end = byte_of(&b->walk, event->end_mark.index) + b->skipped,
                      .line = (int)event->start_mark.line + 1,
                      .column = (int)event->start_mark.column + 1};
}

static batten_status take_word(builder *b, const yaml_event_t *event)
{
    if (event->data.scalar.anchor)
        return refuse(b, &event->start_mark, "anchors (&name) are not used in designs");
    if (event->data.scalar.tag)
        return refuse(b, &event->start_mark, "tags (!name) are not used in designs");
    const yaml_scalar_style_t style = event->data.scalar.style;
    if (style == YAML_LITERAL_SCALAR_STYLE || style == YAML_FOLDED_SCALAR_STYLE)
        return refuse(b, &event->start_mark,
                      "texts after '|' or '>' are not used in designs; write them in quotes");
    bat_node node = node_at(b, event, BAT_NODE_WORD);
    node.plain = style == YAML_PLAIN_SCALAR_STYLE;
    const char *word = (const char *)event->data.scalar.value;
    if (memchr(word, 0, event->data.scalar.length))
        return refuse(b, &event->start_mark, "a word contains the character NUL");
    node.word = bat_arena_copy(&b->tree->arena, word, event->data.scalar.length);
    if (!node.word)
        return BATTEN_OUT_OF_MEMORY;
    int index;
    return add_node(b, &node, &index);
}

static batten_status open_node(builder *b, const yaml_event_t *event)
{
    const bool is_map = event->type == YAML_MAPPING_START_EVENT;
    if (is_map ? event->data.mapping_start.anchor : event->data.sequence_start.anchor)
        return refuse(b, &event->start_mark, "anchors (&name) are not used in designs");
    if (is_map ? event->data.mapping_start.tag : event->data.sequence_start.tag)
        return refuse(b, &event->start_mark, "tags (!name) are not used in designs");
    if (expects_key(b))
        return refuse(b, &event->start_mark, "a key must be a word, not a list or map");
    if (b->depth == b->nesting) {
        *b->place =
            (bat_place){(int)event->start_mark.line + 1, (int)event->start_mark.column + 1};
        return bat_fail(BATTEN_TOO_LARGE, "lists and maps nest deeper than the limit, %d",
                        b->nesting);
    }
    bat_node node = node_at(b, event, is_map ? BAT_NODE_MAP : BAT_NODE_LIST);
    node.flow = is_map ? event->data.mapping_start.style == YAML_FLOW_MAPPING_STYLE
                       : event->data.sequence_start.style == YAML_FLOW_SEQUENCE_STYLE;
    int index;
    const batten_status status = add_node(b, &node, &index);
    if (status != BATTEN_OK)
        return status;
    b->open[b->depth] = index;
    b->last[b->depth] = b->key[b->depth] = -1;
    b->depth++;
    return BATTEN_OK;
}

static int compare_keys(const void *a, const void *b)
{
    const bat_node *first = *(const bat_node *const *)a;
    const bat_node *second = *(const bat_node *const *)b;
    const int order = strcmp(first->word, second->word);
    if (order)
        return order;
    return first->begin < second->begin ? -1 : first->begin > second->begin;
}

static batten_status check_keys(builder *b, const bat_node *map)
{
    if (map->count < 2)
        return BATTEN_OK;
    const bat_node *nodes = b->tree->nodes;
    const bat_node **keys = bat_array((size_t)map->count, sizeof *keys);
    if (!keys)
        return BATTEN_OUT_OF_MEMORY;
    int count = 0;
    for (int i = map->first; i >= 0; i = nodes[i].next)
        keys[count++] = &nodes[nodes[i].key];
    qsort(keys, (size_t)count, sizeof *keys, compare_keys);
    const bat_node *again = NULL, *before = NULL;
    for (int i = 1; i < count; i++)
        if (strcmp(keys[i]->word, keys[i - 1]->word) == 0 &&
            (!again || keys[i]->begin < again->begin)) {
            again = keys[i];
            before = keys[i - 1];
        }
    bat_release(keys);
    if (!again)
        return BATTEN_OK;
    *b->place = (bat_place){again->line, again->column};
    return bat_fail(BATTEN_BAD_FORMAT,
                    "'%s' appears here a second time; it is already on line %d", again->word,
                    before->line);
}

static batten_status close_node(builder *b, const yaml_event_t *event)
{
    b->depth--;
    bat_node *node = &b->tree->nodes[b->open[b->depth]];
    node->after = b->tree->count;
    /* libyaml ends a block where the next thing begins; ours ends with its last item. */
    if (node->flow)
        node->end = byte_of(&b->walk, event->end_mark.index) + b->skipped;
    else if (b->last[b->depth] >= 0)
        node->end = b->tree->nodes[b->last[b->depth]].end;
    return node->kind == BAT_NODE_MAP ? check_keys(b, node) : BATTEN_OK;
}

static batten_status take_event(builder *b, const yaml_event_t *event)
{
    switch (event->type) {
    case YAML_SCALAR_EVENT:
        return take_word(b, event);
    case YAML_SEQUENCE_START_EVENT:
    case YAML_MAPPING_START_EVENT:
        return open_node(b, event);
    case YAML_SEQUENCE_END_EVENT:
    case YAML_MAPPING_END_EVENT:
        return close_node(b, event);
    case YAML_ALIAS_EVENT:
        return refuse(b, &event->start_mark, "aliases (*name) are not used in designs");
    case YAML_DOCUMENT_START_EVENT:
        if (b->seen_document)
            return refuse(b, &event->start_mark,
                          "a second document begins here; one is allowed");
        b->seen_document = true;
        return BATTEN_OK;
    default:
        return BATTEN_OK;
    }
}

/* ---- what cannot be YAML ---- */

static bat_place place_of_byte(const char *text, size_t byte)
{
    bat_place place = {1, 1};
    for (size_t i = 0; i < byte; i++) {
        if (text[i] == '\n') {
            place.line++;
            place.column = 1;
        } else if (!continues_character(text[i])) {
            place.column++;
        }
    }
    return place;
}

static batten_status check_bytes(const char *text, size_t length, bat_place *place)
{
    *place = (bat_place){1, 1};
    const bool marked =
        length >= 2 && (memcmp(text, "\xFF\xFE", 2) == 0 || memcmp(text, "\xFE\xFF", 2) == 0);
    const bool zeros = length >= 2 && (!text[0]) != (!text[1]);
    if (marked || zeros)
        return bat_fail(BATTEN_BAD_FORMAT, "the text is UTF-16; save it as UTF-8");
    const char *nul = memchr(text, 0, length);
    if (nul) {
        *place = place_of_byte(text, (size_t)(nul - text));
        return bat_fail(BATTEN_BAD_FORMAT, "the text contains a NUL byte");
    }
    if (length > INT_MAX / 2)
        return bat_fail(BATTEN_TOO_LARGE, "the text has %zu bytes; %d are allowed", length,
                        INT_MAX / 2);
    return BATTEN_OK;
}

static batten_status yaml_failed(const yaml_parser_t *parser, const char *text, size_t length,
                                 bat_place *place)
{
    if (parser->error == YAML_MEMORY_ERROR)
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for the YAML parser");
    const char *problem = parser->problem ? parser->problem : "not YAML";
    if (parser->error == YAML_READER_ERROR) {
        const size_t byte = parser->problem_offset < length ? parser->problem_offset : length;
        *place = place_of_byte(text, byte);
        return bat_fail(BATTEN_BAD_FORMAT, "%s at byte %zu", problem, byte);
    }
    *place =
        (bat_place){(int)parser->problem_mark.line + 1, (int)parser->problem_mark.column + 1};
    return bat_fail(BATTEN_BAD_FORMAT, "%s%s%s", parser->context ? parser->context : "",
                    parser->context ? ", " : "", problem);
}

static batten_status take_events(builder *b, yaml_parser_t *parser)
{
    for (;;) {
        yaml_event_t event;
        if (!yaml_parser_parse(parser, &event))
            return yaml_failed(parser, b->walk.text, b->walk.length, b->place);
        const batten_status status = take_event(b, &event);
        const bool ends = event.type == YAML_STREAM_END_EVENT;
        yaml_event_delete(&event);
        if (status != BATTEN_OK || ends)
            return status;
    }
}

batten_status bat_tree_parse(const char *text, size_t length, int nesting, bat_tree *tree,
                             bat_place *place)
{
    *tree = (bat_tree){0};
    batten_status status = check_bytes(text, length, place);
    if (status != BATTEN_OK)
        return status;
    const size_t skipped = length >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    builder b = {.tree = tree,
                 .place = place,
                 .walk = {text + skipped, length - skipped, 0, 0},
                 .skipped = skipped,
                 .nesting = bat_min_int(nesting, MOST_NESTING)};
    yaml_parser_t parser;
    if (!yaml_parser_initialize(&parser))
        return bat_fail(BATTEN_OUT_OF_MEMORY, "no memory for the YAML parser");
    yaml_parser_set_encoding(&parser, YAML_UTF8_ENCODING);
    yaml_parser_set_input_string(&parser, (const unsigned char *)text + skipped,
                                 length - skipped);
    status = take_events(&b, &parser);
    yaml_parser_delete(&parser);
    if (status == BATTEN_OK && tree->count == 0) {
        *place = (bat_place){1, 1};
        status = bat_fail(BATTEN_BAD_FORMAT, "the text is empty");
    }
    return status;
}

void bat_tree_free(bat_tree *tree)
{
    bat_arena_free(&tree->arena);
    bat_release(tree->nodes);
    *tree = (bat_tree){0};
}

/* ---- finding ---- */

int bat_tree_find(const bat_tree *tree, int node, const char *key)
{
    const bat_node *nodes = tree->nodes;
    if (nodes[node].kind != BAT_NODE_MAP)
        return -1;
    int i = nodes[node].first;
    while (i >= 0 && strcmp(nodes[nodes[i].key].word, key) != 0)
        i = nodes[i].next;
    return i;
}

int bat_tree_find_path(const bat_tree *tree, int node, const char *path, size_t *used)
{
    const bat_node *nodes = tree->nodes;
    int found = -1;
    if (nodes[node].kind != BAT_NODE_MAP)
        return -1;
    for (int i = nodes[node].first; i >= 0; i = nodes[i].next) {
        const char *key = nodes[nodes[i].key].word;
        const size_t length = strlen(key);
        if (strncmp(path, key, length) == 0 && (path[length] == 0 || path[length] == '.') &&
            (found < 0 || length > *used)) {
            found = i;
            *used = length;
        }
    }
    return found;
}
