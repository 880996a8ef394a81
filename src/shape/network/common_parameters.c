/* Common parameters for a network, and the curves drawn anew as the surface runs along them. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "spline/curve/curve.h"
#include <batten/interpolate.h>
#include <batten/local.h>

#include <string.h>

/* ---- parameters ---- */

/* A node beside a knot stands on it: on a corner within a small part of the tolerance, on
 * others within rounding. */
static batten_status snap_to_knots(const bat_network_curve *c, int nodes, double near)
{
    const int p = batten_curve_degree(c->curve), n = batten_curve_point_count(c->curve);
    const double *U = batten_curve_knots(c->curve);
    for (int k = p + 1; k < n; k++) {
        const bool corner = k + p <= n && U[k] == U[k + p - 1];
        for (int i = 1; i + 1 < nodes; i++) {
            /* A node beside a corner is that corner if their parameters differ by less than 1/100. */
            double here[3], there[3];
            if (c->at[i] == U[k] || fabs(c->at[i] - U[k]) > (corner ? 1e-2 : BAT_MEANT_SAME))
                continue;
            batten_status status = batten_curve_evaluate(c->curve, c->at[i], 0, here);
            if (status == BATTEN_OK)
                status = batten_curve_evaluate(c->curve, U[k], 0, there);
            if (status != BATTEN_OK)
                return status;
            if (bat_distance(3, here, there) <= near)
                c->at[i] = U[k];
        }
    }
    return BATTEN_OK;
}

static batten_status find_parameters(bat_network *net, int family)
{
    bat_network_family *f = &net->family[family];
    const int nodes = net->family[1 - family].count;
    f->parameters = bat_array((size_t)nodes, sizeof *f->parameters);
    batten_status status = f->parameters ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int used = 0, first = -1;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        const bool again = k > 0 && k == f->count - 1 && net->family[1 - family].closed;
        if (f->curves[k].point)
            continue;
        if (!again)
            first = used++ ? first : k;
        status = snap_to_knots(&f->curves[k], nodes, bat_network_snap(net));
        for (int i = 0; i < nodes && !again; i++)
            f->parameters[i] += f->curves[k].at[i];
    }
    for (int i = 0; status == BATTEN_OK && i < nodes; i++) {
        const double own = f->curves[first].at[i], mean = f->parameters[i] / used;
        f->parameters[i] = i == nodes - 1 ? 1 : fabs(mean - own) <= BAT_MEANT_SAME ? own : mean;
    }
    for (int k = 0; status == BATTEN_OK && k < f->count; k++)
        for (int i = 0; i < nodes; i++) {
            if (f->curves[k].point)
                f->curves[k].at[i] = f->parameters[i];
            net->report.spread =
                bat_max(net->report.spread, fabs(f->curves[k].at[i] - f->parameters[i]));
        }
    return status;
}

/* ---- maps ---- */

/* Is a cubic nowhere flatter than a tenth of its chords between the nodes? */
static batten_status is_steep(const batten_curve *map, int nodes, const double *u,
                              const double *at, bool *steep)
{
    batten_curve *bezier = NULL;
    const batten_status status = batten_curve_to_bezier(map, &bezier);
    if (status != BATTEN_OK)
        return status;
    const double *P = batten_curve_points(bezier), *U = batten_curve_knots(bezier);
    const int p = batten_curve_degree(bezier), n = batten_curve_point_count(bezier);
    *steep = true;
    for (int k = 0, i = 0; k + p < n; k += p) {
        const double a = U[k + p], b = U[k + p + 1];
        while (i + 2 < nodes && u[i + 1] <= (a + b) / 2)
            i++;
        const double chord = (at[i + 1] - at[i]) / (u[i + 1] - u[i]);
        for (int c = k; c < k + p; c++)
            *steep = *steep && p * (P[c + 1] - P[c]) / (b - a) >= chord / 10;
    }
    batten_curve_unref(bezier);
    return BATTEN_OK;
}

/* The cubic spline through the nodes: natural, or, minus the line, periodic. */
static batten_status spline_map(int nodes, const double *u, const double *at, bool periodic,
                                batten_curve **out)
{
    batten_curve_interpolate_options options = batten_curve_interpolate_defaults();
    batten_curve *made = NULL, *clamped = NULL;
    double *off = bat_array((size_t)nodes, sizeof *off);
    if (!off)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < nodes; i++)
        off[i] = at[i] - u[i];
    options.parameters = BATTEN_GIVEN;
    options.given = u;
    options.closed = periodic;
    options.start.kind = options.end.kind = BATTEN_END_NATURAL;
    batten_status status = batten_curve_interpolate((batten_points){1, nodes - periodic, off},
                                                    &options, NULL, &made);
    bat_release(off);
    if (status == BATTEN_OK)
        status = batten_curve_clamp(made, &clamped);
    if (status == BATTEN_OK) { /* and the line again: its control points are Greville's */
        batten_curve *map = NULL;
        status = bat_curve_copy(clamped, &map);
        for (int i = 0; status == BATTEN_OK && i < map->count; i++)
            map->points[i] += batten_curve_greville(clamped, i);
        if (status == BATTEN_OK)
            status = bat_curve_finish(map, out);
    }
    batten_curve_unref(clamped);
    batten_curve_unref(made);
    return status;
}

