/*
 * 186, 514, 510, 508: solids, shells and faces that share their edges.
 *
 * A loop runs so that its face is on its left seen against the normal of the surface. The flags
 * of the shell and of the solid say on which side of the surface the outside is; where it is
 * against the normal, the face is reversed and its loops are turned, as a body wants it.
 */
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/loops.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/topology.h"
#include "numeric/box.h"

#include <string.h>

/* A loop going along an edge, as 508 says it. */
typedef struct {
    int edge;
    bool reversed;
    batten_curve *flat;
} use;

typedef struct {
    bat_iges_reading *reading;
    bat_builder *builder;
    bat_iges_ground *ground;
    bat_list uses;  /* of use: all loops, one after another */
    bat_list loops; /* of size_t: how many uses each has */
    bool reversed;
} face_of_solid;

static void end_face(face_of_solid *face)
{
    use *uses = face->uses.items;
    for (size_t k = 0; k < face->uses.count; k++)
        batten_curve_unref(uses[k].flat);
    bat_release(face->uses.items);
    bat_release(face->loops.items);
}

/* Matrices within a solid would move a part of what is shared. */
static batten_status open_part(bat_iges_reading *reading, const bat_iges_entry *entry,
                               bat_iges_item *item)
{
    batten_status status = bat_iges_open(reading, entry, item);
    bat_iges_shape_of(reading, entry)->is_met = true;
    if (status == BATTEN_OK && entry->transform)
        status =
            bat_fail(BATTEN_UNSUPPORTED, "the matrix of D%d, a part, is not read", entry->id);
    return status;
}

/* ---- 508: loops ---- */

/* The curve in (u, v) of the edge, when there is one and it says something. */
static batten_status read_flat(const bat_iges_item *item, face_of_solid *face, size_t at,
                               int count, use *made)
{
    const batten_curve *curve = NULL;
    int id = 0;
    if (count != 1 || !face->ground->has_parameters)
        return BATTEN_OK;
    batten_status status = bat_iges_integer(item->parameters, at + 6, &id);
    if (status == BATTEN_OK && id == 0)
        return BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_iges_curve(face->reading, id, &curve);
    return status == BATTEN_OK
               ? bat_iges_flatten(face->ground, curve,
                                  face->builder->parts.edges[made->edge].curve, &made->flat)
               : status;
}

/* From *at on: TYPE (1: a vertex, as at a pole), list, number, OF, K, then K times ISOP, curve.
 */
static batten_status read_use(const bat_iges_item *item, face_of_solid *face, size_t *at)
{
    int v[4] = {0}, count = 0;
    use made = {0, false, NULL};
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < 4; k++)
        status = bat_iges_integer(item->parameters, *at + k, &v[k]);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, *at + 4, *at + 5, 2, &count);
    if (status == BATTEN_OK && v[0] != 1) {
        status = bat_iges_body_edge(face->reading, face->builder, v[1], v[2], &made.edge);
        made.reversed = v[3] == 0;
        if (status == BATTEN_OK)
            status = read_flat(item, face, *at, count, &made);
        if (status == BATTEN_OK)
            status = bat_list_add(face->reading->input, &face->uses, &made);
        if (status == BATTEN_OK)
            ((size_t *)face->loops.items)[face->loops.count - 1]++;
        else
            batten_curve_unref(made.flat);
    }
    *at += 5 + 2 * (size_t)count;
    return status;
}

static batten_status read_loop(face_of_solid *face, int id)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    const size_t none = 0;
    size_t at = 2;
    int count = 0;
    batten_status status = bat_iges_find_type(face->reading, id, 508, &entry);
    if (status != BATTEN_OK)
        return status;
    status = open_part(face->reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(&item, 1, 2, 5, &count);
    if (status == BATTEN_OK)
        status = bat_list_add(face->reading->input, &face->loops, &none);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = read_use(&item, face, &at);
    bat_iges_close(&item);
    return status == BATTEN_OK ? bat_iges_count_read(face->reading, 508) : status;
}

