/* Bezier triangles as tensor patches and back: exact, by blossoms. */
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"
#include "spline/triangles/triangles.h"

#include <string.h>

/* A Bezier patch n x n over the unit square whose net waits to be filled in. */
static batten_status make_patch(const batten_triangles *triangles, bat_nurbs **out)
{
    const int n = triangles->degree;
    const bat_nurbs_shape shape = {.dimension = triangles->dimension,
                                   .degree = {n, n},
                                   .count = {n + 1, n + 1},
                                   .periodic = {false, false},
                                   .rational = triangles->weights != NULL};
    const batten_status status = bat_nurbs_make(&shape, out);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        for (int i = n + 1; i < 2 * n + 2; i++)
            (*out)->axes[k].knots[i] = 1; /* the others are 0 */
    return status;
}

/* rows [(n + 1)^2][width] become points and weights. */
static batten_status finish_patch(const batten_triangles *triangles, const double *rows,
                                  bat_nurbs *made, batten_surface **out)
{
    const size_t d = (size_t)triangles->dimension, width = triangles->width;
    const size_t count = (size_t)(triangles->degree + 1) * (size_t)(triangles->degree + 1);
    for (size_t i = 0; i < count; i++) {
        const double *row = rows + i * width;
        const double w = width > d ? row[d] : 1;
        for (size_t k = 0; k < d; k++)
            made->points[i * d + k] = row[k] / w;
        if (made->weights)
            made->weights[i] = w / triangles->weight_scale;
    }
    return bat_nurbs_finish(made, out);
}

/* ---- three patches ---- */

/* The net seen from corner `first`, which becomes corner 0. */
static void turn_net(const batten_triangles *triangles, int triangle, int first, double *out)
{
    const int n = triangles->degree;
    const size_t width = triangles->width;
    const double *net = bat_triangle_net(triangles, triangle);
    for (int row = 0; row <= n; row++)
        for (int k = 0; k <= row; k++, out += width)
            memcpy(out, net + (size_t)bat_triangle_at(n, first, n - row, k) * width,
                   width * sizeof *out);
}

/* sum[p + k][q + k] += share * row, where row is the blossom with the centre k times, the
 * middles of the two edges p and q times, and corner 0 for the rest. */
static void add_share(int n, size_t width, int k, int p, int q, const double *row, double *sum)
{
    const double share = bat_binomials[n][k] * bat_binomials[n - k][p] *
                         bat_binomials[n - k - p][q] /
                         (bat_binomials[n][p + k] * bat_binomials[n][q + k]);
    double *to = sum + (size_t)((p + k) * (n + 1) + q + k) * width;
    for (size_t c = 0; c < width; c++)
        to[c] += share * row[c];
}

/* The patch at corner 0 of a turned net, which is spoilt. `work` [2][net]. */
static void corner_patch(int n, size_t width, double *for_k, double *work, double *sum)
{
    static const double centre[3] = {1 / 3.0, 1 / 3.0, 1 / 3.0};
    static const double middle[2][3] = {{0.5, 0.5, 0}, {0.5, 0, 0.5}};
    const size_t bytes = (size_t)BATTEN_TRIANGLE_POINTS(n) * width * sizeof *work;
    double *for_p = work, *for_q = work + bytes / sizeof *work;
    memset(sum, 0, (size_t)(n + 1) * (size_t)(n + 1) * width * sizeof *sum);
    for (int k = 0; k <= n; k++) {
        memcpy(for_p, for_k, bytes);
        for (int p = 0; p <= n - k; p++) {
            memcpy(for_q, for_p, bytes);
            for (int q = 0; q <= n - k - p; q++) {
                add_share(n, width, k, p, q, for_q, sum);
                if (q < n - k - p)
                    bat_triangle_step(n - k - p - q, width, middle[1], for_q);
            }
            if (p < n - k)
                bat_triangle_step(n - k - p, width, middle[0], for_p);
        }
        if (k < n)
            bat_triangle_step(n - k, width, centre, for_k);
    }
}

