#ifndef BATTEN_GREGORY_H
#define BATTEN_GREGORY_H
/**
 * @file
 * Gregory patches: bicubic or quartic, with inner points that are seen differently from
 * different edges; so patches that know only their own edges join smoothly. And procedural
 * surfaces over a polygon.
 *
 * Gregory's square, the Coons patch of the second kind whose twists need not agree, is
 * batten_surface_coons with BATTEN_TWIST_GREGORY.
 */
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * The derivative across a cubic edge that all patches along it share but for its sign, factor
 * and part along the edge: its plane, with the edge, follows from the edge and the planes at
 * its ends alone.
 *
 * With C' = sum c_i B2_i and unit normals n_j at the ends, g_0 = n_0 x c_0 / |n_0 x c_0|, g_2
 * alike with c_2, g_1 = (g_0 + g_2) / 2; the derivative is k g + h C', k and h linear such that
 * it is `across` at the ends.
 *
 * @param edge    [4][3] Bezier points; where end points coincide the next ones count
 * @param across  [2][3] derivatives across at both ends, not along the edge
 * @param normals [2][3] of the planes that the neighbours share at the ends; NULL: those of the
 *                edge and `across`
 * @param[out] field [4][3] Bezier points of the derivative across
 * @return BATTEN_OK; SINGULAR_HERE for an edge without direction at an end, `across` along it,
 * or an edge that turns half around between its ends (divide it); NOT_COMPATIBLE when the
 * derivatives at the ends lie on different sides of the edge; NOT_FINITE
 * Source: [CK83].
 */
BATTEN_API batten_status batten_gregory_field(const double *edge, const double *across,
                                              const double *normals, double *field);

/**
 * The bicubic Gregory patch, of kind "gregory", over [0, 1] x [0, 1].
 *
 * @param points [4][4][3] Bezier points, i along u; the inner four are not looked at
 * @param inner  [2][2][2][3] at (1 + i, 1 + j): the point as the edge v = j sees it, that as
 * the edge u = i sees it; they are blended by the distances from both
 * @return BATTEN_OK, NOT_FINITE
 *
 * Slopes are continuous everywhere; at a corner second derivatives depend on the direction of
 * approach where its two points differ, and at the corner itself their mean counts.
 * batten_surface_to_nurbs approximates: the exact rational form has weights 0 at its corners.
 * Source: [CK83].
 */
BATTEN_API batten_status batten_surface_gregory(const double *points, const double *inner,
                                                batten_surface **out);

/**
 * The quartic Gregory triangle, of kind "gregory-triangle", over [0, 1] x [0, 1]: at (u, v) the
 * point with barycentric coordinates (1 - u, u (1 - v), u v), with a pole at u = 0.
 *
 * @param edges [3][5][3] Bezier points of the edges from corner 0 to 1, 1 to 2, 2 to 0
 * @param inner [3][2][3] the points next to corner i: as the edge that leaves it sees it, as
 * the edge that comes to it does
 * @return BATTEN_OK, NOT_FINITE; NOT_COMPATIBLE when edges do not end where the next begins
 * Source: [WM96], [LSNC09].
 */
BATTEN_API batten_status batten_surface_gregory_triangle(const double *edges,
                                                         const double *inner,
                                                         batten_surface **out);

/**
 * The Gregory patch between three or four cubic curves, all of its inner points from
 * batten_gregory_field: patches made so along a common edge have a common tangent plane all
 * along it when they have it at its ends.
 *
 * @param count     3 or 4
 * @param curves    single cubics (or of lower degree) in any order and direction
 * @param tolerance corners may be open so far; ends meet halfway
 * @param[out] places [count], the loop; may be NULL
 * @return as batten_curves_loop and batten_gregory_field, naming the curve; UNSUPPORTED for a
 * side that is rational, of a higher degree or of more than one span
 */
BATTEN_API batten_status batten_surface_gregory_between(int count,
                                                        const batten_curve *const *curves,
                                                        double tolerance,
                                                        batten_loop_place *places,
                                                        batten_surface **out);

/**
 * A NURBS surface near another one, whose normals along the edges are near too, so that
 * neighbours that are smooth together stay so. The tolerance is made smaller until they are.
 *
 * @param surface   of any kind, in space
 * @param tolerance model units, > 0
 * @param angle     radians, > 0
 * @param[out] error   the deviation; may be NULL
 * @param[out] reached the largest angle between the normals at 129 places of each edge; places
 * without a normal (poles) do not count; may be NULL
 * @return as batten_surface_to_nurbs; TOLERANCE_NOT_MET with the angle reached
 */
BATTEN_API batten_status batten_surface_to_smooth_nurbs(const batten_surface *surface,
                                                        double tolerance, double angle,
                                                        batten_surface **out, double *error,
                                                        double *reached);

#ifdef __cplusplus
}
#endif
#endif
