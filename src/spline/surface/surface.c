/* Making, keeping and describing surfaces. */
#include "spline/surface/surface.h"
#include "base/plural.h"
#include "numeric/vector.h"

#include "spline/curve/curve.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>

static const char *const axis_names[2] = {"u", "v"};

/* ---- making ---- */

static batten_status check_axis(const batten_axis *axis, const char *name)
{
    const int least = axis->periodic ? 1 : axis->degree + 1;
    if (axis->degree < 1 || axis->degree > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "the degree in %s is %d; it must be in 1..%d", name,
                        axis->degree, BATTEN_MAX_DEGREE);
    if (axis->point_count < least)
        return bat_fail(
            BATTEN_TOO_FEW_POINTS, "%d control point%s in %s for degree %d; %d are needed",
            axis->point_count, bat_plural(axis->point_count), name, axis->degree, least);
    if (axis->point_count > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d control points in %s; the limit is %d",
                        axis->point_count, name, BAT_MAX_POINTS);
    return BATTEN_OK;
}

static batten_status check_sizes(int dimension, const batten_axis *u, const batten_axis *v)
{
    if (dimension < 1 || dimension > 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "the dimension is %d; it must be 1, 2 or 3",
                        dimension);
    batten_status status = check_axis(u, axis_names[BATTEN_U]);
    if (status == BATTEN_OK)
        status = check_axis(v, axis_names[BATTEN_V]);
    if (status != BATTEN_OK)
        return status;
    const long long total = (long long)u->point_count * v->point_count;
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE, "%d x %d are %lld control points; the limit is %d",
                        u->point_count, v->point_count, total, BAT_MAX_POINTS);
    return BATTEN_OK;
}

static batten_status check_period(const batten_axis *axis, const char *name)
{
    const int m = axis->point_count;
    for (int i = 0; i <= m; i++)
        if (!isfinite(axis->knots[i]))
            return bat_fail(BATTEN_NOT_FINITE, "knot %d in %s is %g", i, name, axis->knots[i]);
    if (!(axis->knots[m] > axis->knots[0]))
        return bat_fail(BATTEN_BAD_KNOTS,
                        "the period in %s is empty: knot 0 is %.17g and knot %d is %.17g", name,
                        axis->knots[0], m, axis->knots[m]);
    return BATTEN_OK;
}

static batten_status fill_knots(const batten_axis *given, const char *name, bat_axis *axis)
{
    const int p = given->degree, m = given->point_count;
    char what[32] = "knot in ";
    strcat(what, name);
    if (!given->periodic) {
        memcpy(axis->knots, given->knots, ((size_t)m + (size_t)p + 1) * sizeof *axis->knots);
        return bat_knots_check(p, m, axis->knots, what);
    }
    const batten_status status = check_period(given, name);
    if (status != BATTEN_OK)
        return status;
    bat_knots_wrap(p, m, given->knots, axis->knots);
    return bat_knots_check(p, m + p, axis->knots, what);
}

static void fill_points(bat_nurbs *nurbs, int own_u, int own_v, const double *points,
                        const double *weights)
{
    const size_t d = (size_t)nurbs->base.dimension;
    double *point = nurbs->points, *weight = nurbs->weights;
    for (int i = 0; i < nurbs->axes[BATTEN_U].count; i++)
        for (int j = 0; j < nurbs->axes[BATTEN_V].count; j++, point += d) {
            const size_t from = (size_t)(i % own_u) * (size_t)own_v + (size_t)(j % own_v);
            memcpy(point, points + from * d, d * sizeof *point);
            if (weights)
                *weight++ = weights[from];
        }
}

batten_status batten_surface_create(int dimension, const batten_axis *u, const batten_axis *v,
                                    const double *points, const double *weights,
                                    batten_surface **out)
{
    assert(u && v && u->knots && v->knots && points && out);
    batten_status status = check_sizes(dimension, u, v);
    if (status != BATTEN_OK)
        return status;
    const bat_nurbs_shape shape = {
        .dimension = dimension,
        .degree = {u->degree, v->degree},
        .count = {u->point_count + (u->periodic ? u->degree : 0),
                  v->point_count + (v->periodic ? v->degree : 0)},
        .periodic = {u->periodic, v->periodic},
        .rational = weights != NULL,
    };
    bat_nurbs *nurbs = NULL;
    status = bat_nurbs_make(&shape, &nurbs);
    if (status != BATTEN_OK)
        return status;
    status = fill_knots(u, axis_names[BATTEN_U], &nurbs->axes[BATTEN_U]);
    if (status == BATTEN_OK)
        status = fill_knots(v, axis_names[BATTEN_V], &nurbs->axes[BATTEN_V]);
    if (status != BATTEN_OK) {
        bat_nurbs_free(nurbs);
        return status;
    }
    fill_points(nurbs, u->point_count, v->point_count, points, weights);
    return bat_nurbs_finish(nurbs, out);
}

/* ---- the NURBS kind ---- */

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
                        at % d, at / d / count_v, at / d % count_v, nurbs->points[at]);
    for (size_t i = 0; i < count * d; i++)
        nurbs->largest = bat_max(nurbs->largest, fabs(nurbs->points[i]));
    return BATTEN_OK;
}

