#ifndef BATTEN_CUBIC_H
#define BATTEN_CUBIC_H
/**
 * @file
 * What is true of a parametric cubic: inflections, cusp, loop, or none of them.
 *
 * With the edges d1, d2, d3 of the control polygon, let A = d1 x d2, B = d1 x d3, C = d2 x d3.
 * Then P' x P'' = 18 (A (1-t)^2 + B t (1-t) + C t^2), and all that is said here follows from
 * the ratios A : B : C, which no affine map of the plane changes. D = B^2 - 4 A C.
 */
#include <batten/curve.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The one table of classes: name, text. */
#define BATTEN_CUBIC_CLASS_TABLE(ROW)                                    \
    ROW(PLAIN, "plain", "no inflection, cusp or loop")                   \
    ROW(ONE_INFLECTION, "one inflection", "one inflection")              \
    ROW(TWO_INFLECTIONS, "two inflections", "two inflections")           \
    ROW(CUSP, "cusp", "a cusp")                                          \
    ROW(LOOP, "loop", "a loop")                                          \
    ROW(EXPLICIT, "explicit", "the graph of a cubic function, inclined") \
    ROW(PARABOLA, "parabola", "a parabola")                              \
    ROW(LINE, "line", "a straight line")                                 \
    ROW(RETRACED_LINE, "retraced line", "a line that is run back on")    \
    ROW(POINT, "point", "a single point")                                \
    ROW(SPACE, "space", "a space cubic, which lies in no plane")

#define BATTEN_CUBIC_CLASS_ENUM(name, word, text) BATTEN_CUBIC_##name,
/** Of a whole cubic all but PLAIN and ONE_INFLECTION can be; of a segment all but EXPLICIT and
 * PARABOLA. */
typedef enum batten_cubic_class {
    BATTEN_CUBIC_CLASS_TABLE(BATTEN_CUBIC_CLASS_ENUM) BATTEN_CUBIC_CLASS_COUNT
} batten_cubic_class;
#undef BATTEN_CUBIC_CLASS_ENUM

/** A word or two: "two inflections". */
BATTEN_API const char *batten_cubic_class_name(batten_cubic_class kind);
/** A few words for a sentence: "the graph of a cubic function, inclined". */
BATTEN_API const char *batten_cubic_class_text(batten_cubic_class kind);

/**
 * What was found out about one cubic. Parameters are those of the segment, 0 to 1, or of the
 * curve when it came from one; numbers that have no meaning for its class are NaN.
 */
typedef struct batten_cubic {
    batten_cubic_class whole;   /**< of the whole cubic, t from -infinity to infinity */
    batten_cubic_class segment; /**< of its open segment 0 < t < 1 */
    double from, to;            /**< the segment: 0 and 1, or the span of the curve */
    double margin;       /**< of the segment: by how much a part of the terms that decide must
                              change before the class does; 0 on a boundary, at most 1 */
    double whole_margin; /**< the same of the whole cubic */
    double flatness;     /**< max(|A|, |B|, |C|) / (longest edge)^2: 0 of a line */
    double a, b, c;      /**< A, B, C */
    double p, q, r;      /**< P' x P'' = (p t^2 - 2 q t + 2 r) / 2, with t from 0 to 1 */
    double invariant; /**< I = (q / p)^2 - 2 r / p: above 0 two inflections, 0 a cusp, below 0
                           a loop; NaN when p = 0 */
    int inflection_count; /**< of the whole cubic, 0..2, cusps not counted */
    double inflections[2];
    double cusp;              /**< its parameter */
    double crossing[2];       /**< both parameters of the double point of a loop, rising */
    batten_vec3 double_point; /**< where a loop crosses itself */
    bool has_tangents;        /**< do the end tangents meet, so that lambda and mu exist? */
    double lambda, mu; /**< P1 = P0 + lambda (T - P0), P2 = P3 + mu (T - P3), T where they meet
                        */
} batten_cubic;

/**
 * Classify a cubic by its Bezier points.
 *
 * Signs are decided exactly: with tolerance 0 the answer is the true one of the cubic that has
 * these numbers, boundaries included, as long as coordinates that are not 0 are at least 2^-200
 * times the largest.
 *
 * @param dimension 2 or 3; a cubic in space that lies in a plane is classified there
 * @param points    [4][dimension]
 * @param tolerance relative, 0 or more and below 1; what decides counts as 0 when it is within
 *                  this part of its terms, and the cubic as a line when its flatness is.
 *                  1e-12 suits numbers that were computed
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE or OVERFLOW (edges of about 1e150)
 * Cost: about 0.3 microseconds; up to some 20 on a boundary.
 * Source: [SL] III.2, [Wang81], [SD89]; signs as [Shewchuk97].
 */
