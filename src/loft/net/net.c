/*
 * A net that is made fair: the bicubic spline through it, with knots at the points; the sections by
 * which it is judged, across its rows, across its columns and along its diagonals; and the least change
 * that removes inflections in excess, by the convex program of a lofting.
 */
#include "loft/net/net.h"
#include "base/list.h"

/* ---- the surface through it ---- */

batten_surface_interpolate_options bat_fair_net_fit(const batten_net_fair_options *o)
{
    batten_surface_interpolate_options fit = batten_surface_interpolate_defaults();
    fit.knots_at_data = true;
    fit.closed_u = o->closed_u;
    fit.closed_v = o->closed_v;
    fit.parameters = o->parameters;
    return fit;
}

batten_status bat_fair_net_surface(const bat_fair_net_work *work, const double *z,
                                   batten_surface **out)
{
    batten_surface_interpolate_options fit = bat_fair_net_fit(work->options);
    const batten_grid grid = {3, work->given.count_u, work->given.count_v, z};
    fit.parameters = BATTEN_GIVEN;
    fit.given_u = work->u;
    fit.given_v = work->v;
    return batten_surface_interpolate(grid, &fit, NULL, (batten_uv_out){NULL, NULL}, NULL, out);
}

/* A bicubic surface over the unit square as a patch, of its own memory; closed ones are clamped. */
static batten_status clamped_patch(const batten_surface *surface, bat_loft_patch *out)
{
    batten_surface *half = NULL, *open = NULL;
    batten_status status = batten_surface_clamp(surface, BATTEN_U, &half);
    if (status == BATTEN_OK)
        status = batten_surface_clamp(half, BATTEN_V, &open);
    if (status == BATTEN_OK) {
        const int nu = batten_surface_point_count(open, BATTEN_U),
                  nv = batten_surface_point_count(open, BATTEN_V);
        status = bat_loft_patch_make(nu, batten_surface_knots(open, BATTEN_U), nv,
                                     batten_surface_knots(open, BATTEN_V), out);
        if (status == BATTEN_OK)
            memcpy(out->points, batten_surface_points(open),
                   3 * (size_t)nu * (size_t)nv * sizeof *out->points);
    }
    batten_surface_unref(half);
    batten_surface_unref(open);
    return status;
}

/* ---- its sections ---- */

/* At most so many of a family: more places of a large net tell nothing new. */
enum { MOST_CUTS = 60 };

/* The mean directions of the net: along u, across it in the net, and its normal. */
typedef struct {
    double along[3], across[3];
} frame;

static const double *at(const bat_fair_net_work *w, int i, int j)
{
    return w->given.at + 3 * ((size_t)i * (size_t)w->given.count_v + (size_t)j);
}

/* From the first points of all lines to the last. */
static void mean_direction(const bat_fair_net_work *w, bool along_u, double out[3])
{
    const int lines = along_u ? w->given.count_v : w->given.count_u;
    const int last = (along_u ? w->given.count_u : w->given.count_v) - 1;
    for (int c = 0; c < 3; c++)
        out[c] = 0;
    for (int k = 0; k < lines; k++) {
        const double *a = along_u ? at(w, 0, k) : at(w, k, 0);
        const double *b = along_u ? at(w, last, k) : at(w, k, last);
        for (int c = 0; c < 3; c++)
            out[c] += (b[c] - a[c]) / lines;
    }
}

static double to_unit(double v[3])
{
    const double length = bat_norm(3, v);
    for (int c = 0; c < 3; c++)
        v[c] /= length;
    return length;
}

/* Closed nets have no mean direction, and folded ones may have none: x and y serve then. */
static frame frame_of(const bat_fair_net_work *w)
{
    frame f;
    double v[3], normal[3];
    mean_direction(w, true, f.along);
    mean_direction(w, false, v);
    bat_loft_cross(f.along, v, normal);
    const double least = 1e-3 * w->size * w->size; /* of a net that is thin, or closes nearly */
    if (w->options->closed_u || w->options->closed_v || !(bat_norm(3, normal) > least))
        return (frame){{1, 0, 0}, {0, 1, 0}};
    to_unit(f.along);
    to_unit(normal);
    bat_loft_cross(normal, f.along, f.across);
    return f;
}

static void range_along(const bat_fair_net_work *w, const double m[3], double out[2])
{
    const size_t nodes = (size_t)w->given.count_u * (size_t)w->given.count_v;
    out[0] = HUGE_VAL;
    out[1] = -HUGE_VAL;
    for (size_t k = 0; k < nodes; k++) {
        const double here = bat_dot(3, m, w->given.at + 3 * k);
        out[0] = bat_min(out[0], here);
        out[1] = bat_max(out[1], here);
    }
}

typedef struct {
    const bat_fair_net_work *work;
    int count, room;
    bat_loft_cut *cuts;
} list;

/* Planes at even places between those that touch the net. */
static batten_status add_family(list *l, bat_cut_kind kind, const double m[3], int places)
{
    double range[2];
    const int count = bat_min_int(MOST_CUTS, places);
    range_along(l->work, m, range);
    batten_status status = BATTEN_OK;
    for (int k = 0; k < count && status == BATTEN_OK; k++) {
        bat_loft_cut cut = {.kind = kind, .needed = -1};
        memcpy(cut.m, m, sizeof cut.m);
        cut.at = range[0] + (range[1] - range[0]) * (k + 1) / (count + 1);
        status = BAT_LIST_ADD(l->cuts, l->count, l->room, cut);
    }
    return status;
}

