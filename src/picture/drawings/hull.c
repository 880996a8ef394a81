/* The curves of a lines plan: stations, waterlines and buttocks of half a hull. */
#include "picture/drawings/hull.h"

#include <batten/nearest.h>

#include <string.h>

static const char letters[] = "xyz";

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

/* The plane of a cut on the side that is taken; its offset in the unit of the normal. */
static batten_vec3 plane_of(bat_family family, half h, const bat_cut *cut, double *offset)
{
    *offset = family == BAT_BUTTOCKS    ? h.side * cut->at
              : family == BAT_DIAGONALS ? cut->at * bat_cos(cut->angle)
                                        : cut->at;
    if (family == BAT_DIAGONALS)
        return (batten_vec3){0, h.side * bat_sin(cut->angle), bat_cos(cut->angle)};
    return (batten_vec3){family == BAT_STATIONS, family == BAT_BUTTOCKS,
                         family == BAT_WATERLINES};
}

static batten_status cut_surface(const batten_surface *surface, bat_family family, half h,
                                 bat_cut *cut)
{
    double offset;
    const batten_vec3 normal = plane_of(family, h, cut, &offset);
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
    if (family == BAT_DIAGONALS)
        return false;
    /* Nearer than a millionth of the size is there but for rounding. */
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
        if (cut->lines.count == 0 && family == BAT_DIAGONALS)
            batten_notes_add(notes, "", 0, bat_family_names[family],
                             "diagonal %d from height %g does not meet the hull", i + 1,
                             cut->at);
        else if (cut->lines.count == 0)
            batten_notes_add(notes, "", 0, bat_family_names[family],
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

static void measure_reach(bat_hull *hull)
{
    const bat_cuts *diagonals = &hull->families[BAT_DIAGONALS];
    for (int i = 0; i < diagonals->count; i++) {
        const bat_cut *cut = &diagonals->cuts[i];
        for (size_t k = 0; k < cut->lines.count; k++)
            for (size_t n = 0; n < cut->lines.strokes[k].count; n++)
                hull->reach = bat_max(
                    hull->reach, bat_diagonal_way(cut, cut->lines.strokes[k].points + 3 * n));
    }
}

batten_status bat_hull_cut(const batten_model *model,
                           const batten_draw_lines_plan_options *plan, batten_notes *notes,
                           bat_hull *out)
{
    bat_hull hull = {.edges = {0, 0, NULL}};
    half h = {1, 0};
    batten_status status = measure_half(model, notes, &hull, &h);
    if (status == BATTEN_OK)
        status = bat_hull_place_cuts(plan, notes, &hull);
    for (int f = 0; f < BAT_AXES && status == BATTEN_OK; f++)
        status = cut_family(model, (bat_family)f, h, notes, &hull);
    if (status == BATTEN_OK)
        status = gather_edges(model, h, &hull);
    if (status == BATTEN_OK)
        status = bat_hull_find_knuckles(plan->data, &hull);
    if (status == BATTEN_OK)
        status = bat_hull_place_diagonals(plan, &hull);
    if (status == BATTEN_OK)
        status = cut_family(model, BAT_DIAGONALS, h, notes, &hull);
    measure_reach(&hull);
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
    for (int i = 0; i < hull->knuckle_count; i++)
        bat_strokes_free(&hull->knuckles[i].lines);
    bat_release(hull->knuckles);
}
