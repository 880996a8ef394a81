/* Surfaces near scattered data: the choice of the method, and the report. */
#include "shape/cloud/scattered.h"
#include "spline/spline.h"

#include <string.h>

batten_surface_scattered_options batten_surface_scattered_defaults(void)
{
    return (batten_surface_scattered_options){.size = sizeof(batten_surface_scattered_options),
                                              .degree_u = 3,
                                              .degree_v = 3,
                                              .corrections = 20};
}

static size_t span_of(const bat_scatter *s, size_t t, int k)
{
    const bat_net_axis *axis = &s->axis[k];
    return (size_t)bat_knots_span(axis->degree, axis->count, axis->knots,
                                  s->uv[2 * t + (size_t)k], BATTEN_FROM_RIGHT);
}

static int count_empty(const bat_scatter *s, bool *held)
{
    const int nv = s->axis[1].count;
    int empty = 0;
    for (size_t t = 0; t < s->count; t++)
        if (s->weights[t] > 0)
            held[span_of(s, t, 0) * (size_t)nv + span_of(s, t, 1)] = true;
    for (int i = s->axis[0].degree; i < s->axis[0].count; i++)
        for (int j = s->axis[1].degree; j < nv; j++)
            empty += !held[i * nv + j];
    return empty;
}

batten_status bat_scatter_report(bat_scatter *s)
{
    const size_t d = (size_t)s->dimension;
    batten_surface_fit_report *r = &s->report;
    const batten_status status = bat_surface_fit_measure(s->count, s->away, s->given, r);
    if (status != BATTEN_OK)
        return status;
    const size_t worst = (size_t)r->worst;
    for (int k = 0; k < 2; k++)
        r->at[k] = s->origin[k] + s->length * s->uv[2 * worst + (size_t)k];
    for (size_t c = 0; c < 3; c++)
        r->where[c] = c < d ? s->values[worst * d + c] : 0;
    if (d == 1) {
        r->where[2] = r->where[0];
        memcpy(r->where, r->at, sizeof r->at);
    }
    r->points_u = s->axis[0].count;
    r->points_v = s->axis[1].count;
    r->lambda = s->lambda * s->length * s->length;
    r->freedom = s->freedom;
    r->iterations = s->system.iterations;
    return BATTEN_OK;
}

static batten_status find_empty(bat_scatter *s)
{
    bool *held = bat_array3((size_t)s->axis[0].count, (size_t)s->axis[1].count, sizeof *held);
    if (!held)
        return BATTEN_OUT_OF_MEMORY;
    s->report.empty = count_empty(s, held);
    bat_release(held);
    return BATTEN_OK;
}

/* ---- fitting ---- */

batten_status bat_scatter_fit(bat_scatter *s)
{
    batten_status status;
    if (s->options->method == BATTEN_SCATTERED_MULTILEVEL)
        status = bat_scatter_levels(s);
    else if (s->options->tolerance > 0)
        status = bat_scatter_within(s);
    else
        status = bat_scatter_penalised(s);
    return status == BATTEN_OK ? find_empty(s) : status;
}

batten_status batten_surface_scattered(const double *uv, batten_points values,
                                       const batten_surface_scattered_options *options,
                                       const batten_job *job, batten_surface_fit_report *report,
                                       batten_surface **out)
{
    batten_surface_scattered_options chosen = batten_surface_scattered_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_scattered_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_scatter s = {.dimension = values.dimension,
                     .count = (size_t)bat_max_int(values.count, 0),
                     .values = values.at,
                     .options = &chosen};
    s.given = s.options->weights;
    status = bat_scatter_begin(&s, uv, job);
    if (status == BATTEN_OK)
        status = bat_scatter_fit(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_outside(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_report(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_surface(&s, out);
    if (status == BATTEN_OK && report)
        *report = s.report;
    bat_scatter_end(&s);
    return status;
}