/* ---- 510: faces ---- */

/* The part of an elementary surface that the edges need. */
static batten_status make_surface(face_of_solid *face, batten_surface **made)
{
    bat_list points = {.size = 3 * sizeof(double)};
    const use *uses = face->uses.items;
    bat_elementary *elementary = &face->ground->elementary;
    bat_around around;
    double error = 0;
    batten_status status = bat_around_begin(elementary, face->ground->tolerance, &around);
    for (size_t k = 0; status == BATTEN_OK && k < face->uses.count; k++) {
        const batten_curve *curve = face->builder->parts.edges[uses[k].edge].curve;
        status = bat_iges_sample(face->reading, curve, &points);
        if (status == BATTEN_OK)
            status = bat_around_add(&around, curve, uses[k].reversed);
    }
    elementary->goes_on = status == BATTEN_OK && bat_around_is_once(&around);
    if (status == BATTEN_OK)
        status = bat_elementary_surface(elementary, (int)points.count, points.items,
                                        face->ground->tolerance, made, &error);
    bat_release(points.items);
    return status;
}

static batten_status put_loops(const face_of_solid *face)
{
    const use *uses = face->uses.items;
    const size_t *counts = face->loops.items;
    batten_status status = BATTEN_OK;
    size_t first = 0;
    for (size_t l = 0; status == BATTEN_OK && l < face->loops.count; l++) {
        if (counts[l] > 0)
            status = bat_builder_loop(face->builder);
        for (size_t k = 0; status == BATTEN_OK && k < counts[l]; k++) {
            const use *u = &uses[first + (face->reversed ? counts[l] - 1 - k : k)];
            status =
                bat_builder_use(face->builder, u->edge, u->reversed != face->reversed, u->flat);
        }
        first += counts[l];
    }
    return status;
}

/* Name and colour of the face, and all of it into the builder. */
static batten_status put_face(bat_iges_item *item, face_of_solid *face)
{
    batten_surface *made = NULL;
    char *name = NULL;
    batten_body_face plain = {.reversed = face->reversed};
    batten_status status = face->ground->is_elementary ? make_surface(face, &made) : BATTEN_OK;
    if (status == BATTEN_OK)
        status = bat_iges_given_name(item, &name);
    if (status == BATTEN_OK)
        status = bat_iges_colour(face->reading, item->entry, &plain.has_colour, plain.colour);
    if (status == BATTEN_OK) {
        plain.name = name;
        plain.surface = made ? made : face->ground->surface;
        status = bat_builder_face(face->builder, &plain);
    }
    if (status == BATTEN_OK)
        status = put_loops(face);
    bat_release(name);
    batten_surface_unref(made);
    return status;
}

static double miss_of(const face_of_solid *face)
{
    const use *uses = face->uses.items;
    double miss = 0;
    for (size_t k = 0; k < face->uses.count; k++)
        miss = bat_max(miss, bat_iges_miss(face->ground,
                                           face->builder->parts.edges[uses[k].edge].curve,
                                           uses[k].flat));
    return miss;
}

/* An open 510: SURF, N, whether the first loop is the outer one, loops. */
static batten_status read_face(bat_iges_item *item, bool agrees, bat_builder *builder)
{
    bat_iges_face plain;
    face_of_solid face = {.reading = item->reading,
                          .builder = builder,
                          .uses = {.size = sizeof(use)},
                          .loops = {.size = sizeof(size_t)},
                          .reversed = !agrees};
    int surface = 0, count = 0, id = 0;
    batten_status status = bat_iges_integer(item->parameters, 1, &surface);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 2, 4, 1, &count);
    if (status != BATTEN_OK)
        return status;
    item->own = 4 + (size_t)count;
    bat_iges_face_begin(item->reading, item->entry, &plain);
    status = bat_iges_set_ground(&plain, surface);
    face.ground = &plain.ground;
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = bat_iges_integer(item->parameters, 4 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = read_loop(&face, id);
    }
    if (status == BATTEN_OK)
        status = put_face(item, &face);
    if (status == BATTEN_OK)
        item->reading->body_miss = bat_max(item->reading->body_miss, miss_of(&face));
    end_face(&face);
    bat_iges_face_end(&plain);
    return status;
}

