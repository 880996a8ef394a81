#ifndef BATTEN_NEAREST_H
#define BATTEN_NEAREST_H
/**
 * @file
 * Nearest points, crossings, plane sections, and lines that follow a direction on a surface.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/**
 * All places inside the domain where a curve turns back along a direction: so between them a
 * coordinate in that direction runs one way. Of a piece square to the direction none. The
 * length of `direction` does not matter; BAD_ARGUMENT when it is 0 or not finite. Complete but
 * for turns within the rounding of the control points, by Descartes' rule of signs.
 *
 * @param curve  any curve
 * @param direction  of any length but 0
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: on each the roots of a polynomial of degree p - 1, of a rational
 * curve 2 p - 2.
 */
BATTEN_API batten_status batten_curve_turns(const batten_curve *curve, batten_vec3 direction,
                                            batten_parameters *out);
/**
 * All u at which coordinate `axis` (0, 1, 2) equals `value`, by roots of the Bernstein form.
 * A coordinate that is constant on a piece gives both ends of the piece.
 *
 * @param curve  any curve
 * @param axis  0, 1 or 2, below the dimension
 * @param value  model units
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the spans: on each that reaches the value the roots of a polynomial of degree
 * p, and those of its derivative.
 */
BATTEN_API batten_status batten_curve_crossings(const batten_curve *curve, int axis,
                                                double value, batten_parameters *out);

/**
 * All u at which a curve of 2 or 3 dimensions meets the plane `normal . x = distance`, in the
 * same way.
 *
 * @param curve  of dimension 2 or 3
 * @param normal  of any length but 0
 * @param distance  of the plane from the origin, in lengths of `normal`
 * @param[out] out  release `out->at` with batten_release
 * @return as batten_curve_crossings; BAD_ARGUMENT for a normal of 0, UNSUPPORTED for a function
 *
 * Cost: as batten_curve_crossings.
 */
BATTEN_API batten_status batten_curve_plane_crossings(const batten_curve *curve,
                                                      batten_vec3 normal, double distance,
                                                      batten_parameters *out);

/**
 * Where a plane curve crosses itself: parameters in pairs u < v, so `at` is [count / 2][2].
 * Places where it touches itself, or runs along itself, may be left out; the point in which a
 * closed curve ends is none.
 *
 * @param curve  of dimension 2
 * @param[out] out  release `out->at` with batten_release
 * @return BATTEN_OK, NOT_COMPATIBLE, OUT_OF_MEMORY
 *
 * Cost: n log n for n pieces whose boxes overlap little; where many overlap, for each pair of
 * them a halving of both.
 */
BATTEN_API batten_status batten_curve_self_crossings(const batten_curve *curve,
                                                     batten_parameters *out);

/** How far points lie from a shape. */
typedef struct batten_deviation {
    double max, rms;
    int worst;    /**< index of the farthest point */
    double at[2]; /**< its foot's parameters */
} batten_deviation;

/** Where a function puts the feet of points on a surface: room of the caller's. */
typedef struct batten_feet {
    double *uv;        /**< [count][2], their parameters, or NULL */
    double *distances; /**< [count], or NULL */
} batten_feet;
/**
 * Distance of points [count][dimension] from a curve: the global minimum, ends included. Every
 * root of (C - Q) . C' is found on each span whose box comes near enough. Cost: n to begin,
 * then log n for each point that is near few of the n spans.
 * @param start [count] first guesses, or NULL: the whole curve is searched
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] distances [count], or NULL
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, OUT_OF_MEMORY
 */
BATTEN_API batten_status batten_curve_deviation(const batten_curve *curve, batten_points points,
                                                const double *start, const batten_job *job,
                                                double *distances, batten_deviation *out);
/**
 * The same for a surface, points [count][3]; start [count][2] or NULL. Descends from every
 * valley of a grid of 2 degree + 2 samples each way on each patch whose box comes near enough,
 * inside the patch first: where the surface winds between samples, a nearer point can be
 * missed.
 *
 * @param surface  in space
 * @param points  [count][3]
 * @param start  [count][2], parameters near the feet; or NULL
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] distances  [count], model units; may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, UNSUPPORTED (points of another dimension), TOO_FEW_POINTS, NOT_FINITE,
 * OUT_OF_DOMAIN, CANCELLED, OUT_OF_MEMORY
 *
 * Cost: (2 p + 2) (2 q + 2) evaluations on each patch that comes near enough, for each point;
 * chunks of 16 points are shared among threads.
 */
BATTEN_API batten_status batten_surface_deviation(const batten_surface *surface,
                                                  batten_points points, const double *start,
                                                  const batten_job *job, double *distances,
                                                  batten_deviation *out);

/**
 * The same, and where the feet are.
 * @param surface  in space
 * @param points  [count][3]
 * @param start  [count][2], parameters near the feet; or NULL
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param feet  uv: [count][2], distances: [count]; each may be NULL
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_deviation
 *
 * Cost: as batten_surface_deviation.
 */
BATTEN_API batten_status batten_surface_project(const batten_surface *surface,
                                                batten_points points, const double *start,
                                                const batten_job *job, batten_feet feet,
                                                batten_deviation *out);

