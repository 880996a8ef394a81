/* Making, keeping and describing sets of Bezier triangles. */
#include "spline/triangles/triangles.h"
#include "base/plural.h"

#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <float.h>
#include <stdint.h>
#include <string.h>

/* ---- making ---- */

batten_status bat_triangles_make(const bat_triangles_shape *shape, batten_triangles **out)
{
    batten_triangles *made = bat_array(1, sizeof *made);
    if (!made)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&made->references);
    made->dimension = shape->dimension;
    made->degree = shape->degree;
    made->count = shape->count;
    made->net_count = BATTEN_TRIANGLE_POINTS((size_t)shape->degree);
    made->width = (size_t)shape->dimension + shape->rational;
    made->vertex_count = shape->vertex_count;

    const size_t count = (size_t)shape->count;
    const size_t each = made->net_count;
    made->points = bat_array3(each * (size_t)shape->dimension, count, sizeof *made->points);
    made->net = made->points;
    if (shape->rational) {
        made->weights = bat_array3(each, count, sizeof *made->weights);
        made->net = bat_array3(each * made->width, count, sizeof *made->net);
    }
    if (shape->vertex_count) {
        made->vertices = bat_array(2 * (size_t)shape->vertex_count, sizeof *made->vertices);
        made->corners = bat_array3(count, 3, sizeof *made->corners);
    }
    if (made->points && made->net && (made->weights || !shape->rational) &&
        ((made->vertices && made->corners) || !shape->vertex_count)) {
        *out = made;
        return BATTEN_OK;
    }
    bat_triangles_free(made);
    return BATTEN_OUT_OF_MEMORY;
}

void bat_triangles_free(batten_triangles *triangles)
{
    if (triangles->net != triangles->points)
        bat_release(triangles->net);
    bat_release(triangles->points);
    bat_release(triangles->weights);
    bat_release(triangles->vertices);
    bat_release(triangles->corners);
    bat_release(triangles);
}

bat_triangles_shape bat_triangles_shape_of(const batten_triangles *triangles)
{
    return (bat_triangles_shape){triangles->dimension, triangles->degree, triangles->count,
                                 triangles->weights != NULL, triangles->vertex_count};
}

void bat_triangles_copy_domain(const batten_triangles *from, batten_triangles *to)
{
    if (!from->vertex_count)
        return;
    memcpy(to->vertices, from->vertices, 2 * (size_t)from->vertex_count * sizeof *to->vertices);
    memcpy(to->corners, from->corners, 3 * (size_t)from->count * sizeof *to->corners);
}

static batten_status check_sizes(int dimension, int degree, int count,
                                 const batten_triangulation *domain)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    if (degree < 1 || degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree is %d; it must be in 1..%d", degree,
                        BATTEN_MAX_DEGREE);
    if (count < 1)
        return bat_fail(BATTEN_TOO_FEW_POINTS, "there %s %d triangle%s; at least 1 is needed",
                        bat_one_or_many(count, "is", "are"), count, bat_plural(count));
    const long long total = (long long)count * BATTEN_TRIANGLE_POINTS(degree);
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%d triangles of degree %d have %lld control points; the limit is %d",
                        count, degree, total, BAT_MAX_POINTS);
    if (domain && (domain->vertex_count < 3 || domain->vertex_count > BAT_MAX_POINTS))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the domain has %d vertices; 3 to %d are allowed",
                        domain->vertex_count, BAT_MAX_POINTS);
    return BATTEN_OK;
}

batten_status batten_triangles_create(const batten_triangles_parts *parts,
                                      batten_triangles **out)
{
    assert(parts->points && out &&
           (!parts->domain || (parts->domain->vertices && parts->domain->corners)));
    batten_status status =
        check_sizes(parts->dimension, parts->degree, parts->count, parts->domain);
    if (status != BATTEN_OK)
        return status;
    const bat_triangles_shape shape = {parts->dimension, parts->degree, parts->count,
                                       parts->weights != NULL,
                                       parts->domain ? parts->domain->vertex_count : 0};
    batten_triangles *made = NULL;
    status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    const size_t total = (size_t)parts->count * made->net_count;
    memcpy(made->points, parts->points,
           total * (size_t)parts->dimension * sizeof *parts->points);
    if (parts->weights)
        memcpy(made->weights, parts->weights, total * sizeof *parts->weights);
    if (parts->domain) {
        memcpy(made->vertices, parts->domain->vertices,
               2 * (size_t)parts->domain->vertex_count * sizeof *made->vertices);
        memcpy(made->corners, parts->domain->corners,
               3 * (size_t)parts->count * sizeof *made->corners);
    }
    return bat_triangles_finish(made, out);
}

/* ---- looking at what was filled in ---- */

static batten_status check_points(batten_triangles *made)
{
    const size_t d = (size_t)made->dimension, each = made->net_count;
    const size_t total = (size_t)made->count * each * d;
    const size_t at = bat_first_not_finite(made->points, total);
    if (at < total)
        return bat_fail(BATTEN_NOT_FINITE,
                        "coordinate %zu of control point %zu of triangle %zu is %g", at % d + 1,
                        at / d % each + 1, at / d / each + 1, made->points[at]);
    for (size_t i = 0; i < total; i++)
        made->largest = bat_max(made->largest, fabs(made->points[i]));
    return BATTEN_OK;
}

