/* The parts of skinning that others use too. */
#ifndef BAT_SKIN_H
#define BAT_SKIN_H
#include "base/work.h"
#include <batten/skin.h>

/* The maps that bring sections from the xy-plane to their places along the spine. @param maps
 * [count] */
batten_status bat_skin_places(int count, const batten_surface_skin_options *options,
                              batten_affine *maps);

/* The same shape with spans stretched so that the speed does not jump where the tangent goes
 * on; corners keep their parameters. Clamped. Rational sections, whose speed is not in their
 * points alone, stay as they are. */
batten_status bat_skin_even_speed(const batten_curve *section, batten_curve **out);

/* batten_surface_skin, with open and closed sections together when they are `mixed`. */
batten_status bat_surface_skin(int count, const batten_curve *const *sections,
                               const batten_surface_skin_options *options, bool mixed,
                               const batten_job *job, double *v,
                               batten_surface_skin_report *report, batten_surface **out);

#endif
