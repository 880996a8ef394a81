#ifndef BATTEN_LOCAL_H
#define BATTEN_LOCAL_H
/**
 * @file
 * Curves through points found locally: tangents, slopes and curvatures at the points, and the
 * pieces
 * between them.
 */
#include <batten/interpolate.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- tangents of curves ---- */

/** From which neighbours a tangent comes. */
typedef enum batten_tangent_rule {
    BATTEN_TANGENT_CIRCLE,   /**< of the circle through the point and its two neighbours; at an
                                  end of the circle of the first three points */
    BATTEN_TANGENT_BESSEL,   /**< of the parabola through the three, with chord parameters */
    BATTEN_TANGENT_AKIMA,    /**< Akima's slopes of each coordinate over chord parameters: what
                                  is straight in a coordinate stays so; depends on the axes */
    BATTEN_TANGENT_RENNER,   /**< Akima's weights with areas instead of slopes, so that axes do
                                  not matter; three points in line give that line */
    BATTEN_TANGENT_PARABOLA, /**< of the parabola nearest to five points, chord parameters */
    BATTEN_TANGENT_BISECTOR, /**< halves the angle between the two chords */
    BATTEN_TANGENT_GIVEN     /**< `given` in the options */
} batten_tangent_rule;

/** How long tangents are, and with them the steps of the parameters. */
typedef enum batten_tangent_length {
    BATTEN_LENGTH_CHORD,  /**< steps = chords, tangents of length 1 */
    BATTEN_LENGTH_MIDDLE, /**< tangents of length 1, and steps such that each span has speed 1
                               in its middle too: so its length is its step by Simpson's rule */
    BATTEN_LENGTH_RULE    /**< steps = chords, and the derivative that the rule gives (BESSEL,
                               AKIMA, PARABOLA, GIVEN; else as CHORD) */
} batten_tangent_length;

/** What becomes of a point between two straight runs (RENNER). */
typedef enum batten_corner {
    BATTEN_CORNER_ROUND, /**< the tangent is the mean of both chords */
    BATTEN_CORNER_KEEP   /**< each run keeps its own tangent */
} batten_corner;

typedef struct batten_tangents_options {
    size_t size;
    batten_tangent_rule rule;     /**< BATTEN_TANGENT_CIRCLE */
    batten_tangent_length length; /**< BATTEN_LENGTH_CHORD */
    batten_corner corners;        /**< BATTEN_CORNER_ROUND */
    bool closed;                  /**< the first point is not repeated */
    const double *given;          /**< [count][dimension], with BATTEN_TANGENT_GIVEN */
} batten_tangents_options;
/** The defaults of tangents at points: those beside the fields of batten_tangents_options. */
BATTEN_API batten_tangents_options batten_tangents_defaults(void);

typedef struct batten_tangents_report {
    int turned_back;       /**< points where the polygon turns back on itself: no direction is
                                defined there, and one at right angles to it was taken */
    int first_turned_back; /**< the first of these, or -1 */
    int corners;           /**< points that keep two tangents */
} batten_tangents_report;

/**
 * Parameters and tangents for points of the plane or of space.
 *
 * @param points  [count][dimension], dimension 2 or 3, neighbours apart; 2 points, closed 3
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; from 0
 * @param[out] leaving  [count][dimension] derivatives by the parameter, after each point
 * @param[out] arriving [count][dimension] those before it, the same bits except at a kept
 * corner; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT or OVERFLOW naming
 * the points, OUT_OF_MEMORY
 *
 * Two points give their chord. Cost: linear in count.
 * Source: [McConalogue70] (CIRCLE and MIDDLE), [Akima70], [Akima72] (RENNER with CHORD),
 * [Renner82] (RENNER with MIDDLE), [PT97] 9.3.1, [SL] VI.8.
 */
BATTEN_API batten_status batten_tangents(batten_points points,
                                         const batten_tangents_options *options,
                                         double *parameters, batten_tangents_report *report,
                                         double *leaving, double *arriving);

