/* Smooth elements over triangles: values and gradients at the corners become Bezier triangles.
 */
#include "base/plural.h"
#include "spline/curve/curve.h"
#include "spline/triangles/triangles.h"
#include <batten/scattered.h>

#include <string.h>

/* ---- what all have in common ---- */

/* The data, after they were looked at. */
typedef struct {
    const batten_triangulation *domain;
    int count;
    const double *f, *g; /* values, gradients */
} element_data;

static const double *vertex(const element_data *data, int v)
{
    return data->domain->vertices + 2 * (size_t)v;
}

static batten_status check_finite(const double *values, size_t count, size_t each,
                                  const char *what, const char *of)
{
    const size_t at = bat_first_not_finite(values, count * each);
    return at == count * each ? BATTEN_OK
                              : bat_fail(BATTEN_NOT_FINITE, "%s %zu of %s %zu is %g", what,
                                         at % each + 1, of, at / each + 1, values[at]);
}

batten_status batten_triangles_linear(const batten_triangulation *domain, int count,
                                      const double *values, batten_triangles **out)
{
    assert(domain && values && out);
    if (count < 1 || count > BAT_MAX_POINTS || domain->vertex_count < 3)
        return bat_fail(count > BAT_MAX_POINTS ? BATTEN_TOO_LARGE : BATTEN_TOO_FEW_POINTS,
                        "there %s %d triangle%s with %d %s",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count),
                        domain->vertex_count,
                        bat_one_or_many(domain->vertex_count, "vertex", "vertices"));
    batten_status status =
        check_finite(values, (size_t)domain->vertex_count, 1, "value", "vertex");
    if (status != BATTEN_OK)
        return status;
    double *points = bat_array3((size_t)count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 3 * count; i++) {
        const int v = domain->corners[i];
        points[i] = v >= 0 && v < domain->vertex_count ? values[v] : 0; /* refused below */
    }
    status = batten_triangles_create(
        &(batten_triangles_parts){1, 1, count, points, NULL, domain}, out);
    bat_release(points);
    return status;
}

/* Refuse what is no domain, and what is too large: `pieces` for each triangle. */
static batten_status check_sizes(const element_data *data, int pieces, int degree)
{
    const long long total =
        (long long)data->count * pieces * BATTEN_TRIANGLE_POINTS((long long)degree);
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d triangles would have %lld control points in %d pieces of degree %d "
                        "each; the limit is %d",
                        data->count, total, pieces, degree, (int)BAT_MAX_POINTS);
    batten_triangles *plain = NULL;
    batten_status status = batten_triangles_linear(data->domain, data->count, data->f, &plain);
    batten_triangles_unref(plain);
    if (status != BATTEN_OK)
        return status;
    return check_finite(data->g, (size_t)data->domain->vertex_count, 2, "component",
                        "the gradient at vertex");
}

static batten_status make_elements(const element_data *data, int degree, int pieces,
                                   int more_vertices, batten_triangles **out)
{
    const int vertex_count = data->domain->vertex_count;
    const bat_triangles_shape shape = {1, degree, data->count * pieces, false,
                                       vertex_count + more_vertices};
    batten_status status = bat_triangles_make(&shape, out);
    if (status == BATTEN_OK)
        memcpy((*out)->vertices, data->domain->vertices,
               2 * (size_t)vertex_count * sizeof(double));
    return status;
}

/* f + g . (p - v) part of the way from vertex v to p. */
static double ahead(const element_data *data, int v, const double *p, double part)
{
    const double *q = vertex(data, v), *g = data->g + 2 * (size_t)v;
    return data->f[v] + part * (g[0] * (p[0] - q[0]) + g[1] * (p[1] - q[1]));
}

static void set_corners(batten_triangles *made, int piece, int a, int b, int c)
{
    const int corners[3] = {a, b, c};
    memcpy(made->corners + 3 * piece, corners, sizeof corners);
}

/* ---- Clough and Tocher ---- */

