/* Smooth runs of quintics that share point and two derivatives at their ends. */
#include "spline/curve/hermite_run.h"
#include "base/list.h"
#include "numeric/vector.h"

bool bat_hermite_agrees(int dimension, int first, const double *left, const double *right,
                        double same)
{
    for (int m = first; m < 3; m++) {
        const double *l = left + 3 * m, *r = right + 3 * m;
        if (bat_distance(dimension, l, r) >
            same * bat_max(bat_norm(dimension, l), bat_norm(dimension, r)))
            return false;
    }
    return true;
}

batten_status bat_hermite_curve(int dimension, int count, const bat_hermite_place *places,
                                batten_curve **out)
{
    const size_t d = (size_t)dimension;
    double *u = bat_array((size_t)count, (1 + 3 * d) * sizeof *u);
    if (!u)
        return BATTEN_OUT_OF_MEMORY;
    double *values = u + count;
    for (int i = 0; i < count; i++) {
        u[i] = places[i].u;
        for (int m = 0; m < 3; m++, values += d)
            memcpy(values, places[i].q[m], d * sizeof *values);
    }
    const batten_status status =
        batten_curve_from_hermite(dimension, count, 3, u, u + count, out);
    bat_release(u);
    return status;
}

batten_status bat_hermite_run_add(bat_hermite_run *run, double u, const double *q)
{
    bat_hermite_place place = {.u = u};
    memcpy(place.q, q, sizeof place.q);
    return BAT_LIST_ADD(run->places, run->count, run->room, place);
}

batten_status bat_hermite_run_finish(bat_hermite_run *run, batten_curve **out)
{
    batten_curve *made = NULL;
    if (run->count >= 2) {
        const batten_status status =
            bat_hermite_curve(run->dimension, run->count, run->places, &made);
        if (status != BATTEN_OK)
            return status;
    }
    run->count = 0;
    *out = made;
    return BATTEN_OK;
}

void bat_hermite_run_release(bat_hermite_run *run)
{
    bat_release(run->places);
    *run = (bat_hermite_run){0};
}
