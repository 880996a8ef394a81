#ifndef BATTEN_GRID_H
#define BATTEN_GRID_H
/**
 * @file
 * Surfaces through and near grids of points.
 *
 * S(u, v) = sum P[i][j] L_i(u) M_j(v), where L_i is the curve of the method through the values
 * 0, but 1 at i. So the surface passes through the points when the methods do, is as smooth
 * along u as the one and along v as the other, and is the same whichever direction comes first.
 */
#include <batten/approximate.h>
#include <batten/local.h>
#include <batten/polygon.h>
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/** What is known along the rim of a grid, for surfaces with knots at the data. */
typedef struct batten_surface_interpolate_options {
    size_t size;
    int degree_u, degree_v;            /**< 3, 3 */
    batten_parametrization parameters; /**< averaged over the rows; BATTEN_CENTRIPETAL */
    const double *given_u, *given_v;   /**< [count] (periodic [count + 1]) with BATTEN_GIVEN */
    bool knots_at_data;                /**< false: averaged knots (the default) */
    bool closed_u, closed_v;
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
} batten_surface_interpolate_options;

/** Cubic, centripetal, averaged knots; not-a-knot ends where knots are at the data. */
BATTEN_API batten_surface_interpolate_options batten_surface_interpolate_defaults(void);

/** What a grid interpolation found out about its data. */
typedef struct batten_surface_interpolate_report {
    double error;              /**< largest distance from a data point */
    double spread_u, spread_v; /**< largest |row parameter - average|, in steps; above 0.5
                                  skinning is better */
    int filled; /**< how many points were none, and stand where least energy puts them */
} batten_surface_interpolate_report;

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
 * @param points  [count_u][count_v][dimension]
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] uv  u, v: parameters of the grid lines [count_u], [count_v]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return as batten_curve_interpolate; the message names the direction
 *
 * Cost: linear in the number of points; each direction is factored once. Gaps: their number
 * times the square of those in two lines.
 * Source: [deBoor01] ch. XVII, [PT97] 9.2.5.
 */
BATTEN_API batten_status batten_surface_interpolate(
    batten_grid points, const batten_surface_interpolate_options *options,
    const batten_job *job, batten_uv_out uv, batten_surface_interpolate_report *report,
    batten_surface **out);

/* ---- twists of nets ---- */

typedef enum batten_twists {
    BATTEN_TWISTS_ZERO,     /**< right for a(u) + b(v) alone: else flat spots */
    BATTEN_TWISTS_BILINEAR, /**< mean of the twists of the adjoining quadrangles */
    BATTEN_TWISTS_BESSEL,   /**< of the biquadratic through 3 x 3 points */
    BATTEN_TWISTS_ADINI,    /**< of the bilinear Coons patch around the point */
    BATTEN_TWISTS_SPLINE,   /**< those that make a bicubic net C2 */
    BATTEN_TWISTS_ENERGY,   /**< least sum of integrals of S_uu^2 + 2 S_uv^2 + S_vv^2 */
    BATTEN_TWISTS_SELESNICK /**< from curvatures; needs `shape` */
} batten_twists;

/** What Selesnick's twists need at each point: [count_u][count_v] of each. */
typedef struct batten_twist_shape {
    const double *suu, *svv; /**< [..][3] second derivatives along the net */
    const double *gaussian;  /**< curvature, 1 / length^2 */
} batten_twist_shape;

/** A rectangular net of points and derivatives, borrowed for the call. */
typedef struct batten_net {
    int dimension;
    int count_u, count_v;
    const double *u, *v;   /**< [count_u], [count_v], increasing; 2 or more of each */
    const double *points;  /**< [count_u][count_v][dimension] */
    const double *su, *sv; /**< [count_u][count_v][dimension], the derivatives there */
} batten_net;

/**
 * Twists at the points of a rectangular net.
 *
 * @param method  which of them
 * @param given  u, v: [count_u], [count_v], increasing, 2 or more of each; points, su, sv:
 *              [count_u][count_v][d], the points and their derivatives
 * @param shape  with SELESNICK, and d = 3; else NULL
 * @param[out] twists  [count_u][count_v][d]
 * @param[out] clamped  SELESNICK: at how many points the curvature asked for cannot be, and the
 * nearest was taken; may be NULL
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, NOT_INCREASING, TOO_FEW_POINTS, TOO_LARGE, OUT_OF_MEMORY
 *
 * On the rim Adini takes the patches that are there, Bessel one-sided parabolas. Where S_u and
 * S_v are parallel Selesnick's is Adini's. Cost: linear; ENERGY factors a band matrix, count_u
 * count_v min(count_u, count_v)^2.
 * Source: [BFFH88], [AC61] for Adini's, [Selesnick81], [HS87].
 */
