/* Rational splines in tension: spans A (1 - t) + B t + C (1 - t)^3 / (1 + p t) + D t^3 / (1 + p (1 - t)), as exact rational quartics. */
#include "shape/linear/tension.h"
#include "spline/data_check.h"

#include <batten/bent.h>
#include <string.h>

enum { DEGREE = 4 };

/* Beyond it a span is its chord but for a millionth of the bends at its ends. */
static const double most_tension = 1e6;

static batten_status check_tensions(const bat_tension *t)
{
    for (int i = 0; i < t->spans; i++)
        if (t->sigma[i] > most_tension)
            return bat_fail(
                BATTEN_BAD_ARGUMENT,
                "the tension of span %d is %g; 0 to %g is possible, where the curve "
                "is the polygon",
                i + 1, t->sigma[i], most_tension);
    return BATTEN_OK;
}

/*
 * Over the common denominator w = (1 + p t) (1 + p (1 - t)), divided by 1 + p: its Bezier coefficients of degree 2 are 1, m
 * and 1; those of C (1 - t)^3 (1 + p (1 - t)) of degree 4 are C (1 + p), C / 4, 0, 0 and 0.
 */
static void set_span(const bat_tension *t, int i, double *points, double *weights)
{
    const int d = t->dimension, next = bat_tension_next(t, i);
    const double p = t->sigma[i], m = 1 + p * p / (2 * (1 + p));
    const double bend = (t->u[i + 1] - t->u[i]) * t->b[i];
    const double w[DEGREE + 1] = {1, (1 + m) / 2, (1 + 2 * m) / 3, (1 + m) / 2, 1};
    for (int k = 0; k < d; k++) {
        const double C = bend * t->moments[i * d + k], D = bend * t->moments[next * d + k];
        const double from = t->points[i * d + k], to = t->points[next * d + k];
        const double A = from - C, B = to - D;
        const double cubic[4] = {A, (2 * A * m + B) / 3, (A + 2 * B * m) / 3, B};
        points[d + k] = ((cubic[0] + 3 * cubic[1]) / 4 + C / (4 * (1 + p))) / w[1];
        points[2 * d + k] = (cubic[1] + cubic[2]) / 2 / w[2];
        points[3 * d + k] = ((3 * cubic[2] + cubic[3]) / 4 + D / (4 * (1 + p))) / w[3];
        points[k] = from;
        points[4 * d + k] = to;
    }
    memcpy(weights, w, sizeof w);
}

static batten_status make_curve(const bat_tension *t, batten_curve **out)
{
    const size_t d = (size_t)t->dimension, count = (size_t)t->spans * DEGREE + 1;
    double *points = bat_array3(count, d, sizeof *points);
    double *weights = bat_array(count, sizeof *weights);
    batten_status status = points && weights ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < t->spans && status == BATTEN_OK; i++)
        set_span(t, i, points + (size_t)i * DEGREE * d, weights + (size_t)i * DEGREE);
    if (status == BATTEN_OK)
        status = batten_curve_from_bezier(
            t->dimension, (batten_pieces){.degree = DEGREE, .count = t->spans, .breaks = t->u},
            points, weights, out);
    bat_release(points);
    bat_release(weights);
    return status;
}

batten_status batten_curve_rational_tension(batten_points points,
                                            const batten_chain_tension_options *options,
                                            double *parameters, batten_curve **out)
{
    assert(points.at && out);
    batten_chain_tension_options o = batten_chain_tension_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_tension_options, options, &o);
    if (status == BATTEN_OK)
        status = bat_points_check(points.dimension, points.count, points.at, o.closed ? 3 : 2);
    if (status == BATTEN_OK && o.rule != BATTEN_TENSION_GIVEN)
        status = bat_fail(BATTEN_BAD_ARGUMENT,
                          "rational splines take their tensions as given, without a rule");
    if (status != BATTEN_OK)
        return status;
    bat_tension t = {.dimension = points.dimension,
                     .count = points.count,
                     .spans = o.closed ? points.count : points.count - 1,
                     .closed = o.closed,
                     .rational = true,
                     .points = points.at};
    status = bat_tension_begin(&t, &o);
    if (status == BATTEN_OK)
        status = check_tensions(&t);
    if (status == BATTEN_OK)
        status = bat_tension_solve(&t);
    if (status == BATTEN_OK)
        status = bat_tension_check_slopes(&t);
    if (status == BATTEN_OK)
        status = make_curve(&t, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, t.u, (size_t)points.count * sizeof *parameters);
    bat_tension_end(&t);
    return status;
}
