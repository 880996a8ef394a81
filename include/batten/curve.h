#ifndef BATTEN_CURVE_H
#define BATTEN_CURVE_H
/**
 * @file
 * A NURBS curve of degree 1..25 in 1 to 3 dimensions: immutable, reference counted.
 *
 * With degree p and n control points there are n + p + 1 knots U, and the domain is
 * [U[p], U[n]]. Points are Cartesian and never premultiplied; weights are positive, or NULL.
 *
 * A periodic curve is given by one period: m control points and m + 1 knots. It is kept, and
 * seen through the properties, in the wrapped form: n = m + p points of which the last p repeat
 * the first p, and all n + p + 1 knots. Functions that change a periodic curve return a
 * periodic curve where that has a meaning, else the clamped form; each says which.
 */
#include <batten/geometry.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_curve batten_curve;

/** Some curves, yours to release. */
typedef struct batten_curves {
    int count;
    batten_curve **at;
} batten_curves;
/** Give the references of all curves back and release the row. */
BATTEN_API void batten_curves_release(batten_curves *curves);

/** A row of curves, borrowed for the call. */
typedef struct batten_curve_row {
    int count;
    const batten_curve *const *at;
} batten_curve_row;

/** The degree and the knots of a function, or of one direction of a tensor-product surface. */
typedef struct batten_axis {
    int degree;
    int point_count;
    const double
        *knots; /**< [point_count + degree + 1]; periodic: one period, [point_count + 1] */
    bool periodic;
} batten_axis;

/** The pieces of a piecewise polynomial, or of one direction of a patchwork. */
typedef struct batten_pieces {
    int degree;
    int count;
    const double *breaks; /**< [count + 1], increasing; NULL: 0, 1, 2 ... */
} batten_pieces;

/** A knot and how many times of it. */
typedef struct batten_knot {
    double at; /**< equal to the knot */
    int times;
} batten_knot;

/** Found parameters, increasing; release `at` with batten_release. */
typedef struct batten_parameters {
    int count;
    double *at;
} batten_parameters;

/** From which side a value is taken where a curve is not smooth. */
typedef enum batten_side { BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT } batten_side;

/* ---- making, keeping ---- */

/**
 * Make a curve from its control points and knots; the arrays are copied.
 *
 * @param points  dimension: d, 1..3
 *     point_count: n, at least p + 1
 *     [n][d], finite
 * @param degree  p, 1..25
 * @param weights  [n], finite and positive; NULL for a polynomial curve
 * @param knots  [n + p + 1], finite, never decreasing; U[p] < U[n]; no knot inside the
 *                     domain more than p times, none at all more than p + 1 times
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, BAD_DEGREE, TOO_FEW_POINTS, NOT_FINITE, BAD_KNOTS,
 * BAD_WEIGHT, TOO_LARGE or OUT_OF_MEMORY
 *
 * Cost: linear in n: one check of each number, and one copy.
 */
BATTEN_API batten_status batten_curve_create(batten_points points, int degree,
                                             const double *weights, const double *knots,
                                             batten_curve **out);

/**
 * Make a periodic curve from one period.
 *
 * `point_count` is m >= 1, fewer than p + 1 are allowed; `knots` [m + 1] never decrease and
 * span the period T = knots[m] - knots[0] > 0. For any integer j they continue as knots[j + m]
 * = knots[j] + T, and the points as points[i + m] = points[i]. The wrapped form, which the
 * properties show, has n = m + p points and the knots U[j] = knots[j - p], j = 0 .. m + 2 p. So
 * the domain [U[p], U[n]] is [knots[0], knots[m]]; wrapped point i is points[i modulo m]; and
 * point i has its influence on [U[i], U[i + p + 1]] = [knots[i - p], knots[i + 1]]. No knot may
 * stand more than p times, the seam included. Errors as batten_curve_create.
 *
 * @param points  [m][dimension], finite
 * @param degree  1 to 25
 * @param weights  [m], finite and positive; NULL for a polynomial curve
 * @param knots  [m + 1], one period
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, BAD_DEGREE, BAD_KNOTS, BAD_WEIGHT,
 * BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in m + p.
 */
