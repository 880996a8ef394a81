/* How smoothly curves join: gap, angle, curvature and its rate, and what rounding hides. */
#include "inspect/continuity.h"
#include "inspect/affine/side.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

enum { ORDER = BAT_SIDE_ORDER };

batten_curve_continuity_options batten_curve_continuity_defaults(void)
{
    return (batten_curve_continuity_options){.size = sizeof(batten_curve_continuity_options),
                                             .angle = 1.7453292519943296e-4, /* 0.01 degrees */
                                             .curvature = 0.01,
                                             .derivative = 1e-6};
}

/* With s the arc length: C' = v Cs, C'' = v' Cs + v^2 Css, C''' = .. Cs + 3 v v' Css + v^3
 * Csss. */
static void by_arc_length(bat_side *s)
{
    const double v = bat_vec3_norm(s->c[1]);
    const batten_vec3 t = bat_vec3_scale(s->c[1], 1 / v);
    const double v1 = bat_vec3_dot(t, s->c[2]);
    s->curvature = bat_vec3_scale(bat_vec3_along(s->c[2], -v1, t), 1 / (v * v));
    const batten_vec3 across = bat_vec3_along(s->c[3], -bat_vec3_dot(t, s->c[3]), t);
    s->rate =
        bat_vec3_scale(bat_vec3_along(across, -3 * v * v1, s->curvature), 1 / (v * v * v));
}

