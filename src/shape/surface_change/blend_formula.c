/* The surface of kind "blend": ribbons with different weights, blended point by point. */
#include "shape/surface_change/blend.h"
#include "spline/curve/curve.h"

#include <string.h>

void bat_blend_free(void *data)
{
    bat_blend *b = data;
    for (int i = 0; b && i < BAT_BLEND_CURVES; i++)
        batten_curve_unref(b->curves[i]);
    bat_release(b);
}

int bat_blend_rows(const bat_blend *b)
{
    return b->count[0] + b->count[1];
}

/* A polynomial in Bezier form and its derivatives to order 3. */
static void bezier(int q, const double *rows, double v, int order, double *out)
{
    double work[BAT_BLEND_ROWS], basis[BAT_BLEND_ROWS];
    memcpy(work, rows, (size_t)(q + 1) * sizeof *work);
    for (int l = 0; l <= order; l++) {
        out[l] = 0;
        if (q - l < 0)
            continue;
        bat_bernstein(q - l, v, 1 - v, basis);
        for (int r = 0; r <= q - l; r++)
            out[l] += basis[r] * work[r];
        for (int r = 0; r < q - l; r++)
            work[r] = (q - l) * (work[r + 1] - work[r]);
    }
}

static batten_status evaluate(const void *data, const bat_surface_place *at, int order,
                              double *out)
{
    const bat_blend *b = data;
    memset(out, 0, (size_t)BATTEN_SURFACE_DERIVATIVES(order) * 3 * sizeof *out);
    for (int k = 0; k < BAT_BLEND_CURVES; k++) {
        double along[12], across[4];
        if (!b->curves[k])
            continue;
        const batten_status status =
            batten_curve_evaluate_side(b->curves[k], at->u, at->sides.u, order, along);
        if (status != BATTEN_OK)
            return status;
        bezier(bat_blend_rows(b) - 1, b->part[k], at->v, order, across);
        for (int total = 0; total <= order; total++)
            for (int l = 0; l <= total; l++)
                for (int c = 0; c < 3; c++)
                    out[3 * BATTEN_SURFACE_DERIVATIVE(total - l, l) + c] +=
                        across[l] * along[3 * (total - l) + c];
    }
    return BATTEN_OK;
}

const bat_formula bat_blend_formula = {"blend", evaluate, NULL, bat_blend_free};
