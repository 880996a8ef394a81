/*
 * Where a surface cannot fold, by its control net.
 *
 * On a block of spans S_u is a positive combination of the differences of control points along u, and S_v of those along v. Seen
 * along some direction, both fill cones in a plane; where every vector of the second cone lies to the left of every one of the
 * first, by less than half a turn, the normal stays on one side. Blocks for which that does not hold are halved, down to a span.
 */
#include "inspect/fold_cones.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"

/* A product of slopes below 1 by more than roundings of the differences of near points. */
static const double surely_below_one = 1 - 1e-6;

typedef struct {
    const double *points;
    int dimension, count_v;
    int degree[2];
    int *spans[2];       /* the knot where each span begins */
    bat_span_range open; /* what is not proved */
} net;

/* Control points first .. last of each direction. */
typedef struct {
    int first[2], last[2];
} window;

static batten_vec3 point_at(const net *n, int i, int j)
{
    const size_t at = (size_t)i * (size_t)n->count_v + (size_t)j;
    return bat_vec3_of(n->dimension, n->points + (size_t)n->dimension * at);
}

/* From one corner of a window to those beside it, and between them: the mean directions. */
static void find_means(const net *n, const window *w, batten_vec3 mean[2])
{
    const batten_vec3 a = point_at(n, w->first[0], w->first[1]),
                      b = point_at(n, w->last[0], w->first[1]),
                      c = point_at(n, w->first[0], w->last[1]),
                      d = point_at(n, w->last[0], w->last[1]);
    mean[0] = bat_vec3_add(bat_vec3_subtract(b, a), bat_vec3_subtract(d, c));
    mean[1] = bat_vec3_add(bat_vec3_subtract(c, a), bat_vec3_subtract(d, b));
}

/* The slopes of all differences of one direction against their mean, in the plane of both means; false when one does not
 * run with its mean. */
static bool find_slopes(const net *n, const window *w, int direction, const batten_vec3 dual[2],
                        double range[2])
{
    const int step[2] = {direction == 0, direction == 1};
    range[0] = HUGE_VAL;
    range[1] = -HUGE_VAL;
    for (int i = w->first[0]; i <= w->last[0] - step[0]; i++)
        for (int j = w->first[1]; j <= w->last[1] - step[1]; j++) {
            const batten_vec3 by =
                bat_vec3_subtract(point_at(n, i + step[0], j + step[1]), point_at(n, i, j));
            const double with = bat_vec3_dot(by, dual[direction]),
                         across = bat_vec3_dot(by, dual[1 - direction]);
            if (with == 0 && bat_vec3_norm(by) == 0)
                continue; /* at a pole: it has no part in any direction */
            if (!(with > 0))
                return false;
            range[0] = bat_min(range[0], across / with);
            range[1] = bat_max(range[1], across / with);
        }
    return range[0] <= range[1];
}

static bool cannot_fold(const net *n, const window *w)
{
    batten_vec3 mean[2];
    double slopes[2][2];
    find_means(n, w, mean);
    const batten_vec3 normal = bat_vec3_cross(mean[0], mean[1]);
    const double square = bat_vec3_dot(normal, normal);
    if (!isnormal(square))
        return false;
    const batten_vec3 dual[2] = {bat_vec3_scale(bat_vec3_cross(mean[1], normal), 1 / square),
                                 bat_vec3_scale(bat_vec3_cross(normal, mean[0]), 1 / square)};
    if (!find_slopes(n, w, 0, dual, slopes[0]) || !find_slopes(n, w, 1, dual, slopes[1]))
        return false;
    for (int k = 0; k < 4; k++)
        if (!(slopes[0][k % 2] * slopes[1][k / 2] < surely_below_one))
            return false;
    return true;
}

/* Leave spans open. */
static void leave_open(net *n, const bat_span_range *block)
{
    for (int k = 0; k < 2; k++) {
        n->open.first[k] = bat_min_int(n->open.first[k], block->first[k]);
        n->open.end[k] = bat_max_int(n->open.end[k], block->end[k]);
    }
}

static bool is_open_already(const net *n, const bat_span_range *block)
{
    return n->open.first[0] <= block->first[0] && n->open.end[0] >= block->end[0] &&
           n->open.first[1] <= block->first[1] && n->open.end[1] >= block->end[1];
}

/* Halving goes no deeper than twice the digits of a count. */
static void prove_block(net *n, bat_span_range block)
{
    window w;
    if (is_open_already(n, &block))
        return;
    for (int k = 0; k < 2; k++) {
        w.first[k] = n->spans[k][block.first[k]] - n->degree[k];
        w.last[k] = n->spans[k][block.end[k] - 1];
    }
    if (cannot_fold(n, &w))
        return;
    const int size[2] = {block.end[0] - block.first[0], block.end[1] - block.first[1]};
    const int k = size[1] > size[0];
    if (size[k] == 1) {
        leave_open(n, &block);
        return;
    }
    const int middle = block.first[k] + size[k] / 2, end = block.end[k];
    block.end[k] = middle;
    prove_block(n, block);
    block.first[k] = middle;
    block.end[k] = end;
    prove_block(n, block);
}

/* The knots where the spans of a direction begin. */
static int *list_spans(const batten_surface *surface, batten_direction direction)
{
    const double *knots = batten_surface_knots(surface, direction);
    const int degree = batten_surface_degree(surface, direction);
    const int end = batten_surface_point_count(surface, direction);
    int *spans = bat_array((size_t)end, sizeof *spans), count = 0;
    for (int k = degree; spans && k < end; k++)
        if (knots[k] < knots[k + 1])
            spans[count++] = k;
    return spans;
}

batten_status bat_folds_possible(const batten_surface *surface, bat_span_range *out)
{
    const bat_span_range all = {{0, 0},
                                {batten_surface_spans(surface, BATTEN_U, NULL) - 1,
                                 batten_surface_spans(surface, BATTEN_V, NULL) - 1}};
    *out = all;
    if (surface->kind != &bat_nurbs_kind || batten_surface_is_rational(surface))
        return BATTEN_OK;
    net n = {.points = batten_surface_points(surface),
             .dimension = batten_surface_dimension(surface),
             .count_v = batten_surface_point_count(surface, BATTEN_V),
             .degree = {batten_surface_degree(surface, BATTEN_U),
                        batten_surface_degree(surface, BATTEN_V)},
             .spans = {list_spans(surface, BATTEN_U), list_spans(surface, BATTEN_V)},
             .open = {{all.end[0], all.end[1]}, {0, 0}}};
    const batten_status status = n.spans[0] && n.spans[1] ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        prove_block(&n, all);
        *out = n.open;
    }
    bat_release(n.spans[0]);
    bat_release(n.spans[1]);
    return status;
}
