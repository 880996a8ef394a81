#include "picture/shaded/smooth_edges.h"

#include "support/test.h"

#include <string.h>

/* Two flat triangles over the unit square, the second one's free corner at the height z. */
static batten_model *tent(double z)
{
    const double points[18] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, z, 0, 1, 0, 1, 0, 0};
    batten_triangles *triangles = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_triangles_create(&(batten_triangles_parts){3, 1, 2, points, NULL, NULL},
                                     &triangles));
    CHECK_OK(batten_model_create(1, &model));
    batten_object object = {.name = "tent", .layer = "", .kind = BATTEN_OBJECT_TRIANGLES};
    object.triangles = triangles;
    CHECK_OK(batten_model_add(model, &object));
    batten_triangles_unref(triangles);
    return model;
}

TEST(edges_are_smooth_where_triangles_go_over_into_each_other)
{
    for (int bent = 0; bent < 2; bent++) {
        batten_model *model = tent(bent ? 0.5 : 0), *patched = NULL;
        unsigned char *sides = NULL;
        CHECK_OK(batten_model_with_patches(model, BATTEN_PATCHES_POLE, &patched));
        CHECK_OK(bat_smooth_edges(model, patched, &sides));
        for (int i = 0; i < 2; i++)
            CHECK_INT(sides[i], bent ? BAT_SIDE_U0 : BAT_SIDE_U0 | BAT_SIDE_U1);
        bat_release(sides);
        batten_model_unref(patched);
        batten_model_unref(model);
    }
}
