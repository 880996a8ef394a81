/* Where two rails are at the same height along a direction, and how they go on from there. */
#include "shape/sweep/rail_heights.h"
#include "numeric/jet3.h"

enum { HALVINGS = 200 };

/* ---- matching ---- */

batten_status bat_rail_height(const bat_between *m, int rail, double u, double *height)
{
    double at[3];
    const batten_status status = batten_curve_evaluate(m->rails[rail], u, 0, at);
    *height = bat_vec3_dot(bat_vec3_of(3, at), m->across);
    return status;
}

static batten_status find_height(const bat_between *m, int rail, double height, double *u)
{
    batten_interval where = batten_curve_domain(m->rails[rail]);
    double low = 0, high = 0, at = 0;
    batten_status status = bat_rail_height(m, rail, where.a, &low);
    if (status == BATTEN_OK)
        status = bat_rail_height(m, rail, where.b, &high);
    if (height <= low || height >= high) {
        *u = height <= low ? where.a : where.b;
        return status;
    }
    for (int i = 0; status == BATTEN_OK && i < HALVINGS; i++) {
        const double middle = where.a + (where.b - where.a) / 2;
        if (!(where.a < middle && middle < where.b))
            break;
        status = bat_rail_height(m, rail, middle, &at);
        if (at <= height)
            where.a = middle;
        else
            where.b = middle;
    }
    *u = where.a;
    return status;
}

/* From derivatives of the height in u those of u in the height, times powers of `range`. */
static void invert_derivatives(const double *f, double range, double *u)
{
    const double r = range / f[1];
    const double f2 = f[2] / f[1], f3 = f[3] / f[1], f4 = f[4] / f[1];
    u[1] = r;
    u[2] = -f2 * r * r;
    u[3] = (3 * f2 * f2 - f3) * r * r * r;
    u[4] = (10 * f2 * f3 - 15 * f2 * f2 * f2 - f4) * r * r * r * r;
}

/* Derivatives of a curve whose parameter goes as u[0..4]: the chain rule. */
static void apply_chain_rule(const double *c, const double *u, double *out)
{
    for (int k = 0; k < 3; k++) {
        const double c1 = c[3 + k], c2 = c[6 + k], c3 = c[9 + k], c4 = c[12 + k];
        out[k] = c[k];
        out[3 + k] = c1 * u[1];
        out[6 + k] = c2 * u[1] * u[1] + c1 * u[2];
        out[9 + k] = c3 * u[1] * u[1] * u[1] + 3 * c2 * u[1] * u[2] + c1 * u[3];
        out[12 + k] = c4 * u[1] * u[1] * u[1] * u[1] + 6 * c3 * u[1] * u[1] * u[2] +
                      c2 * (3 * u[2] * u[2] + 4 * u[1] * u[3]) + c1 * u[4];
    }
}

batten_status bat_rail_look(const bat_between *m, int rail, double v, batten_side side,
                            double *out)
{
    const batten_interval domain = batten_curve_domain(m->rails[rail]);
    double u[5] = {v < 1 ? (1 - v) * domain.a + v * domain.b : domain.b, domain.b - domain.a};
    double values[15], f[5];
    batten_status status = BATTEN_OK;
    if (m->by_planes)
        status = find_height(m, rail, (1 - v) * m->heights[0] + v * m->heights[1], &u[0]);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate_side(m->rails[rail], u[0], side, 4, values);
    if (status != BATTEN_OK)
        return status;
    if (m->by_planes) {
        for (int k = 0; k < 5; k++)
            f[k] = bat_vec3_dot(bat_vec3_of(3, values + 3 * k), m->across);
        if (!(f[1] > 0))
            return bat_fail(BATTEN_SINGULAR_HERE,
                            "rail %d does not rise at %.17g of its parameters", rail + 1, u[0]);
        invert_derivatives(f, m->heights[1] - m->heights[0], u);
    }
    apply_chain_rule(values, u, out);
    return BATTEN_OK;
}
