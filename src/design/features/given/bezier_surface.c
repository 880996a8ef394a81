/* The feature 'bezier-surface': the Bezier surface of a net. */
#include "base/plural.h"
#include "design/shared/grid.h"

static const batten_parameter parameters[] = {
    {"bezier-surface", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the net: rows of points, all of the same length"},
    {"weights", BATTEN_VALUE_NUMBER, true, false, NULL, NULL,
     "of the points, row by row: a rational surface"},
};

/* The weights of the net, turned as its points are; NULL when none are given. */
static batten_status weights_of(const bat_run *run, const bat_grid *grid, double **out)
{
    const bat_argument *given = bat_argument_of(run, "weights");
    const int total = grid->count_u * grid->count_v;
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != total)
        return bat_fail(BATTEN_BAD_ARGUMENT, "%d weight%s for %d point%s", given->count,
                        bat_plural(given->count), total, bat_plural(total));
    double *weights = bat_array((size_t)total, sizeof *weights);
    if (!weights)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < grid->count_u; i++)
        for (int j = 0; j < grid->count_v; j++)
            weights[i * grid->count_v + j] = given->items[j * grid->count_u + i].number[0];
    *out = weights;
    return BATTEN_OK;
}

static batten_status make_bezier_surface(bat_run *run, const bat_grid *grid,
                                         batten_surface **surface)
{
    static const double unit[2] = {0, 1};
    const int p = grid->count_u - 1, q = grid->count_v - 1;
    double *weights = NULL;
    if (bat_max_int(p, q) > BATTEN_MAX_DEGREE || bat_min_int(p, q) < 1)
        return bat_fail(BATTEN_BAD_DEGREE,
                        "a net of %d x %d points gives the degrees %d and %d; they must be in "
                        "1..%d, and 'b-spline-surface' takes nets of any size",
                        p + 1, q + 1, p, q, BATTEN_MAX_DEGREE);
    batten_status status = weights_of(run, grid, &weights);
    if (status == BATTEN_OK)
        status = batten_surface_from_bezier(3, (batten_pieces){p, 1, unit},
                                            (batten_pieces){q, 1, unit}, grid->points, weights,
                                            surface);
    bat_release(weights);
    return status;
}

static batten_status run_bezier_surface(bat_run *run)
{
    return bat_grid_surface(run, "bezier-surface", make_bezier_surface);
}

const bat_feature bat_feature_bezier_surface = {
    .shown =
        {"bezier-surface", "The Bezier surface of a net",
         "One patch whose degrees are one less than the numbers of points, up to 25. Its edges are\n"
         "the Bezier curves of the rims of the net, it touches the net at its corners, and it lies\n"
         "within its convex hull. 'match' joins such patches smoothly, 'part' cuts pieces out,\n"
         "'elevate' raises degrees.",
         "features:\n"
         "  net:\n"
         "    points: [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0],\n"
         "             [0, 1, 1], [1, 1, 2], [2, 1, 2], [3, 1, 1],\n"
         "             [0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, 0]]\n"
         "    columns: 4\n"
         "  hood: {bezier-surface: net}\n",
         "[SL section V.3] [Utah74 paper 7] [Bezier74] [Farin02]", "batten_surface_from_bezier",
         BAT_PARAMETERS(parameters), false,
         .also = "UNISURF, Bézier patch, bicubic patch, control net",
         .formula = "    S(u, v) = Σ Σ b_ij B_i^m(u) B_j^n(v)",
         .promise = "The surface lies in the convex hull of its net."},
    .run = run_bezier_surface,
    .displacing = "bezier-surface"};
