/* Where in a triangulation a point lies. */
#include "spline/triangles.h"
#include "spline/triangulate.h"

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
    return walk->convex ? -1 : scan(walk, point, at);
}

int batten_plane_triangles_find(const batten_plane_triangles *triangles, int start,
                                const double point[2], double at[3])
{
    assert(triangles && point && at);
    const bat_walk walk = {triangles->count, triangles->vertices, triangles->corners,
                           triangles->beside, triangles->slivers == 0};
    return bat_walk_find(&walk, start, point, at);
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

/* The next edge of the rim: round the corner at its end from triangle to triangle. False where
 * that leads in circles. */
static bool next_on_rim(const int *corners, const int *beside, int count, int *t, int *e)
{
    const int turn = corners[3 * *t + (*e + 2) % 3];
    for (int step = 0; step < count; step++) {
        int k = 0;
        while (k < 2 && corners[3 * *t + k] != turn)
            k++;
        *e = (k + 2) % 3; /* the edge that leaves the corner */
        if (beside[3 * *t + *e] < 0)
            return true;
        *t = beside[3 * *t + *e];
    }
    return false;
}

bool bat_walk_is_convex(const double *vertices, int count, const int *corners,
                        const int *beside)
{
    for (int i = 0; i < 3 * count; i++) {
        if (beside[i] >= 0)
            continue;
        int t = i / 3, e = i % 3;
        const double *a = vertices + 2 * (size_t)corners[3 * t + (e + 1) % 3];
        const double *b = vertices + 2 * (size_t)corners[3 * t + (e + 2) % 3];
        if (!next_on_rim(corners, beside, count, &t, &e))
            return false;
        const double *c = vertices + 2 * (size_t)corners[3 * t + (e + 2) % 3];
        const double x = b[0] - a[0], y = b[1] - a[1], p = c[0] - b[0], q = c[1] - b[1];
        if (x * q - y * p < -1e-12 * hypot(x, y) * hypot(p, q))
            return false;
    }
    return true;
}
