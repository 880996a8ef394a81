#ifndef BATTEN_FILL_H
#define BATTEN_FILL_H
/**
 * @file
 * Holes with any number of sides, filled smoothly by as many NURBS surfaces as there are sides.
 *
 * Gregory's square, the Coons patch of the second kind whose twists need not agree, is
 * batten_surface_coons with BATTEN_TWIST_GREGORY.
 */
#include <batten/coons.h>

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
 *
 * Cost: constant; no allocation.
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
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OUT_OF_MEMORY
 *
 * Slopes are continuous everywhere; at a corner second derivatives depend on the direction of
 * approach where its two points differ, and at the corner itself their mean counts.
 * batten_surface_to_nurbs approximates: the exact rational form has weights 0 at its corners.
 *
 * Cost: constant; a point of the surface one bicubic sum and two quotients.
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
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OUT_OF_MEMORY; NOT_COMPATIBLE when edges do not end where the
 * next begins
 *
 * Cost: constant; a point of the surface one quartic sum.
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
 * @param curves  [count], single cubics (or of lower degree) in any order and direction
 * @param tolerance  model units: how far corners may be open; ends meet halfway
 * @param[out] places [count], the loop; may be NULL
 * @return as batten_curves_loop and batten_gregory_field, naming the curve; BAD_ARGUMENT
 * (count), UNSUPPORTED for a side that is rational, of a higher degree or of more than one span
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_gregory_between(int count,
                                                        const batten_curve *const *curves,
                                                        double tolerance,
                                                        batten_loop_place *places,
                                                        batten_surface **out);

/**
 * How far the normals of two surfaces differ along each of the four edges: what a surface that
 * was made to continue its neighbours keeps of their tangent planes when a spline stands for it.
 *
 * @param a, b  in space, over the same domain
 * @param[out] angles [4] radians: by batten_edge: the largest of 32 places in
 * every span that either has; places where one of them has no normal (poles,
 * parameter lines that meet at less than 1e-4) do not count
 * @return BATTEN_OK; BAD_ARGUMENT for surfaces that are not in space, NOT_COMPATIBLE for
 * domains that differ, OUT_OF_MEMORY
 *
 * Cost: 64 normals for each span.
 */
BATTEN_API batten_status batten_surface_edge_angles(const batten_surface *a,
                                                    const batten_surface *b, double *angles);

/**
 * A NURBS surface near another one, whose normals along the edges are near too, so that
 * neighbours that are smooth together stay so. Knots are added near the edges until they are.
 *
 * @param surface   of any kind, in space
 * @param tolerance model units, > 0
 * @param angle     radians, > 0
 * @param[out] error  the deviation, model units; may be NULL
 * @param[out] angle_error  radians, the largest of batten_surface_edge_angles; may be NULL
 * @return as batten_surface_to_nurbs; TOLERANCE_NOT_MET with the angle reached
 *
 * Cost: batten_surface_to_nurbs, then a spline more for every halving of the spans at the edges;
 * at most 250000 control points.
 */
BATTEN_API batten_status batten_surface_to_smooth_nurbs(const batten_surface *surface,
                                                        double tolerance, double angle,
                                                        double *error, double *angle_error,
                                                        batten_surface **out);
typedef enum batten_triangle_method {
    /** Nielson: along the lines from each side to its opposite corner. With slopes of cubic
     * precision. Kind "side-vertex". */
    BATTEN_TRIANGLE_SIDE_VERTEX,
    /** Barnhill, Birkhoff and Gordon: along parallels to the sides; half the sum of the three
     * less the plane of the corners, or, with slopes, the mean of the six Boolean sums, whose
     * twists are reconciled by rational terms. Kind "barnhill-birkhoff-gordon". */
    BATTEN_TRIANGLE_PARALLELS,
    /** Charrot and Gregory: Taylor expansions about both sides of each corner, blended. Kind
     * "charrot-gregory". */
    BATTEN_TRIANGLE_CORNERS
} batten_triangle_method;

