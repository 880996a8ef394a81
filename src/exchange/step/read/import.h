/* What the files that read STEP above the geometry share. */
#ifndef BAT_STEP_IMPORT_H
#define BAT_STEP_IMPORT_H
#include "exchange/step/read/groups.h"
#include "exchange/step/read/styles.h"
#include "exchange/step/read/topology.h"
#include "exchange/step/read/units.h"

#include <batten/model.h>

enum { BAT_STEP_NAME = 256 };

/* Instances that say how the file hangs together: uint32_t, in order. */
typedef struct {
    bat_list representations; /* of shapes */
    bat_list maps;            /* REPRESENTATION_MAP */
    bat_list relations;       /* of representations without a placement */
    bat_list placed;          /* and with one */
    bat_list occurrences;     /* CONTEXT_DEPENDENT_SHAPE_REPRESENTATION */
    bat_list definitions;     /* SHAPE_DEFINITION_REPRESENTATION */
    bat_list roots;           /* items that are whole shapes */
} bat_step_outline;

typedef struct {
    bat_input *input;
    bat_step_file file;
    bat_census census;
    bat_step_units units;
    bat_step_styles styles;
    bat_step_groups groups;
    char path[BAT_STEP_PATH]; /* of the group of the object at work */
    bat_step_topology topology;
    bat_step_outline outline;
    bool *taken;              /* items that are read already, by their instance */
    uint32_t *homes;          /* see assembly.c */
    bat_list representations; /* see product.c */
    bat_list placings;
    int annotations; /* items of drawings, which are not read */
} bat_step_import;

/* ---- objects.c ---- */

/* Where the objects of items go, and what holds for them all. */
typedef struct {
    bat_step_import *import;
    batten_model *model;
    bat_step_scale scale;
    const char *product; /* the name of what has none of its own */
    bool is_hidden;
} bat_step_target;

/* The object's name, colour and layer, from the first of the instances that has them; NULLs are
 * skipped. The name is put into the buffer. */
void bat_step_dress(const bat_step_target *target, int count,
                    const bat_step_instance *const *from, batten_object *object,
                    char name[BAT_STEP_NAME]);
/* Add the object of an item to the model and count it; when the model does not take it, it is
 * left out. */
batten_status bat_step_add_object(const bat_step_target *target, const bat_step_instance *item,
                                  const batten_object *object);
/* Note that an item is left out; a reason that is no fault of the data is handed on. */
batten_status bat_step_leave_item(const bat_step_target *target, const bat_step_instance *item,
                                  batten_status reason);
/* End the body at work and leave its item out. */
batten_status bat_step_give_up(const bat_step_target *target, const bat_step_instance *item,
                               batten_status reason);
/* The name that an item has; "" for none. */
void bat_step_name_of(const bat_step_file *file, const bat_step_instance *instance,
                      char name[BAT_STEP_NAME]);

/* ---- bodies.c ---- */

/* Has it faces? Its body, then; or its surface, when it is the whole of one. */
bool bat_step_is_body(const bat_step_file *file, const bat_step_instance *item);
batten_status bat_step_read_body(const bat_step_target *target, const bat_step_instance *item);

/* ---- tessellated.c ---- */

/* Is it made of triangles? Its mesh, then. */
bool bat_step_is_tessellated(const bat_step_file *file, const bat_step_instance *item);
batten_status bat_step_read_tessellated(const bat_step_target *target,
                                        const bat_step_instance *item);

/* ---- items.c ---- */

/* The objects of an item of a representation. What cannot be read is noted. */
batten_status bat_step_read_item(const bat_step_target *target, const bat_step_instance *item);

/* ---- placing.c ---- */

/* A placement or transformation operator as a map out of its own coordinates. */
batten_status bat_step_read_place(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_affine *place);
/* The map that takes `from` to `to`. `from` must keep lengths, or scale all alike. */
batten_affine bat_step_move(const batten_affine *from, const batten_affine *to);

/* ---- product.c ---- */

/* The model of all that the outline names. */
batten_status bat_step_read_products(bat_step_import *import, batten_model **out);

#endif
