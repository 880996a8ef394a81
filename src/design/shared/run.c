/* What a feature may do while it runs: put objects out, change all of its inputs. */
#include "design/text/document.h"

#include <stdio.h>

/* ---- objects ---- */

batten_status bat_merge(const bat_run *run, const char *parameter, unsigned kinds,
                        batten_model **out)
{
    bat_objects objects = {0, NULL};
    batten_model *model = NULL;
    batten_status status = bat_gather(run, parameter, kinds, &objects);
    if (status == BATTEN_OK)
        status = batten_model_create(bat_unit_metres(run), &model);
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = batten_model_add(model, objects.at[i]);
    bat_objects_release(&objects);
    if (status == BATTEN_OK)
        *out = model;
    else
        batten_model_unref(model);
    return status;
}

/* ---- putting objects into the model ---- */

batten_status bat_expect(const bat_run *run, long long count)
{
    const long long all = run->objects + count, most = run->document->most_objects;
    return all <= most
               ? BATTEN_OK
               : bat_fail(
                     BATTEN_TOO_LARGE,
                     "with it the design would have made %lld objects, more than %lld; a line "
                     "'most-objects: %lld' in the design allows them",
                     all, most, all);
}

batten_status bat_add(bat_run *run, const batten_object *object)
{
    const batten_status status = bat_expect(run, (long long)batten_model_count(run->model) + 1);
    return status == BATTEN_OK ? batten_model_add(run->model, object) : status;
}

batten_status bat_put_curve(bat_run *run, batten_status status, batten_curve *curve)
{
    const batten_object like = {.name = run->name, .layer = ""};
    return bat_put_curve_like(run, status, curve, &like, false);
}

batten_status bat_put_surface(bat_run *run, batten_status status, batten_surface *surface)
{
    const batten_object like = {.name = run->name, .layer = ""};
    return bat_put_surface_like(run, status, surface, &like);
}

static batten_status put_curve(bat_run *run, batten_status status, batten_curve *curve,
                               batten_chain *chain, const batten_object *like, bool keep_data)
{
    batten_object object = *like;
    object.kind = BATTEN_OBJECT_CURVE;
    object.curve = curve;
    object.chain = chain; /* not that of the curve that it was made from */
    object.surface = NULL;
    object.triangles = NULL;
    if (!keep_data) {
        object.point_count = 0;
        object.points = object.parameters = NULL;
    }
    if (status == BATTEN_OK)
        status = bat_add(run, &object);
    batten_chain_unref(chain);
    batten_curve_unref(curve);
    return status;
}

batten_status bat_put_curve_like(bat_run *run, batten_status status, batten_curve *curve,
                                 const batten_object *like, bool keep_data)
{
    return put_curve(run, status, curve, NULL, like, keep_data);
}

batten_status bat_put_curves_like(bat_run *run, const batten_object *object,
                                  const batten_curves *curves)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < curves->count && status == BATTEN_OK; i++) {
        batten_object like = *object;
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", object->name, i + 1);
        if (curves->count > 1)
            like.name = name;
        status = bat_put_curve_like(run, status, batten_curve_ref(curves->at[i]), &like, false);
    }
    return status;
}

batten_status bat_put_flat(bat_run *run, batten_status status, batten_curve *curve,
                           const char *name, const char *layer, const double *colour)
{
    const batten_object like = {.name = name,
                                .layer = layer,
                                .has_colour = true,
                                .colour = {colour[0], colour[1], colour[2]}};
    batten_curve *space = NULL;
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(curve, 3, &space);
    batten_curve_unref(curve);
    return bat_put_curve_like(run, status, space, &like, false);
}

batten_status bat_put_chain_like(bat_run *run, batten_status status, batten_curve *curve,
                                 batten_chain *chain, const batten_object *like)
{
    return put_curve(run, status, curve, chain, like, false);
}

/* What other features change and files hold is NURBS. */
static batten_status to_nurbs(bat_run *run, const batten_surface *surface,
                              batten_surface **nurbs)
{
    double error = 0;
    const batten_status status =
        batten_surface_to_nurbs(surface, bat_tolerance(run), &error, nurbs);
    if (status == BATTEN_OK && error > 0)
        bat_report_error(run, error, error);
    return status;
}

