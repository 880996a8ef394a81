/*
 * The mechanical spline: between two points the beam is free of load, so that its axis is an
 * elastica, k'' + k^3 / 2 = 0 along arc length.
 *
 * Of a span with a chord of length 1 the curvature k and its derivative c at the start and the
 * arc length s are unknown; the end point and the turn are given. Newton's derivatives are
 * exact: by s those of the curve itself, and by k and c from the two ways in which elastica go
 * into each other, being scaled and being shifted along themselves.
 */
#include "numeric/vector.h"
#include "shape/bent/two_angle.h"
#include "spline/chain/chain.h"

#include <string.h>

typedef struct {
    double v[3]; /* k, c, s */
} unknowns;

/* What the unknowns lead to, and its derivatives by them. */
typedef struct {
    bat_elastica end;
    double x[3], y[3], turn[3], curvature[3];
} response;

/* ---- derivatives ---- */

/* The changes of x, y, turn and curvature at the end when the elastica is scaled, so that k
 * changes by k and c by 2 c, and when it begins later, so that k changes by c and c by -k^3
 * / 2.
 */
static void add_motions(const unknowns *p, double by_scale, double by_shift, int column,
                        response *r)
{
    const double k = p->v[0], s = p->v[2];
    const bat_elastica *e = &r->end;
    r->x[column] = by_scale * (s * e->tangent[0] - e->point[0]) +
                   by_shift * (e->tangent[0] - 1 + k * e->point[1]);
    r->y[column] = by_scale * (s * e->tangent[1] - e->point[1]) +
                   by_shift * (e->tangent[1] - k * e->point[0]);
    r->turn[column] = by_scale * s * e->curvature + by_shift * (e->curvature - k);
    r->curvature[column] = by_scale * (e->curvature + s * e->slope) + by_shift * e->slope;
}

/* Where the curve is almost straight its curvature is k + c s. */
static void almost_straight(const unknowns *p, response *r)
{
    const double k = p->v[0], c = p->v[1], s = p->v[2], s2 = s * s, s3 = s * s2;
    const double by_k[4] = {-s3 * (k / 3 + c * s / 8), s2 / 2, s, 1};
    const double by_c[4] = {-s2 * s2 * (k / 8 + c * s / 20), s3 / 6, s2 / 2, s};
    double *const rows[4] = {r->x, r->y, r->turn, r->curvature};
    for (int i = 0; i < 4; i++) {
        rows[i][0] = by_k[i];
        rows[i][1] = by_c[i];
    }
}

static void respond(const unknowns *p, response *r)
{
    const double k = p->v[0], c = p->v[1];
    bat_elastica_at(k, c, p->v[2], &r->end);
    /* The motions lose eps / waves^3 or so, the other form waves^2. */
    if (r->end.waves * r->end.waves < 1e-6) {
        almost_straight(p, r);
    } else {
        const double fourth = c * c + k * k * k * k / 4;
        add_motions(p, k * k * k / (4 * fourth), c / fourth, 0, r);
        add_motions(p, c / (2 * fourth), -k / (2 * fourth), 1, r);
    }
    r->x[2] = r->end.tangent[0];
    r->y[2] = r->end.tangent[1];
    r->turn[2] = r->end.curvature;
    r->curvature[2] = r->end.slope;
}

/* ---- three equations ---- */

/* The change of the unknowns that changes x, y and turn by `by`; false when there is none. */
static bool solve(const response *r, const double by[3], double out[3])
{
    double xy[3], yt[3], tx[3];
    bat_cross(r->x, r->y, xy);
    bat_cross(r->y, r->turn, yt);
    bat_cross(r->turn, r->x, tx);
    const double det = xy[0] * r->turn[0] + xy[1] * r->turn[1] + xy[2] * r->turn[2];
    bool finite = true;
    for (int i = 0; i < 3; i++) {
        out[i] = (by[0] * yt[i] + by[1] * tx[i] + by[2] * xy[i]) / det;
        finite = finite && isfinite(out[i]);
    }
    return finite;
}

/* How far the end is from (1, 0), seen from the tangent at the start, and from its direction.
 */
static double miss(const response *r, double alpha, double beta, double by[3])
{
    by[0] = bat_cos(alpha) - r->end.point[0];
    by[1] = -bat_sin(alpha) - r->end.point[1];
    by[2] = beta - alpha - r->end.turn;
    return fabs(by[0]) + fabs(by[1]) + fabs(by[2]);
}

/* A step back towards `from` until the end is missed by less than before. */
static bool shorten(double alpha, double beta, const double step[3], double before,
                    const unknowns *from, unknowns *to, response *r)
{
    double by[3];
    for (double part = 1; part > 1e-3; part /= 2) {
        for (int i = 0; i < 3; i++)
            to->v[i] = from->v[i] + part * step[i];
        if (!(to->v[2] > 0))
            continue;
        respond(to, r);
        if (miss(r, alpha, beta, by) < before)
            return true;
    }
    return false;
}

