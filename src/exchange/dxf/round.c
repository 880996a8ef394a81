/* Circles, arcs and ellipses, from and to the numbers that DXF has for them. */
#include "exchange/dxf/round.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/round_curve.h"
#include "numeric/vector.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

/* ---- from the curve to the entity ---- */

/* What is found: an ellipse, and from where to where the curve goes along it. */
typedef struct {
    batten_vec3 centre, x, y, z; /* y = z cross x, along the axes */
    double a, b, from, sweep;
    bool is_full;
} found;

/* Of the curve that is looked at: its pieces, and how far beside an ellipse they may be. */
typedef struct {
    const batten_curve *bezier;
    int pieces;
    double far, tolerance; /* the largest coordinate */
} looking;

/*
 * The ellipse of the first piece. With the weights 1, w, 1 it goes from -phi to phi, cos phi =
 * w, along two conjugate half diameters: one to the middle control point, the other along the
 * chord. False when it is no ellipse.
 */
static bool first_ellipse(const looking *l, batten_vec3 *centre, batten_vec3 *p, batten_vec3 *q)
{
    const double *P = batten_curve_points(l->bezier), *W = batten_curve_weights(l->bezier);
    const double w = W[1] / sqrt(W[0] * W[2]), rest = (1 - w) * (1 + w);
    const batten_vec3 a = bat_dxf_vector(P), b = bat_dxf_vector(P + 3),
                      c = bat_dxf_vector(P + 6);
    /* 1 - w^2 and w have lost half of their digits below the root of DBL_EPSILON. */
    if (!(rest > 1e-8 && w > 1e-8))
        return false;
    const batten_vec3 middle = bat_vec3_along(a, 0.5, bat_vec3_subtract(c, a));
    const batten_vec3 up = bat_vec3_subtract(b, middle);
    *centre = bat_vec3_along(middle, -w * w / rest, up);
    *p = bat_vec3_scale(up, w / rest);
    *q = bat_vec3_scale(bat_vec3_subtract(c, a), 0.5 / sqrt(rest));
    return true;
}

/* Half axes of the ellipse with these conjugate half diameters; of a circle the first stays.
 * What short pieces say of them is rough: the radius is the distance of the first point from
 * the centre, and whether it is a circle is seen along the whole. */
static bool find_axes(const looking *l, batten_vec3 p, batten_vec3 q, found *f)
{
    const double *P = batten_curve_points(l->bezier);
    const double pp = bat_vec3_dot(p, p), qq = bat_vec3_dot(q, q), pq = bat_vec3_dot(p, q);
    const double chord =
        bat_distance(3, P, P + 6) / 2; /* |q| times the sine of half the angle */
    const batten_vec3 normal = bat_vec3_cross(p, q);
    const double area = bat_vec3_norm(normal);
    if (!(area > 1e-6 * (pp + qq)) || !isfinite(pp + qq))
        return false;
    f->z = bat_vec3_scale(normal, 1 / area);
    const double rough = l->tolerance * bat_max(1, qq / (chord * chord));
    const bool is_circle = bat_hypot(2 * pq, pp - qq) <= rough * sqrt(pp + qq);
    const double t = is_circle ? 0 : bat_atan2(2 * pq, pp - qq) / 2;
    const batten_vec3 x = bat_vec3_along(bat_vec3_scale(p, bat_cos(t)), bat_sin(t), q);
    f->a = bat_vec3_norm(x);
    f->x = bat_vec3_scale(x, 1 / f->a);
    f->b = area / f->a;
    if (is_circle)
        f->a = f->b = bat_vec3_norm(bat_vec3_subtract(bat_dxf_vector(P), f->centre));
    f->y = bat_vec3_cross(f->z, f->x);
    return true;
}

/* The angle of a point on the ellipse; false when it is beside it. */
static bool angle_of(const looking *l, const found *f, const double point[3], double *angle)
{
    const batten_vec3 d = bat_vec3_subtract(bat_dxf_vector(point), f->centre);
    const double x = bat_vec3_dot(d, f->x) / f->a, y = bat_vec3_dot(d, f->y) / f->b;
    *angle = bat_atan2(y, x);
    return fabs(bat_vec3_dot(d, f->z)) <= l->tolerance &&
           fabs(bat_hypot(x, y) - 1) * f->a <= l->tolerance;
}

