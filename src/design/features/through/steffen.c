#include "design/shared/local.h"

static const batten_parameter parameters[] = {
    {"steffen", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "a table of offsets, rows of points, or curves that have points"},
    BAT_EACH,
};

static batten_status make(bat_run *run, const bat_data *data, bat_made *made)
{
    (void)run;
    return bat_make_of_slopes(data, BATTEN_SLOPE_STEFFEN, made);
}

static batten_status run(bat_run *run)
{
    static const bat_method method = {2, BAT_AS_FUNCTION, make};
    return bat_through(run, &method);
}

const bat_feature bat_feature_steffen = {
    .shown =
        {"steffen", "A cubic function with extrema at points only",
         "The slope of the parabola through three points, but never steeper than twice the flatter of\n"
         "the two chords, and 0 where the data turn. So no span has an extremum inside, and smooth\n"
         "data keep their parabola. Points must rise along one axis.",
         "features:\n"
         "  tank: {points: [[0, 0], [1 m, 5 cm], [2 m, 10 cm], [3 m, 90 cm], [5 m, 1 m]]}\n"
         "  level: {steffen: tank}\n",
         "[Steffen90]", "batten_slopes", BAT_PARAMETERS(parameters), false},
    .run = run};
