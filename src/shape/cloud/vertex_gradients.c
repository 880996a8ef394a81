/* Gradients at the vertices of a triangulation, from the values there. */
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

static batten_status all_gradients(surroundings *s, double *gradients, int *planes)
{
    for (int v = 0; v < s->triangles->vertex_count; v++) {
        double *g = gradients + 2 * (size_t)v;
        const int count = surround(s, v);
        if (fit_quadratic(s, v, count, g))
            continue;
        ++*planes;
        if (!fit_plane(s, v, g))
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "no plane is determined near vertex %d, (%g, %g)", v,
                            vertex(s, v)[0], vertex(s, v)[1]);
    }
    return BATTEN_OK;
}

batten_status batten_triangle_gradients(const batten_plane_triangles *triangles,
                                        const double *values, int *planes, double *gradients)
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
        status = all_gradients(&s, gradients, &fitted_planes);
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

/* ---- the network of least bending ---- */

enum { MOST_STEPS = 200 };

/* An edge of length L along the unit vector e, with the slopes a and b at its ends and s of its
 * chord, bends by 4 / L ((a - s)^2 + (a - s) (b - s) + (b - s)^2). The matrix has blocks of two
 * unknowns; those of the diagonal are the preconditioner, and bound the condition by 3. */
typedef struct {
    const batten_plane_triangles *triangles;
    size_t size;    /* unknowns */
    double *blocks; /* [vertex_count][3] the inverses of the diagonal blocks: xx, xy, yy */
    double *x, *residual, *direction, *image, *scaled;
} network;

typedef struct {
    int from, to;
    double x, y, length; /* the unit vector */
} network_edge;

/* The edge i of all sides of triangles, or false when another triangle lists it. */
static bool take_edge(const batten_plane_triangles *triangles, int i, network_edge *edge)
{
    if (triangles->beside[i] > i / 3)
        return false;
    const int *corners = triangles->corners + 3 * (i / 3);
    edge->from = corners[(i + 1) % 3];
    edge->to = corners[(i + 2) % 3];
    const double *p = triangles->vertices + 2 * (size_t)edge->from;
    const double *q = triangles->vertices + 2 * (size_t)edge->to;
    edge->length = bat_hypot(q[0] - p[0], q[1] - p[1]);
    edge->x = (q[0] - p[0]) / edge->length;
    edge->y = (q[1] - p[1]) / edge->length;
    return true;
}

static void add_along(const network_edge *edge, int vertex, double amount, double *out)
{
    out[2 * (size_t)vertex] += amount / edge->length * edge->x;
    out[2 * (size_t)vertex + 1] += amount / edge->length * edge->y;
}

static double slope_along(const network_edge *edge, int vertex, const double *g)
{
    return edge->x * g[2 * (size_t)vertex] + edge->y * g[2 * (size_t)vertex + 1];
}

/* out = A g, or with values b - A g. */
static void apply_network(const network *n, const double *values, const double *g, double *out)
{
    network_edge edge;
    memset(out, 0, n->size * sizeof *out);
    for (int i = 0; i < 3 * n->triangles->count; i++) {
        if (!take_edge(n->triangles, i, &edge))
            continue;
        double a = slope_along(&edge, edge.from, g), b = slope_along(&edge, edge.to, g);
        if (values) {
            const double s = (values[edge.to] - values[edge.from]) / edge.length;
            a = s - a;
            b = s - b;
        }
        add_along(&edge, edge.from, 2 * a + b, out);
        add_along(&edge, edge.to, a + 2 * b, out);
    }
}

static void fill_blocks(network *n)
{
    network_edge edge;
    memset(n->blocks, 0, n->size / 2 * 3 * sizeof *n->blocks);
    for (int i = 0; i < 3 * n->triangles->count; i++)
        for (int k = 0; take_edge(n->triangles, i, &edge) && k < 2; k++) {
            double *block = n->blocks + 3 * (size_t)(k ? edge.to : edge.from);
            block[0] += 2 * edge.x * edge.x / edge.length;
            block[1] += 2 * edge.x * edge.y / edge.length;
            block[2] += 2 * edge.y * edge.y / edge.length;
        }
    for (size_t v = 0; v < n->size / 2; v++) {
        double *block = n->blocks + 3 * v;
        const double whole = block[0] * block[2] - block[1] * block[1], first = block[0];
        block[0] = block[2] / whole;
        block[1] = -block[1] / whole;
        block[2] = first / whole;
    }
}

static double precondition(const network *n)
{
    double product = 0;
    for (size_t v = 0; v < n->size / 2; v++) {
        const double *block = n->blocks + 3 * v, *r = n->residual + 2 * v;
        double *z = n->scaled + 2 * v;
        z[0] = block[0] * r[0] + block[1] * r[1];
        z[1] = block[1] * r[0] + block[2] * r[1];
        product += z[0] * r[0] + z[1] * r[1];
    }
    return product;
}

static double dot_product(size_t size, const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < size; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Conjugate gradients until the residual is 1e-14 of that of gradients 0. */
static batten_status solve_network(network *n, const double *values, double *x, int *steps)
{
    memset(n->x, 0, n->size * sizeof *n->x);
    apply_network(n, values, n->x, n->residual);
    /* A residual of 1e-14 of the first, squared: as far as rounding allows. */
    const double enough = 1e-28 * precondition(n);
    apply_network(n, values, x, n->residual);
    double product = precondition(n);
    if (!isfinite(product) || !isfinite(enough))
        return bat_fail(BATTEN_OVERFLOW, "the squares of the slopes along edges overflow");
    memcpy(n->direction, n->scaled, n->size * sizeof *n->scaled);
    for (*steps = 0; product > enough; ++*steps) {
        if (*steps == MOST_STEPS)
            return bat_fail(
                BATTEN_INCOMPLETE,
                "the network of least bending is not found in %d steps: the residual "
                "is %g of the first",
                /* The square root of `enough` stands for 1e-14. */
                MOST_STEPS, sqrt(product / enough) * 1e-14);
        apply_network(n, NULL, n->direction, n->image);
        const double step = product / dot_product(n->size, n->direction, n->image);
        for (size_t i = 0; i < n->size; i++) {
            x[i] += step * n->direction[i];
            n->residual[i] -= step * n->image[i];
        }
        const double before = product;
        product = precondition(n);
        for (size_t i = 0; i < n->size; i++)
            n->direction[i] = n->scaled[i] + product / before * n->direction[i];
    }
    return bat_first_not_finite(x, n->size) == n->size
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "the gradients of the network overflow");
}

batten_status batten_triangle_network(const batten_plane_triangles *triangles,
                                      const double *values, int *iterations, double *gradients)
{
    assert(triangles && values && gradients);
    const size_t size = 2 * (size_t)triangles->vertex_count;
    network n = {.triangles = triangles, .size = size};
    double *all = bat_array3(size, 6, sizeof *all), *found = NULL;
    n.blocks = bat_array3(size / 2, 3, sizeof *n.blocks);
    batten_status status = all && n.blocks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int steps = 0;
    if (status == BATTEN_OK) {
        n.x = all;
        n.residual = all + size;
        n.direction = all + 2 * size;
        n.image = all + 3 * size;
        n.scaled = all + 4 * size;
        found = all + 5 * size;
        memcpy(found, gradients, size * sizeof *found);
        fill_blocks(&n);
        status = solve_network(&n, values, found, &steps);
    }
    if (status == BATTEN_OK) {
        memcpy(gradients, found, size * sizeof *found);
        if (iterations)
            *iterations = steps;
    }
    bat_release(n.blocks);
    bat_release(all);
    return status;
}
