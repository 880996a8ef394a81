/* Surfaces as tiles fine enough for the picture. */
#include "picture/lines/tiles.h"

#include "picture/lines/stroke.h"
#include <batten/curvature.h>

/* In each span, steps never exceed this; across the other direction so many lines are looked
 * at. */
enum { MOST_STEPS = 96, PROBES = 48 };

/* One direction of a surface while its steps are chosen. */
typedef struct {
    int knot_count;
    double *knots;
    int *steps; /* [knot_count - 1] */
} axis;

static void axis_free(axis *a)
{
    bat_release(a->knots);
    bat_release(a->steps);
}

static batten_status axis_make(const batten_surface *surface, batten_direction direction,
                               axis *out)
{
    axis a = {.knot_count = batten_surface_spans(surface, direction, NULL)};
    a.knots = bat_array((size_t)a.knot_count, sizeof *a.knots);
    a.steps = bat_array((size_t)a.knot_count, sizeof *a.steps);
    if (!a.knots || !a.steps) {
        axis_free(&a);
        return BATTEN_OUT_OF_MEMORY;
    }
    batten_surface_spans(surface, direction, a.knots);
    *out = a;
    return BATTEN_OK;
}

/* How far the middle of three points lies from that of its neighbours. */
static double bulge(const double *a, const double *b, const double *c)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double d = b[k] - 0.5 * (a[k] + c[k]);
        sum += d * d;
    }
    return sqrt(sum);
}

/* How far the corners of a cell are from a parallelogram. */
static double twist(const double *a, const double *b, const double *c, const double *d)
{
    double sum = 0;
    for (int k = 0; k < 3; k++) {
        const double t = (a[k] - b[k]) - (c[k] - d[k]);
        sum += t * t;
    }
    return sqrt(sum);
}

/* Points probed on a grid: four steps in each span along the axis, lines across it. */
typedef struct {
    size_t count_along, count_across;
    double *points; /* [along][across][3] or [across][along][3] */
    bool along_first;
} probe;

static const double *probed(const probe *p, size_t along, size_t across)
{
    return p->points + 3 * (p->along_first ? along * p->count_across + across
                                           : across * p->count_along + along);
}

/* Linear pieces of n steps err n^2 times less than one piece, whose error is that of the halves
 * and four times that of the quarters. A cell that is cut into triangles errs by a quarter of
 * its twist; lines across are half a span apart, and n steps there too make it n^2 times less.
 */
static int steps_for(const probe *p, size_t span, double tolerance, int least)
{
    double error = 0;
    for (size_t j = 0; j < p->count_across; j++) {
        const double *q[5];
        for (size_t k = 0; k < 5; k++)
            q[k] = probed(p, 4 * span + k, j);
        error = bat_max(error, bulge(q[0], q[2], q[4]));
        error = bat_max(error, 4 * bulge(q[0], q[1], q[2]));
        error = bat_max(error, 4 * bulge(q[2], q[3], q[4]));
        if (j + 1 < p->count_across)
            error = bat_max(error, 0.5 * twist(q[0], q[4], probed(p, 4 * span, j + 1),
                                               probed(p, 4 * span + 4, j + 1)));
    }
    const double steps = ceil(sqrt(error / tolerance));
    return steps < least ? least : steps > MOST_STEPS ? MOST_STEPS : (int)steps;
}

/* Parameters across: knots and the middles of spans, thinned to about PROBES. */
static batten_status across_parameters(const axis *a, size_t *count, double **out)
{
    const batten_status status = bat_divide_spans(a->knot_count, a->knots, 2, count, out);
    const size_t every = status == BATTEN_OK ? *count / PROBES + 1 : 1;
    size_t kept = 0;
    for (size_t i = 0; status == BATTEN_OK && i < *count; i += every)
        (*out)[kept++] = (*out)[i];
    if (status == BATTEN_OK)
        *count = kept;
    return status;
}

static batten_status choose_steps(const batten_surface *surface, batten_direction direction,
                                  double tolerance, int least, axis *along, const axis *across)
{
    probe p = {.along_first = direction == BATTEN_U};
    double *at = NULL, *lines = NULL;
    batten_status status =
        bat_divide_spans(along->knot_count, along->knots, 4, &p.count_along, &at);
    if (status == BATTEN_OK)
        status = across_parameters(across, &p.count_across, &lines);
    if (status == BATTEN_OK) {
        p.points = bat_array3(p.count_along, p.count_across, 3 * sizeof *p.points);
        status = p.points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK)
        status = p.along_first
                     ? batten_surface_evaluate_grid(
                           surface, (batten_uv_grid){p.count_along, p.count_across, at, lines},
                           0, NULL, p.points)
                     : batten_surface_evaluate_grid(
                           surface, (batten_uv_grid){p.count_across, p.count_along, lines, at},
                           0, NULL, p.points);
    for (int i = 0; status == BATTEN_OK && i + 1 < along->knot_count; i++)
        along->steps[i] = steps_for(&p, (size_t)i, tolerance, least);
    bat_release(p.points);
    bat_release(lines);
    bat_release(at);
    return status;
}

