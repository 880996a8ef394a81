/* Holes filled by one trimmed surface: as few spans as keep all that is asked. */
#include "shape/fill/sheet.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include <string.h>

#define DEGREES (180 / BAT_PI)

batten_fill_sheet_options batten_fill_sheet_defaults(void)
{
    return (batten_fill_sheet_options){.size = sizeof(batten_fill_sheet_options),
                                       .angle = 0.002 * BAT_PI / 180};
}

static batten_status check_options(const batten_fill_sheet_options *o)
{
    if (!(o->tolerance >= 0) || !isfinite(o->tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of a fill is 0 or more, not %g",
                        o->tolerance);
    if (!(o->angle > 0) || !isfinite(o->angle))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle of a fill is above 0, not %g",
                        o->angle);
    if (!(o->most_curvature >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the difference of curvatures of a fill is 0 or more, not %g",
                        o->most_curvature);
    if (o->points.count > 0 && o->points.dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "points inside a fill have dimension 3, these have %d",
                        o->points.dimension);
    for (int i = 0; i < o->curves.count; i++)
        if (batten_curve_dimension(o->curves.at[i]) != 3)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "inner curve %d has dimension %d: what a fill goes through lies in "
                            "space",
                            i + 1, batten_curve_dimension(o->curves.at[i]));
    return BATTEN_OK;
}

/* ---- is it good? ---- */

typedef struct {
    double gap, angle, curvature; /* what is allowed */
} bounds;

static bounds bounds_of(const batten_fill_sheet_options *options,
                        const bat_sheet_outline *outline,
                        const batten_fill_sheet_report *report)
{
    /* Without a tolerance a millionth of the hole. */
    bounds most = {options->tolerance > 0
                       ? bat_max(options->tolerance, BAT_MEANT_SAME * outline->size)
                       : 1e-6 * outline->size,
                   options->angle, HUGE_VAL};
    /* A hundredth of the curvature around is not seen as a change of shading. */
    if (options->curvature)
        most.curvature = options->most_curvature > 0
                             ? options->most_curvature
                             : bat_max(report->rim_curvature, 1 / outline->size) / 100;
    return most;
}

/* How much the worst is over its bound; at most 1 when all hold. */
static double excess(const batten_fill_sheet_report *r, const bounds *most)
{
    double worst = r->inside_gap / most->gap;
    for (int i = 0; i < r->count; i++) {
        const batten_fill_edge *e = &r->outer[i];
        worst = bat_max(worst, e->gap / most->gap);
        if (e->has_slope)
            worst = bat_max(worst, e->angle / most->angle);
        if (e->has_curvature)
            worst = bat_max(worst, e->curvature / most->curvature);
    }
    return worst;
}

static batten_status refuse_inside(const batten_fill_sheet_report *r, const bounds *most)
{
    const double *at = r->inside_at;
    return bat_fail(
        BATTEN_TOLERANCE_NOT_MET,
        "the sheet misses inner %s %d by %.3g at (%g, %g, %g), more than %.3g, with "
        "%d x %d spans: allow more, or smooth what is inside",
        r->inside > 0 ? "point" : "curve", r->inside > 0 ? r->inside : -r->inside,
        r->inside_gap, at[0], at[1], at[2], most->gap, r->columns, r->rows);
}

/* The first bound that does not hold, with its figure. */
static batten_status refuse_excess(const batten_fill_sheet_report *r, const bounds *most)
{
    if (r->inside_gap > most->gap)
        return refuse_inside(r, most);
    for (int i = 0; i < r->count; i++) {
        const batten_fill_edge *e = &r->outer[i];
        const double *g = e->gap_at, *a = e->angle_at, *k = e->curvature_at;
        if (e->gap > most->gap)
            return bat_fail(
                BATTEN_TOLERANCE_NOT_MET,
                "the sheet misses curve %d by %.3g at (%g, %g, %g), more than %.3g, "
                "with %d x %d spans: allow more, or smooth the curve",
                e->curve + 1, e->gap, g[0], g[1], g[2], most->gap, r->columns, r->rows);
        if (e->has_slope && e->angle > most->angle)
            return bat_fail(
                BATTEN_TOLERANCE_NOT_MET,
                "the sheet leaves the tangent planes along curve %d by %.3g degrees "
                "at (%g, %g, %g), more than %.3g: the surfaces around contradict "
                "each other more than one smooth surface can follow",
                e->curve + 1, e->angle * DEGREES, a[0], a[1], a[2], most->angle * DEGREES);
        if (e->has_curvature && e->curvature > most->curvature)
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "curvatures across curve %d differ by %.3g at (%g, %g, %g), and "
                            "%.3g is allowed: the surfaces around contradict each other more "
                            "than one smooth surface can follow",
                            e->curve + 1, e->curvature, k[0], k[1], k[2], most->curvature);
    }
    return BATTEN_OK;
}

