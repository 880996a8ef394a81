/* Writes meshes and points as PLY, as text or as bytes. */
#include "exchange/meshes/facets.h"
#include "exchange/ply/ply.h"
#include "exchange/reading/bytes.h"

#include <batten/text.h>
#include <limits.h>

/* All objects become one element of vertices and one of faces. */
typedef struct {
    const batten_model *model;
    batten_notes *notes;
    batten_text *text;
    bool as_text;
    int vertices, triangles;
    bool has_colours, has_face_colours;
    double *normals;                /* [vertices][3], or NULL */
    const batten_mesh_parts *parts; /* of the only object, for its attributes */
    bool is_first;                  /* of a line of text */
} writing;

static const batten_mesh_parts *mesh_of(const writing *w, int object)
{
    const batten_mesh *mesh = batten_model_object(w->model, object)->mesh;
    return mesh ? batten_mesh_view(mesh) : NULL;
}

static void count_object(writing *w, int i, double *vertices, double *triangles)
{
    const batten_object *object = batten_model_object(w->model, i);
    const batten_mesh_parts *p = mesh_of(w, i);
    *vertices += p ? p->vertex_count : object->point_count;
    *triangles += p ? p->triangle_count : 0;
    w->has_colours |= (p && p->colours) || (!p && object->has_colour);
    w->has_face_colours |= p && p->triangle_colours;
}

static batten_status count_all(writing *w)
{
    double vertices = 0, triangles = 0;
    const int count = batten_model_count(w->model);
    for (int i = 0; i < count; i++)
        count_object(w, i, &vertices, &triangles);
    /* The colour of an object is that of its vertices, or of its faces where some have one. */
    for (int i = 0; i < count && !w->has_face_colours; i++)
        w->has_colours |= batten_model_object(w->model, i)->has_colour;
    if (vertices > INT_MAX || triangles > INT_MAX)
        return bat_fail(BATTEN_TOO_LARGE, "%.0f vertices and %.0f triangles are too many",
                        vertices, triangles);
    w->vertices = (int)vertices;
    w->triangles = (int)triangles;
    if (count == 1)
        w->parts = mesh_of(w, 0);
    if (count > 1)
        batten_notes_remark(w->notes, "", 0, "",
                            "%d objects become one: PLY files do not keep them apart", count);
    return BATTEN_OK;
}

/* ---- normals ---- */

/* The normals of the corners at the vertices; false when those of a vertex differ. */
static bool gather(const batten_mesh_parts *p, double *normals, bool *seen)
{
    for (size_t i = 0; i < 3 * (size_t)p->triangle_count; i++) {
        const size_t v = (size_t)p->corners[i];
        if (seen[v] && memcmp(normals + 3 * v, p->normals + 3 * i, 3 * sizeof *normals) != 0)
            return false;
        memcpy(normals + 3 * v, p->normals + 3 * i, 3 * sizeof *normals);
        seen[v] = true;
    }
    return true;
}

static int count_with_normals(const writing *w)
{
    int count = 0;
    for (int i = 0; i < batten_model_count(w->model); i++) {
        const batten_mesh_parts *p = mesh_of(w, i);
        count += p && p->normals;
    }
    return count;
}

static bool have_normals(const writing *w)
{
    const int count = count_with_normals(w), all = batten_model_count(w->model);
    if (count > 0 && count < all)
        batten_notes_add(w->notes, "", 0, "",
                         "the normals are left out: not all objects have them");
    return count > 0 && count == all;
}

static batten_status find_normals(writing *w)
{
    if (!have_normals(w))
        return BATTEN_OK;
    double *normals = bat_array(3 * (size_t)w->vertices, sizeof *normals);
    bool *seen = bat_array((size_t)w->vertices, sizeof *seen), same = true;
    size_t first = 0;
    const bool enough = normals && seen;
    for (int i = 0; enough && same && i < batten_model_count(w->model); i++) {
        const batten_mesh_parts *p = mesh_of(w, i);
        same = gather(p, normals + 3 * first, seen + first);
        first += (size_t)p->vertex_count;
    }
    bat_release(seen);
    if (enough && same) {
        w->normals = normals;
        return BATTEN_OK;
    }
    bat_release(normals);
    if (enough)
        batten_notes_add(w->notes, "", 0, "",
                         "the normals are left out: they differ between the faces at a vertex, "
                         "and PLY files have one for each vertex");
    return enough ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* ---- the header ---- */

/* A word that a header may have as the name of a property of its own. */
static void put_word(batten_text *text, const char *name)
{
    static const char *const taken[] = {"",
                                        "x",
                                        "y",
                                        "z",
                                        "nx",
                                        "ny",
                                        "nz",
                                        "red",
                                        "green",
                                        "blue",
                                        "diffuse_red",
                                        "diffuse_green",
                                        "diffuse_blue"};
    for (size_t k = 0; k < sizeof taken / sizeof taken[0]; k++)
        if (strcmp(name, taken[k]) == 0)
            batten_text_add(text, "value_");
    for (const char *c = name; *c; c++)
        batten_text_add(text, "%c", (unsigned char)*c <= ' ' ? '_' : *c);
}

static void put_header(writing *w)
{
    static const char colours[] =
        "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    batten_text_add(w->text, "ply\nformat %s 1.0\nelement vertex %d\n",
                    w->as_text ? "ascii" : "binary_little_endian", w->vertices);
    batten_text_add(w->text, "property double x\nproperty double y\nproperty double z\n");
    if (w->normals)
        batten_text_add(w->text,
                        "property double nx\nproperty double ny\nproperty double nz\n");
    if (w->has_colours)
        batten_text_bytes(w->text, colours, sizeof colours - 1);
    for (int k = 0; w->parts && k < w->parts->attribute_count; k++) {
        batten_text_add(w->text, "property double ");
        put_word(w->text, w->parts->attributes[k].name);
        batten_text_add(w->text, "\n");
    }
    if (w->triangles)
        batten_text_add(w->text, "element face %d\nproperty list uchar int vertex_indices\n",
                        w->triangles);
    if (w->triangles && w->has_face_colours)
        batten_text_bytes(w->text, colours, sizeof colours - 1);
    batten_text_add(w->text, "end_header\n");
}

