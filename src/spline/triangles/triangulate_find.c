/* Where in a triangulation a point lies. */
#include "spline/triangles/triangles.h"
#include "spline/triangles/triangulate.h"

/* Rounding of barycentric coordinates: a point so little outside counts as inside. */
static const double rounding = 1e-12;

static bool is_inside(const bat_walk *walk, int t, const double point[2], double at[3])
{
    bat_triangle_barycentric(walk->vertices, walk->corners + 3 * t, point, at);
    return at[0] >= -rounding && at[1] >= -rounding && at[2] >= -rounding;
}

static int scan(const bat_walk *walk, const double point[2], double at[3])
{
    for (int t = 0; t < walk->count; t++)
        if (is_inside(walk, t, point, at))
            return t;
    return -1;
}

/* Does a ray from the point cross the rim an odd number of times? */
static bool is_within_rim(const bat_walk *walk, const double p[2])
{
    bool within = false;
    for (int i = 0; i < walk->rim_count; i++) {
        const int t = walk->rim[i] / 3, e = walk->rim[i] % 3;
        const double *a = walk->vertices + 2 * (size_t)walk->corners[3 * t + (e + 1) % 3];
        const double *b = walk->vertices + 2 * (size_t)walk->corners[3 * t + (e + 2) % 3];
        const double x = a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
        if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < x)
            within = !within;
    }
    return within;
}

int bat_walk_find(const bat_walk *walk, int start, const double point[2], double at[3])
{
    assert(start >= 0 && start < walk->count);
    if (!isfinite(point[0]) || !isfinite(point[1]))
        return -1;
    int t = start;
    for (int step = 0; step < walk->count; step++) {
        if (is_inside(walk, t, point, at))
            return t;
        int across = -1;
        double least = -rounding;
        for (int e = 0; e < 3; e++)
            if (at[e] < least && walk->beside[3 * t + e] >= 0) {
                least = at[e];
                across = walk->beside[3 * t + e];
            }
        if (across < 0)
            break;
        t = across;
        if (step == walk->count - 1)
            return scan(walk, point, at); /* in circles, as triangles of other kinds allow */
    }
    if (walk->convex || (walk->rim && !is_within_rim(walk, point)))
        return -1;
    return scan(walk, point, at);
}

int batten_plane_triangles_find(const batten_plane_triangles *triangles, int start,
                                batten_vec2 point, double at[3])
{
    const double point_xy[2] = {point.x, point.y};
    assert(triangles && at);
    const bat_walk walk = {triangles->count,
                           triangles->vertices,
                           triangles->corners,
                           triangles->beside,
                           triangles->slivers == 0,
                           NULL,
                           0};
    return bat_walk_find(&walk, start, point_xy, at);
}

/* ---- triangles from elsewhere ---- */

batten_status bat_triangle_neighbours(int count, const int *corners, int **out)
{
    bat_triangle_edge *edges = NULL;
    int *beside = bat_array3((size_t)count, 3, sizeof *beside);
    batten_status status =
        beside ? bat_triangle_edges(count, corners, &edges) : BATTEN_OUT_OF_MEMORY;
    if (status != BATTEN_OK) {
        bat_release(beside);
        return status;
    }
    for (int i = 0; i < 3 * count; i++)
        beside[i] = -1;
    for (int i = 0; i + 1 < 3 * count; i++) {
        const bat_triangle_edge *a = edges + i, *b = a + 1;
        if (a->low != b->low || a->high != b->high)
            continue;
        beside[3 * a->triangle + a->edge] = b->triangle;
        beside[3 * b->triangle + b->edge] = a->triangle;
    }
    bat_release(edges);
    *out = beside;
    return BATTEN_OK;
}
