/* How a curve bends at a parameter, and its energies. */
#ifndef BAT_FAIR_BEND_H
#define BAT_FAIR_BEND_H
#include "base/base.h"
#include <batten/curvature.h>

/* Curvature and its rate at one parameter; of a function (dimension 1) its second and third
 * derivative, and du for ds. Where the curve stands still it counts as straight; what rounding
 * alone may make of a straight line counts as 0. */
typedef struct {
    double curvature, rate, speed;
} bat_curve_bend;
/* `size`: bat_curve_size of the curve. */
batten_status bat_curve_bend_at(const batten_curve *curve, double size, double u,
                                batten_side side, bat_curve_bend *out);

/* The integrals of curvature^2 and rate^2 by arc length and how far off they may be, by
 * adaptive quadrature between `breaks` (rising, from end to end of the domain): the knots, and
 * where curvature is extreme or the curve stands still. An error that is no small part of its
 * integral says that this is infinite, or nearly so. */
typedef struct {
    double energy, energy_error, variation, variation_error;
} bat_energies;
batten_status bat_curve_energies(const batten_curve *curve, const batten_parameters *breaks,
                                 bat_energies *out);

#endif
