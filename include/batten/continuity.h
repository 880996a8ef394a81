#ifndef BATTEN_CONTINUITY_H
#define BATTEN_CONTINUITY_H
/**
 * @file
 * How smoothly curves go over into each other, and making them do so.
 */
#include <batten/body.h>
#include <batten/coons.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_curve_end { BATTEN_CURVE_START, BATTEN_CURVE_END } batten_curve_end;

/** What counts as equal. */
typedef struct batten_curve_continuity_options {
    size_t size;
    double gap;        /**< model units; 0: a millionth of the size of the curves */
    double angle;      /**< between tangents, radians; 0.01 degrees */
    double curvature;  /**< difference of curvatures, or of their rates, over the larger; 0.01.
                            What bulges by less than `gap` over the size counts as straight */
    double derivative; /**< difference of derivatives over the larger; 1e-6 */
} batten_curve_continuity_options;
/** The defaults of continuity: those beside the fields of batten_curve_continuity_options. */
BATTEN_API batten_curve_continuity_options batten_curve_continuity_defaults(void);

/**
 * What is true at a join, run through from the left piece L to the right piece R.
 *
 * The beta form: R' = b1 L', R'' = b1^2 L'' + b2 L', R''' = b1^3 L''' + 3 b1 b2 L'' + b3 L'
 * with b1 > 0 is the same as equal tangent, curvature and rate of curvature; b1 = 1, b2 = b3 =
 * 0 as equal derivatives.
 */
typedef struct batten_continuity {
    double u;       /**< the knot; of two curves, where the first one ends */
    int parametric; /**< the highest k <= 3 with C^k; -1 for a gap */
    int geometric;  /**< the highest k <= 3 with G^k; -1 for a gap; 0 where an end is singular
                         or the tangent turns back, whatever `parametric` says */
    double gap;     /**< model units */
    double angle;   /**< between the tangents, radians, 0 .. pi; where the first derivative
                         vanishes the tangent is that of the first that does not; NaN without */
    double
        curvature_difference; /**< of the curvature vectors, 1 / length; NaN where singular */
    double curvature_part;    /**< the same over the larger curvature */
    double rate_difference;   /**< of the derivatives by arc length of the curvature vectors, as
                                   far as they lie across the tangent, 1 / length^2 */
    double rate_part;         /**< the same over the larger rate */
    double curvature[2];      /**< before and behind; NaN where singular. In the plane signed */
    double rate[2];           /**< of curvature by arc length; in space never negative */
    double beta[3];           /**< best fits of b1, b2, b3, each with those before it */
    double residual[3];       /**< what these leave of R', R'', R''' */
    bool singular[2];         /**< the first derivative vanishes before, behind */
    bool reversed;            /**< the tangent turns back: a cusp */
} batten_continuity;

/**
 * The join of an end of one curve with an end of another: L runs towards the end named of
 * `first`, R away from that of `second`.
 * @param first  any curve
 * @param first_end  which end of the first
 * @param second  of the same dimension
 * @param second_end  which end of the second
 * @param options NULL for the defaults
 * @param[out] out  gaps, angles and ratios, order by order
 * @return BATTEN_OK; NOT_COMPATIBLE when their dimensions differ; BAD_ARGUMENT (options)
 *
 * Cost: two evaluations to order 4 at most.
 * Source: [BD89] for the beta form.
 */
BATTEN_API batten_status batten_curves_continuity(
    const batten_curve *first, batten_curve_end first_end, const batten_curve *second,
    batten_curve_end second_end, const batten_curve_continuity_options *options,
    batten_continuity *out);

/** All joins of one curve: at its inner knots, in order, then, when its ends lie within the gap
 * allowed, at the seam. Release `at` with batten_release. */
typedef struct batten_continuities {
    int count;
    batten_continuity *at;
} batten_continuities;

/**
 * How a curve continues at each of its inner knots, and of a closed curve at its seam.
 *
 * @param curve  any curve
 * @param options  tolerances; NULL for the defaults
 * @param[out] out  one entry for each knot that may be rough
 * @return BATTEN_OK, OUT_OF_MEMORY; as batten_curves_continuity
 *
 * Cost: linear in the knots.
 */
BATTEN_API batten_status batten_curve_continuity(const batten_curve *curve,
                                                 const batten_curve_continuity_options *options,
                                                 batten_continuities *out);

/* ---- the joins of a whole model ---- */

