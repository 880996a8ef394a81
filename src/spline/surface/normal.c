/*
 * Normals by limits. Near a point where Su x Sv vanishes the surface is expanded to order 5
 * (or as far as it goes),
 * and Su x Sv along several rays that lead into the domain; the first coefficient that stands
 * out of its roundoff gives the direction of the normal on that ray, and all rays must agree.
 */
#include "spline/surface/normal.h"

#include <string.h>

enum { ORDER = 5, TERMS = BATTEN_SURFACE_DERIVATIVES(ORDER), TEST_PLACES = 3 };

/* Two rays whose normals differ by less (radians) are taken to agree: the square root of what
 * doubles resolve, times 64 for what the higher derivatives lose. */
#define AGREEMENT (64 * 0x1p-26)

/* Taylor coefficients in units of the spans and of the largest coordinate, and their roundoff.
 */
typedef struct {
    int order; /* ORDER, or the highest that the surface has */
    double c[TERMS][3], noise[TERMS];
} expansion;

static batten_status expand(const batten_surface *surface, const bat_surface_place *place,
                            expansion *out)
{
    const int d = surface->dimension;
    const int order = bat_min_int(ORDER, surface->kind->highest_order);
    bat_surface_local local;
    double values[TERMS * 3];
    const batten_status status = surface->kind->evaluate(surface, place, order, values);
    if (status != BATTEN_OK)
        return status;
    surface->kind->local(surface, place, &local);
    double unit_u = 1, noise_u = 16 * DBL_EPSILON;
    out->order = order;
    for (int k = 0; k <= order; k++) {
        double unit = unit_u, noise = noise_u;
        for (int l = 0; k + l <= order; l++) {
            const int at = BATTEN_SURFACE_DERIVATIVE(k, l);
            out->noise[at] = noise;
            for (int x = 0; x < 3; x++)
                out->c[at][x] = x < d ? values[at * d + x] / local.largest * unit : 0;
            unit *= local.span[1] / (l + 1);
            noise *= 2.0 * local.degree[1] / (l + 1);
        }
        unit_u *= local.span[0] / (k + 1);
        noise_u *= 2.0 * local.degree[0] / (k + 1);
    }
    return BATTEN_OK;
}