/* The inner ordinate of the piece on the edge from i to j; letters of [Farin86]: z next to the
 * centre, and `middle` the gradient at the middle of the edge or NULL. */
static double edge_ordinate(const element_data *data, int i, int j, const double *centre,
                            const double *middle)
{
    const double *a = vertex(data, i), *b = vertex(data, j);
    const double ex = b[0] - a[0], ey = b[1] - a[1];
    const double cx = centre[0] - a[0], cy = centre[1] - a[1];
    const double along = (cx * ex + cy * ey) / (ex * ex + ey * ey);
    const double iij = ahead(data, i, b, 1.0 / 3), ijj = ahead(data, j, a, 1.0 / 3);
    const double zi = ahead(data, i, centre, 1.0 / 3), zj = ahead(data, j, centre, 1.0 / 3);
    const double mi = (zi - data->f[i]) - along * (iij - data->f[i]);
    const double mj = (zj - ijj) - along * (data->f[j] - ijj);
    const double foot = iij + along * (ijj - iij);
    if (!middle)
        return foot + (mi + mj) / 2;
    const double nx = cx - along * ex, ny = cy - along * ey;
    return foot + 2 * (middle[0] * nx + middle[1] * ny) / 3 - (mi + mj) / 2;
}

static void clough_tocher(const element_data *data, const double *middles, int t,
                          batten_triangles *made)
{
    const int *corner = data->domain->corners + 3 * t;
    double *centre = made->vertices + 2 * ((size_t)data->domain->vertex_count + (size_t)t);
    for (int k = 0; k < 2; k++) {
        const double first = vertex(data, corner[0])[k];
        centre[k] =
            first +
            ((vertex(data, corner[1])[k] - first) + (vertex(data, corner[2])[k] - first)) / 3;
    }
    double d[3], z[3], q[3];
    for (int e = 0; e < 3; e++) {
        z[e] = ahead(data, corner[e], centre, 1.0 / 3);
        d[e] = edge_ordinate(data, corner[(e + 1) % 3], corner[(e + 2) % 3], centre,
                             middles ? middles + 6 * (size_t)t + 2 * e : NULL);
    }
    for (int e = 0; e < 3; e++)
        q[e] = (z[e] + d[(e + 1) % 3] + d[(e + 2) % 3]) / 3;
    for (int e = 0; e < 3; e++) {
        const int i = (e + 1) % 3, j = (e + 2) % 3;
        const double *a = vertex(data, corner[i]), *b = vertex(data, corner[j]);
        const double net[10] = {data->f[corner[i]],
                                ahead(data, corner[i], b, 1.0 / 3),
                                z[i],
                                ahead(data, corner[j], a, 1.0 / 3),
                                d[e],
                                q[i],
                                data->f[corner[j]],
                                z[j],
                                q[j],
                                (q[0] + q[1] + q[2]) / 3};
        bat_triangle_set(made, 3 * t + e, 1, net);
        set_corners(made, 3 * t + e, corner[i], corner[j], data->domain->vertex_count + t);
    }
}

batten_status batten_triangles_clough_tocher(const batten_triangulation *domain, int count,
                                             const double *values, const double *gradients,
                                             const double *middles, batten_triangles **out)
{
    assert(domain && values && gradients && out);
    const element_data data = {domain, count, values, gradients};
    batten_triangles *made = NULL;
    batten_status status = check_sizes(&data, 3, 3);
    if (status == BATTEN_OK && middles)
        status = check_finite(middles, (size_t)count, 6, "component",
                              "the gradients at the middles of the edges of triangle");
    if (status == BATTEN_OK)
        status = make_elements(&data, 3, 3, count, &made);
    if (status != BATTEN_OK)
        return status;
    for (int t = 0; t < count; t++)
        clough_tocher(&data, middles, t, made);
    return bat_triangles_finish(made, out);
}

/* ---- Powell and Sabin ---- */

