/* The feature 'part': the part between two parameters. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"part", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"from", BATTEN_VALUE_NUMBER, false, true, NULL, NULL,
     "the parameter at which the part begins"},
    {"to", BATTEN_VALUE_NUMBER, false, true, NULL, NULL, "the parameter at which it ends"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, batten_curve **out)
{
    return batten_curve_subrange(given, bat_number(run, "from"), bat_number(run, "to"), out);
}

static batten_status chain(const bat_run *run, const batten_chain *given, batten_chain **out)
{
    return batten_chain_subrange(given, bat_number(run, "from"), bat_number(run, "to"), out);
}

static batten_status surface(const bat_run *run, const batten_surface *given,
                             batten_surface **out)
{
    return batten_surface_subrange(given, (batten_direction)bat_word(run, "direction"),
                                   bat_number(run, "from"), bat_number(run, "to"), out);
}

static batten_status run_part(bat_run *run)
{
    return bat_change_all(run,
                          &(bat_change){.curve = curve, .chain = chain, .surface = surface});
}

const bat_feature bat_feature_part = {
    .shown =
        {"part", "The part between two parameters",
         "Exact; the part keeps its parameters. Of curves made of arcs, spirals and elastica the\n"
         "part is made of them too.",
         "features:\n"
         "  keel: {line: [[0, 0], [3 m, 0]]}\n"
         "  fore: {part: keel, from: 0.5, to: 1}\n",
         "[PT97 section 5.2]", "batten_curve_subrange", BAT_PARAMETERS(parameters), false,
         .also = "subcurve, subpatch, segment of a curve, trim by parameters"},
    .run = run_part,
    .cuts = true};