/* Does the whole curve go along the ellipse, onwards and at most once? A conic is where another
 * is when they share five points. */
static batten_status follow(const looking *l, found *f, bool *does)
{
    double last = 0, sum = 0;
    *does = true;
    for (int i = 0; i <= 4 * l->pieces && *does; i++) {
        double u[2], point[3], angle;
        const double *breaks = batten_curve_knots(l->bezier);
        u[0] = breaks[2 * bat_min_int(i / 4, l->pieces - 1) + 2];
        u[1] = breaks[2 * bat_min_int(i / 4, l->pieces - 1) + 4];
        const double at = i == 4 * l->pieces ? u[1] : u[0] + (u[1] - u[0]) * (i % 4) / 4;
        const batten_status status = batten_curve_evaluate(l->bezier, at, 0, point);
        if (status != BATTEN_OK)
            return status;
        *does = angle_of(l, f, point, &angle);
        if (i == 0) {
            f->from = angle;
        } else {
            const double step = remainder(angle - last, 2 * BAT_PI);
            *does = *does && step > 0;
            sum += step;
        }
        last = angle;
    }
    f->sweep = sum;
    f->is_full = fabs(sum - 2 * BAT_PI) <= BAT_WRITTEN;
    /* A sweep of less than a microradian has no centre that its points could tell. */
    *does = *does && (f->is_full || (sum < 2 * BAT_PI && sum > 1e-6));
    return BATTEN_OK;
}

/* ---- numbers that stay when they are found again ---- */

/* To a multiple of 10^n, |n| <= 22: such powers are exact. */
static double to_places(double x, int n)
{
    const double power = bat_pow(10, abs(n));
    return n < 0 ? round(x * power) / power : round(x / power) * power;
}

/* The powers of ten to which numbers are rounded; `angle` also for what has no unit. */
typedef struct {
    int centre, size, axis, angle;
} places;

static batten_vec3 vector_to_places(batten_vec3 v, int n)
{
    return (batten_vec3){to_places(v.x, n), to_places(v.y, n), to_places(v.z, n)};
}

/* As the reader has the normal of the file. */
static batten_vec3 unit_of(batten_vec3 z)
{
    return bat_vec3_scale(z, 1 / bat_vec3_norm(z));
}

/* Made a unit vector and rounded again it must come out the same. */
static batten_vec3 settled_normal(batten_vec3 z)
{
    for (int i = 0; i < 4; i++)
        z = unit_of(vector_to_places(z, -13));
    return vector_to_places(z, -13);
}

static double angle_to_places(double angle, double turn, int n)
{
    const double rest = fmod(angle, turn);
    const double place = to_places(rest < 0 ? rest + turn : rest, n);
    return place >= turn ? 0 : place + 0.0;
}

/* The radius is measured from the centre that is written. */
static batten_status settle_circle(const looking *l, found *f, const places *n,
                                   bat_dxf_round *out, bool *does)
{
    const batten_frame axes = bat_dxf_axes(unit_of(bat_dxf_vector(out->normal)));
    const batten_vec3 y = bat_vec3_cross(axes.z, axes.x);
    const batten_vec3 at = vector_to_places((batten_vec3){bat_vec3_dot(f->centre, axes.x),
                                                          bat_vec3_dot(f->centre, y),
                                                          bat_vec3_dot(f->centre, axes.z)},
                                            n->centre);
    const batten_vec3 start = bat_dxf_vector(batten_curve_points(l->bezier));
    bat_dxf_put_vector(at, out->centre);
    f->centre =
        bat_vec3_along(bat_vec3_along(bat_vec3_scale(axes.x, at.x), at.y, y), at.z, axes.z);
    out->size = to_places(bat_vec3_norm(bat_vec3_subtract(start, f->centre)), n->size);
    f->a = f->b = out->size;
    const batten_status status = out->size > 0 ? follow(l, f, does) : BATTEN_OK;
    if (status != BATTEN_OK || !(out->size > 0) || !*does)
        return status;
    out->kind = f->is_full ? BAT_DXF_CIRCLE : BAT_DXF_ARC;
    if (f->is_full)
        return BATTEN_OK;
    const double from = f->from + bat_atan2(bat_vec3_dot(f->x, y), bat_vec3_dot(f->x, axes.x));
    out->angles[0] = angle_to_places(from * 180 / BAT_PI, 360, n->angle + 2);
    out->angles[1] = angle_to_places((from + f->sweep) * 180 / BAT_PI, 360, n->angle + 2);
    if (out->normal[2] == -1)
        out->kind = BAT_DXF_NOT_ROUND;
    return BATTEN_OK;
}

