/*
 * Geometry and topology of a STEP file as Batten's values. A `bat_step_scale` says the units of
 * the representation that owns an item.
 */
#ifndef BAT_STEP_SHAPES_H
#define BAT_STEP_SHAPES_H
#include "body/builder.h"
#include "body/elementary.h"
#include "exchange/step/instances.h"

typedef struct {
    double length;    /* model units of one unit of the context */
    double angle;     /* radians of one unit of plane angle */
    double tolerance; /* model units */
} bat_step_scale;

/* Geometry: message on failure. The instance's type is found by its keywords. */
batten_status bat_step_read_point(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, double point[3]);
batten_status bat_step_read_direction(const bat_step_file *file,
                                      const bat_step_instance *instance, double direction[3]);
batten_status bat_step_read_placement(const bat_step_file *file,
                                      const bat_step_instance *instance,
                                      const bat_step_scale *scale, batten_frame *frame);
/* Any bounded curve; lines and conics without bounds are NOT_COMPATIBLE. */
batten_status bat_step_read_curve(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_curve **out);
/* Any bounded surface: B-splines, rectangular trimmed, curve bounded, spheres, tori ... */
batten_status bat_step_read_surface(const bat_step_file *file,
                                    const bat_step_instance *instance,
                                    const bat_step_scale *scale, batten_surface **out);

/* What edges and vertices were made of which instance: so that they are shared. */
typedef struct {
    bat_step_file *file;
    bat_builder builder;
    bat_step_scale scale;
    bat_census *census;
    bat_list edges, vertices; /* (id, index) pairs, by a hash; private to topology.c */
} bat_step_topology;
void bat_step_topology_begin(bat_step_file *file, const bat_step_scale *scale,
                             bat_census *census, bat_step_topology *topology);
/* Faces, shells into the builder; those that cannot be read are noted and left out. `style`
 * gives a face its colour and name; see product.c. */
typedef void bat_step_style(const void *context, const bat_step_instance *item,
                            batten_body_face *face);
batten_status bat_step_read_shell(bat_step_topology *topology,
                                  const bat_step_instance *instance, bool reversed,
                                  bat_step_style *style, const void *context);
/* A face outside shells, in a shell of its own. */
batten_status bat_step_read_face(bat_step_topology *topology, const bat_step_instance *instance,
                                 bat_step_style *style, const void *context);
/* The body of all that was read since begin; NULL in *out when nothing was. */
batten_status bat_step_topology_end(bat_step_topology *topology, bool is_solid,
                                    batten_body **out);

#endif
