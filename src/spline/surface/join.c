/* Two surfaces side by side. */
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include "spline/surface/change.h"

#include <string.h>

/* ---- making them alike ---- */

/* Clamped, and of this degree. */
static batten_status prepare_direction(batten_surface **surface, batten_direction direction,
                                       int degree)
{
    batten_surface *changed = NULL;
    batten_status status = batten_surface_clamp(*surface, direction, &changed);
    status = bat_surface_replace(status, surface, &changed);
    const int by = degree - batten_surface_degree(*surface, direction);
    if (status != BATTEN_OK || by == 0)
        return status;
    status = batten_surface_elevate(*surface, direction, by, &changed);
    return bat_surface_replace(status, surface, &changed);
}

static batten_status prepare(const batten_surface *surface, const int degrees[2], bool rational,
                             batten_surface **out)
{
    batten_surface *made = batten_surface_ref(surface), *changed = NULL;
    batten_status status = BATTEN_OK;
    for (int k = 0; k < 2 && status == BATTEN_OK; k++)
        status = prepare_direction(&made, (batten_direction)k, degrees[k]);
    if (status == BATTEN_OK && rational && !batten_surface_is_rational(made)) {
        status = batten_surface_to_rational(made, &changed);
        status = bat_surface_replace(status, &made, &changed);
    }
    if (status == BATTEN_OK)
        *out = made;
    else
        batten_surface_unref(made);
    return status;
}

/* The knots of `other` that `axis` lacks, each as often as it lacks it: out [knots of other].
 */
static int missing_knots(const bat_axis *axis, const bat_axis *other, double *out)
{
    const int n = axis->count + axis->degree + 1, m = other->count + other->degree + 1;
    int count = 0;
    for (int i = 0, j = 0; j < m; j++) {
        while (i < n && axis->knots[i] < other->knots[j])
            i++;
        if (i < n && axis->knots[i] == other->knots[j])
            i++;
        else
            out[count++] = other->knots[j];
    }
    return count;
}