BATTEN_API batten_status batten_curve_create_periodic(batten_points points, int degree,
                                                      const double *weights,
                                                      const double *knots, batten_curve **out);

/** One more reference to the same curve. */
BATTEN_API batten_curve *batten_curve_ref(const batten_curve *curve);
/**
 * Give one reference back; NULL is welcome.
 *
 * @param curve  any curve
 */
BATTEN_API void batten_curve_unref(batten_curve *curve);

/* ---- properties ---- */

/**
 * The number of coordinates of its points, 1 to 3; 1 is a function of its parameter.
 *
 * @param curve  any curve
 */
BATTEN_API int batten_curve_dimension(const batten_curve *curve);
/**
 * The degree p, 1 to 25.
 *
 * @param curve  any curve
 */
BATTEN_API int batten_curve_degree(const batten_curve *curve);
/** How many control points there are; of a periodic curve those of the wrapped form, m + p. */
BATTEN_API int batten_curve_point_count(const batten_curve *curve);
/**
 * How many knots there are, each as often as its multiplicity.
 *
 * @param curve  any curve
 */
BATTEN_API int batten_curve_knot_count(const batten_curve *curve);
/**
 * The control points, [point_count][dimension], never premultiplied by weights; borrowed.
 *
 * @param curve  any curve
 */
BATTEN_API const double *batten_curve_points(const batten_curve *curve);  /**
 * < [n][d]
 *
 * @param curve  any curve
 */
BATTEN_API const double *batten_curve_weights(const batten_curve *curve); /**
 * < [n], or NULL
 *
 * @param curve  any curve
 */
BATTEN_API const double *batten_curve_knots(const batten_curve *curve);   /**
 * < [n + p + 1]
 *
 * @param curve  any curve
 */
BATTEN_API bool batten_curve_is_rational(const batten_curve *curve);
/** Whether the knots repeat: the curve has no ends. */
BATTEN_API bool batten_curve_is_periodic(const batten_curve *curve);
/**
 * Does the first knot stand p + 1 times at both ends of the domain?
 *
 * @param curve  any curve
 */
BATTEN_API bool batten_curve_is_clamped(const batten_curve *curve);
/**
 * The closed interval of valid parameters.
 *
 * @param curve  any curve
 */
BATTEN_API batten_interval batten_curve_domain(const batten_curve *curve);
/**
 * Do the end points lie within `tolerance` of each other?
 *
 * @param curve  any curve
 */
BATTEN_API bool batten_curve_is_closed(const batten_curve *curve, double tolerance);
/** The box of the control points that bear on the domain: contains the curve. */
BATTEN_API batten_box batten_curve_box(const batten_curve *curve);
/**
 * Greville abscissa of control point i: (U[i+1] + ... + U[i+p]) / p.
 *
 * @param curve  any curve
 * @param i  from 0, below the point count
 */
BATTEN_API double batten_curve_greville(const batten_curve *curve, int i);
/**
 * Distinct knots of the domain, both ends included.
 * @param curve  any curve
 * @param[out] knots  [batten_curve_point_count + 1] at most, or NULL to count
 * @return how many
 */
BATTEN_API int batten_curve_spans(const batten_curve *curve, double *knots);

/* ---- evaluation ---- */

/**
 * Evaluate a curve and its derivatives with respect to `u`.
 *
 * At a knot the derivatives are those from the right; at the end of the domain, from the left.
 * A parameter up to 4 ulps outside the domain counts as its end. A periodic curve takes any u.
 *
 * @param curve  any curve, of degree p and dimension d
 * @param u      parameter, in batten_curve_domain(curve)
 * @param order  highest derivative wanted, >= 0; those above p of a polynomial curve are
 * exactly 0
 * @param[out] out  [order + 1][d]; row k is the k-th derivative, in model units per u^k
 * @return BATTEN_OK, NOT_FINITE, BATTEN_OUT_OF_DOMAIN or BATTEN_OVERFLOW
 *
 * Error of a point: at most 8 p r |P| (rational, weights within 1:100: 10 p r |P|), r = 2^-53,
 * |P| the largest coordinate. Cost: about p^2 blends of control points; after a batch on the
 * same curve, p d multiplications. No allocation up to order 25.
 */
