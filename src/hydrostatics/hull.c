/* A hull from its surfaces: both halves as Bezier patches that look outwards, and lids across
 * from open edges to their images. */
#include "hydrostatics/hull.h"
#include "base/list.h"
#include "hydrostatics/wet.h"
#include "numeric/box.h"
#include "numeric/vector.h"

#include <string.h>

/* What is nearer to the centre plane than this, as a part of the size, needs no lid. */
static const double ON_PLANE = 1e-12;
/* Volumes that count as some, areas that count as open, and those that joints may leave, all as
 * parts of the size or of the area. */
static const double ENCLOSED = 1e-6, OPEN = 1e-6, JOINT = 1e-4;
/* Volumes that differ by more, as a part of the area, tell a hole; the rule is not exact for rational patches. */
static const double HOLE = 1e-3;
/* The default tolerance of surfaces that are no NURBS, as a part of the size. */
static const double NEAR = 1e-6;

/* ---- patches ---- */

static batten_status add_patch(batten_hull *hull, const int degree[2], int lid, bat_patch *out)
{
    const size_t count = (size_t)(degree[0] + 1) * (size_t)(degree[1] + 1);
    *out = (bat_patch){lid,
                       {degree[0], degree[1]},
                       1,
                       bat_arena_array(&hull->arena, 4 * count, sizeof(double))};
    if (!out->points)
        return BATTEN_OUT_OF_MEMORY;
    return BAT_LIST_ADD(hull->patches, hull->patch_count, hull->patch_room, *out);
}

/* Control point (i, j) of a surface of Bezier patches. */
static void take_point(const batten_hull *hull, const batten_surface *bezier, int i, int j,
                       double out[4])
{
    const size_t at =
        (size_t)i * (size_t)batten_surface_point_count(bezier, BATTEN_V) + (size_t)j;
    const double *p = batten_surface_points(bezier) + 3 * at;
    const double *weights = batten_surface_weights(bezier);
    out[3] = weights ? weights[at] : 1;
    for (int c = 0; c < 3; c++)
        out[c] = out[3] * ((p[c] - hull->centre[c]) / hull->size);
}

static batten_status add_patches(batten_hull *hull, const batten_surface *bezier, bool mirrored)
{
    const int degree[2] = {batten_surface_degree(bezier, BATTEN_U),
                           batten_surface_degree(bezier, BATTEN_V)};
    const int counts[2] = {batten_surface_point_count(bezier, BATTEN_U),
                           batten_surface_point_count(bezier, BATTEN_V)};
    bat_patch patch;
    for (int a = 0; a + degree[0] < counts[0]; a += degree[0])
        for (int b = 0; b + degree[1] < counts[1]; b += degree[1]) {
            if (add_patch(hull, degree, BAT_SKIN, &patch) != BATTEN_OK)
                return BATTEN_OUT_OF_MEMORY;
            double *at = patch.points;
            for (int i = a; i <= a + degree[0]; i++)
                for (int j = b; j <= b + degree[1]; j++, at += 4) {
                    take_point(hull, bezier, i, j, at);
                    at[1] *= mirrored ? -1 : 1;
                }
        }
    return BATTEN_OK;
}

/* ---- lids ---- */

typedef struct {
    const batten_surface *bezier;
    batten_direction constant;
    bool high;
} edge;

static void edge_point(const batten_hull *hull, const edge *e, int k, double out[4])
{
    const int at = e->high ? batten_surface_point_count(e->bezier, e->constant) - 1 : 0;
    if (e->constant == BATTEN_U)
        take_point(hull, e->bezier, at, k, out);
    else
        take_point(hull, e->bezier, k, at, out);
}

/* The lid continues the surface beyond its edge, towards the image of the edge: so its normal
 * keeps its side. */
static batten_status add_lid_patch(batten_hull *hull, const edge *e, int first)
{
    const int along = batten_surface_degree(e->bezier, !e->constant);
    const bool across_u = e->constant == BATTEN_U;
    bat_patch patch;
    if (add_patch(hull, (const int[2]){across_u ? 1 : along, across_u ? along : 1},
                  hull->lid_count, &patch) != BATTEN_OK)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k <= along; k++)
        for (int side = 0; side < 2; side++) {
            double *at = patch.points + 4 * (across_u ? side * (along + 1) + k : 2 * k + side);
            edge_point(hull, e, first + k, at);
            at[1] *= side == e->high ? -1 : 1;
        }
    return BATTEN_OK;
}

/* The box of the control points of an edge. */
static batten_box edge_box(const edge *e)
{
    const int count = batten_surface_point_count(e->bezier, !e->constant);
    const int row = batten_surface_point_count(e->bezier, BATTEN_V);
    const int at = e->high ? batten_surface_point_count(e->bezier, e->constant) - 1 : 0;
    batten_box box = bat_box_of_nothing();
    for (int k = 0; k < count; k++) {
        const size_t place = (size_t)(e->constant == BATTEN_U ? at : k) * (size_t)row +
                             (size_t)(e->constant == BATTEN_U ? k : at);
        const double *p = batten_surface_points(e->bezier) + 3 * place;
        bat_box_join(&box, bat_box_at(p));
    }
    return box;
}

