/* A fill and what lies beside it, seen in one point, and how both differ. */
#include "numeric/vector.h"
#include "shape/fill/fill.h"
#include <string.h>

/* Below this part of the product of speeds, next to a corner where two sides meet smoothly, a
 * normal is noise of what the sides were approximated by. */
static const double flat = 1e-4;

static void see_normal(bat_fill_view *s)
{
    const batten_vec3 n = bat_vec3_cross(bat_vec3_of(3, s->u), bat_vec3_of(3, s->v));
    const double size = bat_vec3_norm(n);
    s->sine = size / (bat_norm(3, s->u) * bat_norm(3, s->v));
    s->regular = s->sine > flat;
    s->normal[0] = n.x / size;
    s->normal[1] = n.y / size;
    s->normal[2] = n.z / size;
}

batten_status bat_fill_see_surface(const batten_surface *surface, double u, double v,
                                   bat_fill_view *out)
{
    double d[6][3];
    const batten_status status = batten_surface_evaluate(surface, u, v, 2, d[0]);
    if (status != BATTEN_OK)
        return status;
    double *parts[6] = {out->point, out->u, out->v, out->uu, out->uv, out->vv};
    for (int k = 0; k < 6; k++)
        memcpy(parts[k], d[k], sizeof d[k]);
    out->bent = true;
    see_normal(out);
    return BATTEN_OK;
}

/* The ribbon, seen as a surface of which u runs along it. */
batten_status bat_fill_see_ribbon(const bat_fill_side *side, double t, batten_side from,
                                  bat_fill_view *out)
{
    double C[3][3], T[2][3];
    *out = (bat_fill_view){0};
    batten_status status = batten_curve_evaluate_side(side->curve, t, from, 2, C[0]);
    if (status == BATTEN_OK && side->slope)
        status = batten_curve_evaluate_side(side->slope, t, from, 1, T[0]);
    if (status == BATTEN_OK && side->bend)
        status = batten_curve_evaluate_side(side->bend, t, from, 0, out->vv);
    if (status != BATTEN_OK)
        return status;
    memcpy(out->point, C[0], sizeof C[0]);
    if (!side->slope)
        return BATTEN_OK;
    memcpy(out->u, C[1], sizeof C[1]);
    memcpy(out->v, T[0], sizeof T[0]);
    memcpy(out->uu, C[2], sizeof C[2]);
    memcpy(out->uv, T[1], sizeof T[1]);
    out->bent = side->bend != NULL;
    see_normal(out);
    return BATTEN_OK;
}

/* The normal curvature in a direction of the tangent plane. */
double bat_fill_curvature(const bat_fill_view *s, const double direction[3],
                          const double normal[3])
{
    const double E = bat_dot(3, s->u, s->u), F = bat_dot(3, s->u, s->v);
    const double G = bat_dot(3, s->v, s->v), a = bat_dot(3, direction, s->u);
    const double b = bat_dot(3, direction, s->v), D = E * G - F * F;
    const double x = (G * a - F * b) / D, y = (E * b - F * a) / D;
    return x * x * bat_dot(3, s->uu, normal) + 2 * x * y * bat_dot(3, s->uv, normal) +
           y * y * bat_dot(3, s->vv, normal);
}

static void keep_largest(double value, const double point[3], double *largest, double at[3])
{
    if (value > *largest) {
        *largest = value;
        memcpy(at, point, 3 * sizeof *at);
    }
}

/* Both sides of one point of an edge that runs along `along`. */
void bat_fill_compare(const bat_fill_view *s, const bat_fill_view *r, const double along[3],
                      batten_fill_edge *edge)
{
    keep_largest(bat_distance(3, s->point, r->point), s->point, &edge->gap, edge->gap_at);
    if (!s->regular || !r->regular)
        return;
    const batten_vec3 n = bat_vec3_of(3, s->normal), m = bat_vec3_of(3, r->normal);
    const double turned = bat_atan2(bat_vec3_norm(bat_vec3_cross(n, m)), bat_vec3_dot(n, m));
    edge->has_slope = true;
    keep_largest(turned, s->point, &edge->angle, edge->angle_at);
    if (!s->bent || !r->bent)
        return;
    batten_vec3 across = bat_vec3_cross(n, bat_vec3_of(3, along));
    across = bat_vec3_scale(across, 1 / bat_vec3_norm(across));
    const double direction[3] = {across.x, across.y, across.z};
    const double difference = bat_fill_curvature(s, direction, s->normal) -
                              bat_fill_curvature(r, direction, s->normal);
    edge->has_curvature = true;
    keep_largest(fabs(difference), s->point, &edge->curvature, edge->curvature_at);
}

double bat_fill_largest_curvature(const bat_fill_view *s)
{
    const double E = bat_dot(3, s->u, s->u), F = bat_dot(3, s->u, s->v);
    const double G = bat_dot(3, s->v, s->v), D = E * G - F * F;
    const double L = bat_dot(3, s->uu, s->normal), M = bat_dot(3, s->uv, s->normal);
    const double N = bat_dot(3, s->vv, s->normal);
    const double mean = (E * N - 2 * F * M + G * L) / (2 * D), gauss = (L * N - M * M) / D;
    return fabs(mean) + sqrt(bat_max(0, mean * mean - gauss));
}
