/* The feature 'catmull-rom-surface': the local surface of Catmull and Rom through a grid
 * of points. */
#include "design/shared/grid.h"
#include <batten/grid.h>

static const batten_parameter parameters[] = {
    {"catmull-rom-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"blend", BATTEN_VALUE_COUNT, false, false, "2", NULL,
     "degree of the B-splines that blend: 2 is smooth, 3 has curvature"},
    {"local", BATTEN_VALUE_COUNT, false, false, "1", NULL,
     "degree of the polynomials that are blended"},
    {"closed-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"closed-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
};

static batten_status make_catmull_rom_surface(bat_run *run, const bat_grid *grid,
                                              batten_surface **surface)
{
    batten_curve_catmull_rom_options u = batten_curve_catmull_rom_defaults();
    double off;
    u.blend = bat_count(run, "blend");
    u.local = bat_count(run, "local");
    batten_curve_catmull_rom_options v = u;
    u.closed = bat_yes(run, "closed-u");
    v.closed = bat_yes(run, "closed-v");
    const batten_status status = batten_surface_catmull_rom(
        (batten_grid){3, grid->count_u, grid->count_v, grid->points}, (batten_uv){NULL, NULL},
        (const batten_curve_catmull_rom_options *const[2]){&u, &v}, run->job, &off, surface);
    if (status == BATTEN_OK)
        bat_report_error(run, off, off);
    return status;
}

static batten_status run_catmull_rom_surface(bat_run *run)
{
    return bat_grid_surface(run, "catmull-rom-surface", make_catmull_rom_surface);
}

const bat_feature bat_feature_catmull_rom_surface = {
    .shown =
        {"catmull-rom-surface", "The local surface of Catmull and Rom through a grid of points",
         "No equations are solved: moving a point changes the surface only near it. With the\n"
         "default values it is bicubic and smooth; blend 3 with local 2 is of degree 5, with\n"
         "continuous curvature. Where 'local' is less than 'blend' - 1 the surface passes near the\n"
         "points instead.",
         "features:\n"
         "  grid:\n"
         "    points: [[0, 0, 0], [1, 0, 0.1], [2, 0, 0],\n"
         "             [0, 1, 0.1], [1, 1, 0.5], [2, 1, 0.1],\n"
         "             [0, 2, 0], [1, 2, 0.1], [2, 2, 0]]\n"
         "    columns: 3\n"
         "  hill: {catmull-rom-surface: grid}\n",
         "[Utah74 paper 15] [CR74]", "batten_surface_catmull_rom", BAT_PARAMETERS(parameters),
         false, .also = "local surface, cardinal surface",
         .formula = "    S(u, v) = Σ Σ P_ij F_i(u) F_j(v),  F_i of catmull-rom",
         .promise = "A point changes the surface only nearby."},
    .run = run_catmull_rom_surface};