/* @param way -1 when the curve is run backwards */
static batten_status side_at(const batten_curve *curve, double size, double u, batten_side from,
                             double way, bat_side *out)
{
    const int d = curve->dimension;
    const double h = bat_span_width(curve, u, from);
    batten_curve_local local;
    double values[(ORDER + 1) * 3], sign = 1;
    batten_status status = batten_curve_evaluate_side(curve, u, from, ORDER, values);
    if (status == BATTEN_OK)
        status = bat_curve_local_at(curve, size, u, from, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = (bat_side){.singular = status == BATTEN_SINGULAR_HERE};
    for (int m = 0; m <= ORDER; m++, sign *= way) {
        out->c[m] = bat_vec3_scale(bat_vec3_of(d, values + m * d), sign);
        out->roundoff[m] = bat_derivative_roundoff(curve, m, size, h);
    }
    out->tangent = bat_vec3_scale(local.tangent, way);
    if (!out->singular)
        by_arc_length(out);
    return BATTEN_OK;
}

batten_status bat_side_at_end(const batten_curve *curve, batten_curve_end end, bool away,
                              bat_side *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const bool last = end == BATTEN_CURVE_END;
    return side_at(curve, bat_curve_size(curve), last ? domain.b : domain.a,
                   last ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, last == away ? -1 : 1, out);
}

static double difference(batten_vec3 a, batten_vec3 b)
{
    return bat_vec3_norm(bat_vec3_subtract(a, b));
}

/* What is left of r when the best multiple of l is taken off. */
static double fit(batten_vec3 r, batten_vec3 l, double *factor)
{
    *factor = bat_vec3_dot(r, l) / bat_vec3_dot(l, l);
    return bat_vec3_norm(bat_vec3_along(r, -*factor, l));
}

static void fit_betas(const bat_side *l, const bat_side *r, batten_continuity *out)
{
    double *b = out->beta;
    if (l->singular) {
        for (int k = 0; k < 3; k++)
            b[k] = out->residual[k] = NAN;
        return;
    }
    const batten_vec3 *c = l->c;
    out->residual[0] = fit(r->c[1], c[1], &b[0]);
    out->residual[1] = fit(bat_vec3_along(r->c[2], -b[0] * b[0], c[2]), c[1], &b[1]);
    const batten_vec3 third = bat_vec3_along(r->c[3], -b[0] * b[0] * b[0], c[3]);
    out->residual[2] = fit(bat_vec3_along(third, -3 * b[0] * b[1], c[2]), c[1], &b[2]);
}

static int parametric_order(const bat_side *l, const bat_side *r, double tolerance)
{
    int k = 0;
    for (; k < ORDER; k++) {
        const batten_vec3 a = l->c[k + 1], b = r->c[k + 1];
        const double larger = bat_max(bat_vec3_norm(a), bat_vec3_norm(b));
        if (difference(a, b) > tolerance * larger + l->roundoff[k + 1] + r->roundoff[k + 1])
            break;
    }
    return k;
}

double bat_side_roundoff(const bat_side *s, int m)
{
    const double v = bat_vec3_norm(s->c[1]);
    double power = v, sum = 0;
    for (int k = 1; k <= m; k++, power *= v)
        sum += s->roundoff[k] / power;
    return sum;
}

/* Of curves in the plane the sign of a vector across the tangent says to which side it points;
 * in space it has none. */
static double size_across(int d, batten_vec3 tangent, batten_vec3 a)
{
    const double size = bat_vec3_norm(a);
    return d < 3 && bat_vec3_cross(tangent, a).z < 0 ? -size : size;
}

static void compare_bending(int d, const bat_side *l, const bat_side *r, double straight,
                            double size, batten_continuity *out)
{
    const bat_side *sides[2] = {l, r};
    out->curvature_difference = out->curvature_part = NAN;
    out->rate_difference = out->rate_part = NAN;
    for (int k = 0; k < 2; k++) {
        const bat_side *s = sides[k];
        out->curvature[k] =
            s->singular ? (double)NAN : size_across(d, s->tangent, s->curvature);
        out->rate[k] = s->singular ? (double)NAN : size_across(d, s->tangent, s->rate);
    }
    if (l->singular || r->singular)
        return;
    const double bent = bat_max(bat_vec3_norm(l->curvature), bat_vec3_norm(r->curvature));
    const double rate = bat_max(bat_vec3_norm(l->rate), bat_vec3_norm(r->rate));
    const double calm = bent / size + straight / size;
    out->curvature_difference = difference(l->curvature, r->curvature);
    out->curvature_part = out->curvature_difference / bat_max(bent, straight);
    out->rate_difference = difference(l->rate, r->rate);
    out->rate_part = out->rate_difference / bat_max(rate, calm);
}

static int geometric_order(const bat_side *l, const bat_side *r,
                           const batten_curve_continuity_options *o, const batten_continuity *c)
{
    if (l->singular || r->singular || !(c->angle <= o->angle))
        return 0;
    /* A part that rounding alone may make is none. */
    const double noise2 = bat_side_roundoff(l, 2) + bat_side_roundoff(r, 2);
    if (c->curvature_part > o->curvature && c->curvature_difference > noise2)
        return 1;
    const double noise3 = bat_side_roundoff(l, 3) + bat_side_roundoff(r, 3);
    return c->rate_part > o->curvature && c->rate_difference > noise3 ? 2 : 3;
}

static void compare(int d, const bat_side *l, const bat_side *r, double size,
                    const batten_curve_continuity_options *o, batten_continuity *out)
{
    /* As the documentation of the options says: a millionth of the size. */
    const double gap = o->gap > 0 ? o->gap : 1e-6 * size;
    const batten_vec3 a = l->tangent, b = r->tangent;
    out->gap = difference(l->c[0], r->c[0]);
    out->angle = bat_vec3_norm(a) > 0 && bat_vec3_norm(b) > 0
                     ? bat_atan2(bat_vec3_norm(bat_vec3_cross(a, b)), bat_vec3_dot(a, b))
                     : (double)NAN;
    out->singular[0] = l->singular;
    out->singular[1] = r->singular;
    out->reversed = out->angle >= BAT_PI - o->angle;
    fit_betas(l, r, out);
    compare_bending(d, l, r, size > 0 ? gap / (size * size) : 0, size > 0 ? size : 1, out);
    const bool meets = out->gap <= gap + l->roundoff[0] + r->roundoff[0];
    out->parametric = meets ? parametric_order(l, r, o->derivative) : -1;
    out->geometric = meets ? geometric_order(l, r, o, out) : -1;
}

batten_status bat_continuity_bounds(const batten_curve_continuity_options *given,
                                    batten_curve_continuity_options *out)
{
    *out = batten_curve_continuity_defaults();
    const batten_status status = BAT_TAKE_OPTIONS(batten_curve_continuity_options, given, out);
    if (status != BATTEN_OK)
        return status;
    const double values[] = {out->gap, out->angle, out->curvature, out->derivative};
    for (int k = 0; k < 4; k++)
        if (!(values[k] >= 0 && isfinite(values[k])))
            return bat_fail(BATTEN_BAD_ARGUMENT, "a tolerance of continuity is %g", values[k]);
    return BATTEN_OK;
}

static double size_of(const batten_curve *curve)
{
    const batten_box box = batten_curve_box(curve);
    return difference(box.low, box.high);
}

batten_status batten_curves_continuity(const batten_curve *first, batten_curve_end first_end,
                                       const batten_curve *second, batten_curve_end second_end,
                                       const batten_curve_continuity_options *options,
                                       batten_continuity *out)
{
    batten_curve_continuity_options o;
    batten_status status = bat_continuity_bounds(options, &o);
    if (status == BATTEN_OK && first->dimension != second->dimension)
        status = bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                          first->dimension, second->dimension);
    if (status != BATTEN_OK)
        return status;
    const batten_interval domain = batten_curve_domain(first);
    const double u = first_end == BATTEN_CURVE_END ? domain.b : domain.a;
    bat_side l, r;
    status = bat_side_at_end(first, first_end, false, &l);
    if (status == BATTEN_OK)
        status = bat_side_at_end(second, second_end, true, &r);
    if (status != BATTEN_OK)
        return status;
    *out = (batten_continuity){.u = u};
    compare(first->dimension, &l, &r, bat_max(size_of(first), size_of(second)), &o, out);
    return BATTEN_OK;
}

