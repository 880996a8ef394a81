/* The box of a surface that has no control points: that of samples, widened. */
#include "shape/formula/nurbs.h"

#include <string.h>

enum { LEAST = 33, MOST = 513 }; /* samples along a direction */

/* The parameters of the samples: evenly in each span, each break among them where there are not
 * too many. */
static double *sample_places(const batten_surface *surface, batten_direction direction,
                             size_t *count)
{
    const int breaks = batten_surface_spans(surface, direction, NULL), spans = breaks - 1;
    double *knots = bat_array((size_t)breaks, sizeof *knots);
    const int each = spans < LEAST ? (LEAST - 1 + spans - 1) / spans : 2;
    const int n = bat_min_int(spans * each + 1, MOST);
    double *places = bat_array((size_t)n, sizeof *places);
    if (!knots || !places) {
        bat_release(knots);
        bat_release(places);
        return NULL;
    }
    batten_surface_spans(surface, direction, knots);
    for (int i = 0; i < n; i++) {
        const double at = (double)i * spans / (n - 1);
        const int s = bat_min_int((int)at, spans - 1);
        places[i] = knots[s] + (at - s) * (knots[s + 1] - knots[s]);
    }
    places[n - 1] = knots[spans];
    bat_release(knots);
    *count = (size_t)n;
    return places;
}

/* Points of a grid that stand in a line, `step` numbers apart. */
typedef struct {
    size_t count, step;
    const double *points;
} grid_line;

typedef struct {
    double low[3], high[3];
} extent;

/* The box of the points, and their largest second difference. */
static void widen_by_line(int d, const grid_line *line, extent *box, double bend[3])
{
    const size_t count = line->count, step = line->step;
    const double *points = line->points;
    for (size_t i = 0; i < count; i++)
        for (int x = 0; x < d; x++) {
            const double at = points[i * step + (size_t)x];
            box->low[x] = bat_min(box->low[x], at);
            box->high[x] = bat_max(box->high[x], at);
            if (i == 0 || i + 1 == count)
                continue;
            const double before = points[(i - 1) * step + (size_t)x],
                         after = points[(i + 1) * step + (size_t)x];
            bend[x] = bat_max(bend[x], fabs((before - at) + (after - at)));
        }
}

static batten_box box_of_samples(int d, size_t count_u, size_t count_v, const double *points)
{
    extent box = {{0}, {0}};
    double bend_u[3] = {0}, bend_v[3] = {0};
    const size_t n = (size_t)d;
    memcpy(box.low, points, n * sizeof *points);
    memcpy(box.high, points, n * sizeof *points);
    for (size_t j = 0; j < count_v; j++)
        widen_by_line(d, &(grid_line){count_u, count_v * n, points + j * n}, &box, bend_u);
    for (size_t i = 0; i < count_u; i++)
        widen_by_line(d, &(grid_line){count_v, n, points + i * count_v * n}, &box, bend_v);
    /* Between two samples a parabola leaves its chord by an eighth of the second difference. */
    for (int x = 0; x < d; x++) {
        box.low[x] -= (bend_u[x] + bend_v[x]) / 8;
        box.high[x] += (bend_u[x] + bend_v[x]) / 8;
    }
    const double *low = box.low, *high = box.high;
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

batten_status bat_formula_find_box(const batten_surface *surface, batten_box *out)
{
    size_t count_u = 0, count_v = 0;
    double *u = sample_places(surface, BATTEN_U, &count_u);
    double *v = sample_places(surface, BATTEN_V, &count_v);
    double *points = bat_array3(count_u * count_v, (size_t)surface->dimension, sizeof *points);
    batten_status status = u && v && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(surface, (batten_uv_grid){count_u, count_v, u, v},
                                              0, NULL, points);
    if (status == BATTEN_OK)
        *out = box_of_samples(surface->dimension, count_u, count_v, points);
    bat_release(u);
    bat_release(v);
    bat_release(points);
    return status;
}
