/* Where the stations, waterlines and buttocks of a lines plan stand. */
#include "base/plural.h"
#include "picture/drawings/hull.h"
#include "picture/sheet/numbers.h"

#include <string.h>

batten_status bat_cuts_make(bat_cuts *cuts, int count)
{
    cuts->cuts =
        bat_array((size_t)count + 1, sizeof *cuts->cuts); /* and the design waterline */
    if (!cuts->cuts)
        return BATTEN_OUT_OF_MEMORY;
    cuts->count = count;
    return BATTEN_OK;
}

/* Multiples of the spacing, `from` among the planes or not. */
static batten_status space_cuts(bat_hull *hull, bat_family family, double spacing)
{
    const double low = hull->low[family], high = hull->high[family];
    const double margin = 1e-6 * (high - low);
    const double first = ceil((low + (family == BAT_STATIONS ? -margin : margin)) / spacing);
    const double last = floor((high + (family == BAT_STATIONS ? margin : -margin)) / spacing);
    if (!(last - first < BAT_CUT_LIMIT))
        return bat_fail(BATTEN_TOO_LARGE,
                        "a %s every %g between %g and %g makes more than %d of them",
                        bat_family_names[family], spacing, low, high, BAT_CUT_LIMIT);
    bat_cuts *cuts = &hull->families[family];
    cuts->spacing = spacing;
    const batten_status status = bat_cuts_make(cuts, (int)bat_max(0, last - first + 1));
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = (first + i) * spacing;
    return status;
}

static batten_status place_given(bat_hull *hull, const batten_draw_lines_plan_options *plan)
{
    bat_cuts *cuts = &hull->families[BAT_STATIONS];
    if (plan->station_count < 0 || plan->station_count > BAT_CUT_LIMIT)
        return bat_fail(BATTEN_TOO_LARGE, "%d station%s %s given; a lines plan draws up to %d",
                        plan->station_count, bat_plural(plan->station_count),
                        bat_one_or_many(plan->station_count, "is", "are"), BAT_CUT_LIMIT);
    for (int i = 0; i < plan->station_count; i++) {
        if (!isfinite(plan->station_at[i]))
            return bat_fail(BATTEN_NOT_FINITE, "station %d stands at %g", i + 1,
                            plan->station_at[i]);
        if (i > 0 && !(plan->station_at[i] > plan->station_at[i - 1]))
            return bat_fail(BATTEN_NOT_INCREASING,
                            "station %d at %g does not lie beyond station %d at %g", i + 1,
                            plan->station_at[i], i - 1 + 1, plan->station_at[i - 1]);
    }
    const batten_status status = bat_cuts_make(cuts, plan->station_count);
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = plan->station_at[i];
    return status;
}

static batten_status place_stations(bat_hull *hull, const batten_draw_lines_plan_options *plan)
{
    if (plan->station_at)
        return place_given(hull, plan);
    if (plan->stations > 0)
        return space_cuts(hull, BAT_STATIONS, plan->stations);
    bat_cuts *cuts = &hull->families[BAT_STATIONS];
    const double low = hull->low[0], length = hull->high[0] - low;
    const batten_status status = bat_cuts_make(cuts, 11);
    cuts->spacing = length / 10;
    for (int i = 0; i < cuts->count; i++)
        cuts->cuts[i].at = low + length * i / 10;
    return status;
}

/* Put the design waterline among the others, or mark the one that it is. */
static void add_design_waterline(bat_hull *hull, double at, batten_notes *notes)
{
    bat_cuts *cuts = &hull->families[BAT_WATERLINES];
    if (isnan(at))
        return;
    if (!(at > hull->low[2] && at < hull->high[2])) {
        batten_notes_add(notes, "", 0, "design waterline",
                         "height %g lies outside the hull, which reaches from %g to %g", at,
                         hull->low[2], hull->high[2]);
        return;
    }
    int i = cuts->count;
    /* Nearer than a millionth of the depth two waterlines are one line of the drawing. */
    const double same = 1e-6 * (hull->high[2] - hull->low[2]);
    while (i > 0 && cuts->cuts[i - 1].at > at - same)
        i--;
    if (i == cuts->count || cuts->cuts[i].at > at + same) {
        memmove(cuts->cuts + i + 1, cuts->cuts + i,
                (size_t)(cuts->count - i) * sizeof *cuts->cuts);
        cuts->cuts[i] = (bat_cut){.at = at};
        cuts->count++;
    }
    cuts->cuts[i].is_design = true;
}

static batten_status check_spacing(double spacing, bat_family family)
{
    if (spacing >= 0 && isfinite(spacing))
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT, "the spacing of the %ss is %g; it cannot be negative",
                    bat_family_names[family], spacing);
}

batten_status bat_hull_place_cuts(const batten_draw_lines_plan_options *plan,
                                  batten_notes *notes, bat_hull *hull)
{
    const double given[] = {plan->stations, plan->buttocks, plan->waterlines};
    /* At most so many when the spacing is left to us. */
    static const int usual[] = {11, 10, 12};
    for (int f = 0; f < BAT_AXES; f++) {
        batten_status status = check_spacing(given[f], (bat_family)f);
        const double range = hull->high[f] - hull->low[f];
        if (status == BATTEN_OK && f == BAT_STATIONS)
            status = place_stations(hull, plan);
        else if (status == BATTEN_OK)
            status = space_cuts(hull, (bat_family)f,
                                given[f] > 0 ? given[f] : bat_round_step(range, usual[f]));
        if (status != BATTEN_OK)
            return status;
    }
    add_design_waterline(hull, plan->design_waterline, notes);
    return BATTEN_OK;
}
