/* The NURBS kind: making, describing and mapping its surfaces; its table stands last. */
#include "numeric/vector.h"
#include "spline/surface/change.h"

#include <limits.h>
#include <string.h>

/* ---- making ---- */

batten_status bat_nurbs_make(const bat_nurbs_shape *shape, bat_nurbs **out)
{
    const size_t count_u = (size_t)shape->count[BATTEN_U],
                 count_v = (size_t)shape->count[BATTEN_V];
    const size_t d = (size_t)shape->dimension;
    bat_nurbs *nurbs = bat_array(1, sizeof *nurbs);
    if (!nurbs)
        return BATTEN_OUT_OF_MEMORY;
    bat_references_begin(&nurbs->base.references);
    nurbs->base.kind = &bat_nurbs_kind;
    nurbs->base.dimension = shape->dimension;
    nurbs->width = d + shape->rational;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = bat_axis_make(shape->degree[k], shape->count[k], shape->periodic[k],
                               &nurbs->axes[k]);
    nurbs->points = bat_array3(count_u * d, count_v, sizeof *nurbs->points);
    nurbs->net = nurbs->points;
    if (shape->rational) {
        nurbs->weights = bat_array3(count_u, count_v, sizeof *nurbs->weights);
        nurbs->net = bat_array3(count_u * nurbs->width, count_v, sizeof *nurbs->net);
    }
    if (status == BATTEN_OK && nurbs->points && nurbs->net &&
        (nurbs->weights || !shape->rational)) {
        *out = nurbs;
        return BATTEN_OK;
    }
    bat_nurbs_free(nurbs);
    return BATTEN_OUT_OF_MEMORY;
}

void bat_nurbs_free(bat_nurbs *nurbs)
{
    for (int k = 0; k < 2; k++)
        bat_axis_free(&nurbs->axes[k]);
    if (nurbs->net != nurbs->points)
        bat_release(nurbs->net);
    bat_release(nurbs->points);
    bat_release(nurbs->weights);
    bat_release(nurbs);
}

bat_nurbs_shape bat_nurbs_shape_of(const bat_nurbs *nurbs)
{
    const bat_axis *u = &nurbs->axes[BATTEN_U], *v = &nurbs->axes[BATTEN_V];
    return (bat_nurbs_shape){nurbs->base.dimension,
                             {u->degree, v->degree},
                             {u->count, v->count},
                             {u->periodic, v->periodic},
                             nurbs->weights != NULL};
}

static batten_status check_points(bat_nurbs *nurbs, size_t count, size_t count_v)
{
    const size_t d = (size_t)nurbs->base.dimension;
    const size_t at = bat_first_not_finite(nurbs->points, count * d);
    if (at < count * d)
        return bat_fail(BATTEN_NOT_FINITE, "coordinate %zu of control point (%zu, %zu) is %g",
                        at % d + 1, at / d / count_v + 1, at / d % count_v + 1,
                        nurbs->points[at]);
    for (size_t i = 0; i < count * d; i++)
        nurbs->largest = bat_max(nurbs->largest, fabs(nurbs->points[i]));
    return BATTEN_OK;
}

static batten_status check_weights(bat_nurbs *nurbs, size_t count, size_t count_v)
{
    double largest = 0;
    for (size_t i = 0; i < count; i++) {
        const double w = nurbs->weights[i];
        const size_t k = i / count_v + 1, l = i % count_v + 1;
        if (!isfinite(w))
            return bat_fail(BATTEN_NOT_FINITE, "weight (%zu, %zu) is %g", k, l, w);
        if (w <= 0)
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "weight (%zu, %zu) is %g; weights must be positive", k, l, w);
        largest = bat_max(largest, w);
    }
    nurbs->weight_scale =
        ldexp(1, bat_min_int(-ilogb(largest), 1023)); /* 2^1074 is no number */
    return BATTEN_OK;
}

static void fill_net(bat_nurbs *nurbs, size_t count)
{
    const size_t d = (size_t)nurbs->base.dimension;
    const double *point = nurbs->points;
    double *row = nurbs->net;
    for (size_t i = 0; i < count; i++, point += d) {
        const double w = nurbs->weights[i] * nurbs->weight_scale;
        for (size_t k = 0; k < d; k++)
            *row++ = w * point[k];
        *row++ = w;
    }
}

batten_status bat_nurbs_finish(bat_nurbs *nurbs, batten_surface **out)
{
    const size_t count_v = (size_t)nurbs->axes[BATTEN_V].count;
    const size_t count = (size_t)nurbs->axes[BATTEN_U].count * count_v;
    nurbs->weight_scale = 1;
    batten_status status = check_points(nurbs, count, count_v);
    if (status == BATTEN_OK && nurbs->weights)
        status = check_weights(nurbs, count, count_v);
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = bat_axis_finish(&nurbs->axes[k]);
    if (status != BATTEN_OK) {
        bat_nurbs_free(nurbs);
        return status;
    }
    if (nurbs->weights)
        fill_net(nurbs, count);
    *out = &nurbs->base;
    return BATTEN_OK;
}