static batten_status check_weights(batten_triangles *made)
{
    const size_t each = made->net_count, total = (size_t)made->count * each;
    double largest = 0;
    for (size_t i = 0; i < total; i++) {
        const double w = made->weights[i];
        if (!isfinite(w))
            return bat_fail(BATTEN_NOT_FINITE, "weight %zu of triangle %zu is %g", i % each + 1,
                            i / each + 1, w);
        if (w <= 0)
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "weight %zu of triangle %zu is %g; weights must be positive",
                            i % each + 1, i / each + 1, w);
        largest = bat_max(largest, w);
    }
    made->weight_scale = ldexp(1, bat_min_int(-ilogb(largest), 1023)); /* 2^1074 is no number */
    return BATTEN_OK;
}

/* Twice the area, and a bound on its roundoff. */
static double area_of(const double *a, const double *b, const double *c, double *noise)
{
    const double left = (b[0] - a[0]) * (c[1] - a[1]), right = (b[1] - a[1]) * (c[0] - a[0]);
    *noise = 4 * DBL_EPSILON * (fabs(left) + fabs(right));
    return left - right;
}

static batten_status check_triangle(const batten_triangles *made, int t)
{
    const int *corners = made->corners + 3 * t;
    for (int e = 0; e < 3; e++)
        if (corners[e] < 0 || corners[e] >= made->vertex_count)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "corner %d of triangle %d is vertex %d; there are %d", e + 1, t + 1,
                            corners[e] + 1, made->vertex_count);
    double noise;
    const double area =
        area_of(made->vertices + 2 * corners[0], made->vertices + 2 * corners[1],
                made->vertices + 2 * corners[2], &noise);
    if (!(fabs(area) > noise))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "triangle %d of the domain, at vertices %d, %d and %d, has no area",
                        t + 1, corners[0] + 1, corners[1] + 1, corners[2] + 1);
    if (area < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "triangle %d of the domain, at vertices %d, %d and %d, goes round "
                        "clockwise",
                        t + 1, corners[0] + 1, corners[1] + 1, corners[2] + 1);
    return BATTEN_OK;
}

static batten_status check_domain(const batten_triangles *made)
{
    const size_t count = 2 * (size_t)made->vertex_count;
    const size_t at = count ? bat_first_not_finite(made->vertices, count) : 0;
    if (at < count)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of vertex %zu is %g", at % 2 + 1,
                        at / 2 + 1, made->vertices[at]);
    batten_status status = BATTEN_OK;
    for (int t = 0; made->vertex_count && t < made->count && status == BATTEN_OK; t++)
        status = check_triangle(made, t);
    return status;
}

static void fill_net(batten_triangles *made)
{
    const size_t d = (size_t)made->dimension, total = (size_t)made->count * made->net_count;
    const double *point = made->points;
    double *row = made->net;
    for (size_t i = 0; i < total; i++, point += d) {
        const double w = made->weights[i] * made->weight_scale;
        for (size_t k = 0; k < d; k++)
            *row++ = w * point[k];
        *row++ = w;
    }
}

batten_status bat_triangles_finish(batten_triangles *made, batten_triangles **out)
{
    made->weight_scale = 1;
    batten_status status = check_points(made);
    if (status == BATTEN_OK && made->weights)
        status = check_weights(made);
    if (status == BATTEN_OK)
        status = check_domain(made);
    if (status != BATTEN_OK) {
        bat_triangles_free(made);
        return status;
    }
    if (made->weights)
        fill_net(made);
    *out = made;
    return BATTEN_OK;
}

void bat_triangle_set(batten_triangles *made, int triangle, double scale, const double *rows)
{
    const size_t d = (size_t)made->dimension, first = (size_t)triangle * made->net_count;
    if (!made->weights) {
        memcpy(made->points + first * d, rows, made->net_count * d * sizeof *rows);
        return;
    }
    for (size_t i = 0; i < made->net_count; i++) {
        const double *row = rows + i * (d + 1);
        made->weights[first + i] = row[d] / scale;
        for (size_t k = 0; k < d; k++)
            made->points[(first + i) * d + k] = row[k] / row[d];
    }
}

/* ---- keeping ---- */

batten_triangles *batten_triangles_ref(const batten_triangles *triangles)
{
    /* What is const to the holder is the shape; the count behind it is not part of it. */
    batten_triangles *shared = (batten_triangles *)(uintptr_t)triangles;
    bat_references_add(&shared->references);
    return shared;
}

void batten_triangles_unref(batten_triangles *triangles)
{
    if (triangles && bat_references_drop(&triangles->references))
        bat_triangles_free(triangles);
}

/* ---- properties ---- */

int batten_triangles_dimension(const batten_triangles *triangles)
{
    return triangles->dimension;
}

int batten_triangles_degree(const batten_triangles *triangles)
{
    return triangles->degree;
}

int batten_triangles_count(const batten_triangles *triangles)
{
    return triangles->count;
}

bool batten_triangles_is_rational(const batten_triangles *triangles)
{
    return triangles->weights != NULL;
}

const double *batten_triangles_points(const batten_triangles *triangles)
{
    return triangles->points;
}

const double *batten_triangles_weights(const batten_triangles *triangles)
{
    return triangles->weights;
}

bool batten_triangles_domain(const batten_triangles *triangles, batten_triangulation *domain)
{
    if (!triangles->vertex_count)
        return false;
    *domain = (batten_triangulation){triangles->vertex_count, triangles->vertices,
                                     triangles->corners};
    return true;
}

batten_box batten_triangles_box(const batten_triangles *triangles)
{
    const size_t d = (size_t)triangles->dimension;
    const size_t total = (size_t)triangles->count * triangles->net_count;
    double low[3] = {0}, high[3] = {0};
    for (size_t k = 0; k < d; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (size_t i = 0; i < total; i++) {
            low[k] = bat_min(low[k], triangles->points[i * d + k]);
            high[k] = bat_max(high[k], triangles->points[i * d + k]);
        }
    }
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}
