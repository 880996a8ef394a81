#ifndef BATTEN_CONTOURS_H
#define BATTEN_CONTOURS_H
/**
 * @file
 * Scalar fields on surfaces (height, curvature, light), and the lines along which they have a
 * given value; the curves of equations F(x, y) = 0 and F = G = 0.
 */
#include <batten/nearest.h>
#include <batten/standard.h>
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
    BATTEN_FIELD_SILHOUETTE, /**< n . (point - S) / |point - S|: level 0 is the outline as seen
                                  from `point` */
    BATTEN_FIELD_ABSOLUTE,   /**< |kappa1| + |kappa2|, 1 / length */
    BATTEN_FIELD_ZEBRA       /**< r . direction, of the ray r = 2 (eye . n) n - eye that the
                                  surface reflects: equal steps of it are the edges of stripes */
} batten_field_kind;

/** Directions need not be unit vectors, only not 0. */
typedef struct batten_surface_field {
    batten_field_kind kind;
    batten_vec3 direction, point, eye; /**< as the kind says */
} batten_surface_field;

/** The values whose contours are wanted, borrowed for the call. */
typedef struct batten_levels {
    int count;
    const double *at; /**< [count] */
} batten_levels;

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
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  the result; as it was when the function fails
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
                                                 batten_levels levels, double tolerance,
                                                 const batten_job *job, batten_contours *out);
/**
 * The same with cubics instead of chords, for small tolerances: their number goes with the
 * fourth root. Each has the tangents of the contour at its ends and is measured at 3 places.
 *
 * @param surface  any surface
 * @param field  what the lines are of: height, curvature, light ...
 * @param levels  [count], increasing
 * @param tolerance  model units, above 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_contours
 *
 * Cost: as batten_surface_contours; each cubic is measured at 3 places.
 */
BATTEN_API batten_status batten_surface_smooth_contours(const batten_surface *surface,
                                                        const batten_surface_field *field,
                                                        batten_levels levels, double tolerance,
                                                        const batten_job *job,
                                                        batten_contours *out);
/**
 * The same on Bezier triangles in space: lines continue from one to the next where they share
 * both corners of an edge. `parameters` are the barycentric coordinates of corners 1 and 2,
 * each in the triangle that the point was found in; those of critical points too. TOO_LARGE
 * likewise.
 *
 * @param triangles  in space
 * @param field  what the lines are of: height, curvature, light ...
 * @param levels  [count], increasing
 * @param tolerance  model units, above 0
 * @param job  threads, progress, cancelling; NULL for one thread and no questions
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, NOT_INCREASING, BAD_ARGUMENT, NOT_COMPATIBLE,
 * TOLERANCE_NOT_MET, TOO_LARGE, OUT_OF_MEMORY
 *
 * Cost: linear in the triangles and in what is drawn; 16 to 1024 flat pieces for each.
 */
BATTEN_API batten_status batten_triangles_contours(const batten_triangles *triangles,
                                                   const batten_surface_field *field,
                                                   batten_levels levels, double tolerance,
                                                   const batten_job *job, batten_contours *out);

/**
 * The contours of a field over Bezier triangles, as batten_surface_smooth_contours.
 *
 * @param triangles  of dimension 3, or 1 over a domain
 * @param field  what the lines are of: height, curvature, light ...
 * @param levels  [count], increasing
 * @param tolerance  model units, above 0
 * @param job  threads, progress, cancelling; NULL for one thread
 * @param[out] out  release with batten_contours_release
 * @return as batten_triangles_contours
 *
 * Cost: as batten_triangles_contours.
 */
BATTEN_API batten_status batten_triangles_smooth_contours(
    const batten_triangles *triangles, const batten_surface_field *field, batten_levels levels,
    double tolerance, const batten_job *job, batten_contours *out);
/** Release contours, and empty them. */
BATTEN_API void batten_contours_release(batten_contours *contours);
/** Highest degree of a curve that is made implicit. */
#define BATTEN_IMPLICIT_DEGREE 8

/** The equation of a curve: a determinant whose entries are linear in x and y. Immutable. */
typedef struct batten_implicit batten_implicit;

/** How good an equation is. Where its gradient is small (at cusps and crossings it is 0) the
 * curve f = 0 is only known to `residual` / gradient. */
typedef struct batten_implicit_from_curve_report {
    int degree;            /**< of f, as many times may a line meet the curve */
    double error;          /**< largest |f| at 8 degree + 1 places of the curve, model units */
    double least_gradient; /**< smallest |gradient| at these places; the largest is 1 */
} batten_implicit_from_curve_report;

