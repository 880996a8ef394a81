/*
 * Where a surface cannot fold, by its control net.
 *
 * On a block of spans S_u is a positive combination of the differences of control points along u, and S_v of those along v. Seen
 * along some direction, both fill cones in a plane; where every vector of the second cone lies to the left of every one of the
 * first, by less than half a turn, the normal stays on one side. Blocks for which that does not hold are halved, down to a span.
 * The derivative of a rational curve, too, is a positive combination of those differences (Floater, Derivatives of rational
 * Bezier curves, CAGD 9, 1992); of a surface where the lines across have the same weights but for a factor.
 */
#include "inspect/fold_cones.h"
#include "base/list.h"
#include "numeric/vector.h"
#include "spline/surface/surface.h"

#include <float.h>

/* A product of slopes below 1 by more than roundings of the differences of near points. */
static const double surely_below_one = 1 - 1e-6;

typedef struct {
    const double *points;
    int dimension, count_v;
    int degree[2];
    int count[2];         /* of spans */
    int *spans[2];        /* the knot where each begins */
    bat_span_ranges open; /* what is not proved */
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

/* Looks at every difference of a window, or at some of them. */
typedef struct {
    const net *net;
    const window *window;
    int every[2];
    batten_vec3 dual[2];
} looking;

/* The slopes of the differences of one direction against their mean, in the plane of both means; false when one does not
 * run with its mean. The dimension is known where it is inlined. */
static inline bool slopes_of(const looking *look, int d, int direction, double range[2])
{
    const net *n = look->net;
    const window *w = look->window;
    const int step[2] = {direction == 0, direction == 1};
    const size_t next = (size_t)d * (direction == 0 ? (size_t)n->count_v : 1);
    const batten_vec3 along = look->dual[direction], beside = look->dual[1 - direction];
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = w->first[0]; i <= w->last[0] - step[0]; i += look->every[0])
        for (int j = w->first[1]; j <= w->last[1] - step[1]; j += look->every[1]) {
            const double *a =
                n->points + (size_t)d * ((size_t)i * (size_t)n->count_v + (size_t)j);
            const batten_vec3 by =
                bat_vec3_subtract(bat_vec3_of(d, a + next), bat_vec3_of(d, a));
            const double with = bat_vec3_dot(by, along), across = bat_vec3_dot(by, beside);
            if (with == 0 && bat_vec3_norm(by) == 0)
                continue; /* at a pole: it has no part in any direction */
            if (!(with > 0))
                return false;
            const double slope = across / with;
            low = bat_min(low, slope);
            high = bat_max(high, slope);
        }
    range[0] = low;
    range[1] = high;
    return low <= high;
}

static bool find_slopes(const looking *look, int direction, double range[2])
{
    return look->net->dimension == 3 ? slopes_of(look, 3, direction, range)
                                     : slopes_of(look, 2, direction, range);
}

/* Do all differences that are looked at lie in cones of which the second is to the left of the first? */
static bool keep_apart(const looking *look)
{
    double slopes[2][2];
    if (!find_slopes(look, 0, slopes[0]) || !find_slopes(look, 1, slopes[1]))
        return false;
    for (int k = 0; k < 4; k++)
        if (!(slopes[0][k % 2] * slopes[1][k / 2] < surely_below_one))
            return false;
    return true;
}

static bool cannot_fold(const net *n, const window *w)
{
    /* Of a large window so many lines are looked at first: most that fail do so there. */
    enum { FEW = 6 };
    batten_vec3 mean[2];
    find_means(n, w, mean);
    const batten_vec3 normal = bat_vec3_cross(mean[0], mean[1]);
    const double square = bat_vec3_dot(normal, normal);
    if (!isnormal(square))
        return false;
    looking look = {.net = n,
                    .window = w,
                    .every = {1, 1},
                    .dual = {bat_vec3_scale(bat_vec3_cross(mean[1], normal), 1 / square),
                             bat_vec3_scale(bat_vec3_cross(normal, mean[0]), 1 / square)}};
    const int lines[2] = {w->last[0] - w->first[0], w->last[1] - w->first[1]};
    if (lines[0] > 2 * FEW || lines[1] > 2 * FEW) {
        for (int k = 0; k < 2; k++)
            look.every[k] = bat_max_int(1, lines[k] / FEW);
        if (!keep_apart(&look))
            return false;
        look.every[0] = look.every[1] = 1;
    }
    return keep_apart(&look);
}

