/*
 * Distance of points from surfaces.
 *
 * Each patch between knot lines has the box of its control points and a grid of sample points.
 * Of a patch whose box comes nearer than what was found so far, every sample that is nearer
 * than its neighbours starts a descent inside its patch (foot.c), so that a crease along a knot
 * line is a rim like any other; where that ends on a knot line it continues over the whole
 * surface.
 */
#include "base/work.h"
#include "inspect/nearest/foot.h"
#include "inspect/nearest/nearest.h"
#include "numeric/vector.h"
#include "spline/data_check.h"

#include <float.h>
#include <string.h>

typedef struct {
    int count;     /* spans */
    int samples;   /* for each span; they share their ends */
    double *knots; /* [count + 1] */
    double *at;    /* [count * samples + 1] */
} direction;

typedef struct {
    const batten_surface *surface; /* NURBS */
    int dimension;
    direction along[2];
    double *points; /* [u samples][v samples][d] */
    double *boxes;  /* [u spans][v spans][2][d] */
} patches;

/* ---- patches ---- */

static batten_status direction_begin(const batten_surface *surface, batten_direction which,
                                     direction *out)
{
    const int degree = batten_surface_degree(surface, which);
    out->count = batten_surface_spans(surface, which, NULL) - 1;
    out->samples = 2 * degree + 1;
    out->knots = bat_array((size_t)out->count + 1, sizeof *out->knots);
    out->at = bat_array3((size_t)out->count + 1, (size_t)out->samples, sizeof *out->at);
    if (!out->knots || !out->at)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(surface, which, out->knots);
    for (int i = 0; i <= out->count * out->samples; i++) {
        const int span = i / out->samples, part = i % out->samples;
        const double a = out->knots[span], b = part ? out->knots[span + 1] : a;
        out->at[i] = a + (b - a) * part / out->samples;
    }
    return BATTEN_OK;
}

static int sample_count(const direction *along)
{
    return along->count * along->samples + 1;
}

