/* The feature 'gregory': patches over a mesh of cubic curves, each made alone. */
#include "design/shared/smooth.h"

#include <batten/fill.h>

static const batten_parameter parameters[] = {
    {"gregory", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "three or four cubic curves, in any order"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far corners may be open, and the spline from the patch; the tolerance of the design "
     "by default"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "0.01 deg", NULL,
     "between normals of spline and patch along the edges"},
};

static batten_status run_gregory(bat_run *run)
{
    bat_objects curves;
    batten_surface *patch = NULL;
    const double within =
        bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run);
    batten_status status = bat_gather(run, "gregory", BAT_CURVES, &curves);
    if (status != BATTEN_OK)
        return status;
    const batten_curve **sides = bat_array((size_t)curves.count, sizeof(const batten_curve *));
    for (int i = 0; sides && i < curves.count; i++)
        sides[i] = curves.at[i]->curve;
    status = sides ? batten_surface_gregory_between(curves.count, sides, within, NULL, &patch)
                   : BATTEN_OUT_OF_MEMORY;
    bat_release(sides);
    bat_objects_release(&curves);
    const bat_smooth_wish wish = {.names = {"v = 0", "u = 1", "v = 1", "u = 0"},
                                  .within = within,
                                  .angle = bat_number(run, "angle")};
    return bat_put_smooth_surface(run, status, patch, &wish);
}

const bat_feature bat_feature_gregory = {
    .shown =
        {"gregory", "Patches over a mesh of cubic curves, each made alone",
         "Three or four cubics become a patch whose tangent planes along a side follow only from\n"
         "this side and from the planes at its ends. So patches on both sides of it join smoothly,\n"
         "without knowing of each other, when the curves that meet in a corner have a common\n"
         "tangent plane there.",
         "features:\n"
         "  p: {points: [[0, 0, 0], [1 m, 0, 0.4 m], [2 m, 0, 0.4 m], [3 m, 0, 0]]}\n"
         "  q: {points: [[3 m, 0, 0], [3 m, 1 m, 0.3 m], [2 m, 2 m, 0.3 m], [1.5 m, 3 m, 0]]}\n"
         "  r: {points: [[1.5 m, 3 m, 0], [1 m, 2 m, 0.3 m], [0, 1 m, 0.3 m], [0, 0, 0]]}\n"
         "  a: {bezier: p}\n"
         "  b: {bezier: q}\n"
         "  c: {bezier: r}\n"
         "  patch: {gregory: [a, b, c]}\n",
         "[Utah74 paper 4] [CK83] [WM96]", "batten_surface_gregory_between",
         BAT_PARAMETERS(parameters), false,
         .also = "Gregory patch, Chiyokura-Kimura, twist incompatibility, N-sided mesh",
         .formula =
             "    S = Σ Σ b_ij(u, v) B_i³(u) B_j³(v),  b_11 = (u b_11ᵛ + v b_11ᵘ)/(u + v), the other inner points alike",
         .promise = "Patches on both sides of a cubic have one tangent plane along it."},
    .run = run_gregory};
