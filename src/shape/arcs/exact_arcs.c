/* Lines and arcs of circles that stand in a NURBS curve as they are, found again. */
#include "shape/arcs/exact_arcs.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"
#include <batten/arcs.h>

#include <string.h>

/* ---- one arc ---- */

/* Point and derivative of a piece at t of it, by the length of the piece: from the left at its
 * end. */
static void piece_at(const batten_curve *curve, const bat_piece *piece, double t, double row[4])
{
    const double h = piece->b - piece->a, u = t < 1 ? piece->a + t * h : piece->b;
    bat_curve_on_piece(curve, piece, u, 1, row);
    row[2] *= h;
    row[3] *= h;
}

/* The arc through three points; half of its turn is the angle at the middle one. */
static bool arc_through(const double a[2], const double m[2], const double b[2],
                        batten_span *out)
{
    const double in[2] = {m[0] - a[0], m[1] - a[1]}, on[2] = {b[0] - m[0], b[1] - m[1]};
    const double chord[2] = {b[0] - a[0], b[1] - a[1]};
    const double half = bat_turn(in, on);
    if (!(bat_norm(2, chord) > 0) || !(fabs(half) < BAT_PI * (1 - 0x1p-20)))
        return false;
    bat_arc_span(a, bat_norm(2, chord), bat_atan2(chord[1], chord[0]), half, out);
    return isfinite(out->length) && out->length > 0;
}

static void line_between(const double a[2], const double b[2], batten_span *out)
{
    bat_arc_span(a, bat_distance(2, a, b), bat_atan2(b[1] - a[1], b[0] - a[0]), 0, out);
}

/* How far a point is beside the circle of an arc, or its line: k d^2 / 2 - N d, which for
 * points of a rational piece of degree p is a polynomial of degree 2 p over w^2. Where it is
 * headed at the point comes along. */
static double beside(const batten_span *arc, const double at[2], double tangent[2])
{
    const double k = arc->curvature[0], T[2] = {bat_cos(arc->angle), bat_sin(arc->angle)};
    const double d[2] = {at[0] - arc->start[0], at[1] - arc->start[1]};
    tangent[0] = T[0] - k * d[1];
    tangent[1] = T[1] + k * d[0];
    return k / 2 * bat_dot(2, d, d) - (T[0] * d[1] - T[1] * d[0]);
}

/* A part of a piece, from t = from to t = to. */
typedef struct {
    const batten_curve *curve;
    const bat_piece *piece;
    double from, to;
} piece_part;

/* Is the part on the arc, and does it go along it once?
 *
 * At the n + 1 extremes of a Chebyshev polynomial, n = 4 p: what is of degree 2 p and below 1
 * there is nowhere above the root of 2 [EZ64]. */
static bool lies_on(const piece_part *part, const batten_span *arc, double tolerance)
{
    const double from = part->from, to = part->to;
    const int n = 4 * part->curve->degree;
    double before[2], turn = 0;
    for (int i = 0; i <= n; i++) {
        const double share = i < n ? bat_sin(BAT_PI * i / (2 * n)) : 1;
        double row[4], tangent[2];
        piece_at(part->curve, part->piece, i < n ? from + (to - from) * share * share : to,
                 row);
        const double off = beside(arc, row, tangent);
        /* At its centre a circle is nowhere near, whatever the square says. */
        if (!(fabs(off) <= tolerance) || !(bat_norm(2, tangent) > 0.5) ||
            !(bat_dot(2, tangent, row + 2) >= -tolerance))
            return false;
        turn += i > 0 ? bat_turn(before, tangent) : 0;
        memcpy(before, tangent, sizeof before);
    }
    return fabs(turn - arc->curvature[0] * arc->length) < 1e-6;
}

/* ---- one piece ---- */

/* A line where it is one within the tolerance, for then its radius is rounding. */
static bool recognise(const piece_part *part, double tolerance, batten_span *out)
{
    double a[4], m[4], b[4];
    piece_at(part->curve, part->piece, part->from, a);
    piece_at(part->curve, part->piece, part->from + (part->to - part->from) / 2, m);
    piece_at(part->curve, part->piece, part->to, b);
    if (!(bat_distance(2, a, b) > 4 * tolerance))
        return false;
    line_between(a, b, out);
    return lies_on(part, out, tolerance) ||
           (part->curve->weights && arc_through(a, m, b, out) && lies_on(part, out, tolerance));
}

double bat_exact_tolerance(const batten_curve *curve)
{
    const batten_box box = batten_curve_box(curve);
    const double size = bat_max(box.high.x - box.low.x, box.high.y - box.low.y);
    const double largest = bat_max(bat_max(fabs(box.low.x), fabs(box.high.x)),
                                   bat_max(fabs(box.low.y), fabs(box.high.y)));
    return bat_max(1e-12 * size, 32 * DBL_EPSILON * largest);
}