static batten_status add_lid(batten_hull *hull, int surface, const edge *e)
{
    const int count = batten_surface_point_count(e->bezier, !e->constant);
    const int degree = batten_surface_degree(e->bezier, !e->constant);
    const batten_hull_lid lid = {surface, e->constant, e->high, edge_box(e), 0};
    if (bat_max(-lid.edge.low.y, lid.edge.high.y) <= ON_PLANE * hull->size)
        return BATTEN_OK;
    for (int first = 0; first + degree < count; first += degree)
        if (add_lid_patch(hull, e, first) != BATTEN_OK)
            return BATTEN_OUT_OF_MEMORY;
    return BAT_LIST_ADD(hull->lids, hull->lid_count, hull->lid_room, lid);
}

static batten_status add_lids(batten_hull *hull, int surface, const batten_surface *bezier)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 4 && status == BATTEN_OK; k++)
        status = add_lid(hull, surface, &(edge){bezier, (batten_direction)(k / 2), k % 2});
    return status;
}

/* ---- one surface ---- */

/* What a surface, its image and their lids enclose tells which side is out; where that is nothing,
 * as of a flat bottom, the side that looks away from the middle of the hull. The image of a surface
 * looks the other way, as a mirror turns left to right; a lid as the surface. */
static void face_outwards(batten_hull *hull, int first, int images, int lids)
{
    double own = 0, all = 0, normal[3] = {0};
    for (int i = first; i < hull->patch_count; i++) {
        double flux[3] = {0};
        hull->patches[i].sign = i >= images && i < lids ? -1 : 1;
        bat_patch_flux(&hull->patches[i], flux, normal);
        const double sum = flux[0] + flux[1] + flux[2];
        own += i < images ? sum : 0;
        all += sum;
    }
    if ((fabs(all) > ENCLOSED ? all : own) < 0)
        for (int i = first; i < hull->patch_count; i++)
            hull->patches[i].sign = -hull->patches[i].sign;
}

/* A surface that is closed by itself has as much area to one side as to the other, and the same volume by lines along
 * each axis. */
static batten_status check_closed(const batten_hull *hull, int surface, int first)
{
    const double volume = hull->size * hull->size * hull->size;
    double flux[3] = {0}, normal[3] = {0}, area = 0;
    for (int i = first; i < hull->patch_count; i++) {
        double part = 0;
        const batten_status status = bat_patch_area(&hull->patches[i], &part);
        if (status != BATTEN_OK)
            return status;
        area += part;
        bat_patch_flux(&hull->patches[i], flux, normal);
    }
    for (int c = 0; c < 3; c++)
        if (fabs(normal[c]) > OPEN * area)
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "surface %d of a whole hull is not closed: %.3g of its area is "
                            "missing along %c",
                            surface + 1, fabs(normal[c]) * hull->size * hull->size, "xyz"[c]);
    for (int c = 0; c < 3; c++)
        if (fabs(flux[c] - flux[(c + 1) % 3]) > HOLE * area)
            return bat_fail(
                BATTEN_NOT_COMPATIBLE,
                "surface %d of a whole hull is not closed: its volume is %.6g by lines "
                "along %c and %.6g along %c",
                surface + 1, flux[c] * volume, "xyz"[c], flux[(c + 1) % 3] * volume,
                "xyz"[(c + 1) % 3]);
    return BATTEN_OK;
}

/* Along a joint the lids of both surfaces take each other away, unless these face to different
 * sides. */
static batten_status check_joints(const batten_hull *hull)
{
    double flux[3] = {0}, normal[3] = {0}, area = 0;
    for (int i = 0; i < hull->patch_count; i++) {
        double part[3] = {0};
        if (hull->patches[i].lid != BAT_JOINT)
            continue;
        bat_patch_flux(&hull->patches[i], flux, part);
        area += bat_norm(3, part);
        for (int c = 0; c < 3; c++)
            normal[c] += part[c];
    }
    if (bat_norm(3, normal) <= JOINT * area &&
        fabs(flux[0] + flux[1] + flux[2]) <= JOINT * area)
        return BATTEN_OK;
    return bat_fail(BATTEN_NOT_COMPATIBLE,
                    "surfaces that share an edge seem to face to different sides of it: a hull "
                    "whose inner sides or tops are surfaces of their own is not understood");
}