BATTEN_API batten_status batten_cubic_classify(int dimension, const double *points,
                                               double tolerance, batten_cubic *out);
/** Many at once, points [count][4][dimension]; a message names the index.
 * @param[out] out [count]; of no use after a failure */
BATTEN_API batten_status batten_cubics_classify(size_t count, int dimension,
                                                const double *points, double tolerance,
                                                const batten_job *job, batten_cubic *out);
/**
 * Classify the spans of a polynomial curve of degree at most 3, dimension 2 or 3.
 *
 * The spans are the Bezier pieces, so their points are rounded: exact cusps of a spline need a
 * tolerance.
 *
 * @param[out] count how many spans
 * @param[out] out   [count], release with batten_release; parameters in those of the curve, but
 *                   a to r and the invariant with each span from 0 to 1
 * @return also UNSUPPORTED for rational curves and higher degrees
 */
BATTEN_API batten_status batten_curve_classify(const batten_curve *curve, double tolerance,
                                               int *count, batten_cubic **out);

/* ---- the plane of lambda and mu: P0, P3 and both tangent lines stay, the lengths change ----
 */

/** The regions into which the plane falls, for the open segment. */
typedef enum batten_cubic_region {
    BATTEN_REGION_REGULAR,        /**< 0 < lambda <= 1, 0 < mu <= 1: R, convex */
    BATTEN_REGION_ONE_INFLECTION, /**< both above 0, exactly one above 1 */
    BATTEN_REGION_EXCESS,         /**< both above 1, below the hyperbola: two inflections */
    BATTEN_REGION_CUSP,           /**< on the hyperbola, both above 1 */
    BATTEN_REGION_LOOP,           /**< both above 1, beyond the hyperbola */
    BATTEN_REGION_S_SHAPED,       /**< one above 0 and at most 1, the other below 0: one
                                       inflection */
    BATTEN_REGION_S_EXCESS,       /**< one above 1, the other below 0: two inflections */
    BATTEN_REGION_S_CUSP,
    BATTEN_REGION_S_LOOP,
    BATTEN_REGION_TURNING,    /**< one above 1, the other far below 0: plain, but turning
                                   by more than half a circle */
    BATTEN_REGION_FAR,        /**< both below 0: plain, bulging to the far side of T */
    BATTEN_REGION_DEGENERATE, /**< lambda or mu 0: an end without a tangent */
    BATTEN_REGION_COUNT
} batten_cubic_region;
BATTEN_API const char *batten_cubic_region_name(batten_cubic_region region);

/** What the plane says about one of its points. */
typedef struct batten_cubic_place {
    batten_cubic_region region;
    batten_cubic_class segment;
    double h;     /**< 3 lambda mu - 4 lambda - 4 mu + 4: the hyperbola is 0 */
    double d;     /**< -lambda mu h: the discriminant D, over (edge x edge)^2 */
    double first; /**< lambda (lambda - 3 mu (1 - mu)): 0 where a loop returns to P0 */
    double last;  /**< mu (mu - 3 lambda (1 - lambda)): 0 where it returns to P3 */
} batten_cubic_place;

/** Look (lambda, mu) up; any finite numbers, else NOT_FINITE. Source: [SL] III.3, [Liu81]. */
BATTEN_API batten_status batten_cubic_look_up(double lambda, double mu,
                                              batten_cubic_place *out);
/** The cubic of (lambda, mu) with P0 = (0, 0), T = (0, 1), P3 = (1, 1): Bezier points [4][2].
 */
BATTEN_API void batten_cubic_of_lengths(double lambda, double mu, double *points);
/**
 * The form of Stone and DeRose: the affine map that takes P0, P1, P2 to (0, 0), (0, 1), (1, 1)
 * takes P3 to (x, y), which alone decides.
 * @return SINGULAR_HERE when the first three points lie on a line, else as
 * batten_cubic_classify
 */
BATTEN_API batten_status batten_cubic_canonical(const double *points, double *x, double *y);
/** The class of the open segment by that form. Source: [SD89]. */
BATTEN_API batten_cubic_class batten_cubic_canonical_class(double x, double y);

#ifdef __cplusplus
}
#endif
#endif