/* The knot index that begins each span. */
static int span_index(const batten_surface *surface, batten_direction which, double knot)
{
    const double *knots = batten_surface_knots(surface, which);
    int low = batten_surface_degree(surface, which),
        high = batten_surface_point_count(surface, which);
    while (high - low > 1) {
        const int middle = low + (high - low) / 2;
        if (knots[middle] <= knot)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static void set_box(const patches *p, int i, int j, double *low, double *high)
{
    const int d = p->dimension, nv = batten_surface_point_count(p->surface, BATTEN_V);
    const int pu = batten_surface_degree(p->surface, BATTEN_U);
    const int pv = batten_surface_degree(p->surface, BATTEN_V);
    const int u = span_index(p->surface, BATTEN_U, p->along[0].knots[i]) - pu;
    const int v = span_index(p->surface, BATTEN_V, p->along[1].knots[j]) - pv;
    const double *points = batten_surface_points(p->surface);
    for (int k = 0; k < d; k++) {
        low[k] = HUGE_VAL;
        high[k] = -HUGE_VAL;
        for (int a = u; a <= u + pu; a++)
            for (int b = v; b <= v + pv; b++) {
                const double x =
                    points[((size_t)a * (size_t)nv + (size_t)b) * (size_t)d + (size_t)k];
                low[k] = bat_min(low[k], x);
                high[k] = bat_max(high[k], x);
            }
    }
}

static double *box_of(const patches *p, int i, int j)
{
    const size_t index = (size_t)i * (size_t)p->along[1].count + (size_t)j;
    return p->boxes + index * 2 * (size_t)p->dimension;
}

static batten_status patches_begin(const batten_surface *surface, const batten_job *job,
                                   patches *p)
{
    *p = (patches){.surface = surface, .dimension = batten_surface_dimension(surface)};
    const size_t d = (size_t)p->dimension;
    batten_status status = direction_begin(surface, BATTEN_U, &p->along[0]);
    if (status == BATTEN_OK)
        status = direction_begin(surface, BATTEN_V, &p->along[1]);
    if (status != BATTEN_OK)
        return status;
    const size_t nu = (size_t)sample_count(&p->along[0]),
                 nv = (size_t)sample_count(&p->along[1]);
    p->points = bat_array3(nu, nv, d * sizeof *p->points);
    p->boxes = bat_array3((size_t)p->along[0].count, (size_t)p->along[1].count,
                          2 * d * sizeof *p->boxes);
    if (!p->points || !p->boxes)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < p->along[0].count; i++)
        for (int j = 0; j < p->along[1].count; j++)
            set_box(p, i, j, box_of(p, i, j), box_of(p, i, j) + d);
    return batten_surface_evaluate_grid(
        surface, (batten_uv_grid){nu, nv, p->along[0].at, p->along[1].at}, 0, job, p->points);
}

static void patches_end(patches *p)
{
    for (int k = 0; k < 2; k++) {
        bat_release(p->along[k].knots);
        bat_release(p->along[k].at);
    }
    bat_release(p->points);
    bat_release(p->boxes);
}

/* ---- descent ---- */

/* Newton's method needs ten steps where it converges at all; on a crest it creeps. */
enum { STEPS = 50 };

static bat_foot_area whole(const patches *p)
{
    bat_foot_area all = {.surface = p->surface};
    for (int k = 0; k < 2; k++) {
        all.low[k] = p->along[k].knots[0];
        all.high[k] = p->along[k].knots[p->along[k].count];
    }
    return all;
}

/* From `at`, which becomes the foot, downhill inside the area. */
static batten_status descend(const double *q, const bat_foot_area *in, double at[2],
                             bat_nearest *best)
{
    bat_foot_place foot = {.at = {at[0], at[1]}};
    const batten_status status = bat_foot_on_surface(in, 2, STEPS, q, &foot);
    if (status != BATTEN_OK)
        return status;
    memcpy(at, foot.at, sizeof foot.at);
    const double distance = sqrt(2 * foot.value);
    if (distance < best->distance)
        *best = (bat_nearest){distance, {at[0], at[1]}};
    return BATTEN_OK;
}

/* From sample (i, j) of a patch: inside it, and beyond where that ends on its rim. */
static batten_status descend_from(const patches *p, const double *q, const bat_foot_area *patch,
                                  int i, int j, bat_nearest *best)
{
    double at[2] = {p->along[0].at[i], p->along[1].at[j]};
    const batten_status status = descend(q, patch, at, best);
    const bat_foot_area all = whole(p);
    bool on_line = false;
    for (int k = 0; k < 2; k++)
        on_line = on_line || (at[k] <= patch->low[k] && at[k] > all.low[k]) ||
                  (at[k] >= patch->high[k] && at[k] < all.high[k]);
    return status == BATTEN_OK && on_line ? descend(q, &all, at, best) : status;
}

/* ---- one point ---- */

static double box_distance(int d, const double *box, const double *q)
{
    double away[3] = {0};
    for (int k = 0; k < d; k++)
        away[k] = bat_max(0, bat_max(box[k] - q[k], q[k] - box[d + k]));
    return bat_norm(d, away);
}

static double sample_distance(const patches *p, const double *q, int i, int j)
{
    const size_t nv = (size_t)sample_count(&p->along[1]);
    return bat_distance(p->dimension,
                        p->points + ((size_t)i * nv + (size_t)j) * (size_t)p->dimension, q);
}

/* Is sample (i, j) the nearest of those around it in its patch? Of equals the first. */
static bool is_valley(const patches *p, const double *q, int i, int j, const int low[2])
{
    const double here = sample_distance(p, q, i, j);
    for (int a = i - 1; a <= i + 1; a++)
        for (int b = j - 1; b <= j + 1; b++) {
            const bool inside = a >= low[0] && a <= low[0] + p->along[0].samples &&
                                b >= low[1] && b <= low[1] + p->along[1].samples;
            if (!inside || (a != i && b != j) || (a == i && b == j))
                continue;
            const double there = sample_distance(p, q, a, b);
            if (there < here || (there == here && (a < i || (a == i && b < j))))
                return false;
        }
    return true;
}

static batten_status search_patch(const patches *p, const double *q, int pi, int pj,
                                  bat_nearest *best)
{
    const int low[2] = {pi * p->along[0].samples, pj * p->along[1].samples};
    const bat_foot_area patch = {p->surface,
                                 {p->along[0].knots[pi], p->along[1].knots[pj]},
                                 {p->along[0].knots[pi + 1], p->along[1].knots[pj + 1]}};
    batten_status status = BATTEN_OK;
    for (int i = low[0]; i <= low[0] + p->along[0].samples; i++)
        for (int j = low[1]; status == BATTEN_OK && j <= low[1] + p->along[1].samples; j++)
            if (is_valley(p, q, i, j, low))
                status = descend_from(p, q, &patch, i, j, best);
    return status;
}

/* The patch with the nearest box first: what it gives spares most others. */
static batten_status search_all(const patches *p, const double *q, bat_nearest *best)
{
    int first[2] = {0, 0};
    double nearest = HUGE_VAL;
    for (int i = 0; i < p->along[0].count; i++)
        for (int j = 0; j < p->along[1].count; j++) {
            const double away = box_distance(p->dimension, box_of(p, i, j), q);
            if (away < nearest) {
                nearest = away;
                first[0] = i;
                first[1] = j;
            }
        }
    batten_status status = search_patch(p, q, first[0], first[1], best);
    for (int i = 0; i < p->along[0].count; i++)
        for (int j = 0; status == BATTEN_OK && j < p->along[1].count; j++) {
            const bool done = i == first[0] && j == first[1];
            if (!done && box_distance(p->dimension, box_of(p, i, j), q) < best->distance)
                status = search_patch(p, q, i, j, best);
        }
    return status;
}

/* ---- many points ---- */

typedef struct {
    patches patches;
    const double *points, *start;
    bat_nearest *nearest;
} query;

static batten_status search_chunk(void *context, size_t begin, size_t end)
{
    const query *q = context;
    const patches *p = &q->patches;
    batten_status status = BATTEN_OK;
    for (size_t i = begin; status == BATTEN_OK && i < end; i++) {
        const double *point = q->points + i * (size_t)p->dimension;
        q->nearest[i].distance = HUGE_VAL;
        if (q->start) {
            const bat_foot_area all = whole(p);
            double at[2];
            for (int k = 0; k < 2; k++)
                at[k] = bat_min(all.high[k], bat_max(all.low[k], q->start[2 * i + (size_t)k]));
            status = descend(point, &all, at, &q->nearest[i]);
        }
        if (status == BATTEN_OK)
            status = search_all(p, point, &q->nearest[i]);
    }
    return status;
}

batten_status batten_surface_deviation(const batten_surface *surface, batten_points points,
                                       const double *start, const batten_job *job,
                                       double *distances, batten_deviation *out)
{
    if (points.dimension != 3)
        return bat_wrong_dimension(points, 3);
    return batten_surface_project(surface, (batten_points){3, points.count, points.at}, start,
                                  job, (batten_feet){NULL, distances}, out);
}

batten_status batten_surface_project(const batten_surface *surface, batten_points points,
                                     const double *start, const batten_job *job,
                                     batten_feet feet, batten_deviation *out)
{
    if (points.dimension != 3)
        return bat_wrong_dimension(points, 3);
    query q = {.points = points.at, .start = start};
    batten_surface *nurbs = NULL;
    batten_status status = bat_deviation_check(batten_surface_dimension(surface), points.count,
                                               points.at, start, 2);
    const batten_box box = batten_surface_box(surface);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    /* What is not NURBS is made so to twelve digits: distances are asked for as exactly. */
    if (status == BATTEN_OK)
        status = batten_surface_to_nurbs(surface, 1e-12 * size + DBL_MIN, NULL, &nurbs);
    if (status == BATTEN_OK)
        status = patches_begin(nurbs, job, &q.patches);
    if (status == BATTEN_OK &&
        !(q.nearest = bat_array((size_t)points.count, sizeof *q.nearest)))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_parallel(job, (size_t)points.count, 16, search_chunk, &q);
    if (status == BATTEN_OK)
        status = bat_deviation_finish(points.count, q.nearest, feet.distances, out);
    for (int i = 0; status == BATTEN_OK && feet.uv && i < points.count; i++)
        memcpy(feet.uv + 2 * (size_t)i, q.nearest[i].at, sizeof q.nearest[i].at);
    bat_release(q.nearest);
    patches_end(&q.patches);
    batten_surface_unref(nurbs);
    return status;
}
