/* The data of a transfinite triangle, from curves and ribbons in any order and direction. */
#include "base/plural.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/fill/triangle_patch.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <string.h>

/* A curve in the direction of the loop, over [0, 1]. */
static batten_status normalised(const batten_curve *curve, bool reversed, batten_curve **out)
{
    batten_curve *turned = NULL;
    batten_status status = BATTEN_OK;
    if (reversed)
        status = batten_curve_reverse(curve, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(turned ? turned : curve, 0, 1, out);
    batten_curve_unref(turned);
    return status;
}

/* Inner knots that leave the direction free to jump. */
static batten_status check_kinks(const batten_curve *curve, int number, double angle_tolerance)
{
    const int count = batten_curve_spans(curve, NULL);
    double *breaks = bat_array((size_t)count, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, breaks);
    batten_status status = BATTEN_OK;
    for (int i = 1; i + 1 < count && status == BATTEN_OK; i++) {
        double left[6], right[6];
        status = batten_curve_evaluate_side(curve, breaks[i], BATTEN_FROM_LEFT, 1, left);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate_side(curve, breaks[i], BATTEN_FROM_RIGHT, 1, right);
        if (status == BATTEN_OK && bat_distance(3, left + 3, right + 3) >
                                       angle_tolerance * bat_norm(3, left + 3) +
                                           64 * DBL_EPSILON * bat_norm(3, right + 3))
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              "curve %d has a kink, or a jump of its speed, at %g of its way",
                              number, breaks[i]);
    }
    bat_release(breaks);
    return status;
}

static batten_status add_side(const batten_ribbon *ribbon, const batten_loop_place *place,
                              double angle_tolerance, bat_triangle_side *side)
{
    batten_status status = normalised(ribbon->curve, place->reversed, &side->curve);
    if (status == BATTEN_OK)
        status = check_kinks(side->curve, place->curve + 1, angle_tolerance);
    if (status == BATTEN_OK && ribbon->slope)
        status = normalised(ribbon->slope, place->reversed, &side->slope);
    return status;
}

/* Corners are the means of the ends that meet there. */
static batten_status find_corners(bat_triangle_patch *patch)
{
    for (int i = 0; i < 3; i++) {
        double end[6], start[6]; /* of sides j and k, which meet in corner i */
        batten_status status =
            batten_curve_evaluate(patch->sides[(i + 1) % 3].curve, 1, 1, end);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(patch->sides[(i + 2) % 3].curve, 0, 1, start);
        if (status != BATTEN_OK)
            return status;
        for (int c = 0; c < 3; c++) {
            patch->corner[i][c] = end[c] / 2 + start[c] / 2;
            patch->tangent[i][0][c] = start[3 + c];
            patch->tangent[i][1][c] = -end[3 + c];
        }
    }
    for (int e = 0; e < 3; e++) {
        memcpy(patch->sides[e].ends[0], patch->tangent[(e + 1) % 3][1], 3 * sizeof(double));
        memcpy(patch->sides[e].ends[1], patch->tangent[(e + 2) % 3][0], 3 * sizeof(double));
    }
    return BATTEN_OK;
}

/* k and h at one end of a side, so that k T + h C' is the other curve's tangent there. */
static batten_status fit_end(bat_triangle_side *side, int end, const int numbers[2],
                             double angle_tolerance)
{
    double T[3], C[6], rest[3];
    const double *X = side->ends[end];
    batten_status status = batten_curve_evaluate(side->slope, end, 0, T);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(side->curve, end, 1, C);
    if (status != BATTEN_OK)
        return status;
    /* Unit vectors, so that sizes do not matter. */
    double t[3], e[3], x[3];
    const double lt = bat_norm(3, T), le = bat_norm(3, C + 3), lx = bat_norm(3, X);
    for (int c = 0; c < 3; c++) {
        t[c] = T[c] / lt;
        e[c] = C[3 + c] / le;
        x[c] = X[c] / lx;
    }
    /* The square of a sine of 1e-6: `te` is rounded, and 1 - te^2 with it. */
    const double te = bat_dot(3, t, e), det = 1 - te * te;
    if (!(det > BAT_ROUNDING) || !(lx > 0))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "curves %d and %d have no tangent plane where they meet", numbers[0],
                        numbers[1]);
    const double tx = bat_dot(3, t, x), ex = bat_dot(3, e, x);
    const double k = (tx - te * ex) / det, h = (ex - te * tx) / det;
    for (int c = 0; c < 3; c++)
        rest[c] = x[c] - k * t[c] - h * e[c];
    const double angle = bat_asin(bat_min(1, bat_norm(3, rest)));
    if (angle > angle_tolerance)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "curve %d leaves the tangent plane of the ribbon of curve %d at their "
                        "corner by %g degree%s",
                        numbers[1], numbers[0], angle * 180 / BAT_PI,
                        bat_plural_real(angle * 180 / BAT_PI, 6));
    if (!(k > 0))
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the ribbon of curve %d leads away from curve %d at their corner: the "
                        "surface would fold back",
                        numbers[0], numbers[1]);
    side->k[end] = k * (lx / lt);
    side->h[end] = h * (lx / le);
    return BATTEN_OK;
}

/* @param numbers  of the curves as they were given, side by side */
static batten_status fit_slopes(bat_triangle_patch *patch, const int numbers[3],
                                double angle_tolerance)
{
    batten_status status = BATTEN_OK;
    for (int e = 0; e < 3 && status == BATTEN_OK; e++) {
        const int before[2] = {numbers[e], numbers[(e + 2) % 3]},
                  behind[2] = {numbers[e], numbers[(e + 1) % 3]};
        if (patch->sides[e].slope)
            status = fit_end(&patch->sides[e], 0, before, angle_tolerance);
        if (patch->sides[e].slope && status == BATTEN_OK)
            status = fit_end(&patch->sides[e], 1, behind, angle_tolerance);
    }
    for (int e = 0; e < 3 && status == BATTEN_OK; e++)
        for (int end = 0; end < 2; end++) {
            bat_jets point, along, across;
            bat_side_frame(patch, e, bat_jet_u(end), &point, &along, &across);
            for (int c = 0; c < 3; c++)
                patch->turn[e][end][c] = across.x[c].d[1];
        }
    return status;
}

batten_status bat_triangle_fill(const batten_ribbon ribbons[3],
                                const batten_loop_place places[3], double angle_tolerance,
                                bat_triangle_patch *patch)
{
    batten_status status = BATTEN_OK;
    int numbers[3];
    for (int e = 0; e < 3 && status == BATTEN_OK; e++) {
        numbers[e] = places[e].curve + 1;
        patch->smooth |= ribbons[e].slope != NULL;
        status =
            add_side(&ribbons[places[e].curve], &places[e], angle_tolerance, &patch->sides[e]);
    }
    if (status == BATTEN_OK)
        status = find_corners(patch);
    if (status == BATTEN_OK && patch->smooth)
        status = fit_slopes(patch, numbers, angle_tolerance);
    return status;
}
