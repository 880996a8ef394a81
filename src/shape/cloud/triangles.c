/* From scattered points to a smooth function: vertices, triangles, gradients, elements. */
#include "base/work.h"
#include "spline/data_check.h"

#include <batten/scattered.h>

#include <float.h>
#include <string.h>

batten_triangles_scattered_options batten_triangles_scattered_defaults(void)
{
    return (batten_triangles_scattered_options){
        .size = sizeof(batten_triangles_scattered_options), .sliver = 1e-3};
}

typedef struct {
    int count;
    const double *values; /* [count] of the points */
    const batten_triangles_scattered_options *options;
    const batten_job *job;
    batten_plane_triangles triangles;
    double *f; /* [vertex_count] */
    double *g; /* [vertex_count][2] */
    batten_triangles_scattered_report report;
} pipeline;

static batten_status report_progress(const pipeline *p, double fraction, const char *what)
{
    batten_job job = BATTEN_JOB;
    const batten_status taken = BAT_TAKE_OPTIONS(batten_job, p->job, &job);
    if (taken != BATTEN_OK)
        return taken;
    if (job.progress)
        job.progress(job.user, fraction, what);
    if (job.is_cancelled && job.is_cancelled(job.user))
        return bat_fail(BATTEN_CANCELLED, "cancelled before: %s", what);
    return BATTEN_OK;
}

/* To the mean of its vertex, as the difference from the first value there. */
static void add_value(pipeline *p, int i, int *points)
{
    const int v = p->triangles.vertex_of[i];
    const double apart = p->values[i] - p->values[p->triangles.first[v]];
    p->f[v] += apart;
    points[v]++;
    if (fabs(apart) > p->report.conflict) {
        p->report.conflict = fabs(apart);
        p->report.conflicting = i;
    }
}

/* The mean of the values at each vertex: the first one, and the mean of what differs from it.
 */
static void average(pipeline *p, int *points)
{
    const batten_plane_triangles *t = &p->triangles;
    memset(points, 0, (size_t)t->vertex_count * sizeof *points);
    memset(p->f, 0, (size_t)t->vertex_count * sizeof *p->f);
    p->report.conflicting = -1;
    for (int i = 0; i < p->count; i++)
        add_value(p, i, points);
    for (int v = 0; v < t->vertex_count; v++)
        p->f[v] = p->values[t->first[v]] + p->f[v] / points[v];
}

static batten_status take_values(pipeline *p)
{
    const size_t n = (size_t)p->triangles.vertex_count;
    int *points = bat_array(n, sizeof *points);
    p->f = bat_array(n, sizeof *p->f);
    p->g = bat_array3(n, 2, sizeof *p->g);
    const bool enough = points && p->f && p->g;
    if (enough)
        average(p, points);
    bat_release(points);
    return enough ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* Slopes that are too small to be numbers would be taken for 0. */
static batten_status check_slopes(const pipeline *p)
{
    const batten_plane_triangles *t = &p->triangles;
    double rise = 0, size = 0;
    for (int v = 0; v < t->vertex_count; v++) {
        rise = bat_max(rise, fabs(p->f[v] - p->f[0]));
        for (int k = 0; k < 2; k++)
            size = bat_max(size, fabs(t->vertices[2 * (size_t)v + (size_t)k] - t->vertices[k]));
    }
    return rise == 0 || rise / size > DBL_MIN / DBL_EPSILON
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW,
                          "values differ by %g over a width of %g: such slopes overflow", rise,
                          size);
}

static batten_status find_gradients(pipeline *p)
{
    batten_status status = report_progress(p, 0.4, "gradients");
    if (status == BATTEN_OK)
        status = check_slopes(p);
    const double share = p->options->network ? 0.15 : 0.3;
    bat_stage stage;
    batten_job job;
    if (status == BATTEN_OK)
        status = bat_stage_begin(p->job, 0.4, share, &stage, &job);
    if (status == BATTEN_OK)
        status = batten_triangle_gradients(&p->triangles, p->f, &job, &p->report.planes, p->g);
    if (status != BATTEN_OK || !p->options->network)
        return status;
    p->report.planes = 0;
    status = bat_stage_begin(p->job, 0.4 + share, 0.3 - share, &stage, &job);
    return status == BATTEN_OK ? batten_triangle_network(&p->triangles, p->f, &job,
                                                         &p->report.iterations, p->g)
                               : status;
}

static batten_status make_elements_of_kind(pipeline *p, batten_triangles **out)
{
    const batten_plane_triangles *t = &p->triangles;
    const batten_triangulation domain = {t->vertex_count, t->vertices, t->corners};
    if (p->options->element == BATTEN_ELEMENT_LINEAR)
        return batten_triangles_linear(&domain, t->count, p->f, out);
    if (p->options->element == BATTEN_ELEMENT_POWELL_SABIN)
        return batten_triangles_powell_sabin(&domain, t->count, p->f, p->g, &p->report.thinnest,
                                             out);
    return batten_triangles_clough_tocher(&domain, t->count, p->f, p->g, NULL, out);
}

