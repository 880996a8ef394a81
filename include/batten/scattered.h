#ifndef BATTEN_SCATTERED_H
#define BATTEN_SCATTERED_H
/**
 * @file
 * Surfaces near scattered data: functions over the plane, data with parameters, clouds of
 * points.
 */
#include <batten/grid_fit.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef enum batten_scattered_method {
    BATTEN_SCATTERED_PENALISED, /**< least squares and a penalty on bending */
    BATTEN_SCATTERED_MULTILEVEL /**< bicubic lattices, each half as wide as the one before, near
                                     what is left: fast, local, no least squares */
} batten_scattered_method;

typedef struct batten_scattered_options {
    size_t size;
    batten_scattered_method method;
    int degree_u, degree_v; /**< 3, 3; 2 to 9. MULTILEVEL: always 3 */
    int spans_u, spans_v;  /**< between knots, with which it begins. 0: by the number of data; 4
                                with a tolerance; of MULTILEVEL 1 in the shorter direction */
    double domain[2][2];   /**< u from, to; v from, to; all 0: the box of the parameters */
    const double *weights; /**< [count], or NULL */
    batten_smooth_by by;   /**< PENALISED without tolerance: BATTEN_SMOOTH_BY_VALIDATION. LAMBDA
                                with amount 0: least squares; where the data do not determine the
                                surface the penalty weighs 1e-8 of them, and `lambda` says so */
    double amount;
    double tolerance; /**< > 0: lines of knots are added where data are farther, until none is;
                         0 */
    int most_points;  /**< control points at most; 0: 250000 */
    int levels;       /**< MULTILEVEL: at most; 0: 9, or as many as the data are good for */
    bool huber; /**< PENALISED: distances count by their squares up to the threshold, beyond
                     in proportion */
    double threshold; /**< 0: 1.345 standard deviations, found from the median distance */
    int corrections;  /**< of clouds: how often parameters are moved to the feet at most; 20 */
} batten_scattered_options;

BATTEN_API batten_scattered_options batten_scattered_defaults(void);

/**
 * A tensor product spline near values at scattered parameters.
 *
 * PENALISED: the least of the weighted squares plus lambda times the integral of Suu^2 + 2
 * Suv^2 + Svv^2, over knots at even distances; lambda by cross validation, by a target or as
 * given. With a tolerance knots are added in the strips, and along the directions, where data
 * are too far off, and in the end those removed that are not needed; lambda is then 1e-4 of the
 * data's scale or more, 1e-9 when knots alone do not meet the tolerance. Where a part of the
 * domain holds no data (bins four times as wide as the data are dense) the penalty weighs 1e-2
 * of that scale at least, however small lambda becomes, unless lambda is given or the target
 * cannot be met so: the surface goes on calmly there. `outside` of the report says how far it
 * leaves the box of the data nonetheless. Systems are solved directly where that is cheap, else
 * (some 125 spans each way) by conjugate gradients; lambda is then chosen on 80 spans, so a
 * target of rms is met nearly, and `freedom` is not asked.
 *
 * MULTILEVEL: each level meets single points exactly and averages where several share control
 * points. Levels follow until the tolerance is met; without one, and without `levels`,
 * until the next would have more than eight control points for each datum, or the root of the
 * mean square no longer falls by a tenth. `end` of the report says which it was.
 *
 * @param uv      [count][2], any order
 * @param values  [count][dimension]; dimension 1: a function of (u, v)
 * @param options NULL for the defaults
 * @param[out] report may be NULL
 * @param[out] out clamped, over the domain
 * @return BATTEN_OK; TOO_FEW_POINTS; NOT_FINITE, BAD_WEIGHT, OUT_OF_DOMAIN naming the datum;
 * COINCIDENT when the parameters span no area; BAD_DEGREE, BAD_ARGUMENT, TOO_LARGE;
 * TOLERANCE_NOT_MET with the most that was reached and where
 *
 * Cost: for each fit (degree + 1)^4 / 2 for a datum and, solved directly, the control points
 * times the square of those of the shorter direction; memory linear in data and control points.
 * Source: [HH74], [Dierckx93], [LWS97], [Hutchinson89] for the trace.
 */
BATTEN_API batten_status batten_surface_scattered(int dimension, int count, const double *uv,
                                                  const double *values,
                                                  const batten_scattered_options *options,
                                                  const batten_job *job,
                                                  batten_surface_fit_report *report,
                                                  batten_surface **out);

/**
 * A surface near a cloud of points, whose parameters are their feet on a base surface, then on
 * the surface itself.
 *
 * After each fit every point takes a step of Newton towards its foot, where that brings it
 * nearer, until rms no longer falls by a hundredth; the best is kept. Points on the rim of the
 * domain stay on it.
 *
 * @param points  [count][3]
 * @param base    any surface over which the cloud lies once; NULL: the smallest rectangle
 * around it in the plane of least squares
 * @param[out] uv [count][2], of the points on the surface; may be NULL
 * @return as batten_surface_scattered; COINCIDENT when the points lie on a line (without base)
 * Cost: a search for each point on the base, then as batten_surface_scattered for each round.
 * Source: [Hoschek88].
 */
BATTEN_API batten_status batten_surface_cloud(int count, const double *points,
                                              const batten_surface *base,
                                              const batten_scattered_options *options,
                                              const batten_job *job, double *uv,
                                              batten_surface_fit_report *report,
                                              batten_surface **out);

/** The bilinear surface of four corners: a base for clouds. @param corners (0, 0), (1, 0), (0,
 * 1), (1, 1) [4][3] */
BATTEN_API batten_status batten_surface_of_corners(const double *corners, batten_surface **out);

/** The graph (u, v, f(u, v)) of a polynomial surface of one dimension, in space; clamped.
 * @return BATTEN_OK, BAD_ARGUMENT when it is none */
BATTEN_API batten_status batten_surface_graph(const batten_surface *function,
                                              batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
