/* Curves of a network that were given twice, and points in which a family ends. */
#include "numeric/vector.h"
#include "shape/network/gordon.h"

#include <string.h>

/* ---- curves given twice ---- */

/* How many of the other family curves a and b meet in the same point, as far as the gaps of
 * these joints can tell; *first is one of them. A
 * closed curve among open ones does not count: both its ends may belong to outermost curves. */
static int share_nodes(const bat_network *net, const bat_network_pairs *pairs, int family,
                       int a, int b, int *first)
{
    const bat_network_family *across = &net->family[1 - family];
    int shared = 0;
    for (int l = 0; l < across->count; l++) {
        const int at_a = bat_network_pair(net, family, a, l),
                  at_b = bat_network_pair(net, family, b, l);
        const double near = bat_max(net->same, pairs->distance[at_a] + pairs->distance[at_b]);
        const bat_network_curve *c = &across->curves[l];
        if (c->point || (c->closed && !across->closed) ||
            bat_distance(3, pairs->points + 3 * at_a, pairs->points + 3 * at_b) > near)
            continue;
        if (shared++ == 0)
            *first = l;
    }
    return shared;
}

/* Rows of `width` numbers for each pair, without those of curve k. */
static void drop_rows(const bat_network *net, int family, int k, size_t width, double *rows)
{
    const size_t room = (size_t)net->family[1].room, at = (size_t)k;
    const size_t behind = (size_t)(net->family[family].count - 1 - k);
    if (family == 0)
        memmove(rows + at * room * width, rows + (at + 1) * room * width,
                behind * room * width * sizeof *rows);
    else
        for (size_t j = 0; j < (size_t)net->family[0].count; j++)
            memmove(rows + (j * room + at) * width, rows + (j * room + at + 1) * width,
                    behind * width * sizeof *rows);
}

static void drop(bat_network *net, bat_network_pairs *pairs, int family, int k)
{
    bat_network_family *f = &net->family[family];
    batten_curve_unref(f->curves[k].curve);
    bat_trace_free(&f->curves[k].trace);
    for (int on = 0; on < 2; on++)
        drop_rows(net, family, k, 1, pairs->at[on]);
    drop_rows(net, family, k, 3, pairs->points);
    drop_rows(net, family, k, 1, pairs->distance);
    f->count--;
    memmove(f->curves + k, f->curves + k + 1, (size_t)(f->count - k) * sizeof *f->curves);
    f->curves[f->count] = (bat_network_curve){0};
    net->report.repeated_count++;
}

/* Two different curves that meet another one in the same point: no network. */
static batten_status refuse(const bat_network *net, const bat_network_pairs *pairs, int family,
                            int a, int b, int l, double apart)
{
    char names[3][BAT_NETWORK_LABEL];
    const bat_network_family *f = &net->family[family];
    const int pair[2] = {bat_network_pair(net, family, a, l),
                         bat_network_pair(net, family, b, l)};
    const double *p = pairs->points + 3 * pair[0], *q = pairs->points + 3 * pair[1];
    const double s = net->scale;
    return bat_fail(
        BATTEN_COINCIDENT,
        "%s and %s meet %s in the same point, (%g, %g, %g): they are %.3g apart there, and "
        "miss it by %.3g and %.3g; elsewhere they are up to %.3g apart",
        bat_network_label(net, family, &f->curves[a], names[0]),
        bat_network_label(net, family, &f->curves[b], names[1]),
        bat_network_label(net, 1 - family, &net->family[1 - family].curves[l], names[2]),
        p[0] / s, p[1] / s, p[2] / s, bat_distance(3, p, q) / s, pairs->distance[pair[0]] / s,
        pairs->distance[pair[1]] / s, apart / s);
}

/* The second of two curves that are one is left out, and noted. */
static void drop_second(bat_network *net, bat_network_pairs *pairs, int family, int a, int b,
                        double apart)
{
    const bat_network_family *f = &net->family[family];
    if (net->report.repeated_count < BATTEN_GORDON_REPEATED)
        net->report.repeated[net->report.repeated_count] =
            (batten_gordon_repeated){.is_guide = family == 1,
                                     .used = f->curves[a].index,
                                     .left = f->curves[b].index,
                                     .apart = apart / net->scale};
    drop(net, pairs, family, b);
}

/* Two curves of a family that meet another one in the same point are one curve, at the seam of
 * closed ones; else there is no network. */
