/* Gathers the curves of the loops of a face, in space and on its surface. */
#include "exchange/iges/read/loops.h"
#include "body/trace/lift.h"
#include "exchange/iges/read/references.h"
#include "exchange/iges/read/surfaces.h"

#include <string.h>

void bat_iges_face_begin(bat_iges_reading *reading, const bat_iges_entry *entry,
                         bat_iges_face *face)
{
    *face = (bat_iges_face){
        .reading = reading, .entry = entry, .loops = {.size = sizeof(bat_iges_loop)}};
}

void bat_iges_face_end(bat_iges_face *face)
{
    bat_iges_loop *loops = face->loops.items;
    for (size_t k = 0; k < face->loops.count; k++) {
        bat_iges_side *sides = loops[k].sides.items;
        for (size_t i = 0; i < loops[k].sides.count; i++) {
            batten_curve_unref(sides[i].space);
            batten_curve_unref(sides[i].flat);
        }
        bat_release(loops[k].sides.items);
    }
    bat_release(face->loops.items);
    if (face->ground.chart)
        bat_chart_end(face->ground.chart);
    bat_release(face->ground.chart);
    face->ground.chart = NULL;
    face->loops = (bat_list){.size = sizeof(bat_iges_loop)};
}

/* The parameters of surfaces of revolution and of extrusion are not the same everywhere. */
batten_status bat_iges_set_ground(bat_iges_face *face, int id)
{
    const bat_iges_entry *entry = NULL;
    bat_iges_ground *ground = &face->ground;
    batten_status status = bat_iges_find(face->reading, id, &entry);
    if (status != BATTEN_OK)
        return status;
    ground->is_elementary = bat_iges_is_elementary(entry->type);
    ground->has_parameters = !ground->is_elementary && entry->type != 120 && entry->type != 122;
    if (ground->is_elementary)
        return bat_iges_elementary(face->reading, entry, &ground->elementary);
    status = bat_iges_surface(face->reading, id, &ground->surface);
    if (status == BATTEN_OK)
        ground->tolerance = bat_iges_tolerance(
            face->reading, bat_iges_size_of_box(batten_surface_box(ground->surface)));
    return status;
}

batten_status bat_iges_add_loop(bat_iges_face *face)
{
    const bat_iges_loop loop = {.sides = {.size = sizeof(bat_iges_side)}};
    return bat_list_add(face->reading->input, &face->loops, &loop);
}

/* ---- both families of curves ---- */

static batten_status at_share(const batten_curve *curve, double share, double p[3])
{
    const batten_interval domain = batten_curve_domain(curve);
    return batten_curve_evaluate(
        curve, share < 1 ? domain.a + share * (domain.b - domain.a) : domain.b, 0, p);
}

static double distance(const double a[3], const double b[3])
{
    const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

/* Does the plane curve run against the one in space? Where it leaves the domain it says
 * nothing. */
static bool runs_against(const batten_surface *surface, const batten_curve *flat,
                         const batten_curve *space)
{
    static const double shares[] = {0, 0.2, 0.8, 1};
    const batten_interval u = batten_surface_domain(surface, BATTEN_U),
                          v = batten_surface_domain(surface, BATTEN_V);
    double along = 0, against = 0;
    for (int k = 0; k < 4; k++) {
        double b[3], s[3], c[3], d[3];
        if (at_share(flat, shares[k], b) != BATTEN_OK ||
            at_share(space, shares[k], c) != BATTEN_OK ||
            at_share(space, 1 - shares[k], d) != BATTEN_OK)
            return false;
        if (batten_surface_evaluate(surface, bat_min(bat_max(b[0], u.a), u.b),
                                    bat_min(bat_max(b[1], v.a), v.b), 0, s) != BATTEN_OK)
            return false;
        along += distance(s, c);
        against += distance(s, d);
    }
    return against < along / 2;
}

batten_status bat_iges_flatten(const bat_iges_ground *ground, const batten_curve *curve,
                               const batten_curve *space, batten_curve **out)
{
    batten_curve *plane = NULL;
    batten_status status = batten_curve_to_dimension(curve, 2, &plane);
    if (status == BATTEN_OK && space && runs_against(ground->surface, plane, space)) {
        status = batten_curve_reverse(plane, out);
        batten_curve_unref(plane);
        return status;
    }
    if (status == BATTEN_OK)
        *out = plane;
    return status;
}

static batten_status add_side(bat_iges_face *face, batten_curve *space, batten_curve *flat,
                              bool reversed)
{
    bat_iges_loop *loops = face->loops.items;
    const bat_iges_side side = {space, flat, reversed};
    batten_status status =
        bat_list_add(face->reading->input, &loops[face->loops.count - 1].sides, &side);
    if (status != BATTEN_OK) {
        batten_curve_unref(space);
        batten_curve_unref(flat);
    }
    return status;
}

/* A side that has its curve in (u, v) alone. */
static batten_status add_lifted(bat_iges_face *face, const batten_curve *curve, int said)
{
    const bat_iges_ground *ground = &face->ground;
    batten_curve *flat = NULL, *space = NULL;
    double error = 0;
    if (!ground->has_parameters)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "an edge has a curve in (u, v) alone, on a surface whose parameters "
                        "differ between programs");
    batten_status status = bat_iges_flatten(ground, curve, NULL, &flat);
    if (status == BATTEN_OK)
        status = bat_lift(ground->surface, flat, ground->tolerance, &space, &error);
    if (status == BATTEN_OK)
        return add_side(face, space, flat, said < 0);
    batten_curve_unref(flat);
    return status;
}

batten_status bat_iges_add_sides(bat_iges_face *face, const bat_iges_curves *space,
                                 const bat_iges_curves *flat, int said)
{
    const size_t count = bat_iges_curves_count(space), flats = bat_iges_curves_count(flat);
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && count == 0 && k < flats; k++)
        status = add_lifted(face, bat_iges_curves_at(flat, k), said);
    for (size_t k = 0; status == BATTEN_OK && k < count; k++) {
        const batten_curve *curve = bat_iges_curves_at(space, k);
        batten_curve *plane = NULL;
        /* They belong together one by one; else they are left to be found again. */
        if (flats == count)
            status =
                bat_iges_flatten(&face->ground, bat_iges_curves_at(flat, k), curve, &plane);
        if (status == BATTEN_OK)
            status = add_side(face, batten_curve_ref(curve), plane, said < 0);
    }
    return status;
}

enum { SAMPLES = 9 };

batten_status bat_iges_sample(bat_iges_reading *reading, const batten_curve *curve,
                              bat_list *points)
{
    const batten_interval domain = batten_curve_domain(curve);
    const int steps = bat_min_int(1000, SAMPLES * batten_curve_spans(curve, NULL));
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i <= steps; i++) {
        double p[3];
        status = batten_curve_evaluate(
            curve, i < steps ? domain.a + i * (domain.b - domain.a) / steps : domain.b, 0, p);
        if (status == BATTEN_OK)
            status = bat_list_add(reading->input, points, p);
    }
    return status;
}

double bat_iges_open_gap(const bat_iges_face *face)
{
    return bat_max(100 * face->ground.tolerance, 1e-3 * face->size);
}
