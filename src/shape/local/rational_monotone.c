/* The monotone rational quadratic of Gregory and Delbourgo. */
#include "shape/local/hermite_data.h"

#include <string.h>

/* With v = (m0 + m1) / d the function on a span is, in t from 0 to 1,
 *     (y0 (1 - t)^2 + (m0 y1 + m1 y0) / d t (1 - t) + y1 t^2) / ((1 - t)^2 + v t (1 - t) +
 * t^2). Both and x times the denominator are cubics; their Bezier values are these. */
static void span(const bat_chords *c, int i, const double *slopes, double *points,
                 double *weights)
{
    const double d = c->d[i], m0 = d == 0 ? 1 : slopes[i] / d,
                 m1 = d == 0 ? 1 : slopes[i + 1] / d;
    const double v = m0 + m1, x0 = c->x[i], y0 = c->y[i], h = c->h[i];
    const double rise = c->y[i + 1] - y0;
    weights[0] = 1;
    weights[1] = weights[2] = (1 + v) / 3;
    points[0] = x0;
    points[1] = y0;
    points[2] = x0 + h / (1 + v);
    points[3] = y0 + rise * (m0 / (1 + v));
    points[4] = x0 + h * (v / (1 + v));
    points[5] = y0 + rise * ((m0 + 1) / (1 + v));
}

static batten_status check_slopes(const bat_chords *c, const double *slopes)
{
    batten_status status = bat_local_check_rows(1, c->count, slopes, "slope");
    for (int i = 0; i + 1 < c->count && status == BATTEN_OK; i++) {
        const double d = c->d[i], a = slopes[i], b = slopes[i + 1];
        const bool good = d > 0   ? a >= 0 && b >= 0
                          : d < 0 ? a <= 0 && b <= 0
                                  : a == 0 && b == 0;
        if (!good || !isfinite((a + b) / (d == 0 ? 1 : d)))
            status = bat_fail(BATTEN_BAD_ARGUMENT,
                              "span %d has the slope %g, but slopes %g and %g at its ends",
                              i + 1, d, a, b);
    }
    return status;
}

static batten_status make_rational_pieces(const bat_chords *c, const double *slopes,
                                          double *points, double *weights, batten_curve **out)
{
    const batten_status status = check_slopes(c, slopes);
    if (status != BATTEN_OK)
        return status;
    const int last = c->count - 1;
    for (int i = 0; i < last; i++)
        span(c, i, slopes, points + 6 * (size_t)i, weights + 3 * (size_t)i);
    points[6 * (size_t)last] = c->x[last];
    points[6 * (size_t)last + 1] = c->y[last];
    weights[3 * (size_t)last] = 1;
    return batten_curve_from_bezier(2, (batten_pieces){3, last, c->x}, points, weights, out);
}

batten_status batten_curve_rational_monotone(int count, const double *x, const double *y,
                                             const double *slopes, batten_curve **out)
{
    assert(x && y && out);
    bat_chords chords;
    batten_status status = bat_chords_make(count, x, y, &chords);
    if (status != BATTEN_OK)
        return status;
    double *found = bat_array((size_t)count, sizeof *found);
    double *points = bat_array3((size_t)count, 6, sizeof *points);
    double *weights = bat_array3((size_t)count, 3, sizeof *weights);
    status = BATTEN_OUT_OF_MEMORY;
    if (found && points && weights) {
        if (!slopes)
            bat_slopes(&chords, BATTEN_SLOPE_FRITSCH_BUTLAND, found);
        status = make_rational_pieces(&chords, slopes ? slopes : found, points, weights, out);
    }
    bat_release(found);
    bat_release(points);
    bat_release(weights);
    bat_chords_free(&chords);
    return status;
}
