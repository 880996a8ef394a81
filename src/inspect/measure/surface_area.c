/* The area of a surface by two rules of integration over its patches. */
#include "base/work.h"
#include "numeric/quadrature.h"
#include "numeric/vector.h"
#include <batten/measure.h>

#include <float.h>
#include <string.h>

/* A cell of the domain is measured with the Gauss-Legendre rules of both lengths in each
 * direction. The long one is exact up to degree 15, and the short one, up to 9, tells in which
 * direction and how far it may be off. */
enum { SHORT = 5, LONG = 8, NODES = SHORT + LONG };

/* So many cells may be halved in all: a fold, where the integrand has a kink, is not followed
 * for ever. */
enum { MOST_HALVED = 8192 };

typedef struct {
    const batten_surface *surface;
    int dimension;
    double size;                         /* by which coordinates are divided */
    double nodes[NODES], weights[NODES]; /* the short rule, then the long one */
    double *values;                      /* [NODES][NODES][3][dimension] */
} ruler;

typedef struct {
    double low[2], high[2];
    double area, error; /* in units of size^2 */
    double gain;      /* the error, or 0 where that is rounding or the cell cannot be halved */
    double direction; /* in which it is halved */
} cell;

/* ---- one cell ---- */

/* The area of the parallelogram of both steps, h halves of the sides of the cell. */
static double density(const ruler *r, const double *values, const double h[2])
{
    double a[3] = {0}, b[3] = {0};
    for (int k = 0; k < r->dimension; k++) {
        a[k] = values[r->dimension + k] / r->size * h[0];
        b[k] = values[2 * r->dimension + k] / r->size * h[1];
    }
    bat_cross(a, b, a);
    return bat_hypot(bat_hypot(a[0], a[1]), a[2]);
}

static void sum_cell(const ruler *r, cell *c)
{
    const double h[2] = {0.5 * (c->high[0] - c->low[0]), 0.5 * (c->high[1] - c->low[1])};
    double sums[2][2] = {{0, 0}, {0, 0}}; /* of the rules along u and v, the long one behind */
    for (int i = 0; i < NODES; i++)
        for (int j = 0; j < NODES; j++)
            if (i >= SHORT || j >= SHORT)
                sums[i >= SHORT][j >= SHORT] +=
                    r->weights[i] * r->weights[j] *
                    density(r, r->values + (size_t)(i * NODES + j) * 3 * (size_t)r->dimension,
                            h);
    const double fine = sums[1][1];
    const double by_u = fabs(fine - sums[0][1]), by_v = fabs(fine - sums[1][0]);
    const int k = by_v > by_u;
    const double middle = c->low[k] + 0.5 * (c->high[k] - c->low[k]);
    c->area = fine;
    c->error = bat_max(by_u, by_v) + 2 * DBL_EPSILON * fine;
    c->direction = k;
    c->gain = c->error > NODES * DBL_EPSILON * fine && middle > c->low[k] && middle < c->high[k]
                  ? c->error
                  : 0;
}

static batten_status measure_cell(const ruler *r, cell *c)
{
    double at[2][NODES];
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < NODES; i++)
            at[k][i] = c->low[k] + (c->high[k] - c->low[k]) * (0.5 + 0.5 * r->nodes[i]);
    const batten_status status = batten_surface_evaluate_grid(
        r->surface, (batten_uv_grid){NODES, NODES, at[0], at[1]}, 1, NULL, r->values);
    if (status != BATTEN_OK)
        return status;
    sum_cell(r, c);
    return isfinite(c->area)
               ? BATTEN_OK
               : bat_fail(BATTEN_OVERFLOW, "the area about (%g, %g) is out of range", at[0][0],
                          at[1][0]);
}

/* ---- all cells, in a heap: the one with the most to gain first ---- */

typedef struct {
    size_t count, room;
    cell *cells;
} heap;

static void sink(heap *h, size_t at)
{
    const cell moved = h->cells[at];
    for (size_t child = 2 * at + 1; child < h->count; child = 2 * at + 1) {
        if (child + 1 < h->count && h->cells[child + 1].gain > h->cells[child].gain)
            child++;
        if (!(h->cells[child].gain > moved.gain))
            break;
        h->cells[at] = h->cells[child];
        at = child;
    }
    h->cells[at] = moved;
}

static void rise(heap *h, size_t at)
{
    const cell moved = h->cells[at];
    for (; at > 0 && h->cells[(at - 1) / 2].gain < moved.gain; at = (at - 1) / 2)
        h->cells[at] = h->cells[(at - 1) / 2];
    h->cells[at] = moved;
}

