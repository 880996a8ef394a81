/* What the report of a network says of its curves: how near neighbours come to each other, and
 * how far the guides are from what the profiles alone would make. */
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include <batten/nearest.h>

/* ---- neighbours ---- */

/* Curves a and b of a family where they meet curve l of the other one. */
static void compare_neighbours(bat_network *net, int family, int a, int b, int l)
{
    const bat_network_family *f = &net->family[family];
    const int guides = net->family[1].count;
    const double *here = net->nodes + 3 * (family == 0 ? a * guides + l : l * guides + a),
                 *there = net->nodes + 3 * (family == 0 ? b * guides + l : l * guides + b);
    const double distance = bat_distance(3, here, there);
    if (distance <= net->same || distance / net->scale >= net->report.nearest)
        return;
    net->report.nearest = distance / net->scale;
    net->report.nearest_is_guide = family == 1;
    net->report.nearest_curves[0] = f->curves[a].index;
    net->report.nearest_curves[1] = f->curves[b].index;
}

/* The first and the last are neighbours, too: across a slit. Poles have none. */
static void find_nearest(bat_network *net)
{
    net->report.nearest = HUGE_VAL;
    for (int family = 0; family < 2; family++) {
        const bat_network_family *f = &net->family[family], *across = &net->family[1 - family];
        for (int k = 0; k < f->count; k++) {
            const int next = (k + 1) % f->count;
            for (int l = 0; l < across->count && k != next; l++)
                if (!across->curves[l].point && !f->curves[k].point && !f->curves[next].point)
                    compare_neighbours(net, family, k, next, l);
        }
    }
}

/* ---- the guides and the skin of the profiles ---- */

static batten_status make_skin(const bat_network_side *u, const bat_network_side *v,
                               batten_surface **out)
{
    const size_t across = (size_t)v->count, along = (size_t)u->count;
    double *points = bat_array3(along, 3 * across, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (size_t a = 0; a < along; a++)
        for (size_t b = 0; b < across; b++)
            for (int j = 0; j < v->cardinals; j++)
                for (size_t c = 0; c < 3; c++)
                    points[3 * (a * across + b) + c] +=
                        v->blend[b * (size_t)v->cardinals + (size_t)j] *
                        u->rows[3 * ((size_t)j * along + a) + c];
    const batten_axis axis_u = {u->degree, u->count, u->knots, false},
                      axis_v = {v->degree, v->count, v->knots, false};
    const batten_status status = batten_surface_create(3, &axis_u, &axis_v, points, NULL, out);
    bat_release(points);
    return status;
}

static batten_status measure_guide(bat_network *net, const bat_network_curve *guide,
                                   const batten_surface *skin, int per, double *points)
{
    const int spans = net->family[0].count - 1, count = per * spans + 1;
    const double *v = net->family[1].parameters;
    batten_deviation found;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < count; i++) {
        const int k = bat_min_int(i / per, spans - 1);
        const double part = (double)(i - k * per) / per;
        status = bat_network_point(guide, (1 - part) * v[k] + part * v[k + 1], points + 3 * i);
    }
    if (status == BATTEN_OK)
        status = batten_surface_deviation(skin, (batten_points){3, count, points}, NULL,
                                          net->work.job, NULL, &found);
    if (status == BATTEN_OK && found.max / net->scale > net->report.guide_error) {
        const double *p = points + 3 * found.worst;
        net->report.guide_error = found.max / net->scale;
        net->report.guide_worst = guide->index;
        net->report.guide_worst_at =
            (batten_vec3){p[0] / net->scale, p[1] / net->scale, p[2] / net->scale};
    }
    return status;
}

static batten_status measure_guides(bat_network *net, const bat_network_side sides[2])
{
    const bat_network_family *f = &net->family[1];
    const int spans = net->family[0].count - 1;
    /* About 4000 places in all, 2 to 8 for each span. */
    const int per = (int)bat_max(2, bat_min(8, 4000.0 / ((double)f->count * spans)));
    batten_surface *skin = NULL;
    double *points = bat_array3((size_t)per * (size_t)spans + 1, 3, sizeof *points);
    batten_status status =
        points ? make_skin(&sides[0], &sides[1], &skin) : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++)
        if (!f->curves[k].point && f->curves[k].index >= 0)
            status = measure_guide(net, &f->curves[k], skin, per, points);
    batten_surface_unref(skin);
    bat_release(points);
    return status;
}

batten_status bat_network_measure(bat_network *net, const bat_network_side sides[2])
{
    find_nearest(net);
    return measure_guides(net, sides);
}
