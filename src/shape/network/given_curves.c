/* The curves of a network as they are given become curves that can be compared. */
#include "numeric/box.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "shape/skin/sections.h"
#include "spline/curve/curve.h"
#include <batten/approximate.h>

#include <float.h>
#include <stdio.h>

const char *bat_network_label(const bat_network *net, int family,
                              const bat_network_curve *curve, char label[BAT_NETWORK_LABEL])
{
    const bat_network_family *f = &net->family[family];
    if (curve->index < 0)
        snprintf(label, BAT_NETWORK_LABEL, "the pole of the %ss", net->family[1 - family].what);
    else if (f->names)
        snprintf(label, BAT_NETWORK_LABEL, "%s '%.100s' (%d of %d)", f->what,
                 f->names[curve->index], curve->index + 1, f->given);
    else
        snprintf(label, BAT_NETWORK_LABEL, "%s %d", f->what, curve->index + 1);
    return label;
}

static batten_box box_of(int count, const batten_curve *const *curves)
{
    batten_box all = batten_curve_box(curves[0]);
    for (int k = 1; k < count; k++)
        bat_box_join(&all, batten_curve_box(curves[k]));
    return all;
}

double batten_network_size(int count, const batten_curve *const *curves)
{
    return bat_box_diagonal(box_of(count, curves));
}

batten_status bat_network_scale(int count, const batten_curve *const *curves, double *scale)
{
    double largest = 0;
    for (int k = 0; k < count; k++)
        if (batten_curve_dimension(curves[k]) < 2)
            return bat_fail(BATTEN_UNSUPPORTED, "curve %d of the network is a function", k + 1);
    const batten_box all = box_of(count, curves);
    const double low[3] = {all.low.x, all.low.y, all.low.z},
                 high[3] = {all.high.x, all.high.y, all.high.z};
    double extent = 0;
    for (int c = 0; c < 3; c++) {
        largest = bat_max(largest, bat_max(fabs(low[c]), fabs(high[c])));
        extent = bat_max(extent, high[c] - low[c]);
    }
    if (!(extent > 64 * DBL_EPSILON * largest))
        return bat_fail(BATTEN_COINCIDENT, "all curves of the network are one point");
    *scale = ldexp(1, -ilogb(largest));
    return BATTEN_OK;
}

batten_status bat_network_take_curve(const batten_curve *given, double scale, double tolerance,
                                     batten_curve **out, double *moved)
{
    const batten_affine map = batten_affine_scaling(scale, scale, scale);
    batten_curve *curve = NULL, *next = NULL;
    *moved = 0;
    batten_status status = batten_curve_to_dimension(given, 3, &curve);
    if (status == BATTEN_OK &&
        (status = batten_curve_transform(curve, &map, &next)) == BATTEN_OK)
        bat_curve_take(&curve, next);
    if (status == BATTEN_OK && batten_curve_is_rational(curve)) {
        status = batten_curve_approximate(curve, 3, tolerance / 16, moved, &next);
        if (status == BATTEN_OK)
            bat_curve_take(&curve, next);
    }
    if (status == BATTEN_OK && (status = bat_skin_even_speed(curve, &next)) == BATTEN_OK)
        bat_curve_take(&curve, next);
    if (status == BATTEN_OK &&
        (status = batten_curve_set_domain(curve, 0, 1, &next)) == BATTEN_OK)
        bat_curve_take(&curve, next);
    if (status == BATTEN_OK)
        *out = curve;
    else
        batten_curve_unref(curve);
    return status;
}

/* A curve all of whose control points lie within the distance is a point. */
static bool is_point(const batten_curve *curve, double distance)
{
    const double *P = batten_curve_points(curve);
    const int n = batten_curve_point_count(curve);
    for (int i = 1; i < n; i++)
        if (bat_distance(3, P, P + 3 * i) > distance)
            return false;
    return true;
}

static batten_status take_family(bat_network *net, int which, const batten_curve *const *given)
{
    bat_network_family *f = &net->family[which];
    f->room = f->given + 3; /* two poles, or the first one twice */
    f->curves = bat_array((size_t)f->room, sizeof *f->curves);
    if (!f->curves)
        return BATTEN_OUT_OF_MEMORY;
    for (; f->count < f->given; f->count++) {
        bat_network_curve *c = &f->curves[f->count];
        c->index = f->count;
        batten_status status = bat_network_take_curve(given[f->count], net->scale,
                                                      net->tolerance, &c->curve, &c->moved);
        if (status == BATTEN_OK)
            status = bat_trace_make(c->curve, &c->trace);
        if (status != BATTEN_OK) {
            batten_curve_unref(c->curve);
            c->curve = NULL;
            return status;
        }
        c->point = is_point(c->curve, bat_min(net->same, net->tolerance / 4));
        c->closed = !c->point && batten_curve_is_closed(c->curve, net->gap);
    }
    return BATTEN_OK;
}

batten_status bat_network_take(bat_network *net, const batten_curve *const *profiles,
                               const batten_curve *const *guides)
{
    batten_status status = take_family(net, 0, profiles);
    if (status == BATTEN_OK)
        status = take_family(net, 1, guides);
    return status;
}

void bat_network_free(bat_network *net)
{
    for (int which = 0; which < 2; which++) {
        bat_network_family *f = &net->family[which];
        for (int k = 0; k < f->count; k++) {
            batten_curve_unref(f->curves[k].curve);
            batten_curve_unref(f->curves[k].map);
            bat_trace_free(&f->curves[k].trace);
            bat_release(f->curves[k].at);
        }
        bat_release(f->curves);
        bat_release(f->parameters);
    }
    bat_release(net->nodes);
}
