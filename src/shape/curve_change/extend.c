/* Curves made longer at an end: straight, along an arc, naturally, by a length or to a parameter. */
#include "shape/curve_change/extend.h"
#include "inspect/singular.h"
#include "numeric/rounding.h"
#include "numeric/vector.h"
#include "spline/curve/curve.h"

#include <batten/measure.h>
#include <float.h>

/* ---- pieces ---- */

/* Curvature and rate that rounding alone may make count as 0; then n is the direction of what is
 * left, else any. SINGULAR_HERE where the end has no speed. */
static batten_status tip_at(const batten_curve *curve, bat_tip *out)
{
    bat_side side;
    const batten_status status = bat_side_at_end(curve, BATTEN_CURVE_END, false, &side);
    if (status != BATTEN_OK)
        return status;
    if (side.singular)
        return bat_fail(BATTEN_SINGULAR_HERE, "the curve stands still at its end");
    const double bent = bat_vec3_norm(side.curvature), rate = bat_vec3_norm(side.rate);
    *out = (bat_tip){.dimension = curve->dimension,
                     .u = batten_curve_domain(curve).b,
                     .p = side.c[0],
                     .t = side.tangent,
                     .speed = bat_vec3_norm(side.c[1])};
    if (bent > bat_side_roundoff(&side, 2)) {
        out->n = bat_vec3_scale(side.curvature, 1 / bent);
        out->curvature = bent;
        out->rate = bat_vec3_dot(side.rate, out->n);
    } else if (rate > bat_side_roundoff(&side, 3)) {
        out->n = bat_vec3_scale(side.rate, 1 / rate);
        out->rate = rate;
    }
    return BATTEN_OK;
}

/* From p by x along t and y along n. */
static batten_vec3 point_beside_tip(const bat_tip *tip, batten_vec3 p, double x, double y)
{
    return bat_vec3_along(bat_vec3_along(p, x, tip->t), y, tip->n);
}

static void put_point(int d, batten_vec3 p, double *to)
{
    const double values[3] = {p.x, p.y, p.z};
    for (int k = 0; k < d; k++)
        to[k] = values[k];
}

static batten_status line_piece(const bat_tip *tip, double length, batten_curve **out)
{
    const double breaks[2] = {tip->u, tip->u + length / tip->speed};
    double points[2 * 3];
    put_point(tip->dimension, tip->p, points);
    put_point(tip->dimension, point_beside_tip(tip, tip->p, length, 0),
              points + tip->dimension);
    return batten_curve_from_bezier(tip->dimension, (batten_pieces){1, 1, breaks}, points, NULL,
                                    out);
}

/* Rational quadratics that each turn by 90 degrees at most. At the angle a the circle has come
 * (sin a / k, 2 sin^2(a / 2) / k) from the tip, which is right for tiny k as well. The speed at
 * the ends of a piece is that of the tip when it lasts 2 sin(turn / 2) / (k speed). */
static batten_status arc_piece(const bat_tip *tip, double length, batten_curve **out)
{
    enum { MOST = 4 };
    /* A full quarter turn is one piece though its angle be rounded up. */
    const double k = tip->curvature, angle = k * length;
    const int d = tip->dimension,
              count = bat_max_int(1, (int)ceil(angle / (BAT_PI / 2) - BAT_ROUNDING));
    double points[(2 * MOST + 1) * 3], weights[2 * MOST + 1], breaks[MOST + 1];
    if (count > MOST)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "an arc of the length %g goes around the circle of radius %g more "
                        "than once",
                        length, 1 / k);
    const double turn = angle / count, leg = bat_tan(turn / 2) / k;
    for (int i = 0; i <= count; i++) {
        const double a = i * turn, half = bat_sin(a / 2);
        const batten_vec3 on =
            point_beside_tip(tip, tip->p, bat_sin(a) / k, 2 * half * half / k);
        put_point(d, on, points + (size_t)(2 * i * d));
        breaks[i] = tip->u + i * (2 * bat_sin(turn / 2) / (k * tip->speed));
        weights[2 * i] = 1;
        if (i == count)
            break;
        put_point(d, point_beside_tip(tip, on, leg * bat_cos(a), leg * bat_sin(a)),
                  points + (size_t)((2 * i + 1) * d));
        weights[2 * i + 1] = bat_cos(turn / 2);
    }
    return batten_curve_from_bezier(d, (batten_pieces){2, count, breaks}, points, weights, out);
}

