/* Surfaces through networks of curves, after Gordon: options, the order of the steps, the report. */
#include "shape/network/gordon.h"
#include "spline/curve/curve.h"

#include <string.h>

batten_surface_gordon_options batten_surface_gordon_defaults(void)
{
    return (batten_surface_gordon_options){.size = sizeof(batten_surface_gordon_options),
                                           .cut = true};
}

static batten_status check_network(int profiles, int guides,
                                   const batten_surface_gordon_options *o)
{
    if (!isfinite(o->tolerance))
        return bat_fail(BATTEN_NOT_FINITE, "the tolerance is %g", o->tolerance);
    if (o->tolerance <= 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", o->tolerance);
    if (!isfinite(o->gap))
        return bat_fail(BATTEN_NOT_FINITE, "the gap is %g", o->gap);
    if (o->gap < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the gap is %g, below 0", o->gap);
    if (profiles < 1 || guides < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "there are %d profiles and %d guides; a network has both", profiles,
                        guides);
    /* A surface has more control points than nodes: the least that is known before the work. */
    if ((double)profiles * guides > BAT_MAX_MADE_POINTS / 4.0)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d profiles and %d guides have %.3g nodes; the limit is %d", profiles,
                        guides, (double)profiles * guides, (int)(BAT_MAX_MADE_POINTS / 4));
    return BATTEN_OK;
}

static batten_status find_scale(bat_network *net, const batten_curve *const *profiles,
                                const batten_curve *const *guides)
{
    const int n = net->family[0].given, m = net->family[1].given;
    const batten_curve **all = bat_array((size_t)n + (size_t)m, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(all, profiles, (size_t)n * sizeof *all);
    memcpy(all + n, guides, (size_t)m * sizeof *all);
    batten_status status = bat_network_scale(n + m, all, &net->scale);
    if (status == BATTEN_OK)
        net->report.size = batten_network_size(n + m, all);
    bat_release(all);
    const double gap = net->options->gap > 0 ? net->options->gap : net->options->tolerance;
    net->tolerance = net->options->tolerance * net->scale;
    net->gap = gap * net->scale;
    net->size = net->report.size * net->scale;
    net->same = bat_network_same_place(net->gap, net->size);
    if (status == BATTEN_OK && net->tolerance < 0x1p-44)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "the tolerance %g is lost in the rounding of coordinates of %g",
                          net->options->tolerance, 1 / net->scale);
    return status;
}

static batten_status make_network_surface(bat_network *net, batten_surface **out)
{
    bat_network_side sides[2] = {{0}, {0}};
    batten_status status = bat_network_find_nodes(net);
    if (status == BATTEN_OK)
        status = bat_network_parametrize(net);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = bat_network_make_side(net, k, &sides[k]);
    if (status == BATTEN_OK)
        status = bat_network_sum(net, sides, out);
    if (status == BATTEN_OK && (status = bat_network_measure(net, sides)) != BATTEN_OK) {
        batten_surface_unref(*out);
        *out = NULL;
    }
    for (int k = 0; k < 2; k++)
        bat_network_side_free(&sides[k]);
    return status;
}

batten_status batten_surface_gordon(batten_curve_row profiles, batten_curve_row guides,
                                    const batten_surface_gordon_options *options,
                                    const batten_job *job, batten_surface_gordon_report *report,
                                    batten_surface **out)
{
    batten_surface_gordon_options chosen = batten_surface_gordon_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_gordon_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    options = &chosen;
    bat_network net = {
        .family = {{.what = "profile",
                    .names = options->profile_names,
                    .given = profiles.count},
                   {.what = "guide", .names = options->guide_names, .given = guides.count}},
        .options = options,
        .work = {job, 0}};
    status = check_network(profiles.count, guides.count, options);
    if (status == BATTEN_OK)
        status = find_scale(&net, profiles.at, guides.at);
    if (status == BATTEN_OK)
        status = bat_network_take(&net, profiles.at, guides.at);
    if (status == BATTEN_OK)
        status = make_network_surface(&net, out);
    if (status == BATTEN_OK && report)
        *report = net.report;
    bat_network_free(&net);
    return status;
}
