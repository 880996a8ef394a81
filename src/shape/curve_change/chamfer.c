/* Corners cut off by straight lines, between two curves or along one. */
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/curve_change/cut_corners.h"
#include "shape/curve_change/extend.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>

static batten_status check_lengths(const batten_curve *first, const batten_curve *second,
                                   const double lengths[2], double tolerance)
{
    if (first->dimension == 1 || second->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "functions have no corners; make their graphs");
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves have %d and %d dimensions",
                        first->dimension, second->dimension);
    for (int k = 0; k < 2; k++)
        if (!(lengths[k] > 0 && isfinite(lengths[k])))
            return bat_fail(BATTEN_BAD_ARGUMENT, "a length of %g is cut off, not above 0",
                            lengths[k]);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

/* The parameter `length` from the end of the first curve (k = 0), or from the start of the
 * second. */
static batten_status find_cut(const batten_curve *curve, int k, double length, double tolerance,
                              double *u)
{
    double whole;
    batten_status status = batten_curve_length(curve, tolerance / 4, NULL, &whole);
    if (status == BATTEN_OK && length > whole + tolerance)
        return bat_fail(BATTEN_NOT_FOUND, "%g cannot be cut off the %s curve, which is %g long",
                        length, k ? "second" : "first", whole);
    const double s = k ? bat_min(length, whole) : bat_max(0, whole - length);
    return status == BATTEN_OK ? batten_curve_at_length(curve, 1, &s, tolerance / 2, u)
                               : status;
}

/* From a to b with the speed of the first curve at u. */
static batten_status make_line(const batten_curve *first, double u, const double *a,
                               const double *b, batten_curve **out)
{
    const int d = first->dimension;
    const double length = bat_distance(d, a, b);
    double points[2 * 3], at[2 * 3];
    if (!(length > 0))
        return bat_fail(BATTEN_COINCIDENT, "the line across the corner would be a point");
    const batten_status status = batten_curve_evaluate_side(first, u, BATTEN_FROM_LEFT, 1, at);
    if (status != BATTEN_OK)
        return status;
    const double speed = bat_norm(d, at + d);
    const double breaks[2] = {u, u + (speed > 0 ? length / speed : length)};
    for (int k = 0; k < d; k++) {
        points[k] = a[k];
        points[d + k] = b[k];
    }
    return batten_curve_from_bezier(d, (batten_pieces){1, 1, breaks}, points, NULL, out);
}

batten_status batten_curves_chamfer(const batten_curve *first, const batten_curve *second,
                                    const double lengths[2], double tolerance, double u[2],
                                    batten_curve **line)
{
    assert(first && second && line);
    const batten_curve *const curves[2] = {first, second};
    double at[2], p[2][3], ends[2][3];
    batten_status status = check_lengths(first, second, lengths, tolerance);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(first, batten_curve_domain(first).b, 0, ends[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(second, batten_curve_domain(second).a, 0, ends[1]);
    if (status != BATTEN_OK)
        return status;
    const double gap = bat_distance(first->dimension, ends[0], ends[1]);
    if (gap > tolerance + BAT_EXACT * bat_curve_size(first))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the curves are %g apart where they should meet",
                        gap);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = find_cut(curves[k], k, lengths[k], tolerance, &at[k]);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(curves[k], at[k], 0, p[k]);
    }
    if (status == BATTEN_OK)
        status = make_line(first, at[0], p[0], p[1], line);
    for (int k = 0; status == BATTEN_OK && u && k < 2; k++)
        u[k] = at[k];
    return status;
}

/* ---- all corners ---- */

typedef struct {
    double before, behind, tolerance;
    batten_corners_report report;
} cutting;

static batten_status cut_corner(void *context, const bat_corner *corner, bat_corner_cut *out)
{
    cutting *c = context;
    c->report.cut++;
    return batten_curves_chamfer(corner->before, corner->behind,
                                 (double[2]){c->before, c->behind}, c->tolerance, out->u,
                                 &out->link);
}

batten_status batten_curve_chamfer(const batten_curve *curve, const double lengths[2],
                                   double tolerance, batten_corners_report *report,
                                   batten_curve **out)
{
    assert(curve && out);
    cutting c = {lengths[0], lengths[1], tolerance, {.complete = true}};
    const bat_cutter cutter = {cut_corner, &c,
                               2 * tolerance + BAT_ROUNDING * bat_curve_size(curve)};
    batten_status status = check_lengths(curve, curve, lengths, tolerance);
    if (status == BATTEN_OK)
        status = bat_curve_corner_count(curve, &c.report.corners);
    if (status == BATTEN_OK)
        status = bat_curve_cut_corners(curve, &cutter, out);
    if (status == BATTEN_OK && report)
        *report = c.report;
    return status;
}
