/* Holes of n sides. */
#include "shape/fill/fill.h"
#include "numeric/rounding.h"
#include <string.h>

batten_surface_fill_options batten_surface_fill_defaults(void)
{
    return (batten_surface_fill_options){.size = sizeof(batten_surface_fill_options),
                                         .angle = 0.002 * BAT_PI / 180};
}

static batten_status check_options(const batten_surface_fill_options *options)
{
    if (!(options->tolerance >= 0) || !isfinite(options->tolerance))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance of a fill is 0 or more, not %g",
                        options->tolerance);
    if (!(options->angle > 0) || !isfinite(options->angle))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle of a fill is above 0, not %g",
                        options->angle);
    if (options->curvature && options->form != BATTEN_FILL_SPLIT)
        return bat_fail(BATTEN_UNSUPPORTED, "a fill that is a formula takes no curvature over");
    return BATTEN_OK;
}

static void free_patches(batten_surface **patches)
{
    for (int i = 0; i < BATTEN_FILL_SIDES; i++)
        batten_surface_unref(patches[i]);
}

/* Surfaces that are exact along all edges, in the loop's coordinates. */
static batten_status split_loop(const bat_fill_loop *loop,
                                const batten_surface_fill_options *options,
                                batten_surface **out)
{
    bat_fill *fill = bat_array(1, sizeof *fill);
    if (!fill)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface *plane[BATTEN_FILL_SIDES] = {NULL};
    batten_status status = bat_fill_plane(loop, plane);
    if (status == BATTEN_OK)
        status = bat_fill_make(loop, plane, fill);
    for (int i = 0; status == BATTEN_OK && i < loop->count; i++)
        status = bat_fill_patch(fill, i, options->angle, &out[i]);
    bat_fill_end(fill);
    bat_release(fill);
    free_patches(plane);
    if (status == BATTEN_OK && options->curvature)
        status = bat_fill_bend(loop, out);
    return status;
}

/* Does it keep its sides? */
static batten_status judge_gaps(const bat_fill_loop *loop,
                                const batten_surface_fill_options *options,
                                const batten_surface_fill_report *report)
{
    /* A given tolerance is not asked for below nine digits; without one, a millionth of the hole. */
    const double most = options->tolerance > 0
                            ? bat_max(options->tolerance, BAT_MEANT_SAME * loop->size)
                            : 1e-6 * loop->size;
    for (int i = 0; i < report->count; i++) {
        const batten_fill_edge *edge = &report->outer[i];
        if (!(edge->gap <= most))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "the fill misses curve %d by %.3g at (%g, %g, %g), more than %.3g",
                            edge->curve + 1, edge->gap, edge->gap_at[0], edge->gap_at[1],
                            edge->gap_at[2], most);
    }
    return BATTEN_OK;
}

/* Is it good enough to be given? */
static batten_status check_quality(const batten_surface_fill_options *options,
                                   const batten_surface_fill_report *report)
{
    const batten_fill_edge *worst = &report->inner[0];
    for (int i = 1; i < report->count; i++)
        if (report->inner[i].curvature > worst->curvature)
            worst = &report->inner[i];
    const double *at = worst->curvature_at, *fold = report->fold_at;
    if (options->curvature && !(worst->curvature <= report->most_curvature))
        return bat_fail(
            BATTEN_TOLERANCE_NOT_MET,
            "with curvature taken over the fill bends unevenly%s: between its surfaces %d and "
            "%d the curvature differs by %.3g at (%g, %g, %g), more than %.3g, and the "
            "surfaces around bend by at most %.3g (1 / length); continuity G1 does better",
            report->folded ? " and folds over" : "", worst->first + 1, worst->second + 1,
            worst->curvature, at[0], at[1], at[2], report->most_curvature,
            report->rim_curvature);
    if (report->folded && !options->may_fold)
        return bat_fail(BATTEN_TOLERANCE_NOT_MET, "the fill folds over near (%g, %g, %g)%s",
                        fold[0], fold[1], fold[2],
                        options->curvature ? ": with curvature taken over; continuity G1 may "
                                             "do better"
                                           : "");
    return BATTEN_OK;
}

/* A surface of the loop that is a formula, and the spline near it. */
static batten_status make_formula(const bat_fill_loop *loop, int quad,
                                  const batten_surface_fill_options *options,
                                  batten_surface **out)
{
    batten_surface *formula = NULL;
    batten_status status = bat_fill_formula(loop, quad, options->form, &formula);
    if (status != BATTEN_OK || !options->as_splines) {
        *out = formula;
        return status;
    }
    /* Without a tolerance a millionth of the hole, as judge_gaps asks for. */
    const double within = options->tolerance > 0
                              ? bat_max(options->tolerance / loop->size, BAT_MEANT_SAME)
                              : 1e-6;
    status = batten_surface_to_smooth_nurbs(formula, within, options->angle, NULL, NULL, out);
    batten_surface_unref(formula);
    return status;
}

static batten_status make_patches(const bat_fill_loop *loop,
                                  const batten_surface_fill_options *options,
                                  batten_surface_fill_report *report, batten_surface **out)
{
    batten_status status = bat_fill_corners(loop, report);
    if (status == BATTEN_OK && options->form == BATTEN_FILL_SPLIT)
        status = split_loop(loop, options, out);
    for (int i = 0;
         options->form != BATTEN_FILL_SPLIT && status == BATTEN_OK && i < loop->count; i++)
        status = make_formula(loop, i, options, &out[i]);
    if (status == BATTEN_OK)
        status = bat_fill_measure(loop, out, report);
    if (status == BATTEN_OK)
        status = judge_gaps(loop, options, report);
    if (status == BATTEN_OK)
        status = check_quality(options, report);
    return status;
}

batten_status batten_surface_fill(int count, const batten_ribbon *sides,
                                  const batten_surface_fill_options *options,
                                  batten_surface_fill_report *report, batten_surface **out)
{
    batten_surface_fill_options chosen = batten_surface_fill_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_fill_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    batten_surface *patches[BATTEN_FILL_SIDES] = {NULL}, *placed[BATTEN_FILL_SIDES] = {NULL};
    batten_surface_fill_report *reached = bat_array(1, sizeof *reached);
    bat_fill_loop loop = {0};
    status = reached ? check_options(&chosen) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_fill_loop_make(count, sides, chosen.tolerance, reached, &loop);
    if (status == BATTEN_OK)
        status = make_patches(&loop, &chosen, reached, patches);
    const batten_affine map = batten_affine_compose(
        batten_affine_scaling(loop.size, loop.size, loop.size),
        batten_affine_translation(loop.centre[0], loop.centre[1], loop.centre[2]));
    for (int i = 0; status == BATTEN_OK && i < loop.count; i++)
        status = batten_surface_transform(patches[i], &map, &placed[i]);
    if (report && (status == BATTEN_OK || status == BATTEN_TOLERANCE_NOT_MET))
        *report = *reached;
    if (status == BATTEN_OK)
        memcpy(out, placed, sizeof placed);
    else
        free_patches(placed);
    free_patches(patches);
    bat_fill_loop_free(&loop);
    bat_release(reached);
    return status;
}
