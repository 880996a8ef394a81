/* 141, 142, 143, 144: surfaces with boundaries; 108: bounded planes. Each is a body of one
 * face. */
#include "base/plural.h"
#include "exchange/iges/read/bodies.h"
#include "exchange/iges/read/loops.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/surfaces.h"

/* ---- loops ---- */

/* 142: CRTN, SURF, BPTR, CPTR, PREF. */
static batten_status read_curve_on_surface(bat_iges_face *face, int id)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_curves space, flat;
    bat_iges_item item;
    int in_plane = 0, in_space = 0;
    batten_status status = bat_iges_find_type(face->reading, id, 142, &entry);
    if (status != BATTEN_OK)
        return status;
    bat_iges_curves_begin(&space);
    bat_iges_curves_begin(&flat);
    status = bat_iges_open(face->reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item.parameters, 3, &in_plane);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item.parameters, 4, &in_space);
    if (status == BATTEN_OK && in_plane == 0 && in_space == 0)
        status = bat_fail(BATTEN_BAD_FORMAT, "its boundary D%d has no curve", id);
    if (status == BATTEN_OK && in_space != 0)
        status = bat_iges_members(face->reading, in_space, &space);
    if (status == BATTEN_OK && in_plane != 0 && (face->ground.has_parameters || in_space == 0))
        status = bat_iges_members(face->reading, in_plane, &flat);
    if (status == BATTEN_OK)
        status = bat_iges_add_loop(face);
    if (status == BATTEN_OK)
        status = bat_iges_add_sides(face, &space, &flat, 0);
    if (status == BATTEN_OK)
        status = bat_iges_count_read(face->reading, 142);
    bat_iges_close(&item);
    bat_iges_curves_end(&flat);
    bat_iges_curves_end(&space);
    return status;
}

/* From parameter *at on: CRV, SENSE, K, and K curves in (u, v). */
static batten_status read_boundary_curve(bat_iges_face *face, const bat_iges_item *item,
                                         size_t *at)
{
    bat_iges_curves space, flat;
    int id = 0, sense = 0, count = 0;
    batten_status status = bat_iges_integer(item->parameters, *at, &id);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, *at + 1, &sense);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, *at + 2, *at + 3, 1, &count);
    if (status != BATTEN_OK)
        return status;
    bat_iges_curves_begin(&space);
    bat_iges_curves_begin(&flat);
    status = bat_iges_members(face->reading, id, &space);
    for (int k = 0; status == BATTEN_OK && k < count && face->ground.has_parameters; k++) {
        int plane = 0;
        status = bat_iges_integer(item->parameters, *at + 3 + (size_t)k, &plane);
        if (status == BATTEN_OK)
            status = bat_iges_members(face->reading, plane, &flat);
    }
    if (status == BATTEN_OK)
        status = bat_iges_add_sides(face, &space, &flat, sense == 2 ? -1 : 1);
    *at += 3 + (size_t)count;
    bat_iges_curves_end(&flat);
    bat_iges_curves_end(&space);
    return status;
}

/* 141: TYPE, PREF, SURF, N, then each curve. */
static batten_status read_boundary(bat_iges_face *face, int id)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_item item;
    int count = 0;
    size_t at = 5;
    batten_status status = bat_iges_find_type(face->reading, id, 141, &entry);
    if (status != BATTEN_OK)
        return status;
    status = bat_iges_open(face->reading, entry, &item);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(&item, 4, 5, 3, &count);
    if (status == BATTEN_OK && count < 1)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "its boundary D%d has %d curve%s", id, count,
                          bat_plural(count));
    if (status == BATTEN_OK)
        status = bat_iges_add_loop(face);
    for (int k = 0; status == BATTEN_OK && k < count; k++)
        status = read_boundary_curve(face, &item, &at);
    if (status == BATTEN_OK)
        status = bat_iges_count_read(face->reading, 141);
    bat_iges_close(&item);
    return status;
}

/* ---- faces ---- */

