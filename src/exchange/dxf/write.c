#include "base/plural.h"
#include "exchange/dxf/dxf.h"
#include "exchange/path.h"
#include "exchange/prepare.h"
#include "numeric/vector.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
    bat_dxf dxf;
    const batten_model *model;
    batten_notes *notes;
    int layer_count;
    bat_dxf_layer_row *layers; /* [layer_count], "0" first */
    int *layer_of;             /* [objects] */
    int model_space, entities;
    int named; /* objects on layers of their names */
    bool has_full_colours;
} writing;

/* ---- layers ---- */

static bat_dxf_colour_code colour_of(const batten_object *object)
{
    return object->has_colour ? bat_dxf_code_of_colour(object->colour)
                              : (bat_dxf_colour_code){BAT_DXF_PLAIN, -1};
}

/* By name, so that equal ones stand together, and the first object of a layer first. */
typedef struct {
    bat_dxf_layer_row row;
    int object;
} wanted_layer;

static int compare_layers(const void *a, const void *b)
{
    const wanted_layer *one = a, *other = b;
    const int order = strcmp(one->row.name, other->row.name);
    return order ? order : (one->object > other->object) - (one->object < other->object);
}

/* The layer of an object, else its name: so that machines can tell them apart. */
static void want_layer(const batten_object *object, int index, wanted_layer *wanted)
{
    bat_dxf_layer(object->layer[0] ? object->layer : object->name, wanted->row.name);
    wanted->row.colour = colour_of(object);
    wanted->object = index;
}

static batten_status find_layers(writing *w)
{
    const int n = batten_model_count(w->model);
    wanted_layer *wanted = bat_array((size_t)n, sizeof *wanted);
    w->layers = bat_array((size_t)n + 1, sizeof *w->layers);
    w->layer_of = bat_array((size_t)n, sizeof *w->layer_of);
    if (!wanted || !w->layers || !w->layer_of) {
        bat_release(wanted);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0; i < n; i++) {
        want_layer(batten_model_object(w->model, i), i, &wanted[i]);
        w->has_full_colours |= wanted[i].row.colour.full >= 0;
        w->named += !batten_model_object(w->model, i)->layer[0];
    }
    qsort(wanted, (size_t)n, sizeof *wanted, compare_layers);
    w->layers[w->layer_count++] = (bat_dxf_layer_row){"0", {BAT_DXF_PLAIN, -1}};
    for (int i = 0; i < n; i++) {
        const bool is_zero = strcmp(wanted[i].row.name, "0") == 0;
        if (!is_zero && strcmp(wanted[i].row.name, w->layers[w->layer_count - 1].name) != 0)
            w->layers[w->layer_count++] = wanted[i].row;
        w->layer_of[wanted[i].object] = is_zero ? 0 : w->layer_count - 1;
    }
    bat_release(wanted);
    return BATTEN_OK;
}

/* ---- entities ---- */

static void begin_entity(writing *w, int index, const char *kind, const char *subclass)
{
    const batten_object *object = batten_model_object(w->model, index);
    const bat_dxf_layer_row *layer = &w->layers[w->layer_of[index]];
    const bat_dxf_colour_code colour = colour_of(object);
    bat_dxf_text(&w->dxf, 0, kind);
    bat_dxf_handle(&w->dxf, w->model_space);
    bat_dxf_text(&w->dxf, 100, "AcDbEntity");
    bat_dxf_text(&w->dxf, 8, layer->name);
    if (object->is_hidden)
        bat_dxf_integer(&w->dxf, 60, 1);
    if (colour.index != layer->colour.index || colour.full != layer->colour.full)
        bat_dxf_put_colour(&w->dxf, colour);
    bat_dxf_text(&w->dxf, 100, subclass);
    w->entities++;
}

static void put_path(writing *w, int index, const bat_path *path)
{
    const batten_frame *f = &path->frame;
    const batten_frame axes = bat_dxf_axes(f->z);
    const batten_vec3 ay = bat_vec3_cross(axes.z, axes.x);
    const batten_vec3 fy = bat_vec3_cross(f->z, f->x);
    begin_entity(w, index, "LWPOLYLINE", "AcDbPolyline");
    bat_dxf_integer(&w->dxf, 90, path->count);
    bat_dxf_integer(&w->dxf, 70, path->closed ? 1 : 0);
    bat_dxf_real(&w->dxf, 38, bat_vec3_dot(f->origin, axes.z));
    for (int i = 0; i < path->count; i++) {
        const bat_vertex *v = &path->vertices[i];
        const batten_vec3 p = bat_vec3_along(bat_vec3_along(f->origin, v->x, f->x), v->y, fy);
        bat_dxf_real(&w->dxf, 10, bat_vec3_dot(p, axes.x));
        bat_dxf_real(&w->dxf, 20, bat_vec3_dot(p, ay));
        if (v->bulge != 0)
            bat_dxf_real(&w->dxf, 42, v->bulge);
    }
    const double normal[3] = {axes.z.x, axes.z.y, axes.z.z};
    if (!(normal[0] == 0 && normal[1] == 0 && normal[2] == 1))
        bat_dxf_point(&w->dxf, 210, normal);
}

