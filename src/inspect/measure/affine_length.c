/* The affine length and curvature of plane curves, which area-preserving maps leave alone. */
#include "inspect/affine/exact_span.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/curvature.h>
#include <batten/invariants.h>

#include <string.h>

/* Evaluations of one piece at most, and steps to invert its length. */
enum { LIMIT = 30000, STEPS = 80, MOST_PARTS = 1000000 };

/* ---- the integrand ---- */

static double cross(const double *a, const double *b)
{
    return a[0] * b[1] - a[1] * b[0];
}

/* d s / d u, from the right or the left; `is_flat`: the curve lies in a plane. */
static batten_status affine_speed(const batten_curve *curve, bool is_flat, double u,
                                  batten_side side, double *speed)
{
    double v[4 * 3];
    const int d = curve->dimension;
    const batten_status status = batten_curve_evaluate_side(curve, u, side, is_flat ? 2 : 3, v);
    if (status != BATTEN_OK)
        return status;
    const double *a = v + d, *b = v + 2 * d, *c = v + 3 * d;
    if (d == 2) {
        *speed = bat_cbrt(fabs(cross(a, b)));
        return BATTEN_OK;
    }
    double n[3];
    bat_cross(a, b, n);
    *speed = is_flat ? bat_cbrt(bat_norm(3, n)) : sqrt(bat_cbrt(fabs(bat_dot(3, n, c))));
    return BATTEN_OK;
}

/*
 * A piece inside a span, between inflections. There the speed vanishes as a cube root, so the
 * parameter goes as u = a + (b - a) w(v) with w = v^3 (10 - 15 v + 6 v^2), which makes that
 * smooth at both ends.
 */
typedef struct {
    const batten_curve *curve;
    bool is_flat;
    double a, b;
} piece;

static double parameter_at(const piece *p, double v)
{
    if (v >= 1)
        return p->b;
    return p->a + (p->b - p->a) * (v * v * v * (10 + v * (6 * v - 15)));
}

static batten_status speed_at(void *context, double v, double *value)
{
    const piece *p = context;
    const double u = parameter_at(p, v), w = v * (1 - v);
    double speed;
    const batten_status status = affine_speed(
        p->curve, p->is_flat, u, u >= p->b ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &speed);
    if (status == BATTEN_OK)
        *value = speed * (p->b - p->a) * 30 * w * w;
    return status;
}

/* ---- pieces ---- */

typedef struct {
    bool is_flat, is_straight;
    int count;
    double *at;   /* [count + 1] ends */
    double *sums; /* [count + 1] length up to there */
    double error;
} measured;

static void release_measured(measured *m)
{
    bat_release(m->at);
    bat_release(m->sums);
}

