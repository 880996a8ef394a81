/* Gradients at the vertices of a triangulation, from the values there. */
#include "base/work.h"
#include "numeric/dense.h"
#include "spline/triangles/triangulate.h"
#include <batten/scattered.h>

#include <stdlib.h>
#include <string.h>

/* ---- who is joined to whom ---- */

typedef struct {
    int *start; /* [vertex_count + 1] */
    int *list;  /* neighbours of v: list[start[v]] .. */
} rings;

static void rings_free(rings *r)
{
    bat_release(r->start);
    bat_release(r->list);
}

/* Every edge once from each of its ends: triangles have it one way each, the rim both. */
static void for_edges(const batten_plane_triangles *triangles, rings *r, bool fill)
{
    for (int i = 0; i < 3 * triangles->count; i++) {
        const int *corners = triangles->corners + 3 * (i / 3);
        const int a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
        const int ways = triangles->beside[i] < 0 ? 2 : 1;
        for (int k = 0; k < ways; k++) {
            const int from = k ? b : a, to = k ? a : b;
            if (fill)
                r->list[--r->start[from]] = to;
            else
                r->start[from]++;
        }
    }
}

static batten_status rings_make(const batten_plane_triangles *triangles, rings *out)
{
    const size_t n = (size_t)triangles->vertex_count;
    rings r = {bat_array(n + 1, sizeof *r.start), NULL};
    if (!r.start)
        return BATTEN_OUT_OF_MEMORY;
    memset(r.start, 0, (n + 1) * sizeof *r.start);
    for_edges(triangles, &r, false);
    for (size_t v = 0; v < n; v++)
        r.start[v + 1] += r.start[v];
    r.list = bat_array((size_t)r.start[n] + 1, sizeof *r.list);
    if (!r.list) {
        rings_free(&r);
        return BATTEN_OUT_OF_MEMORY;
    }
    for_edges(triangles, &r, true); /* ends of rows become their starts */
    *out = r;
    return BATTEN_OK;
}

/* ---- local quadratics ---- */

enum { NEAREST = 12, ENOUGH = 40 };

typedef struct {
    double distance;
    int vertex;
} candidate;

typedef struct {
    const batten_plane_triangles *triangles;
    const double *values;
    rings rings;
    int *seen;             /* [vertex_count] the last vertex that listed it */
    candidate *candidates; /* [vertex_count] */
} surroundings;

static int compare_candidates(const void *a, const void *b)
{
    const candidate *first = a, *second = b;
    if (first->distance != second->distance)
        return first->distance < second->distance ? -1 : 1;
    return (first->vertex > second->vertex) - (first->vertex < second->vertex);
}

static const double *vertex(const surroundings *s, int v)
{
    return s->triangles->vertices + 2 * (size_t)v;
}

/* At most `most` of the neighbours `of` a vertex: those of a hub would cost their square. */
static int list_ring(surroundings *s, int v, int of, int most, int count)
{
    const double *p = vertex(s, v);
    const int first = s->rings.start[of];
    const int end = first + bat_min_int(s->rings.start[of + 1] - first, most);
    for (int k = first; k < end; k++) {
        const int other = s->rings.list[k];
        if (s->seen[other] == v)
            continue;
        s->seen[other] = v;
        const double *q = vertex(s, other);
        s->candidates[count++] = (candidate){bat_hypot(q[0] - p[0], q[1] - p[1]), other};
    }
    return count;
}

/* The nearest vertices among neighbours, and their neighbours as long as those are few. */
static int surround(surroundings *s, int v)
{
    s->seen[v] = v;
    int count = list_ring(s, v, v, s->triangles->vertex_count, 0), done = 0;
    for (int ring = 0; ring < 2; ring++) {
        const int last = count;
        if (ring == 1 && count >= NEAREST)
            break;
        while (done < last && count < ENOUGH)
            count = list_ring(s, v, s->candidates[done++].vertex, ENOUGH, count);
    }
    qsort(s->candidates, (size_t)count, sizeof *s->candidates, compare_candidates);
    return bat_min_int(count, NEAREST);
}

/* Rows of f(q) - f(p) = g . d + d . H d / 2, lengths in units of the largest distance, weighted
 * so that each right side is the slope towards q. All slopes are unknown to the solution: it is
 * the matrix by which they make the gradient, and tells how far it would exaggerate them. Near
 * a conic through the vertex and its neighbours that has no bound; then a plane serves better.
 */
