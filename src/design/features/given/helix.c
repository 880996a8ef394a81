/* The feature 'helix': a screw line on a cylinder or a cone. */
#include "design/features/given/equations.h"
#include "design/shared/place.h"

static const batten_parameter parameters[] = {
    {"helix", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius"},
    {"end-radius", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the radius at its end, of a helix on a cone; as at the start by default"},
    {"pitch", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "how far it rises in a turn; below 0 it is left-handed and goes down"},
    {"turns", BATTEN_VALUE_NUMBER, false, true, NULL, NULL, "how many, also 2.5"},
    BAT_EQUATION_WITHIN,
    BAT_PLACE,
};

static batten_status run_helix(bat_run *run)
{
    batten_curve *helix = NULL;
    double error = 0;
    const double radius = bat_number(run, "helix");
    const double end = bat_has(run, "end-radius") ? bat_number(run, "end-radius") : radius;
    const batten_status status =
        batten_curve_helix((batten_interval){radius, end}, bat_number(run, "pitch"),
                           bat_number(run, "turns"), bat_equation_within(run), &error, &helix);
    if (status == BATTEN_OK)
        bat_report_error(run, error, error);
    return bat_place_curve(run, status, helix);
}

const bat_feature bat_feature_helix = {
    .shown =
        {"helix", "A helix, on a cylinder or a cone, with a proved error",
         "P(t) = (r cos 2\u03c0t, r sin 2\u03c0t, p t) about 'axis', from 'at', counter-clockwise as seen from\n"
         "the tip of the axis, beginning at angle 0 as an arc does. t counts turns. Its curvature is\n"
         "r / (r\u00b2 + (p / 2\u03c0)\u00b2). No NURBS curve is a helix; this one is C2 and nowhere farther from it\n"
         "than 'within'.",
         "features:\n"
         "  thread: {helix: 5 mm, pitch: 1.25 mm, turns: 8}\n"
         "  spring: {helix: 20 mm, end-radius: 12 mm, pitch: 6 mm, turns: 6.5}\n",
         "[MKC09]", "batten_curve_helix", BAT_PARAMETERS(parameters), false,
         .also = "screw line, spring, thread, coil, conical spiral",
         .formula = "    P(t) = (r cos 2\u03c0t, r sin 2\u03c0t, p t)",
         .promise = "It is C2, and no farther from the helix than the error, which is proved."},
    .run = run_helix};