/* The inflections of a curve that lies in a plane of space, seen along an axis. */
static batten_status inflections_in_space(const batten_curve *curve, const int *axes,
                                          batten_parameters *out)
{
    batten_affine map = {{{0}}, {0}};
    batten_curve *turned = NULL, *plane = NULL;
    map.m[0][axes[0]] = map.m[1][axes[1]] = 1;
    batten_status status = batten_curve_transform(curve, &map, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(turned, 2, &plane);
    if (status == BATTEN_OK)
        status = batten_curve_inflections(plane, out);
    batten_curve_unref(plane);
    batten_curve_unref(turned);
    return status;
}

/* Points that lie within this part of their size in a plane lie in it. */
static const double flat_tolerance = 1e-12;

/* Knots and inflections in order, each once. */
static batten_status list_ends(const batten_curve *curve, measured *m)
{
    batten_parameters turns = {0, NULL};
    batten_status status = BATTEN_OK;
    const bat_flatness flat =
        bat_flatness_of_points(curve->dimension, curve->count, curve->points, flat_tolerance);
    m->is_flat = flat.dimension < 3;
    m->is_straight = flat.dimension < 2;
    if (curve->dimension == 2)
        status = batten_curve_inflections(curve, &turns);
    else if (flat.dimension == 2)
        status = inflections_in_space(curve, flat.axes, &turns);
    const int knots = batten_curve_spans(curve, NULL);
    if (status == BATTEN_OK) {
        const size_t room = (size_t)knots + (size_t)turns.count;
        double *breaks = bat_array((size_t)knots, sizeof *breaks);
        m->at = bat_array(room, sizeof *m->at);
        m->sums = bat_array(room, sizeof *m->sums);
        status = breaks && m->at && m->sums ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
        if (status == BATTEN_OK)
            batten_curve_spans(curve, breaks);
        int count = 0;
        for (int i = 0, j = 0; status == BATTEN_OK && (i < knots || j < turns.count);) {
            const bool is_turn = i == knots || (j < turns.count && turns.at[j] < breaks[i]);
            const double next = is_turn ? turns.at[j++] : breaks[i++];
            if (count == 0 || next > m->at[count - 1])
                m->at[count++] = next;
        }
        m->count = count - 1;
        bat_release(breaks);
    }
    bat_release(turns.at);
    return status;
}

static batten_status measure_curve(const batten_curve *curve, double tolerance, measured *out)
{
    measured m = {0};
    if (curve->dimension < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve of one dimension has no affine length");
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    batten_status status = list_ends(curve, &m);
    for (int i = 0; i < m.count && status == BATTEN_OK; i++) {
        piece p = {curve, m.is_flat, m.at[i], m.at[i + 1]};
        double length = 0, error = 0;
        status = bat_integrate(speed_at, &p, 0, 1, tolerance / m.count, LIMIT, &length, &error);
        m.sums[i + 1] = m.sums[i] + length;
        m.error += error;
    }
    if (status == BATTEN_OK)
        *out = m;
    else
        release_measured(&m);
    return status;
}

batten_status batten_curve_affine_length(const batten_curve *curve, double tolerance,
                                         double *error, double *length)
{
    measured m;
    const batten_status status = measure_curve(curve, tolerance, &m);
    if (status != BATTEN_OK)
        return status;
    *length = m.sums[m.count];
    if (error)
        *error = m.error;
    release_measured(&m);
    return BATTEN_OK;
}

/* ---- division ---- */

/* Where in a piece the length from its begin is s: Newton's step where it stays inside what is
 * left, else the middle. */
static batten_status invert(piece *p, double s, double whole, double tolerance, double *u)
{
    double low = 0, high = 1, at = s / whole;
    for (int k = 0; k < STEPS && low < high; k++) {
        double to, error, speed = 0;
        batten_status status =
            bat_integrate(speed_at, p, 0, at, tolerance / 4, LIMIT, &to, &error);
        if (status == BATTEN_OK)
            status = speed_at(p, at, &speed);
        if (status != BATTEN_OK)
            return status;
        if (fabs(to - s) <= tolerance / 2)
            break;
        *(to < s ? &low : &high) = at;
        const double next = speed > 0 ? at + (s - to) / speed : -1;
        at = next > low && next < high ? next : low + (high - low) / 2;
    }
    *u = parameter_at(p, at);
    return BATTEN_OK;
}

static batten_status divide(const batten_curve *curve, const measured *m, int count,
                            double tolerance, double *u)
{
    const double whole = m->sums[m->count];
    batten_status status = BATTEN_OK;
    for (int k = 1, i = 0; k < count && status == BATTEN_OK; k++) {
        const double s = whole * k / count;
        while (i + 1 < m->count && m->sums[i + 1] < s)
            i++;
        piece p = {curve, m->is_flat, m->at[i], m->at[i + 1]};
        const double part = m->sums[i + 1] - m->sums[i];
        if (s <= m->sums[i] || part <= 0)
            u[k] = p.a;
        else if (s >= m->sums[i + 1])
            u[k] = p.b;
        else
            status = invert(&p, s - m->sums[i], part, tolerance, &u[k]);
    }
    return status;
}

batten_status batten_curve_divide_affine(const batten_curve *curve, int count, double tolerance,
                                         double *u)
{
    if (count < 1 || count > MOST_PARTS)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a curve is not cut into %d parts", count);
    if (!(tolerance > 0 && tolerance < 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance %g is not in (0, 1)", tolerance);
    measured m;
    const double size = bat_largest(curve->count * curve->dimension, curve->points);
    /* A first measure, for the unit. */
    const double unit = size > 0 ? bat_cbrt(size * size) : 1;
    batten_status status = measure_curve(curve, 0.01 * unit, &m);
    if (status != BATTEN_OK)
        return status;
    const double rough = m.sums[m.count];
    release_measured(&m);
    if (m.is_straight || !(rough > 0))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the curve is straight, so it has no affine length");
    double *found = bat_array((size_t)count + 1, sizeof *found);
    status = found ? measure_curve(curve, tolerance / 4 * rough, &m) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        status = divide(curve, &m, count, tolerance / 2 * rough, found);
        release_measured(&m);
    }
    if (status == BATTEN_OK) {
        found[0] = batten_curve_domain(curve).a;
        found[count] = batten_curve_domain(curve).b;
        memcpy(u, found, ((size_t)count + 1) * sizeof *u);
    }
    bat_release(found);
    return status;
}

/* ---- curvature ---- */

batten_status batten_curve_affine_curvature(const batten_curve *curve, double u,
                                            batten_side side, double *curvature)
{
    double v[5 * 2];
    if (curve->dimension != 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "affine curvature is that of plane curves");
    const batten_status status = batten_curve_evaluate_side(curve, u, side, 4, v);
    if (status != BATTEN_OK)
        return status;
    const double *first = v + 2, *second = v + 4, *third = v + 6, *fourth = v + 8;
    const double w = cross(first, second), size = bat_norm(2, first) * bat_norm(2, second);
    /* The product of two vectors that are parallel rounds to a few dozen eps of their sizes. */
    if (fabs(w) <= 1e-14 * size)
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve is straight or stops at u = %g", u);
    /* [23] w^(-5/3) - (w^(-2/3))'' / 2, with w' = [13] and w'' = [14] + [23] */
    const double slope = cross(first, third), root = bat_cbrt(w);
    const double eighth = root * root * w * w;
    *curvature =
        (3 * w * (4 * cross(second, third) + cross(first, fourth)) - 5 * slope * slope) /
        (9 * eighth);
    return BATTEN_OK;
}