static bool fit_quadratic(const surroundings *s, int v, int count, double *gradient)
{
    enum { UNKNOWN = 5 };
    const double *p = vertex(s, v), most = 100;
    const double radius = s->candidates[count - 1].distance;
    double a[NEAREST * UNKNOWN], b[NEAREST * NEAREST] = {0};
    for (int i = 0; i < count; i++) {
        const candidate *c = s->candidates + i;
        const double *q = vertex(s, c->vertex);
        const double x = (q[0] - p[0]) / radius, y = (q[1] - p[1]) / radius;
        const double row[UNKNOWN] = {x, y, x * x / 2, x * y, y * y / 2};
        for (int k = 0; k < UNKNOWN; k++)
            a[i * UNKNOWN + k] = radius / c->distance * row[k];
        b[i * count + i] = 1;
    }
    if (count < UNKNOWN ||
        bat_dense_least_squares(count, UNKNOWN, a, (size_t)count, b) != BATTEN_OK)
        return false;
    for (int k = 0; k < 2; k++) {
        double sum = 0, size = 0;
        for (int i = 0; i < count; i++) {
            const candidate *c = s->candidates + i;
            sum += b[k * count + i] * ((s->values[c->vertex] - s->values[v]) / c->distance);
            size += fabs(b[k * count + i]);
        }
        if (!(size <= most))
            return false;
        gradient[k] = sum;
    }
    return isfinite(gradient[0]) && isfinite(gradient[1]);
}

/* The plane nearest to the slopes along all edges of a vertex: they never lie on one line. */
static bool fit_plane(const surroundings *s, int v, double *gradient)
{
    const double *p = vertex(s, v);
    double xx = 0, xy = 0, yy = 0, right[2] = {0, 0};
    for (int k = s->rings.start[v]; k < s->rings.start[v + 1]; k++) {
        const double *q = vertex(s, s->rings.list[k]);
        const double length = bat_hypot(q[0] - p[0], q[1] - p[1]);
        const double x = (q[0] - p[0]) / length, y = (q[1] - p[1]) / length;
        const double slope = (s->values[s->rings.list[k]] - s->values[v]) / length;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        right[0] += x * slope;
        right[1] += y * slope;
    }
    const double whole = xx * yy - xy * xy;
    gradient[0] = (yy * right[0] - xy * right[1]) / whole;
    gradient[1] = (xx * right[1] - xy * right[0]) / whole;
    return isfinite(gradient[0]) && isfinite(gradient[1]);
}

enum { VERTICES_A_STEP = 64 };

static batten_status all_gradients(surroundings *s, const batten_job *job, double *gradients,
                                   int *planes)
{
    bat_work work = {job, 0};
    const int all = s->triangles->vertex_count;
    for (int v = 0; v < all; v++) {
        const batten_status status =
            v % VERTICES_A_STEP
                ? BATTEN_OK
                : bat_work_step(&work, VERTICES_A_STEP, (double)v / all, "gradients");
        if (status != BATTEN_OK)
            return status;
        double *g = gradients + 2 * (size_t)v;
        const int count = surround(s, v);
        if (fit_quadratic(s, v, count, g))
            continue;
        ++*planes;
        if (!fit_plane(s, v, g))
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "no plane is determined near vertex %d, (%g, %g)", v + 1,
                            vertex(s, v)[0], vertex(s, v)[1]);
    }
    return BATTEN_OK;
}

batten_status batten_triangle_gradients(const batten_plane_triangles *triangles,
                                        const double *values, const batten_job *job, int *planes,
                                        double *gradients)
{
    assert(triangles && values && gradients);
    const size_t n = (size_t)triangles->vertex_count;
    int fitted_planes = 0;
    surroundings s = {triangles, values, {NULL, NULL}, NULL, NULL};
    batten_status status = rings_make(triangles, &s.rings);
    if (status != BATTEN_OK)
        return status;
    s.seen = bat_array(n, sizeof *s.seen);
    s.candidates = bat_array(n, sizeof *s.candidates);
    if (s.seen && s.candidates) {
        for (size_t v = 0; v < n; v++)
            s.seen[v] = -1;
        status = all_gradients(&s, job, gradients, &fitted_planes);
    } else {
        status = BATTEN_OUT_OF_MEMORY;
    }
    bat_release(s.candidates);
    bat_release(s.seen);
    rings_free(&s.rings);
    if (status == BATTEN_OK && planes)
        *planes = fitted_planes;
    return status;
}