BATTEN_API batten_status batten_curve_evaluate(const batten_curve *curve, double u, int order,
                                               double *out);
/**
 * The same, with the derivatives taken from the named side at a knot.
 *
 * @param curve  any curve
 * @param u  in batten_curve_domain(curve); of a periodic curve any
 * @param side  at a knot; elsewhere both sides agree
 * @param order  of the highest derivative, 0 or more
 * @param[out] out  [order + 1][d]
 * @return as batten_curve_evaluate
 *
 * Cost: as batten_curve_evaluate.
 */
BATTEN_API batten_status batten_curve_evaluate_side(const batten_curve *curve, double u,
                                                    batten_side side, int order, double *out);
/** What a curve is beyond its domain. */
typedef enum batten_beyond {
    BATTEN_BEYOND_REFUSE,   /**< nothing: OUT_OF_DOMAIN */
    BATTEN_BEYOND_CONTINUE, /**< its last span continues, a polynomial: grows fast */
    BATTEN_BEYOND_LINEAR    /**< its tangent at the end, with its speed */
} batten_beyond;
/**
 * The same as batten_curve_evaluate inside the domain; beyond it as asked for. Periodic curves
 * take any u anyway.
 *
 * @param curve  any curve
 * @param u  any number
 * @param beyond  what holds outside the domain
 * @param order  of the highest derivative, 0 or more
 * @param[out] out  [order + 1][d]
 * @return as batten_curve_evaluate; UNSUPPORTED for a rational curve that should CONTINUE;
 * BAD_ARGUMENT (beyond)
 *
 * Cost: as batten_curve_evaluate; CONTINUE takes one evaluation to order p and a Taylor sum.
 */
BATTEN_API batten_status batten_curve_evaluate_beyond(const batten_curve *curve, double u,
                                                      batten_beyond beyond, int order,
                                                      double *out);
/**
 * Many parameters at once, in any order: the same bits as one by one, much faster.
 * @param curve  any curve
 * @param count  how many
 * @param u  [count], in the domain
 * @param order  of the highest derivative, 0 or more
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out [count][order + 1][d]; of no use after a failure, whose message names the
 * index
 * @return as batten_curve_evaluate, naming the first parameter that fails; CANCELLED,
 * OUT_OF_MEMORY
 *
 * Cost: as batten_curve_evaluate for each, without the search and the blends of knots: the
 * spans are turned into polynomials once, which the curve keeps. Chunks of 4096 are shared
 * among threads.
 */
BATTEN_API batten_status batten_curve_evaluate_many(const batten_curve *curve, size_t count,
                                                    const double *u, int order,
                                                    const batten_job *job, double *out);

/* ---- changes: each makes a new curve of the same shape unless it says otherwise ----
 *
 * Control points that do not change keep their bits. A curve whose homogeneous points are too
 * large for numbers is refused with OVERFLOW, one that would have more than 10 million points
 * with TOO_LARGE. Cost grows with the number of points. */

/**
 * Insert a knot `times` times; with the times it stands there, p at most inside the domain, p +
 * 1 at its ends. Periodic curves stay periodic (any u is reduced to the period).
 *
 * @param curve  any curve
 * @param u  inside the domain or at its ends
 * @param times  1 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (times), NOT_FINITE, OUT_OF_DOMAIN or BAD_KNOTS (too often)
 *
 * Cost: n + times p blends of points.
 * Source: [Boehm80].
 */
BATTEN_API batten_status batten_curve_insert_knot(const batten_curve *curve, double u,
                                                  int times, batten_curve **out);
/**
 * Insert many knots at once: much faster than one by one. Rules as for
 * batten_curve_insert_knot.
 * @param curve  any curve
 * @param count  0 or more
 * @param knots [count], never decreasing (else NOT_INCREASING), inside the domain
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, NOT_INCREASING, OUT_OF_DOMAIN, BAD_KNOTS (too often),
 * TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: n + count p blends of points.
 */