batten_status bat_put_surface_like(bat_run *run, batten_status status, batten_surface *surface,
                                   const batten_object *like)
{
    batten_surface *nurbs = NULL;
    if (status == BATTEN_OK)
        status = to_nurbs(run, surface, &nurbs);
    batten_surface_unref(surface);
    const batten_object object = {.name = like->name,
                                  .layer = like->layer,
                                  .group = like->group,
                                  .is_hidden = like->is_hidden,
                                  .has_colour = like->has_colour,
                                  .colour = {like->colour[0], like->colour[1], like->colour[2]},
                                  .kind = BATTEN_OBJECT_SURFACE,
                                  .surface = nurbs};
    if (status == BATTEN_OK)
        status = bat_add(run, &object);
    batten_surface_unref(nurbs);
    return status;
}

batten_status bat_put_triangles(bat_run *run, batten_status status, batten_triangles *triangles)
{
    const batten_object object = {.name = run->name,
                                  .layer = "",
                                  .kind = BATTEN_OBJECT_TRIANGLES,
                                  .triangles = triangles};
    if (status == BATTEN_OK)
        status = bat_add(run, &object);
    batten_triangles_unref(triangles);
    return status;
}

/* ---- changing all objects ---- */

static batten_status change_curve(bat_run *run, const bat_change *change,
                                  const batten_object *object)
{
    batten_curve *curve = NULL;
    batten_chain *chain = NULL;
    double error = 0;
    batten_status status = change->curve
                               ? change->curve(run, object->curve, &curve)
                               : change->near_curve(run, object->curve, &error, &curve);
    if (status == BATTEN_OK && !change->curve)
        bat_report_error(run, error, error);
    if (status == BATTEN_OK && object->chain && change->chain)
        status = change->chain(run, object->chain, &chain);
    return put_curve(run, status, curve, chain, object, change->keeps_data);
}

static batten_status change_surface(bat_run *run, const bat_change *change,
                                    const batten_object *object)
{
    batten_surface *surface = NULL;
    double error = 0;
    const batten_status status =
        change->surface ? change->surface(run, object->surface, &surface)
                        : change->near_surface(run, object->surface, &error, &surface);
    if (status == BATTEN_OK && !change->surface)
        bat_report_error(run, error, error);
    return bat_put_surface_like(run, status, surface, object);
}

static batten_status change_triangles(bat_run *run, const bat_change *change,
                                      const batten_object *object)
{
    batten_object made = *object;
    batten_triangles *triangles = NULL;
    batten_status status = change->triangles(run, object->triangles, &triangles);
    made.triangles = triangles;
    if (status == BATTEN_OK)
        status = bat_add(run, &made);
    batten_triangles_unref(triangles);
    return status;
}

static unsigned changed_kinds(const bat_change *change)
{
    return (change->curve || change->near_curve ? BAT_CURVES : 0) |
           (change->surface || change->near_surface ? BAT_SURFACES : 0) |
           (change->triangles ? BAT_TRIANGLES : 0);
}

static batten_status change_object(bat_run *run, const bat_change *change, unsigned kinds,
                                   const batten_object *object)
{
    if (!(kinds & 1u << object->kind))
        return bat_add(run, object);
    if (object->kind == BATTEN_OBJECT_CURVE)
        return change_curve(run, change, object);
    if (object->kind == BATTEN_OBJECT_TRIANGLES)
        return change_triangles(run, change, object);
    return change_surface(run, change, object);
}

batten_status bat_change_all(bat_run *run, const bat_change *change)
{
    const char *input = run->feature->parameters[0].name;
    const unsigned kinds = changed_kinds(change);
    bat_objects objects;
    batten_status status = bat_gather_some(run, input, kinds, &objects);
    if (status != BATTEN_OK)
        return status;
    bat_objects_release(&objects);
    status = bat_gather(run, input, BAT_ALL, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = change_object(run, change, kinds, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

/* ---- affine maps ---- */

batten_status bat_transform_object(bat_run *run, const batten_affine *map,
                                   const batten_object *object)
{
    return batten_model_add_mapped(run->model, object, map);
}

batten_status bat_transform_all(bat_run *run, const batten_affine *map)
{
    bat_objects objects;
    batten_status status = bat_gather(run, run->feature->parameters[0].name, BAT_ALL, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = bat_transform_object(run, map, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

void bat_report_error(bat_run *run, double max, double rms)
{
    batten_feature_result *shown = &run->result->shown;
    shown->error_max = shown->has_error ? bat_max(shown->error_max, max) : max;
    shown->error_rms = shown->has_error ? bat_max(shown->error_rms, rms) : rms;
    shown->has_error = true;
}
