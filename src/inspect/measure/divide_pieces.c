/* Parameters where a curve falls into pieces: at corners, breaks of curvature and turns. */
#include "base/plural.h"
#include "inspect/inflections.h"
#include "inspect/singular.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"
#include <batten/measure.h>
#include <batten/nearest.h>

#include <float.h>

/* Cuts so far, rising, both ends among them. */
typedef struct {
    const batten_curve *curve;
    batten_interval domain;
    double size;
    batten_parameters cuts;
} division;

/* Take more cuts over; their memory too. */
static batten_status add_parameters(division *d, batten_status status, batten_parameters *more)
{
    batten_parameters all = {0, NULL};
    if (status == BATTEN_OK)
        status = bat_parameters_merge(&d->cuts, more, d->domain, &all);
    if (status == BATTEN_OK) {
        bat_release(d->cuts.at);
        d->cuts = all;
    }
    bat_release(more->at);
    *more = (batten_parameters){0, NULL};
    return status;
}

static batten_status add_one(division *d, double u)
{
    batten_parameters one = {1, bat_array(1, sizeof *one.at)};
    if (!one.at)
        return BATTEN_OUT_OF_MEMORY;
    one.at[0] = u;
    return add_parameters(d, BATTEN_OK, &one);
}

static batten_status add_knots(division *d)
{
    batten_parameters knots = {batten_curve_spans(d->curve, NULL), NULL};
    knots.at = bat_array((size_t)knots.count, sizeof *knots.at);
    if (!knots.at)
        return BATTEN_OUT_OF_MEMORY;
    batten_curve_spans(d->curve, knots.at);
    return add_parameters(d, BATTEN_OK, &knots);
}

static batten_status add_turns(division *d, const batten_vec3 *direction)
{
    batten_parameters more = {0, NULL};
    batten_status status = BATTEN_OK;
    if (direction)
        return add_parameters(d, batten_curve_turns(d->curve, *direction, &more), &more);
    for (int k = 0; status == BATTEN_OK && k < d->curve->dimension; k++)
        status = add_parameters(
            d, batten_curve_turns(d->curve, (batten_vec3){k == 0, k == 1, k == 2}, &more),
            &more);
    return status;
}

/* ---- corners and jumps ---- */

static batten_status side_at(const division *d, double u, batten_side side,
                             batten_curve_local *out)
{
    const batten_status status = bat_curve_local_at(d->curve, d->size, u, side, out);
    if (status != BATTEN_OK && status != BATTEN_SINGULAR_HERE)
        return status;
    if (!(bat_vec3_norm(out->tangent) > 0))
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve has no direction at u = %.17g", u);
    return BATTEN_OK;
}

/* Is the curve not smooth at a knot, to the tangent or (`curvature`) to curvature? */
static batten_status is_broken(const division *d, double u, bool curvature, bool *broken)
{
    batten_curve_local a, b;
    batten_status status = side_at(d, u, BATTEN_FROM_LEFT, &a);
    if (status == BATTEN_OK)
        status = side_at(d, u, BATTEN_FROM_RIGHT, &b);
    if (status != BATTEN_OK)
        return status;
    /* What the second derivative may lose to rounding, as a curvature. */
    const double h = bat_min(bat_span_width(d->curve, u, BATTEN_FROM_LEFT),
                             bat_span_width(d->curve, u, BATTEN_FROM_RIGHT));
    const double speed = bat_min(a.speed, b.speed);
    const double second = bat_derivative_roundoff(d->curve, 2, d->size, h);
    const double jump = fabs(a.curvature - b.curvature);
    const double most = bat_max(fabs(a.curvature), fabs(b.curvature));
    /* Unit tangents and curvatures that agree in nine digits are the same but for rounding. */
    *broken = bat_vec3_norm(bat_vec3_subtract(a.tangent, b.tangent)) > 1e-9 ||
              (curvature &&
               (!(speed > 0) || jump > bat_max(1e-9 * most, 8 * second / (speed * speed))));
    return BATTEN_OK;
}

static batten_status add_breaks(division *d, bool curvature)
{
    batten_parameters knots = {batten_curve_spans(d->curve, NULL), NULL};
    knots.at = bat_array((size_t)knots.count, sizeof *knots.at);
    batten_status status = knots.at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int kept = 0;
    if (status == BATTEN_OK)
        batten_curve_spans(d->curve, knots.at);
    for (int i = 1; status == BATTEN_OK && i + 1 < knots.count; i++) {
        bool broken = false;
        status = is_broken(d, knots.at[i], curvature, &broken);
        if (broken)
            knots.at[kept++] = knots.at[i];
    }
    knots.count = kept;
    return add_parameters(d, status, &knots);
}

/* ---- kinds ---- */

/* Curvature that touches 0 without a change of sign is an extremum of it; so only places where
 * it vanishes on a straight piece are left, and those are ends of spans at which it jumps or
 * not. */
