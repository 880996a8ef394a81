/* From chains to NURBS: exact where the spans are, else quintics within a tolerance. */
#include "spline/curve/curve.h"
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "spline/chain/chain.h"

#include <float.h>
#include <string.h>

enum { MAX_PIECES = 10000000, DEPTH = 40 };

static int span_degree(const batten_chain *chain)
{
    bool cubic = true;
    for (int i = 0; i < chain->count; i++)
        cubic = cubic && chain->spans[i].kind == BATTEN_SPAN_TENSION &&
                chain->spans[i].tension == 0;
    return batten_chain_is_arcs(chain) ? 2 : cubic ? 3 : 5;
}

/* ---- pieces on their way ---- */

/* Bezier pieces of one degree; points [count * degree + 1][dimension]. */
typedef struct {
    int dimension, degree, count, capacity;
    bool rational;
    double *points, *weights, *breaks;
    double gap; /* the largest between two pieces, beyond the rounding of their ends */
} pieces;

static void pieces_end(pieces *p)
{
    bat_release(p->points);
    bat_release(p->weights);
    bat_release(p->breaks);
}

static batten_status reserve(pieces *p)
{
    if (p->count < p->capacity)
        return BATTEN_OK;
    if (p->count >= MAX_PIECES)
        return bat_fail(BATTEN_TOO_LARGE, "the chain needs more than %d pieces", MAX_PIECES);
    const size_t capacity = (size_t)bat_max_int(16, 2 * p->capacity);
    const size_t rows = capacity * (size_t)p->degree + 1;
    double *points = bat_resize(p->points, rows, (size_t)p->dimension * sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    p->points = points;
    double *weights = bat_resize(p->weights, rows, sizeof *weights);
    if (!weights)
        return BATTEN_OUT_OF_MEMORY;
    p->weights = weights;
    double *breaks = bat_resize(p->breaks, capacity + 1, sizeof *breaks);
    if (!breaks)
        return BATTEN_OUT_OF_MEMORY;
    p->breaks = breaks;
    p->capacity = (int)capacity;
    return BATTEN_OK;
}

/* Pieces that meet within the rounding of an end, some ten operations, have no gap. */
static double gap_between(int d, const double *end, const double *start)
{
    const double gap = bat_distance(d, end, start);
    return gap <= 16 * DBL_EPSILON * bat_largest(d, start) ? 0 : gap;
}

/* One more piece, up to `b`: its first point is the last of the one before. */
static batten_status add_piece(pieces *p, const double *points, const double *weights, double b)
{
    const batten_status status = reserve(p);
    if (status != BATTEN_OK)
        return status;
    const size_t d = (size_t)p->dimension, rows = (size_t)p->degree + 1;
    const size_t at = (size_t)p->count * (size_t)p->degree, skip = p->count > 0;
    if (skip)
        p->gap = bat_max(p->gap, gap_between(p->dimension, p->points + at * d, points));
    memcpy(p->points + (at + skip) * d, points + skip * d, (rows - skip) * d * sizeof *points);
    for (size_t i = skip; i < rows; i++)
        p->weights[at + i] = weights ? weights[i] : 1;
    p->breaks[++p->count] = b;
    return BATTEN_OK;
}

/* ---- arcs: rational quadratics ---- */

/* From u = a to b, which is part of one span and turns by at most a right angle: the middle
 * point is where the tangents meet. */
static batten_status add_arc(const batten_chain *chain, pieces *p, double a, double b,
                             double turn)
{
    const int d = p->dimension;
    double start[2 * 3], end[2 * 3], points[3 * 3];
    batten_status status = batten_chain_evaluate_side(chain, a, BATTEN_FROM_RIGHT, 1, start);
    if (status == BATTEN_OK)
        status = batten_chain_evaluate_side(chain, b, BATTEN_FROM_LEFT, 1, end);
    if (status != BATTEN_OK)
        return status;
    const double w = bat_cos(turn / 2);
    const double chord = bat_distance(d, start, end), leg = chord / (2 * w);
    const double speed = bat_norm(d, start + d);
    for (int k = 0; k < d; k++) {
        points[k] = start[k];
        points[d + k] = start[k] + leg / speed * start[d + k];
        points[2 * d + k] = end[k];
    }
    const double weights[3] = {1, w, 1};
    return add_piece(p, points, weights, b);
}

static batten_status add_arcs(const batten_chain *chain, pieces *p, int i)
{
    const batten_span *span = &chain->spans[i];
    const double turn = fabs(span->curvature[0]) * span->length;
    const double parts = bat_max(1, ceil(turn / (BAT_PI / 2) * (1 - 1e-12)));
    const double a = chain->breaks[i], b = chain->breaks[i + 1];
    if (!(parts <= MAX_PIECES))
        return bat_fail(BATTEN_TOO_LARGE, "span %d turns %g times", i + 1, turn / (2 * BAT_PI));
    batten_status status = BATTEN_OK;
    for (int k = 0; k < (int)parts && status == BATTEN_OK; k++)
        status =
            add_arc(chain, p, k ? a + (b - a) * (k / parts) : a,
                    k + 1 < (int)parts ? a + (b - a) * ((k + 1) / parts) : b, turn / parts);
    return status;
}

/* ---- cubics and quintics from the values at both ends ---- */

/* The Bezier points of the piece of the given degree, 3 or 5, on [a, b] of one span that has
 * the chain's derivatives at both ends. */
static batten_status hermite(const batten_chain *chain, int degree, double a, double b,
                             double *points)
{
    const int d = batten_chain_dimension(chain), k = (degree + 1) / 2;
    double at[2][3 * 3], breaks[2] = {a, b}, values[2 * 3 * 3];
    batten_status status =
        batten_chain_evaluate_side(chain, a, BATTEN_FROM_RIGHT, k - 1, at[0]);
    if (status == BATTEN_OK)
        status = batten_chain_evaluate_side(chain, b, BATTEN_FROM_LEFT, k - 1, at[1]);
    if (status != BATTEN_OK)
        return status;
    for (int e = 0; e < 2; e++)
        memcpy(values + e * k * d, at[e], (size_t)(k * d) * sizeof *values);
    bat_hermite_points(d, 2, k, breaks, values, points);
    return BATTEN_OK;
}

/* A bound of the distance at equal parameters from piece [a, b] of span i. */
static double quintic_error(const batten_chain *chain, int i, double a, double b,
                            const double *points)
{
    const batten_span *span = &chain->spans[i];
    const int d = batten_chain_dimension(chain);
    const double from = chain->breaks[i];
    const double scale = span->length / (chain->breaks[i + 1] - from);
    /* A point of the piece, and one of the span, are sums of three terms or fewer. */
    const double rounding = 2 * 3 * DBL_EPSILON * bat_largest(6 * d, points);
    return bat_span_quintic_bound(chain->dimension, span, (a - from) * scale,
                                  (b - from) * scale) +
           rounding;
}

/* Halve from the left until every part is near enough; the cubics are exact. */
static batten_status add_hermite(const batten_chain *chain, pieces *p, int i, double tolerance,
                                 double *error)
{
    bat_halving h = bat_halving_of(chain->breaks[i], chain->breaks[i + 1], DEPTH);
    batten_status status = BATTEN_OK;
    while (status == BATTEN_OK && h.waiting > 0) {
        double points[6 * 3], off = 0;
        status = hermite(chain, p->degree, h.a, h.b, points);
        if (status == BATTEN_OK && p->degree == 5)
            off = quintic_error(chain, i, h.a, h.b, points);
        if (status == BATTEN_OK && !(off <= tolerance)) {
            if (!bat_halving_split(&h))
                return bat_fail(BATTEN_TOLERANCE_NOT_MET,
                                "span %d of the chain comes within %g, not %g", i + 1, off,
                                tolerance);
            continue;
        }
        if (status == BATTEN_OK)
            status = add_piece(p, points, NULL, h.b);
        *error = bat_max(*error, off);
        bat_halving_accept(&h);
    }
    return status;
}

/* ---- the whole ---- */

static batten_status convert(const batten_chain *chain, double tolerance, pieces *p,
                             double *error)
{
    batten_status status = reserve(p);
    if (status == BATTEN_OK)
        p->breaks[0] = chain->breaks[0];
    for (int i = 0; i < chain->count && status == BATTEN_OK; i++)
        status =
            p->rational ? add_arcs(chain, p, i) : add_hermite(chain, p, i, tolerance, error);
    *error = bat_max(*error, p->gap);
    return status;
}

batten_status batten_chain_to_curve(const batten_chain *chain, double tolerance, double *error,
                                    batten_curve **out)
{
    assert(chain && out);
    if (!(tolerance > 0 && isfinite(tolerance)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the tolerance is %g, not above 0", tolerance);
    pieces p = {.dimension = batten_chain_dimension(chain), .degree = span_degree(chain)};
    p.rational = p.degree == 2;
    double reached = 0;
    batten_status status = convert(chain, tolerance, &p, &reached);
    if (status == BATTEN_OK)
        status =
            batten_curve_from_bezier(p.dimension, (batten_pieces){p.degree, p.count, p.breaks},
                                     p.points, p.rational ? p.weights : NULL, out);
    if (status == BATTEN_OK && error)
        *error = reached;
    pieces_end(&p);
    return status;
}