static batten_status take_knots(batten_surface **surface, const batten_surface *from,
                                batten_direction direction)
{
    const bat_axis *other = &bat_surface_nurbs(from)->axes[direction];
    double *knots = bat_array((size_t)other->count + (size_t)other->degree + 1, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface *changed = NULL;
    const int count =
        missing_knots(&bat_surface_nurbs(*surface)->axes[direction], other, knots);
    const batten_status status =
        batten_surface_refine(*surface, direction, count, knots, &changed);
    bat_release(knots);
    return bat_surface_replace(status, surface, &changed);
}

/* The same knots across the joint: those of both, on the domain of the first. */
static batten_status unify_across(batten_surface **a, batten_surface **b,
                                  batten_direction across)
{
    const batten_interval domain = batten_surface_domain(*a, across);
    batten_surface *changed = NULL;
    batten_status status = batten_surface_set_domain(*b, across, domain.a, domain.b, &changed);
    status = bat_surface_replace(status, b, &changed);
    if (status == BATTEN_OK)
        status = take_knots(b, *a, across);
    if (status == BATTEN_OK)
        status = take_knots(a, *b, across);
    return status;
}

/* ---- joining ---- */

typedef struct {
    const bat_spline *first, *second;
    size_t width; /* of one control point */
    bool rational;
    double factor; /* of the weights of the second */
    double tolerance;
} joint;

/* The distance of the two edges at one point, and what different weights may add to it. */
static double gap_at(const joint *work, const double *a, const double *b)
{
    const int d = (int)work->width - work->rational;
    if (!work->rational)
        return bat_distance(d, a, b);
    double x[3], y[3];
    for (int k = 0; k < d; k++) {
        x[k] = a[k] / a[d];
        y[k] = b[k] / b[d];
    }
    const double mismatch = fabs(b[d] * work->factor / a[d] - 1);
    /* Equal to the last few bits is equal. */
    return bat_distance(d, x, y) + (mismatch > 64 * 0x1p-52 ? mismatch * bat_norm(d, x) : 0);
}

static batten_status check_gap(const joint *work)
{
    const double *a =
        work->first->values + (size_t)(work->first->count - 1) * work->first->width;
    const double *b = work->second->values;
    for (size_t i = 0; i < work->first->width; i += work->width) {
        const double gap = gap_at(work, a + i, b + i);
        if (!(gap <= work->tolerance))
            return bat_fail(BATTEN_NOT_COMPATIBLE,
                            "the edges to join are %g apart at control point %zu, more than %g",
                            gap, i / work->width + 1, work->tolerance);
    }
    return BATTEN_OK;
}

/* Those of the second go on where those of the first end. */
static void fill_knots(const bat_spline *first, const bat_spline *second, bat_spline *made)
{
    const int p = first->degree, n = first->count, m = second->count;
    const double end = first->knots[n], start = second->knots[p];
    memcpy(made->knots, first->knots, (size_t)(n + p) * sizeof *made->knots);
    for (int i = p + 1; i <= m + p; i++)
        made->knots[n - 1 + i] =
            end == start ? second->knots[i] : end + (second->knots[i] - start);
}

static void fill_joined(const joint *work, bat_spline *made)
{
    const bat_spline *first = work->first, *second = work->second;
    const int n = first->count, m = second->count;
    const size_t width = first->width, before = (size_t)(n - 1) * width;
    memcpy(made->values, first->values, (size_t)n * width * sizeof *made->values);
    for (size_t i = 0; i < (size_t)m * width; i++) {
        double *value = made->values + before + i;
        const double other = second->values[i] * work->factor;
        *value = i < width ? *value + (other - *value) / 2 : other;
    }
    fill_knots(first, second, made);
}

static batten_status join_splines(joint *work, bat_spline *out)
{
    const bat_spline *first = work->first, *second = work->second;
    bat_spline made;
    batten_status status = check_gap(work);
    if (status == BATTEN_OK)
        status = bat_spline_make(first->degree, first->count + second->count - 1, first->width,
                                 &made);
    if (status != BATTEN_OK)
        return status;
    fill_joined(work, &made);
    status = bat_knots_check(made.degree, made.count, made.knots, "joined knot");
    if (status == BATTEN_OK)
        *out = made;
    else
        bat_spline_free(&made);
    return status;
}

static batten_status append(const bat_spline *first, void *context, bat_spline *out)
{
    joint *work = context;
    const size_t last = (size_t)(first->count - 1) * first->width;
    work->first = first;
    work->factor = work->rational ? first->values[last + work->width - 1] /
                                        work->second->values[work->width - 1]
                                  : 1;
    return join_splines(work, out);
}

static batten_status join_alike(const batten_surface *a, const batten_surface *b,
                                batten_direction direction, double tolerance,
                                batten_surface **out)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(b);
    bat_spline second;
    batten_status status = bat_nurbs_to_spline(nurbs, direction, &second);
    if (status != BATTEN_OK)
        return status;
    joint work = {.second = &second,
                  .width = nurbs->width,
                  .rational = nurbs->weights != NULL,
                  .tolerance = tolerance};
    status = bat_nurbs_change(a, direction, append, &work, out);
    bat_spline_free(&second);
    return status;
}

batten_status batten_surface_join(const batten_surface *first, const batten_surface *second,
                                  batten_direction direction, double tolerance,
                                  batten_surface **out)
{
    assert(first && second && out);
    batten_status status = bat_tolerance_check(tolerance);
    if (status != BATTEN_OK)
        return status;
    if (first->dimension != second->dimension)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the surfaces have %d and %d dimensions",
                        first->dimension, second->dimension);
    const bool rational =
        batten_surface_is_rational(first) || batten_surface_is_rational(second);
    int degrees[2];
    for (int k = 0; k < 2; k++)
        degrees[k] = bat_max_int(batten_surface_degree(first, (batten_direction)k),
                                 batten_surface_degree(second, (batten_direction)k));
    batten_surface *a = NULL, *b = NULL;
    status = prepare(first, degrees, rational, &a);
    if (status == BATTEN_OK)
        status = prepare(second, degrees, rational, &b);
    if (status == BATTEN_OK)
        status = unify_across(&a, &b, bat_other(direction));
    if (status == BATTEN_OK)
        status = join_alike(a, b, direction, tolerance, out);
    batten_surface_unref(a);
    batten_surface_unref(b);
    return status;
}