static batten_status join_at(const batten_curve *curve, double before, double behind,
                             double extent, double size,
                             const batten_curve_continuity_options *o, batten_continuity *out)
{
    bat_side l, r;
    batten_status status = side_at(curve, size, before, BATTEN_FROM_LEFT, 1, &l);
    if (status == BATTEN_OK)
        status = side_at(curve, size, behind, BATTEN_FROM_RIGHT, 1, &r);
    if (status != BATTEN_OK)
        return status;
    *out = (batten_continuity){.u = before};
    compare(curve->dimension, &l, &r, extent, o, out);
    return BATTEN_OK;
}

batten_status batten_curve_continuity(const batten_curve *curve,
                                      const batten_curve_continuity_options *options,
                                      batten_continuities *out)
{
    batten_curve_continuity_options o;
    batten_status status = bat_continuity_bounds(options, &o);
    if (status != BATTEN_OK)
        return status;
    const int breaks = batten_curve_spans(curve, NULL);
    const double extent = size_of(curve), size = bat_curve_size(curve);
    /* The same default as that of a joint. */
    const bool closed = batten_curve_is_closed(curve, o.gap > 0 ? o.gap : 1e-6 * extent);
    double *knots = bat_array((size_t)breaks, sizeof *knots);
    batten_continuity *at = bat_array((size_t)breaks, sizeof *at);
    status = knots && at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int count = 0;
    if (status == BATTEN_OK)
        batten_curve_spans(curve, knots);
    for (int k = 1; status == BATTEN_OK && k + 1 < breaks; k++)
        status = join_at(curve, knots[k], knots[k], extent, size, &o, &at[count++]);
    if (status == BATTEN_OK && closed)
        status = join_at(curve, knots[breaks - 1], knots[0], extent, size, &o, &at[count++]);
    if (status == BATTEN_OK)
        *out = (batten_continuities){count, at};
    else
        bat_release(at);
    bat_release(knots);
    return status;
}
