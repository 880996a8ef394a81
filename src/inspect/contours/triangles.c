/* Contours on sets of Bezier triangles. */
#include "base/plural.h"
#include "inspect/contours/contours.h"

#include "numeric/vector.h"
#include <stdlib.h>
#include <string.h>

/* A corner of a triangle, to be found again in its neighbours. */
typedef struct {
    double point[3];
    double along; /* a direction in which no grid has two corners together */
    size_t at;    /* 3 * triangle + corner */
} corner;

static int in_order(const void *a, const void *b)
{
    const corner *s = a, *t = b;
    if (s->along != t->along)
        return s->along < t->along ? -1 : 1;
    return s->at < t->at ? -1 : 1;
}

/* The same node for corners within `near` of each other; their count. */
static int number_nodes(size_t count, const corner *corners, double near, int *nodes)
{
    int made = 0;
    for (size_t i = 0; i < count; i++)
        nodes[corners[i].at] = -1;
    for (size_t i = 0; i < count; i++) {
        int *node = &nodes[corners[i].at];
        for (size_t j = i; *node < 0 && j-- > 0;) {
            if (corners[i].along - corners[j].along > near)
                break;
            if (bat_distance(3, corners[i].point, corners[j].point) <= near)
                *node = nodes[corners[j].at];
        }
        if (*node < 0)
            *node = made++;
    }
    return made;
}

static batten_status evaluate(const void *shape, int piece, const double uv[2], int order,
                              double *out)
{
    const double u = bat_max(0, bat_min(1, uv[0])), v = bat_max(0, bat_min(1 - u, uv[1]));
    return batten_triangles_evaluate(shape, piece, (const double[3]){1 - u - v, u, v}, order,
                                     out);
}

static batten_status find_corners(const batten_triangles *triangles, corner *corners,
                                  double *uv)
{
    static const double places[3][2] = {{0, 0}, {1, 0}, {0, 1}};
    static const double direction[3] = {0.6172134, 0.5439871, 0.5685213}; /* a unit vector */
    const size_t count = (size_t)batten_triangles_count(triangles);
    for (size_t i = 0; i < 3 * count; i++) {
        corners[i].at = i;
        memcpy(uv + 2 * i, places[i % 3], sizeof places[0]);
        const batten_status status =
            evaluate(triangles, (int)(i / 3), places[i % 3], 0, corners[i].point);
        if (status != BATTEN_OK)
            return status;
        corners[i].along = bat_dot(3, direction, corners[i].point);
    }
    qsort(corners, 3 * count, sizeof *corners, in_order);
    return BATTEN_OK;
}

/* ---- edges ---- */

enum { EDGE_PROBES = 3 };

