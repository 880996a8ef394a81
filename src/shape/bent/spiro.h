/*
 * Splines whose curvature is cubic in arc length: one span, and the equations at the points.
 *
 * On a span theta = c[0] t + c[1] t^2 + c[2] t^3 + c[3] t^4 from the tangent at its start, t =
 * arc length / length. The chord lies along the x axis: this determines the angle of the start,
 * and the length.
 */
#ifndef BAT_SPIRO_H
#define BAT_SPIRO_H
#include "shape/points/chord_polygon.h"
#include <batten/bent.h>

enum { BAT_SPIRO_UNKNOWNS = 4 };

/* At start and end: the angle from the chord, curvature and its first two derivatives by arc
 * length, and their derivatives by the unknowns. */
typedef struct {
    double value[2][4];
    double by[2][4][BAT_SPIRO_UNKNOWNS];
    double chord; /* by the length */
} bat_spiro_span;

void bat_spiro_span_at(const double *c, double chord, bat_spiro_span *out);
/* The integrals of squared curvature and of its squared derivative. */
void bat_spiro_span_energies(const double *c, const bat_spiro_span *span, double chord,
                             double *bending, double *variation);

/* The equations of a polygon. */
typedef struct {
    const bat_chord_polygon *chords;
    const batten_spiro_kind *kinds; /* [count] */
    const bool *straight;           /* [spans]: between two free ends */
    batten_spiro_end ends[2];       /* the directions from the end chords, the curvatures times
                                       the longest chord */
} bat_spiro_task;

/* Solve for c [spans][4], which begins with spirals near the points. `report`: steps, residual
 * and the largest curvature times the longest chord. */
batten_status bat_spiro_solve(const bat_spiro_task *task, int max_steps, double *c,
                              batten_chain_spiro_report *report);

#endif
