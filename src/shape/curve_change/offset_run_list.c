/* The runs of an offset, each with its projection into the plane. */
#include "base/list.h"
#include "shape/curve_change/offset.h"

batten_status bat_offset_add(bat_offset *o, batten_status status, batten_curve *curve)
{
    bat_offset_run run = {.curve = curve};
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(curve, 2, &run.plan);
    if (status == BATTEN_OK)
        status = BAT_LIST_ADD(o->runs, o->count, o->room, run);
    if (status == BATTEN_OK)
        return BATTEN_OK;
    batten_curve_unref(run.plan);
    batten_curve_unref(run.curve);
    return status;
}

void bat_offset_runs_release(bat_offset *o)
{
    for (int i = 0; i < o->count; i++) {
        batten_curve_unref(o->runs[i].curve);
        batten_curve_unref(o->runs[i].plan);
    }
    bat_release(o->runs);
}