/**
 * The implicit form of one plane Bezier curve, rational or not: f vanishes on the whole
 * algebraic curve that the piece belongs to, so its sign tells sides near the piece only.
 *
 * f is the determinant of Bezout's matrix in Bernstein form, in coordinates relative to the
 * middle of the curve and its size; the matrix is kept, not the expanded polynomial, which
 * would lose digits. f is scaled so that its gradient is 1 where it is largest on the curve. It
 * is checked by substitution.
 *
 * @param curve  of dimension 2 and one span; a degree that was raised is lowered again first
 * @param[out] report  what was reached; may be NULL
 * @param[out] out  release with batten_implicit_free
 * @return BATTEN_OK; NOT_COMPATIBLE (dimension, several spans, or a curve that is run over more
 * than once or has a point where all of X, Y and weight vanish: then f is 0 everywhere);
 * UNSUPPORTED above degree 8; TOLERANCE_NOT_MET when substitution misses by 1e-6 of the size
 *
 *
 * Cost: n^2 entries for degree n, and 8 n + 1 values to check it, each of n^3 / 3
 * multiplications, as later calls of batten_implicit_value.
 * Source: [SAG84], in the form of [BG04].
 */
BATTEN_API batten_status batten_implicit_from_curve(const batten_curve *curve,
                                                    batten_implicit_from_curve_report *report,
                                                    batten_implicit **out);
/**
 * Release an implicit form; NULL is welcome.
 *
 * @param implicit  of batten_implicit_from_curve, or NULL
 */
BATTEN_API void batten_implicit_free(batten_implicit *implicit);
/**
 * f at a point, in model units.
 * @param implicit  of batten_implicit_from_curve
 * @param x, y  model units
 * @param[out] gradient [2], without a unit; or NULL
 */
BATTEN_API double batten_implicit_value(const batten_implicit *implicit, double x, double y,
                                        double *gradient);
/**
 * The parameter of a point of the curve, also outside its domain: from the null vector of the
 * matrix.
 *
 * @param implicit  of batten_implicit_from_curve
 * @param x, y  model units
 * @param[out] u  in the parameter of the curve, also beyond its domain
 * @return BATTEN_OK; SINGULAR_HERE where the curve crosses itself or the point is not on it (by
 * 1e-6 of its size)
 *
 * Cost: degree^3 / 3 multiplications; no allocation.
 */
BATTEN_API batten_status batten_implicit_invert(const batten_implicit *implicit, double x,
                                                double y, double *u);

/* ---- tracing ---- */

/** The value of a function of the plane, and its gradient [2]. */
typedef double (*batten_field)(const void *context, double x, double y, double *gradient);

typedef enum batten_singular_kind {
    BATTEN_SINGULAR_CROSSING, /**< two branches with two directions */
    BATTEN_SINGULAR_ISOLATED, /**< a point alone */
    BATTEN_SINGULAR_CUSP      /**< neither, to rounding: a cusp, or branches that touch */
} batten_singular_kind;
/** A place where value and gradient vanish. */
typedef struct batten_singular_point {
    double x, y;
    batten_singular_kind kind; /**< by the sign of the Hessian's determinant */
} batten_singular_point;

/** Curves on which a field is 0. */
typedef struct batten_trace {
    batten_polylines lines; /**< points in the plane z = 0; `parameters` is NULL */
    int singular_count;
    batten_singular_point *singular;
} batten_trace;

/**
 * Trace f(x, y) = 0 in a window: changes of sign on the edges of a grid are refined and linked
 * through its cells; between them points are set on the curve by Newton's method until chords
 * are within `tolerance`. Branches that no grid line meets are not found, and where two
 * branches come nearer than a cell they may be linked the wrong way.
 * @param field  what is drawn
 * @param context  handed to the field as it is
 * @param window    low and high x and y, low < high
 * @param cells     in either direction, 2 .. 2000
 * @param tolerance of chords, model units, > 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE, with the place, when a value is not finite
 * Cost: cells^2 values. Release with batten_trace_release.
 */
BATTEN_API batten_status batten_trace_field(batten_field field, const void *context,
                                            batten_box window, int cells, double tolerance,
                                            batten_trace *out);

