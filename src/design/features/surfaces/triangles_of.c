/* The feature 'triangles-of': a surface as Bezier triangles. */
#include "design/feature.h"

static const batten_parameter parameters[] = {
    {"triangles-of", BATTEN_VALUE_MODEL, false, true, NULL, NULL, "a surface"},
};

static batten_status run_triangles_of(bat_run *run)
{
    bat_objects surfaces;
    batten_triangles *triangles = NULL;
    batten_status status = bat_gather(run, "triangles-of", BAT_SURFACES, &surfaces);
    if (status != BATTEN_OK)
        return status;
    status = surfaces.count == 1
                 ? batten_triangles_from_surface(surfaces.at[0]->surface, &triangles)
                 : bat_fail(BATTEN_BAD_ARGUMENT, "one surface is cut into triangles, not %d",
                            surfaces.count);
    bat_objects_release(&surfaces);
    return bat_put_triangles(run, status, triangles);
}

const bat_feature bat_feature_triangles_of = {
    .shown =
        {"triangles-of", "A surface as Bezier triangles",
         "Every Bezier patch of degrees m and n becomes two triangles of degree m + n, along the\n"
         "diagonal from its first corner: exactly the same surface.",
         "features:\n"
         "  chine: {polyline: [[0, 0.5 m, 0], [4 m, 0.6 m, 0.1 m]]}\n"
         "  sheer: {polyline: [[0, 0.7 m, 0.6 m], [4 m, 0.9 m, 0.8 m]]}\n"
         "  plank: {ruled: [chine, sheer]}\n"
         "  halves: {triangles-of: plank}\n",
         "[Farin86]", "batten_triangles_from_surface", BAT_PARAMETERS(parameters), false,
         .also = "split patches into triangles",
         .formula =
             "    b(b1, b2, b3) = Σ n!/(i! j! k!) b1^i b2^j b3^k c_ijk,  n = sum of the degrees of the patch",
         .promise = "It is exactly the same surface."},
    .run = run_triangles_of};