BATTEN_API batten_status batten_net_twists(batten_twists method, const batten_net *given,
                                           const batten_twist_shape *shape, int *clamped,
                                           double *twists);
/** A method for curves: points [count][dimension], at increasing parameters [count] (closed:
 * [count + 1]). Knots, degree and number of control points must depend on the parameters alone,
 * control points linearly on the points. */
typedef struct batten_line_method {
    batten_status (*make)(void *user, int dimension, int count, const double *points,
                          const double *parameters, batten_curve **out);
    void *user;
    bool closed; /**< the first point follows the last */
} batten_line_method;

/**
 * Parameters for the lines of a grid: in each direction from 0 to 1, the average of those that
 * its lines would have alone; lines that are a single point are left out.
 *
 * @param points  [count_u][count_v][dimension]
 * @param kind  which of them
 * @param closed_u, closed_v  also give the step from the last line back to the first
 * @param[out] spread  [2] the largest |own - average| of a line of points, in steps, in u and
 *              in v; above 0.5 skinning is better; may be NULL
 * @param[out] uv  u, v: [count_u], [count_v]; closed: one more
 * @return BATTEN_OK, BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT naming the two lines
 *
 * Cost: linear in the points.
 * Source: [PT97] 9.2.5.
 */
BATTEN_API batten_status batten_grid_parametrize(batten_grid points,
                                                 batten_parametrization kind, bool closed_u,
                                                 bool closed_v, double *spread,
                                                 batten_uv_out uv);

/**
 * The tensor product of two methods.
 *
 * @param points  [count_u][count_v][dimension], finite
 * @param uv  u, v: parameters of the grid lines, increasing; closed: one more
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] error  the largest distance of a point from the surface at its parameters; may be
 * NULL
 * @return BATTEN_OK, what the methods report (naming the line), NOT_COMPATIBLE when the curves
 * of a method have different knots, UNSUPPORTED when they are rational; BAD_ARGUMENT, TOO_FEW_POINTS, NOT_FINITE,
 * NOT_INCREASING, TOO_LARGE, CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 * Cost: count_v times the method along u, and for each control point that this gives once the method along v.
 * Source: [deBoor01] ch. XVII.
 */
BATTEN_API batten_status batten_surface_tensor(batten_grid points, batten_uv uv,
                                               const batten_line_method *const along[2],
                                               const batten_job *job, double *error,
                                               batten_surface **out);

/** Nu-splines in both directions: bicubics that are drawn into chosen grid lines. */
typedef struct batten_surface_nu_options {
    size_t size;
    bool closed_u, closed_v;
    double nu_u, nu_v;   /**< of all lines, as nu of batten_curve_weighted_options; 0 */
    const double *nus_u; /**< [count_u] line by line, instead; or NULL */
    const double *nus_v; /**< [count_v] */
    const double *u, *v; /**< parameters of the grid lines; NULL: chord lengths, averaged */
} batten_surface_nu_options;
/** The defaults of nu-spline surfaces: those beside the fields of batten_surface_nu_options. */
BATTEN_API batten_surface_nu_options batten_surface_nu_defaults(void);

/**
 * The tensor product of nu-splines with natural ends: a bicubic surface, C1. Without nu the
 * natural bicubic spline, C2.
 *
 * @param points  [count_u][count_v][dimension]
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_tensor
 *
 * Cost: linear in the points: one tridiagonal system for each line.
 * Source: [Nielson74].
 */
BATTEN_API batten_status batten_surface_nu(batten_grid points,
                                           const batten_surface_nu_options *options,
                                           const batten_job *job, batten_surface **out);

/**
 * The tensor product of curves of the class of Catmull and Rom: local, no equations.
 * @param points  [count_u][count_v][dimension]
 * @param uv  u, v: parameters of the grid lines; NULL: centripetal, averaged
 * @param along  [2], of the lines along u, along v; their alpha and `given` are not used; NULL
 *              for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] error  model units, the largest distance of a point from the surface; 0 but for
 *              rounding when both pass their points; may be NULL
 * @return as batten_surface_tensor
 *
 * Cost: linear in the points; nothing is solved.
 * Source: [CR74].
 */
BATTEN_API batten_status batten_surface_catmull_rom(
    batten_grid points, batten_uv uv, const batten_curve_catmull_rom_options *const along[2],
    const batten_job *job, double *error, batten_surface **out);
/**
 * The uniform B-spline surface of a net, with the ends of batten_curve_uniform in each
 * direction.
 * @param points [count_u][count_v][dimension]
 * @param degree_u  1 to 25
 * @param degree_v  1 to 25
 * @param ends_u  how the lines along u end
 * @param ends_v  how the lines along v end
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_tensor and batten_curve_uniform
 *
 * Cost: linear in the points; nothing is solved.
 * Source: [Coons74], [Riesenfeld73].
 */
