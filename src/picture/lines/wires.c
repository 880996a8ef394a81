/* Lines of a model for line drawings: isolines, borders, edges of bodies and meshes. */
#include "picture/lines/wires.h"

#include "picture/sheet/sheet.h"

#include <stdlib.h>
#include <string.h>

/* Facets of all surfaces together are at most about so many. */
static const double facet_limit = 2000000;

bool bat_wires_shows(const batten_object *object)
{
    return object->kind == BATTEN_OBJECT_SURFACE &&
           batten_surface_dimension(object->surface) == 3;
}

/* ---- the list ---- */

/* A line more, which is taken over. */
static batten_status add_wire(bat_wires *w, bat_wire_kind kind, int object, double value,
                              bat_stroke stroke)
{
    if (w->count == w->capacity) {
        const size_t capacity = 2 * w->capacity + 64;
        bat_wire *larger = bat_resize(w->wires, capacity, sizeof *larger);
        if (!larger) {
            bat_stroke_free(&stroke);
            return BATTEN_OUT_OF_MEMORY;
        }
        w->wires = larger;
        w->capacity = capacity;
    }
    w->wires[w->count++] = (bat_wire){kind, object, value, stroke, NULL};
    return BATTEN_OK;
}

void bat_wires_drop(bat_wires *w, size_t count)
{
    while (w->count > count) {
        bat_wire *last = &w->wires[--w->count];
        bat_stroke_free(&last->stroke);
        bat_release(last->away);
    }
}

void bat_wires_free(bat_wires *w)
{
    for (int i = 0; w->tiles && i < batten_model_count(w->model); i++)
        bat_tiles_free(&w->tiles[i]);
    bat_wires_drop(w, 0);
    bat_release(w->tiles);
    bat_release(w->wires);
    w->tiles = NULL;
    w->wires = NULL;
    w->capacity = 0;
}

/* ---- isolines, edges, creases ---- */

/* Are two edges the same, in whatever direction? */
static bool coincide(const bat_stroke *a, const bat_stroke *b, double near)
{
    const double *p[3] = {a->points, a->points + 3 * (a->count / 2),
                          a->points + 3 * (a->count - 1)};
    const double *first = b->points, *last = b->points + 3 * (b->count - 1);
    bool ahead = true, back = true;
    for (int k = 0; k < 3; k++) {
        ahead &= fabs(p[0][k] - first[k]) <= near && fabs(p[2][k] - last[k]) <= near;
        back &= fabs(p[2][k] - first[k]) <= near && fabs(p[0][k] - last[k]) <= near;
    }
    if (!ahead && !back)
        return false;
    /* The middle of the one on the other, which may have points elsewhere. */
    for (size_t i = 0; i + 1 < b->count; i++) {
        const double *q = b->points + 3 * i;
        double along[3], off[3], length2 = 0, dot = 0, distance2 = 0;
        for (int k = 0; k < 3; k++) {
            along[k] = q[3 + k] - q[k];
            off[k] = p[1][k] - q[k];
            length2 += along[k] * along[k];
            dot += along[k] * off[k];
        }
        const double s = length2 > 0 ? bat_max(0, bat_min(1, dot / length2)) : 0;
        for (int k = 0; k < 3; k++)
            distance2 += (off[k] - s * along[k]) * (off[k] - s * along[k]);
        if (distance2 <= near * near)
            return true;
    }
    return false;
}

static bool is_known_edge(const bat_wires *w, const bat_stroke *stroke)
{
    for (size_t i = 0; i < w->count; i++)
        if (w->wires[i].kind == BAT_WIRE_EDGE &&
            coincide(stroke, &w->wires[i].stroke, 2 * w->tolerance))
            return true;
    return false;
}

/* The line at a fixed parameter, unless it is a point, or an edge that is there already. */
static batten_status add_isoline(bat_wires *w, bat_wire_kind kind, int object,
                                 batten_direction direction, double at)
{
    bat_stroke stroke = {0, NULL};
    const batten_surface *surface = batten_model_object(w->model, object)->surface;
    const batten_status status =
        bat_stroke_isoline_within(surface, direction, at, w->tolerance, &stroke);
    if (status != BATTEN_OK)
        return status;
    /* A pole to the rounding of files is not a line. */
    if (bat_stroke_is_point(&stroke, 1e-9 * w->size) ||
        (kind == BAT_WIRE_EDGE && is_known_edge(w, &stroke))) {
        bat_stroke_free(&stroke);
        return BATTEN_OK;
    }
    return add_wire(w, kind, object, 0, stroke);
}

