/* Surfaces, Bezier triangles and bodies as meshes, for formats that hold nothing else. */
#include "model/as_meshes.h"
#include "base/list.h"
#include "base/plural.h"
#include "base/work.h"
#include "model/addresses.h"
#include "model/object_notes.h"
#include "model/rebuild.h"

#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <string.h>

/* What became of a shape; copies of a definition share theirs. */
typedef struct {
    const batten_model *of; /* the definition */
    const char *name;       /* of its object */
    batten_mesh *mesh;      /* NULL: it cannot be meshed */
} meshed_shape;

/* The triangles of a shape, made before anything is said about them. */
typedef struct {
    const batten_object *object; /* the first that has it */
    batten_status status;
    char message[512]; /* of a failure */
    batten_mesh *mesh;
    batten_mesh_report report;
    batten_notes *said; /* about faces of a body */
} made_triangles;

typedef struct {
    unsigned kinds; /* that become meshes */
    double unit_metres;
    batten_mesh_options options;
    int left;            /* of options.most, by the objects before */
    char too_large[512]; /* what is said of the first that alone is; "" */
    const batten_job *job;
    batten_notes *notes;
    bat_addresses places; /* the number in `made` of a surface, triangles or a body */
    made_triangles *made;
    size_t made_count, made_room;
    atomic_llong finished;   /* triangles of them so far */
    bat_addresses addresses; /* the number in `done` of a surface, triangles or a body */
    meshed_shape *done;
    size_t count, capacity;
} meshing;

/* What is not farther than that from the shape may lie on it. */
static double rounding(const batten_mesh *mesh)
{
    const batten_box box = batten_mesh_box(mesh);
    const double ends[6] = {box.low.x,  box.low.y,  box.low.z,
                            box.high.x, box.high.y, box.high.z};
    double size = 0;
    for (int k = 0; k < 6; k++)
        size = fmax(size, fabs(ends[k]));
    return 8 * DBL_EPSILON * size;
}

/* How near the triangles are, and why no nearer when that is not what was asked. */
static void say_chord(const batten_object *object, const batten_mesh_report *report,
                      const batten_mesh *mesh, batten_notes *notes)
{
    const int count = batten_mesh_view(mesh)->triangle_count;
    if (report->chord > rounding(mesh))
        batten_notes_remark(notes, "", 0, object->name,
                            "approximated within %g by %d triangles", report->chord, count);
    else if (count > 0)
        batten_notes_remark(notes, "", 0, object->name,
                            "meshed exactly by %d triangles, as far as was measured", count);
    if (report->beyond > 0 && report->error > 0.5 * report->asked)
        batten_notes_add(notes, "", 0, object->name,
                         "the chord of %g is not met: %d of %d triangles are up to %g from the "
                         "shape, for edges are up to %g off their faces there",
                         report->asked, report->beyond, count, report->chord, report->error);
    else if (report->beyond > 0)
        batten_notes_add(notes, "", 0, object->name,
                         "the chord of %g is not met: %d of %d triangles are up to %g from the "
                         "shape and could not be divided",
                         report->asked, report->beyond, count, report->chord);
}

static const void *shape_of(const batten_object *object)
{
    return object->surface     ? (const void *)object->surface
           : object->triangles ? (const void *)object->triangles
                               : (const void *)object->body;
}

/* What ends all work, and not that on one object alone. */
static bool is_final(batten_status status)
{
    return status == BATTEN_OUT_OF_MEMORY || status == BATTEN_CANCELLED ||
           status == BATTEN_INCOMPLETE;
}

/* ---- triangles of all shapes, on the threads of the job ---- */

static batten_status list_shape(void *context, const batten_model *from, int index,
                                batten_model *made, const batten_object *object)
{
    meshing *m = context;
    if (!(m->kinds & 1u << object->kind) ||
        bat_addresses_find(&m->places, shape_of(object)) >= 0)
        return batten_model_add(made, object);
    batten_status status = BAT_LIST_GROW(m->made, m->made_count, m->made_room, 1);
    if (status == BATTEN_OK)
        status = bat_addresses_add(&m->places, shape_of(object), (int)m->made_count);
    if (status == BATTEN_OK)
        m->made[m->made_count++] = (made_triangles){.object = batten_model_object(from, index)};
    return status == BATTEN_OK ? batten_model_add(made, object) : status;
}

