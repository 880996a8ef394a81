/* A set of triangles over the plane as a function of (x, y). */
#include "spline/triangles/triangles.h"
#include "spline/triangles/triangulate.h"
#include <batten/scattered.h>

#include <string.h>

static int list_rim(int count, const int *beside, int *rim)
{
    int listed = 0;
    for (int i = 0; i < 3 * count; i++)
        if (beside[i] < 0)
            rim[listed++] = i;
    return listed;
}

/* The place on the rim nearest to p: its triangle and barycentric coordinates. */
static int nearest_on_rim(const bat_walk *walk, const double p[2], double at[3])
{
    double least = INFINITY;
    int found = 0;
    for (int i = 0; i < walk->rim_count; i++) {
        const int t = walk->rim[i] / 3, e = walk->rim[i] % 3;
        const double *a = walk->vertices + 2 * (size_t)walk->corners[3 * t + (e + 1) % 3];
        const double *b = walk->vertices + 2 * (size_t)walk->corners[3 * t + (e + 2) % 3];
        const double x = b[0] - a[0], y = b[1] - a[1];
        double s = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y);
        s = bat_min(bat_max(s, 0), 1);
        const double dx = a[0] + s * x - p[0], dy = a[1] + s * y - p[1];
        if (dx * dx + dy * dy < least) {
            least = dx * dx + dy * dy;
            found = t;
            at[e] = 0;
            at[(e + 1) % 3] = 1 - s;
            at[(e + 2) % 3] = s;
        }
    }
    return found;
}

/* Barycentric coordinates that rounding has put outside come back, as those of evaluation. */
static void settle(double at[3])
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        at[k] = bat_max(at[k], 0);
        sum += at[k];
    }
    for (int k = 0; k < 3; k++)
        at[k] /= sum;
}

/* Derivatives in u and v, rows 1 and 2, become those in x and y. */
static batten_status turn_slopes(const bat_walk *walk, int t, size_t dimension, double *table)
{
    const double *v[3];
    for (int k = 0; k < 3; k++)
        v[k] = walk->vertices + 2 * (size_t)walk->corners[3 * t + k];
    const double ux = v[1][0] - v[0][0], uy = v[1][1] - v[0][1];
    const double vx = v[2][0] - v[0][0], vy = v[2][1] - v[0][1];
    const double whole = ux * vy - uy * vx;
    for (size_t d = 0; d < dimension; d++) {
        const double su = table[dimension + d], sv = table[2 * dimension + d];
        table[dimension + d] = (su * vy - sv * uy) / whole;
        table[2 * dimension + d] = (sv * ux - su * vx) / whole;
    }
    return bat_first_not_finite(table, 3 * dimension) == 3 * dimension
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "a derivative in triangle %d is no number", t + 1);
}

typedef struct {
    const batten_triangles *triangles;
    bat_walk walk;
    batten_outside outside;
    size_t outside_count;
    int t; /* where the last place was */
} place_finder;

static batten_status find_place(place_finder *finder, size_t i, const double *p, double at[3])
{
    if (!isfinite(p[0]) || !isfinite(p[1]))
        return bat_fail(BATTEN_NOT_FINITE, "place %zu is (%g, %g)", i + 1, p[0], p[1]);
    const int t = bat_walk_find(&finder->walk, finder->t, p, at);
    if (t >= 0) {
        finder->t = t;
        settle(at);
        return BATTEN_OK;
    }
    if (finder->outside == BATTEN_OUTSIDE_REFUSED)
        return bat_fail(BATTEN_OUT_OF_DOMAIN, "place %zu, (%g, %g), is outside the triangles",
                        i + 1, p[0], p[1]);
    finder->outside_count++;
    finder->t = nearest_on_rim(&finder->walk, p, at);
    return BATTEN_OK;
}

static batten_status evaluate_places(place_finder *finder, size_t count, const double *xy,
                                     int order, const batten_job *given, double *out)
{
    const size_t d = (size_t)finder->triangles->dimension, row = order ? 3 * d : d;
    batten_job job = BATTEN_JOB;
    batten_status status = BAT_TAKE_OPTIONS(batten_job, given, &job);
    for (size_t i = 0; i < count && status == BATTEN_OK; i++) {
        double at[3], table[9];
        if (i % 1024 == 0 && job.is_cancelled && job.is_cancelled(job.user))
            return bat_fail(BATTEN_CANCELLED, "cancelled after %zu of %zu places", i, count);
        status = find_place(finder, i, xy + 2 * i, at);
        if (status == BATTEN_OK)
            status = batten_triangles_evaluate(finder->triangles, finder->t, at, order, table);
        if (status == BATTEN_OK && order)
            status = turn_slopes(&finder->walk, finder->t, d, table);
        if (status == BATTEN_OK)
            memcpy(out + i * row, table, row * sizeof *out);
    }
    return status;
}

batten_status batten_triangles_over(const batten_triangles *triangles, batten_batch xy,
                                    int order, batten_outside_points outside,
                                    const batten_job *job, double *out)
{
    assert(triangles && xy.at && out && (order == 0 || order == 1));
    if (!triangles->vertex_count)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the triangles lie over no domain");
    int *beside = NULL;
    batten_status status =
        bat_triangle_neighbours(triangles->count, triangles->corners, &beside);
    if (status != BATTEN_OK)
        return status;
    int *rim = bat_array3((size_t)triangles->count, 3, sizeof *rim);
    place_finder finder = {.triangles = triangles, .outside = outside.rule};
    if (rim) {
        const bat_walk walk = {triangles->count,
                               triangles->vertices,
                               triangles->corners,
                               beside,
                               false,
                               rim,
                               list_rim(triangles->count, beside, rim)};
        finder.walk = walk;
        status = evaluate_places(&finder, xy.count, xy.at, order, job, out);
    } else {
        status = BATTEN_OUT_OF_MEMORY;
    }
    bat_release(rim);
    bat_release(beside);
    if (status == BATTEN_OK && outside.count)
        *outside.count = finder.outside_count;
    return status;
}
