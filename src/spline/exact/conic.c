/* Lines, circles and ellipses as exact NURBS curves. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>
#include <float.h>
#include <string.h>

static const double HALF_PI = BAT_PI / 2, TWO_PI = 2 * BAT_PI;

/* ---- straight ---- */

batten_status batten_curve_line(int dimension, const double *a, const double *b,
                                batten_curve **out)
{
    assert(a && b && out);
    const double knots[4] = {0, 0, 1, 1};
    double points[6] = {0};
    for (int k = 0; k < dimension && dimension <= 3; k++) {
        points[k] = a[k];
        points[dimension + k] = b[k];
    }
    return batten_curve_create((batten_points){dimension, 2, points}, 1, NULL, knots, out);
}

static batten_status chord_knots(int d, int count, const double *points, double *knots)
{
    for (int i = 1; i < count; i++) {
        const double chord = bat_distance(d, points + (size_t)(i - 1) * (size_t)d,
                                          points + (size_t)i * (size_t)d);
        if (!isfinite(chord))
            return bat_fail(BATTEN_NOT_FINITE, "the distance of points %d and %d is %g",
                            i - 1 + 1, i + 1, chord);
        knots[i + 1] = knots[i] + chord;
        if (!(knots[i + 1] > knots[i]))
            return bat_fail(BATTEN_COINCIDENT,
                            "points %d and %d coincide: %g apart on a length of %g", i - 1 + 1,
                            i + 1, chord, knots[i]);
    }
    knots[count + 1] = knots[count];
    return BATTEN_OK;
}

batten_status batten_curve_polyline(batten_points points, batten_curve **out)
{
    assert(points.at && out);
    if (points.dimension < 1 || points.dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        points.dimension);
    if (points.count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d point%s; a polyline needs 2", points.count,
                        bat_plural(points.count));
    double *knots = bat_array((size_t)points.count + 2, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = chord_knots(points.dimension, points.count, points.at, knots);
    if (status == BATTEN_OK)
        status = batten_curve_create(points, 1, NULL, knots, out);
    bat_release(knots);
    return status;
}

/* ---- around ---- */

/* centre + x cos + y sin: a circle or an ellipse in a plane of any position. */
typedef struct {
    int dimension;
    double centre[3], x[3], y[3];
} ellipse;

/* cos and sin, exact at the quarters: pi / 2 as a double is no quarter to cos. */
static void direction(double angle, double *c, double *s)
{
    const double quarter = nearbyint(angle / HALF_PI);
    *c = bat_cos(angle);
    *s = bat_sin(angle);
    if (quarter == 0 || fabs(angle - quarter * HALF_PI) > 2 * DBL_EPSILON * fabs(angle))
        return;
    const int turn = (int)fmod(quarter, 4) & 3;
    *c = turn == 0 ? 1 : turn == 2 ? -1 : 0;
    *s = turn == 1 ? 1 : turn == 3 ? -1 : 0;
}

static void put_on_ellipse(const ellipse *shape, double c, double s, double *point)
{
    for (int k = 0; k < shape->dimension; k++)
        point[k] = shape->centre[k] + (shape->x[k] * c + shape->y[k] * s);
}

static batten_status check_angle(double angle)
{
    if (!isfinite(angle))
        return bat_fail(BATTEN_NOT_FINITE, "the angle is %g", angle);
    if (!(angle > 0 && angle <= TWO_PI))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle is %.17g; it must be in (0, 2 pi]",
                        angle);
    return BATTEN_OK;
}

/* Points 2 i on the curve at start + i step; between two of them the meeting point of their
 * tangents, which is (first + second) / (1 + cos step) from the centre. */