/**
 * The zeros of an implicit curve in a window, as batten_trace_field.
 *
 * @param implicit  as made by batten_implicit_from_curve
 * @param window  of x and y
 * @param cells  of the grid along the longer side
 * @param tolerance  model units, above 0
 * @param[out] out  release with batten_trace_release
 * @return as batten_trace_field
 *
 * Cost: as batten_trace_field.
 */
BATTEN_API batten_status batten_implicit_trace(const batten_implicit *implicit,
                                               batten_box window, int cells, double tolerance,
                                               batten_trace *out);
/** Release a trace, and empty it. */
BATTEN_API void batten_trace_release(batten_trace *trace);

/* ---- surfaces and curves of equations; see also standard.h ---- */

/**
 * The surface of three expressions in two variables u, v.
 *
 * A quintic spline in both directions, C4, through points at even steps of u and v, twice as many until
 * the error is proved: on each cell, by the sixth derivatives, enclosed by intervals, and the errors measured at
 * 6 x 6 Chebyshev nodes. The parameters are u and v.
 *
 * @param coordinates  [3], each in two variables
 * @param range  [2], of u and v, a < b, finite
 * @param tolerance  model units, above 0
 * @param job  progress, cancelling, threads; NULL for none
 * @param[out] error  the largest distance of points of equal parameters, proved
 * @param[out] out  the surface; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE; OUT_OF_DOMAIN (no value, or a pole: the message says where);
 * TOLERANCE_NOT_MET (with 200 points in one direction: corners, roots); CANCELLED, INCOMPLETE (work limit);
 * OUT_OF_MEMORY
 *
 * Cost: linear in cells, 36 evaluations for each.
 * Source: [MKC09]; the Lebesgue constant of Chebyshev nodes, [Davis75] 2.4.
 */
BATTEN_API batten_status batten_surface_parametric(const batten_equation *const *coordinates,
                                                   const batten_interval range[2],
                                                   double tolerance, const batten_job *job,
                                                   double *error, batten_surface **out);

/**
 * A helix about the z axis, or a spiral on a cone.
 *
 * It begins at (radius, 0, 0) and turns counter-clockwise as it rises. Its parameter is the angle over a turn.
 *
 * @param radius  at the start and at the end, above or at 0, not both 0
 * @param pitch  how far it rises in a turn; negative: a left-handed helix that falls
 * @param turns  how many, above 0, up to 10,000
 * @param tolerance  model units, above 0
 * @param[out] error  proved
 * @param[out] out  the curve, C2; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE; as batten_curve_parametric
 *
 * Cost: linear in turns.
 * Source: [MKC09].
 */
BATTEN_API batten_status batten_curve_helix(batten_interval radius, double pitch, double turns,
                                            double tolerance, double *error,
                                            batten_curve **out);

/**
 * All of the plane curve F(x, y) = 0, or of the space curve F(x, y, z) = G(x, y, z) = 0, in a box.
 *
 * The box is cut in two again and again. A part goes when intervals prove that it has no point of
 * the curve; it is understood when they prove that the curve is a graph over one axis there, and where it
 * crosses each side. So no branch and no loop is missed, however small. What is never understood
 * clusters about singular points, and becomes one once the cluster is smaller than the tolerance;
 * larger ones (double lines, curves that touch along a line) are listed as undecided. Pieces of
 * branches become cubics, C1, as few as are proved to be within the tolerance.
 *
 * The box is grown by at most the tolerance, so that curves that touch it from inside belong to it as a
 * whole. Chains are cut at nodes only where branches cannot be paired by their directions.
 *
 * @param equation_count  1: in the plane, 2: in space
 * @param equations  [equation_count], each in equation_count + 1 variables
 * @param box  low < high in each of the equation_count + 1 coordinates
 * @param tolerance  model units, above 0
 * @param job  progress, cancelling, work limit in boxes; NULL for none
 * @param[out] out  curves, closed ones with equal ends; with INCOMPLETE what was found; else as it was
 *                  when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE; TOLERANCE_NOT_MET (below 1e-12 of the box); INCOMPLETE
 * (undecided boxes: the message says how many and where); CANCELLED; OUT_OF_MEMORY
 *
 * Cost: for each piece some 10 boxes in the plane and 100 in space, with n + 1 evaluations each.
 * Source: [SW05] subdivision; [Neumaier90] interval Newton.
 */
BATTEN_API batten_status batten_curves_implicit(int equation_count,
                                                const batten_equation *const *equations,
                                                const batten_box *box, double tolerance,
                                                const batten_job *job,
                                                batten_equation_curves *out);

#ifdef __cplusplus
}
#endif
#endif
