/*
 * Surfaces that are formulas: Coons, Gregory, side-vertex, n-sided, procedural skins ... A kind
 * says how one point is computed (with jets, numeric/jet.h, all derivatives come for free); the
 * rest of what a surface can do is common: batches, grids, normals, box, isocurves, maps, and
 * the NURBS surface near it.
 *
 * The parameters run over [spans[0], last span] in each direction. A surface over a triangle is
 * seen over the unit square: barycentric (1 - u, u (1 - v), u v), with a pole at u = 0.
 */
#ifndef BAT_FORMULA_H
#define BAT_FORMULA_H
#include "spline/surface/surface.h"

/* What a kind is. `data` belongs to the surface once bat_formula_create has succeeded. */
typedef struct {
    const char *kind; /* "coons" ... */
    /* A point and its derivatives up to total order `order` <= 3, for u, v inside the closed
     * domain; the sides matter on inner spans only. `out`
     * [BATTEN_SURFACE_DERIVATIVES(order)][dimension]. Must be finite on the whole domain, its
     * corners and edges too. */
    batten_status (*evaluate)(const void *data, const bat_surface_place *at, int order,
                              double *out);
    /* The equal NURBS surface where there is one; NULL: it is approximated. Its `error` is as
     * that of batten_surface_to_nurbs. */
    batten_status (*to_nurbs)(const void *data, double tolerance, batten_surface **out,
                              double *error);
    void (*free)(void *data);
} bat_formula;

/* How smooth a surface is across its inner spans, for the one direction: 0, 1 or 2 derivatives
 * that do not jump. */
typedef struct {
    int count;           /* of breaks, at least 2 */
    const double *spans; /* [count], increasing; copied */
    int smoothness;
} bat_formula_axis;

/*
 * @param size  a coordinate as large as any of the surface: what its roundoff is measured by
 * @return BATTEN_OK; on failure `data` still belongs to the caller
 */
batten_status bat_formula_create(const bat_formula *formula, void *data, int dimension,
                                 const bat_formula_axis *u, const bat_formula_axis *v,
                                 double size, batten_surface **out);

/* Which of the spans between breaks [count] holds a parameter of their range; a break belongs
 * to the span on the side named. */
static inline int bat_breaks_span(int count, const double *breaks, double at, batten_side side)
{
    int low = 0, high = count - 2;
    while (low < high) {
        const int middle = low + (high - low + 1) / 2;
        if (breaks[middle] < at || (breaks[middle] == at && side == BATTEN_FROM_RIGHT))
            low = middle;
        else
            high = middle - 1;
    }
    return low;
}

/*
 * The tensor B-spline near any surface of dimension 1 to 3: degree 5, interpolating at
 * Greville's abscissae; spans are halved where the error, measured between them, is too large.
 * A straight or spline edge whose knots are the surface's spans stays as it is but for
 * rounding.
 * @param[out] error  the largest measured distance at equal parameters; TOLERANCE_NOT_MET names
 *                    it when `most` points were not enough
 */
batten_status bat_surface_approximate(const batten_surface *surface, double tolerance, int most,
                                      batten_surface **out, double *error);
/* The same of a surface in space, whose normals along the four edges are also within `angle` of
 * those of the surface, in radians: knots are added near the edges until they are, at places
 * where both have normals. TOLERANCE_NOT_MET names the angle reached. */
batten_status bat_surface_approximate_smooth(const batten_surface *surface, double tolerance,
                                             double angle, int most, batten_surface **out,
                                             double *error);
#define BAT_APPROXIMATE_MOST 4000000 /* unless someone knows better */

#endif
