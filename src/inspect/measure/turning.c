/* How often a closed curve turns, and how often it winds around a point. */
#include "inspect/closed.h"
#include "inspect/inflections.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>
#include <batten/nearest.h>

#include <string.h>

/* ---- windings ---- */

/* Where y turns back, and both ends. */
static batten_status one_way(const batten_curve *curve, batten_parameters *out)
{
    const batten_interval domain = batten_curve_domain(curve);
    const batten_parameters ends = {2, (double[2]){domain.a, domain.b}};
    batten_parameters turns = {0, NULL};
    batten_status status = batten_curve_turns(curve, (batten_vec3){0, 1, 0}, &turns);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&turns, &ends, (batten_interval){0, 0}, out);
    bat_release(turns.at);
    return status;
}

/* The x at which y passes the height of the point, between a, on one side, and b. */
static batten_status pass(const batten_curve *curve, double height, double a, double b,
                          bool rising, double *x)
{
    double point[2] = {0, 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < 64; i++) {
        const double middle = a + (b - a) / 2;
        status = batten_curve_evaluate(curve, middle, 0, point);
        if ((point[1] <= height) == rising)
            a = middle;
        else
            b = middle;
    }
    *x = point[0];
    return status;
}

/* +1 or -1 when the way from y = from to y = to passes the height: each height belongs to what
 * lies above it. */
static int passes(double from, double to, double height)
{
    return (to > height) - (from > height);
}

static batten_status count_windings(const batten_curve *curve, const batten_parameters *ways,
                                    const double *point, int *out)
{
    double first[2] = {0, 0}, from[2] = {0, 0}, to[2];
    batten_status status = BATTEN_OK;
    int count = 0;
    for (int i = 0; status == BATTEN_OK && i < ways->count; i++, memcpy(from, to, sizeof to)) {
        status = batten_curve_evaluate_side(curve, ways->at[i],
                                            i ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, 0, to);
        if (i == 0) {
            memcpy(first, to, sizeof to);
            continue;
        }
        const int way = status == BATTEN_OK ? passes(from[1], to[1], point[1]) : 0;
        double x;
        if (way == 0)
            continue;
        status = pass(curve, point[1], ways->at[i - 1], ways->at[i], way > 0, &x);
        count += x > point[0] ? way : 0;
    }
    if (passes(from[1], first[1], point[1]) && from[0] > point[0])
        count += passes(from[1], first[1], point[1]); /* the line that closes it */
    *out = count;
    return status;
}

batten_status batten_curve_winding(const batten_curve *curve, batten_vec2 point, double closed,
                                   int *out)
{
    const double point_xy[2] = {point.x, point.y};
    batten_parameters ways = {0, NULL};
    batten_deviation near;
    int count = 0;
    batten_status status = bat_closed_check(curve, closed);
    if (status == BATTEN_OK)
        status = batten_curve_deviation(
            curve, (batten_points){batten_curve_dimension(curve), 1, point_xy}, NULL, NULL,
            NULL, &near);
    /* Within some thousand roundings the point is on it. */
    if (status == BATTEN_OK && near.max <= 1e-12 * bat_curve_size(curve))
        status = bat_fail(BATTEN_SINGULAR_HERE, "(%g, %g) lies on the curve", point_xy[0],
                          point_xy[1]);
    if (status == BATTEN_OK)
        status = one_way(curve, &ways);
    if (status == BATTEN_OK)
        status = count_windings(curve, &ways, point_xy, &count);
    if (status == BATTEN_OK)
        *out = count;
    bat_release(ways.at);
    return status;
}

/* ---- turning ---- */

static batten_status tangent_at(const batten_curve *curve, double size, double u,
                                batten_side side, batten_vec3 *out)
{
    batten_curve_local local;
    const batten_status status = bat_curve_local_at(curve, size, u, side, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    if (!(bat_vec3_norm(local.tangent) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve has no direction at u = %.17g", u);
    *out = local.tangent;
    return BATTEN_OK;
}

/* The angle from one direction to the next, which must stay below `most`. */
static batten_status add_angle(batten_vec3 a, batten_vec3 b, double most, double u, double *sum)
{
    const double angle = bat_atan2(bat_vec3_cross(a, b).z, bat_vec3_dot(a, b));
    if (fabs(angle) > most)
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve has a cusp near u = %.17g", u);
    *sum += angle;
    return BATTEN_OK;
}

/* All places where the tangent may pass the direction of an axis, and all knots: between two of
 * them it stays within a right angle. */
static batten_status quadrants(const batten_curve *curve, batten_parameters *out)
{
    const batten_interval exactly = {0, 0};
    batten_parameters x = {0, NULL}, y = {0, NULL}, both = {0, NULL};
    batten_parameters knots = {batten_curve_spans(curve, NULL), NULL};
    knots.at = bat_array((size_t)knots.count, sizeof *knots.at);
    batten_status status = knots.at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        batten_curve_spans(curve, knots.at);
        status = batten_curve_turns(curve, (batten_vec3){1, 0, 0}, &x);
    }
    if (status == BATTEN_OK)
        status = batten_curve_turns(curve, (batten_vec3){0, 1, 0}, &y);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&x, &y, exactly, &both);
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&both, &knots, exactly, out);
    bat_release(both.at);
    bat_release(knots.at);
    bat_release(y.at);
    bat_release(x.at);
    return status;
}

static batten_status sum_angles(const batten_curve *curve, const batten_parameters *at,
                                bool closed, double *sum)
{
    /* A turn is measured between tangents, which keep seven digits at a cusp: within that a
     * quarter turn or a half is told from a little less. */
    const double size = bat_curve_size(curve), right = BAT_PI / 2 + 1e-6, full = BAT_PI - 1e-7;
    batten_vec3 first = {0, 0, 0}, left, right_side = {0, 0, 0};
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < at->count; i++) {
        const double u = at->at[i];
        if (i > 0)
            status = tangent_at(curve, size, u, BATTEN_FROM_LEFT, &left);
        if (status == BATTEN_OK && i > 0)
            status = add_angle(right_side, left, right, u, sum);
        if (status != BATTEN_OK || i + 1 == at->count)
            break;
        status = tangent_at(curve, size, u, BATTEN_FROM_RIGHT, &right_side);
        if (i == 0)
            first = right_side;
        else if (status == BATTEN_OK)
            status = add_angle(left, right_side, full, u, sum);
    }
    if (status == BATTEN_OK && closed)
        status = add_angle(left, first, full, at->at[0], sum);
    return status;
}

batten_status batten_curve_turning(const batten_curve *curve, double closed, double *out)
{
    batten_parameters at = {0, NULL};
    double sum = 0;
    if (curve->dimension != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a curve of %d dimensions has no turning number",
                        curve->dimension);
    if (!(closed >= 0 && isfinite(closed)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of closed curves is %g", closed);
    batten_status status = quadrants(curve, &at);
    if (status == BATTEN_OK)
        status = sum_angles(curve, &at, batten_curve_is_closed(curve, closed), &sum);
    if (status == BATTEN_OK)
        *out = sum / (2 * BAT_PI);
    bat_release(at.at);
    return status;
}
