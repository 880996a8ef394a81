/* The boolean sum of both skins of a network, and what it keeps of the curves. */
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "spline/curve/curve.h"
#include "spline/surface/surface.h"

#include <stdio.h>
#include <string.h>

/* ---- the control net ---- */

/* guides' rows minus the combination of the nodes: what the profiles' skin lacks along each
 * guide, [cardinals in u][count_v][3]. */
static void find_lacks(const bat_network *net, const bat_network_side *u,
                       const bat_network_side *v, double *lacks)
{
    const int guides = net->family[1].count;
    for (int i = 0; i < u->cardinals; i++)
        for (int b = 0; b < v->count; b++) {
            double *lack = lacks + 3 * ((size_t)i * (size_t)v->count + (size_t)b);
            memcpy(lack, v->rows + 3 * ((size_t)i * (size_t)v->count + (size_t)b),
                   3 * sizeof *lack);
            for (int j = 0; j < v->cardinals; j++)
                for (int c = 0; c < 3; c++)
                    lack[c] -=
                        v->blend[b * v->cardinals + j] * net->nodes[3 * (j * guides + i) + c];
        }
}

static void find_point(const bat_network_side *u, const bat_network_side *v,
                       const double *lacks, int a, int b, double *point)
{
    for (int j = 0; j < v->cardinals; j++) {
        const double *row = u->rows + 3 * ((size_t)j * (size_t)u->count + (size_t)a);
        for (int c = 0; c < 3; c++)
            point[c] += v->blend[b * v->cardinals + j] * row[c];
    }
    for (int i = 0; i < u->cardinals; i++) {
        const double *lack = lacks + 3 * ((size_t)i * (size_t)v->count + (size_t)b);
        for (int c = 0; c < 3; c++)
            point[c] += u->blend[a * u->cardinals + i] * lack[c];
    }
}

/* The outermost curves are the rims to the last bit. */
static void keep_rims(const bat_network_side *u, const bat_network_side *v, double *points)
{
    const size_t across = (size_t)v->count;
    for (size_t end = 0; end < 2; end++) {
        const size_t a = end * ((size_t)u->count - 1), b = end * (across - 1);
        const double *guide = v->rows + 3 * end * (size_t)(v->curves - 1) * across;
        const double *profile = u->rows + 3 * end * (size_t)(u->curves - 1) * (size_t)u->count;
        memcpy(points + 3 * a * across, guide, 3 * across * sizeof *points);
        for (size_t i = 0; i < (size_t)u->count; i++)
            memcpy(points + 3 * (i * across + b), profile + 3 * i, 3 * sizeof *points);
    }
}

/* ---- periodic ---- */

/* Clamped rows of a cubic whose ends continue each other with two derivatives become those of
 * the periodic form: all but the first two stay, and the last three are not needed. These two
 * are blossoms of the first span at the knots before it, which are those at the end, a period
 * less. */
static void wrap(const bat_network_side *side, size_t count, size_t step, double *rows)
{
    const double *U = side->knots + 4;
    const double a = side->knots[side->count - 1] - 1, b = side->knots[side->count - 2] - 1;
    for (size_t i = 0; i < count; i++) {
        double *P0 = rows + i, *P1 = P0 + step;
        const double P2 = *(P1 + step);
        const double at_a = *P0 + (*P1 - *P0) * (a / U[0]); /* (0, 0, a) */
        *P1 += (P2 - *P1) * (a / U[1]);                     /* (0, u1, a) */
        *P0 = at_a + (*P1 - at_a) * (b / U[0]);             /* (0, b, a) */
    }
}

static void wrap_net(const bat_network_side *u, const bat_network_side *v, double *points)
{
    const size_t across = 3 * (size_t)v->count;
    if (u->seam)
        wrap(u, across, across, points);
    for (size_t i = 0; v->seam && i < (size_t)u->count; i++)
        wrap(v, 3, 3, points + i * across);
}

