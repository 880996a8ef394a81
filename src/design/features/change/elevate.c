/* The feature 'elevate': the same shape with a higher degree. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"elevate", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "curves, surfaces, triangles"},
    {"by", BATTEN_VALUE_COUNT, false, false, "1", NULL, "how much higher the degree becomes"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static batten_status curve(const bat_run *run, const batten_curve *given, batten_curve **out)
{
    return batten_curve_elevate(given, bat_count(run, "by"), out);
}

static batten_status surface(const bat_run *run, const batten_surface *given,
                             batten_surface **out)
{
    return batten_surface_elevate(given, (batten_direction)bat_word(run, "direction"),
                                  bat_count(run, "by"), out);
}

static batten_status triangles(const bat_run *run, const batten_triangles *given,
                               batten_triangles **out)
{
    return batten_triangles_elevate(given, bat_count(run, "by"), out);
}

static batten_status run_elevate(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.curve = curve,
                                             .surface = surface,
                                             .triangles = triangles,
                                             .keeps_data = true});
}

const bat_feature bat_feature_elevate = {
    .shown = {"elevate", "The same shape with a higher degree", "Exact.",
              "features:\n"
              "  keel: {line: [[0, 0], [3 m, 0]]}\n"
              "  cubic: {elevate: keel, by: 2}\n",
              "[PT97 section 5.5]", "batten_curve_elevate", BAT_PARAMETERS(parameters), false,
              .also = "degree elevation, raise degree"},
    .run = run_elevate};
