/*
 * Geometry and topology of a STEP file as Batten's values. A `bat_step_scale` says the units of
 * the representation that owns an item.
 * Source: [Part42].
 */
#ifndef BAT_STEP_SHAPES_H
#define BAT_STEP_SHAPES_H
#include "body/builder.h"
#include "body/elementary/elementary.h"
#include "exchange/step/text/instances.h"

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
/* A LINE, CIRCLE, ELLIPSE, PARABOLA or HYPERBOLA, also as the 3-D curve of a SURFACE_CURVE; of
 * other curves, a TRIMMED_CURVE among them, *is_conic is false, the conic untouched, and the
 * status OK. */
batten_status bat_step_as_conic(const bat_step_file *file, const bat_step_instance *instance,
                                const bat_step_scale *scale, bat_conic *conic, bool *is_conic);
/* A plane, cylinder, cone, sphere, torus, extrusion, revolution or offset surface, which may be
 * unbounded: give it to bat_elementary_surface. Of other surfaces *is_elementary is false and
 * the status OK. What it stands on is referenced by `basis`: release it with
 * bat_step_basis_end. */
typedef struct {
    batten_curve *curve;
    batten_surface *surface;
    bool is_reversed; /* the normal of the file is against that of the elementary surface */
} bat_step_basis;
batten_status bat_step_as_elementary(const bat_step_file *file,
                                     const bat_step_instance *instance,
                                     const bat_step_scale *scale, bat_elementary *elementary,
                                     bat_step_basis *basis, bool *is_elementary);
void bat_step_basis_end(bat_step_basis *basis);
/* Any bounded curve; lines and conics without bounds are NOT_COMPATIBLE, circles and ellipses
 * are whole. SURFACE_CURVE, SEAM_CURVE and INTERSECTION_CURVE stand for their 3-D curve. */
batten_status bat_step_read_curve(const bat_step_file *file, const bat_step_instance *instance,
                                  const bat_step_scale *scale, batten_curve **out);
/* Any bounded surface: B-splines, rectangular trimmed, curve bounded, spheres, tori ... */
batten_status bat_step_read_surface(const bat_step_file *file,
                                    const bat_step_instance *instance,
                                    const bat_step_scale *scale, batten_surface **out);

/* The curve in the parameters of the surface that a PCURVE, or the item of a SURFACE_CURVE that
 * lies on that surface, stands for; only when it is a B-spline surface, whose parameters are
 * the file's own: else *out stays NULL and the status is OK. */
batten_status bat_step_read_pcurve(const bat_step_file *file, const bat_step_instance *instance,
                                   const bat_step_instance *surface,
                                   const bat_step_scale *scale, batten_curve **out);

#endif