static size_t point_count(const axis *a)
{
    size_t count = 0;
    for (int i = 0; i + 1 < a->knot_count; i++)
        count += (size_t)a->steps[i] + 1;
    return count;
}

static void coarsen(axis *a, double factor)
{
    for (int i = 0; i + 1 < a->knot_count; i++)
        a->steps[i] = bat_max_int(1, (int)(a->steps[i] * factor));
}

static void keep_below(size_t limit, axis *u, axis *v)
{
    /* Each span has one point more than steps, so once may not be enough; one step must
     * remain. */
    for (int round = 0; round < 8; round++) {
        const double total = (double)point_count(u) * (double)point_count(v);
        if (total <= (double)limit)
            return;
        coarsen(u, sqrt((double)limit / total));
        coarsen(v, sqrt((double)limit / total));
    }
}

static batten_status list_parameters(const axis *a, size_t *count, double **out)
{
    *count = point_count(a);
    double *u = bat_array(*count, sizeof *u);
    if (!u)
        return BATTEN_OUT_OF_MEMORY;
    size_t n = 0;
    for (int i = 0; i + 1 < a->knot_count; i++) {
        const double from = a->knots[i], range = a->knots[i + 1] - from;
        for (int k = 0; k < a->steps[i]; k++)
            u[n++] = from + range * k / a->steps[i];
        /* Just before the next knot: there the normal may jump, and both sides are shown. */
        const bool is_last = i + 2 == a->knot_count;
        u[n++] = is_last ? a->knots[i + 1] : a->knots[i + 1] - 1e-9 * range;
    }
    *out = u;
    return BATTEN_OK;
}

static batten_status evaluate(const batten_surface *surface, bat_curvature curvature,
                              const batten_job *job, bat_tiles *t)
{
    t->points = bat_array3(t->count_u, t->count_v, 3 * sizeof *t->points);
    t->normals = bat_array3(t->count_u, t->count_v, 3 * sizeof *t->normals);
    if (curvature)
        t->curvature = bat_array3(t->count_u, t->count_v, sizeof *t->curvature);
    if (!t->points || !t->normals || (curvature && !t->curvature))
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = batten_surface_normal_grid(
        surface, (batten_uv_grid){t->count_u, t->count_v, t->u, t->v}, job, t->points,
        t->normals);
    if (status == BATTEN_OK && curvature)
        status = batten_surface_curvature_grid(
            surface, (batten_uv_grid){t->count_u, t->count_v, t->u, t->v}, job,
            curvature == BAT_CURVATURE_GAUSSIAN ? t->curvature : NULL,
            curvature == BAT_CURVATURE_MEAN ? t->curvature : NULL);
    return status;
}

batten_status bat_tiles_make(const batten_surface *surface, double tolerance, int least,
                             size_t limit, bat_curvature curvature, const batten_job *job,
                             bat_tiles *out)
{
    axis u = {0, NULL, NULL}, v = {0, NULL, NULL};
    bat_tiles tiles = {0};
    batten_status status = axis_make(surface, BATTEN_U, &u);
    if (status == BATTEN_OK)
        status = axis_make(surface, BATTEN_V, &v);
    if (status == BATTEN_OK)
        status = choose_steps(surface, BATTEN_U, tolerance, least, &u, &v);
    if (status == BATTEN_OK)
        status = choose_steps(surface, BATTEN_V, tolerance, least, &v, &u);
    if (status == BATTEN_OK) {
        keep_below(limit, &u, &v);
        status = list_parameters(&u, &tiles.count_u, &tiles.u);
    }
    if (status == BATTEN_OK)
        status = list_parameters(&v, &tiles.count_v, &tiles.v);
    if (status == BATTEN_OK)
        status = evaluate(surface, curvature, job, &tiles);
    axis_free(&v);
    axis_free(&u);
    if (status == BATTEN_OK)
        *out = tiles;
    else
        bat_tiles_free(&tiles);
    return status;
}

void bat_tiles_free(bat_tiles *tiles)
{
    bat_release(tiles->u);
    bat_release(tiles->v);
    bat_release(tiles->points);
    bat_release(tiles->normals);
    bat_release(tiles->curvature);
}
