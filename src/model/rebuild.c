/* A model made anew from changed objects, the models that it places among them. */
#include "model/rebuild.h"
#include "model/definitions.h"

typedef struct {
    double unit_metres, scale;
    bat_object_change *change;
    void *context;
    bat_definitions definitions;
    int *order;          /* [definitions] */
    batten_model **made; /* [definitions] */
} changing;

static batten_status change_object(changing *c, const batten_model *from, int index,
                                   batten_model *made)
{
    const batten_object *object = batten_model_object(from, index);
    if (object->kind != BATTEN_OBJECT_INSTANCE)
        return c->change(c->context, from, index, made, object);
    batten_object placed = *object;
    placed.definition = c->made[bat_definitions_index(&c->definitions, object->definition)];
    for (int k = 0; k < 3; k++)
        placed.place.t[k] *= c->scale;
    return c->change(c->context, from, index, made, &placed);
}

static batten_status change_definition(changing *c, int index)
{
    const batten_model *model = c->definitions.models[index];
    batten_status status = batten_model_create(c->unit_metres, &c->made[index]);
    if (status == BATTEN_OK)
        status = batten_model_set_name(c->made[index], batten_model_name(model));
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = change_object(c, model, i, c->made[index]);
    return status;
}

static batten_status change_all(changing *c, const batten_model *model)
{
    batten_status status = bat_definitions_find(model, &c->definitions);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)c->definitions.count;
    c->order = bat_array(count, sizeof *c->order);
    c->made = bat_array(count, sizeof *c->made);
    if (!c->order || !c->made)
        return BATTEN_OUT_OF_MEMORY;
    bat_definitions_rising(&c->definitions, c->order);
    for (size_t i = 0; status == BATTEN_OK && i < count; i++)
        status = change_definition(c, c->order[i]);
    return status;
}

batten_status bat_model_change(const batten_model *model, double unit_metres, double scale,
                               bat_object_change *change, void *context, batten_model **out)
{
    changing c = {
        .unit_metres = unit_metres, .scale = scale, .change = change, .context = context};
    const batten_status status = change_all(&c, model);
    if (status == BATTEN_OK)
        *out = batten_model_ref(c.made[0]);
    for (int i = 0; c.made && i < c.definitions.count; i++)
        batten_model_unref(c.made[i]);
    bat_release(c.made);
    bat_release(c.order);
    bat_definitions_end(&c.definitions);
    return status;
}
