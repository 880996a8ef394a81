/*
 * A curve of a network as the surface runs along it: C(map(u)) as a chain of cubic pieces.
 *
 * Between its knots, and between the nodes, the composition is smooth; each such stretch is
 * halved until Hermite's cubics are near enough. At a corner both sides have their own tangents.
 */
#include "numeric/halving.h"
#include "numeric/vector.h"
#include "shape/network/gordon.h"
#include "spline/curve/curve.h"

#include <stdlib.h>
#include <string.h>

/* A place where the composition may be less smooth: parameters of the surface and the curve. */
typedef struct {
    double u, s;
} chain_break;

typedef struct {
    const bat_network_curve *source;
    double tolerance;
    int count, room;
    double *breaks; /* [room + 1] */
    double *points; /* [3 room + 1][3] */
} chain;

enum { MOST_PIECES = 100000 };

/* The value of the map and its slope. */
static batten_status map_at(const bat_network_curve *c, double u, double out[2])
{
    out[0] = u;
    out[1] = 1;
    return c->map ? batten_curve_evaluate(c->map, u, 1, out) : BATTEN_OK;
}

static batten_status at_place(const bat_network_curve *c, chain_break p, batten_side side,
                              double *out)
{
    double map[2];
    batten_status status = map_at(c, p.u, map);
    if (status == BATTEN_OK)
        status =
            batten_curve_evaluate_side(c->curve, bat_max(0, bat_min(1, p.s)), side, 1, out);
    for (int k = 3; status == BATTEN_OK && k < 6; k++)
        out[k] *= map[1];
    return status;
}

batten_status bat_network_point(const bat_network_curve *c, double u, double *point)
{
    double map[2];
    const batten_status status = map_at(c, u, map);
    return status == BATTEN_OK
               ? batten_curve_evaluate(c->curve, bat_max(0, bat_min(1, map[0])), 0, point)
               : status;
}

/* ---- breaks ---- */

/* Where the map, which rises, has the value s: by halving. */
static batten_status invert(const bat_network_curve *c, double s, double *u)
{
    double low = 0, high = 1;
    *u = s;
    for (int i = 0; c->map && i < 60; i++) {
        double map[2];
        *u = low + (high - low) / 2;
        const batten_status status = map_at(c, *u, map);
        if (status != BATTEN_OK)
            return status;
        if (map[0] < s)
            low = *u;
        else
            high = *u;
    }
    return BATTEN_OK;
}

static int by_place(const void *a, const void *b)
{
    const double x = ((const chain_break *)a)->s, y = ((const chain_break *)b)->s;
    return (x > y) - (x < y);
}

/* Knots and nodes in order; a knot at a node has the parameter of the node. */
static batten_status find_breaks(const bat_network_curve *c, int nodes,
                                 const double *parameters, chain_break **out, int *count)
{
    const int knots = batten_curve_spans(c->curve, NULL);
    chain_break *all = bat_array((size_t)(knots + nodes), sizeof *all);
    double *U = bat_array((size_t)knots, sizeof *U);
    batten_status status = all && U ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    int used = 0;
    if (status == BATTEN_OK)
        batten_curve_spans(c->curve, U);
    for (int i = 0; status == BATTEN_OK && i < nodes; i++)
        all[used++] = (chain_break){parameters[i], c->map ? c->at[i] : parameters[i]};
    for (int k = 1; status == BATTEN_OK && k + 1 < knots; k++) {
        int i = 0;
        while (i < nodes && fabs(all[i].s - U[k]) > 1e-12)
            i++;
        if (i < nodes)
            continue;
        all[used].s = U[k];
        status = invert(c, U[k], &all[used++].u);
    }
    bat_release(U);
    if (status != BATTEN_OK) {
        bat_release(all);
        return status;
    }
    qsort(all, (size_t)used, sizeof *all, by_place);
    *out = all;
    *count = used;
    return BATTEN_OK;
}

/* ---- pieces ---- */

static batten_status make_room(chain *c, int more)
{
    if (c->count + more <= c->room)
        return BATTEN_OK;
    const int room = bat_max_int(2 * c->room, c->count + more);
    double *breaks = bat_resize(c->breaks, (size_t)room + 1, sizeof *breaks);
    if (breaks)
        c->breaks = breaks;
    double *points = bat_resize(c->points, 9 * (size_t)room + 3, sizeof *points);
    if (points)
        c->points = points;
    if (!breaks || !points)
        return BATTEN_OUT_OF_MEMORY;
    c->room = room;
    return BATTEN_OK;
}