bool bat_exact_piece(const batten_curve *curve, const bat_piece *piece, double tolerance,
                     bat_exact *out)
{
    double a[4], m[4], b[4];
    piece_at(curve, piece, 0, a);
    piece_at(curve, piece, 0.5, m);
    piece_at(curve, piece, 1, b);
    /* Beyond half a circle the ends come near, and say less: then half by half. */
    out->count = bat_distance(2, a, b) < bat_distance(2, a, m) ? 2 : 1;
    for (int i = 0; i < out->count; i++) {
        const piece_part part = {curve, piece, (double)i / out->count, (i + 1.0) / out->count};
        if (!recognise(&part, tolerance, &out->arcs[i]))
            return false;
    }
    if (out->count == 2 && bat_exact_merge(&out->arcs[0], &out->arcs[1], tolerance))
        out->count = 1;
    return true;
}

/* ---- neighbours ---- */

static bool passes(const batten_span *arc, const batten_span *part, double t, double tolerance)
{
    double at[2], tangent[2];
    bat_arc_at(part, t, at);
    return fabs(beside(arc, at, tangent)) <= tolerance;
}

bool bat_exact_merge(batten_span *first, const batten_span *next, double tolerance)
{
    const double turn[2] = {first->curvature[0] * first->length,
                            next->curvature[0] * next->length};
    double end[2];
    batten_span one;
    bat_arc_at(next, next->length, end);
    const double chord[2] = {end[0] - first->start[0], end[1] - first->start[1]};
    if (turn[0] * turn[1] < 0 || (turn[0] == 0) != (turn[1] == 0) ||
        fabs(turn[0] + turn[1]) > BAT_PI * (1 + 1e-9) ||
        !(bat_norm(2, chord) > bat_max(first->length, next->length) / 2))
        return false;
    bat_arc_span(first->start, bat_norm(2, chord), bat_atan2(chord[1], chord[0]),
                 (turn[0] + turn[1]) / 2, &one);
    if (!passes(&one, first, first->length / 2, tolerance) ||
        !passes(&one, first, first->length, tolerance) ||
        !passes(&one, next, next->length / 2, tolerance) ||
        !(fabs(one.length - first->length - next->length) <= 4 * tolerance))
        return false;
    *first = one;
    return true;
}

/* ---- a curve ---- */

typedef struct {
    int count;
    batten_span *spans;
    double *breaks;
} arc_spans;

static void add_span(arc_spans *s, const batten_span *span, double b, double tolerance)
{
    if (s->count == 0 || !bat_exact_merge(&s->spans[s->count - 1], span, tolerance))
        s->spans[s->count++] = *span;
    s->breaks[s->count] = b;
}

/* All pieces; false at the first that is neither a line nor an arc. */
static bool find(const batten_curve *curve, double tolerance, arc_spans *s)
{
    const double *U = curve->knots;
    double rows[BAT_MAX_ROWS];
    s->breaks[0] = U[curve->degree];
    for (int k = curve->degree; k < curve->count; k++) {
        if (U[k] == U[k + 1])
            continue;
        bat_exact found;
        const bat_piece piece = bat_curve_piece(curve, k, rows);
        if (!bat_exact_piece(curve, &piece, tolerance, &found))
            return false;
        const double middle = piece.a + (piece.b - piece.a) / 2;
        if (found.count == 2 && !(middle > piece.a && middle < piece.b))
            return false;
        for (int i = 0; i < found.count; i++)
            add_span(s, &found.arcs[i], i + 1 < found.count ? middle : piece.b, tolerance);
    }
    return true;
}

static batten_status of_plane_curve(const batten_curve *curve, batten_chain **out)
{
    const size_t room = 2 * (size_t)(batten_curve_spans(curve, NULL) - 1);
    const double tolerance = bat_exact_tolerance(curve);
    arc_spans s = {.spans = bat_array(room, sizeof *s.spans),
                   .breaks = bat_array(room + 1, sizeof *s.breaks)};
    batten_chain *chain = NULL;
    batten_status status = s.spans && s.breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && isfinite(tolerance) && find(curve, tolerance, &s))
        status =
            batten_chain_create(&(batten_chain_parts){2, s.count, s.spans, s.breaks,
                                                      batten_curve_is_closed(curve, tolerance)},
                                16 * tolerance, &chain);
    bat_release(s.spans);
    bat_release(s.breaks);
    if (status == BATTEN_OK)
        *out = chain;
    return status;
}

/* ---- curves in space ---- */

static batten_status of_space_curve(const batten_curve *curve, batten_chain **out)
{
    int axis;
    batten_curve *flat = NULL;
    batten_chain *chain = NULL, *placed = NULL;
    batten_status status = batten_curve_flatten(curve, &axis, &flat);
    if (status == BATTEN_OK && axis >= 0)
        status = of_plane_curve(flat, &chain);
    if (status == BATTEN_OK && chain) {
        const batten_frame frame = batten_frame_across(axis, curve->points[axis]);
        status = batten_chain_place(chain, &frame, &placed);
    }
    batten_curve_unref(flat);
    batten_chain_unref(chain);
    if (status == BATTEN_OK)
        *out = placed;
    return status;
}

batten_status batten_arcs_from_curve_exact(const batten_curve *curve, batten_chain **out)
{
    assert(curve && out);
    if (curve->dimension == 3)
        return of_space_curve(curve, out);
    if (curve->dimension == 2)
        return of_plane_curve(curve, out);
    *out = NULL;
    return BATTEN_OK;
}
