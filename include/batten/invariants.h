#ifndef BATTEN_INVARIANTS_H
#define BATTEN_INVARIANTS_H
/**
 * @file
 * What no affine map changes about a polynomial curve of any degree: its singular points, its
 * canonical form and invariants, whether another curve is an affine image of it, its affine
 * arc length.
 *
 * A span is given by its Bezier points and stands for the polynomial X(t) with t from 0 to 1;
 * "the whole" is the same polynomial for all real t. Cubics have more of their own in cubic.h.
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

/**
 * A word or two: "two inflections".
 *
 * @param kind  which of them
 */
BATTEN_API const char *batten_cubic_class_name(batten_cubic_class kind);
/**
 * A few words for a sentence: "the graph of a cubic function, inclined".
 *
 * @param kind  which of them
 */
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

/** Some of them, yours to release with batten_cubics_release. */
typedef struct batten_cubics {
    int count;
    batten_cubic *at;
} batten_cubics;
/**
 * Release them, and empty the row.
 *
 * @param cubics  the row
 */
BATTEN_API void batten_cubics_release(batten_cubics *cubics);

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
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE or OVERFLOW (edges of about 1e150)
 * Cost: about 0.3 microseconds; up to some 20 on a boundary.
 * Source: [SL] III.2, [Wang81], [SD89]; signs as [Shewchuk97].
 */
BATTEN_API batten_status batten_cubic_classify(int dimension, const double *points,
                                               double tolerance, batten_cubic *out);
/**
 * Many at once, points [count][4][dimension]; a message names the index.
 * @param count  how many
 * @param dimension  2 or 3
 * @param points  [count][4][dimension], Bezier points
 * @param tolerance  as batten_cubic_classify
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out [count]; of no use after a failure
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE with the index, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: count times that of batten_cubic_classify; chunks of 4096 are shared among threads.
 */
BATTEN_API batten_status batten_cubics_classify(size_t count, int dimension,
                                                const double *points, double tolerance,
                                                const batten_job *job, batten_cubic *out);
/**
 * Classify the spans of a polynomial curve of degree at most 3, dimension 2 or 3.
 *
 * The spans are the Bezier pieces, so their points are rounded: exact cusps of a spline need a
 * tolerance.
 *
 * @param curve  polynomial, of degree 3 at most, dimension 2 or 3
 * @param tolerance  as batten_cubic_classify
 * @param[out] out   release with batten_cubics_release; parameters in those of the curve, but
 *                   a to r and the invariant with each span from 0 to 1
 * @return as batten_cubic_classify; UNSUPPORTED for rational curves and higher degrees;
 * OUT_OF_MEMORY
 *
 * Cost: linear in the spans.
 */
BATTEN_API batten_status batten_curve_classify(const batten_curve *curve, double tolerance,
                                               batten_cubics *out);

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
/** The name of a region of the plane of cubics, in English. */
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

/**
 * Look (lambda, mu) up; any finite numbers, else NOT_FINITE.
 *
 * @param lambda, mu  any finite numbers
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE
 *
 * Cost: constant; no allocation.
 * Source: [SL] III.3, [Liu81].
 */
BATTEN_API batten_status batten_cubic_look_up(double lambda, double mu,
                                              batten_cubic_place *out);
/** The cubic of (lambda, mu) with P0 = (0, 0), T = (0, 1), P3 = (1, 1): Bezier points [4][2].
 */
BATTEN_API void batten_cubic_from_lengths(double lambda, double mu, double *points);
/**
 * The form of Stone and DeRose: the affine map that takes P0, P1, P2 to (0, 0), (0, 1), (1, 1)
 * takes P3 to (x, y), which alone decides.
 * @param points  [4][2], Bezier points
 * @param[out] x, y  of the image of P3
 * @return BATTEN_OK; SINGULAR_HERE when the first three points lie on a line, else as
 * batten_cubic_classify
 *
 * Cost: that of batten_cubic_classify.
 */
