/* What a reader of glTF sees of a model: triangle by triangle, from the JSON and the bytes. */
#ifndef TESTS_EXCHANGE_SEEN_H
#define TESTS_EXCHANGE_SEEN_H
#include "exchange/meshes/meshes.h"
#include "exchange/reading/bytes.h"
#include "support/json.h"

typedef struct {
    const char *json, *bytes;
    char *data;
    batten_notes *notes;
} glb;

static inline glb written_glb(const batten_model *model)
{
    glb g = {.data = NULL};
    size_t size = 0;
    CHECK_OK(batten_notes_create(20, &g.notes));
    CHECK_OK(write_form(model, BATTEN_FORMAT_GLTF, false, g.notes, &g.data, &size));
    const size_t length = bat_bytes_u32(g.data + 12);
    char *json = test_array(length + 1, 1);
    memcpy(json, g.data + 20, length);
    g.json = json;
    g.bytes = g.data + 28 + length;
    return g;
}

static inline void end_glb(glb *g)
{
    batten_release(g->data);
    batten_notes_free(g->notes);
}

/* The value of a key, or `otherwise` when the object has none. */
static inline int whole_of(const char *object, const char *key, int otherwise)
{
    const char *at = json_try(object, key);
    return at ? (int)json_number(at) : otherwise;
}

/* Where item `index` of an accessor stands, items of `size` bytes; the bounds are checked. */
static const char *item_of(const glb *g, int accessor, int index, int size)
{
    const char *a = json_item(json_key(g->json, "accessors"), accessor);
    const char *view =
        json_item(json_key(g->json, "bufferViews"), whole_of(a, "bufferView", -1));
    const int count = whole_of(a, "count", -1), length = whole_of(view, "byteLength", -1);
    CHECK(index >= 0 && index < count);
    CHECK_INT(length, count * size);
    CHECK_INT(whole_of(a, "componentType", 0), size == 4 ? 5125 : 5126);
    CHECK_INT(whole_of(view, "target", 0), size == 4 ? 34963 : 34962);
    const int offset = whole_of(view, "byteOffset", -1);
    const char *buffer = json_item(json_key(g->json, "buffers"), 0);
    CHECK(offset + length <= whole_of(buffer, "byteLength", 0) && offset % 4 == 0);
    return g->bytes + offset + index * size;
}

static inline void vector_of(const glb *g, int accessor, int index, double out[3])
{
    const char *at = item_of(g, accessor, index, 12);
    for (int k = 0; k < 3; k++)
        out[k] = bat_bytes_float(at + 4 * k, false);
}

/* From y up to z up. */
static inline void set_upright(const double in[3], double out[3])
{
    const double turned[3] = {in[0], -in[2], in[1]};
    memcpy(out, turned, sizeof turned);
}

/* The light of glTF as sRGB. */
static inline double shown(double light)
{
    return light <= 0.0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - 0.055;
}

typedef struct {
    double at[3][3], normal[3][3], colour[3][3];
    bool has_normal, has_colour;
} facet;

enum { MOST = 100 };
typedef struct {
    facet facets[MOST];
    int count;
} scene;

static inline void see_primitive(const glb *g, const char *primitive, const double matrix[16],
                                 scene *s)
{
    const char *attributes = json_key(primitive, "attributes");
    const int indices = whole_of(primitive, "indices", -1);
    const int normals = whole_of(attributes, "NORMAL", -1);
    const int colours = whole_of(attributes, "COLOR_0", -1);
    const int material = whole_of(primitive, "material", -1);
    const int count = whole_of(json_item(json_key(g->json, "accessors"), indices), "count", 0);
    CHECK_INT(count % 3, 0);
    for (int i = 0; i < count; i++) {
        CHECK(s->count < MOST);
        facet *f = &s->facets[s->count];
        const int vertex = (int)bat_bytes_u32(item_of(g, indices, i, 4)), k = i % 3;
        double p[3], moved[3];
        vector_of(g, whole_of(attributes, "POSITION", -1), vertex, p);
        for (int row = 0; row < 3; row++)
            moved[row] = matrix[row] * p[0] + matrix[4 + row] * p[1] + matrix[8 + row] * p[2] +
                         matrix[12 + row];
        set_upright(moved, f->at[k]);
        f->has_normal = normals >= 0;
        f->has_colour = colours >= 0 || material >= 0;
        if (normals >= 0) {
            vector_of(g, normals, vertex, p);
            set_upright(p, f->normal[k]);
        }
        double light[4] = {0};
        if (material >= 0)
            json_numbers(json_key(json_key(json_item(json_key(g->json, "materials"), material),
                                           "pbrMetallicRoughness"),
                                  "baseColorFactor"),
                         4, light);
        if (colours >= 0)
            vector_of(g, colours, vertex, light);
        CHECK(colours < 0 || material < 0); /* they would be multiplied */
        for (int c = 0; c < 3; c++)
            f->colour[k][c] = shown(light[c]);
        s->count += k == 2;
    }
}

static inline void see_node(const glb *g, int index, const double above[16], scene *s)
{
    const char *node = json_item(json_key(g->json, "nodes"), index);
    double own[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, matrix[16];
    if (json_try(node, "matrix"))
        CHECK_INT(json_numbers(json_try(node, "matrix"), 16, own), 16);
    for (int column = 0; column < 4; column++)
        for (int row = 0; row < 4; row++) {
            matrix[4 * column + row] = 0;
            for (int k = 0; k < 4; k++)
                matrix[4 * column + row] += above[4 * k + row] * own[4 * column + k];
        }
    const int mesh = whole_of(node, "mesh", -1);
    const char *primitives =
        mesh < 0 ? NULL : json_key(json_item(json_key(g->json, "meshes"), mesh), "primitives");
    for (int k = 0; primitives && json_item(primitives, k); k++)
        see_primitive(g, json_item(primitives, k), matrix, s);
    const char *children = json_try(node, "children");
    for (int k = 0; children && json_item(children, k); k++)
        see_node(g, (int)json_number(json_item(children, k)), matrix, s);
}

static inline scene *see(const glb *g)
{
    static const double still[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
    scene *s = test_array(1, sizeof *s);
    const char *roots = json_try(json_item(json_key(g->json, "scenes"), 0), "nodes");
    for (int k = 0; roots && json_item(roots, k); k++)
        see_node(g, (int)json_number(json_item(roots, k)), still, s);
    return s;
}

#endif