static void bezier_of(const double *a, const double *b, double h, double *piece)
{
    for (int c = 0; c < 3; c++) {
        piece[c] = a[c];
        piece[3 + c] = a[c] + h / 3 * a[3 + c];
        piece[6 + c] = b[c] - h / 3 * b[3 + c];
        piece[9 + c] = b[c];
    }
}

/* How far a piece from u is off: a bound by what it is at its quarters. */
static batten_status piece_error(const chain *c, double u, double h, const double *piece,
                                 double *worst)
{
    for (int i = 1; i < 4; i++) {
        double basis[4], found[3], wanted[3];
        bat_bernstein(3, i / 4.0, 1 - i / 4.0, basis);
        bat_combine(3, basis, 3, piece, found);
        const batten_status status = bat_network_point(c->source, u + h * (i / 4.0), wanted);
        if (status != BATTEN_OK)
            return status;
        *worst = bat_max(*worst, BAT_CUBIC_BETWEEN_3 * bat_distance(3, found, wanted));
    }
    return BATTEN_OK;
}

/* The end at u of a piece of the stretch from a to b. */
static batten_status place_of_end(const chain *c, chain_break a, chain_break b, double u,
                                  chain_break *out)
{
    double map[2];
    *out = b;
    if (u == b.u)
        return BATTEN_OK;
    const batten_status status = map_at(c->source, u, map);
    if (status == BATTEN_OK)
        *out = (chain_break){u, bat_max(a.s, bat_min(b.s, map[0]))};
    return status;
}

/* The piece that starts at u with these values, up to `to`; its error, and the values there. */
static batten_status try_piece(chain *c, double u, const double *start, chain_break to,
                               double *end, double *error)
{
    batten_status status = make_room(c, 1);
    if (status == BATTEN_OK)
        status = at_place(c->source, to, BATTEN_FROM_LEFT, end);
    if (status != BATTEN_OK)
        return status;
    double *piece = c->points + 9 * (size_t)c->count;
    bezier_of(start, end, to.u - u, piece);
    c->breaks[c->count] = u;
    c->breaks[c->count + 1] = to.u;
    *error = 0;
    return piece_error(c, u, to.u - u, piece, error);
}

static batten_status add_stretch(chain *c, chain_break a, chain_break b)
{
    if (b.u - a.u <= 1e-12) {
        if (c->count > 0) /* too short to be drawn: the piece before it ends later */
            c->breaks[c->count] = b.u;
        return BATTEN_OK;
    }
    double start[6], end[6], error = 0;
    bat_halving h = bat_halving_of(a.u, b.u, BAT_HALVING_MOST);
    batten_status status = at_place(c->source, a, BATTEN_FROM_RIGHT, start);
    while (status == BATTEN_OK && h.waiting > 0) {
        chain_break to;
        status = place_of_end(c, a, b, h.b, &to);
        if (status == BATTEN_OK)
            status = try_piece(c, h.a, start, to, end, &error);
        if (status != BATTEN_OK)
            return status;
        if (error <= c->tolerance) {
            c->count++;
            memcpy(start, end, sizeof start);
            bat_halving_accept(&h);
        } else if (c->count + h.waiting >= MOST_PIECES || !bat_halving_split(&h))
            return bat_fail(BATTEN_TOO_LARGE,
                            "a curve of the network needs more than %d cubic pieces to be "
                            "reparametrised within %g",
                            (int)MOST_PIECES, c->tolerance);
    }
    return status;
}

batten_status bat_network_redraw(const bat_network_curve *curve, int node_count,
                                 const double *parameters, double tolerance, batten_curve **out)
{
    chain c = {.source = curve, .tolerance = tolerance};
    chain_break *breaks = NULL;
    int count = 0;
    batten_status status = find_breaks(curve, node_count, parameters, &breaks, &count);
    for (int i = 0; status == BATTEN_OK && i + 1 < count; i++)
        status = add_stretch(&c, breaks[i], breaks[i + 1]);
    if (status == BATTEN_OK) {
        c.breaks[0] = breaks[0].u; /* where the first stretch was too short, too */
        status = batten_curve_from_bezier(3, (batten_pieces){3, c.count, c.breaks}, c.points,
                                          NULL, out);
    }
    bat_release(breaks);
    bat_release(c.points);
    bat_release(c.breaks);
    return status;
}