BATTEN_API batten_status batten_cubic_canonical(const double *points, double *x, double *y);
/**
 * The class of the open segment by that form.
 *
 * @param x  first coordinate
 * @param y  second coordinate
 * Source: [SD89].
 */
BATTEN_API batten_cubic_class batten_cubic_canonical_class(double x, double y);
/* ---- the census: inflections, cusps, double points, each of them and how many ---- */

/* The one table of special points: name, word, plural. */
#define BATTEN_SPECIAL_TABLE(ROW)                \
    ROW(INFLECTION, "inflection", "inflections") \
    ROW(UNDULATION, "undulation", "undulations") \
    ROW(CUSP, "cusp", "cusps")                   \
    ROW(PAUSE, "pause", "pauses")                \
    ROW(CROSSING, "crossing", "crossings")       \
    ROW(ISOLATED, "isolated point", "isolated points")

#define BATTEN_SPECIAL_ENUM(name, word, plural) BATTEN_SPECIAL_##name,
/**
 * INFLECTION: x'y'' - x''y' changes its sign. UNDULATION: it is 0 and does not. CUSP: the
 * curve stops and turns back, x' and y' vanish to an odd order. PAUSE: it stops and continues.
 * CROSSING: it passes twice through a point (a crunode, or a tacnode). ISOLATED: a real point
 * with two conjugate complex parameters, off the curve that is drawn (an acnode).
 */
typedef enum batten_special_kind {
    BATTEN_SPECIAL_TABLE(BATTEN_SPECIAL_ENUM) BATTEN_SPECIAL_COUNT
} batten_special_kind;
#undef BATTEN_SPECIAL_ENUM

/**
 * "isolated point", or in the plural "isolated points".
 *
 * @param kind  which of them
 */
BATTEN_API const char *batten_special_name(batten_special_kind kind, bool plural);

typedef struct batten_special {
    batten_special_kind kind;
    bool inside;      /**< in the open span; of a crossing with both parameters */
    int multiplicity; /**< 1: simple; of a crossing 2 where the branches touch, and so on */
    double t;         /**< parameter; of a crossing the lower, of an isolated point the real
                         part */
    double s; /**< of a crossing the upper parameter, of an isolated point the imaginary part
                 above 0; else NaN */
    batten_vec3 point;
} batten_special;

typedef struct batten_census {
    double from, to;    /**< the span: 0 and 1, or that of the curve; so are t and s */
    int degree;         /**< of the polynomial itself, which may be below that of the form */
    int flat_dimension; /**< 0: a point, 1: a line, 2: in a plane, 3: in space, where only
                             this is found out */
    double flatness;    /**< what is missing to the dimension below, by the size of the span */
    bool is_repeated;   /**< X(t) = Y(g(t)): every point is passed more than once, so double
                             points are not counted */
    bool is_complete;   /**< double points are proved to be all; else only those crossings
                             inside are listed that a search found */
    int whole[BATTEN_SPECIAL_COUNT], segment[BATTEN_SPECIAL_COUNT];
    int complex_count;  /**< double points that are not real, by multiplicity */
    int infinite_count; /**< and those at infinity; with crossings, isolated points, cusps and
                             pauses (higher ones more than once) they make
                             (degree - 1) (degree - 2) / 2 */
    double margin;      /**< of the counts inside the span: the smallest of what x'y'' - x''y'
                             would have to change by, by its size, before it had a root more or
                             less, and of how far, in parts of the span, crossings are from
                             its ends. A pair of crossings that nearly comes to be is not seen */
    int count;
    batten_special *specials; /**< [count] by kind, then by t */
} batten_census;

/** Some of them, yours to release with batten_censuses_release. */
typedef struct batten_censuses {
    int count;
    batten_census *at;
} batten_censuses;

