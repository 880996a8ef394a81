/* The feature 'rotate': the same, turned about an axis. */
#include "design/shared/place.h"

static const batten_parameter parameters[] = {
    {"rotate", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what is turned"},
    {"by", BATTEN_VALUE_ANGLE, false, true, NULL, NULL,
     "how far, counter-clockwise about the axis"},
    {"at", BATTEN_VALUE_POINT, false, false, "origin", NULL, "a point on the axis"},
    {"axis", BATTEN_VALUE_POINT, false, false, "z", NULL, "the direction of the axis"},
};

static batten_status run_rotate(bat_run *run)
{
    const batten_vec3 axis = bat_point(run, "axis");
    const batten_status status = bat_check_direction("axis", axis);
    if (status != BATTEN_OK)
        return status;
    const batten_affine map =
        batten_affine_rotation(bat_point(run, "at"), axis, bat_number(run, "by"));
    return bat_transform_all(run, &map);
}

const bat_feature bat_feature_rotate = {
    .shown = {"rotate", "The same, turned about an axis",
              "Every object is turned, with the points it was made from.",
              "features:\n"
              "  rib: {line: [[1 m, 0], [2 m, 0]]}\n"
              "  next: {rotate: rib, by: 15 deg}\n",
              "", "batten_affine_rotation", BAT_PARAMETERS(parameters), false,
              .also = "turn, spin"},
    .run = run_rotate,
    .displacing = "rotate"};
