#ifndef BATTEN_ARCS_H
#define BATTEN_ARCS_H
/**
 * @file
 * Curves and rows of points as chains of few arcs and lines, within a tolerance: what machines
 * that know nothing else can follow.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_arcs_join {
    BATTEN_ARCS_SMOOTH, /**< the fewest that turn only at corners of the curve; of points
                             BIARCS */
    BATTEN_ARCS_PLAIN,  /**< single arcs with small corners where they meet: lines where the
                             curve is nearly straight */
    BATTEN_ARCS_BIARCS  /**< biarcs, whose ends have the directions of the curve: some 45 per
                             cent more than SMOOTH */
} batten_arcs_join;

/** On which side of the curve, seen along it, the arcs may lie. */
typedef enum batten_arcs_side {
    BATTEN_ARCS_EITHER,
    BATTEN_ARCS_LEFT,
    BATTEN_ARCS_RIGHT,
    BATTEN_ARCS_INSIDE, /**< of a closed curve, as it turns */
    BATTEN_ARCS_OUTSIDE
} batten_arcs_side;

typedef struct batten_arcs_options {
    size_t size;
    double tolerance;        /**< model units, > 0; must be set */
    batten_arcs_join joined; /**< BATTEN_ARCS_SMOOTH */
    batten_arcs_side side;   /**< BATTEN_ARCS_EITHER */
    double least_radius;     /**< of any arc, model units; 0 for none */
    int most;                /**< arcs and lines; 0: as many as it takes */
    double corner; /**< radians: where the direction of the curve jumps by more, it has
                        a corner; 1e-6 */
    bool spread;   /**< with the same number of arcs, make the largest deviation as
                        small as can be, within 2 per cent; true */
    bool closed;   /**< of points: the first is also the last; it is not repeated */
} batten_arcs_options;
BATTEN_API batten_arcs_options batten_arcs_defaults(void);

typedef struct batten_arcs_report {
    int arcs, lines;
    double deviation;    /**< the largest distance between curve and arcs: at all places where
                              the distance has an extreme, or of points the largest */
    double left, right;  /**< the largest to either side of the curve, >= 0 */
    double at;           /**< parameter of the curve, or index of the point, of the largest */
    double sampled;      /**< the same by dense sampling alone, 64 and more on each arc */
    double least_radius; /**< infinity when all are lines */
    double largest_turn; /**< of the tangent between neighbours, radians; corners included */
} batten_arcs_report;

/**
 * The fewest arcs for a plane curve.
 *
 * From corner to corner. SMOOTH and PLAIN arcs begin and end on the curve, with one side
 * allowed half the tolerance beside it; along a curve with the curvature k, s the arc length,
 * their number goes to the integral of |dk/ds|^(1/3) ds divided by (72 sqrt 3 tolerance)^(1/3),
 * and smooth arcs cannot be fewer. Where curvature has an extreme, or a closed curve must
 * close, SMOOTH takes about half an arc more than PLAIN. Its arcs bend to no side to which the
 * curve does not, and are not sharper than 1.4 times its sharpest place. PLAIN and BIARCS make
 * each arc, each biarc as long as the tolerance allows, within a thousandth; biarcs have the
 * directions of the curve at their ends, and 2 / (324 tolerance)^(1/3) stands in their number.
 * With one side allowed the tolerance counts by half. What is lines and arcs exactly from
 * corner to corner (see batten_arcs_exact) stays as it is, even where fewer arcs would do: a
 * circle is two arcs, a line one line, a polyline with round corners itself. Corners and ends
 * of the curve are kept exactly as points; SMOOTH and PLAIN turn there by a little more or less
 * than the curve. SMOOTH arcs of a closed curve without corners may begin anywhere on it.
 *
 * @param curve   dimension 2
 * @param options with the tolerance
 * @param[out] report may be NULL
 * @param[out] out a chain of arcs and lines, by arc length
 * @return BATTEN_OK; BAD_ARGUMENT (dimension, tolerance, radius, side of a curve that is not
 * closed); TOLERANCE_NOT_MET naming the parameter where no arc of `least_radius` stays within
 * the tolerance, or the number that is needed when that is more than `most`; SINGULAR_HERE for
 * a curve that is a point; OVERFLOW; OUT_OF_MEMORY
 *
 * Cost: PLAIN and BIARCS about 15 trials for each, each of some 30 evaluations; with `spread`
 * and few arcs up to ten times that. SMOOTH 10,000 trial arcs for each, around a closed curve
 * up to 24 times; 10 KB for each arc. Where more than 10,000 are needed from corner to corner
 * it takes biarcs. Source: [MW95], [Bolton75]; [DRS08] for the search from place to place; the
 * leans as its second coordinate and the measure of the error are our own.
 */
BATTEN_API batten_status batten_arcs_of_curve(const batten_curve *curve,
                                              const batten_arcs_options *options,
                                              batten_arcs_report *report, batten_chain **out);

/**
 * The chain of arcs and lines that a curve is already, if it is one: every Bezier piece is a
 * line (of any degree, with any speed that does not turn back) or a rational arc of a circle,
 * within 1e-12 of the size of the curve, or its rounding if that is more.
 *
 * Neighbours that go on along one line, or one circle up to half of it, become one span. A
 * curve in space must lie in a plane x, y or z = constant; its chain is placed there.
 *
 * @param curve any curve
 * @param[out] out NULL when the curve is no such chain; else its breaks are knots of the curve,
 *             and middles of spans that turn by more than half a circle. Between two breaks
 *             the chain goes by arc length, as the curve may not
 * @return BATTEN_OK, OUT_OF_MEMORY
 * Cost: 4 p + 1 evaluations for each piece of degree p, or 8 p + 2 when it is no line.
 * Source: the identity |C - c|^2 = r^2, of degree 2 p, at the places of [EZ64].
 */
BATTEN_API batten_status batten_arcs_exact(const batten_curve *curve, batten_chain **out);

/** The same for a plane chain that is not placed: it is converted within a hundredth of the
 * tolerance first, and the rest used for the arcs. `at` is a parameter of the chain. */
BATTEN_API batten_status batten_arcs_of_chain(const batten_chain *chain,
                                              const batten_arcs_options *options,
                                              batten_arcs_report *report, batten_chain **out);

/**
 * Few arcs that pass all points of a row within a tolerance; ends of arcs are points of the row
 * (or half the tolerance beside them when one side is allowed). Biarcs have the directions of
 * the circles through three neighbours, so rough points are better served with `plain` arcs.
 * The distance is that of the points: between them the arcs go as they like. `spread`, `corner`
 * and `most` are as for curves, but there are no corners.
 *
 * @param points [count][2], 2 or more, 3 or more when closed; neighbours apart
 * @param[out] parameters [count], of the places on the chain nearest to the points; may be NULL
 * @return also TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, SINGULAR_HERE where the points turn back
 * Cost: about count log(count) distances.
 * Source: [MW92] for biarcs within a band.
 */
BATTEN_API batten_status batten_arcs_of_points(int count, const double *points,
                                               const batten_arcs_options *options,
                                               double *parameters, batten_arcs_report *report,
                                               batten_chain **out);

#ifdef __cplusplus
}
#endif
#endif