/* Of the two long half axes the one near which a full turn begins; of a part that with its
 * first large component above 0, so that the choice does not hang on rounding. */
static bool takes_other_axis(const found *f)
{
    if (f->is_full)
        return bat_cos(f->from) < -1e-6;
    const double x[3] = {f->x.x, f->x.y, f->x.z};
    const double most = bat_largest(3, x);
    int k = 0;
    while (fabs(x[k]) < most / 2)
        k++;
    return x[k] < 0;
}

static void settle_ellipse(const found *f, const places *n, bat_dxf_round *out)
{
    const bool other = takes_other_axis(f);
    const double from = f->from + (other ? BAT_PI : 0);
    const batten_vec3 axis = bat_vec3_scale(f->x, other ? -f->a : f->a);
    out->kind = BAT_DXF_ELLIPSE;
    bat_dxf_put_vector(vector_to_places(f->centre, n->centre), out->centre);
    bat_dxf_put_vector(vector_to_places(axis, n->axis), out->axis);
    out->size = to_places(f->b / f->a, n->angle);
    out->angles[0] = f->is_full ? 0 : angle_to_places(from, 2 * BAT_PI, n->angle);
    out->angles[1] =
        f->is_full ? 2 * BAT_PI : angle_to_places(from + f->sweep, 2 * BAT_PI, n->angle);
}

/*
 * How far rounding moves what is found: the centre by as much more as the pieces that a reader
 * makes are short (a square of the half angle), the axes by as much more as they are alike.
 */
static places places_of(const looking *l, const found *f)
{
    const double half = f->sweep / (2 * ceil(f->sweep / (BAT_PI / 2) - 1e-6));
    const double unlike = f->a == f->b ? 1 : 1 - f->b / f->a;
    /* Some 50 roundings of DBL_EPSILON in finding the axes. */
    const double coordinate = bat_max(1e-14 * f->a, 4 * DBL_EPSILON * l->far);
    const double centre =
        4 * DBL_EPSILON * (l->far + f->a) / (2 * bat_sin(half) * bat_sin(half));
    return (places){.centre = (int)ceil(bat_log10(bat_max(centre, coordinate))),
                    .size = (int)ceil(bat_log10(coordinate)),
                    .axis = (int)ceil(bat_log10(coordinate / unlike)),
                    /* three times as many roundings for angles, which divide */
                    .angle = (int)ceil(bat_log10(coordinate / (f->a * unlike) + 3e-14))};
}

/* Nearly a circle its axes would have to be rough: it stays what it is. */
static bool are_fine(const looking *l, const found *f, const places *n)
{
    const double limit = 2e-12 * f->a + 64 * DBL_EPSILON * l->far;
    if (abs(n->centre) > 22 || abs(n->size) > 22 || abs(n->axis) > 22 || n->angle < -20 ||
        n->angle > -6)
        return false;
    return bat_pow(10, n->axis) <= limit && bat_pow(10, n->angle) * f->a <= limit;
}

/* A full turn looks upward. */
static batten_status settle(const looking *l, found *f, bat_dxf_round *out)
{
    const places n = places_of(l, f);
    const batten_vec3 z = settled_normal(f->z);
    bool does = false;
    if (!are_fine(l, f, &n))
        return BATTEN_OK;
    bat_dxf_put_vector(f->is_full && z.z < 0 ? bat_vec3_scale(z, -1) : z, out->normal);
    if (f->a == f->b)
        return settle_circle(l, f, &n, out, &does);
    if (f->is_full && z.z < 0)
        f->from = -f->from;
    settle_ellipse(f, &n, out);
    return BATTEN_OK;
}