BATTEN_API batten_status batten_surface_uniform(batten_grid points, int degree_u, int degree_v,
                                                batten_polygon_end ends_u,
                                                batten_polygon_end ends_v,
                                                batten_surface **out);

/** Splines in tension in both directions. */
typedef struct batten_surface_tension_options {
    size_t size;
    bool closed_u, closed_v;
    double tension_u, tension_v; /**< of all strips, as in batten_chain_tension_options; 0 */
    const double *tensions_u;    /**< [strips along u] strip by strip, instead; or NULL */
    const double *tensions_v;
    const double *u, *v; /**< parameters of the grid lines; NULL: chord lengths */
} batten_surface_tension_options;
/** The defaults of surfaces in tension: those beside the fields of
 * batten_surface_tension_options. */
BATTEN_API batten_surface_tension_options batten_surface_tension_defaults(void);
/**
 * The tensor product of splines in tension with natural ends: C2, of the kind "tension".
 * Without tension it is the natural bicubic spline; with very much tension bilinear patches.
 * Between the lines of the grid each strip has its own tension, so that single folds can be
 * drawn tight.
 *
 * It is not a NURBS surface; batten_surface_to_nurbs comes near it.
 *
 * @param options  NULL for the defaults
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, and as batten_chain_tension, naming the line
 * Cost: linear in the number of points; a point of the surface 16 products for each coordinate.
 * Source: [Schweikert66], [Cline74].
 */
BATTEN_API batten_status batten_surface_tension(batten_grid points,
                                                const batten_surface_tension_options *options,
                                                batten_surface **out);
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
    double error, rms;
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

typedef struct batten_surface_fit_grid_options {
    size_t size;
    int degree_u, degree_v; /**< 3, 3 */
    int points_u, points_v; /**< control points, periodic: of one period. 0: least squares one
                                 for every four lines of the grid; smoothing up to 43, at most
                                 one for every line */
    batten_parametrization parameters; /**< averaged over the rows; BATTEN_CENTRIPETAL */
    const double *given_u, *given_v;   /**< [count] (periodic [count + 1]) with BATTEN_GIVEN */
    const double *weights_u, *weights_v; /**< [count] of the lines of the grid: the weight of a
                                              datum is their product; NULL: all 1 */
    bool closed_u, closed_v;
    bool hold_rims; /**< least squares: the surface passes the four corners, and its rims are
                         the least squares of the rims' data alone; true */
    batten_grid_penalty penalty; /**< smoothing: BATTEN_GRID_ENERGY */
    int order;                   /**< of the derivatives or differences, 1..4; 2 */
    batten_smooth_by by;         /**< BATTEN_SMOOTH_BY_VALIDATION */
    double amount;               /**< lambda, or the rms */
    double tolerance; /**< least squares: > 0: control points are added, from `points_u` by
                           `points_v` (0: the fewest) on, along the direction that gains more,
                           until no datum is farther; 0 */
} batten_surface_fit_grid_options;

/** The defaults of grid fits: those beside the fields of batten_surface_fit_grid_options. */
BATTEN_API batten_surface_fit_grid_options batten_surface_fit_grid_defaults(void);
/**
 * The surface with few control points and the least sum of squared distances from a grid.
 *
 * Curves are fitted along u to the data of each line, and then along v to their control points:
 * with the weights of lines that is the least squares of the tensor product. Knots follow the
 * data ([PT97] 9.69). With `hold_rims` the corners are met, and surfaces that share the data of
 * a rim share the rim. With a tolerance the fewest control points are sought that meet it,
 * TOLERANCE_NOT_MET when none do.
 *
 * @param points  [count_u][count_v][dimension]
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] uv  u, v: parameters of the grid lines [count_u], [count_v]; may be NULL
 * @param[out] report  what was reached; may be NULL
 * @return as batten_curve_least_squares; the message names the direction; TOO_LARGE
 * Cost: linear in the number of data.
 * Source: [PT97] 9.4.4, [Dierckx93].
 */
BATTEN_API batten_status batten_surface_fit_grid(batten_grid points,
                                                 const batten_surface_fit_grid_options *options,
                                                 const batten_job *job, batten_uv_out uv,
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
 * @param options  NULL for the defaults
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] uv  the parameters of the lines; either may be NULL
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_fit_grid; BAD_ARGUMENT (order, amount), TOO_LARGE
 * Cost: the cube of the control points of a direction to begin, then for each lambda their
 * product.
 * Source: [EM96], [Dierckx93], [CW79].
 */
BATTEN_API batten_status batten_surface_smooth_grid(
    batten_grid points, const batten_surface_fit_grid_options *options, const batten_job *job,
    batten_uv_out uv, batten_surface_fit_report *report, batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
