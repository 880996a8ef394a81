/* Surfaces that keep tangent planes as splines. */
#include "design/shared/smooth.h"

#include <batten/fill.h>
#include <stdio.h>

/* What is less than that is exact but for rounding: a ten-millionth of a degree. */
static const double exact = 1e-7 * BAT_PI / 180;

static void remark_angles(const bat_run *run, const double *angles, const bat_smooth_wish *wish)
{
    char text[4 * 200] = "";
    size_t used = 0;
    double largest = 0;
    for (int e = 0; e < 4; e++) {
        if (!wish->names[e])
            continue;
        largest = bat_max(largest, angles[e]);
        const int added =
            snprintf(text + used, sizeof text - used, "%s%.100s %.2g", used > 0 ? ", " : "",
                     wish->names[e], angles[e] * 180 / BAT_PI);
        used += (size_t)bat_max_int(0, bat_min_int(added, 199));
    }
    if (largest > exact)
        bat_remark(run, "tangent planes along the edges are kept to %.2g degrees (%s)",
                   largest * 180 / BAT_PI, text);
}

batten_status bat_put_smooth_surface(bat_run *run, batten_status status,
                                     batten_surface *surface, const bat_smooth_wish *wish)
{
    batten_surface *nurbs = NULL;
    double error = 0, angles[4];
    if (status == BATTEN_OK)
        status = batten_surface_to_smooth_nurbs(surface, wish->within, wish->angle, &error,
                                                NULL, &nurbs);
    if (status == BATTEN_OK)
        status = batten_surface_edge_angles(surface, nurbs, angles);
    if (status == BATTEN_OK) {
        if (error > 0)
            bat_report_error(run, error, error);
        remark_angles(run, angles, wish);
    }
    batten_surface_unref(surface);
    return bat_put_surface(run, status, nurbs);
}