static void fill_arc(const ellipse *shape, double start, double angle, int pieces,
                     double *points, double *weights, double *knots)
{
    const int d = shape->dimension;
    const double step = angle / pieces,
                 rise = pieces == 4 && angle == TWO_PI ? 1 : 1 + bat_cos(step);
    double c0, s0;
    direction(start, &c0, &s0);
    put_on_ellipse(shape, c0, s0, points);
    weights[0] = 1;
    knots[0] = knots[1] = knots[2] = 0;
    for (int i = 1; i <= pieces; i++) {
        double c1, s1;
        direction(i == pieces ? start + angle : start + i * step, &c1, &s1);
        put_on_ellipse(shape, (c0 + c1) / rise, (s0 + s1) / rise, points + (2 * i - 1) * d);
        put_on_ellipse(shape, c1, s1, points + 2 * i * d);
        weights[2 * i - 1] = bat_cos(step / 2);
        weights[2 * i] = 1;
        knots[2 * i + 1] = knots[2 * i + 2] = (double)i / pieces;
        c0 = c1;
        s0 = s1;
    }
    knots[2 * pieces + 3] = 1;
    if (angle == TWO_PI) /* the end is the start */
        memcpy(points + 2 * pieces * d, points, (size_t)d * sizeof *points);
}

static void set_ends(size_t d, int pieces, const double *ends, double *points)
{
    memcpy(points, ends, d * sizeof *points);
    memcpy(points + 2 * (size_t)pieces * d, ends + d, d * sizeof *points);
}

/* ends: NULL, or the first and the last point, known better than by cos and sin. */
static batten_status make_arc(const ellipse *shape, double start, double angle,
                              const double *ends, batten_curve **out)
{
    double points[27], weights[9], knots[12];
    const int pieces = bat_max_int(1, bat_min_int(4, (int)ceil(angle / HALF_PI)));
    const size_t d = (size_t)shape->dimension;
    fill_arc(shape, start, angle, pieces, points, weights, knots);
    if (ends)
        set_ends(d, pieces, ends, points);
    return batten_curve_create((batten_points){(int)d, 2 * pieces + 1, points}, 2, weights,
                               knots, out);
}

