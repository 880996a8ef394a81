/* Turns any curve, surface or body into clamped NURBS in space, for IGES and STEP. */
#include "exchange/shapes/prepare.h"
#include "base/plural.h"
#include "model/object_notes.h"
#include "spline/surface/surface.h"

#include <limits.h>

batten_status bat_prepare_curve(const batten_object *object, batten_curve **out)
{
    batten_curve *space = NULL;
    batten_status status = batten_curve_to_dimension(object->curve, 3, &space);
    if (status == BATTEN_OK && batten_curve_is_clamped(space))
        *out = batten_curve_ref(space);
    else if (status == BATTEN_OK)
        status = batten_curve_clamp(space, out);
    batten_curve_unref(space);
    return status;
}

batten_status bat_prepare_surface(const batten_object *object, double tolerance,
                                  batten_notes *notes, batten_surface **out)
{
    batten_surface *nurbs = NULL;
    double error = 0;
    if (batten_surface_dimension(object->surface) != 3)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "surface '%.60s' has %d dimension%s; the format needs 3", object->name,
                        batten_surface_dimension(object->surface),
                        bat_plural(batten_surface_dimension(object->surface)));
    batten_status status = batten_surface_to_nurbs(object->surface, tolerance, &error, &nurbs);
    if (status == BATTEN_OK && error > 0)
        batten_notes_add(notes, "", 0, object->name, "approximated within %g", error);
    if (status == BATTEN_OK)
        status = bat_surface_clamp_both(&nurbs);
    if (status == BATTEN_OK)
        *out = batten_surface_ref(nurbs);
    batten_surface_unref(nurbs);
    return status;
}

/* What is said of faces is said of the object. */
static batten_status trace_faces(const batten_object *object, double unit_metres,
                                 batten_notes *notes, batten_body_trace_report *report,
                                 batten_body **out)
{
    batten_notes *said = NULL;
    batten_status status = batten_notes_create(INT_MAX, &said);
    if (status == BATTEN_OK)
        status = batten_body_trace(object->body, batten_body_view(object->body)->tolerance,
                                   NULL, said, report, out);
    if (said)
        bat_object_notes(said, object->name, unit_metres, notes);
    batten_notes_free(said);
    return status;
}

static batten_status trace(const batten_object *object, double unit_metres, batten_notes *notes,
                           batten_body **out)
{
    const batten_body_parts *parts = batten_body_view(object->body);
    batten_body *traced = NULL;
    batten_body_trace_report report = {.failed = 0};
    if (parts->is_traced) {
        *out = batten_body_ref(object->body);
        return BATTEN_OK;
    }
    const batten_status status = trace_faces(object, unit_metres, notes, &report, &traced);
    if (status == BATTEN_OUT_OF_MEMORY)
        return status;
    if (status == BATTEN_OK && report.failed == 0) {
        *out = traced;
        return BATTEN_OK;
    }
    batten_notes_add(notes, "", 0, object->name,
                     "not all faces have curves in their parameters; written as they are");
    batten_body_unref(traced);
    *out = batten_body_ref(object->body);
    return BATTEN_OK;
}

batten_status bat_prepare_body(const batten_object *object, double tolerance,
                               double unit_metres, batten_notes *notes, batten_body **out)
{
    batten_surface *surface = NULL;
    if (object->kind == BATTEN_OBJECT_BODY)
        return trace(object, unit_metres, notes, out);
    batten_status status = bat_prepare_surface(object, tolerance, notes, &surface);
    if (status == BATTEN_OK)
        status = batten_body_from_surface(object->name, surface, tolerance, out);
    batten_surface_unref(surface);
    return status;
}

static size_t points_of(const batten_surface *surface)
{
    return (size_t)batten_surface_point_count(surface, BATTEN_U) *
           (size_t)batten_surface_point_count(surface, BATTEN_V);
}

static size_t points_of_object(const batten_object *object)
{
    size_t count = 0;
    const batten_body_parts *parts = object->body ? batten_body_view(object->body) : NULL;
    if (object->surface)
        count += points_of(object->surface);
    if (object->curve)
        count += (size_t)batten_curve_point_count(object->curve);
    for (int f = 0; parts && f < parts->face_count; f++)
        count += points_of(parts->faces[f].surface);
    return count;
}

size_t bat_count_points(const batten_model *model)
{
    size_t count = 0;
    for (int i = 0; i < batten_model_count(model); i++)
        count += points_of_object(batten_model_object(model, i));
    return count;
}
