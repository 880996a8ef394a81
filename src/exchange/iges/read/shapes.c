/* Entities decoded into curves, surfaces, points and bodies; those that others refer to, once.
 */
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/references.h"

static batten_status move_points(bat_iges_item *item, const batten_affine *map)
{
    for (int i = 0; i < item->point_count; i++) {
        double *p = &item->points[3 * i];
        const batten_vec3 q = batten_affine_apply(*map, (batten_vec3){p[0], p[1], p[2]});
        p[0] = q.x;
        p[1] = q.y;
        p[2] = q.z;
    }
    return BATTEN_OK;
}

/* Move what was made by the matrices of the entry; curves in parameters are not moved. */
static batten_status move_by_matrix(bat_iges_item *item)
{
    batten_affine map;
    batten_curve *curve = NULL;
    batten_surface *surface = NULL;
    batten_body *body = NULL;
    if (item->entry->transform == 0 || item->entry->use == 5)
        return BATTEN_OK;
    batten_status status = bat_iges_transform(item->reading, item->entry->transform, &map);
    if (status != BATTEN_OK)
        return status;
    if (item->curve)
        status = batten_curve_transform(item->curve, &map, &curve);
    else if (item->surface)
        status = batten_surface_transform(item->surface, &map, &surface);
    else if (item->body)
        status = batten_body_transform(item->body, &map, &body);
    else if (item->definition)
        item->place = batten_affine_compose(item->place, map);
    else
        status = move_points(item, &map);
    if (curve) {
        batten_curve_unref(item->curve);
        item->curve = curve;
    }
    if (surface) {
        batten_surface_unref(item->surface);
        item->surface = surface;
    }
    if (body) {
        batten_body_unref(item->body);
        item->body = body;
    }
    return status;
}

batten_status bat_iges_decode(bat_iges_reading *reading, const bat_iges_entry *entry,
                              bat_iges_item *item)
{
    batten_status status = bat_iges_open(reading, entry, item);
    if (status == BATTEN_OK && !item->row->read)
        status = bat_fail(BATTEN_UNSUPPORTED, "entities of this type are not read");
    /* The forms of curves and surfaces often say what the shape happens to be. */
    if (status == BATTEN_OK && (entry->form < item->row->low || entry->form > item->row->high))
        status = bat_fail(BATTEN_UNSUPPORTED, "its form %d is not read", entry->form);
    if (status == BATTEN_OK)
        status = item->row->read(item);
    return status == BATTEN_OK ? move_by_matrix(item) : status;
}

/* Decode a curve or surface that others refer to, once. */
static batten_status decode_once(bat_iges_reading *reading, const bat_iges_entry *entry)
{
    bat_iges_shape *shape = bat_iges_shape_of(reading, entry);
    bat_iges_item item;
    if (shape->state == BAT_IGES_BUSY)
        return bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a part of itself", entry->id);
    if (shape->state == BAT_IGES_BAD)
        return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d, which cannot be read",
                        entry->id);
    if (shape->state == BAT_IGES_READ)
        return BATTEN_OK;
    shape->state = BAT_IGES_BUSY;
    batten_status status = bat_iges_decode(reading, entry, &item);
    if (status == BATTEN_OK) {
        shape->curve = item.curve ? batten_curve_ref(item.curve) : NULL;
        shape->surface = item.surface ? batten_surface_ref(item.surface) : NULL;
        status = bat_census_read(reading->input, &reading->census, item.row->name);
    }
    bat_iges_close(&item);
    shape->state = status == BATTEN_OK ? BAT_IGES_READ : BAT_IGES_BAD;
    return status;
}

static batten_status refuse_kind(const bat_iges_reading *reading, const bat_iges_entry *entry,
                                 bat_iges_kind kind)
{
    char name[BAT_IGES_TYPE_NAME];
    bat_iges_name_of_type(reading, entry->type, name);
    return bat_fail(BATTEN_BAD_FORMAT, "it refers to entity D%d as a %s, which is a %s",
                    entry->id, kind == BAT_IGES_CURVE ? "curve" : "surface", name);
}

/* An entry of a kind, decoded. */
static batten_status keep_kind(bat_iges_reading *reading, int id, bat_iges_kind kind,
                               const bat_iges_shape **out)
{
    const bat_iges_entry *entry = NULL;
    batten_status status = bat_iges_find(reading, id, &entry);
    if (status != BATTEN_OK)
        return status;
    if (bat_iges_row_of(reading, entry->type)->kind != kind)
        return refuse_kind(reading, entry, kind);
    status = decode_once(reading, entry);
    if (status == BATTEN_OK)
        *out = bat_iges_shape_of(reading, entry);
    return status;
}

batten_status bat_iges_curve(bat_iges_reading *reading, int id, const batten_curve **out)
{
    const bat_iges_shape *shape = NULL;
    batten_status status = keep_kind(reading, id, BAT_IGES_CURVE, &shape);
    if (status == BATTEN_OK && !shape->curve)
        status = bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a set of points, not a curve", id);
    if (status == BATTEN_OK)
        *out = shape->curve;
    return status;
}

batten_status bat_iges_surface(bat_iges_reading *reading, int id, const batten_surface **out)
{
    const bat_iges_shape *shape = NULL;
    batten_status status = keep_kind(reading, id, BAT_IGES_SURFACE, &shape);
    if (status == BATTEN_OK && !shape->surface)
        status = bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a face, not a surface", id);
    if (status == BATTEN_OK)
        *out = shape->surface;
    return status;
}
