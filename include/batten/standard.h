#ifndef BATTEN_STANDARD_H
#define BATTEN_STANDARD_H
/**
 * @file
 * The classical shapes as exact NURBS; curves and surfaces by their equations, y = f(x),
 * [x(t), y(t), z(t)], within an error that interval arithmetic proves.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- curves ---- */

/**
 * The segment from a to b, in `dimension` coordinates, degree 1, domain [0, 1].
 *
 * @param a, b  [dimension], apart or not
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_line(int dimension, const double *a, const double *b,
                                           batten_curve **out);
/**
 * A polyline through points [count][dimension], degree 1; knots by chord length.
 *
 * @param points  [count][dimension], neighbours apart, count >= 2
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, TOO_FEW_POINTS, NOT_FINITE, COINCIDENT, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in count.
 */
BATTEN_API batten_status batten_curve_polyline(batten_points points, batten_curve **out);
/**
 * An arc in the plane about (0, 0), from angle 0 counter-clockwise to `angle`, in (0, 2 pi];
 * degree 2, ceil(angle / 90 degrees) pieces, domain [0, 1].
 *
 * @param radius  model units, above 0
 * @param angle  radians, in (0, 2 pi]
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_arc(double radius, double angle, batten_curve **out);
/**
 * An arc in space in the xy-plane of `frame`, from `start` to `start + angle` radians.
 *
 * @param frame  its origin is the centre; it is made orthonormal
 * @param radius  model units, above 0
 * @param start  radians
 * @param angle  radians, in (0, 2 pi]
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_arc_in(const batten_frame *frame, double radius,
                                             double start, double angle, batten_curve **out);
/**
 * The arc through three points of the plane or space.
 *
 * @param dimension  2 or 3
 * @param a  the start, [dimension]
 * @param b  a point between, [dimension]
 * @param c  the end, [dimension]
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, COINCIDENT, BAD_ARGUMENT, SINGULAR_SYSTEM (the points lie on a
 * line), OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_arc_through(int dimension, const double *a,
                                                  const double *b, const double *c,
                                                  batten_curve **out);

/** How a full circle is written down. */
typedef enum batten_circle_form {
    BATTEN_CIRCLE_SQUARE_9,   /**< nine points, the corners and mid-sides of a square */
    BATTEN_CIRCLE_TRIANGLE_7, /**< seven points on a triangle */
    BATTEN_CIRCLE_SQUARE_7    /**< seven points on a square, two halves */
} batten_circle_form;

/**
 * A full circle about (0, 0) in the plane, domain [0, 1].
 *
 * @param radius  model units, above 0
 * @param form  how it is written down
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_circle(double radius, batten_circle_form form,
                                             batten_curve **out);

/**
 * An arc of the ellipse x = a cos w, y = b sin w in the plane.
 *
 * @param a, b  half axes, above 0
 * @param start  the first angle w, radians
 * @param angle  how far w goes, in (0, 2 pi]
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_ellipse(double a, double b, double start, double angle,
                                              batten_curve **out);
/**
 * The rational quadratic from a to c with end tangents that meet in b, and shoulder weight w:
 * below 1 an ellipse, 1 a parabola, above 1 a hyperbola.
 *
 * @param dimension  1, 2 or 3
 * @param a  the start, [dimension]
 * @param b  where the end tangents meet, [dimension]
 * @param c  the end, [dimension]
 * @param w  above 0
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_curve_create
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_conic(int dimension, const double *a, const double *b,
                                            const double *c, double w, batten_curve **out);
/**
 * The same, through a further point of the plane inside the triangle a b c.
 *
 * @param a  the start
 * @param b  where the end tangents meet
 * @param c  the end
 * @param q  the further point, inside the triangle
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT (q), SINGULAR_SYSTEM (a triangle without area),
 * OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_conic_through(batten_vec2 a, batten_vec2 b, batten_vec2 c,
                                                    batten_vec2 q, batten_curve **out);
/**
 * The conic arc through five points of the plane, in their order along it.
 * @param points  [5][2], in their order along the conic
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, UNSUPPORTED (dimension), BAD_ARGUMENT (not five), NOT_FINITE, COINCIDENT,
 * SINGULAR_SYSTEM
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_curve_conic_five(batten_points points, batten_curve **out);

/* ---- surfaces ---- */

