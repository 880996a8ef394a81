/* The outside of a corner of an offset: an arc, a mitre, or a mitre cut off. */
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <batten/standard.h>

/* A straight link through points [count][d]. */
static batten_status add_polyline(bat_offset *o, int count, const double *points)
{
    batten_curve *curve = NULL;
    const batten_status status =
        batten_curve_polyline((batten_points){o->full->dimension, count, points}, &curve);
    return bat_offset_add(o, status, curve);
}

/* The arc about p from q, turning by `turn`. */
static batten_status add_arc(bat_offset *o, const double *p, double turn, const double *q)
{
    const double radius = fabs(o->distance), start = bat_atan2(q[1] - p[1], q[0] - p[0]);
    const int d = o->full->dimension;
    /* A frame seen from below turns clockwise. */
    const batten_frame frame = {
        bat_vec3_of(d, p), {bat_cos(start), bat_sin(start), 0}, {0, 0, turn < 0 ? -1 : 1}};
    batten_curve *arc = NULL, *flat = NULL;
    batten_status status = batten_curve_arc_in(&frame, radius, 0, fabs(turn), &arc);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(arc, d, &flat);
    batten_curve_unref(arc);
    return bat_offset_add(o, status, flat);
}

/* The points at which the sides, extended by `further`, are left. */
static batten_status add_straight(bat_offset *o, const bat_offset_gap *at, double further,
                                  bool mitre)
{
    const int d = o->full->dimension;
    const double *t = at->t, *q = at->q, *r = at->r, c = bat_cos(at->turn),
                 s = bat_sin(at->turn);
    const double behind[2] = {c * t[0] - s * t[1], s * t[0] + c * t[1]};
    double points[4 * 3] = {0};
    for (int k = 0; k < d; k++) {
        points[k] = q[k];
        points[d + k] = q[k] + (k < 2 ? further * t[k] : 0);
        points[2 * d + k] = r[k] - (k < 2 ? further * behind[k] : 0);
        points[3 * d + k] = r[k];
    }
    if (!mitre)
        return add_polyline(o, 4, points);
    for (int k = 0; k < d; k++)
        points[2 * d + k] = points[3 * d + k];
    return add_polyline(o, 3, points);
}

batten_status bat_offset_corner(bat_offset *o, const bat_offset_gap *at)
{
    const double radius = fabs(o->distance), half = fabs(at->turn) / 2;
    const bool mitre = o->options.corners == BATTEN_OFFSET_MITRE &&
                       bat_cos(half) * o->options.mitre_limit >= 1;
    if (o->options.corners == BATTEN_OFFSET_ROUND)
        return add_arc(o, at->p, at->turn, at->q);
    return add_straight(o, at, radius * (mitre ? bat_tan(half) : bat_tan(half / 2)), mitre);
}
