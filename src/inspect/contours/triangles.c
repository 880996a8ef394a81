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
        const int node_count = number_nodes(3 * count, corners, 1e-9 * size, nodes);
        const bat_pieces pieces = {.shape = triangles,
                                   .evaluate = evaluate,
                                   .piece_count = (int)count,
                                   .corner_count = 3,
                                   .nodes = nodes,
                                   .uv = uv,
                                   .node_count = node_count,
                                   .size = size};
        status = bat_contours(&pieces, field, level_count, levels, tolerance, smooth, job, out);
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
