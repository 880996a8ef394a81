/*
 * The free elastica, k'' + k^3 / 2 = 0 along arc length s, in closed form by Jacobi's functions
 * of the parameter m = 1/2.
 *
 * With lambda^4 = k'^2 + k^4 / 4, which stays the same along the curve, k = sqrt(2) lambda
 * cn(v), v = lambda s + phase. The tangent is (cn^2 v, sqrt(2) sn v dn v) in the frame of the
 * force that bends the curve: it never points backwards there. Along the first axis the point
 * moves by the integral of cn^2, 2 E(v) - v, and across it by what sqrt(2) cn v loses, both
 * divided by lambda. The addition theorems in v = phase + delta, delta = lambda s, need
 * functions of delta alone, and nothing cancels when the curve is almost straight.
 */
#include "spline/chain/chain.h"

/* Jacobi's functions at one place, m = 1/2. */
typedef struct {
    double sn, cn, dn;
    double gain; /* the integral of cn^2 from 0 */
} jacobi;

/* Of the descending Landen transformations. */
static const double landen_ratios[] = {0.1715728752538099024, 0.00746966672950958191,
                                       1.394936942369415740e-05, 4.864622683763723359e-11};
static const double landen_steps[] = {0.1464466094067262378, 0.006328487669779609585,
                                      1.181808830134060611e-05, 4.121371990270229469e-11};

/* By arithmetic-geometric means, from a = 1, b = c = sqrt(1/2): 2^4 a_4, c_n / a_n and c_n; the
 * next c is 5e-22. [DLMF] 22.20. */
static jacobi jacobi_at(double v)
{
    /* 2 E / K - 1 of the complete integrals */
    double gain = 0.4569465810444636254 * v;
    double amplitude = 16 * 0.8472130847939790866 * v;
    for (int n = 3; n >= 0; n--) {
        const double sine = bat_sin(amplitude);
        gain += 2 * landen_steps[n] * sine;
        amplitude = (amplitude + bat_asin(landen_ratios[n] * sine)) / 2;
    }
    const double sn = bat_sin(amplitude);
    return (jacobi){sn, bat_cos(amplitude), sqrt(1 - sn * sn / 2), gain};
}

/* The integral of cn^2 from the inflection, where cn v is the lemniscate's sine of (v + K) /
 * sqrt(2), times dn^2 v / v: of second
 * order in v, so near 0 by its series. */
static double gain_from_inflection(double v, const jacobi *at)
{
    static const double c[] = {1.0 / 6,       -1.0 / 280,        1.0 / 13200,
                               -1.0 / 624000, 41.0 / 1209312000, -7.172601482064398e-10};
    if (fabs(v) > 0.5)
        return (at->gain * at->dn * at->dn - at->sn * at->cn * at->dn) / v;
    const double fourth = v * v * v * v;
    double sum = 0;
    for (int i = (int)(sizeof c / sizeof c[0]) - 1; i >= 0; i--)
        sum = sum * fourth + c[i];
    return v * v * sum * at->dn * at->dn;
}

/* cn(phase + delta) - cn(phase). */
static double cn_gained(double c, double s, double dn, double cn, const jacobi *d)
{
    if (d->cn < 0)
        return cn - c;
    const double half = d->sn / (1 + d->cn), sn2 = d->sn * d->sn;
    return -(c * sn2 * (half * half + c * c) / 2 + s * dn * d->sn * d->dn) /
           (1 - s * s * sn2 / 2);
}

/* Turned back by the angle of the unit vector `by`. */
static void turn_back(const double by[2], double x, double y, double out[2])
{
    out[0] = by[0] * x + by[1] * y;
    out[1] = by[0] * y - by[1] * x;
}

static double turn_between(const double from[2], const double to[2])
{
    double turned[2];
    turn_back(from, to[0], to[1], turned);
    if (turned[0] > 0)
        return bat_atan2(turned[1], turned[0]);
    /* Both are within a right angle of the first axis, so this never jumps. */
    return bat_atan2(to[1], to[0]) - bat_atan2(from[1], from[0]);
}

