/* What Gregory patches share. */
#ifndef BAT_GREGORY_H
#define BAT_GREGORY_H
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include <batten/fill.h>

/* a p + b q over a + b: halfway where both vanish. Numbers are parameters or barycentric
 * coordinates, none negative. */
void bat_gregory_blend(bat_jet a, bat_jet b, const double p[3], const double q[3],
                       bat_jet out[3]);
/* out += weight point */
void bat_gregory_add(bat_jet weight, const double point[3], bat_jet out[3]);
/* Jets of three coordinates as a surface hands them out. */
void bat_gregory_hand_out(const bat_jet point[3], int order, double *out);

/* The surface of a formula over the unit square whose data [count] begin with its points. */
batten_status bat_gregory_create(const bat_formula *formula, const double *points, size_t count,
                                 batten_surface **out);

#endif