static batten_status add_bezier(batten_hull *hull, int surface, const batten_surface *bezier,
                                bool whole)
{
    const int first = hull->patch_count;
    batten_status status = add_patches(hull, bezier, false);
    const int images = hull->patch_count;
    if (status == BATTEN_OK && !whole)
        status = add_patches(hull, bezier, true);
    const int lids = hull->patch_count;
    if (status == BATTEN_OK && !whole)
        status = add_lids(hull, surface, bezier);
    if (status == BATTEN_OK)
        face_outwards(hull, first, images, lids);
    return status == BATTEN_OK && whole ? check_closed(hull, surface, first) : status;
}

static batten_status add_surface(batten_hull *hull, int index, const batten_surface *surface,
                                 const batten_hull_options *options)
{
    const double tolerance = options->tolerance > 0 ? options->tolerance : NEAR * hull->size;
    batten_surface *nurbs = NULL, *bezier = NULL;
    batten_status status = batten_surface_to_nurbs(surface, tolerance, NULL, &nurbs);
    if (status == BATTEN_OK)
        status = batten_surface_to_bezier(nurbs, &bezier);
    if (status == BATTEN_OK)
        status = add_bezier(hull, index, bezier, options->whole);
    batten_surface_unref(bezier);
    batten_surface_unref(nurbs);
    return status;
}

/* ---- the whole ---- */

static batten_status check_surfaces(int count, const batten_surface *const *surfaces,
                                    const batten_hull_options *options)
{
    if (count < 1)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a hull of %d surfaces; at least 1 is needed",
                        count);
    if (!(options->tolerance >= 0) || !isfinite(options->tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the tolerance of a hull is %g; it must be 0 or above",
                        options->tolerance);
    for (int i = 0; i < count; i++)
        if (batten_surface_dimension(surfaces[i]) != 3)
            return bat_fail(BATTEN_UNSUPPORTED,
                            "surface %d of a hull has %d dimensions; it must have 3", i + 1,
                            batten_surface_dimension(surfaces[i]));
    return BATTEN_OK;
}

/* The box of both sides, and the coordinates of patches from it. */
static batten_status measure_box(batten_hull *hull, int count,
                                 const batten_surface *const *surfaces, bool whole)
{
    batten_box box = bat_box_of_nothing();
    for (int i = 0; i < count; i++)
        bat_box_join(&box, batten_surface_box(surfaces[i]));
    if (!whole) {
        box.high.y = bat_max(box.high.y, -box.low.y);
        box.low.y = -box.high.y;
    }
    const double low[3] = {box.low.x, box.low.y, box.low.z};
    const double high[3] = {box.high.x, box.high.y, box.high.z};
    for (int c = 0; c < 3; c++) {
        hull->centre[c] = low[c] + 0.5 * (high[c] - low[c]);
        hull->size = bat_max(hull->size, high[c] - low[c]);
    }
    hull->box = box;
    if (!(hull->size > 0) || !isfinite(hull->size))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the hull reaches %g at most; it needs a size",
                        hull->size);
    return BATTEN_OK;
}

static batten_status fill_hull(batten_hull *hull, int count,
                               const batten_surface *const *surfaces,
                               const batten_hull_options *options)
{
    bool *images = bat_array((size_t)count, sizeof *images);
    batten_status status =
        images ? measure_box(hull, count, surfaces, options->whole) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && !options->whole)
        status = bat_hull_find_images(hull, count, surfaces, images);
    for (int i = 0; i < count && status == BATTEN_OK; i++)
        if (!images[i])
            status = add_surface(hull, i, surfaces[i], options);
    bat_release(images);
    if (status == BATTEN_OK && count > 1)
        status = bat_hull_find_joints(hull, count, surfaces);
    if (status == BATTEN_OK)
        status = check_joints(hull);
    for (int i = 0; i < hull->patch_count && status == BATTEN_OK; i++) {
        double area = 0;
        const int lid = hull->patches[i].lid;
        if (lid < 0)
            continue;
        status = bat_patch_area(&hull->patches[i], &area);
        hull->lids[lid].area += area * hull->size * hull->size;
    }
    return status;
}

batten_status batten_hull_create(int count, const batten_surface *const *surfaces,
                                 const batten_hull_options *options, batten_hull **out)
{
    batten_hull_options chosen = batten_hull_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_hull_options, options, &chosen);
    if (status == BATTEN_OK)
        status = check_surfaces(count, surfaces, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_hull *hull = bat_array(1, sizeof *hull);
    if (!hull)
        return BATTEN_OUT_OF_MEMORY;
    status = fill_hull(hull, count, surfaces, &chosen);
    if (status == BATTEN_OK)
        *out = hull;
    else
        batten_hull_free(hull);
    return status;
}

void batten_hull_free(batten_hull *hull)
{
    if (!hull)
        return;
    bat_arena_free(&hull->arena);
    bat_release(hull->patches);
    bat_release(hull->lids);
    bat_release(hull);
}

batten_box batten_hull_box(const batten_hull *hull)
{
    return hull->box;
}

const batten_hull_lid *batten_hull_lids(const batten_hull *hull, int *count)
{
    *count = hull->lid_count;
    return hull->lids;
}