/* The net without the last three lines of v, closed up. */
static void drop_last(const bat_network_side *u, const bat_network_side *v, double *points)
{
    const size_t across = 3 * (size_t)v->count, kept = across - 9;
    for (size_t i = 1; v->seam && i < (size_t)u->count; i++)
        memmove(points + i * kept, points + i * across, kept * sizeof *points);
}

static batten_axis axis_of(const bat_network_side *side)
{
    const int p = side->degree;
    return side->seam ? (batten_axis){p, side->count - p, side->knots + p, true}
                      : (batten_axis){p, side->count, side->knots, false};
}

static batten_status check_size(const bat_network_side *u, const bat_network_side *v)
{
    if ((double)u->count * v->count > BAT_MAX_MADE_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "the network makes a surface of %d by %d control points; the limit is "
                        "%d in all",
                        u->count, v->count, (int)BAT_MAX_MADE_POINTS);
    return BATTEN_OK;
}

static batten_status make_surface(const bat_network *net, const bat_network_side *u,
                                  const bat_network_side *v, batten_surface **out)
{
    const size_t across = (size_t)v->count;
    double *lacks = bat_array3((size_t)u->cardinals, 3 * across, sizeof *lacks);
    double *points = bat_array3((size_t)u->count, 3 * across, sizeof *points);
    batten_status status = lacks && points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        find_lacks(net, u, v, lacks);
        for (int a = 0; a < u->count; a++)
            for (int b = 0; b < v->count; b++)
                find_point(u, v, lacks, a, b, points + 3 * ((size_t)a * across + (size_t)b));
        keep_rims(u, v, points);
        wrap_net(u, v, points);
        drop_last(u, v, points);
        const batten_axis axis_u = axis_of(u), axis_v = axis_of(v);
        status = batten_surface_create(3, &axis_u, &axis_v, points, NULL, out);
    }
    bat_release(points);
    bat_release(lacks);
    return status;
}

/* ---- the check ---- */

enum { PER_SPAN = 9 }; /* a knot and 8 places behind it */

static batten_status places_of(const bat_network_side *side, double **out, int *count)
{
    const int p = side->degree;
    double *at = bat_array((size_t)PER_SPAN * (size_t)(side->count - p) + 1, sizeof *at);
    if (!at)
        return BATTEN_OUT_OF_MEMORY;
    *count = 0;
    for (int k = p; k < side->count; k++) {
        const double a = side->knots[k], b = side->knots[k + 1];
        for (int i = 0; a < b && i < PER_SPAN; i++)
            at[(*count)++] = a + (b - a) * ((double)i / PER_SPAN);
    }
    at[(*count)++] = side->knots[side->count];
    *out = at;
    return BATTEN_OK;
}

/* The largest distance of a curve from its line: `line` [count] points `step` numbers apart. */
static batten_status line_distance(const bat_network_curve *c, int count, const double *at,
                                   const double *line, size_t step, double *worst,
                                   double *where)
{
    *worst = 0;
    *where = 0;
    for (int i = 0; i < count; i++) {
        double point[3];
        const batten_status status = bat_network_point(c, at[i], point);
        if (status != BATTEN_OK)
            return status;
        const double distance = bat_distance(3, point, line + (size_t)i * step);
        if (!(distance <= *worst)) {
            *worst = distance;
            *where = at[i];
        }
    }
    return BATTEN_OK;
}

static batten_status compare(bat_network *net, int family, int count, const double *at,
                             const double *grid)
{
    const bat_network_family *f = &net->family[family];
    const size_t n = (size_t)f->count;
    for (int k = 0; k < f->count; k++) {
        double worst = 0, where = 0;
        const double *line = grid + 3 * (size_t)k * (family == 0 ? 1 : (size_t)count);
        const batten_status status = line_distance(&f->curves[k], count, at, line,
                                                   family == 0 ? 3 * n : 3, &worst, &where);
        if (status != BATTEN_OK)
            return status;
        const double off = (worst + f->curves[k].moved) / net->scale;
        const double gap =
            net->gap > net->tolerance ? bat_max(net->report.gap, net->report.seam) : 0;
        char name[BAT_NETWORK_LABEL];
        if (!(off <= net->options->tolerance + gap))
            return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                            "the surface misses %s by %g at its parameter %g, more than the "
                            "tolerance %g",
                            bat_network_label(net, family, &f->curves[k], name), off, where,
                            net->options->tolerance);
        if (off > net->report.error) {
            net->report.error = off;
            net->report.worst_is_guide = family == 1;
            net->report.worst = f->curves[k].index;
        }
    }
    return BATTEN_OK;
}

