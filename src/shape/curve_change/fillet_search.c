/*
 * Where an arc of radius r goes from one plane curve into another: its centre is at the
 * distance r from both, on the same side s of both ways,
 *
 *     A(u) + s r N_A(u) = B(v) + s r N_B(v).
 *
 * Straight curves have one solution. For others the offsets of both are crossed, and each
 * crossing is the start of Newton's method, with (A + s r N)' = (1 - s r k) A'.
 */
#include "inspect/nearest/self_crossings.h"
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "shape/curve_change/cut_corners.h"
#include "shape/curve_change/offset.h"
#include "spline/curve/curve.h"

#include <batten/measure.h>
#include <float.h>

typedef struct {
    const batten_curve *const *curves;
    double radius, size;
    bat_fillet_place best;
    double removed; /* by the best */
} search;

/* ---- one place ---- */

/* The centre of the circle that touches at a parameter, how it moves with that, and the unit
 * tangent there. */
typedef struct {
    double center[2], slope[2], tangent[2];
} contact;

static batten_status contact_at(const search *s, int k, int side, double u, contact *out)
{
    double c[3 * 2];
    const batten_status status = batten_curve_evaluate(s->curves[k], u, 2, c);
    if (status != BATTEN_OK)
        return status;
    const double v = bat_norm(2, c + 2), bend = (c[2] * c[5] - c[3] * c[4]) / (v * v * v);
    const double r = side * s->radius;
    for (int i = 0; i < 2; i++) {
        out->tangent[i] = c[2 + i] / v;
        out->slope[i] = (1 - r * bend) * c[2 + i];
    }
    out->center[0] = c[0] - r * out->tangent[1];
    out->center[1] = c[1] + r * out->tangent[0];
    return BATTEN_OK;
}

/* Does the circle lead from A(u) into B(v), turning by pi at most? */
static bool turns(int side, const double *ta, const double *tb)
{
    const double angle = bat_atan2(side * (ta[0] * tb[1] - ta[1] * tb[0]), bat_dot(2, ta, tb));
    return angle > BAT_MEANT_SAME;
}

/* Newton's method from u within the domains; *good when centres and tangents agree. */
static batten_status refine_centre(const search *s, int side, double u[2], bool *good)
{
    enum { ROUNDS = 40 };
    contact at[2];
    *good = false;
    for (int round = 0; round < ROUNDS; round++) {
        for (int k = 0; k < 2; k++) {
            const batten_status status = contact_at(s, k, side, u[k], &at[k]);
            if (status != BATTEN_OK)
                return status;
        }
        const double f[2] = {at[1].center[0] - at[0].center[0],
                             at[1].center[1] - at[0].center[1]};
        const double *d0 = at[0].slope, *d1 = at[1].slope;
        const double det = d0[1] * d1[0] - d0[0] * d1[1];
        const double before[2] = {u[0], u[1]};
        /* Both centres are one but for rounding. */
        *good = bat_norm(2, f) <= 1e-12 * (s->size + s->radius) &&
                turns(side, at[0].tangent, at[1].tangent);
        if (!isfinite(bat_norm(2, f)) || !(fabs(det) > 0))
            return BATTEN_OK;
        u[0] += (d1[0] * f[1] - d1[1] * f[0]) / det;
        u[1] += (d0[0] * f[1] - d0[1] * f[0]) / det;
        for (int k = 0; k < 2; k++) {
            const batten_interval domain = batten_curve_domain(s->curves[k]);
            u[k] = bat_min(domain.b, bat_max(domain.a, u[k]));
        }
        const double still = 4 * DBL_EPSILON;
        if (fabs(u[0] - before[0]) <= still * fabs(u[0]) &&
            fabs(u[1] - before[1]) <= still * fabs(u[1]))
            return BATTEN_OK;
    }
    return BATTEN_OK;
}

/* Take a place over when it is one, and removes less than the best so far. */
static batten_status try_pair(search *s, int side, double u0, double u1)
{
    const batten_interval first = batten_curve_domain(s->curves[0]),
                          second = batten_curve_domain(s->curves[1]);
    double u[2] = {bat_min(first.b, bat_max(first.a, u0)),
                   bat_min(second.b, bat_max(second.a, u1))};
    double lost[2];
    bool good;
    batten_status status = refine_centre(s, side, u, &good);
    if (status != BATTEN_OK || !good)
        return status;
    const double tolerance = BAT_MEANT_SAME * s->size;
    status =
        batten_curve_length_between(s->curves[0], u[0], first.b, tolerance, NULL, &lost[0]);
    if (status == BATTEN_OK)
        status = batten_curve_length_between(s->curves[1], second.a, u[1], tolerance, NULL,
                                             &lost[1]);
    if (status != BATTEN_OK)
        return status;
    s->best.found++;
    if (lost[0] + lost[1] < s->removed) {
        s->removed = lost[0] + lost[1];
        s->best.side = side;
        s->best.u[0] = u[0];
        s->best.u[1] = u[1];
    }
    return BATTEN_OK;
}

/* ---- straight curves ---- */

typedef struct {
    double p[2], t[2], length;
} line;

