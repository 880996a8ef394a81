/* The feature 'fit-within': few control points, and no point farther than a bound. */
#include "base/plural.h"
#include "design/shared/through.h"
#include <batten/approximate.h>

static const batten_parameter parameters[] = {
    {"fit-within", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "points, or a table of offsets"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the distance from the curve that no point exceeds"},
    {"by", BATTEN_VALUE_WORD, false, false, "fewest", "fewest insert remove bezier",
     "how knots are found; 'bezier' divides cubics instead"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "1 to 25"},
    {"corner", BATTEN_VALUE_ANGLE, false, false, "0", NULL,
     "where the points turn by more, the curve has a corner; 0: nowhere"},
    {"corners", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points that are corners, counted from 1"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make_fit_within(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_within_options options = batten_curve_within_defaults();
    batten_curve_within_report report;
    int *corners = NULL;
    options.tolerance = bat_number(run, "within");
    options.method = (batten_within_method)bat_word(run, "by");
    options.degree = bat_count(run, "degree");
    options.corner = bat_number(run, "corner");
    options.closed = bat_yes(run, "closed");
    options.parameters = bat_parametrization_of(run, data);
    options.given = data->abscissae;
    options.job = run->job;
    batten_status status = bat_indices(run, "corners", &options.corner_count, &corners);
    options.corners = corners;
    if (status == BATTEN_OK)
        status =
            batten_curve_within((batten_points){data->dimension, data->count, data->points},
                                &options, made->parameters, &report, &made->curve);
    bat_release(corners);
    if (status != BATTEN_OK)
        return status;
    bat_remark(
        run,
        "'%s': %d control point%s for %d point%s, %d corner%s; between points the curve is up "
        "to %.3g from their polygon",
        data->name, report.points, bat_plural(report.points), data->count,
        bat_plural(data->count), report.corners, bat_plural(report.corners), report.apart);
    made->has_error = true;
    made->error_max = report.error;
    made->error_rms = report.rms;
    return BATTEN_OK;
}

static batten_status run_fit_within(bat_run *run)
{
    return bat_through(run, &(bat_method){.least = 2,
                                          .ways = BAT_IN_SPACE | BAT_AS_FUNCTION,
                                          .make = make_fit_within});
}

const bat_feature bat_feature_fit_within = {
    .shown =
        {"fit-within", "Few control points, and no point farther than a bound",
         "For digitised lines, aerofoils and contours: the tolerance is the accuracy of the\n"
         "points, and the curve has hardly more control points than that takes. 'insert' starts with\n"
         "one span and adds knots where points are too far off, 'remove' starts with one knot for\n"
         "each point; both then take away the knots that the tolerance can spare, fitting anew\n"
         "each time. 'fewest' tries both; above 5000 points 'insert' alone where that suffices.\n"
         "'bezier' is fast and local: cubics with common tangents, divided where they are too far\n"
         "off, with about twice as many control points and with steps in curvature. Give\n"
         "'corner: 40 deg', or the points in 'corners', where the line has corners; they are kept\n"
         "exactly, as the ends are. The curve may not swing between points by more than their\n"
         "polygon turns there, unless no other curve is close enough; how far it leaves that polygon\n"
         "is noted. A tolerance below the noise of the points costs a knot for each of them: it is\n"
         "met if a curve through all points meets it, and otherwise refused with the distance that\n"
         "was reached. For a function distances are measured along its second axis.",
         "features:\n"
         "  scan: {points: [[0, 0], [1 m, 20 cm], [2 m, 31 cm], [3 m, 40 cm], [4 m, 39 cm], [5 m, 30 cm], [6 m, 19 cm]]}\n"
         "  edge: {fit-within: scan, within: 1 cm}\n",
         "[LM88], [Schneider90]", "batten_curve_within", BAT_PARAMETERS(parameters), false,
         .also = "tolerance fit, Lyche Mørken, data reduction, Schneider, digitised curve",
         .formula =
             "    max_j |C(t_j) − Q_j| ≤ within, with as few control points as are found",
         .promise =
             "No point is farther from the curve than the bound, or it is refused with what was reached."},
    .run = run_fit_within};
