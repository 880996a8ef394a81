/* The network of least bending over a triangulation: the gradients at its vertices. */
#include "base/work.h"
#include <batten/scattered.h>

#include <string.h>

enum { MOST_STEPS = 200, USUAL_STEPS = 30 };

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

static void add_to_block(const network_edge *edge, double block[3])
{
    block[0] += 2 * edge->x * edge->x / edge->length;
    block[1] += 2 * edge->x * edge->y / edge->length;
    block[2] += 2 * edge->y * edge->y / edge->length;
}

static void invert_block(double block[3])
{
    const double whole = block[0] * block[2] - block[1] * block[1], first = block[0];
    block[0] = block[2] / whole;
    block[1] = -block[1] / whole;
    block[2] = first / whole;
}

static void fill_blocks(network *n)
{
    network_edge edge;
    memset(n->blocks, 0, n->size / 2 * 3 * sizeof *n->blocks);
    for (int i = 0; i < 3 * n->triangles->count; i++)
        for (int k = 0; take_edge(n->triangles, i, &edge) && k < 2; k++)
            add_to_block(&edge, n->blocks + 3 * (size_t)(k ? edge.to : edge.from));
    for (size_t v = 0; v < n->size / 2; v++)
        invert_block(n->blocks + 3 * v);
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
static batten_status solve_network(network *n, const double *values, bat_work *work, double *x,
                                   int *steps)
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
        const batten_status status = bat_work_step(
            work, 1, *steps / (USUAL_STEPS + (double)*steps), "the network of least bending");
        if (status != BATTEN_OK)
            return status;
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
                                      const double *values, const batten_job *job,
                                      int *iterations, double *gradients)
{
    bat_work work = {job, 0};
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
        status = solve_network(&n, values, &work, found, &steps);
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