static batten_status check_radius(double radius, const char *what)
{
    if (!isfinite(radius))
        return bat_fail(BATTEN_NOT_FINITE, "the %s is %g", what, radius);
    if (!(radius > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the %s is %g; it must be positive", what, radius);
    return BATTEN_OK;
}

batten_status batten_curve_arc(double radius, double angle, batten_curve **out)
{
    return batten_curve_ellipse(radius, radius, 0, angle, out);
}

batten_status batten_curve_ellipse(double a, double b, double start, double angle,
                                   batten_curve **out)
{
    assert(out);
    const ellipse shape = {2, {0}, {a, 0, 0}, {0, b, 0}};
    batten_status status = check_radius(a, a == b ? "radius" : "first half axis");
    if (status == BATTEN_OK)
        status = check_radius(b, "second half axis");
    if (status == BATTEN_OK && !isfinite(start))
        status = bat_fail(BATTEN_NOT_FINITE, "the start angle is %g", start);
    if (status == BATTEN_OK)
        status = check_angle(angle);
    return status == BATTEN_OK ? make_arc(&shape, start, angle, NULL, out) : status;
}

batten_status batten_curve_arc_in(const batten_frame *frame, double radius, double start,
                                  double angle, batten_curve **out)
{
    assert(frame && out);
    batten_frame square;
    batten_vec3 y;
    batten_status status = check_radius(radius, "radius");
    if (status == BATTEN_OK && !isfinite(start))
        status = bat_fail(BATTEN_NOT_FINITE, "the start angle is %g", start);
    if (status == BATTEN_OK)
        status = check_angle(angle);
    if (status == BATTEN_OK)
        status = bat_frame_square(frame, &square, &y);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 o = square.origin, x = square.x;
    const ellipse shape = {3,
                           {o.x, o.y, o.z},
                           {radius * x.x, radius * x.y, radius * x.z},
                           {radius * y.x, radius * y.y, radius * y.z}};
    return make_arc(&shape, start, angle, NULL, out);
}

/* ---- a circle through three points ---- */

/* Turning from ab to bc is half of the sweep from a to c: the angle at the circumference. */
static batten_status arc_of(int d, const double *a, const double *b, const double *c,
                            double length, batten_curve **out)
{
    const batten_vec3 start = bat_vec3_of(d, a), end = bat_vec3_of(d, c),
                      middle = bat_vec3_of(d, b);
    const batten_vec3 ab = bat_vec3_scale(bat_vec3_subtract(middle, start), 1 / length);
    const batten_vec3 bc = bat_vec3_scale(bat_vec3_subtract(end, middle), 1 / length);
    const batten_vec3 ac = bat_vec3_scale(bat_vec3_subtract(end, start), 1 / length);
    const batten_vec3 normal = bat_vec3_cross(ab, bc);
    const double sine = bat_vec3_norm(normal), half = bat_atan2(sine, bat_vec3_dot(ab, bc));
    /* A cross product errs by a few eps of the product of lengths. */
    if (sine <= 8 * DBL_EPSILON * bat_vec3_norm(ab) * bat_vec3_norm(bc))
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "the three points lie on a line, no circle passes through them");
    const double chord = bat_vec3_norm(ac), radius = length * (chord / 2 / bat_sin(half));
    const batten_vec3 x =
        bat_vec3_scale(bat_vec3_cross(ac, normal), radius / sine / chord); /* towards b */
    const batten_vec3 y = bat_vec3_scale(ac, radius / chord);
    const batten_vec3 centre =
        bat_vec3_along(bat_vec3_along(start, length / 2, ac), -bat_cos(half), x);
    const ellipse shape = {d, {centre.x, centre.y, centre.z}, {x.x, x.y, x.z}, {y.x, y.y, y.z}};
    double ends[6];
    memcpy(ends, a, (size_t)d * sizeof *ends);
    memcpy(ends + d, c, (size_t)d * sizeof *ends);
    return make_arc(&shape, -half, 2 * half, ends, out);
}

batten_status batten_curve_arc_through(int dimension, const double *a, const double *b,
                                       const double *c, batten_curve **out)
{
    assert(a && b && c && out);
    const int d = dimension;
    if (d < 2 || d > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 2 or 3", d);
    const double ab = bat_distance(d, a, b), bc = bat_distance(d, b, c),
                 ac = bat_distance(d, a, c);
    if (!isfinite(ab + bc + ac))
        return bat_fail(BATTEN_NOT_FINITE, "the points are %g, %g and %g apart", ab, bc, ac);
    if (ab == 0 || bc == 0 || ac == 0)
        return bat_fail(BATTEN_COINCIDENT,
                        "two of the points coincide; they are %g, %g and %g apart", ab, bc, ac);
    return arc_of(d, a, b, c, bat_max(ab, bc), out);
}

/* ---- full circles ---- */

static batten_status scaled_circle(double radius, int count, const double *unit,
                                   const double *weights, const double *knots,
                                   batten_curve **out)
{
    double points[14];
    for (int i = 0; i < 2 * count; i++)
        points[i] = radius * unit[i];
    return batten_curve_create((batten_points){2, count, points}, 2, weights, knots, out);
}

batten_status batten_curve_circle(double radius, batten_circle_form form, batten_curve **out)
{
    static const double R3 = 1.7320508075688772, H3 = 0.8660254037844386;
    static const double triangle[] = {H3, 0.5, 0, 2, -H3, 0.5, -R3, -1, 0, -1, R3, -1, H3, 0.5};
    static const double triangle_weights[] = {1, 0.5, 1, 0.5, 1, 0.5, 1};
    static const double triangle_knots[] = {0, 0, 0, 1 / 3., 1 / 3., 2 / 3., 2 / 3., 1, 1, 1};
    static const double square[] = {1, 0, 1, 1, -1, 1, -1, 0, -1, -1, 1, -1, 1, 0};
    static const double square_weights[] = {1, 0.5, 0.5, 1, 0.5, 0.5, 1};
    static const double square_knots[] = {0, 0, 0, 0.25, 0.5, 0.5, 0.75, 1, 1, 1};
    assert(out);
    const batten_status status = check_radius(radius, "radius");
    if (status != BATTEN_OK)
        return status;
    switch (form) {
    case BATTEN_CIRCLE_SQUARE_9:
        return batten_curve_arc(radius, TWO_PI, out);
    case BATTEN_CIRCLE_TRIANGLE_7:
        return scaled_circle(radius, 7, triangle, triangle_weights, triangle_knots, out);
    case BATTEN_CIRCLE_SQUARE_7:
        return scaled_circle(radius, 7, square, square_weights, square_knots, out);
    }
    return bat_fail(BATTEN_BAD_ARGUMENT, "%d is no form of a circle", (int)form);
}
