/* Biarcs by their legs, in the plane or in space, as rational quadratics. */
#include "numeric/vector.h"
#include "shape/arcs/biarc.h"

#include <string.h>

/* Pieces on their way: 4 at most for each biarc, since an arc is halved when it turns by more
 * than a right angle. */
typedef struct {
    int d, count;
    double *points;  /* [4 n * 2 + 1][d] */
    double *weights; /* [4 n * 2 + 1] */
    double *breaks;  /* [4 n + 1] */
} rational_pieces;

static batten_status pieces_make(rational_pieces *p, int d, size_t biarcs)
{
    *p = (rational_pieces){.d = d};
    p->points = bat_array3(8 * biarcs + 1, (size_t)d, sizeof *p->points);
    p->weights = bat_array(8 * biarcs + 1, sizeof *p->weights);
    p->breaks = bat_array(4 * biarcs + 1, sizeof *p->breaks);
    return p->points && p->weights && p->breaks ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void pieces_end(rational_pieces *p)
{
    bat_release(p->points);
    bat_release(p->weights);
    bat_release(p->breaks);
}

/* By its ends and the corner between them, and the weight of this. */
static void add_piece(rational_pieces *p, const double *const points[3], double weight,
                      double until)
{
    const size_t at = 2 * (size_t)p->count, d = (size_t)p->d;
    for (size_t i = 0; i < 3; i++)
        memcpy(p->points + (at + i) * d, points[i], d * sizeof *p->points);
    p->weights[at] = p->weights[at + 2] = 1;
    p->weights[at + 1] = weight;
    p->breaks[++p->count] = until;
}

/* An arc from a to b whose end tangents meet in `corner`; adds its length. */
static void add_arc(rational_pieces *p, const double *a, const double *corner, const double *b)
{
    const int d = p->d;
    const double chord = bat_distance(d, a, b);
    const double legs = bat_distance(d, a, corner) + bat_distance(d, corner, b);
    /* The cosine of half the turn; the sine by the height of the triangle, for small turns. */
    const double w = bat_min(1, chord / legs);
    double middle[3], height = 0;
    for (int k = 0; k < d; k++) {
        middle[k] = corner[k] - (a[k] / 2 + b[k] / 2);
        height += middle[k] * middle[k];
    }
    const double half = bat_atan2(2 * sqrt(height), chord);
    const double length = half == 0 ? chord : chord * (half / bat_sin(half));
    const double start = p->breaks[p->count];
    if (w * w >= 0.5) {
        add_piece(p, (const double *const[]){a, corner, b}, w, start + length);
        return;
    }
    double first[3], second[3], between[3];
    for (int k = 0; k < d; k++) {
        first[k] = (a[k] + w * corner[k]) / (1 + w);
        second[k] = (b[k] + w * corner[k]) / (1 + w);
        between[k] = first[k] / 2 + second[k] / 2;
    }
    const double weight = sqrt((1 + w) / 2);
    add_piece(p, (const double *const[]){a, first, between}, weight, start + length / 2);
    add_piece(p, (const double *const[]){between, second, b}, weight, start + length);
}

/* The second leg d2 of the biarc whose first is r d2, from
 * 2 r (1 - T0.T1) d2^2 + 2 V.(r T0 + T1) d2 = V.V; for a chord V of length 1. */
static double second_leg(int d, const double *V, const double *T0, const double *T1, double r)
{
    double difference[3];
    for (int k = 0; k < d; k++)
        difference[k] = T0[k] - T1[k];
    /* 1 - T0.T1, without cancellation. */
    const double c = bat_dot(d, difference, difference) / 2;
    const double b = r * bat_dot(d, V, T0) + bat_dot(d, V, T1);
    const double root = sqrt(b * b + 2 * r * c);
    return b > 0 ? 1 / (b + root) : (root - b) / (2 * r * c);
}

static batten_status add_biarc(rational_pieces *p, batten_ray start, batten_ray end,
                               double ratio)
{
    const int d = p->d;
    const double *a = start.point, *b = end.point;
    const double l = bat_distance(d, a, b);
    double V[3], T0[3], T1[3], corner[2][3], joint[3];
    for (int k = 0; k < d; k++)
        V[k] = (b[k] - a[k]) / l;
    bat_direction(d, start.direction, T0);
    bat_direction(d, end.direction, T1);
    const double leg = second_leg(d, V, T0, T1, ratio);
    /* Legs are a / sin of the angles, which are known to some eps. */
    if (!(leg * bat_max(1, ratio) < 0x1p26))
        return bat_fail(BATTEN_SINGULAR_HERE,
                        "the directions at both ends are equal and do not point along the "
                        "chord: no biarc has legs in the ratio %g",
                        ratio);
    for (int k = 0; k < d; k++) {
        corner[0][k] = a[k] + ratio * leg * l * T0[k];
        corner[1][k] = b[k] - leg * l * T1[k];
        joint[k] = (corner[0][k] + ratio * corner[1][k]) / (1 + ratio);
    }
    add_arc(p, a, corner[0], joint);
    add_arc(p, joint, corner[1], b);
    return BATTEN_OK;
}

static batten_status make_rational_curve(const rational_pieces *p, batten_curve **out)
{
    return batten_curve_from_bezier(p->d, (batten_pieces){2, p->count, p->breaks}, p->points,
                                    p->weights, out);
}

batten_status batten_curve_biarc(int dimension, batten_ray start, batten_ray end, double ratio,
                                 batten_curve **out)
{
    assert(start.point && start.direction && end.point && end.direction && out);
    if (dimension != 2 && dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "a biarc of %d dimensions; there are 2 and 3",
                        dimension);
    if (!(ratio > 0 && isfinite(ratio)))
        return bat_fail(BATTEN_BAD_ARGUMENT, "the ratio of the legs is %g; it must be above 0",
                        ratio);
    batten_status status =
        bat_biarc_check_ends(dimension, start.point, start.direction, end.point, end.direction);
    if (status != BATTEN_OK)
        return status;
    rational_pieces p;
    status = pieces_make(&p, dimension, 1);
    if (status == BATTEN_OK)
        status = add_biarc(&p, start, end, ratio);
    if (status == BATTEN_OK)
        status = make_rational_curve(&p, out);
    pieces_end(&p);
    return status;
}

/* ---- through points ---- */

static batten_status add_all(rational_pieces *p, batten_points points, bool closed,
                             const double *directions, double *at)
{
    const int d = p->d, count = points.count, spans = closed ? count : count - 1;
    batten_status status = BATTEN_OK;
    for (int i = 0; i < spans && status == BATTEN_OK; i++) {
        const int j = (i + 1) % count;
        at[i] = p->breaks[p->count];
        status = add_biarc(p, (batten_ray){points.at + i * d, directions + i * d},
                           (batten_ray){points.at + j * d, directions + j * d}, 1);
        if (status != BATTEN_OK)
            status = bat_fail(status, "between points %d and %d: %s", i + 1, j + 1,
                              batten_message());
    }
    if (status == BATTEN_OK && !closed)
        at[count - 1] = p->breaks[p->count];
    return status;
}

batten_status batten_curve_biarcs(batten_points points,
                                  const batten_chain_biarcs_options *options,
                                  double *parameters, batten_curve **out)
{
    assert(points.at && out);
    batten_chain_biarcs_options wanted = batten_chain_biarcs_defaults();
    batten_status status = BAT_TAKE_OPTIONS(batten_chain_biarcs_options, options, &wanted);
    if (status != BATTEN_OK)
        return status;
    if (points.dimension != 2 && points.dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "biarcs of %d dimensions; there are 2 and 3",
                        points.dimension);
    status = bat_biarcs_check(points.dimension, points.count, points.at, &wanted);
    if (status != BATTEN_OK)
        return status;
    const size_t n = (size_t)points.count, d = (size_t)points.dimension;
    rational_pieces p;
    status = pieces_make(&p, points.dimension, n);
    double *directions = bat_array3(n, d, sizeof *directions);
    double *at = bat_array(n, sizeof *at);
    if (status == BATTEN_OK && (!directions || !at))
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK && wanted.directions)
        memcpy(directions, wanted.directions, n * d * sizeof *directions);
    else if (status == BATTEN_OK)
        status = bat_circle_directions(points.dimension, points.count, points.at, wanted.closed,
                                       directions);
    if (status == BATTEN_OK)
        status = add_all(&p, points, wanted.closed, directions, at);
    if (status == BATTEN_OK)
        status = make_rational_curve(&p, out);
    if (status == BATTEN_OK && parameters)
        memcpy(parameters, at, n * sizeof *parameters);
    bat_release(directions);
    bat_release(at);
    pieces_end(&p);
    return status;
}
