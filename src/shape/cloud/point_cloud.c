/* Clouds of points: parameters by projection, then by steps towards the feet. */
#include "base/plural.h"
#include "inspect/nearest/foot.h"
#include "numeric/vector.h"
#include "shape/cloud/scattered.h"
#include "spline/data_check.h"
#include "spline/surface/surface.h"

#include <batten/nearest.h>
#include <float.h>
#include <string.h>

enum { CHUNK = 1024, MOST_CHOICES = 3 };

/* ---- the first parameters ---- */

static batten_status project(int count, const double *points, const batten_surface *base,
                             const batten_job *job, double *uv)
{
    batten_deviation ignored;
    if (!base)
        return bat_scatter_on_plane((size_t)count, points, uv);
    if (batten_surface_dimension(base) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the base has %d dimension%s, not 3",
                        batten_surface_dimension(base),
                        bat_plural(batten_surface_dimension(base)));
    return batten_surface_project(base, (batten_points){3, count, points}, NULL, job,
                                  (batten_feet){uv, NULL}, &ignored);
}

/* ---- steps to the feet ---- */

typedef struct {
    bat_scatter *s;
    const batten_surface *surface;
} correction;

static batten_status correct_chunk(void *context, size_t begin, size_t end)
{
    const correction *job = context;
    bat_scatter *s = job->s;
    const size_t n = end - begin;
    const size_t wide = 3 * BATTEN_SURFACE_DERIVATIVES(2);
    double *at = bat_array3(n, wide, sizeof *at), *moved = bat_array3(n, 2, sizeof *moved),
           *then = bat_array3(n, 3, sizeof *then);
    batten_status status = at && moved && then ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_many(job->surface, n, s->uv + 2 * begin, 2, NULL, at);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        const double *uv = s->uv + 2 * (begin + i);
        /* What is on a rim stays there. */
        const bool free[2] = {uv[0] > 0 && uv[0]<s->side[0], uv[1]> 0 && uv[1] < s->side[1]};
        double step[2];
        bat_foot_place here;
        bat_foot_slopes(3, at + i * wide, 2, s->centred + 3 * (begin + i), &here);
        bat_foot_step(&here, free, 0.25, step);
        for (int k = 0; k < 2; k++)
            moved[2 * i + (size_t)k] = bat_min(s->side[k], bat_max(0, uv[k] + step[k]));
    }
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_many(job->surface, n, moved, 0, NULL, then);
    for (size_t i = 0; status == BATTEN_OK && i < n; i++) {
        const double *q = s->centred + 3 * (begin + i);
        if (bat_distance(3, then + 3 * i, q) < bat_distance(3, at + i * wide, q))
            memcpy(s->uv + 2 * (begin + i), moved + 2 * i, 2 * sizeof *moved);
    }
    bat_release(then);
    bat_release(moved);
    bat_release(at);
    return status;
}

static batten_status correct_once(bat_scatter *s)
{
    correction job = {s, NULL};
    batten_surface *surface = NULL;
    batten_status status = bat_scatter_net(s, &surface);
    job.surface = surface;
    if (status == BATTEN_OK)
        status = bat_parallel(s->work.job, s->count, CHUNK, correct_chunk, &job);
    batten_surface_unref(surface);
    return status;
}

/* Correct and fit again, at most `most` times, while rms falls by a hundredth; parameters with
 * which it grows are given up. */
static batten_status correct(bat_scatter *s, batten_status (*fit)(bat_scatter *s), int most)
{
    double *kept = bat_array3(s->count, 2, sizeof *kept);
    batten_status status = kept ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int round = 0; status == BATTEN_OK && round < most; round++) {
        const double before = s->sum;
        memcpy(kept, s->uv, 2 * s->count * sizeof *kept);
        status = correct_once(s);
        if (status == BATTEN_OK)
            status = fit(s);
        if (status == BATTEN_OK && s->sum > before) {
            memcpy(s->uv, kept, 2 * s->count * sizeof *kept);
            status = fit(s);
            break;
        }
        s->report.corrections++;
        if (s->sum >= 0.98 * before)
            break;
    }
    bat_release(kept);
    return status;
}

