/* How many objects the instances of a model place in all, without placing them. */
#include "model/placed_counts.h"
#include "model/definitions.h"

#include <batten/text.h>

static double points_of(const batten_surface *surface)
{
    return (double)batten_surface_point_count(surface, BATTEN_U) *
           (double)batten_surface_point_count(surface, BATTEN_V);
}

static double points_in(const batten_object *object)
{
    const batten_body_parts *body = object->body ? batten_body_view(object->body) : NULL;
    double count = object->point_count;
    if (object->curve)
        count += batten_curve_point_count(object->curve);
    if (object->surface)
        count += points_of(object->surface);
    if (object->triangles) {
        const double p = batten_triangles_degree(object->triangles);
        count += (p + 1) * (p + 2) / 2 * batten_triangles_count(object->triangles);
    }
    if (object->mesh)
        count += batten_mesh_view(object->mesh)->vertex_count;
    for (int i = 0; body && i < body->face_count; i++)
        count += points_of(body->faces[i].surface);
    for (int i = 0; body && i < body->edge_count; i++)
        count += body->edges[i].curve ? batten_curve_point_count(body->edges[i].curve) : 0;
    return count;
}

typedef struct {
    const bat_definitions *definitions;
    bat_placed own, *placed; /* placed: [definitions] */
} counting;

/* Those that it places are known. */
static batten_status count_objects(void *context, int index, const char *name)
{
    counting *c = context;
    const batten_model *model = c->definitions->models[index];
    bat_placed *all = &c->placed[index];
    (void)name;
    for (int i = 0; i < batten_model_count(model); i++) {
        const batten_object *object = batten_model_object(model, i);
        const double points = points_in(object);
        c->own.objects += 1;
        c->own.points += points;
        all->objects += 1;
        all->points += points;
        if (object->definition) {
            const int of = bat_definitions_index(c->definitions, object->definition);
            all->objects += c->placed[of].objects;
            all->points += c->placed[of].points;
        }
    }
    return BATTEN_OK;
}

batten_status bat_count_placed(const batten_model *model, bat_placed *own, bat_placed *placed)
{
    bat_definitions definitions = {0};
    counting c = {.definitions = &definitions};
    batten_status status = bat_definitions_find(model, &definitions);
    if (status == BATTEN_OK) {
        c.placed = bat_array((size_t)definitions.count, sizeof *c.placed);
        status = c.placed ? bat_definitions_each(&definitions, count_objects, &c)
                          : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        *own = c.own;
        *placed = c.placed[0];
    }
    bat_release(c.placed);
    bat_definitions_end(&definitions);
    return status;
}

/* ---- once ---- */

/* "block/object": the objects of one definition, its instances not. */
static batten_status add_once(batten_model *made, const batten_model *from, const char *name,
                              batten_text *path)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(from); i++) {
        batten_object object = *batten_model_object(from, i);
        if (object.definition)
            continue;
        path->length = 0;
        batten_text_add(path, "%s%s%s", name, *name ? "/" : "", object.name);
        object.name = path->bytes;
        status = path->failed ? BATTEN_OUT_OF_MEMORY : batten_model_add(made, &object);
    }
    return status;
}

batten_status batten_model_once(const batten_model *model, batten_model **out)
{
    bat_definitions definitions = {0};
    batten_model *made = NULL;
    batten_text path = BATTEN_TEXT;
    batten_status status = bat_definitions_find(model, &definitions);
    const char **names = NULL;
    if (status == BATTEN_OK) {
        names = bat_array((size_t)definitions.count, sizeof *names);
        status = names ? batten_model_create(batten_model_unit_metres(model), &made)
                       : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        bat_definitions_names(&definitions, names);
    for (int i = 0; status == BATTEN_OK && i < definitions.count; i++)
        status = add_once(made, definitions.models[i], i ? names[i] : "", &path);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_model_unref(made);
    batten_text_free(&path);
    bat_release(names);
    bat_definitions_end(&definitions);
    return status;
}
