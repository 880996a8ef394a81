/* Tangents shaped by tension, continuity and bias. */
#include "shape/points/mirrored_ends.h"

#include <string.h>

batten_tangents_kochanek_bartels_options batten_tangents_kochanek_bartels_defaults(void)
{
    return (batten_tangents_kochanek_bartels_options){
        .size = sizeof(batten_tangents_kochanek_bartels_options)};
}

static batten_status check_tensions(int count,
                                    const batten_tangents_kochanek_bartels_options *o)
{
    const double *lists[] = {o->tension, o->continuity, o->bias};
    static const char *const names[] = {"tension", "continuity", "bias"};
    for (int l = 0; l < 3; l++)
        for (int i = 0; lists[l] && i < count; i++)
            if (!isfinite(lists[l][i]))
                return bat_fail(BATTEN_NOT_FINITE, "the %s at point %d is %g", names[l], i + 1,
                                lists[l][i]);
    return BATTEN_OK;
}

/* The slope of the chord from point i, and its step. */
static double slope(const bat_row_beyond *row, int i, double *d)
{
    double a[3], b[3];
    const double h = bat_parameter_beyond(row, i + 1) - bat_parameter_beyond(row, i);
    bat_point_beyond(row, i, a);
    bat_point_beyond(row, i + 1, b);
    for (int k = 0; k < row->d; k++)
        d[k] = (b[k] - a[k]) / h;
    return h;
}

static double at(const double *list, int i)
{
    return list ? list[i] : 0;
}

static void tangents_at(const bat_row_beyond *row,
                        const batten_tangents_kochanek_bartels_options *o, int i,
                        double *leaving, double *arriving)
{
    double d0[3], d1[3];
    const double h0 = slope(row, i - 1, d0), h1 = slope(row, i, d1);
    const double t = at(o->tension, i), c = at(o->continuity, i), b = at(o->bias, i);
    const double w0 = (1 - t) * (1 + b) * (h1 / (h0 + h1));
    const double w1 = (1 - t) * (1 - b) * (h0 / (h0 + h1));
    for (int k = 0; k < row->d; k++) {
        arriving[k] = (1 - c) * w0 * d0[k] + (1 + c) * w1 * d1[k];
        leaving[k] = (1 + c) * w0 * d0[k] + (1 - c) * w1 * d1[k];
    }
}

static batten_status find(const bat_row_beyond *row,
                          const batten_tangents_kochanek_bartels_options *o, double *leaving,
                          double *arriving)
{
    const size_t d = (size_t)row->d, n = (size_t)row->count * d;
    double *made = bat_array3(2, n, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < row->count; i++)
        tangents_at(row, o, i, made + (size_t)i * d, made + n + (size_t)i * d);
    const size_t bad = bat_first_not_finite(made, 2 * n);
    if (bad == 2 * n) {
        memcpy(leaving, made, n * sizeof *leaving);
        memcpy(arriving, made + n, n * sizeof *arriving);
    }
    bat_release(made);
    return bad == 2 * n ? BATTEN_OK
                        : bat_fail(BATTEN_OVERFLOW, "the tangent at point %zu is too long",
                                   bad % n / d + 1);
}

batten_status
batten_tangents_kochanek_bartels(batten_points points,
                                 const batten_tangents_kochanek_bartels_options *options,
                                 double *parameters, double *leaving, double *arriving)
{
    enum { PARABOLA = 2 };
    assert(points.at && parameters && leaving && arriving);
    batten_tangents_kochanek_bartels_options chosen =
        batten_tangents_kochanek_bartels_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_tangents_kochanek_bartels_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const batten_tangents_kochanek_bartels_options *o = &chosen;
    bat_row_beyond row;
    const bat_beyond_rule rule = {.alpha = o->alpha,
                                  .given = o->given,
                                  .closed = o->closed,
                                  .kind = o->phantoms,
                                  .degree = PARABOLA};
    status = bat_row_beyond_make(points, &rule, &row);
    if (status == BATTEN_OK)
        status = check_tensions(points.count, o);
    if (status == BATTEN_OK)
        status = find(&row, o, leaving, arriving);
    if (status == BATTEN_OK)
        memcpy(parameters, row.t, ((size_t)points.count + o->closed) * sizeof *parameters);
    bat_release(row.t);
    return status;
}
