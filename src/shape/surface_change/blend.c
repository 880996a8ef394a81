/*
 * Surfaces between two edges: ribbons blended by the polynomials of Hermite. In Bezier form row
 * r is a combination of the curves of one ribbon, so that points, tangent planes and curvatures
 * at the edges are theirs to rounding.
 */
#include "shape/surface_change/blend.h"
#include "numeric/rounding.h"

#include "numeric/vector.h"
#include "shape/formula/formula.h"
#include "spline/curve/curve.h"

#include <string.h>

enum {
    MOST = BAT_BLEND_ORDERS,
    MOST_ROWS = BAT_BLEND_ROWS,
    SAMPLES = 33,
    CURVES = BAT_BLEND_CURVES
};

typedef struct {
    const batten_surface *const *surfaces;
    const batten_surface_blend_end *ends;
    double tolerance, size;
    batten_surfaces_blend_report *report;
    bat_blend *b;
} blending;

batten_surface_blend_end batten_surfaces_blend_defaults(batten_edge edge)
{
    return (batten_surface_blend_end){.size = sizeof(batten_surface_blend_end),
                                      .edge = edge,
                                      .to = 1,
                                      .continuity = 2,
                                      .bulge = 1};
}

/* ---- ribbons ---- */

/* The part of a curve of the ribbon over [0, 1]. */
static batten_status take_part(const batten_curve *curve, double from, double to,
                               batten_curve **out)
{
    const batten_interval d = batten_curve_domain(curve);
    batten_curve *part = NULL;
    batten_status status = batten_curve_subrange(curve, (1 - from) * d.a + from * d.b,
                                                 (1 - to) * d.a + to * d.b, &part);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(part, 0, 1, out);
    batten_curve_unref(part);
    return status;
}

static batten_status take_side(blending *t, int side)
{
    const batten_surface_blend_end *end = &t->ends[side];
    const int order = bat_max_int(1, end->continuity);
    batten_curve *ribbon[MOST] = {NULL, NULL, NULL};
    double error = 0;
    batten_status status =
        batten_edge_ribbon(t->surfaces[side], end->edge, order, t->tolerance, &error, ribbon);
    t->b->count[side] = end->continuity + 1;
    for (int k = 0; k <= end->continuity && status == BATTEN_OK; k++)
        status = take_part(ribbon[k], end->from, end->to, &t->b->curves[side * MOST + k]);
    t->report->error = bat_max(t->report->error, error);
    for (int k = 0; k < MOST; k++)
        batten_curve_unref(ribbon[k]);
    return status;
}

static batten_status turn_second(bat_blend *b)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < b->count[1] && status == BATTEN_OK; k++) {
        batten_curve **at = &b->curves[MOST + k], *turned = NULL, *made = NULL;
        status = batten_curve_reverse(*at, &turned);
        if (status == BATTEN_OK)
            status = batten_curve_set_domain(turned, 0, 1, &made);
        batten_curve_unref(turned);
        if (status == BATTEN_OK) {
            batten_curve_unref(*at);
            *at = made;
        }
    }
    return status;
}

/* Mean distance of the edges, as they run or against each other, and their own extents. */
static batten_status measure_edges(blending *t, double distance[2], double extent[2])
{
    const batten_curve *first = t->b->curves[0], *second = t->b->curves[MOST];
    double start[2][3];
    distance[0] = distance[1] = extent[0] = extent[1] = 0;
    for (int i = 0; i < SAMPLES; i++) {
        const double u = (double)i / (SAMPLES - 1);
        double a[3], b[2][3];
        batten_status status = batten_curve_evaluate(first, u, 0, a);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(second, u, 0, b[0]);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(second, 1 - u, 0, b[1]);
        if (status != BATTEN_OK)
            return status;
        if (i == 0) {
            memcpy(start[0], a, sizeof a);
            memcpy(start[1], b[0], sizeof a);
        }
        extent[0] = bat_max(extent[0], bat_distance(3, a, start[0]));
        extent[1] = bat_max(extent[1], bat_distance(3, b[0], start[1]));
        for (int k = 0; k < 2; k++)
            distance[k] += bat_distance(3, a, b[k]) / SAMPLES;
        t->size = bat_max(t->size, bat_max(bat_largest(3, a), bat_largest(3, b[0])));
    }
    return BATTEN_OK;
}

static batten_status place_edges(blending *t, double *distance)
{
    double apart[2], extent[2];
    batten_status status = measure_edges(t, apart, extent);
    if (status != BATTEN_OK)
        return status;
    t->report->reversed = apart[1] < apart[0];
    *distance = bat_min(apart[0], apart[1]);
    const double least = BAT_ROUNDING * t->size;
    if (!(*distance > least))
        return bat_fail(BATTEN_COINCIDENT, "the edges are the same: their mean distance is %g",
                        *distance);
    if (!(bat_max(extent[0], extent[1]) > least))
        return bat_fail(BATTEN_COINCIDENT, "both edges are points");
    return t->report->reversed ? turn_second(t->b) : BATTEN_OK;
}

