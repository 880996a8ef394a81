/* The box of all that a model holds and places. */
#include "exchange/definitions.h"

static void widen(batten_box *box, bool *any, batten_box by)
{
    if (!*any)
        *box = by;
    *any = true;
    box->low.x = bat_min(box->low.x, by.low.x);
    box->low.y = bat_min(box->low.y, by.low.y);
    box->low.z = bat_min(box->low.z, by.low.z);
    box->high.x = bat_max(box->high.x, by.high.x);
    box->high.y = bat_max(box->high.y, by.high.y);
    box->high.z = bat_max(box->high.z, by.high.z);
}

/* The box of a box that is mapped. */
static batten_box place_box(const batten_affine *place, batten_box box)
{
    batten_box whole = box;
    bool any = false;
    for (int k = 0; k < 8; k++) {
        const batten_vec3 corner = {k & 1 ? box.high.x : box.low.x,
                                    k & 2 ? box.high.y : box.low.y,
                                    k & 4 ? box.high.z : box.low.z};
        const batten_vec3 at = batten_affine_apply(*place, corner);
        widen(&whole, &any, (batten_box){at, at});
    }
    return whole;
}

/* The box of what is in the model itself. */
static void widen_by_objects(const batten_model *model, bool *any, batten_box *all)
{
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        for (int k = 0; k < object->point_count; k++) {
            const double *p = &object->points[3 * k];
            const batten_vec3 point = {p[0], p[1], p[2]};
            widen(all, any, (batten_box){point, point});
        }
        if (object->curve)
            widen(all, any, batten_curve_box(object->curve));
        if (object->surface)
            widen(all, any, batten_surface_box(object->surface));
        if (object->offsets)
            widen(all, any, batten_offsets_box(object->offsets));
        if (object->triangles)
            widen(all, any, batten_triangles_box(object->triangles));
        if (object->body)
            widen(all, any, batten_body_box(object->body));
        if (object->mesh && batten_mesh_view(object->mesh)->vertex_count)
            widen(all, any, batten_mesh_box(object->mesh));
    }
}

/* Of definitions, by their numbers. */
typedef struct {
    const bat_definitions *definitions;
    batten_box *boxes; /* [definitions] */
    bool *any;         /* [definitions] is there anything in it? */
} boxes;

/* Those of what it places are known. */
static batten_status find_box(void *context, int index, const char *name)
{
    const boxes *b = context;
    const batten_model *model = b->definitions->models[index];
    (void)name;
    widen_by_objects(model, &b->any[index], &b->boxes[index]);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        if (!object->definition)
            continue;
        const int placed = bat_definitions_index(b->definitions, object->definition);
        if (b->any[placed])
            widen(&b->boxes[index], &b->any[index],
                  place_box(&object->place, b->boxes[placed]));
    }
    return BATTEN_OK;
}

/* Without memory, one instance after the other: they lie at most 32 deep, and so does the
 * recursion. */
static void widen_by_all(const batten_model *model, bool *any, batten_box *all)
{
    widen_by_objects(model, any, all);
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        bool is_something = false;
        batten_box placed;
        if (object->definition)
            widen_by_all(object->definition, &is_something, &placed);
        if (is_something)
            widen(all, any, place_box(&object->place, placed));
    }
}

/* Each definition once, however often it is placed. */
static batten_status widen_by_definitions(const batten_model *model, bool *any, batten_box *all)
{
    bat_definitions definitions = {0};
    boxes b = {.definitions = &definitions};
    batten_status status = bat_definitions_find(model, &definitions);
    if (status == BATTEN_OK) {
        b.boxes = bat_array((size_t)definitions.count, sizeof *b.boxes);
        b.any = bat_array((size_t)definitions.count, sizeof *b.any);
        status = b.boxes && b.any ? bat_definitions_each(&definitions, find_box, &b)
                                  : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        *any = b.any[0];
        *all = b.boxes[0];
    }
    bat_release(b.boxes);
    bat_release(b.any);
    bat_definitions_end(&definitions);
    return status;
}

bool batten_model_box(const batten_model *model, batten_box *box)
{
    bool any = false;
    batten_box all = {{0, 0, 0}, {0, 0, 0}};
    if (batten_model_depth(model) == 0 || widen_by_definitions(model, &any, &all) != BATTEN_OK)
        widen_by_all(model, &any, &all);
    if (any)
        *box = all;
    return any;
}
