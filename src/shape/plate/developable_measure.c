/* What is reported of a developable surface: warp, area and the curvature of its rulings. */
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/plate/developable_parts.h"

enum { LOOKS = 4 };

/* The ruling at u; `before` is the normal midway along the one before it. */
static batten_status look_at_ruling(const batten_surface *surface, double u, batten_side side,
                                    batten_vec3 *before, batten_developable *out)
{
    double a[9], b[9];
    batten_status status = batten_surface_evaluate_side(
        surface, u, 0, (batten_sides){side, BATTEN_FROM_RIGHT}, 1, a);
    if (status == BATTEN_OK)
        status = batten_surface_evaluate_side(surface, u, 1,
                                              (batten_sides){side, BATTEN_FROM_LEFT}, 1, b);
    if (status != BATTEN_OK)
        return status;
    const batten_vec3 d = bat_vec3_subtract(bat_vec3_of(3, b), bat_vec3_of(3, a));
    const double length = bat_vec3_norm(d);
    const batten_vec3 r = bat_vec3_scale(d, length > 0 ? 1 / length : 0);
    const batten_vec3 m = bat_vec3_cross(bat_vec3_of(3, a + 3), r);
    const batten_vec3 n = bat_vec3_cross(bat_vec3_of(3, b + 3), r);
    const double p = bat_vec3_norm(m), q = bat_vec3_norm(n);
    /* Where neighbouring rulings change sides, the edges cross between them. */
    const batten_vec3 middle = bat_vec3_add(m, n);
    const double size = bat_vec3_norm(middle);
    if (size > 0 && bat_vec3_dot(middle, *before) < 0) {
        out->warp = BAT_PI;
        out->warp_at = u;
    }
    if (size > 0)
        *before = bat_vec3_scale(middle, 1 / size);
    /* The end that rests in a cone moves by rounding only. */
    if (!(bat_min(p, q) > BAT_MEANT_SAME * bat_max(p, q)))
        return BATTEN_OK;
    const batten_vec3 m1 = bat_vec3_scale(m, 1 / p), n1 = bat_vec3_scale(n, 1 / q);
    const double cosine = bat_vec3_dot(m1, n1);
    const double warp = bat_atan2(bat_vec3_norm(bat_vec3_cross(m1, n1)), cosine);
    if (warp > out->warp) {
        out->warp = warp;
        out->warp_at = u;
    }
    /* Both ends move to opposite sides: neighbouring rulings meet between them. */
    if (cosine < 0 && !out->has_regression) {
        out->has_regression = true;
        out->regression_at = u;
        out->regression_share = p / (p + q);
    }
    return BATTEN_OK;
}

batten_status bat_plate_measure(const batten_surface_developable_options *options,
                                batten_developable *out)
{
    const int count = batten_surface_spans(out->surface, BATTEN_U, NULL);
    double *knots = bat_array((size_t)count, sizeof *knots);
    if (!knots)
        return BATTEN_OUT_OF_MEMORY;
    batten_surface_spans(out->surface, BATTEN_U, knots);
    batten_status status = BATTEN_OK;
    batten_vec3 before = {0, 0, 0};
    for (int k = 0; k + 1 < count; k++)
        for (int i = 0; i <= LOOKS && status == BATTEN_OK; i++) {
            const double u = knots[k] + (knots[k + 1] - knots[k]) * i / LOOKS;
            const bool last = i == LOOKS;
            status = look_at_ruling(out->surface, last ? knots[k + 1] : u,
                                    last ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT, &before, out);
        }
    bat_release(knots);
    out->is_developable = out->warp <= options->warp && !out->has_regression;
    return status;
}