/* What a unit of v is in the parameter across the edge. */
static batten_status find_scale(const blending *t, int side, double distance, double *scale)
{
    const batten_curve *slope = t->b->curves[side * MOST + 1];
    double speed = 0;
    *scale = 0;
    if (!slope)
        return BATTEN_OK;
    for (int i = 0; i < SAMPLES; i++) {
        double d[3];
        const batten_status status =
            batten_curve_evaluate(slope, (double)i / (SAMPLES - 1), 0, d);
        if (status != BATTEN_OK)
            return status;
        speed += bat_norm(3, d) / SAMPLES;
    }
    *scale = t->ends[side].bulge * distance / speed;
    if (!(speed > 0) || !isfinite(*scale))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "surface %d stands still across its edge: its mean speed there is %g",
                        side + 1, speed);
    return BATTEN_OK;
}

/* Row j from either end: the Taylor polynomial there in Bezier form, sum over i of
 * C(j, i) (q - i)! / q! S^(i), S^(i) being taken away from the edge at the far end. */
static void fill_parts(bat_blend *b, int side, double scale)
{
    const int q = bat_blend_rows(b) - 1;
    for (int j = 0; j < b->count[side]; j++) {
        double factor = 1; /* (q - i)! / q! scale^i (-1)^i for slopes that leave at v = 1 */
        for (int i = 0; i <= j; i++) {
            b->part[side * MOST + i][side ? q - j : j] = bat_binomials[j][i] * factor;
            factor *= scale / bat_max_int(1, q - i);
        }
    }
}

/* ---- exact ---- */

/* Do all curves have the same weights but for a factor? */
static bool weights_agree(int count, batten_curve *const *curves)
{
    const batten_curve *first = curves[0];
    for (int k = 1; k < count && first->weights; k++) {
        const double factor = curves[k]->weights[0] / first->weights[0];
        for (int i = 1; i < first->count; i++)
            if (fabs(curves[k]->weights[i] / (factor * first->weights[i]) - 1) > BAT_EXACT)
                return false;
    }
    return true;
}

static batten_status fill_nurbs(const bat_blend *b, batten_curve *const *unified,
                                batten_surface **out)
{
    const batten_curve *first = unified[0];
    const int q = bat_blend_rows(b) - 1;
    const bat_nurbs_shape shape = {.dimension = 3,
                                   .degree = {first->degree, q},
                                   .count = {first->count, q + 1},
                                   .rational = first->weights != NULL};
    bat_nurbs *made = NULL;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    memcpy(made->axes[0].knots, first->knots,
           (size_t)(first->count + first->degree + 1) * sizeof(double));
    for (int r = 0; r <= 2 * q + 1; r++)
        made->axes[1].knots[r] = r > q;
    for (int i = 0; i < first->count; i++)
        for (int r = 0; r <= q; r++) {
            double *point = made->points + 3 * (i * (q + 1) + r);
            memset(point, 0, 3 * sizeof *point);
            for (int k = 0, c = 0; k < CURVES; k++) {
                if (!b->curves[k])
                    continue;
                for (int x = 0; x < 3; x++)
                    point[x] += b->part[k][r] * unified[c]->points[3 * i + x];
                c++;
            }
            if (made->weights)
                made->weights[i * (q + 1) + r] = first->weights[i];
        }
    return bat_nurbs_finish(made, out);
}

/* ---- near, for weights that differ ---- */

/* Over the knots that the curves have together. Takes the blend over. */
static batten_status make_near(blending *t, const batten_curve *unified, batten_surface **out)
{
    static const double ends[] = {0, 1};
    const bat_formula_axis v = {2, ends, 2};
    bat_formula_axis u = {
        batten_curve_spans(unified, NULL), NULL,
        bat_knots_smoothness(unified->degree, unified->count, unified->knots, 2)};
    batten_surface *truth = NULL;
    double *breaks = bat_array((size_t)u.count, sizeof *breaks), error = 0;
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    u.spans = breaks;
    batten_curve_spans(unified, breaks);
    batten_status status =
        bat_formula_create(&bat_blend_formula, t->b, 3, &u, &v, t->size, &truth);
    if (status == BATTEN_OK) {
        t->b = NULL;
        status = batten_surface_to_nurbs(truth, t->tolerance, &error, out);
    }
    t->report->error += error;
    batten_surface_unref(truth);
    bat_release(breaks);
    return status;
}

