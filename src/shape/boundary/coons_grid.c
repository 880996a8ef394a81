/* A net of Coons patches over a grid of points. */
#include "shape/points/grid_parameters.h"
#include <batten/coons.h>
#include <batten/curvature.h>

#include <string.h>

typedef struct {
    const batten_surface_coons_network_options *options;
    int dimension, count[2];
    const double *points;
    double *at[2];           /* the parameters */
    batten_curve **lines[2]; /* [0] along u [count[1]], [1] along v [count[0]] */
    double *values[6];       /* at each point: Su, Sv, Suu, Svv, twist; Gaussian curvature */
} grid;

static void grid_release(grid *g)
{
    for (int k = 0; k < 2; k++) {
        for (int i = 0; g->lines[k] && i < g->count[1 - k]; i++)
            batten_curve_unref(g->lines[k][i]);
        bat_release(g->lines[k]);
        bat_release(g->at[k]);
    }
    for (int i = 0; i < 6; i++)
        bat_release(g->values[i]);
}

static batten_status parametrize(grid *g, int k)
{
    const size_t d = (size_t)g->dimension, row = (size_t)g->count[1] * d;
    const bat_family family = {.name = k ? "v grid lines" : "u grid lines",
                               .dimension = g->dimension,
                               .count = g->count[k],
                               .lines = g->count[1 - k],
                               .point_step = k ? d : row,
                               .line_step = k ? row : d,
                               .points = g->points};
    double spread;
    g->at[k] = bat_array((size_t)g->count[k], sizeof *g->at[k]);
    return g->at[k] ? bat_family_parametrize(&family, g->options->parameters, g->at[k], &spread)
                    : BATTEN_OUT_OF_MEMORY;
}

static batten_status make_line(grid *g, int k, int line, double *room)
{
    const int d = g->dimension, n = g->count[k];
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    options.parameters = BATTEN_GIVEN;
    options.given = g->at[k];
    options.start.kind = options.end.kind = g->options->ends;
    for (int i = 0; i < n; i++)
        memcpy(room + i * d,
               g->points + (k ? line * g->count[1] + i : i * g->count[1] + line) * d,
               (size_t)d * sizeof *room);
    return batten_curve_interpolate((batten_points){d, n, room}, &options, NULL,
                                    &g->lines[k][line]);
}

static batten_status make_lines(grid *g, int k)
{
    double *room = bat_array3((size_t)g->count[k], (size_t)g->dimension, sizeof *room);
    g->lines[k] = bat_array((size_t)g->count[1 - k], sizeof *g->lines[k]);
    batten_status status = room && g->lines[k] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < g->count[1 - k]; i++)
        status = make_line(g, k, i, room);
    bat_release(room);
    return status;
}

/* ---- Selesnick's twists, for which more must be known ---- */

static batten_status look_along(grid *g, int i, int j, const batten_surface *surface)
{
    const int d = g->dimension, node = i * g->count[1] + j;
    double out[9];
    batten_surface_local local;
    batten_status status = batten_curve_evaluate(g->lines[0][j], g->at[0][i], 2, out);
    if (status == BATTEN_OK) {
        memcpy(g->values[0] + node * d, out + d, (size_t)d * sizeof *out);
        memcpy(g->values[2] + node * d, out + 2 * d, (size_t)d * sizeof *out);
        status = batten_curve_evaluate(g->lines[1][i], g->at[1][j], 2, out);
    }
    if (status == BATTEN_OK) {
        memcpy(g->values[1] + node * d, out + d, (size_t)d * sizeof *out);
        memcpy(g->values[3] + node * d, out + 2 * d, (size_t)d * sizeof *out);
        status = batten_surface_local_at(surface, g->at[0][i], g->at[1][j], &local);
    }
    if (status == BATTEN_SINGULAR_HERE) /* no curvature: Adini's twist is taken there */
        status = BATTEN_OK;
    else if (status == BATTEN_OK)
        g->values[5][node] = local.gaussian;
    return status;
}

