/* Skins through rows of points: each row with the knots that it can have, few in all. */
#include "shape/skin/rows_of_points.h"
#include "base/plural.h"
#include "base/sort.h"
#include "numeric/vector.h"
#include "shape/points/parametrize.h"
#include "spline/curve/curve.h"
#include "spline/data_check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

batten_surface_skin_rows_options batten_surface_skin_rows_defaults(void)
{
    return (batten_surface_skin_rows_options){.size = sizeof(batten_surface_skin_rows_options),
                                              .degree = 3,
                                              .parameters = BATTEN_CENTRIPETAL,
                                              .margin = 0.25};
}

typedef struct {
    int dimension, count, degree; /* rows */
    const int *counts;
    const double *points;
    const batten_surface_skin_rows_options *options;
    size_t *first; /* [count + 1] where the points of a row begin */
    double *u;     /* [first[count]] */
    bat_shared_knots shared;
    batten_curve **curves; /* [count] */
    batten_surface_skin_rows_report found;
} rows;

/* ---- checks ---- */

static batten_status check_options(const rows *r)
{
    const batten_surface_skin_rows_options *o = r->options;
    const batten_surface_skin_options *across = o->across;
    if (o->degree < 1 || o->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree along the rows is %d, not 1 to %d",
                        o->degree, BATTEN_MAX_DEGREE);
    if (!(o->margin >= 0 && o->margin < 0.5))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the margin of knots is %g; it must be 0 or more and below 0.5",
                        o->margin);
    if (o->parameters == BATTEN_GIVEN && !o->given)
        return bat_fail(BATTEN_BAD_ARGUMENT, "no parameters of the points are given");
    if (across && (across->spine || across->starts || across->tolerance != 0 ||
                   across->match != BATTEN_MATCH_PARAMETERS))
        return bat_fail(BATTEN_BAD_ARGUMENT, "rows of points have no spine, no starts, no "
                                             "tolerance, and are not matched");
    return BATTEN_OK;
}

static batten_status check_rows(rows *r)
{
    if (r->count < 2)
        return bat_fail(BATTEN_TOO_FEW_POINTS,
                        "there %s %d row%s of points, and a skin needs 2",
                        bat_one_or_many(r->count, "is", "are"), r->count, bat_plural(r->count));
    if (r->count > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "there are %d rows; the limit is %d", r->count,
                        (int)BAT_MAX_MADE_POINTS);
    size_t total = 0;
    for (int k = 0; k < r->count; k++) {
        if (r->counts[k] < 2)
            return bat_fail(BATTEN_TOO_FEW_POINTS, "row %d has %d point%s, and needs 2", k + 1,
                            r->counts[k], bat_plural(r->counts[k]));
        total += (size_t)r->counts[k];
    }
    if (total > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "the rows have %zu points; the limit is %d", total,
                        (int)BAT_MAX_MADE_POINTS);
    const size_t bad =
        bat_first_not_finite(r->points, total * (size_t)r->dimension) / (size_t)r->dimension;
    size_t first = 0;
    for (int k = 0; k < r->count && bad < total; first += (size_t)r->counts[k++])
        if (bad < first + (size_t)r->counts[k])
            return bat_fail(BATTEN_NOT_FINITE, "point %zu of row %d is not finite",
                            bad - first + 1, k + 1);
    return BATTEN_OK;
}

/* ---- parameters and knots ---- */

/* Each row from 0 to 1; a message about it names the row. */
static batten_status parametrize_row(const rows *r, int k)
{
    const int n = r->counts[k];
    double *u = r->u + r->first[k];
    const double *points = r->points + r->first[k] * (size_t)r->dimension;
    batten_status status;
    if (r->options->parameters == BATTEN_GIVEN) {
        memcpy(u, r->options->given + r->first[k], (size_t)n * sizeof *u);
        status = bat_parameters_check(n, u);
    } else
        status = bat_parametrize((batten_points){r->dimension, n, points},
                                 r->options->parameters, false, u);
    if (status != BATTEN_OK) {
        char reason[160];
        snprintf(reason, sizeof reason, "%s", batten_message());
        return bat_fail(status, "row %d: %s", k + 1, reason);
    }
    const double start = u[0], length = u[n - 1] - u[0];
    for (int i = 0; i < n; i++)
        u[i] = (u[i] - start) / length;
    u[n - 1] = 1;
    return BATTEN_OK;
}

/* Rows by their number of points, the longest first. */
typedef struct {
    int points, row;
} rank;

static int by_length(const void *a, const void *b)
{
    const rank *x = a, *y = b;
    return x->points != y->points ? y->points - x->points : x->row - y->row;
}

static batten_status share_knots(rows *r)
{
    rank *order = bat_array((size_t)r->count, sizeof *order);
    r->shared.capacity = (int)r->first[r->count];
    r->shared.knots = bat_array((size_t)r->shared.capacity, sizeof *r->shared.knots);
    batten_status status = order && r->shared.knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < r->count; k++) {
        order[k] = (rank){r->counts[k], k};
        r->found.separate_knot_count += bat_max_int(0, r->counts[k] - r->degree - 1);
    }
    if (status == BATTEN_OK)
        qsort(order, (size_t)r->count, sizeof *order, by_length);
    for (int k = 0; status == BATTEN_OK && k < r->count; k++) {
        const int row = order[k].row;
        bat_shared_knots_take(&r->shared, r->degree, r->counts[row], r->u + r->first[row],
                              r->options->margin);
    }
    bat_release(order);
    const double size = (double)(r->shared.count + r->degree + 1) * (r->count + 2);
    if (status == BATTEN_OK && size > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d rows with %d common knots make a surface of %.3g points; the limit "
                        "is %d",
                        r->count, r->shared.count, size, (int)BAT_MAX_MADE_POINTS);
    return status;
}