static batten_status make_elements(pipeline *p, batten_triangles **out)
{
    batten_status status = BATTEN_OK;
    if (p->options->element != BATTEN_ELEMENT_LINEAR)
        status = find_gradients(p);
    if (status == BATTEN_OK)
        status = report_progress(p, 0.7, "elements");
    return status == BATTEN_OK ? make_elements_of_kind(p, out) : status;
}

/* Compare every value with the corner of a piece that is its vertex. */
static void measure_misses(pipeline *p, const batten_triangles *made)
{
    batten_triangulation domain;
    const int degree = batten_triangles_degree(made);
    const int corner[3] = {0, BATTEN_TRIANGLE_POINT(degree, 0),
                           BATTEN_TRIANGLE_POINT(0, degree)};
    batten_triangles_domain(made, &domain);
    for (int i = 0; i < 3 * batten_triangles_count(made); i++)
        if (domain.corners[i] < p->triangles.vertex_count)
            p->f[domain.corners[i]] = batten_triangles_points(
                made)[(size_t)(i / 3) * (size_t)BATTEN_TRIANGLE_POINTS(degree) +
                      (size_t)corner[i % 3]];
    p->report.worst = -1;
    double scaled = 0;
    for (int i = 0; i < p->count; i++) {
        const double off = fabs(p->values[i] - p->f[p->triangles.vertex_of[i]]);
        if (off > p->report.error) {
            p->report.error = off;
            p->report.worst = i;
        }
    }
    for (int i = 0; p->report.error > 0 && i < p->count; i++) {
        const double off = (p->values[i] - p->f[p->triangles.vertex_of[i]]) / p->report.error;
        scaled += off * off;
    }
    p->report.rms = p->report.error * sqrt(scaled / p->count);
}

static batten_status make_triangles(pipeline *p, const double *xy)
{
    batten_triangulate_options options = batten_triangulate_defaults();
    bat_stage stage;
    batten_job job;
    const batten_status status = bat_stage_begin(p->job, 0, 0.3, &stage, &job);
    options.tolerance = p->options->tolerance;
    options.sliver = p->options->sliver;
    options.job = &job;
    return status == BATTEN_OK
               ? batten_triangulate((batten_points){2, p->count, xy}, &options, &p->triangles)
               : status;
}

static batten_status swap_edges(pipeline *p)
{
    bat_stage stage;
    batten_job job;
    const batten_status status = bat_stage_begin(p->job, 0.3, 0.1, &stage, &job);
    return status == BATTEN_OK
               ? batten_triangles_swap(&p->triangles, p->f, &job, &p->report.swaps)
               : status;
}

static batten_status carry_out(pipeline *p, const double *xy, batten_triangles **out)
{
    batten_status status = report_progress(p, 0, "triangles");
    if (status == BATTEN_OK)
        status = make_triangles(p, xy);
    if (status == BATTEN_OK)
        status = take_values(p);
    if (status == BATTEN_OK && p->options->data_dependent)
        status = swap_edges(p);
    if (status == BATTEN_OK)
        status = make_elements(p, out);
    if (status != BATTEN_OK)
        return status;
    p->report.vertices = p->triangles.vertex_count;
    p->report.triangles = p->triangles.count;
    p->report.pieces = batten_triangles_count(*out);
    p->report.merged = p->triangles.merged;
    p->report.slivers = p->triangles.slivers;
    measure_misses(p, *out);
    return BATTEN_OK;
}

batten_status batten_triangles_scattered(batten_points xy, const double *values,
                                         const batten_triangles_scattered_options *options,
                                         const batten_job *job,
                                         batten_triangles_scattered_report *report,
                                         batten_triangles **out)
{
    if (xy.dimension != 2)
        return bat_wrong_dimension(xy, 2);
    assert(xy.at && values && out);
    batten_triangles_scattered_options chosen = batten_triangles_scattered_defaults();
    batten_status status =
        BAT_TAKE_OPTIONS(batten_triangles_scattered_options, options, &chosen);
    if (status != BATTEN_OK)
        return status;
    const size_t n = xy.count > 0 ? (size_t)xy.count : 0, bad = bat_first_not_finite(values, n);
    if (bad < n)
        return bat_fail(BATTEN_NOT_FINITE, "value %zu is %g", bad + 1, values[bad]);
    pipeline p = {.count = xy.count, .values = values, .options = &chosen, .job = job};
    p.report.thinnest = 0.5;
    status = carry_out(&p, xy.at, out);
    if (status == BATTEN_OK && report)
        *report = p.report;
    bat_release(p.f);
    bat_release(p.g);
    batten_plane_triangles_release(&p.triangles);
    return status;
}
