/* Changes that keep the shape: knots, degree, parts. */
#include "spline/surface/change.h"

#include "numeric/dense.h"

#include "spline/curve/curve.h"

#include <string.h>

/* ---- surfaces as splines and back ---- */

static batten_status open_direction(const bat_axis *axis, bat_spline *spline)
{
    bat_spline opened;
    const batten_status status =
        bat_spline_subrange(spline, axis->breaks[0], axis->breaks[axis->span_count], &opened);
    bat_spline_free(spline);
    if (status == BATTEN_OK)
        *spline = opened;
    return status;
}

batten_status bat_nurbs_to_spline(const bat_nurbs *nurbs, batten_direction direction,
                                  bat_spline *out)
{
    const bat_axis *axis = &nurbs->axes[direction];
    const int across = nurbs->axes[bat_other(direction)].count;
    bat_spline made;
    batten_status status =
        bat_spline_make(axis->degree, axis->count, (size_t)across * nurbs->width, &made);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)axis->count;
    memcpy(made.knots, axis->knots, (n + (size_t)axis->degree + 1) * sizeof *made.knots);
    if (direction == BATTEN_U)
        memcpy(made.values, nurbs->net, n * made.width * sizeof *made.values);
    else
        bat_transpose(across, axis->count, nurbs->width, nurbs->net, made.values);
    if (axis->periodic)
        status = open_direction(axis, &made);
    if (status == BATTEN_OK)
        *out = made;
    return status;
}

/* Points and weights from the homogeneous net [count_u][count_v][width]. */
static void fill_points(bat_nurbs *nurbs, double weight_scale, const double *net)
{
    const size_t d = (size_t)nurbs->base.dimension;
    const size_t count = (size_t)nurbs->axes[0].count * (size_t)nurbs->axes[1].count;
    if (!nurbs->weights) {
        memcpy(nurbs->points, net, count * d * sizeof *net);
        return;
    }
    for (size_t i = 0; i < count; i++, net += d + 1) {
        for (size_t k = 0; k < d; k++)
            nurbs->points[i * d + k] = net[k] / net[d];
        nurbs->weights[i] = net[d] / weight_scale;
    }
}

static void fill_from_spline(const bat_nurbs *like, batten_direction direction,
                             const bat_spline *spline, bat_nurbs *made)
{
    const bat_axis *across = &like->axes[bat_other(direction)];
    memcpy(made->axes[direction].knots, spline->knots,
           ((size_t)spline->count + (size_t)spline->degree + 1) * sizeof *spline->knots);
    memcpy(made->axes[bat_other(direction)].knots, across->knots,
           ((size_t)across->count + (size_t)across->degree + 1) * sizeof *across->knots);
    if (direction == BATTEN_U) {
        fill_points(made, like->weight_scale, spline->values);
        return;
    }
    /* Only a rational surface has a net of its own; it is filled from the points later on. */
    double *net = made->net;
    bat_transpose(spline->count, across->count, like->width, spline->values, net);
    if (made->weights)
        fill_points(made, like->weight_scale, net);
}

/* The surface of a spline along `direction`, like `like` in all else; OVERFLOW when a row is
 * not finite. */
static batten_status surface_from_spline(const bat_nurbs *like, batten_direction direction,
                                         const bat_spline *spline, batten_surface **out)
{
    if (!bat_all_finite(spline->values, (size_t)spline->count * spline->width))
        return bat_fail(BATTEN_OVERFLOW, "a control point became too large for a number");
    bat_nurbs_shape shape = bat_nurbs_shape_of(like);
    shape.degree[direction] = spline->degree;
    shape.count[direction] = spline->count;
    shape.periodic[direction] = false;
    bat_nurbs *made = NULL;
    const batten_status status = bat_nurbs_make(&shape, &made);
    if (status != BATTEN_OK)
        return status;
    fill_from_spline(like, direction, spline, made);
    return bat_nurbs_finish(made, out);
}

batten_status bat_nurbs_change(const batten_surface *surface, batten_direction direction,
                               bat_spline_change change, void *context, batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    bat_spline from, made;
    batten_status status = bat_nurbs_to_spline(nurbs, direction, &from);
    if (status != BATTEN_OK)
        return status;
    status = change(&from, context, &made);
    if (status == BATTEN_OK) {
        status = surface_from_spline(nurbs, direction, &made, out);
        bat_spline_free(&made);
    }
    bat_spline_free(&from);
    return status;
}

/* Would so many control points along `direction` be too many? */
static batten_status check_size(const batten_surface *surface, batten_direction direction,
                                double count)
{
    const double total = count * batten_surface_point_count(surface, bat_other(direction));
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f control points would be needed; the limit is %d", total,
                        BAT_MAX_POINTS);
    return BATTEN_OK;
}

/* ---- knots ---- */

typedef struct {
    int count;
    const double *knots;
} new_knots;

static batten_status insert(const bat_spline *spline, void *context, bat_spline *out)
{
    const new_knots *wish = context;
    const batten_status status = bat_knots_check_insertion(
        spline->degree, spline->count, spline->knots, false, wish->count, wish->knots);
    return status == BATTEN_OK ? bat_spline_insert(spline, wish->count, wish->knots, out)
                               : status;
}

batten_status batten_surface_refine(const batten_surface *surface, batten_direction direction,
                                    int count, const double *knots, batten_surface **out)
{
    assert(surface && count >= 0 && (knots || count == 0) && out);
    const batten_status status = check_size(
        surface, direction, (double)batten_surface_point_count(surface, direction) + count);
    new_knots wish = {count, knots};
    return status == BATTEN_OK ? bat_nurbs_change(surface, direction, insert, &wish, out)
                               : status;
}

