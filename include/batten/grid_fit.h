#ifndef BATTEN_GRID_FIT_H
#define BATTEN_GRID_FIT_H
/**
 * @file
 * Surfaces near the points of a grid: least squares with few control points, and smoothing.
 */
#include <batten/approximate.h>
#include <batten/job.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Why lattices were not halved again. */
typedef enum batten_levels_end {
    BATTEN_LEVELS_NONE,   /**< another method */
    BATTEN_LEVELS_MET,    /**< the tolerance is met, or every datum */
    BATTEN_LEVELS_MOST,   /**< as many levels as were wanted, or nine */
    BATTEN_LEVELS_LARGE,  /**< the next would have too many control points */
    BATTEN_LEVELS_FEW,    /**< the next would have more than eight control points for a datum */
    BATTEN_LEVELS_NO_GAIN /**< the last brought the data nearer by less than a tenth */
} batten_levels_end;

/** What a surface near points reached. Distances are those of the data from the surface at
 * their parameters, in model units, so no datum is farther from the surface; data of weight 0
 * do not count. */
typedef struct batten_surface_fit_report {
    double max, rms;
    double most;     /**< 95 of 100 data are not farther */
    int worst;       /**< index of the farthest datum; of a grid i * count_v + j */
    double at[2];    /**< its parameters */
    double where[3]; /**< and the datum itself; of a function (u, v, value) */
    double lambda;   /**< the weight of the penalty; 0 without one */
    double freedom;  /**< how many of the data the surface follows: the trace of the matrix that
                          turns data into values; of scattered data an estimate; 0: not asked */
    int points_u, points_v;    /**< control points, those of one period */
    double spread_u, spread_v; /**< of a grid: largest |row parameter - average|, in steps */
    int rounds;                /**< of refinement, of levels */
    int corrections;           /**< rounds of parameter correction */
    int reweightings;          /**< rounds of a robust fit */
    double threshold;          /**< the distance from which on a robust fit counts data less */
    int empty;                 /**< of scattered data: cells between knots that hold none */
    int iterations;            /**< of conjugate gradients; 0: solved directly */
    double outside; /**< of scattered data: how far the surface leaves the box of the data,
                         seen on a grid of places */
    double outside_share;  /**< by the side of the box along which it does (at least a tenth of
                                its longest) */
    double outside_at[3];  /**< where on the surface; of a function (u, v, value) */
    double layered;        /**< of a cloud: the share of points whose neighbour by parameters on
                                the base is far away in space; above some tenths the cloud does
                                not lie over its base once, as a closed body does not */
    double layers_apart;   /**< how far, by the median */
    batten_levels_end end; /**< of levels */
} batten_surface_fit_report;

/** What is made small beside the distances. */
typedef enum batten_grid_penalty {
    BATTEN_GRID_ENERGY,     /**< integrals of squares of the derivatives along u and along v */
    BATTEN_GRID_DIFFERENCES /**< squares of the differences of control points along u and v,
                               with even knots: P-splines */
} batten_grid_penalty;

typedef struct batten_grid_fit_options {
    size_t size;
    int degree_u, degree_v; /**< 3, 3 */
    int points_u, points_v; /**< control points, periodic: of one period. 0: least squares one
                                 for every four lines of the grid; smoothing up to 43, at most
                                 one for every line */
    batten_parametrization parameters; /**< averaged over the rows; BATTEN_CENTRIPETAL */
    const double *given_u, *given_v;   /**< [count] (periodic [count + 1]) with BATTEN_GIVEN */
    const double *weights_u, *weights_v; /**< [count] of the lines of the grid: the weight of a
                                              datum is their product; NULL: all 1 */
    bool periodic_u, periodic_v;
    bool hold_rims; /**< least squares: the surface passes the four corners, and its rims are
                         the least squares of the rims' data alone; true */
    batten_grid_penalty penalty; /**< smoothing: BATTEN_GRID_ENERGY */
    int order;                   /**< of the derivatives or differences, 1..4; 2 */
    batten_smooth_by by;         /**< BATTEN_SMOOTH_BY_VALIDATION */
    double amount;               /**< lambda, or the rms */
    double tolerance; /**< least squares: > 0: control points are added, from `points_u` by
                           `points_v` (0: the fewest) on, along the direction that gains more,
                           until no datum is farther; 0 */
} batten_grid_fit_options;

BATTEN_API batten_grid_fit_options batten_grid_fit_defaults(void);

/**
 * The surface with few control points and the least sum of squared distances from a grid.
 *
 * Curves are fitted along u to the data of each line, and then along v to their control points:
 * with the weights of lines that is the least squares of the tensor product. Knots follow the
 * data ([PT97] 9.69). With `hold_rims` the corners are met, and surfaces that share the data of
 * a rim share the rim. With a tolerance the fewest control points are sought that meet it,
 * TOLERANCE_NOT_MET when none do.
 *
 * @param points [count_u][count_v][dimension]
 * @param options NULL for the defaults
 * @param[out] u, v  parameters of the grid lines [count_u], [count_v]; may be NULL
 * @param[out] report may be NULL
 * @return as batten_curve_least_squares; the message names the direction; TOO_LARGE
 * Cost: linear in the number of data. Source: [PT97] 9.4.4, [Dierckx93].
 */
BATTEN_API batten_status batten_surface_fit_grid(int dimension, int count_u, int count_v,
                                                 const double *points,
                                                 const batten_grid_fit_options *options,
                                                 const batten_job *job, double *u, double *v,
                                                 batten_surface_fit_report *report,
                                                 batten_surface **out);

/**
 * A smooth surface near a grid: least squares plus lambda times a penalty of roughness.
 *
 * With G the matrices of the data and R those of the penalty the least is sought of the squares
 * and lambda (R_u x G_v + G_u x R_v): a penalty along the lines of the grid, which both
 * directions can be solved for apart. lambda = 0 gives the least squares without held rims (the
 * interpolating surface, with as many control points as data); infinity the polynomial of
 * degree order - 1 in u and in v. The knots of BATTEN_GRID_ENERGY are averages of parameters,
 * as for interpolation.
 *
 * Each direction may have 400 control points, and not more than lines of the grid.
 *
 * @return as batten_surface_fit_grid; BAD_ARGUMENT (order, amount), TOO_LARGE
 * Cost: the cube of the control points of a direction to begin, then for each lambda their
 * product. Source: [EM96], [Dierckx93], [CW79].
 */
BATTEN_API batten_status batten_surface_smooth_grid(int dimension, int count_u, int count_v,
                                                    const double *points,
                                                    const batten_grid_fit_options *options,
                                                    const batten_job *job, double *u, double *v,
                                                    batten_surface_fit_report *report,
                                                    batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