/* All curves of a family against the surface. */
static batten_status check_family(bat_network *net, int family, const bat_network_side *side,
                                  const batten_surface *surface)
{
    const size_t lines = (size_t)net->family[family].count;
    const double *across = net->family[1 - family].parameters;
    double *at = NULL, *grid = NULL;
    int count = 0;
    batten_status status = places_of(side, &at, &count);
    if (status == BATTEN_OK) {
        grid = bat_array3((size_t)count, 3 * lines, sizeof *grid);
        status = grid ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    }
    if (status == BATTEN_OK && family == 0)
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){(size_t)count, lines, at, across}, 0, net->work.job,
            grid);
    else if (status == BATTEN_OK)
        status = batten_surface_evaluate_grid(
            surface, (batten_uv_grid){lines, (size_t)count, across, at}, 0, net->work.job,
            grid);
    if (status == BATTEN_OK)
        status = compare(net, family, count, at, grid);
    bat_release(grid);
    bat_release(at);
    return status;
}

static batten_status check_nodes(bat_network *net, const batten_surface *surface)
{
    const size_t n = (size_t)net->family[0].count, m = (size_t)net->family[1].count;
    double *grid = bat_array3(n, 3 * m, sizeof *grid);
    if (!grid)
        return BATTEN_OUT_OF_MEMORY;
    const batten_status status = batten_surface_evaluate_grid(
        surface, (batten_uv_grid){m, n, net->family[0].parameters, net->family[1].parameters},
        0, net->work.job, grid);
    for (size_t i = 0; status == BATTEN_OK && i < m; i++)
        for (size_t j = 0; j < n; j++)
            net->report.node_error =
                bat_max(net->report.node_error,
                        bat_distance(3, grid + 3 * (i * n + j), net->nodes + 3 * (j * m + i)) /
                            net->scale);
    bat_release(grid);
    return status;
}

static void fill_report(bat_network *net, const bat_network_side sides[2])
{
    batten_surface_gordon_report *r = &net->report;
    r->closed_u = net->family[0].closed;
    r->closed_v = net->family[1].closed;
    r->smooth_u = r->closed_u && net->family[0].smooth;
    r->smooth_v = r->closed_v && net->family[1].smooth;
    r->exact_u = sides[0].exact;
    r->exact_v = sides[1].exact;
    r->points_u = axis_of(&sides[0]).point_count;
    r->points_v = axis_of(&sides[1]).point_count;
    r->exact_knots_u = sides[0].exact_knots;
    r->exact_knots_v = sides[1].exact_knots;
}

batten_status bat_network_sum(bat_network *net, bat_network_side sides[2], batten_surface **out)
{
    const uint64_t steps = (uint64_t)sides[0].count * (uint64_t)sides[1].count *
                           (uint64_t)(net->family[0].count + net->family[1].count);
    batten_surface *surface = NULL;
    batten_status status = check_size(&sides[0], &sides[1]);
    if (status == BATTEN_OK)
        status = bat_work_step(&net->work, steps, 0.8, "boolean sum");
    if (status == BATTEN_OK)
        status = make_surface(net, &sides[0], &sides[1], &surface);
    for (int k = 0; status == BATTEN_OK && k < 2; k++)
        status = check_family(net, k, &sides[k], surface);
    if (status == BATTEN_OK)
        status = check_nodes(net, surface);
    if (status == BATTEN_OK) {
        const double back = 1 / net->scale;
        const batten_affine map = batten_affine_scaling(back, back, back);
        fill_report(net, sides);
        status = batten_surface_transform(surface, &map, out);
    }
    batten_surface_unref(surface);
    return status;
}
