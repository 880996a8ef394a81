/* The feature 'tangents-and-curvatures': cubics with given directions and curvatures:
 * curvature continuous, order six. */
#include "base/plural.h"
#include "design/shared/local.h"

#include <string.h>

static const batten_parameter parameters[] = {
    {"tangents-and-curvatures", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    {"tangents", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "a direction for each point; by circles through three points when there are none"},
    {"curvatures", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "one for each point or for all, 1 by the unit, above 0 to the left; else by circles"},
    BAT_EACH,
    BAT_CLOSED,
};

/* What was not given comes from circles through three points. */
static batten_status find(bat_run *run, const bat_data *data, double **tangents,
                          double **curvatures)
{
    const size_t n = (size_t)data->count;
    batten_tangents_options options = batten_tangents_defaults();
    batten_tangents_report report = {0};
    options.closed = bat_yes(run, "closed");
    double *t = bat_array(n + 1, sizeof *t);
    batten_status status =
        t ? bat_vectors(run, data, "tangents", tangents) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && bat_argument_of(run, "curvatures")->count > 0)
        status = bat_numbers_each(run, "curvatures", data->count, "points", curvatures);
    if (status == BATTEN_OK && !*tangents) {
        *tangents = bat_array3(n, 2, sizeof **tangents);
        status = *tangents ? batten_tangents((batten_points){2, data->count, data->points},
                                             &options, t, &report, *tangents, NULL)
                           : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK && !*curvatures) {
        *curvatures = bat_array(n, sizeof **curvatures);
        status = *curvatures
                     ? batten_circle_curvatures((batten_points){2, data->count, data->points},
                                                options.closed, *curvatures)
                     : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        bat_note_turns(run, data, &report);
    bat_release(t);
    return status;
}

static batten_status make_tangents_and_curvatures(bat_run *run, const bat_data *data,
                                                  bat_made *made)
{
    const size_t n = (size_t)data->count;
    double *tangents = NULL, *curvatures = NULL, *t = bat_array(n + 1, sizeof *t);
    batten_curve_from_curvatures_report report;
    batten_status status = t ? find(run, data, &tangents, &curvatures) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_curve_from_curvatures(
            &(batten_curved_points){
                {2, data->count, data->points}, tangents, curvatures, bat_yes(run, "closed")},
            t, NULL, &report, &made->curve);
    if (status == BATTEN_OK) {
        memcpy(made->parameters, t, n * sizeof *t);
        if (report.fallen_back > 0)
            bat_note(run,
                     "in %d span%s '%s' has no cubic with these curvatures and keeps the "
                     "tangents alone; the first is after point %d",
                     report.fallen_back, bat_plural(report.fallen_back), data->name,
                     report.first_fallen_back + 1);
    }
    bat_release(t);
    bat_release(tangents);
    bat_release(curvatures);
    return status;
}

static batten_status run_tangents_and_curvatures(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_PLANE, make_tangents_and_curvatures};
    return bat_through(run, &method);
}

const bat_feature bat_feature_tangents_and_curvatures = {
    .shown =
        {"tangents-and-curvatures",
         "Cubics with given directions and curvatures: curvature continuous, order six",
         "For curves whose direction and curvature are known at the points, or for circle-like\n"
         "data where circles through three points give both: one cubic between two points matches\n"
         "direction and curvature at both, so curvature is continuous, and a smooth curve is\n"
         "approximated with an error of the sixth power of the step. A quarter of a circle is off\n"
         "by 0.002 of its radius. Of up to three solutions the one is taken whose legs are closest\n"
         "to a third of the chord. A span that has no solution, as where the curvatures bend\n"
         "against the tangents, keeps only the tangents, which is noted. The points lie in a\n"
         "plane. The speed jumps at the points, for only direction and curvature are given.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1 m, 60 cm], [2 m, 70 cm], [3 m, 20 cm], [4 m, 0]]}\n"
         "  arc: {tangents-and-curvatures: ducks}\n",
         "[SL section III.7] [dBHS87]", "batten_curve_from_curvatures",
         BAT_PARAMETERS(parameters), false,
         .also = "geometric Hermite, de Boor Höllig Sabin, G2 Hermite, high accuracy",
         .formula =
             "    (d0 × d1) δ0 = a × d1 − (3/2) κ1 δ1²,  (d0 × d1) δ1 = d0 × a − (3/2) κ0 δ0²,  a = P1 − P0\n"
             "    b0 = P0,  b1 = P0 + δ0 d0,  b2 = P1 − δ1 d1,  b3 = P1   (d unit tangents)",
         .promise =
             "Directions and curvatures are met at every point, so curvature is continuous; the error falls with h⁶."},
    .run = run_tangents_and_curvatures};
