/* The same triangles in another form: elevated, cut, selected. */
#include "base/plural.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/triangles/triangles.h"

#include <string.h>

/* ---- degree ---- */

/* In place, from degree n to n + 1; from the last row on, for it only reads what is before. */
static void elevate(int n, size_t width, double *net)
{
    for (int row = n + 1; row >= 0; row--)
        for (int k = row; k >= 0; k--) {
            const int index[3] = {n + 1 - row, row - k, k};
            const int from[3] = {BATTEN_TRIANGLE_POINT(row - k, k),
                                 BATTEN_TRIANGLE_POINT(row - k - 1, k),
                                 BATTEN_TRIANGLE_POINT(row - k, k - 1)};
            double sum[BAT_MAX_WIDTH] = {0};
            for (int e = 0; e < 3; e++)
                for (size_t c = 0; index[e] > 0 && c < width; c++)
                    sum[c] += index[e] * net[(size_t)from[e] * width + c];
            double *to = net + (size_t)BATTEN_TRIANGLE_POINT(row - k, k) * width;
            for (size_t c = 0; c < width; c++)
                to[c] = sum[c] / (n + 1);
        }
}

batten_status batten_triangles_elevate(const batten_triangles *triangles, int by,
                                       batten_triangles **out)
{
    assert(triangles && out);
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    if (by < 0 || by > BATTEN_MAX_DEGREE - shape.degree)
        return bat_fail(BATTEN_BAD_DEGREE,
                        "degree %d cannot be raised by %d; the highest degree is %d",
                        shape.degree, by, BATTEN_MAX_DEGREE);
    shape.degree += by;
    if ((long long)shape.count * BATTEN_TRIANGLE_POINTS(shape.degree) > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d triangles of degree %d have more than %d control points",
                        shape.count, shape.degree, BAT_MAX_POINTS);
    batten_triangles *made = NULL;
    const batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    double *net = bat_array(made->net_count * made->width, sizeof *net);
    if (!net) {
        bat_triangles_free(made);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int t = 0; t < shape.count; t++) {
        memcpy(net, bat_triangle_net(triangles, t),
               triangles->net_count * triangles->width * sizeof *net);
        for (int n = triangles->degree; n < shape.degree; n++)
            elevate(n, made->width, net);
        bat_triangle_set(made, t, triangles->weight_scale, net);
    }
    bat_release(net);
    bat_triangles_copy_domain(triangles, made);
    return bat_triangles_finish(made, out);
}

/* ---- cutting ---- */

void bat_triangle_sub(int degree, size_t width, const double *net, double corners[3][3],
                      double *work, double *out)
{
    const int n = degree;
    const size_t size = (size_t)BATTEN_TRIANGLE_POINTS(n) * width;
    double *for_k = work, *for_j = work + size, *rest = work + 2 * size;
    memcpy(for_k, net, size * sizeof *net);
    for (int k = 0; k <= n; k++) {
        if (k > 0)
            bat_triangle_step(n - k + 1, width, corners[2], for_k);
        memcpy(for_j, for_k, size * sizeof *net);
        for (int j = 0; j <= n - k; j++) {
            if (j > 0)
                bat_triangle_step(n - k - j + 1, width, corners[1], for_j);
            memcpy(rest, for_j, size * sizeof *net);
            for (int level = n - k - j; level > 0; level--)
                bat_triangle_step(level, width, corners[0], rest);
            memcpy(out + (size_t)BATTEN_TRIANGLE_POINT(j, k) * width, rest,
                   width * sizeof *net);
        }
    }
}

/* Fill triangle `place` of `made` with the part of a triangle that has these corners. */
static void set_part(const batten_triangles *triangles, int triangle, double corners[3][3],
                     double *work, batten_triangles *made, int place)
{
    const size_t size = triangles->net_count * triangles->width;
    bat_triangle_sub(triangles->degree, triangles->width, bat_triangle_net(triangles, triangle),
                     corners, work + size, work);
    bat_triangle_set(made, place, triangles->weight_scale, work);
}

static double *part_work(const batten_triangles *triangles)
{
    return bat_array(4 * triangles->net_count * triangles->width, sizeof(double));
}

/* The domain with one more vertex, at `at` in the triangle that is cut. */
static void split_domain(const batten_triangles *triangles, int triangle, const double at[3],
                         batten_triangles *made)
{
    const int middle = triangles->vertex_count, count = triangles->count;
    const int *old = triangles->corners + 3 * triangle;
    bat_triangles_copy_domain(triangles, made);
    for (int c = 0; c < 2; c++)
        made->vertices[2 * middle + c] = at[0] * triangles->vertices[2 * old[0] + c] +
                                         at[1] * triangles->vertices[2 * old[1] + c] +
                                         at[2] * triangles->vertices[2 * old[2] + c];
    const int places[3] = {triangle, count, count + 1};
    for (int e = 0; e < 3; e++)
        for (int c = 0; c < 3; c++)
            made->corners[3 * places[e] + c] =
                c == e ? middle : triangles->corners[3 * triangle + c];
}

