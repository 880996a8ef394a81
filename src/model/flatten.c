/* Instances replaced by what they place. */
#include "base/base.h"
#include "model/placed_counts.h"

#include <batten/model.h>
#include <batten/text.h>
#include <string.h>

enum { DEEPEST = 32 };

/* As much as 40 times what the model holds, as with files, and what is little all the same. */
static const double times = 40, few_objects = 1e5, few_points = 1e7, most_objects = 1e6;

/* A model on the way down, where it stands, and what its objects are named after. */
typedef struct {
    const batten_model *model;
    batten_affine place;
    int next;
    size_t name_length; /* of the path so far */
    batten_object look; /* what instances give to objects without a layer and colour of their
                           own; hidden when any of them is */
} level;

typedef struct {
    level *levels; /* [DEEPEST + 1] */
    int depth;     /* of the level at work */
    batten_text path;
    batten_model *made;
} flattening;

/* Path and name: "arm/bolt". */
static void set_name(flattening *f, const char *name)
{
    f->path.length = f->levels[f->depth].name_length;
    batten_text_add(&f->path, "%s%s", f->path.length ? "/" : "", name);
}

/* The object with what the instances around it say of its looks. */
static batten_object dressed(const batten_object *object, const batten_object *look)
{
    batten_object made = *object;
    made.is_hidden |= look->is_hidden;
    if (!object->has_colour && look->has_colour) {
        made.has_colour = true;
        memcpy(made.colour, look->colour, sizeof made.colour);
    }
    if (!*object->layer && look->layer)
        made.layer = look->layer;
    return made;
}

static batten_status add_object(flattening *f, const batten_object *object)
{
    batten_object named = dressed(object, &f->levels[f->depth].look);
    if (f->path.failed)
        return BATTEN_OUT_OF_MEMORY;
    named.name = f->path.bytes ? f->path.bytes : "";
    if (f->depth == 0)
        return batten_model_add(f->made, &named);
    return batten_model_add_mapped(f->made, &named, &f->levels[f->depth].place);
}

static batten_status add_all(flattening *f)
{
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && f->depth >= 0) {
        level *at = &f->levels[f->depth];
        if (at->next == batten_model_count(at->model)) {
            f->depth--;
            continue;
        }
        const batten_object *object = batten_model_object(at->model, at->next++);
        set_name(f, object->name);
        if (object->kind != BATTEN_OBJECT_INSTANCE) {
            status = add_object(f, object);
            continue;
        }
        assert(f->depth < DEEPEST);
        f->levels[++f->depth] =
            (level){.model = object->definition,
                    .place = batten_affine_compose(object->place, at->place),
                    .name_length = f->path.length,
                    .look = dressed(object, &at->look)};
    }
    return status;
}

/* Before the work. */
static batten_status check_size(const batten_model *model)
{
    bat_placed own, all;
    const batten_status status = bat_count_placed(model, &own, &all);
    if (status != BATTEN_OK)
        return status;
    const double objects = bat_min(few_objects + times * own.objects, most_objects);
    const double points = few_points + times * own.points;
    if (all.objects > objects)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f objects hold instances which place %.0f objects and instances; "
                        "the limit is %.0f",
                        own.objects, all.objects, objects);
    if (all.points > points)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f points are in instances which place %.0f points; the limit is "
                        "%.0f",
                        own.points, all.points, points);
    return BATTEN_OK;
}

batten_status batten_model_flat(const batten_model *model, batten_model **out)
{
    if (batten_model_depth(model) == 0) {
        *out = batten_model_ref(model);
        return BATTEN_OK;
    }
    batten_status status = check_size(model);
    if (status != BATTEN_OK)
        return status;
    flattening f = {.levels = bat_array(DEEPEST + 1, sizeof(level)), .path = BATTEN_TEXT};
    if (!f.levels)
        return BATTEN_OUT_OF_MEMORY;
    f.levels[0] = (level){.model = model, .place = batten_affine_identity()};
    status = batten_model_create(batten_model_unit_metres(model), &f.made);
    if (status == BATTEN_OK)
        status = batten_model_set_name(f.made, batten_model_name(model));
    if (status == BATTEN_OK)
        status = add_all(&f);
    batten_text_free(&f.path);
    bat_release(f.levels);
    if (status == BATTEN_OK)
        *out = f.made;
    else
        batten_model_unref(f.made);
    return status;
}
