/* Curves beyond the ends of their domains. */
#include "spline/curve/curve.h"

/* Taylor's series of derivatives D [terms + 1][d] at distance h, and its derivatives. */
static void continue_by(int d, int terms, const double *D, double h, int order, double *out)
{
    for (int k = 0; k <= order; k++)
        for (int c = 0; c < d; c++) {
            double sum = 0;
            for (int j = terms; j >= k; j--)
                sum = D[j * d + c] + sum * (h / (j - k + 1));
            out[k * d + c] = sum;
        }
}

batten_status batten_curve_evaluate_beyond(const batten_curve *curve, double u,
                                           batten_beyond beyond, int order, double *out)
{
    assert(curve && out && order >= 0);
    const batten_interval domain = batten_curve_domain(curve);
    if ((int)beyond < 0 || beyond > BATTEN_BEYOND_LINEAR)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there is no rule %d beyond the domain",
                        (int)beyond);
    const bool inside = !isfinite(u) || (u >= domain.a && u <= domain.b);
    if (inside || beyond == BATTEN_BEYOND_REFUSE || batten_curve_is_periodic(curve))
        return batten_curve_evaluate(curve, u, order, out);
    if (beyond == BATTEN_BEYOND_CONTINUE && batten_curve_is_rational(curve))
        return bat_fail(BATTEN_UNSUPPORTED,
                        "a rational curve has poles, so it does not go on beyond its domain");
    double D[3 * (BATTEN_MAX_DEGREE + 1)];
    const int d = batten_curve_dimension(curve);
    const int terms = beyond == BATTEN_BEYOND_LINEAR ? 1 : batten_curve_degree(curve);
    const double end = u < domain.a ? domain.a : domain.b;
    const batten_status status = batten_curve_evaluate(curve, end, terms, D);
    if (status != BATTEN_OK)
        return status;
    double rows[3 * (BATTEN_MAX_DEGREE + 1)] = {0};
    const int known = bat_min_int(order, terms);
    continue_by(d, terms, D, u - end, known, rows);
    if (bat_first_not_finite(rows, (size_t)((known + 1) * d)) < (size_t)((known + 1) * d))
        return bat_fail(BATTEN_OVERFLOW, "the curve leaves the numbers at %g", u);
    for (int i = 0; i < (order + 1) * d; i++)
        out[i] = i < (known + 1) * d ? rows[i] : 0;
    return BATTEN_OK;
}
