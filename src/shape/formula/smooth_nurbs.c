/* NURBS surfaces whose normals along their edges are near those of another one. */
#include "base/plural.h"
#include "shape/formula/formula.h"

#include "numeric/vector.h"
#include <batten/fill.h>

/* More control points than that are no answer to an angle. */
enum { MOST_POINTS = 250000 };

static batten_status largest_angle(const batten_surface *a, const batten_surface *b,
                                   double *largest)
{
    double angles[4] = {0};
    const batten_status status = batten_surface_edge_angles(a, b, angles);
    *largest = bat_max(bat_max(angles[0], angles[1]), bat_max(angles[2], angles[3]));
    return status;
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
    double turned = 0, moved = 0;
    batten_surface *nurbs = NULL;
    batten_status status = batten_surface_to_nurbs(surface, tolerance, &moved, &nurbs);
    if (status == BATTEN_OK)
        status = largest_angle(surface, nurbs, &turned);
    if (status == BATTEN_OK && turned > angle) {
        batten_surface_unref(nurbs);
        nurbs = NULL;
        status = bat_surface_approximate_smooth(surface, tolerance, angle, MOST_POINTS, &nurbs,
                                                &moved);
        if (status == BATTEN_OK)
            status = largest_angle(surface, nurbs, &turned);
    }
    if (status == BATTEN_OK && turned > angle)
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET,
                          "normals along the edges stay %g degree%s away, %g are allowed",
                          turned * 180 / BAT_PI, bat_plural_real(turned * 180 / BAT_PI, 6),
                          angle * 180 / BAT_PI);
    if (status != BATTEN_OK) {
        batten_surface_unref(nurbs);
        return status;
    }
    *out = nurbs;
    if (error)
        *error = moved;
    if (reached)
        *reached = turned;
    return BATTEN_OK;
}
