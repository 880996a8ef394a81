/* Pieces that continue a curve beyond its end. */
#ifndef BAT_EXTEND_H
#define BAT_EXTEND_H
#include "inspect/affine/side.h"
#include "spline/spline.h"
#include <batten/extend.h>

/* Where a curve ends and how it bends there: in space, T and N of length one, N across T. */
typedef struct {
    int dimension;
    double u; /* of the tip on its curve, where the domain of a piece begins */
    batten_vec3 p, t, n;
    double speed, curvature, rate; /* curvature and its rate by arc length, towards n */
} bat_tip;

/* What continues the tip by an arc length, on the domain [tip->u, ..] with the speed of the tip.
 * @param error as in batten_curve_extend_report */
batten_status bat_tip_piece(const bat_tip *tip, batten_lengthening how, double length,
                            double *error, batten_curve **out);
/* A spline clamped at its end, of rows of any width, with its last piece continued to u. */
batten_status bat_spline_go_on(const bat_spline *from, double u, bat_spline *out);
/* The clamped curve with its last piece continued to u, beyond its end (extend_natural.c). */
batten_status bat_curve_go_on(const batten_curve *curve, double u, batten_curve **out);
/* The u that it reaches by an arc length. `first` is a first guess of the step. */
batten_status bat_curve_go_on_by(const batten_curve *curve, double length, double first,
                                 double tolerance, double *u);

#endif