/* New vertices: the centres of the triangles, then a point on each edge. */
typedef struct {
    double *centres; /* [count][2] */
    int *edge_of;    /* [count][3] the number of each edge */
    double *cut;     /* [edge_count] where it is cut, from its lower vertex */
    int edge_count;
    double thinnest;
} six_split;

/* The lengths of the sides, each by the corner across from it. */
static void find_sides(const element_data *data, const int *corner, double side[3])
{
    for (int e = 0; e < 3; e++) {
        const double *a = vertex(data, corner[(e + 1) % 3]),
                     *b = vertex(data, corner[(e + 2) % 3]);
        side[e] = bat_hypot(b[0] - a[0], b[1] - a[1]);
    }
}

static void find_centre(const element_data *data, int t, double *centre)
{
    const int *corner = data->domain->corners + 3 * t;
    double side[3];
    find_sides(data, corner, side);
    const double all = side[0] + side[1] + side[2];
    for (int k = 0; k < 2; k++) {
        const double first = vertex(data, corner[0])[k];
        centre[k] = first + (side[1] * (vertex(data, corner[1])[k] - first) +
                             side[2] * (vertex(data, corner[2])[k] - first)) /
                                all;
    }
}

/* Where the line between the centres of two triangles crosses their edge. */
static batten_status cut_edge(const element_data *data, const bat_triangle_edge *edge,
                              six_split *split, double *cut)
{
    const double *a = vertex(data, edge[0].low), *b = vertex(data, edge[0].high);
    const double *p = split->centres + 2 * (size_t)edge[0].triangle;
    const double *q = split->centres + 2 * (size_t)edge[1].triangle;
    const double x = q[0] - p[0], y = q[1] - p[1];
    *cut = ((p[0] - a[0]) * y - (p[1] - a[1]) * x) / ((b[0] - a[0]) * y - (b[1] - a[1]) * x);
    if (!(*cut > 0 && *cut < 1))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the line between the centres of triangles %d and %d misses their edge "
                        "from vertex %d to %d: it crosses it at %g of its length",
                        edge[0].triangle + 1, edge[1].triangle + 1, edge[0].low + 1,
                        edge[0].high + 1, *cut);
    split->thinnest = bat_min(split->thinnest, bat_min(*cut, 1 - *cut));
    return BATTEN_OK;
}

static batten_status cut_edges(const element_data *data, const bat_triangle_edge *edges,
                               six_split *split)
{
    const int total = 3 * data->count;
    batten_status status = BATTEN_OK;
    for (int i = 0, n; i < total && status == BATTEN_OK; i += n) {
        const bat_triangle_edge *edge = edges + i;
        for (n = 1; i + n < total && edge[n].low == edge->low && edge[n].high == edge->high;)
            n++;
        if (n > 2)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "the edge from vertex %d to %d belongs to %d triangles",
                            edge->low + 1, edge->high + 1, n);
        for (int k = 0; k < n; k++)
            split->edge_of[3 * edge[k].triangle + edge[k].edge] = split->edge_count;
        split->cut[split->edge_count] = 0.5;
        if (n == 2)
            status = cut_edge(data, edge, split, split->cut + split->edge_count);
        split->edge_count++;
    }
    return status;
}

/* The two pieces on edge e of triangle t, side = 3 t + e; z next to the centre at the corners,
 * and in it. */