batten_status batten_triangles_to_patches(const batten_triangles *triangles, int triangle,
                                          batten_surface *out[3])
{
    assert(triangles && out && triangle >= 0 && triangle < triangles->count);
    const int n = triangles->degree;
    const size_t size = triangles->net_count * triangles->width;
    double *work = bat_array(3 * size + (size_t)(n + 1) * (size_t)(n + 1) * triangles->width,
                             sizeof *work);
    batten_surface *made[3] = {NULL, NULL, NULL};
    batten_status status = work ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < 3 && status == BATTEN_OK; i++) {
        bat_nurbs *patch = NULL;
        status = make_patch(triangles, &patch);
        if (status != BATTEN_OK)
            break;
        turn_net(triangles, triangle, i, work);
        corner_patch(n, triangles->width, work, work + size, work + 3 * size);
        status = finish_patch(triangles, work + 3 * size, patch, &made[i]);
    }
    bat_release(work);
    for (int i = 0; i < 3; i++) {
        if (status == BATTEN_OK)
            out[i] = made[i];
        else
            batten_surface_unref(made[i]);
    }
    return status;
}

/* ---- one patch with a pole ---- */

/* In place, a Bezier curve of degree n becomes one of degree n + 1. */
static void elevate_row(int n, size_t width, double *row)
{
    memcpy(row + (size_t)(n + 1) * width, row + (size_t)n * width, width * sizeof *row);
    for (int k = n; k > 0; k--)
        for (size_t c = 0; c < width; c++) {
            double *at = row + (size_t)k * width + c;
            *at = (k * *(at - width) + (n + 1 - k) * *at) / (n + 1);
        }
}

batten_status batten_triangles_to_pole_patch(const batten_triangles *triangles, int triangle,
                                             batten_surface **out)
{
    assert(triangles && out && triangle >= 0 && triangle < triangles->count);
    const int n = triangles->degree;
    const size_t width = triangles->width;
    const double *net = bat_triangle_net(triangles, triangle);
    double *rows = bat_array3((size_t)(n + 1) * width, (size_t)n + 1, sizeof *rows);
    bat_nurbs *patch = NULL;
    batten_status status = rows ? make_patch(triangles, &patch) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        for (int i = 0; i <= n; i++) {
            double *row = rows + (size_t)i * (size_t)(n + 1) * width;
            memcpy(row, net + (size_t)BATTEN_TRIANGLE_POINT(i, 0) * width,
                   (size_t)(i + 1) * width * sizeof *row);
            for (int degree = i; degree < n; degree++)
                elevate_row(degree, width, row);
        }
        status = finish_patch(triangles, rows, patch, out);
    }
    bat_release(rows);
    return status;
}

batten_status batten_triangles_half_at_edge(const batten_triangles *triangles, int triangle,
                                            int edge, batten_surface **out)
{
    assert(triangles && out && triangle >= 0 && triangle < triangles->count && edge >= 0 &&
           edge < 3);
    bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    shape.count = 1;
    shape.vertex_count = 0;
    double *net = bat_array(triangles->net_count * triangles->width, sizeof *net);
    batten_triangles *made = NULL, *turned = NULL;
    batten_surface *whole = NULL;
    batten_status status = net ? bat_triangles_make(&shape, &made) : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        turn_net(triangles, triangle, edge, net);
        bat_triangle_set(made, 0, triangles->weight_scale, net);
        status = bat_triangles_finish(made, &turned);
    }
    if (status == BATTEN_OK)
        status = batten_triangles_to_pole_patch(turned, 0, &whole);
    if (status == BATTEN_OK)
        status = batten_surface_subrange(whole, BATTEN_U, 0.5, 1, out);
    batten_surface_unref(whole);
    batten_triangles_unref(turned);
    bat_release(net);
    return status;
}

/* ---- an edge ---- */

batten_status batten_triangles_edge(const batten_triangles *triangles, int triangle, int edge,
                                    batten_curve **out)
{
    assert(triangles && out && triangle >= 0 && triangle < triangles->count && edge >= 0 &&
           edge < 3);
    const int n = triangles->degree;
    const size_t d = (size_t)triangles->dimension;
    batten_curve *made = NULL;
    const batten_status status =
        bat_curve_make(triangles->dimension, n, n + 1, triangles->weights != NULL, &made);
    if (status != BATTEN_OK)
        return status;
    for (int s = 0; s <= n; s++) {
        const size_t at =
            (size_t)triangle * triangles->net_count + (size_t)bat_triangle_at(n, edge, 0, s);
        memcpy(made->points + (size_t)s * d, triangles->points + at * d,
               d * sizeof *made->points);
        if (triangles->weights)
            made->weights[s] = triangles->weights[at];
        made->knots[s] = 0;
        made->knots[n + 1 + s] = 1;
    }
    return bat_curve_finish(made, out);
}

/* ---- from tensor patches ---- */

/* What a triangle is cut from: a patch m x n of a net with `count_v` rows in v. */
typedef struct {
    int m, n, count_v;
    size_t width, first;
    const double *net;
} tensor;