/** The largest of a measure, and where; NaN where it is not known. */
typedef struct batten_join_worst {
    double value;
    batten_vec3 at;
} batten_join_worst;

/**
 * Where two shapes meet, and how smoothly. Of curves at one point, of surfaces everywhere along an edge: there
 * angles are those between tangent planes, curvatures and rates those of the sections square to the edge, by
 * the linkage curve theorem enough for all directions.
 */
typedef struct batten_join {
    int shape[2]; /**< which curves, surfaces or faces; the same twice at a seam */
    int side
        [2];  /**< of curves 0 the start, 1 the end; of surfaces 0 u low, 1 u high, 2 v low, 3 v
                       high; of faces -1 */
    int part; /**< of surfaces: which of the two edges runs along a part of the other; -1: all
                       meets all */
    int edge; /**< of a body: which edge; else -1 */
    int parametric; /**< of curves: the highest C^k, k <= 3; else -1 */
    int geometric;  /**< the highest k <= 3 with G^k everywhere within the bounds; -1: a gap */
    batten_join_worst gap;       /**< model units */
    batten_join_worst angle;     /**< radians, 0 .. pi */
    batten_join_worst curvature; /**< difference of the curvatures over the larger one */
    batten_join_worst rate;      /**< difference of their rates by length over the larger one */
    double curvature_difference; /**< the largest, 1 / length */
    double rate_difference;      /**< the largest, 1 / length^2 */
} batten_join;

/** Release with batten_joins_release. */
typedef struct batten_joins {
    int count;
    batten_join *at; /**< in order of shapes and sides */
    bool left_out;   /**< there are more than 10,000 */
} batten_joins;

/**
 * All places where ends of curves meet, found without being told which: those within `options->gap`.
 *
 * @param count  number of curves
 * @param curves  [count], of one dimension
 * @param options  what counts as equal; NULL for the defaults, the gap then a millionth of the size of all
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  release with batten_joins_release
 * @return BATTEN_OK; NOT_COMPATIBLE when curves of several dimensions meet; BAD_ARGUMENT (options), CANCELLED,
 * INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: count log count, and as batten_curves_continuity for each join.
 */
BATTEN_API batten_status batten_curves_joins(int count, const batten_curve *const *curves,
                                             const batten_curve_continuity_options *options,
                                             const batten_job *job, batten_joins *out);
/**
 * All common edges of surfaces, found without being told which: edges that run along each other within
 * `options->gap` from end to end, or one of them along a part of the other. Seams of closed surfaces are among
 * them; edges that are collapsed to a pole are not.
 *
 * Each is visited at 8 steps of every span and 32 at least; from the largest value found of each measure its
 * greatest is followed between these places. Where a surface is singular only the gap is known.
 *
 * @param count  number of surfaces
 * @param surfaces  [count], of one dimension
 * @param options  what counts as equal; NULL for the defaults, the gap then a millionth of the size of all
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  release with batten_joins_release
 * @return BATTEN_OK; BAD_ARGUMENT (options), CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: count log count, and some 40 places of each join: of each two evaluations to order 3 and a foot on a
 * curve.
 * Source: [PW92] for the direction across.
 */
BATTEN_API batten_status batten_surfaces_joins(int count, const batten_surface *const *surfaces,
                                               const batten_curve_continuity_options *options,
                                               const batten_job *job, batten_joins *out);
/**
 * How smoothly faces continue across each edge that two of them share, or that is the seam of one.
 *
 * Both surfaces are looked at in the feet of the places of the edge, from its parameters where it has some;
 * places as of batten_surfaces_joins. Of a seam without parameters only the gap is known. Edges without a curve,
 * with one use, and with more than two are left out.
 *
 * @param body  any body
 * @param options  what counts as equal; NULL for the defaults; a gap of 0: the tolerance of the body
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  in order of edges; `shape` are faces; release with batten_joins_release
 * @return BATTEN_OK; BAD_ARGUMENT (options), CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: some 40 places of each edge, with two feet on a surface each.
 * Source: [PW92] for the direction across.
 */
BATTEN_API batten_status batten_body_joins(const batten_body *body,
                                           const batten_curve_continuity_options *options,
                                           const batten_job *job, batten_joins *out);

/** Release joins, and empty them. */
BATTEN_API void batten_joins_release(batten_joins *joins);

