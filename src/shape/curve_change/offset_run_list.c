/* The runs of an offset, each with its projection into the plane. */
#include "shape/curve_change/offset.h"

batten_status bat_offset_add(bat_offset *o, batten_status status, batten_curve *curve)
{
    bat_offset_run run = {.curve = curve};
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(curve, 2, &run.plan);
    if (status == BATTEN_OK && o->count == o->room) {
        const int room = bat_max_int(16, 2 * o->room);
        bat_offset_run *grown = bat_resize(o->runs, (size_t)room, sizeof *grown);
        if (grown) {
            o->runs = grown;
            o->room = room;
        } else {
            status = BATTEN_OUT_OF_MEMORY;
        }
    }
    if (status == BATTEN_OK) {
        o->runs[o->count++] = run;
        return BATTEN_OK;
    }
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
