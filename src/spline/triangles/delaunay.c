/*
 * The triangulation of Delaunay by merging neighbours, from pairs of points up: always
 * O(n log n), whatever the points.
 *
 * Source: [GS85]; names as there, but only the edges of the triangulation are kept, not their
 * duals.
 */
#include "spline/triangles/delaunay.h"

#include "base/work.h"
#include "numeric/plane_signs.h"

#include <stdlib.h>

/* ---- edges ---- */

static const double *point_of(const bat_delaunay *edges, int vertex)
{
    return edges->points + 2 * (size_t)vertex;
}

static const double *origin_of(const bat_delaunay *edges, int e)
{
    return point_of(edges, edges->origin[e]);
}

static const double *end_of(const bat_delaunay *edges, int e)
{
    return point_of(edges, edges->origin[e ^ 1]);
}

/* Join two rings, or cut one in two. */
static void splice(bat_delaunay *edges, int a, int b)
{
    const int after_a = edges->next[a], after_b = edges->next[b];
    edges->next[a] = after_b;
    edges->previous[after_b] = a;
    edges->next[b] = after_a;
    edges->previous[after_a] = b;
}

static int make_edge(bat_delaunay *edges, int from, int to)
{
    int e = edges->free;
    if (e >= 0) {
        edges->free = edges->next[e];
    } else {
        e = edges->used;
        edges->used += 2;
    }
    edges->origin[e] = from;
    edges->origin[e + 1] = to;
    edges->next[e] = edges->previous[e] = e;
    edges->next[e + 1] = edges->previous[e + 1] = e + 1;
    return e;
}

/* From the end of a to the origin of b, where both bound one face on their left. */
static int connect(bat_delaunay *edges, int a, int b)
{
    const int e = make_edge(edges, bat_delaunay_end(edges, a), edges->origin[b]);
    splice(edges, e, bat_delaunay_left(edges, a));
    splice(edges, e ^ 1, b);
    return e;
}

static void delete_edge(bat_delaunay *edges, int e)
{
    e &= ~1;
    splice(edges, e, edges->previous[e]);
    splice(edges, e + 1, edges->previous[e + 1]);
    edges->origin[e] = edges->origin[e + 1] = -1;
    edges->next[e] = edges->free;
    edges->free = e;
}

/* ---- merging ---- */

static bool is_left(const bat_delaunay *edges, const double *p, int e)
{
    return bat_orientation(p, origin_of(edges, e), end_of(edges, e)) > 0;
}

static bool is_right(const bat_delaunay *edges, const double *p, int e)
{
    return bat_orientation(p, end_of(edges, e), origin_of(edges, e)) > 0;
}

static bool is_in_circle(const bat_delaunay *edges, const double *a, const double *b, int c,
                         int d)
{
    return bat_in_circle(a, b, end_of(edges, c), end_of(edges, d)) > 0;
}

/* A triangulation of some points, sorted from left to right: the edges of its hull that leave
 * the first point counterclockwise and the last one clockwise. */
typedef struct {
    int first, last;
} part;

/* The lowest edge between two parts, from the right to the left. */
static int lowest_edge(bat_delaunay *edges, int *left, int *right)
{
    for (;;) {
        if (is_left(edges, origin_of(edges, *right), *left))
            *left = bat_delaunay_left(edges, *left);
        else if (is_right(edges, origin_of(edges, *left), *right))
            *right = edges->next[*right ^ 1];
        else
            return connect(edges, *right ^ 1, *left);
    }
}

/* The edge of the left part on which the next triangle may stand; edges that are in the way go.
 */
static int left_candidate(bat_delaunay *edges, int base)
{
    int e = edges->next[base ^ 1];
    while (
        is_right(edges, end_of(edges, e), base) &&
        is_in_circle(edges, end_of(edges, base), origin_of(edges, base), e, edges->next[e])) {
        const int after = edges->next[e];
        delete_edge(edges, e);
        e = after;
    }
    return e;
}

static int right_candidate(bat_delaunay *edges, int base)
{
    int e = edges->previous[base];
    while (is_right(edges, end_of(edges, e), base) &&
           is_in_circle(edges, end_of(edges, base), origin_of(edges, base), e,
                        edges->previous[e])) {
        const int after = edges->previous[e];
        delete_edge(edges, e);
        e = after;
    }
    return e;
}

static part merge(bat_delaunay *edges, part a, part b)
{
    int left = a.last, right = b.first;
    int base = lowest_edge(edges, &left, &right);
    part both = {a.first, b.last};
    if (edges->origin[left] == edges->origin[a.first])
        both.first = base ^ 1;
    if (edges->origin[right] == edges->origin[b.last])
        both.last = base;
    for (;;) {
        const int l = left_candidate(edges, base), r = right_candidate(edges, base);
        const bool has_left = is_right(edges, end_of(edges, l), base);
        const bool has_right = is_right(edges, end_of(edges, r), base);
        if (!has_left && !has_right)
            return both;
        if (!has_left ||
            (has_right && bat_in_circle(end_of(edges, l), origin_of(edges, l),
                                        origin_of(edges, r), end_of(edges, r)) > 0))
            base = connect(edges, r, base ^ 1);
        else
            base = connect(edges, base ^ 1, l ^ 1);
    }
}

