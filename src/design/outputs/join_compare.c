/* How smoothly ends of curves or edges of surfaces meet: gap, turn, step of the curvature. */
#include "design/outputs/joins.h"

#include <batten/continuity.h>

/* Points of an edge at which two surfaces are compared, at least, and steps of each span. */
#define JOIN_POINTS 17
#define SPAN_POINTS 4

/* The angle by which a way out of one shape turns on its way into the other. */
static double turn_between(batten_vec3 out_of, batten_vec3 into)
{
    return bat_atan2(bat_join_norm(bat_vec3_cross(out_of, into)), bat_vec3_dot(out_of, into));
}

/* |a - b| of two curvatures as a part of the larger one; what bulges by less than the tolerance
 * over the size of the shapes counts as straight. */
static double share_of_larger(batten_vec3 a, batten_vec3 b, double straight)
{
    const double larger = bat_max(bat_join_norm(a), bat_join_norm(b));
    return bat_join_gap(a, b) / bat_max(larger, straight);
}

batten_status bat_compare_curves(const batten_curve *a, int side_a, const batten_curve *b,
                                 int side_b, double tolerance, bat_join *join)
{
    batten_curve_continuity_options options = batten_curve_continuity_defaults();
    batten_continuity found;
    options.gap = tolerance;
    const batten_status status = batten_curves_continuity(
        a, side_a ? BATTEN_CURVE_END : BATTEN_CURVE_START, b,
        side_b ? BATTEN_CURVE_END : BATTEN_CURVE_START, &options, &found);
    if (status != BATTEN_OK)
        return status;
    join->g1 = found.angle;
    join->g2 = found.curvature_part;
    join->g3 = found.rate_difference;
    join->parametric = found.parametric;
    join->geometric = found.geometric;
    return BATTEN_OK;
}

/* ---- surfaces ---- */

/* How far a derivative goes over the whole domain in its direction. */
static double reach(const batten_surface *surface, batten_direction direction,
                    batten_vec3 derivative)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    return bat_join_norm(derivative) * (domain.b - domain.a);
}

/* The point of an edge at `t`, the direction there into the surface, square to the edge, and
 * the normal curvature in it as a vector; false where the surface is singular. */
static bool leave_surface(const batten_surface *surface, int side, double t, batten_vec3 *into,
                          batten_vec3 *curvature)
{
    const bool fixed_v = side >= 2, high = side % 2;
    const batten_interval domain =
        batten_surface_domain(surface, fixed_v ? BATTEN_V : BATTEN_U);
    const double fixed = high ? domain.b : domain.a;
    const int d = batten_surface_dimension(surface);
    double s[BATTEN_SURFACE_DERIVATIVES(2) * 3];
    if (batten_surface_evaluate(surface, fixed_v ? t : fixed, fixed_v ? fixed : t, 2, s) !=
        BATTEN_OK)
        return false;
    const batten_vec3 su = bat_vec3_of(d, s + d), sv = bat_vec3_of(d, s + 2 * d);
    const batten_vec3 suu = bat_vec3_of(d, s + 3 * d), suv = bat_vec3_of(d, s + 4 * d),
                      svv = bat_vec3_of(d, s + 5 * d);
    const batten_vec3 across = fixed_v ? sv : su, along = fixed_v ? su : sv;
    const batten_vec3 across2 = fixed_v ? svv : suu, along2 = fixed_v ? suu : svv;
    const batten_vec3 product = bat_vec3_cross(su, sv);
    const double area = bat_join_norm(product), g = bat_vec3_dot(along, along);
    /* At a pole one of them is rounding. */
    const double u_reach = reach(surface, BATTEN_U, su), v_reach = reach(surface, BATTEN_V, sv);
    if (!(bat_min(u_reach, v_reach) > 1e-9 * bat_max(u_reach, v_reach)))
        return false;
    /* Derivatives parallel to a few thousand roundings have no normal. */
    if (!(area > 1e-12 * bat_join_norm(su) * bat_join_norm(sv)) || !(g > 0))
        return false;
    /* x = (across - f along) / length: square to the edge, a unit vector in the tangent plane.
     */
    const double f = bat_vec3_dot(across, along) / g;
    const batten_vec3 square = bat_vec3_along(across, -f, along);
    const double length = bat_join_norm(square);
    const batten_vec3 n = bat_vec3_scale(product, 1 / area);
    const batten_vec3 second =
        bat_vec3_along(bat_vec3_along(across2, -2 * f, suv), f * f, along2);
    *into = bat_vec3_scale(square, (high ? -1 : 1) / length);
    *curvature = bat_vec3_scale(n, bat_vec3_dot(second, n) / (length * length));
    return true;
}

batten_status bat_edge_curve(const batten_surface *surface, int side, batten_curve **out)
{
    const batten_direction direction = side < 2 ? BATTEN_U : BATTEN_V;
    const batten_interval domain = batten_surface_domain(surface, direction);
    return batten_surface_isocurve(surface, direction, side % 2 ? domain.b : domain.a, out);
}

/* A surface, one of its sides, the edge there, and the spans of it. */
typedef struct {
    const batten_surface *surface;
    int side;
    batten_curve *curve;
    int spans;
    double *breaks;       /* [spans + 1] */
    batten_curve **parts; /* [spans] */
} surface_side;

static void release_side(surface_side *side)
{
    for (int k = 0; side->parts && k < side->spans; k++)
        batten_curve_unref(side->parts[k]);
    bat_release(side->parts);
    bat_release(side->breaks);
    batten_curve_unref(side->curve);
}

