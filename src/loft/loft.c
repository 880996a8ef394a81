/* The lofting of a hull, as others call it: one smooth surface, or panels between knuckles. */
#include "base/plural.h"
#include "loft/report.h"

#include <string.h>

batten_loft_options batten_loft_defaults(double within)
{
    return (batten_loft_options){.size = sizeof(batten_loft_options), .within = within};
}

static batten_status take_options(const batten_loft_options *given, batten_loft_options *out)
{
    *out = batten_loft_defaults(0);
    const batten_status status = BAT_TAKE_OPTIONS(batten_loft_options, given, out);
    if (status != BATTEN_OK)
        return status;
    if (!(out->within > 0) || !isfinite(out->within))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the bound of a lofting is %g; it must be above 0",
                        out->within);
    if (!(out->height >= 0) || !isfinite(out->height))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the height of visible bulges is %g; it must be 0 or above",
                        out->height);
    if (out->knuckle_count < 0 || (out->knuckle_count > 0 && !out->knuckles))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d knuckles are declared; their number must be 0 or above, and each "
                        "has a name",
                        out->knuckle_count);
    if (out->straight_count < 0 || (out->straight_count > 0 && !out->straight))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "%d straight runs are declared; their number must be 0 or above, and "
                        "each has a line",
                        out->straight_count);
    return BATTEN_OK;
}

/* ---- the surfaces ---- */

static batten_status find_panels(const batten_offset_table *table,
                                 const batten_loft_options *options, const batten_job *job,
                                 bat_hull_panels *panels)
{
    const batten_status status = bat_hull_panels_make(table, options, job, panels);
    return status == BATTEN_OK ? bat_hull_panels_run(panels) : status;
}

/* A panel that is ruled is of degree 1 across. */
static batten_status make_ruled(const bat_loft_patch *patch, batten_surface **out)
{
    static const double straight[] = {0, 0, 1, 1};
    const batten_axis u = {BAT_LOFT_DEGREE, patch->nu, patch->u_knots, false};
    const batten_axis v = {1, 2, straight, false};
    double *points = bat_array((size_t)patch->nu, 6 * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < patch->nu; i++) {
        const double *row = patch->points + 3 * (size_t)i * (size_t)patch->nv;
        memcpy(points + 6 * (size_t)i, row, 3 * sizeof *points);
        memcpy(points + 6 * (size_t)i + 3, row + 3 * (patch->nv - 1), 3 * sizeof *points);
    }
    const batten_status status = batten_surface_create(3, &u, &v, points, NULL, out);
    bat_release(points);
    return status;
}

static batten_status make_surface(const bat_loft *loft, batten_surface **out)
{
    const bat_loft_patch *patch = &loft->patch;
    const batten_axis u = {BAT_LOFT_DEGREE, patch->nu, patch->u_knots, false};
    const batten_axis v = {BAT_LOFT_DEGREE, patch->nv, patch->v_knots, false};
    if (bat_hull_is_ruled(loft))
        return make_ruled(patch, out);
    return batten_surface_create(3, &u, &v, patch->points, NULL, out);
}

/* All surfaces or none. */
static batten_status make_surfaces(const bat_hull_panels *panels, batten_surface **out)
{
    batten_surface **made = bat_array((size_t)panels->count, sizeof *made);
    batten_status status = made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < panels->count && status == BATTEN_OK; k++)
        status = make_surface(panels->at + k, &made[k]);
    for (int k = 0; k < panels->count && made; k++)
        if (status == BATTEN_OK)
            out[k] = made[k];
        else
            batten_surface_unref(made[k]);
    bat_release(made);
    return status;
}

batten_status batten_hull_loft(const batten_offset_table *table,
                               const batten_loft_options *options, const batten_job *job,
                               batten_loft_report *report, batten_surface **out)
{
    batten_loft_options chosen;
    batten_loft_report found = {0};
    bat_hull_panels panels;
    batten_status status = take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    status = find_panels(table, &chosen, job, &panels);
    double *enough = report ? &report->enough : &found.enough;
    if (status == BATTEN_NOT_COMPATIBLE && panels.rails.is_explained)
        *enough = panels.rails.enough;
    else if (status == BATTEN_NOT_COMPATIBLE)
        status = bat_loft_find_enough(table, &chosen, job, enough);
    if (status == BATTEN_OK)
        status = bat_loft_fill_report(&panels, table, &found);
    if (status == BATTEN_OK)
        status = make_surfaces(&panels, out);
    if (status == BATTEN_OK && report)
        *report = found;
    else
        batten_loft_report_release(&found);
    bat_hull_panels_free(&panels);
    return status;
}

batten_status batten_surface_loft(const batten_offset_table *table,
                                  const batten_loft_options *options, const batten_job *job,
                                  batten_loft_report *report, batten_surface **out)
{
    batten_loft_options chosen;
    const batten_status status = take_options(options, &chosen);
    if (status != BATTEN_OK)
        return status;
    if (chosen.knuckle_count > 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "one surface has no knuckles, and %d are declared: batten_hull_loft "
                        "makes the panels between them",
                        chosen.knuckle_count);
    if (chosen.straight_count > 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "straight runs are on lines in space, which batten_hull_loft makes: %d "
                        "%s declared",
                        chosen.straight_count,
                        bat_one_or_many(chosen.straight_count, "is", "are"));
    return batten_hull_loft(table, &chosen, job, report, out);
}