/* ---- vertices and faces ---- */

static void put_gap(writing *w)
{
    if (!w->is_first)
        batten_text_bytes(w->text, " ", 1);
    w->is_first = false;
}

static void put_double(writing *w, double value)
{
    if (!w->as_text) {
        bat_bytes_put_double(w->text, value);
        return;
    }
    put_gap(w);
    batten_text_number(w->text, value);
}

static void put_integer(writing *w, int value, int bytes)
{
    if (!w->as_text) {
        bat_bytes_put(w->text, (uint64_t)value, bytes);
        return;
    }
    put_gap(w);
    batten_text_number(w->text, value);
}

static void end_line(writing *w)
{
    if (w->as_text)
        batten_text_bytes(w->text, "\n", 1);
    w->is_first = true;
}

/* What has no colour of its own is light grey among what has. */
static void put_colour(writing *w, const batten_object *object, const double *own)
{
    for (int k = 0; k < 3; k++) {
        const double part = own ? own[k] : object->has_colour ? object->colour[k] : 0.8;
        put_integer(w, (int)floor(255 * bat_min(bat_max(part, 0), 1) + 0.5), 1);
    }
}

static void put_vertices(writing *w)
{
    size_t index = 0;
    for (int i = 0; i < batten_model_count(w->model); i++) {
        const batten_object *object = batten_model_object(w->model, i);
        const batten_mesh_parts *p = mesh_of(w, i);
        const double *points = p ? p->points : object->points;
        const int count = p ? p->vertex_count : object->point_count;
        for (size_t j = 0; j < (size_t)count; j++, index++) {
            for (size_t k = 0; k < 3; k++)
                put_double(w, points[3 * j + k]);
            for (size_t k = 0; w->normals && k < 3; k++)
                put_double(w, w->normals[3 * index + k]);
            if (w->has_colours)
                put_colour(w, object, p && p->colours ? p->colours + 3 * j : NULL);
            for (int k = 0; w->parts && k < w->parts->attribute_count; k++)
                put_double(w, w->parts->attributes[k].values[j]);
            end_line(w);
        }
    }
}

static void put_face(writing *w, const batten_object *object, const batten_mesh_parts *p,
                     int first, size_t j)
{
    put_integer(w, 3, 1);
    for (size_t k = 0; k < 3; k++)
        put_integer(w, first + p->corners[3 * j + k], 4);
    if (w->has_face_colours)
        put_colour(w, object, p->triangle_colours ? p->triangle_colours + 3 * j : NULL);
    end_line(w);
}

static void put_faces(writing *w)
{
    int first = 0;
    for (int i = 0; i < batten_model_count(w->model); i++) {
        const batten_object *object = batten_model_object(w->model, i);
        const batten_mesh_parts *p = mesh_of(w, i);
        for (size_t j = 0; p && j < (size_t)p->triangle_count; j++)
            put_face(w, object, p, first, j);
        first += p ? p->vertex_count : object->point_count;
    }
}

static void note_attributes(const writing *w)
{
    for (int i = 0; i < batten_model_count(w->model); i++) {
        const batten_mesh_parts *p = mesh_of(w, i);
        if (!w->parts && p && p->attribute_count)
            batten_notes_add(
                w->notes, "", 0, batten_model_object(w->model, i)->name,
                "further values of each vertex: %d; left out, as other objects have none",
                p->attribute_count);
    }
}

batten_status bat_write_ply(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text)
{
    writing w = {.model = model,
                 .notes = notes,
                 .text = text,
                 .as_text = options->as_text,
                 .is_first = true};
    batten_status status = count_all(&w);
    if (status == BATTEN_OK)
        status = find_normals(&w);
    if (status == BATTEN_OK) {
        bat_remark_unit(model, "PLY", notes);
        note_attributes(&w);
        put_header(&w);
        put_vertices(&w);
        put_faces(&w);
    }
    bat_release(w.normals);
    return status;
}
