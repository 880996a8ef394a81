/* The frames of a spine at one place, with their derivatives. */
#include "inspect/measure/frames.h"
#include "numeric/quadrature.h"
#include "shape/sweep/motion_spine.h"

#include <string.h>

enum {
    SUBSTEPS = 4, /* double reflections from a node to a place between nodes */
    GAUSS = 6     /* for the length between nodes */
};

/* ---- places ---- */

/* Point and derivatives of the spine, [order + 1][3]. */
static batten_status look_at_spine(const bat_spine_motion *m, double u, batten_side side,
                                   int order, double *out)
{
    return batten_curve_evaluate_side(m->spine, u, side, order, out);
}

batten_status bat_spine_tangent(const bat_spine_motion *m, double u, batten_side side,
                                batten_vec3 *point, batten_vec3 *tangent)
{
    double values[6];
    const batten_status status = look_at_spine(m, u, side, 1, values);
    if (status != BATTEN_OK)
        return status;
    *point = bat_vec3_of(3, values);
    *tangent = bat_vec3_of(3, values + 3);
    const double speed = bat_vec3_norm(*tangent);
    if (!(speed > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the spine has no tangent at %.17g", u);
    *tangent = bat_vec3_scale(*tangent, 1 / speed);
    return BATTEN_OK;
}

batten_status bat_spine_length(const bat_spine_motion *m, double a, double b, double *length)
{
    double nodes[GAUSS], weights[GAUSS], sum = 0;
    bat_gauss(GAUSS, nodes, weights);
    for (int i = 0; i < GAUSS && a < b; i++) {
        double values[6];
        const batten_status status =
            look_at_spine(m, a + (b - a) * (nodes[i] + 1) / 2, BATTEN_FROM_RIGHT, 1, values);
        if (status != BATTEN_OK)
            return status;
        sum += weights[i] * bat_norm(3, values + 3);
    }
    *length = sum * (b - a) / 2;
    return BATTEN_OK;
}

/* ---- frames ---- */

/* The minimising axis at u: carried on from the node before. */
static batten_status carry_axis(const bat_spine_motion *m, int node, double u, batten_side side,
                                batten_vec3 *x)
{
    batten_vec3 point[2], tangent[2];
    const double a = m->u[node];
    *x = m->x[node];
    batten_status status = bat_spine_tangent(m, a, BATTEN_FROM_RIGHT, &point[0], &tangent[0]);
    for (int i = 1; i <= SUBSTEPS && status == BATTEN_OK && a < u; i++) {
        const double at = i < SUBSTEPS ? a + (u - a) * i / SUBSTEPS : u;
        status = bat_spine_tangent(m, at, i < SUBSTEPS ? BATTEN_FROM_RIGHT : side, &point[1],
                                   &tangent[1]);
        if (status == BATTEN_OK)
            *x = bat_frame_carry(point[0], tangent[0], point[1], tangent[1], *x);
        point[0] = point[1];
        tangent[0] = tangent[1];
    }
    return status;
}

/* From the axis at v and the tangent's derivatives those of the axis, which turns about what is
 * across the tangent alone: x' = -(x . t') t. */
static bat_jet3 minimising_axis(batten_vec3 x, const bat_jet3 *tangent)
{
    static const double binomials[3][3] = {{1}, {1, 1}, {1, 2, 1}};
    batten_vec3 X[4] = {x}, T[4];
    double values[4][3], w[3];
    for (int k = 0; k < 4; k++)
        T[k] = bat_jet3_in_v(tangent, k);
    for (int k = 0; k < 3; k++) {
        w[k] = 0;
        for (int i = 0; i <= k; i++)
            w[k] += binomials[k][i] * bat_vec3_dot(X[i], T[k - i + 1]);
        X[k + 1] = (batten_vec3){0, 0, 0};
        for (int i = 0; i <= k; i++)
            X[k + 1] = bat_vec3_along(X[k + 1], -binomials[k][i] * w[i], T[k - i]);
    }
    for (int k = 0; k < 4; k++)
        memcpy(values[k], (double[3]){X[k].x, X[k].y, X[k].z}, sizeof values[k]);
    return bat_jet3_of_v(3, values[0]);
}

/* What of `direction` lies across the tangent, of length one. */
static batten_status across(bat_jet3 direction, bat_jet3 tangent, double u, const char *what,
                            bat_jet3 *out)
{
    const double size = bat_vec3_norm(bat_jet3_in_v(&direction, 0));
    if (size > 0) /* nearer to 1, so that squares are numbers */
        direction = bat_jet3_multiply(bat_jet_constant(1 / size), direction);
    const bat_jet3 rest = bat_jet3_subtract(
        direction, bat_jet3_multiply(bat_jet3_dot(direction, tangent), tangent));
    if (!(bat_vec3_norm(bat_jet3_in_v(&rest, 0)) > 1e-10))
        return bat_fail(BATTEN_SINGULAR_HERE, "%s at %.17g: there is no frame", what, u);
    *out = bat_jet3_unit(rest);
    return BATTEN_OK;
}

/* The way from the spine to the point of the guide with the same share of its parameters. */
static batten_status guide_direction(const bat_spine_motion *m, const bat_jet3 *point, double u,
                                     batten_side side, bat_jet3 *out)
{
    const batten_interval from = batten_curve_domain(m->spine),
                          to = batten_curve_domain(m->guide);
    const double rate = (to.b - to.a) / (from.b - from.a);
    double values[12];
    const double at = u < from.b ? to.a + rate * (u - from.a) : to.b;
    const batten_status status =
        batten_curve_evaluate_side(m->guide, bat_min(at, to.b), side, 3, values);
    if (status != BATTEN_OK)
        return status;
    double power = 1;
    for (int k = 1; k <= 3; k++) {
        power *= rate;
        for (int c = 0; c < 3; c++)
            values[3 * k + c] *= power;
    }
    *out = bat_jet3_subtract(bat_jet3_of_v(3, values), *point);
    return BATTEN_OK;
}

static batten_status fill_axes(const bat_spine_motion *m, const double *values, int node,
                               double u, batten_side side, bat_bare_frame *f)
{
    batten_status status = BATTEN_OK;
    if (m->has_up || m->guide) {
        bat_jet3 direction = bat_jet3_constant(m->up);
        if (m->guide)
            status = guide_direction(m, &f->point, u, side, &direction);
        if (status == BATTEN_OK)
            status = across(direction, f->z, u,
                            m->guide ? "the guide lies along the spine's tangent"
                                     : "the spine runs along its upward direction",
                            &f->y);
        f->x = bat_jet3_cross(f->y, f->z);
        return status;
    }
    if (m->kind == BATTEN_FRAME_FIXED) {
        f->x = bat_jet3_constant(m->fixed[0]);
        f->z = bat_jet3_constant(m->fixed[1]);
    } else if (m->kind == BATTEN_FRAME_FRENET) {
        status = across(bat_jet3_of_v(3, values + 6), f->z, u,
                        "the spine is straight, with Frenet frames,", &f->x);
    } else {
        batten_vec3 x;
        status = carry_axis(m, node, u, side, &x);
        if (status == BATTEN_OK)
            f->x = minimising_axis(x, &f->tangent);
    }
    if (status == BATTEN_OK)
        f->y = bat_jet3_cross(f->z, f->x);
    return status;
}

/* The frame without laws. */
batten_status bat_spine_frame(const bat_spine_motion *m, int node, double u, batten_side side,
                              bat_bare_frame *f)
{
    double values[18];
    batten_status status = look_at_spine(m, u, side, 5, values);
    if (status != BATTEN_OK)
        return status;
    const double speed = bat_norm(3, values + 3);
    if (!(speed > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the spine has no tangent at %.17g", u);
    f->point = bat_jet3_of_v(3, values);
    bat_jet3 slope = bat_jet3_of_v(3, values + 3);
    slope = bat_jet3_multiply(bat_jet_constant(1 / speed), slope);
    f->speed = bat_jet3_norm(slope);
    f->tangent = bat_jet3_multiply(bat_jet_divide(bat_jet_constant(1), f->speed), slope);
    f->speed = bat_jet_scale(speed, f->speed);
    f->z = f->tangent;
    return fill_axes(m, values, node, u, side, f);
}
