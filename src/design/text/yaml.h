/* The text of a design as a tree of nodes that know their bytes. */
#ifndef BAT_DESIGN_YAML_H
#define BAT_DESIGN_YAML_H
#include "base/arena.h"

typedef enum { BAT_NODE_WORD, BAT_NODE_LIST, BAT_NODE_MAP } bat_node_kind;

/* Nodes stand in the order of the text, a key before its value; so a node and all below it are
 * nodes[i] .. nodes[after - 1]. */
typedef struct {
    bat_node_kind kind;
    bool plain; /* a word without quotes */
    bool flow;  /* a list or map in brackets */
    size_t begin,
        end; /* its bytes in the text; of a block list or map, up to its last item's end */
    int line, column; /* from 1; columns count characters */
    const char *word; /* of a word: what it says, without quotes */
    int count;        /* of a list or map: how many items */
    int first, next;  /* the first item, the next item of the parent; -1 for none */
    int key;          /* of an item of a map: the word that is its key; else -1 */
    int after;
} bat_node;

/* Begin with {0}. */
typedef struct {
    bat_arena arena;
    bat_node *nodes; /* nodes[0] is the root */
    int count;
} bat_tree;

typedef struct {
    int line, column; /* from 1; 0 for none */
} bat_place;

/*
 * Parse YAML. Anchors, aliases, tags, block scalars, several documents, keys that are not words,
 * and equal keys in one map are refused, and so is what nests deeper than `nesting`.
 *
 * @param[out] tree   free it with bat_tree_free, also after a failure
 * @param[out] place  where it is wrong
 */
batten_status bat_tree_parse(const char *text, size_t length, int nesting, bat_tree *tree,
                             bat_place *place);
void bat_tree_free(bat_tree *tree);

/* The value of a key of the map `node`, or -1. */
int bat_tree_find(const bat_tree *tree, int node, const char *key);
/* The same for the longest key that `path` begins with, up to its end or a '.'; `*used` is the
 * length of that key. */
int bat_tree_find_path(const bat_tree *tree, int node, const char *path, size_t *used);

#endif
