/* What is placed often: subfigures and their instances. */
#include "exchange/iges/write/writing.h"
#include "model/rebuild.h"

#include <string.h>

/* x' = scale R x + t with rows of R that are orthonormal; scale R gives back the bits. */
typedef struct {
    double scale, rotation[3][3];
    bool is_turned;
} similarity;

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool find_similarity(const batten_affine *place, similarity *out)
{
    out->scale = sqrt(dot(place->m[0], place->m[0]));
    out->is_turned = false;
    if (!(out->scale > 0 && isfinite(out->scale)))
        return false;
    /* A product of a hundred thousand rotations stays within this of one. */
    if (fabs(out->scale - 1) < 1e-10)
        out->scale = 1; /* rotations are so only to rounding */
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            out->rotation[i][k] = place->m[i][k] / out->scale;
            out->is_turned |= out->rotation[i][k] != (i == k);
            if (out->scale * out->rotation[i][k] != place->m[i][k])
                return false;
        }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k <= i; k++)
            /* As near as the scale above. */
            if (!(fabs(dot(out->rotation[i], out->rotation[k]) - (i == k)) <= 1e-10))
                return false;
    return true;
}

bool bat_iges_can_place(const batten_affine *place)
{
    similarity s;
    return find_similarity(place, &s);
}

static void put_rows(bat_iges_writing *w, const double m[3][3], const double t[3])
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            bat_iges_put_real(&w->data, m[i][k], ',');
        bat_iges_put_real(&w->data, t[i], i < 2 ? ',' : ';');
    }
}

/* 124: the rows of the matrix, each with its shift. Form 1 is for mirrors. */
static int put_matrix(bat_iges_writing *w, const double m[3][3], const double t[3])
{
    const double turned[3] = {m[1][1] * m[2][2] - m[1][2] * m[2][1],
                              m[1][2] * m[2][0] - m[1][0] * m[2][2],
                              m[1][0] * m[2][1] - m[1][1] * m[2][0]};
    const int id = bat_iges_begin_entity(w, 124);
    put_rows(w, m, t);
    bat_iges_end_entity(
        w, &(bat_iges_look){.type = 124, .form = dot(m[0], turned) < 0, .is_part = true});
    return id;
}

int bat_iges_put_subfigure(bat_iges_writing *w, const char *name, int depth,
                           const bat_members *items)
{
    const int id = bat_iges_begin_entity(w, 308);
    bat_iges_put_integer(&w->data, depth, ',');
    bat_iges_put_string(&w->data, name[0] ? name : "part", ',');
    bat_iges_put_integer(&w->data, items->count, ',');
    for (int i = 0; i < items->count; i++)
        bat_iges_put_integer(&w->data, items->members[i].item,
                             i + 1 < items->count ? ',' : ';');
    bat_iges_end_entity(w, &(bat_iges_look){.type = 308, .use = 2});
    return id;
}

int bat_iges_put_instance(bat_iges_writing *w, int subfigure, const batten_affine *place,
                          int name, bat_iges_look look)
{
    const double nowhere[3] = {0, 0, 0};
    similarity s;
    find_similarity(place, &s);
    if (s.is_turned)
        look.matrix = put_matrix(w, (const double(*)[3])s.rotation, place->t);
    const double *t = s.is_turned ? nowhere : place->t;
    const int id = bat_iges_begin_entity(w, 408);
    bat_iges_put_integer(&w->data, subfigure, ',');
    for (int k = 0; k < 3; k++)
        bat_iges_put_real(&w->data, t[k], ',');
    bat_iges_put_real(&w->data, s.scale, ',');
    bat_iges_put_properties(w, name);
    look.type = 408;
    bat_iges_end_entity(w, &look);
    return id;
}

/* ---- parts ---- */

typedef struct {
    const batten_model *whole;
    batten_notes *notes;
    bool has_solids;
} parting;

/* The body as what is placed once, as it lies. */
static batten_status add_as_part(batten_model *made, const batten_object *object)
{
    batten_object body = *object, instance = *object;
    batten_model *part = NULL;
    body.group = "";
    batten_status status = batten_model_create(batten_model_unit_metres(made), &part);
    if (status == BATTEN_OK)
        status = batten_model_add(part, &body);
    instance.kind = BATTEN_OBJECT_INSTANCE;
    instance.body = NULL;
    instance.definition = part;
    instance.place = batten_affine_identity();
    if (status == BATTEN_OK)
        status = batten_model_add(made, &instance);
    batten_model_unref(part);
    return status;
}

static batten_status add_part(void *context, const batten_model *from, int index,
                              batten_model *made, const batten_object *object)
{
    (void)index;
    const parting *p = context;
    const bool is_among_others = from != p->whole && batten_model_count(from) > 1;
    if (object->kind == BATTEN_OBJECT_POINTS && object->point_count == 0)
        return BATTEN_OK;
    if (object->kind == BATTEN_OBJECT_INSTANCE && batten_model_count(object->definition) == 0) {
        batten_notes_add(p->notes, "", 0, object->name,
                         "left out, as this instance places nothing");
        return BATTEN_OK;
    }
    return object->kind == BATTEN_OBJECT_BODY && is_among_others && !p->has_solids &&
                   batten_body_view(object->body)->face_count > 1
               ? add_as_part(made, object)
               : batten_model_add(made, object);
}

batten_status bat_iges_make_parts(const batten_model *model, bool has_solids,
                                  batten_notes *notes, batten_model **out)
{
    parting p = {model, notes, has_solids};
    return bat_model_change(model, batten_model_unit_metres(model), 1, add_part, &p, out);
}
