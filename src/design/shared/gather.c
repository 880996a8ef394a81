/* What a feature takes in: its arguments by name, and the objects of their models; objects that it cannot use are
 * refused or noted. */
#include "base/plural.h"
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

static const batten_model *model_of(const bat_run *run, const bat_argument *argument, int i)
{
    return run->results[argument->items[i].count].value;
}

/* All objects of the kinds, and the first of other kinds. */
static int gather_wanted(const batten_model *model, unsigned kinds, const batten_object **found,
                         const batten_object **foreign)
{
    int count = 0;
    *foreign = NULL;
    for (int k = 0; k < batten_model_count(model); k++) {
        const batten_object *object = batten_model_object(model, k);
        if (is_wanted(object, kinds))
            found[count++] = object;
        else if (!*foreign)
            *foreign = object;
    }
    return count;
}

/* "'nose' is one point" */
static void name_object(const batten_object *object, char *text, size_t size)
{
    static const char *const names[] = {
        "points",    "a curve", "a surface", "a table of offsets",
        "triangles", "a body",  "a mesh",    "an instance"};
    const bool one = object->kind == BATTEN_OBJECT_POINTS && object->point_count == 1;
    snprintf(text, size, "'%s' is %s", object->name, one ? "a point" : names[object->kind]);
}

/* Objects of an input that the feature cannot use: all of them are an error, some a note. */
static batten_status answer_for_foreign(const bat_run *run, const char *parameter,
                                        const bat_item *item, const batten_object *foreign,
                                        int used, int count, unsigned kinds)
{
    char names[80], what[120];
    name_kinds(kinds, names, sizeof names);
    name_object(foreign, what, sizeof what);
    if (used == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'%s' takes %s, and %s", parameter, names, what);
    bat_note(run,
             "'%s' takes %s: %d of the %d objects of '%s' %s not used (%s); 'select' names "
             "those that are meant",
             parameter, names, count - used, count, item->text,
             bat_one_or_many(count - used, "is", "are"), what);
    return BATTEN_OK;
}

/* @param strict  objects of other kinds are refused or noted */
static batten_status gather(const bat_run *run, const char *parameter, unsigned kinds,
                            bool strict, bat_objects *out)
{
    const bat_argument *argument = bat_argument_of(run, parameter);
    int all = 0, count = 0;
    for (int i = 0; i < argument->count; i++)
        all += batten_model_count(model_of(run, argument, i));
    const batten_object **found = bat_array((size_t)all, sizeof *found);
    if (!found)
        return BATTEN_OUT_OF_MEMORY;
    const batten_object *foreign;
    for (int i = 0; i < argument->count; i++)
        count += gather_wanted(model_of(run, argument, i), kinds, found + count, &foreign);
    batten_status status = BATTEN_OK;
    char names[80];
    name_kinds(kinds, names, sizeof names);
    if (count == 0)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "%s are needed, and '%s' has none%s", names,
                          argument->count ? argument->items[0].text : "the input",
                          advice(run, argument, kinds));
    int done = 0;
    for (int i = 0; i < argument->count && strict && status == BATTEN_OK; i++) {
        const batten_model *model = model_of(run, argument, i);
        const int used = gather_wanted(model, kinds, found + done, &foreign);
        done += used;
        if (foreign)
            status = answer_for_foreign(run, parameter, &argument->items[i], foreign, used,
                                        batten_model_count(model), kinds);
    }
    if (status == BATTEN_OK)
        *out = (bat_objects){count, found};
    else
        bat_release(found);
    return status;
}

batten_status bat_gather(const bat_run *run, const char *parameter, unsigned kinds,
                         bat_objects *out)
{
    return gather(run, parameter, kinds, true, out);
}

batten_status bat_for_objects(bat_run *run, const char *parameter, unsigned kinds,
                              bat_object_step *step)
{
    bat_objects objects;
    batten_status status = bat_gather(run, parameter, kinds, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = step(run, objects.at[i]);
    bat_objects_release(&objects);
    return status;
}

batten_status bat_gather_some(const bat_run *run, const char *parameter, unsigned kinds,
                              bat_objects *out)
{
    return gather(run, parameter, kinds, false, out);
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