batten_status batten_triangles_split(const batten_triangles *triangles, int triangle,
                                     const double at[3], batten_triangles **out)
{
    assert(triangles && at && out && triangle >= 0 && triangle < triangles->count);
    if (!(at[0] > 0 && at[1] > 0 && at[2] > 0) || !(fabs(at[0] + at[1] + at[2] - 1) <= 1e-9))
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a triangle is cut at an inner point; (%g, %g, %g) is none", at[0],
                        at[1], at[2]);
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    shape.count += 2;
    shape.vertex_count += shape.vertex_count > 0;
    batten_triangles *made = NULL;
    batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    double *work = part_work(triangles);
    if (!work) {
        bat_triangles_free(made);
        return BATTEN_OUT_OF_MEMORY;
    }
    for (int t = 0; t < triangles->count; t++)
        bat_triangle_set(made, t, triangles->weight_scale, bat_triangle_net(triangles, t));
    const int places[3] = {triangle, triangles->count, triangles->count + 1};
    for (int e = 0; e < 3; e++) {
        double corners[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        memcpy(corners[e], at, 3 * sizeof *at);
        set_part(triangles, triangle, corners, work, made, places[e]);
    }
    bat_release(work);
    if (shape.vertex_count)
        split_domain(triangles, triangle, at, made);
    return bat_triangles_finish(made, out);
}

/* Sides that are one edge have one middle; how many there are. */
static int number_middles(const batten_triangles *triangles, const bat_triangle_edge *edges,
                          int *middles)
{
    int found = 0;
    for (int i = 0; i < 3 * triangles->count; i++) {
        if (i > 0 && (edges[i].low != edges[i - 1].low || edges[i].high != edges[i - 1].high))
            found++;
        middles[3 * edges[i].triangle + edges[i].edge] = triangles->vertex_count + found;
    }
    return found + 1;
}

/* The middle of each edge as a vertex: middles [count][3], one for edges that are shared; how
 * many there are is returned. */
static batten_status find_middles(const batten_triangles *triangles, int *middles, int *count)
{
    bat_triangle_edge *edges = NULL;
    const batten_status status =
        bat_triangle_edges(triangles->count, triangles->corners, &edges);
    if (status != BATTEN_OK)
        return status;
    *count = number_middles(triangles, edges, middles);
    bat_release(edges);
    return BATTEN_OK;
}

static void halve_domain(const batten_triangles *triangles, const int *middles,
                         batten_triangles *made)
{
    memcpy(made->vertices, triangles->vertices,
           2 * (size_t)triangles->vertex_count * sizeof *made->vertices);
    for (int t = 0; t < triangles->count; t++) {
        const int *old = triangles->corners + 3 * t, *middle = middles + 3 * t;
        for (int e = 0; e < 3; e++) {
            const double *a = triangles->vertices + 2 * old[(e + 1) % 3];
            const double *b = triangles->vertices + 2 * old[(e + 2) % 3];
            for (int c = 0; c < 2; c++)
                made->vertices[2 * middle[e] + c] = a[c] / 2 + b[c] / 2;
            for (int c = 0; c < 3; c++)
                made->corners[3 * (4 * t + e) + c] = c == e ? old[e] : middle[3 - c - e];
            made->corners[3 * (4 * t + 3) + e] = middle[e];
        }
    }
}

static void halve_net(const batten_triangles *triangles, int t, double *work,
                      batten_triangles *made)
{
    double middle[3][3] = {{0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}};
    for (int e = 0; e < 3; e++) {
        double corners[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int c = 0; c < 3; c++)
            if (c != e)
                memcpy(corners[c], middle[3 - c - e], sizeof middle[0]);
        set_part(triangles, t, corners, work, made, 4 * t + e);
    }
    set_part(triangles, t, middle, work, made, 4 * t + 3);
}

/* The parts at corners 0, 1, 2 and the inner one. Part e: corner e stays, corner c becomes the
 * middle of the edge from e to c, which is opposite 3 - c - e. */
static void halve_nets(const batten_triangles *triangles, double *work, batten_triangles *made)
{
    for (int t = 0; t < triangles->count; t++)
        halve_net(triangles, t, work, made);
}

