/* Sections as rows of homogeneous coordinates over [0, 1], all of one degree. */
#include "shape/skin/common_knots_parts.h"

#include <float.h>
#include <string.h>

static batten_status normalise(const batten_curve *section, int degree, batten_curve **out)
{
    batten_curve *clamped = NULL, *raised = NULL;
    batten_status status = batten_curve_clamp(section, &clamped);
    if (status == BATTEN_OK)
        status = batten_curve_elevate(clamped, degree - batten_curve_degree(clamped), &raised);
    if (status == BATTEN_OK)
        status = batten_curve_set_domain(raised, 0, 1, out);
    batten_curve_unref(raised);
    batten_curve_unref(clamped);
    return status;
}

static batten_status take_rows(const bat_fitting *f, const batten_curve *curve, bat_spline *out)
{
    const size_t d = (size_t)f->dimension;
    const int n = batten_curve_point_count(curve);
    const batten_status status = bat_spline_make(f->degree, n, f->width, out);
    if (status != BATTEN_OK)
        return status;
    const double *P = batten_curve_points(curve), *w = batten_curve_weights(curve);
    memcpy(out->knots, batten_curve_knots(curve),
           (size_t)(n + f->degree + 1) * sizeof *out->knots);
    for (size_t i = 0; i < (size_t)n; i++) {
        for (size_t c = 0; c < d; c++)
            out->values[i * f->width + c] = (w ? w[i] : 1) * P[i * d + c];
        if (f->rational)
            out->values[i * f->width + d] = w ? w[i] : 1;
    }
    return BATTEN_OK;
}

batten_status bat_common_take(bat_fitting *f, const batten_curve *const *sections)
{
    batten_status status = BATTEN_OK;
    f->periodic = true;
    for (int k = 0; k < f->count; k++) {
        f->periodic = f->periodic && batten_curve_is_periodic(sections[k]);
        f->degree = bat_max_int(f->degree, batten_curve_degree(sections[k]));
        f->rational = f->rational || batten_curve_is_rational(sections[k]);
    }
    f->dimension = batten_curve_dimension(sections[0]);
    f->width = (size_t)f->dimension + f->rational;
    for (int k = 0; status == BATTEN_OK && k < f->count; k++) {
        batten_curve *curve = NULL;
        status = normalise(sections[k], f->degree, &curve);
        if (status == BATTEN_OK)
            status = take_rows(f, curve, &f->given[k]);
        batten_curve_unref(curve);
    }
    return status;
}

batten_status bat_common_check_tolerance(const bat_fitting *f)
{
    double size = 0;
    for (int k = 0; k < f->count; k++)
        for (size_t i = 0; i < (size_t)f->given[k].count * f->width; i++)
            size = bat_max(size, fabs(f->given[k].values[i]));
    if (f->tolerance < 64 * DBL_EPSILON * size)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "the tolerance %g is lost in the rounding of coordinates of %g; 0 asks "
                        "for the exact skin",
                        f->tolerance, size);
    return BATTEN_OK;
}
