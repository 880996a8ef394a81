/*
 * Smoothing of grids. Each direction has the matrix G of its data and the matrix R of its
 * penalty; both become diagonal in one basis, and with them the equations of the tensor
 * product, so that a lambda costs one division for each control point.
 */
#include "numeric/dense.h"
#include "numeric/vector.h"
#include "shape/grid/fit_frame.h"
#include "shape/grid/smoothing_modes.h"
#include "shape/near/smooth.h"

#include <string.h>

enum { MOST_POINTS = 400, USUAL_POINTS = 43 };

/* ---- the tensor product ---- */

typedef struct {
    bat_grid_fit *grid;
    bat_fit fit[2];
    bat_modes modes[2];
    double *data;   /* [nu][nv][d], the data in the modes */
    double outside; /* weighted squares that no surface with these knots reaches */
    double weight;  /* of all data */
    int counted;    /* data of weight above 0 */
} smoothing;

static batten_status even_knots(bat_grid_fit *t, int k)
{
    const int p = t->degree[k], before = t->periodic[k] ? 0 : p;
    const int spans = t->periodic[k] ? t->wanted[k] : t->wanted[k] - p;
    const double a = t->parameters[k][0],
                 b = t->parameters[k][t->periodic[k] ? t->count[k] : t->count[k] - 1];
    double *U = t->knots[k] = bat_array((size_t)t->wanted[k] + (size_t)p + 2, sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i <= spans + 2 * before; i++)
        U[i] = i - before == spans ? b : a + (b - a) / spans * (i - before);
    return BATTEN_OK;
}

/* The parameter at place x, where lines of the grid are numbered from 0. */
static double at_place(const bat_grid_fit *t, int k, double x)
{
    const int i = bat_min_int((int)x, t->count[k] - 2);
    const double *u = t->parameters[k];
    return u[i] + (x - i) * (u[i + 1] - u[i]);
}

/* Averages, as for interpolation, of as many places among the data as there are control points:
 * with as many as data the rule of least squares would leave tiny spans at the rims. */
static void averaged_knots(const bat_grid_fit *t, int k, double *U)
{
    const int p = t->degree[k], n = t->wanted[k], last = t->count[k] - 1;
    for (int i = 0; i <= p; i++) {
        U[i] = t->parameters[k][0];
        U[n + i] = t->parameters[k][last];
    }
    for (int j = 1; j < n - p; j++) {
        double sum = 0;
        for (int i = j; i < j + p; i++)
            sum += at_place(t, k, (double)i * last / (n - 1));
        U[j + p] = sum / p;
    }
}

static batten_status data_knots(bat_grid_fit *t, int k)
{
    double *U = t->knots[k] =
        bat_array((size_t)t->wanted[k] + (size_t)t->degree[k] + 1, sizeof *U);
    if (!U)
        return BATTEN_OUT_OF_MEMORY;
    if (!t->periodic[k]) {
        averaged_knots(t, k, U);
        return BATTEN_OK;
    }
    const bat_fit_request request = {.degree = t->degree[k],
                                     .count = t->wanted[k],
                                     .periodic = true,
                                     .data_count = t->count[k],
                                     .parameters = t->parameters[k],
                                     .weights = t->weights[k]};
    return bat_fit_knots(&request, U);
}

static batten_status prepare_direction(smoothing *s, int k)
{
    bat_grid_fit *t = s->grid;
    const batten_surface_fit_grid_options *o = t->options;
    const bool even = o->penalty == BATTEN_GRID_DIFFERENCES;
    const int order = bat_min_int(o->order, even ? t->wanted[k] - 1 : t->degree[k]);
    batten_status status = even ? even_knots(t, k) : data_knots(t, k);
    if (status == BATTEN_OK)
        status = bat_grid_fit_line(t, k, 1, t->points, &s->fit[k]);
    if (status == BATTEN_OK)
        status = even ? bat_fit_penalise_differences(&s->fit[k], order)
                      : bat_fit_penalise_energy(&s->fit[k], order);
    if (status == BATTEN_OK)
        status = bat_modes_make(&s->fit[k], t->periodic[k] ? 1 : order, &s->modes[k]);
    return status;
}

/* out [n][width] = T N^t W lines, of lines [count][width]. */
static batten_status project(const smoothing *s, int k, size_t width, const double *lines,
                             double *out)
{
    const bat_fit *fit = &s->fit[k];
    const size_t n = (size_t)fit->count;
    double *right = bat_array3(n, width, sizeof *right);
    if (!right)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < fit->data_count; i++)
        for (int a = 0; a < fit->data.width; a++) {
            const double f = fit->factors[i] * fit->factors[i] *
                             fit->data.values[(size_t)i * (size_t)fit->data.width + (size_t)a];
            double *to = right + (size_t)((fit->data.first[i] + a) % fit->count) * width;
            for (size_t c = 0; c < width; c++)
                to[c] += f * lines[(size_t)i * width + c];
        }
    memset(out, 0, n * width * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            for (size_t c = 0; c < width; c++)
                out[i * width + c] += s->modes[k].basis[i * n + j] * right[j * width + c];
    bat_release(right);
    return BATTEN_OK;
}

