/* Quintics that follow an offset between its breaks. */
#include "shape/curve_change/offset_strand.h"
#include "base/plural.h"
#include "inspect/singular.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <string.h>

enum { SAMPLES = 7 };

static batten_status place_singular(const bat_offset *o, double u, batten_side side,
                                    bat_run_place *out)
{
    batten_curve_local local;
    const batten_status status = bat_curve_local_at(o->plan, o->size, u, side, &local);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    if (!(bat_vec3_norm(local.tangent) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve has no direction at u = %.17g", u);
    out->singular = true;
    out->factor = 1;
    out->t[0] = local.tangent.x;
    out->t[1] = local.tangent.y;
    out->q[0][0] -= o->distance * out->t[1];
    out->q[0][1] += o->distance * out->t[0];
    return BATTEN_OK;
}

batten_status bat_run_place_at(const bat_offset *o, double u, batten_side side,
                               bat_run_place *out)
{
    const int d = o->full->dimension;
    double c[4 * 3];
    const batten_status status = batten_curve_evaluate_side(o->full, u, side, 3, c);
    if (status != BATTEN_OK)
        return status;
    *out = (bat_run_place){.u = u};
    memcpy(out->p, c, (size_t)d * sizeof *c);
    for (int m = 0; m < 3; m++)
        memcpy(out->q[m], c + m * d, (size_t)d * sizeof *c);
    const double *c1 = c + d, *c2 = c + 2 * d, *c3 = c + 3 * d;
    const double v = bat_norm(2, c1), offset = o->distance;
    if (v <= bat_derivative_roundoff(o->plan, 1, o->size, bat_span_width(o->plan, u, side)))
        return place_singular(o, u, side, out);
    out->t[0] = c1[0] / v;
    out->t[1] = c1[1] / v;
    const double b = c1[0] * c2[1] - c1[1] * c2[0], rate = c1[0] * c3[1] - c1[1] * c3[0];
    out->k = b / (v * v * v);
    out->factor = 1 - out->k * offset;
    const double dk = rate / (v * v * v) - 3 * out->k * bat_dot(2, c1, c2) / (v * v);
    out->q[0][0] -= offset * out->t[1];
    out->q[0][1] += offset * out->t[0];
    for (int k = 0; k < 2; k++) {
        out->q[1][k] = out->factor * c1[k];
        out->q[2][k] = out->factor * c2[k] - offset * dk * c1[k];
    }
    return BATTEN_OK;
}

batten_status bat_run_settle(const bat_offset *o, bat_run_place *at, double towards)
{
    bat_run_place near;
    /* Inside by so little that Q' has hardly changed, and by so much that c' is not rounding. */
    const double h = 1e-4 * (towards - at->u);
    if (!at->singular)
        return BATTEN_OK;
    const batten_status status = bat_run_place_at(o, at->u + h, BATTEN_FROM_RIGHT, &near);
    for (int k = 0; status == BATTEN_OK && k < o->full->dimension; k++) {
        at->q[1][k] = (near.q[0][k] - at->q[0][k]) / h;
        at->q[2][k] = 0;
    }
    return status;
}

/* ---- quintics ---- */

/* The quintic between two places at the share t of the way. */
static void quintic(int d, const bat_run_place *a, const bat_run_place *b, double t,
                    double *out)
{
    const double h = b->u - a->u, s = 1 - t, s3 = s * s * s, t3 = t * t * t;
    const double first[3] = {s3 * (1 + 3 * t + 6 * t * t), s3 * t * (1 + 3 * t) * h,
                             s3 * t * t / 2 * h * h};
    const double last[3] = {t3 * (1 + 3 * s + 6 * s * s), -t3 * s * (1 + 3 * s) * h,
                            t3 * s * s / 2 * h * h};
    for (int k = 0; k < d; k++) {
        out[k] = 0;
        for (int m = 0; m < 3; m++)
            out[k] += first[m] * a->q[m][k] + last[m] * b->q[m][k];
    }
}

/* How far the quintic is from the offset at a share of the way. */
static batten_status quintic_off(const bat_offset *o, const bat_run_place *a,
                                 const bat_run_place *b, double t, double *off)
{
    const int d = o->full->dimension;
    bat_run_place at;
    double q[3];
    const batten_status status =
        bat_run_place_at(o, a->u + (b->u - a->u) * t, BATTEN_FROM_RIGHT, &at);
    if (status != BATTEN_OK)
        return status;
    quintic(d, a, b, t, q);
    *off = bat_distance(d, q, at.q[0]);
    return BATTEN_OK;
}

static batten_status quintic_error(const bat_offset *o, const bat_run_place *a,
                                   const bat_run_place *b, double *error)
{
    batten_status status = BATTEN_OK;
    *error = 0;
    for (int i = 1; i <= SAMPLES && status == BATTEN_OK; i++) {
        double off = 0;
        status = quintic_off(o, a, b, i / (SAMPLES + 1.0), &off);
        *error = bat_max(*error, BAT_QUINTIC_BETWEEN_7 * off);
    }
    return status;
}

batten_status bat_strand_follow(bat_offset *o, bat_hermite_run *s, bat_run_place a,
                                const bat_run_place *b)
{
    enum { DEPTH = 40 };
    bat_halving h = bat_halving_of(a.u, b->u, DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        bat_run_place next = *b;
        double error = 0;
        if (h.waiting > 1)
            status = bat_run_place_at(o, h.b, BATTEN_FROM_LEFT, &next);
        if (status == BATTEN_OK)
            status = bat_run_settle(o, &next, a.u);
        if (status == BATTEN_OK)
            status = quintic_error(o, &a, &next, &error);
        if (status != BATTEN_OK)
            return status;
        if (error > o->options.tolerance) {
            if (s->count > o->options.most_pieces || !bat_halving_split(&h))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "the offset is missed by %g near u = %.17g after %d piece%s",
                                error, a.u, s->count, bat_plural(s->count));
            continue;
        }
        o->report.error = bat_max(o->report.error, error);
        status = bat_hermite_run_add(s, next.u, next.q[0]);
        a = next;
        bat_halving_accept(&h);
    }
    return status;
}

batten_status bat_strand_hand_over(bat_offset *o, bat_hermite_run *s)
{
    batten_curve *curve = NULL;
    const batten_status status = bat_hermite_run_finish(s, &curve);
    return status == BATTEN_OK && !curve ? BATTEN_OK : bat_offset_add(o, status, curve);
}
