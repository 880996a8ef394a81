/* The edges of a developable surface at their parameters, and the warp between them along a ruling. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"
#include <batten/measure.h>

/* Directions on both sides of a knot that differ by more are a corner, radians. */
static const double corner = 1e-6;

static batten_status check_corners(const batten_curve *curve, const char *name)
{
    const int count = batten_curve_spans(curve, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(curve, knots);
    batten_status status = BATTEN_OK;
    for (int i = 1; i + 1 < count && status == BATTEN_OK; i++) {
        double left[6], right[6];
        status = batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_LEFT, 1, left);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate_side(curve, knots[i], BATTEN_FROM_RIGHT, 1, right);
        if (status != BATTEN_OK)
            break;
        double difference[3];
        const double a = bat_norm(3, left + 3), b = bat_norm(3, right + 3);
        for (int c = 0; c < 3; c++)
            difference[c] = left[3 + c] / a - right[3 + c] / b;
        if (a > 0 && b > 0 && bat_norm(3, difference) > corner)
            status = bat_fail(BATTEN_NOT_COMPATIBLE,
                              "the %s edge has a corner at %g; split it there and make a plate "
                              "for each part",
                              name, knots[i]);
    }
    bat_release(knots);
    return status;
}

batten_status bat_plate_edge_make(const batten_curve *curve, const char *name,
                                  bat_plate_edge *out)
{
    double lengths[BAT_EDGE_STEPS + 1];
    const batten_box box = batten_curve_box(curve);
    const double size = bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    out->curve = curve;
    /* A hundred times what quadrature rounds by: parameters by length then have nine digits. */
    batten_status status = check_corners(curve, name);
    if (status == BATTEN_OK)
        status = batten_curve_length(curve, 1e-11 * size, NULL, &out->length);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i <= BAT_EDGE_STEPS; i++)
        lengths[i] = out->length * i / BAT_EDGE_STEPS;
    status = batten_curve_at_length(curve, BAT_EDGE_STEPS + 1, lengths,
                                    BAT_MEANT_SAME * out->length, out->u);
    const batten_interval domain = batten_curve_domain(curve);
    out->u[0] = domain.a;
    out->u[BAT_EDGE_STEPS] = domain.b;
    for (int i = 0; i <= BAT_EDGE_STEPS && status == BATTEN_OK; i++) {
        double values[6];
        status = batten_curve_evaluate(curve, out->u[i], 1, values);
        const double speed = bat_norm(3, values + 3);
        if (status == BATTEN_OK && !(speed * (domain.b - domain.a) > BAT_MEANT_SAME * size))
            status = bat_fail(BATTEN_SINGULAR_HERE, "the %s edge has no tangent at %g", name,
                              out->u[i]);
        out->rate[i] = out->length / speed;
    }
    return status;
}

batten_status bat_plate_edge_at(const bat_plate_edge *edge, double x, bat_edge_place *out)
{
    const int i = bat_max_int(0, bat_min_int((int)(x * BAT_EDGE_STEPS), BAT_EDGE_STEPS - 1));
    const double f = x * BAT_EDGE_STEPS - i, a = edge->u[i], b = edge->u[i + 1];
    const double ra = edge->rate[i] / BAT_EDGE_STEPS, rb = edge->rate[i + 1] / BAT_EDGE_STEPS;
    /* The cubic of both values and rates. */
    const double u =
        a + f * (ra + f * (3 * (b - a) - 2 * ra - rb + f * (ra + rb - 2 * (b - a))));
    double values[6];
    out->u = bat_min(b, bat_max(a, u));
    const batten_status status = batten_curve_evaluate(edge->curve, out->u, 1, values);
    if (status != BATTEN_OK)
        return status;
    out->P = bat_vec3_of(3, values);
    out->T = bat_vec3_scale(bat_vec3_of(3, values + 3), 1 / bat_norm(3, values + 3));
    return BATTEN_OK;
}

bool bat_warp_of(const bat_edge_place *a, const bat_edge_place *b, double least, double *sine,
                 double *cosine)
{
    const batten_vec3 d = bat_vec3_subtract(b->P, a->P);
    const double length = bat_vec3_norm(d);
    if (!(length > least))
        return false;
    const batten_vec3 r = bat_vec3_scale(d, 1 / length);
    const batten_vec3 m = bat_vec3_cross(a->T, r), n = bat_vec3_cross(b->T, r);
    const double both = bat_vec3_norm(m) * bat_vec3_norm(n);
    if (!(both > BAT_ROUNDING))
        return false;
    *sine = bat_vec3_dot(r, bat_vec3_cross(m, n)) / both;
    *cosine = bat_vec3_dot(m, n) / both;
    return true;
}

batten_status bat_plate_warp(const bat_plate *plate, bat_pair at, bool *has, double *sine,
                             double *cosine)
{
    bat_edge_place a, b;
    batten_status status = bat_plate_edge_at(&plate->edge[0], at.x, &a);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[1], at.y, &b);
    if (status == BATTEN_OK)
        *has = bat_warp_of(&a, &b, BAT_MEANT_SAME * plate->size, sine, cosine);
    return status;
}
