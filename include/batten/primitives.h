#ifndef BATTEN_PRIMITIVES_H
#define BATTEN_PRIMITIVES_H
/**
 * @file
 * Lines, circles, ellipses and clothoids nearest to points.
 *
 * All minimise the sum of squared distances at right angles to the shape, after a start that is
 * found without iteration. Points on a shape give it back to rounding.
 */
#include <batten/chain.h>

#ifdef __cplusplus
extern "C" {
#endif

/** How near the points are. */
typedef struct batten_primitive_report {
    double max, rms; /**< largest distance, root of the mean square; model units */
    int worst;       /**< index of the farthest point */
    int rounds;      /**< of refinement */
} batten_primitive_report;

/** A line: its points are point + s * direction. */
typedef struct batten_fitted_line {
    double point[3];     /**< the mean of the data */
    double direction[3]; /**< of length one, from the first datum towards the last */
    double from, to;     /**< s of the outermost feet */
} batten_fitted_line;

/**
 * The line in the plane or in space with the least sum of squared distances (total least
 * squares, by the eigenvectors of the spread).
 * @param points [count][dimension], dimension 2 or 3, count >= 2
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE; COINCIDENT when all points are
 * one; SINGULAR_SYSTEM when they spread alike in several directions
 */
BATTEN_API batten_status batten_line_fit(int dimension, int count, const double *points,
                                         batten_fitted_line *line,
                                         batten_primitive_report *report);

/** What a circle through points minimises. */
typedef enum batten_circle_method {
    BATTEN_CIRCLE_GEOMETRIC, /**< distances, by Gauss and Newton from Taubin's circle */
    BATTEN_CIRCLE_TAUBIN,    /**< (x^2 + y^2 - r^2)^2 by its mean slope: nearly unbiased */
    BATTEN_CIRCLE_PRATT,     /**< nearly the same; works for lines too */
    BATTEN_CIRCLE_KASA       /**< (x^2 + y^2 - r^2)^2: linear; too small on short arcs */
} batten_circle_method;

/** A circle in the xy-plane of `frame`, about its origin; the data lie from `start` to
 * `start + angle`, radians, as they go from the first to the last. */
typedef struct batten_fitted_circle {
    batten_frame frame;
    double radius;
    double start, angle; /**< angle in (0, 2 pi]: 2 pi when the data go all around */
} batten_fitted_circle;

/**
 * The circle nearest to points of the plane, or in space within the plane nearest to them; the
 * normal is such that the data run counter-clockwise.
 * @param points [count][dimension], dimension 2 or 3, count >= 3
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE; SINGULAR_SYSTEM when the points
 * lie on a line
 * Cost: linear in count for each round. Source: [Taubin91], [Pratt87].
 */
BATTEN_API batten_status batten_circle_fit(int dimension, int count, const double *points,
                                           batten_circle_method method,
                                           batten_fitted_circle *circle,
                                           batten_primitive_report *report);

/** An ellipse in the plane: center + a cos(t) axis + b sin(t) (axis turned left), a >= b; the
 * data lie from t = `start` to `start + angle`. */
typedef struct batten_fitted_ellipse {
    double center[2], axis[2];
    double a, b;
    double start, angle; /**< angle in (0, 2 pi], negative when the data run clockwise */
} batten_fitted_ellipse;

/**
 * The ellipse nearest to points of the plane: Fitzgibbon's direct fit, which is always an
 * ellipse, then the distances at right angles.
 * @param points [count][2], count >= 5
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE; SINGULAR_SYSTEM when the points determine no
 * ellipse (on a line, a parabola or a hyperbola)
 * Source: [FPF99] in the stable form of [HF98].
 */
BATTEN_API batten_status batten_ellipse_fit(int count, const double *points,
                                            batten_fitted_ellipse *ellipse,
                                            batten_primitive_report *report);

/**
 * The clothoid nearest to points of the plane, given in their order along it: curvature linear
 * in arc length. Lines and arcs are clothoids.
 *
 * @param points [count][2], count >= 4, neighbours apart; between neighbours the curve turns by
 *               less than a right angle
 * @param[out] span  BATTEN_SPAN_SPIRAL, from the foot of the first to that of the last
 * @param[out] lengths [count], arc lengths of the feet from there; may be NULL
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT; TOLERANCE_NOT_MET when the first
 * guess is too far off for rounds to converge
 * Source: the distances at right angles as in [ARW01].
 */
BATTEN_API batten_status batten_clothoid_fit(int count, const double *points, batten_span *span,
                                             double *lengths, batten_primitive_report *report);

#ifdef __cplusplus
}
#endif
#endif
