/* How smoothly ends of curves or edges of surfaces meet: gap, turn, steps of the curvature and of its rate. */
#include "inspect/joins/joins.h"

#include "numeric/vector.h"
#include <batten/nearest.h>

batten_status bat_join_of_curves(const batten_curve *a, int side_a, const batten_curve *b,
                                 int side_b, const batten_curve_continuity_options *bounds,
                                 batten_join *join)
{
    const batten_interval domain = batten_curve_domain(a);
    const int d = batten_curve_dimension(a);
    batten_continuity found;
    double p[3];
    batten_status status = batten_curves_continuity(
        a, side_a ? BATTEN_CURVE_END : BATTEN_CURVE_START, b,
        side_b ? BATTEN_CURVE_END : BATTEN_CURVE_START, bounds, &found);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(a, side_a ? domain.b : domain.a, 0, p);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 at = bat_vec3_of(d, p);
    join->gap = (batten_join_worst){found.gap, at};
    join->angle = (batten_join_worst){found.angle, at};
    join->curvature = (batten_join_worst){found.curvature_part, at};
    join->rate = (batten_join_worst){found.rate_part, at};
    join->curvature_difference = found.curvature_difference;
    join->rate_difference = found.rate_difference;
    join->parametric = found.parametric;
    join->geometric = found.geometric;
    return BATTEN_OK;
}

batten_status bat_side_curve(const batten_surface *surface, int side, batten_curve **out)
{
    const batten_direction direction = side < 2 ? BATTEN_U : BATTEN_V;
    const batten_interval domain = batten_surface_domain(surface, direction);
    return batten_surface_isocurve(surface, direction, side % 2 ? domain.b : domain.a, out);
}

/* ---- one side of a surface ---- */

/* A surface, one of its sides, the edge there, and the spans of it. */
typedef struct {
    const batten_surface *surface;
    int side, dimension;
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
    *out =
        (surface_side){surface, side, batten_surface_dimension(surface), NULL, 0, NULL, NULL};
    const batten_status status = bat_side_curve(surface, side, &out->curve);
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

/* How far a derivative goes over the whole domain in its direction. */
static double reach(const batten_surface *surface, batten_direction direction,
                    batten_vec3 derivative)
{
    const batten_interval domain = batten_surface_domain(surface, direction);
    return bat_vec3_norm(derivative) * (domain.b - domain.a);
}

/* The way from the edge into the surface; false where the surface is singular. */
static bool look_across(const surface_side *side, int span, double t, bat_across *out)
{
    const bool fixed_v = side->side >= 2, high = side->side % 2;
    const batten_interval domain =
        batten_surface_domain(side->surface, fixed_v ? BATTEN_V : BATTEN_U);
    const double fixed = high ? domain.b : domain.a, at = within_span(side, span, t);
    double s[BATTEN_SURFACE_DERIVATIVES(3) * 3];
    if (batten_surface_evaluate(side->surface, fixed_v ? at : fixed, fixed_v ? fixed : at, 3,
                                s) != BATTEN_OK)
        return false;
    const batten_vec3 su = bat_vec3_of(side->dimension, s + side->dimension),
                      sv = bat_vec3_of(side->dimension, s + 2 * side->dimension);
    /* At a pole one of them is rounding. */
    const double u_reach = reach(side->surface, BATTEN_U, su),
                 v_reach = reach(side->surface, BATTEN_V, sv);
    if (!(bat_min(u_reach, v_reach) > 1e-9 * bat_max(u_reach, v_reach)))
        return false;
    return bat_across_edge(side->dimension, s, fixed_v ? su : sv,
                           bat_vec3_scale(fixed_v ? sv : su, high ? -1 : 1), out);
}

/* ---- both sides ---- */

typedef struct {
    surface_side first, second;
    double tolerance;
    bat_straight straight;
} edge_pair;

/* Tangent planes that turn by less than this do not tell two feet apart. */
#define SAME_TURN 1e-6

/* One surface at one place of its edge. */
typedef struct {
    double p[3];
    bool is_regular;
    bat_across across;
} edge_place;

/* The foot of a place on one span of the other edge; kept when no foot before agreed better. */
static batten_status compare_foot(const edge_place *place, const edge_pair *pair, int k,
                                  bat_meeting *best)
{
    const surface_side *b = &pair->second;
    bat_across across;
    bat_meeting m = *best;
    batten_deviation foot;
    const batten_status status = batten_curve_deviation(
        b->parts[k], (batten_points){b->dimension, 1, place->p}, NULL, NULL, NULL, &foot);
    if (status != BATTEN_OK)
        return status;
    best->gap = fmin(best->gap, foot.max);
    if (!place->is_regular || foot.max > pair->tolerance ||
        !look_across(b, k, foot.at[0], &across))
        return BATTEN_OK;
    bat_meeting_compare(&place->across, &across, &pair->straight, &m);
    const bool is_better = !(m.angle >= best->angle - SAME_TURN);
    if (is_better || (m.angle <= best->angle + SAME_TURN && m.curvature < best->curvature)) {
        m.gap = best->gap;
        *best = m;
    }
    return BATTEN_OK;
}

/* Both surfaces at one place of the edge of the first. Where an edge is closed, has a corner or
 * crosses itself, several places of it are one point with several tangent planes: of all feet
 * within the tolerance that counts which agrees best. */
static batten_status meet_at(const void *context, int span, double t, bat_meeting *out)
{
    const edge_pair *pair = context;
    const surface_side *b = &pair->second;
    edge_place place;
    batten_deviation foot;
    batten_status status = batten_curve_evaluate(pair->first.curve, t, 0, place.p);
    if (status != BATTEN_OK)
        return status;
    place.is_regular = look_across(&pair->first, span, t, &place.across);
    out->point = bat_vec3_of(b->dimension, place.p);
    for (int k = 0; k < b->spans && status == BATTEN_OK; k++) {
        const batten_box box = batten_curve_box(b->parts[k]);
        if (bat_join_is_in(&box, out->point, pair->tolerance))
            status = compare_foot(&place, pair, k, out);
    }
    if (status == BATTEN_OK && isnan(out->gap)) {
        status = batten_curve_deviation(b->curve, (batten_points){b->dimension, 1, place.p},
                                        NULL, NULL, NULL, &foot);
        out->gap = foot.max;
    }
    return status;
}

static double size_of(const batten_surface *surface)
{
    const batten_box box = batten_surface_box(surface);
    return bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
}

/* By the linkage curve theorem [PW92] two surfaces with one tangent plane along an edge have one
 * curvature when they have it in one direction across; and so for the rates of those with one
 * curvature. */
batten_status bat_join_of_surfaces(const batten_surface *a, int side_a, const batten_surface *b,
                                   int side_b, const batten_curve_continuity_options *bounds,
                                   batten_join *join)
{
    const double size = bat_max(size_of(a), size_of(b));
    edge_pair pair = {.tolerance = bounds->gap,
                      .straight = bat_straight_within(bounds->gap, size)};
    batten_status status = lay_side(a, side_a, &pair.first);
    if (status == BATTEN_OK)
        status = lay_side(b, side_b, &pair.second);
    if (status == BATTEN_OK)
        status = cut_spans(&pair.second);
    const bat_edge_walk walk = {meet_at, &pair, pair.first.spans, pair.first.breaks};
    if (status == BATTEN_OK)
        status = bat_follow_edge(&walk, bounds, join);
    join->parametric = -1;
    release_side(&pair.first);
    release_side(&pair.second);
    return status;
}
