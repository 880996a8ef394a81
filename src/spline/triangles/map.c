/* Triangles as affine maps take them. */
#include "numeric/vector.h"
#include "spline/triangles/triangles.h"

#include <string.h>

static void swap(double *a, double *b)
{
    const double kept = *a;
    *a = *b;
    *b = kept;
}

/* Corners 1 and 2 change places; those of the domain go round as before when its axes do so
 * too. */
static void turn_over(batten_triangles *made)
{
    const size_t d = (size_t)made->dimension, total = (size_t)made->count * made->net_count;
    for (size_t first = 0; first < total; first += made->net_count)
        for (int row = 1; row <= made->degree; row++)
            for (int k = 0; 2 * k < row; k++) {
                const size_t one = first + (size_t)BATTEN_TRIANGLE_POINT(row - k, k);
                const size_t other = first + (size_t)BATTEN_TRIANGLE_POINT(k, row - k);
                for (size_t c = 0; c < d; c++)
                    swap(&made->points[one * d + c], &made->points[other * d + c]);
                if (made->weights)
                    swap(&made->weights[one], &made->weights[other]);
            }
    for (int i = 0; i < made->vertex_count; i++)
        swap(&made->vertices[2 * i], &made->vertices[2 * i + 1]);
    for (int t = 0; made->vertex_count && t < made->count; t++) {
        const int second = made->corners[3 * t + 1];
        made->corners[3 * t + 1] = made->corners[3 * t + 2];
        made->corners[3 * t + 2] = second;
    }
}

batten_status batten_triangles_transform(const batten_triangles *triangles,
                                         const batten_affine *map, batten_triangles **out)
{
    assert(triangles && map && out);
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the affine map has an element that is no number");
    const bat_triangles_shape shape = bat_triangles_shape_of(triangles);
    batten_triangles *made = NULL;
    const batten_status status = bat_triangles_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)triangles->dimension;
    const size_t total = (size_t)triangles->count * triangles->net_count;
    for (size_t i = 0; i < total; i++) {
        const batten_vec3 moved =
            batten_affine_apply(*map, bat_vec3_of((int)d, triangles->points + i * d));
        const double xyz[3] = {moved.x, moved.y, moved.z};
        memcpy(made->points + i * d, xyz, d * sizeof *xyz);
    }
    if (triangles->weights)
        memcpy(made->weights, triangles->weights, total * sizeof *made->weights);
    bat_triangles_copy_domain(triangles, made);
    const size_t bad = bat_first_not_finite(made->points, total * d);
    if (bad == total * d && d == 3 && batten_affine_determinant(*map) < 0)
        turn_over(made);
    if (bad == total * d)
        return bat_triangles_finish(made, out);
    bat_triangles_free(made);
    return bat_fail(BATTEN_OVERFLOW,
                    "control point %zu of triangle %zu is mapped to where numbers end",
                    bad / d % triangles->net_count + 1, bad / d / triangles->net_count + 1);
}
