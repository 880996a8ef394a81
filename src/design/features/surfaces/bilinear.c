/* The feature 'bilinear': the patch of straight lines between four corners. */
#include "design/feature.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"bilinear", BATTEN_VALUE_POINT, true, true, NULL, NULL,
     "the four corners, one after the other around the patch"},
};

static batten_status run_bilinear(bat_run *run)
{
    const bat_argument *corners = bat_argument_of(run, "bilinear");
    batten_vec3 p[4];
    batten_surface *surface = NULL;
    if (corners->count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a bilinear patch has 4 corners, not %d",
                        corners->count);
    for (int i = 0; i < 4; i++) {
        const double *at = corners->items[i].number;
        p[i] = (batten_vec3){at[0], at[1], at[2]};
    }
    const batten_status status = batten_surface_bilinear(p[0], p[1], p[3], p[2], &surface);
    return bat_put_surface(run, status, surface);
}

const bat_feature bat_feature_bilinear = {
    .shown =
        {"bilinear", "The patch of straight lines between four corners",
         "A plane when the corners lie in one, otherwise a hyperbolic paraboloid; both families of\n"
         "its lines are straight. u runs from the first corner to the second.",
         "features:\n"
         "  sail: {bilinear: [[0, 0, 0], [4 m, 0, 2 m], [4 m, 4 m, 0], [0, 4 m, 2 m]]}\n",
         "[PT97 section 8.2]", "batten_surface_bilinear", BAT_PARAMETERS(parameters), false,
         .also = "hyperbolic paraboloid, four corners, hypar",
         .formula = "    S(u, v) = (1−u)(1−v) P00 + u (1−v) P10 + (1−u) v P01 + u v P11",
         .promise = "It is exact; both families of lines are straight."},
    .run = run_bilinear};