/* The face of a shell; one that is bad is taken back with a note, and *whole is false. */
static batten_status add_face(bat_iges_reading *reading, int id, bool agrees,
                              bat_builder *builder, bool *whole)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    const int mark = bat_builder_mark(builder);
    batten_status status = bat_iges_find_type(reading, id, 510, &entry);
    if (status != BATTEN_OK)
        return status;
    status = open_part(reading, entry, &item);
    if (status == BATTEN_OK)
        status = read_face(&item, agrees, builder);
    bat_iges_close(&item);
    if (status == BATTEN_OK)
        return bat_iges_count_read(reading, 510);
    if (!bat_iges_is_fault_of_data(status))
        return status;
    bat_builder_back(builder, mark);
    bat_iges_note(reading, entry, "%.300s; the face is left out", batten_message());
    reading->input->left_out++;
    *whole = false;
    return bat_census_leave(reading->input, &reading->census,
                            bat_iges_row_of(reading, 510)->name);
}

/* ---- 514: shells; 186: solids ---- */

/* How many edges between a face that is reversed and one that is not are used both ways, less
 * those that are used the same way twice. `seen` has 0 for each edge. */
static int agreement(const bat_builder *builder, int first_face, int *seen)
{
    const batten_body_parts *p = &builder->parts;
    int sum = 0;
    for (int f = first_face; f < p->face_count; f++)
        for (int l = p->faces[f].first; l < p->faces[f].first + p->faces[f].count; l++)
            for (int i = p->loops[l].first; i < p->loops[l].first + p->loops[l].count; i++) {
                const batten_body_use *u = &p->uses[i];
                /* What the edge was used as: 1 plus its way plus twice the side of the face. */
                const int now = 1 + u->reversed + 2 * p->faces[f].reversed;
                const int before = seen[u->edge];
                seen[u->edge] = now;
                if (before && (before - 1) / 2 != (now - 1) / 2)
                    sum += (before - 1) % 2 != (now - 1) % 2 ? 1 : -1;
            }
    return sum;
}

/* Loops should run around the normals of surfaces, but some programs let them run around the
 * outside of the faces as the shell says it. Edges between faces of both kinds tell. Then those
 * that are against their surface in the shell are to be turned; where the solid has the shell
 * inside out, as for a void, these are the faces that are not reversed in the body. */
static batten_status choose_direction(bat_iges_item *item, bool agrees, bat_builder *builder,
                                      int first_face)
{
    int *seen = NULL;
    batten_status status = bat_input_array(
        item->reading->input, (size_t)builder->parts.edge_count + 1, sizeof *seen, &seen);
    if (status == BATTEN_OK && agreement(builder, first_face, seen) < 0) {
        for (int f = first_face; f < builder->parts.face_count; f++)
            if (builder->parts.faces[f].reversed == agrees)
                bat_builder_turn(builder, f);
        bat_iges_remark(item->reading, item->entry,
                        "its loops run around the outside of the faces, not around the normals "
                        "of their surfaces");
    }
    bat_release(seen);
    return status;
}

/* An open 514: N, then faces and whether each agrees with its surface. */
static batten_status read_faces(bat_iges_item *item, bool agrees, bat_builder *builder,
                                bool *whole)
{
    const int first_face = bat_builder_mark(builder);
    int count = 0;
    batten_status status = bat_iges_read_count(item, 1, 2, 2, &count);
    if (status == BATTEN_OK)
        status = bat_builder_shell(builder, item->entry->form != 2);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        int id = 0, flag = 0;
        status = bat_iges_integer(item->parameters, 2 + 2 * (size_t)k, &id);
        if (status == BATTEN_OK)
            status = bat_iges_integer(item->parameters, 3 + 2 * (size_t)k, &flag);
        if (status == BATTEN_OK)
            status = add_face(item->reading, id, (flag != 0) == agrees, builder, whole);
    }
    if (status == BATTEN_OK)
        status = choose_direction(item, agrees, builder, first_face);
    item->own = 2 + 2 * (size_t)count;
    return status;
}