batten_status bat_network_drop_repeated(bat_network *net, bat_network_pairs *pairs, int family)
{
    bat_network_family *f = &net->family[family];
    for (int a = 0; a < f->count; a++)
        for (int b = a + 1; b < f->count;) {
            int first = 0;
            bool same = false;
            double apart = 0;
            batten_status status = BATTEN_OK;
            const int shared = share_nodes(net, pairs, family, a, b, &first);
            if (shared > 0 && !f->curves[a].point && !f->curves[b].point)
                status = bat_network_are_same(net, &f->curves[a], &f->curves[b], &same, &apart);
            if (status != BATTEN_OK)
                return status;
            if (shared == 0)
                b++;
            else if (same && net->family[1 - family].curves[first].closed)
                drop_second(net, pairs, family, a, b, apart);
            else
                return refuse(net, pairs, family, a, b, first, apart);
        }
    return BATTEN_OK;
}

/* ---- poles ---- */

static batten_status end_of(const bat_network_curve *c, int end, double *point)
{
    return batten_curve_evaluate(c->curve, end, 0, point);
}

/* How far ends may be from each other to be a pole: gaps may be as wide as is allowed, but what
 * is an opening at the scale of the network stays one. */
static double pole_width(const bat_network *net)
{
    return bat_min(net->gap, bat_max(net->same, net->size / 1000));
}

/* Does each curve of a family end in `point`? */
static batten_status all_end_in(const bat_network *net, int family, const double *point,
                                bool *all)
{
    const bat_network_family *f = &net->family[family];
    *all = f->count > 1;
    for (int k = 0; k < f->count && *all; k++) {
        double ends[2][3];
        batten_status status = end_of(&f->curves[k], 0, ends[0]);
        if (status == BATTEN_OK)
            status = end_of(&f->curves[k], 1, ends[1]);
        if (status != BATTEN_OK)
            return status;
        *all = !f->curves[k].point && !f->curves[k].closed &&
               (bat_distance(3, ends[0], point) <= pole_width(net) ||
                bat_distance(3, ends[1], point) <= pole_width(net));
    }
    return BATTEN_OK;
}

/* Does a curve of the other family meet the first curve of this one at that end? */
static bool end_is_taken(const bat_network *net, const bat_network_pairs *pairs, int family,
                         int end)
{
    for (int l = 0; l < net->family[1 - family].count; l++)
        if (pairs->at[family][bat_network_pair(net, family, 0, l)] == end)
            return true;
    return false;
}

static batten_status point_curve(const double *point, batten_curve **out)
{
    static const double knots[] = {0, 0, 1, 1};
    const double points[] = {point[0], point[1], point[2], point[0], point[1], point[2]};
    return batten_curve_create((batten_points){3, 2, points}, 1, NULL, knots, out);
}

/* A curve of the other family that is but this point. */
static batten_status add_pole(bat_network *net, bat_network_pairs *pairs, int family,
                              const double *point)
{
    bat_network_family *across = &net->family[1 - family];
    bat_network_curve *pole = &across->curves[across->count];
    const int l = across->count;
    batten_status status = point_curve(point, &pole->curve);
    if (status != BATTEN_OK)
        return status;
    pole->index = -1;
    pole->point = true;
    across->count++;
    net->report.pole_count++;
    for (int k = 0; k < net->family[family].count; k++) {
        double start[3];
        status = end_of(&net->family[family].curves[k], 0, start);
        if (status != BATTEN_OK)
            return status;
        const int at = bat_network_pair(net, family, k, l);
        pairs->at[family][at] = bat_distance(3, start, point) <= pole_width(net) ? 0 : 1;
        pairs->at[1 - family][at] = 0.5;
        memcpy(pairs->points + 3 * at, point, 3 * sizeof *point);
    }
    return BATTEN_OK;
}

batten_status bat_network_find_poles(bat_network *net, bat_network_pairs *pairs, int family)
{
    for (int end = 0; end < 2; end++) {
        double point[3];
        bool all = false;
        batten_status status = end_of(&net->family[family].curves[0], end, point);
        if (status == BATTEN_OK)
            status = all_end_in(net, family, point, &all);
        if (status == BATTEN_OK && all && !end_is_taken(net, pairs, family, end))
            status = add_pole(net, pairs, family, point);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}
