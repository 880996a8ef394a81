/* Curves that join the ends of two others smoothly, and which ends are nearest. */
#include "inspect/affine/side.h"
#include "numeric/vector.h"
#include "shape/local/hermite_data.h"
#include "spline/curve/curve.h"
#include <batten/blend.h>

enum { MOST = 4, MOST_DEGREE = 2 * MOST - 1 };

batten_status batten_curves_nearest_ends(const batten_curve *first, const batten_curve *second,
                                         batten_curve_end ends[2])
{
    static const batten_curve_end pairs[4][2] = {{BATTEN_CURVE_END, BATTEN_CURVE_START},
                                                 {BATTEN_CURVE_END, BATTEN_CURVE_END},
                                                 {BATTEN_CURVE_START, BATTEN_CURVE_START},
                                                 {BATTEN_CURVE_START, BATTEN_CURVE_END}};
    const batten_curve *curves[2] = {first, second};
    const int d = first->dimension;
    double points[2][2][3], least = HUGE_VAL;
    if (second->dimension != d)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions", d,
                        second->dimension);
    for (int k = 0; k < 4; k++) {
        const batten_interval domain = batten_curve_domain(curves[k / 2]);
        const batten_status status = batten_curve_evaluate(
            curves[k / 2], k % 2 ? domain.b : domain.a, 0, points[k / 2][k % 2]);
        if (status != BATTEN_OK)
            return status;
    }
    for (int k = 0; k < 4; k++) {
        const double gap = bat_distance(d, points[0][pairs[k][0]], points[1][pairs[k][1]]);
        if (!(gap < least))
            continue;
        least = gap;
        ends[0] = pairs[k][0];
        ends[1] = pairs[k][1];
    }
    return BATTEN_OK;
}

/* ---- derivatives at the ends ---- */

/* The standard speed of a blend over `chord` between two sides: where only tangents are asked,
 * that of the cubic nearest to an arc, 2 chord / (1 + the cosine of the angles from the chord),
 * for no more than 240 degrees; else one that changes little on the way. */
static double standard_speed(int d, const bat_side sides[2], const batten_blend_end ends[2],
                             double chord)
{
    const batten_vec3 way =
        bat_vec3_scale(bat_vec3_subtract(sides[1].c[0], sides[0].c[0]), 1 / chord);
    const double u[3] = {way.x, way.y, way.z};
    double t[2][3], along = 0;
    for (int k = 0; k < 2; k++) {
        const batten_vec3 tangent =
            bat_vec3_norm(sides[k].tangent) > 0 ? sides[k].tangent : way;
        t[k][0] = tangent.x;
        t[k][1] = tangent.y;
        t[k][2] = tangent.z;
        along += bat_dot(d, u, t[k]);
    }
    if (ends[0].continuity < 2 && ends[1].continuity < 2)
        return 4 * chord / bat_max(1, 2 + along);
    return 3 * chord * bat_middle_leg(d, u, t[0], t[1]);
}

/* A speed v turns the blend by v k, and by v^2 r / 2 with the rate r, in its unit of time. */
static double limit_speed(const bat_side *side, int continuity, double v)
{
    const double most = 4, k = bat_vec3_norm(side->curvature), r = bat_vec3_norm(side->rate);
    if (continuity >= 2 && v * k > most)
        v = most / k;
    if (continuity >= 3 && v * v * r / 2 > most)
        v = sqrt(2 * most / r);
    return v;
}

/* By arc length P' = T, P'' = K, P''' = R - |K|^2 T, with R the rate across the tangent. */
static void derivatives(const bat_side *side, double v, batten_vec3 out[MOST])
{
    const batten_vec3 k = side->curvature;
    out[0] = side->c[0];
    out[1] = bat_vec3_scale(side->tangent, v);
    out[2] = bat_vec3_scale(k, v * v);
    out[3] = bat_vec3_scale(bat_vec3_along(side->rate, -bat_vec3_dot(k, k), side->tangent),
                            v * v * v);
}

/* Bezier points 0 .. order from the derivatives at 0: b_k = sum of C(k, j) (n - j)! / n! P(j),
 * each one less than its binomial. `step` -1 runs backwards, from the last point. */
static void place_points(int n, int order, const batten_vec3 *derivative, int step,
                         batten_vec3 *out)
{
    for (int k = 0; k <= order; k++) {
        batten_vec3 sum = {0, 0, 0};
        double factor = 1; /* C(k, j) (n - j)! / n! step^j */
        for (int j = 0; j <= k; j++) {
            sum = bat_vec3_along(sum, factor, derivative[j]);
            factor *= (double)step * (k - j) / ((j + 1.0) * (n - j));
        }
        out[k * step] = sum;
    }
}

