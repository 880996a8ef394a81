/* Least squares on grids with a given number of control points: along v, then along u. */
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "shape/grid/fit_frame.h"
#include "shape/points/grid_poles.h"
#include "spline/curve/curve.h"

static batten_status knots_by_data(bat_grid_fit *t, int direction)
{
    const bat_fit_request request = {.degree = t->degree[direction],
                                     .count = t->wanted[direction],
                                     .periodic = t->periodic[direction],
                                     .data_count = t->count[direction],
                                     .parameters = t->parameters[direction],
                                     .weights = t->weights[direction]};
    t->knots[direction] = bat_array((size_t)request.count + (size_t)request.degree + 1,
                                    sizeof *t->knots[direction]);
    return t->knots[direction] ? bat_fit_knots(&request, t->knots[direction])
                               : BATTEN_OUT_OF_MEMORY;
}

/* Lines of `width` numbers to their control values [wanted][width]. */
static batten_status fit_direction(bat_grid_fit *t, int direction, int width,
                                   const double *lines, double *control)
{
    bat_fit fit = {0};
    int unknown = 0;
    batten_status status = bat_grid_fit_line(t, direction, width, lines, &fit);
    if (status == BATTEN_OK && t->options->hold_rims && !t->periodic[direction]) {
        fit.fixed[0] = fit.fixed[1] = true;
        fit.ends[0] = lines;
        fit.ends[1] = lines + (size_t)(t->count[direction] - 1) * (size_t)width;
    }
    if (status == BATTEN_OK && !t->periodic[direction])
        unknown = bat_fit_undetermined(&fit);
    if (status == BATTEN_OK && unknown > 0)
        status = BATTEN_SINGULAR_SYSTEM;
    else if (status == BATTEN_OK)
        status = bat_fit_solve(&fit, 0, control, &unknown);
    if (status == BATTEN_SINGULAR_SYSTEM)
        status = bat_fail(status, "control point %d of %d along %c has no grid line of its own",
                          unknown + 1, t->wanted[direction], "uv"[direction]);
    bat_fit_end(&fit);
    return status;
}

static batten_status solve_both(bat_grid_fit *t)
{
    const size_t d = (size_t)t->dimension;
    const int width_u = t->count[1] * t->dimension, width_v = t->wanted[0] * t->dimension;
    double *along = bat_array3((size_t)t->wanted[0], (size_t)width_u, sizeof *along);
    double *turned = bat_array3((size_t)t->count[1], (size_t)width_v, sizeof *turned);
    double *solved = bat_array3((size_t)t->wanted[1], (size_t)width_v, sizeof *solved);
    t->control = bat_array3((size_t)t->wanted[0], (size_t)t->wanted[1] * d, sizeof(double));
    batten_status status =
        along && turned && solved && t->control ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = knots_by_data(t, k);
    if (status == BATTEN_OK)
        status = fit_direction(t, 0, width_u, t->points, along);
    if (status == BATTEN_OK) {
        bat_transpose(t->wanted[0], t->count[1], d, along, turned);
        status = fit_direction(t, 1, width_v, turned, solved);
    }
    if (status == BATTEN_OK)
        bat_transpose(t->wanted[1], t->wanted[0], d, solved, t->control);
    for (int k = 0; k < 4 && status == BATTEN_OK && t->options->hold_rims; k++)
        if (!t->periodic[k / 2])
            bat_keep_pole((batten_grid){t->dimension, t->count[0], t->count[1], t->points},
                          t->wanted, t->control, k / 2, k % 2);
    bat_release(solved);
    bat_release(turned);
    bat_release(along);
    return status;
}

batten_status bat_grid_least_squares(const bat_grid_fit *start, const batten_job *job,
                                     double *u, double *v, batten_surface_fit_report *report,
                                     batten_surface **out)
{
    bat_grid_fit t = *start;
    batten_status status = bat_grid_fit_begin(&t, job);
    if (status == BATTEN_OK)
        status = solve_both(&t);
    return bat_grid_fit_finish(&t, status, u, v, report, out);
}