/**
 * The bilinear surface of four corners, over [0, 1] x [0, 1].
 *
 * @param p00  S(0, 0), model units
 * @param p10  S(1, 0)
 * @param p01  S(0, 1)
 * @param p11  S(1, 1)
 * @param[out] out  the result; as it was when the function fails
 * @return as batten_surface_create
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_bilinear(batten_vec3 p00, batten_vec3 p10,
                                                 batten_vec3 p01, batten_vec3 p11,
                                                 batten_surface **out);
/**
 * Turn a profile about the axis through `origin` by `angle` in (0, 2 pi] radians; u runs
 * around, v along the profile. A profile that crosses the axis is refused, one that touches it
 * has a pole.
 *
 * @param profile  in space
 * @param origin  of the axis
 * @param axis  its direction, of any length but 0
 * @param angle  radians
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: linear in the control points of the profile, times 2 for each started quarter turn and
 * 1.
 */
BATTEN_API batten_status batten_surface_revolved(const batten_curve *profile,
                                                 batten_vec3 origin, batten_vec3 axis,
                                                 double angle, batten_surface **out);
/**
 * A cylinder about the z-axis of `frame`, from its origin up; u runs around, v up.
 *
 * @param frame  where it stands; it is made orthonormal
 * @param radius  model units, above 0
 * @param height  model units, above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_cylinder(const batten_frame *frame, double radius,
                                                 double height, batten_surface **out);
/**
 * A cone about the z-axis of `frame`: radius r0 at the origin and r1 at `height`; one of them
 * may be 0. u runs around, v up.
 *
 * @param frame  where it stands
 * @param r0, r1  model units, 0 or more
 * @param height  model units, above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_cone(const batten_frame *frame, double r0, double r1,
                                             double height, batten_surface **out);

/**
 * The sphere about the origin of a frame; u around its z-axis, v from the south pole up.
 *
 * @param frame  NULL is not allowed; batten_frame_world() is the world
 * @param radius  model units, above 0
 * @param[out] out  the result, one reference, which is yours
 * @return BATTEN_OK, BAD_ARGUMENT, NOT_FINITE, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_sphere(const batten_frame *frame, double radius,
                                               batten_surface **out);
/**
 * x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1 in the frame; its poles are on the z-axis.
 *
 * @param frame  where it stands
 * @param a, b, c  half axes, model units, above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_ellipsoid(const batten_frame *frame, double a, double b,
                                                  double c, batten_surface **out);
/**
 * z = height (x^2 / a^2 + y^2 / b^2), from the pole at the origin up to the rim with half axes
 * a and b.
 *
 * @param frame  where it stands
 * @param a, b  half axes of the rim, model units, above 0
 * @param height  model units, above 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_paraboloid(const batten_frame *frame, double a,
                                                   double b, double height,
                                                   batten_surface **out);
/**
 * The hyperboloid of one sheet x^2 / a^2 + y^2 / b^2 - z^2 / c^2 = 1 from z = low to z = high;
 * v runs along one family of its straight lines.
 *
 * @param frame  where it stands
 * @param a, b, c  half axes, model units, above 0
 * @param height  low and high, model units, low < high
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_hyperboloid(const batten_frame *frame, double a,
                                                    double b, double c, batten_interval height,
                                                    batten_surface **out);
/**
 * The torus about the z-axis of `frame`, its tube in the xy-plane.
 *
 * @param frame  where it stands
 * @param major, minor  radii, model units, major > minor > 0
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant.
 */
BATTEN_API batten_status batten_surface_torus(const batten_frame *frame, double major,
                                              double minor, batten_surface **out);

/**
 * The bicubic patch through sixteen points, at the parameters 0, 1/3, 2/3 and 1 of both directions.
 *
 * @param points  [4][4][3], the second index along v
 * @param[out] out  the result, a Bezier patch over the unit square; as it was when the function fails
 * @return BATTEN_OK, NOT_FINITE naming the point, OUT_OF_MEMORY
 *
 * Cost: constant.
 * Source: [Utah74] paper 13.
 */
BATTEN_API batten_status batten_surface_sixteen_points(const double *points,
                                                       batten_surface **out);

/* ---- curves and surfaces by equations ---- */