/* A normal, not of unit length; (0, 0, 0) where there is none. */
static batten_status normal_at(const batten_surface *surface, batten_direction direction,
                               double at, double across, batten_side side, double n[3])
{
    double d[9];
    const double uv[2] = {direction == BATTEN_U ? at : across,
                          direction == BATTEN_U ? across : at};
    const batten_status status = batten_surface_evaluate_side(
        surface, uv[0], uv[1],
        (batten_sides){direction == BATTEN_U ? side : BATTEN_FROM_RIGHT,
                       direction == BATTEN_U ? BATTEN_FROM_RIGHT : side},
        1, d);
    if (status != BATTEN_OK)
        return status;
    n[0] = d[4] * d[8] - d[5] * d[7];
    n[1] = d[5] * d[6] - d[3] * d[8];
    n[2] = d[3] * d[7] - d[4] * d[6];
    return BATTEN_OK;
}

/* Does the normal turn by more than half a degree from before the one parameter to after the
 * other, both of a knot line or the two ends of a seam, in the middle of some span along it? */
static batten_status is_crease(const batten_surface *surface, batten_direction direction,
                               double before, double after, int count, const double *knots,
                               bool *out)
{
    *out = false;
    for (int i = 0; i + 1 < count && !*out; i++) {
        double a[3], b[3];
        const double across = 0.5 * (knots[i] + knots[i + 1]);
        batten_status status =
            normal_at(surface, direction, before, across, BATTEN_FROM_LEFT, a);
        if (status == BATTEN_OK)
            status = normal_at(surface, direction, after, across, BATTEN_FROM_RIGHT, b);
        if (status != BATTEN_OK)
            return status;
        const double length = sqrt(bat_dot(3, a, a)) * sqrt(bat_dot(3, b, b));
        *out = length > 0 && bat_dot(3, a, b) < cos(0.5 * BAT_PI / 180) * length;
    }
    return BATTEN_OK;
}