static batten_status add_shell(bat_iges_reading *reading, int id, bool agrees,
                               bat_builder *builder, bool *whole)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    batten_status status = bat_iges_find_type(reading, id, 514, &entry);
    if (status != BATTEN_OK)
        return status;
    status = open_part(reading, entry, &item);
    if (status == BATTEN_OK)
        status = read_faces(&item, agrees, builder, whole);
    bat_iges_close(&item);
    return status == BATTEN_OK ? bat_iges_count_read(reading, 514) : status;
}

/* The box of all vertices and edges; without any, of the first face. */
static batten_box box_of(const batten_body_parts *parts)
{
    batten_box box = bat_box_of_nothing();
    if (parts->vertex_count == 0)
        return batten_surface_box(parts->faces[0].surface);
    for (int k = 0; k < parts->vertex_count; k++)
        bat_box_join(&box, bat_box_at(parts->vertices + 3 * (size_t)k));
    for (int k = 0; k < parts->edge_count; k++)
        bat_box_join(&box, batten_curve_box(parts->edges[k].curve));
    return box;
}

/* Make the body, with the tolerance that its size allows. A shell that lost a face is not
 * closed any more. */
static batten_status finish(bat_iges_item *item, bat_builder *builder, bool is_solid,
                            bool whole, batten_status status)
{
    if (status == BATTEN_OK && builder->parts.face_count == 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "none of its faces could be read");
    if (status != BATTEN_OK) {
        bat_builder_end(builder);
        return status;
    }
    const double size = bat_iges_size_of_box(box_of(&builder->parts));
    if (isinf(size)) {
        bat_builder_end(builder);
        return bat_fail(BATTEN_OVERFLOW, "its edges reach too far to be measured");
    }
    builder->parts.tolerance = bat_iges_tolerance_of_miss(
        item->reading, bat_iges_tolerance(item->reading, size), item->reading->body_miss, size);
    if (!whole)
        bat_builder_open_shells(builder);
    return bat_builder_finish(builder, is_solid && whole, &item->body);
}

/* SHELL, SOF, N, then voids and their flags. */
batten_status bat_iges_read_solid(bat_iges_item *item)
{
    bat_builder builder;
    int id = 0, flag = 0, count = 0;
    bool whole = true;
    batten_status status = bat_iges_integer(item->parameters, 1, &id);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 2, &flag);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 3, 4, 2, &count);
    if (status != BATTEN_OK)
        return status;
    item->own = 4 + 2 * (size_t)count;
    bat_iges_next_body(item->reading);
    bat_builder_begin(&builder, 1);
    status = add_shell(item->reading, id, flag != 0, &builder, &whole);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = bat_iges_integer(item->parameters, 4 + 2 * (size_t)k, &id);
        if (status == BATTEN_OK)
            status = bat_iges_integer(item->parameters, 5 + 2 * (size_t)k, &flag);
        if (status == BATTEN_OK)
            status = add_shell(item->reading, id, flag != 0, &builder, &whole);
    }
    return finish(item, &builder, true, whole, status);
}

batten_status bat_iges_read_shell(bat_iges_item *item)
{
    bat_builder builder;
    bool whole = true;
    bat_iges_next_body(item->reading);
    bat_builder_begin(&builder, 1);
    batten_status status = read_faces(item, true, &builder, &whole);
    return finish(item, &builder, false, whole, status);
}

batten_status bat_iges_read_face(bat_iges_item *item)
{
    bat_builder builder;
    bat_iges_next_body(item->reading);
    bat_builder_begin(&builder, 1);
    batten_status status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status = read_face(item, true, &builder);
    return finish(item, &builder, false, true, status);
}