static double length(const double a[3])
{
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

/* sum += factor a x b */
static void add_cross(double factor, const double a[3], const double b[3], double sum[3])
{
    sum[0] += factor * (a[1] * b[2] - a[2] * b[1]);
    sum[1] += factor * (a[2] * b[0] - a[0] * b[2]);
    sum[2] += factor * (a[0] * b[1] - a[1] * b[0]);
}

/* The coefficient m of Su x Sv along (a, b), from all S(k, l) x S(i, j) with k + l + i + j = m
 * + 2; its roundoff is returned. */
static double cross_term(const expansion *e, int m, double a, double b, double sum[3])
{
    double noise = 0;
    memset(sum, 0, 3 * sizeof *sum);
    for (int k = 1; k <= m + 1; k++)
        for (int l = 0; k + l <= m + 1; l++)
            for (int j = 1; j <= m + 2 - k - l; j++) {
                const int i = m + 2 - k - l - j;
                const int first = BATTEN_SURFACE_DERIVATIVE(k, l);
                const int second = BATTEN_SURFACE_DERIVATIVE(i, j);
                const double factor = k * j * bat_pow(a, k - 1 + i) * bat_pow(b, l + j - 1);
                const double n1 = e->noise[first], n2 = e->noise[second];
                add_cross(factor, e->c[first], e->c[second], sum);
                noise += fabs(factor) *
                         (n1 * length(e->c[second]) + n2 * length(e->c[first]) + n1 * n2);
            }
    return noise;
}

/* The unit normal on a ray and the order of its coefficient; -1 when all vanish. */
static int ray_normal(const expansion *e, double a, double b, double normal[3])
{
    for (int m = 0; m < e->order; m++) {
        double sum[3];
        const double noise = cross_term(e, m, a, b, sum), size = length(sum);
        if (size > noise) {
            for (int x = 0; x < 3; x++)
                normal[x] = sum[x] / size;
            return m;
        }
    }
    return -1;
}

/* What the rays have said so far. */
typedef struct {
    double normal[3];
    bool known, is_limit, disagree;
} verdict;

static void hear(verdict *so_far, int order, const double normal[3])
{
    if (order < 0)
        return;
    so_far->is_limit |= order > 0;
    if (!so_far->known) {
        memcpy(so_far->normal, normal, sizeof so_far->normal);
        so_far->known = true;
        return;
    }
    const double *n = so_far->normal;
    double cross[3] = {0};
    add_cross(1, n, normal, cross);
    so_far->disagree |=
        length(cross) > AGREEMENT || n[0] * normal[0] + n[1] * normal[1] + n[2] * normal[2] < 0;
}

static bool has_side(const batten_surface *surface, batten_direction direction, double at,
                     batten_side side)
{
    const batten_interval domain = surface->kind->domain(surface, direction);
    return surface->kind->is_periodic(surface, direction) ||
           (side == BATTEN_FROM_RIGHT ? at < domain.b : at > domain.a);
}

/* Three rays into each quadrant that belongs to the domain. */
static batten_status ask_rays(const batten_surface *surface, double u, double v,
                              verdict *so_far)
{
    static const double slopes[3][2] = {{1, 1}, {1, 0.5}, {0.5, 1}};
    static const batten_side sides[2] = {BATTEN_FROM_RIGHT, BATTEN_FROM_LEFT};
    for (int quadrant = 0; quadrant < 4; quadrant++) {
        const batten_side side_u = sides[quadrant % 2], side_v = sides[quadrant / 2];
        if (!has_side(surface, BATTEN_U, u, side_u) || !has_side(surface, BATTEN_V, v, side_v))
            continue;
        const bat_surface_place place = {u, v, {side_u, side_v}};
        expansion e;
        const batten_status status = expand(surface, &place, &e);
        if (status != BATTEN_OK)
            return status;
        const double sign_u = side_u == BATTEN_FROM_RIGHT ? 1 : -1;
        const double sign_v = side_v == BATTEN_FROM_RIGHT ? 1 : -1;
        for (int i = 0; i < 3; i++) {
            double normal[3];
            const int order =
                ray_normal(&e, sign_u * slopes[i][0], sign_v * slopes[i][1], normal);
            hear(so_far, order, normal);
        }
    }
    return BATTEN_OK;
}

/* Does the whole edge through (u, v) along `along` lie in one point? Then the normal there must
 * be the same wherever the edge is approached: true for a pole, false for the apex of a cone.
 */
static batten_status ask_along_edge(const batten_surface *surface, batten_direction along,
                                    double u, double v, verdict *so_far)
{
    const batten_interval domain = surface->kind->domain(surface, along);
    const double length_of_edge = domain.b - domain.a;
    bat_surface_local local;
    double here[3] = {0}, there[3] = {0}, places[TEST_PLACES];
    const bat_surface_place place = bat_surface_place_at(u, v);
    surface->kind->local(surface, &place, &local);
    batten_status status = batten_surface_evaluate(surface, u, v, 0, here);
    for (int i = 0; i < TEST_PLACES && status == BATTEN_OK; i++) {
        places[i] = (along == BATTEN_U ? u : v) + length_of_edge * (i + 1) / (TEST_PLACES + 1);
        if (places[i] > domain.b)
            places[i] -= length_of_edge;
        status = batten_surface_evaluate(surface, along == BATTEN_U ? places[i] : u,
                                         along == BATTEN_U ? v : places[i], 0, there);
        for (int x = 0; x < surface->dimension; x++)
            if (fabs(there[x] - here[x]) > 64 * DBL_EPSILON * local.largest)
                return status;
    }
    for (int i = 0; i < TEST_PLACES && status == BATTEN_OK; i++)
        status = ask_rays(surface, along == BATTEN_U ? places[i] : u,
                          along == BATTEN_U ? v : places[i], so_far);
    return status;
}

batten_status bat_surface_limit_normal(const batten_surface *surface, double u, double v,
                                       double normal[3], bool *is_limit)
{
    verdict heard = {.known = false};
    batten_status status = ask_rays(surface, u, v, &heard);
    if (status == BATTEN_OK && heard.is_limit)
        status = ask_along_edge(surface, BATTEN_U, u, v, &heard);
    if (status == BATTEN_OK && heard.is_limit)
        status = ask_along_edge(surface, BATTEN_V, u, v, &heard);
    if (status != BATTEN_OK)
        return status;
    if (!heard.known || heard.disagree)
        return bat_fail(BATTEN_SINGULAR_HERE, "the surface has no %s normal at (%.17g, %.17g)",
                        heard.known ? "unique" : "recognisable", u, v);
    memcpy(normal, heard.normal, sizeof heard.normal);
    *is_limit = heard.is_limit;
    return BATTEN_OK;
}

batten_status batten_surface_normal(const batten_surface *surface, double u, double v,
                                    bool *is_limit, batten_vec3 *normal)
{
    assert(surface && normal);
    const int d = surface->dimension;
    if (d < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface of dimension %d has no normal", d);
    double values[9], su[3] = {0}, sv[3] = {0}, n[3];
    batten_status status = batten_surface_evaluate(surface, u, v, 1, values);
    if (status != BATTEN_OK)
        return status;
    memcpy(su, values + d, (size_t)d * sizeof *su);
    memcpy(sv, values + 2 * d, (size_t)d * sizeof *sv);
    bat_surface_local local;
    const bat_surface_place place = bat_surface_place_at(u, v);
    surface->kind->local(surface, &place, &local);
    const double noise_u = bat_derivative_noise(local.degree[0], local.span[0], local.largest);
    const double noise_v = bat_derivative_noise(local.degree[1], local.span[1], local.largest);
    bool limit = false;
    if (!bat_regular_normal(su, sv, noise_u, noise_v, n))
        status = bat_surface_limit_normal(surface, u, v, n, &limit);
    if (status != BATTEN_OK)
        return status;
    *normal = (batten_vec3){n[0], n[1], n[2]};
    if (is_limit)
        *is_limit = limit;
    return BATTEN_OK;
}
