#include "exchange/gltf/gltf.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/bytes.h"
#include "model/definitions.h"
#include "model/palette.h"

#include <batten/text.h>
#include <float.h>
#include <limits.h>

enum { MOST_NODES = 1000000 };

/* A node is an object of a definition at one of its places. */
typedef struct {
    const batten_object *object;
    int number;       /* of the object among those of all definitions */
    int first, count; /* its children */
} node;

/* The accessors of a mesh; -1 for none. */
typedef struct {
    int positions, normals, colours;
    int indices; /* of all triangles */
} vertex_data;

typedef struct {
    batten_notes *notes;
    double unit;
    bat_definitions definitions;
    node *nodes;
    int node_count, node_capacity, root_count;
    int *mesh_of;      /* [objects] index of the mesh + 1; 0: none */
    int *same, *look;  /* [objects] the first with the same mesh, and with its look too */
    vertex_data *data; /* [objects] of that first one */
    int mesh_count, material_count, accessor_count;
    batten_text bytes, meshes, materials, accessors, views;
    double error; /* of rounding, metres */
} writing;

/* ---- nodes ---- */

static batten_status add_node(writing *w, const batten_object *object, int number)
{
    if (w->node_count >= MOST_NODES)
        return bat_fail(BATTEN_TOO_LARGE, "instances within instances make more than %d nodes",
                        MOST_NODES);
    if (w->node_count == w->node_capacity) {
        const int capacity = bat_max_int(16, 2 * w->node_capacity);
        node *nodes = bat_resize(w->nodes, (size_t)capacity, sizeof *nodes);
        if (!nodes)
            return BATTEN_OUT_OF_MEMORY;
        w->nodes = nodes;
        w->node_capacity = capacity;
    }
    w->nodes[w->node_count++] = (node){object, number, 0, 0};
    return BATTEN_OK;
}

static batten_status add_objects(writing *w, const batten_model *model)
{
    const int first = w->definitions.first[bat_definitions_index(&w->definitions, model)];
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = add_node(w, batten_model_object(model, i), first + i);
    return status;
}

/* Level by level, so that the children of a node follow each other. */
static batten_status find_nodes(writing *w)
{
    batten_status status = add_objects(w, w->definitions.models[0]);
    w->root_count = w->node_count;
    for (int i = 0; status == BATTEN_OK && i < w->node_count; i++) {
        if (!w->nodes[i].object->definition)
            continue;
        const int first = w->node_count;
        status = add_objects(w, w->nodes[i].object->definition);
        w->nodes[i].first = first;
        w->nodes[i].count = w->node_count - first;
    }
    return status;
}

/* ---- what JSON is put together of ---- */

static void put_numbers(batten_text *text, int count, const double *numbers)
{
    for (int k = 0; k < count; k++) {
        if (k)
            batten_text_add(text, ",");
        batten_text_number(text, numbers[k]);
    }
}

static void put_comma(batten_text *text)
{
    if (text->length)
        batten_text_add(text, ",");
}

/* A view of the bytes from `at` on, and an accessor for it: 5126 is float, 5125 unsigned int.
 * @return its index */
static int put_accessor(writing *w, size_t at, int count, bool is_index, const char *type,
                        const double *low, const double *high)
{
    put_comma(&w->views);
    batten_text_add(&w->views,
                    "{\"buffer\":0,\"byteOffset\":%zu,\"byteLength\":%zu,\"target\":%d}", at,
                    w->bytes.length - at, is_index ? 34963 : 34962);
    put_comma(&w->accessors);
    batten_text_add(&w->accessors,
                    "{\"bufferView\":%d,\"componentType\":%d,\"count\":%d,\"type\":\"%s\"",
                    w->accessor_count, is_index ? 5125 : 5126, count, type);
    if (low) {
        batten_text_add(&w->accessors, ",\"min\":[");
        put_numbers(&w->accessors, 3, low);
        batten_text_add(&w->accessors, "],\"max\":[");
        put_numbers(&w->accessors, 3, high);
        batten_text_add(&w->accessors, "]");
    }
    batten_text_add(&w->accessors, "}");
    return w->accessor_count++;
}

