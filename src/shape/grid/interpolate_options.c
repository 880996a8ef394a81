/* What may be asked of the surface through a grid. */
#include "shape/grid/interpolate.h"

static batten_status check_derivatives(const batten_surface_interpolate_options *o, int d,
                                       int count_u, int count_v)
{
    const struct {
        const double *values;
        size_t count;
        const char *name;
        bool periodic;
    } given[] = {
        {o->du, 2 * (size_t)bat_orders_u(o) * (size_t)count_v * (size_t)d, "du", o->closed_u},
        {o->dv, 2 * (size_t)bat_orders_v(o) * (size_t)count_u * (size_t)d, "dv", o->closed_v},
        {o->twists, 4 * (size_t)bat_orders_u(o) * (size_t)bat_orders_v(o) * (size_t)d, "twists",
         o->closed_u || o->closed_v}};
    if (o->orders_u < 0 || o->orders_v < 0 || o->orders_u > BATTEN_MAX_DEGREE ||
        o->orders_v > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d orders along u, %d along v: 0 to %d are possible", o->orders_u,
                        o->orders_v, BATTEN_MAX_DEGREE);
    for (int i = 0; i < 3; i++) {
        if (!given[i].values)
            continue;
        if (given[i].periodic || o->weights)
            return bat_fail(BATTEN_BAD_ARGUMENT, "`%s` is given, but %s", given[i].name,
                            o->weights ? "a rational surface takes no derivatives"
                                       : "a periodic surface has no rim there");
        const size_t bad = bat_first_not_finite(given[i].values, given[i].count);
        if (bad < given[i].count)
            return bat_fail(BATTEN_NOT_FINITE, "number %zu of `%s` is %g", bad + 1,
                            given[i].name, given[i].values[bad]);
    }
    if (o->twists && (!o->du || !o->dv))
        return bat_fail(BATTEN_BAD_ARGUMENT, "`twists` are given, but not both `du` and `dv`");
    if (!o->twists && o->du && o->dv && (bat_orders_u(o) > 1 || bat_orders_v(o) > 1))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "`du` and `dv` give %d and %d orders: then `twists` must be given too",
                        bat_orders_u(o), bat_orders_v(o));
    return BATTEN_OK;
}

static batten_status check_ends(const batten_surface_interpolate_options *o)
{
    switch (o->ends) {
    case BATTEN_END_NOT_A_KNOT:
    case BATTEN_END_NATURAL:
    case BATTEN_END_PARABOLIC:
    case BATTEN_END_BESSEL:
    case BATTEN_END_FAIR:
        return BATTEN_OK;
    default:
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "ends of kind %d need vectors: give a surface `du` and `dv`",
                        (int)o->ends);
    }
}

static batten_status check_weights(size_t count, const double *weights)
{
    for (size_t i = 0; weights && i < count; i++)
        if (!(weights[i] > 0 && weights[i] < HUGE_VAL))
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "the weight of point %zu is %g; it must be above 0", i + 1,
                            weights[i]);
    return BATTEN_OK;
}

batten_status bat_grid_options_check(const batten_surface_interpolate_options *o, int dimension,
                                     int count_u, int count_v)
{
    batten_status status = check_weights((size_t)count_u * (size_t)count_v, o->weights);
    if (status == BATTEN_OK)
        status = check_derivatives(o, dimension, count_u, count_v);
    return status == BATTEN_OK ? check_ends(o) : status;
}