/**
 * Count the special points of a polynomial span in the plane, or of one in space that lies in
 * a plane.
 *
 * The coordinates are taken as the exact numbers that they are, and all counts are decided in
 * whole numbers: they are right, boundaries included.
 *
 * @param dimension 2 or 3
 * @param degree    1 .. 25
 * @param points    [degree + 1][dimension] Bezier points
 * @param tolerance relative, 0 or more and below 1: a span within this part of its size counts
 *                  as lying in a plane, a line or a point. 0: only what does exactly
 * @param[out] out  release with batten_census_release
 * @return BATTEN_OK; BAD_ARGUMENT; BAD_DEGREE; NOT_FINITE; INCOMPLETE where the coordinates
 *         differ by more than 2^300 in size, or roots that coincide or nearly do would take too
 *         much work (from degree 15 or so)
 * Cost: about 0.2 ms for a cubic, 1 ms for a sextic, 0.1 s for degree 10. From degree 13 or so
 * the work of eliminating is too large: then is_complete is false, after at most half a second.
 * Source: [SL] VIII; [SWP08] for elimination, [CA76] for roots. The counts are [Walker50]'s.
 */
BATTEN_API batten_status batten_census_take(int dimension, int degree, const double *points,
                                            double tolerance, batten_census *out);
/** Release one census. */
BATTEN_API void batten_census_release(batten_census *census);
/**
 * The same for every span of a polynomial curve. Its Bezier points are rounded when it has
 * more than one span, so what lies on a boundary may come to lie beside it: see the margin.
 * @param curve  polynomial, of dimension 2 or 3
 * @param tolerance  as batten_census_take
 * @param[out] out  one for each span; release with batten_censuses_release
 * @return as batten_census_take, naming the span; UNSUPPORTED for rational curves
 *
 * Cost: batten_census_take for each span.
 */
BATTEN_API batten_status batten_curve_census(const batten_curve *curve, double tolerance,
                                             batten_censuses *out);
/**
 * Release all censuses and their row.
 *
 * @param censuses  the row
 */
BATTEN_API void batten_censuses_release(batten_censuses *censuses);

/* ---- canonical form: what is left when affine maps and changes of parameter are used up ----
 */

/** In space; a plane curve has less. */
enum { BATTEN_MAX_INVARIANTS = 3 * (BATTEN_MAX_DEGREE - 3) };

/**
 * An entry of the canonical form. When t_old = c t_new + f, value_old = c^weight value_new, and
 * no affine map changes it.
 */
typedef struct batten_invariant {
    int row;      /**< 0 .. dimension - 1 */
    int power;    /**< j: the entry is the coefficient of t^j / j! */
    int weight;   /**< pivot of the row - j, above 0 */
    double value; /**< relative invariant */
    double
        scaled; /**< value by radius^weight, -1 .. 1: no change of parameter changes its size */
    double absolute; /**< value^(w0 / g) / base^(weight / g) with g the common divisor of w0 and
                          weight, where there is a base; no change of parameter changes it.
                          Signs of even weights, the base's too, are invariant besides */
} batten_invariant;

typedef struct batten_canonical {
    int dimension;  /**< r: of the least space that the curve lies in, 0..3 */
    int pivots[3];  /**< [r] j_1 < ... < j_r: row k is t^j_k / j_k! and lower powers, without
                         those of the other pivots and without a constant */
    bool has_shift; /**< is the origin of the parameter determined? */
    double shift;   /**< the curve has this form in t - shift */
    double radius;  /**< largest |value|^(1 / weight); 0 when all are 0: then c is free too */
    int base; /**< index of the invariant of the lowest weight w0 that is not 0; -1: none */
    double margin; /**< how far the pivot nearest to dependence is from it, 1 at most */
    double
        neglected; /**< how large a part was taken for 0 to find the pivots, 1 would be all */
    int count;
    batten_invariant at[BATTEN_MAX_INVARIANTS]; /**< [count] by row, then by falling power */
} batten_canonical;

/** Some of them, yours to release with batten_canonicals_release. */
typedef struct batten_canonicals {
    int count;
    batten_canonical *at;
} batten_canonicals;
/**
 * Release them, and empty the row.
 *
 * @param forms  the row
 */
BATTEN_API void batten_canonicals_release(batten_canonicals *forms);