static batten_status make_blend(blending *t, batten_surface **out)
{
    batten_curve *unified[CURVES] = {NULL};
    const batten_curve *given[CURVES];
    int count = 0;
    for (int k = 0; k < CURVES; k++)
        if (t->b->curves[k])
            given[count++] = t->b->curves[k];
    batten_status status = batten_curves_unify(count, given, unified);
    if (status == BATTEN_OK && weights_agree(count, unified))
        status = fill_nurbs(t->b, unified, out);
    else if (status == BATTEN_OK && !(t->tolerance > 0))
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the edges have different weights: a tolerance above 0 is needed");
    else if (status == BATTEN_OK)
        status = make_near(t, unified[0], out);
    for (int k = 0; k < CURVES; k++)
        batten_curve_unref(unified[k]);
    return status;
}

/* ---- the call ---- */

/* What is asked of one side. */
static batten_status check_side(int k, const batten_surface_blend_end *e)
{
    if (!isfinite(e->from) || !isfinite(e->to) || !isfinite(e->bulge))
        return bat_fail(BATTEN_NOT_FINITE, "side %d: from %g to %g, bulge %g", k + 1, e->from,
                        e->to, e->bulge);
    if ((int)e->edge < 0 || e->edge > BATTEN_EDGE_U0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "side %d: a surface has no edge %d", k + 1,
                        (int)e->edge);
    if (e->from < 0 || !(e->from < e->to) || e->to > 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "side %d: a part from %g to %g; parts go forwards within 0 and 1",
                        k + 1, e->from, e->to);
    if (e->continuity < 0 || e->continuity > 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "side %d: continuity G%d; surfaces are blended with G0, G1 or G2",
                        k + 1, e->continuity);
    if (e->bulge <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "side %d: a bulge of %g; bulges are above 0",
                        k + 1, e->bulge);
    return BATTEN_OK;
}

static batten_status check_blend(const blending *t)
{
    for (int k = 0; k < 2; k++) {
        if (batten_surface_dimension(t->surfaces[k]) != 3)
            return bat_fail(BATTEN_NOT_COMPATIBLE, "surface %d is not in space", k + 1);
        const batten_status status = check_side(k, &t->ends[k]);
        if (status != BATTEN_OK)
            return status;
    }
    return bat_tolerance_check(t->tolerance);
}

static batten_status blend_edges(blending *t, batten_surface **out)
{
    double distance = 0, scale[2] = {0, 0};
    batten_surface *made = NULL;
    batten_status status = take_side(t, 0);
    if (status == BATTEN_OK)
        status = take_side(t, 1);
    if (status == BATTEN_OK)
        status = place_edges(t, &distance);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        status = find_scale(t, k, distance, &scale[k]);
        if (status == BATTEN_OK)
            fill_parts(t->b, k, scale[k]);
    }
    t->report->error *= bat_max(1, bat_max(scale[0], scale[1]));
    if (status == BATTEN_OK)
        status = make_blend(t, &made);
    if (status == BATTEN_OK)
        status = bat_blend_measure(
            &(bat_blend_contact){t->surfaces, t->ends, t->size, t->report}, made);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_unref(made);
    return status;
}

/* Two structs stand as far apart as the first says that it is long. */
static batten_status take_ends(const batten_surface_blend_end given[2],
                               batten_surface_blend_end chosen[2])
{
    const char *second = (const char *)given + given[0].size;
    chosen[0] = chosen[1] = batten_surfaces_blend_defaults(BATTEN_EDGE_V0);
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_blend_end, given, &chosen[0]);
    if (status == BATTEN_OK)
        status = bat_take_options("batten_surface_blend_end", second,
                                  sizeof(batten_surface_blend_end), &chosen[1]);
    return status;
}

batten_status batten_surfaces_blend(const batten_surface *const surfaces[2],
                                    const batten_surface_blend_end ends[2], double tolerance,
                                    batten_surfaces_blend_report *report, batten_surface **out)
{
    assert(surfaces && surfaces[0] && surfaces[1] && ends && out);
    batten_surfaces_blend_report found = {.error = 0};
    batten_surface_blend_end chosen[2];
    batten_status status = take_ends(ends, chosen);
    blending t = {
        .surfaces = surfaces, .ends = chosen, .tolerance = tolerance, .report = &found};
    if (status == BATTEN_OK)
        status = check_blend(&t);
    if (status != BATTEN_OK)
        return status;
    t.b = bat_array(1, sizeof *t.b);
    status = t.b ? blend_edges(&t, out) : BATTEN_OUT_OF_MEMORY;
    bat_blend_free(t.b);
    if (status == BATTEN_OK && report)
        *report = found;
    return status;
}
