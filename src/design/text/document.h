/* A design as parsed: names, typed arguments, order. It does not change; an edit parses anew.
 */
#ifndef BAT_DESIGN_DOCUMENT_H
#define BAT_DESIGN_DOCUMENT_H
#include "design/feature.h"
#include "design/text/value.h"
#include "design/text/yaml.h"

/* A feature or an output of the text. */
typedef struct {
    const char *name;
    int key, node;              /* of the tree */
    const bat_feature *feature; /* NULL when it is wrong */
    bat_argument *arguments;
} bat_entry;

typedef struct {
    const char *name;
    int node;
    bool known;
    bat_quantity value;
} bat_parameter;

/* The errors of a text; the first is kept. */
typedef struct {
    const char *file;
    batten_notes *notes;
    int count;
    char first[900];
} bat_complaints;

typedef struct bat_document {
    const char *file_name;
    bool allow_outside;
    batten_limits limits;
    const char *provided_file;
    const batten_model *provided;
    bat_tree tree;
    bat_arena arena;
    const bat_features *operations; /* that its entries may name */
    bat_complaints *complaints;     /* while parsing */
    double unit_metres, tolerance;
    bool has_units; /* it names its unit */
    int most_objects; /* that all features together may make */
    const char *title;
    int parameter_count, feature_count, output_count;
    bat_parameter *parameters;
    bat_entry *features, *outputs;
    const char **names; /* of the features, sorted */
    int *named;         /* [feature_count] the feature that names[i] belongs to */
    int *order;         /* [feature_count] of evaluation */
} bat_document;

/* Parse `text`, whose entries name `operations`; `out` is to be freed, also after a failure. */
batten_status bat_document_parse(const char *text, size_t length,
                                 const batten_design_options *options,
                                 const bat_features *operations, batten_notes *notes,
                                 bat_document *out);
void bat_document_free(bat_document *document);

/* ---- complaints.c ---- */

/* Note an error of the text at a node (-1: the whole file). */
void bat_complain(bat_document *document, int node, const char *format, ...)
    BATTEN_PRINTF(3, 4);
/* The same at a line and a column; line 0: the whole file. */
void bat_complain_at(bat_complaints *complaints, int line, int column, const char *sentence);
/* `what` (features, parameters) need each other. @param names [count + 1] the first again last
 */
void bat_complain_of_ring(bat_document *document, int node, const char *what, int count,
                          const char **names);

/* ---- names.c ---- */

/* Sort the names of the features, which are listed; then they are found. */
batten_status bat_names_sort(bat_document *document);
/* The index of a feature, or -1. */
int bat_document_feature(const bat_document *document, const char *name);

/* ---- head.c ---- */

/* The newest version of the format that we know. */
#define BAT_FORMAT_VERSION 1

/* Read version, units and title, and name sections that are unknown. */
void bat_head_read(bat_document *document);
/* Read the tolerance; it may name parameters. */
void bat_tolerance_read(bat_document *document);

/* ---- parameters.c ---- */

/* List and evaluate the `count` parameters below a node (-1: there are none). */
batten_status bat_parameters_read(bat_document *document, int node, int count);
/* What expressions of the document may name. */
bat_names bat_document_names(bat_document *document);

/* ---- argument.c ---- */

/* Read the arguments of an entry from its node; wrong ones are complained about. */
batten_status bat_arguments_read(bat_document *document, bat_entry *entry);
/* ---- path.c ---- */

/* Does a path, as written, leave the folder it is relative to? */
bool bat_path_leaves(const char *path);
/* The path of a file beside the design; with symlinks resolved it must stay below the design's
 * folder. Release it. */
batten_status bat_path_beside(const bat_document *document, const char *path, char **out);
/* Does the path of an output, with symlinks resolved, stay in the folder it is made in ("" is
 * the current one)? BAD_ARGUMENT where it leaves it, FILE_ERROR for a link that leads nowhere. */
batten_status bat_path_check_inside(const bat_document *document, const char *folder,
                                    const char *path);

/* ---- graph.c ---- */

/* Something that needs other things, by index. */
typedef struct {
    int count;
    int *begin; /* [count + 1] in `needs` */
    int *needs;
} bat_graph;

/* An order in which each comes after what it needs.
 * @param[out] order  [count]
 * @param[out] cycle  [count + 1] the members of a ring, when there is one, the first again at
 * the end
 * @return the number of things in the ring; 0 when all are in order; -1 without memory */
int bat_graph_order(const bat_graph *graph, int *order, int *cycle);
/* Mark `from` and all that it needs. @param[in,out] marked [count] */
batten_status bat_graph_mark(const bat_graph *graph, int from, bool *marked);

/* Does the item name a feature, `count`? */
bool bat_item_is_feature(batten_value_kind kind, const bat_item *item);
/* The features that an entry needs: calls `visit` with each index. */
void bat_entry_inputs(const bat_entry *entry, void (*visit)(void *user, int feature),
                      void *user);

/* The graph of the features; release begin and needs. */
batten_status bat_document_graph(const bat_document *document, bat_graph *out);
void bat_graph_release(bat_graph *graph);

#endif
