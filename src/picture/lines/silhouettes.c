/* Where surfaces turn away from the eye. */
#include "numeric/vector.h"
#include "picture/lines/wires.h"

/* The direction to the eye from a point. */
static void look_back(const bat_eye *eye, const double point[3], double out[3])
{
    double length2 = 0;
    for (int k = 0; k < 3; k++) {
        out[k] = eye->distance > 0
                     ? eye->centre[k] + eye->distance * eye->view.eye[k] - point[k]
                     : eye->view.eye[k];
        length2 += out[k] * out[k];
    }
    for (int k = 0; k < 3; k++)
        out[k] /= sqrt(length2);
}

/* The unit normal on the side from which the surface bends away: the line of sight e lies in
 * the tangent plane, e = a Su + b Sv, and along it the surface leaves towards n where
 * II(a, b) > 0. Seen from the eye there is nothing of it on the other side. */
static batten_status find_away(const batten_surface *surface, const bat_eye *eye,
                               const double uv[2], double away[3])
{
    double d[18], e[3], n[3];
    const batten_status status = batten_surface_evaluate(surface, uv[0], uv[1], 2, d);
    if (status != BATTEN_OK)
        return status;
    const double *su = d + 3, *sv = d + 6;
    look_back(eye, d, e);
    bat_cross(su, sv, n);
    const double E = bat_dot(3, su, su), F = bat_dot(3, su, sv), G = bat_dot(3, sv, sv);
    const double x = bat_dot(3, e, su), y = bat_dot(3, e, sv), det = E * G - F * F;
    const double a = (G * x - F * y) / det, b = (E * y - F * x) / det;
    const double bends = a * a * bat_dot(3, d + 9, n) + 2 * a * b * bat_dot(3, d + 12, n) +
                         b * b * bat_dot(3, d + 15, n);
    const double length = sqrt(bat_dot(3, n, n));
    const bool known = length > 0 && isfinite(bends);
    for (int k = 0; k < 3; k++)
        away[k] = known ? (bends > 0 ? -n[k] : n[k]) / length : 0;
    return BATTEN_OK;
}

static batten_status add_silhouette(bat_wires *w, const bat_eye *eye, int object,
                                    const batten_polyline *line)
{
    const batten_surface *surface = batten_model_object(w->model, object)->surface;
    batten_status status = bat_wires_add_contour(w, BAT_WIRE_SILHOUETTE, object, 0, line);
    if (status != BATTEN_OK)
        return status;
    bat_wire *wire = &w->wires[w->count - 1];
    wire->away = bat_array3(wire->stroke.count, 3, sizeof *wire->away);
    if (!wire->away)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < wire->stroke.count && status == BATTEN_OK; i++)
        status = find_away(surface, eye, line->parameters + 2 * (i % (size_t)line->count),
                           wire->away + 3 * i);
    return status;
}

static batten_status add_object(bat_wires *w, const bat_eye *eye, int object)
{
    const double *e = eye->view.eye, level = 0, *c = eye->centre, d = eye->distance;
    const batten_surface_field field = {
        .kind = d > 0 ? BATTEN_FIELD_SILHOUETTE : BATTEN_FIELD_ISOPHOTE,
        .direction = {e[0], e[1], e[2]},
        .point = {c[0] + d * e[0], c[1] + d * e[1], c[2] + d * e[2]}};
    batten_contours found = {0};
    batten_status status =
        batten_surface_contours(batten_model_object(w->model, object)->surface, &field,
                                (batten_levels){1, &level}, 0.5 * w->tolerance, w->job, &found);
    for (int i = 0; i < found.count && status == BATTEN_OK; i++)
        status = add_silhouette(w, eye, object, &found.lines[i].line);
    batten_contours_release(&found);
    return status;
}

static batten_status add_outline(bat_wires *w, const bat_eye *eye, int object)
{
    bat_mesh_eye at = {.is_far = !(eye->distance > 0)};
    for (int k = 0; k < 3; k++)
        at.at[k] =
            at.is_far ? eye->view.eye[k] : eye->centre[k] + eye->distance * eye->view.eye[k];
    return bat_wires_add_mesh(w, BAT_WIRE_SILHOUETTE, object, BAT_MESH_OUTLINE, &at);
}

static bool is_same(const bat_eye *a, const bat_eye *b)
{
    bool same = a->distance == b->distance;
    for (int k = 0; k < 3; k++)
        same &= a->view.eye[k] == b->view.eye[k] && a->centre[k] == b->centre[k];
    return same;
}

batten_status bat_wires_add_silhouettes(bat_wires *w, const bat_eye *eye)
{
    if (w->has_silhouettes && is_same(&w->silhouettes_of, eye))
        return BATTEN_OK;
    bat_wires_drop(w, w->lasting);
    w->has_silhouettes = false;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < batten_model_count(w->model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(w->model, i);
        if (w->options->silhouettes && bat_wires_shows(object))
            status = add_object(w, eye, i);
        else if (w->options->silhouettes && object->kind == BATTEN_OBJECT_MESH)
            status = add_outline(w, eye, i);
    }
    w->has_silhouettes = status == BATTEN_OK;
    w->silhouettes_of = *eye;
    return status;
}
