#ifndef BATTEN_INTERPOLATE_H
#define BATTEN_INTERPOLATE_H
/**
 * @file
 * Curves through points by one linear system: splines, nu-splines and weighted splines,
 * quadratics,
 * Beta-splines, splines under conditions and in tension.
 *
 * Among all curves through the points they make the sum over the spans of w times the integral
 * of |P''|^2, plus the sum over the inner points of nu |P'|^2, least. A large w makes a span
 * straighter, a large nu draws the bend into its point.
 *
 * Where their knots are decides about them. Knots midway between the data are sound; knots at
 * the data are not: an error of the first slope continues for ever with changing sign.
 *
 * At a joint P' after it is beta1 times P' before it, and P'' after it beta1^2 P'' + beta2 P'
 * before it. With beta1 = 1 and beta2 = 0 they are the uniform cubic B-splines.
 *
 * Think of a batten that is pulled at its ends. Each span obeys P'''' = sigma^2 P''; first and
 * second derivatives are continuous at every point. Without tension it is the cubic spline,
 * with very much of it the polygon; in between, the turns that the data do not have disappear.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How parameters are given to points. */
typedef enum batten_parametrization {
    BATTEN_CENTRIPETAL, /**< step = sqrt of the chord */
    BATTEN_CHORD,       /**< step = the chord */
    BATTEN_UNIFORM,     /**< step = 1 */
    BATTEN_FOLEY,       /**< Foley-Nielson: affine invariant, by chords and angles */
    BATTEN_FOLEY_CHORD, /**< the same with Euclidean lengths ("modified chord") */
    BATTEN_GIVEN
} batten_parametrization;
/**
 * Parameters for points, beginning at 0.
 *
 * @param points  [count][dimension]
 * @param kind  any but BATTEN_GIVEN
 * @param closed  also give the step from the last point back to the first
 * @param[out] parameters  [count], or [count + 1] when closed; increasing
 * @return BATTEN_OK; COINCIDENT naming the first pair of neighbours that coincide (uniform
 * steps do not mind), NOT_FINITE, TOO_FEW_POINTS, TOO_LARGE, BAD_ARGUMENT (kind), OVERFLOW,
 * OUT_OF_MEMORY
 *
 * Cost: linear in count.
 * Source: [Lee89], [FN89].
 */
BATTEN_API batten_status batten_parametrize(batten_points points, batten_parametrization kind,
                                            bool closed, double *parameters);

/** What holds at one end of a cubic spline. */
typedef enum batten_end_kind {
    BATTEN_END_NOT_A_KNOT,
    BATTEN_END_NATURAL,   /**< second derivative 0 */
    BATTEN_END_CLAMPED,   /**< first derivative given in `vector` */
    BATTEN_END_DIRECTION, /**< direction in `vector`, length 1 per unit of chord parameter */
    BATTEN_END_SECOND,    /**< second derivative given in `vector` */
    BATTEN_END_PARABOLIC, /**< second derivative constant over the end span */
    BATTEN_END_BESSEL,    /**< tangent of the parabola through the first three points */
    BATTEN_END_CIRCLE,    /**< tangent of the circle through the first three points */
    BATTEN_END_CURVATURE, /**< curvature vector given in `vector`; what is not across the
                             tangent is left out */
    BATTEN_END_FAIR       /**< end slopes that make the jumps of the third derivative least */
} batten_end_kind;

typedef struct batten_end {
    batten_end_kind kind;
    double vector[3];
} batten_end;

/** A derivative that the curve must have at one of its data points. */
typedef struct batten_derivative {
    int index; /**< which data point */
    int order; /**< 1, 2 ... */
    double value[3];
} batten_derivative;

typedef struct batten_curve_interpolate_options {
    size_t size;
    int degree;                        /**< 3 */
    batten_parametrization parameters; /**< BATTEN_CENTRIPETAL */
    const double *given;               /**< [count] (periodic: [count + 1]) with BATTEN_GIVEN */
    bool knots_at_data;    /**< true: C2 cubic with knots at the data and conditions at the
                                ends (degree 3, or odd degrees with `derivatives`);
                                false: averaged knots, no end conditions needed */
    batten_end start, end; /**< used with knots at the data */
    bool closed;           /**< the curve closes smoothly; the first point is not repeated */
    int derivative_count;
    const batten_derivative
        *derivatives; /**< further conditions, at any data point (averaged knots) */
} batten_curve_interpolate_options;

