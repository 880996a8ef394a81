/* Writes meshes as STL, as text or as bytes. */
#include "exchange/meshes/facets.h"
#include "exchange/reading/bytes.h"
#include "exchange/stl/stl.h"

#include <batten/text.h>
#include <float.h>

enum { HEADER = 80, FACET = 50 };

/* ---- bytes ---- */

typedef struct {
    batten_text *text;
    double error; /* the largest rounding of a coordinate */
} writing;

/* -0 becomes 0: else points that only rounding makes one could differ in their bytes. */
static void put_float(char *bytes, double value)
{
    const float rounded = (float)value + 0.0f;
    uint32_t bits;
    memcpy(&bits, &rounded, sizeof bits);
    for (int k = 0; k < 4; k++)
        bytes[k] = (char)(unsigned char)(bits >> (8 * k) & 0xff);
}

/* The normal is that of the rounded corners: so that what is read is written the same. */
static batten_status put_facet(writing *w, const batten_object *object, const batten_mesh *mesh,
                               int index)
{
    const batten_mesh_parts *p = batten_mesh_view(mesh);
    double corners[9], normal[3];
    char bytes[FACET] = {0};
    for (int k = 0; k < 9; k++) {
        const int vertex = p->corners[3 * (size_t)index + (size_t)(k / 3)];
        const double x = p->points[3 * (size_t)vertex + (size_t)(k % 3)];
        if (fabs(x) > (double)FLT_MAX)
            return bat_fail(BATTEN_OVERFLOW,
                            "%c of vertex %d of '%.60s' is %g; binary STL holds numbers below "
                            "3.4e38",
                            "xyz"[k % 3], vertex + 1, object->name, x);
        corners[k] = (double)(float)x;
        w->error = bat_max(w->error, fabs(corners[k] - x));
        put_float(bytes + 12 + 4 * k, x);
    }
    bat_facet_normal(corners, corners + 3, corners + 6, normal);
    for (int k = 0; k < 3; k++)
        put_float(bytes + 4 * k, normal[k]);
    batten_text_bytes(w->text, bytes, FACET);
    return BATTEN_OK;
}

/* The mesh of each object without the triangles that rounding takes away, and the triangles of
 * all together. */
static batten_status round_meshes(const batten_model *model, batten_notes *notes,
                                  batten_mesh **rounded, uint32_t *count)
{
    batten_status status = BATTEN_OK;
    uint64_t sum = 0;
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(model); i++) {
        status = bat_rounded_mesh(batten_model_object(model, i), 1, notes, &rounded[i]);
        if (status == BATTEN_OK)
            sum += (uint64_t)batten_mesh_view(rounded[i])->triangle_count;
    }
    if (status == BATTEN_OK && sum > UINT32_MAX)
        return bat_fail(BATTEN_TOO_LARGE, "%.0f triangles are more than an STL file counts",
                        (double)sum);
    *count = (uint32_t)sum;
    return status;
}

static batten_status put_meshes(writing *w, const batten_model *model, batten_notes *notes)
{
    /* Must not begin with "solid": some programs would take it for the readable form. */
    static const char header[HEADER] = "Batten, binary STL";
    const int objects = batten_model_count(model);
    batten_mesh **rounded = bat_array((size_t)objects, sizeof *rounded);
    uint32_t count = 0;
    if (!rounded)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = round_meshes(model, notes, rounded, &count);
    batten_text_bytes(w->text, header, HEADER);
    bat_bytes_put(w->text, count, 4);
    for (int i = 0; status == BATTEN_OK && i < objects; i++) {
        const int triangles = batten_mesh_view(rounded[i])->triangle_count;
        for (int k = 0; status == BATTEN_OK && k < triangles; k++)
            status = put_facet(w, batten_model_object(model, i), rounded[i], k);
    }
    for (int i = 0; i < objects; i++)
        batten_mesh_unref(rounded[i]);
    bat_release(rounded);
    return status;
}

static batten_status write_bytes(const batten_model *model, batten_notes *notes,
                                 batten_text *text)
{
    writing w = {text, 0};
    const batten_status status = put_meshes(&w, model, notes);
    if (status == BATTEN_OK && w.error > 0)
        batten_notes_remark(notes, "", 0, "",
                            "coordinates are rounded to 32 bits: at most %.3g off", w.error);
    if (status == BATTEN_OK && batten_model_count(model) > 1)
        batten_notes_remark(notes, "", 0, "",
                            "%d objects become one: binary STL does not keep them apart",
                            batten_model_count(model));
    return status;
}

/* ---- text ---- */

static void put_words(batten_text *text, const char *words)
{
    batten_text_bytes(text, words, strlen(words));
}

static void put_numbers(batten_text *text, const double numbers[3])
{
    for (int k = 0; k < 3; k++) {
        put_words(text, " ");
        batten_text_number(text, numbers[k]);
    }
    put_words(text, "\n");
}

static void put_name(batten_text *text, const char *name)
{
    const bat_span core = bat_name_core(name, "mesh");
    put_words(text, " ");
    for (size_t i = 0; i < core.length; i++) {
        const char c = (unsigned char)core.bytes[i] < ' ' ? ' ' : core.bytes[i];
        batten_text_bytes(text, &c, 1);
    }
    put_words(text, "\n");
}

static void put_solid(const batten_object *object, batten_text *text)
{
    const batten_mesh_parts *p = batten_mesh_view(object->mesh);
    put_words(text, "solid");
    put_name(text, object->name);
    for (int i = 0; i < p->triangle_count; i++) {
        const int *corners = p->corners + 3 * (size_t)i;
        const double *at[3];
        double normal[3];
        for (int k = 0; k < 3; k++)
            at[k] = p->points + 3 * (size_t)corners[k];
        bat_facet_normal(at[0], at[1], at[2], normal);
        put_words(text, "facet normal");
        put_numbers(text, normal);
        put_words(text, "outer loop\n");
        for (int k = 0; k < 3; k++) {
            put_words(text, "vertex");
            put_numbers(text, at[k]);
        }
        put_words(text, "endloop\nendfacet\n");
    }
    put_words(text, "endsolid");
    put_name(text, object->name);
}

batten_status bat_write_stl(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    bat_remark_unit(model, "STL", notes);
    if (!options->as_text)
        return write_bytes(model, notes, text);
    for (int i = 0; i < batten_model_count(model); i++)
        put_solid(batten_model_object(model, i), text);
    return BATTEN_OK;
}
