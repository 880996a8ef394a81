/* A catamaran of one of its hulls. */
#include "base/list.h"
#include "hydrostatics/hull.h"
#include <batten/measure.h>

static size_t numbers_of(const bat_patch *patch)
{
    return 4 * (size_t)(patch->degree[0] + 1) * (size_t)(patch->degree[1] + 1);
}

/* A patch of the one hull at its place, to port, or its image. */
static batten_status add_patch(batten_hull *twin, const batten_hull *hull,
                               const bat_patch *patch, double to_port, bool image)
{
    bat_patch made = *patch;
    const double scale = hull->size / twin->size;
    made.points = bat_arena_array(&twin->arena, numbers_of(patch), sizeof(double));
    if (!made.points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < numbers_of(patch); i += 4) {
        const double *from = patch->points + i;
        double *to = made.points + i;
        for (int c = 0; c < 3; c++)
            to[c] = scale * from[c];
        to[1] += from[3] * ((hull->centre[1] + to_port) / twin->size);
        to[1] = image ? -to[1] : to[1];
        to[3] = from[3];
    }
    if (image)
        made.sign = -made.sign; /* a mirror turns left to right */
    return BAT_LIST_ADD(twin->patches, twin->patch_count, twin->patch_room, made);
}

static void set_box(batten_hull *twin, const batten_hull *hull, double to_port)
{
    twin->box = hull->box;
    twin->box.high.y += to_port;
    twin->box.low.y = -twin->box.high.y;
    twin->size = bat_max(hull->size, 2 * twin->box.high.y);
    for (int c = 0; c < 3; c++)
        twin->centre[c] = c == 1 ? 0 : hull->centre[c];
}

static batten_status fill_twin(batten_hull *twin, const batten_hull *hull, double to_port)
{
    batten_status status = BATTEN_OK;
    set_box(twin, hull, to_port);
    for (int i = 0; i < 2 * hull->patch_count && status == BATTEN_OK; i++)
        status = add_patch(twin, hull, &hull->patches[i / 2], to_port, i % 2);
    for (int i = 0; i < hull->lid_count && status == BATTEN_OK; i++) {
        batten_hull_lid lid = hull->lids[i];
        lid.area *= 2;
        status = BAT_LIST_ADD(twin->lids, twin->lid_count, twin->lid_room, lid);
    }
    return status;
}

batten_status batten_hull_twin(const batten_hull *hull, double spacing, batten_hull **out)
{
    if (!(spacing > 0) || !isfinite(spacing))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hulls of a catamaran are %g apart; it must be above 0", spacing);
    if (hull->box.low.y + 0.5 * spacing < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hulls of the catamaran overlap: each reaches to y = %.6g on the "
                        "inner side, and their planes are %.6g apart",
                        hull->box.low.y, spacing);
    batten_hull *twin = bat_array(1, sizeof *twin);
    if (!twin)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = fill_twin(twin, hull, 0.5 * spacing);
    if (status == BATTEN_OK)
        *out = twin;
    else
        batten_hull_free(twin);
    return status;
}
