/* The feature 'fit-circle': the circle nearest to points, in any plane. */
#include "design/features/near/primitive.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"fit-circle", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points, or a table of offsets"},
    {"by", BATTEN_VALUE_WORD, false, false, "distances", "distances taubin pratt kasa",
     "what is made least: the distances, or an expression close to them that needs no iteration"},
    BAT_WHOLE,
    BAT_EACH,
};

static batten_status draw_circle(bat_run *run, const char *name,
                                 const batten_fitted_circle *circle, batten_curve **out)
{
    const bool whole = bat_yes(run, "whole");
    bat_remark(run, "'%s': a circle of radius %.9g about [%.9g, %.9g, %.9g]", name,
               circle->radius, circle->frame.origin.x, circle->frame.origin.y,
               circle->frame.origin.z);
    return batten_curve_arc_in(&circle->frame, circle->radius, circle->start,
                               whole ? 2 * BAT_PI : circle->angle, out);
}

static batten_status make_fit_circle(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_fitted_circle circle;
    batten_primitive_report report;
    batten_status status =
        batten_circle_fit((batten_points){3, data->count, data->points},
                          (batten_circle_method)bat_word(run, "by"), &report, &circle);
    if (status == BATTEN_OK) {
        made->has_parameters = false;
        status = draw_circle(run, data->name, &circle, &made->curve);
    }
    return bat_made_primitive(&report, status, made);
}

static batten_status run_fit_circle(bat_run *run)
{
    static const bat_method method = {3, BAT_IN_SPACE, make_fit_circle};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fit_circle = {
    .shown =
        {"fit-circle", "The circle nearest to points, in any plane",
         "For measured holes, pipes, rims and corner rounds: the points may go all around or lie\n"
         "on a short arc. In space the plane nearest to them is found first. 'distances' makes the\n"
         "sum of squared distances least; 'taubin' and 'pratt' come close to it, and 'kasa' gives\n"
         "circles that are too small on short arcs. Radius and centre are noted. With 'whole: no'\n"
         "the arc ends beside the first and the last point. Points on a straight line have no\n"
         "circle and are refused.",
         "features:\n"
         "  marks: {points: [[1 m, 0], [71 cm, 70 cm], [0, 1.01 m], [-70 cm, 71 cm]]}\n"
         "  rim: {fit-circle: marks}\n",
         "[Taubin91], [Pratt87]", "batten_circle_fit", BAT_PARAMETERS(parameters), false,
         .also = "best circle, Taubin, Pratt, Kåsa, hole, radius of points",
         .formula = "    Σ (|Q_j − c| − r)² → minimum;  kasa: Σ (|Q_j − c|² − r²)²",
         .promise = "With distances the sum of squared distances is a minimum."},
    .run = run_fit_circle};
