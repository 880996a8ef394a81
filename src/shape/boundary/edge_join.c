/* How a surface that was made joins the surface beside it: measured on both, and not on what it was made from. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/boundary/edge_fit.h"
#include <batten/nearest.h>

/* In every span of the edge, and at least on all of it; Newton's steps along the other edge, which square the error
 * each time. */
enum { IN_SPAN = 16, AT_LEAST = 256, STEPS = 8 };
/* Directions at less than this have no plane: next to a corner of which both sides go on smoothly a normal is noise. */
static const double parallel = 1e-4;

/* An edge that is measured against one of another surface. */
typedef struct {
    const batten_surface *surface, *beside;
    bat_edge_place here, there;
    batten_curve *edge; /* of the surface beside it, over the parameter along it */
    double foot;        /* where the last foot was */
} pair;

/* A surface at its edge: the direction along, the one inside or outside across, and second derivatives. */
typedef struct {
    batten_vec3 point, along, across, uu, uv, vv, normal;
    bool regular;
} view;

static batten_status see_edge(const batten_surface *surface, const bat_edge_place *place,
                              double t, double out, view *seen)
{
    const bool along_u = place->along == BATTEN_U;
    const batten_sides sides = {along_u ? BATTEN_FROM_RIGHT : place->side,
                                along_u ? place->side : BATTEN_FROM_RIGHT};
    double d[6][3];
    const batten_status status = batten_surface_evaluate_side(
        surface, along_u ? t : place->at, along_u ? place->at : t, sides, 2, d[0]);
    if (status != BATTEN_OK)
        return status;
    const double sign = out * place->outward;
    const int first = along_u ? 1 : 2, second = along_u ? 2 : 1;
    *seen = (view){.point = bat_vec3_of(3, d[0]),
                   .along = bat_vec3_of(3, d[first]),
                   .across = bat_vec3_scale(bat_vec3_of(3, d[second]), sign),
                   .uu = bat_vec3_of(3, d[along_u ? 3 : 5]),
                   .uv = bat_vec3_scale(bat_vec3_of(3, d[4]), sign),
                   .vv = bat_vec3_of(3, d[along_u ? 5 : 3])};
    const double u = bat_vec3_norm(seen->along), v = bat_vec3_norm(seen->across);
    seen->normal = bat_vec3_cross(seen->along, seen->across);
    const double area = bat_vec3_norm(seen->normal);
    seen->regular = area > parallel * u * v && bat_min(u, v) > BAT_MEANT_SAME * bat_max(u, v);
    seen->normal = bat_vec3_scale(seen->normal, seen->regular ? 1 / area : 0);
    return BATTEN_OK;
}

/* The foot of a point on the other edge: from the last foot, or from anywhere. */
static batten_status find_foot(pair *p, const double point[3])
{
    const batten_interval domain = batten_curve_domain(p->edge);
    double t = p->foot, d[9], step = HUGE_VAL;
    for (int k = 0; k < STEPS && fabs(step) > BAT_ROUNDING * (domain.b - domain.a); k++) {
        const batten_status status = batten_curve_evaluate(p->edge, t, 2, d);
        if (status != BATTEN_OK)
            return status;
        const double r[3] = {point[0] - d[0], point[1] - d[1], point[2] - d[2]};
        const double slope = bat_dot(3, d + 3, d + 3) - bat_dot(3, r, d + 6);
        const double next =
            bat_max(domain.a, bat_min(domain.b, t + bat_dot(3, r, d + 3) / slope));
        step = slope > 0 ? next - t : HUGE_VAL;
        if (!(slope > 0))
            break;
        t = next;
    }
    if (fabs(step) <= BAT_MEANT_SAME * (domain.b - domain.a)) {
        p->foot = t;
        return BATTEN_OK;
    }
    batten_deviation found;
    const batten_status status =
        batten_curve_deviation(p->edge, (batten_points){3, 1, point}, NULL, NULL, NULL, &found);
    if (status == BATTEN_OK)
        p->foot = found.at[0];
    return status;
}

