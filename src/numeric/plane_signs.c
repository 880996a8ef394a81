/*
 * The orientation and in-circle predicates. Floating point decides when an error bound lets it,
 * otherwise exact arithmetic does. Source: [Shewchuk97], sections 4.3 and 4.4.
 */
#include "numeric/plane_signs.h"

#include "numeric/exact.h"

#include <float.h>

/* Bounds on the roundoff of the plain determinants, in units of the sum of the absolute values
 * of their products. Source: [Shewchuk97], sections 4.3 and 4.4. */
static const double unit = DBL_EPSILON / 2;

static int sign_of(double value)
{
    return (value > 0) - (value < 0);
}

/* ---- sides of a line ---- */

static int exact_orientation(const double *a, const double *b, const double *c)
{
    const bat_exact ax = bat_exact_difference(a[0], c[0]);
    const bat_exact ay = bat_exact_difference(a[1], c[1]);
    const bat_exact bx = bat_exact_difference(b[0], c[0]);
    const bat_exact by = bat_exact_difference(b[1], c[1]);
    bat_exact sum = {.count = 0};
    bat_exact_add_product(&sum, 1, &ax, &by);
    bat_exact_add_product(&sum, -1, &ay, &bx);
    return bat_exact_sign(&sum);
}

int bat_orientation(const double *a, const double *b, const double *c)
{
    const double ax = a[0] - c[0], ay = a[1] - c[1], bx = b[0] - c[0], by = b[1] - c[1];
    if ((ax == 0 || by == 0) && (ay == 0 || bx == 0))
        return 0;
    const double left = ax * by, right = ay * bx;
    const double bound = (3 + 16 * unit) * unit * (fabs(left) + fabs(right));
    const double value = left - right;
    return fabs(value) > bound ? sign_of(value) : exact_orientation(a, b, c);
}

/* ---- sides of a circle ---- */

typedef struct {
    bat_exact x, y;
} side;

/* sum += |a|^2 (b x c) */
static void add_lifted(const side *a, const side *b, const side *c, bat_exact *sum)
{
    bat_exact square = {.count = 0}, cross = {.count = 0};
    bat_exact_add_product(&square, 1, &a->x, &a->x);
    bat_exact_add_product(&square, 1, &a->y, &a->y);
    bat_exact_add_product(&cross, 1, &b->x, &c->y);
    bat_exact_add_product(&cross, -1, &b->y, &c->x);
    bat_exact_add_product(sum, 1, &square, &cross);
}

static side side_of(const double *a, const double *d)
{
    return (side){bat_exact_difference(a[0], d[0]), bat_exact_difference(a[1], d[1])};
}

static int exact_in_circle(const double *a, const double *b, const double *c, const double *d)
{
    const side ad = side_of(a, d), bd = side_of(b, d), cd = side_of(c, d);
    bat_exact sum = {.count = 0};
    add_lifted(&ad, &bd, &cd, &sum);
    add_lifted(&bd, &cd, &ad, &sum);
    add_lifted(&cd, &ad, &bd, &sum);
    return bat_exact_sign(&sum);
}

static bool difference_is_exact(double a, double b, double difference)
{
    const double part = difference - a;
    return (a - (difference - part)) + (-b - part) == 0;
}

/* Are all differences from d exact, and whole multiples below 2^11 of one step? Then their
 * squares are below 2^22, their products with sums of products below 2^46, and the plain
 * determinant has no rounding: on grids that decides nearly every circle. */
static bool is_short(const double *corners[3], const double *d)
{
    double largest = 0;
    for (int i = 0; i < 6; i++)
        largest = bat_max(largest, fabs(corners[i / 2][i % 2] - d[i % 2]));
    const double step = ldexp(1, ilogb(largest) - 10);
    for (int i = 0; i < 6; i++) {
        const double a = corners[i / 2][i % 2], b = d[i % 2], difference = a - b;
        if (!difference_is_exact(a, b, difference) ||
            rint(difference / step) * step != difference)
            return false;
    }
    return true;
}

int bat_in_circle(const double *a, const double *b, const double *c, const double *d)
{
    const double ax = a[0] - d[0], ay = a[1] - d[1], bx = b[0] - d[0], by = b[1] - d[1];
    const double cx = c[0] - d[0], cy = c[1] - d[1];
    const double aa = ax * ax + ay * ay, bb = bx * bx + by * by, cc = cx * cx + cy * cy;
    const double value =
        aa * (bx * cy - by * cx) + bb * (cx * ay - cy * ax) + cc * (ax * by - ay * bx);
    const double all = aa * (fabs(bx * cy) + fabs(by * cx)) +
                       bb * (fabs(cx * ay) + fabs(cy * ax)) +
                       cc * (fabs(ax * by) + fabs(ay * bx));
    if (fabs(value) > (10 + 96 * unit) * unit * all)
        return sign_of(value);
    const double *corners[3] = {a, b, c};
    if (is_short(corners, d))
        return sign_of(value);
    return exact_in_circle(a, b, c, d);
}
