/* A model in which what instances place has the colour of the instance. */
#include "model/inherited_colours.h"
#include "base/list.h"
#include "model/definitions.h"

#include <string.h>

enum { MOST_COLOURS = 256, MOST_COPIED = 1000000 };

/* A definition as it looks in a colour, or as it is. */
typedef struct {
    int definition;
    const double *colour; /* [3], of an instance; NULL: as it is */
    int next;             /* variant of the same definition, or -1 */
    batten_model *made;
} variant;

typedef struct {
    bat_definitions definitions;
    bool *is_bare; /* [definitions] it has shapes that take the colour of an instance */
    int *first;    /* [definitions] the first variant of each, or -1 */
    int *colours;  /* [definitions] how many of them have a colour */
    int *order;    /* [definitions] */
    variant *variants;
    int count, capacity;
    int copied; /* objects of variants with a colour */
    int lost;   /* instances in too many colours */
    const char *first_lost;
} painting;

/* ---- what takes a colour ---- */

static bool has_bare_face(const batten_body *body)
{
    const batten_body_parts *parts = batten_body_view(body);
    for (int i = 0; i < parts->face_count; i++)
        if (!parts->faces[i].has_colour)
            return true;
    return false;
}

static bool is_bare(const painting *p, const batten_object *object)
{
    if (object->has_colour)
        return false;
    if (object->definition)
        return p->is_bare[bat_definitions_index(&p->definitions, object->definition)];
    return object->surface || object->triangles ||
           (object->body && has_bare_face(object->body)) ||
           (object->mesh && !batten_mesh_view(object->mesh)->triangle_colours);
}

static void find_bare(painting *p)
{
    bat_definitions_rising(&p->definitions, p->order);
    for (int i = 0; i < p->definitions.count; i++) {
        const batten_model *model = p->definitions.models[p->order[i]];
        for (int k = 0; k < batten_model_count(model) && !p->is_bare[p->order[i]]; k++)
            p->is_bare[p->order[i]] = is_bare(p, batten_model_object(model, k));
    }
}

/* ---- variants ---- */

static bool same_colour(const double *a, const double *b)
{
    return a && b ? memcmp(a, b, 3 * sizeof *a) == 0 : a == b;
}

static int find_variant(const painting *p, int definition, const double *colour)
{
    int at = p->first[definition];
    while (at >= 0 && !same_colour(p->variants[at].colour, colour))
        at = p->variants[at].next;
    return at;
}

/* What an instance within a variant makes of its definition. */
static const double *colour_of(const painting *p, const variant *in,
                               const batten_object *instance)
{
    const int definition = bat_definitions_index(&p->definitions, instance->definition);
    if (!p->is_bare[definition])
        return NULL;
    return instance->has_colour ? instance->colour : in->colour;
}

static batten_status add_variant(painting *p, int definition, const double *colour)
{
    const batten_status status =
        BAT_LIST_ADD(p->variants, p->count, p->capacity,
                     (variant){definition, colour, p->first[definition], NULL});
    if (status == BATTEN_OK)
        p->first[definition] = p->count - 1;
    return status;
}

static batten_status need_variant(painting *p, const batten_object *instance,
                                  const double *colour)
{
    const int definition = bat_definitions_index(&p->definitions, instance->definition);
    const int objects = batten_model_count(instance->definition);
    if (find_variant(p, definition, colour) >= 0)
        return BATTEN_OK;
    if (colour &&
        (p->colours[definition] == MOST_COLOURS || objects > MOST_COPIED - p->copied)) {
        p->first_lost = p->lost++ ? p->first_lost : instance->name;
        return find_variant(p, definition, NULL) >= 0 ? BATTEN_OK
                                                      : add_variant(p, definition, NULL);
    }
    if (colour) {
        p->colours[definition]++;
        p->copied += objects;
    }
    return add_variant(p, definition, colour);
}

/* From the model on, each variant brings those that it places. */
static batten_status find_variants(painting *p)
{
    batten_status status = add_variant(p, 0, NULL);
    for (int i = 0; status == BATTEN_OK && i < p->count; i++) {
        const variant in = p->variants[i];
        const batten_model *model = p->definitions.models[in.definition];
        for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++) {
            const batten_object *object = batten_model_object(model, k);
            if (object->definition)
                status = need_variant(p, object, colour_of(p, &in, object));
        }
    }
    return status;
}

/* ---- the models ---- */

static batten_status add_object(const painting *p, variant *v, const batten_object *object)
{
    batten_object painted = *object;
    if (object->definition) {
        const int definition = bat_definitions_index(&p->definitions, object->definition);
        int at = find_variant(p, definition, colour_of(p, v, object));
        if (at < 0)
            at = find_variant(p, definition, NULL);
        painted.definition = p->variants[at].made;
    } else if (v->colour && is_bare(p, object)) {
        painted.has_colour = true;
        memcpy(painted.colour, v->colour, sizeof painted.colour);
    }
    return batten_model_add(v->made, &painted);
}

static batten_status make_variant(const painting *p, variant *v)
{
    const batten_model *model = p->definitions.models[v->definition];
    batten_status status = batten_model_create(batten_model_unit_metres(model), &v->made);
    if (status == BATTEN_OK)
        status = batten_model_set_name(v->made, batten_model_name(model));
    for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++)
        status = add_object(p, v, batten_model_object(model, k));
    return status;
}

static batten_status make_variants(painting *p, batten_model **out)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < p->definitions.count; i++)
        for (int at = p->first[p->order[i]]; status == BATTEN_OK && at >= 0;
             at = p->variants[at].next)
            status = make_variant(p, &p->variants[at]);
    if (status == BATTEN_OK)
        *out = batten_model_ref(p->variants[0].made);
    return status;
}

static batten_status begin_painting(painting *p, const batten_model *model)
{
    batten_status status = bat_definitions_find(model, &p->definitions);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)p->definitions.count;
    p->is_bare = bat_array(count, sizeof *p->is_bare);
    p->first = bat_array(count, sizeof *p->first);
    p->colours = bat_array(count, sizeof *p->colours);
    p->order = bat_array(count, sizeof *p->order);
    if (!p->is_bare || !p->first || !p->colours || !p->order)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < count; i++)
        p->first[i] = -1;
    return BATTEN_OK;
}

static void end_painting(painting *p)
{
    for (int i = 0; i < p->count; i++)
        batten_model_unref(p->variants[i].made);
    bat_definitions_end(&p->definitions);
    bat_release(p->is_bare);
    bat_release(p->first);
    bat_release(p->colours);
    bat_release(p->order);
    bat_release(p->variants);
}

batten_status bat_model_painted(const batten_model *model, batten_notes *notes,
                                batten_model **out)
{
    painting p = {.count = 0};
    batten_status status = begin_painting(&p, model);
    if (status == BATTEN_OK) {
        find_bare(&p);
        status = find_variants(&p);
    }
    if (status == BATTEN_OK && p.copied == 0)
        *out = batten_model_ref(model);
    else if (status == BATTEN_OK)
        status = make_variants(&p, out);
    if (status == BATTEN_OK && p.lost)
        batten_notes_add(notes, "", 0, p.first_lost,
                         "instances without their colour: %d; what they place is shown in too "
                         "many others",
                         p.lost);
    end_painting(&p);
    return status;
}