static batten_status add_creases(bat_wires *w, int object, batten_direction direction,
                                 bool closed)
{
    const batten_surface *s = batten_model_object(w->model, object)->surface;
    const batten_direction other = direction == BATTEN_U ? BATTEN_V : BATTEN_U;
    const int count = batten_surface_spans(s, direction, NULL);
    const int across = batten_surface_spans(s, other, NULL);
    double *knots = bat_array((size_t)count + (size_t)across, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(s, direction, knots);
    batten_surface_spans(s, other, knots + count);
    batten_status status = BATTEN_OK;
    for (int i = closed ? 0 : 1; i + 1 < count && status == BATTEN_OK; i++) {
        bool crease;
        status = is_crease(s, direction, knots[i > 0 ? i : count - 1], knots[i], across,
                           knots + count, &crease);
        if (status == BATTEN_OK && crease)
            status = add_isoline(w, BAT_WIRE_EDGE, object, direction, knots[i]);
    }
    bat_release(knots);
    return status;
}

/* Edges where the domain ends, and lines between them; of a closed one its seam is a line. */
static batten_status add_lines(bat_wires *w, int object, batten_direction direction)
{
    const batten_surface *s = batten_model_object(w->model, object)->surface;
    const batten_interval domain = batten_surface_domain(s, direction);
    /* Closed to the rounding of files. */
    const bool closed = batten_surface_is_closed(s, direction, 1e-9 * w->size);
    const int parts = w->options->isolines;
    batten_status status = BATTEN_OK;
    if (!closed) {
        status = add_isoline(w, BAT_WIRE_EDGE, object, direction, domain.a);
        if (status == BATTEN_OK)
            status = add_isoline(w, BAT_WIRE_EDGE, object, direction, domain.b);
    }
    for (int k = closed && parts > 1 ? 0 : 1; k < parts && status == BATTEN_OK; k++)
        status = add_isoline(w, BAT_WIRE_ISOLINE, object, direction,
                             domain.a + (domain.b - domain.a) * k / parts);
    return status == BATTEN_OK ? add_creases(w, object, direction, closed) : status;
}

/* ---- contours ---- */

/* A contour as a wire. */
batten_status bat_wires_add_contour(bat_wires *w, bat_wire_kind kind, int object, double value,
                                    const batten_polyline *line)
{
    const size_t count = (size_t)line->count + line->closed;
    bat_stroke stroke = {count, bat_array3(count, 3, sizeof(double))};
    if (!stroke.points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(stroke.points, line->points, 3 * (size_t)line->count * sizeof(double));
    if (line->closed)
        memcpy(stroke.points + 3 * (count - 1), line->points, 3 * sizeof(double));
    return add_wire(w, kind, object, value, stroke);
}

static batten_status add_contours(bat_wires *w, int object, int level_count,
                                  const double *levels)
{
    batten_contours found = {0};
    batten_status status = batten_surface_contours(
        batten_model_object(w->model, object)->surface, &w->options->contour_field,
        (batten_levels){level_count, levels}, w->tolerance, w->job, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        status = bat_wires_add_contour(w, BAT_WIRE_CONTOUR, object,
                                       levels[found.lines[i].level], &found.lines[i].line);
    batten_contours_release(&found);
    return status;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

enum { SAMPLES = 24 };

/* The field on a grid over one surface; what is not a number is left out. */
static batten_status sample_field(const bat_wires *w, const batten_surface *s, size_t *count,
                                  double *values)
{
    const batten_interval u = batten_surface_domain(s, BATTEN_U);
    const batten_interval v = batten_surface_domain(s, BATTEN_V);
    for (int i = 0; i < SAMPLES; i++)
        for (int j = 0; j < SAMPLES; j++) {
            const double uv[2] = {u.a + (u.b - u.a) * (i + 0.5) / SAMPLES,
                                  v.a + (v.b - v.a) * (j + 0.5) / SAMPLES};
            const batten_status status = batten_surface_field_values(
                s, &w->options->contour_field, 1, uv, &values[*count]);
            if (status != BATTEN_OK)
                return status;
            *count += isfinite(values[*count]) ? 1 : 0;
        }
    return BATTEN_OK;
}

/* The range of the field over all surfaces but for one sample in fifty at each end: curvature
 * is large at few places. */
static batten_status find_range(const bat_wires *w, double *low, double *high)
{
    const int objects = batten_model_count(w->model);
    double *values = bat_array3((size_t)objects, SAMPLES * SAMPLES, sizeof *values);
    size_t count = 0;
    batten_status status = values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < objects && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(w->model, i);
        if (bat_wires_shows(object))
            status = sample_field(w, object->surface, &count, values);
    }
    *low = *high = 0;
    if (status == BATTEN_OK && count > 0) {
        qsort(values, count, sizeof *values, ascending);
        const bool all = w->options->contour_field.kind == BATTEN_FIELD_HEIGHT;
        const size_t beyond = all ? 0 : count / 50;
        *low = values[beyond];
        *high = values[count - 1 - beyond];
    }
    bat_release(values);
    return status;
}

static batten_status add_all_contours(bat_wires *w)
{
    enum { MOST_LEVELS = 1000 };
    double low, high, levels[64];
    batten_status status = find_range(w, &low, &high);
    /* What is constant but for roundings has no contours. */
    if (status != BATTEN_OK || !(high - low > 1e-9 * bat_max(fabs(low), fabs(high))))
        return status;
    const double given = w->options->contour_spacing;
    const double step = given > 0 ? given : bat_round_step(high - low, 12);
    /* The ends were sampled inside the surfaces: one level more at each. */
    const double first = floor(low / step) - 1, last = ceil(high / step) + 1;
    if (!(last - first < MOST_LEVELS))
        return bat_fail(BATTEN_TOO_LARGE,
                        "contours %g apart from %g to %g: more than %d levels", step, low, high,
                        MOST_LEVELS);
    w->level_step = step;
    for (double at = first; at <= last && status == BATTEN_OK;) {
        int count = 0;
        for (; count < 64 && at <= last; at++)
            levels[count++] = at * step;
        for (int i = 0; i < batten_model_count(w->model) && status == BATTEN_OK; i++)
            if (bat_wires_shows(batten_model_object(w->model, i)))
                status = add_contours(w, i, count, levels);
    }
    return status;
}

/* ---- all of it ---- */

batten_status bat_wires_measure(bat_wires *w)
{
    int count = 0;
    for (int i = 0; i < batten_model_count(w->model); i++)
        count += bat_wires_shows(batten_model_object(w->model, i)) ||
                 batten_model_object(w->model, i)->kind == BATTEN_OBJECT_MESH;
    if (count == 0)
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "none of the %d objects of the model is a surface in space, a body or a "
            "mesh: nothing hides a line",
            batten_model_count(w->model));
    batten_model_box(w->model, &w->box);
    const batten_vec3 a = w->box.low, b = w->box.high;
    w->size = hypot(hypot(b.x - a.x, b.y - a.y), b.z - a.z);
    if (!isfinite(w->size))
        return bat_fail(BATTEN_OVERFLOW, "coordinates from %g to %g are too large to draw", a.x,
                        b.x);
    return BATTEN_OK;
}

static batten_status gather_object(bat_wires *w, int i, int surfaces)
{
    const batten_object *object = batten_model_object(w->model, i);
    bat_stroke stroke = {0, NULL};
    if (object->kind == BATTEN_OBJECT_CURVE) {
        const batten_status status = bat_stroke_curve(object->curve, &stroke);
        return status == BATTEN_OK ? add_wire(w, BAT_WIRE_CURVE, i, 0, stroke) : status;
    }
    if (!bat_wires_shows(object))
        return BATTEN_OK;
    batten_status status = add_lines(w, i, BATTEN_U);
    if (status == BATTEN_OK)
        status = add_lines(w, i, BATTEN_V);
    if (status == BATTEN_OK && w->options->hidden != BATTEN_HIDDEN_SHOWN)
        status = bat_tiles_make(object->surface, w->tolerance, 2,
                                (size_t)(facet_limit / 2 / surfaces), BAT_CURVATURE_NONE,
                                w->job, &w->tiles[i]);
    return status;
}

batten_status bat_wires_add_mesh(bat_wires *w, bat_wire_kind kind, int object,
                                 bat_mesh_lines which, const bat_mesh_eye *eye)
{
    bat_strokes lines = {0};
    batten_status status =
        bat_stroke_mesh(batten_model_object(w->model, object)->mesh, which, eye, &lines);
    for (size_t i = 0; i < lines.count && status == BATTEN_OK; i++) {
        status = add_wire(w, kind, object, 0, lines.strokes[i]);
        lines.strokes[i] = (bat_stroke){0, NULL}; /* taken over */
    }
    bat_strokes_free(&lines);
    return status;
}

/* After the edges of surfaces, which are compared with those that are there. A smooth mesh is
 * seen by its silhouettes, when these are drawn. */
static batten_status gather_meshes(bat_wires *w)
{
    const bat_mesh_lines which =
        w->options->silhouettes ? BAT_MESH_EDGES : BAT_MESH_EDGES_OR_ALL;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(w->model) && status == BATTEN_OK; i++)
        if (batten_model_object(w->model, i)->kind == BATTEN_OBJECT_MESH)
            status = bat_wires_add_mesh(w, BAT_WIRE_EDGE, i, which, NULL);
    return status;
}

batten_status bat_wires_gather(bat_wires *w, double scale)
{
    const int count = batten_model_count(w->model);
    int surfaces = 0;
    for (int i = 0; i < count; i++)
        surfaces += bat_wires_shows(batten_model_object(w->model, i));
    /* A quarter of a point is not seen; but a line must lie on the facets that could hide it.
     */
    w->tolerance = (w->options->hidden == BATTEN_HIDDEN_SHOWN ? 0.25 : 0.05) / scale;
    w->tiles = bat_array((size_t)count, sizeof *w->tiles);
    batten_status status = w->tiles ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        status = gather_object(w, i, surfaces);
    if (status == BATTEN_OK)
        status = gather_meshes(w);
    if (status == BATTEN_OK && w->options->contours)
        status = add_all_contours(w);
    w->lasting = w->count;
    if (status != BATTEN_OK)
        bat_wires_free(w);
    return status;
}
