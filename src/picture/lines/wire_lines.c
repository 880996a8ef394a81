/* The list of wires, and the isolines, edges and creases among them. */
#include "picture/lines/wire_lines.h"
#include "base/list.h"
#include "picture/lines/wires.h"

/* ---- the list ---- */

batten_status bat_wires_add(bat_wires *w, bat_wire_kind kind, int object, double value,
                            bat_stroke stroke)
{
    const batten_status status = BAT_LIST_ADD(w->wires, w->count, w->capacity,
                                              (bat_wire){kind, object, value, stroke, NULL});
    if (status != BATTEN_OK)
        bat_stroke_free(&stroke);
    return status;
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
    return bat_wires_add(w, kind, object, 0, stroke);
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
        *out = length > 0 && bat_dot(3, a, b) < bat_cos(0.5 * BAT_PI / 180) * length;
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

batten_status bat_wires_add_lines(bat_wires *w, int object, batten_direction direction)
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
