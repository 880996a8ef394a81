/* What surfaces near points share: the report, and the frame of a fit to a grid. */
#ifndef BAT_GRID_FIT_H
#define BAT_GRID_FIT_H
#include "base/work.h"
#include "shape/near/approximate.h"
#include <batten/grid.h>

/* One fit to a grid on its way. Index 0 is u. */
typedef struct {
    int dimension;
    int count[2];
    const double *points;
    const batten_surface_fit_grid_options *options;
    bat_work work;
    int degree[2], wanted[2]; /* control points; periodic: of one period */
    bool periodic[2];
    const double *weights[2];
    double *parameters[2]; /* [count + 1] */
    double *knots[2];
    double spread[2];
    double *control; /* [wanted u][wanted v][d] */
    double lambda, freedom;
} bat_grid_fit;

/* Check, find parameters. Release with bat_grid_fit_end, also after a failure. */
batten_status bat_grid_fit_begin(bat_grid_fit *t, const batten_job *job);
/* A fit along one direction of lines of `width` numbers; message with its name. */
batten_status bat_grid_fit_line(const bat_grid_fit *t, int direction, int width,
                                const double *points, bat_fit *out);
/* Surface and report from the control points; gives all back. */
batten_status bat_grid_fit_finish(bat_grid_fit *t, batten_status status, double *u, double *v,
                                  batten_surface_fit_report *report, batten_surface **out);

/* Least squares with the control points that the options name, in the frame `start`, of which
 * dimension, count, points and options are set. */
batten_status bat_grid_least_squares(const bat_grid_fit *start, const batten_job *job,
                                     double *u, double *v, batten_surface_fit_report *report,
                                     batten_surface **out);

/* max, rms, most, worst of distances [count]; weights NULL: all 1. `distances` is sorted.
 * OVERFLOW when their squares are no numbers. */
batten_status bat_surface_fit_measure(size_t count, double *distances, const double *weights,
                                      batten_surface_fit_report *report);

#endif
