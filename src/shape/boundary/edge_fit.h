/* The edges of surfaces: which one runs along a curve, and what it is where no exact curve is
 * at hand. */
#ifndef BAT_RIBBON_FIT_H
#define BAT_RIBBON_FIT_H
#include "base/base.h"
#include <batten/coons.h>

/* Where an edge lies, and which way is out of the surface. */
typedef struct {
    batten_direction along; /* the parameter that runs along the edge */
    double at;              /* the other one */
    batten_side side;       /* from which the surface is seen at `at` */
    double outward; /* 1 or -1: the sign of a step across the edge, out of the surface */
} bat_edge_place;

bat_edge_place bat_edge_of(const batten_surface *surface, batten_edge edge);

/*
 * The derivative of order k <= 2 outwards across the edge as a curve along it: pieces of degree
 * 5 (k = 2: 3) with the end derivatives of the truth, halved until none is farther from it than
 * `tolerance` at equal parameters.
 * @param[out] error the largest distance found
 */
batten_status bat_edge_fit(const batten_surface *surface, batten_edge edge, int k,
                           double tolerance, batten_curve **out, double *error);

/* An edge as a curve over the parameter along it, exact or within a quarter of the tolerance, which is above 0 for
 * surfaces that are no NURBS (edge_along_curve.c). */
batten_status bat_take_edge(const batten_surface *surface, batten_edge edge, double tolerance,
                            batten_curve **out);

/*
 * The edge that runs along a curve within `tolerance`, or of which the curve runs along a part,
 * and the places of the curve's two ends on it (edge_along_curve.c). A surface that is no NURBS
 * needs a tolerance above 0.
 * @return NOT_FOUND with the distance of the nearest
 */
batten_status bat_edge_beside(const batten_surface *surface, const batten_curve *curve,
                              double tolerance, batten_edge *edge, double at[2]);

#endif
