/* Least squares on a grid with the fewest control points that keep within a tolerance. */
#include "shape/grid/fit_frame.h"

typedef struct {
    bat_grid_fit start;
    batten_surface_fit_grid_options options;
    const batten_job *job;
    double *u, *v;
    double tolerance;
    int most[2];
    batten_surface_fit_report report; /* of the best so far */
    batten_surface *surface;
} growth;

/* Least squares with these options. */
static batten_status fit_with(const growth *g, const batten_surface_fit_grid_options *options,
                              bool parameters, batten_surface_fit_report *report,
                              batten_surface **out)
{
    bat_grid_fit start = g->start;
    start.options = options;
    return bat_grid_least_squares(&start, g->job, parameters ? g->u : NULL,
                                  parameters ? g->v : NULL, report, out);
}

static int *points_along(batten_surface_fit_grid_options *options, int k)
{
    return k == 0 ? &options->points_u : &options->points_v;
}

/* A fit with more control points along k; with fewer lines of their own than control points
 * there is none, and *rms is infinite. */
static batten_status try_along(const growth *g, int k, double *rms)
{
    batten_surface_fit_grid_options options = g->options;
    batten_surface_fit_report report;
    batten_surface *surface = NULL;
    int *n = points_along(&options, k);
    *rms = HUGE_VAL;
    if (*n == g->most[k])
        return BATTEN_OK;
    *n = bat_min_int(g->most[k], *n + bat_max_int(1, *n / 4));
    const batten_status status = fit_with(g, &options, false, &report, &surface);
    if (status == BATTEN_OK)
        *rms = report.rms;
    batten_surface_unref(surface);
    return status == BATTEN_SINGULAR_SYSTEM ? BATTEN_OK : status;
}

static batten_status fit_best(growth *g)
{
    batten_surface *surface = NULL;
    const batten_status status = fit_with(g, &g->options, true, &g->report, &surface);
    if (status == BATTEN_OK) {
        batten_surface_unref(g->surface);
        g->surface = surface;
    }
    return status;
}

/* Along the direction that leaves less. */
static batten_status add_points(growth *g, bool *grown)
{
    double rms[2];
    batten_status status = try_along(g, 0, &rms[0]);
    if (status == BATTEN_OK)
        status = try_along(g, 1, &rms[1]);
    const int k = status == BATTEN_OK && rms[1] < rms[0] ? 1 : 0;
    *grown = status == BATTEN_OK && rms[k] < HUGE_VAL;
    if (*grown) {
        int *n = points_along(&g->options, k);
        *n = bat_min_int(g->most[k], *n + bat_max_int(1, *n / 4));
    }
    return status;
}

/* The fewest, unless the caller begins with more. */
static void settle_start(growth *g)
{
    const int degrees[2] = {g->options.degree_u, g->options.degree_v};
    for (int k = 0; k < 2; k++) {
        int *n = points_along(&g->options, k);
        g->most[k] = g->start.count[k];
        if (*n == 0)
            *n = bat_min_int(bat_max_int(degrees[k], 1) + 1, g->start.count[k]);
    }
    g->tolerance = g->options.tolerance;
    g->options.tolerance = 0;
}

static batten_status fit_within(const bat_grid_fit *start, const batten_job *job, double *u,
                                double *v, batten_surface_fit_report *report,
                                batten_surface **out)
{
    growth g = {.start = *start, .options = *start->options, .job = job, .u = u, .v = v};
    settle_start(&g);
    bool grown = true;
    int rounds = 1;
    batten_status status = fit_best(&g);
    for (; status == BATTEN_OK && g.report.error > g.tolerance && grown; rounds++) {
        status = add_points(&g, &grown);
        if (status == BATTEN_OK && grown)
            status = fit_best(&g);
    }
    if (status == BATTEN_OK && g.report.error > g.tolerance)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "datum %d is missed by %g, more than %g, with %d x %d control points",
                          g.report.worst + 1, g.report.error, g.tolerance, g.report.points_u,
                          g.report.points_v);
    if (status != BATTEN_OK) {
        batten_surface_unref(g.surface);
        return status;
    }
    g.report.rounds = rounds;
    if (report)
        *report = g.report;
    *out = g.surface;
    return BATTEN_OK;
}

batten_status batten_surface_fit_grid(batten_grid points,
                                      const batten_surface_fit_grid_options *options,
                                      const batten_job *job, batten_uv_out uv,
                                      batten_surface_fit_report *report, batten_surface **out)
{
    batten_surface_fit_grid_options chosen = batten_surface_fit_grid_defaults();
    const batten_status status =
        BAT_TAKE_OPTIONS(batten_surface_fit_grid_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const bat_grid_fit start = {.dimension = points.dimension,
                                .count = {points.count_u, points.count_v},
                                .points = points.at,
                                .options = &chosen};
    const double tolerance = start.options->tolerance;
    if (!(tolerance >= 0 && tolerance < HUGE_VAL))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not 0 or above", tolerance);
    return tolerance > 0 ? fit_within(&start, job, uv.u, uv.v, report, out)
                         : bat_grid_least_squares(&start, job, uv.u, uv.v, report, out);
}