/* sRGB to the linear light in which glTF has colours. */
static double linear(double c)
{
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* ---- meshes ---- */

/* (x, y, z) with z up is (x, z, -y) with y up. */
static void turn_up(const double in[3], double scale, double out[3])
{
    out[0] = scale * in[0];
    out[1] = scale * in[2];
    out[2] = -scale * in[1];
}

static batten_status put_positions(writing *w, const batten_object *object,
                                   const bat_corners *corners, int *accessor)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    const size_t at = w->bytes.length;
    double low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
    for (int i = 0; i < corners->count; i++) {
        const int vertex = p->corners[corners->source[i]];
        double place[3];
        turn_up(p->points + 3 * (size_t)vertex, w->unit, place);
        for (int k = 0; k < 3; k++) {
            if (!(fabs(place[k]) <= (double)FLT_MAX))
                return bat_fail(BATTEN_OVERFLOW,
                                "a coordinate of vertex %d of '%.60s' is %g m; glTF holds "
                                "numbers below 3.4e38",
                                vertex, object->name, place[k]);
            const float rounded = (float)place[k] + 0.0f;
            bat_bytes_put_float(&w->bytes, rounded);
            w->error = bat_max(w->error, fabs((double)rounded - place[k]));
            low[k] = i ? bat_min(low[k], (double)rounded) : (double)rounded;
            high[k] = i ? bat_max(high[k], (double)rounded) : (double)rounded;
        }
    }
    *accessor = put_accessor(w, at, corners->count, false, "VEC3", low, high);
    return BATTEN_OK;
}

/* glTF wants normals of the length 1 up to rounding: a mesh with others has none. */
static bool has_unit_normals(const writing *w, const batten_object *object)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    for (size_t i = 0; p->normals && i < 3 * (size_t)p->triangle_count; i++) {
        const double *n = p->normals + 3 * i;
        if (fabs(hypot(hypot(n[0], n[1]), n[2]) - 1) < 1e-3)
            continue;
        batten_notes_add(w->notes, "", 0, object->name,
                         "the normals are left out: (%g, %g, %g) has not the length 1", n[0],
                         n[1], n[2]);
        return false;
    }
    return p->normals != NULL;
}

static int put_normals(writing *w, const batten_mesh_parts *p, const bat_corners *corners)
{
    const size_t at = w->bytes.length;
    for (int i = 0; i < corners->count; i++) {
        const double *n = p->normals + 3 * (size_t)corners->source[i];
        const double length = hypot(hypot(n[0], n[1]), n[2]);
        double turned[3];
        turn_up(n, 1 / length, turned);
        for (int k = 0; k < 3; k++)
            bat_bytes_put_float(&w->bytes, (float)turned[k] + 0.0f);
    }
    return put_accessor(w, at, corners->count, false, "VEC3", NULL, NULL);
}

static int put_colours(writing *w, const batten_mesh_parts *p, const bat_corners *corners)
{
    const size_t at = w->bytes.length;
    for (int i = 0; i < corners->count; i++) {
        const double *c = p->colours + 3 * (size_t)p->corners[corners->source[i]];
        for (int k = 0; k < 3; k++)
            bat_bytes_put_float(&w->bytes, (float)linear(bat_min(bat_max(c[k], 0), 1)));
    }
    return put_accessor(w, at, corners->count, false, "VEC3", NULL, NULL);
}

/* The corners of `count` triangles, those of the list or, without one, the first. */
static int put_indices(writing *w, const bat_corners *corners, int count, const int *triangles)
{
    const size_t at = w->bytes.length;
    for (size_t i = 0; i < (size_t)count; i++)
        for (size_t k = 0; k < 3; k++)
            bat_bytes_put(
                &w->bytes,
                (uint64_t)corners->index[3 * (triangles ? (size_t)triangles[i] : i) + k], 4);
    return put_accessor(w, at, 3 * count, true, "SCALAR", NULL, NULL);
}

/* Sheets are seen from both sides. */
static int put_material(writing *w, const double colour[3])
{
    put_comma(&w->materials);
    batten_text_add(&w->materials, "{\"pbrMetallicRoughness\":{\"baseColorFactor\":[");
    for (int k = 0; k < 3; k++) {
        batten_text_number(&w->materials, linear(bat_min(bat_max(colour[k], 0), 1)));
        batten_text_add(&w->materials, ",");
    }
    batten_text_add(&w->materials,
                    "1],\"metallicFactor\":0,\"roughnessFactor\":0.5},\"doubleSided\":true}");
    return w->material_count++;
}

