/* Reads surfaces: B-splines, power splines, ruled, revolved, tabulated and offset. */
#include "exchange/iges/read/surfaces.h"
#include "exchange/iges/read/curves.h"
#include "exchange/iges/read/references.h"
#include "exchange/shapes/net.h"
#include "shape/near/even_speed.h"
#include "spline/surface/surface.h"

#include <batten/offset.h>
#include <batten/skin.h>
#include <batten/standard.h>
#include <string.h>

/* ---- 128: B-spline surface ---- */

static batten_status restrict_surface(batten_direction direction, batten_interval range,
                                      batten_surface **surface)
{
    const batten_interval domain = batten_surface_domain(*surface, direction);
    batten_surface *part = NULL;
    if (range.a == domain.a && range.b == domain.b)
        return BATTEN_OK;
    return bat_surface_replace(
        batten_surface_subrange(*surface, direction, range.a, range.b, &part), surface, &part);
}

/* K1, K2, M1, M2 and five properties. */
typedef struct {
    int head[9];
    size_t count_u, count_v, knots_u, knots_v;
} net;

static batten_status read_net(bat_iges_item *item, net *n)
{
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < 9; k++)
        status = bat_iges_integer(item->parameters, k + 1, &n->head[k]);
    if (status == BATTEN_OK)
        status = bat_iges_check_shape(item, n->head[0], n->head[2]);
    if (status == BATTEN_OK)
        status = bat_iges_check_shape(item, n->head[1], n->head[3]);
    if (status != BATTEN_OK)
        return status;
    n->count_u = (size_t)n->head[0] + 1;
    n->count_v = (size_t)n->head[1] + 1;
    n->knots_u = n->count_u + (size_t)n->head[2] + 1;
    n->knots_v = n->count_v + (size_t)n->head[3] + 1;
    const size_t points = n->count_u * n->count_v, limit = item->reading->input->limits.points;
    status = bat_iges_need(item, 10 + n->knots_u + n->knots_v + 4 * points);
    if (status == BATTEN_OK && points > limit)
        status = bat_fail(BATTEN_BAD_FORMAT, "%zu points; the limit is %zu", points, limit);
    return status;
}

/* `numbers` are both knots, the weights, the points. */
static batten_status make_surface(bat_iges_item *item, const net *n, const double *numbers)
{
    bat_input *input = item->reading->input;
    const double *weights = numbers + n->knots_u + n->knots_v;
    const size_t count = n->count_u * n->count_v;
    double *turned_weights = NULL, *turned_points = NULL;
    batten_status status =
        bat_net_transpose(input, n->count_u, n->count_v, 3, weights + count, &turned_points);
    if (status == BATTEN_OK && bat_iges_weights_matter(item, n->head[6] != 0, count, weights))
        status = bat_net_transpose(input, n->count_u, n->count_v, 1, weights, &turned_weights);
    if (status == BATTEN_OK) {
        const batten_axis u = {n->head[2], (int)n->count_u, numbers, false};
        const batten_axis v = {n->head[3], (int)n->count_v, numbers + n->knots_u, false};
        status =
            batten_surface_create(3, &u, &v, turned_points, turned_weights, &item->surface);
    }
    bat_release(turned_weights);
    bat_release(turned_points);
    return status;
}

batten_status bat_iges_read_nurbs_surface(bat_iges_item *item)
{
    net n;
    const double *numbers = NULL;
    batten_status status = read_net(item, &n);
    if (status != BATTEN_OK)
        return status;
    const size_t count = n.knots_u + n.knots_v + 4 * n.count_u * n.count_v;
    status = bat_iges_reals_in_place(item->parameters, 10, count, &numbers);
    if (status == BATTEN_OK)
        status = make_surface(item, &n, numbers);
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        const batten_interval domain = batten_surface_domain(item->surface, direction);
        status = restrict_surface(direction,
                                  bat_iges_interval(item, 10 + count + 2 * (size_t)k, domain),
                                  &item->surface);
    }
    item->own = 10 + count + 4;
    return status;
}

/* ---- 114: parametric spline surface ---- */

/* CTYPE, PTYPE, M, N, breaks both ways, then patches: for each coordinate the 16 coefficients
 * of s^0..s^3 for t^0, t^1 ... A patch that says nothing ends each row, and such a row the
 * whole. */