/* Group 70: 1 closed, 4 rational. */
static void put_spline(writing *w, int index, const batten_curve *curve)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *weights = batten_curve_weights(curve), *knots = batten_curve_knots(curve);
    begin_entity(w, index, "SPLINE", "AcDbSpline");
    bat_dxf_integer(&w->dxf, 70,
                    (batten_curve_is_closed(curve, 0) ? 1 : 0) + (weights ? 4 : 0));
    bat_dxf_integer(&w->dxf, 71, p);
    bat_dxf_integer(&w->dxf, 72, n + p + 1);
    bat_dxf_integer(&w->dxf, 73, n);
    bat_dxf_integer(&w->dxf, 74, 0);
    for (int i = 0; i < n + p + 1; i++)
        bat_dxf_real(&w->dxf, 40, knots[i]);
    for (int i = 0; i < n && weights; i++)
        bat_dxf_real(&w->dxf, 41, weights[i]);
    for (int i = 0; i < n; i++)
        bat_dxf_point(&w->dxf, 10, batten_curve_points(curve) + 3 * i);
}

static batten_status put_curve(writing *w, int index, const batten_object *object)
{
    bool is_path = false;
    bat_path path = {0};
    batten_curve *space = NULL;
    const batten_box box = batten_curve_box(object->curve);
    if (box.high.x == box.low.x && box.high.y == box.low.y && box.high.z == box.low.z) {
        batten_notes_add(w->notes, "", 0, object->name, "left out: this curve has no length");
        return BATTEN_OK;
    }
    batten_status status = bat_path_of(object, &is_path, &path);
    if (status == BATTEN_OK && is_path && path.count >= 2)
        put_path(w, index, &path);
    else if (status == BATTEN_OK && (status = bat_prepare_curve(object, &space)) == BATTEN_OK)
        put_spline(w, index, space);
    bat_path_release(&path);
    batten_curve_unref(space);
    return status;
}

static batten_status put_object(writing *w, int index)
{
    const batten_object *object = batten_model_object(w->model, index);
    if (object->kind == BATTEN_OBJECT_CURVE)
        return put_curve(w, index, object);
    for (int i = 0; i < object->point_count; i++) {
        begin_entity(w, index, "POINT", "AcDbPoint");
        bat_dxf_point(&w->dxf, 10, object->points + 3 * i);
    }
    return BATTEN_OK;
}

/* ---- the whole ---- */

/* More handles than the file can need. */
static batten_status count_handles(const batten_model *model, int *handles)
{
    double sum = 64;
    for (int i = 0; i < batten_model_count(model); i++)
        sum += 2 + batten_model_object(model, i)->point_count;
    if (sum > 1e9)
        return bat_fail(BATTEN_TOO_LARGE, "a DXF file of %.0f entities", sum);
    *handles = (int)sum;
    return BATTEN_OK;
}

static batten_status write_all(writing *w)
{
    int handles = 0;
    batten_status status = count_handles(w->model, &handles);
    if (status == BATTEN_OK)
        status = find_layers(w);
    if (status != BATTEN_OK)
        return status;
    bat_dxf_begin(&w->dxf, batten_model_unit_metres(w->model), w->has_full_colours,
                  w->layer_count, w->layers, handles, &w->model_space);
    bat_dxf_text(&w->dxf, 0, "SECTION");
    bat_dxf_text(&w->dxf, 2, "ENTITIES");
    for (int i = 0; i < batten_model_count(w->model) && status == BATTEN_OK; i++)
        status = put_object(w, i);
    bat_dxf_text(&w->dxf, 0, "ENDSEC");
    bat_dxf_end(&w->dxf);
    if (w->named)
        batten_notes_remark(
            w->notes, "", 0, "",
            "DXF files hold no names: %d object%s without a layer %s on a layer "
            "of that name",
            w->named, bat_plural(w->named), bat_one_or_many(w->named, "is", "are"));
    if (status == BATTEN_OK && w->entities == 0 && batten_model_count(w->model) > 0)
        status = bat_fail(BATTEN_UNSUPPORTED,
                          "DXF files hold points and curves, and there are none");
    return status;
}

batten_status bat_write_dxf(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    (void)options;
    writing w = {.dxf = {.text = BATTEN_TEXT}, .model = model, .notes = notes};
    const batten_status status = write_all(&w);
    bat_release(w.layers);
    bat_release(w.layer_of);
    if (status == BATTEN_OK)
        *text = w.dxf.text;
    else
        batten_text_free(&w.dxf.text);
    return status;
}