/* The control point (i, j, k) of the triangle with corners a, b, c of the unit square: the mean
 * over all ways to give its i a's, j b's and k c's to the m arguments u and n arguments v of
 * the blossom. With arguments 0 and 1 this is a control point of the patch. */
static void mixed_point(const tensor *from, const int corners[3][2], int i, int j, int k,
                        double *out)
{
    const int m = from->m;
    memset(out, 0, from->width * sizeof *out);
    for (int a = 0; a <= i && a <= m; a++)
        for (int b = 0; b <= j && a + b <= m; b++) {
            const int c = m - a - b;
            if (c > k)
                continue;
            const int p = a * corners[0][0] + b * corners[1][0] + c * corners[2][0];
            const int q =
                (i - a) * corners[0][1] + (j - b) * corners[1][1] + (k - c) * corners[2][1];
            const double share = bat_binomials[i][a] * bat_binomials[j][b] *
                                 bat_binomials[k][c] / bat_binomials[m + from->n][m];
            const double *row =
                from->net +
                (from->first + (size_t)p * (size_t)from->count_v + (size_t)q) * from->width;
            for (size_t x = 0; x < from->width; x++)
                out[x] += share * row[x];
        }
}

static const int halves[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};

/* Both triangles of all patches; `net` is one triangle's. */
static void cut_patches(const bat_nurbs *bezier, const int spans[2], double *net,
                        batten_triangles *made)
{
    const int degree = made->degree;
    const bat_axis *u = &bezier->axes[BATTEN_U], *v = &bezier->axes[BATTEN_V];
    tensor from = {u->degree, v->degree, v->count, bezier->width, 0, bezier->net};
    for (int s = 0; s < 2 * spans[0] * spans[1]; s++) {
        const int along_u = s / 2 / spans[1], along_v = s / 2 % spans[1];
        from.first =
            (size_t)(along_u * from.m) * (size_t)from.count_v + (size_t)(along_v * from.n);
        double *to = net;
        for (int row = 0; row <= degree; row++)
            for (int k = 0; k <= row; k++, to += from.width)
                mixed_point(&from, halves[s % 2], degree - row, row - k, k, to);
        bat_triangle_set(made, s, bezier->weight_scale, net);
        for (int e = 0; e < 3; e++)
            made->corners[3 * s + e] = (along_u + halves[s % 2][e][0]) * (spans[1] + 1) +
                                       along_v + halves[s % 2][e][1];
    }
    for (int i = 0; i <= spans[0]; i++)
        for (int j = 0; j <= spans[1]; j++) {
            made->vertices[2 * (i * (spans[1] + 1) + j)] = u->breaks[i];
            made->vertices[2 * (i * (spans[1] + 1) + j) + 1] = v->breaks[j];
        }
}

static batten_status from_bezier(const bat_nurbs *bezier, batten_triangles **out)
{
    const int spans[2] = {bezier->axes[0].span_count, bezier->axes[1].span_count};
    const int degree = bezier->axes[0].degree + bezier->axes[1].degree;
    const long long count = 2LL * spans[0] * spans[1];
    if (count * BATTEN_TRIANGLE_POINTS(degree) > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%lld triangles of degree %d have more than %d control points", count,
                        degree, BAT_MAX_POINTS);
    const bat_triangles_shape shape = {bezier->base.dimension, degree, (int)count,
                                       bezier->weights != NULL,
                                       (spans[0] + 1) * (spans[1] + 1)};
    batten_triangles *made = NULL;
    const batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    double *net = bat_array(made->net_count * made->width, sizeof *net);
    if (!net) {
        bat_triangles_free(made);
        return BATTEN_OUT_OF_MEMORY;
    }
    cut_patches(bezier, spans, net, made);
    bat_release(net);
    return bat_triangles_finish(made, out);
}

batten_status batten_triangles_from_surface(const batten_surface *surface,
                                            batten_triangles **out)
{
    assert(surface && out);
    const int degree =
        batten_surface_degree(surface, BATTEN_U) + batten_surface_degree(surface, BATTEN_V);
    if (degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE,
                        "a surface of degrees %d and %d has triangles of degree %d; the "
                        "highest is %d",
                        batten_surface_degree(surface, BATTEN_U),
                        batten_surface_degree(surface, BATTEN_V), degree, BATTEN_MAX_DEGREE);
    batten_surface *bezier = NULL;
    batten_status status = batten_surface_to_bezier(surface, &bezier);
    if (status == BATTEN_OK)
        status = from_bezier(bat_surface_nurbs(bezier), out);
    batten_surface_unref(bezier);
    return status;
}