/** A polyline in space. */
typedef struct batten_polyline {
    int count;
    bool closed;
    double *points;     /**< [count][3] */
    double *parameters; /**< [count][2], u and v on the surface */
} batten_polyline;
typedef struct batten_polylines {
    int count;
    batten_polyline *lines;
} batten_polylines;
/**
 * Where a surface meets the plane `normal . x = distance`, found along isoparametric lines on a
 * `cells_u` x `cells_v` grid (every point is on the surface, and on the plane to rounding,
 * coarser only where knots nearly coincide; loops smaller than a cell can be missed). Across
 * the seam of a closed surface a line continues, and its parameters jump. A rim of the surface
 * that lies in the plane belongs to the section; a line in its inside where the plane only
 * touches does not.
 *
 * @param surface  in space
 * @param normal  of any length but 0
 * @param distance  of the plane from the origin, in lengths of `normal`
 * @param cells_u, cells_v  of the grid, 1 or more
 * @param[out] out  release with batten_polylines_release
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, NOT_COMPATIBLE, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: about 2 cells_u cells_v crossings of isoparametric lines, and one evaluation for each
 * node.
 */
BATTEN_API batten_status batten_surface_section(const batten_surface *surface,
                                                batten_vec3 normal, double distance,
                                                int cells_u, int cells_v,
                                                batten_polylines *out);
/**
 * Release all polylines and their row.
 *
 * @param lines  of batten_surface_section
 */
BATTEN_API void batten_polylines_release(batten_polylines *lines);

/* ---- lines that follow a direction ---- */

typedef enum batten_line_kind {
    BATTEN_LINE_CURVATURE1,  /**< of curvature: along the direction of the larger one */
    BATTEN_LINE_CURVATURE2,  /**< of the smaller one */
    BATTEN_LINE_ASYMPTOTIC1, /**< without normal curvature, turned from the first principal
                                  direction to the left as seen from the end of the normal */
    BATTEN_LINE_ASYMPTOTIC2, /**< turned to the right */
    BATTEN_LINE_GEODESIC     /**< straight on the surface */
} batten_line_kind;

/** Why a line ends. */
typedef enum batten_line_end {
    BATTEN_LINE_AT_LENGTH,    /**< it is as long as was asked for */
    BATTEN_LINE_CLOSED,       /**< it is back at its start */
    BATTEN_LINE_AT_RIM,       /**< of the surface */
    BATTEN_LINE_AT_UMBILIC,   /**< both principal curvatures are equal, and have no direction */
    BATTEN_LINE_AT_PARABOLIC, /**< the Gaussian curvature is not below 0 beyond: no asymptotic
                                   direction */
    BATTEN_LINE_AT_SINGULAR   /**< a pole, or a crease: no direction is known beyond */
} batten_line_end;

/** Where a line starts, and how far it goes. */
typedef struct batten_line_start {
    batten_line_kind kind;
    double u, v;
    batten_vec3
        direction; /**< of geodesics: laid into the tangent plane; others go both ways */
    double length; /**< most, of each way; 0: ten times the size of the surface */
} batten_line_start;

/** Release with batten_surface_line_release. */
typedef struct batten_surface_line {
    batten_polyline line;
    double *arms; /**< [line.count][2][3]: the control points before and after each point of
                       cubics, as of a contour; their speed at the points is 1 by length */
    double length;
    double error; /**< how far two integrations, the second 32 times as fine, are apart, and
                       cubics from their line at their middles */
    batten_line_end
        ends[2]; /**< before its first point, behind its last; of geodesics the first
                                  is BATTEN_LINE_AT_LENGTH */
} batten_surface_line;

/**
 * A line of curvature, an asymptotic line or a geodesic of a surface, from one of its points.
 *
 * Integrated by length with steps of the fourth order, doubled and held to a part of the tolerance; at the rim
 * cut exactly; across the seam of a closed surface it continues. It is integrated once more with a 32nd of the
 * error, and so on up to 4 times, until both agree within the tolerance.
 *
 * @param surface  in space
 * @param start  kind, place in the domain, direction and length
 * @param tolerance  model units, above 0
 * @param job  progress, cancelling; NULL for no questions
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; NOT_COMPATIBLE (no surface in space), BAD_ARGUMENT (kind, tolerance, length), OUT_OF_DOMAIN,
 * NOT_FINITE; SINGULAR_HERE where the start has no such direction, and why; TOLERANCE_NOT_MET with what was
 * reached; TOO_LARGE (more than 100,000 points), CANCELLED, INCOMPLETE, OUT_OF_MEMORY
 *
 * Cost: 12 evaluations to order 2 for each point, twice or more.
 * Source: [PM02] for the equations.
 */
BATTEN_API batten_status batten_surface_line_from(const batten_surface *surface,
                                                  const batten_line_start *start,
                                                  double tolerance, const batten_job *job,
                                                  batten_surface_line *out);
/** Release a line, and empty it. */
BATTEN_API void batten_surface_line_release(batten_surface_line *line);

#ifdef __cplusplus
}
#endif
#endif
