/* The feature 'ellipse': an ellipse or a part of one, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"ellipse", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "the first semi-axis, along 'from'"},
    {"b", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the second semi-axis"},
    {"start", BATTEN_VALUE_ANGLE, false, false, "0", NULL, "where it begins"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "360 deg", NULL,
     "how far it goes, up to 360 deg"},
    BAT_PLACE,
};

static batten_status run_ellipse(bat_run *run)
{
    batten_curve *ellipse = NULL;
    const batten_status status =
        batten_curve_ellipse(bat_number(run, "ellipse"), bat_number(run, "b"),
                             bat_number(run, "start"), bat_number(run, "angle"), &ellipse);
    return bat_place_curve(run, status, ellipse);
}

const bat_feature bat_feature_ellipse = {
    .shown =
        {"ellipse", "An ellipse or a part of one, exactly",
         "The point at angle t is (a cos t, b sin t) in the plane at right angles to 'axis'.",
         "features:\n"
         "  port: {ellipse: 20 cm, b: 12 cm, axis: y}\n",
         "[PT97 section 7.6]", "batten_curve_ellipse", BAT_PARAMETERS(parameters), false,
         .also = "elliptic arc",
         .formula = "    C = at + a cos t · x + b sin t · y, as rational quadratics",
         .promise = "It is exact."},
    .run = run_ellipse};