/**
 * The cubic through points with the given tangents, or slopes: C1; at points whose two tangents
 * differ, C0.
 *
 * @param points  dimension: 1 (then tangents are slopes of a function of the parameter), 2 or 3
 *     [count][dimension], 2 or more; closed: 1 or more, periodic
 * @param parameters  [count], closed [count + 1]; increasing
 * @param leaving  [count][dimension]
 * @param arriving  [count][dimension]; NULL: the same as leaving
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW;
 * TOLERANCE_NOT_MET when the curve misses a point by more than rounding
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_curve_from_tangents(batten_points points,
                                                    const double *parameters,
                                                    const double *leaving,
                                                    const double *arriving, bool closed,
                                                    batten_curve **out);

/**
 * Second derivatives at the points of such a curve, for a quintic through the same: the mean of
 * those of the two cubic spans that meet there, the shorter one counting more; at an end that
 * of its span. Exact where the points and tangents come from a cubic. Together with points and
 * tangents they go to batten_curve_from_hermite.
 *
 * Arguments as for batten_curve_from_tangents.
 * @param points  [count][dimension]
 * @param[out] parameters  [count], or [count + 1] when closed; increasing
 * @param tangents  [count][dimension], derivatives by the parameter
 * @param closed  whether the last point is followed by the first
 * @param[out] second  [count][dimension], model units by the parameter squared
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_ARGUMENT, TOO_LARGE,
 * OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_second_derivatives(batten_points points,
                                                   const double *parameters,
                                                   const double *tangents, bool closed,
                                                   double *second);

/* ---- slopes of functions ---- */

/** From which neighbours a slope comes. d: slopes of the chords. */
typedef enum batten_slope_rule {
    BATTEN_SLOPE_BESSEL, /**< of the parabola through a point and its two neighbours; at an end
                              of the first three. Exact for parabolas */
    BATTEN_SLOPE_AKIMA, /**< d before and after, weighted by how little the slopes change beyond
                             them; two more d's at each end in equal differences. Straight runs
                             of three points stay straight */
    BATTEN_SLOPE_FRITSCH_CARLSON, /**< Bessel's, shortened where the cubic would not be monotone
                                       between two points; 0 at extrema of the data */
    BATTEN_SLOPE_FRITSCH_BUTLAND, /**< weighted harmonic mean of d before and after; 0 at
                                     extrema of the data: monotone, and less round */
    BATTEN_SLOPE_STEFFEN,         /**< Bessel's, no steeper than twice the flatter chord: no
                                       extrema but at points */
    BATTEN_SLOPE_MAKIMA           /**< Akima's, with the mean slope of the two chords beyond
                                       added to each change: level runs of three points stay
                                       level and do not swing beside steps; sloping straight
                                       runs may bend */
} batten_slope_rule;

/**
 * Slopes for a function through (x, y); with batten_curve_from_tangents they make its cubic.
 *
 * The ends of FRITSCH_CARLSON and FRITSCH_BUTLAND have the slope of the parabola through three
 * points, 0 where that has the wrong sign, and no steeper than 3 d where the data turn.
 * FRITSCH_CARLSON shortens both slopes of a span by one factor, and a point takes the smaller
 * one of its two spans: the authors go from left to right, and the result of that depends on
 * the direction.
 *
 * @param x [count] increasing, 2 or more
 * @param rule  how they are found
 * @param[out] slopes [count]
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW
 * Cost: linear in count.
 * Source: [Akima70], [FC80], [FB84], [Steffen90]; [Ionita19] for MAKIMA.
 */
BATTEN_API batten_status batten_slopes(int count, const double *x, const double *y,
                                       batten_slope_rule rule, double *slopes);

/**
 * The quadratic spline function through points with at most one more knot in each span:
 * monotone where the data are, and convex or concave where they are. C1.
 *
 * Slopes are means of those of the chords, weighted with their lengths; 0 at extrema of the
 * data, and that of the line where three points are in line. Where a straight run ends in an
 * extremum of the data, or in another straight run, no smooth function is both convex and
 * monotone: then a span beside it bends twice.
 *
 * @param y  second coordinate
 * @param[out] slopes [count], may be NULL
 * @param[out] out dimension 1, parameter x
 * @return as batten_slopes. Cost: linear in count.
 * Source: [Schumaker83].
 */
BATTEN_API batten_status batten_curve_schumaker(int count, const double *x, const double *y,
                                                double *slopes, batten_curve **out);

