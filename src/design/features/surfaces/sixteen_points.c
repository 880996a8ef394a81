/* The feature 'sixteen-points': the bicubic patch through sixteen points. */
#include "design/shared/grid.h"

#include <batten/standard.h>

static const batten_parameter parameters[] = {
    {"sixteen-points", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "four rows of four points"},
};

static batten_status make_sixteen_points(bat_run *run, const bat_grid *grid,
                                         batten_surface **surface)
{
    (void)run;
    if (grid->count_u != 4 || grid->count_v != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the patch passes through 4 rows of 4 points, not %d of %d; "
                        "'interpolate-grid' takes any number",
                        grid->count_v, grid->count_u);
    return batten_surface_sixteen_points(grid->points, surface);
}

static batten_status run_sixteen_points(bat_run *run)
{
    return bat_grid_surface(run, "sixteen-points", make_sixteen_points);
}

const bat_feature bat_feature_sixteen_points = {
    .shown =
        {"sixteen-points", "The bicubic patch through sixteen points",
         "One patch that passes the points at the parameters 0, 1/3, 2/3 and 1 in both directions; its\n"
         "edges pass the four points along them. Exact. For more points, or points that are far from\n"
         "even, there is 'interpolate-grid'.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.3], [2, 0, 0.3], [3, 0, 0],\n"
         "             [0, 1, 0.3], [1, 1, 0.9], [2, 1, 0.8], [3, 1, 0.3],\n"
         "             [0, 2, 0.3], [1, 2, 0.7], [2, 2, 0.9], [3, 2, 0.3],\n"
         "             [0, 3, 0], [1, 3, 0.3], [2, 3, 0.3], [3, 3, 0]]\n"
         "    columns: 4\n"
         "  cushion: {sixteen-points: grid}\n",
         "[Utah74 paper 13]", "batten_surface_sixteen_points", BAT_PARAMETERS(parameters),
         false, .also = "16-point form, sixteen point form, bicubic patch through points",
         .formula = "    B = Q P Qᵀ,  Q = (1/6) [6 0 0 0; −5 18 −9 2; 2 −9 18 −5; 0 0 0 6]",
         .promise = "The surface passes the sixteen points at thirds of its parameters."},
    .run = run_sixteen_points};