batten_status batten_triangles_halve(const batten_triangles *triangles, batten_triangles **out)
{
    assert(triangles && out);
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    if (4LL * shape.count * (long long)triangles->net_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "four times %d triangles of degree %d have more than %d control points",
                        shape.count, shape.degree, BAT_MAX_POINTS);
    shape.count *= 4;
    int middle_count = 0;
    int *middles = bat_array(3 * (size_t)triangles->count, sizeof *middles);
    double *work = part_work(triangles);
    batten_triangles *made = NULL;
    batten_status status = middles && work ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && shape.vertex_count)
        status = find_middles(triangles, middles, &middle_count);
    shape.vertex_count += middle_count;
    if (status == BATTEN_OK)
        status = bat_triangles_make(&shape, &made);
    if (status == BATTEN_OK) {
        halve_nets(triangles, work, made);
        if (shape.vertex_count)
            halve_domain(triangles, middles, made);
        status = bat_triangles_finish(made, out);
    }
    bat_release(middles);
    bat_release(work);
    return status;
}

/* ---- some of them, and the graph ---- */

batten_status batten_triangles_select(const batten_triangles *triangles, int count,
                                      const int *which, batten_triangles **out)
{
    assert(triangles && which && out);
    if (count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "%d triangle%s %s selected; at least 1 must be",
                        count, bat_plural(count), bat_one_or_many(count, "is", "are"));
    for (int i = 0; i < count; i++)
        if (which[i] < 0 || which[i] >= triangles->count)
            return bat_fail(BATTEN_OUT_OF_DOMAIN, "triangle %d does not exist; there are %d",
                            which[i] + 1, triangles->count);
    if ((long long)count * (long long)triangles->net_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d triangles of degree %d have more than %d control points", count,
                        triangles->degree, BAT_MAX_POINTS);
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    shape.count = count;
    batten_triangles *made = NULL;
    const batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    if (shape.vertex_count)
        memcpy(made->vertices, triangles->vertices,
               2 * (size_t)shape.vertex_count * sizeof *made->vertices);
    for (int i = 0; i < count; i++) {
        bat_triangle_set(made, i, triangles->weight_scale,
                         bat_triangle_net(triangles, which[i]));
        for (int e = 0; shape.vertex_count && e < 3; e++)
            made->corners[3 * i + e] = triangles->corners[3 * which[i] + e];
    }
    return bat_triangles_finish(made, out);
}

/* Points and weights of one set as the triangles from `at` on of another. */
static void copy_nets(const batten_triangles *from, batten_triangles *to, int at)
{
    const size_t total = (size_t)from->count * from->net_count;
    const size_t first = (size_t)at * from->net_count, d = (size_t)from->dimension;
    memcpy(to->points + first * d, from->points, total * d * sizeof *to->points);
    for (size_t i = 0; to->weights && i < total; i++)
        to->weights[first + i] = from->weights ? from->weights[i] : 1;
}

batten_status batten_triangles_together(const batten_triangles *first,
                                        const batten_triangles *second, batten_triangles **out)
{
    assert(first && second && out);
    const int degree = bat_max_int(first->degree, second->degree);
    const long long count = (long long)first->count + second->count;
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "triangles of dimensions %d and %d",
                        first->dimension, second->dimension);
    if (count * BATTEN_TRIANGLE_POINTS(degree) > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%lld triangles of degree %d have more than %d control points", count,
                        degree, BAT_MAX_POINTS);
    const bat_triangles_shape shape = {first->dimension, degree, (int)count,
                                       first->weights || second->weights, 0};
    batten_triangles *a = NULL, *b = NULL, *made = NULL;
    batten_status status = batten_triangles_elevate(first, degree - first->degree, &a);
    if (status == BATTEN_OK)
        status = batten_triangles_elevate(second, degree - second->degree, &b);
    if (status == BATTEN_OK)
        status = bat_triangles_make(&shape, &made);
    if (status == BATTEN_OK) {
        copy_nets(a, made, 0);
        copy_nets(b, made, first->count);
        status = bat_triangles_finish(made, out);
    }
    batten_triangles_unref(a);
    batten_triangles_unref(b);
    return status;
}

batten_status batten_triangles_from_function(const batten_triangles *triangles,
                                             batten_triangles **out)
{
    assert(triangles && out);
    if (triangles->dimension != 1 || triangles->weights || !triangles->vertex_count)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a graph is that of polynomial triangles of dimension 1 over a domain");
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    shape.dimension = 3;
    batten_triangles *made = NULL;
    const batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    const int n = triangles->degree;
    double *to = made->points;
    const double *value = triangles->points;
    for (int t = 0; t < triangles->count; t++) {
        const int *corners = triangles->corners + 3 * t;
        for (int row = 0; row <= n; row++)
            for (int k = 0; k <= row; k++) {
                for (int c = 0; c < 2; c++)
                    *to++ = ((n - row) * triangles->vertices[2 * corners[0] + c] +
                             (row - k) * triangles->vertices[2 * corners[1] + c] +
                             k * triangles->vertices[2 * corners[2] + c]) /
                            n;
                *to++ = *value++;
            }
    }
    bat_triangles_copy_domain(triangles, made);
    return bat_triangles_finish(made, out);
}
