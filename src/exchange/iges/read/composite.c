/* 102: composite curves, and curves in rows. */
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/references.h"

void bat_iges_curves_begin(bat_iges_curves *curves)
{
    *curves = (bat_iges_curves){.at = {.size = sizeof(batten_curve *)}};
}

void bat_iges_curves_end(bat_iges_curves *curves)
{
    batten_curve **at = curves->at.items;
    for (size_t k = 0; k < curves->at.count; k++)
        batten_curve_unref(at[k]);
    bat_release(curves->at.items);
    bat_iges_curves_begin(curves);
}

size_t bat_iges_curves_count(const bat_iges_curves *curves)
{
    return curves->at.count;
}

const batten_curve *bat_iges_curves_at(const bat_iges_curves *curves, size_t index)
{
    return ((batten_curve *const *)curves->at.items)[index];
}

/* Takes the reference over, also on failure. */
static batten_status add_curve(bat_input *input, bat_iges_curves *curves, batten_curve *curve)
{
    batten_status status = bat_list_add(input, &curves->at, &curve);
    if (status != BATTEN_OK)
        batten_curve_unref(curve);
    return status;
}

/* ---- members ---- */

/* Move the curves from `first` on by the matrices of their composite. */
static batten_status move_curves(bat_iges_item *item, bat_iges_curves *curves, size_t first)
{
    batten_affine map;
    batten_curve **at = curves->at.items;
    if (item->entry->transform == 0 || item->entry->use == 5)
        return BATTEN_OK;
    batten_status status = bat_iges_transform(item->reading, item->entry->transform, &map);
    for (size_t k = first; status == BATTEN_OK && k < curves->at.count; k++) {
        batten_curve *moved = NULL;
        status = batten_curve_transform(at[k], &map, &moved);
        if (status == BATTEN_OK) {
            batten_curve_unref(at[k]);
            at[k] = moved;
        }
    }
    return status;
}

/* The members of an open composite, not yet moved with it. Points among them say nothing of its
 * shape. */
static batten_status read_members(bat_iges_item *item, bat_iges_curves *curves)
{
    int count = 0;
    batten_status status = bat_iges_read_count(item, 1, 2, 1, &count);
    if (status == BATTEN_OK && count < 1)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d members", count);
    for (int k = 0; status == BATTEN_OK && k < count; k++) {
        const bat_iges_entry *member = NULL;
        int id = 0;
        status = bat_iges_integer(item->parameters, 2 + (size_t)k, &id);
        if (status == BATTEN_OK)
            status = bat_iges_find(item->reading, id, &member);
        if (status == BATTEN_OK && member->type != 116 && member->type != 132)
            status = bat_iges_members(item->reading, id, curves);
    }
    item->own = 2 + (size_t)(count > 0 ? count : 0);
    return status;
}

static batten_status nested_members(bat_iges_reading *reading, const bat_iges_entry *entry,
                                    bat_iges_curves *curves)
{
    const size_t first = bat_iges_curves_count(curves);
    bat_iges_shape *shape = bat_iges_shape_of(reading, entry);
    bat_iges_item item;
    if (shape->state == BAT_IGES_BUSY)
        return bat_fail(BATTEN_BAD_FORMAT, "entity D%d is a part of itself", entry->id);
    const bat_iges_state before = shape->state;
    shape->state = BAT_IGES_BUSY;
    batten_status status = bat_iges_open(reading, entry, &item);
    if (status == BATTEN_OK)
        status = read_members(&item, curves);
    if (status == BATTEN_OK)
        status = move_curves(&item, curves, first);
    if (status == BATTEN_OK && !shape->is_met && before == BAT_IGES_NEW)
        status = bat_census_read(reading->input, &reading->census, item.row->name);
    shape->is_met = true;
    bat_iges_close(&item);
    shape->state = status == BATTEN_OK || before != BAT_IGES_NEW ? before : BAT_IGES_BAD;
    return status;
}

batten_status bat_iges_members(bat_iges_reading *reading, int id, bat_iges_curves *curves)
{
    const bat_iges_entry *entry = NULL;
    const batten_curve *curve = NULL;
    batten_status status = bat_iges_find(reading, id, &entry);
    if (status == BATTEN_OK && entry->type == 102)
        return nested_members(reading, entry, curves);
    if (status == BATTEN_OK)
        status = bat_iges_curve(reading, id, &curve);
    return status == BATTEN_OK ? add_curve(reading->input, curves, batten_curve_ref(curve))
                               : status;
}

/* ---- one curve of many ---- */

/* Join neighbours, then neighbours of those, until one is left: so each is copied but a few
 * times. */
static batten_status join_all(bat_iges_curves *curves, double tolerance)
{
    batten_curve **at = curves->at.items;
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && curves->at.count > 1) {
        const size_t count = curves->at.count;
        for (size_t k = 0; status == BATTEN_OK && k + 1 < count; k += 2) {
            batten_curve *joined = NULL;
            status = batten_curve_join(at[k], at[k + 1], tolerance, &joined);
            if (status == BATTEN_OK) {
                batten_curve_unref(at[k]);
                at[k] = joined;
            }
        }
        for (size_t k = 1; status == BATTEN_OK && k < count; k++) {
            if (k % 2 == 1)
                batten_curve_unref(at[k]);
            else
                at[k / 2] = at[k];
        }
        if (status == BATTEN_OK)
            curves->at.count = (count + 1) / 2;
    }
    return status;
}

batten_status bat_iges_read_composite(bat_iges_item *item)
{
    bat_iges_curves curves;
    double size = 0;
    bat_iges_curves_begin(&curves);
    batten_status status = read_members(item, &curves);
    const size_t count = bat_iges_curves_count(&curves);
    if (status == BATTEN_OK && count == 0)
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "none of its members is a curve");
    for (size_t k = 0; status == BATTEN_OK && k < count; k++)
        size += bat_iges_size_of_curve(bat_iges_curves_at(&curves, k));
    if (status == BATTEN_OK)
        status = join_all(&curves, bat_iges_tolerance(item->reading, size));
    if (status == BATTEN_OK)
        item->curve = batten_curve_ref(bat_iges_curves_at(&curves, 0));
    bat_iges_curves_end(&curves);
    return status;
}
