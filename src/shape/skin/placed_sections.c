/* The sections of a skin where they stand, and with common knots. */
#include "shape/skin/common_knots.h"
#include "shape/skin/steps.h"

#include <string.h>

static batten_status place_section(const bat_skin *t, const batten_curve *section,
                                   const batten_affine *map, batten_curve **out)
{
    batten_curve *raised = NULL;
    batten_status status = BATTEN_OK;
    if (batten_curve_dimension(section) == t->dimension)
        raised = batten_curve_ref(section);
    else
        status = batten_curve_to_dimension(section, t->dimension, &raised);
    if (status == BATTEN_OK && map)
        status = batten_curve_transform(raised, map, out);
    else if (status == BATTEN_OK)
        *out = batten_curve_ref(raised);
    batten_curve_unref(raised);
    return status;
}

batten_status bat_skin_place(bat_skin *t)
{
    for (int k = 0; k < t->count; k++)
        t->dimension = bat_max_int(t->dimension, batten_curve_dimension(t->given[k]));
    batten_affine *maps = NULL;
    batten_status status = BATTEN_OK;
    if (t->options->spine) {
        t->dimension = 3;
        maps = bat_array((size_t)t->count, sizeof *maps);
        status = maps ? bat_skin_places(t->count, t->options, maps) : BATTEN_OUT_OF_MEMORY;
    }
    for (int k = 0; status == BATTEN_OK && k < t->count; k++)
        status = place_section(t, t->given[k], maps ? &maps[k] : NULL, &t->placed[k]);
    bat_release(maps);
    return status;
}

/* ---- common knots ---- */

static bool all_periodic(const bat_skin *t)
{
    bool periodic = true;
    for (int k = 0; k < t->count; k++)
        periodic = periodic && batten_curve_is_periodic(t->placed[k]);
    return periodic;
}

batten_status bat_skin_unify(bat_skin *t)
{
    const batten_curve *const *placed = (const batten_curve *const *)t->placed;
    t->periodic_u = all_periodic(t);
    const bool exact = t->options->tolerance == 0;
    double moved = 0;
    for (int k = 0; k < t->count; k++)
        moved = bat_max(moved, t->moved[k]);
    const batten_status status =
        exact ? batten_curves_unify(t->count, placed, t->unified)
              : bat_common_knots(t->count, placed, t->options->tolerance - moved, &t->work,
                                 t->unified, t->deviation);
    if (status != BATTEN_OK)
        return status;
    const batten_curve *first = t->unified[0];
    t->rational = batten_curve_is_rational(first);
    t->width = (size_t)t->dimension + t->rational;
    t->points =
        batten_curve_point_count(first) - (t->periodic_u ? batten_curve_degree(first) : 0);
    const double size = (double)t->points * (t->count + 2);
    if (size > BAT_MAX_MADE_POINTS)
        return bat_fail(
            BATTEN_TOO_LARGE,
            "%d sections with %d common control points make a surface of %.3g; the limit is %d",
            t->count, t->points, size, (int)BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}