static void put_primitive(writing *w, const vertex_data *data, int indices,
                          const double *colour)
{
    batten_text_add(&w->meshes, "{\"attributes\":{\"POSITION\":%d", data->positions);
    if (data->normals >= 0)
        batten_text_add(&w->meshes, ",\"NORMAL\":%d", data->normals);
    if (data->colours >= 0)
        batten_text_add(&w->meshes, ",\"COLOR_0\":%d", data->colours);
    batten_text_add(&w->meshes, "},\"indices\":%d", indices);
    if (colour)
        batten_text_add(&w->meshes, ",\"material\":%d", put_material(w, colour));
    batten_text_add(&w->meshes, "}");
}

/* glTF would multiply colours of vertices with it. */
static const double *one_colour(const batten_object *object)
{
    return object->has_colour && !batten_mesh_view(object->mesh)->colours ? object->colour
                                                                          : NULL;
}

/* Triangles of one colour are one primitive; all of them use the same vertices. */
static batten_status put_primitives(writing *w, const batten_object *object,
                                    const bat_corners *corners, vertex_data *data)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    bat_palette palette;
    if (p->colours && p->triangle_colours)
        batten_notes_add(
            w->notes, "", 0, object->name,
            "the colours of its faces are left out: its vertices have colours too, "
            "which glTF would multiply with them");
    if (p->colours || !p->triangle_colours) {
        data->indices = put_indices(w, corners, p->triangle_count, NULL);
        put_primitive(w, data, data->indices, one_colour(object));
        return BATTEN_OK;
    }
    const batten_status status = bat_palette_find(p, &palette);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < palette.count; i++) {
        const int first = palette.first[i];
        if (i)
            batten_text_add(&w->meshes, ",");
        put_primitive(
            w, data,
            put_indices(w, corners, palette.first[i + 1] - first, palette.order + first),
            bat_palette_colour(&palette, p, i));
    }
    bat_palette_end(&palette);
    return BATTEN_OK;
}

static void begin_mesh(writing *w, const batten_object *object)
{
    put_comma(&w->meshes);
    batten_text_add(&w->meshes, "{\"name\":");
    batten_text_json(&w->meshes, object->name);
    batten_text_add(&w->meshes, ",\"primitives\":[");
}

static void end_mesh(writing *w)
{
    batten_text_add(&w->meshes, "]}");
    w->mesh_count++;
}

static batten_status put_mesh(writing *w, const batten_object *object, vertex_data *data)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    batten_mesh_parts shown = *p;
    bat_corners corners = {0, NULL, NULL};
    if (!has_unit_normals(w, object))
        shown.normals = NULL;
    batten_status status = bat_number_corners(&shown, &corners);
    if (status == BATTEN_OK)
        status = put_positions(w, object, &corners, &data->positions);
    if (status == BATTEN_OK) {
        if (shown.normals)
            data->normals = put_normals(w, p, &corners);
        if (p->colours)
            data->colours = put_colours(w, p, &corners);
        begin_mesh(w, object);
        status = put_primitives(w, object, &corners, data);
        end_mesh(w);
    }
    bat_corners_end(&corners);
    return status;
}

/* Without the triangles that rounding takes away; a mesh of nothing else stays as it is, since
 * glTF has none without triangles. */
static batten_status put_rounded(writing *w, const batten_object *object, vertex_data *data)
{
    batten_object shown = *object;
    batten_mesh *rounded = NULL;
    batten_status status = bat_rounded_mesh(object, w->unit, w->notes, &rounded);
    if (status != BATTEN_OK)
        return status;
    if (batten_mesh_view(rounded)->triangle_count > 0)
        shown.mesh = rounded;
    status = put_mesh(w, &shown, data);
    batten_mesh_unref(rounded);
    return status;
}

/* The mesh of object `number`; one that looks like another is that one, one of another colour
 * shares its numbers. */
