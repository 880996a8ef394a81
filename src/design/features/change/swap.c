/* The feature 'swap': the same surface with u and v exchanged. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"swap", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the surfaces"},
};

static batten_status surface(const bat_run *run, const batten_surface *given,
                             batten_surface **out)
{
    (void)run;
    return batten_surface_swap(given, out);
}

static batten_status run_swap(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.surface = surface});
}

const bat_feature bat_feature_swap = {
    .shown = {"swap", "The same surface with u and v exchanged",
              "Exact; the normal points to the other side.",
              "features:\n"
              "  buoy: {sphere: 30 cm}\n"
              "  turned: {swap: buoy}\n",
              "", "batten_surface_swap", BAT_PARAMETERS(parameters), false,
              .also = "transpose, exchange u and v, flip normal"},
    .run = run_swap};
