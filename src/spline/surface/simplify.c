/* Changes that may move a surface a little: fewer knots, lower degree. */
#include "spline/surface/change.h"

/* How far the surface moves when a row (w x .., w) moves by 1: as for curves, for a surface is
 * a convex combination of its rows. */
static double moved_per_row(const bat_nurbs *nurbs, double tolerance)
{
    if (!nurbs->weights)
        return 1;
    const size_t count = (size_t)nurbs->axes[0].count * (size_t)nurbs->axes[1].count;
    double least = HUGE_VAL;
    for (size_t i = 0; i < count; i++)
        least = bat_min(least, nurbs->weights[i] * nurbs->weight_scale);
    return (1 + sqrt(nurbs->base.dimension) * nurbs->largest + tolerance) / least;
}

/* What is asked of the rows, and what they answer. */
typedef struct {
    size_t group; /* numbers of one control point */
    double at, tolerance, error;
    int times, removed, degree;
} request;

static batten_status remove_one(const bat_spline *spline, void *context, bat_spline *out)
{
    request *asked = context;
    return bat_spline_remove(spline, asked->at, asked->times, asked->group, asked->tolerance,
                             &asked->removed, &asked->error, out);
}

static batten_status reduce(const bat_spline *spline, void *context, bat_spline *out)
{
    request *asked = context;
    return bat_spline_reduce(spline, asked->degree, asked->group, asked->tolerance,
                             &asked->error, out);
}

static batten_status simplify(const batten_surface *surface, batten_direction direction,
                              bat_spline_change change, request *asked, batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    const batten_status status = bat_tolerance_check(asked->tolerance);
    if (status != BATTEN_OK)
        return status;
    const double factor = moved_per_row(nurbs, asked->tolerance);
    asked->group = nurbs->width;
    asked->tolerance /= factor;
    const batten_status made = bat_nurbs_change(surface, direction, change, asked, out);
    asked->error *= factor;
    return made;
}

batten_status batten_surface_remove_knot(const batten_surface *surface, batten_knot_line knot,
                                         double tolerance, int *removed, double *error,
                                         batten_surface **out)
{
    assert(surface && out);
    const bat_axis *axis = &bat_surface_nurbs(surface)->axes[knot.direction];
    const double a = axis->breaks[0], b = axis->breaks[axis->span_count];
    if (knot.times < 0)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a knot cannot be removed %d times", knot.times);
    if (!(knot.at > a && knot.at < b) ||
        bat_knots_multiplicity(axis->degree, axis->count, axis->knots, knot.at) == 0)
        return bat_fail(isfinite(knot.at) ? BATTEN_NOT_FOUND : BATTEN_NOT_FINITE,
                        "%.17g is no knot inside the domain [%.17g, %.17g]", knot.at, a, b);
    request asked = {.at = knot.at, .times = knot.times, .tolerance = tolerance};
    const batten_status status = simplify(surface, knot.direction, remove_one, &asked, out);
    if (status == BATTEN_OK && removed)
        *removed = asked.removed;
    if (status == BATTEN_OK && error)
        *error = asked.error;
    return status;
}

batten_status batten_surface_reduce(const batten_surface *surface, batten_direction direction,
                                    int degree, double tolerance, double *error,
                                    batten_surface **out)
{
    assert(surface && out);
    const int p = batten_surface_degree(surface, direction);
    if (degree < 1 || degree > p)
        return bat_fail(BATTEN_BAD_DEGREE, "degree %d cannot be reduced to %d", p, degree);
    request asked = {.degree = degree, .tolerance = tolerance};
    const batten_status status = simplify(surface, direction, reduce, &asked, out);
    if (status == BATTEN_OK && error)
        *error = asked.error;
    return status;
}