batten_status bat_nurbs_copy(const bat_nurbs *nurbs, bool rational, bat_nurbs **out)
{
    bat_nurbs_shape shape = bat_nurbs_shape_of(nurbs);
    shape.rational |= rational;
    bat_nurbs *made = NULL;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)shape.count[0] * (size_t)shape.count[1];
    memcpy(made->points, nurbs->points, count * (size_t)shape.dimension * sizeof *made->points);
    for (size_t i = 0; made->weights && i < count; i++)
        made->weights[i] = nurbs->weights ? nurbs->weights[i] : 1;
    for (int k = 0; k < 2; k++)
        memcpy(made->axes[k].knots, nurbs->axes[k].knots,
               ((size_t)shape.count[k] + (size_t)shape.degree[k] + 1) * sizeof(double));
    *out = made;
    return BATTEN_OK;
}

/* ---- properties ---- */

static void nurbs_free(batten_surface *surface)
{
    bat_nurbs_free((bat_nurbs *)surface);
}

const bat_nurbs *bat_surface_nurbs(const batten_surface *surface)
{
    assert(surface && surface->kind == &bat_nurbs_kind);
    return (const bat_nurbs *)surface;
}

static const bat_axis *axis_of(const batten_surface *surface, batten_direction direction)
{
    assert(direction == BATTEN_U || direction == BATTEN_V);
    return &bat_surface_nurbs(surface)->axes[direction];
}

static batten_interval nurbs_domain(const batten_surface *surface, batten_direction direction)
{
    const bat_axis *axis = axis_of(surface, direction);
    return (batten_interval){axis->breaks[0], axis->breaks[axis->span_count]};
}

static bool nurbs_is_periodic(const batten_surface *surface, batten_direction direction)
{
    return axis_of(surface, direction)->periodic;
}

static int nurbs_spans(const batten_surface *surface, batten_direction direction, double *knots)
{
    const bat_axis *axis = axis_of(surface, direction);
    const int count = axis->span_count + 1;
    if (knots)
        memcpy(knots, axis->breaks, (size_t)count * sizeof *knots);
    return count;
}

/* Do the start and the end of one direction meet at the parameter t of the other? */
static bool ends_meet(const batten_surface *surface, batten_direction direction, double t,
                      double tolerance)
{
    const batten_interval ends = nurbs_domain(surface, direction);
    const bool at_u = direction == BATTEN_U;
    const bat_surface_place start = bat_surface_place_at(at_u ? ends.a : t, at_u ? t : ends.a);
    const bat_surface_place end = {
        at_u ? ends.b : t, at_u ? t : ends.b, {BATTEN_FROM_LEFT, BATTEN_FROM_LEFT}};
    double first[3], last[3];
    return bat_nurbs_evaluate(surface, &start, 0, first) == BATTEN_OK &&
           bat_nurbs_evaluate(surface, &end, 0, last) == BATTEN_OK &&
           bat_distance(surface->dimension, first, last) <= tolerance;
}

/* Both ends are of a degree: degree + 1 places of each span of the other direction tell. */
static bool nurbs_is_closed(const batten_surface *surface, batten_direction direction,
                            double tolerance)
{
    const bat_axis *along = axis_of(surface, bat_other(direction));
    for (int s = 0; s < along->span_count; s++)
        for (int i = 0; i <= along->degree; i++) {
            const double a = along->breaks[s], b = along->breaks[s + 1];
            const double t = i < along->degree ? a + (b - a) * i / along->degree : b;
            if (!ends_meet(surface, direction, t, tolerance))
                return false;
        }
    return true;
}

