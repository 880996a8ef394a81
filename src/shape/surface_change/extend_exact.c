/*
 * Extensions that are exact. For S = A / w the rows A, w may continue straight with the
 * derivatives A' + g A, w' + g w for any number g: S' is the same. g is such that w does not
 * grow, so that the extension reaches as far as is asked; where w' = c w all along the edge, g
 * = -c, and w stays what it is.
 */
#include "shape/surface_change/extend.h"

#include "numeric/vector.h"
#include "shape/curve_change/extend.h"
#include "spline/surface/change.h"

#include <float.h>
#include <string.h>

typedef struct {
    double way;
    size_t width; /* of one control point */
    bool rational;
} wish;

/* The derivative of row n - 1, a clamped end. */
static void end_slope(const bat_spline *from, double *slope)
{
    const int p = from->degree, n = from->count;
    const double *last = from->values + (size_t)(n - 1) * from->width;
    const double factor = p / (from->knots[n] - from->knots[n - 1]);
    for (size_t i = 0; i < from->width; i++)
        slope[i] = factor * (last[i] - *(last + i - from->width));
}

/* In place; true when A and w stay C1. */
static bool tame_weights(const wish *w, const bat_spline *from, double *slope)
{
    const double *last = from->values + (size_t)(from->count - 1) * from->width;
    double least = HUGE_VAL, most = -HUGE_VAL;
    if (!w->rational)
        return true;
    for (size_t i = w->width - 1; i < from->width; i += w->width) {
        least = bat_min(least, slope[i] / last[i]);
        most = bat_max(most, slope[i] / last[i]);
    }
    const double speed =
        from->degree / (from->knots[from->count] - from->knots[from->count - 1]);
    const double noise = 64 * DBL_EPSILON * speed;
    if (bat_max(fabs(least), fabs(most)) <= noise)
        most = 0;
    for (size_t i = 0; i < from->width; i++)
        slope[i] -= most * last[i];
    if (most - least <= noise)
        for (size_t i = w->width - 1; i < from->width; i += w->width)
            slope[i] = 0;
    return most == 0;
}

static batten_status straight(const bat_spline *from, void *context, bat_spline *out)
{
    const wish *w = context;
    const int p = from->degree, n = from->count;
    double *slope = bat_array(from->width, sizeof *slope);
    if (!slope)
        return BATTEN_OUT_OF_MEMORY;
    end_slope(from, slope);
    /* With C1 the row of the old edge lies on the line of its neighbours, and goes. */
    const int smooth = tame_weights(w, from, slope), kept = n - smooth;
    const batten_status status = bat_spline_make(p, kept + p, from->width, out);
    if (status == BATTEN_OK) {
        const double *last = from->values + (size_t)(n - 1) * from->width;
        memcpy(out->values, from->values, (size_t)kept * from->width * sizeof *out->values);
        for (int i = 1; i <= p; i++)
            for (size_t k = 0; k < from->width; k++)
                out->values[(size_t)(kept + i - 1) * from->width + k] =
                    last[k] + w->way * i / p * slope[k];
        memcpy(out->knots, from->knots, (size_t)(kept + p) * sizeof *out->knots);
        for (int i = 0; i <= p; i++)
            out->knots[kept + p + i] = from->knots[n] + w->way;
    }
    bat_release(slope);
    return status;
}

static batten_status natural(const bat_spline *from, void *context, bat_spline *out)
{
    const wish *w = context;
    return bat_spline_go_on(from, from->knots[from->count] + w->way, out);
}

/* Weights of what was made, seen before it is divided by them. */
static batten_status check_rows(const wish *w, const bat_spline *made)
{
    const size_t count = (size_t)made->count * made->width;
    if (bat_first_not_finite(made->values, count) < count)
        return bat_fail(BATTEN_OVERFLOW, "the surface leaves the numbers");
    for (size_t i = w->width - 1; w->rational && i < count; i += w->width)
        if (!(made->values[i] > 0))
            return bat_fail(BATTEN_BAD_WEIGHT,
                            "gone on by %g of its parameter, the surface has the weight %g",
                            w->way, made->values[i]);
    return BATTEN_OK;
}

static batten_status checked(const bat_spline *from, wish *w, bat_spline_change change,
                             bat_spline *out)
{
    batten_status status = change(from, w, out);
    if (status != BATTEN_OK)
        return status;
    status = check_rows(w, out);
    if (status != BATTEN_OK)
        bat_spline_free(out);
    return status;
}

static batten_status straight_checked(const bat_spline *from, void *context, bat_spline *out)
{
    return checked(from, context, straight, out);
}

static batten_status natural_checked(const bat_spline *from, void *context, bat_spline *out)
{
    return checked(from, context, natural, out);
}

static wish wish_of(const batten_surface *surface, double way)
{
    const bat_nurbs *nurbs = bat_surface_nurbs(surface);
    return (wish){way, nurbs->width, nurbs->weights != NULL};
}

batten_status bat_surface_straight_on(const batten_surface *surface, double way,
                                      batten_surface **out)
{
    wish w = wish_of(surface, way);
    return bat_nurbs_change(surface, BATTEN_V, straight_checked, &w, out);
}

batten_status bat_surface_go_on(const batten_surface *surface, double way, batten_surface **out)
{
    wish w = wish_of(surface, way);
    return bat_nurbs_change(surface, BATTEN_V, natural_checked, &w, out);
}
