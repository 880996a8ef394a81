/* Writes points and curves as DXF entities. */
#include "base/plural.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/round.h"
#include "exchange/shapes/path.h"
#include "exchange/shapes/prepare.h"
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

typedef struct {
    bat_dxf_layer_row row;
    int object;
    bool is_hidden;
} wanted_layer;

/* By name and colour, so that equal ones stand together, and the first object first. */
static int compare_layers(const void *a, const void *b)
{
    const wanted_layer *one = a, *other = b;
    const bat_dxf_colour_code *c = &one->row.colour, *d = &other->row.colour;
    int order = strcmp(one->row.name, other->row.name);
    if (order == 0)
        order = (c->index > d->index) - (c->index < d->index);
    if (order == 0)
        order = (c->full > d->full) - (c->full < d->full);
    return order ? order : (one->object > other->object) - (one->object < other->object);
}

/* The layer of an object, else its name: so that machines can tell them apart. */
static void want_layer(const batten_object *object, int index, wanted_layer *wanted)
{
    bat_dxf_layer(object->layer[0] ? object->layer : object->name, wanted->row.name);
    wanted->row.colour = colour_of(object);
    wanted->object = index;
    wanted->is_hidden = object->is_hidden;
}

/* The layer of all these objects: off when it shows none of them, in the colour of most. */
static bat_dxf_layer_row layer_row(int count, const wanted_layer *wanted)
{
    bat_dxf_layer_row row = wanted[0].row;
    int most = 0, first = 0;
    row.is_off = true;
    for (int i = 0, begin = 0; i < count; i++) {
        const bat_dxf_colour_code *a = &wanted[begin].row.colour, *b = &wanted[i].row.colour;
        begin = a->index == b->index && a->full == b->full ? begin : i;
        const int here = i - begin + 1, by = wanted[begin].object;
        if (here > most || (here == most && by < first)) {
            most = here;
            first = by;
            row.colour = *b;
        }
        row.is_off &= wanted[i].is_hidden;
    }
    return row;
}

/* The number of a layer that is listed now, or of "0", which stands first. */
static int list_layer(writing *w, const bat_dxf_layer_row *row)
{
    if (strcmp(row->name, "0") == 0) {
        w->layers[0].is_off = row->is_off;
        return 0;
    }
    w->layers[w->layer_count] = *row;
    return w->layer_count++;
}

/* Objects of one name stand side by side. */
static void make_layers(writing *w, int n, const wanted_layer *wanted)
{
    for (int i = 0, end = 0; i < n; i = end) {
        while (end < n && strcmp(wanted[end].row.name, wanted[i].row.name) == 0)
            end++;
        const bat_dxf_layer_row row = layer_row(end - i, &wanted[i]);
        const int layer = list_layer(w, &row);
        for (int k = i; k < end; k++)
            w->layer_of[wanted[k].object] = layer;
    }
}

static void want_layers(writing *w, int n, wanted_layer *wanted)
{
    for (int i = 0; i < n; i++) {
        want_layer(batten_model_object(w->model, i), i, &wanted[i]);
        w->has_full_colours |= wanted[i].row.colour.full >= 0;
        w->named += !batten_model_object(w->model, i)->layer[0];
    }
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
    want_layers(w, n, wanted);
    qsort(wanted, (size_t)n, sizeof *wanted, compare_layers);
    w->layers[w->layer_count++] =
        (bat_dxf_layer_row){.name = "0", .colour = {BAT_DXF_PLAIN, -1}};
    make_layers(w, n, wanted);
    bat_release(wanted);
    return BATTEN_OK;
}

/* ---- entities ---- */

/* What every entity has first; a part of a polyline belongs to it. */
static void begin_part(writing *w, int index, int owner, const char *kind)
{
    const batten_object *object = batten_model_object(w->model, index);
    const bat_dxf_layer_row *layer = &w->layers[w->layer_of[index]];
    const bat_dxf_colour_code colour = colour_of(object);
    bat_dxf_text(&w->dxf, 0, kind);
    bat_dxf_handle(&w->dxf, owner);
    bat_dxf_text(&w->dxf, 100, "AcDbEntity");
    bat_dxf_text(&w->dxf, 8, layer->name);
    if (object->is_hidden && !layer->is_off)
        bat_dxf_integer(&w->dxf, 60, 1);
    if (colour.index != layer->colour.index || colour.full != layer->colour.full)
        bat_dxf_put_colour(&w->dxf, colour);
}

static void begin_entity(writing *w, int index, const char *kind, const char *subclass)
{
    begin_part(w, index, w->model_space, kind);
    bat_dxf_text(&w->dxf, 100, subclass);
    w->entities++;
}

/* Nothing stands for the normal that planes have by themselves. */
static void put_normal(writing *w, const double normal[3])
{
    if (!(normal[0] == 0 && normal[1] == 0 && normal[2] == 1))
        bat_dxf_point(&w->dxf, 210, normal);
}

static void put_line(writing *w, int index, const double a[3], const double b[3])
{
    begin_entity(w, index, "LINE", "AcDbLine");
    bat_dxf_point(&w->dxf, 10, a);
    bat_dxf_point(&w->dxf, 11, b);
}

