/* The curves of a lines plan: stations, waterlines and buttocks of half a hull. */
#include "picture/drawings/hull.h"
#include "base/plural.h"

#include "picture/sheet/sheet.h"
#include <batten/nearest.h>

#include <string.h>

static const char *const names[BAT_FAMILIES] = {"station", "buttock", "waterline"};
static const char letters[] = "xyz";

/* Beyond this a spacing is surely a wrong unit. */
enum { CUT_LIMIT = 400 };

/* ---- polylines cut by a plane ---- */

static batten_status add_run(bat_strokes *list, size_t count, const double *points)
{
    if (count < 2)
        return BATTEN_OK;
    double *copy = bat_array3(count, 3, sizeof *copy);
    if (!copy)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(copy, points, count * 3 * sizeof *copy);
    return bat_strokes_add(list, (bat_stroke){count, copy});
}

batten_status bat_strokes_add_part(bat_strokes *list, const bat_stroke *stroke, int axis,
                                   double sign, double value)
{
    /* Each segment gives at most two points of a run. */
    double *run = bat_array3(2 * stroke->count + 1, 3, sizeof *run);
    if (!run)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    size_t count = 0;
    double before = 0;
    for (size_t i = 0; i < stroke->count && status == BATTEN_OK; i++) {
        const double *p = stroke->points + 3 * i;
        const double side = sign * (p[axis] - value);
        if ((before < 0 && side > 0) || (before > 0 && side < 0)) {
            const double t = before / (before - side), *q = p - 3;
            for (int k = 0; k < 3; k++)
                run[3 * count + (size_t)k] = k == axis ? value : q[k] + t * (p[k] - q[k]);
            count++;
        }
        if (side >= 0)
            memcpy(run + 3 * count++, p, 3 * sizeof *run);
        if (side < 0 && count > 0) {
            status = add_run(list, count, run);
            count = 0;
        }
        before = side;
    }
    if (status == BATTEN_OK)
        status = add_run(list, count, run);
    bat_release(run);
    return status;
}

/* ---- size ---- */

static batten_status parameters(const batten_surface *surface, batten_direction direction,
                                size_t *count, double **out)
{
    const int knot_count = batten_surface_spans(surface, direction, NULL);
    double *knots = bat_array((size_t)knot_count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, direction, knots);
    /* 128 steps in all find the largest breadth of a hull to about 1/100,000. */
    const int steps = bat_max_int(2, 128 / bat_max_int(knot_count - 1, 1));
    const batten_status status = bat_divide_spans(knot_count, knots, steps, count, out);
    bat_release(knots);
    return status;
}

static batten_status extend(const batten_surface *surface, double low[3], double high[3])
{
    size_t count_u = 0, count_v = 0;
    double *u = NULL, *v = NULL, *points = NULL;
    batten_status status = parameters(surface, BATTEN_U, &count_u, &u);
    if (status == BATTEN_OK)
        status = parameters(surface, BATTEN_V, &count_v, &v);
    if (status == BATTEN_OK) {
        points = bat_array3(count_u, count_v, 3 * sizeof *points);
        status = points ? batten_surface_evaluate_grid(surface,
                                                       (batten_uv_grid){count_u, count_v, u, v},
                                                       0, NULL, points)
                        : BATTEN_OUT_OF_MEMORY;
    }
    for (size_t i = 0; status == BATTEN_OK && i < count_u * count_v; i++)
        for (size_t k = 0; k < 3; k++) {
            low[k] = bat_min(low[k], points[3 * i + k]);
            high[k] = bat_max(high[k], points[3 * i + k]);
        }
    bat_release(points);
    bat_release(v);
    bat_release(u);
    return status;
}

/* The surfaces of a model, one after another: the next from *index on, or NULL. */
static const batten_surface *next_surface(const batten_model *model, int *index)
{
    while (*index < batten_model_count(model)) {
        const batten_object *object = batten_model_object(model, (*index)++);
        if (object->kind == BATTEN_OBJECT_SURFACE &&
            batten_surface_dimension(object->surface) == 3)
            return object->surface;
    }
    return NULL;
}