batten_status bat_iges_read_spline_surface(bat_iges_item *item)
{
    int m = 0, n = 0;
    double *breaks_u = NULL, *breaks_v = NULL, *made = NULL, read[48], size = 0;
    batten_status status = bat_iges_read_count(item, 3, 6, 1, &m);
    if (status == BATTEN_OK)
        status = bat_iges_read_count(item, 4, 6, 1, &n);
    if (status == BATTEN_OK && (m < 1 || n < 1))
        status = bat_fail(BATTEN_TOO_FEW_POINTS, "it has %d x %d patches", m, n);
    if (status != BATTEN_OK)
        return status;
    const size_t mu = (size_t)m, mv = (size_t)n, first = 5 + mu + 1 + mv + 1;
    /* The last patch that counts; the dummies behind it need not be there. */
    status = bat_iges_need(item, first + 48 * ((mu - 1) * (mv + 1) + mv));
    if (status == BATTEN_OK)
        status = bat_iges_real_array(item, 5, mu + 1, &breaks_u);
    if (status == BATTEN_OK)
        status = bat_iges_real_array(item, 5 + mu + 1, mv + 1, &breaks_v);
    if (status == BATTEN_OK)
        status = bat_input_array(item->reading->input, mu * mv, sizeof read, &made);
    for (size_t k = 0; status == BATTEN_OK && k < mu * mv; k++) {
        const size_t patch = k / mv * (mv + 1) + k % mv;
        status = bat_iges_reals(item->parameters, first + 48 * patch, 48, read);
        for (size_t i = 0; status == BATTEN_OK && i < 48; i++) {
            const size_t coordinate = i / 16, s = i % 4, t = i % 16 / 4;
            made[48 * k + 3 * (4 * s + t) + coordinate] = read[i];
        }
        for (size_t c = 0; status == BATTEN_OK && c < 3; c++)
            size = bat_max(size, fabs(made[48 * k + c] - made[c]));
    }
    if (status == BATTEN_OK)
        status = batten_surface_from_power(
            3, (batten_pieces){3, m, breaks_u}, (batten_pieces){3, n, breaks_v}, made,
            bat_iges_tolerance(item->reading, size), &item->surface);
    item->own = first + 48 * (mu + 1) * (mv + 1);
    bat_release(made);
    bat_release(breaks_v);
    bat_release(breaks_u);
    return status;
}

/* ---- 118: ruled surface ---- */

/* The curve of an id, run at even speed when asked for, turned around when asked for. */
static batten_status rail(bat_iges_item *item, int id, bool even, bool reversed,
                          batten_curve **out)
{
    const batten_curve *curve = NULL;
    batten_curve_even_speed_report report = {.error = 0};
    batten_curve *made = NULL, *turned_around = NULL;
    batten_status status = bat_iges_curve(item->reading, id, &curve);
    if (status != BATTEN_OK)
        return status;
    if (even && batten_curve_degree(curve) > 1)
        status = bat_curve_even_speed(
            curve, bat_iges_tolerance(item->reading, bat_iges_size_of_curve(curve)),
            bat_input_most_near(item->reading->input, batten_curve_point_count(curve)), &report,
            &made);
    else
        made = batten_curve_ref(curve);
    if (status == BATTEN_OK && report.error > 0)
        bat_iges_remark(item->reading, item->entry, "ruled by arc length, curve D%d within %g",
                        id, report.error);
    if (status == BATTEN_OK && reversed) {
        status = batten_curve_reverse(made, &turned_around);
        batten_curve_unref(made);
        made = turned_around;
    }
    if (status == BATTEN_OK)
        *out = made;
    return status;
}

batten_status bat_iges_read_ruled(bat_iges_item *item)
{
    int v[4] = {0};
    batten_curve *first = NULL, *second = NULL;
    batten_status status = BATTEN_OK;
    for (size_t k = 0; status == BATTEN_OK && k < 4; k++)
        status = bat_iges_integer(item->parameters, k + 1, &v[k]);
    const bool even = item->entry->form == 0;
    item->own = 5;
    if (status == BATTEN_OK)
        status = rail(item, v[0], even, false, &first);
    if (status == BATTEN_OK)
        status = rail(item, v[1], even, v[2] == 1, &second);
    if (status == BATTEN_OK)
        status = batten_surface_ruled(first, second, &item->surface);
    batten_curve_unref(second);
    batten_curve_unref(first);
    return status;
}

/* ---- 120: surface of revolution; 122: tabulated cylinder ---- */

static batten_status end_points(const batten_curve *curve, double ends[2][3])
{
    const batten_interval domain = batten_curve_domain(curve);
    batten_status status = batten_curve_evaluate(curve, domain.a, 0, ends[0]);
    return status == BATTEN_OK ? batten_curve_evaluate(curve, domain.b, 0, ends[1]) : status;
}

/* u runs along the generatrix and v around, as IGES has it: then its curves (u, v) run around
 * the face on the side that they mean. */