/** An expression in up to three variables, read from a text; immutable. */
typedef struct batten_equation batten_equation;
/** A name that stands for a number. */
typedef struct batten_equation_constant {
    const char *name;
    double value;
} batten_equation_constant;
/** What names mean in an expression; borrowed for the call. */
typedef struct batten_equation_names {
    int variable_count, constant_count;
    const char *const *variables; /**< [variable_count], 1 to 3 */
    const batten_equation_constant *constants; /**< [constant_count] */
} batten_equation_names;
/**
 * Read an expression: numbers, variables, constants, pi, + - * / ^ ( ), sin cos tan asin acos
 * atan (radians), sinh cosh tanh, exp ln log10 sqrt abs, and min max of two. a^b^c is a^(b^c),
 * -a^2 is -(a^2). "F = G" is F - G. Numbers are the nearest doubles.
 *
 * @param text  the expression
 * @param names  variables and constants; a variable hides a constant of its name
 * @param[out] out  the expression; the caller frees it
 * @return BATTEN_OK; BAD_FORMAT with what is expected where; BAD_ARGUMENT (no variable, more than three);
 * NOT_FINITE (a constant); TOO_LARGE (over 2000 operations, 24 values that wait); OUT_OF_MEMORY
 * Cost: linear in the text.
 */
BATTEN_API batten_status batten_equation_read(const char *text,
                                              const batten_equation_names *names,
                                              batten_equation **out);
/** Free `equation`; NULL is welcome. */
BATTEN_API void batten_equation_free(batten_equation *equation);

/**
 * The value of an expression.
 * @param equation  any expression
 * @param at  [variable_count], finite
 * @param[out] value  the value, to rounding
 * @param[out] error  how far the true value may be from it; may be NULL
 * @return BATTEN_OK; OUT_OF_DOMAIN where it has no value or an unbounded one (1 / 0, ln 0)
 * Cost: linear in the operations.
 */
BATTEN_API batten_status batten_equation_value(const batten_equation *equation,
                                               const double *at, double *value, double *error);

/** What is special at a point. */
typedef enum batten_equation_point_kind {
    BATTEN_EQUATION_NODE,     /**< branches cross, up to the tolerance */
    BATTEN_EQUATION_ISOLATED, /**< the equation holds, or nearly, at this point alone */
    BATTEN_EQUATION_SINGULAR, /**< the gradient vanishes, and it is neither: a cusp, say */
    BATTEN_EQUATION_HALT,     /**< a parametric curve may stand still */
    BATTEN_EQUATION_CORNER    /**< a curve has no derivative */
} batten_equation_point_kind;
typedef struct batten_equation_point {
    batten_equation_point_kind kind;
    batten_vec3 point;
    double parameter; /**< of a parametric curve */
    int branches;     /**< of an implicit one: how many ends of branches meet here */
} batten_equation_point;
/** Curves that equations describe. */
typedef struct batten_equation_curves {
    int count;
    batten_curve **curves; /**< [count] */
    int point_count;
    batten_equation_point *points; /**< [point_count] what is special */
    int undecided_count;
    batten_box *undecided; /**< [undecided_count] boxes in which there may be more */
    double error;          /**< proved: the largest distance of true curves, outside of undecided
                                boxes, from these and the points, or the other way round */
    int boxes;             /**< how many boxes or intervals were examined */
} batten_equation_curves;

/** Release what belongs to `curves`. */
BATTEN_API void batten_equation_curves_release(batten_equation_curves *curves);

/**
 * The curve of 1 to 3 expressions in one variable t, which is its parameter.
 *
 * Quintic pieces with two derivatives at both ends; t is halved until the sixth derivative, enclosed by
 * intervals, proves that each is near enough: C2, exact for polynomials up to degree 5. Where a derivative
 * fails (|t| at 0, a root at its end) short chords replace them, and the place is among the points.
 *
 * @param dimension  1 to 3
 * @param coordinates  [dimension], each in one variable
 * @param range  of t, a < b, finite
 * @param tolerance  model units, above 0
 * @param job  progress, cancelling; NULL for none
 * @param[out] out  one curve; as it was when the function fails
 * @return BATTEN_OK; BAD_ARGUMENT; NOT_FINITE; OUT_OF_DOMAIN with the place (no value, a pole, a jump);
 * TOLERANCE_NOT_MET (rounding); TOO_LARGE (over 20,000 pieces); CANCELLED; INCOMPLETE; OUT_OF_MEMORY
 * Cost: linear in pieces, about 28 products of intervals for each operation of a piece.
 * Source: [MKC09]; the remainder of two-point Hermite interpolation, [Davis75] 3.5.
 */
BATTEN_API batten_status batten_curve_parametric(int dimension,
                                                 const batten_equation *const *coordinates,
                                                 batten_interval range, double tolerance,
                                                 const batten_job *job,
                                                 batten_equation_curves *out);

#ifdef __cplusplus
}
#endif
#endif
