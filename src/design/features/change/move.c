/* The feature 'move': the same somewhere else. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"move", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what is moved"},
    {"by", BATTEN_VALUE_POINT, false, true, NULL, NULL, "how far in x, y and z"},
};

static batten_status run_move(bat_run *run)
{
    const batten_vec3 by = bat_point(run, "by");
    const batten_affine map = batten_affine_translation(by.x, by.y, by.z);
    return bat_transform_all(run, &map);
}

const bat_feature bat_feature_move = {
    .shown = {"move", "The same somewhere else",
              "Every object is moved, with the points it was made from.",
              "features:\n"
              "  mast: {circle: 6 cm}\n"
              "  mizzen: {move: mast, by: [-3 m, 0, 0]}\n",
              "", "batten_affine_translation", BAT_PARAMETERS(parameters), false,
              .also = "translate, shift, displace"},
    .run = run_move,
    .displacing = "move"};
