#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"fritsch-carlson", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    return bat_make_of_slopes(data, BATTEN_SLOPE_FRITSCH_CARLSON, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fritsch_carlson = {
    .shown =
        {"fritsch-carlson", "A cubic function that is monotone where the data are",
         "For tables that must not overshoot: volumes, levels, distribution curves. Slopes begin as\n"
         "those of parabolas through three points and are shortened just as much as it takes that\n"
         "every span is monotone; where the data turn they are 0, so extrema lie at points. Rounder\n"
         "than fritsch-butland, and of third order where the data are smooth and monotone. The points\n"
         "must rise along one axis. Second derivatives jump; at extrema of the data the curve is\n"
         "flatter than the data suggest.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {fritsch-carlson: tank}\n",
         "[FC80]", "batten_slopes", BAT_PARAMETERS(parameters), false},
    .run = run};
