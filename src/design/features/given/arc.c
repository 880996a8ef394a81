/* The feature 'arc': a circular arc, exactly. */
#include "design/shared/place.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"arc", BATTEN_VALUE_LENGTH, false, true, NULL, NULL, "the radius"},
    {"start", BATTEN_VALUE_ANGLE, false, false, "0", NULL, "where it begins"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "360 deg", NULL,
     "how far it goes, up to 360 deg"},
    BAT_PLACE,
};

static batten_status run_arc(bat_run *run)
{
    batten_frame frame;
    batten_curve *arc = NULL;
    batten_status status = bat_frame(run, &frame);
    if (status == BATTEN_OK)
        status = batten_curve_arc_in(&frame, bat_number(run, "arc"), bat_number(run, "start"),
                                     bat_number(run, "angle"), &arc);
    return bat_put_curve(run, status, arc);
}

const bat_feature bat_feature_arc = {
    .shown =
        {"arc", "A circular arc, exactly",
         "An arc of degree 2 about 'at', in the plane at right angles to 'axis', counter-clockwise\n"
         "as seen from the tip of the axis. Angle 0 is along 'from', or where the plane meets the\n"
         "horizontal plane.",
         "features:\n"
         "  bilge: {arc: 0.6 m, start: 270 deg, angle: 90 deg, axis: x, from: y}\n",
         "[PT97 section 7.3]", "batten_curve_arc_in", BAT_PARAMETERS(parameters), false,
         .also = "circular arc",
         .formula =
             "    C(t) = (B0 P0 + w B1 P1 + B2 P2)/(B0 + w B1 + B2),  w = cos(half the angle) of each piece",
         .promise = "It is exact: |C(t) − centre| = radius."},
    .run = run_arc};
