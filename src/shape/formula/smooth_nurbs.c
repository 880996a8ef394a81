/* NURBS surfaces whose normals along their edges are near those of another one. */
#include "numeric/vector.h"
#include <batten/fill.h>

enum { PLACES = 128, ROUNDS = 8 };

static batten_status normal_at(const batten_surface *surface, double u, double v,
                               batten_vec3 *normal, bool *regular)
{
    double d[3][3];
    const batten_status status = batten_surface_evaluate(surface, u, v, 1, d[0]);
    if (status != BATTEN_OK)
        return status;
    *normal = bat_vec3_cross(bat_vec3_of(3, d[1]), bat_vec3_of(3, d[2]));
    /* Below this part of the product of speeds it is rounding. */
    *regular = bat_vec3_norm(*normal) > 1e-9 * bat_norm(3, d[1]) * bat_norm(3, d[2]);
    return BATTEN_OK;
}

static batten_status angle_along_edges(const batten_surface *a, const batten_surface *b,
                                       double *largest)
{
    const batten_interval u = batten_surface_domain(a, BATTEN_U);
    const batten_interval v = batten_surface_domain(a, BATTEN_V);
    *largest = 0;
    for (int edge = 0; edge < 4; edge++)
        for (int k = 0; k <= PLACES; k++) {
            const double t = (double)k / PLACES, high = edge % 2;
            const double x = edge < 2 ? t : high, y = edge < 2 ? high : t;
            const double at_u = (1 - x) * u.a + x * u.b, at_v = (1 - y) * v.a + y * v.b;
            batten_vec3 n, m;
            bool regular[2];
            batten_status status = normal_at(a, at_u, at_v, &n, &regular[0]);
            if (status == BATTEN_OK)
                status = normal_at(b, at_u, at_v, &m, &regular[1]);
            if (status != BATTEN_OK)
                return status;
            if (regular[0] && regular[1])
                *largest = bat_max(
                    *largest, atan2(bat_vec3_norm(bat_vec3_cross(n, m)), bat_vec3_dot(n, m)));
        }
    return BATTEN_OK;
}

batten_status batten_surface_to_smooth_nurbs(const batten_surface *surface, double tolerance,
                                             double angle, double *error, double *reached,
                                             batten_surface **out)
{
    if (batten_surface_dimension(surface) != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a surface of dimension %d has no normals",
                        batten_surface_dimension(surface));
    if (!(angle > 0) || !isfinite(angle))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the angle between normals is above 0, not %g",
                        angle);
    double turned = 0;
    for (int round = 0; round < ROUNDS; round++) {
        batten_surface *nurbs = NULL;
        double moved = 0;
        batten_status status = batten_surface_to_nurbs(surface, tolerance, &moved, &nurbs);
        if (status == BATTEN_OK)
            status = angle_along_edges(surface, nurbs, &turned);
        if (status == BATTEN_OK && turned <= angle) {
            *out = nurbs;
            if (error)
                *error = moved;
            if (reached)
                *reached = turned;
            return BATTEN_OK;
        }
        batten_surface_unref(nurbs);
        if (status != BATTEN_OK)
            return status;
        tolerance /= 8;
    }
    return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                    "normals along the edges stay %g degrees away, %g are allowed",
                    turned * 180 / BAT_PI, angle * 180 / BAT_PI);
}