/* The normal curvature in a direction of the tangent plane. */
static double curvature_along(const view *s, batten_vec3 direction, batten_vec3 normal)
{
    const double E = bat_vec3_dot(s->along, s->along), F = bat_vec3_dot(s->along, s->across);
    const double G = bat_vec3_dot(s->across, s->across), D = E * G - F * F;
    const double a = bat_vec3_dot(direction, s->along), b = bat_vec3_dot(direction, s->across);
    const double x = (G * a - F * b) / D, y = (E * b - F * a) / D;
    return x * x * bat_vec3_dot(s->uu, normal) + 2 * x * y * bat_vec3_dot(s->uv, normal) +
           y * y * bat_vec3_dot(s->vv, normal);
}

static batten_status measure_at(pair *p, double t, batten_edge_join *found)
{
    view s, r;
    batten_status status = see_edge(p->surface, &p->here, t, -1, &s);
    const double point[3] = {s.point.x, s.point.y, s.point.z};
    if (status == BATTEN_OK)
        status = find_foot(p, point);
    if (status == BATTEN_OK)
        status = see_edge(p->beside, &p->there, p->foot, 1, &r);
    if (status != BATTEN_OK)
        return status;
    found->gap = bat_max(found->gap, bat_vec3_norm(bat_vec3_subtract(s.point, r.point)));
    if (!s.regular || !r.regular)
        return BATTEN_OK;
    /* Edges that run against each other have the normal on the other side. */
    if (bat_vec3_dot(s.along, r.along) < 0)
        r.normal = bat_vec3_scale(r.normal, -1);
    const double angle = bat_atan2(bat_vec3_norm(bat_vec3_cross(s.normal, r.normal)),
                                   bat_vec3_dot(s.normal, r.normal));
    if (angle > found->angle) {
        found->angle = angle;
        found->at = s.point;
    }
    const batten_vec3 across = bat_vec3_cross(s.normal, s.along);
    const batten_vec3 unit = bat_vec3_scale(across, 1 / bat_vec3_norm(across));
    const double here = curvature_along(&s, unit, s.normal),
                 there = curvature_along(&r, unit, r.normal);
    found->curvature_difference = bat_max(found->curvature_difference, fabs(here - there));
    found->curvature = bat_max(found->curvature, fabs(there));
    return BATTEN_OK;
}

static batten_status measure_spans(pair *p, batten_edge_join *found)
{
    const int count = batten_surface_spans(p->surface, p->here.along, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(p->surface, p->here.along, knots);
    batten_status status = BATTEN_OK;
    const int places = bat_max_int(IN_SPAN, AT_LEAST / (count - 1));
    for (int k = 0; k <= (count - 1) * places && status == BATTEN_OK; k++) {
        /* Denser to the ends of each span, where splines that follow a twist are farthest off. */
        const int span = bat_min_int(k / places, count - 2);
        const double s = 0.5 - 0.5 * bat_cos((k - span * places) * BAT_PI / places);
        status = measure_at(p, (1 - s) * knots[span] + s * knots[span + 1], found);
    }
    bat_release(knots);
    return status;
}

batten_status batten_surface_edge_join(batten_surface_edge edge, const batten_surface *beside,
                                       double tolerance, batten_edge_join *out)
{
    pair p = {.surface = edge.surface,
              .beside = beside,
              .here = bat_edge_of(edge.surface, edge.edge)};
    batten_edge other = BATTEN_EDGE_V0;
    batten_edge_join found = {0};
    batten_curve *curve = NULL;
    double at[2];
    if (batten_surface_dimension(edge.surface) != 3 || batten_surface_dimension(beside) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface that is not in space has no normals");
    batten_status status = bat_take_edge(edge.surface, edge.edge, tolerance, &curve);
    if (status == BATTEN_OK)
        status = bat_edge_beside(beside, curve, tolerance, &other, at);
    if (status == BATTEN_OK)
        status = bat_take_edge(beside, other, tolerance, &p.edge);
    if (status == BATTEN_OK) {
        p.there = bat_edge_of(beside, other);
        p.foot = at[0];
        status = measure_spans(&p, &found);
    }
    batten_curve_unref(p.edge);
    batten_curve_unref(curve);
    if (status == BATTEN_OK)
        *out = found;
    return status;
}
