/* The meshes of a glTF file: their bytes, and the accessors, materials and primitives of them. */
#include "exchange/gltf/writing.h"
#include "exchange/meshes/facets.h"
#include "exchange/reading/bytes.h"
#include "model/palette.h"
#include <batten/text.h>

#include <float.h>
#include <limits.h>

/* ---- what JSON is put together of ---- */

void bat_gltf_put_numbers(batten_text *text, int count, const double *numbers)
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
static int put_accessor(bat_gltf_writing *w, size_t at, int count, bool is_index,
                        const char *type, const double *low, const double *high)
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
        bat_gltf_put_numbers(&w->accessors, 3, low);
        batten_text_add(&w->accessors, "],\"max\":[");
        bat_gltf_put_numbers(&w->accessors, 3, high);
        batten_text_add(&w->accessors, "]");
    }
    batten_text_add(&w->accessors, "}");
    return w->accessor_count++;
}

/* sRGB to the linear light in which glTF has colours. */
static double linear(double c)
{
    return c <= 0.04045 ? c / 12.92 : bat_pow((c + 0.055) / 1.055, 2.4);
}

/* ---- meshes ---- */

/* (x, y, z) with z up is (x, z, -y) with y up. */
static void turn_up(const double in[3], double scale, double out[3])
{
    out[0] = scale * in[0];
    out[1] = scale * in[2];
    out[2] = -scale * in[1];
}

static batten_status put_positions(bat_gltf_writing *w, const batten_object *object,
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
                                vertex + 1, object->name, place[k]);
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
static bool has_unit_normals(const bat_gltf_writing *w, const batten_object *object)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    for (size_t i = 0; p->normals && i < 3 * (size_t)p->triangle_count; i++) {
        const double *n = p->normals + 3 * i;
        if (fabs(bat_hypot(bat_hypot(n[0], n[1]), n[2]) - 1) < 1e-3)
            continue;
        batten_notes_add(w->notes, "", 0, object->name,
                         "the normals are left out: (%g, %g, %g) has not the length 1", n[0],
                         n[1], n[2]);
        return false;
    }
    return p->normals != NULL;
}

static void put_normal(bat_gltf_writing *w, const double n[3])
{
    const double length = bat_hypot(bat_hypot(n[0], n[1]), n[2]);
    double turned[3];
    turn_up(n, 1 / length, turned);
    for (int k = 0; k < 3; k++)
        bat_bytes_put_float(&w->bytes, (float)turned[k] + 0.0f);
}

static int put_normals(bat_gltf_writing *w, const batten_mesh_parts *p,
                       const bat_corners *corners)
{
    const size_t at = w->bytes.length;
    for (int i = 0; i < corners->count; i++)
        put_normal(w, p->normals + 3 * (size_t)corners->source[i]);
    return put_accessor(w, at, corners->count, false, "VEC3", NULL, NULL);
}

static int put_colours(bat_gltf_writing *w, const batten_mesh_parts *p,
                       const bat_corners *corners)
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
static int put_indices(bat_gltf_writing *w, const bat_corners *corners, int count,
                       const int *triangles)
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
static int put_material(bat_gltf_writing *w, const double colour[3])
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

static void put_primitive(bat_gltf_writing *w, const bat_gltf_vertices *data, int indices,
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
static batten_status put_primitives(bat_gltf_writing *w, const batten_object *object,
                                    const bat_corners *corners, bat_gltf_vertices *data)
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

static void begin_mesh(bat_gltf_writing *w, const batten_object *object)
{
    put_comma(&w->meshes);
    batten_text_add(&w->meshes, "{\"name\":");
    batten_text_json(&w->meshes, object->name);
    batten_text_add(&w->meshes, ",\"primitives\":[");
}

static void end_mesh(bat_gltf_writing *w)
{
    batten_text_add(&w->meshes, "]}");
    w->mesh_count++;
}

static batten_status put_mesh(bat_gltf_writing *w, const batten_object *object,
                              bat_gltf_vertices *data)
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
static batten_status put_rounded(bat_gltf_writing *w, const batten_object *object,
                                 bat_gltf_vertices *data)
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
static batten_status add_mesh(bat_gltf_writing *w, const batten_object *object, int number)
{
    const bat_gltf_vertices *before = &w->data[w->same[number]];
    batten_status status = BATTEN_OK;
    w->mesh_of[number] = w->mesh_count + 1;
    if (w->look[number] < number) {
        w->mesh_of[number] = w->mesh_of[w->look[number]];
    } else if (w->same[number] < number && before->indices >= 0) {
        begin_mesh(w, object);
        put_primitive(w, before, before->indices, one_colour(object));
        end_mesh(w);
    } else {
        w->data[number] = (bat_gltf_vertices){-1, -1, -1, -1};
        status = put_rounded(w, object, &w->data[number]);
    }
    return status;
}

static batten_status put_object(bat_gltf_writing *w, const batten_object *object, int index)
{
    if (object->mesh && batten_mesh_view(object->mesh)->triangle_count)
        return add_mesh(w, object, index);
    return BATTEN_OK;
}

batten_status bat_gltf_put_meshes(bat_gltf_writing *w)
{
    batten_status status = bat_definitions_meshes(&w->definitions, w->same, w->look);
    for (int i = 0; i < w->definitions.count; i++) {
        const batten_model *model = w->definitions.models[i];
        for (int k = 0; status == BATTEN_OK && k < batten_model_count(model); k++)
            status = put_object(w, batten_model_object(model, k), w->definitions.first[i] + k);
    }
    return status;
}
