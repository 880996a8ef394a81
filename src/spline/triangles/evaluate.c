/* Points, derivatives and normals of Bezier triangles, by de Casteljau's algorithm. */
#include "base/work.h"
#include "numeric/vector.h"
#include "spline/surface/normal.h"
#include "spline/surface/surface.h"
#include "spline/triangles/triangles.h"

#include <string.h>

/* What a sum of barycentric coordinates may miss 1 by, and what they may lie outside: as
 * computing them from points of the plane rounds, in thin triangles too. */
#define SLACK 1e-9

enum { SMALL_NET = 400 }; /* numbers that are kept on the stack: degree 11 with weights */

static batten_status check_place(const batten_triangles *triangles, int triangle,
                                 const double at[3])
{
    if (triangle < 0 || triangle >= triangles->count)
        return bat_fail(BATTEN_OUT_OF_DOMAIN, "triangle %d does not exist; there are %d",
                        triangle + 1, triangles->count);
    if (bat_first_not_finite(at, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "barycentric coordinate %zu is %g",
                        bat_first_not_finite(at, 3) + 1, at[bat_first_not_finite(at, 3)]);
    if (fabs(at[0] + at[1] + at[2] - 1) > SLACK)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "the barycentric coordinates %.17g, %.17g, %.17g have the sum %.17g",
                        at[0], at[1], at[2], at[0] + at[1] + at[2]);
    if (at[0] < -SLACK || at[1] < -SLACK || at[2] < -SLACK)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "the barycentric coordinates %.17g, %.17g, %.17g are outside the "
                        "triangle",
                        at[0], at[1], at[2]);
    return BATTEN_OK;
}

/* `work` holds a net and, for rational sets, derivatives with weights. */
static size_t work_size(const batten_triangles *triangles, int order)
{
    const size_t rows = triangles->weights ? BATTEN_SURFACE_DERIVATIVES((size_t)order) : 0;
    return (triangles->net_count + rows) * triangles->width;
}

static batten_status evaluate(const batten_triangles *triangles, int triangle,
                              const double at[3], int order, double *work, double *out)
{
    const size_t numbers = triangles->net_count * triangles->width;
    memcpy(work, bat_triangle_net(triangles, triangle), numbers * sizeof *work);
    if (triangles->weights) {
        bat_triangle_derivatives(triangles->degree, triangles->width, at, order, work,
                                 work + numbers);
        bat_surface_divide(triangles->dimension, order, work + numbers, out);
    } else {
        bat_triangle_derivatives(triangles->degree, triangles->width, at, order, work, out);
    }
    if (bat_all_finite(out, BATTEN_SURFACE_DERIVATIVES((size_t)order) *
                                (size_t)triangles->dimension))
        return BATTEN_OK;
    return bat_fail(BATTEN_OVERFLOW,
                    "the point or a derivative of triangle %d is too large for a number",
                    triangle + 1);
}

batten_status batten_triangles_evaluate(const batten_triangles *triangles, int triangle,
                                        const double at[3], int order, double *out)
{
    assert(triangles && at && out && order >= 0);
    double small[SMALL_NET], *work = small;
    batten_status status = check_place(triangles, triangle, at);
    if (status != BATTEN_OK)
        return status;
    const size_t size = work_size(triangles, order);
    if (size > SMALL_NET)
        work = bat_array(size, sizeof *work);
    if (!work)
        return BATTEN_OUT_OF_MEMORY;
    status = evaluate(triangles, triangle, at, order, work, out);
    if (work != small)
        bat_release(work);
    return status;
}

typedef struct {
    const batten_triangles *triangles;
    const int *triangle;
    const double *at;
    int order;
    double *out;
} batch;

static batten_status evaluate_chunk(void *context, size_t begin, size_t end)
{
    const batch *all = context;
    const size_t stride =
        BATTEN_SURFACE_DERIVATIVES((size_t)all->order) * (size_t)all->triangles->dimension;
    double *work = bat_array(work_size(all->triangles, all->order), sizeof *work);
    if (!work)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (size_t i = begin; i < end && status == BATTEN_OK; i++)
        status = evaluate(all->triangles, all->triangle[i], all->at + 3 * i, all->order, work,
                          all->out + i * stride);
    bat_release(work);
    return status;
}

static batten_status check_places(const batten_triangles *triangles,
                                  const batten_triangle_places *places)
{
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < places->count && status == BATTEN_OK; i++)
        status = check_place(triangles, places->triangle[i], places->at + 3 * i);
    return status;
}

batten_status batten_triangles_evaluate_many(const batten_triangles *triangles,
                                             batten_triangle_places places, int order,
                                             const batten_job *job, double *out)
{
    assert(triangles && order >= 0 && ((places.triangle && places.at && out) || !places.count));
    batch all = {triangles, places.triangle, places.at, order, out};
    const batten_status status = check_places(triangles, &places);
    return status == BATTEN_OK ? bat_parallel(job, places.count, 256, evaluate_chunk, &all)
                               : status;
}

/* ---- normals ---- */

/* The normal of the tensor patch that covers the place: its limits are found as those of any
 * surface. The patch of corner i has b_j = u / 2 - u v / 6, b_k = v / 2 - u v / 6. */
static batten_status limit_normal(const batten_triangles *triangles, int triangle,
                                  const double at[3], batten_vec3 *normal, bool *is_limit)
{
    batten_surface *patches[3];
    const int i = at[0] >= at[1] && at[0] >= at[2] ? 0 : at[1] >= at[2] ? 1 : 2;
    const double bj = bat_max(at[(i + 1) % 3], 0), bk = bat_max(at[(i + 2) % 3], 0);
    const double pu = 3 + 2 * (bj - bk), pv = 3 + 2 * (bk - bj);
    const double u = 12 * bj / (pu + sqrt(bat_max(0, pu * pu - 24 * bj)));
    const double v = 12 * bk / (pv + sqrt(bat_max(0, pv * pv - 24 * bk)));
    batten_status status = batten_triangles_to_patches(triangles, triangle, patches);
    if (status != BATTEN_OK)
        return status;
    status = batten_surface_normal(patches[i], bat_min(u, 1), bat_min(v, 1), is_limit, normal);
    for (int k = 0; k < 3; k++)
        batten_surface_unref(patches[k]);
    return status;
}

batten_status batten_triangles_normal(const batten_triangles *triangles, int triangle,
                                      const double at[3], bool *is_limit, batten_vec3 *normal)
{
    assert(triangles && at && normal);
    const int d = triangles->dimension;
    if (d < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "triangles of dimension %d have no normal", d);
    double values[9], su[3] = {0}, sv[3] = {0}, n[3];
    const batten_status status = batten_triangles_evaluate(triangles, triangle, at, 1, values);
    if (status != BATTEN_OK)
        return status;
    memcpy(su, values + d, (size_t)d * sizeof *su);
    memcpy(sv, values + 2 * d, (size_t)d * sizeof *sv);
    const double noise = bat_derivative_noise(triangles->degree, 1, triangles->largest);
    if (!bat_regular_normal(su, sv, noise, noise, n))
        return limit_normal(triangles, triangle, at, normal, is_limit);
    *normal = (batten_vec3){n[0], n[1], n[2]};
    if (is_limit)
        *is_limit = false;
    return BATTEN_OK;
}
