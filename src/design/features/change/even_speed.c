/* The feature 'even-speed': nearly the same curves, with their arc length as parameter. */
#include "base/plural.h"
#include "design/feature.h"

#include <batten/approximate.h>

static const batten_parameter parameters[] = {
    {"even-speed", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "the curves"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far from the curve; a tenth of the tolerance of the design by default"},
};

static batten_status change_even_speed(const bat_run *run, const batten_curve *curve,
                                       double *error, batten_curve **out)
{
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run) / 10;
    batten_curve_even_speed_report report;
    const batten_status status = batten_curve_even_speed(curve, within, &report, out);
    if (status != BATTEN_OK)
        return status;
    *error = report.error;
    bat_remark(run, "length %.10g; the speed is 1 to within %.2g on %d piece%s", report.length,
               report.speed, report.pieces, bat_plural(report.pieces));
    return BATTEN_OK;
}

static batten_status run_even_speed(bat_run *run)
{
    return bat_change_all(run, &(bat_change){.near_curve = change_even_speed});
}

const bat_feature bat_feature_even_speed = {
    .shown =
        {"even-speed", "Nearly the same curves, with their arc length as parameter",
         "For feeds, cameras and whatever else steps along a curve by its parameter. Only straight\n"
         "lines have such a form exactly; other curves are followed 'within' the tolerance, at\n"
         "equal lengths, by pieces of degree 5 with the tangents and curvatures of the curve. The\n"
         "result has more control points; corners and cusps stay what they are.",
         "features:\n"
         "  oval: {ellipse: 2 m, b: 1 m}\n"
         "  track: {even-speed: oval, within: 0.1 mm}\n",
         "[PT97]", "batten_curve_even_speed", BAT_PARAMETERS(parameters), false,
         .also = "arc length parametrisation, constant speed, feed rate, reparametrise",
         .formula = "    |C′(s)| = 1:  s the arc length",
         .promise = "The curve is met within the tolerance at equal lengths."},
    .run = run_even_speed};