/* The spans to be looked at for a range: one more at each side. */
static double looked_at(const bat_span_range *range)
{
    return (range->end[0] - range->first[0] + 2.0) * (range->end[1] - range->first[1] + 2.0);
}

/* One range for those from `first` on, where that is no more work. */
static void join_ranges(bat_span_ranges *open, int first)
{
    if (open->count - first < 2)
        return;
    bat_span_range whole = open->at[first];
    double apart = 0;
    for (int i = first; i < open->count; i++) {
        const bat_span_range *range = &open->at[i];
        for (int k = 0; k < 2; k++) {
            whole.first[k] = bat_min_int(whole.first[k], range->first[k]);
            whole.end[k] = bat_max_int(whole.end[k], range->end[k]);
        }
        apart += looked_at(range);
    }
    if (apart < looked_at(&whole))
        return;
    open->at[first] = whole;
    open->count = first + 1;
}

/* Halving goes no deeper than twice the digits of a count. */
static batten_status prove_block(net *n, bat_span_range block)
{
    window w;
    for (int k = 0; k < 2; k++) {
        w.first[k] = n->spans[k][block.first[k]] - n->degree[k];
        w.last[k] = n->spans[k][block.end[k] - 1];
    }
    if (cannot_fold(n, &w))
        return BATTEN_OK;
    const int size[2] = {block.end[0] - block.first[0], block.end[1] - block.first[1]};
    /* The direction of which it has the larger part: both bend about as much over the whole. */
    const bool is_wide = (double)size[1] * n->count[0] > (double)size[0] * n->count[1];
    const int k = size[0] == 1 || (is_wide && size[1] > 1), proved_before = n->open.count;
    if (size[k] == 1)
        return BAT_LIST_ADD(n->open.at, n->open.count, n->open.room, block);
    const int middle = block.first[k] + size[k] / 2, end = block.end[k];
    block.end[k] = middle;
    batten_status status = prove_block(n, block);
    block.first[k] = middle;
    block.end[k] = end;
    if (status == BATTEN_OK)
        status = prove_block(n, block);
    join_ranges(&n->open, proved_before);
    return status;
}

/* Are the weights products of those of a row and of a column, but for rounding? */
static bool weights_are_products(const batten_surface *surface)
{
    const double *w = batten_surface_weights(surface);
    const int count_u = batten_surface_point_count(surface, BATTEN_U),
              count_v = batten_surface_point_count(surface, BATTEN_V);
    for (int i = 1; w && i < count_u; i++)
        for (int j = 1; j < count_v; j++) {
            const double row = w[(size_t)i * (size_t)count_v], product = row * (w[j] / w[0]);
            if (!(fabs(w[(size_t)i * (size_t)count_v + (size_t)j] - product) <=
                  8 * DBL_EPSILON * product))
                return false;
        }
    return true;
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

batten_status bat_folds_possible(const batten_surface *surface, bat_span_ranges *out)
{
    const bat_span_range all = {{0, 0},
                                {batten_surface_spans(surface, BATTEN_U, NULL) - 1,
                                 batten_surface_spans(surface, BATTEN_V, NULL) - 1}};
    net n = {.open = {NULL, 0, 0}};
    batten_status status = BATTEN_OK;
    if (surface->kind != &bat_nurbs_kind || !weights_are_products(surface)) {
        status = BAT_LIST_ADD(n.open.at, n.open.count, n.open.room, all);
    } else {
        n.points = batten_surface_points(surface);
        n.dimension = batten_surface_dimension(surface);
        n.count_v = batten_surface_point_count(surface, BATTEN_V);
        for (int k = 0; k < 2; k++) {
            n.count[k] = all.end[k];
            n.degree[k] = batten_surface_degree(surface, (batten_direction)k);
            n.spans[k] = list_spans(surface, (batten_direction)k);
        }
        status = n.spans[0] && n.spans[1] ? prove_block(&n, all) : BATTEN_OUT_OF_MEMORY;
    }
    bat_release(n.spans[0]);
    bat_release(n.spans[1]);
    if (status == BATTEN_OK)
        *out = n.open;
    else
        bat_release(n.open.at);
    return status;
}