/** Cubic, centripetal, knots at the data, not-a-knot ends. */
BATTEN_API batten_curve_interpolate_options batten_curve_interpolate_defaults(void);
/**
 * A curve through points.
 *
 * Two points give a line, fewer points than degree + 1 a lower degree; three with not-a-knot
 * ends the parabola.
 *
 * @param points  [count][dimension]; with a periodic curve each once
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, BAD_DEGREE, NOT_FINITE, TOO_FEW_POINTS, TOO_LARGE, COINCIDENT, NOT_INCREASING,
 * SINGULAR_SYSTEM, TOLERANCE_NOT_MET, OVERFLOW, OUT_OF_MEMORY
 *
 * With knots at the data each end takes (degree - 1) / 2 conditions; for each that is missing
 * it does without a knot. Periodic curves of even degree have their knots midway between the
 * points, and their domain begins half a step before the first.
 *
 * Cost: linear in count. The result is checked: it passes every point within 8 eps of the
 * largest coordinate of data and control points, else TOLERANCE_NOT_MET.
 * Source: [deBoor01] ch. IV, XIII; [PT97] 9.2; [Xin77] for fair ends.
 */
BATTEN_API batten_status
batten_curve_interpolate(batten_points points, const batten_curve_interpolate_options *options,
                         double *parameters, batten_curve **out);

/** What the points of a function say about its cubic spline. */
typedef struct batten_convexity {
    int points;    /**< 1: the slopes of the chords never fall, -1: never rise, 0: they do both;
                        1 of points in line */
    bool promised; /**< the spline is convex (points 1) or concave (-1) everywhere */
    int at;        /**< the first point that stands out, where the promise fails; or -1 */
} batten_convexity;
/**
 * Will the cubic spline through points of a function be convex, or concave? Convex points are
 * not enough: it can still swing beside a sudden turn. A promise is kept; without one the
 * spline may be convex all the same.
 *
 * @param x, y  [count], x increasing, 2 or more
 * @param start, end  as for batten_curve_interpolate, but not NOT_A_KNOT, FAIR or CURVATURE;
 * NULL: natural
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW, BAD_ARGUMENT
 * Cost: linear; nothing is solved.
 * Source: [SL] II.3, after Wang Rishuang.
 */
BATTEN_API batten_status batten_spline_convexity(int count, const double *x, const double *y,
                                                 const batten_end *start, const batten_end *end,
                                                 batten_convexity *out);
/** Where the weights of the spans come from. */
typedef enum batten_weight_rule {
    BATTEN_WEIGHTS_GIVEN, /**< those given, or 1 */
    BATTEN_WEIGHTS_SLOPE  /**< (1 + slope^2)^-3 of each chord, after Salkauskas: for functions
                               with steep places */
} batten_weight_rule;

typedef struct batten_curve_weighted_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count] (closed: [count + 1]) with BATTEN_GIVEN */
    bool closed;                       /**< closes smoothly; the first point is not repeated */
    batten_end start, end; /**< NATURAL; also CLAMPED, DIRECTION, SECOND, PARABOLIC, BESSEL,
                                CIRCLE */
    double nu;             /**< at every point, times the mean step of the parameters, so that
                                no unit matters. 0: none; 10: much */
    const double *nus;     /**< [count] point by point, instead; or NULL. Those of the ends of
                                an open curve say nothing */
    batten_weight_rule rule;
    const double *weights; /**< [spans], above 0; NULL: 1 */
} batten_curve_weighted_options;

/** Chord parameters, natural ends, nu 0, all weights 1: the cubic spline. */
BATTEN_API batten_curve_weighted_options batten_curve_weighted_defaults(void);
/**
 * The weighted nu-spline through points: a cubic for each span, with a common tangent at the
 * points.
 *
 * There w P'' after the point less w P'' before it is nu P'. So equal weights give continuous
 * curvature; unequal ones make it jump. With very large nu everywhere it becomes the polygon,
 * with one large nu a point gets a corner, where P' comes to 0. Negative nu loosen the point
 * and are allowed while there is a least. A closed curve comes back as a periodic one.
 *
 * @param points  dimension: 1..3
 *     [count][dimension], at least two; closed: at least three, each once
 * @param options  NULL for the defaults
 * @param[out] parameters  [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (weights, ends), NOT_FINITE, TOO_FEW_POINTS, COINCIDENT,
 * NOT_INCREASING, SINGULAR_SYSTEM (nu too negative), OVERFLOW, TOLERANCE_NOT_MET
 *
 * Cost: linear in count. The equations are checked for the slopes found.
 * Source: [Nielson74], [Salkauskas84], [Foley87].
 */
