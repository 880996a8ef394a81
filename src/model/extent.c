/* The box of all that a model holds and places. */
#include "numeric/box.h"
#include "model/definitions.h"

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

/* The box of what is in the model itself. */
static batten_box box_of_objects(const batten_model *model)
{
    batten_box all = bat_box_of_nothing();
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        for (int k = 0; k < object->point_count; k++)
            bat_box_join(&all, bat_box_at(&object->points[3 * k]));
        if (object->curve)
            bat_box_join(&all, batten_curve_box(object->curve));
        if (object->surface)
            bat_box_join(&all, batten_surface_box(object->surface));
        if (object->offset_table)
            bat_box_join(&all, batten_offset_table_box(object->offset_table));
        if (object->triangles)
            bat_box_join(&all, batten_triangles_box(object->triangles));
        if (object->body)
            bat_box_join(&all, batten_body_box(object->body));
        if (object->mesh && batten_mesh_view(object->mesh)->vertex_count)
            bat_box_join(&all, batten_mesh_box(object->mesh));
    }
    return all;
}

/* Of definitions, by their numbers. */
typedef struct {
    const bat_definitions *definitions;
    batten_box *boxes; /* [definitions] */
} boxes;

/* Those of what it places are known. */
static batten_status find_box(void *context, int index, const char *name)
{
    const boxes *b = context;
    const batten_model *model = b->definitions->models[index];
    (void)name;
    b->boxes[index] = box_of_objects(model);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->definition)
            join_placed(&b->boxes[index], &object->place,
                        b->boxes[bat_definitions_index(b->definitions, object->definition)]);
    }
    return BATTEN_OK;
}

/* Without memory, one instance after the other: they lie at most 32 deep, and so does the
 * recursion. */
static batten_box box_of_all(const batten_model *model)
{
    batten_box all = box_of_objects(model);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (object->definition)
            join_placed(&all, &object->place, box_of_all(object->definition));
    }
    return all;
}

/* Each definition once, however often it is placed. */
static batten_status box_by_definitions(const batten_model *model, batten_box *all)
{
    bat_definitions definitions = {0};
    boxes b = {.definitions = &definitions};
    batten_status status = bat_definitions_find(model, &definitions);
    if (status == BATTEN_OK) {
        b.boxes = bat_array((size_t)definitions.count, sizeof *b.boxes);
        status =
            b.boxes ? bat_definitions_each(&definitions, find_box, &b) : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        *all = b.boxes[0];
    bat_release(b.boxes);
    bat_definitions_end(&definitions);
    return status;
}

bool batten_model_box(const batten_model *model, batten_box *box)
{
    batten_box all = bat_box_of_nothing();
    if (batten_model_depth(model) == 0 || box_by_definitions(model, &all) != BATTEN_OK)
        all = box_of_all(model);
    if (bat_box_is_of_nothing(all))
        return false;
    *box = all;
    return true;
}
