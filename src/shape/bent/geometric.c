/*
 * The geometric spline: the beam whose bending moment is linear along the chord of the span, so
 * that its curvature is a + b x of the abscissa x, with no assumption of small slopes.
 *
 * Of a span with a chord of length 1 the sine of the angle to the chord is u = p + (q - p) x -
 * B x (1 - x), b = 2 B, with p and q the sines at its ends. The one unknown B makes the rise,
 * the integral of u / sqrt(1 - u^2), vanish. It falls as B grows, from infinity, where u
 * touches 1, to -infinity, where u touches -1: each pair of angles below a right angle has one
 * solution.
 */
#include "shape/bent/two_angle.h"
#include "spline/chain/chain.h"

#include <string.h>

/* B, and the integrals there. */
typedef struct {
    double p, q, B;
    bat_geometric at;
} beam;

static void bend(beam *b, double B)
{
    b->B = B;
    bat_geometric_at(b->p, b->q - b->p - B, 2 * B, &b->at);
}

/* How fast the rise falls with B: the integral of x (1 - x) / w^3. */
static double softness(const beam *b)
{
    return b->at.moments[1] - b->at.moments[2];
}

/* The sum of the roots of what is left to 1 at the ends: u touches 1 when B is minus its
 * square.
 */
static double largest_bend(double p, double q)
{
    const double sum = sqrt(1 - p) + sqrt(1 - q);
    return sum * sum;
}

static batten_status find(double alpha, double beta, beam *out)
{
    enum { STEPS = 100 };
    beam b = {.p = bat_sin(alpha), .q = bat_sin(beta)};
    double low = -largest_bend(b.p, b.q), high = largest_bend(-b.p, -b.q);
    double B = bat_max(low / 2, bat_min(high / 2, 3 * (alpha + beta)));
    for (int i = 0; i < STEPS; i++) {
        bend(&b, B);
        const double rise = b.at.rise, step = rise / softness(&b);
        if (rise > 0)
            low = B;
        else
            high = B;
        if (fabs(step) <= 1e-15 * (fabs(b.p) + fabs(b.q)) || !(low < high)) {
            *out = b;
            return BATTEN_OK;
        }
        const double next = B + step;
        B = next > low && next < high ? next : low + (high - low) / 2;
        if (B == b.B) {
            *out = b;
            return BATTEN_OK;
        }
    }
    return bat_fail(BATTEN_SINGULAR_SYSTEM,
                    "no beam under a linear moment leaves its chord at %g and reaches it at %g "
                    "radians",
                    alpha, beta);
}

static batten_status curvatures(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out)
{
    (void)tension;
    beam b;
    const batten_status status = find(alpha, beta, &b);
    if (status != BATTEN_OK)
        return status;
    const double *m = b.at.moments, soft = softness(&b);
    /* How B follows the sines. */
    const double B_p = (m[0] - m[1]) / soft, B_q = m[1] / soft;
    *out = (bat_end_curvatures){.k0 = (b.q - b.p - b.B) / l,
                                .k1 = (b.q - b.p + b.B) / l,
                                .k0_alpha = bat_cos(alpha) * (-1 - B_p) / l,
                                .k0_beta = bat_cos(beta) * (1 - B_q) / l,
                                .k1_alpha = bat_cos(alpha) * (-1 + B_p) / l,
                                .k1_beta = bat_cos(beta) * (1 + B_q) / l};
    return BATTEN_OK;
}

static batten_status spans(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count)
{
    (void)tension;
    beam b;
    const batten_status status = find(alpha, beta, &b);
    if (status != BATTEN_OK)
        return status;
    memset(out, 0, sizeof *out);
    out->kind = BATTEN_SPAN_GEOMETRIC;
    out->length = l;
    out->angle = alpha;
    out->curvature[0] = (b.q - b.p - b.B) / l;
    out->curvature[1] = 2 * b.B / l / l;
    *count = 1;
    return BATTEN_OK;
}

/* A function of the abscissa stays below a right angle; at 89 degrees it is still bent well. */
const bat_span_family bat_family_geometric = {"a geometric spline", 1.5533430342749532,
                                              "an Euler spiral", curvatures, spans};
