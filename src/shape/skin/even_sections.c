/* Sections of even speed. */
#include "shape/skin/steps.h"

#include <string.h>

/* At a knot that stands p times, its first at i: by how much the curve is faster behind it,
 * when its tangent is continuous; 0 at a corner, 1 at other knots. */
static double speed_ratio(const batten_curve *curve, int i)
{
    const int p = batten_curve_degree(curve), d = batten_curve_dimension(curve);
    const double *U = batten_curve_knots(curve);
    if (U[i] != U[i + p - 1])
        return 1;
    const double *on = batten_curve_points(curve) + (size_t)(i - 1) * (size_t)d;
    double before[3], after[3];
    for (int c = 0; c < d; c++) {
        before[c] = on[c] - on[c - d];
        after[c] = on[c + d] - on[c];
    }
    const double a = bat_norm(d, before), b = bat_norm(d, after);
    if (!(a > 0 && b > 0) || bat_dot(d, before, after) < bat_cos(bat_skin_corner) * a * b)
        return 0;
    const double ratio = (b / (U[i + p] - U[i])) / (a / (U[i] - U[i - 1]));
    return ratio > 1.0 / 64 && ratio < 64 ? ratio
                                          : 0; /* beyond, stretching would leave slivers */
}

/* Stretch the spans between two corners, or ends, U[first] and U[last], by the speeds there:
 * `stretched` begins with the knots in [first, last) and is made to end where they do. */
static void restore_length(const double *U, int first, int last, double *stretched)
{
    const double given = U[last] - U[first], found = stretched[last] - stretched[first];
    for (int i = first; i <= last; i++)
        stretched[i] = U[first] + (stretched[i] - stretched[first]) * (given / found);
    stretched[last] = U[last];
}

static void stretch(const batten_curve *curve, double *knots)
{
    const int p = batten_curve_degree(curve), n = batten_curve_point_count(curve);
    const double *U = batten_curve_knots(curve);
    double factor = 1;
    memcpy(knots, U, (size_t)(n + p + 1) * sizeof *knots);
    int corner = p;
    for (int i = p + 1; i <= n; i++) {
        knots[i] = U[i] == U[i - 1] ? knots[i - 1] : knots[i - 1] + factor * (U[i] - U[i - 1]);
        if (i < n && U[i] == U[i - 1])
            continue;
        const double ratio = i < n ? speed_ratio(curve, i) : 0;
        factor *= ratio;
        if (ratio == 0) {
            restore_length(U, corner, i, knots);
            corner = i;
            factor = 1;
        }
    }
}

batten_status bat_skin_even_speed(const batten_curve *section, batten_curve **out)
{
    batten_curve *clamped = NULL;
    batten_status status = batten_curve_clamp(section, &clamped);
    if (status != BATTEN_OK || batten_curve_is_rational(clamped)) {
        if (status == BATTEN_OK)
            *out = clamped;
        return status;
    }
    const int p = batten_curve_degree(clamped), n = batten_curve_point_count(clamped);
    double *knots = bat_array((size_t)(n + p + 1), sizeof *knots);
    status = knots ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK) {
        stretch(clamped, knots);
        for (int i = n + 1; i <= n + p; i++)
            knots[i] = knots[n];
        status = batten_curve_create(
            (batten_points){batten_curve_dimension(clamped), n, batten_curve_points(clamped)},
            p, NULL, knots, out);
    }
    bat_release(knots);
    batten_curve_unref(clamped);
    return status;
}