/**
 * The rational quadratic function of Gregory and Delbourgo through points: monotone where the
 * data are, for any slopes of the same sign as the chords, and smoother than a monotone cubic.
 *
 * @param y  second coordinate
 * @param slopes [count]; NULL: those of BATTEN_SLOPE_FRITSCH_BUTLAND
 * @param[out] out its exact graph, dimension 2, a rational cubic whose parameter is x
 * @return as batten_slopes; BAD_ARGUMENT naming the span whose slopes have not the sign of its
 * chord. Cost: linear in count.
 * Source: [GD82].
 */
BATTEN_API batten_status batten_curve_rational_monotone(int count, const double *x,
                                                        const double *y, const double *slopes,
                                                        batten_curve **out);

/* ---- tangents and curvatures both given ---- */

typedef struct batten_curve_from_curvatures_report {
    int several;           /**< spans with two or three solutions */
    int fallen_back;       /**< spans without a solution, which keep the tangents only */
    int first_fallen_back; /**< the first of these, or -1 */
    double error;          /**< largest curvature error at the ends of the other spans, times
                                their chord */
} batten_curve_from_curvatures_report;

/** Points of the plane with directions and curvatures; borrowed for the call. */
typedef struct batten_curved_points {
    batten_points points;
    const double *tangents;   /**< [count][2] */
    const double *curvatures; /**< [count] */
    bool closed;
} batten_curved_points;

/**
 * The plane cubic spline with given directions and curvatures at its points: curvature is
 * continuous, and a smooth curve is met with order 6.
 *
 * A span has up to three solutions; the one whose legs (a third of the end derivatives) are
 * nearest to a third of the chord is taken, which is the one that converges to the curve. A
 * span without solution, as where the curvatures ask for a turn that the tangents deny, gets
 * the legs of BATTEN_LENGTH_MIDDLE.
 *
 * @param data  points: [count][2], 2 or more, closed 3; neighbours apart
 *     tangents: [count][2] directions, of any length above 0
 *     curvatures: [count] signed, 1 / length; positive: a left turn
 * @param[out] parameters  [count], closed [count + 1]: sums of chords; may be NULL
 * @param[out] solutions  [count - 1], closed [count]: how many each span has, 0..3; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, BAD_ARGUMENT (a tangent of no
 * length, named), OVERFLOW
 *
 * The curve has triple knots: direction and curvature are continuous, the speed is not.
 * Cost: linear in count.
 * Source: [dBHS87].
 */
BATTEN_API batten_status batten_curve_from_curvatures(
    const batten_curved_points *data, double *parameters, int *solutions,
    batten_curve_from_curvatures_report *report, batten_curve **out);

/**
 * Signed curvatures of the circles through each point and its neighbours; at an end that of
 * the first three points. Two points: 0.
 * @param points [count][2]
 * @param closed  whether the last point is followed by the first
 * @param[out] curvatures  [count], per model unit, positive where the circle turns left
 * @return BATTEN_OK, UNSUPPORTED (not in the plane), TOO_FEW_POINTS, NOT_FINITE, TOO_LARGE,
 * COINCIDENT, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_circle_curvatures(batten_points points, bool closed,
                                                  double *curvatures);
/** What stands beyond the ends of an open row of points, where a local method asks for more
 * points than there are. Their parameters continue in the mirror image of the steps. */
typedef enum batten_phantoms {
    BATTEN_PHANTOM_EXTRAPOLATE, /**< the polynomial through the end points continues: of the
                                     degree that the method reproduces, as points allow */
    BATTEN_PHANTOM_REFLECT,     /**< the points beyond are those inside, mirrored in the end
                                     point: the curve ends without bending where it is C2 */
    BATTEN_PHANTOM_REPEAT       /**< the end point is repeated: the curve starts slowly */
} batten_phantoms;