/* To choose lambda or weights costs many fits: they stay until parameters are found, and are
 * chosen again for these, some times. */
static batten_status correct_all(bat_scatter *s)
{
    const batten_surface_scattered_options *o = s->options;
    const bool keep = o->method == BATTEN_SCATTERED_PENALISED &&
                      (o->huber || o->by != BATTEN_SMOOTH_BY_LAMBDA);
    batten_status status = BATTEN_OK;
    double before = HUGE_VAL;
    for (int i = 0; i < (keep ? MOST_CHOICES : 1) && s->sum < 0.9 * before; i++) {
        before = s->sum;
        s->keep = keep;
        status = correct(s, bat_scatter_fit, o->corrections - s->report.corrections);
        s->keep = false;
        if (status == BATTEN_OK && keep)
            status = bat_scatter_fit(s);
        if (status != BATTEN_OK)
            break;
    }
    return status;
}

/* ---- even speed ---- */

enum { STEPS = 1024, LINES = 17, COARSE = 8 };

/* The average length along direction k up to each of STEPS + 1 places, in shares. */
static batten_status find_lengths(const bat_scatter *s, const batten_surface *surface, int k,
                                  double *lengths)
{
    const size_t counts[2] = {k == 0 ? STEPS + 1 : LINES, k == 0 ? LINES : STEPS + 1};
    double *places = bat_array(STEPS + 1 + LINES, sizeof *places);
    double *grid = bat_array3(counts[0], counts[1], 3 * sizeof *grid);
    batten_status status = grid && places ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int e = 0; e < 2; e++)
            for (size_t i = 0; i < counts[e]; i++)
                places[(e ? counts[0] : 0) + i] =
                    s->side[e] * (double)i / (double)(counts[e] - 1);
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){counts[0], counts[1], places, places + counts[0]}, 0,
            NULL, grid);
    }
    lengths[0] = 0;
    for (size_t i = 1; status == BATTEN_OK && i <= STEPS; i++) {
        lengths[i] = lengths[i - 1];
        for (size_t j = 0; j < LINES; j++) {
            const size_t here = k == 0 ? i * LINES + j : j * (STEPS + 1) + i;
            const size_t before = k == 0 ? here - LINES : here - 1;
            lengths[i] += bat_distance(3, grid + 3 * here, grid + 3 * before);
        }
    }
    for (int i = 0; status == BATTEN_OK && i <= STEPS && lengths[STEPS] > 0; i++)
        lengths[i] = i == STEPS ? 1 : lengths[i] / lengths[STEPS];
    bat_release(places);
    bat_release(grid);
    return status;
}

static void map_parameters(bat_scatter *s, int k, const double *lengths)
{
    for (size_t t = 0; lengths[STEPS] > 0 && t < s->count; t++) {
        double *x = &s->uv[2 * t + (size_t)k];
        const double at = *x / s->side[k] * STEPS;
        const int i = bat_min_int(STEPS - 1, (int)at);
        const double share = lengths[i] + (at - i) * (lengths[i + 1] - lengths[i]);
        *x = *x >= s->side[k] ? s->side[k] : bat_min(s->side[k], s->side[k] * share);
    }
}

static batten_status fit_coarsely(bat_scatter *s)
{
    const int spans = bat_min_int(COARSE, bat_max_int(1, (int)(sqrt((double)s->count) / 4)));
    batten_status status = bat_scatter_even(&s->axis[0], 3, spans, s->side[0]);
    if (status == BATTEN_OK)
        status = bat_scatter_even(&s->axis[1], 3, spans, s->side[1]);
    s->probes = 0;
    return status == BATTEN_OK ? bat_scatter_nearly(s) : status;
}

static batten_status spread_once(bat_scatter *s, double *lengths)
{
    batten_surface *surface = NULL;
    batten_status status = bat_scatter_net(s, &surface);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++) {
        status = find_lengths(s, surface, k, lengths);
        if (status == BATTEN_OK)
            map_parameters(s, k, lengths);
    }
    batten_surface_unref(surface);
    return status == BATTEN_OK ? fit_coarsely(s) : status;
}

