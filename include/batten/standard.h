#ifndef BATTEN_STANDARD_H
#define BATTEN_STANDARD_H
/**
 * @file
 * The classical shapes as exact NURBS.
 */
#include <batten/surface.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ---- curves ---- */

/** The segment from a to b, in `dimension` coordinates, degree 1, domain [0, 1]. */
BATTEN_API batten_status batten_curve_line(int dimension, const double *a, const double *b,
                                           batten_curve **out);
/** A polyline through points [count][dimension], degree 1; knots by chord length. */
BATTEN_API batten_status batten_curve_polyline(int dimension, int count, const double *points,
                                               batten_curve **out);
/** An arc in the plane about (0, 0), from angle 0 counter-clockwise to `angle`, in (0, 2 pi];
 * degree 2, ceil(angle / 90 degrees) pieces, domain [0, 1]. */
BATTEN_API batten_status batten_curve_arc(double radius, double angle, batten_curve **out);
/** An arc in space in the xy-plane of `frame`, from `start` to `start + angle` radians. */
BATTEN_API batten_status batten_curve_arc_in(const batten_frame *frame, double radius,
                                             double start, double angle, batten_curve **out);
/** The arc through three points of the plane or space. */
BATTEN_API batten_status batten_curve_arc_through(int dimension, const double *a,
                                                  const double *b, const double *c,
                                                  batten_curve **out);

/** How a full circle is written down. */
typedef enum batten_circle_form {
    BATTEN_CIRCLE_SQUARE_9,   /**< nine points, the corners and mid-sides of a square */
    BATTEN_CIRCLE_TRIANGLE_7, /**< seven points on a triangle */
    BATTEN_CIRCLE_SQUARE_7    /**< seven points on a square, two halves */
} batten_circle_form;
BATTEN_API batten_status batten_curve_circle(double radius, batten_circle_form form,
                                             batten_curve **out);
BATTEN_API batten_status batten_curve_ellipse(double a, double b, double start, double angle,
                                              batten_curve **out);
/** The rational quadratic from a to c with end tangents that meet in b, and shoulder weight w:
 * below 1 an ellipse, 1 a parabola, above 1 a hyperbola. */
BATTEN_API batten_status batten_curve_conic(int dimension, const double *a, const double *b,
                                            const double *c, double w, batten_curve **out);
/** The same, through a further point of the plane inside the triangle a b c. */
BATTEN_API batten_status batten_curve_conic_through(const double *a, const double *b,
                                                    const double *c, const double *q,
                                                    batten_curve **out);
/** The conic arc through five points of the plane, in their order along it.
 * @param points [5][2] */
BATTEN_API batten_status batten_curve_conic_five(const double *points, batten_curve **out);

/* ---- surfaces ---- */

/** Four corners: S(0,0), S(1,0), S(0,1), S(1,1). */
BATTEN_API batten_status batten_surface_bilinear(batten_vec3 p00, batten_vec3 p10,
                                                 batten_vec3 p01, batten_vec3 p11,
                                                 batten_surface **out);
/** Turn a profile about the axis through `origin` by `angle` in (0, 2 pi] radians; u runs
 * around, v along the profile. A profile that crosses the axis is refused, one that touches it
 * has a pole. */
BATTEN_API batten_status batten_surface_revolved(const batten_curve *profile,
                                                 batten_vec3 origin, batten_vec3 axis,
                                                 double angle, batten_surface **out);
/** About the z-axis of `frame`, from its origin up. u around, v up. */
BATTEN_API batten_status batten_surface_cylinder(const batten_frame *frame, double radius,
                                                 double height, batten_surface **out);
/** Radius r0 at the origin and r1 at `height`; one of them may be 0. */
BATTEN_API batten_status batten_surface_cone(const batten_frame *frame, double r0, double r1,
                                             double height, batten_surface **out);
BATTEN_API batten_status batten_surface_sphere(const batten_frame *frame, double radius,
                                               batten_surface **out);
/** x^2 / a^2 + y^2 / b^2 + z^2 / c^2 = 1 in the frame; its poles are on the z-axis. */
BATTEN_API batten_status batten_surface_ellipsoid(const batten_frame *frame, double a, double b,
                                                  double c, batten_surface **out);
/** z = height (x^2 / a^2 + y^2 / b^2), from the pole at the origin up to the rim with half axes
 * a and b. */
BATTEN_API batten_status batten_surface_paraboloid(const batten_frame *frame, double a,
                                                   double b, double height,
                                                   batten_surface **out);
/** The hyperboloid of one sheet x^2 / a^2 + y^2 / b^2 - z^2 / c^2 = 1 from z = low to z = high;
 * v runs along one family of its straight lines. */
BATTEN_API batten_status batten_surface_hyperboloid(const batten_frame *frame, double a,
                                                    double b, double c, double low, double high,
                                                    batten_surface **out);
/** `major` > `minor` > 0. */
BATTEN_API batten_status batten_surface_torus(const batten_frame *frame, double major,
                                              double minor, batten_surface **out);

#ifdef __cplusplus
}
#endif
#endif
