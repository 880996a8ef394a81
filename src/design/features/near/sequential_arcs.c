/* The feature 'sequential-arcs': one arc from point to point, each going on from the one
 * before. */
#include "base/plural.h"
#include "design/shared/through.h"
#include <batten/arcs.h>

static const batten_parameter parameters[] = {
    {"sequential-arcs", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"start-angle", BATTEN_VALUE_ANGLE, false, false, NULL, NULL,
     "direction at the start, from the first axis; else that with the least jumps of "
     "curvature"},
    BAT_EACH,
};

static batten_status make_sequential_arcs(bat_run *run, const bat_data *data, bat_made *made)
{
    const double degree = BAT_PI / 180;
    const double start =
        bat_has(run, "start-angle") ? bat_number(run, "start-angle") : (double)NAN;
    batten_chain_sequential_arcs_report report;
    const batten_status status =
        batten_chain_sequential_arcs((batten_points){2, data->count, data->points}, start, NULL,
                                     made->parameters, &report, &made->chain);
    if (status != BATTEN_OK)
        return status;
    bat_note(
        run,
        "'%s' begins at %g degree%s; each degree more changes the curvature of arc %d by %g, "
        "and swings on to the end; curvature jumps by %g at most",
        data->name, report.start_angle / degree,
        bat_plural_real(report.start_angle / degree, 6), report.sensitive_at + 1,
        report.sensitivity * degree, report.jump);
    if (report.long_arcs > 0)
        bat_note(run, "'%s' has %d arc%s turning by more than 180 degrees", data->name,
                 report.long_arcs, bat_plural(report.long_arcs));
    return BATTEN_OK;
}

static batten_status run_sequential_arcs(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_sequential_arcs};
    return bat_through(run, &method);
}

const bat_feature bat_feature_sequential_arcs = {
    .shown =
        {"sequential-arcs", "One arc from point to point, each going on from the one before",
         "The oldest way to draw with arcs: from the start, each arc continues in the direction in\n"
         "which the one before ends, to the next point. It has one arc for each pair of points,\n"
         "half as many as biarcs, and the joints are the points themselves. But any error at the\n"
         "start, or at a point, swings from side to side up to the end and is never damped: a note\n"
         "says by how much. Use it for a few accurate points, such as those of a template made of\n"
         "arcs; otherwise use 'arc-spline', which solves for all arcs at once, or 'biarcs'.\n"
         "Without a start angle the one is taken that makes the sum of squared jumps of curvature\n"
         "least; points of a circle then give the circle. The points lie in a plane.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 50 cm], [2 m, 60 cm], [3 m, 30 cm]]}\n"
         "  edge: {sequential-arcs: ducks}\n",
         "[SL section VI.6]", "batten_chain_sequential_arcs", BAT_PARAMETERS(parameters), false,
         .also = "arc after arc, compass",
         .formula =
             "    θ_{i+1} = 2 φ_i − θ_i,  κ_i = 2 sin(φ_i − θ_i)/l_i   (φ_i, l_i direction and length of chord i)",
         .promise =
             "Tangents are continuous; without a start angle Σ (κ_{i+1} − κ_i)² is least."},
    .run = run_sequential_arcs};