BATTEN_API batten_status batten_curve_weighted(batten_points points,
                                               const batten_curve_weighted_options *options,
                                               double *parameters, batten_curve **out);
typedef enum batten_quadratic_kind {
    BATTEN_QUADRATIC_BETWEEN,   /**< any data, knots midway between them, none in the two end
                                     spans */
    BATTEN_QUADRATIC_MIDPOINTS, /**< the data are the mid-points of the spans between knots, and
                                     both ends */
    BATTEN_QUADRATIC_SEQUENTIAL /**< knots at the data, one parabola after another */
} batten_quadratic_kind;

/** SEQUENTIAL: the one slope that is needed. */
typedef enum batten_quadratic_slope {
    BATTEN_QUADRATIC_BEST, /**< that which makes the sum of the squared jumps of P'' least */
    BATTEN_QUADRATIC_AT_START, /**< P' at the first point is given */
    BATTEN_QUADRATIC_AT_END    /**< P' at the last point is given */
} batten_quadratic_slope;

typedef struct batten_curve_quadratic_options {
    size_t size;
    batten_quadratic_kind kind;        /**< BETWEEN */
    batten_parametrization parameters; /**< BATTEN_CHORD; MIDPOINTS: UNIFORM or GIVEN, else they
                                            are taken as uniform */
    const double *given;               /**< [count] with BATTEN_GIVEN */
    batten_quadratic_slope slope;      /**< BEST */
    double vector[3];                  /**< AT_START, AT_END: P' */
} batten_curve_quadratic_options;

/** Knots midway between the data, chord parameters. */
BATTEN_API batten_curve_quadratic_options batten_curve_quadratic_defaults(void);
/**
 * A quadratic spline through points.
 *
 * MIDPOINTS: the knots k follow from the parameters t, k[0] = t[0], then k[i] = 2 t[i] - k[i -
 * 1]; they must increase and end at the last parameter. With uniform parameters these are 0,
 * 1/2, 3/2, 5/2 ... n. Its values at the knots are a dominant system. All three kinds reproduce
 * parabolas; the error of BETWEEN and MIDPOINTS falls with the third power of the step, that of
 * SEQUENTIAL does so only with the right slope. Two points give a line, three points of BETWEEN
 * or MIDPOINTS the parabola (MIDPOINTS: through the middle one at its mid-parameter).
 *
 * @param points     [count][dimension], at least two; MIDPOINTS: three
 * @param options    NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, NOT_INCREASING,
 * NOT_COMPATIBLE (parameters that are not mid-points, with the knot), OVERFLOW,
 * TOLERANCE_NOT_MET (a point is missed by more than rounding)
 *
 * Cost: linear in count.
 * Source: [Marsden74], [deBoor01] ch. VI.
 */
BATTEN_API batten_status batten_curve_quadratic(batten_points points,
                                                const batten_curve_quadratic_options *options,
                                                double *parameters, batten_curve **out);
/** What the points are. */
typedef enum batten_beta_use {
    BATTEN_BETA_NEAR,   /**< control points: the curve is drawn to them, and passes the ends */
    BATTEN_BETA_THROUGH /**< the joints: the curve passes all of them */
} batten_beta_use;
/**
 * A Beta-spline near or through points, of one Bezier piece for each step from point to point;
 * point i belongs to the parameter i. At the ends of an open curve there is no curvature; a
 * closed one comes back as a periodic curve.
 *
 * Larger beta2 draws the curve to its polygon; beta1 above 1 makes it leave each joint faster
 * than it comes, so that it leans to the later points, below 1 to the earlier ones: the
 * reversed points with 1 / beta1 and beta2 / beta1^3 give the reversed curve. Through points,
 * values far from 1 and 0 make large swings. For beta1 other than 1 the parameter has jumps of
 * speed at the joints, the shape is smooth.
 *
 * @param points [count][dimension]; open: at least two; closed: at least three, each once
 * @param use  what the points are
 * @param beta1  above 0
 * @param beta2  0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (the betas), NOT_FINITE, TOO_FEW_POINTS, OVERFLOW,
 * SINGULAR_SYSTEM, TOLERANCE_NOT_MET (a joint that misses its point by more than rounding)
 *
 * Cost: linear in count.
 * Source: [Barsky88].
 */
BATTEN_API batten_status batten_curve_beta(batten_points points, batten_beta_use use,
                                           double beta1, double beta2, bool closed,
                                           batten_curve **out);
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

typedef struct batten_curve_constrained_options {
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
} batten_curve_constrained_options;
/** The defaults of splines under conditions: those beside the fields of
 * batten_curve_constrained_options. */
