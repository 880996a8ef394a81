/*
 * 186, 514, 510, 508: solids, shells and faces that share their edges.
 *
 * A loop runs so that its face is on its left seen against the normal of the surface. The flags
 * of the shell and of the solid say on which side of the surface the outside is; where it is
 * against the normal, the face is reversed and its loops are turned, as a body wants it.
 */
#include "exchange/iges/read/solid.h"
#include "exchange/iges/read/attributes.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/topology.h"
#include "numeric/box.h"

#include <string.h>

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
            status =
                bat_iges_add_face(item->reading, id, (flag != 0) == agrees, builder, whole);
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
    status = bat_iges_open_part(reading, entry, &item);
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
static batten_status finish_body(bat_iges_item *item, bat_builder *builder, bool is_solid,
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
    return finish_body(item, &builder, true, whole, status);
}

batten_status bat_iges_read_shell(bat_iges_item *item)
{
    bat_builder builder;
    bool whole = true;
    bat_iges_next_body(item->reading);
    bat_builder_begin(&builder, 1);
    batten_status status = read_faces(item, true, &builder, &whole);
    return finish_body(item, &builder, false, whole, status);
}

batten_status bat_iges_read_face(bat_iges_item *item)
{
    bat_builder builder;
    bat_iges_next_body(item->reading);
    bat_builder_begin(&builder, 1);
    batten_status status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status = bat_iges_put_face_of(item, true, &builder);
    return finish_body(item, &builder, false, true, status);
}