static batten_status make_triangles(void *context, const batten_job *job, size_t index)
{
    meshing *m = context;
    made_triangles *t = &m->made[index];
    const batten_object *object = t->object;
    /* Shapes are begun in their order: those that are finished are refused before this one is asked for. */
    if (atomic_load(&m->finished) > m->options.most) {
        t->status = BATTEN_TOO_LARGE;
        return BATTEN_OK;
    }
    if (object->kind == BATTEN_OBJECT_SURFACE)
        t->status =
            batten_mesh_from_surface(object->surface, &m->options, job, &t->report, &t->mesh);
    else if (object->kind == BATTEN_OBJECT_TRIANGLES)
        t->status = batten_mesh_from_triangles(object->triangles, &m->options, job, &t->report,
                                               &t->mesh);
    else {
        t->status = batten_notes_create(INT_MAX, &t->said);
        if (t->status == BATTEN_OK)
            t->status = batten_mesh_from_body(object->body, &m->options, job, t->said,
                                              &t->report, &t->mesh);
    }
    if (t->status != BATTEN_OK)
        snprintf(t->message, sizeof t->message, "%s", batten_message());
    else
        atomic_fetch_add(&m->finished, batten_mesh_view(t->mesh)->triangle_count);
    return is_final(t->status) ? t->status : BATTEN_OK;
}

/* Each shape once, whatever stands for it in how many copies. */
static batten_status make_all_triangles(const batten_model *model, meshing *m)
{
    batten_model *listed = NULL;
    batten_status status =
        bat_model_change(model, batten_model_unit_metres(model), 1, list_shape, m, &listed);
    if (status == BATTEN_OK)
        status =
            bat_parallel_long(m->job, m->made_count, "triangles of shapes", make_triangles, m);
    batten_model_unref(listed);
    return status;
}

static void release_triangles(meshing *m)
{
    for (size_t i = 0; i < m->made_count; i++) {
        batten_mesh_unref(m->made[i].mesh);
        batten_notes_free(m->made[i].said);
    }
    bat_release(m->made);
    bat_addresses_end(&m->places);
}

/* ---- one object ---- */

/* The shape of one object as a mesh. Notes about faces become notes about the object. */
static batten_status mesh_shape(const batten_object *object, meshing *m, batten_mesh **out)
{
    const made_triangles *t = &m->made[bat_addresses_find(&m->places, shape_of(object))];
    const batten_mesh_report report = t->report;
    if (t->said)
        bat_object_notes(t->said, object->name, m->unit_metres, m->notes);
    if (t->status != BATTEN_OK)
        return bat_fail(t->status, "%s", t->message);
    say_chord(object, &report, t->mesh, m->notes);
    if (report.failed > 0)
        batten_notes_add(m->notes, "", 0, object->name, "faces left out of the mesh: %d",
                         report.failed);
    if (report.failed > 0 && batten_mesh_view(t->mesh)->triangle_count == 0)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "its %d face%s cannot be", report.failed,
                        bat_plural(report.failed));
    *out = batten_mesh_ref(t->mesh);
    return BATTEN_OK;
}

static batten_status keep_shape(meshing *m, const void *address, const meshed_shape *shape)
{
    batten_status status = BAT_LIST_GROW(m->done, m->count, m->capacity, 1);
    if (status == BATTEN_OK)
        status = bat_addresses_add(&m->addresses, address, (int)m->count);
    if (status == BATTEN_OK)
        m->done[m->count++] = *shape;
    return status;
}

/* What a face looks like. Without a colour it is light grey among those that have one. */
static void colour_of(const batten_object *object, const batten_body_face *face,
                      double colour[3])
{
    static const double grey[3] = {0.8, 0.8, 0.8};
    memcpy(colour,
           face->has_colour     ? face->colour
           : object->has_colour ? object->colour
                                : grey,
           sizeof grey);
}

static bool has_one_colour(const batten_object *object, const batten_body_parts *parts)
{
    double first[3], other[3];
    for (int i = 0; i < parts->face_count; i++) {
        colour_of(object, &parts->faces[i], i ? other : first);
        if (i && memcmp(first, other, sizeof first) != 0)
            return false;
    }
    return true;
}

static batten_status colour_triangles(const batten_object *object, batten_mesh **mesh)
{
    batten_mesh_parts parts = *batten_mesh_view(*mesh);
    double *colours = bat_array3((size_t)parts.triangle_count, 3, sizeof *colours);
    batten_mesh *made = NULL;
    if (!colours)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < (size_t)parts.triangle_count; i++)
        colour_of(object, &batten_body_view(object->body)->faces[parts.faces[i]],
                  colours + 3 * i);
    parts.triangle_colours = colours;
    const batten_status status = batten_mesh_create(&parts, &made);
    bat_release(colours);
    if (status == BATTEN_OK) {
        batten_mesh_unref(*mesh);
        *mesh = made;
    }
    return status;
}

/* Faces that all look the same give the object its colour, others their triangles. */
static batten_status take_colours(const batten_object *object, batten_object *meshed,
                                  batten_mesh **mesh)
{
    if (object->kind != BATTEN_OBJECT_BODY)
        return BATTEN_OK;
    const batten_body_parts *parts = batten_body_view(object->body);
    bool any = false;
    for (int i = 0; i < parts->face_count; i++)
        any |= parts->faces[i].has_colour;
    if (!any)
        return BATTEN_OK;
    if (!has_one_colour(object, parts))
        return colour_triangles(object, mesh);
    meshed->has_colour = true;
    colour_of(object, &parts->faces[0], meshed->colour);
    return BATTEN_OK;
}

