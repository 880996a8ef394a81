#ifndef BATTEN_CONSTRAINED_H
#define BATTEN_CONSTRAINED_H
/**
 * @file
 * Curves through points that also obey inequalities: on one side of lines or planes, within a
 * band, never going back, bent to one side.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_constraint_kind {
    BATTEN_CONSTRAINT_VALUE, /**< normal . P >= bound + rate u: the side of a line or plane */
    BATTEN_CONSTRAINT_SLOPE, /**< normal . P' >= bound: never back, with bound 0 */
    BATTEN_CONSTRAINT_BEND,  /**< normal . P'' >= bound: bent to one side, with bound 0 */
    BATTEN_CONSTRAINT_DIRECTION, /**< at point `from` P' goes along `normal`, at least `bound`
                                    times as fast as the polygon on average; in 1 dimension P'
                                    is normal[0] */
    BATTEN_CONSTRAINT_MEAN       /**< the mean of normal . P over the parameter is `bound` */
} batten_constraint_kind;

/** One constraint; inequalities hold everywhere between two points. */
typedef struct batten_constraint {
    batten_constraint_kind kind;
    int from, to;     /**< indices of points, from < to; to = 0: the last one */
    double normal[3]; /**< [dimension], not 0 */
    double bound;
    double rate; /**< VALUE: for each unit of the parameter, so that functions have lines too */
} batten_constraint;

typedef struct batten_constrained_options {
    size_t size;
    int degree;                        /**< 3, which suits order 2; 1..25 */
    int pieces;                        /**< spans between neighbours among the points, 0..64; 0:
                                            the whole is one Bezier curve; 4 */
    int order;                         /**< of the derivative whose square is least, 1..5; 2 */
    int checks;                        /**< parts of each span whose control points obey the
                                            inequalities, 1..64; 4 */
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count] with BATTEN_GIVEN */
    const double *weights;             /**< [count] above 0: near the points instead of through
                                            them, infinity: through; NULL: through all */
    int constraint_count;
    const batten_constraint *constraints;
} batten_constrained_options;
BATTEN_API batten_constrained_options batten_constrained_defaults(void);

typedef struct batten_constrained_report {
    double energy; /**< the integral of the squared derivative */
    int active;    /**< inequalities between control values that hold with equality and press */
    int redundant; /**< equations that followed from others */
    double error_max; /**< the largest distance from a point */
} batten_constrained_report;

/**
 * The B-spline or Bezier curve through (or near) points, with the constraints, whose squared
 * derivative has the least integral: half of it, plus half the sum of the weights times the
 * squared distances.
 *
 * Inequalities are asked of the control points of `checks` parts of each span, so they hold at
 * every parameter; more checks ask less of the curve than is needed, and it comes nearer to
 * the best that there is.
 *
 * @param dimension 1 (a function of given parameters), 2 or 3
 * @param points    [count][dimension], 2 or more
 * @param options   NULL for the defaults
 * @param[out] parameters [count], may be NULL
 * @param[out] report     may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT; NOT_COMPATIBLE
 * naming the point or constraint that contradicts the others; SINGULAR_SYSTEM when the curve is
 * not determined; TOO_LARGE beyond 1000 unknowns, dimension (count - 1) pieces or so;
 * INCOMPLETE
 *
 * Cost: the cube of the number of unknowns, and for each constraint that presses the square of
 * their number times the unknowns: for some dozens of points. Source: [Wielinga74]; [GI83].
 */
BATTEN_API batten_status batten_curve_constrained(
    int dimension, int count, const double *points, const batten_constrained_options *options,
    double *parameters, batten_constrained_report *report, batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
