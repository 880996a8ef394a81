/* What a sheet reached along its sides and inside. */
#include "numeric/vector.h"
#include "shape/fill/sheet.h"
#include <string.h>

/* Places of each span of a side and of what is inside. */
enum { LEAST_PLACES = 65, PLACES_A_CELL = 10 };

/* At least LEAST_PLACES a span, and PLACES_A_CELL for each cell of the sheet that it may cross. */
static int places_for(const batten_surface *surface)
{
    const int cells = batten_surface_spans(surface, BATTEN_U, NULL) +
                      batten_surface_spans(surface, BATTEN_V, NULL);
    return bat_max_int(LEAST_PLACES, PLACES_A_CELL * cells);
}

/* Rises in every span: its parameters, `places` + 1 of each; the last of one is the first of
 * the next, seen from the other side. */
typedef struct {
    int spans, places;
    double *knots;
} walk;

static batten_status begin_walk(const batten_curve *curve, const batten_surface *surface,
                                walk *out)
{
    out->spans = batten_curve_spans(curve, NULL) - 1;
    /* as many for a curve of many spans as for one of few */
    out->places = bat_max_int(LEAST_PLACES, places_for(surface) / out->spans);
    out->knots = bat_array((size_t)out->spans + 1, sizeof *out->knots);
    if (!out->knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, out->knots);
    return BATTEN_OK;
}

static double walk_at(const walk *w, int span, int place)
{
    const double s = (double)place / w->places;
    return (1 - s) * w->knots[span] + s * w->knots[span + 1];
}

static batten_status measure_place(const bat_sheet_outline *outline, int i,
                                   const batten_surface *surface, double t, batten_side from,
                                   batten_fill_edge *edge, double *rim)
{
    const bat_fill_side *side = &outline->sides[i];
    bat_fill_view s, r;
    double at[2], curve[2][3];
    batten_status status = batten_curve_evaluate(outline->plane[i], t, 0, at);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(side->curve, t, from, 1, curve[0]);
    if (status == BATTEN_OK)
        status = bat_fill_see_surface(surface, at[0], at[1], &s);
    if (status == BATTEN_OK)
        status = bat_fill_see_ribbon(side, t, from, &r);
    if (status != BATTEN_OK)
        return status;
    if (outline->reversed[i])
        for (int c = 0; c < 3; c++) {
            r.v[c] = -r.v[c]; /* both normals up */
            r.uv[c] = -r.uv[c];
            r.normal[c] = -r.normal[c];
        }
    bat_fill_compare(&s, &r, curve[1], edge);
    if (r.regular && r.bent)
        *rim = bat_max(*rim, bat_fill_largest_curvature(&r));
    return BATTEN_OK;
}

static batten_status measure_side(const bat_sheet_outline *outline, int i,
                                  const batten_surface *surface, batten_fill_edge *edge,
                                  double *rim)
{
    walk w = {0, 0, NULL};
    batten_status status = begin_walk(outline->sides[i].curve, surface, &w);
    *edge = (batten_fill_edge){.curve = outline->sides[i].given};
    for (int span = 0; status == BATTEN_OK && span < w.spans; span++)
        for (int k = 0; status == BATTEN_OK && k <= w.places; k++)
            status = measure_place(outline, i, surface, walk_at(&w, span, k),
                                   k == 0 ? BATTEN_FROM_RIGHT : BATTEN_FROM_LEFT, edge, rim);
    bat_release(w.knots);
    return status;
}

/* ---- inside ---- */

/* A point of the model against the sheet over it. */
static batten_status measure_point(const batten_affine *to_frame, double size,
                                   const double point[3], const batten_surface *surface,
                                   int number, batten_fill_sheet_report *report)
{
    const batten_vec3 p = batten_affine_apply(*to_frame, bat_vec3_of(3, point));
    double at[3];
    const batten_status status = batten_surface_evaluate(surface, p.x, p.y, 0, at);
    const double gap = status == BATTEN_OK ? fabs(at[2] - p.z) * size : 0;
    if (report->inside == 0 || gap > report->inside_gap) {
        report->inside = number;
        report->inside_gap = gap;
        memcpy(report->inside_at, point, sizeof report->inside_at);
    }
    return status;
}

static batten_status measure_inside(const bat_sheet_outline *outline,
                                    const bat_sheet_inside *inside,
                                    const batten_surface *surface,
                                    batten_fill_sheet_report *report)
{
    const batten_affine map = bat_sheet_to_frame(outline);
    batten_status status = BATTEN_OK;
    report->inside = 0;
    report->inside_gap = 0;
    for (int i = 0; status == BATTEN_OK && i < inside->points.count; i++)
        status = measure_point(&map, outline->size, inside->points.at + 3 * (size_t)i, surface,
                               i + 1, report);
    for (int i = 0; status == BATTEN_OK && i < inside->curves.count; i++) {
        walk w = {0, 0, NULL};
        status = begin_walk(inside->curves.at[i], surface, &w);
        for (int span = 0; status == BATTEN_OK && span < w.spans; span++)
            for (int k = 0; status == BATTEN_OK && k <= w.places; k++) {
                double point[3];
                status =
                    batten_curve_evaluate(inside->curves.at[i], walk_at(&w, span, k), 0, point);
                if (status == BATTEN_OK)
                    status = measure_point(&map, outline->size, point, surface, -1 - i, report);
            }
        bat_release(w.knots);
    }
    return status;
}

/* ---- all ---- */

static void to_model(const bat_sheet_outline *outline, batten_fill_edge *edge)
{
    const batten_affine map = bat_sheet_from_frame(outline);
    double *at[3] = {edge->gap_at, edge->angle_at, edge->curvature_at};
    edge->gap *= outline->size;
    edge->curvature /= outline->size;
    for (int k = 0; k < 3; k++) {
        const batten_vec3 p = batten_affine_apply(map, bat_vec3_of(3, at[k]));
        at[k][0] = p.x;
        at[k][1] = p.y;
        at[k][2] = p.z;
    }
}

batten_status bat_sheet_measure(const bat_sheet_outline *outline,
                                const bat_sheet_inside *inside, const batten_surface *surface,
                                batten_fill_sheet_report *report)
{
    batten_status status = BATTEN_OK;
    double rim = 0;
    report->count = outline->count;
    report->columns = batten_surface_spans(surface, BATTEN_U, NULL) - 1;
    report->rows = batten_surface_spans(surface, BATTEN_V, NULL) - 1;
    for (int i = 0; status == BATTEN_OK && i < outline->count; i++) {
        status = measure_side(outline, i, surface, &report->outer[i], &rim);
        to_model(outline, &report->outer[i]);
    }
    report->rim_curvature = rim / outline->size;
    if (status == BATTEN_OK)
        status = measure_inside(outline, inside, surface, report);
    return status;
}