/* Note that the shape is left out. One that needs more triangles than are allowed for all may
 * be damaged, and the others are not. */
static void leave_out(meshing *m, const batten_object *object, batten_status status)
{
    batten_notes_add(m->notes, "", 0, object->name, "left out, as this %s cannot be meshed: %s",
                     batten_object_kind_name(object->kind), batten_message());
    if (status == BATTEN_TOO_LARGE && !*m->too_large)
        snprintf(m->too_large, sizeof m->too_large, "%.*s", (int)sizeof m->too_large - 1,
                 batten_message());
}

/* Each alone may have what is allowed for all. */
static batten_status count_triangles(meshing *m, const batten_object *object,
                                     const batten_mesh *mesh)
{
    const int count = batten_mesh_view(mesh)->triangle_count;
    if (count > m->left)
        return bat_fail(BATTEN_TOO_LARGE,
                        "the shapes up to '%.60s' have more than the %d triangles that are "
                        "allowed for all",
                        object->name, m->options.most);
    m->left -= count;
    return BATTEN_OK;
}

/* The mesh of the object's shape, which may be that of the same object in a copy of the
 * definition; NULL, with a note, when there is none. */
static batten_status find_mesh(meshing *m, const batten_model *of, const batten_object *object,
                               batten_mesh **mesh)
{
    const void *address = shape_of(object);
    const int found = bat_addresses_find(&m->addresses, address);
    const meshed_shape *before = found < 0 ? NULL : &m->done[found];
    if (before && before->of != of && strcmp(before->name, object->name) == 0) {
        *mesh = before->mesh ? batten_mesh_ref(before->mesh) : NULL;
        return BATTEN_OK;
    }
    meshed_shape shape = {.of = of, .name = object->name};
    batten_status status = mesh_shape(object, m, &shape.mesh);
    if (status == BATTEN_OK) {
        status = count_triangles(m, object, shape.mesh);
    } else if (!is_final(status)) {
        leave_out(m, object, status);
        status = BATTEN_OK;
    }
    if (status == BATTEN_OK && !before)
        status = keep_shape(m, address, &shape);
    if (status == BATTEN_OK && shape.mesh)
        *mesh = before ? shape.mesh : batten_mesh_ref(shape.mesh);
    else if (status != BATTEN_OK)
        batten_mesh_unref(shape.mesh);
    return status;
}

static batten_status add_meshed(void *context, const batten_model *from, int index,
                                batten_model *made, const batten_object *object)
{
    (void)index;
    meshing *m = context;
    batten_mesh *mesh = NULL;
    batten_object meshed = *object;
    if (!(m->kinds & 1u << object->kind))
        return batten_model_add(made, object);
    batten_status status = find_mesh(m, from, object, &mesh);
    if (status != BATTEN_OK || !mesh)
        return status;
    meshed.kind = BATTEN_OBJECT_MESH;
    meshed.surface = NULL;
    meshed.triangles = NULL;
    meshed.body = NULL;
    status = take_colours(object, &meshed, &mesh);
    meshed.mesh = mesh;
    if (status == BATTEN_OK)
        status = batten_model_add(made, &meshed);
    batten_mesh_unref(mesh);
    return status;
}

batten_status bat_model_meshed(const batten_model *model, unsigned kinds,
                               const batten_mesh_options *options, const batten_job *job,
                               batten_notes *notes, batten_model **out)
{
    const batten_mesh_options chosen = options ? *options : batten_mesh_defaults();
    meshing m = {.kinds = kinds,
                 .unit_metres = batten_model_unit_metres(model),
                 .options = chosen,
                 .left = chosen.most,
                 .job = job,
                 .notes = notes};
    batten_model *made = NULL;
    batten_status status = make_all_triangles(model, &m);
    if (status == BATTEN_OK)
        status =
            bat_model_change(model, batten_model_unit_metres(model), 1, add_meshed, &m, &made);
    bool any = false;
    for (size_t i = 0; i < m.count; i++) {
        any = any || m.done[i].mesh;
        batten_mesh_unref(m.done[i].mesh);
    }
    if (status == BATTEN_OK && !any && *m.too_large)
        status = bat_fail(BATTEN_TOO_LARGE, "%s", m.too_large);
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_model_unref(made);
    release_triangles(&m);
    bat_release(m.done);
    bat_addresses_end(&m.addresses);
    return status;
}

batten_status batten_model_meshed(const batten_model *model, const batten_mesh_options *options,
                                  const batten_job *job, batten_notes *notes,
                                  batten_model **out)
{
    batten_mesh_options chosen = batten_mesh_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_mesh_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    return bat_model_meshed(model, BAT_SHAPES, &chosen, job, notes, out);
}