batten_status batten_surface_insert_knot(const batten_surface *surface,
                                         batten_direction direction, double at, int times,
                                         batten_surface **out)
{
    assert(surface && out);
    const bat_axis *axis = &bat_surface_nurbs(surface)->axes[direction];
    double knots[BATTEN_MAX_DEGREE + 1];
    if (times < 1 || times > axis->degree + 1)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a knot cannot be inserted %d times into degree %d", times,
                        axis->degree);
    const batten_status status = bat_axis_place(axis, BATTEN_FROM_RIGHT, &at);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < times; i++)
        knots[i] = at;
    return batten_surface_refine(surface, direction, times, knots, out);
}

/* ---- degree ---- */

static batten_status elevate(const bat_spline *spline, void *context, bat_spline *out)
{
    const int *by = context;
    return bat_spline_elevate(spline, *by, out);
}

batten_status batten_surface_elevate(const batten_surface *surface, batten_direction direction,
                                     int by, batten_surface **out)
{
    assert(surface && out);
    const int degree = batten_surface_degree(surface, direction);
    if (by < 0 || degree + by > BATTEN_MAX_DEGREE)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d cannot be raised by %d; the limit is %d",
                        degree, by, BATTEN_MAX_DEGREE);
    const batten_status status = check_size(
        surface, direction, ((double)by + 1) * batten_surface_point_count(surface, direction));
    return status == BATTEN_OK ? bat_nurbs_change(surface, direction, elevate, &by, out)
                               : status;
}

/* ---- parts ---- */

static batten_status subrange(const bat_spline *spline, void *context, bat_spline *out)
{
    const batten_interval *part = context;
    return bat_spline_subrange(spline, part->a, part->b, out);
}

batten_status batten_surface_subrange(const batten_surface *surface, batten_direction direction,
                                      double a, double b, batten_surface **out)
{
    assert(surface && out);
    const batten_interval domain = batten_surface_domain(surface, direction);
    batten_status status = bat_knots_clip(domain.a, domain.b, &a);
    if (status == BATTEN_OK)
        status = bat_knots_clip(domain.a, domain.b, &b);
    if (status == BATTEN_OK && a >= b)
        status = bat_fail(BATTEN_OUT_OF_DOMAIN, "the part from %.17g to %.17g is empty", a, b);
    batten_interval part = {a, b};
    return status == BATTEN_OK ? bat_nurbs_change(surface, direction, subrange, &part, out)
                               : status;
}

batten_status batten_surface_clamp(const batten_surface *surface, batten_direction direction,
                                   batten_surface **out)
{
    assert(surface && out);
    const batten_interval domain = batten_surface_domain(surface, direction);
    return batten_surface_subrange(surface, direction, domain.a, domain.b, out);
}

static bool is_clamped(const batten_surface *surface, batten_direction direction)
{
    const int p = batten_surface_degree(surface, direction),
              n = batten_surface_point_count(surface, direction);
    const double *knots = batten_surface_knots(surface, direction);
    return knots[0] == knots[p] && knots[n] == knots[n + p];
}

batten_status bat_surface_clamp_both(batten_surface **surface)
{
    for (int k = 0; k < 2; k++) {
        const batten_direction direction = k ? BATTEN_V : BATTEN_U;
        batten_surface *clamped = NULL;
        if (is_clamped(*surface, direction))
            continue;
        const batten_status status =
            bat_surface_replace(batten_surface_clamp(*surface, direction, &clamped), surface,
                                &clamped);
        if (status != BATTEN_OK)
            return status;
    }
    return BATTEN_OK;
}

batten_status batten_surface_split(const batten_surface *surface, batten_direction direction,
                                   double at, batten_surface **low, batten_surface **high)
{
    assert(surface && low && high);
    const batten_interval domain = batten_surface_domain(surface, direction);
    if (!isfinite(at))
        return bat_fail(BATTEN_NOT_FINITE, "the parameter is %g", at);
    if (at <= domain.a || at >= domain.b)
        return bat_fail(BATTEN_OUT_OF_DOMAIN,
                        "a surface with the domain [%.17g, %.17g] cannot be cut at %.17g",
                        domain.a, domain.b, at);
    batten_surface *first = NULL, *second = NULL;
    batten_status status = batten_surface_subrange(surface, direction, domain.a, at, &first);
    if (status == BATTEN_OK)
        status = batten_surface_subrange(surface, direction, at, domain.b, &second);
    if (status != BATTEN_OK) {
        batten_surface_unref(first);
        return status;
    }
    *low = first;
    *high = second;
    return BATTEN_OK;
}

static batten_status to_bezier(const bat_spline *spline, void *context, bat_spline *out)
{
    (void)context;
    return bat_spline_to_bezier(spline, out);
}

batten_status batten_surface_to_bezier(const batten_surface *surface, batten_surface **out)
{
    assert(surface && out);
    double total = 1;
    for (int k = 0; k < 2; k++) {
        const bat_axis *axis = &bat_surface_nurbs(surface)->axes[k];
        total *= (double)axis->degree * axis->span_count + 1;
    }
    if (total > BAT_MAX_POINTS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "%.0f control points would be needed; the limit is %d", total,
                        BAT_MAX_POINTS);
    batten_surface *along_u = NULL;
    batten_status status = bat_nurbs_change(surface, BATTEN_U, to_bezier, NULL, &along_u);
    if (status == BATTEN_OK)
        status = bat_nurbs_change(along_u, BATTEN_V, to_bezier, NULL, out);
    batten_surface_unref(along_u);
    return status;
}