/* The body of a face whose loops are all there. */
static batten_status make_body(bat_iges_item *item, bat_iges_face *face, bool border)
{
    bat_builder builder;
    bat_builder_begin(&builder, 1);
    batten_status status = bat_builder_shell(&builder, false);
    if (status == BATTEN_OK)
        status = bat_iges_make_face(face, border, &builder);
    builder.parts.tolerance = face->ground.tolerance;
    if (status == BATTEN_OK)
        return bat_builder_finish(&builder, false, &item->body);
    bat_builder_end(&builder);
    return status;
}

/* SURF, N1, N2, the outer boundary, N2 inner ones; N1 is 0 when the outer one is that of the
 * surface. */
batten_status bat_iges_read_trimmed(bat_iges_item *item)
{
    bat_iges_face face;
    int surface = 0, outer = 0, count = 0, id = 0;
    batten_status status = bat_iges_integer(item->parameters, 1, &surface);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 2, &outer);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 3, 5, 1, &count);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 4, &id);
    if (status != BATTEN_OK)
        return status;
    item->own = 5 + (size_t)count;
    bat_iges_face_begin(item->reading, item->entry, &face);
    status = bat_iges_set_ground(&face, surface);
    const bool border = outer == 0 || id == 0;
    if (status == BATTEN_OK && border && face.ground.is_elementary)
        status = bat_fail(BATTEN_BAD_FORMAT, "its surface D%d has no border", surface);
    if (status == BATTEN_OK && !border)
        status = read_curve_on_surface(&face, id);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = bat_iges_integer(item->parameters, 5 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = read_curve_on_surface(&face, id);
    }
    if (status == BATTEN_OK)
        status = make_body(item, &face, border);
    bat_iges_face_end(&face);
    return status;
}

/* TYPE, SURF, N, boundaries. */
batten_status bat_iges_read_bounded(bat_iges_item *item)
{
    bat_iges_face face;
    int surface = 0, count = 0, id = 0;
    batten_status status = bat_iges_integer(item->parameters, 2, &surface);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 3, 4, 1, &count);
    if (status == BATTEN_OK && count < 1)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d boundaries", count);
    if (status != BATTEN_OK)
        return status;
    item->own = 4 + (size_t)count;
    bat_iges_face_begin(item->reading, item->entry, &face);
    status = bat_iges_set_ground(&face, surface);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        status = bat_iges_integer(item->parameters, 4 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = read_boundary(&face, id);
    }
    if (status == BATTEN_OK)
        status = make_body(item, &face, false);
    bat_iges_face_end(&face);
    return status;
}

/* 108 form 1: the part of the plane that the closed curve PTR bounds. Its own matrix moves what
 * is made, so the plane is taken as it stands in the parameters. */
batten_status bat_iges_read_plane(bat_iges_item *item)
{
    bat_iges_face face;
    bat_iges_curves space, flat;
    double equation[4];
    int id = 0;
    if (item->entry->form == 0)
        return bat_fail(BATTEN_UNSUPPORTED, "a plane without bounds");
    batten_status status = bat_iges_reals(item->parameters, 1, 4, equation);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 5, &id);
    if (status != BATTEN_OK)
        return status;
    item->own = 10;
    bat_iges_face_begin(item->reading, item->entry, &face);
    bat_iges_curves_begin(&space);
    bat_iges_curves_begin(&flat);
    face.ground.is_elementary = true;
    status = bat_iges_plane_of(equation, &face.ground.elementary);
    if (status == BATTEN_OK)
        status = bat_iges_members(item->reading, id, &space);
    if (status == BATTEN_OK)
        status = bat_iges_add_loop(&face);
    if (status == BATTEN_OK)
        status = bat_iges_add_sides(&face, &space, &flat, 0);
    if (status == BATTEN_OK)
        status = make_body(item, &face, false);
    bat_iges_curves_end(&flat);
    bat_iges_curves_end(&space);
    bat_iges_face_end(&face);
    return status;
}