static batten_status add_mesh(writing *w, const batten_object *object, int number)
{
    const vertex_data *before = &w->data[w->same[number]];
    batten_status status = BATTEN_OK;
    w->mesh_of[number] = w->mesh_count + 1;
    if (w->look[number] < number) {
        w->mesh_of[number] = w->mesh_of[w->look[number]];
    } else if (w->same[number] < number && before->indices >= 0) {
        begin_mesh(w, object);
        put_primitive(w, before, before->indices, one_colour(object));
        end_mesh(w);
    } else {
        w->data[number] = (vertex_data){-1, -1, -1, -1};
        status = put_rounded(w, object, &w->data[number]);
    }
    return status;
}

static batten_status put_meshes(writing *w)
{
    batten_status status = bat_definitions_meshes(&w->definitions, w->same, w->look);
    for (int i = 0; i < w->definitions.count; i++) {
        const batten_model *model = w->definitions.models[i];
        for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++) {
            const batten_object *object = batten_model_object(model, k);
            if (object->mesh && batten_mesh_view(object->mesh)->triangle_count)
                status = add_mesh(w, object, w->definitions.first[i] + k);
            else if (!object->mesh && !object->definition)
                batten_notes_add(w->notes, "", 0, object->name,
                                 "left out: glTF files are written of meshes, not of this %s",
                                 batten_object_kind_name(object->kind));
        }
    }
    return status;
}

/* ---- the places of instances ---- */

/* glTF wants places of turns, scales along the axes before them, and shifts: columns at right
 * angles. */
static bool is_sheared(const batten_affine *place)
{
    for (int i = 0; i < 3; i++)
        for (int k = i + 1; k < 3; k++) {
            double dot = 0, a = 0, b = 0;
            for (int row = 0; row < 3; row++) {
                dot += place->m[row][i] * place->m[row][k];
                a += place->m[row][i] * place->m[row][i];
                b += place->m[row][k] * place->m[row][k];
            }
            if (fabs(dot) > 1e-9 * sqrt(a) * sqrt(b))
                return true;
        }
    return false;
}

/* The place among axes with y up, columns first. None is the same as the identity. */
static void put_matrix(writing *w, const batten_object *object, batten_text *text)
{
    static const int from[3] = {0, 2, 1};
    static const double sign[3] = {1, 1, -1};
    const batten_affine *place = &object->place;
    double m[16] = {0};
    bool is_moved = false;
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            m[4 * column + row] =
                sign[row] * sign[column] * place->m[from[row]][from[column]] + 0.0;
            is_moved = is_moved || m[4 * column + row] != (row == column);
        }
        m[12 + row] = sign[row] * w->unit * place->t[from[row]] + 0.0;
        is_moved = is_moved || m[12 + row] != 0;
    }
    m[15] = 1;
    if (!is_moved)
        return;
    batten_text_add(text, ",\"matrix\":[");
    put_numbers(text, 16, m);
    batten_text_add(text, "]");
    if (is_sheared(place))
        batten_notes_add(w->notes, "", 0, object->name,
                         "its place is sheared, which glTF does not allow; some programs will "
                         "show it elsewhere");
}

static void put_range(batten_text *text, int first, int count)
{
    for (int i = 0; i < count; i++)
        batten_text_add(text, i ? ",%d" : "%d", first + i);
}

static void put_nodes(writing *w, batten_text *text)
{
    for (int i = 0; i < w->node_count; i++) {
        const node *n = &w->nodes[i];
        batten_text_add(text, i ? ",{\"name\":" : "{\"name\":");
        batten_text_json(text, n->object->name);
        if (w->mesh_of[n->number])
            batten_text_add(text, ",\"mesh\":%d", w->mesh_of[n->number] - 1);
        if (n->object->definition)
            put_matrix(w, n->object, text);
        if (n->count) {
            batten_text_add(text, ",\"children\":[");
            put_range(text, n->first, n->count);
            batten_text_add(text, "]");
        }
        batten_text_add(text, "}");
    }
}

/* ---- the file ---- */

static void put_list(batten_text *text, const char *name, const batten_text *items)
{
    if (!items->length)
        return;
    batten_text_add(text, ",\"%s\":[", name);
    batten_text_bytes(text, items->bytes, items->length);
    batten_text_add(text, "]");
}

