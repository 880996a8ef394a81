/* Representations, what belongs together of them, and how they are placed in one another. */
#ifndef BAT_STEP_PRODUCT_H
#define BAT_STEP_PRODUCT_H
#include "exchange/step/read/import.h"

/* A representation. Those that relate to each other without a placement are one definition,
 * for which the first of them stands. */
typedef struct {
    uint32_t instance;
    const bat_step_record *record;    /* with its name, items and context */
    uint32_t first;                   /* of its definition */
    bool is_shape;                    /* and not only mapped */
    bool has_context;                 /* which stands behind its items, perhaps many: it has */
    const bat_step_instance *context; /* been looked for, and is this, or NULL */
    bool is_product, is_aspect;       /* what the file says that it is the shape of */
    const bat_step_instance *product; /* a PRODUCT_DEFINITION */

    /* Of a definition: */
    bool is_placed; /* within another */
    bool is_entered, is_made;
    uint32_t placing, placing_count; /* what is placed in it: a range, sorted by instance */
    batten_model *model;
} bat_step_representation;

/* A definition within another. */
typedef struct {
    uint32_t parent, child;              /* definitions */
    uint32_t instance;                   /* the MAPPED_ITEM or the relationship */
    const bat_step_instance *styled;     /* what a colour may be given to */
    const bat_step_instance *occurrence; /* NEXT_ASSEMBLY_USAGE_OCCURRENCE; or NULL */
    batten_affine place;
} bat_step_placing;

/* The representation of an instance; NULL when it is none. */
bat_step_representation *bat_step_representation_of(const bat_step_import *import,
                                                    const bat_step_instance *instance);
void bat_step_scale_of(bat_step_import *import, bat_step_representation *of,
                       bat_step_scale *scale);
/* Its items: a list. */
batten_status bat_step_items_of(const bat_step_import *import,
                                const bat_step_representation *of, int *count, size_t *at);

/* The scale of the first representation. */
void bat_step_first_scale(bat_step_import *import, bat_step_scale *scale);
/* roots.c: add what no product leads to, or leave it out by name. Cost: one pass over the file when something is left. */
batten_status bat_step_read_roots(bat_step_import *import, batten_model *model);

/* outline.c: find the representations and tie them together */
batten_status bat_step_find_representations(bat_step_import *import);
/* assembly.c: find what is placed in what; sorted by parent and instance */
batten_status bat_step_find_placings(bat_step_import *import);

#endif