static batten_status fit_surface(const grid *g, batten_surface **out)
{
    batten_surface_interpolate_options options = batten_surface_interpolate_defaults();
    options.knots_at_data = true;
    options.parameters = BATTEN_GIVEN;
    options.given_u = g->at[0];
    options.given_v = g->at[1];
    return batten_surface_interpolate(
        (batten_grid){g->dimension, g->count[0], g->count[1], g->points}, &options, NULL,
        (batten_uv_out){NULL, NULL}, NULL, out);
}

static batten_status curvature_twists(grid *g)
{
    const size_t nodes = (size_t)g->count[0] * (size_t)g->count[1];
    batten_surface *surface = NULL;
    if (g->dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "Selesnick's twists need three dimensions");
    batten_status status = fit_surface(g, &surface);
    for (int k = 0; status == BATTEN_OK && k < 6; k++) {
        g->values[k] = bat_array3(nodes, 3, sizeof *g->values[k]);
        if (!g->values[k])
            status = BATTEN_OUT_OF_MEMORY;
    }
    for (int i = 0; i < g->count[0]; i++)
        for (int j = 0; status == BATTEN_OK && j < g->count[1]; j++)
            status = look_along(g, i, j, surface);
    const batten_twist_shape shape = {g->values[2], g->values[3], g->values[5]};
    if (status == BATTEN_OK)
        status =
            batten_net_twists(BATTEN_TWISTS_SELESNICK,
                              &(batten_net){3, g->count[0], g->count[1], g->at[0], g->at[1],
                                            g->points, g->values[0], g->values[1]},
                              &shape, NULL, g->values[4]);
    batten_surface_unref(surface);
    return status;
}

/* ---- all ---- */

static batten_status check_grid(int dimension, int count_u, int count_v, const double *points)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (count_u < 2 || count_v < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "a grid of %d x %d points is too small", count_u,
                        count_v);
    const size_t total = (size_t)count_u * (size_t)count_v * (size_t)dimension;
    const size_t i = bat_first_not_finite(points, total) / (size_t)dimension;
    if (i < (size_t)count_u * (size_t)count_v)
        return bat_fail(BATTEN_NOT_FINITE, "point (%zu, %zu) is not finite",
                        i / (size_t)count_v + 1, i % (size_t)count_v + 1);
    return BATTEN_OK;
}

static batten_status build_patches(grid *g, batten_surface **out)
{
    batten_surface_coons_network_options options = *g->options;
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = parametrize(g, k);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = make_lines(g, k);
    if (status == BATTEN_OK && !options.given && options.twists == BATTEN_TWISTS_SELESNICK) {
        status = curvature_twists(g);
        options.given = g->values[4];
    }
    /* The curves pass the points but for rounding, which has nothing to do with tolerances. */
    options.tolerance = INFINITY;
    return status == BATTEN_OK
               ? batten_surface_coons_network(
                     &(batten_curve_net){g->count[0], g->count[1], g->at[0], g->at[1],
                                         (const batten_curve *const *)g->lines[0],
                                         (const batten_curve *const *)g->lines[1]},
                     &options, NULL, out)
               : status;
}

batten_status batten_surface_coons_grid(batten_grid points,
                                        const batten_surface_coons_network_options *options,
                                        batten_uv_out uv, batten_surface **out)
{
    assert(points.at && out);
    batten_surface_coons_network_options chosen = batten_surface_coons_network_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_surface_coons_network_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    grid g = {.options = &chosen,
              .dimension = points.dimension,
              .count = {points.count_u, points.count_v},
              .points = points.at};
    status = check_grid(points.dimension, points.count_u, points.count_v, points.at);
    if (status == BATTEN_OK)
        status = build_patches(&g, out);
    if (status == BATTEN_OK && uv.u)
        memcpy(uv.u, g.at[0], (size_t)points.count_u * sizeof *uv.u);
    if (status == BATTEN_OK && uv.v)
        memcpy(uv.v, g.at[1], (size_t)points.count_v * sizeof *uv.v);
    grid_release(&g);
    return status;
}