static batten_status check_weights(bat_nurbs *nurbs, size_t count, size_t count_v)
{
    double largest = 0;
    for (size_t i = 0; i < count; i++) {
        const double w = nurbs->weights[i];
        if (!isfinite(w))
            return bat_fail(BATTEN_NOT_FINITE, "weight (%zu, %zu) is %g", i / count_v,
                            i % count_v, w);
        if (w <= 0)
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "weight (%zu, %zu) is %g; weights must be positive", i / count_v,
                            i % count_v, w);
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

/* At degree + 1 places of each span of the other direction: both ends are there of that degree.
 */
static bool nurbs_is_closed(const batten_surface *surface, batten_direction direction,
                            double tolerance)
{
    const bat_axis *along = axis_of(surface, bat_other(direction));
    const batten_interval ends = nurbs_domain(surface, direction);
    for (int s = 0; s < along->span_count; s++)
        for (int i = 0; i <= along->degree; i++) {
            const double a = along->breaks[s], b = along->breaks[s + 1];
            const double t = i < along->degree ? a + (b - a) * i / along->degree : b;
            double first[3], last[3];
            const bool at_u = direction == BATTEN_U;
            if (bat_nurbs_evaluate(surface, at_u ? ends.a : t, at_u ? t : ends.a,
                                   BATTEN_FROM_RIGHT, BATTEN_FROM_RIGHT, 0,
                                   first) != BATTEN_OK ||
                bat_nurbs_evaluate(surface, at_u ? ends.b : t, at_u ? t : ends.b,
                                   BATTEN_FROM_LEFT, BATTEN_FROM_LEFT, 0, last) != BATTEN_OK ||
                !(bat_distance(surface->dimension, first, last) <= tolerance))
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

static void nurbs_local(const batten_surface *surface, double u, double v, batten_side side_u,
                        batten_side side_v, bat_surface_local *out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    double at[2] = {u, v};
    const batten_side sides[2] = {side_u, side_v};
    out->largest = nurbs->largest;
    for (int k = 0; k < 2; k++) {
        const bat_axis *axis = &nurbs->axes[k];
        bat_axis_place(axis, sides[k], &at[k]); /* has been evaluated: is in the domain */
        const int s = bat_axis_span(axis, at[k], sides[k]);
        out->degree[k] = axis->degree;
        out->span[k] = axis->breaks[s + 1] - axis->breaks[s];
    }
}

batten_status bat_nurbs_to_nurbs(const batten_surface *surface, double tolerance,
                                 batten_surface **out, double *error)
{
    (void)tolerance;
    *out = batten_surface_ref(surface);
    if (error)
        *error = 0;
    return BATTEN_OK;
}

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
    .to_nurbs = bat_nurbs_to_nurbs,
    .transform = bat_nurbs_transform,
    .turn_over = bat_nurbs_turn_over,
};

/* ---- any surface ---- */

batten_surface *batten_surface_ref(const batten_surface *surface)
{
    /* What is const to the holder is the shape; the count behind it is not part of it. */
    batten_surface *shared = (batten_surface *)(uintptr_t)surface;
    bat_references_add(&shared->references);
    return shared;
}

void batten_surface_unref(batten_surface *surface)
{
    if (surface && bat_references_drop(&surface->references))
        surface->kind->free(surface);
}

const char *batten_surface_kind(const batten_surface *surface)
{
    return surface->kind->name;
}

int batten_surface_dimension(const batten_surface *surface)
{
    return surface->dimension;
}

batten_interval batten_surface_domain(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->domain(surface, direction);
}

int batten_surface_spans(const batten_surface *surface, batten_direction direction,
                         double *knots)
{
    return surface->kind->spans(surface, direction, knots);
}

bool batten_surface_is_closed(const batten_surface *surface, batten_direction direction,
                              double tolerance)
{
    assert(surface);
    return surface->kind->is_closed(surface, direction, tolerance);
}

batten_box batten_surface_box(const batten_surface *surface)
{
    return surface->kind->box(surface);
}

batten_status batten_surface_to_nurbs(const batten_surface *surface, double tolerance,
                                      double *error, batten_surface **out)
{
    assert(surface && out);
    return surface->kind->to_nurbs(surface, tolerance, out, error);
}

batten_status batten_surface_transform(const batten_surface *surface, const batten_affine *map,
                                       batten_surface **out)
{
    assert(surface && map && out);
    return surface->kind->transform(surface, map, out);
}

batten_status batten_surface_transform_sides(const batten_surface *surface,
                                             const batten_affine *map, batten_surface **out)
{
    assert(surface && map && out);
    batten_surface *image = NULL;
    batten_status status = surface->kind->transform(surface, map, &image);
    if (status != BATTEN_OK)
        return status;
    if (surface->dimension < 3 || !(batten_affine_determinant(*map) < 0)) {
        *out = image;
        return BATTEN_OK;
    }
    status = image->kind->turn_over(image, out);
    batten_surface_unref(image);
    return status;
}

batten_status batten_surface_isocurve(const batten_surface *surface, batten_direction direction,
                                      double at, batten_curve **out)
{
    assert(surface && out && (direction == BATTEN_U || direction == BATTEN_V));
    return surface->kind->isocurve(surface, direction, at, out);
}

/* ---- properties of a NURBS surface ---- */

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

bool batten_surface_is_periodic(const batten_surface *surface, batten_direction direction)
{
    return surface->kind->is_periodic(surface, direction);
}

void batten_surfaces_release(batten_surfaces *surfaces)
{
    for (int i = 0; i < surfaces->count; i++)
        batten_surface_unref(surfaces->at[i]);
    bat_release(surfaces->at);
    *surfaces = (batten_surfaces){0, NULL};
}
