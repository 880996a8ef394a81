/* The feature 'scale': the same in another size. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"scale", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what is made larger or smaller"},
    {"by", BATTEN_VALUE_NUMBER, true, true, NULL, NULL,
     "one factor, or one each for x, y and z"},
    {"at", BATTEN_VALUE_POINT, false, false, "origin", NULL, "the point that stays"},
};

static batten_status run_scale(bat_run *run)
{
    const bat_argument *by = bat_argument_of(run, "by");
    if (by->count != 1 && by->count != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "'by' has 1 or 3 factors, not %d", by->count);
    for (int i = 0; i < by->count; i++)
        if (by->items[i].number[0] == 0)
            return bat_fail(BATTEN_BAD_ARGUMENT, "a factor of 0 would leave nothing");
    const double x = by->items[0].number[0];
    const double y = by->items[by->count / 2].number[0], z = by->items[by->count - 1].number[0];
    const batten_vec3 at = bat_point(run, "at");
    const batten_affine there = batten_affine_translation(-at.x, -at.y, -at.z);
    const batten_affine back = batten_affine_translation(at.x, at.y, at.z);
    const batten_affine grown = batten_affine_compose(there, batten_affine_scaling(x, y, z));
    const batten_affine map = batten_affine_compose(grown, back);
    return bat_transform_all(run, &map);
}

const bat_feature bat_feature_scale = {
    .shown = {"scale", "The same in another size",
              "Every object is scaled, with the points it was made from.",
              "features:\n"
              "  port: {circle: 10 cm}\n"
              "  oval: {scale: port, by: [2, 1, 1]}\n",
              "", "batten_affine_scaling", BAT_PARAMETERS(parameters), false,
              .also = "resize, enlarge, shrink, stretch"},
    .run = run_scale,
    .displacing = "scale"};