BATTEN_API batten_status batten_curve_refine(const batten_curve *curve, int count,
                                             const double *knots, batten_curve **out);
/**
 * Remove a knot up to `times` times as long as the curve moves by no more than `tolerance`. A
 * periodic curve becomes clamped.
 *
 * @param curve  any curve
 * @param knot  at: a knot inside the domain, else NOT_FOUND; times: 0 or more
 * @param tolerance  model units, 0 or more; of a rational curve the bound takes the smallest
 * weight and the largest coordinate into account, so it may be far too careful
 * @param[out] removed  how often it could be removed; may be NULL
 * @param[out] error  a bound on how far the curve moved; may be NULL
 * @return BATTEN_OK, NOT_FINITE, BAD_WEIGHT, BAD_ARGUMENT, OVERFLOW, NOT_FOUND, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, for the copies; each removal solves p + 1 equations.
 * Source: [Tiller92], with all equations checked.
 */
BATTEN_API batten_status batten_curve_remove_knot(const batten_curve *curve, batten_knot knot,
                                                  double tolerance, int *removed, double *error,
                                                  batten_curve **out);
/**
 * Remove knots while the whole curve moves by no more than `tolerance`, at equal parameters; a
 * periodic curve becomes clamped. One by one first, where movements are added up span by span;
 * then in groups, halved where they cannot go, the rest fitted to the given curve by least
 * squares and compared with it on its own knots. Both ends stay to the bit.
 *
 * @param tolerance as for batten_curve_remove_knot; with 0 only knots go that move nothing
 * @param[out] removed  how many went
 * @param[out] error a bound: the largest control point of the difference; may be NULL
 * @return BATTEN_OK, NOT_FINITE, BAD_WEIGHT, BAD_ARGUMENT, OVERFLOW, OUT_OF_MEMORY
 * Cost: 128 log2(n) banded solutions at most.
 * Source: [LM87], [LM88].
 */
BATTEN_API batten_status batten_curve_remove_knots(const batten_curve *curve, double tolerance,
                                                   int *removed, double *error,
                                                   batten_curve **out);
/**
 * Raise the degree by `by` >= 0, to 25 at most (else BAD_DEGREE); every distinct knot stands
 * so many times more. Periodic curves stay periodic.
 *
 * @param curve  any curve
 * @param by  0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_DEGREE, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the result, about (p + by)^2 for each span.
 * Source: [Prautzsch84].
 */
BATTEN_API batten_status batten_curve_elevate(const batten_curve *curve, int by,
                                              batten_curve **out);
/**
 * Lower the degree to `degree` >= 1, moving the curve by at most `tolerance`; fails with
 * TOLERANCE_NOT_MET (and the error in the message) otherwise. The result is clamped and keeps
 * both ends; inner knots stand once less for each degree, but once at least. The reverse of
 * elevation.
 * @param curve  any curve
 * @param degree  1 to that of the curve
 * @param tolerance  model units, 0 or more
 * @param[out] error a bound on how far the curve moved; may be NULL
 * @return BATTEN_OK, BAD_DEGREE, BAD_ARGUMENT (tolerance), TOLERANCE_NOT_MET, OVERFLOW,
 * OUT_OF_MEMORY
 *
 * Cost: linear in the spans, about p^2 for each degree.
 */
BATTEN_API batten_status batten_curve_reduce(const batten_curve *curve, int degree,
                                             double tolerance, double *error,
                                             batten_curve **out);
/**
 * Cut at u, inside the domain. Both parts keep their parameters, are clamped at both ends, and
 * share the point at the cut bit for bit.
 *
 * @param curve  any curve
 * @param u  inside the domain
 * @param[out] left  the part before
 * @param[out] right  the part after
 * @return BATTEN_OK, NOT_FINITE, OUT_OF_DOMAIN, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, and p^2 at the cut.
 */
BATTEN_API batten_status batten_curve_split(const batten_curve *curve, double u,
                                            batten_curve **left, batten_curve **right);
