/* The feature 'nu-surface': the bicubic surface with a tension at each line of its grid. */
#include "design/shared/grid.h"
#include "design/shared/through.h"
#include <batten/grid.h>

static const batten_parameter parameters[] = {
    {"nu-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"nu-u", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "at the lines that the rows cross, of all or one for each: 0 is the spline, 10 much"},
    {"nu-v", BATTEN_VALUE_NUMBER, true, false, "0", NULL,
     "at the rows, of all or one for each"},
    {"closed-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"closed-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_status make_nu_surface(bat_run *run, const bat_grid *grid,
                                     batten_surface **surface)
{
    batten_surface_nu_options o = batten_surface_nu_defaults();
    double *nus[2] = {NULL, NULL};
    o.closed_u = bat_yes(run, "closed-u");
    o.closed_v = bat_yes(run, "closed-v");
    batten_status status = bat_numbers_each(run, "nu-u", grid->count_u, "lines", &nus[0]);
    if (status == BATTEN_OK)
        status = bat_numbers_each(run, "nu-v", grid->count_v, "rows", &nus[1]);
    o.nus_u = nus[0];
    o.nus_v = nus[1];
    if (status == BATTEN_OK)
        status = batten_surface_nu((batten_grid){3, grid->count_u, grid->count_v, grid->points},
                                   &o, run->job, surface);
    bat_release(nus[0]);
    bat_release(nus[1]);
    return status;
}

static batten_status run_nu_surface(bat_run *run)
{
    return bat_grid_surface(run, "nu-surface", make_nu_surface);
}

const bat_feature bat_feature_nu_surface = {
    .shown =
        {"nu-surface", "The bicubic surface with a tension at each line of its grid",
         "Nu-splines along the rows and across them. A large nu draws the bend of the surface into\n"
         "its line, in the limit as a knuckle, while the rest stays round. The surface is one\n"
         "bicubic B-spline surface; tangents are continuous across every line, and curvature along\n"
         "the lines too.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 1], [2, 0, 0],\n"
         "             [0, 1, 0], [1, 1, 1], [2, 1, 0],\n"
         "             [0, 2, 0], [1, 2, 1], [2, 2, 0]]\n"
         "    columns: 3\n"
         "  ridge: {nu-surface: grid, nu-u: [0, 30, 0]}\n",
         "[Utah74 paper 10] [Nielson74]", "batten_surface_nu", BAT_PARAMETERS(parameters),
         false, .also = "ν-spline surface, knuckle lines",
         .formula =
             "    S(u, v) = Σ Σ P_ij L_i(u) M_j(v),  L_i, M_j nu-splines:  L″(u_i+) − L″(u_i−) = ν_i L′(u_i)",
         .promise = "Tangents are continuous across every line, curvature along the lines."},
    .run = run_nu_surface};