batten_status bat_fair_net_cuts(bat_fair_net_work *work)
{
    const frame f = frame_of(work);
    const int nu = 2 * work->given.count_u - 1, nv = 2 * work->given.count_v - 1;
    const int diagonals = bat_max_int(work->given.count_u, work->given.count_v);
    double along[2], across[2], rising[3], falling[3];
    range_along(work, f.along, along);
    range_along(work, f.across, across);
    for (int c = 0; c < 3; c++) { /* planes through opposite corners of the box of the net */
        const double a = f.along[c] * (across[1] - across[0]),
                     b = f.across[c] * (along[1] - along[0]);
        rising[c] = a - b;
        falling[c] = a + b;
    }
    to_unit(rising);
    to_unit(falling);
    list l = {.work = work};
    batten_status status = add_family(&l, BAT_CUT_STATION, f.along, nu);
    if (status == BATTEN_OK)
        status = add_family(&l, BAT_CUT_WATERLINE, f.across, nv);
    if (status == BATTEN_OK)
        status = add_family(&l, BAT_CUT_DIAGONAL, rising, diagonals);
    if (status == BATTEN_OK)
        status = add_family(&l, BAT_CUT_DIAGONAL, falling, diagonals);
    work->cut_count = l.count;
    work->cuts = l.cuts;
    return status;
}

batten_status bat_fair_net_judge(const bat_fair_net_work *work, const batten_surface *surface,
                                 bat_loft_reached *out)
{
    /* Judging asks for bulges above a quarter of the bound: here above all of it, which a move within it
     * flattens. */
    bat_loft loft = {.cut_count = work->cut_count,
                     .cuts = work->cuts,
                     .within = 4 * work->largest,
                     .height = BAT_FAIR_NET_SEEN * work->size};
    batten_status status = clamped_patch(surface, &loft.patch);
    if (status == BATTEN_OK)
        status = bat_loft_judge(&loft, out);
    bat_loft_patch_free(&loft.patch);
    return status;
}

/* ---- its least change ---- */

/* Points beside which a share of a bound is none: a point held counts as one with this share of
 * the largest bound, and is put back in the end. */
static const double held_share = 1e-7;

static void place_data(const bat_fair_net_work *work, bat_loft_datum *data)
{
    for (int i = 0; i < work->given.count_u; i++)
        for (int j = 0; j < work->given.count_v; j++) {
            const size_t k = (size_t)i * (size_t)work->given.count_v + (size_t)j;
            data[k] =
                (bat_loft_datum){.within = bat_max(work->within[k], held_share * work->largest),
                                 .u = work->u[i],
                                 .v = work->v[j],
                                 .is_fixed = true,
                                 .station = i,
                                 .index = j};
            memcpy(data[k].point, work->centre + 3 * k, sizeof data[k].point);
        }
}

/* So many rows of control points at each rim as keep edge, tangents, curvatures. */
static void hold_rims(int rows, bat_loft *loft)
{
    const int nu = loft->patch.nu, nv = loft->patch.nv;
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++)
            for (int c = 0; c < 3; c++)
                loft->held[3 * ((size_t)i * (size_t)nv + (size_t)j) + (size_t)c] =
                    i < rows || j < rows || i >= nu - rows || j >= nv - rows;
}

static void read_net(const bat_fair_net_work *work, const bat_loft_patch *patch, double *z)
{
    for (int i = 0; i < work->given.count_u; i++)
        for (int j = 0; j < work->given.count_v; j++) {
            bat_loft_place place;
            bat_loft_place_at(patch, work->u[i], work->v[j], &place);
            memcpy(z + 3 * ((size_t)i * (size_t)work->given.count_v + (size_t)j), place.s[0][0],
                   3 * sizeof *z);
        }
}

static void release_loft(bat_loft *loft)
{
    bat_loft_patch_free(&loft->patch);
    bat_release(loft->held);
    bat_release(loft->data);
}

/* The control points of the spline through the net are what the program moves. */
static batten_status fill_loft(const bat_fair_net_work *work, const batten_surface *surface,
                               bat_loft *loft)
{
    const size_t nodes = (size_t)work->given.count_u * (size_t)work->given.count_v;
    const batten_status status = clamped_patch(surface, &loft->patch);
    if (status != BATTEN_OK)
        return status;
    loft->data = bat_array(nodes, sizeof *loft->data);
    loft->held = bat_array3((size_t)loft->patch.nu, (size_t)loft->patch.nv, 3);
    if (!loft->data || !loft->held)
        return BATTEN_OUT_OF_MEMORY;
    loft->datum_count = (int)nodes;
    place_data(work, loft->data);
    hold_rims(work->options->hold, loft);
    return BATTEN_OK;
}

/* Where no way between the bounds is found the net stays. */
static batten_status change(const bat_fair_net_work *work, const batten_surface *surface,
                            int excess, double *z)
{
    bat_loft loft = {.within = work->largest,
                     .breadth = work->size / 3,
                     .height = BAT_FAIR_NET_SEEN * work->size,
                     .cut_count = work->cut_count,
                     .cuts = work->cuts,
                     .job = work->job};
    bat_loft_reached reached = {0};
    batten_status status = fill_loft(work, surface, &loft);
    if (status == BATTEN_OK)
        status = bat_loft_run(&loft, &reached);
    if (status == BATTEN_OK && reached.excess < excess)
        read_net(work, &loft.patch, z);
    release_loft(&loft);
    return status == BATTEN_NOT_COMPATIBLE ? BATTEN_OK : status;
}

batten_status bat_fair_net_change(const bat_fair_net_work *work, double *z)
{
    bat_loft_reached before = {0};
    batten_surface *surface = NULL;
    batten_status status = bat_fair_net_surface(work, z, &surface);
    if (status == BATTEN_OK)
        status = bat_fair_net_judge(work, surface, &before);
    if (status == BATTEN_OK && before.excess > 0)
        status = change(work, surface, before.excess, z);
    batten_surface_unref(surface);
    return status;
}
