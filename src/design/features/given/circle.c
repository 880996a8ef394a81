/* The feature 'circle': a full circle, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"circle", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius"},
    {"form", BATTEN_VALUE_WORD, false, false, "square-9", "square-9 triangle-7 square-7",
     "its control points: how many, and on what"},
    BAT_PLACE,
};

static batten_status run_circle(bat_run *run)
{
    batten_curve *circle = NULL;
    const batten_status status = batten_curve_circle(
        bat_number(run, "circle"), (batten_circle_form)bat_word(run, "form"), &circle);
    return bat_place_curve(run, status, circle);
}

const bat_feature bat_feature_circle = {
    .shown =
        {"circle", "A full circle, exactly",
         "A rational curve of degree 2 about 'at', in the plane at right angles to 'axis'. The\n"
         "forms differ in their control points and in how evenly the parameter runs.",
         "features:\n"
         "  mast: {circle: 6 cm, at: [4 m, 0, 2 m]}\n",
         "[PT97 section 7.5]", "batten_curve_circle", BAT_PARAMETERS(parameters), false,
         .also = "full circle",
         .formula =
             "    C(t) = (B0 P0 + w B1 P1 + B2 P2)/(B0 + w B1 + B2),  w = cos(half the angle) of each piece",
         .promise = "It is exact: |C(t) − centre| = radius."},
    .run = run_circle};