static batten_status spiral_piece(const bat_tip *tip, double length, double tolerance,
                                  double *error, batten_curve **out)
{
    const batten_span span = {
        .kind = BATTEN_SPAN_SPIRAL, .length = length, .curvature = {tip->curvature, tip->rate}};
    const batten_frame frame = {tip->p, tip->t, bat_vec3_cross(tip->t, tip->n)};
    const double breaks[2] = {tip->u, tip->u + length / tip->speed};
    batten_chain *flat = NULL, *placed = NULL;
    batten_curve *space = NULL;
    batten_status status =
        batten_chain_create(&(batten_chain_parts){2, 1, &span, breaks, false}, 0, &flat);
    if (status == BATTEN_OK)
        status = batten_chain_place(flat, &frame, &placed);
    if (status == BATTEN_OK)
        status = batten_chain_to_curve(placed, tolerance, error, &space);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(space, tip->dimension, out);
    batten_curve_unref(space);
    batten_chain_unref(placed);
    batten_chain_unref(flat);
    return status;
}

batten_status bat_tip_piece(const bat_tip *tip, batten_lengthening how, double length,
                            double *error, batten_curve **out)
{
    *error = 0;
    /* What bends by less than rounding is straight. */
    const double size = fabs(tip->p.x) + fabs(tip->p.y) + fabs(tip->p.z) + length;
    const double sag = (tip->curvature + fabs(tip->rate) * length) * length * length;
    if (how.kind == BATTEN_EXTEND_SPIRAL && tip->rate != 0 && sag > DBL_EPSILON * size)
        return spiral_piece(tip, length, how.tolerance, error, out);
    if (how.kind != BATTEN_EXTEND_LINE && tip->curvature * length * length > DBL_EPSILON * size)
        return arc_piece(tip, length, out);
    return line_piece(tip, length, out);
}

/* ---- at work: beyond the end; for the start the curve is reversed ---- */

typedef struct {
    const batten_curve *curve; /* clamped */
    batten_extension extension;
    double length, to; /* one of them NaN */
    double tolerance;
    batten_curve_extend_report report;
    batten_curve *made;
} lengthening;

/* NaN: as it is. */
static batten_status set_end(const batten_curve *piece, double to, batten_curve **out)
{
    if (!isnan(to))
        return batten_curve_set_domain(piece, batten_curve_domain(piece).a, to, out);
    *out = batten_curve_ref(piece);
    return BATTEN_OK;
}

/* The curve, run towards the named end. */
static batten_status turn_to_end(const batten_curve *curve, batten_curve_end end,
                                 batten_curve **out)
{
    if (end == BATTEN_CURVE_START)
        return batten_curve_reverse(curve, out);
    *out = batten_curve_ref(curve);
    return BATTEN_OK;
}

static batten_status add_piece(lengthening *t)
{
    bat_tip tip = {0};
    batten_curve *piece = NULL, *timed = NULL;
    const double b = batten_curve_domain(t->curve).b;
    batten_status status = tip_at(t->curve, &tip);
    const double length = isnan(t->length) ? tip.speed * (t->to - b) : t->length;
    if (status == BATTEN_OK)
        status = bat_tip_piece(&tip, (batten_lengthening){t->extension, t->tolerance}, length,
                               &t->report.error, &piece);
    if (status == BATTEN_OK)
        status = set_end(piece, t->to, &timed);
    if (status == BATTEN_OK)
        status = batten_curves_continuity(t->curve, BATTEN_CURVE_END, timed, BATTEN_CURVE_START,
                                          NULL, &t->report.join);
    if (status == BATTEN_OK)
        status = batten_curve_join(t->curve, timed, 4 * DBL_EPSILON * bat_curve_size(timed),
                                   &t->made);
    t->report.length = length;
    batten_curve_unref(timed);
    batten_curve_unref(piece);
    return status;
}

static batten_status extend_end(lengthening *t)
{
    const batten_interval domain = batten_curve_domain(t->curve);
    batten_curve *tail = NULL;
    double u = t->to;
    bat_tip tip;
    batten_status status = BATTEN_OK;
    if (isnan(u)) {
        const double guess =
            tip_at(t->curve, &tip) == BATTEN_OK ? t->length / tip.speed : domain.b - domain.a;
        status = bat_curve_go_on_by(t->curve, t->length, guess, t->tolerance, &u);
    }
    if (status == BATTEN_OK)
        status = bat_curve_go_on(t->curve, u, &t->made);
    if (status == BATTEN_OK)
        status = batten_curve_subrange(t->made, domain.b, u, &tail);
    if (status == BATTEN_OK)
        status = batten_curve_length(tail, t->tolerance, NULL, &t->report.length);
    if (status == BATTEN_OK)
        status = batten_curves_continuity(t->curve, BATTEN_CURVE_END, tail, BATTEN_CURVE_START,
                                          NULL, &t->report.join);
    batten_curve_unref(tail);
    return status;
}

/* ---- proof ---- */