static void set_two_pieces(const element_data *data, const six_split *split, int side,
                           const double z[4], batten_triangles *made)
{
    const int t = side / 3, e = side % 3;
    const int *corner = data->domain->corners + 3 * t;
    const int ci = (e + 1) % 3, cj = (e + 2) % 3, i = corner[ci], j = corner[cj];
    const int edge = split->edge_of[side];
    const double from_low = split->cut[edge], m = i < j ? from_low : 1 - from_low;
    const int first = data->domain->vertex_count, on_edge = first + data->count + edge;
    const double *r = made->vertices + 2 * (size_t)on_edge;
    const double ei = ahead(data, i, r, 0.5), ej = ahead(data, j, r, 0.5);
    const double at_edge = (1 - m) * ei + m * ej, between = (1 - m) * z[ci] + m * z[cj];
    const double one[6] = {data->f[i], ei, z[ci], at_edge, between, z[3]};
    const double two[6] = {at_edge, ej, between, data->f[j], z[cj], z[3]};
    const int piece = 6 * t + 2 * e;
    bat_triangle_set(made, piece, 1, one);
    bat_triangle_set(made, piece + 1, 1, two);
    set_corners(made, piece, i, on_edge, first + t);
    set_corners(made, piece + 1, on_edge, j, first + t);
}

static void powell_sabin(const element_data *data, const six_split *split, int t,
                         batten_triangles *made)
{
    const int *corner = data->domain->corners + 3 * t;
    const double *centre = split->centres + 2 * (size_t)t;
    double z[4], b[3], side[3];
    find_sides(data, corner, side);
    for (int e = 0; e < 3; e++)
        z[e] = ahead(data, corner[e], centre, 0.5);
    z[3] = 0;
    for (int e = 0; e < 3; e++) {
        b[e] = side[e] / (side[0] + side[1] + side[2]);
        z[3] += b[e] * z[e];
    }
    for (int e = 0; e < 3; e++)
        set_two_pieces(data, split, 3 * t + e, z, made);
}

static void fill_new_vertices(const element_data *data, const six_split *split,
                              const bat_triangle_edge *edges, batten_triangles *made)
{
    double *fresh = made->vertices + 2 * (size_t)data->domain->vertex_count;
    memcpy(fresh, split->centres, 2 * (size_t)data->count * sizeof *fresh);
    fresh += 2 * (size_t)data->count;
    for (int i = 0; i < 3 * data->count; i++) {
        const int edge = split->edge_of[3 * edges[i].triangle + edges[i].edge];
        const double *a = vertex(data, edges[i].low), *b = vertex(data, edges[i].high);
        for (int k = 0; k < 2; k++)
            fresh[2 * (size_t)edge + (size_t)k] = a[k] + split->cut[edge] * (b[k] - a[k]);
    }
}

static batten_status split_and_set(const element_data *data, six_split *split,
                                   const bat_triangle_edge *edges, batten_triangles **out)
{
    batten_triangles *made = NULL;
    for (int t = 0; t < data->count; t++)
        find_centre(data, t, split->centres + 2 * (size_t)t);
    batten_status status = cut_edges(data, edges, split);
    if (status == BATTEN_OK)
        status = make_elements(data, 2, 6, data->count + split->edge_count, &made);
    if (status != BATTEN_OK)
        return status;
    fill_new_vertices(data, split, edges, made);
    for (int t = 0; t < data->count; t++)
        powell_sabin(data, split, t, made);
    return bat_triangles_finish(made, out);
}

batten_status batten_triangles_powell_sabin(const batten_triangulation *domain, int count,
                                            const double *values, const double *gradients,
                                            double *thinnest, batten_triangles **out)
{
    assert(domain && values && gradients && out);
    const element_data data = {domain, count, values, gradients};
    batten_status status = check_sizes(&data, 6, 2);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)count;
    bat_triangle_edge *edges = NULL;
    six_split split = {.thinnest = 0.5};
    split.centres = bat_array3(n, 2, sizeof *split.centres);
    split.edge_of = bat_array3(n, 3, sizeof *split.edge_of);
    split.cut = bat_array3(n, 3, sizeof *split.cut);
    status = split.centres && split.edge_of && split.cut ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = bat_triangle_edges(count, domain->corners, &edges);
    if (status == BATTEN_OK)
        status = split_and_set(&data, &split, edges, out);
    if (status == BATTEN_OK && thinnest)
        *thinnest = split.thinnest;
    bat_release(edges);
    bat_release(split.cut);
    bat_release(split.edge_of);
    bat_release(split.centres);
    return status;
}