/* ---- finer and finer ---- */

/* Spans along the longer side: more would take minutes. */
static const int spans_tried[] = {6, 12, 24, 48, 96};

static batten_status make_sheet(const bat_sheet_outline *outline,
                                const bat_sheet_inside *inside, const double allowed[3],
                                int spans, batten_surface **out)
{
    bat_sheet_conditions conditions = {0, 0, NULL};
    const double longer =
        bat_max(outline->high[0] - outline->low[0], outline->high[1] - outline->low[1]);
    batten_status status =
        bat_sheet_ask(outline, inside, isfinite(allowed[2]), longer / spans, &conditions);
    for (int k = 0; k < conditions.count; k++)
        conditions.at[k].allowed = allowed[conditions.at[k].order];
    if (status == BATTEN_OK)
        status = bat_sheet_solve(outline, &conditions, spans, out);
    bat_release(conditions.at);
    return status;
}

/* The first that keeps the bounds, in the frame; the last one's report where none does. */
static batten_status refine(const bat_sheet_outline *outline,
                            const batten_fill_sheet_options *options,
                            batten_fill_sheet_report *report, batten_surface **out)
{
    const bat_sheet_inside inside = {options->points, options->curves};
    const int tries = (int)(sizeof spans_tried / sizeof *spans_tried);
    double last = HUGE_VAL;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < tries; k++) {
        batten_surface *made = NULL;
        const bounds aim = bounds_of(options, outline, report);
        /* in the frame, and half, since places between those asked may be farther off */
        const double allowed[3] = {aim.gap / outline->size / 2, aim.angle / 2,
                                   aim.curvature * outline->size / 2};
        status = make_sheet(outline, &inside, allowed, spans_tried[k], &made);
        if (status == BATTEN_OK)
            status = bat_sheet_measure(outline, &inside, made, report);
        const bounds most = bounds_of(options, outline, report);
        const double over = excess(report, &most);
        /* Twice the spans bring half of the excess at least, or nothing will. */
        const bool is_last = k == tries - 1 || (k > 1 && over > 0.7 * last);
        report->most_curvature = most.curvature;
        last = over;
        if (status == BATTEN_OK && over <= 1) {
            *out = made;
            return BATTEN_OK;
        }
        batten_surface_unref(made);
        if (status == BATTEN_OK && is_last)
            return refuse_excess(report, &most);
    }
    return status;
}

/* ---- the result ---- */

void batten_fill_sheet_release(batten_fill_sheet *sheet)
{
    batten_surface_unref(sheet->surface);
    for (int i = 0; i < BATTEN_SHEET_SIDES; i++)
        batten_curve_unref(sheet->sides[i].parameters);
    *sheet = (batten_fill_sheet){0};
}

static batten_status place_in_model(const bat_sheet_outline *outline,
                                    const batten_surface *surface, batten_fill_sheet *out)
{
    const batten_affine map = bat_sheet_from_frame(outline);
    const batten_status status = batten_surface_transform(surface, &map, &out->surface);
    if (status != BATTEN_OK)
        return status;
    out->count = outline->count;
    for (int i = 0; i < outline->count; i++)
        out->sides[i] = (batten_sheet_side){.curve = outline->sides[i].given,
                                            .reversed = outline->reversed[i],
                                            .parameters = batten_curve_ref(outline->plane[i])};
    return BATTEN_OK;
}

batten_status batten_surface_fill_sheet(int count, const batten_ribbon *sides,
                                        const batten_fill_sheet_options *options,
                                        batten_fill_sheet_report *report,
                                        batten_fill_sheet *out)
{
    batten_fill_sheet_options chosen = batten_fill_sheet_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_fill_sheet_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_options(&chosen);
    if (status == BATTEN_OK)
        status = bat_fill_check_sides(count, BATTEN_SHEET_SIDES, sides);
    if (status != BATTEN_OK)
        return status;
    bat_sheet_outline *outline = bat_array(1, sizeof *outline);
    batten_fill_sheet_report *reached = bat_array(1, sizeof *reached);
    batten_fill_sheet made = {0};
    batten_surface *surface = NULL;
    status = outline && reached ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status =
            bat_sheet_outline_make(count, sides, chosen.tolerance, &reached->loop_gap, outline);
    if (status == BATTEN_OK)
        status = refine(outline, &chosen, reached, &surface);
    if (report && (status == BATTEN_OK || status == BATTEN_TOLERANCE_NOT_MET))
        *report = *reached;
    if (status == BATTEN_OK)
        status = place_in_model(outline, surface, &made);
    if (status == BATTEN_OK)
        *out = made;
    batten_surface_unref(surface);
    if (outline)
        bat_sheet_outline_free(outline);
    bat_release(outline);
    bat_release(reached);
    return status;
}
