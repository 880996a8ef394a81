/* Circles, arcs and ellipses of a DXF file as curves. */
#include "exchange/dxf/round_curve.h"
#include "body/elementary/elementary.h"
#include "exchange/dxf/dxf.h"
#include "exchange/dxf/round.h"
#include "numeric/vector.h"

/* ---- from the entity to the curve ---- */

batten_vec3 bat_dxf_vector(const double v[3])
{
    return (batten_vec3){v[0], v[1], v[2]};
}

void bat_dxf_put_vector(batten_vec3 v, double out[3])
{
    out[0] = v.x + 0.0; /* no -0 */
    out[1] = v.y + 0.0;
    out[2] = v.z + 0.0;
}

/* The sweep from one angle to the other, above 0 and at most a turn. */
static double sweep_of(const double angles[2], double turn, double least)
{
    const double sweep = fmod(angles[1] - angles[0], turn);
    return sweep <= least ? sweep + turn : sweep;
}

static batten_status circle_curve(const bat_dxf_round *round, batten_curve **out)
{
    bat_conic circle = {.kind = BAT_ELLIPSE, .a = round->size, .b = round->size};
    if (!(circle.a > 0))
        return bat_fail(BATTEN_BAD_FORMAT, "its radius is %g", circle.a);
    circle.frame = bat_dxf_axes(bat_dxf_vector(round->normal));
    const batten_frame axes = circle.frame;
    const batten_vec3 y = bat_vec3_cross(axes.z, axes.x);
    circle.frame.origin = bat_vec3_along(
        bat_vec3_along(bat_vec3_scale(axes.x, round->centre[0]), round->centre[1], y),
        round->centre[2], axes.z);
    if (round->kind == BAT_DXF_CIRCLE)
        return bat_conic_between(&circle, 0, 2 * BAT_PI, out);
    const double start = fmod(round->angles[0], 360) * BAT_PI / 180;
    const double sweep = sweep_of(round->angles, 360, 0) * BAT_PI / 180;
    return bat_conic_between(&circle, start, start + sweep, out);
}

static batten_status ellipse_curve(const bat_dxf_round *round, batten_curve **out)
{
    bat_conic ellipse = {.kind = BAT_ELLIPSE};
    const batten_vec3 axis = bat_dxf_vector(round->axis);
    ellipse.frame = bat_dxf_axes(bat_dxf_vector(round->normal));
    ellipse.frame.origin = bat_dxf_vector(round->centre);
    const batten_vec3 flat =
        bat_vec3_along(axis, -bat_vec3_dot(axis, ellipse.frame.z), ellipse.frame.z);
    ellipse.a = bat_vec3_norm(flat);
    ellipse.b = round->size * ellipse.a;
    if (!(ellipse.a > 0 && ellipse.b > 0))
        return bat_fail(BATTEN_BAD_FORMAT, "its half axes are %g and %g", ellipse.a, ellipse.b);
    ellipse.frame.x = bat_vec3_scale(flat, 1 / ellipse.a);
    const double from = round->angles[0];
    /* Angles are written with 12 digits: what is nearer to the start is a whole turn. */
    return bat_conic_between(&ellipse, from, from + sweep_of(round->angles, 2 * BAT_PI, 1e-12),
                             out);
}

batten_status bat_dxf_round_curve(const bat_dxf_round *round, batten_curve **out)
{
    return round->kind == BAT_DXF_ELLIPSE ? ellipse_curve(round, out)
                                          : circle_curve(round, out);
}
