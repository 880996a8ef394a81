/* The feature 'b-spline-surface': the uniform B-spline surface of a net. */
#include "design/shared/grid.h"

#include <batten/grid.h>

static const batten_parameter parameters[] = {
    {"b-spline-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the net: rows of points, all of the same length"},
    {"degree-u", BATTEN_VALUE_COUNT, false, false, "3", NULL, "along the rows"},
    {"degree-v", BATTEN_VALUE_COUNT, false, false, "3", NULL, "across the rows"},
    {"ends-u", BATTEN_VALUE_WORD, false, false, "clamped",
     "clamped free phantom repeated closed", "how the surface ends at the ends of the rows"},
    {"ends-v", BATTEN_VALUE_WORD, false, false, "clamped",
     "clamped free phantom repeated closed", "how it ends at the first and the last row"},
};

static batten_status make_b_spline_surface(bat_run *run, const bat_grid *grid,
                                           batten_surface **surface)
{
    return batten_surface_uniform((batten_grid){3, grid->count_u, grid->count_v, grid->points},
                                  bat_count(run, "degree-u"), bat_count(run, "degree-v"),
                                  (batten_polygon_end)bat_word(run, "ends-u"),
                                  (batten_polygon_end)bat_word(run, "ends-v"), surface);
}

static batten_status run_b_spline_surface(bat_run *run)
{
    return bat_grid_surface(run, "b-spline-surface", make_b_spline_surface);
}

const bat_feature bat_feature_b_spline_surface = {
    .shown =
        {"b-spline-surface", "The uniform B-spline surface of a net",
         "A smooth surface near a net: moving a point changes it only nearby. The ends are those\n"
         "of 'b-spline'. A row or column given twice draws the surface close; given as often as\n"
         "the degree it makes a knuckle.",
         "features:\n"
         "  net:\n"
         "    points: [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0],\n"
         "             [0, 1, 1], [1, 1, 2], [2, 1, 2], [3, 1, 1],\n"
         "             [0, 2, 1], [1, 2, 2], [2, 2, 2], [3, 2, 1],\n"
         "             [0, 3, 0], [1, 3, 1], [2, 3, 1], [3, 3, 0]]\n"
         "    columns: 4\n"
         "  hood: {b-spline-surface: net, ends-v: free}\n",
         "[SL section V.4] [Utah74 paper 1] [Utah74 paper 6] [Coons74] [Riesenfeld73]",
         "batten_surface_uniform", BAT_PARAMETERS(parameters), false,
         .also = "NURBS surface, control net, uniform B-spline surface",
         .formula = "    S(u, v) = Σ Σ d_ij N_{i,k}(u) N_{j,l}(v), uniform knots",
         .promise = "A point changes the surface only nearby."},
    .run = run_b_spline_surface,
    .displacing = "b-spline-surface"};
