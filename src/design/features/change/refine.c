/* The feature 'refine': the same shape with more knots and control points. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"refine", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves and surfaces"},
    {"knots", BATTEN_VALUE_NUMBER, true, true, NULL, NULL,
     "the knots to insert, never decreasing"},
    {"direction", BATTEN_VALUE_WORD, false, false, "u", "u v", "of surfaces"},
};

static double *list_knots(const bat_run *run, int *count)
{
    const bat_argument *given = bat_argument_of(run, "knots");
    double *knots = bat_array((size_t)given->count, sizeof *knots);
    for (int i = 0; knots && i < given->count; i++)
        knots[i] = given->items[i].number[0];
    *count = given->count;
    return knots;
}

static batten_status curve(const bat_run *run, const batten_curve *given, batten_curve **out)
{
    int count;
    double *knots = list_knots(run, &count);
    const batten_status status =
        knots ? batten_curve_refine(given, count, knots, out) : BATTEN_OUT_OF_MEMORY;
    bat_release(knots);
    return status;
}

static batten_status surface(const bat_run *run, const batten_surface *given,
                             batten_surface **out)
{
    int count;
    double *knots = list_knots(run, &count);
    const batten_direction direction = (batten_direction)bat_word(run, "direction");
    const batten_status status =
        knots ? batten_surface_refine(given, direction, count, knots, out)
              : BATTEN_OUT_OF_MEMORY;
    bat_release(knots);
    return status;
}

static batten_status run_refine(bat_run *run)
{
    return bat_change_all(
        run, &(bat_change){.curve = curve, .surface = surface, .keeps_data = true});
}

const bat_feature bat_feature_refine = {
    .shown = {"refine", "The same shape with more knots and control points", "Exact.",
              "features:\n"
              "  keel: {line: [[0, 0], [3 m, 0]]}\n"
              "  finer: {refine: keel, knots: [0.25, 0.5, 0.75]}\n",
              "[PT97 section 5.3]", "batten_curve_refine", BAT_PARAMETERS(parameters), false,
              .also = "knot insertion, Boehm, Oslo algorithm, add control points"},
    .run = run_refine};
