#ifndef BATTEN_INTERPOLATE_H
#define BATTEN_INTERPOLATE_H
/**
 * @file
 * Curves through points, and surfaces through grids of points.
 */
#include <batten/surface.h>

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
 * @param closed  also give the step from the last point back to the first
 * @param[out] parameters  [count], or [count + 1] when closed; increasing
 * @return BATTEN_COINCIDENT naming the first pair of neighbours that coincide (uniform steps do
 * not mind), BATTEN_NOT_FINITE, BATTEN_TOO_FEW_POINTS or BATTEN_OVERFLOW Source: [Lee89],
 * [FN89].
 */
BATTEN_API batten_status batten_parametrize(int dimension, int count, const double *points,
                                            batten_parametrization kind, bool closed,
                                            double *parameters);

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

/** A derivative that the curve shall have at one of its data points. */
typedef struct batten_derivative {
    int index; /**< which data point */
    int order; /**< 1, 2 ... */
    double value[3];
} batten_derivative;

typedef struct batten_interpolate_options {
    size_t size;
    int degree;                        /**< 3 */
    batten_parametrization parameters; /**< BATTEN_CENTRIPETAL */
    const double *given;               /**< [count] (periodic: [count + 1]) with BATTEN_GIVEN */
    bool knots_at_data;    /**< true: C2 cubic with knots at the data and conditions at the
                                ends (degree 3, or odd degrees with `derivatives`);
                                false: averaged knots, no end conditions needed */
    batten_end start, end; /**< used with knots at the data */
    bool periodic;         /**< the curve closes smoothly; the first point is not repeated */
    int derivative_count;
    const batten_derivative
        *derivatives; /**< further conditions, at any data point (averaged knots) */
} batten_interpolate_options;

/** Cubic, centripetal, knots at the data, not-a-knot ends. */
BATTEN_API batten_interpolate_options batten_interpolate_defaults(void);

/**
 * A curve through points.
 *
 * Two points give a line, fewer points than degree + 1 a lower degree; three with not-a-knot
 * ends the parabola.
 *
 * @param points  [count][dimension]; with a periodic curve each once
 * @param options NULL for the defaults
 * @param[out] parameters [count], those of the points; may be NULL
 * @return BATTEN_OK, NOT_FINITE, TOO_FEW_POINTS, COINCIDENT, NOT_INCREASING, SINGULAR_SYSTEM
 * ...
 *
 * With knots at the data each end takes (degree - 1) / 2 conditions; for each that is missing
 * it does without a knot. Periodic curves of even degree have their knots midway between the
 * points, and their domain begins half a step before the first.
 *
 * Cost: linear in count. The result is checked: it passes every point within 8 eps of the
 * largest coordinate of data and control points, else TOLERANCE_NOT_MET. Source: [deBoor01] ch.
 * IV, XIII; [PT97] 9.2; [Xin77] for fair ends.
 */
BATTEN_API batten_status batten_curve_interpolate(int dimension, int count,
                                                  const double *points,
                                                  const batten_interpolate_options *options,
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
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, NOT_INCREASING, OVERFLOW, BAD_ARGUMENT
 * Cost: linear; nothing is solved. Source: [SL] II.3, after Wang Rishuang.
 */
BATTEN_API batten_status batten_spline_convexity(int count, const double *x, const double *y,
                                                 const batten_end *start, const batten_end *end,
                                                 batten_convexity *out);

/** What is known along the rim of a grid, for surfaces with knots at the data. */
typedef struct batten_grid_options {
    size_t size;
    int degree_u, degree_v;            /**< 3, 3 */
    batten_parametrization parameters; /**< averaged over the rows; BATTEN_CENTRIPETAL */
    const double *given_u, *given_v;   /**< [count] (periodic [count + 1]) with BATTEN_GIVEN */
    bool knots_at_data;                /**< false: averaged knots (the default) */
    bool periodic_u, periodic_v;
    batten_end_kind ends; /**< what holds on the rim when no derivatives are given */
    const double *du; /**< [orders_u][2][count_v][d], Su (Suu ..) on the first and last row; or
                           NULL */
    const double *dv; /**< [orders_v][2][count_u][d], Sv (Svv ..) on the first and last column;
                           or NULL */
    const double *twists; /**< [orders_u][2][orders_v][2][d], Suv (Suuv ..) at the corners (u
                             end first); or NULL */
    int orders_u,
        orders_v; /**< how many derivatives `du` and `dv` give; 0: one. Knots at the data
                       take (degree - 1) / 2, averaged ones as many as the degree */
    const double *weights; /**< [count_u][count_v], > 0, of the points of a rational surface; or
                                NULL. Not with derivatives */
    const bool *gaps; /**< [count_u][count_v], where there is no point: what stands there is not
                           looked at; or NULL */
} batten_grid_options;

BATTEN_API batten_grid_options batten_grid_defaults(void);

/** What a grid interpolation found out about its data. */
typedef struct batten_grid_report {
    double residual;           /**< largest distance from a data point */
    double spread_u, spread_v; /**< largest |row parameter - average|, in steps; above 0.5
                                  skinning is better */
    int filled; /**< how many points were none, and stand where least energy puts them */
} batten_grid_report;

/**
 * A surface through a grid of points.
 *
 * Parameters run from 0 to 1 unless they are given. Lines of the grid that are a single point
 * are left out of their average, and a rim that is one stays one: a pole. Where both `du` and
 * `dv` are given, of one order, but not `twists`, the twists are estimated with Bessel's
 * parabolas. Few points lower a degree.
 *
 * With `weights` the points (w x, w y, w z, w) are interpolated; BAD_WEIGHT naming the control
 * point whose weight is not above 0 then. Gaps are filled first, with the points that make the
 * second differences over the grid, as sums for the integral of Suu^2 + 2 Suv^2 + Svv^2, least:
 * a plane with gaps stays plane. SINGULAR_SYSTEM when the others do not determine them.
 *
 * @param points [count_u][count_v][dimension]
 * @param[out] u, v  parameters of the grid lines [count_u], [count_v]; may be NULL
 * @param[out] report may be NULL
 * @return as batten_curve_interpolate; the message names the direction
 *
 * Cost: linear in the number of points; each direction is factored once. Gaps: their number
 * times the square of those in two lines. Source: [deBoor01] ch. XVII, [PT97] 9.2.5.
 */
BATTEN_API batten_status batten_surface_interpolate(int dimension, int count_u, int count_v,
                                                    const double *points,
                                                    const batten_grid_options *options,
                                                    const batten_job *job, double *u, double *v,
                                                    batten_grid_report *report,
                                                    batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