/* ---- the smallest parts ---- */

static part part_of_two(bat_delaunay *edges, int first)
{
    const int e = make_edge(edges, first, first + 1);
    return (part){e, e ^ 1};
}

static part part_of_three(bat_delaunay *edges, int first)
{
    const int a = make_edge(edges, first, first + 1);
    const int b = make_edge(edges, first + 1, first + 2);
    splice(edges, a ^ 1, b);
    const double *p = point_of(edges, first);
    const int side = bat_orientation(p, p + 2, p + 4);
    if (side == 0)
        return (part){a, b ^ 1};
    const int c = connect(edges, b, a);
    return side > 0 ? (part){a, b ^ 1} : (part){c ^ 1, c};
}

/* ---- all together ---- */

typedef struct {
    double x, y;
    int point;
} place;

static int compare_places(const void *a, const void *b)
{
    const place *first = a, *second = b;
    if (first->x != second->x)
        return first->x < second->x ? -1 : 1;
    return (first->y > second->y) - (first->y < second->y);
}

static void take_apart(int count, const place *places, double *points, int *order)
{
    for (int i = 0; i < count; i++) {
        points[2 * (size_t)i] = places[i].x;
        points[2 * (size_t)i + 1] = places[i].y;
        order[i] = places[i].point;
    }
}

/* The points from left to right, side by side in memory, and which they are. */
static batten_status sort(int count, const double *points, double *sorted, int *order)
{
    place *places = bat_array((size_t)count, sizeof *places);
    if (!places)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        places[i] = (place){points[2 * (size_t)i], points[2 * (size_t)i + 1], i};
    qsort(places, (size_t)count, sizeof *places, compare_places);
    take_apart(count, places, sorted, order);
    bat_release(places);
    return BATTEN_OK;
}

/* So few merges between two questions, for the largest parts take long. */
enum { MERGES_A_STEP = 64 };

/* The first half of [*count] parts becomes all of them. */
static batten_status merge_neighbours(bat_delaunay *edges, bat_work *work, double fraction,
                                      int *count, part *parts)
{
    batten_status status = BATTEN_OK;
    for (int i = 0; i < *count / 2 && status == BATTEN_OK; i++) {
        if (i % MERGES_A_STEP == 0)
            status = bat_work_step(work, MERGES_A_STEP, fraction, "triangles");
        parts[i] = merge(edges, parts[2 * i], parts[2 * i + 1]);
    }
    if (*count % 2)
        parts[*count / 2] = parts[*count - 1];
    *count = (*count + 1) / 2;
    return status;
}

static batten_status merge_all(bat_delaunay *edges, int count, const batten_job *job,
                               part *parts)
{
    bat_work work = {job, 0};
    batten_status status = BATTEN_OK;
    int left = count / 2; /* the last takes three points when their number is odd */
    for (int i = 0; i < left; i++)
        parts[i] = i == left - 1 && count % 2 ? part_of_three(edges, 2 * i)
                                              : part_of_two(edges, 2 * i);
    const double levels = bat_max(1, ilogb(left) + 1);
    for (int level = 0; left > 1 && status == BATTEN_OK; level++)
        status = merge_neighbours(edges, &work, level / levels, &left, parts);
    return status;
}

/* Origins as the caller counts points. */
static void rename_points(bat_delaunay *edges, const double *points, const int *order)
{
    for (int e = 0; e < edges->used; e++)
        if (edges->origin[e] >= 0)
            edges->origin[e] = order[edges->origin[e]];
    edges->points = points;
}

batten_status bat_delaunay_make(int count, const double *points, const batten_job *job,
                                bat_delaunay *out)
{
    const size_t n = (size_t)count; /* planar: at most 3 n - 3 edges at any time */
    double *sorted = bat_array(n, 2 * sizeof *sorted);
    bat_delaunay edges = {.points = sorted, .free = -1};
    edges.origin = bat_array3(n, 6, sizeof(int));
    edges.next = bat_array3(n, 6, sizeof(int));
    edges.previous = bat_array3(n, 6, sizeof(int));
    int *order = bat_array(n, sizeof *order);
    part *parts = bat_array(n / 2 + 1, sizeof *parts);
    batten_status status = BATTEN_OUT_OF_MEMORY;
    if (sorted && edges.origin && edges.next && edges.previous && order && parts)
        status = sort(count, points, sorted, order);
    if (status == BATTEN_OK)
        status = merge_all(&edges, count, job, parts);
    if (status == BATTEN_OK) {
        rename_points(&edges, points, order);
        *out = edges;
    } else {
        bat_delaunay_free(&edges);
    }
    bat_release(sorted);
    bat_release(order);
    bat_release(parts);
    return status;
}

void bat_delaunay_free(bat_delaunay *edges)
{
    bat_release(edges->origin);
    bat_release(edges->next);
    bat_release(edges->previous);
}