/**
 * The part from a to b, a < b, clamped. Of a periodic curve b may lie beyond the end of the
 * domain, up to one period from a.
 *
 * @param curve  any curve
 * @param a, b  parameters in the domain
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OUT_OF_DOMAIN, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, and p^2 at both cuts.
 */
BATTEN_API batten_status batten_curve_subrange(const batten_curve *curve, double a, double b,
                                               batten_curve **out);
/**
 * Join end to start. The ends must be within `tolerance` (else NOT_COMPATIBLE) and meet
 * halfway; degrees and rationality are unified, the second domain is moved to follow the first
 * (BAD_KNOTS when knots fall together there), the joining knot is kept p times. At most 1
 * million points.
 *
 * @param first, second  of one dimension
 * @param tolerance  model units, 0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (tolerance), NOT_COMPATIBLE (dimensions, or the gap),
 * BAD_KNOTS, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of both, after the degrees are raised.
 */
BATTEN_API batten_status batten_curve_join(const batten_curve *first,
                                           const batten_curve *second, double tolerance,
                                           batten_curve **out);
/**
 * The reversed curve. Knots change their sign, which is exact: the domain [a, b] becomes
 * [-b, -a], the point at u is found at -u, and reversing twice gives the same bits. Call
 * batten_curve_set_domain where another domain is wanted.
 *
 * @param curve  any curve
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_reverse(const batten_curve *curve, batten_curve **out);
/**
 * Map the domain linearly to [a, b], a < b. Points and weights keep their bits; knots that
 * could not be told apart in the new domain are refused with BAD_KNOTS. Periodic stays
 * periodic.
 *
 * @param curve  any curve
 * @param a, b  finite
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT (a is not below b), BAD_KNOTS, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_set_domain(const batten_curve *curve, double a, double b,
                                                 batten_curve **out);
/**
 * Replace u by (a u + b) / (c u + d); ad - bc > 0 and c u + d > 0 on all knots, else
 * BAD_ARGUMENT. The result is rational; a periodic curve becomes clamped.
 *
 * @param curve  any curve
 * @param a, b, c, d  finite
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_KNOTS, BAD_WEIGHT, BAD_ARGUMENT, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_moebius(const batten_curve *curve, double a, double b,
                                              double c, double d, batten_curve **out);
/**
 * The clamped form: also what a periodic curve becomes for formats that know no other.
 *
 * @param curve  any curve
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, and p^2 at both ends.
 */
BATTEN_API batten_status batten_curve_clamp(const batten_curve *curve, batten_curve **out);
/**
 * The same curve with all weights 1 instead of none.
 *
 * @param curve  any curve
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_to_rational(const batten_curve *curve,
                                                  batten_curve **out);
/**
 * The curve in 1..3 dimensions: coordinates are dropped, or added as 0.
 *
 * @param curve  any curve
 * @param dimension  coordinates of each point, 1 to 3
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT (dimension), OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_to_dimension(const batten_curve *curve, int dimension,
                                                   batten_curve **out);
/**
 * A curve in a plane x, y or z = constant as a curve of that plane: the coordinate that is the
 * same all along, but for the rounding of whatever made it (2^-46 of the largest), is dropped.
 *
 * @param curve  any curve
 * @param[out] axis 0, 1 or 2, the last of several; -1 for none, and when the curve has fewer
 * than 3 dimensions: then the curve comes back as it is. batten_frame_across is the plane.
 * @param[out] out  of dimension 2, or the curve itself
 * @return BATTEN_OK or OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_flatten(const batten_curve *curve, int *axis,
                                              batten_curve **out);
/**
 * A curve with control point `index` replaced, of a periodic curve with all its copies.
 * @param curve  any curve
 * @param index  of the control point, from 0
 * @param point  [d], model units
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: linear in the control points, for the copy.
 */
BATTEN_API batten_status batten_curve_with_point(const batten_curve *curve, int index,
                                                 const double *point, batten_curve **out);
