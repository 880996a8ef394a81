/* The feature 'fit-line': the straight line nearest to points. */
#include "design/features/near/primitive.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"fit-line", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "points, or a table of offsets"},
    BAT_EACH,
};

/* A foot's parameter goes from 0 at the outermost on one side to 1 at that on the other, whatever rounding says. */
static void take_feet(const batten_fitted_line *line, const bat_data *data, double *feet)
{
    for (int i = 0; i < data->count; i++) {
        double s = 0;
        for (int k = 0; k < 3; k++)
            s += (data->points[3 * i + k] - line->point[k]) * line->direction[k];
        feet[i] = bat_max(0, bat_min(1, (s - line->from) / (line->to - line->from)));
    }
}

static batten_status draw_line(const batten_fitted_line *line, batten_curve **out)
{
    double ends[2][3];
    for (int k = 0; k < 3; k++) {
        ends[0][k] = line->point[k] + line->from * line->direction[k];
        ends[1][k] = line->point[k] + line->to * line->direction[k];
    }
    return batten_curve_line(3, ends[0], ends[1], out);
}

static batten_status make_fit_line(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    batten_fitted_line line;
    batten_primitive_report report;
    batten_status status =
        batten_line_fit((batten_points){3, data->count, data->points}, &report, &line);
    if (status == BATTEN_OK) {
        take_feet(&line, data, made->parameters);
        status = draw_line(&line, &made->curve);
    }
    return bat_made_primitive(&report, status, made);
}

static batten_status run_fit_line(bat_run *run)
{
    static const bat_method method = {2, BAT_IN_SPACE, make_fit_line};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fit_line = {
    .shown =
        {"fit-line", "The straight line nearest to points",
         "Distances are measured at right angles to the line, so the line does not depend on the\n"
         "axes: for edges that should be straight, keels, axes of holes. It runs as the points do,\n"
         "between the outermost feet of the perpendiculars from them. Every point counts, outliers\n"
         "most. Points that spread equally in several directions, such as the corners of a square,\n"
         "have no nearest line and are refused; so are points that all coincide.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 11 cm], [2 m, 19 cm], [3 m, 31 cm]]}\n"
         "  keel: {fit-line: marks}\n",
         "[GVL13]", "batten_line_fit", BAT_PARAMETERS(parameters), false,
         .also = "regression line, total least squares, orthogonal regression",
         .formula = "    Σ |(Q_j − c) × d|² → minimum,  |d| = 1",
         .promise = "The sum of squared distances at right angles is the least of all lines."},
    .run = run_fit_line};