typedef enum batten_match_kind {
    BATTEN_MATCH_GEOMETRIC, /**< G^k: tangent, curvature */
    BATTEN_MATCH_PARAMETRIC /**< C^k: derivatives */
} batten_match_kind;
typedef enum batten_match_mover {
    BATTEN_MATCH_MOVES_SECOND,
    BATTEN_MATCH_MOVES_FIRST,
    BATTEN_MATCH_MOVES_BOTH
} batten_match_mover;

/** How two curves are to meet. */
typedef struct batten_match {
    batten_match_kind kind;
    int order;
    batten_match_mover mover;
} batten_match;

/**
 * Make the end of one curve and the start of another join smoothly, by moving the order + 1
 * control points next to the join of one of them or of both.
 *
 * PARAMETRIC moves make the sum of squared movements least. GEOMETRIC moves go point by point:
 * the end point, then the second one by the least way onto the tangent (both move: onto the
 * bisector of the two), then the third one across the tangent as far as curvature asks for
 * (both move: to the mean of the curvatures). Weights and knots stay; periodic curves become
 * clamped.
 *
 * @param first, second  of one dimension
 * @param how  order: 0..2 GEOMETRIC, 0..3 PARAMETRIC; the degrees must be `order` or more
 * @param[out] moved  the longest move of a control point, model units; may be NULL
 * @param[out] first_out  the first curve as it becomes
 * @param[out] second_out  the second one
 * @return BATTEN_OK; BAD_ARGUMENT, BAD_DEGREE; NOT_COMPATIBLE; SINGULAR_HERE when an end has no
 * tangent, or the tangents are opposite when both move; TOLERANCE_NOT_MET when the result,
 * measured, does not join as asked
 *
 * Cost: linear in the control points, for the copies.
 */
BATTEN_API batten_status batten_curves_match(const batten_curve *first,
                                             const batten_curve *second, batten_match how,
                                             double *moved, batten_curve **first_out,
                                             batten_curve **second_out);
/** What a match did, and how well the surfaces then join. */
typedef struct batten_surface_match_report {
    double moved;     /**< the longest move of a control point, after refinement */
    double gap;       /**< largest distance of the edges at equal places along them */
    double angle;     /**< largest angle between the tangent planes along the edge, radians */
    double curvature; /**< largest difference of a principal curvature, 1 / length; NaN where
                         one of the surfaces has no curvature on the edge */
    bool reversed;    /**< the edges run against each other */
} batten_surface_match_report;

/**
 * The edges of two surfaces whose ends are nearest to each other, and the larger distance of
 * an end from its partner; of equal ones the first.
 *
 * @param first, second  in space
 * @param[out] first_edge  an edge of the first
 * @param[out] second_edge  an edge of the second
 * @param[out] gap  model units; may be NULL
 * @return BATTEN_OK, NOT_COMPATIBLE
 *
 * Cost: the four corners of each surface, 64 evaluations in all.
 */
BATTEN_API batten_status batten_surfaces_near_edges(const batten_surface *first,
                                                    const batten_surface *second,
                                                    batten_edge *first_edge,
                                                    batten_edge *second_edge, double *gap);

/**
 * Move the rows of control points of `first` next to an edge, so that the edge becomes the edge
 * of `second` and the surfaces join there.
 *
 * Row 0 becomes the other's edge. With order 1 row 1 is laid so that the derivative across is
 * the other's, times one factor that keeps the mean length it had: one tangent plane, and C1 up
 * to that factor, as Bezier patches are joined. With order 2 row 2 follows in the same way:
 * curvature continues. The rows behind stay. Along the edge the surface takes over the knots
 * and the degree of the other; it is refined exactly before.
 *
 * @param first  whose rows move: a polynomial NURBS surface, and its edge
 * @param second  which it joins
 * @param order      0 (edge), 1 (tangent plane), 2 (curvature)
 * @param tolerance  within which the edge and the derivatives of a rational `second` are met,
 * those of another exactly
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; UNSUPPORTED when `first` is rational or not NURBS; BAD_DEGREE when its
 * degree across is below `order`; TOO_FEW_POINTS when the moved rows would reach the opposite
 * edge; NOT_COMPATIBLE when an edge is a point, or a surface has no slope across its edge;
 * TOLERANCE_NOT_MET when the edges, measured, are farther apart than that
 *
 * Cost: linear in the control points after both are refined along the edge.
 * Source: [Farin02] ch. 15 and 16.
 */
BATTEN_API batten_status batten_surface_match(batten_surface_edge first,
                                              batten_surface_edge second, int order,
                                              double tolerance,
                                              batten_surface_match_report *report,
                                              batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