typedef struct batten_curve_catmull_rom_options {
    size_t size;
    int blend;    /**< degree of the B-splines that blend, k - 1: 1 or more; 2 */
    int local;    /**< degree of the polynomials that are blended, m: 0 or more; 1 */
    double alpha; /**< steps are chords to this power: 0 uniform, 1/2 centripetal, 1 chords; 0
                       to 1; 0.5 */
    const double *given;      /**< parameters [count], closed [count + 1], instead of alpha */
    bool closed;              /**< the first point is not repeated */
    batten_phantoms phantoms; /**< BATTEN_PHANTOM_EXTRAPOLATE */
} batten_curve_catmull_rom_options;
/** The defaults of Catmull-Rom splines: those beside the fields of
 * batten_curve_catmull_rom_options. */
BATTEN_API batten_curve_catmull_rom_options batten_curve_catmull_rom_defaults(void);

typedef struct batten_curve_catmull_rom_report {
    int continuity; /**< derivatives that are continuous for all points: k - 2; from m = k on
                         k - 1 */
    bool through;   /**< does it pass the points: m >= k - 2 */
    double error;   /**< largest distance of a point from the curve at its parameter */
} batten_curve_catmull_rom_report;

/**
 * The curve F(t) = sum L_j(t) N_j(t): N_j are the B-splines of order k with knots at the
 * parameters of the points, L_j is the polynomial of degree m through the m + 1 points in the
 * middle of the knots of N_j. Degree m + k - 1; it reproduces polynomials of degree max(m, k -
 * 1) of the parameter.
 *
 * With k = 3, m = 1 this is the spline of Catmull and Rom, whose cubics have no cusps and do
 * not cross themselves for alpha = 1/2. Of (k, m) and (k + 1, m - 1) with m = k both give the
 * same curve. Where m - k is odd the middle falls between points: L_j then takes one more point
 * after it than before, and reversed points give another curve.
 *
 * @param points  [count][dimension], dimension 1 to 3, 2 points, closed 3; neighbours apart
 * unless alpha is 0
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out a B-spline curve with just so many knots at each parameter as its continuity
 * asks for
 * @return BATTEN_OK, BAD_ARGUMENT, BAD_DEGREE, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT or
 * OVERFLOW naming the points, NOT_INCREASING, TOO_LARGE; TOLERANCE_NOT_MET when the curve
 * misses a point by more than rounding
 *
 * A point that moves changes at most m + k spans. Cost: (m + k)^3 for a span.
 * Source: [CR74], [BG88]; [YSK11] for alpha.
 */
BATTEN_API batten_status batten_curve_catmull_rom(
    batten_points points, const batten_curve_catmull_rom_options *options, double *parameters,
    batten_curve_catmull_rom_report *report, batten_curve **out);

typedef struct batten_tangents_kochanek_bartels_options {
    size_t size;
    const double *tension; /**< [count], NULL for 0: 1 halts at a point, below 0 is rounder */
    const double *continuity; /**< [count], NULL for 0: -1 turns at a point as the chords do, 1
                                   turns there the other way; not 0: a corner */
    const double *bias;       /**< [count], NULL for 0: 1 leaves along the chord before the
                                   point, -1 along the one after */
    double alpha;             /**< as for batten_curve_catmull_rom_options; 0 */
    const double *given;
    bool closed;
    batten_phantoms phantoms;
} batten_tangents_kochanek_bartels_options;
/** The defaults of Kochanek and Bartels: those beside the fields of
 * batten_tangents_kochanek_bartels_options. */
BATTEN_API batten_tangents_kochanek_bartels_options
batten_tangents_kochanek_bartels_defaults(void);

/**
 * Tangents of Kochanek and Bartels; with batten_curve_from_tangents they make the curve. With
 * tension alone it is the cardinal spline, with zeros the cubic of Catmull and Rom.
 *
 * For uneven steps the two chords at a point weigh as in Bessel's parabola, so that zeros give
 * the curve of Catmull and Rom for every alpha; the authors weigh them the other way round
 * there.
 *
 * @param points [count][dimension], dimension 1 to 3, 2 points, closed 3
 * @param options NULL for the defaults
 * @param[out] parameters [count], closed [count + 1]
 * @param[out] leaving, arriving [count][dimension]: derivatives after each point and before it,
 * the same bits where continuity is 0
 * @return as batten_curve_catmull_rom. Cost: linear in count.
 * Source: [KB84].
 */
BATTEN_API batten_status batten_tangents_kochanek_bartels(
    batten_points points, const batten_tangents_kochanek_bartels_options *options,
    double *parameters, double *leaving, double *arriving);
