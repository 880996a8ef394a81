#include "design/shared/near.h"

static const batten_parameter parameters[] = {
    {"smooth", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "points, or a table of offsets"},
    {"rms", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the root of the mean squared distance that may be left"},
    {"lambda", BATTEN_VALUE_NUMBER, false, false, NULL, NULL,
     "how much bending weighs against distance, instead of 'rms'"},
    {"order", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "1 to 4: which derivative shall be small"},
    BAT_PARAMETRIZATION,
    BAT_CLOSED,
    BAT_AS,
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_smooth_options options = batten_curve_smooth_defaults();
    return bat_make_smooth(run, data, batten_curve_smooth, &options, made);
}

static batten_status run(bat_run *run)
{
    return bat_through(
        run, &(bat_method){.least = 2, .ways = BAT_IN_SPACE | BAT_AS_FUNCTION, .make = make});
}

const bat_feature bat_feature_smooth = {
    .shown =
        {"smooth", "The smoothing spline: a batten tied to its points by springs",
         "A knot stands at every point, and the curve gives way to noise: 'rms' says how far, as a\n"
         "length; or 'lambda' how stiff the batten is (0 interpolates, a huge one gives the straight\n"
         "line). Without either, cross validation chooses: each point is foretold from the others\n"
         "as well as can be, which needs some thirty points whose errors have nothing to do\n"
         "with each other. Use 'order: 3' where curvature shall vary gently. Corners are\n"
         "rounded; single bad points show as bumps.",
         "features:\n"
         "  marks: {points: [[0, 0], [1 m, 19 cm], [2 m, 31 cm], [3 m, 42 cm], [4 m, 41 cm], [5 m, 33 cm], [6 m, 22 cm]]}\n"
         "  sheer: {smooth: marks, rms: 1 cm}\n",
         "[Reinsch67]", "batten_curve_smooth", BAT_PARAMETERS(parameters), false},
    .run = run};
