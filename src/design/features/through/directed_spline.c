/* The feature 'directed-spline': a spline through points with given directions at some of
 * them. */
#include "base/plural.h"
#include "design/shared/through.h"
#include <batten/local.h>

static const batten_parameter parameters[] = {
    {"directed-spline", BATTEN_VALUE_MODEL, false, true, NULL, NULL,
     "rows of points, a table of offsets, or curves that have points"},
    BAT_EACH,
    {"at", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points with a given direction, counted from 1"},
    {"directions", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "one for each of these; their lengths do not matter"},
    {"tension", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "nu of all points, or one for each: where it is large the curve bends sharply"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "chord",
     "centripetal chord uniform foley foley-chord", "how points get parameters"},
};

static batten_status find_directions(const bat_run *run, batten_curve_directed_options *options,
                                     batten_direction_at **out)
{
    const bat_argument *at = bat_argument_of(run, "at");
    const bat_argument *directions = bat_argument_of(run, "directions");
    if (at->count != directions->count)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "'at' names %d point%s and 'directions' has %d",
                        at->count, bat_plural(at->count), directions->count);
    int count = 0, *points = NULL;
    const batten_status status = bat_indices(run, "at", &count, &points);
    if (status != BATTEN_OK)
        return status;
    batten_direction_at *made = bat_array((size_t)at->count, sizeof *made);
    for (int i = 0; made && i < at->count; i++) {
        made[i].index = points[i];
        for (int k = 0; k < 3; k++)
            made[i].vector[k] = directions->items[i].number[k];
    }
    bat_release(points);
    options->direction_count = at->count;
    options->directions = *out = made;
    return made ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status find_tension(const bat_run *run, int count,
                                  batten_curve_directed_options *options, double **out)
{
    const bat_argument *given = bat_argument_of(run, "tension");
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != 1 && given->count != count)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "'tension' has %d number%s for %d point%s; it takes 1 or one for each",
                        given->count, bat_plural(given->count), count, bat_plural(count));
    *out = bat_array((size_t)count, sizeof **out);
    for (int i = 0; *out && i < count; i++)
        (*out)[i] = given->items[given->count == 1 ? 0 : i].number[0];
    options->tension = *out;
    return *out ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status make_directed_spline(bat_run *run, const bat_data *data, bat_made *made)
{
    batten_curve_directed_options options = batten_curve_directed_defaults();
    batten_curve_directed_report report = {0};
    batten_direction_at *directions = NULL;
    double *tension = NULL;
    options.parameters = (batten_parametrization)bat_word(run, "parameters");
    batten_status status = find_directions(run, &options, &directions);
    if (status == BATTEN_OK)
        status = find_tension(run, data->count, &options, &tension);
    if (status == BATTEN_OK)
        status =
            batten_curve_directed((batten_points){data->dimension, data->count, data->points},
                                  &options, made->parameters, &report, &made->curve);
    if (status == BATTEN_OK && report.clamped > 0)
        bat_note(run,
                 "%d of the directions of '%s' lead against the points, the first at point %d; "
                 "the curve is slow there",
                 report.clamped, data->name, report.first_clamped + 1);
    bat_release(directions);
    bat_release(tension);
    return status;
}

static batten_status run_directed_spline(bat_run *run)
{
    const bat_method method = {.least = 2, .ways = BAT_IN_SPACE, .make = make_directed_spline};
    return bat_through(run, &method);
}

const bat_feature bat_feature_directed_spline = {
    .shown =
        {"directed-spline", "A spline through points with given directions at some of them",
         "The cubic spline of least energy that passes through the points and has the given\n"
         "directions at those listed in 'at'; its speed there is found. Use it where a curve must\n"
         "leave along a frame, be upright at the bow or level at the crown. At all other points\n"
         "its second derivative is continuous; at those with a direction only the component along\n"
         "that direction is, so that curvature may jump there. 'tension' draws the curve tight at\n"
         "points, as a weight on a batten does: its curvature stays continuous. Directions against\n"
         "the order of the points are passed slowly, which is noted.",
         "features:\n"
         "  ducks: {points: [[0, 0], [1, 1], [2, 1.2], [3, 0.6], [4, 0]]}\n"
         "  crown: {directed-spline: ducks, at: [1, 3], directions: [[0, 1], [1, 0]]}\n",
         "[SL section III.7] [Utah74 paper 10] [Nielson74]", "batten_curve_directed",
         BAT_PARAMETERS(parameters), false,
         .also = "clamped spline, given tangents, tangent constraint, direction constraint",
         .formula =
             "    S(t_i) = P_i,  S′(t_k) = λ_k d_k,  λ_k > 0,  for the directions d_k that are given",
         .promise =
             "∫ |S″|² dt + Σ ν_i |S′(t_i)|² is least of all such curves, but where a λ_k would not be positive."},
    .run = run_directed_spline};
