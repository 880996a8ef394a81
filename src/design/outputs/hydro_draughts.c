/* Draughts for a table of hydrostatics where none are given: round ones up to the deck. */
#include "design/outputs/hydrostatics.h"

/* A draught at the edge of the deck is one that is taken but for rounding. */
static const double ROUNDING = 1e-9;

/* The top of the hull is an edge along the ship that is closed across, above its middle. */
static double deck_of(const batten_hull *hull)
{
    int count;
    const batten_hull_lid *lids = batten_hull_lids(hull, &count);
    const batten_box box = batten_hull_box(hull);
    double height = box.high.z;
    for (int i = 0; i < count; i++) {
        const batten_box *edge = &lids[i].edge;
        if (edge->high.x - edge->low.x > edge->high.z - edge->low.z &&
            edge->low.z > 0.5 * (box.low.z + box.high.z))
            height = bat_min(height, edge->low.z);
    }
    return height;
}

/* The smallest of 1, 2 and 5 times a power of ten that takes no more than so many steps. */
static double round_step(double range)
{
    static const double factors[] = {2, 2.5, 2};
    double step = 1;
    while (range / step > BAT_HYDRO_DRAUGHTS)
        step *= 10;
    while (range / (step / 10) <= BAT_HYDRO_DRAUGHTS)
        step /= 10;
    for (int i = 0; range / (step / factors[i]) <= BAT_HYDRO_DRAUGHTS && i < 3; i++)
        step /= factors[i];
    return step;
}

batten_status bat_hydro_round_draughts(const batten_hull *hull,
                                       double draughts[BAT_HYDRO_DRAUGHTS], int *count)
{
    const double low = bat_max(0, batten_hull_box(hull).low.z), high = deck_of(hull);
    const double step = high > low ? round_step(high - low) : 1;
    const double first = floor(low / step) + 1, last = floor(high / step * (1 + ROUNDING));
    *count = (int)bat_max(0, bat_min(BAT_HYDRO_DRAUGHTS, last - first + 1));
    if (*count == 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the hull reaches from z = %.6g to %.6g: no draught above the baseline "
                        "z = 0 is below its deck; give 'draughts'",
                        batten_hull_box(hull).low.z, high);
    for (int i = 0; i < *count; i++)
        draughts[i] = step * (first + i);
    return BATTEN_OK;
}