/**
 * The surface between three curves.
 *
 * It is seen over the unit square: barycentric coordinates (1 - u, u (1 - v), u v), where
 * corner 0 is opposite the first curve and v runs along that curve; u = 0 is a pole. Corners
 * and curves may come in any order: only the labels change, not the surface.
 *
 * Without slopes the surface meets the curves (C0). With one or more it has along each such
 * curve the tangent planes that the curve and its slope span: to meet the other curves'
 * tangents at the corners, the slope T becomes k(t) T + h(t) C', k and h linear. Curves without
 * a slope take the linear blend of their neighbours' tangents. Curvatures of ribbons are not
 * used.
 *
 * Derivatives at corners 1 and 2 (u = 1, v = 0 and 1), where second derivatives have no limit,
 * and within 1e-6 of them in both parameters are those at that distance.
 *
 * @param ribbons   three curves of dimension 3 without kinks
 * @param method  which of them
 * @param tolerance  of the corners, in model units; the loop may be open by so much there
 * @param angle_tolerance  in radians: how far a curve may leave the tangent plane of its
 * neighbour's ribbon at a corner
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE naming the corner and the gap, or the angle; COINCIDENT;
 * SINGULAR_HERE where slopes are given and a curve has no tangent at a corner, or a ribbon no
 * tangent plane; BAD_ARGUMENT for other dimensions or a curve with a kink
 *
 * Cost: 3 to 6 points of curves each, and some thousand multiplications, for a point with
 * derivatives up to order 3.
 * Source: [BarnhillBirkhoffGordon73], [Nielson79], [CharrotGregory80]. The mean of the sums,
 * and the linear k and h, are ours: so that no order of the sides is preferred, and ribbons of
 * any surface fit.
 */
BATTEN_API batten_status batten_triangle_patch(const batten_ribbon ribbons[3],
                                               batten_triangle_method method, double tolerance,
                                               double angle_tolerance, batten_surface **out);
/** The most sides a hole may have. */
#define BATTEN_FILL_SIDES 8

/** What the surfaces are. */
typedef enum batten_fill_form {
    BATTEN_FILL_SPLIT, /**< NURBS, exact along all edges */
    BATTEN_FILL_KATO,  /**< formulas of kind "kato": the sides, continued straight along their
                            ribbons, weighed by the squared distances from the other sides of a
                            regular polygon */
    BATTEN_FILL_CHARROT_GREGORY /**< formulas of kind "charrot-gregory": the corners, each the
                                     surface between its two ribbons, weighed by the squared
                                     distances from the sides that do not meet there */
} batten_fill_form;

typedef struct batten_surface_fill_options {
    size_t size;
    double tolerance; /**< corners of the loop may be open so far, and rational sides are met a
                           thousand times better; model units; 0: a millionth of the size */
    double angle;     /**< where the ribbons of a corner twist against each other the tangent
                           plane leaves them by so much at most, radians; 0.002 degrees */
    bool curvature;   /**< along ribbons that give a curvature take it over, too */
    batten_fill_form form; /**< BATTEN_FILL_SPLIT */
    bool may_fold;         /**< a fill that folds over is given, too; false */
    bool as_splines; /**< forms that are formulas come as NURBS surfaces within the tolerance
                                of them, whose normals along the edges are within the angle of
                                those of the formula; what is reported is measured on these; false */
} batten_surface_fill_options;
/** The defaults of n-sided fills: those beside the fields of batten_surface_fill_options. */
BATTEN_API batten_surface_fill_options batten_surface_fill_defaults(void);

/** What a fill reached along one edge: measured on the surfaces, at 17 places of each span. */
typedef struct batten_fill_edge {
    int curve;      /**< which of the given sides; -1: an edge between two of the surfaces */
    int first;      /**< the surface whose u = 0 .. 1 runs along the edge (v = 0), or which has
                         the inner edge at u = 1 */
    int second;     /**< the surface on the other side, or along the other half of the side */
    bool has_slope; /**< there is something that the tangent planes are compared with */
    bool has_curvature;
    double gap;       /**< the largest distance, model units */
    double angle;     /**< the largest angle between the normals, radians */
    double curvature; /**< the largest difference of the normal curvatures across the edge */
    double gap_at[3], angle_at[3], curvature_at[3]; /**< where, in space */
} batten_fill_edge;

