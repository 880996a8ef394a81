#ifndef BATTEN_SURFACE_EXTEND_H
#define BATTEN_SURFACE_EXTEND_H
/**
 * @file
 * Surfaces made longer at their edges.
 */
#include <batten/extend.h>
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_surface_extend_report {
    double to;          /**< the parameter at which the longer surface ends */
    double least, most; /**< lengths of what was added, along 33 lines across the edge */
    double turn;        /**< the largest angle, radians, between the tangents of such a line at
                             the old edge and at the new one: a natural extension that turns
                             far goes astray */
    double angle;       /**< the largest jump of the normal over the old edge, radians */
    double curvature;   /**< the largest jump of the normal curvature across it */
    int multiplicity;   /**< of the knot at the old edge; 0: there is none */
    double error;       /**< how far what was added, or the old edge, may be from what it should
                             be: of an ARC, else 0 */
} batten_surface_extend_report;

/**
 * One surface that goes on beyond an edge, along all lines across it at once.
 *
 * The parameters go on with the speeds of the edge, so where these differ along the edge so do
 * the lengths; none of 33 lines gets less than `length`. LINE: straight along the tangents
 * across, G1, exact; ARC: along the circles of curvature of the lines across, G2, within
 * the tolerance; NATURAL: the last patches evaluated beyond the edge, no new knot, exact. The
 * old part keeps its shape and parameters. A surface joined with C1 has a knot of multiplicity
 * degree - 1 at the old edge; a rational one whose weights change along the edge as well as
 * across it has a full knot there, and only G1.
 *
 * @param surface NURBS, in space; not periodic across the edge
 * @param length  model units, > 0; an ARC may go around once
 * @param tolerance of an ARC, model units, > 0; else not used
 * @param[out] report may be NULL
 * @return BATTEN_OK; BAD_ARGUMENT, NOT_FINITE; UNSUPPORTED (SPIRAL, other kinds of surfaces, an
 * ARC at an edge with different weights); NOT_COMPATIBLE (periodic); SINGULAR_HERE (the edge is
 * a point, or stands still across, with the place); BAD_WEIGHT (it cannot go on that far);
 * TOLERANCE_NOT_MET, OVERFLOW
 *
 * Cost: linear in the control points; about 40 evaluations for each of 33 lines and each of
 * some ten trials of the length. Source: [PT97] 5.2 for knots moved, [Farin02].
 */
BATTEN_API batten_status batten_surface_extend(const batten_surface *surface, batten_edge edge,
                                               batten_extension extension, double length,
                                               double tolerance,
                                               batten_surface_extend_report *report,
                                               batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
