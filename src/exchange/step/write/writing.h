/* A STEP file being written: what its parts share. */
#ifndef BAT_STEP_WRITING_H
#define BAT_STEP_WRITING_H
#include "exchange/step/step.h"
#include "model/definitions.h"
#include "model/groups.h"

/* Where nobody says when. */
#define BAT_STEP_NEUTRAL_DATE "2000-01-01T00:00:00"

/* Ids that grow in number. */
typedef struct {
    int *ids;
    int count, capacity;
} bat_step_bag;
batten_status bat_step_bag_add(bat_step_bag *bag, int id);

/* Looks that were written last. */
enum { BAT_STEP_LOOKS = 32 };
typedef struct {
    batten_object_kind kind;
    double colour[3];
    int assignment;
} bat_step_look;

/* The product that a model became. */
typedef struct {
    int definition;     /* PRODUCT_DEFINITION */
    int representation; /* that it is shown by */
    int origin;         /* AXIS2_PLACEMENT_3D in it */
} bat_step_node;

typedef struct {
    bat_step step;
    const batten_write_options *options;
    double unit_metres;
    bool is_bare; /* AP203: no colours, layers, groups, nor anything hidden */
    int application, product_context, definition_context;
    int context; /* units and accuracy */
    bat_step_bag products, formations, definitions;
    bat_step_bag styled, hidden;
    bat_members layers, groups;
    bat_step_look looks[BAT_STEP_LOOKS];
    int look_count;
    bool has_noted_bare;
    bat_definitions parts; /* the models that become products */
    bat_step_node *nodes;  /* [parts] */
    const char **names;    /* [parts] of the products; borrowed */
    int *numbers;          /* [parts] behind the name in the id; 0 for none */
    int occurrences;
} bat_step_writing;

/* ---- write_product.c ---- */

/* The contexts of applications and products, the units. */
void bat_step_put_contexts(bat_step_writing *w, double unit_metres);
/* A product up to its definition: the id of the PRODUCT_DEFINITION. */
batten_status bat_step_put_product(bat_step_writing *w, const char *id, const char *name,
                                   int *definition);
/* What AP203 wants to know of all products: who, when, approved by whom, how secret. */
void bat_step_put_management(bat_step_writing *w);

/* ---- write_names.c ---- */

/* The names of all products, and numbers for those of one name. */
batten_status bat_step_name_products(bat_step_writing *w);
/* No two products have one id. */
batten_status bat_step_add_product_id(const bat_step_writing *w, int index, batten_text *id);

/* ---- write_accuracy.c ---- */

/* In model units: how far curves of bodies miss their vertices and surfaces, a micrometre at
 * least, but for what is so small that nothing of it would be left. */
double bat_step_accuracy(const bat_definitions *parts, const batten_write_options *options);

/* ---- write_style.c ---- */

/* Colour, layer, group, whether it is hidden: of an object that has become the item. */
batten_status bat_step_mark(bat_step_writing *w, const batten_object *object, int item);
batten_status bat_step_put_colour(bat_step_writing *w, batten_object_kind kind,
                                  const double colour[3], int item);
/* The presentation, layers and groups of what was marked. */
batten_status bat_step_put_marks(bat_step_writing *w);

/* ---- write_mesh.c ---- */

/* A mesh as a tessellated shell: the id. */
int bat_step_put_mesh(bat_step *step, const char *name, const batten_mesh *mesh);

#endif