typedef struct batten_surface_fill_report {
    int count; /**< of the surfaces: as many as sides, after those with corners are divided */
    batten_fill_edge outer[BATTEN_FILL_SIDES]; /**< [count], round the loop */
    batten_fill_edge inner[BATTEN_FILL_SIDES]; /**< [count], between surface i and the next */
    double loop_gap;                           /**< the widest corner of the loop */
    double approximation; /**< how far the sides are from the given curves */
    double corner_angle;  /**< the largest between the planes of the ribbons that meet in a
                                corner, or of one and the side beside it, radians: no surface
                                joins both there */
    int corner;           /**< at the start of side `corner` of the loop */
    double twist;     /**< the largest disagreement of two ribbons about how the tangent plane
                            turns in a corner, over the speed there; where it is not 0 no
                            surface has a curvature */
    int twisted;      /**< corners with such a disagreement */
    int flat_corners; /**< corners where two sides continue smoothly: surfaces have no normal at
                            the point itself, and none is compared where their parameter
                            lines meet at less than 1e-4 */
    double rim_curvature;  /**< the largest of the ribbons that give one, 1 / length */
    double most_curvature; /**< what the curvature may differ by between the surfaces when it
                                is taken over: rim_curvature, at least 1 / size of the loop */
    bool folded;           /**< normals of neighbouring points turn back, or those along a side
                                against its ribbon: the fill overlaps */
    double fold_at[3];     /**< where it does first */
} batten_surface_fill_report;

/**
 * Fill a hole: the fairest surfaces with one tangent plane along all edges.
 *
 * The hole is divided from its centre to the middle of each side. The n surfaces are over
 * [0, 1] x [0, 1]; surface i has its corner (0, 0) at the start of side i, v = 0 along the
 * first half of the side, u = 0 along the second half of the side before, and (1, 1) at the
 * centre. The sides are met exactly, the tangent planes of their ribbons too, but for small
 * zones at corners where two ribbons twist against each other; between the surfaces tangent
 * planes are the same to rounding. All that is left free makes the bending of the whole least.
 *
 * With `curvature` the surfaces are bent so that they have the normal curvature of the ribbons
 * along the sides, to what the report says; at corners where the ribbons contradict each other
 * this fades away within a quarter of half a side. Between the surfaces curvature is not the
 * same, but nearly: the report says how nearly. Where they contradict each other much there is
 * no such fill: when the curvatures across an edge between the surfaces differ by more than the
 * largest curvature of the ribbons, or, if these are flatter than a ball of the loop's size, by
 * more than 1 / size, the fill is refused. (The size is half the longest edge of the box around
 * the loop.) One that folds over is refused, with or without curvature, unless it may.
 *
 * The other forms are procedural: surface i is the same quarter of one formula over a polygon,
 * smooth inside, with the positions and tangent planes of the ribbons; a side without slope is
 * given one that goes over from the tangent of the side before to that of the side behind.
 * batten_surface_to_nurbs and batten_surface_to_smooth_nurbs approximate them, or as_splines.
 *
 * Ribbons that contradict each other in a corner (report: corner_angle) are left there: no
 * surface joins both. The fill has the plane of the two sides in the corner itself; split
 * surfaces come back to the ribbons' planes within a 64th of half a side, formulas slowly along
 * all of it. The angles along the sides say how much is left.
 *
 * Sides come in any order and direction, and are put into a loop. One with a corner inside is
 * divided there, and one of two is halved; then there may be 3 to 8.
 *
 * @param sides [count], curves in space; `slope` points into the hole, NULL leaves the tangent
 *              planes along the side free; a re-entrant corner of the hole, of more than 180
 *              degrees, cannot have ribbons
 * @param options NULL for the defaults
 * @param[out] report  what was reached; may be NULL; set also with TOLERANCE_NOT_MET
 * @param[out] out [BATTEN_FILL_SIDES]; the first report->count are yours to unref, the others
 *             NULL
 * @return BATTEN_OK; BAD_ARGUMENT for fewer than 2 or more than 8 sides; NOT_COMPATIBLE naming
 * the corner of an open loop, the side whose ribbon points out of the hole, or a re-entrant
 * corner with ribbons (curves are counted from 1 in messages); SINGULAR_HERE where a ribbon has
 * no tangent plane at a corner; TOLERANCE_NOT_MET for a fill that folds over, that misses a side, or whose
 * curvature is too uneven, with the numbers; COINCIDENT, UNSUPPORTED, BAD_DEGREE, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Degree and knots are those of the sides, three degrees higher. Cost: the cube of some 12 n
 * unknowns, and linear in the knots of two neighbouring sides.
 * Source: [CK83] for the division and [GZ94] for the vertex where n surfaces meet; [Kato91],
 * [CG84].
 */
BATTEN_API batten_status batten_surface_fill(int count, const batten_ribbon *sides,
                                             const batten_surface_fill_options *options,
                                             batten_surface_fill_report *report,
                                             batten_surface **out);

/** The most sides of a hole that one sheet fills. */
#define BATTEN_SHEET_SIDES 64