static void put_json(writing *w, batten_text *text)
{
    batten_text_add(text, "{\"asset\":{\"version\":\"2.0\",\"generator\":\"Batten\"},"
                          "\"scene\":0,\"scenes\":[{");
    const char *name = batten_model_name(w->definitions.models[0]);
    if (*name) {
        batten_text_add(text, "\"name\":");
        batten_text_json(text, name);
    }
    if (w->root_count) {
        batten_text_add(text, *name ? ",\"nodes\":[" : "\"nodes\":[");
        put_range(text, 0, w->root_count);
        batten_text_add(text, "]");
    }
    batten_text_add(text, "}]");
    if (w->node_count) {
        batten_text_add(text, ",\"nodes\":[");
        put_nodes(w, text);
        batten_text_add(text, "]");
    }
    put_list(text, "meshes", &w->meshes);
    put_list(text, "materials", &w->materials);
    put_list(text, "accessors", &w->accessors);
    put_list(text, "bufferViews", &w->views);
    if (w->bytes.length)
        batten_text_add(text, ",\"buffers\":[{\"byteLength\":%zu}]", w->bytes.length);
    batten_text_add(text, "}");
    while (text->length % 4 && !text->failed)
        batten_text_bytes(text, " ", 1);
}

/* Header, the chunk of JSON, the chunk of bytes; each a multiple of 4 long. */
static batten_status put_file(writing *w, const batten_text *json, batten_text *text)
{
    const uint64_t bytes = w->bytes.length;
    const uint64_t length = 12 + 8 + (uint64_t)json->length + (bytes ? 8 + bytes : 0);
    if (length > UINT32_MAX)
        return bat_fail(BATTEN_TOO_LARGE, "a glTF file of %.0f bytes; it can have 4 GiB",
                        (double)length);
    text->failed = text->failed || json->failed || w->bytes.failed || w->meshes.failed ||
                   w->materials.failed || w->accessors.failed || w->views.failed;
    batten_text_bytes(text, "glTF", 4);
    bat_bytes_put(text, 2, 4);
    bat_bytes_put(text, length, 4);
    bat_bytes_put(text, json->length, 4);
    batten_text_bytes(text, "JSON", 4);
    batten_text_bytes(text, json->bytes, json->length);
    if (bytes) {
        bat_bytes_put(text, bytes, 4);
        batten_text_bytes(text, "BIN\0", 4);
        batten_text_bytes(text, w->bytes.bytes, w->bytes.length);
    }
    return BATTEN_OK;
}

static void release(writing *w)
{
    bat_definitions_end(&w->definitions);
    bat_release(w->nodes);
    bat_release(w->mesh_of);
    bat_release(w->same);
    bat_release(w->look);
    bat_release(w->data);
    batten_text_free(&w->bytes);
    batten_text_free(&w->meshes);
    batten_text_free(&w->materials);
    batten_text_free(&w->accessors);
    batten_text_free(&w->views);
}

static void remark(const writing *w, double unit)
{
    if (unit == 0)
        batten_notes_add(w->notes, "", 0, "",
                         "the model names no unit; its numbers are taken for metres");
    if (w->error > 0)
        batten_notes_remark(w->notes, "", 0, "",
                            "coordinates are rounded to 32 bits: at most %.3g m off", w->error);
}

batten_status bat_write_gltf(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text)
{
    (void)options;
    const double unit = batten_model_unit_metres(model);
    batten_text json = BATTEN_TEXT;
    writing w = {.notes = notes, .unit = unit > 0 ? unit : 1};
    batten_status status = bat_definitions_find(model, &w.definitions);
    if (status == BATTEN_OK)
        status = find_nodes(&w);
    if (status == BATTEN_OK) {
        const size_t objects = (size_t)w.definitions.first[w.definitions.count];
        w.mesh_of = bat_array(objects, sizeof *w.mesh_of);
        w.same = bat_array(objects, sizeof *w.same);
        w.look = bat_array(objects, sizeof *w.look);
        w.data = bat_array(objects, sizeof *w.data);
        status =
            w.mesh_of && w.same && w.look && w.data ? put_meshes(&w) : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK) {
        put_json(&w, &json);
        status = put_file(&w, &json, text);
        remark(&w, unit);
    }
    batten_text_free(&json);
    release(&w);
    return status;
}
