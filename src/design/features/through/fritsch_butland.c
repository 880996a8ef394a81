#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"fritsch-butland", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    return bat_make_of_slopes(data, BATTEN_SLOPE_FRITSCH_BUTLAND, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_fritsch_butland = {
    .shown =
        {"fritsch-butland",
         "A cubic function with harmonic means of slopes: monotone and tight",
         "The method known as PCHIP: each slope is a weighted harmonic mean of those of the chords\n"
         "before and after, 0 where the data turn. Monotone where the data are, visually tight at\n"
         "steps, no parameter to choose. Somewhat flatter than fritsch-carlson beside short chords.\n"
         "Points must rise along one axis; second derivatives jump.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {fritsch-butland: tank}\n",
         "[FB84]", "batten_slopes", BAT_PARAMETERS(parameters), false},
    .run = run};
