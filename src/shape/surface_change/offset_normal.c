/*
 * Points of an offset and their derivatives. Where an edge is a point, say Su = 0 along v = b,
 * Su = (v - b) T with T = Suv + (v - b) Suvv / 2 + ..., and T x Sv has the direction that
 * Su x Sv has beside the edge, or the opposite one.
 */
#include "numeric/rounding.h"
#include "shape/surface_change/offset.h"

#include "numeric/jet.h"
#include "numeric/vector.h"
#include "spline/surface/normal.h"

enum { HIGHEST = 3, MOST_VALUES = BATTEN_SURFACE_DERIVATIVES(HIGHEST + 2) * 3 };

/* Jets of the derivative (a, b) of the surface, of as many orders as are known. */
static void take_jets(const double *values, int a, int b, int order, bat_jet out[3])
{
    for (int c = 0; c < 3; c++)
        out[c] = bat_jet_constant(0);
    for (int total = 0; total <= order; total++)
        for (int l = 0; l <= total; l++)
            for (int c = 0; c < 3; c++)
                out[c].d[BATTEN_SURFACE_DERIVATIVE(total - l, l)] =
                    values[3 * BATTEN_SURFACE_DERIVATIVE(total - l + a, l + b) + c];
}

/* The same of T, what is left of Su (of Sv) when v (u) minus its value here is taken out. */
static void take_quotient(const double *values, batten_direction across, int order,
                          bat_jet out[3])
{
    take_jets(values, 1, 1, order, out);
    for (int total = 0; total <= order; total++)
        for (int l = 0; l <= total; l++)
            for (int c = 0; c < 3; c++)
                out[c].d[BATTEN_SURFACE_DERIVATIVE(total - l, l)] /=
                    across == BATTEN_V ? l + 1 : total - l + 1;
}

static double length(const bat_jet a[3])
{
    return bat_norm(3, (const double[3]){a[0].d[0], a[1].d[0], a[2].d[0]});
}

/* In place a / |a here|, so that products neither overflow nor vanish. */
static void tame(bat_jet a[3])
{
    const double size = length(a);
    for (int c = 0; c < 3; c++)
        for (int i = 0; i < BAT_JET_SIZE; i++)
            a[c].d[i] /= size;
}

static void unit_cross(bat_jet a[3], bat_jet b[3], double sign, bat_jet n[3])
{
    bat_jet square = bat_jet_constant(0);
    tame(a);
    tame(b);
    for (int c = 0; c < 3; c++) {
        const int i = (c + 1) % 3, j = (c + 2) % 3;
        n[c] = bat_jet_subtract(bat_jet_multiply(a[i], b[j]), bat_jet_multiply(a[j], b[i]));
    }
    tame(n);
    for (int c = 0; c < 3; c++)
        square = bat_jet_add(square, bat_jet_multiply(n[c], n[c]));
    const bat_jet norm = bat_jet_square_root(square);
    for (int c = 0; c < 3; c++)
        n[c] = bat_jet_scale(sign, bat_jet_divide(n[c], norm));
}

/* Do a and b, which are no roundoff, span a plane? */
static bool spans(const bat_jet a[3], const bat_jet b[3])
{
    const double la = length(a), lb = length(b);
    if (!(la > 0 && lb > 0))
        return false;
    const batten_vec3 x = {a[0].d[0] / la, a[1].d[0] / la, a[2].d[0] / la};
    const batten_vec3 y = {b[0].d[0] / lb, b[1].d[0] / lb, b[2].d[0] / lb};
    return bat_vec3_norm(bat_vec3_cross(x, y)) > BAT_LEAST_SINE;
}

/* At a collapsed edge; `noise` of Su and Sv. */
static batten_status limit_normal(const batten_surface *surface, const bat_surface_place *place,
                                  const double *values, const double noise[2], int order,
                                  bat_jet n[3])
{
    const double at[2] = {place->u, place->v};
    for (int k = 0; k < 2; k++) { /* the tangent that vanishes */
        const batten_direction across = bat_other((batten_direction)k);
        const batten_interval domain = batten_surface_domain(surface, across);
        bat_jet a[3], b[3];
        if (bat_norm(3, values + 3 * (1 + k)) > 2 * noise[k] ||
            (at[across] != domain.a && at[across] != domain.b))
            continue;
        take_quotient(values, across, order, a);
        take_jets(values, k == 1, k == 0, order, b);
        if (!spans(a, b))
            continue;
        /* Inside, Su is (v - b) T: with the sign of v - b. */
        const double sign = at[across] == domain.a ? 1 : -1;
        if (k == 0)
            unit_cross(a, b, sign, n);
        else
            unit_cross(b, a, sign, n);
        return BATTEN_OK;
    }
    return bat_fail(BATTEN_SINGULAR_HERE,
                    "the surface has no normal at (%.9g, %.9g): its tangents span no plane",
                    place->u, place->v);
}

/* Large and small numbers are brought near 1, for the squares in bat_regular_normal. */
static bool is_regular(const double *su, const double *sv, double noise_u, double noise_v)
{
    const double lu = bat_norm(3, su), lv = bat_norm(3, sv);
    double a[3], b[3], n[3];
    if (!(lu > 0 && lv > 0 && isfinite(lu) && isfinite(lv)))
        return false;
    for (int c = 0; c < 3; c++) {
        a[c] = su[c] / lu;
        b[c] = sv[c] / lv;
    }
    return bat_regular_normal(a, b, noise_u / lu, noise_v / lv, n);
}

/* The normal alone: the same bits as those of unit_cross. */
static void unit_normal(const double *su, const double *sv, bat_jet n[3])
{
    const double lu = bat_norm(3, su), lv = bat_norm(3, sv);
    double a[3], b[3], m[3];
    for (int c = 0; c < 3; c++) {
        a[c] = su[c] / lu;
        b[c] = sv[c] / lv;
    }
    for (int c = 0; c < 3; c++) {
        const int i = (c + 1) % 3, j = (c + 2) % 3;
        m[c] = a[i] * b[j] - a[j] * b[i];
    }
    const double size = bat_norm(3, m);
    for (int c = 0; c < 3; c++)
        m[c] /= size;
    const double norm = sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    for (int c = 0; c < 3; c++)
        n[c].d[0] = m[c] / norm;
}

batten_status bat_offset_point(const batten_surface *surface, double distance,
                               const bat_surface_place *at, int order, double *out)
{
    double values[MOST_VALUES], noise[2];
    bat_jet n[3], a[3], b[3];
    bat_surface_local local;
    batten_status status = surface->kind->evaluate(surface, at, order + 1, values);
    if (status != BATTEN_OK)
        return status;
    surface->kind->local(surface, at, &local);
    for (int k = 0; k < 2; k++)
        noise[k] = bat_derivative_noise(local.degree[k], local.span[k], local.largest);
    const bool regular = is_regular(values + 3, values + 6, noise[0], noise[1]);
    if (regular && order == 0) {
        unit_normal(values + 3, values + 6, n);
    } else if (regular) {
        take_jets(values, 1, 0, order, a);
        take_jets(values, 0, 1, order, b);
        unit_cross(a, b, 1, n);
    } else {
        status = surface->kind->evaluate(surface, at, order + 2, values);
        if (status == BATTEN_OK)
            status = limit_normal(surface, at, values, noise, order, n);
        if (status != BATTEN_OK)
            return status;
    }
    for (int i = 0; i < BATTEN_SURFACE_DERIVATIVES(order); i++)
        for (int c = 0; c < 3; c++)
            out[3 * i + c] = values[3 * i + c] + distance * n[c].d[i];
    return BATTEN_OK;
}
