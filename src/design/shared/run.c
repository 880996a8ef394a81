/* What a feature may ask and do while it runs: its arguments by name, objects in and objects out. */
#include "design/text/document.h"

#include <assert.h>
#include <stdio.h>
#include <string.h>

/* ---- arguments ---- */

const bat_argument *bat_argument_of(const bat_run *run, const char *parameter)
{
    int i = 0;
    while (i < run->feature->parameter_count &&
           strcmp(run->feature->parameters[i].name, parameter) != 0)
        i++;
    assert(i < run->feature->parameter_count);
    return &run->arguments[i];
}

static const bat_item *item_of(const bat_run *run, const char *parameter)
{
    static const bat_item none = {{0}, -1, NULL};
    const bat_argument *argument = bat_argument_of(run, parameter);
    return argument->count ? argument->items : &none;
}

bool bat_has(const bat_run *run, const char *parameter)
{
    return bat_argument_of(run, parameter)->count > 0;
}

double bat_number(const bat_run *run, const char *parameter)
{
    return item_of(run, parameter)->number[0];
}

int bat_count(const bat_run *run, const char *parameter)
{
    return bat_has(run, parameter) ? item_of(run, parameter)->count : 0;
}

int bat_word(const bat_run *run, const char *parameter)
{
    return item_of(run, parameter)->count;
}

bool bat_yes(const bat_run *run, const char *parameter)
{
    return item_of(run, parameter)->count == 1;
}

const char *bat_text(const bat_run *run, const char *parameter)
{
    return item_of(run, parameter)->text;
}

batten_vec3 bat_point(const bat_run *run, const char *parameter)
{
    const double *p = item_of(run, parameter)->number;
    return (batten_vec3){p[0], p[1], p[2]};
}

const batten_model *bat_model(const bat_run *run, const char *parameter)
{
    return run->results[item_of(run, parameter)->count].value;
}

double bat_unit_metres(const bat_run *run)
{
    return run->document->unit_metres;
}

const char *bat_unit_name(const bat_run *run)
{
    const bat_document *d = run->document;
    const char *name = batten_unit_name(d->unit_metres);
    const bool is_stated =
        d->has_units || !d->provided || batten_model_unit_metres(d->provided) > 0;
    return is_stated && name ? name : "";
}

double bat_tolerance(const bat_run *run)
{
    return run->document->tolerance;
}

const char *bat_file_name(const bat_run *run)
{
    return run->document->file_name;
}

/* ---- objects ---- */

/* "curves or surfaces" */
static void name_kinds(unsigned kinds, char *text, size_t size)
{
    static const char *const names[] = {"points",    "curves", "surfaces", "tables of offsets",
                                        "triangles", "bodies", "meshes",   "instances"};
    size_t used = 0;
    *text = 0;
    for (int i = 0; i < (int)(sizeof names / sizeof names[0]); i++)
        if (kinds & (1u << i) && used < size)
            used += (size_t)snprintf(text + used, size - used, "%s%s", used ? " or " : "",
                                     names[i]);
}

static bool is_wanted(const batten_object *object, unsigned kinds)
{
    return (kinds & (1u << object->kind)) ||
           ((kinds & BAT_POINTS) && object->kind == BATTEN_OBJECT_CURVE &&
            object->point_count && !(kinds & BAT_CURVES));
}

/* What to do when curves are wanted and there are only points. */
static const char *advice(const bat_run *run, const bat_argument *argument, unsigned kinds)
{
    bool has_points = false;
    for (int i = 0; i < argument->count; i++) {
        const batten_model *model = run->results[argument->items[i].count].value;
        for (int k = 0; k < batten_model_count(model); k++)
            has_points |= is_wanted(batten_model_object(model, k), BAT_POINTS | BAT_OFFSETS);
    }
    return has_points && (kinds & BAT_CURVES)
               ? "; 'interpolate' ('batten fit') makes curves through its points"
               : "";
}

batten_status bat_gather(const bat_run *run, const char *parameter, unsigned kinds,
                         bat_objects *out)
{
    const bat_argument *argument = bat_argument_of(run, parameter);
    int all = 0, count = 0;
    for (int i = 0; i < argument->count; i++)
        all += batten_model_count(run->results[argument->items[i].count].value);
    const batten_object **found = bat_array((size_t)all, sizeof *found);
    if (!found)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < argument->count; i++) {
        const batten_model *model = run->results[argument->items[i].count].value;
        for (int k = 0; k < batten_model_count(model); k++)
            if (is_wanted(batten_model_object(model, k), kinds))
                found[count++] = batten_model_object(model, k);
    }
    if (count > 0) {
        *out = (bat_objects){count, found};
        return BATTEN_OK;
    }
    bat_release(found);
    char names[80];
    name_kinds(kinds, names, sizeof names);
    return bat_fail(BATTEN_BAD_ARGUMENT, "%s are needed, and '%s' has none%s", names,
                    argument->count ? argument->items[0].text : "the input",
                    advice(run, argument, kinds));
}

void bat_objects_release(bat_objects *objects)
{
    bat_release(objects->at);
    *objects = (bat_objects){0, NULL};
}

batten_status bat_one_curve(const bat_run *run, const char *parameter, const batten_curve **out)
{
    bat_objects curves;
    batten_status status = bat_gather(run, parameter, BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    if (curves.count == 1)
        *out = curves.at[0]->curve;
    else
        status =
            bat_fail(BATTEN_BAD_ARGUMENT, "'%s' is one curve, not %d", parameter, curves.count);
    bat_objects_release(&curves);
    return status;
}

batten_status bat_merge(const bat_run *run, const char *parameter, batten_model **out)
{
    bat_objects objects = {0, NULL};
    batten_model *model = NULL;
    batten_status status = bat_gather(run, parameter, BAT_ALL, &objects);
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

batten_status bat_change_all(bat_run *run, const bat_change *change)
{
    const char *input = run->feature->parameters[0].name;
    const unsigned kinds = changed_kinds(change);
    const batten_model *model = bat_model(run, input);
    bat_objects objects;
    batten_status status = bat_gather(run, input, kinds, &objects);
    if (status != BATTEN_OK)
        return status;
    bat_objects_release(&objects);
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++) {
        const batten_object *object = batten_model_object(model, i);
        if (!(kinds & 1u << object->kind))
            status = bat_add(run, object);
        else if (object->kind == BATTEN_OBJECT_CURVE)
            status = change_curve(run, change, object);
        else if (object->kind == BATTEN_OBJECT_TRIANGLES)
            status = change_triangles(run, change, object);
        else
            status = change_surface(run, change, object);
    }
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