/* From `p`, close to the solution. A span goes less than one period. */
static bool improve(double alpha, double beta, unknowns *p, response *r)
{
    enum { STEPS = 30 };
    static const double period = 7.416298709205487;
    respond(p, r);
    for (int i = 0; i < STEPS; i++) {
        double by[3], step[3];
        const double missed = miss(r, alpha, beta, by);
        if (!solve(r, by, step))
            return false;
        const double size = fabs(p->v[0]) + fabs(p->v[1]);
        const double change = fabs(step[0]) + fabs(step[1]);
        /* The steps square: this was the last that counts, and its end is not missed by more
         * than rounding. */
        if (change <= 1e-9 * size + 1e-300 && missed < 1e-9) {
            for (int k = 0; k < 3; k++)
                p->v[k] += step[k];
            respond(p, r);
            return r->end.waves < period;
        }
        const unknowns from = *p;
        if (!shorten(alpha, beta, step, missed, &from, p, r))
            return false;
    }
    return false;
}

static unknowns small_angles(double a, double b)
{
    return (unknowns){
        {-(4 * a + 2 * b), 6 * (a + b), 1 + (2 * a * a - a * b + 2 * b * b) / 30}};
}

/* Large angles are reached from smaller ones of the same ratio. */
static bool walk(double alpha, double beta, unknowns *p, response *r)
{
    double at = 0.25, step = 0.25;
    *p = small_angles(at * alpha, at * beta);
    if (!improve(at * alpha, at * beta, p, r))
        return false;
    while (at < 1) {
        const double next = bat_min(1, at + step);
        const double by[3] = {bat_cos(next * alpha) - bat_cos(at * alpha),
                              bat_sin(at * alpha) - bat_sin(next * alpha),
                              (next - at) * (beta - alpha)};
        double change[3];
        unknowns there = *p;
        response reached = *r;
        if (solve(r, by, change))
            for (int i = 0; i < 3; i++)
                there.v[i] += change[i];
        if (there.v[2] > 0 && improve(next * alpha, next * beta, &there, &reached)) {
            at = next;
            *p = there;
            *r = reached;
        } else if ((step /= 2) < 1e-3) {
            return false;
        }
    }
    return true;
}

static batten_status find(double alpha, double beta, unknowns *p, response *r)
{
    *p = small_angles(alpha, beta);
    if (improve(alpha, beta, p, r) || walk(alpha, beta, p, r))
        return BATTEN_OK;
    return bat_fail(BATTEN_SINGULAR_SYSTEM,
                    "no free beam leaves its chord at %g and reaches it at %g radians", alpha,
                    beta);
}

/* ---- the family ---- */

static batten_status curvatures(double alpha, double beta, double l, double tension,
                                bat_end_curvatures *out)
{
    (void)tension;
    unknowns p;
    response r;
    const batten_status status = find(alpha, beta, &p, &r);
    if (status != BATTEN_OK)
        return status;
    double by_alpha[3], by_beta[3];
    const double turned[3] = {-bat_sin(alpha), -bat_cos(alpha), -1}, ended[3] = {0, 0, 1};
    if (!solve(&r, turned, by_alpha) || !solve(&r, ended, by_beta))
        return bat_fail(BATTEN_SINGULAR_SYSTEM,
                        "the beam between %g and %g radians from its chord is about to snap",
                        alpha, beta);
    *out = (bat_end_curvatures){.k0 = p.v[0] / l,
                                .k1 = r.end.curvature / l,
                                .k0_alpha = by_alpha[0] / l,
                                .k0_beta = by_beta[0] / l};
    for (int i = 0; i < 3; i++) {
        out->k1_alpha += r.curvature[i] * by_alpha[i] / l;
        out->k1_beta += r.curvature[i] * by_beta[i] / l;
    }
    return BATTEN_OK;
}

static batten_status spans(double alpha, double beta, double l, double tension,
                           batten_span *out, int *count)
{
    (void)tension;
    unknowns p;
    response r;
    const batten_status status = find(alpha, beta, &p, &r);
    if (status != BATTEN_OK)
        return status;
    memset(out, 0, sizeof *out);
    out->kind = BATTEN_SPAN_ELASTICA;
    out->length = p.v[2] * l;
    out->angle = alpha;
    out->curvature[0] = p.v[0] / l;
    out->curvature[1] = p.v[1] / l / l;
    *count = 1;
    return BATTEN_OK;
}

/* No beam leaves its chord at more than 124 degrees, which it does where it reaches the end
 * along the chord; at other angles it slips into loops earlier. */
const bat_span_family bat_family_elastica = {"an elastica", 2.17, "an Euler spiral", curvatures,
                                             spans};