static batten_status find_span_ratio(rows *r)
{
    const int n = r->shared.count + 1;
    double *spans = bat_array((size_t)n, sizeof *spans);
    if (!spans)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < n; i++)
        spans[i] = (i < n - 1 ? r->shared.knots[i] : 1) - (i > 0 ? r->shared.knots[i - 1] : 0);
    bat_sort_doubles((size_t)n, spans);
    r->found.span_ratio = spans[0] / spans[n / 2];
    r->found.knot_count = r->shared.count;
    bat_release(spans);
    return BATTEN_OK;
}

/* ---- the surface ---- */

static batten_status check_points(rows *r, const batten_surface *surface, const double *v)
{
    const size_t d = (size_t)r->dimension;
    double size = 0;
    for (size_t i = 0; i < r->first[r->count] * d; i++)
        size = bat_max(size, fabs(r->points[i]));
    for (int k = 0; k < r->count; k++)
        for (size_t i = r->first[k]; i < r->first[k + 1]; i++) {
            double at[3];
            const batten_status status = batten_surface_evaluate(surface, r->u[i], v[k], 0, at);
            if (status != BATTEN_OK)
                return status;
            /* A hundred times the rounding of a banded system on coordinates of this size. */
            const double miss = bat_distance(r->dimension, at, r->points + i * d);
            r->found.error = bat_max(r->found.error, miss);
            if (!(miss <= 1e-11 * size))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET, "point %zu of row %d is missed by %g",
                                i - r->first[k] + 1, k + 1, miss);
        }
    return BATTEN_OK;
}

static batten_status through_rows(rows *r)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < r->count; k++) {
        bool is_free = false;
        status = bat_row_through(
            &r->shared, r->degree, r->dimension, r->counts[k], r->u + r->first[k],
            r->points + r->first[k] * (size_t)r->dimension, &is_free, &r->curves[k]);
        r->found.free_rows += is_free;
    }
    return status;
}

static batten_status make_surface(rows *r, const batten_job *job, double *v,
                                  batten_surface **out)
{
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < r->count; k++)
        status = parametrize_row(r, k);
    if (status == BATTEN_OK)
        status = share_knots(r);
    if (status == BATTEN_OK)
        status = find_span_ratio(r);
    if (status == BATTEN_OK)
        status = through_rows(r);
    batten_surface *surface = NULL;
    if (status == BATTEN_OK)
        status = batten_surface_skin(
            (batten_curve_row){r->count, (const batten_curve *const *)r->curves},
            r->options->across, job, v, NULL, &surface);
    const batten_surface_skin_options *across = r->options->across;
    if (status == BATTEN_OK && !(across && (across->align || across->turn)))
        status = check_points(r, surface, v);
    if (status == BATTEN_OK)
        *out = surface;
    else
        batten_surface_unref(surface);
    return status;
}

static batten_status begin_rows(rows *r)
{
    batten_status status = check_options(r);
    if (status == BATTEN_OK)
        status = check_rows(r);
    if (status != BATTEN_OK)
        return status;
    int most = 0;
    for (int k = 0; k < r->count; k++)
        most = bat_max_int(most, r->counts[k]);
    r->degree = bat_min_int(r->options->degree, most - 1);
    r->first = bat_array((size_t)r->count + 1, sizeof *r->first);
    r->curves = bat_array((size_t)r->count, sizeof *r->curves);
    if (!r->first || !r->curves)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < r->count; k++)
        r->first[k + 1] = r->first[k] + (size_t)r->counts[k];
    r->u = bat_array(r->first[r->count], sizeof *r->u);
    return r->u ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

batten_status batten_surface_skin_rows(batten_rows points,
                                       const batten_surface_skin_rows_options *options,
                                       const batten_job *job, batten_uv_out uv,
                                       batten_surface_skin_rows_report *report,
                                       batten_surface **out)
{
    batten_surface_skin_rows_options chosen = batten_surface_skin_rows_defaults();
    batten_surface_skin_options ways_across = batten_surface_skin_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_skin_rows_options, options, &chosen);
    if (status == BATTEN_OK)
        status = BAT_TAKE_OPTIONS(batten_surface_skin_options, chosen.across, &ways_across);
    if (chosen.across)
        chosen.across = &ways_across;
    if (status != BATTEN_OK)
        return status;
    rows r = {.dimension = points.dimension,
              .count = points.count,
              .counts = points.counts,
              .points = points.at,
              .options = &chosen};
    status = begin_rows(&r);
    double *across =
        status == BATTEN_OK ? bat_array((size_t)points.count, sizeof *across) : NULL;
    if (status == BATTEN_OK && !across)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = make_surface(&r, job, across, out);
    if (status == BATTEN_OK && uv.u)
        memcpy(uv.u, r.u, r.first[points.count] * sizeof *uv.u);
    if (status == BATTEN_OK && uv.v)
        memcpy(uv.v, across, (size_t)points.count * sizeof *uv.v);
    if (status == BATTEN_OK && report)
        *report = r.found;
    for (int k = 0; r.curves && k < points.count; k++)
        batten_curve_unref(r.curves[k]);
    bat_release(across);
    bat_release(r.curves);
    bat_release(r.shared.knots);
    bat_release(r.u);
    bat_release(r.first);
    return status;
}
