/* What is true at one parameter of a curve: tangent, curvature, torsion, and their rounding. */
#include "inspect/local.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>

/* ---- one point ---- */

enum { HIGHEST = BATTEN_MAX_DEGREE };

double bat_curve_size(const batten_curve *curve)
{
    return bat_largest(curve->count * curve->dimension, curve->points);
}

batten_status bat_curve_check_size(const batten_curve *curve)
{
    /* Curvature multiplies two derivatives and a third: cubes of these sizes are still
     * numbers. */
    static const double least = 1e-120, most = 1e120;
    const double size = bat_curve_size(curve);
    if (size == 0 || (size >= least && size <= most))
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT,
                    "the largest coordinate is %g; from %g to %g can be worked with: choose "
                    "another unit",
                    size, least, most);
}

double bat_span_width(const batten_curve *curve, double u, batten_side side)
{
    if (bat_curve_place(curve, side, &u) != BATTEN_OK)
        return 1;
    const int k = bat_knots_span(curve->degree, curve->count, curve->knots, u, side);
    return curve->knots[k + 1] - curve->knots[k];
}

double bat_derivative_roundoff(const batten_curve *curve, int m, double size, double h)
{
    return 8 * DBL_EPSILON * size * bat_pow(2 * curve->degree / h, m);
}

/* The first derivative that does not vanish gives the direction; from the left an even one
 * points backwards. */
static batten_status singular(const batten_curve *curve, double u, batten_side side,
                              double size, double h, batten_curve_local *out)
{
    const int d = curve->dimension, order = bat_max_int(3, curve->degree);
    double values[(HIGHEST + 1) * 3];
    batten_status status = batten_curve_evaluate_side(curve, u, side, order, values);
    if (status != BATTEN_OK)
        return status;
    *out = (batten_curve_local){.point = bat_vec3_of(d, values)};
    for (int m = 2; m <= order; m++) {
        const double length = bat_norm(d, values + m * d);
        if (length <= bat_derivative_roundoff(curve, m, size, h))
            continue;
        const double sign = side == BATTEN_FROM_LEFT && m % 2 == 0 ? -1 : 1;
        out->tangent = bat_vec3_scale(bat_vec3_of(d, values + m * d), sign / length);
        break;
    }
    return bat_fail(BATTEN_SINGULAR_HERE, "the first derivative vanishes at u = %.17g", u);
}

/* Signed curvature, its rate and the frame, from C', C'', C''' in the plane. */
static void local_in_plane(const batten_vec3 c[4], batten_curve_local *out)
{
    const double v = out->speed, v2 = v * v;
    const double b = bat_vec3_cross(c[1], c[2]).z, rate = bat_vec3_cross(c[1], c[3]).z;
    out->curvature = b / (v2 * v);
    out->curvature_rate =
        rate / (v2 * v2) - 3 * out->curvature * bat_vec3_dot(c[1], c[2]) / (v2 * v);
    out->normal = (batten_vec3){-out->tangent.y, out->tangent.x, 0};
    out->binormal = (batten_vec3){0, 0, 1};
}

static void local_in_space(const batten_vec3 c[4], batten_side side, batten_curve_local *out)
{
    const double v = out->speed, v2 = v * v;
    const batten_vec3 b = bat_vec3_cross(c[1], c[2]), rate = bat_vec3_cross(c[1], c[3]);
    const double size = bat_vec3_norm(b);
    if (size <= 4 * DBL_EPSILON * v * bat_vec3_norm(c[2])) { /* straight here */
        out->curvature_rate =
            (side == BATTEN_FROM_LEFT ? -1 : 1) * bat_vec3_norm(rate) / (v2 * v2);
        return;
    }
    out->curvature = size / (v2 * v);
    out->curvature_rate = bat_vec3_dot(b, rate) / (size * v2 * v2) -
                          3 * out->curvature * bat_vec3_dot(c[1], c[2]) / (v2 * v);
    out->torsion = bat_vec3_dot(b, c[3]) / (size * size);
    out->binormal = bat_vec3_scale(b, 1 / size);
    out->normal = bat_vec3_cross(out->binormal, out->tangent);
}

void bat_local_of(int d, const double *values, batten_side side, batten_curve_local *out)
{
    const double speed = bat_norm(d, values + d);
    batten_vec3 c[4];
    for (int m = 0; m <= 3; m++)
        c[m] = bat_vec3_of(d, values + m * d);
    *out = (batten_curve_local){
        .point = c[0], .speed = speed, .tangent = bat_vec3_scale(c[1], 1 / speed)};
    if (d < 3)
        local_in_plane(c, out);
    else
        local_in_space(c, side, out);
}

batten_status bat_curve_local_at(const batten_curve *curve, double size, double u,
                                 batten_side side, batten_curve_local *out)
{
    const int d = curve->dimension;
    double values[4 * 3];
    batten_status status = batten_curve_evaluate_side(curve, u, side, 3, values);
    if (status != BATTEN_OK)
        return status;
    const double h = bat_span_width(curve, u, side), speed = bat_norm(d, values + d);
    if (speed <= bat_derivative_roundoff(curve, 1, size, h))
        return singular(curve, u, side, size, h, out);
    bat_local_of(d, values, side, out);
    return BATTEN_OK;
}

batten_status batten_curve_local_at(const batten_curve *curve, double u, batten_side side,
                                    batten_curve_local *out)
{
    return bat_curve_local_at(curve, bat_curve_size(curve), u, side, out);
}

/* ---- combs ---- */

static batten_status tooth(const batten_curve *curve, double size, double u, batten_side side,
                           double scale, batten_tooth *out)
{
    batten_curve_local at;
    const batten_status status = bat_curve_local_at(curve, size, u, side, &at);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    *out = (batten_tooth){.u = u,
                          .foot = at.point,
                          .tip = bat_vec3_along(at.point, -scale * at.curvature, at.normal),
                          .curvature = at.curvature};
    return BATTEN_OK;
}

batten_status batten_curve_comb(const batten_curve *curve, int per_span, double scale,
                                batten_tooth *teeth)
{
    if (per_span < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d teeth on a span, at least 1 is needed",
                        per_span);
    if (!isfinite(scale))
        return bat_fail(BATTEN_NOT_FINITE, "the scale of the comb is %g", scale);
    const int spans = batten_curve_spans(curve, NULL) - 1;
    const size_t each = (size_t)per_span + 1, count = (size_t)spans * each;
    const double size = bat_curve_size(curve);
    double *breaks = bat_array((size_t)spans + 1, sizeof *breaks);
    batten_tooth *made = bat_array(count, sizeof *made);
    batten_status status = breaks && made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(curve, breaks);
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        const size_t span = k / each, part = k % each;
        const bool last = part + 1 == each;
        const double a = breaks[span], b = breaks[span + 1];
        const double u = last ? b : a + (b - a) * ((double)part / per_span);
        status =
            tooth(curve, size, u, last ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, scale, &made[k]);
    }
    for (size_t k = 0; status == BATTEN_OK && k < count; k++)
        teeth[k] = made[k];
    bat_release(made);
    bat_release(breaks);
    return status;
}
