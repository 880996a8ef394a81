/* Models: named objects with a unit, shared by reference. */
#include "base/base.h"
#include "base/list.h"
#include "model/extent.h"

#include <batten/model.h>
#include <limits.h>
#include <stdint.h>
#include <string.h>

struct batten_model {
    bat_references references;
    char *name; /* NULL for none */
    double unit_metres;
    int depth; /* of instances within instances */
    int count, capacity;
    batten_object *objects; /* each owns its name, layer, arrays and one reference */
    bat_kept_box boxes[2];  /* [bat_model_bounds], of a definition that is placed */
};

enum { DEEPEST = 32 };

const char *batten_object_kind_name(batten_object_kind kind)
{
    static const char *const names[] = {
        "row of points",           "curve", "surface", "table of offsets",
        "set of Bezier triangles", "body",  "mesh",    "instance"};
    return (size_t)kind < sizeof names / sizeof names[0] ? names[kind] : "?";
}

static bool is_unit(double metres)
{
    return isfinite(metres) && metres >= 0;
}

batten_status batten_model_create(double unit_metres, batten_model **out)
{
    if (!is_unit(unit_metres))
        return bat_fail(BATTEN_BAD_ARGUMENT, "a unit of %g metres is not allowed", unit_metres);
    batten_model *model = bat_array(1, sizeof *model);
    if (!model)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&model->references);
    model->unit_metres = unit_metres;
    bat_kept_box_begin(&model->boxes[BAT_EXACT_BODIES]);
    bat_kept_box_begin(&model->boxes[BAT_WIDE_BODIES]);
    *out = model;
    return BATTEN_OK;
}

/* Casts away the const under which an object shows what it owns. */
static void release_objects(const void *memory)
{
    bat_release((void *)(uintptr_t)memory);
}

static void object_free(const batten_object *object)
{
    release_objects(object->name);
    release_objects(object->layer);
    release_objects(object->group);
    release_objects(object->points);
    release_objects(object->parameters);
    batten_curve_unref((batten_curve *)(uintptr_t)object->curve);
    batten_chain_unref((batten_chain *)(uintptr_t)object->chain);
    batten_surface_unref((batten_surface *)(uintptr_t)object->surface);
    batten_offset_table_unref((batten_offset_table *)(uintptr_t)object->offset_table);
    batten_triangles_unref((batten_triangles *)(uintptr_t)object->triangles);
    batten_body_unref((batten_body *)(uintptr_t)object->body);
    batten_mesh_unref((batten_mesh *)(uintptr_t)object->mesh);
    batten_model_unref((batten_model *)(uintptr_t)object->definition);
}

batten_model *batten_model_ref(const batten_model *model)
{
    batten_model *counted = (batten_model *)(uintptr_t)model;
    bat_references_add(&counted->references);
    return counted;
}

void batten_model_unref(batten_model *model)
{
    if (!model || !bat_references_drop(&model->references))
        return;
    for (int i = 0; i < model->count; i++)
        object_free(&model->objects[i]);
    bat_release(model->objects);
    bat_release(model->name);
    bat_release(model);
}

/* ---- properties ---- */

const char *batten_model_name(const batten_model *model)
{
    return model->name ? model->name : "";
}

double batten_model_unit_metres(const batten_model *model)
{
    return model->unit_metres;
}

int batten_model_count(const batten_model *model)
{
    return model->count;
}

int batten_model_depth(const batten_model *model)
{
    return model->depth;
}

bat_kept_box *bat_model_kept_box(const batten_model *model, bat_model_bounds bounds)
{
    return &((batten_model *)(uintptr_t)model)->boxes[bounds];
}

const batten_object *batten_model_object(const batten_model *model, int index)
{
    assert(index >= 0 && index < model->count);
    return &model->objects[index];
}

int batten_model_find(const batten_model *model, const char *name)
{
    for (int i = 0; i < model->count; i++)
        if (strcmp(model->objects[i].name, name) == 0)
            return i;
    return -1;
}

/* ---- adding ---- */