/* Parameters on the base may run unevenly, as on a plane beside a steep flank: correction alone
 * would take hundreds of rounds. Coarse fits give average lengths, by which parameters are
 * spread anew, as long as that brings the points nearer. */
static batten_status spread(bat_scatter *s)
{
    double *kept = bat_array3(s->count, 2, sizeof *kept);
    double *lengths = bat_array(STEPS + 1, sizeof *lengths);
    batten_status status = kept && lengths ? fit_coarsely(s) : BATTEN_OUT_OF_MEMORY;
    for (int round = 0; status == BATTEN_OK && round < 10; round++) {
        const double before = s->sum;
        memcpy(kept, s->uv, 2 * s->count * sizeof *kept);
        status = spread_once(s, lengths);
        if (status == BATTEN_OK && !(s->sum < 0.98 * before)) {
            memcpy(s->uv, kept, 2 * s->count * sizeof *kept);
            break;
        }
    }
    bat_release(lengths);
    bat_release(s->control); /* the fit to come makes a net of its own */
    s->control = NULL;
    bat_release(kept);
    return status;
}

/* ---- the cloud ---- */

static batten_status centre_points(bat_scatter *s)
{
    double *centred = bat_array3(s->count, 3, sizeof *centred);
    if (!centred)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < 3 * s->count; i++)
        centred[i] = s->values[i] - s->centre[i % 3];
    s->centred = centred;
    return BATTEN_OK;
}

static batten_status fit_cloud(bat_scatter *s, double *uv, const batten_job *job)
{
    const batten_surface_scattered_options *o = s->options;
    batten_status status = bat_scatter_begin(s, uv, job);
    if (status == BATTEN_OK)
        status = centre_points(s);
    if (status == BATTEN_OK)
        status = bat_scatter_layers(s);
    if (status == BATTEN_OK && o->corrections > 0) {
        s->correct = correct;
        status = spread(s);
    }
    if (status == BATTEN_OK)
        status = bat_scatter_fit(s);
    const bool within = o->tolerance > 0 && o->method == BATTEN_SCATTERED_PENALISED;
    if (status == BATTEN_OK && !within && o->corrections > 0)
        status = correct_all(s);
    for (size_t i = 0; status == BATTEN_OK && i < 2 * s->count; i++)
        uv[i] = s->origin[i % 2] + s->length * s->uv[i];
    return status;
}

batten_status batten_surface_cloud(const batten_cloud *cloud,
                                   const batten_surface_scattered_options *options,
                                   const batten_job *job, double *uv,
                                   batten_surface_fit_report *report, batten_surface **out)
{
    if (cloud->points.dimension != 3)
        return bat_wrong_dimension(cloud->points, 3);
    batten_surface_scattered_options o = batten_surface_scattered_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_surface_scattered_options, options, &o);
    if (status != BATTEN_OK)
        return status;
    bat_scatter s = {.dimension = 3,
                     .count = (size_t)bat_max_int(cloud->points.count, 0),
                     .values = cloud->points.at,
                     .given = o.weights,
                     .options = &o};
    status = bat_points_check(3, cloud->points.count, cloud->points.at, 3);
    double *at = status == BATTEN_OK ? bat_array3(s.count, 2, sizeof *at) : NULL;
    if (status == BATTEN_OK)
        status = at ? project(cloud->points.count, cloud->points.at, cloud->base, job, at)
                    : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && cloud->base && k < 2; k++) {
        const batten_interval domain =
            batten_surface_domain(cloud->base, k ? BATTEN_V : BATTEN_U);
        if (o.domain[k][0] == 0 && o.domain[k][1] == 0) {
            o.domain[k][0] = domain.a;
            o.domain[k][1] = domain.b;
        }
    }
    if (status == BATTEN_OK)
        status = fit_cloud(&s, at, job);
    if (status == BATTEN_OK)
        status = bat_scatter_outside(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_report(&s);
    if (status == BATTEN_OK)
        status = bat_scatter_surface(&s, out);
    if (status == BATTEN_OK && report)
        *report = s.report;
    if (status == BATTEN_OK && uv)
        memcpy(uv, at, 2 * s.count * sizeof *uv);
    bat_scatter_end(&s);
    bat_release(at);
    return status;
}