/* Points inside an edge of a triangle, from its corner of the smaller node on. */
static batten_status probe_edge(const batten_triangles *triangles, size_t edge,
                                const double *uv, const int *nodes,
                                double points[EDGE_PROBES][3])
{
    const size_t first = edge / 3 * 3, next = first + (edge + 1) % 3;
    const size_t from = nodes[edge] < nodes[next] ? edge : next,
                 to = from == edge ? next : edge;
    for (int i = 0; i < EDGE_PROBES; i++) {
        const double at = (i + 1.0) / (EDGE_PROBES + 1);
        const double place[2] = {uv[2 * from] + at * (uv[2 * to] - uv[2 * from]),
                                 uv[2 * from + 1] + at * (uv[2 * to + 1] - uv[2 * from + 1])};
        const batten_status status = evaluate(triangles, (int)(edge / 3), place, 0, points[i]);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

/* Is an edge the same curve as the first edge between its two nodes? */
static batten_status edge_agrees(const batten_triangles *triangles, size_t edge,
                                 const double *uv, const int *nodes, double near,
                                 bat_pair_values *edges, bool *out)
{
    const int a = nodes[edge], b = nodes[edge / 3 * 3 + (edge + 1) % 3];
    *out = a != b;
    if (a == b)
        return BATTEN_OK;
    const int *known =
        bat_pair_values_at(edges, bat_min_int(a, b), bat_max_int(a, b), (int)edge);
    if (!known)
        return BATTEN_OUT_OF_MEMORY;
    double here[EDGE_PROBES][3], there[EDGE_PROBES][3];
    if (*known == (int)edge)
        return BATTEN_OK;
    batten_status status = probe_edge(triangles, edge, uv, nodes, here);
    if (status == BATTEN_OK)
        status = probe_edge(triangles, (size_t)*known, uv, nodes, there);
    for (int i = 0; i < EDGE_PROBES && status == BATTEN_OK; i++)
        *out = *out && bat_distance(3, here[i], there[i]) <= near;
    return status;
}

/* In a net an edge is a pair of nodes. Where that says too little, a triangle gets nodes of its
 * own: two of its corners are one point, as at a pole or where an edge closes, or one of its
 * edges is another curve between the same two points, as on a tube of two pieces. Lines are
 * joined there by their ends, as at the seams of a surface. */
static batten_status separate_nodes(const batten_triangles *triangles, const double *uv,
                                    double near, int *nodes, int *node_count)
{
    const size_t count = (size_t)batten_triangles_count(triangles);
    bat_pair_values edges = {0};
    bool *apart = bat_array(count, sizeof *apart);
    batten_status status = apart ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = 0; i < 3 * count && status == BATTEN_OK; i++) {
        bool agrees = true;
        status = edge_agrees(triangles, i, uv, nodes, near, &edges, &agrees);
        apart[i / 3] = apart[i / 3] || !agrees;
    }
    for (size_t i = 0; i < 3 * count && status == BATTEN_OK; i++)
        if (apart[i / 3])
            nodes[i] = (*node_count)++;
    bat_release(apart);
    bat_pair_values_free(&edges);
    return status;
}

static batten_status triangles_contours(const batten_triangles *triangles,
                                        const batten_surface_field *field, int level_count,
                                        const double *levels, double tolerance, bool smooth,
                                        const batten_job *job, batten_contours *out)
{
    const size_t count = (size_t)batten_triangles_count(triangles);
    if (batten_triangles_dimension(triangles) != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "triangles in %d dimension%s have no fields: they must be in space",
                        batten_triangles_dimension(triangles),
                        bat_plural(batten_triangles_dimension(triangles)));
    const batten_box box = batten_triangles_box(triangles);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    corner *corners = bat_array3(count, 3, sizeof *corners);
    double *uv = bat_array3(count, 6, sizeof *uv);
    int *nodes = bat_array3(count, 3, sizeof *nodes);
    batten_status status = corners && uv && nodes ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = find_corners(triangles, corners, uv);
    if (status == BATTEN_OK) {
        /* Corners of neighbours are the same point up to rounding. */
        const double near = 1e-9 * size;
        int node_count = number_nodes(3 * count, corners, near, nodes);
        status = separate_nodes(triangles, uv, near, nodes, &node_count);
        const bat_pieces pieces = {.shape = triangles,
                                   .evaluate = evaluate,
                                   .piece_count = (int)count,
                                   .corner_count = 3,
                                   .nodes = nodes,
                                   .uv = uv,
                                   .node_count = node_count,
                                   .size = size};
        if (status == BATTEN_OK)
            status =
                bat_contours(&pieces, field, level_count, levels, tolerance, smooth, job, out);
    }
    bat_release(nodes);
    bat_release(uv);
    bat_release(corners);
    return status;
}

batten_status batten_triangles_contours(const batten_triangles *triangles,
                                        const batten_surface_field *field, batten_levels levels,
                                        double tolerance, const batten_job *job,
                                        batten_contours *out)
{
    return triangles_contours(triangles, field, levels.count, levels.at, tolerance, false, job,
                              out);
}

batten_status batten_triangles_smooth_contours(const batten_triangles *triangles,
                                               const batten_surface_field *field,
                                               batten_levels levels, double tolerance,
                                               const batten_job *job, batten_contours *out)
{
    return triangles_contours(triangles, field, levels.count, levels.at, tolerance, true, job,
                              out);
}