/* `curvature` and `slope` are for a unit of length in which s = 1. */
static void unit_elastica(double curvature, double slope, bat_elastica *out)
{
    static const double root = 1.41421356237309504880;
    const double lambda = sqrt(bat_hypot(slope, curvature * curvature / 2));
    *out = (bat_elastica){{1, 0}, {1, 0}, 0, curvature, slope, 0, 0};
    if (lambda == 0)
        return;
    const jacobi d = jacobi_at(lambda);
    /* At the phase: the start. */
    const double c = curvature / (root * lambda), dn = sqrt((1 + c * c) / 2);
    const double s = -slope / (root * lambda * lambda * dn);
    const double divisor = 1 - s * s * d.sn * d.sn / 2;
    const double cn = (c * d.cn - s * dn * d.sn * d.dn) / divisor;
    const double sn = (s * d.cn * d.dn + d.sn * c * dn) / divisor;
    const double first[2] = {c * c, root * s * dn};
    const double last[2] = {cn * cn, root * sn * sqrt((1 + cn * cn) / 2)};
    /* The integral of cn^2 by lambda, by powers of c, which is small where the curve is almost
     * straight. */
    const double n = d.sn / lambda;
    const double along = (gain_from_inflection(lambda, &d) +
                          c * c * (d.gain / lambda * d.sn * d.sn / 2 + n * d.cn * d.dn) -
                          s * c * dn * d.sn * n) /
                         divisor;
    turn_back(first, along, -root * cn_gained(c, s, dn, cn, &d) / lambda, out->point);
    turn_back(first, last[0], last[1], out->tangent);
    out->turn = turn_between(first, last);
    out->curvature = root * lambda * cn;
    out->slope = -lambda * lambda * last[1];
    out->waves = lambda;
    out->energy = 2 * lambda * lambda * along;
}

void bat_elastica_at(double curvature, double slope, double s, bat_elastica *out)
{
    unit_elastica(curvature * s, slope * s * s, out);
    if (s == 0) {
        *out = (bat_elastica){{0, 0}, {1, 0}, 0, curvature, slope, 0, 0};
        return;
    }
    out->point[0] *= s;
    out->point[1] *= s;
    out->curvature /= s;
    out->slope = out->slope / s / s;
    out->energy /= s;
}

void bat_span_elastica(int d, const batten_span *span, double t, int order, double *out)
{
    assert(d == 2);
    (void)d;
    bat_elastica at;
    bat_elastica_at(span->curvature[0], span->curvature[1], t, &at);
    const double back[2] = {bat_cos(span->angle), -bat_sin(span->angle)};
    double T[2];
    turn_back(back, at.point[0], at.point[1], out);
    turn_back(back, at.tangent[0], at.tangent[1], T);
    const double N[2] = {-T[1], T[0]}, k = at.curvature;
    for (int i = 0; i < 2; i++) {
        out[i] += span->start[i];
        if (order >= 1)
            out[2 + i] = T[i];
        if (order >= 2)
            out[4 + i] = k * N[i];
        if (order >= 3)
            out[6 + i] = at.slope * N[i] - k * k * T[i];
    }
}

batten_status bat_span_elastica_check(const batten_span *span, int index)
{
    const double k = span->curvature[0] * span->length;
    const double slope = span->curvature[1] * span->length * span->length;
    const double waves = sqrt(bat_hypot(slope, k * k / 2));
    /* Beyond, rounding the phase costs more than half of the digits. */
    if (waves <= 0x1p26)
        return BATTEN_OK;
    return bat_fail(
        BATTEN_TOO_LARGE,
        "span %d is %g long, too long for an elastica with the curvature %g and its "
        "derivative %g at the start",
        index + 1, span->length, span->curvature[0], span->curvature[1]);
}
