/* The box of all that a model holds and places. */
#include "model/extent.h"
#include "body/measure/box.h"
#include "numeric/box.h"

/* The box of a box that is mapped. */
static batten_box place_box(const batten_affine *place, batten_box box)
{
    batten_box whole = bat_box_of_nothing();
    for (int k = 0; k < 8; k++) {
        const batten_vec3 corner = {k & 1 ? box.high.x : box.low.x,
                                    k & 2 ? box.high.y : box.low.y,
                                    k & 4 ? box.high.z : box.low.z};
        const batten_vec3 at = batten_affine_apply(*place, corner);
        bat_box_join(&whole, (batten_box){at, at});
    }
    return whole;
}

/* Join the box of what an instance places, if there is anything in it. */
static void join_placed(batten_box *all, const batten_affine *place, batten_box placed)
{
    if (!bat_box_is_of_nothing(placed))
        bat_box_join(all, place_box(place, placed));
}

/* The box of what is in an object; instances are left to join_definition. */
static batten_status join_object(const batten_object *object, bat_model_bounds bounds,
                                 batten_box *all)
{
    for (int k = 0; k < object->point_count; k++)
        bat_box_join(all, bat_box_at(&object->points[3 * k]));
    if (object->curve)
        bat_box_join(all, batten_curve_box(object->curve));
    if (object->surface)
        bat_box_join(all, batten_surface_box(object->surface));
    if (object->offset_table)
        bat_box_join(all, batten_offset_table_box(object->offset_table));
    if (object->triangles)
        bat_box_join(all, batten_triangles_box(object->triangles));
    if (object->mesh && batten_mesh_view(object->mesh)->vertex_count)
        bat_box_join(all, batten_mesh_box(object->mesh));
    if (!object->body)
        return BATTEN_OK;
    batten_box box = bat_box_of_nothing();
    batten_status status = BATTEN_OK;
    if (bounds == BAT_WIDE_BODIES)
        box = bat_body_wide_box(object->body);
    else
        status = bat_body_find_box(object->body, &box);
    bat_box_join(all, box);
    return status;
}

static batten_status find_box(const batten_model *model, bat_model_bounds bounds,
                              batten_box *out);

/* Each definition keeps its box, so that the work is linear however often it is placed. */
static batten_status join_definition(const batten_object *instance, bat_model_bounds bounds,
                                     batten_box *all)
{
    bat_kept_box *kept = bat_model_kept_box(instance->definition, bounds);
    batten_box placed;
    batten_status status = BATTEN_OK;
    if (!bat_kept_box_get(kept, &placed)) {
        status = find_box(instance->definition, bounds, &placed);
        if (status == BATTEN_OK)
            bat_kept_box_put(kept, placed);
    }
    if (status == BATTEN_OK)
        join_placed(all, &instance->place, placed);
    return status;
}

/* As deep as instances lie within instances: 32 at most. */
static batten_status find_box(const batten_model *model, bat_model_bounds bounds,
                              batten_box *out)
{
    batten_box all = bat_box_of_nothing();
    batten_status status = BATTEN_OK;
    const int count = batten_model_count(model);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        status = join_object(batten_model_object(model, i), bounds, &all);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        if (batten_model_object(model, i)->definition) {
            const batten_object *instance = batten_model_object(model, i);
            assert(batten_model_depth(instance->definition) < batten_model_depth(model));
            status = join_definition(instance, bounds, &all);
        }
    if (status == BATTEN_OK)
        *out = all;
    return status;
}

bool batten_model_box(const batten_model *model, batten_box *box)
{
    batten_box all = bat_box_of_nothing();
    if (find_box(model, BAT_EXACT_BODIES, &all) != BATTEN_OK)
        find_box(model, BAT_WIDE_BODIES, &all); /* needs no memory: cannot fail */
    if (bat_box_is_of_nothing(all))
        return false;
    *box = all;
    return true;
}