static batten_status add_spirals(division *d)
{
    batten_parameters more = {0, NULL};
    batten_status status = add_breaks(d, true);
    if (status == BATTEN_OK && d->curve->dimension == 2)
        status = add_parameters(d, batten_curve_inflections(d->curve, &more), &more);
    if (status == BATTEN_OK)
        status = add_parameters(d, batten_curve_curvature_extrema(d->curve, &more), &more);
    return status;
}

/* Between a and b the curve bends one way: where its tangent has come around by half a turn
 * since the last cut. */
static batten_status add_half_turns(division *d, double a, double b)
{
    batten_status status = BATTEN_OK;
    for (bool found = true; status == BATTEN_OK && found;) {
        batten_curve *part = NULL;
        batten_curve_local local;
        batten_parameters turns = {0, NULL};
        /* Ends are not cuts; a zero at one is found to some million roundings. */
        const double apart = 1e-9 * (b - a);
        found = false;
        status = side_at(d, a, BATTEN_FROM_RIGHT, &local);
        if (status == BATTEN_OK)
            status = batten_curve_subrange(d->curve, a, b, &part);
        if (status == BATTEN_OK)
            status = batten_curve_turns(
                part, (batten_vec3){-local.tangent.y, local.tangent.x, 0}, &turns);
        for (int i = 0; status == BATTEN_OK && i < turns.count && !found; i++)
            if (turns.at[i] > a + apart && turns.at[i] < b - apart) {
                found = true;
                a = turns.at[i];
                status = add_one(d, a);
            }
        bat_release(turns.at);
        batten_curve_unref(part);
    }
    return status;
}

static batten_status add_convex(division *d)
{
    batten_parameters more = {0, NULL};
    if (d->curve->dimension != 2)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "only curves in the plane have convex pieces, this one has %d "
                        "dimension%s",
                        d->curve->dimension, bat_plural(d->curve->dimension));
    batten_status status = add_breaks(d, false);
    if (status == BATTEN_OK)
        status = add_parameters(d, batten_curve_inflections(d->curve, &more), &more);
    const int count = d->cuts.count;
    double *at = status == BATTEN_OK ? bat_array((size_t)count, sizeof *at) : NULL;
    if (status == BATTEN_OK && !at)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        at[i] = d->cuts.at[i];
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++)
        status = add_half_turns(d, at[i], at[i + 1]);
    bat_release(at);
    return status;
}

/* ---- the proof ---- */

/* None of these lies clearly inside a piece. */
static batten_status none_inside(double a, double b, batten_status status,
                                 batten_parameters *found, const char *what)
{
    const double apart = 1e-6 * (b - a);
    for (int i = 0; status == BATTEN_OK && i < found->count; i++)
        if (found->at[i] > a + apart && found->at[i] < b - apart)
            status = bat_fail(BATTEN_INCOMPLETE,
                              "the piece from %.17g to %.17g has %s inside, at %.17g", a, b,
                              what, found->at[i]);
    bat_release(found->at);
    *found = (batten_parameters){0, NULL};
    return status;
}

static batten_status prove_piece(const division *d, batten_piece_kind kind, double a, double b)
{
    batten_curve *part = NULL;
    batten_parameters found = {0, NULL};
    /* Cutting rounds each of the control points p times. */
    const double rounding = 4 * d->curve->degree * DBL_EPSILON * d->size;
    batten_status status = batten_curve_subrange(d->curve, a, b, &part);
    if (status == BATTEN_OK && d->curve->dimension == 2)
        status = none_inside(a, b, bat_curve_inflections(part, rounding, &found), &found,
                             "an inflection");
    if (status == BATTEN_OK && kind == BATTEN_PIECES_SPIRAL)
        status = none_inside(a, b, bat_curve_curvature_extrema(part, rounding, &found), &found,
                             "an extremum of curvature");
    batten_curve_unref(part);
    return status;
}

batten_status batten_curve_divide_pieces(const batten_curve *curve, batten_piece_kind kind,
                                         const batten_vec3 *direction, batten_parameters *out)
{
    division d = {
        .curve = curve, .domain = batten_curve_domain(curve), .size = bat_curve_size(curve)};
    const bool bends = kind == BATTEN_PIECES_SPIRAL || kind == BATTEN_PIECES_CONVEX;
    if (bends && curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED, "a function has no such pieces; make its graph");
    batten_status status = add_one(&d, d.domain.a);
    if (status == BATTEN_OK)
        status = add_one(&d, d.domain.b);
    if (status == BATTEN_OK)
        status = kind == BATTEN_PIECES_MONOTONE ? add_turns(&d, direction)
                 : kind == BATTEN_PIECES_SPIRAL ? add_spirals(&d)
                 : kind == BATTEN_PIECES_CONVEX ? add_convex(&d)
                                                : add_knots(&d);
    for (int i = 0; status == BATTEN_OK && bends && i + 1 < d.cuts.count; i++)
        status = prove_piece(&d, kind, d.cuts.at[i], d.cuts.at[i + 1]);
    if (status == BATTEN_OK)
        *out = d.cuts;
    else
        bat_release(d.cuts.at);
    return status;
}