/* ---- no inflections in excess ---- */

/**
 * How long the derivatives at both ends of a plane cubic span may be.
 *
 * A span turns left by `alpha` from its start tangent to its chord and by `beta` from there to
 * its end tangent (radians; both to the right: both negative). When both have one sign and less
 * than a half circle together, it has no inflection, cusp or loop if and only if |P'(0)| and
 * |P'(1)|, for a parameter from 0 to 1, are at most these limits.
 *
 * @param chord  its length, model units, above 0
 * @param alpha, beta  radians
 * @param[out] start, end  model units
 * @return BATTEN_OK; NOT_COMPATIBLE when the angles have opposite signs (one inflection is then
 * right) or turn by a half circle or more; NOT_FINITE, BAD_ARGUMENT
 *
 * Cost: constant; no allocation.
 * Source: [SL] III.5.
 */
BATTEN_API batten_status batten_tangent_limits(double chord, double alpha, double beta,
                                               double *start, double *end);

/** What a correction leaves at the joins of the spans that it changes. */
typedef enum batten_correct_joins {
    BATTEN_CORRECT_TANGENT,  /**< directions stay: G1 */
    BATTEN_CORRECT_CURVATURE /**< and lengths nearby are chosen anew, so that curvatures agree
                                  at as many joins as possible: G2; in the plane. Where the
                                  directions bend both sides oppositely there is none */
} batten_correct_joins;

typedef struct batten_curve_correct_tangents_options {
    size_t size;
    double within;    /**< lambda and mu come down to this; above 0 and below 1; 0.95 */
    double tolerance; /**< relative: nearer to 1 than this they are left as they are; 1e-9 */
    batten_correct_joins joins; /**< BATTEN_CORRECT_TANGENT */
} batten_curve_correct_tangents_options;
/** The defaults of corrected tangents: those beside the fields of
 * batten_curve_correct_tangents_options. */
BATTEN_API batten_curve_correct_tangents_options batten_curve_correct_tangents_defaults(void);

typedef struct batten_curve_correct_tangents_report {
    int span_count;
    int corrected; /**< spans that had inflections in excess, a cusp or a loop, and have none */
    int incurable; /**< spans that keep them: they turn by a half circle or more, run back along
                        a line, or their tangents do not meet in front of them */
    int first_incurable; /**< index of the first of these, or -1 */
    int rejoined;        /**< joins whose curvatures were brought together again */
    int broken;          /**< joins whose curvatures differ now by more than 1e-6 of the larger,
                              and did not before */
} batten_curve_correct_tangents_report;

/**
 * Shorten the end tangents of those spans of a cubic curve that have inflections in excess, a
 * cusp or a loop. Points at the knots and directions there stay; so do the knots.
 *
 * A span with lambda, mu (see cubic.h) above 0 gets both at most `within` when one is above 1;
 * with one above 0 and the other below, where one inflection is right, the positive one. Spans
 * that lie in no plane are left alone.
 *
 * @param curve   polynomial, of degree 3 at most and dimension 2 or 3
 * @param options NULL for the defaults
 * @param[out] changed [spans], 1 where a span was changed; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out     with every knot three times: speeds differ at joins that were corrected.
 *                     A curve without such spans comes back as it is
 * @return BATTEN_OK, UNSUPPORTED (rational, higher degree, curvatures in space), BAD_ARGUMENT,
 * OVERFLOW, TOO_LARGE, OUT_OF_MEMORY
 * Cost: linear; with CURVATURE about 200 quartic equations for each span near a corrected one,
 * and the best choice for all joins together.
 * Source: [SL] III.6; [dBHS87] for curvatures.
 */
BATTEN_API batten_status batten_curve_correct_tangents(
    const batten_curve *curve, const batten_curve_correct_tangents_options *options,
    int *changed, batten_curve_correct_tangents_report *report, batten_curve **out);

/* ---- corners and straight runs ---- */

/** How a curve passes into a straight run. */
typedef enum batten_transition {
    BATTEN_TRANSITION_TANGENT,  /**< with its direction */
    BATTEN_TRANSITION_CURVATURE /**< and with curvature 0 */
} batten_transition;

