/*
 * How many lines a plane section can have at most, by the control net.
 *
 * The section is where F = w (coordinate - level) is 0. Where all control values of F have one sign, the plane misses the surface.
 * Where they increase strictly along u in every row, F does, and each line of constant v meets the section once where F is
 * negative at its begin and positive at its end, else never. The edges change sign no more often than their control values,
 * so those begins are at most as many intervals as the runs of negative values of the first edge, those ends as many as the
 * runs of positive ones of the last; two such sets have at most one interval less in common than they are in all. That is the
 * largest number of lines.
 */
#include "design/features/take/section_proof.h"

#include <float.h>
#include <math.h>

typedef struct {
    const batten_surface *surface;
    int count[2];
    int axis;
    double level;
    double roundoff; /* what is larger has its sign for sure */
} net;

static double value_at(const net *n, int i, int j)
{
    const size_t at = (size_t)i * (size_t)n->count[1] + (size_t)j;
    const double *weights = batten_surface_weights(n->surface);
    const double height =
        batten_surface_points(n->surface)[3 * at + (size_t)n->axis] - n->level;
    return weights ? weights[at] * height : height;
}

static double largest_term(const net *n)
{
    const double *points = batten_surface_points(n->surface);
    const double *weights = batten_surface_weights(n->surface);
    double largest = 0;
    for (size_t k = 0; k < (size_t)n->count[0] * (size_t)n->count[1]; k++) {
        const double term = fabs(points[3 * k + (size_t)n->axis]) + fabs(n->level);
        largest = fmax(largest, weights ? weights[k] * term : term);
    }
    return largest;
}

/* 1 or -1 when all values have this sign, else 0. */
static int common_sign(const net *n)
{
    int above = 0, below = 0;
    for (int i = 0; i < n->count[0]; i++)
        for (int j = 0; j < n->count[1]; j++) {
            const double value = value_at(n, i, j);
            above += value > n->roundoff;
            below += value < -n->roundoff;
        }
    const int all = n->count[0] * n->count[1];
    return above == all ? 1 : below == all ? -1 : 0;
}

/* The value at place k of the row at `along` of a direction. */
static double value_in(const net *n, int direction, int along, int k)
{
    return direction == 0 ? value_at(n, along, k) : value_at(n, k, along);
}

/* 1 or -1 when the values rise or fall strictly along a direction, else 0. */
static int common_slope(const net *n, int direction)
{
    int up = 0, down = 0;
    for (int along = 0; along + 1 < n->count[direction]; along++)
        for (int k = 0; k < n->count[1 - direction]; k++) {
            const double step =
                value_in(n, direction, along + 1, k) - value_in(n, direction, along, k);
            up += step > n->roundoff;
            down += step < -n->roundoff;
        }
    const int all = (n->count[direction] - 1) * n->count[1 - direction];
    return up == all ? 1 : down == all ? -1 : 0;
}

/* Does the surface begin and end in its first and last row of control points? */
static bool is_clamped(const batten_surface *surface, batten_direction direction)
{
    const double *knots = batten_surface_knots(surface, direction);
    const int degree = batten_surface_degree(surface, direction);
    const int last = batten_surface_point_count(surface, direction) + degree;
    return knots[0] == knots[degree] && knots[last] == knots[last - degree];
}

/* Runs of values with this sign in the row at `along`; -1 where a value has none for sure. */
static int count_runs(const net *n, int direction, int along, int sign)
{
    int runs = 0;
    bool inside = false;
    for (int k = 0; k < n->count[1 - direction]; k++) {
        const double value = sign * value_in(n, direction, along, k);
        if (fabs(value) <= n->roundoff)
            return -1;
        runs += value > 0 && !inside;
        inside = value > 0;
    }
    return runs;
}

/* At most so many lines; -1 where that is not known. */
static int most_lines(const net *n, int direction)
{
    const int slope = common_slope(n, direction);
    if (slope == 0 || !is_clamped(n->surface, (batten_direction)direction) ||
        !is_clamped(n->surface, (batten_direction)(1 - direction)))
        return -1;
    const int begins = count_runs(n, direction, 0, -slope);
    const int ends = count_runs(n, direction, n->count[direction] - 1, slope);
    if (begins < 0 || ends < 0)
        return -1;
    return begins > 0 && ends > 0 ? begins + ends - 1 : 0;
}

bool bat_section_is_proved(const batten_surface *surface, int axis, double level, int lines)
{
    net n = {.surface = surface,
             .count = {batten_surface_point_count(surface, BATTEN_U),
                       batten_surface_point_count(surface, BATTEN_V)},
             .axis = axis,
             .level = level};
    /* A difference, a product and a difference of products: each rounds its terms once. */
    n.roundoff = 4 * DBL_EPSILON * largest_term(&n);
    if (common_sign(&n) != 0)
        return lines == 0;
    return most_lines(&n, 0) == lines || most_lines(&n, 1) == lines;
}