/* Monotone for any data, with a continuous slope; `closed`: the slope at both ends is one. */
static batten_status monotone_map(int nodes, const double *u, const double *at, bool closed,
                                  batten_curve **out)
{
    const int more = closed ? 1 : 0, count = nodes + 2 * more;
    double *x = bat_array3(3, (size_t)count, sizeof *x);
    double *values = bat_array3((size_t)nodes, 2, sizeof *values);
    batten_status status = x && values ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        double *y = x + count, *slopes = y + count;
        memcpy(x + more, u, (size_t)nodes * sizeof *x);
        memcpy(y + more, at, (size_t)nodes * sizeof *y);
        if (closed) {
            x[0] = u[nodes - 2] - 1;
            y[0] = at[nodes - 2] - 1;
            x[count - 1] = u[1] + 1;
            y[count - 1] = at[1] + 1;
        }
        status = batten_slopes(count, x, y, BATTEN_SLOPE_FRITSCH_BUTLAND, slopes);
        for (int i = 0; i < nodes; i++) {
            values[2 * i] = at[i];
            values[2 * i + 1] = slopes[i + more];
        }
    }
    if (status == BATTEN_OK)
        status = batten_curve_from_hermite(1, nodes, 2, u, values, out);
    bat_release(values);
    bat_release(x);
    return status;
}

/* How far the nodes are from the places where they belong, along the curve. */
static batten_status nodes_off(const bat_network_curve *c, int nodes, const double *u,
                               double *off)
{
    *off = 0;
    for (int i = 0; i < nodes; i++) {
        double here[3], there[3];
        batten_status status = batten_curve_evaluate(c->curve, c->at[i], 0, here);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(c->curve, u[i], 0, there);
        if (status != BATTEN_OK)
            return status;
        *off = bat_max(*off, bat_distance(3, here, there));
    }
    return BATTEN_OK;
}

static batten_status make_map(const bat_network *net, int family, bat_network_curve *c)
{
    const bat_network_family *f = &net->family[family];
    const int nodes = net->family[1 - family].count;
    const double *u = f->parameters;
    double off = 0;
    bool steep = false;
    batten_status status = nodes_off(c, nodes, u, &off);
    if (status != BATTEN_OK || off <= net->tolerance / 1024)
        return status;
    const bool periodic = f->closed && f->smooth;
    if (nodes - periodic > 2) {
        status = spline_map(nodes, u, c->at, periodic, &c->map);
        if (status == BATTEN_OK)
            status = is_steep(c->map, nodes, u, c->at, &steep);
    }
    if (status != BATTEN_OK || steep)
        return status;
    batten_curve_unref(c->map);
    c->map = NULL;
    return monotone_map(nodes, u, c->at, periodic, &c->map);
}

/* Do all curves of a closed family are smooth where they close? */
static batten_status find_smooth(bat_network_family *f)
{
    f->smooth = f->closed;
    for (int k = 0; k < f->count && f->smooth; k++) {
        double first[6], last[6];
        batten_status status = batten_curve_evaluate(f->curves[k].curve, 0, 1, first);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(f->curves[k].curve, 1, 1, last);
        if (status != BATTEN_OK)
            return status;
        const double fast = bat_max(bat_norm(3, first + 3), bat_norm(3, last + 3));
        f->smooth = f->curves[k].point || bat_distance(3, first + 3, last + 3) <= fast / 100;
    }
    return BATTEN_OK;
}

/* ---- the points of the nodes ---- */

static batten_status find_node(const bat_network *net, int j, int i, double *node)
{
    const bat_network_curve *profile = bat_network_at(net, 0, j),
                            *guide = bat_network_at(net, 1, i);
    double p[3], q[3];
    batten_status status =
        batten_curve_evaluate(profile->curve, profile->point ? 0 : profile->at[i], 0, p);
    if (status == BATTEN_OK)
        status = batten_curve_evaluate(guide->curve, guide->point ? 0 : guide->at[j], 0, q);
    for (int c = 0; status == BATTEN_OK && c < 3; c++)
        node[c] = profile->point ? p[c] : guide->point ? q[c] : (p[c] + q[c]) / 2;
    return status;
}

/* The last node of a closed curve is its first. */
static void close_nodes(double *first, double *last)
{
    for (int c = 0; c < 3; c++)
        first[c] = last[c] = (first[c] + last[c]) / 2;
}

static batten_status find_nodes(bat_network *net)
{
    const int n = net->family[0].count, m = net->family[1].count;
    net->nodes = bat_array3((size_t)n, (size_t)m * 3, sizeof *net->nodes);
    if (!net->nodes)
        return BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < n; j++)
        for (int i = 0; i < m; i++) {
            const batten_status status = find_node(net, j, i, net->nodes + 3 * (j * m + i));
            if (status != BATTEN_OK)
                return status;
        }
    for (int j = 0; j < n && net->family[0].closed; j++)
        close_nodes(net->nodes + 3 * (j * m), net->nodes + 3 * (j * m + m - 1));
    for (int i = 0; i < m && net->family[1].closed; i++)
        close_nodes(net->nodes + 3 * i, net->nodes + 3 * ((n - 1) * m + i));
    return BATTEN_OK;
}

batten_status bat_network_parametrize(bat_network *net)
{
    batten_status status = BATTEN_OK;
    for (int family = 0; status == BATTEN_OK && family < 2; family++) {
        bat_network_family *f = &net->family[family];
        status = find_parameters(net, family);
        if (status == BATTEN_OK)
            status = find_smooth(f);
        for (int k = 0; status == BATTEN_OK && k < f->count; k++)
            if (!f->curves[k].point)
                status = make_map(net, family, &f->curves[k]);
    }
    return status == BATTEN_OK ? find_nodes(net) : status;
}