static void list_coordinates(int d, int count, const batten_vec3 *from, double *out)
{
    for (int i = 0; i < count; i++) {
        const double p[3] = {from[i].x, from[i].y, from[i].z};
        for (int k = 0; k < d; k++)
            out[i * d + k] = p[k];
    }
}

static batten_status build_blend(int d, const bat_side sides[2], const batten_blend_end ends[2],
                                 const double v[2], batten_curve **out)
{
    const int n = ends[0].continuity + ends[1].continuity + 1;
    const double breaks[2] = {0, 1};
    batten_vec3 derivative[MOST], b[MOST_DEGREE + 1];
    double points[(MOST_DEGREE + 1) * 3];
    for (int k = 0; k < 2; k++) {
        derivatives(&sides[k], v[k], derivative);
        place_points(n, ends[k].continuity, derivative, k ? -1 : 1, k ? b + n : b);
    }
    list_coordinates(d, n + 1, b, points);
    return batten_curve_from_bezier(d, (batten_pieces){n, 1, breaks}, points, NULL, out);
}

/* ---- the whole ---- */

static batten_status check_blend(const batten_curve *first, const batten_curve *second,
                                 const batten_blend_end ends[2])
{
    if (first->dimension == 1 || second->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "functions are blended as their graphs");
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                        first->dimension, second->dimension);
    for (int k = 0; k < 2; k++) {
        if (ends[k].continuity < 0 || ends[k].continuity > 3)
            return bat_fail(BATTEN_BAD_ARGUMENT, "continuity G%d at end %d, not G0 to G3",
                            ends[k].continuity, k + 1);
        if (!(ends[k].bulge > 0 && isfinite(ends[k].bulge)))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the bulge at end %d is %g, not above 0",
                            k + 1, ends[k].bulge);
    }
    return BATTEN_OK;
}

static batten_status look_at_end(const batten_curve *curve, const batten_blend_end *end,
                                 int which, bat_side *side)
{
    const batten_status status = bat_side_at_end(curve, end->end, which == 1, side);
    if (status == BATTEN_OK && end->continuity > 0 && side->singular)
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the %s curve stands still at its %s, where G%d is asked",
                        which ? "second" : "first",
                        end->end == BATTEN_CURVE_END ? "end" : "start", end->continuity);
    return status;
}

static batten_status verify_joins(const batten_curve *first, const batten_curve *second,
                                  const batten_blend_end ends[2], const batten_curve *blend,
                                  batten_curves_blend_report *report)
{
    batten_continuity *joins = report->joins;
    batten_status status = batten_curves_continuity(first, ends[0].end, blend,
                                                    BATTEN_CURVE_START, NULL, &joins[0]);
    if (status == BATTEN_OK)
        status = batten_curves_continuity(blend, BATTEN_CURVE_END, second, ends[1].end, NULL,
                                          &joins[1]);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        if (joins[k].geometric < ends[k].continuity)
            status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                              "the blend joins the %s curve with G%d, not G%d",
                              k ? "second" : "first", joins[k].geometric, ends[k].continuity);
    return status;
}

batten_status batten_curves_blend(const batten_curve *first, const batten_blend_end *first_end,
                                  const batten_curve *second,
                                  const batten_blend_end *second_end,
                                  batten_curves_blend_report *report, batten_curve **out)
{
    assert(first && first_end && second && second_end && out);
    const batten_blend_end ends[2] = {*first_end, *second_end};
    batten_curves_blend_report done = {0};
    batten_curve *made = NULL;
    bat_side sides[2];
    batten_status status = check_blend(first, second, ends);
    if (status == BATTEN_OK)
        status = look_at_end(first, &ends[0], 0, &sides[0]);
    if (status == BATTEN_OK)
        status = look_at_end(second, &ends[1], 1, &sides[1]);
    if (status != BATTEN_OK)
        return status;
    const double chord = bat_vec3_norm(bat_vec3_subtract(sides[1].c[0], sides[0].c[0]));
    if (!(chord > sides[0].roundoff[0] + sides[1].roundoff[0]))
        return bat_fail(BATTEN_COINCIDENT, "the ends are %g apart: nothing is between them",
                        chord);
    const double v = standard_speed(first->dimension, sides, ends, chord);
    for (int k = 0; k < 2; k++)
        done.speed[k] = ends[k].bulge * limit_speed(&sides[k], ends[k].continuity, v);
    status = build_blend(first->dimension, sides, ends, done.speed, &made);
    if (status == BATTEN_OK)
        status = verify_joins(first, second, ends, made, &done);
    if (status == BATTEN_OK) {
        if (report)
            *report = done;
        *out = made;
    } else {
        batten_curve_unref(made);
    }
    return status;
}