batten_status bat_iges_read_revolution(bat_iges_item *item)
{
    int ids[2] = {0};
    double angles[2], ends[2][3];
    const batten_curve *axis = NULL, *generatrix = NULL;
    batten_curve *turned_to = NULL;
    batten_surface *made = NULL;
    batten_status status = bat_iges_integer(item->parameters, 1, &ids[0]);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 2, &ids[1]);
    if (status == BATTEN_OK)
        status = bat_iges_reals(item->parameters, 3, 2, angles);
    if (status == BATTEN_OK)
        status = bat_iges_curve(item->reading, ids[0], &axis);
    if (status == BATTEN_OK)
        status = bat_iges_curve(item->reading, ids[1], &generatrix);
    if (status == BATTEN_OK)
        status = end_points(axis, ends);
    if (status != BATTEN_OK)
        return status;
    item->own = 5;
    const batten_vec3 origin = {ends[0][0], ends[0][1], ends[0][2]};
    const batten_vec3 along = {ends[1][0] - origin.x, ends[1][1] - origin.y,
                               ends[1][2] - origin.z};
    const double angle = angles[1] - angles[0];
    /* A whole turn may have been written with 7 digits. */
    if (!(angle > 0 && angle <= 2 * BAT_PI + 1e-6))
        return bat_fail(BATTEN_BAD_FORMAT, "it turns from %g to %g radians", angles[0],
                        angles[1]);
    if (along.x == 0 && along.y == 0 && along.z == 0)
        return bat_fail(BATTEN_COINCIDENT, "its axis D%d is a point", ids[0]);
    const batten_affine turn = batten_affine_rotation(origin, along, angles[0]);
    if (angles[0] == 0)
        turned_to = batten_curve_ref(generatrix);
    else
        status = batten_curve_transform(generatrix, &turn, &turned_to);
    /* An angle within rounding of a whole turn is one. */
    if (status == BATTEN_OK)
        status = batten_surface_revolved(turned_to, origin, along,
                                         angle > 2 * BAT_PI - 1e-9 ? 2 * BAT_PI : angle, &made);
    if (status == BATTEN_OK)
        status = batten_surface_swap(made, &item->surface);
    batten_surface_unref(made);
    batten_curve_unref(turned_to);
    return status;
}

/* The generatrix runs from the start of the directrix to a point. */
batten_status bat_iges_read_tabulated(bat_iges_item *item)
{
    int id = 0;
    double to[3], ends[2][3];
    const batten_curve *directrix = NULL;
    batten_status status = bat_iges_integer(item->parameters, 1, &id);
    if (status == BATTEN_OK)
        status = bat_iges_reals_or_0(item, 2, 3, to);
    if (status == BATTEN_OK)
        status = bat_iges_curve(item->reading, id, &directrix);
    if (status == BATTEN_OK)
        status = end_points(directrix, ends);
    item->own = 5;
    return status == BATTEN_OK
               ? batten_surface_extruded(
                     directrix,
                     (batten_vec3){to[0] - ends[0][0], to[1] - ends[0][1], to[2] - ends[0][2]},
                     &item->surface)
               : status;
}

/* ---- 140: offset surface ---- */

/* (NX, NY, NZ) picks the side: it is along the normal in the middle, or against it. */
batten_status bat_iges_read_offset_surface(bat_iges_item *item)
{
    int id = 0;
    double v[4];
    const batten_surface *base = NULL;
    batten_vec3 normal;
    batten_surface_offset_options options = batten_surface_offset_defaults();
    batten_surface_offset_report report;
    batten_status status = bat_iges_reals(item->parameters, 1, 4, v);
    if (status == BATTEN_OK)
        status = bat_iges_integer(item->parameters, 5, &id);
    if (status == BATTEN_OK)
        status = bat_iges_surface(item->reading, id, &base);
    if (status != BATTEN_OK)
        return status;
    item->own = 6;
    const batten_interval u = batten_surface_domain(base, BATTEN_U),
                          w = batten_surface_domain(base, BATTEN_V);
    status = batten_surface_normal(base, (u.a + u.b) / 2, (w.a + w.b) / 2, NULL, &normal);
    if (status != BATTEN_OK)
        return status;
    const double side = v[0] * normal.x + v[1] * normal.y + v[2] * normal.z;
    if (side == 0)
        return bat_fail(BATTEN_BAD_FORMAT,
                        "the direction %g %g %g does not say to which side it is offset", v[0],
                        v[1], v[2]);
    options.tolerance =
        bat_iges_tolerance(item->reading, bat_iges_size_of_box(batten_surface_box(base)));
    options.most_points = bat_input_most_near(
        item->reading->input, (double)batten_surface_point_count(base, BATTEN_U) *
                                  batten_surface_point_count(base, BATTEN_V));
    status =
        batten_surface_offset(base, side > 0 ? v[3] : -v[3], &options, &report, &item->surface);
    if (status == BATTEN_OK && !report.exact)
        bat_iges_remark(item->reading, item->entry, "offset by %g within %g", v[3],
                        report.error);
    return status;
}
