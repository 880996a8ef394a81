/* The feature 'reverse': the same shape, run through the other way. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"reverse", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, batten_curve **out)
{
    (void)run;
    return batten_curve_reverse(given, out);
}

static batten_status chain(const bat_run *run, const batten_chain *given, batten_chain **out)
{
    (void)run;
    return batten_chain_reverse(given, out);
}

static batten_status surface(const bat_run *run, const batten_surface *given,
                             batten_surface **out)
{
    return batten_surface_reverse(given, (batten_direction)bat_word(run, "direction"), out);
}

static batten_status run_reverse(bat_run *run)
{
    return bat_change_all(run,
                          &(bat_change){.curve = curve, .chain = chain, .surface = surface});
}

const bat_feature bat_feature_reverse = {
    .shown = {"reverse", "The same shape, run through the other way", "Exact.",
              "features:\n"
              "  keel: {line: [[0, 0], [3 m, 0]]}\n"
              "  astern: {reverse: keel}\n",
              "[PT97 section 6.5]", "batten_curve_reverse", BAT_PARAMETERS(parameters), false,
              .also = "flip direction, invert"},
    .run = run_reverse};
