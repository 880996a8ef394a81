/* Spans in tension: P'''' = tension^2 P'', by the points and the second derivatives at both
 * ends. */
#include "spline/chain/chain.h"

/* 3!, 5! .. 19! */
static const double odd_factorials[] = {6,
                                        120,
                                        5040,
                                        362880,
                                        39916800,
                                        6227020800,
                                        1307674368000,
                                        355687428096000,
                                        121645100408832000};

/* (sinh y - y) / y^3 and (cosh y - 1) / y^2 for 0 <= y <= 1, by their series in y^2: the first
 * term left out is below 1 / 20! there, which is lost in the rounding of the first. */
static double sinh_rest(double y)
{
    double sum = 0;
    for (int k = 8; k >= 0; k--)
        sum = sum * (y * y) + 1 / odd_factorials[k];
    return sum;
}

static double cosh_rest(double y)
{
    static const double factorials[] = {
        2, 24, 720, 40320, 3628800, 479001600, 87178291200, 20922789888000, 6402373705728000};
    double sum = 0;
    for (int k = 8; k >= 0; k--)
        sum = sum * (y * y) + 1 / factorials[k];
    return sum;
}

static void shape_by_series(double z, double x, double out[4])
{
    const double y = z * x, S = sinh_rest(y), C = cosh_rest(y), S1 = sinh_rest(z);
    const double q = 1 / (1 + z * z * S1); /* z / sinh z */
    out[0] = q * x * (x * x * S - S1);
    out[1] = q * (x * x * C - S1);
    out[2] = q * x * (1 + y * y * S);
    out[3] = q * (1 + y * y * C);
}

void bat_tension_shape(double z, double x, double rest, double out[4])
{
    if (z <= 1) {
        shape_by_series(z, x, out);
        return;
    }
    /* All exponents are below 0, so that no tension is too large. */
    const double e = bat_exp(-z * rest), scale = -bat_expm1(-2 * z);
    const double sine = e * (-bat_expm1(-2 * z * x) / scale);
    const double cosine = e * ((1 + bat_exp(-2 * z * x)) / scale);
    out[0] = (sine - x) / z / z;
    out[1] = (cosine - 1 / z) / z;
    out[2] = sine;
    out[3] = z * cosine;
}

void bat_span_tension(int d, const batten_span *span, double t, int order, double *out)
{
    const double h = span->length, z = span->tension * h;
    const double x = t / h, rest = (h - t) / h;
    double up[4], down[4]; /* those that belong to the second derivative at end and start */
    bat_tension_shape(z, x, rest, up);
    bat_tension_shape(z, rest, x, down);
    for (int k = 0; k < d; k++) {
        const double A = span->start[k], B = span->end[k];
        const double M = span->bend[0][k], N = span->bend[1][k];
        out[k] = rest * A + x * B + h * (h * (M * down[0] + N * up[0]));
        if (order >= 1)
            out[d + k] = (B - A) / h + h * (N * up[1] - M * down[1]);
        if (order >= 2)
            out[2 * d + k] = M * down[2] + N * up[2];
        if (order >= 3)
            out[3 * d + k] = (N * up[3] - M * down[3]) / h;
    }
}

batten_status bat_span_tension_check(const batten_span *span, int index)
{
    if (!isfinite(span->tension * span->length))
        return bat_fail(BATTEN_OVERFLOW,
                        "span %d: its tension %g times its length %g is too large", index + 1,
                        span->tension, span->length);
    return BATTEN_OK;
}