BATTEN_API batten_curve_constrained_options batten_curve_constrained_defaults(void);

typedef struct batten_curve_constrained_report {
    double energy; /**< the integral of the squared derivative */
    int active;    /**< inequalities between control values that hold with equality and press */
    int redundant; /**< equations that followed from others */
    double error_max; /**< the largest distance from a point */
} batten_curve_constrained_report;
/**
 * The B-spline or Bezier curve through (or near) points, with the constraints, whose squared
 * derivative has the least integral: half of it, plus half the sum of the weights times the
 * squared distances.
 *
 * Inequalities are asked of the control points of `checks` parts of each span, so they hold at
 * every parameter; more checks ask less of the curve than is needed, and it comes nearer to
 * the best that there is.
 *
 * @param points  dimension: 1 (a function of given parameters), 2 or 3
 *     [count][dimension], 2 or more
 * @param options  NULL for the defaults
 * @param[out] parameters  [count], may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK; NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT; NOT_COMPATIBLE
 * naming the point or constraint that contradicts the others; SINGULAR_SYSTEM when the curve is
 * not determined; TOO_LARGE beyond 1000 unknowns, dimension (count - 1) pieces or so;
 * INCOMPLETE
 *
 * Cost: the cube of the number of unknowns, and for each constraint that presses the square of
 * their number times the unknowns: for some dozens of points.
 * Source: [Wielinga74]; [GI83].
 */
BATTEN_API batten_status batten_curve_constrained(
    batten_points points, const batten_curve_constrained_options *options, double *parameters,
    batten_curve_constrained_report *report, batten_curve **out);
/** What tension is added for, where the tension given is too little. */
typedef enum batten_tension_rule {
    BATTEN_TENSION_GIVEN,   /**< nothing */
    BATTEN_TENSION_CONVEX,  /**< no inflection that the polygon of the points does not have */
    BATTEN_TENSION_MONOTONE /**< each coordinate rises and falls only as the points do */
} batten_tension_rule;

typedef struct batten_chain_tension_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given;               /**< [count] (closed: [count + 1]) with BATTEN_GIVEN */
    bool closed;                       /**< closes smoothly; the first point is not repeated */
    batten_end start, end;  /**< NATURAL; also CLAMPED, DIRECTION, SECOND, PARABOLIC, BESSEL,
                                 CIRCLE */
    double tension;         /**< of every span, 0 or more: sigma times the mean step of the
                                 parameters, so that no unit matters. 0: none; 2: a little;
                                 10: much */
    const double *tensions; /**< [spans] the same span by span, instead; or NULL */
    batten_tension_rule rule;
    double slack; /**< above 0, for the rules: 0.01. See below */
} batten_chain_tension_options;

/** Chord parameters, natural ends, tension 0, nothing automatic. */
BATTEN_API batten_chain_tension_options batten_chain_tension_defaults(void);
/**
 * The spline in tension through points, as a chain of spans of kind TENSION.
 *
 * The rule CONVEX looks at the turns of the polygon. At a point where it turns the curve turns
 * the same way, with no inflection between two points that turn alike; in space the turns are
 * seen along the normals of the polygon's corners. A function (dimension 1) is taken as its
 * graph: convex where the data are. At a point in line with its neighbours no smooth curve can
 * keep still, if the polygon turns beside it; there the tangent leaves the line by at most
 * `slack` times the turns beside it. MONOTONE looks at each coordinate: between two points it
 * changes no direction, except near a point where the data do; over a level span the slope is
 * at most `slack` of that beside it. The tension of the spans that fail is raised by halves,
 * beginning with 1 by the length of the span, so long as it is too little somewhere.
 *
 * Two points give a line, or with given derivatives a span between them.
 *
 * @param points  dimension: 1..3
 *     [count][dimension], at least two; closed: at least three, each once
 * @param options  NULL for the defaults
 * @param[out] parameters  [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (tension, ends), NOT_FINITE, TOO_FEW_POINTS, COINCIDENT,
 * NOT_INCREASING, OVERFLOW, TOLERANCE_NOT_MET (a rule that 100 rounds do not satisfy, naming
 * the point; a slope that jumps)
 *
 * Cost: linear in count, for each round of a rule; rounds are mostly fewer than 20.
 * Source: [Schweikert66], [Cline74]; [KK97] for turns in space.
 */
BATTEN_API batten_status batten_chain_tension(batten_points points,
                                              const batten_chain_tension_options *options,
                                              double *parameters, batten_chain **out);

#ifdef __cplusplus
}
#endif
#endif
