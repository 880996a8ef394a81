/* Surfaces through grids by the methods that curves have. */
#include "shape/grid/tensor.h"
#include <batten/interpolate.h>

#include <string.h>

/* ---- nu-splines ---- */

batten_surface_nu_options batten_surface_nu_defaults(void)
{
    return (batten_surface_nu_options){.size = sizeof(batten_surface_nu_options)};
}

static batten_status make_nu(void *user, int dimension, int count, const double *points,
                             const double *parameters, batten_curve **out)
{
    batten_curve_weighted_options o = *(const batten_curve_weighted_options *)user;
    o.given = parameters;
    return batten_curve_weighted((batten_points){dimension, count, points}, &o, NULL, out);
}

static batten_curve_weighted_options weighted(bool closed, double nu, const double *nus)
{
    batten_curve_weighted_options o = batten_curve_weighted_defaults();
    o.parameters = BATTEN_GIVEN;
    o.closed = closed;
    o.nu = nu;
    o.nus = nus;
    return o;
}

batten_status batten_surface_nu(batten_grid points, const batten_surface_nu_options *options,
                                const batten_job *job, batten_surface **out)
{
    assert(points.at && out);
    batten_surface_nu_options chosen = batten_surface_nu_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_nu_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_surface_nu_options *o = &chosen;
    batten_curve_weighted_options curves[2] = {weighted(o->closed_u, o->nu_u, o->nus_u),
                                               weighted(o->closed_v, o->nu_v, o->nus_v)};
    const batten_line_method u = {make_nu, &curves[0], o->closed_u},
                             v = {make_nu, &curves[1], o->closed_v};
    bat_grid_parameters at = {NULL, NULL, {0, 0}};
    status = bat_grid_check(points.dimension, points.count_u, points.count_v, points.at,
                            o->closed_u, o->closed_v);
    if (status == BATTEN_OK)
        status = bat_grid_parameters_of(points, BATTEN_CHORD,
                                        (const bool[2]){o->closed_u, o->closed_v},
                                        (const double *const[2]){o->u, o->v}, &at);
    if (status == BATTEN_OK)
        status =
            batten_surface_tensor(points, (batten_uv){at.u, at.v},
                                  (const batten_line_method *const[2]){&u, &v}, job, NULL, out);
    bat_grid_parameters_release(&at);
    return status;
}

/* ---- uniform B-splines of nets ---- */

typedef struct {
    int degree;
    batten_polygon_end ends;
} polygon_way;

static batten_status make_uniform(void *user, int dimension, int count, const double *points,
                                  const double *parameters, batten_curve **out)
{
    const polygon_way *way = user;
    (void)parameters;
    return batten_curve_uniform((batten_points){dimension, count, points}, way->degree, NULL,
                                way->ends, out);
}

batten_status batten_surface_uniform(batten_grid points, int degree_u, int degree_v,
                                     batten_polygon_end ends_u, batten_polygon_end ends_v,
                                     batten_surface **out)
{
    assert(points.at && out);
    polygon_way ways[2] = {{degree_u, ends_u}, {degree_v, ends_v}};
    const batten_line_method u = {make_uniform, &ways[0], false},
                             v = {make_uniform, &ways[1], false};
    batten_status status = bat_grid_check(points.dimension, points.count_u, points.count_v,
                                          points.at, false, false);
    if (status != BATTEN_OK)
        return status;
    const int most = bat_max_int(points.count_u, points.count_v);
    double *steps = bat_array((size_t)most, sizeof *steps);
    if (!steps)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < most; i++)
        steps[i] = i;
    status =
        batten_surface_tensor(points, (batten_uv){steps, steps},
                              (const batten_line_method *const[2]){&u, &v}, NULL, NULL, out);
    bat_release(steps);
    return status;
}

/* ---- the class of Catmull and Rom ---- */

static batten_status make_catmull_rom(void *user, int dimension, int count,
                                      const double *points, const double *parameters,
                                      batten_curve **out)
{
    batten_curve_catmull_rom_options o = *(const batten_curve_catmull_rom_options *)user;
    o.given = parameters;
    return batten_curve_catmull_rom((batten_points){dimension, count, points}, &o, NULL, NULL,
                                    out);
}

batten_status batten_surface_catmull_rom(batten_grid points, batten_uv uv,
                                         const batten_curve_catmull_rom_options *const along[2],
                                         const batten_job *job, double *off,
                                         batten_surface **out)
{
    assert(points.at && out);
    batten_curve_catmull_rom_options curves[2] = {batten_curve_catmull_rom_defaults(),
                                                  batten_curve_catmull_rom_defaults()};
    batten_status status =
        BAT_TAKE_OPTIONS(batten_curve_catmull_rom_options, along[0], &curves[0]);
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_curve_catmull_rom_options, along[1], &curves[1]);
    if (status != BATTEN_OK)
        return status;
    const batten_line_method ways[2] = {{make_catmull_rom, &curves[0], curves[0].closed},
                                        {make_catmull_rom, &curves[1], curves[1].closed}};
    bat_grid_parameters at = {NULL, NULL, {0, 0}};
    status = bat_grid_check(points.dimension, points.count_u, points.count_v, points.at,
                            curves[0].closed, curves[1].closed);
    if (status == BATTEN_OK)
        status = bat_grid_parameters_of(points, BATTEN_CENTRIPETAL,
                                        (const bool[2]){curves[0].closed, curves[1].closed},
                                        (const double *const[2]){uv.u, uv.v}, &at);
    if (status == BATTEN_OK)
        status = batten_surface_tensor(points, (batten_uv){at.u, at.v},
                                       (const batten_line_method *const[2]){&ways[0], &ways[1]},
                                       job, off, out);
    bat_grid_parameters_release(&at);
    return status;
}