static batten_status check_object(const batten_object *object)
{
    assert((object->kind == BATTEN_OBJECT_CURVE) == (object->curve != NULL));
    assert(object->kind == BATTEN_OBJECT_CURVE || !object->chain);
    assert((object->kind == BATTEN_OBJECT_SURFACE) == (object->surface != NULL));
    assert((object->kind == BATTEN_OBJECT_OFFSET_TABLE) == (object->offset_table != NULL));
    assert((object->kind == BATTEN_OBJECT_TRIANGLES) == (object->triangles != NULL));
    assert((object->kind == BATTEN_OBJECT_BODY) == (object->body != NULL));
    assert((object->kind == BATTEN_OBJECT_MESH) == (object->mesh != NULL));
    assert((object->kind == BATTEN_OBJECT_INSTANCE) == (object->definition != NULL));
    assert(object->point_count >= 0 && (object->points || !object->point_count));

    if (object->triangles && batten_triangles_dimension(object->triangles) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "triangles of dimension %d cannot be stored in a model; those in space "
                        "can, such as the graph of a function",
                        batten_triangles_dimension(object->triangles));
    for (int k = 0; object->has_colour && k < 3; k++)
        if (!(object->colour[k] >= 0 && object->colour[k] <= 1))
            return bat_fail(BATTEN_BAD_ARGUMENT, "colour part %d is %g, not in 0..1", k + 1,
                            object->colour[k]);
    const size_t count = (size_t)object->point_count;
    const size_t bad = count ? bat_first_not_finite(object->points, 3 * count) : 0;
    if (bad < 3 * count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of point %zu is not finite",
                        bad % 3 + 1, bad / 3 + 1);
    if (object->parameters && bat_first_not_finite(object->parameters, count) < count)
        return bat_fail(BATTEN_NOT_FINITE, "parameter %zu is not finite",
                        bat_first_not_finite(object->parameters, count) + 1);
    return BATTEN_OK;
}

/* Instances must be of another model in the same unit, not too deep, and placed by numbers. */
static batten_status check_instance(const batten_model *model, const batten_object *object)
{
    const batten_model *definition = object->definition;
    if (!definition)
        return BATTEN_OK;
    if (definition == model || definition->unit_metres != model->unit_metres)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "instance '%.60s' is of the model itself, or of one in another unit",
                        object->name);
    if (definition->depth >= DEEPEST)
        return bat_fail(BATTEN_TOO_LARGE, "instance '%.60s' lies more than %d deep",
                        object->name, DEEPEST);
    if (bat_first_not_finite(&object->place.m[0][0], 9) < 9 ||
        bat_first_not_finite(object->place.t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the place of instance '%.60s' is not finite",
                        object->name);
    return BATTEN_OK;
}

static batten_status reserve(batten_model *model)
{
    if (model->count < model->capacity)
        return BATTEN_OK;
    if (model->count > INT_MAX / 2)
        return bat_fail(BATTEN_TOO_LARGE, "a model holds at most %d objects", INT_MAX / 2);
    return BAT_LIST_GROW(model->objects, model->count, model->capacity, 1);
}

/* A copy of `count` items; also of none. NULL when memory is exhausted. */
static void *copy_items(const void *items, size_t count, size_t size)
{
    void *copied = bat_array(count, size);
    if (copied && count)
        memcpy(copied, items, count * size);
    return copied;
}

static void *copy_text(const char *text)
{
    return text ? copy_items(text, strlen(text) + 1, 1) : bat_array(1, 1);
}

batten_status batten_model_set_name(batten_model *model, const char *name)
{
    char *copied = NULL;
    if (name && *name) {
        copied = copy_text(name);
        if (!copied)
            return BATTEN_OUT_OF_MEMORY;
    }
    bat_release(model->name);
    model->name = copied;
    return BATTEN_OK;
}

batten_status batten_model_add(batten_model *model, const batten_object *object)
{
    batten_status status = check_object(object);
    if (status == BATTEN_OK)
        status = check_instance(model, object);
    if (status == BATTEN_OK)
        status = reserve(model);
    if (status != BATTEN_OK)
        return status;

    batten_object copied = *object;
    const size_t count = (size_t)object->point_count;
    copied.name = copy_text(object->name);
    copied.layer = copy_text(object->layer);
    copied.group = copy_text(object->group);
    copied.points =
        count ? copy_items(object->points, 3 * count, sizeof *object->points) : NULL;
    copied.parameters = object->parameters && count
                            ? copy_items(object->parameters, count, sizeof *object->parameters)
                            : NULL;
    copied.curve = object->curve ? batten_curve_ref(object->curve) : NULL;
    copied.chain = object->chain ? batten_chain_ref(object->chain) : NULL;
    copied.surface = object->surface ? batten_surface_ref(object->surface) : NULL;
    copied.offset_table =
        object->offset_table ? batten_offset_table_ref(object->offset_table) : NULL;
    copied.triangles = object->triangles ? batten_triangles_ref(object->triangles) : NULL;
    copied.body = object->body ? batten_body_ref(object->body) : NULL;
    copied.mesh = object->mesh ? batten_mesh_ref(object->mesh) : NULL;
    copied.definition = object->definition ? batten_model_ref(object->definition) : NULL;
    if (!copied.name || !copied.layer || !copied.group || (count && !copied.points) ||
        (object->parameters && count && !copied.parameters)) {
        object_free(&copied);
        return BATTEN_OUT_OF_MEMORY;
    }
    model->objects[model->count++] = copied;
    bat_kept_box_begin(&model->boxes[BAT_EXACT_BODIES]); /* kept before it was whole */
    bat_kept_box_begin(&model->boxes[BAT_WIDE_BODIES]);
    if (object->definition)
        model->depth = bat_max_int(model->depth, object->definition->depth + 1);
    return BATTEN_OK;
}
