/*
 * Points and parameters beyond the ends of a row of data, for local methods: extrapolated by
 * Neville's algorithm, mirrored in the end point or repeated, or periodic.
 */
#include "shape/points/mirrored_ends.h"
#include "shape/points/parametrize.h"
#include "spline/data_check.h"

#include <string.h>

static batten_status check_rule(const bat_beyond_rule *rule)
{
    if ((int)rule->kind < 0 || rule->kind > BATTEN_PHANTOM_REPEAT)
        return bat_fail(BATTEN_BAD_ARGUMENT, "unknown rule %d for points beyond the ends",
                        (int)rule->kind);
    if (!rule->given && !(rule->alpha >= 0 && rule->alpha <= 1))
        return bat_fail(BATTEN_BAD_ARGUMENT, "alpha is %g; it must be in 0..1", rule->alpha);
    return BATTEN_OK;
}

batten_status bat_row_beyond_make(batten_points points, const bat_beyond_rule *rule,
                                  bat_row_beyond *row)
{
    const int d = points.dimension, count = points.count;
    const bool closed = rule->closed;
    *row = (bat_row_beyond){d, count, closed, rule->kind, rule->degree, points.at, NULL};
    batten_status status = bat_points_check(d, count, points.at, closed ? 3 : 2);
    if (status == BATTEN_OK)
        status = check_rule(rule);
    if (status != BATTEN_OK)
        return status;
    row->degree = bat_min_int(rule->degree, count - 1);
    row->t = bat_array((size_t)count + closed, sizeof *row->t);
    if (!row->t)
        return BATTEN_OUT_OF_MEMORY;
    if (!rule->given)
        return bat_parametrize_power(points, rule->alpha, closed, row->t);
    memcpy(row->t, rule->given, ((size_t)count + closed) * sizeof *row->t);
    return bat_parameters_check(count + closed, row->t);
}

/* What stands at index i of an open row is seen in mirrors at both ends: `sign` times what
 * stands at `index` inside, plus twice the ends themselves, the first one `first` times and the
 * last one `last` times. */
typedef struct {
    int index, first, last;
    double sign;
} mirrored;

static mirrored mirror(int count, int i)
{
    mirrored m = {.sign = 1};
    const int last = count - 1;
    while (i < 0 || i > last) {
        if (i < 0) {
            m.first += (int)m.sign;
            i = -i;
        } else {
            m.last += (int)m.sign;
            i = 2 * last - i;
        }
        m.sign = -m.sign;
    }
    m.index = i;
    return m;
}

/* How many whole periods i lies beyond the row, and its index inside. */
static int periods(int count, int *i)
{
    const int turns = *i >= 0 ? *i / count : -((count - 1 - *i) / count);
    *i -= turns * count;
    return turns;
}

double bat_parameter_beyond(const bat_row_beyond *row, int i)
{
    const double *t = row->t;
    if (row->closed) {
        if (i == row->count)
            return t[i];
        const int turns = periods(row->count, &i);
        return t[i] + turns * (t[row->count] - t[0]);
    }
    const mirrored m = mirror(row->count, i);
    return m.sign * t[m.index] + 2 * (m.first * t[0] + m.last * t[row->count - 1]);
}

static const double *vertex(const bat_row_beyond *row, int i)
{
    return row->points + (size_t)i * (size_t)row->d;
}

/* Aitken and Neville: the polynomial through the points from `first` on, at u. */
static void extrapolate(const bat_row_beyond *row, int first, double u, double *out)
{
    double level[BATTEN_MAX_DEGREE + 1][3];
    const double *t = row->t + first;
    const size_t d = (size_t)row->d;
    for (int a = 0; a <= row->degree; a++)
        memcpy(level[a], vertex(row, first + a), d * sizeof **level);
    for (int l = 1; l <= row->degree; l++)
        for (int a = 0; a + l <= row->degree; a++)
            for (size_t k = 0; k < d; k++)
                level[a][k] += (u - t[a]) / (t[a + l] - t[a]) * (level[a + 1][k] - level[a][k]);
    memcpy(out, level[0], d * sizeof *out);
}

void bat_point_beyond(const bat_row_beyond *row, int i, double *out)
{
    const int last = row->count - 1;
    const size_t d = (size_t)row->d;
    if (row->closed)
        periods(row->count, &i);
    else if (row->kind == BATTEN_PHANTOM_REPEAT)
        i = bat_max_int(0, bat_min_int(i, last));
    if (i >= 0 && i <= last) {
        memcpy(out, vertex(row, i), d * sizeof *out);
    } else if (row->kind == BATTEN_PHANTOM_EXTRAPOLATE) {
        extrapolate(row, i < 0 ? 0 : last - row->degree, bat_parameter_beyond(row, i), out);
    } else {
        const mirrored m = mirror(row->count, i);
        for (size_t k = 0; k < d; k++)
            out[k] = m.sign * vertex(row, m.index)[k] +
                     2 * (m.first * vertex(row, 0)[k] + m.last * vertex(row, last)[k]);
    }
}
