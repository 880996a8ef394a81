/* What nu-splines and weighted splines share. */
#ifndef BAT_DESIGN_WEIGHTED_H
#define BAT_DESIGN_WEIGHTED_H
#include "design/shared/place.h"
#include "design/shared/through.h"
#include <batten/interpolate.h>

/* Ends, parameters and 'closed' are taken from the run, the rest from the options. */
static inline batten_status bat_make_weighted(const bat_run *run, const bat_data *data,
                                              batten_curve_weighted_options *options,
                                              bat_made *made)
{
    options->closed = bat_yes(run, "closed");
    options->given = data->abscissae;
    options->start = bat_end(run, "start", "start-vector");
    options->end = bat_end(run, "end", "end-vector");
    options->parameters = bat_parametrization_of(run, data);
    return batten_curve_weighted((batten_points){data->dimension, data->count, data->points},
                                 options, made->parameters, &made->curve);
}

#endif
