/* A model as glTF: its nodes, their places, and the JSON and bytes of the file. */
#include "base/list.h"
#include "exchange/gltf/writing.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/bytes.h"
#include "model/definitions.h"
#include "model/palette.h"

#include <batten/text.h>
#include <float.h>
#include <limits.h>

enum { MOST_NODES = 1000000 };

/* ---- nodes ---- */

static batten_status add_node(bat_gltf_writing *w, const batten_object *object, int number)
{
    if (w->node_count >= MOST_NODES)
        return bat_fail(BATTEN_TOO_LARGE, "instances within instances make more than %d nodes",
                        MOST_NODES);
    return BAT_LIST_ADD(w->nodes, w->node_count, w->node_capacity,
                        (bat_gltf_node){object, number, 0, 0});
}

static batten_status add_objects(bat_gltf_writing *w, const batten_model *model)
{
    const int first = w->definitions.first[bat_definitions_index(&w->definitions, model)];
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++)
        status = add_node(w, batten_model_object(model, i), first + i);
    return status;
}

static batten_status add_children(bat_gltf_writing *w, int node)
{
    const int first = w->node_count;
    const batten_status status = add_objects(w, w->nodes[node].object->definition);
    w->nodes[node].first = first;
    w->nodes[node].count = w->node_count - first;
    return status;
}

/* Level by level, so that the children of a node follow each other. */
static batten_status find_nodes(bat_gltf_writing *w)
{
    batten_status status = add_objects(w, w->definitions.models[0]);
    w->root_count = w->node_count;
    for (int i = 0; status == BATTEN_OK && i < w->node_count; i++)
        if (w->nodes[i].object->definition)
            status = add_children(w, i);
    return status;
}

/* ---- the places of instances ---- */

static bool are_oblique(const batten_affine *place, int i, int k)
{
    double dot = 0, a = 0, b = 0;
    for (int row = 0; row < 3; row++) {
        dot += place->m[row][i] * place->m[row][k];
        a += place->m[row][i] * place->m[row][i];
        b += place->m[row][k] * place->m[row][k];
    }
    /* Numbers of 32 bits cannot say an angle that is this near to a right one. */
    return fabs(dot) > 1e-9 * sqrt(a) * sqrt(b);
}

/* glTF wants places of turns, scales along the axes before them, and shifts: columns at right
 * angles. */
static bool is_sheared(const batten_affine *place)
{
    for (int i = 0; i < 3; i++)
        for (int k = i + 1; k < 3; k++)
            if (are_oblique(place, i, k))
                return true;
    return false;
}

/* The place among axes with y up, columns first. None is the same as the identity. */
static void put_matrix(bat_gltf_writing *w, const batten_object *object, batten_text *text)
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
    bat_gltf_put_numbers(text, 16, m);
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

static void put_nodes(bat_gltf_writing *w, batten_text *text)
{
    for (int i = 0; i < w->node_count; i++) {
        const bat_gltf_node *n = &w->nodes[i];
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

static void put_json(bat_gltf_writing *w, batten_text *text)
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
static batten_status put_file(bat_gltf_writing *w, const batten_text *json, batten_text *text)
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

static void release(bat_gltf_writing *w)
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

static void remark(const bat_gltf_writing *w, double unit)
{
    if (unit == 0)
        batten_notes_add(w->notes, "", 0, "",
                         "the model has no unit; its numbers are taken as metres");
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
    bat_gltf_writing w = {.notes = notes, .unit = unit > 0 ? unit : 1};
    batten_status status = bat_definitions_find(model, &w.definitions);
    if (status == BATTEN_OK)
        status = find_nodes(&w);
    if (status == BATTEN_OK) {
        const size_t objects = (size_t)w.definitions.first[w.definitions.count];
        w.mesh_of = bat_array(objects, sizeof *w.mesh_of);
        w.same = bat_array(objects, sizeof *w.same);
        w.look = bat_array(objects, sizeof *w.look);
        w.data = bat_array(objects, sizeof *w.data);
        status = w.mesh_of && w.same && w.look && w.data ? bat_gltf_put_meshes(&w)
                                                         : BATTEN_OUT_OF_MEMORY;
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
