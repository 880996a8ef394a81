#ifndef BATTEN_IMPLICIT_H
#define BATTEN_IMPLICIT_H
/**
 * @file
 * Plane curves as f(x, y) = 0: the equation of a Bezier curve, and tracing what an equation
 * says.
 */
#include <batten/inspect.h>

#ifdef __cplusplus
extern "C" {
#endif

/** Highest degree of a curve that is made implicit. */
#define BATTEN_IMPLICIT_DEGREE 8

/** The equation of a curve: a determinant whose entries are linear in x and y. Immutable. */
typedef struct batten_implicit batten_implicit;

/** How good an equation is. Where its gradient is small (at cusps and crossings it is 0) the
 * curve f = 0 is only known to `residual` / gradient. */
typedef struct batten_implicit_report {
    int degree;            /**< of f, as many times may a line meet the curve */
    double residual;       /**< largest |f| at 8 degree + 1 places of the curve, model units */
    double least_gradient; /**< smallest |gradient| at these places; the largest is 1 */
} batten_implicit_report;

/**
 * The implicit form of one plane Bezier curve, rational or not: f vanishes on the whole
 * algebraic curve that the piece belongs to, so its sign tells sides near the piece only.
 *
 * f is the determinant of Bezout's matrix in Bernstein form, in coordinates relative to the
 * middle of the curve and its size; the matrix is kept, not the expanded polynomial, which
 * would lose digits. f is scaled so that its gradient is 1 where it is largest on the curve. It
 * is checked by substitution.
 *
 * @param curve    of dimension 2 and one span; a degree that is raised is lowered again first
 * @param[out] report may be NULL
 * @return BATTEN_OK; NOT_COMPATIBLE (dimension, several spans, or a curve that is run over more
 * than once or has a point where all of X, Y and weight vanish: then f is 0 everywhere);
 * UNSUPPORTED above degree 8; TOLERANCE_NOT_MET when substitution misses by 1e-6 of the size
 *
 * Cost of a value: degree^3 / 3. Source: [SAG84], in the form of [BG04].
 */
BATTEN_API batten_status batten_implicit_of_curve(const batten_curve *curve,
                                                  batten_implicit_report *report,
                                                  batten_implicit **out);
/** NULL is welcome. */
BATTEN_API void batten_implicit_free(batten_implicit *implicit);
/** f at a point, in model units. @param[out] gradient [2], without a unit; or NULL */
BATTEN_API double batten_implicit_value(const batten_implicit *implicit, double x, double y,
                                        double *gradient);
/** The parameter of a point of the curve, also outside its domain: from the null vector of the
 * matrix.
 * @return SINGULAR_HERE where the curve crosses itself or the point is not on it (by 1e-6 of
 * its size) */
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
 * @param window    low and high x and y, low < high
 * @param cells     in either direction, 2 .. 2000
 * @param tolerance of chords, model units, > 0
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE, with the place, when a value is not finite
 * Cost: cells^2 values. Release with batten_trace_release.
 */
BATTEN_API batten_status batten_trace_field(batten_field field, const void *context,
                                            batten_box window, int cells, double tolerance,
                                            batten_trace *out);
BATTEN_API batten_status batten_implicit_trace(const batten_implicit *implicit,
                                               batten_box window, int cells, double tolerance,
                                               batten_trace *out);
BATTEN_API void batten_trace_release(batten_trace *trace);

#ifdef __cplusplus
}
#endif
#endif
