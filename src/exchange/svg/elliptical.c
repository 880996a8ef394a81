/* Recognises a piece of a NURBS curve as an arc of an ellipse. */
#include "exchange/svg/elliptical.h"
#include "numeric/vector.h"

#include <float.h>

/* Ends and the point where their tangents meet; the weight of that one when the ends have 1. */
typedef struct {
    double a[2], b[2], corner[2], weight;
} conic;

/* Control point i in homogeneous coordinates x, y, w. */
static void lift(int dimension, const double *points, const double *weights, int i,
                 double out[3])
{
    for (int k = 0; k < 2; k++)
        out[k] = weights[i] * points[i * dimension + k];
    out[2] = weights[i];
}

/* The middle of a quadratic that was raised to a cubic: (3 Q1 - Q0) / 2 and (3 Q2 - Q3) / 2 are
 * the same. */
static bool lower(const double q[4][3], double rounding, double middle[3])
{
    for (int k = 0; k < 3; k++) {
        const double one = (3 * q[1][k] - q[0][k]) / 2, other = (3 * q[2][k] - q[3][k]) / 2;
        const double size = k < 2 ? rounding : 16 * DBL_EPSILON;
        if (!(fabs(one - other) <= size * bat_max(q[0][2], q[3][2])))
            return false;
        middle[k] = one + (other - one) / 2;
    }
    return true;
}

static bool conic_of(int dimension, int degree, const double *points, const double *weights,
                     double rounding, conic *out)
{
    double q[4][3], middle[3];
    for (int i = 0; i <= degree; i++)
        lift(dimension, points, weights, i, q[i]);
    if (degree == 3 && !lower((const double(*)[3])q, rounding, middle))
        return false;
    for (int k = 0; k < 2; k++) {
        out->a[k] = points[k];
        out->b[k] = points[degree * dimension + k];
        out->corner[k] = degree == 2 ? points[dimension + k] : middle[k] / middle[2];
    }
    out->weight = (degree == 2 ? weights[1] : middle[2]) / sqrt(q[0][2] * q[degree][2]);
    return true;
}

/* How far the middle of the arc that a reader makes is from that of the conic. */
static double miss(const conic *c, const bat_svg_elliptical *e)
{
    const double cosine = bat_cos(e->angle), sine = bat_sin(e->angle);
    const double dx = (c->b[0] - c->a[0]) / 2, dy = (c->b[1] - c->a[1]) / 2;
    /* Half the chord where the ellipse is a unit circle, and how far the arc is beside it. */
    const double u = (cosine * dx + sine * dy) / e->rx, v = (cosine * dy - sine * dx) / e->ry;
    const double half = u * u + v * v, length = sqrt(half);
    if (!(half < 1 && length > 0))
        return INFINITY;
    const double beside = half / (1 + sqrt(1 - half)) * (e->is_clockwise ? -1 : 1) / length;
    const double x = beside * v * e->rx, y = -beside * u * e->ry;
    const double found[2] = {cosine * x - sine * y, sine * x + cosine * y};
    double off[2];
    for (int k = 0; k < 2; k++)
        off[k] =
            c->weight / (1 + c->weight) * (c->corner[k] - (c->a[k] + (c->b[k] - c->a[k]) / 2)) -
            found[k];
    return bat_norm(2, off);
}

/*
 * With the weight w = cos(h) the arc is centre + u cos(t) + v sin(t), -h <= t <= h: the centre
 * lies on the line from the corner through the middle of the chord. The half axes are the
 * singular values of the matrix (u v), as [GVL13] 2.4.
 */
bool bat_svg_is_elliptical(int dimension, int degree, const double *points,
                           const double *weights, double rounding, bat_svg_elliptical *out)
{
    conic c;
    if ((degree != 2 && degree != 3) ||
        !conic_of(dimension, degree, points, weights, rounding, &c))
        return false;
    const double w = c.weight, rest = (1 - w) * (1 + w);
    if (!(w > 0 && rest > 0))
        return false;
    double u[2], v[2];
    for (int k = 0; k < 2; k++) {
        const double middle = c.a[k] + (c.b[k] - c.a[k]) / 2;
        u[k] = (c.corner[k] - middle) * w / rest;
        v[k] = (c.b[k] - c.a[k]) / (2 * sqrt(rest));
    }
    const double area = u[0] * v[1] - u[1] * v[0];
    const double e = u[0] * u[0] + v[0] * v[0], g = u[1] * u[1] + v[1] * v[1];
    const double f = u[0] * u[1] + v[0] * v[1];
    const double rx =
        bat_hypot(u[0] + v[1], u[1] - v[0]) / 2 + bat_hypot(u[0] - v[1], u[1] + v[0]) / 2;
    if (!(area != 0 && rx > 0))
        return false;
    *out = (bat_svg_elliptical){.rx = rx, .ry = fabs(area) / rx, .is_clockwise = area < 0};
    if (fabs(f) > 8 * DBL_EPSILON * (e + g) + rounding / 4 * rx) /* else it is rounding */
        out->angle = bat_atan2(2 * f, e - g) / 2;
    else if (e < g)
        out->angle = BAT_PI / 2;
    return miss(&c, out) <= rounding + 16 * DBL_EPSILON * rx;
}
