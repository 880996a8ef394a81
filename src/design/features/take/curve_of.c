/* The feature 'curve-of': curves of constant parameter on a surface. */
#include "design/feature.h"

#include <batten/text.h>
#include <stdio.h>

static const batten_parameter parameters[] = {
    {"curve-of", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the surfaces"},
    {"u", BATTEN_VALUE_NUMBER, true, false, NULL, NULL, "curves at these values of u"},
    {"v", BATTEN_VALUE_NUMBER, true, false, NULL, NULL, "curves at these values of v"},
};

static batten_status add_curve(bat_run *run, const batten_object *object,
                               batten_direction fixed, double at)
{
    char name[260], number[BATTEN_NUMBER_SIZE];
    batten_curve *curve = NULL;
    batten_object named = *object;
    batten_number_write(at, number);
    snprintf(name, sizeof name, "%.200s %c=%s", object->name, fixed == BATTEN_U ? 'u' : 'v',
             number);
    named.name = name;
    const batten_status status = batten_surface_isocurve(object->surface, fixed, at, &curve);
    return bat_put_curve_like(run, status, curve, &named, false);
}

static batten_status add_curves(bat_run *run, const batten_object *object,
                                const char *parameter, batten_direction fixed)
{
    const bat_argument *values = bat_argument_of(run, parameter);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < values->count && status == BATTEN_OK; i++)
        status = add_curve(run, object, fixed, values->items[i].number[0]);
    return status;
}

static batten_status add_both(bat_run *run, const batten_object *surface)
{
    batten_status status = add_curves(run, surface, "u", BATTEN_U);
    if (status == BATTEN_OK)
        status = add_curves(run, surface, "v", BATTEN_V);
    return status;
}

static batten_status run_curve_of(bat_run *run)
{
    if (!bat_has(run, "u") && !bat_has(run, "v"))
        return bat_fail(BATTEN_BAD_ARGUMENT, "'u' or 'v' must say where the curves are");
    return bat_for_objects(run, "curve-of", BAT_SURFACES, add_both);
}

const bat_feature bat_feature_curve_of = {
    .shown = {"curve-of", "Curves of constant parameter on a surface",
              "Exact; named by the surface and the parameter: 'tank u=0.5'.",
              "features:\n"
              "  tank: {cylinder: 0.4 m, height: 1 m}\n"
              "  rims: {curve-of: tank, v: [0, 1]}\n",
              "[PT97]", "batten_surface_isocurve", BAT_PARAMETERS(parameters), false,
              .also = "isoparametric curve, isocurve, edge of a surface, isoline"},
    .run = run_curve_of,
    .displacing = "curve-of"};