/* out [n][width] = T^t x. */
static void expand(const bat_modes *m, size_t width, const double *x, double *out)
{
    const size_t n = (size_t)m->n;
    memset(out, 0, n * width * sizeof *out);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++)
            for (size_t c = 0; c < width; c++)
                out[j * width + c] += m->basis[i * n + j] * x[i * width + c];
}

static batten_status to_modes(smoothing *s)
{
    const bat_grid_fit *t = s->grid;
    const size_t d = (size_t)t->dimension, cv = (size_t)t->count[1];
    const int nu = t->wanted[0], nv = t->wanted[1];
    double *along = bat_array3((size_t)nu, cv * d, sizeof *along);
    double *turned = bat_array3((size_t)nu, cv * d, sizeof *turned);
    double *across = bat_array3((size_t)nu, (size_t)nv * d, sizeof *across);
    s->data = bat_array3((size_t)nu, (size_t)nv * d, sizeof *s->data);
    batten_status status =
        along && turned && across && s->data ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = project(s, 0, cv * d, t->points, along);
    if (status == BATTEN_OK) {
        bat_transpose(nu, t->count[1], d, along, turned);
        status = project(s, 1, (size_t)nu * d, turned, across);
    }
    if (status == BATTEN_OK)
        bat_transpose(nv, nu, d, across, s->data);
    bat_release(across);
    bat_release(turned);
    bat_release(along);
    return status;
}

/* The roughness of mode (i, j). */
static double roughness(const smoothing *s, int i, int j)
{
    return s->modes[0].penalty[i] + s->modes[1].penalty[j];
}

/* How much of mode (i, j) is kept; lambda may be infinite. */
static double kept(const smoothing *s, int i, int j, double lambda)
{
    const double q = roughness(s, i, j);
    return q > 0 ? 1 / (1 + lambda * q) : 1;
}

static batten_status from_modes(const smoothing *s, double lambda)
{
    const bat_grid_fit *t = s->grid;
    const size_t d = (size_t)t->dimension;
    const int nu = t->wanted[0], nv = t->wanted[1];
    const size_t size = (size_t)nu * (size_t)nv * d;
    double *x = bat_array(size, sizeof *x), *half = bat_array(size, sizeof *half);
    const batten_status status = x && half ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < nu; i++)
        for (int j = 0; j < nv; j++)
            for (size_t c = 0; c < d; c++) {
                const size_t at = ((size_t)i * (size_t)nv + (size_t)j) * d + c;
                x[at] = s->data[at] * kept(s, i, j, lambda);
            }
    if (status == BATTEN_OK) {
        expand(&s->modes[0], (size_t)nv * d, x, half);
        bat_transpose(nu, nv, d, half, x);
        expand(&s->modes[1], (size_t)nu * d, x, half);
        bat_transpose(nv, nu, d, half, t->control);
    }
    bat_release(half);
    bat_release(x);
    return status;
}

/* The value that the control points give at datum (i, j). */
static void value_at(const smoothing *s, int i, int j, double *out)
{
    const bat_grid_fit *t = s->grid;
    const int d = t->dimension;
    const bat_rows_of_fit *u = &s->fit[0].data, *v = &s->fit[1].data;
    for (int c = 0; c < d; c++)
        out[c] = 0;
    for (int a = 0; a < u->width; a++)
        for (int b = 0; b < v->width; b++) {
            const int row = (u->first[i] + a) % t->wanted[0],
                      column = (v->first[j] + b) % t->wanted[1];
            const double f = u->values[i * u->width + a] * v->values[j * v->width + b];
            const double *p =
                t->control + ((size_t)row * (size_t)t->wanted[1] + (size_t)column) * (size_t)d;
            for (int c = 0; c < d; c++)
                out[c] += f * p[c];
        }
}

/* What the least squares leave; measured, for it may be far below the data's size. */
static batten_status find_outside(smoothing *s)
{
    const bat_grid_fit *t = s->grid;
    const batten_status status = from_modes(s, 0);
    for (int i = 0; status == BATTEN_OK && i < t->count[0]; i++)
        for (int j = 0; j < t->count[1]; j++) {
            const double f = s->fit[0].factors[i] * s->fit[1].factors[j];
            double found[3];
            value_at(s, i, j, found);
            const double away =
                bat_distance(t->dimension, found,
                             t->points + ((size_t)i * (size_t)t->count[1] + (size_t)j) *
                                             (size_t)t->dimension);
            s->outside += f * f * away * away;
            s->weight += f * f;
            s->counted += f > 0;
        }
    return status;
}

/* ---- lambda ---- */

