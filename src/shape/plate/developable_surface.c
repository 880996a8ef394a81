/* The surface along the path of least warp, its rulings, and its parts at corners. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"
#include <batten/skin.h>

enum { CONE_RULINGS = 8, ROUGH_PASSES = 100 };

/* ---- cones ---- */

/* A curve that rests in one point, with the degree, knots and weights of another: then rulings
 * between the two have an even parameter. */
static batten_status resting(const batten_curve *like, batten_vec3 at, batten_curve **out)
{
    const int count = batten_curve_point_count(like);
    double *points = bat_array((size_t)count * 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++) {
        points[3 * i] = at.x;
        points[3 * i + 1] = at.y;
        points[3 * i + 2] = at.z;
    }
    const batten_status status =
        batten_curve_create((batten_points){3, count, points}, batten_curve_degree(like),
                            batten_curve_weights(like), batten_curve_knots(like), out);
    bat_release(points);
    return status;
}

/* From pair a to b along a side of the square: one edge rests. */
static batten_status make_cone(const bat_plate *plate, bat_pair a, bat_pair b,
                               batten_surface **out, double *length)
{
    const int e = a.x == b.x ? 1 : 0; /* the edge that moves */
    const double from[2] = {a.x, a.y}, to[2] = {b.x, b.y};
    bat_edge_place start, end, apex;
    batten_curve *side[2] = {NULL, NULL};
    batten_status status = bat_plate_edge_at(&plate->edge[e], from[e], &start);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[e], to[e], &end);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[1 - e], from[1 - e], &apex);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(plate->edge[e].curve, start.u, end.u, &side[e]);
    if (status == BATTEN_OK)
        status = resting(side[e], apex.P, &side[1 - e]);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(side[0], side[1], out);
    *length = (to[e] - from[e]) * plate->edge[e].length;
    batten_curve_unref(side[0]);
    batten_curve_unref(side[1]);
    return status;
}

/* Set the domain of a part and join it to what is there; the part is given back. */
static batten_status add_part(batten_status status, double length, double tolerance,
                              batten_surface *part, batten_surface **whole)
{
    batten_surface *placed = NULL, *joined = NULL;
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(part, BATTEN_U, 0, length, &placed);
    if (status == BATTEN_OK && *whole)
        status = batten_surface_join(*whole, placed, BATTEN_U, tolerance, &joined);
    else if (status == BATTEN_OK)
        joined = batten_surface_ref(placed);
    if (status == BATTEN_OK) {
        batten_surface_unref(*whole);
        *whole = joined;
    }
    batten_surface_unref(placed);
    batten_surface_unref(part);
    return status;
}

/* ---- the whole ---- */

static batten_status put_ruling(const bat_plate *plate, bat_pair pair, double u,
                                batten_developable *out)
{
    batten_ruling *ruling = &out->rulings[out->count++];
    bat_edge_place a, b;
    double sine = 0, cosine = 1;
    batten_status status = bat_plate_edge_at(&plate->edge[0], pair.x, &a);
    if (status == BATTEN_OK)
        status = bat_plate_edge_at(&plate->edge[1], pair.y, &b);
    if (status != BATTEN_OK)
        return status;
    *ruling = (batten_ruling){.u = u, .s = a.u, .t = b.u};
    if (bat_warp_of(&a, &b, BAT_MEANT_SAME * plate->size, &sine, &cosine))
        ruling->warp = bat_atan2(fabs(sine), cosine);
    return BATTEN_OK;
}

/* A cone before or behind what lies between both edges. */
typedef struct {
    bat_pair from, to;
    batten_interval u;
    bool at_start;
} cone;

/* Rulings of a cone by equal shares of length; those at its ends belong to its neighbours or to
 * the outside. */