static bool line_of(const batten_curve *curve, line *out)
{
    const double *a = curve->points, *b = a + 2 * (curve->count - 1);
    const double way[2] = {b[0] - a[0], b[1] - a[1]}, length = bat_norm(2, way);
    if (!bat_plan_is_line(curve))
        return false;
    *out = (line){{a[0], a[1]}, {way[0] / length, way[1] / length}, length};
    return true;
}

static batten_status search_lines(search *s, const line *a, const line *b)
{
    const double q[2] = {b->p[0] - a->p[0], b->p[1] - a->p[1]};
    const double cross = a->t[0] * b->t[1] - a->t[1] * b->t[0];
    const double turn = bat_atan2(fabs(cross), bat_dot(2, a->t, b->t));
    if (!(fabs(cross) > BAT_ROUNDING))
        return bat_fail(BATTEN_NOT_COMPATIBLE, "the straight lines run along each other");
    /* They cross `far` along the first, and `near` along the second; the arc begins and ends
     * `leg` away from there. */
    const double far = (q[0] * b->t[1] - q[1] * b->t[0]) / cross;
    const double near = (q[0] * a->t[1] - q[1] * a->t[0]) / cross;
    const double leg = s->radius * bat_tan(turn / 2), rounding = BAT_EXACT * s->size;
    double at[2] = {far - leg, near + leg}, u[2];
    if (far > a->length + leg + rounding || near < -leg - rounding)
        return bat_fail(BATTEN_NOT_FOUND,
                        "the straight lines end too far before they meet; extend them");
    if (at[0] < -rounding || at[1] > b->length + rounding)
        return bat_fail(BATTEN_NOT_FOUND,
                        "the radius %g needs %g of either straight line; there are %g and %g",
                        s->radius, leg, bat_max(0, far), bat_max(0, b->length - near));
    for (int k = 0; k < 2; k++) {
        at[k] = bat_max(0, bat_min(at[k], k ? b->length : a->length));
        const batten_status status =
            batten_curve_at_length(s->curves[k], 1, &at[k], rounding, &u[k]);
        if (status != BATTEN_OK)
            return status;
    }
    s->best.complete = true;
    return try_pair(s, cross > 0 ? 1 : -1, u[0], u[1]);
}

/* ---- others ---- */

static batten_status offset_of(const batten_curve *bezier, double distance, double tolerance,
                               bat_offset *o)
{
    batten_curve_offset_options options = batten_curve_offset_defaults();
    options.tolerance = tolerance;
    *o = (bat_offset){.full = bezier,
                      .plan = bezier,
                      .distance = distance,
                      .options = options,
                      .size = bat_curve_size(bezier)};
    return bat_offset_runs(o);
}

/* Crossings of runs of the one with runs of the other. */
static batten_status cross_offsets(search *s, int side, const bat_offset o[2])
{
    const int n = o[0].count, all = n + o[1].count;
    const batten_curve **plans = bat_array((size_t)all, sizeof *plans);
    bat_crossings crossings = {0};
    batten_status status = plans ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < all; i++)
        plans[i] = i < n ? o[0].runs[i].plan : o[1].runs[i - n].plan;
    if (status == BATTEN_OK && all)
        status = bat_crossings_find(all, plans, false, &crossings);
    for (int i = 0; status == BATTEN_OK && i < crossings.count; i++) {
        const bat_crossing *c = &crossings.at[i];
        if (c->curve[0] < n && c->curve[1] >= n)
            status = try_pair(s, side, c->u[0], c->u[1]);
    }
    bat_release(crossings.at);
    bat_release(plans);
    return status;
}

static batten_status search_side(search *s, int side)
{
    /* Newton's method needs starts, no more. */
    const double tolerance = 1e-3 * bat_min(s->radius, s->size);
    batten_curve *bezier[2] = {NULL, NULL};
    bat_offset o[2] = {{0}, {0}};
    batten_status status = BATTEN_OK;
    for (int k = 0; status == BATTEN_OK && k < 2; k++) {
        status = batten_curve_to_bezier(s->curves[k], &bezier[k]);
        if (status == BATTEN_OK)
            status = offset_of(bezier[k], side * s->radius, tolerance, &o[k]);
    }
    if (status == BATTEN_OK)
        status = cross_offsets(s, side, o);
    for (int k = 0; k < 2; k++) {
        bat_offset_runs_release(&o[k]);
        batten_curve_unref(bezier[k]);
    }
    return status;
}

batten_status bat_fillet_search(const batten_curve *const curves[2], double radius,
                                bat_fillet_place *out)
{
    search s = {.curves = curves, .radius = radius, .removed = HUGE_VAL};
    line lines[2];
    s.size = bat_max(bat_curve_size(curves[0]), bat_curve_size(curves[1]));
    const bool straight = line_of(curves[0], &lines[0]) && line_of(curves[1], &lines[1]);
    batten_status status = BATTEN_OK;
    if (straight)
        status = search_lines(&s, &lines[0], &lines[1]);
    for (int side = 1; !straight && status == BATTEN_OK && side >= -1; side -= 2)
        status = search_side(&s, side);
    if (status == BATTEN_OK && s.best.found == 0)
        status = bat_fail(BATTEN_NOT_FOUND,
                          "no arc of the radius %g was found that goes from one curve into the "
                          "other; a smaller one may",
                          radius);
    if (status == BATTEN_OK)
        *out = s.best;
    return status;
}
