#ifndef BATTEN_FILL_H
#define BATTEN_FILL_H
/**
 * @file
 * Holes with any number of sides, filled smoothly by as many NURBS surfaces as there are sides.
 */
#include <batten/job.h>
#include <batten/ribbon.h>

#ifdef __cplusplus
extern "C" {
#endif

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

typedef struct batten_fill_options {
    size_t size;
    double tolerance; /**< corners of the loop may be open so far, and rational sides are met a
                           thousand times better; model units; 0: a millionth of the size */
    double angle;     /**< where the ribbons of a corner twist against each other the tangent
                           plane leaves them by so much at most, radians; 0.002 degrees */
    bool curvature;   /**< along ribbons that give a curvature take it over, too */
    batten_fill_form form; /**< BATTEN_FILL_SPLIT */
    bool may_fold;         /**< a fill that folds over is given, too; false */
} batten_fill_options;
BATTEN_API batten_fill_options batten_fill_defaults(void);

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

typedef struct batten_fill_report {
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
    int flat_corners; /**< corners where two sides go on smoothly: surfaces have no normal at
                            the point itself, and none is compared where their parameter
                            lines meet at less than 1e-4 */
    double rim_curvature;  /**< the largest of the ribbons that give one, 1 / length */
    double most_curvature; /**< what the curvature may differ by between the surfaces when it
                                is taken over: rim_curvature, at least 1 / size of the loop */
    bool folded;           /**< normals of neighbouring points turn back, or those along a side
                                against its ribbon: the fill overlaps */
    double fold_at[3];     /**< where it does first */
} batten_fill_report;

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
 * batten_surface_to_nurbs and batten_surface_to_smooth_nurbs approximate them.
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
 * @param[out] report may be NULL; set also with TOLERANCE_NOT_MET
 * @param[out] out [BATTEN_FILL_SIDES]; the first report->count are yours to unref, the others
 *             NULL
 * @return BATTEN_OK; BAD_ARGUMENT for fewer than 2 or more than 8 sides; NOT_COMPATIBLE naming
 * the corner of an open loop, the side whose ribbon points out of the hole, or a re-entrant
 * corner with ribbons (curves are counted from 1 in messages); SINGULAR_HERE where a ribbon has
 * no tangent plane at a corner; TOLERANCE_NOT_MET for a fill that folds over, that misses a
 * side, or whose curvature is too uneven, with the numbers; NOT_FINITE, COINCIDENT ...
 *
 * Degree and knots are those of the sides, three degrees higher. Cost: the cube of some 12 n
 * unknowns, and linear in the knots of two neighbouring sides.
 * Source: [CK83] for the division and [GZ94] for the vertex where n surfaces meet; [Kato91],
 * [CG84].
 */
BATTEN_API batten_status batten_surface_fill(int count, const batten_ribbon *sides,
                                             const batten_fill_options *options,
                                             batten_fill_report *report, batten_surface **out);

/**
 * The ribbon of the surface that lies beside a curve: one of whose edges the curve runs along,
 * wholly or in part. The curve that comes with the ribbon is that of the edge, in the direction
 * of the edge's parameter.
 *
 * @param curve     in space
 * @param surfaces  [count]; the first one that fits is taken
 * @param order     1: slope; 2: and curvature
 * @param tolerance how far the curve may be from the edge, model units
 * @param[out] curves  [order + 1], as batten_edge_ribbon; left alone when none lies beside it
 * @param[out] surface which one; -1 for none
 * @return as batten_edge_ribbon
 */
BATTEN_API batten_status batten_ribbon_beside(const batten_curve *curve, int count,
                                              const batten_surface *const *surfaces, int order,
                                              double tolerance, batten_curve **curves,
                                              int *surface);

#ifdef __cplusplus
}
#endif
#endif
