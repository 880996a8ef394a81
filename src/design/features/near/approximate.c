/* The feature 'approximate': nearly the same curve as a plain B-spline of a wanted degree. */
#include "base/plural.h"
#include "design/feature.h"
#include <batten/approximate.h>

static const batten_parameter parameters[] = {
    {"approximate", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "the curves"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "how far a curve may move"},
    {"degree", BATTEN_VALUE_COUNT, false, false, "3", NULL, "of the new curves, 1 to 25"},
};

static batten_status approximate(bat_run *run, const batten_object *object)
{
    const int degree = bat_count(run, "degree");
    const double tolerance = bat_number(run, "within");
    batten_curve *made = NULL;
    double error = 0;
    batten_status status =
        object->chain
            ? batten_chain_approximate(object->chain, degree, tolerance, &error, &made)
            : batten_curve_approximate(object->curve, degree, tolerance, &error, &made);
    if (status == BATTEN_OK) {
        bat_remark(run, "'%s': %d control point%s instead of %d", object->name,
                   batten_curve_point_count(made), bat_plural(batten_curve_point_count(made)),
                   batten_curve_point_count(object->curve));
        bat_report_error(run, error, error);
    } else if (status != BATTEN_OUT_OF_MEMORY && status != BATTEN_CANCELLED) {
        status = bat_fail(status, "%s: %s", object->name, batten_message());
    }
    /* Parameters stay, so those of the points do. */
    return bat_put_curve_like(run, status, made, object, true);
}

static batten_status run_approximate(bat_run *run)
{
    return bat_for_objects(run, "approximate", BAT_CURVES, approximate);
}

const bat_feature bat_feature_approximate = {
    .shown =
        {"approximate", "Nearly the same curve as a plain B-spline of a wanted degree",
         "For systems without rational curves, high degrees, clothoids or elastica, and for curves\n"
         "with far too many knots. The new curve is polynomial, of 'degree', with as few control\n"
         "points as can be found; at equal parameters it is nowhere farther from the given one\n"
         "than 'within', which is proved by the control points of the difference and not sampled\n"
         "(only the conversion of arcs, clothoids, elastica and splines in tension to a curve is\n"
         "sampled). Ends and corners stay. A curve that closes smoothly still does. With cubics a\n"
         "sixteenth of the tolerance takes twice the spans. Tolerances below the rounding of the\n"
         "points are refused.",
         "features:\n"
         "  rim: {circle: 1 m}\n"
         "  plain: {approximate: rim, within: 0.1 mm}\n",
         "[LM88]", "batten_curve_approximate", BAT_PARAMETERS(parameters), false,
         .also = "convert to B-spline, rebuild, simplify, change degree"},
    .run = run_approximate};