static void put_circle(writing *w, int index, const bat_dxf_round *circle)
{
    begin_entity(w, index, circle->kind == BAT_DXF_ARC ? "ARC" : "CIRCLE", "AcDbCircle");
    bat_dxf_point(&w->dxf, 10, circle->centre);
    bat_dxf_real(&w->dxf, 40, circle->size);
    put_normal(w, circle->normal);
    if (circle->kind != BAT_DXF_ARC)
        return;
    bat_dxf_text(&w->dxf, 100, "AcDbArc");
    bat_dxf_real(&w->dxf, 50, circle->angles[0]);
    bat_dxf_real(&w->dxf, 51, circle->angles[1]);
}

static void put_ellipse(writing *w, int index, const bat_dxf_round *ellipse)
{
    begin_entity(w, index, "ELLIPSE", "AcDbEllipse");
    bat_dxf_point(&w->dxf, 10, ellipse->centre);
    bat_dxf_point(&w->dxf, 11, ellipse->axis);
    put_normal(w, ellipse->normal);
    bat_dxf_real(&w->dxf, 40, ellipse->size);
    bat_dxf_real(&w->dxf, 41, ellipse->angles[0]);
    bat_dxf_real(&w->dxf, 42, ellipse->angles[1]);
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
    put_normal(w, (const double[]){axes.z.x, axes.z.y, axes.z.z});
}

/* A polyline in space; neighbours that are one point are one vertex, and a last vertex that is
 * the first closes it. */
static void put_space(writing *w, int index, const batten_curve *curve)
{
    const double *P = batten_curve_points(curve);
    int n = batten_curve_point_count(curve);
    const bool closed = n > 3 && bat_distance(3, P, P + 3 * (n - 1)) == 0;
    static const double none[3] = {0, 0, 0};
    begin_entity(w, index, "POLYLINE", "AcDb3dPolyline");
    const int polyline = w->dxf.handle;
    bat_dxf_integer(&w->dxf, 66, 1);
    bat_dxf_point(&w->dxf, 10, none);
    bat_dxf_integer(&w->dxf, 70, closed ? 9 : 8);
    n -= closed ? 1 : 0;
    for (int i = 0; i < n; i++) {
        if (i > 0 && bat_distance(3, P + 3 * i, P + 3 * (i - 1)) == 0)
            continue;
        begin_part(w, index, polyline, "VERTEX");
        bat_dxf_text(&w->dxf, 100, "AcDbVertex");
        bat_dxf_text(&w->dxf, 100, "AcDb3dPolylineVertex");
        bat_dxf_point(&w->dxf, 10, P + 3 * i);
        bat_dxf_integer(&w->dxf, 70, 32);
    }
    begin_part(w, index, polyline, "SEQEND");
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

/* The simplest entity that is the curve. `as_path`: the same when it is lines and arcs. */
static batten_status put_space_curve(writing *w, int index, const batten_curve *space,
                                     const bat_path *path, const batten_curve *as_path)
{
    bat_dxf_round round;
    const double *P = batten_curve_points(space);
    const int degree = batten_curve_degree(space), n = batten_curve_point_count(space);
    batten_status status = bat_dxf_round_of(space, &round);
    if (status == BATTEN_OK && round.kind == BAT_DXF_NOT_ROUND && as_path)
        status = bat_dxf_round_of(as_path, &round);
    if (status != BATTEN_OK)
        return status;
    if (degree == 1 && n == 2)
        put_line(w, index, P, P + 3);
    else if (path && as_path && path->count == 2 && !path->closed &&
             path->vertices[0].bulge == 0)
        put_line(w, index, batten_curve_points(as_path), batten_curve_points(as_path) + 3);
    else if (round.kind == BAT_DXF_ELLIPSE)
        put_ellipse(w, index, &round);
    else if (round.kind != BAT_DXF_NOT_ROUND)
        put_circle(w, index, &round);
    else if (path)
        put_path(w, index, path);
    else if (degree == 1)
        put_space(w, index, space);
    else
        put_spline(w, index, space);
    return BATTEN_OK;
}

static batten_status put_curve(writing *w, int index, const batten_object *object)
{
    bool is_path = false;
    bat_path path = {0};
    batten_curve *space = NULL, *as_path = NULL;
    const batten_box box = batten_curve_box(object->curve);
    if (box.high.x == box.low.x && box.high.y == box.low.y && box.high.z == box.low.z) {
        batten_notes_add(w->notes, "", 0, object->name, "left out: this curve has no length");
        return BATTEN_OK;
    }
    batten_status status = bat_path_of(object, &is_path, &path);
    is_path = is_path && path.count >= 2;
    if (status == BATTEN_OK)
        status = bat_prepare_curve(object, &space);
    if (status == BATTEN_OK && is_path &&
        bat_path_curve(&path, &as_path) == BATTEN_OUT_OF_MEMORY)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = put_space_curve(w, index, space, is_path ? &path : NULL, as_path);
    bat_path_release(&path);
    batten_curve_unref(as_path);
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

/* At most; a polyline has one for each vertex. */
static double handles_of(const batten_object *object)
{
    const bool is_polyline =
        object->kind == BATTEN_OBJECT_CURVE && batten_curve_degree(object->curve) == 1;
    return 2 + object->point_count +
           (is_polyline ? batten_curve_point_count(object->curve) : 0);
}

/* More handles than the file can need. */
static batten_status count_handles(const batten_model *model, int *handles)
{
    double sum = 64;
    for (int i = 0; i < batten_model_count(model); i++)
        sum += handles_of(batten_model_object(model, i));
    /* Handles are written as int, and twice as many are never needed. */
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
    if (status == BATTEN_OK && w->entities == 0)
        status = bat_fail(BATTEN_UNSUPPORTED,
                          "DXF files hold points and curves; the model has none");
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
