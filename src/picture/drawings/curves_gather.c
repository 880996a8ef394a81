/* The shapes of a drawing: curves, isolines and points as strokes, combs as teeth, and their colours. */
#include "numeric/box.h"
#include "numeric/vector.h"
#include "picture/drawings/drawing.h"
#include "picture/sheet/axes.h"
#include "picture/sheet/flat.h"

#include <string.h>

/* ---- gathering ---- */

/* A comb is drawn with so many teeth at first, and with more until its outline is smooth, at most so many. */
enum { FEWEST_TEETH = 160, MOST_TEETH = 16384 };

/* How far the tip of a tooth lies from the chord between its neighbours', when the longest of these teeth is
 * a tenth of the size, in sizes. */
static double bend_at(const batten_tooth *teeth, double stretch, double size)
{
    double tips[3][3], along[3], off[3], cross[3];
    for (int i = 0; i < 3; i++)
        bat_drawing_comb_tip(&teeth[i], stretch, tips[i]);
    for (int k = 0; k < 3; k++) {
        along[k] = (tips[2][k] - tips[0][k]) / size;
        off[k] = (tips[1][k] - tips[0][k]) / size;
    }
    bat_cross(along, off, cross);
    const double length = sqrt(bat_dot(3, along, along));
    return length > 0 ? sqrt(bat_dot(3, cross, cross)) / length : sqrt(bat_dot(3, off, off));
}

/* Is the line through the tips smooth in a picture of usual size: within a third of a pixel of 1,200? Halving
 * the steps divides the bend of a smooth line by four, and at jumps, between spans, it may have corners. */
static bool is_smooth(int spans, int per_span, const batten_tooth *teeth, double size)
{
    const double enough = 4 * (1.0 / 3) / 1200;
    double sharpest = 0;
    for (int i = 0; i < spans * (per_span + 1); i++)
        sharpest = bat_max(sharpest, fabs(teeth[i].curvature));
    const double stretch = sharpest > 0 ? 0.1 * size / sharpest : 0;
    for (int span = 0; span < spans; span++)
        for (int i = 0; i + 2 <= per_span; i++)
            if (bend_at(teeth + (size_t)span * (size_t)(per_span + 1) + i, stretch, size) >
                enough)
                return false;
    return true;
}

/* The comb with twice as many teeth, until they suffice. */
static batten_status gather_comb(bat_shape *s)
{
    const batten_curve *curve = s->object->curve;
    const int spans = batten_curve_spans(curve, NULL) - 1;
    const double size = bat_box_diagonal(batten_curve_box(curve));
    int per_span = bat_max_int(4, FEWEST_TEETH / bat_max_int(spans, 1));
    for (bool enough = false; !enough; per_span *= 2) {
        const int count = spans * (per_span + 1);
        batten_tooth *teeth = bat_array((size_t)count, sizeof *teeth);
        if (!teeth)
            return BATTEN_OUT_OF_MEMORY;
        const batten_status status = batten_curve_comb(curve, per_span, 1, teeth);
        if (status != BATTEN_OK) {
            bat_release(teeth);
            /* A curve with a cusp is still a curve: it is drawn without a comb. */
            return status == BATTEN_SINGULAR_HERE ? BATTEN_OK : status;
        }
        bat_release(s->teeth);
        s->teeth = teeth;
        s->tooth_count = count;
        enough = is_smooth(spans, per_span, teeth, size) || count > MOST_TEETH / 2;
    }
    for (int i = 0; i < s->tooth_count; i++)
        s->sharpest = bat_max(s->sharpest, fabs(s->teeth[i].curvature));
    return BATTEN_OK;
}

static batten_status gather_curve(const bat_drawing *d, bat_shape *s)
{
    bat_stroke stroke = {0, NULL};
    batten_status status = bat_stroke_curve(s->object->curve, &stroke);
    if (status == BATTEN_OK)
        status = bat_strokes_add(&s->lines, stroke);
    if (status == BATTEN_OK && d->options->comb && batten_curve_dimension(s->object->curve) > 1)
        status = gather_comb(s);
    return status;
}

static batten_status gather_isolines(const bat_drawing *d, bat_shape *s,
                                     batten_direction direction)
{
    const batten_interval domain = batten_surface_domain(s->object->surface, direction);
    const int count = d->options->isolines;
    batten_status status = BATTEN_OK;
    for (int k = 0; k <= count && status == BATTEN_OK; k++) {
        const double at = k < count ? domain.a + (domain.b - domain.a) * k / count : domain.b;
        bat_stroke stroke = {0, NULL};
        status = bat_stroke_isoline(s->object->surface, direction, at, &stroke);
        if (status == BATTEN_OK)
            status = bat_strokes_add(&s->lines, stroke);
    }
    return status;
}

static batten_status gather_stations(bat_shape *s)
{
    const batten_offset_table *table = s->object->offset_table;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_offset_table_station_count(table) && status == BATTEN_OK; i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        const size_t count = (size_t)station->point_count;
        double *points = bat_array3(count, 3, sizeof *points);
        if (!points)
            return BATTEN_OUT_OF_MEMORY;
        for (size_t k = 0; k < count; k++) {
            const batten_table_point *p = &station->points[k];
            memcpy(points + 3 * k, (double[3]){p->x, p->y, p->z}, 3 * sizeof *points);
        }
        status = bat_strokes_add(&s->lines, (bat_stroke){count, points});
    }
    return status;
}

static batten_status gather_shape(const bat_drawing *d, bat_shape *s)
{
    switch (s->object->kind) {
    case BATTEN_OBJECT_CURVE:
        return gather_curve(d, s);
    case BATTEN_OBJECT_SURFACE: {
        const batten_status status = gather_isolines(d, s, BATTEN_U);
        return status == BATTEN_OK ? gather_isolines(d, s, BATTEN_V) : status;
    }
    case BATTEN_OBJECT_OFFSET_TABLE:
        return gather_stations(s);
    case BATTEN_OBJECT_TRIANGLES:
        return bat_stroke_triangles(s->object->triangles, d->options->isolines, &s->lines);
    case BATTEN_OBJECT_MESH:
        return bat_stroke_mesh(s->object->mesh, BAT_MESH_EDGES_OR_ALL, NULL, &s->lines);
    case BATTEN_OBJECT_POINTS:
    case BATTEN_OBJECT_BODY: /* the model was made flat, and its bodies meshes */
    case BATTEN_OBJECT_INSTANCE:
        break;
    }
    return BATTEN_OK;
}

static bat_colour colour_of(const batten_object *object, int index, int count)
{
    /* Colours of faces are often too pale for lines. */
    const double share = object->kind == BATTEN_OBJECT_MESH ? 0.5 : 1;
    if (object->has_colour)
        return (bat_colour){share * object->colour[0], share * object->colour[1],
                            share * object->colour[2]};
    return bat_palette[count <= BAT_COLOURED ? index : 0];
}

batten_status bat_drawing_gather(bat_drawing *d)
{
    d->shape_count = batten_model_count(d->model);
    if (d->shape_count == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the model has no objects: there is nothing to draw");
    d->shapes = bat_array((size_t)d->shape_count, sizeof *d->shapes);
    if (!d->shapes)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < d->shape_count && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(d->model, i);
        d->shapes[i].object = object;
        d->shapes[i].colour = colour_of(object, i, d->shape_count);
        status = gather_shape(d, &d->shapes[i]);
    }
    return status;
}
