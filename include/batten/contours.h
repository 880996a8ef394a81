#ifndef BATTEN_CONTOURS_H
#define BATTEN_CONTOURS_H
/**
 * @file
 * Scalar fields on surfaces (height, curvature, light), and the lines along which they have a
 * given value.
 */
#include <batten/inspect.h>
#include <batten/job.h>
#include <batten/triangles.h>

#ifdef __cplusplus
extern "C" {
#endif

/** n is the unit normal, along Su x Sv; a reversed surface turns the sign of every field that
 * has n, or H or a principal curvature, in it. */
typedef enum batten_field_kind {
    BATTEN_FIELD_HEIGHT,     /**< direction . S, model units */
    BATTEN_FIELD_GAUSSIAN,   /**< K, 1 / length^2 */
    BATTEN_FIELD_MEAN,       /**< H, 1 / length */
    BATTEN_FIELD_KAPPA1,     /**< the larger principal curvature, 1 / length */
    BATTEN_FIELD_KAPPA2,     /**< the smaller one */
    BATTEN_FIELD_ISOPHOTE,   /**< n . direction: with the direction of the eye, level 0 is the
                                  silhouette; with that of light its lines are the isophotes */
    BATTEN_FIELD_DRAFT,      /**< asin(n . direction), radians; `direction`: that of the pull */
    BATTEN_FIELD_HIGHLIGHT,  /**< signed distance of the normal line from the light line through
                                  `point` along `direction`, model units */
    BATTEN_FIELD_REFLECTION, /**< the same of the ray from `eye` that the surface reflects;
                                  `eye` is the direction towards the one who looks. Both have no
                                  value where the lines are within 6 degrees of parallel */
    BATTEN_FIELD_SILHOUETTE  /**< n . (point - S) / |point - S|: level 0 is the outline as seen
                                  from `point` */
} batten_field_kind;

/** Directions need not be unit vectors, only not 0. */
typedef struct batten_surface_field {
    batten_field_kind kind;
    batten_vec3 direction, point, eye; /**< as the kind says */
} batten_surface_field;

/**
 * A field at points of a surface in space.
 * @param uv [count][2]
 * @param[out] values [count]; NaN where the surface is singular
 * @return BATTEN_OK, NOT_COMPATIBLE (no surface in space), BAD_ARGUMENT (direction 0),
 * NOT_FINITE, OUT_OF_DOMAIN, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: one evaluation to order 3, and 2 microseconds, for each point.
 * Source: [BeiChen94] for highlight lines, [Farin02] ch. 23 for the others.
 */
BATTEN_API batten_status batten_surface_field_values(const batten_surface *surface,
                                                     const batten_surface_field *field,
                                                     size_t count, const double *uv,
                                                     double *values);

typedef enum batten_critical_kind {
    BATTEN_CRITICAL_LEAST,
    BATTEN_CRITICAL_SADDLE,
    BATTEN_CRITICAL_GREATEST
} batten_critical_kind;

/** A point where the field stands still: here lines of its level appear, vanish, or cross. */
typedef struct batten_critical {
    batten_critical_kind kind;
    double value;
    double u, v;
    batten_vec3 point;
} batten_critical;

typedef struct batten_contour {
    int level;            /**< which of the levels */
    batten_polyline line; /**< `count` points; a closed one does not repeat the first */
    double *arms;         /**< NULL for chords. [count][2][3] of smooth contours: the control
                               points before and after each point; between points i and i + 1
                               stands the cubic with the inner control points arms[i][1] and
                               arms[i + 1][0] */
} batten_contour;

typedef struct batten_contours {
    int count;
    batten_contour *lines; /**< by increasing level */
    int critical_count;
    batten_critical *critical; /**< inside smooth pieces, isolated and not degenerate */
    double least, greatest;    /**< of the field at the nodes where it was sampled */
    double error;              /**< largest distance found between a chord, or a cubic, and the
                                    contour */
} batten_contours;

/**
 * The lines along which a field has the given values, in space and in (u, v).
 *
 * Each smooth piece (between knot lines) is cut into triangles, finer where the field bends or
 * where levels would be missed along an edge; points where the field stands still become nodes.
 * Where the field changes sides along an edge its crossing is found on the true surface to
 * rounding; between crossings points are added, by Newton's method on the surface, until chords
 * are within `tolerance` at their middles. So lines are closed or end on a rim, and lines of
 * one level that meet in a saddle run straight through it. Nodes on a level count as above it.
 * A feature smaller than an edge of a triangle with no critical point inside can be missed.
 * Across a line on which a field jumps (curvature, at a knot) contours follow the jump.
 *
 * @param levels [level_count], increasing
 * @param tolerance model units, above 0
 * @return BATTEN_OK, NOT_COMPATIBLE (no surface in space), BAD_ARGUMENT (direction 0, tolerance
 * not above 0), TOLERANCE_NOT_MET (a tolerance below 1e-11 of the diagonal of the surface: its
 * points are not known so well), NOT_FINITE, NOT_INCREASING, TOO_LARGE (more than a million
 * triangles, or chords, whose number goes with 1 / sqrt(tolerance) and is estimated first),
 * CANCELLED, INCOMPLETE, OVERFLOW, OUT_OF_MEMORY
 *
 * Cost: linear in spans and in what is drawn; 16 to 1024 triangles for each span.
 */
BATTEN_API batten_status batten_surface_contours(const batten_surface *surface,
                                                 const batten_surface_field *field,
                                                 int level_count, const double *levels,
                                                 double tolerance, const batten_job *job,
                                                 batten_contours *out);
/** The same with cubics instead of chords, for small tolerances: their number goes with the
 * fourth root. Each has the tangents of the contour at its ends and is measured at 3 places. */
BATTEN_API batten_status batten_surface_smooth_contours(const batten_surface *surface,
                                                        const batten_surface_field *field,
                                                        int level_count, const double *levels,
                                                        double tolerance, const batten_job *job,
                                                        batten_contours *out);
/** The same on Bezier triangles in space: lines go on from one to the next where they share
 * both corners of an edge. `parameters` are the barycentric coordinates of corners 1 and 2,
 * each in the triangle that the point was found in; those of critical points too. TOO_LARGE
 * likewise. */
BATTEN_API batten_status batten_triangles_contours(const batten_triangles *triangles,
                                                   const batten_surface_field *field,
                                                   int level_count, const double *levels,
                                                   double tolerance, const batten_job *job,
                                                   batten_contours *out);
BATTEN_API batten_status batten_triangles_smooth_contours(
    const batten_triangles *triangles, const batten_surface_field *field, int level_count,
    const double *levels, double tolerance, const batten_job *job, batten_contours *out);
BATTEN_API void batten_contours_release(batten_contours *contours);

#ifdef __cplusplus
}
#endif
#endif