/**
 * The canonical form of a polynomial span under affine maps and t -> c t + f.
 *
 * A plane curve of degree n has 2 n - 5 relative invariants, n >= 3, and 2 n - h - 5 when its
 * pivots are n - h - 1 and n, 0 <= h <= n - 2; the absolute ones are one less. ([SL] prints
 * 2 n - h - 4 for h > 0, which counts the entries before the shift is normalised.) In space
 * there are 3 (n - 3) - 1.
 *
 * @param dimension 1 .. 3
 * @param degree  1..25
 * @param points    [degree + 1][dimension] Bezier points; t from 0 to 1
 * @param tolerance relative, above 0 and below 1: what counts as 0. 1e-10 suits most
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; BAD_DEGREE; NOT_FINITE; INCOMPLETE as batten_census_take
 *
 * Cost: degree^2 multiplications for each coordinate; no allocation.
 * Source: [SL] VIII.3-4, [SuXin80].
 */
BATTEN_API batten_status batten_canonical_form(int dimension, int degree, const double *points,
                                               double tolerance, batten_canonical *out);

/**
 * The forms of every span of a polynomial curve, each with t from 0 to 1 along it.
 * @param curve  polynomial
 * @param tolerance  relative, as batten_canonical_form
 * @param[out] out  one for each span; release with batten_canonicals_release
 * @return as batten_canonical_form; UNSUPPORTED for rational curves; OUT_OF_MEMORY
 *
 * Cost: batten_canonical_form for each span.
 */
BATTEN_API batten_status batten_curve_canonical_forms(const batten_curve *curve,
                                                      double tolerance, batten_canonicals *out);

/* The cases of a quintic of the class below: name, word, text. */
#define BATTEN_QUINTIC_TABLE(ROW)                                               \
    ROW(NODE_AND_ISOLATED, "node and isolated", "a node and an isolated point") \
    ROW(CUSP_AND_ISOLATED, "cusp and isolated", "a cusp and an isolated point") \
    ROW(CUSP_AND_NODE, "cusp and node", "a cusp and a node")                    \
    ROW(HIGHER_CUSP, "higher cusp", "a higher cusp and nothing else")           \
    ROW(TWO_NODES, "two nodes", "two nodes")                                    \
    ROW(TACNODE, "tacnode", "a tacnode, two nodes in one")                      \
    ROW(NO_REAL, "no real point", "no real double point")                       \
    ROW(TWO_ISOLATED, "two isolated", "two isolated points")                    \
    ROW(DOUBLE_ISOLATED, "double isolated", "two isolated points in one")

#define BATTEN_QUINTIC_ENUM(name, word, text) BATTEN_QUINTIC_##name,
typedef enum batten_quintic_case {
    BATTEN_QUINTIC_TABLE(BATTEN_QUINTIC_ENUM) BATTEN_QUINTIC_COUNT
} batten_quintic_case;
#undef BATTEN_QUINTIC_ENUM
/**
 * The name of a case of quintics, in English.
 *
 * @param which  as classified
 */
BATTEN_API const char *batten_quintic_name(batten_quintic_case which);
/**
 * A sentence about a case of quintics, in English.
 *
 * @param which  as classified
 */
BATTEN_API const char *batten_quintic_text(batten_quintic_case which);

/** A quintic that some affine map and shift of t make (t^2, t^5 + a t^4 + b t^3 + g t). */
typedef struct batten_quintic {
    batten_quintic_case which;
    double a, b, g;
    double shift;
    double margin; /**< how far the numbers that decide are from another case, 0 .. 1 */
} batten_quintic;
/**
 * The class of plane quintics with pivots 2 and 5: four of the six double points are at
 * infinity, the other two have t = -s and t^2 a root of u^2 + b u + g, so signs decide.
 * @param canonical  of batten_canonical_form
 * @param tolerance what counts as 0 of the scaled numbers
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, or NOT_COMPATIBLE for other curves
 *
 * Cost: constant; no allocation.
 * Source: [SL] VIII.2.
 */
BATTEN_API batten_status batten_quintic_classify(const batten_canonical *canonical,
                                                 double tolerance, batten_quintic *out);

/* ---- equivalence ---- */

