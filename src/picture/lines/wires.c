/* Lines of a model for line drawings: isolines, borders, edges of bodies and meshes. */
#include "picture/lines/wires.h"
#include "base/plural.h"
#include "numeric/box.h"
#include "picture/lines/wire_lines.h"
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
    return bat_wires_add(w, kind, object, value, stroke);
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
            "of the %d object%s of the model none is a surface in space, a body or a "
            "mesh: nothing hides a line",
            batten_model_count(w->model), bat_plural(batten_model_count(w->model)));
    batten_model_box(w->model, &w->box);
    w->size = bat_box_diagonal(w->box);
    if (!isfinite(w->size))
        return bat_fail(BATTEN_OVERFLOW, "coordinates from %g to %g are too large to draw",
                        w->box.low.x, w->box.high.x);
    return BATTEN_OK;
}

static batten_status gather_object(bat_wires *w, int i, int surfaces)
{
    const batten_object *object = batten_model_object(w->model, i);
    bat_stroke stroke = {0, NULL};
    if (object->kind == BATTEN_OBJECT_CURVE) {
        const batten_status status = bat_stroke_curve(object->curve, &stroke);
        return status == BATTEN_OK ? bat_wires_add(w, BAT_WIRE_CURVE, i, 0, stroke) : status;
    }
    if (!bat_wires_shows(object))
        return BATTEN_OK;
    batten_status status = bat_wires_add_lines(w, i, BATTEN_U);
    if (status == BATTEN_OK)
        status = bat_wires_add_lines(w, i, BATTEN_V);
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
        status = bat_wires_add(w, kind, object, 0, lines.strokes[i]);
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