/* The old part is where it was, and the join as smooth as promised. */
static batten_status verify_extension(const lengthening *t)
{
    enum { SAMPLES = 4 };
    static const int promised[] = {1, 2, 2, -1};
    const int knots = batten_curve_spans(t->curve, NULL), d = t->curve->dimension;
    const double size = bat_max(bat_curve_size(t->curve), bat_curve_size(t->made));
    const double most = 32 * (t->made->degree + 1) * DBL_EPSILON * size;
    double *at = bat_array((size_t)knots, sizeof *at), was[3], is[3];
    batten_status status = at ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        batten_curve_spans(t->curve, at);
    for (int i = 0; status == BATTEN_OK && i < SAMPLES * (knots - 1); i++) {
        const int k = i / SAMPLES;
        const double u = at[k] + (at[k + 1] - at[k]) * ((i % SAMPLES) / (double)SAMPLES);
        status = batten_curve_evaluate(t->curve, u, 0, was);
        if (status == BATTEN_OK)
            status = batten_curve_evaluate(t->made, u, 0, is);
        if (status == BATTEN_OK && bat_distance(d, was, is) > most)
            status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "the curve moved by %g at u = %.17g",
                              bat_distance(d, was, is), u);
    }
    if (status == BATTEN_OK && t->report.join.geometric < promised[t->extension])
        status = bat_fail(BATTEN_TOLERANCE_NOT_MET, "the extension joins with G%d, not G%d",
                          t->report.join.geometric, promised[t->extension]);
    bat_release(at);
    return status;
}

static batten_status check_amount(const batten_curve *curve, double amount, double tolerance)
{
    if (curve->dimension == 1)
        return bat_fail(BATTEN_UNSUPPORTED,
                        "a function has no length to extend; make its graph first");
    if (curve->periodic)
        return bat_fail(BATTEN_NOT_COMPATIBLE, "a periodic curve has no end to extend");
    if (!isfinite(amount))
        return bat_fail(BATTEN_NOT_FINITE, "the curve is extended by %g", amount);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    return BATTEN_OK;
}

/* `t` knows how, not yet what. */
static batten_status extend_curve(lengthening *t, const batten_curve *curve,
                                  batten_curve_end end, batten_curve_extend_report *report,
                                  batten_curve **out)
{
    batten_curve *turned = NULL, *clamped = NULL, *back = NULL;
    batten_status status = turn_to_end(curve, end, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_clamp(turned, &clamped);
    if (status == BATTEN_OK) {
        t->curve = clamped;
        status = t->extension == BATTEN_EXTEND_NATURAL ? extend_end(t) : add_piece(t);
    }
    if (status == BATTEN_OK)
        status = verify_extension(t);
    if (status == BATTEN_OK)
        status = turn_to_end(t->made, end, &back);
    if (status == BATTEN_OK) {
        if (end == BATTEN_CURVE_START)
            t->report.join.u = -t->report.join.u;
        if (report)
            *report = t->report;
        *out = back;
    }
    batten_curve_unref(t->made);
    batten_curve_unref(clamped);
    batten_curve_unref(turned);
    return status;
}

batten_status batten_curve_extend(const batten_curve *curve, batten_curve_end end,
                                  batten_lengthening how, double length,
                                  batten_curve_extend_report *report, batten_curve **out)
{
    assert(curve && out);
    lengthening t = {
        .extension = how.kind, .length = length, .to = NAN, .tolerance = how.tolerance};
    batten_status status = check_amount(curve, length, how.tolerance);
    if (status == BATTEN_OK && !(length > 0))
        status =
            bat_fail(BATTEN_BAD_ARGUMENT, "the curve is extended by %g, not above 0", length);
    return status == BATTEN_OK ? extend_curve(&t, curve, end, report, out) : status;
}

batten_status batten_curve_extend_to(const batten_curve *curve, batten_curve_end end,
                                     batten_lengthening how, double u,
                                     batten_curve_extend_report *report, batten_curve **out)
{
    assert(curve && out);
    const batten_interval domain = batten_curve_domain(curve);
    const bool start = end == BATTEN_CURVE_START;
    lengthening t = {
        .extension = how.kind, .length = NAN, .to = start ? -u : u, .tolerance = how.tolerance};
    batten_status status = check_amount(curve, u, how.tolerance);
    if (status == BATTEN_OK && !(start ? u < domain.a : u > domain.b))
        status = bat_fail(BATTEN_OUT_OF_DOMAIN,
                          "u = %.17g is not beyond the %s of the domain [%.17g, %.17g]", u,
                          start ? "start" : "end", domain.a, domain.b);
    return status == BATTEN_OK ? extend_curve(&t, curve, end, report, out) : status;
}
