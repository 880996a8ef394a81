/* The feature 'tension-surface': the surface in tension through a grid of points. */
#include "design/shared/grid.h"
#include "design/shared/through.h"
#include <batten/grid.h>

static const batten_parameter parameters[] = {
    {"tension-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"amount-u", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "along the rows, of all strips or one for each: 0 is the spline, 2 a little, 10 much"},
    {"amount-v", BATTEN_VALUE_NUMBER, true, false, "0", NULL, "the same across the rows"},
    {"closed-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"closed-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_status make_tension_surface(bat_run *run, const bat_grid *grid,
                                          batten_surface **surface)
{
    batten_surface_tension_options o = batten_surface_tension_defaults();
    double *amounts[2] = {NULL, NULL};
    o.closed_u = bat_yes(run, "closed-u");
    o.closed_v = bat_yes(run, "closed-v");
    batten_status status =
        bat_numbers_each(run, "amount-u", grid->count_u - !o.closed_u, "strips", &amounts[0]);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "amount-v", grid->count_v - !o.closed_v, "strips",
                                  &amounts[1]);
    o.tensions_u = amounts[0];
    o.tensions_v = amounts[1];
    if (status == BATTEN_OK)
        status = batten_surface_tension(
            (batten_grid){3, grid->count_u, grid->count_v, grid->points}, &o, surface);
    bat_release(amounts[0]);
    bat_release(amounts[1]);
    return status;
}

static batten_status run_tension_surface(bat_run *run)
{
    return bat_grid_surface(run, "tension-surface", make_tension_surface);
}

const bat_feature bat_feature_tension_surface = {
    .shown =
        {"tension-surface", "The surface in tension through a grid of points",
         "Splines in tension along the rows and across them. Each strip between two lines of the\n"
         "grid can be pulled by itself: no tension gives the bicubic spline, much tension draws\n"
         "the strip straight, so that a surface beside a steep place loses its waves. Tangent\n"
         "planes and curvatures are continuous across all lines. It is not a NURBS surface; one\n"
         "within the design's tolerance is made.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0], [2, 0, 1], [3, 0, 1],\n"
         "             [0, 1, 0], [1, 1, 0], [2, 1, 1], [3, 1, 1],\n"
         "             [0, 2, 0], [1, 2, 0], [2, 2, 1], [3, 2, 1]]\n"
         "    columns: 4\n"
         "  ramp: {tension-surface: grid, amount-u: [8, 0, 8]}\n",
         "[Utah74 paper 10] [Cline74]", "batten_surface_tension", BAT_PARAMETERS(parameters),
         false, .also = "surface in tension, exponential spline surface",
         .formula =
             "    S(u, v) = Σ Σ P_ij L_i(u) M_j(v),  L_i, M_j splines in tension:  L⁗ = σ² L″ on each strip",
         .promise = "Tangent planes and curvatures are continuous."},
    .run = run_tension_surface};
