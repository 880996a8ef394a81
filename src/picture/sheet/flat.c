/* A model made flat: objects within others as objects of their own, bodies by the colours of their
 * faces. */
#include "picture/sheet/flat.h"
#include "base/plural.h"
#include "numeric/box.h"

#include <string.h>

/* Stripes and colours follow the normals. Along an edge of a triangle these turn by no more than
 * this, in radians, and it is no longer than this, as a part of the picture: more, and the stripes have
 * corners. */
static const double STRIPE_TURN = 0.04, STRIPE_EDGE = 0.01;

typedef struct {
    batten_mesh_options mesh;
    const batten_job *job;
    batten_notes *notes;
    batten_model *made;
} flattening;

static batten_status add_mesh(flattening *f, const batten_object *like,
                              const batten_mesh_parts *parts)
{
    batten_object object = *like;
    batten_mesh *mesh = NULL;
    batten_status status = batten_mesh_create(parts, &mesh);
    object.kind = BATTEN_OBJECT_MESH;
    object.body = NULL;
    object.mesh = mesh;
    if (status == BATTEN_OK)
        status = batten_model_add(f->made, &object);
    batten_mesh_unref(mesh);
    return status;
}

/* ---- bodies by the colours of their faces ---- */

static bool same_colour(const batten_body_face *a, const batten_body_face *b)
{
    return a->has_colour == b->has_colour &&
           (!a->has_colour || (a->colour[0] == b->colour[0] && a->colour[1] == b->colour[1] &&
                               a->colour[2] == b->colour[2]));
}

enum { COLOURS = 256 };

/* The first face of each colour; beyond 256 the rest have that of the last. */
static int find_colours(const batten_body_parts *body, int first[COLOURS], int *colour_of)
{
    int count = 0;
    for (int i = 0; i < body->face_count; i++) {
        int k = 0;
        while (k < count && !same_colour(&body->faces[first[k]], &body->faces[i]))
            k++;
        if (k == count && count < COLOURS)
            first[count++] = i;
        colour_of[i] = bat_min_int(k, count - 1);
    }
    return count;
}

/* The triangles of one colour; the arrays have room for all. */
static batten_status add_colour(flattening *f, const batten_object *object,
                                const batten_mesh_parts *all, const batten_body_face *face,
                                int colour, const int *colour_of, batten_mesh_parts *some)
{
    batten_object like = *object;
    int *corners = (int *)(uintptr_t)some->corners, *faces = (int *)(uintptr_t)some->faces;
    double *normals = (double *)(uintptr_t)some->normals;
    some->triangle_count = 0;
    for (int t = 0; t < all->triangle_count; t++) {
        const size_t to = (size_t)some->triangle_count, from = (size_t)t;
        if (colour_of[all->faces[t]] != colour)
            continue;
        memcpy(corners + 3 * to, all->corners + 3 * from, 3 * sizeof *corners);
        memcpy(normals + 9 * to, all->normals + 9 * from, 9 * sizeof *normals);
        faces[some->triangle_count++] = all->faces[t];
    }
    if (face->has_colour) {
        like.has_colour = true;
        memcpy(like.colour, face->colour, sizeof like.colour);
    }
    return some->triangle_count ? add_mesh(f, &like, some) : BATTEN_OK;
}

static batten_status add_colours(flattening *f, const batten_object *object,
                                 const batten_mesh_parts *all)
{
    const batten_body_parts *body = batten_body_view(object->body);
    const size_t n = (size_t)all->triangle_count;
    int first[COLOURS];
    int *colour_of = bat_array((size_t)body->face_count, sizeof *colour_of);
    int *corners = bat_array3(n, 3, sizeof *corners), *faces = bat_array(n, sizeof *faces);
    double *normals = bat_array3(n, 9, sizeof *normals);
    batten_mesh_parts some = {.vertex_count = all->vertex_count,
                              .points = all->points,
                              .corners = corners,
                              .normals = normals,
                              .faces = faces};
    batten_status status =
        colour_of && corners && faces && normals ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    const int count = status == BATTEN_OK ? find_colours(body, first, colour_of) : 0;
    for (int k = 0; k < count && status == BATTEN_OK; k++)
        status = add_colour(f, object, all, &body->faces[first[k]], k, colour_of, &some);
    bat_release(normals);
    bat_release(faces);
    bat_release(corners);
    bat_release(colour_of);
    return status;
}

static batten_status add_body(flattening *f, const batten_object *object)
{
    batten_mesh_report report = {.failed = 0};
    batten_mesh *mesh = NULL;
    batten_status status =
        batten_mesh_from_body(object->body, &f->mesh, f->job, f->notes, &report, &mesh);
    if (status == BATTEN_OK && report.failed > 0)
        batten_notes_add(f->notes, "", 0, object->name, "%d face%s not drawn", report.failed,
                         bat_one_or_many(report.failed, " is", "s are"));
    if (status == BATTEN_OK)
        status = add_colours(f, object, batten_mesh_view(mesh));
    batten_mesh_unref(mesh);
    return status;
}

/* ---- other objects ---- */

static batten_status add_object(flattening *f, const batten_object *object)
{
    if (object->kind == BATTEN_OBJECT_BODY)
        return add_body(f, object);
    if (object->kind != BATTEN_OBJECT_MESH || !batten_mesh_view(object->mesh)->faces)
        return batten_model_add(f->made, object);
    batten_mesh_parts parts = *batten_mesh_view(object->mesh);
    parts.faces = NULL;
    return add_mesh(f, object, &parts);
}

static bool shows_any(const batten_model *model)
{
    for (int i = 0; i < batten_model_count(model); i++)
        if (!batten_model_object(model, i)->is_hidden)
            return true;
    return false;
}

batten_status bat_picture_model(const batten_model *model, const batten_draw_options *options,
                                const batten_job *job, batten_model **out)
{
    flattening f = {.mesh = batten_mesh_defaults(), .job = job, .notes = options->notes};
    batten_model *flat = NULL;
    batten_box box = {{0, 0, 0}, {0, 0, 0}};
    batten_status status = batten_model_flat(model, &flat);
    if (status == BATTEN_OK)
        status = batten_model_create(batten_model_unit_metres(model), &f.made);
    if (status == BATTEN_OK && batten_model_box(flat, &box)) {
        const double size = bat_box_diagonal(box);
        /* A fifth of a pixel, if the shape filled the picture. */
        f.mesh.chord = 0.2 * size / bat_max_int(options->width, options->height);
        if (options->shading != BATTEN_SHADING_PLAIN &&
            options->shading != BATTEN_SHADING_ISOLINES) {
            f.mesh.angle = STRIPE_TURN;
            f.mesh.longest = STRIPE_EDGE * size;
        }
    }
    const bool all = status == BATTEN_OK && !shows_any(flat);
    for (int i = 0; status == BATTEN_OK && i < batten_model_count(flat); i++)
        if (all || !batten_model_object(flat, i)->is_hidden)
            status = add_object(&f, batten_model_object(flat, i));
    batten_model_unref(flat);
    if (status == BATTEN_OK)
        *out = f.made;
    else
        batten_model_unref(f.made);
    return status;
}