static batten_status lay_side(const batten_surface *surface, int side, surface_side *out)
{
    *out = (surface_side){surface, side, NULL, 0, NULL, NULL};
    const batten_status status = bat_edge_curve(surface, side, &out->curve);
    if (status != BATTEN_OK)
        return status;
    out->spans = batten_curve_spans(out->curve, NULL) - 1;
    out->breaks = bat_array((size_t)out->spans + 1, sizeof *out->breaks);
    if (!out->breaks)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(out->curve, out->breaks);
    return BATTEN_OK;
}

static batten_status cut_spans(surface_side *side)
{
    batten_status status = BATTEN_OK;
    side->parts = bat_array((size_t)side->spans, sizeof *side->parts);
    if (!side->parts)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < side->spans && status == BATTEN_OK; k++)
        status = batten_curve_subrange(side->curve, side->breaks[k], side->breaks[k + 1],
                                       &side->parts[k]);
    return status;
}

/* A parameter within a span: its end belongs to the span, not to that which follows. */
static double within_span(const surface_side *side, int k, double t)
{
    return t < side->breaks[k + 1] || k + 1 == side->spans
               ? t
               : nextafter(side->breaks[k + 1], side->breaks[k]);
}

/* One surface at one place of its edge. */
typedef struct {
    double p[3];
    int dimension;
    batten_vec3 into, curvature;
} edge_place;

/* Tangent planes that turn by less than this do not tell two feet apart. */
#define SAME_TURN 1e-6

/* The foot of a place on one span of the other edge; kept in `best` (the turn and the share)
 * when no foot before agreed better. */
static batten_status compare_foot(const edge_place *place, const surface_side *b, int k,
                                  double tolerance, double straight, double best[2])
{
    const batten_box box = batten_curve_box(b->parts[k]);
    if (!bat_join_is_in(&box, bat_vec3_of(place->dimension, place->p), tolerance))
        return BATTEN_OK;
    batten_deviation foot;
    const batten_status status = batten_curve_deviation(
        b->parts[k], (batten_points){place->dimension, 1, place->p}, NULL, NULL, NULL, &foot);
    batten_vec3 into, curvature;
    if (status != BATTEN_OK || foot.max > tolerance ||
        !leave_surface(b->surface, b->side, within_span(b, k, foot.at[0]), &into, &curvature))
        return status;
    const double turn = turn_between(bat_vec3_scale(place->into, -1), into);
    const double share = share_of_larger(place->curvature, curvature, straight);
    const bool is_better = !(turn >= best[0] - SAME_TURN);
    if (is_better || (turn <= best[0] + SAME_TURN && share < best[1])) {
        best[0] = turn;
        best[1] = share;
    }
    return BATTEN_OK;
}

/* Both surfaces at one place of the edge of the first. Where an edge is closed, has a corner or
 * crosses itself, several places of it are one point with several tangent planes: of all feet
 * within the tolerance that counts which agrees best. */
static batten_status compare_at(const surface_side *a, double t, const surface_side *b,
                                double tolerance, double straight, bat_join *join)
{
    edge_place place = {.dimension = batten_curve_dimension(a->curve)};
    batten_deviation foot;
    double best[2] = {NAN, NAN};
    batten_status status = batten_curve_evaluate(a->curve, t, 0, place.p);
    if (status == BATTEN_OK)
        status = batten_curve_deviation(b->curve, (batten_points){place.dimension, 1, place.p},
                                        NULL, NULL, NULL, &foot);
    if (status != BATTEN_OK)
        return status;
    join->g0 = bat_max(join->g0, foot.max);
    if (!leave_surface(a->surface, a->side, t, &place.into, &place.curvature))
        return BATTEN_OK;
    for (int k = 0; k < b->spans && status == BATTEN_OK; k++)
        status = compare_foot(&place, b, k, tolerance, straight, best);
    join->g1 = fmax(join->g1, best[0]);
    join->g2 = fmax(join->g2, best[1]);
    return status;
}

/* Tangent planes at common points, and, where these agree, curvature across the edge: by the
 * linkage curve theorem [PW92] two surfaces with one tangent plane along an edge have one
 * curvature when they have it in one direction across. Each span is looked at with both its
 * ends, so that nothing narrow is missed; at the first point that is off by more than the
 * tolerance it ends. */
batten_status bat_compare_surfaces(const batten_surface *a, int side_a, const batten_surface *b,
                                   int side_b, double tolerance, double straight,
                                   bat_join *join)
{
    surface_side first = {0}, second = {0};
    batten_status status = lay_side(a, side_a, &first);
    if (status == BATTEN_OK)
        status = lay_side(b, side_b, &second);
    if (status == BATTEN_OK)
        status = cut_spans(&second);
    const int steps =
        first.spans > 0 ? bat_max_int(SPAN_POINTS, (JOIN_POINTS - 1) / first.spans) : 1;
    join->g1 = join->g2 = join->g3 = NAN;
    join->g0 = 0;
    for (int i = 0; i < first.spans * (steps + 1) && status == BATTEN_OK; i++) {
        const int k = i / (steps + 1);
        const double share = (double)(i % (steps + 1)) / steps;
        const double t = (1 - share) * first.breaks[k] + share * first.breaks[k + 1];
        status =
            compare_at(&first, within_span(&first, k, t), &second, tolerance, straight, join);
        if (join->g0 > tolerance)
            break;
    }
    release_side(&first);
    release_side(&second);
    return status;
}