/**
 * The curve under an affine map, of which the first d rows and columns count; OVERFLOW when a
 * point leaves the numbers.
 *
 * @param curve  any curve
 * @param map  finite, else NOT_FINITE
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_transform(const batten_curve *curve,
                                                const batten_affine *map, batten_curve **out);
/**
 * Give curves the same degree, the same knots bit for bit and the same domain [0, 1], exactly.
 * Periodic curves stay periodic when all are, else all are clamped. Rational when one is.
 *
 * Knots of different curves that differ in [0, 1] by no more than rounding, 2 eps (max(|a|,
 * |b|) / (b - a) + 1) for each curve with its domain [a, b], are taken for the same knot, and
 * the best known value is used; knots of one curve are never joined.
 *
 * @param count  1 or more
 * @param curves  [count]; dimensions may differ
 * @param[out] out  [count]; yours to unref
 * @return BATTEN_OK; TOO_LARGE, before any work, when the curves would have more than about a
 * million control points in all; BAD_KNOTS when a curve's knots cannot be told apart in [0, 1];
 * OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: n log n to sort n knots, then linear in the control points of the results: count times
 * all distinct knots.
 */
BATTEN_API batten_status batten_curves_unify(int count, const batten_curve *const *curves,
                                             batten_curve **out);

/* ---- other forms ---- */

/**
 * Every knot of the domain p times: control points k p .. k p + p are the Bezier points of
 * piece k.
 *
 * @param curve  any curve
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: p^2 blends of points for each span.
 */
BATTEN_API batten_status batten_curve_to_bezier(const batten_curve *curve, batten_curve **out);
/**
 * From Bezier pieces that share their end points.
 * @param dimension  coordinates of each point, 1 to 3
 * @param pieces  degree, count and breaks [count + 1], increasing
 * @param points  [count * degree + 1][d]
 * @param weights  [count * degree + 1], positive, or NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, BAD_KNOTS,
 * BAD_WEIGHT, BAD_ARGUMENT, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the points.
 */
BATTEN_API batten_status batten_curve_from_bezier(int dimension, batten_pieces pieces,
                                                  const double *points, const double *weights,
                                                  batten_curve **out);
/**
 * From points and derivatives at increasing parameters: degree 2 k - 1 where k values are
 * given at each, inner knots k times.
 * @param dimension  coordinates of each point, 1 to 3
 * @param count  of parameters, 2 or more
 * @param k  values at each, 1..4
 * @param parameters  [count], increasing
 * @param values  [count][k][d], the point, first, second ... derivative
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_ARGUMENT (k, dimension),
 * TOO_LARGE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_curve_from_hermite(int dimension, int count, int k,
                                                   const double *parameters,
                                                   const double *values, batten_curve **out);
/**
 * From polynomial pieces in powers of (u - breaks[i]).
 * @param dimension  coordinates of each point, 1 to 3
 * @param pieces  degree, count and breaks [count + 1], increasing
 * @param coefficients [piece_count][degree + 1][d], constant term first; pieces that do not
 * join within `tolerance` are an error
 * @param tolerance  model units, 0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, BAD_DEGREE, BAD_KNOTS,
 * BAD_WEIGHT, BAD_ARGUMENT, NOT_COMPATIBLE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the pieces, p^2 for each.
 */
BATTEN_API batten_status batten_curve_from_power(int dimension, batten_pieces pieces,
                                                 const double *coefficients, double tolerance,
                                                 batten_curve **out);
/**
 * The graph (u, f(u)) of a curve of one dimension, clamped; of a rational one in Bezier form, one degree higher.
 *
 * @param function  of dimension 1
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT for other dimensions, BAD_DEGREE where one higher is too high;
 * OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in the control points.
 */
BATTEN_API batten_status batten_curve_from_function(const batten_curve *function,
                                                    batten_curve **out);
/**
 * The reverse, for a polynomial curve. Count the pieces with batten_curve_spans() - 1.
 * @param curve  polynomial
 * @param[out] coefficients [pieces][p + 1][d]
 * @return BATTEN_OK, UNSUPPORTED, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: one evaluation to order p for each span.
 */
BATTEN_API batten_status batten_curve_to_power(const batten_curve *curve, double *coefficients);

#ifdef __cplusplus
}
#endif
#endif
