/* The feature 'mirror': the image in a plane, with what it is the image of. */
#include "design/shared/place.h"

#include <stdio.h>

typedef enum { CENTRE, PLANE_X, PLANE_Y, PLANE_Z } plane;

static const batten_parameter parameters[] = {
    {"mirror", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "what is mirrored"},
    {"plane", BATTEN_VALUE_WORD, false, false, "centre", "centre x y z",
     "the plane with this normal; centre is y, the centre plane of a ship"},
    {"at", BATTEN_VALUE_LENGTH, false, false, "0", NULL,
     "how far the plane is from the origin"},
    {"normal", BATTEN_VALUE_POINT, false, false, NULL, NULL, "any normal, instead of 'plane'"},
    {"keep", BATTEN_VALUE_YES_NO, false, false, "yes", NULL, "keep what was mirrored, too"},
};

static batten_status find_plane(const bat_run *run, batten_affine *out)
{
    const int which = bat_word(run, "plane");
    batten_vec3 normal = {which == PLANE_X, which == CENTRE || which == PLANE_Y,
                          which == PLANE_Z};
    if (bat_has(run, "normal"))
        normal = bat_point(run, "normal");
    const batten_status status = bat_check_direction("normal", normal);
    if (status != BATTEN_OK)
        return status;
    const double length = bat_hypot(bat_hypot(normal.x, normal.y), normal.z);
    const double d = bat_number(run, "at") / length;
    *out =
        batten_affine_mirror((batten_vec3){d * normal.x, d * normal.y, d * normal.z}, normal);
    return BATTEN_OK;
}

static batten_status run_mirror(bat_run *run)
{
    batten_affine map;
    batten_status status = find_plane(run, &map);
    if (status != BATTEN_OK)
        return status;
    const batten_model *model = bat_model(run, "mirror");
    const bool keep = bat_yes(run, "keep");
    status = bat_expect(run, (keep ? 2LL : 1LL) * batten_model_count(model));
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK && keep; i++)
        status = bat_add(run, batten_model_object(model, i));
    for (int i = 0; i < batten_model_count(model) && status == BATTEN_OK; i++) {
        batten_object object = *batten_model_object(model, i);
        char name[200];
        snprintf(name, sizeof name, "%s%s", object.name, keep ? " mirrored" : "");
        object.name = name;
        status = bat_transform_object(run, &map, &object);
    }
    return status;
}

const bat_feature bat_feature_mirror = {
    .shown =
        {"mirror", "The image in a plane, with what it is the image of",
         "Half a hull becomes a whole one. The image of 'hull' is named 'hull mirrored'; with\n"
         "'keep: no' only the image is left, under the old name. The outside of surfaces stays\n"
         "outside: u of the image runs the other way, over the same domain; v is as it was.",
         "features:\n"
         "  side: {line: [[0, 1 m, 0], [3 m, 1 m, 1 m]]}\n"
         "  both: {mirror: side, plane: centre}\n",
         "", "batten_affine_mirror", BAT_PARAMETERS(parameters), false,
         .also = "symmetry, reflect, port and starboard, other half"},
    .run = run_mirror,
    .displacing = "!keep"};
