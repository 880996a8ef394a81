/* Spans whose curvature is a polynomial of arc length: lines, arcs, clothoids, and splines
 * after Spiro. */
#include "numeric/fresnel.h"
#include "spline/chain/chain.h"

/* theta(t s) - angle, s in [0, 1], by powers of s. */
static void turning(const batten_span *span, double t, double c[BAT_FRESNEL_DEGREE + 1])
{
    const double *k = span->curvature;
    c[0] = 0;
    c[1] = k[0] * t;
    c[2] = k[1] * t * t / 2;
    c[3] = k[2] * t * t * t / 6;
    c[4] = k[3] * t * t * t * t / 24;
}

batten_status bat_span_spiral_check(const batten_span *span, int index)
{
    double c[BAT_FRESNEL_DEGREE + 1];
    turning(span, span->length, c);
    const double turn = fabs(c[1]) + fabs(c[2]) + fabs(c[3]) + fabs(c[4]);
    if (turn <= BAT_FRESNEL_TURN)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOO_LARGE, "span %d turns by up to %g radians; the limit is %g",
                    index + 1, turn, BAT_FRESNEL_TURN);
}

void bat_span_spiral(int d, const batten_span *span, double t, int order, double *out)
{
    const double *k = span->curvature;
    double c[BAT_FRESNEL_DEGREE + 1], x = 0, y = 0;
    assert(d == 2);
    turning(span, t, c);
    const double angle = span->angle + (c[1] + c[2] + c[3] + c[4]);
    c[0] = span->angle;
    bat_fresnel(c, 1, &x, &y);
    out[0] = span->start[0] + t * x;
    out[1] = span->start[1] + t * y;
    if (order < 1)
        return;
    const double T[2] = {bat_cos(angle), bat_sin(angle)}, N[2] = {-T[1], T[0]};
    const double curvature = k[0] + t * (k[1] + t * (k[2] / 2 + t * (k[3] / 6)));
    const double rate = k[1] + t * (k[2] + t * (k[3] / 2));
    for (int i = 0; i < d; i++) {
        out[2 + i] = T[i];
        if (order >= 2)
            out[4 + i] = curvature * N[i];
        if (order >= 3)
            out[6 + i] = rate * N[i] - curvature * curvature * T[i];
    }
}