typedef struct batten_affine_match {
    bool found;        /**< is error at most the tolerance? */
    batten_affine map; /**< map(from(c v + f)) = to(v) */
    double c, f;
    bool is_whole; /**< the parameters of one curve do not cover those of the other: they are
                        different parts of one curve */
    double error;  /**< the largest distance of control points, which bounds that of the curves;
                        the least that was found, in model units */
} batten_affine_match;

/**
 * Is one polynomial curve the affine image of another, after t -> c t + f?
 *
 * Curves are compared end to end, in both directions. Curves of a single polynomial are also
 * compared as wholes: the invariants give c and f. Then the map is the one of least squares,
 * and the answer is its error; so "found" is proved by the map, and that there is none rests on
 * the invariants being those of the curves that are given.
 *
 * @param from, to  of dimension 2 or 3, polynomial
 * @param tolerance model units of `to`, 0 or more
 * @param[out] out  the map, c and f, and the error; see the struct
 * @return BATTEN_OK; BAD_ARGUMENT; UNSUPPORTED for rational curves; OUT_OF_MEMORY
 *
 * Cost: linear in the control points after both curves have common knots; a least-squares map
 * of 4 unknowns for each coordinate, at most four times.
 */
BATTEN_API batten_status batten_curve_affine_match(const batten_curve *from,
                                                   const batten_curve *to, double tolerance,
                                                   batten_affine_match *out);

/* ---- affine arc length ---- */

/**
 * Affine arc length: the integral of |x'y'' - x''y'|^(1/3) dt in the plane, of
 * |det(C', C'', C''')|^(1/6) dt in space. Maps that keep areas, or volumes, do not change it; a
 * map of determinant D makes it |D|^(1/3), or |D|^(1/6), times as long. A straight line has
 * none.
 *
 * @param curve  of dimension 2 or 3
 * @param tolerance of the result, in its units (model units^(2/3), or ^(1/2) in space), above 0
 * @param[out] error an estimate; may be NULL
 * @param[out] length  in units of the tolerance
 * @return BATTEN_OK; BAD_ARGUMENT (tolerance, a curve of one dimension); TOLERANCE_NOT_MET
 *
 * Cost: Gauss-Legendre on each span, halved until both halves agree with the whole; spans are
 * divided at flat points first.
 * Source: [Blaschke23].
 */
BATTEN_API batten_status batten_curve_affine_length(const batten_curve *curve, double tolerance,
                                                    double *error, double *length);
/**
 * Parameters that cut a curve into parts of equal affine length, both ends included: affine
 * images of a curve are cut at the images of the same points.
 * @param curve  of dimension 2 or 3
 * @param count parts, 1 or more
 * @param tolerance of the lengths from the start as a part of the whole, above 0 and below 1
 * @param[out] u [count + 1]
 * @return as batten_curve_affine_length; BAD_ARGUMENT (count, tolerance); SINGULAR_HERE for a
 * curve without affine length
 *
 * Cost: twice that of batten_curve_affine_length, and some integrals over a piece for each
 * parameter.
 */
BATTEN_API batten_status batten_curve_divide_affine(const batten_curve *curve, int count,
                                                    double tolerance, double *u);
/**
 * Affine curvature of a plane curve: det(C_ss, C_sss) with respect to affine arc length s. 0 of
 * parabolas, (a b)^(-2/3) of an ellipse with half axes a and b, below 0 of hyperbolas.
 *
 * @param curve  of dimension 2
 * @param u  in batten_curve_domain(curve)
 * @param side  from which side at a knot
 * @param[out] curvature  model units^(-4/3)
 * @return BATTEN_OK; BAD_ARGUMENT (dimension); SINGULAR_HERE where x'y'' - x''y' is 0; as
 *         batten_curve_evaluate
 *
 * Cost: one evaluation to order 4.
 * Source: [Blaschke23].
 */
BATTEN_API batten_status batten_curve_affine_curvature(const batten_curve *curve, double u,
                                                       batten_side side, double *curvature);

#ifdef __cplusplus
}
#endif
#endif