/* ---- the whole ---- */

static batten_status recognise_round(const batten_curve *curve, bat_dxf_round *out)
{
    const batten_box box = batten_curve_box(curve);
    const double low[3] = {box.low.x, box.low.y, box.low.z};
    const double high[3] = {box.high.x, box.high.y, box.high.z};
    looking l = {.far = bat_max(bat_largest(3, low), bat_largest(3, high))};
    /* Numbers of 12 digits, so 4e-13 of the size, and the rounding of coordinates far out. */
    l.tolerance = 4e-13 * bat_distance(3, low, high) + 16 * DBL_EPSILON * l.far;
    batten_curve *bezier = NULL;
    batten_status status = batten_curve_to_bezier(curve, &bezier);
    if (status != BATTEN_OK)
        return status;
    l.bezier = bezier;
    l.pieces = batten_curve_spans(bezier, NULL) - 1;
    found f = {.centre = {0, 0, 0}};
    batten_vec3 p, q;
    bool follows = batten_curve_point_count(bezier) == 2 * l.pieces + 1 &&
                   first_ellipse(&l, &f.centre, &p, &q) && find_axes(&l, p, q, &f);
    if (follows)
        status = follow(&l, &f, &follows);
    if (status == BATTEN_OK && follows)
        status = settle(&l, &f, out);
    batten_curve_unref(bezier);
    return status;
}

/* Are the ends of the two where they shall be? Inside both are the same arc. */
static bool ends_agree(const batten_curve *a, const batten_curve *b)
{
    const batten_box box = batten_curve_box(a);
    const double low[3] = {box.low.x, box.low.y, box.low.z};
    const double high[3] = {box.high.x, box.high.y, box.high.z};
    const double far = bat_max(bat_largest(3, low), bat_largest(3, high));
    const int last[2] = {batten_curve_point_count(a) - 1, batten_curve_point_count(b) - 1};
    /* Twice the tolerance of looking: two curves are compared. */
    const double within = 8e-13 * bat_distance(3, low, high) + 64 * DBL_EPSILON * far;
    const double *P = batten_curve_points(a), *Q = batten_curve_points(b);
    return bat_distance(3, P, Q) <= within &&
           bat_distance(3, P + 3 * last[0], Q + 3 * last[1]) <= within;
}

/* The numbers that are found in the curve that a reader makes of these. */
static batten_status find_again(const batten_curve *curve, const bat_dxf_round *round,
                                bat_dxf_round *again, bool *is_there)
{
    bat_dxf_round read = *round;
    batten_curve *made = NULL;
    bat_dxf_put_vector(unit_of(bat_dxf_vector(round->normal)), read.normal);
    *is_there = false;
    batten_status status = bat_dxf_round_curve(&read, &made);
    if (status == BATTEN_OK)
        status = recognise_round(made, again);
    if (status == BATTEN_OK)
        *is_there = round->kind == BAT_DXF_CIRCLE || round->angles[1] == 2 * BAT_PI ||
                    ends_agree(curve, made);
    batten_curve_unref(made);
    return status == BATTEN_OUT_OF_MEMORY ? status : BATTEN_OK;
}

/* What is found again may be found again itself, when rounding moved the first numbers. */
batten_status bat_dxf_round_of(const batten_curve *curve, bat_dxf_round *out)
{
    enum { TRIES = 5 };
    bat_dxf_round first;
    bool is_there = true, is_same = false;
    memset(&first, 0, sizeof first); /* they are compared byte for byte */
    *out = first;
    if (batten_curve_degree(curve) != 2 || !batten_curve_is_rational(curve))
        return BATTEN_OK;
    batten_status status = recognise_round(curve, &first);
    for (int i = 0; i < TRIES && status == BATTEN_OK && is_there && !is_same &&
                    first.kind != BAT_DXF_NOT_ROUND;
         i++) {
        bat_dxf_round again;
        memset(&again, 0, sizeof again);
        status = find_again(curve, &first, &again, &is_there);
        is_same = memcmp(&first, &again, sizeof first) == 0;
        first = again;
    }
    if (status == BATTEN_OK && is_there && is_same)
        *out = first;
    return status;
}