/* Halve the first cell; its halves take its place and the next free one. */
static batten_status halve(const ruler *r, heap *h)
{
    cell low = h->cells[0], high = low;
    const int k = low.direction > 0;
    low.high[k] = high.low[k] = low.low[k] + 0.5 * (low.high[k] - low.low[k]);
    batten_status status = measure_cell(r, &low);
    if (status == BATTEN_OK)
        status = measure_cell(r, &high);
    if (status != BATTEN_OK)
        return status;
    h->cells[0] = low;
    sink(h, 0);
    h->cells[h->count++] = high;
    rise(h, h->count - 1);
    return BATTEN_OK;
}

static double sum(const heap *h, const double *member)
{
    return bat_sum(member, h->count, sizeof(cell) / sizeof(double));
}

static batten_status make_cells(const ruler *r, bat_work *work, heap *h)
{
    int counts[2];
    double *breaks[2] = {NULL, NULL};
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2; k++) {
        counts[k] = batten_surface_spans(r->surface, (batten_direction)k, NULL);
        breaks[k] = bat_array((size_t)counts[k], sizeof(double));
        if (breaks[k])
            batten_surface_spans(r->surface, (batten_direction)k, breaks[k]);
        else
            status = BATTEN_OUT_OF_MEMORY;
    }
    const size_t m = (size_t)counts[0] - 1, n = (size_t)counts[1] - 1;
    h->room = m * n + MOST_HALVED;
    if (status == BATTEN_OK && !(h->cells = bat_array(h->room, sizeof *h->cells)))
        status = BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; status == BATTEN_OK && i < m * n; i++) {
        const double *u = breaks[0] + i / n, *v = breaks[1] + i % n;
        h->cells[i] = (cell){.low = {u[0], v[0]}, .high = {u[1], v[1]}};
        status = measure_cell(r, &h->cells[i]);
        if (status == BATTEN_OK)
            status = bat_work_step(work, 1, (double)i / (double)(m * n), "measuring the area");
    }
    h->count = m * n;
    for (size_t i = h->count / 2; status == BATTEN_OK && i-- > 0;)
        sink(h, i);
    bat_release(breaks[0]);
    bat_release(breaks[1]);
    return status;
}

/* Halve cells until what may be gained is small enough. The sum that is kept of it drifts by
 * rounding, so it is made anew when it says that all is done. */
static batten_status refine(const ruler *r, double precision, bat_work *work, heap *h)
{
    batten_status status = BATTEN_OK;
    double area = sum(h, &h->cells->area), gain = sum(h, &h->cells->gain);
    while (status == BATTEN_OK && gain > precision * area && h->count < h->room) {
        const cell whole = h->cells[0];
        status = halve(r, h);
        if (status == BATTEN_OK)
            status = bat_work_step(work, 1, 1, "measuring the area");
        if ((h->room - h->count) % 64 == 0 || !(gain - whole.gain > precision * area)) {
            area = sum(h, &h->cells->area);
            gain = sum(h, &h->cells->gain);
        }
    }
    if (status == BATTEN_OK && gain > precision * area)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "the area is known to %g of it after %d halvings, not to %g",
                          gain / area, MOST_HALVED, precision);
    return status;
}

/* ---- the surface ---- */

static batten_status check_area(const batten_surface *surface, double precision, double *size)
{
    const batten_box b = batten_surface_box(surface);
    *size = bat_vec3_norm(bat_vec3_subtract(b.high, b.low));
    if (!(precision > 0 && isfinite(precision)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the precision is %g, not above 0", precision);
    if (batten_surface_dimension(surface) == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "a surface in one dimension has no area");
    if (!isfinite(*size))
        return bat_fail(BATTEN_OVERFLOW, "coordinates up to %g: the area is out of range",
                        b.high.x);
    return BATTEN_OK;
}

batten_status batten_surface_area(const batten_surface *surface, double precision,
                                  const batten_job *job, batten_area_measures *out)
{
    ruler r = {.surface = surface, .dimension = batten_surface_dimension(surface)};
    heap h = {0, 0, NULL};
    bat_work work = {.job = job};
    batten_status status = check_area(surface, precision, &r.size);
    if (status != BATTEN_OK)
        return status;
    if (r.size == 0) /* one point */
        r.size = 1;
    bat_gauss(SHORT, r.nodes, r.weights);
    bat_gauss(LONG, r.nodes + SHORT, r.weights + SHORT);
    r.values = bat_array3(NODES * NODES * 3, (size_t)r.dimension, sizeof *r.values);
    status = r.values ? make_cells(&r, &work, &h) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = refine(&r, precision, &work, &h);
    if (status == BATTEN_OK || status == BATTEN_TOLERANCE_NOT_MET) {
        const double found = sum(&h, &h.cells->area) * r.size * r.size;
        const double off = sum(&h, &h.cells->error) * r.size * r.size;
        if (isfinite(found))
            *out = (batten_area_measures){found, off};
        else
            status =
                bat_fail(BATTEN_OVERFLOW, "of a size of %g the area is out of range", r.size);
    }
    bat_release(h.cells);
    bat_release(r.values);
    return status;
}
