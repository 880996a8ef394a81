/* 3DFACE entities gathered into meshes. */
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/filling.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

/* ---- faces ---- */

batten_status bat_dxf_flush_faces(bat_dxf_filling *f)
{
    const size_t corners = f->faces.count * 3;
    batten_mesh *loose = NULL, *mesh = NULL;
    if (corners == 0)
        return BATTEN_OK;
    int *order = bat_array(corners, sizeof *order);
    if (!order)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < corners; i++)
        order[i] = (int)i;
    const batten_mesh_parts parts = {.vertex_count = (int)corners,
                                     .points = f->faces.items,
                                     .triangle_count = (int)f->faces.count,
                                     .corners = order};
    batten_status status = batten_mesh_create(&parts, &loose);
    if (status == BATTEN_OK)
        status = batten_mesh_weld(loose, &mesh);
    f->face_look.mesh = mesh;
    if (status == BATTEN_OK)
        status = bat_dxf_add_object(f, &f->face_look, &f->face_part);
    batten_mesh_unref(loose);
    batten_mesh_unref(mesh);
    bat_release(order);
    f->faces.count = 0;
    return status;
}

static bool looks_same(const batten_object *a, const batten_object *b)
{
    return strcmp(a->layer, b->layer) == 0 && a->is_hidden == b->is_hidden &&
           a->has_colour == b->has_colour &&
           memcmp(a->colour, b->colour, sizeof a->colour) == 0;
}

batten_status bat_dxf_add_face(bat_dxf_filling *f)
{
    char layer_name[BAT_DXF_NAME];
    double corners[4][3];
    int count = 0;
    batten_object look = {.kind = BATTEN_OBJECT_MESH};
    batten_status status = bat_dxf_read_face(&f->pairs, corners, &count);
    if (status != BATTEN_OK)
        return status;
    bat_dxf_read_look(f, layer_name, &look);
    if (f->faces.count > 0 &&
        (!looks_same(&f->face_look, &look) || f->face_part.source != f->part.source))
        status = bat_dxf_flush_faces(f);
    if (status == BATTEN_OK && f->faces.count == 0) {
        snprintf(f->face_name, sizeof f->face_name, "3DFACE %d", ++f->r->number);
        memcpy(f->face_layer, layer_name, sizeof layer_name);
        f->face_look = look;
        f->face_look.name = f->face_name;
        f->face_look.layer = f->part.is_on_zero ? "" : f->face_layer;
        f->face_part = f->part;
    }
    for (int i = 1; status == BATTEN_OK && i + 1 < count; i++) {
        double triangle[9];
        memcpy(triangle, corners[0], sizeof corners[0]);
        memcpy(triangle + 3, corners[i], sizeof corners[0]);
        memcpy(triangle + 6, corners[i + 1], sizeof corners[0]);
        status = bat_list_add(f->r->input, &f->faces, triangle);
    }
    if (status == BATTEN_OK && f->faces.count > INT_MAX / 4)
        status = bat_fail(BATTEN_TOO_LARGE, "more than %d faces", INT_MAX / 4);
    return status;
}