static batten_status weighted_rms(void *user, double lambda, double *rms)
{
    const smoothing *s = user;
    const bat_grid_fit *t = s->grid;
    double sum = s->outside;
    for (int i = 0; i < t->wanted[0]; i++)
        for (int j = 0; j < t->wanted[1]; j++) {
            const double lost = 1 - kept(s, i, j, lambda);
            const double *x =
                s->data + ((size_t)i * (size_t)t->wanted[1] + (size_t)j) * (size_t)t->dimension;
            sum += lost * lost * bat_dot(t->dimension, x, x);
        }
    *rms = sqrt(sum / s->weight);
    return BATTEN_OK;
}

static double freedom(const smoothing *s, double lambda)
{
    double sum = 0;
    for (int i = 0; i < s->grid->wanted[0]; i++)
        for (int j = 0; j < s->grid->wanted[1]; j++)
            sum += kept(s, i, j, lambda);
    return sum;
}

static batten_status validation(void *user, double lambda, double *score)
{
    const smoothing *s = user;
    double rms;
    const batten_status status = weighted_rms(user, lambda, &rms);
    const double rest = s->counted - freedom(s, lambda);
    /* With a trace so near to the number of data the surface interpolates. */

    *score = rest > 1e-6 * s->counted ? rms * s->counted / rest : HUGE_VAL;
    return status;
}

static double scale_of(const smoothing *s)
{
    double sum = 0;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < s->modes[k].n; i++)
            sum += s->modes[k].penalty[i] / s->modes[k].n;
    return sum > 0 ? 1 / sum : 1;
}

static batten_status smooth(smoothing *s)
{
    bat_grid_fit *t = s->grid;
    const batten_surface_fit_grid_options *o = t->options;
    t->control = bat_array3((size_t)t->wanted[0], (size_t)t->wanted[1],
                            (size_t)t->dimension * sizeof(double));
    batten_status status = t->control ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = prepare_direction(s, k);
    if (status == BATTEN_OK)
        status = to_modes(s);
    if (status == BATTEN_OK)
        status = find_outside(s);
    if (status == BATTEN_OK && !(s->weight > 0))
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "all data have the weight 0");
    const bat_lambda_search search = {
        .by = o->by,
        .amount = o->amount,
        .scale = status == BATTEN_OK ? scale_of(s) : 1,
        .last = bat_last_decade(o->order, bat_max_int(t->wanted[0], t->wanted[1])),
        .user = s,
        .rms = weighted_rms,
        .score = validation,
    };
    if (status == BATTEN_OK)
        status = bat_lambda_choose(&search, &t->lambda);
    if (status == BATTEN_OK)
        t->freedom = freedom(s, t->lambda);
    return status == BATTEN_OK ? from_modes(s, t->lambda) : status;
}

/* With knots at all data a ring of even degree is singular. */
static int usual_points(int count, bool periodic, int degree)
{
    return bat_min_int(USUAL_POINTS, periodic && degree % 2 == 0 ? (count + 1) / 2 : count);
}

static batten_status check_smoothing(const batten_surface_fit_grid_options *o)
{
    if (o->order < 1 || o->order > 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the order of the penalty is %d, not 1 to 4",
                        o->order);
    if (o->by != BATTEN_SMOOTH_BY_VALIDATION && !(o->amount >= 0))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the amount of smoothing is %g, below 0",
                        o->amount);
    if (o->points_u > MOST_POINTS || o->points_v > MOST_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d control points in one direction; the limit is %d",
                        bat_max_int(o->points_u, o->points_v), (int)MOST_POINTS);
    return BATTEN_OK;
}

batten_status batten_surface_smooth_grid(batten_grid points,
                                         const batten_surface_fit_grid_options *options,
                                         const batten_job *job, batten_uv_out uv,
                                         batten_surface_fit_report *report,
                                         batten_surface **out)
{
    batten_surface_fit_grid_options chosen = batten_surface_fit_grid_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_fit_grid_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    bat_grid_fit t = {.dimension = points.dimension,
                      .count = {points.count_u, points.count_v},
                      .points = points.at,
                      .options = &chosen};
    smoothing s = {.grid = &t};
    const batten_surface_fit_grid_options *o = t.options;
    t.wanted[0] = o->points_u ? 0 : usual_points(points.count_u, o->closed_u, o->degree_u);
    t.wanted[1] = o->points_v ? 0 : usual_points(points.count_v, o->closed_v, o->degree_v);
    status = check_smoothing(t.options);
    if (status == BATTEN_OK)
        status = bat_grid_fit_begin(&t, job);
    if (status == BATTEN_OK)
        status = smooth(&s);
    for (int k = 0; k < 2; k++) {
        bat_fit_end(&s.fit[k]);
        bat_modes_free(&s.modes[k]);
    }
    bat_release(s.data);
    return bat_grid_fit_finish(&t, status, uv.u, uv.v, report, out);
}
