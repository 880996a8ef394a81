/* The section of a surface square to an edge, as a graph over its tangent: three derivatives of it. */
#include "inspect/joins/across.h"

#include "numeric/vector.h"

/* Derivatives parallel to a few thousand roundings have no normal. */
static const double parallel = 1e-12;

enum { SU = 1, SV, SUU, SUV, SVV, SUUU, SUUV, SUVV, SVVV, ALL };

/* Two directions in the tangent plane, and the parameters that lead along the first of them. */
typedef struct {
    batten_vec3 into, along, normal;
    double u[2], v[2]; /* Su and Sv in both directions */
    double determinant;
} plane;

/* The step (a, b) in (u, v) of which a Su + b Sv is `wanted` in the tangent plane. */
static void solve(const plane *p, double into, double along, double step[2])
{
    step[0] = (into * p->v[1] - along * p->v[0]) / p->determinant;
    step[1] = (along * p->u[0] - into * p->u[1]) / p->determinant;
}

static bool lay_plane(const batten_vec3 *s, batten_vec3 along, batten_vec3 inward, plane *p)
{
    const batten_vec3 product = bat_vec3_cross(s[SU], s[SV]);
    const double area = bat_vec3_norm(product);
    if (!(area > parallel * bat_vec3_norm(s[SU]) * bat_vec3_norm(s[SV])))
        return false;
    p->normal = bat_vec3_scale(product, 1 / area);
    along = bat_vec3_along(along, -bat_vec3_dot(along, p->normal), p->normal);
    const double length = bat_vec3_norm(along);
    if (!(length > 0))
        return false;
    p->along = bat_vec3_scale(along, 1 / length);
    p->into = bat_vec3_cross(p->normal, p->along);
    if (bat_vec3_dot(p->into, inward) < 0)
        p->into = bat_vec3_scale(p->into, -1);
    p->u[0] = bat_vec3_dot(s[SU], p->into);
    p->u[1] = bat_vec3_dot(s[SU], p->along);
    p->v[0] = bat_vec3_dot(s[SV], p->into);
    p->v[1] = bat_vec3_dot(s[SV], p->along);
    p->determinant = p->u[0] * p->v[1] - p->u[1] * p->v[0];
    return p->determinant != 0;
}

/* The second derivative of the surface along (a, b). */
static batten_vec3 second_along(const batten_vec3 *s, double a, double b)
{
    return bat_vec3_along(bat_vec3_along(bat_vec3_scale(s[SUU], a * a), 2 * a * b, s[SUV]),
                          b * b, s[SVV]);
}

/* With (u, v) = x (a1, b1) + x^2 (a2, b2) the section stays over its tangent to the second order; the height of order
 * x^2 is half its curvature, that of order x^3 a sixth of its rate: the slope is 0 here. */
bool bat_across_edge(int dimension, const double *derivatives, batten_vec3 along,
                     batten_vec3 inward, bat_across *out)
{
    batten_vec3 s[ALL];
    plane p;
    double one[2], two[2];
    for (int i = 0; i < ALL; i++)
        s[i] = bat_vec3_of(dimension, derivatives + i * dimension);
    if (!lay_plane(s, along, inward, &p))
        return false;
    solve(&p, 1, 0, one);
    const double a = one[0], b = one[1];
    const batten_vec3 bend = second_along(s, a, b);
    solve(&p, -0.5 * bat_vec3_dot(bend, p.into), -0.5 * bat_vec3_dot(bend, p.along), two);
    const batten_vec3 twice = bat_vec3_add(
        bat_vec3_scale(s[SUU], a * two[0]),
        bat_vec3_along(bat_vec3_scale(s[SUV], a * two[1] + b * two[0]), b * two[1], s[SVV]));
    const batten_vec3 third = bat_vec3_add(
        bat_vec3_along(bat_vec3_scale(s[SUUU], a * a * a), 3 * a * a * b, s[SUUV]),
        bat_vec3_along(bat_vec3_scale(s[SUVV], 3 * a * b * b), b * b * b, s[SVVV]));
    const double rate = bat_vec3_dot(bat_vec3_along(third, 6, twice), p.normal);
    *out =
        (bat_across){p.into, p.normal, bat_vec3_scale(p.normal, bat_vec3_dot(bend, p.normal)),
                     bat_vec3_scale(p.normal, rate)};
    return true;
}
