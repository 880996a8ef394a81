/* Principal, Gaussian and mean curvature of a surface at a point. */
#include "base/plural.h"
#include "base/work.h"
#include "numeric/vector.h"
#include <batten/curvature.h>

#include <float.h>

static batten_status check_space(const batten_surface *surface)
{
    const int d = batten_surface_dimension(surface);
    if (d != 3)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a surface in %d dimension%s has no curvature",
                        d, bat_plural(d));
    return BATTEN_OK;
}

static batten_vec3 derivative(const double *values, int k, int l)
{
    return bat_vec3_of(3, values + 3 * BATTEN_SURFACE_DERIVATIVE(k, l));
}

/* The second fundamental form in the orthonormal tangents e1 = Su / |Su|, e2 = n x e1. There
 * its eigenvalues are the principal curvatures, without the cancellation of the textbook
 * quotient. */
typedef struct {
    batten_vec3 e1, e2;
    double a, b, c; /* II(e1, e1), II(e1, e2), II(e2, e2) */
} shape_form;

/* With Su = p e1 and Sv = q e1 + r e2: II(Su, Su) = p^2 a and so on, solved for a, b, c. */
static shape_form form_of(const double *values, batten_vec3 normal)
{
    const batten_vec3 su = derivative(values, 1, 0), sv = derivative(values, 0, 1);
    const double L = bat_vec3_dot(derivative(values, 2, 0), normal);
    const double M = bat_vec3_dot(derivative(values, 1, 1), normal);
    const double N = bat_vec3_dot(derivative(values, 0, 2), normal);
    const double p = bat_vec3_norm(su);
    shape_form f;
    f.e1 = bat_vec3_scale(su, 1 / p);
    f.e2 = bat_vec3_cross(normal, f.e1);
    const double q = bat_vec3_dot(sv, f.e1), r = bat_vec3_dot(sv, f.e2);
    f.a = L / (p * p);
    f.b = (M / p - q * f.a) / r;
    f.c = (N - 2 * q * r * f.b - q * q * f.a) / (r * r);
    return f;
}

/* Half the angle of (a - c, 2 b) points along the larger eigenvalue. */
static void principal(const shape_form *f, batten_surface_local *out)
{
    const double half = (f->a - f->c) / 2, radius = bat_hypot(half, f->b);
    const double angle = bat_atan2(f->b, half) / 2, c = bat_cos(angle), s = bat_sin(angle);
    out->mean = (f->a + f->c) / 2;
    out->gaussian = f->a * f->c - f->b * f->b;
    out->kappa1 = out->mean + radius;
    out->kappa2 = out->mean - radius;
    out->direction1 = bat_vec3_along(bat_vec3_scale(f->e1, c), s, f->e2);
    out->direction2 = bat_vec3_along(bat_vec3_scale(f->e1, -s), c, f->e2);
}

batten_status batten_surface_local_at(const batten_surface *surface, double u, double v,
                                      batten_surface_local *out)
{
    double values[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    batten_vec3 normal;
    bool is_limit = false;
    batten_status status = check_space(surface);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate(surface, u, v, 2, values);
    if (status == BATTEN_OK)
        status = batten_surface_normal(surface, u, v, &is_limit, &normal);
    if (status != BATTEN_OK)
        return status;
    *out = (batten_surface_local){.point = derivative(values, 0, 0), .normal = normal};
    if (is_limit)
        return bat_fail(BATTEN_SINGULAR_HERE, "the tangents at (%g, %g) do not span a plane", u,
                        v);
    const shape_form form = form_of(values, normal);
    principal(&form, out);
    return BATTEN_OK;
}

/* ---- grids ---- */

typedef struct {
    const batten_surface *surface;
    size_t count_v;
    const double *u, *v;
    double *gaussian, *mean;
} grid;

static void curvatures(const double *values, double *gaussian, double *mean)
{
    const batten_vec3 su = derivative(values, 1, 0), sv = derivative(values, 0, 1);
    const batten_vec3 cross = bat_vec3_cross(su, sv);
    const double area = bat_vec3_norm(cross);
    *gaussian = *mean = (double)NAN;
    /* The cross product of parallel vectors rounds to a few eps of the product of lengths. */
    if (!(area > 64 * DBL_EPSILON * bat_vec3_norm(su) * bat_vec3_norm(sv)))
        return;
    batten_surface_local at;
    const shape_form form = form_of(values, bat_vec3_scale(cross, 1 / area));
    principal(&form, &at);
    *gaussian = at.gaussian;
    *mean = at.mean;
}

static batten_status fill_rows(void *context, size_t begin, size_t end)
{
    const grid *g = context;
    const size_t size = 3 * BATTEN_SURFACE_DERIVATIVES(2);
    double *values = bat_array3(g->count_v, size, sizeof *values);
    batten_status status = values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (size_t i = begin; status == BATTEN_OK && i < end; i++) {
        status = batten_surface_evaluate_grid(
            g->surface, (batten_uv_grid){1, g->count_v, g->u + i, g->v}, 2, NULL, values);
        for (size_t j = 0; status == BATTEN_OK && j < g->count_v; j++) {
            double gaussian, mean;
            curvatures(values + j * size, &gaussian, &mean);
            if (g->gaussian)
                g->gaussian[i * g->count_v + j] = gaussian;
            if (g->mean)
                g->mean[i * g->count_v + j] = mean;
        }
    }
    bat_release(values);
    return status;
}

batten_status batten_surface_curvature_grid(const batten_surface *surface,
                                            batten_uv_grid places, const batten_job *job,
                                            double *gaussian, double *mean)
{
    batten_status status = check_space(surface);
    grid g = {surface, places.count_v, places.u, places.v, gaussian, mean};
    if (status == BATTEN_OK)
        status = bat_parallel(job, places.count_u, 8, fill_rows, &g);
    return status;
}
