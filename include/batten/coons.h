#ifndef BATTEN_COONS_H
#define BATTEN_COONS_H
/**
 * @file
 * Coons patches: surfaces between boundary curves, with the slopes and curvatures across them
 * where these are wanted, and networks of such patches.
 *
 * Every kind is one formula, the Boolean sum of two families of lines: with blending functions
 * A of u and B of v,
 *
 *     S(u, v) = sum A_i(u) L_i(v) + sum M_j(u) B_j(v) - sum A_i(u) C_ij B_j(v),
 *
 * L_i being the boundary curves, slopes and curvatures at u = 0 and u = 1, M_j those at v = 0
 * and v = 1, and C_ij the values and derivatives that both have at the corners.
 *
 * Of what is printed in the sources, this must be read otherwise: the axioms of blending
 * functions ask that first and SECOND derivatives vanish (not third); rows 3 and 4 of the
 * corner matrix of the bicubic patch hold r_u(0,0), r_u(0,1) and r_u(1,0), r_u(1,1); its vector
 * form is U M C Mt Wt, with both M; the patch of the second kind gives no continuity of
 * curvature; and the vector across a boundary is the cross-boundary tangent, not a normal.
 */
#include <batten/grid.h>

#ifdef __cplusplus
extern "C" {
#endif

/** The four edges of a surface over a rectangle. */
typedef enum batten_edge {
    BATTEN_EDGE_V0, /**< v at its least; runs along u */
    BATTEN_EDGE_U1, /**< u at its greatest; runs along v */
    BATTEN_EDGE_V1,
    BATTEN_EDGE_U0
} batten_edge;

/** An edge of a surface. */
typedef struct batten_surface_edge {
    const batten_surface *surface;
    batten_edge edge;
} batten_surface_edge;

/** What is wanted of a ribbon. */
typedef struct batten_ribbon_wish {
    int order;          /**< 0: the edge; 1: and the slope; 2: and the second derivative */
    const double *ends; /**< [2][d] inward derivatives wanted at the ends, those of the boundary
                             curves beside it; NULL with order 0 */
    double tolerance;   /**< model units */
} batten_ribbon_wish;

/**
 * A boundary curve C(t) and, as curves over the same domain, the derivatives of the surface
 * across it, towards its inside: the vector that C gains for a unit of the parameter across.
 * Only references: the maker keeps them alive.
 */
typedef struct batten_ribbon {
    const batten_curve *curve;
    const batten_curve *slope;     /**< first derivative across; NULL: none is wanted */
    const batten_curve *curvature; /**< second derivative across, with `slope`; or NULL */
} batten_ribbon;

/**
 * The ribbon of a surface's edge, as its neighbour needs it: slope (and curvature) continue the
 * surface beyond the edge, so that a patch with this ribbon joins it with one tangent plane
 * (and curvature). The curves run in the direction of the edge's parameter, over its domain,
 * and are exact; a rational surface whose derivatives are of too high a degree is met within
 * `tolerance`.
 *
 * @param surface  any, in space
 * @param edge  which of the four
 * @param order  1: slope; 2: and curvature
 * @param tolerance  model units, above 0 when the ribbon is not exact
 * @param[out] error  how far slope and curvature are from the truth, 0 when exact; may be NULL
 * @param[out] curves [order + 1] the curve, slope, curvature; give the references back
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, TOLERANCE_NOT_MET, BAD_DEGREE, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the three rows next to the edge; where it is fitted, a
 * fit of 25 samples and more for each span.
 */
BATTEN_API batten_status batten_edge_ribbon(const batten_surface *surface, batten_edge edge,
                                            int order, double tolerance, double *error,
                                            batten_curve **curves);

/** How a surface joins another one along an edge. */
typedef struct batten_edge_join {
    double gap; /**< the largest distance from the other edge, model units */
    double
        angle; /**< the largest angle between both tangent planes, radians; above pi / 2 they turn back */
    batten_vec3 at; /**< where that is */
    double
        curvature; /**< the largest normal curvature of the other across the edge, 1 / length */
    double curvature_difference; /**< of both across the edge, at most */
} batten_edge_join;

/**
 * How far an edge of a surface is from continuing another surface that has an edge along it: what was made to be
 * smooth with a neighbour is measured against this neighbour itself.
 *
 * @param edge  of a surface in space
 * @param beside  in space; one of its edges, or a part of one, runs along the edge
 * @param tolerance  model units, above 0: how far both edges may be apart
 * @param[out] out  the largest of 17 places of every span, and of 257 at least; places where one of both has no normal do not count
 * @return BATTEN_OK; BAD_ARGUMENT for surfaces that are not in space, NOT_FOUND with the distance of the nearest edge,
 * OUT_OF_MEMORY
 *
 * Cost: two points and some steps along the other edge for each place.
 */
BATTEN_API batten_status batten_surface_edge_join(batten_surface_edge edge,
                                                  const batten_surface *beside,
                                                  double tolerance, batten_edge_join *out);

/** One curve's place in a loop. */
typedef struct batten_loop_place {
    int curve;     /**< which of the given ones */
    bool reversed; /**< it runs against the loop */
    double gap;    /**< from its end to the start of the next one */
} batten_loop_place;

/**
 * Put curves given in any order and direction end to end into one closed loop that begins with
 * the first curve, in its direction; each next one is the nearest that is left.
 *
 * A chain whose corners are nearer than `tolerance` is a loop.
 *
 * @param curves [count], 2 or more, open, of one dimension
 * @param tolerance  model units, 0 or more
 * @param[out] places  [count], which curve comes next, whether reversed, and the gap after it
 * @return BATTEN_OK; NOT_COMPATIBLE naming the corner (k: where the k-th of the loop begins), both
 * curves and the gap ("corner 2, between curves 1 and 4, is open by 0.12"); COINCIDENT for a curve without length or two that
 * are the same; BAD_ARGUMENT (count, tolerance), OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: count^2 distances of ends.
 */
BATTEN_API batten_status batten_curves_loop(int count, const batten_curve *const *curves,
                                            double tolerance, batten_loop_place *places);
/* ---- blending functions ---- */

/** Families of blending functions F0, F1, G0, G1, H0, H1 over [0, 1]. */
typedef enum batten_blending {
    BATTEN_BLENDING_LINEAR,  /**< F alone: values */
    BATTEN_BLENDING_CUBIC,   /**< F, G: values and slopes; second derivatives do not vanish */
    BATTEN_BLENDING_QUINTIC, /**< F, G, H, all axioms */
    BATTEN_BLENDING_COONS,   /**< the same of C2 cubics on three equal spans */
    BATTEN_BLENDING_GIVEN
} batten_blending;

/**
 * The functions of a family.
 *
 * F_i is 1 at i and 0 at the other end, with slopes and second derivatives 0; G_i has the slope
 * 1 at i and H_i the second derivative 1, all else at both ends being 0. (Linear F only have
 * values, cubic F and G values and slopes.)
 *
 * @param family  which one
 * @param order  1: F; 2: and G; 3: and H
 * @param[out] out [2 * order] curves of dimension 1
 * @return BATTEN_OK; UNSUPPORTED when the family has no G or no H; BAD_ARGUMENT
 *
 * Cost: constant.
 * Source: [Coons74]; G1 and H0, H1 in the space of his splines are derived here.
 */
BATTEN_API batten_status batten_blending_functions(batten_blending family, int order,
                                                   batten_curve **out);

/**
 * Do functions have what makes them blending functions?
 *
 * @param functions [2 * order] F0, F1, G0 .., polynomial or rational, of dimension 1, over
 * [0, 1]
 * @param derivatives  0..2: up to which derivative both ends are looked at; a patch with
 * functions of this order interpolates when order - 1 are right, and patches join with C2 when
 * 2 are
 * @return BATTEN_OK; NOT_COMPATIBLE naming the axiom: "G1: the second derivative at 1 is 0.4,
 * not 0" (1e-10 is let pass); BAD_ARGUMENT
 *
 * Cost: a few evaluations at both ends of each function.
 */
BATTEN_API batten_status batten_blending_check(int order, const batten_curve *const *functions,
                                               int derivatives);

/* ---- one patch ---- */

/** What becomes of twists, d/dv r_u and d/du r_v at a corner, that differ. */
typedef enum batten_twist_policy {
    BATTEN_TWIST_REFUSE,
    BATTEN_TWIST_KEEP_U, /**< slopes across u = 0 and 1 hold, those across v give way. The same
                              surface comes from adding G0 (difference) to the latter */
    BATTEN_TWIST_KEEP_V,
    BATTEN_TWIST_MEAN,   /**< all give way by half */
    BATTEN_TWIST_GREGORY /**< all hold; the twist turns from the one to the other about the
                              corner, and the patch is no longer a spline. Of order 2; with
                            order 3 they are refused */
} batten_twist_policy;

typedef struct batten_surface_coons_options {
    size_t size;
    int order; /**< 1: the first kind, positions; 2: and slopes; 3: and curvatures */
    batten_blending blending_u, blending_v;
    const batten_curve *const *given_u; /**< [2 * order], with BATTEN_BLENDING_GIVEN */
    const batten_curve *const *given_v;
    double tolerance; /**< of all gaps, model units (the parameters run over 0..1); rounding is
                           let pass beyond it */
    batten_twist_policy twist;
    bool repair; /**< a slope or curvature that does not fit the boundary curve at a
                               corner is corrected (F times the gap is added), not refused */
    const double
        *twists; /**< [4][d], corners around it: (0,0), (1,0), (1,1), (0,1); where no slope
                             says what the twist is; NULL: that of the bilinear patch */
} batten_surface_coons_options;

/** First kind, linear functions, tolerance 1e-6, Gregory's twists. */
BATTEN_API batten_surface_coons_options batten_surface_coons_defaults(void);

typedef struct batten_surface_coons_report {
    double corner_gap, slope_gap, twist_gap, higher_gap; /**< the largest, model units; but for
                              corner_gap of vectors per unit of the parameters */
    int corner, slope_corner, twist_corner; /**< where: 1 (0,0), 2 (1,0), 3 (1,1), 4 (0,1) */
    double missed[4][3]; /**< [edge][derivative across]: by how much the surface misses it,
                              largest along the edge */
    double slope_angle;  /**< where slope_gap is: at which the boundary curve leaves the tangent
                              plane, radians */
    double angle[4];     /**< [edge]: the largest between the tangent planes of the surface and
                              of the side, radians; 0 without a slope */
    bool exact;          /**< batten_surface_to_nurbs is exact */
} batten_surface_coons_report;

/**
 * The Coons patch between four sides, a surface of kind "coons" over [0, 1] x [0, 1].
 *
 * Order 1 is the bilinearly blended patch with linear functions; with others neighbours have
 * common slopes across an edge when the net is smooth through its ends. Order 2 takes slopes as
 * well, order 3 curvatures. Slopes and curvatures that are NULL are made from what is known at
 * the corners: so order 2 without any slope is the first kind with chosen twists, + sum G_i
 * T_ij G_j, the cure of flat spots.
 *
 * @param sides [4] by batten_edge; V0 and V1 run along u, U0 and U1 along v, over any domain,
 * mapped to [0, 1]; slopes point inside, per unit of the parameter across. A side may be a
 * point
 * @param options NULL for the defaults
 * @param[out] report  what was found; may be NULL; with NOT_COMPATIBLE up to the gap that was
 *              refused
 * @return BATTEN_OK; NOT_COMPATIBLE naming corner, edges and gap, of a slope also the angle at
 * which the boundary curve leaves the tangent plane; UNSUPPORTED (functions that the family
 * lacks); BAD_ARGUMENT, NOT_FINITE (twists), BAD_DEGREE, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * batten_surface_to_nurbs gives one tensor B-spline, equal but for rounding, when nothing is
 * rational, or the rational curves along each direction share their weights; else, and with
 * Gregory's twists, one within the tolerance. With a tolerance above 0 knots of different
 * curves that are nearer than 1e-9 become one, and the error says how far the surface moved by
 * that.
 *
 * Cost: linear in the control points of the sides to make it; afterwards each point costs one
 * of each line and function.
 * Source: [Coons67], [Coons74], [SL] V.2.
 */
BATTEN_API batten_status batten_surface_coons(const batten_ribbon sides[4],
                                              const batten_surface_coons_options *options,
                                              batten_surface_coons_report *report,
                                              batten_surface **out);

/**
 * The bicubic patch of what is known at its corners, or, with other functions, the same.
 *
 * @param dimension  coordinates of each point, 1 to 3
 * @param corners [2][2][4][d]: at (i, j) the point, r_u, r_v and the twist r_uv
 * @param family  not linear; with cubic functions one bicubic span
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, with a NURBS surface over [0, 1] x [0, 1]; BAD_ARGUMENT (dimension),
 * UNSUPPORTED (family), NOT_FINITE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: constant.
 * Source: [Coons67], [SL] V.2.
 */
BATTEN_API batten_status batten_surface_corner_patch(int dimension, const double *corners,
                                                     batten_blending family,
                                                     batten_surface **out);

/**
 * Four sides from any number of boundary curves in any order and direction.
 *
 * The curves are put into a loop (batten_curves_loop), cut into four sides, and the curves of a
 * side are joined; their parts of [0, 1] are as their lengths. A side of no curve is the point
 * where its neighbours meet. V0 begins with the first curve, in its direction.
 *
 * @param curves  [count], open, of one dimension
 * @param counts [4] curves of V0, U1, V1, U0; NULL: 1 each, or 1, 1, 1, 0 of three curves
 * @param tolerance  model units, above 0
 * @param[out] places [count], the loop; may be NULL
 * @param[out] sides [4] by batten_edge, in the directions that batten_surface_coons expects
 * @return as batten_curves_loop; BAD_ARGUMENT when the counts do not add up
 *
 * Cost: that of batten_curves_loop, and linear in the control points.
 */
BATTEN_API batten_status batten_boundary_sides(int count, const batten_curve *const *curves,
                                               const int *counts, double tolerance,
                                               batten_loop_place *places, batten_curve **sides);

/**
 * The ribbon along a boundary curve taken from the surface beside it.
 *
 * One of the four edges must run along the curve within `tolerance`, or the curve along a part
 * of it. The slope is the surface's, continued, times a + b t, plus (c + d t) times the
 * derivative of the curve: such that at both ends it is `ends`, as far as that lies in the
 * tangent plane of the surface. So the patch has the tangent planes of its neighbour, while its
 * boundary curves need not have their speeds. With curvatures there is one factor for the whole
 * edge, a, and a^2 for them: the boundary curves beside it must fit.
 *
 * @param surface  in space
 * @param curve  in space
 * @param wish  how many derivatives, with which at the ends, within which tolerance
 * @param[out] angle_error [2] sine of the angle between ends and tangent plane; may be NULL
 * @param[out] error  how far the derivatives are from the truth; may be NULL
 * @param[out] ribbon [order + 1] the edge as the surface has it, in the direction of the curve
 * and over [0, 1], and the derivatives across
 * @return BATTEN_OK; NOT_FOUND when no edge runs along the curve, with the distance of the
 * nearest; SINGULAR_HERE where the surface has no tangent plane at an end; NOT_COMPATIBLE when
 * `ends` leave the surface to different sides
 *
 * Cost: samples along each edge to find the one beside the curve, then that of
 * batten_edge_ribbon.
 */
BATTEN_API batten_status batten_ribbon_along(const batten_surface *surface,
                                             const batten_curve *curve, batten_ribbon_wish wish,
                                             double *angle_error, double *error,
                                             batten_curve **ribbon);

/* ---- networks ---- */

typedef struct batten_surface_coons_network_options {
    size_t size;
    batten_blending blending; /**< LINEAR: C0; CUBIC: C1; COONS or QUINTIC: C2 when the curves
                                   are */
    batten_twists twists;     /**< ADINI */
    const double *given;      /**< [count_u][count_v][d] twists of one's own; or NULL */
    double tolerance;         /**< of the curves at their crossings, 1e-6 */
    batten_parametrization parameters; /**< of a grid of points, averaged; CENTRIPETAL */
    batten_end_kind ends;              /**< of the splines through a grid; NOT_A_KNOT */
} batten_surface_coons_network_options;

/** Coons' functions, Adini's twists. */
BATTEN_API batten_surface_coons_network_options batten_surface_coons_network_defaults(void);

/** A net of curves that cross; borrowed for the call. */
typedef struct batten_curve_net {
    int count_u, count_v;               /**< of the parameters, 2 or more of each */
    const double *u;                    /**< [count_u] increasing: where along_v stand */
    const double *v;                    /**< [count_v] increasing: where along_u stand */
    const batten_curve *const *along_u; /**< [count_v], with the domain [u[0], last u] */
    const batten_curve *const *along_v; /**< [count_u], with the domain [v[0], last v] */
} batten_curve_net;

/**
 * The net of Coons patches over a grid of curves, as one B-spline surface.
 *
 * It passes through all curves. Slopes across an edge are blended from those of the curves at
 * its ends, with the twists: so neighbours share them.
 *
 * @param given  u, v: [count_u], [count_v] increasing: parameters of the crossings, 2 or more
 *     along_u: [count_v] curves with the domain [u[0], last u]; curve j is at v[j]
 *     along_v: [count_u] the same along v
 * @param options  NULL for the defaults
 * @param[out] gap  the largest distance of two curves at their crossing; may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE naming the curves and the gap; UNSUPPORTED for rational curves; TOO_LARGE before
 * any work; BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, OVERFLOW, OUT_OF_MEMORY
 *
 * Interior knots stand p - 1 times (C1) or p - 2 times (C2), p the degree, unless the curves
 * themselves are less smooth. Cost: linear in the number of control points.
 */
BATTEN_API batten_status batten_surface_coons_network(
    const batten_curve_net *given, const batten_surface_coons_network_options *options,
    double *gap, batten_surface **out);

/**
 * The same over a grid of points: its curves are the cubic splines through the rows and through
 * the columns.
 *
 * Selesnick's twists take their curvatures from the bicubic spline through the points.
 * @param points  [count_u][count_v][dimension]
 * @param options  NULL for the defaults
 * @param[out] uv  u, v: parameters of the grid lines, 0 .. 1; may be NULL
 * @return as batten_surface_coons_network; COINCIDENT, naming the line of the grid
 *
 * Cost: linear in the points: one banded system for each line, and four numbers at each of
 * (count_u - 1) (count_v - 1) patches.
 */
BATTEN_API batten_status batten_surface_coons_grid(
    batten_grid points, const batten_surface_coons_network_options *options, batten_uv_out uv,
    batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