/* Of the control points that bear on the domain. */
static batten_box nurbs_box(const batten_surface *surface)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *u = &nurbs->axes[BATTEN_U], *v = &nurbs->axes[BATTEN_V];
    const int d = surface->dimension, j0 = bat_axis_first_point(v, 0),
              i0 = bat_axis_first_point(u, 0);
    double low[3] = {0}, high[3] = {0};
    for (int k = 0; k < d; k++) {
        low[k] = INFINITY;
        high[k] = -INFINITY;
        for (int i = i0; i <= u->first[u->span_count - 1]; i++)
            for (int j = j0; j <= v->first[v->span_count - 1]; j++) {
                const double x = nurbs->points[(i * v->count + j) * d + k];
                low[k] = bat_min(low[k], x);
                high[k] = bat_max(high[k], x);
            }
    }
    return (batten_box){{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

static void nurbs_local(const batten_surface *surface, const bat_surface_place *place,
                        bat_surface_local *out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    double at[2] = {place->u, place->v};
    const batten_side sides[2] = {place->sides.u, place->sides.v};
    out->largest = nurbs->largest;
    for (int k = 0; k < 2; k++) {
        const bat_axis *axis = &nurbs->axes[k];
        bat_axis_place(axis, sides[k], &at[k]); /* has been evaluated: is in the domain */
        const int s = bat_axis_span(axis, at[k], sides[k]);
        out->degree[k] = axis->degree;
        out->span[k] = axis->breaks[s + 1] - axis->breaks[s];
    }
}

static batten_status to_nurbs(const batten_surface *surface, double tolerance,
                              batten_surface **out, double *error)
{
    (void)tolerance;
    *out = batten_surface_ref(surface);
    if (error)
        *error = 0;
    return BATTEN_OK;
}

int batten_surface_degree(const batten_surface *surface, batten_direction direction)
{
    return axis_of(surface, direction)->degree;
}

int batten_surface_point_count(const batten_surface *surface, batten_direction direction)
{
    return axis_of(surface, direction)->count;
}

int batten_surface_knot_count(const batten_surface *surface, batten_direction direction)
{
    const bat_axis *axis = axis_of(surface, direction);
    return axis->count + axis->degree + 1;
}

const double *batten_surface_knots(const batten_surface *surface, batten_direction direction)
{
    return axis_of(surface, direction)->knots;
}

const double *batten_surface_points(const batten_surface *surface)
{
    return bat_surface_nurbs(surface)->points;
}

const double *batten_surface_weights(const batten_surface *surface)
{
    return bat_surface_nurbs(surface)->weights;
}

bool batten_surface_is_rational(const batten_surface *surface)
{
    return bat_surface_nurbs(surface)->weights != NULL;
}

/* ---- maps ---- */

batten_status batten_surface_reverse(const batten_surface *surface, batten_direction direction,
                                     batten_surface **out)
{
    assert(surface && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *axis = &nurbs->axes[direction];
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    bat_knots_reverse(axis->degree, axis->count, axis->knots, made->axes[direction].knots);
    const int n = nurbs->axes[BATTEN_U].count, m = nurbs->axes[BATTEN_V].count;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++)
            bat_nurbs_copy_point(nurbs, i * m + j, made,
                                 direction == BATTEN_U ? (n - 1 - i) * m + j
                                                       : i * m + m - 1 - j);
    return bat_nurbs_finish(made, out);
}

batten_status batten_surface_set_domain(const batten_surface *surface,
                                        batten_direction direction, double a, double b,
                                        batten_surface **out)
{
    assert(surface && out);
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const bat_axis *axis = &nurbs->axes[direction];
    bat_nurbs *made;
    batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    status = bat_knots_map(axis->degree, axis->count, axis->knots, a, b,
                           made->axes[direction].knots);
    if (status == BATTEN_OK)
        return bat_nurbs_finish(made, out);
    bat_nurbs_free(made);
    return status;
}

batten_status bat_nurbs_turn_over(const batten_surface *surface, batten_surface **out)
{
    const batten_interval u = batten_surface_domain(surface, BATTEN_U);
    batten_surface *reversed = NULL;
    batten_status status = batten_surface_reverse(surface, BATTEN_U, &reversed);
    if (status == BATTEN_OK)
        status = batten_surface_set_domain(reversed, BATTEN_U, u.a, u.b, out);
    if (status == BATTEN_BAD_KNOTS) {
        /* Knots that are near one another by the size of 0 would not be so elsewhere. */
        *out = reversed;
        return BATTEN_OK;
    }
    batten_surface_unref(reversed);
    return status;
}

static batten_status transform_nurbs(const batten_surface *surface, const batten_affine *map,
                                     batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    if (bat_first_not_finite(&map->m[0][0], 9) < 9 || bat_first_not_finite(map->t, 3) < 3)
        return bat_fail(BATTEN_NOT_FINITE, "the affine map has an element that is no number");
    bat_nurbs *made;
    const batten_status status = bat_nurbs_copy(nurbs, false, &made);
    if (status != BATTEN_OK)
        return status;
    const int d = surface->dimension;
    const size_t total =
        (size_t)nurbs->axes[0].count * (size_t)nurbs->axes[1].count * (size_t)d;
    for (size_t i = 0; i < total; i += (size_t)d) {
        const batten_vec3 moved = batten_affine_apply(*map, bat_vec3_of(d, made->points + i));
        const double xyz[3] = {moved.x, moved.y, moved.z};
        memcpy(made->points + i, xyz, (size_t)d * sizeof *xyz);
    }
    const size_t bad = bat_first_not_finite(made->points, total);
    if (bad == total)
        return bat_nurbs_finish(made, out);
    bat_nurbs_free(made);
    return bat_fail(BATTEN_OVERFLOW, "control point %zu is mapped to where numbers end",
                    bad / (size_t)d + 1);
}

/* ---- the table ---- */

const bat_surface_kind bat_nurbs_kind = {
    .name = "nurbs",
    .highest_order = INT_MAX,
    .free = nurbs_free,
    .domain = nurbs_domain,
    .is_periodic = nurbs_is_periodic,
    .spans = nurbs_spans,
    .is_closed = nurbs_is_closed,
    .box = nurbs_box,
    .evaluate = bat_nurbs_evaluate,
    .evaluate_many = bat_nurbs_evaluate_many,
    .evaluate_grid = bat_nurbs_evaluate_grid,
    .normal_grid = bat_nurbs_normal_grid,
    .local = nurbs_local,
    .isocurve = bat_nurbs_isocurve,
    .to_nurbs = to_nurbs,
    .transform = transform_nurbs,
    .turn_over = bat_nurbs_turn_over,
};
