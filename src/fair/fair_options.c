/* The options of fairing, checked for curves and tables alike. */
#include "base/plural.h"
#include "fair/fair_points.h"

batten_fair_options batten_fair_defaults(double within)
{
    return (batten_fair_options){.size = sizeof(batten_fair_options),
                                 .within = within,
                                 .hold_ends = true,
                                 .order = BATTEN_FAIR_SWEEPS,
                                 .relaxation = 1,
                                 .corner_angle = 0.436332312998582}; /* 25 degrees */
}

static batten_status check_bounds(int count, const batten_fair_options *options)
{
    for (int i = 0; options->within_each && i < count; i++)
        if (!(options->within_each[i] >= 0 && isfinite(options->within_each[i])))
            return bat_fail(BATTEN_BAD_ARGUMENT, "the bound of point %d is %g, not 0 or more",
                            i + 1, options->within_each[i]);
    if (!options->within_each && !(options->within > 0 && isfinite(options->within)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the bound is %g, not above 0", options->within);
    return BATTEN_OK;
}

batten_status bat_fair_check_options(int count, const batten_fair_options *options)
{
    for (int k = 0; k < options->corner_count; k++)
        if (options->corners[k] < 0 || options->corners[k] >= count)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "corner %d is point %d, but there %s %d point%s", k + 1,
                            options->corners[k] + 1, bat_one_or_many(count, "is", "are"), count,
                            bat_plural(count));
    if (!(options->relaxation > 0 && options->relaxation <= 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the relaxation is %g, not above 0 and at most 1",
                        options->relaxation);
    if ((int)options->order < 0 || options->order > BATTEN_FAIR_ALTERNATE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no order %d of fairing",
                        (int)options->order);
    if ((int)options->method < 0 || options->method > BATTEN_FAIR_LEAST_CHANGE)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no method %d of fairing",
                        (int)options->method);
    if (options->max_moves < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the most moves are %d, below 0",
                        options->max_moves);
    return check_bounds(count, options);
}
