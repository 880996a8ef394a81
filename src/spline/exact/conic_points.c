/* Conics by their triangle, through one point or through five, as exact NURBS curves. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <batten/standard.h>
#include <string.h>

/* ---- conics ---- */

batten_status batten_curve_conic(int dimension, const double *a, const double *b,
                                 const double *c, double w, batten_curve **out)
{
    assert(a && b && c && out);
    const double knots[6] = {0, 0, 0, 1, 1, 1}, weights[3] = {1, w, 1};
    double points[9] = {0};
    for (int k = 0; k < dimension && dimension <= 3; k++) {
        points[k] = a[k];
        points[dimension + k] = b[k];
        points[2 * dimension + k] = c[k];
    }
    return batten_curve_create((batten_points){dimension, 3, points}, 2, weights, knots, out);
}

/* Twice the signed area of a triangle of the plane. */
static double area(const double *a, const double *b, const double *c)
{
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

batten_status batten_curve_conic_through(batten_vec2 a, batten_vec2 b, batten_vec2 c,
                                         batten_vec2 q, batten_curve **out)
{
    const double a_xy[2] = {a.x, a.y};
    const double b_xy[2] = {b.x, b.y};
    const double c_xy[2] = {c.x, c.y};
    const double q_xy[2] = {q.x, q.y};
    assert(out);
    const double whole = area(a_xy, b_xy, c_xy);
    if (!isfinite(whole))
        return bat_fail(BATTEN_NOT_FINITE, "the area of the triangle is %g", whole);
    if (whole == 0)
        return bat_fail(BATTEN_SINGULAR_SYSTEM, "the points of the triangle lie on a line");
    const double at_a = area(q_xy, b_xy, c_xy) / whole, at_b = area(a_xy, q_xy, c_xy) / whole,
                 at_c = area(a_xy, b_xy, q_xy) / whole;
    if (!(at_a > 0 && at_b > 0 && at_c > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the point is not inside the triangle: its barycentric coordinates are "
                        "%g, %g, %g",
                        at_a, at_b, at_c);
    return batten_curve_conic(2, a_xy, b_xy, c_xy, at_b / (2 * sqrt(at_a * at_c)), out);
}

/*
 * The conic through P0 .. P4 out of the pencil of conics through P0, P1, P3, P4:
 * F = s (P0 P1)(P3 P4) - t (P0 P3)(P1 P4), each bracket a line, with s and t so that F is 0 at
 * P2.
 */
typedef struct {
    const double *p; /* [5][2] */
    double s, t;
    int sense; /* of the turns from point to point; 0: they are out of order */
} pencil;

static const double *at(const pencil *conic, int i)
{
    return conic->p + 2 * i;
}

/* The symmetric bilinear form of F: 0 when x and y are conjugate. */
static double form(const pencil *conic, const double *x, const double *y)
{
    const double *p0 = at(conic, 0), *p1 = at(conic, 1), *p3 = at(conic, 3), *p4 = at(conic, 4);
    const double first = area(p0, p1, x) * area(p3, p4, y) + area(p0, p1, y) * area(p3, p4, x);
    const double second = area(p0, p3, x) * area(p1, p4, y) + area(p0, p3, y) * area(p1, p4, x);
    return (conic->s * first - conic->t * second) / 2;
}

/* The tangent at a: direction (-F_y, F_x). form(a, .) is affine in its second argument. */
static void tangent(const pencil *conic, const double *a, double *out)
{
    const double size = bat_distance(2, at(conic, 0), at(conic, 4));
    const double right[2] = {a[0] + size, a[1]}, up[2] = {a[0], a[1] + size};
    const double here = form(conic, a, a);
    out[0] = -(form(conic, a, up) - here);
    out[1] = form(conic, a, right) - here;
    const double length = bat_hypot(out[0], out[1]);
    if (length > 0) {
        out[0] /= length;
        out[1] /= length;
    }
}

/* The arc from point i to point j: where its tangents meet, and its weight; false when it is no
 * arc below half a turn that holds the points between. */
static bool arc_between(const pencil *conic, int i, int j, double *b, double *w)
{
    const double *a = at(conic, i), *c = at(conic, j);
    double u[2], v[2];
    tangent(conic, a, u);
    tangent(conic, c, v);
    const double sine = u[0] * v[1] - u[1] * v[0];
    if (fabs(sine) < 1e-6) /* nearly parallel: the meeting point would be badly known */
        return false;
    const double along = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / sine;
    b[0] = a[0] + along * u[0];
    b[1] = a[1] + along * u[1];
    const double square = -form(conic, a, c) / (2 * form(conic, b, b));
    if (!(square > 0 && isfinite(square)))
        return false;
    *w = sqrt(square);
    const double whole = area(a, b, c);
    if (!(whole * conic->sense > 0))
        return false;
    for (int k = i + 1; k < j; k++) {
        const double *q = at(conic, k);
        if (!(area(q, b, c) / whole > 0 && area(a, q, c) / whole > 0 &&
              area(a, b, q) / whole > 0))
            return false;
    }
    return true;
}

static bool conic_pieces(const pencil *conic, int pieces, double *points, double *weights)
{
    const int step = 4 / pieces;
    for (int i = 0; i <= pieces; i++) {
        memcpy(points + 4 * i, at(conic, i * step), 2 * sizeof *points);
        weights[2 * i] = 1;
        if (i < pieces && !arc_between(conic, i * step, (i + 1) * step, points + 4 * i + 2,
                                       &weights[2 * i + 1]))
            return false;
    }
    return true;
}

static batten_status check_five(const double *points)
{
    const size_t bad = bat_first_not_finite(points, 10);
    if (bad < 10)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is %g", bad % 2 + 1,
                        bad / 2 + 1, points[bad]);
    for (int i = 0; i < 5; i++)
        for (int j = i + 1; j < 5; j++)
            if (points[2 * i] == points[2 * j] && points[2 * i + 1] == points[2 * j + 1])
                return bat_fail(BATTEN_COINCIDENT, "points %d and %d coincide at (%g, %g)",
                                i + 1, j + 1, points[2 * i], points[2 * i + 1]);
    return BATTEN_OK;
}

/* On one branch points are the corners of a convex polygon: in their order they are seen from
 * the first one after the other, to the left or to the right. 0: they are not. */
static int sense_of(const double *points)
{
    int sense = 0;
    for (int i = 1; i < 4; i++) {
        const double turn = area(points, points + 2 * i, points + 2 * i + 2);
        const int sign = (turn > 0) - (turn < 0);
        if (sign == 0 || sign == -sense)
            return 0;
        sense = sign;
    }
    return sense;
}

batten_status batten_curve_conic_five(batten_points points, batten_curve **out)
{
    if (points.dimension != 2)
        return bat_wrong_dimension(points, 2);
    if (points.count != 5)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a conic takes 5 points, not %d", points.count);
    assert(points.at && out);
    const batten_status status = check_five(points.at);
    if (status != BATTEN_OK)
        return status;
    pencil conic = {points.at, 0, 0, sense_of(points.at)};
    const double *q = points.at + 4;
    conic.s = area(at(&conic, 0), at(&conic, 3), q) * area(at(&conic, 1), at(&conic, 4), q);
    conic.t = area(at(&conic, 0), at(&conic, 1), q) * area(at(&conic, 3), at(&conic, 4), q);
    const double size = bat_max(fabs(conic.s), fabs(conic.t));
    if (!(size > 0 && isfinite(size)))
        return bat_fail(BATTEN_SINGULAR_SYSTEM, "too many of the five points lie on a line");
    conic.s /= size;
    conic.t /= size;
    double control[18], weights[9], breaks[5];
    for (int pieces = 1; pieces <= 4; pieces *= 2) {
        if (!conic_pieces(&conic, pieces, control, weights))
            continue;
        for (int i = 0; i <= pieces; i++)
            breaks[i] = (double)i / pieces;
        return batten_curve_from_bezier(2, (batten_pieces){2, pieces, breaks}, control, weights,
                                        out);
    }
    return bat_fail(
        BATTEN_SINGULAR_SYSTEM,
        "the five points do not follow each other on one arc of a conic; give them in "
        "their order along it");
}
