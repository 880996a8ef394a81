/*
 * Curves of least energy: the density of the energy along a curve, and Newton's method on nodes
 * that carry point, first and second derivative.
 */
#ifndef BAT_ENERGY_H
#define BAT_ENERGY_H
#include "base/base.h"
#include <batten/bent.h>

/* ---- density ---- */

/* What is integrated over the parameter: `energy` times the density of the energy and `length`
 * times that of the length. */
typedef struct {
    batten_energy kind;
    double energy, length;
} bat_energy_weights;

/* Of the first three derivatives of a point by the parameter, 3 d numbers, d = 2 or 3. */
typedef struct {
    double energy, length; /* their densities, unweighted */
    double size;           /* of the terms that were summed to `energy` */
    double gradient[9];    /* of the weighted sum */
    double hessian[81];    /* [3 d][3 d] */
} bat_energy_density;

/* `derivatives` [3][d]; gradient and hessian only when `all`. */
void bat_energy_density_at(const bat_energy_weights *weights, int d, const double *derivatives,
                           bool all, bat_energy_density *out);

/* ---- the curve ---- */

/* Nodes [count], each with 3 d numbers: point, first and second derivative. Between nodes j and
 * j + 1 stands one quintic over a parameter of length step[j]. */
typedef struct {
    int d, count, spans;
    bool closed;
    double *x;     /* [count][3][d] */
    double *step;  /* [spans] */
    int *unknown;  /* [count][3][d], along the axes of the node: its number, -1 when fixed */
    double *frame; /* [count][d][d]: square axes, by columns, the first along the tangent */
    int unknown_count, band;
} bat_energy_curve;

typedef struct {
    batten_energy kind;
    bool scale_invariant;
    double tension;
    int max_steps;
    double longest; /* a curve beyond this length is growing without end */
} bat_energy_task;

/* Where a search ended. */
typedef enum {
    BAT_ENERGY_LEAST,    /* at the least, to rounding */
    BAT_ENERGY_UNDERWAY, /* after max_steps */
    BAT_ENERGY_STUCK     /* no step lowers the energy, though its derivatives say so */
} bat_energy_end;

/* Lower the energy towards its least near x. */
batten_status bat_energy_minimise(const bat_energy_task *task, bat_energy_curve *curve,
                                  batten_curve_minimum_energy_report *report,
                                  bat_energy_end *end);

/* ---- the parameter ---- */

double bat_energy_length(const bat_energy_curve *curve);
/* Make the parameter the arc length, as near as quintics with the same points, tangents and
 * curvatures at the nodes come to it; false where the curve stands still. */
bool bat_energy_by_length(bat_energy_curve *curve);

/* The six Bernstein coefficients [6][d] of span j. */
void bat_energy_bezier(const bat_energy_curve *curve, int j, double *points);

#endif
