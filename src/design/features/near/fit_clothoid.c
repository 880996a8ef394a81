/* The feature 'fit-clothoid': the clothoid nearest to points of a plane. */
#include "design/features/near/primitive.h"

static const batten_parameter parameters[] = {
    {"fit-clothoid", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points in a plane, in their order along it, or a table of offsets"},
    BAT_EACH,
};

/* The parameters are lengths, from 0 to that of the whole. */
static batten_status draw_clothoid(bat_run *run, const bat_data *data, const batten_span *span,
                                   bat_made *made)
{
    for (int i = 0; i < data->count; i++)
        made->parameters[i] = bat_max(0, bat_min(span->length, made->parameters[i]));
    bat_remark(run, "'%s': a clothoid of length %.9g, curvature %.9g to %.9g", data->name,
               span->length, span->curvature[0],
               span->curvature[0] + span->length * span->curvature[1]);
    return batten_chain_create(&(batten_chain_parts){2, 1, span, NULL, false}, 0, &made->chain);
}

static batten_status make_fit_clothoid(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_span span;
    batten_primitive_report report;
    batten_status status = batten_clothoid_fit((batten_points){2, data->count, data->points}, run->job,
                                               made->parameters, &report, &span);
    if (status == BATTEN_OK)
        status = draw_clothoid(run, data, &span, made);
    return bat_made_primitive(&report, status, made);
}

static batten_status run_fit_clothoid(bat_run *run)
{
    static const bat_method method = {4, BAT_IN_PLANE, make_fit_clothoid};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fit_clothoid = {
    .shown =
        {"fit-clothoid", "The clothoid nearest to points of a plane",
         "One span whose curvature changes evenly along its length: a measured transition of a\n"
         "road or a rail, the run of a plank. Lines and arcs are clothoids too, and points on them\n"
         "give them back. The length and the curvatures at the ends are noted. The points must be\n"
         "given in their order along the curve, no two neighbours coinciding, and the curve may\n"
         "turn by less than a right angle between two of them. Points that no clothoid passes near\n"
         "are refused when the iteration finds none; for a curve of many spans use 'euler-spiral'.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 1 cm], [2 m, 7 cm], [3 m, 22 cm], [4 m, 53 cm]]}\n"
         "  ramp: {fit-clothoid: marks}\n",
         "[ARW01]", "batten_clothoid_fit", BAT_PARAMETERS(parameters), false,
         .also = "best spiral, transition curve, Cornu spiral",
         .formula = "    Σ dist(Q_j, C)² → minimum over C with κ(s) = κ0 + κ1 s",
         .promise = "The sum of squared distances at right angles is a minimum."},
    .run = run_fit_clothoid};
