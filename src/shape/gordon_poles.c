/* Curves of a network that were given twice, and points in which a family ends. */
#include "numeric/vector.h"
#include "shape/gordon.h"
#include <batten/inspect.h>

#include <string.h>

/* ---- curves given twice ---- */

/* How many of the other family curves a and b meet in the same point; *first is one of them. A
 * closed curve among open ones does not count: both its ends may belong to outermost curves. */
static int share_nodes(const bat_network *net, const bat_network_pairs *pairs, int family,
                       int a, int b, int *first)
{
    const bat_network_family *across = &net->family[1 - family];
    int shared = 0;
    for (int l = 0; l < across->count; l++) {
        const double *here = pairs->points + 3 * bat_network_pair(net, family, a, l),
                     *there = pairs->points + 3 * bat_network_pair(net, family, b, l);
        const bat_network_curve *c = &across->curves[l];
        if (c->point || (c->closed && !across->closed) ||
            bat_distance(3, here, there) > 2 * net->tolerance)
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
    f->count--;
    memmove(f->curves + k, f->curves + k + 1, (size_t)(f->count - k) * sizeof *f->curves);
    f->curves[f->count] = (bat_network_curve){0};
    net->report.repeated_count++;
}

/* How far b is from a, from 65 places of it. */
static batten_status apart(const bat_network_curve *a, const bat_network_curve *b,
                           double *distance)
{
    enum { PLACES = 65 };
    double points[3 * PLACES];
    batten_deviation found;
    for (int i = 0; i < PLACES; i++) {
        const batten_status status =
            batten_curve_evaluate(b->curve, i / (PLACES - 1.0), 0, points + 3 * i);
        if (status != BATTEN_OK)
            return status;
    }
    const batten_status status =
        batten_curve_deviation(a->curve, PLACES, points, NULL, NULL, NULL, &found);
    *distance = found.max;
    return status;
}

/* Two curves of a family that meet another one in the same point are one curve, at the seam of
 * closed ones; else the network is none. */
batten_status bat_network_drop_repeated(bat_network *net, bat_network_pairs *pairs, int family)
{
    bat_network_family *f = &net->family[family];
    for (int a = 0; a < f->count; a++)
        for (int b = a + 1; b < f->count;) {
            int first = 0;
            double distance = HUGE_VAL;
            batten_status status = BATTEN_OK;
            const int shared = share_nodes(net, pairs, family, a, b, &first);
            if (shared > 0 && !f->curves[a].point && !f->curves[b].point)
                status = apart(&f->curves[a], &f->curves[b], &distance);
            if (status != BATTEN_OK)
                return status;
            char names[3][BAT_NETWORK_LABEL];
            const bat_network_curve *met = &net->family[1 - family].curves[first];
            if (shared == 0)
                b++;
            else if (distance <= 2 * net->tolerance && met->closed)
                drop(net, pairs, family, b);
            else
                return bat_fail(BATTEN_COINCIDENT, "%s and %s meet %s in the same point",
                                bat_network_label(net, family, &f->curves[a], names[0]),
                                bat_network_label(net, family, &f->curves[b], names[1]),
                                bat_network_label(net, 1 - family, met, names[2]));
        }
    return BATTEN_OK;
}

/* ---- poles ---- */

static batten_status end_of(const bat_network_curve *c, int end, double *point)
{
    return batten_curve_evaluate(c->curve, end, 0, point);
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
               (bat_distance(3, ends[0], point) <= net->tolerance ||
                bat_distance(3, ends[1], point) <= net->tolerance);
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
    return batten_curve_create(3, 1, 2, points, NULL, knots, out);
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
        pairs->at[family][at] = bat_distance(3, start, point) <= net->tolerance ? 0 : 1;
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
