/* Surfaces that keep tangent planes as splines. */
#include "design/shared/smooth.h"
#include "base/plural.h"
#include "numeric/vector.h"

#include <batten/fill.h>
#include <stdio.h>

#define DEGREES (180 / BAT_PI)

/* What is less than that is exact but for rounding: a ten-millionth of a degree. */
static const double exact = 1e-7 / DEGREES;

/* Figures, edge by edge. */
typedef struct {
    char text[4 * 200];
    size_t used;
    double largest;
    int worst;
} figures;

static void add_figure(figures *all, int edge, const char *name, double value)
{
    const int added =
        batten_text_print(all->text + all->used, sizeof all->text - all->used, "%s%.100s %.2g",
                          all->used > 0 ? ", " : "", name, value);
    all->used += (size_t)bat_max_int(0, bat_min_int(added, 199));
    if (value > all->largest) {
        all->largest = value;
        all->worst = edge;
    }
}

/* Of the spline from the formula that it stands for. */
static void remark_angles(const bat_run *run, const double *angles, const bat_smooth_wish *wish)
{
    figures all = {.used = 0};
    for (int e = 0; e < 4; e++)
        if (wish->names[e])
            add_figure(&all, e, wish->names[e], angles[e] * DEGREES);
    if (all.largest > exact * DEGREES)
        bat_remark(run,
                   "the spline keeps the tangent planes of the patch along its edges to %.2g "
                   "degree%s (%s)",
                   all.largest, bat_plural_real(all.largest, 2), all.text);
}

/* ---- the surfaces beside it ---- */

static batten_status measure_joins(const batten_surface *nurbs, const bat_smooth_wish *wish,
                                   batten_edge_join joins[4])
{
    /* Edge and curve, curve and patch, patch and spline may be apart by that, each once at most. */
    const double apart = 4 * wish->within;
    batten_status status = BATTEN_OK;
    for (int e = 0; e < 4 && status == BATTEN_OK; e++)
        if (wish->beside[e])
            status = batten_surface_edge_join((batten_surface_edge){nurbs, (batten_edge)e},
                                              wish->beside[e], apart, &joins[e]);
    return status;
}

/* The angles; those beyond what was asked for are refused, unless slopes are known to give way. */
static batten_status tell_angles(const bat_run *run, const batten_edge_join joins[4],
                                 const bat_smooth_wish *wish)
{
    figures all = {.used = 0};
    for (int e = 0; e < 4; e++)
        if (wish->beside[e])
            add_figure(&all, e, wish->names[e], joins[e].angle * DEGREES);
    const double asked = wish->angle * DEGREES;
    const batten_vec3 at = joins[all.worst].at;
    if (all.largest > asked && bat_argument_of(run, "angle")->given && !wish->gives_way)
        return bat_fail(
            BATTEN_TOLERANCE_NOT_MET,
            "the surface is up to %.3g degree%s off the tangent planes along %s, near "
            "(%.6g, %.6g, %.6g), and %.3g are allowed: let its curves leave within "
            "these planes, or take a smaller 'within' or a larger 'angle'",
            all.largest, bat_plural_real(all.largest, 3), wish->names[all.worst], at.x, at.y,
            at.z, asked);
    if (all.largest > asked)
        bat_note(run,
                 "the surface is up to %.3g degree%s off the tangent planes along %s, near "
                 "(%.6g, %.6g, %.6g)",
                 all.largest, bat_plural_real(all.largest, 3), wish->names[all.worst], at.x,
                 at.y, at.z);
    else if (all.largest > exact * DEGREES)
        bat_remark(run,
                   "tangent planes of the surfaces beside it are kept to %.2g degree%s (%s)",
                   all.largest, bat_plural_real(all.largest, 2), all.text);
    return BATTEN_OK;
}

static void tell_curvatures(const bat_run *run, const batten_surface *surface,
                            const batten_edge_join joins[4], const bat_smooth_wish *wish)
{
    figures all = {.used = 0};
    const batten_box box = batten_surface_box(surface);
    double there = 1 / bat_vec3_norm(bat_vec3_subtract(box.high, box.low));
    for (int e = 0; e < 4; e++)
        if (wish->beside[e] && wish->curvature) {
            add_figure(&all, e, wish->names[e], joins[e].curvature_difference);
            there = bat_max(there, joins[e].curvature);
        }
    /* A millionth of the curvature, or of one that is as large as the surface, is rounding. */
    if (all.largest > 1e-6 * there)
        bat_remark(run,
                   "curvatures across the edges differ by up to %.2g per unit of length from "
                   "those of the surfaces beside it (%s)",
                   all.largest, all.text);
}

batten_status bat_put_smooth_surface(bat_run *run, batten_status status,
                                     batten_surface *surface, const bat_smooth_wish *wish)
{
    batten_surface *nurbs = NULL;
    double error = 0, angles[4];
    batten_edge_join joins[4] = {{0}};
    const bool beside =
        wish->beside[0] || wish->beside[1] || wish->beside[2] || wish->beside[3];
    if (status == BATTEN_OK)
        status = batten_surface_to_smooth_nurbs(surface, wish->within, wish->angle, &error,
                                                NULL, &nurbs);
    if (status == BATTEN_OK)
        status = beside ? measure_joins(nurbs, wish, joins)
                        : batten_surface_edge_angles(surface, nurbs, angles);
    if (status == BATTEN_OK && error > 0)
        bat_report_error(run, error, error);
    if (status == BATTEN_OK && beside) {
        status = tell_angles(run, joins, wish);
        tell_curvatures(run, nurbs, joins, wish);
    } else if (status == BATTEN_OK) {
        remark_angles(run, angles, wish);
    }
    batten_surface_unref(surface);
    if (status != BATTEN_OK) {
        batten_surface_unref(nurbs);
        nurbs = NULL;
    }
    return bat_put_surface(run, status, nurbs);
}
