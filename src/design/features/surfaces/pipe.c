/* The feature 'pipe': a round pipe around a curve. */
#include "design/shared/sweeps.h"

static const batten_parameter parameters[] = {
    {"pipe", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the spines"},
    {"radius", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "of the pipe"},
    BAT_SWEEP_CORNERS,
    BAT_SWEEP_BOUNDS,
};

static batten_status pipe(bat_run *run, const batten_curve *spine)
{
    const batten_box box = batten_curve_box(spine);
    const double size = fabs(box.low.x) + fabs(box.low.y) + fabs(box.low.z) + fabs(box.high.x) +
                        fabs(box.high.y) + fabs(box.high.z);
    batten_surface_sweep_options options = batten_surface_sweep_defaults();
    options.tolerance = bat_sweep_within(run);
    options.degree = bat_count(run, "degree");
    options.corners = (batten_corner_kind)bat_word(run, "corners");
    options.allow_folds = bat_yes(run, "folds");
    /* So that the seam of the circle closes too. */
    if (batten_curve_is_closed(spine, 1e-10 * size))
        options.frames = BATTEN_FRAME_CLOSING;
    batten_surfaces made = {0, NULL};
    batten_surface_sweep_report report;
    const batten_status status = batten_surfaces_pipe(bat_number(run, "radius"), spine,
                                                      &options, run->job, &report, &made);
    return bat_put_sweep(run, status, made.count, made.at, &report);
}

static batten_status run_pipe(bat_run *run)
{
    bat_objects spines;
    batten_status status = bat_gather(run, "pipe", BAT_CURVES, &spines);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < spines.count && status == BATTEN_OK; i++)
        status = pipe(run, spines.at[i]->curve);
    bat_objects_release(&spines);
    return status;
}

const bat_feature bat_feature_pipe = {
    .shown =
        {"pipe", "A round pipe around a curve",
         "A circle swept along the curve, exact around and within the tolerance along it. Where\n"
         "its radius is not below the radius of curvature the pipe is refused, and the message\n"
         "says where. A closed curve makes a closed pipe; corners are mitred or split.",
         "units: m\n"
         "features:\n"
         "  way: {points: [[0, 0, 0], [2, 0, 0], [3, 1, 0], [3, 2, 1]]}\n"
         "  axis: {interpolate: way}\n"
         "  tube: {pipe: axis, radius: 15 cm}\n",
         "[PT97 section 10.4] [BR91]", "batten_surfaces_pipe", BAT_PARAMETERS(parameters),
         false, .also = "tube, hose, canal surface of constant radius",
         .formula = "    S(u, v) = γ(v) + r (cos u · x(v) + sin u · y(v))",
         .promise = "It is exact around and within the tolerance along."},
    .run = run_pipe,
    .displacing = "pipe"};