static batten_status put_cone_rulings(const bat_plate *plate, const cone *c,
                                      batten_developable *out)
{
    const bat_pair a = c->from, b = c->to;
    batten_status status = BATTEN_OK;
    for (int k = c->at_start ? 0 : 1; k < CONE_RULINGS + !c->at_start && status == BATTEN_OK;
         k++) {
        const double f = (double)k / CONE_RULINGS;
        const bat_pair pair = {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y)};
        status = put_ruling(plate, pair, c->u.a + f * (c->u.b - c->u.a), out);
        if (status == BATTEN_OK)
            out->rulings[out->count - 1].warp = 0;
    }
    return status;
}

static batten_status put_rulings(const bat_plate *plate, const bat_middle *m, double before,
                                 double behind, batten_developable *out)
{
    const bat_pair start = {0, 0}, end = {1, 1};
    const double length = m->count > 1 ? m->tau[m->count - 1] : 0;
    const double whole = before + length + behind;
    out->rulings = bat_array((size_t)m->count + 2 * CONE_RULINGS, sizeof *out->rulings);
    if (!out->rulings)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    if (before > 0)
        status = put_cone_rulings(plate, &(cone){start, m->pairs[0], {0, before / whole}, true},
                                  out);
    for (int i = 0; i < m->count && status == BATTEN_OK; i++) {
        const batten_interval domain = batten_curve_domain(plate->edge[0].curve);
        /* Exact edges keep their parameter. */
        const double u = m->edge[0] || m->count == 1
                             ? (before + m->tau[i]) / whole
                             : (m->u[0][i] - domain.a) / (domain.b - domain.a);
        status = put_ruling(plate, m->pairs[i], u, out);
    }
    if (behind > 0 && status == BATTEN_OK)
        status = put_cone_rulings(
            plate, &(cone){m->pairs[m->count - 1], end, {(before + length) / whole, 1}, false},
            out);
    return status;
}

/* A path that is all cones meets in one ruling. */
static batten_status only_ruling(const bat_plate *plate, bat_middle *m)
{
    batten_status status = bat_middle_reserve(1, m);
    if (status != BATTEN_OK)
        return status;
    m->count = 1;
    m->pairs[0] = plate->pairs[0];
    return bat_middle_place(plate, m);
}

static batten_status join_parts(const bat_plate *plate, bat_middle *m, batten_developable *out)
{
    const bat_pair first = plate->pairs[0], last = plate->pairs[plate->count - 1];
    const double tolerance = BAT_MEANT_SAME * plate->size;
    batten_surface *part = NULL, *whole = NULL;
    double before = 0, behind = 0;
    out->cone[0] = first.x > 0 || first.y > 0;
    out->cone[1] = last.x < 1 || last.y < 1;
    batten_status status = BATTEN_OK;
    if (out->cone[0]) {
        status = make_cone(plate, (bat_pair){0, 0}, first, &part, &before);
        status = add_part(status, before, tolerance, part, &whole);
    }
    if (m->surface && status == BATTEN_OK)
        status = add_part(status, m->tau[m->count - 1], tolerance,
                          batten_surface_ref(m->surface), &whole);
    if (out->cone[1] && status == BATTEN_OK) {
        part = NULL;
        status = make_cone(plate, last, (bat_pair){1, 1}, &part, &behind);
        status = add_part(status, behind, tolerance, part, &whole);
    }
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(whole, BATTEN_U, 0, 1, &out->surface);
    if (status == BATTEN_OK)
        status = put_rulings(plate, m, before, behind, out);
    batten_surface_unref(whole);
    return status;
}

batten_status bat_plate_surface(bat_plate *plate,
                                const batten_surface_developable_options *options,
                                batten_developable *out)
{
    bat_middle m = {0};
    batten_status status =
        plate->count > 1 ? bat_middle_make(plate, options, &m) : only_ruling(plate, &m);
    /* Warped plates have rulings without warp in places only; through all of them the surface
     * would swing. */
    if (status == BATTEN_TOLERANCE_NOT_MET) {
        plate->rough = true;
        bat_plate_smooth(plate, ROUGH_PASSES);
        status = bat_middle_make(plate, options, &m);
    }
    if (status == BATTEN_OK)
        status = join_parts(plate, &m, out);
    out->error = m.error;
    bat_middle_release(&m);
    return status;
}