typedef struct batten_curve_cornered_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD; not GIVEN */
    int corner_count;
    const int *corners; /**< rising indices of points where the direction may jump */
    int line_count;
    const int
        *lines; /**< rising indices of points from which the curve is straight to the next */
    batten_transition transition; /**< BATTEN_TRANSITION_TANGENT */
    batten_end_kind ends;         /**< at corners and ends that are free: NOT_A_KNOT, NATURAL,
                                     PARABOLIC,         BESSEL, CIRCLE or FAIR; NATURAL */
} batten_curve_cornered_options;
/** The defaults of curves with corners: those beside the fields of
 * batten_curve_cornered_options. */
BATTEN_API batten_curve_cornered_options batten_curve_cornered_defaults(void);

/**
 * A cubic spline through points with corners and straight runs: C2 on each smooth run, whose
 * parts are made one by one.
 *
 * Where two straight runs meet there is a corner. A smooth run between two straight ones begins
 * and ends with their directions. With curvature 0 there it has averaged knots instead of knots
 * at its points, one more for each condition that is added; of `ends` only NATURAL then has a
 * meaning for that run, the others leave its free end as it comes.
 *
 * @param points [count][dimension], dimension 2 or 3, count >= 2
 * @param options  NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (indices outside, not rising), BAD_DEGREE, NOT_FINITE, TOO_FEW_POINTS, TOO_LARGE,
 * COINCIDENT, NOT_INCREASING, SINGULAR_SYSTEM, TOLERANCE_NOT_MET, OVERFLOW, OUT_OF_MEMORY
 * Cost: linear. Source: [SL] III.7.
 */
BATTEN_API batten_status batten_curve_cornered(batten_points points,
                                               const batten_curve_cornered_options *options,
                                               double *parameters, batten_curve **out);

/* ---- given directions ---- */

/** The direction of a curve at one of its data points. */
typedef struct batten_direction_at {
    int index;
    double vector[3]; /**< any length but 0 */
} batten_direction_at;

typedef struct batten_curve_directed_options {
    size_t size;
    batten_parametrization parameters; /**< BATTEN_CHORD */
    const double *given; /**< [count] with BATTEN_GIVEN: a free choice of spacing */
    int direction_count;
    const batten_direction_at *directions; /**< rising indices; their lengths are found */
    const double *tension; /**< nu [count], 0 or more: P'' jumps by nu P' at a point, which
                                stays G2; large: a sharp bend there. NULL for none */
} batten_curve_directed_options;
/** The defaults of directed splines: those beside the fields of batten_curve_directed_options. */
BATTEN_API batten_curve_directed_options batten_curve_directed_defaults(void);

typedef struct batten_curve_directed_report {
    int clamped;       /**< directions whose best length was not positive: the curve would run
                            through them backwards. They got a tenth of the mean speed there */
    int first_clamped; /**< index of the first such point, or -1 */
    double energy;     /**< sum of the integrals of |P''|^2 and of nu |P'|^2 at the points */
} batten_curve_directed_report;

/**
 * The cubic spline through points with given directions at some of them, that has the least
 * energy: the integral of |P''|^2, and nu |P'|^2 at points with tension.
 *
 * C1 everywhere. At points without direction it is also C2, or with tension G2; at those with
 * a direction only across it. Ends without direction are natural. Whatever positive spacing is
 * given, a curve that is C2 in it is G2: so spacing and tension are all the freedom that G2
 * cubics have.
 *
 * @param points [count][dimension], dimension 1 to 3, count >= 2
 * @param options  NULL for the defaults
 * @param[out] parameters [count]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT (indices, tension, a direction of length 0), COINCIDENT,
 * NOT_INCREASING, TOO_FEW_POINTS, TOO_LARGE, NOT_FINITE, SINGULAR_SYSTEM, OVERFLOW, OUT_OF_MEMORY
 * Cost: linear; once more for each round of clamping.
 * Source: [SL] III.7, [Nielson74].
 */
BATTEN_API batten_status batten_curve_directed(batten_points points,
                                               const batten_curve_directed_options *options,
                                               double *parameters,
                                               batten_curve_directed_report *report,
                                               batten_curve **out);

#ifdef __cplusplus
}
#endif
#endif