typedef struct batten_fill_sheet_options {
    size_t size;
    double tolerance; /**< of corners, sides, and what is inside; 0: a millionth of the size */
    double angle;     /**< between tangent planes and ribbons, radians; 0.002 degrees */
    bool curvature;   /**< take the curvature of ribbons over, too; false */
    /** How far it may be left, 1 / length; 0: a hundredth of the largest around, or of 1 / size
     * of the hole where that is more. */
    double most_curvature;
    batten_points points;    /**< that the sheet goes through, within the sides; none */
    batten_curve_row curves; /**< the same; none */
} batten_fill_sheet_options;
/** The defaults of sheets: those beside the fields of batten_fill_sheet_options. */
BATTEN_API batten_fill_sheet_options batten_fill_sheet_defaults(void);

/** What a sheet reached: measured at 66 places of each span of a side at least. */
typedef struct batten_fill_sheet_report {
    int count;                                  /**< of the sides */
    batten_fill_edge outer[BATTEN_SHEET_SIDES]; /**< [count], round the loop */
    double loop_gap;                            /**< the widest corner of the loop */
    double inside_gap;     /**< how far the sheet is from what is inside, model units */
    double inside_at[3];   /**< where */
    int inside;            /**< which point, from 1; or curve, from -1 down; 0: there is none */
    double rim_curvature;  /**< the largest of the ribbons that give one, 1 / length */
    double most_curvature; /**< what its difference was held to; infinite without `curvature` */
    int columns, rows;     /**< spans of the surface */
} batten_fill_sheet_report;

/** One side of a sheet. */
typedef struct batten_sheet_side {
    int curve;                /**< which of those given */
    bool reversed;            /**< it runs against the loop */
    batten_curve *parameters; /**< its (u, v) on the surface, over its own domain */
} batten_sheet_side;

/** A trimmed surface: what the sides, counter-clockwise in (u, v), go around. */
typedef struct batten_fill_sheet {
    batten_surface *surface;
    int count;
    batten_sheet_side sides[BATTEN_SHEET_SIDES]; /**< [count], round the loop */
} batten_fill_sheet;
/** Give back what a sheet refers to. */
BATTEN_API void batten_fill_sheet_release(batten_fill_sheet *sheet);

/**
 * Fill a hole of any outline by one surface that its sides trim, through points and curves inside.
 *
 * The surface is the graph of a quintic spline with single knots over the mean plane of the hole:
 * four derivatives are continuous inside, and it cannot fold. It bends little between what it
 * meets: by the squares of its second derivatives and a hundredth of those of its third, lengths
 * over half the size of the hole; beyond the sides a thousandth counts.
 *
 * @param sides [count], 2 to 64 curves in space in any order and direction; `slope` points into
 *              the hole; corners may be re-entrant, with ribbons too
 * @param options NULL for the defaults
 * @param[out] report  may be NULL; set also with TOLERANCE_NOT_MET
 * @param[out] out  to be released
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_COMPATIBLE naming an open corner, sides that cross as
 * seen along the mean normal, a side or ribbon that stands steeper than 84 degrees on the mean
 * plane, a ribbon that points out of the hole, what is inside and lies beyond the sides;
 * TOLERANCE_NOT_MET naming the side or what is inside, with the number; COINCIDENT,
 * NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: for n spans a side, 6 to 96, n^4 multiplications: some seconds with 96.
 * Source: [NW06] 17.3 for the multipliers.
 */
BATTEN_API batten_status batten_surface_fill_sheet(int count, const batten_ribbon *sides,
                                                   const batten_fill_sheet_options *options,
                                                   batten_fill_sheet_report *report,
                                                   batten_fill_sheet *out);

/**
 * The ribbon of the surface that lies beside a curve: one of whose edges the curve runs along,
 * wholly or in part. The curve that comes with the ribbon is that of the edge, in the direction
 * of the edge's parameter.
 *
 * @param curve     in space
 * @param surfaces  [count]; the first one that fits is taken
 * @param order     1: slope; 2: and curvature
 * @param tolerance how far the curve may be from the edge, model units
 * @param[out] surface  which one, from 0; -1 for none
 * @param[out] curves  [order + 1], as batten_edge_ribbon; left alone when no surface lies
 *              beside the curve
 * @return as batten_edge_ribbon
 *
 * Cost: samples of four edges for each surface until one fits, then that of batten_edge_ribbon.
 */
BATTEN_API batten_status batten_ribbon_beside(const batten_curve *curve,
                                              batten_surface_row surfaces, int order,
                                              double tolerance, int *surface,
                                              batten_curve **curves);

#ifdef __cplusplus
}
#endif
#endif