/* Which half is taken: that with side * y >= below, where `below` is 0 but for roundings. */
typedef struct {
    double side, below;
} half;

/* The box of the half hull, and on which side of the centre plane it lies. */
static batten_status measure_half(const batten_model *model, batten_notes *notes,
                                  bat_hull *hull, half *out)
{
    for (int k = 0; k < 3; k++) {
        hull->low[k] = HUGE_VAL;
        hull->high[k] = -HUGE_VAL;
    }
    int index = 0;
    const batten_surface *surface;
    while ((surface = next_surface(model, &index)) != NULL) {
        const batten_status status = extend(surface, hull->low, hull->high);
        if (status != BATTEN_OK)
            return status;
    }
    if (!(hull->low[0] < hull->high[0] && hull->low[2] < hull->high[2]))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "a lines plan needs a surface with some length and depth; none of the %d "
            "objects is one",
            batten_model_count(model));
    const double side = hull->high[1] > 0 ? 1 : -1;
    if (side < 0)
        batten_notes_add(notes, "", 0, "", "the hull lies at y <= 0 and is drawn mirrored");
    hull->high[1] = side > 0 ? hull->high[1] : -hull->low[1];
    hull->low[1] = 0;
    if (!(hull->high[1] > 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a lines plan needs a hull with some breadth");
    /* Points on the centre plane may have the rounding of single precision on the other side. */
    *out = (half){side, -1e-7 * hull->high[1]};
    return BATTEN_OK;
}

/* ---- where to cut ---- */

static batten_status make_cuts(bat_cuts *cuts, int count)
{
    cuts->cuts =
        bat_array((size_t)count + 1, sizeof *cuts->cuts); /* and the design waterline */
    if (!cuts->cuts)
        return BATTEN_OUT_OF_MEMORY;
    cuts->count = count;
    return BATTEN_OK;
}

/* Multiples of the spacing, `from` among the planes or not. */
static batten_status space_cuts(bat_hull *hull, bat_family family, double spacing)
{
    const double low = hull->low[family], high = hull->high[family];
    const double margin = 1e-6 * (high - low);
    const double first = ceil((low + (family == BAT_STATIONS ? -margin : margin)) / spacing);
    const double last = floor((high + (family == BAT_STATIONS ? margin : -margin)) / spacing);
    if (!(last - first < CUT_LIMIT))
        return bat_fail(BATTEN_TOO_LARGE,
                        "a %s every %g between %g and %g makes more than %d of them",
                        names[family], spacing, low, high, CUT_LIMIT);
    bat_cuts *cuts = &hull->families[family];
    cuts->spacing = spacing;
    const batten_status status = make_cuts(cuts, (int)bat_max(0, last - first + 1));
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = (first + i) * spacing;
    return status;
}

static batten_status place_given(bat_hull *hull, const batten_draw_lines_plan_options *plan)
{
    bat_cuts *cuts = &hull->families[BAT_STATIONS];
    if (plan->station_count < 0 || plan->station_count > CUT_LIMIT)
        return bat_fail(BATTEN_TOO_LARGE, "%d station%s %s given; a lines plan draws up to %d",
                        plan->station_count, bat_plural(plan->station_count),
                        bat_one_or_many(plan->station_count, "is", "are"), CUT_LIMIT);
    for (int i = 0; i < plan->station_count; i++) {
        if (!isfinite(plan->station_at[i]))
            return bat_fail(BATTEN_NOT_FINITE, "station %d stands at %g", i + 1,
                            plan->station_at[i]);
        if (i > 0 && !(plan->station_at[i] > plan->station_at[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "station %d at %g does not lie beyond station %d at %g", i + 1,
                            plan->station_at[i], i - 1 + 1, plan->station_at[i - 1]);
    }
    const batten_status status = make_cuts(cuts, plan->station_count);
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = plan->station_at[i];
    return status;
}

static batten_status place_stations(bat_hull *hull, const batten_draw_lines_plan_options *plan)
{
    if (plan->station_at)
        return place_given(hull, plan);
    if (plan->stations > 0)
        return space_cuts(hull, BAT_STATIONS, plan->stations);
    bat_cuts *cuts = &hull->families[BAT_STATIONS];
    const double low = hull->low[0], length = hull->high[0] - low;
    const batten_status status = make_cuts(cuts, 11);
    cuts->spacing = length / 10;
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = low + length * i / 10;
    return status;
}

/* Put the design waterline among the others, or mark the one that it is. */
static void add_design_waterline(bat_hull *hull, double at, batten_notes *notes)
{
    bat_cuts *cuts = &hull->families[BAT_WATERLINES];
    if (isnan(at))
        return;
    if (!(at > hull->low[2] && at < hull->high[2])) {
        batten_notes_add(notes, "", 0, "design waterline",
                         "height %g lies outside the hull, which reaches from %g to %g", at,
                         hull->low[2], hull->high[2]);
        return;
    }
    int i = cuts->count;
    /* Nearer than a millionth of the depth two waterlines are one line of the drawing. */
    const double same = 1e-6 * (hull->high[2] - hull->low[2]);
    while (i > 0 && cuts->cuts[i - 1].at > at - same)
        i--;
    if (i == cuts->count || cuts->cuts[i].at > at + same) {
        memmove(cuts->cuts + i + 1, cuts->cuts + i,
                (size_t)(cuts->count - i) * sizeof *cuts->cuts);
        cuts->cuts[i] = (bat_cut){.at = at};
        cuts->count++;
    }
    cuts->cuts[i].is_design = true;
}

static batten_status check_spacing(double spacing, bat_family family)
{
    if (spacing >= 0 && isfinite(spacing))
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT, "the spacing of the %ss is %g; it cannot be negative",
                    names[family], spacing);
}

static batten_status place_cuts(bat_hull *hull, const batten_draw_lines_plan_options *plan,
                                batten_notes *notes)
{
    const double given[] = {plan->stations, plan->buttocks, plan->waterlines};
    /* At most so many when the spacing is left to us. */
    static const int usual[] = {11, 10, 12};
    for (int f = 0; f < BAT_FAMILIES; f++) {
        batten_status status = check_spacing(given[f], (bat_family)f);
        const double range = hull->high[f] - hull->low[f];
        if (status == BATTEN_OK && f == BAT_STATIONS)
            status = place_stations(hull, plan);
        else if (status == BATTEN_OK)
            status = space_cuts(hull, (bat_family)f,
                                given[f] > 0 ? given[f] : bat_round_step(range, usual[f]));
        if (status != BATTEN_OK)
            return status;
    }
    add_design_waterline(hull, plan->design_waterline, notes);
    return BATTEN_OK;
}

/* ---- cutting ---- */

/* Cells of the grid on which a section is sought: fine enough for a smooth line on the
 * sheet. */
static int cells(const batten_surface *surface, batten_direction direction)
{
    const int spans = batten_surface_spans(surface, direction, NULL) - 1;
    return bat_max_int(96, bat_min_int(4 * spans, 400));
}

static batten_status keep_line(bat_strokes *list, const batten_polyline *line, half h)
{
    const size_t count = (size_t)line->count;
    bat_stroke copy = {count + line->closed, bat_array3(count + 1, 3, sizeof(double))};
    if (!copy.points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < copy.count; i++)
        for (size_t k = 0; k < 3; k++)
            copy.points[3 * i + k] = line->points[3 * (i % count) + k] * (k == 1 ? h.side : 1);
    const batten_status status = bat_strokes_add_part(list, &copy, 1, 1, h.below);
    bat_stroke_free(&copy);
    return status;
}

static batten_status cut_surface(const batten_surface *surface, bat_family family, half h,
                                 bat_cut *cut)
{
    const batten_vec3 normal = {family == BAT_STATIONS, family == BAT_BUTTOCKS,
                                family == BAT_WATERLINES};
    const double offset = family == BAT_BUTTOCKS ? h.side * cut->at : cut->at;
    batten_polylines found = {0, NULL};
    batten_status status = batten_surface_section(
        surface, normal, offset, cells(surface, BATTEN_U), cells(surface, BATTEN_V), &found);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        status = keep_line(&cut->lines, &found.lines[i], h);
    batten_polylines_release(&found);
    return status;
}

/* A plane at the very end of the hull only touches it; there the edges are drawn. */
static bool is_at_end(const bat_hull *hull, bat_family family, double at)
{
    const double margin = 1e-6 * (hull->high[family] - hull->low[family]);
    return fabs(at - hull->low[family]) <= margin || fabs(at - hull->high[family]) <= margin;
}

static batten_status cut_family(const batten_model *model, bat_family family, half h,
                                batten_notes *notes, bat_hull *hull)
{
    bat_cuts *cuts = &hull->families[family];
    for (int i = 0; i < cuts->count; i++) {
        bat_cut *cut = &cuts->cuts[i];
        if (is_at_end(hull, family, cut->at))
            continue;
        int index = 0;
        const batten_surface *surface;
        while ((surface = next_surface(model, &index)) != NULL) {
            const batten_status status = cut_surface(surface, family, h, cut);
            if (status != BATTEN_OK)
                return status;
        }
        if (cut->lines.count == 0)
            batten_notes_add(notes, "", 0, names[family],
                             "the plane %c = %g does not meet the hull", letters[family],
                             cut->at);
    }
    return BATTEN_OK;
}

static batten_status keep_edge(const batten_surface *surface, batten_direction direction,
                               double at, double size, half h, bat_strokes *edges)
{
    bat_stroke edge = {0, NULL};
    batten_status status = bat_stroke_isoline(surface, direction, at, &edge);
    for (size_t i = 0; i < edge.count; i++)
        edge.points[3 * i + 1] *= h.side;
    /* An edge shorter than a millionth of the hull is a pole, and is not drawn. */
    if (status == BATTEN_OK && !bat_stroke_is_point(&edge, 1e-6 * size))
        status = bat_strokes_add_part(edges, &edge, 1, 1, h.below);
    bat_stroke_free(&edge);
    return status;
}

static batten_status gather_edges(const batten_model *model, half h, bat_hull *hull)
{
    const double size = hull->high[0] - hull->low[0];
    int index = 0;
    const batten_surface *surface;
    while ((surface = next_surface(model, &index)) != NULL)
        for (int d = 0; d < 2; d++) {
            const batten_direction direction = d == 0 ? BATTEN_U : BATTEN_V;
            const batten_interval domain = batten_surface_domain(surface, direction);
            /* Closed to the rounding of files. */
            if (batten_surface_is_closed(surface, direction, 1e-9 * size))
                continue;
            batten_status status =
                keep_edge(surface, direction, domain.a, size, h, &hull->edges);
            if (status == BATTEN_OK)
                status = keep_edge(surface, direction, domain.b, size, h, &hull->edges);
            if (status != BATTEN_OK)
                return status;
        }
    return BATTEN_OK;
}

batten_status bat_hull_cut(const batten_model *model,
                           const batten_draw_lines_plan_options *plan, batten_notes *notes,
                           bat_hull *out)
{
    bat_hull hull = {.edges = {0, 0, NULL}};
    half h = {1, 0};
    batten_status status = measure_half(model, notes, &hull, &h);
    if (status == BATTEN_OK)
        status = place_cuts(&hull, plan, notes);
    for (int f = 0; f < BAT_FAMILIES && status == BATTEN_OK; f++)
        status = cut_family(model, (bat_family)f, h, notes, &hull);
    if (status == BATTEN_OK)
        status = gather_edges(model, h, &hull);
    if (status == BATTEN_OK)
        *out = hull;
    else
        bat_hull_free(&hull);
    return status;
}

void bat_hull_free(bat_hull *hull)
{
    for (int f = 0; f < BAT_FAMILIES; f++) {
        for (int i = 0; i < hull->families[f].count; i++)
            bat_strokes_free(&hull->families[f].cuts[i].lines);
        bat_release(hull->families[f].cuts);
    }
    bat_strokes_free(&hull->edges);
}
