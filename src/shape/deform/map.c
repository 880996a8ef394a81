/* Points, and functions of two parameters, under a deformation. */
#include "numeric/box.h"
#include "numeric/vector.h"
#include "shape/deform/lattice.h"

#include <stdio.h>
#include <string.h>

enum { ORDER = 3, WIDTH = BAT_LATTICE_MOST_DEGREE + 1 };

/* Where a point is in one direction: its span and what acts there. */
typedef struct {
    int first;
    double basis[ORDER + 1][WIDTH]; /* and derivatives by the model's unit */
} stance;

/* False outside of the box. Where that is refused only rounding leads there. */
static bool find_stance(const batten_deformation *d, int k, double x, int order, stance *out)
{
    const bat_axis *axis = &d->axes[k];
    double s = (x - d->low[k]) / d->extent[k], values[(ORDER + 1) * WIDTH] = {0};
    if (!(s >= 0 && s <= 1)) {
        if (d->join != BATTEN_BOX_JOIN_NONE)
            return false;
        s = s < 0.5 ? 0 : 1;
    }
    const int span = bat_axis_span(axis, s, BATTEN_FROM_RIGHT), p = axis->degree;
    bat_axis_basis(axis, span, s, bat_min_int(order, p), values);
    out->first = bat_axis_first_point(axis, span);
    double unit = 1;
    for (int m = 0; m <= order; m++, unit /= d->extent[k])
        for (int i = 0; i <= p; i++)
            out->basis[m][i] = unit * values[m * (p + 1) + i];
    return true;
}

static bool find_stances(const batten_deformation *d, const double x[3], int order,
                         stance at[3])
{
    for (int k = 0; k < 3; k++)
        if (!find_stance(d, k, x[k], order, &at[k]))
            return false;
    return true;
}

/* The sum of moves with derivatives of these orders of the three basis functions. */
static void sum_moves(const batten_deformation *d, const stance at[3], const int orders[3],
                      double out[3])
{
    const int *p = d->lattice.degrees;
    out[0] = out[1] = out[2] = 0;
    for (int i = 0; i <= p[0]; i++)
        for (int j = 0; j <= p[1]; j++) {
            const double share = at[0].basis[orders[0]][i] * at[1].basis[orders[1]][j];
            const double *move = d->moves + 3 * bat_lattice_index(&d->lattice, at[0].first + i,
                                                                  at[1].first + j, at[2].first);
            for (int k = 0; k <= p[2]; k++)
                for (int c = 0; c < 3; c++)
                    out[c] += share * at[2].basis[orders[2]][k] * move[3 * k + c];
        }
}

void bat_deformation_point(const batten_deformation *d, const double x[3], double out[3])
{
    static const int none[3] = {0, 0, 0};
    stance at[3];
    double move[3] = {0, 0, 0};
    if (find_stances(d, x, 0, at))
        sum_moves(d, at, none, move);
    for (int c = 0; c < 3; c++)
        out[c] = x[c] + move[c];
}

void bat_deformation_jacobian(const batten_deformation *d, const double x[3], double out[3][3])
{
    stance at[3];
    const bool inside = find_stances(d, x, 1, at);
    for (int k = 0; k < 3; k++) {
        int orders[3] = {0, 0, 0};
        double by[3] = {0, 0, 0};
        orders[k] = 1;
        if (inside)
            sum_moves(d, at, orders, by);
        for (int c = 0; c < 3; c++)
            out[c][k] = (c == k) + by[c];
    }
}

/* The derivative of a B-spline is a mean of the differences of its points over the knots that they share. */
double bat_deformation_stretch(const batten_deformation *d)
{
    const int *n = d->lattice.counts;
    double square = 0;
    for (int k = 0; k < 3; k++) {
        const bat_axis *axis = &d->axes[k];
        const size_t stride = k == 2 ? 1 : k == 1 ? (size_t)n[2] : (size_t)n[1] * (size_t)n[2];
        const int total = n[0] * n[1] * n[2];
        double most = 0;
        for (int at = 0; at < total; at++) {
            const int i = at / (int)stride % n[k], p = axis->degree;
            if (i + 1 == n[k])
                continue;
            const double *move = d->moves + 3 * (size_t)at;
            const double by = bat_distance(3, move, move + 3 * stride);
            most = bat_max(most, p * by / (axis->knots[i + p + 1] - axis->knots[i + 1]));
        }
        square += most * most / (d->extent[k] * d->extent[k]);
    }
    return 1 + sqrt(square);
}

/* A basis function of one direction as a jet. */
static bat_jet compose_basis(const stance *at, int i, bat_jet x)
{
    const double g[ORDER + 1] = {at->basis[0][i], at->basis[1][i], at->basis[2][i],
                                 at->basis[3][i]};
    return bat_jet_compose(g, x);
}

static void add_scaled(bat_jet *sum, double factor, const bat_jet *by)
{
    for (int m = 0; m < BAT_JET_SIZE; m++)
        sum->d[m] += factor * by->d[m];
}

/* The sum over one line of lattice points along z. */
static void sum_line(const batten_deformation *d, const bat_jet *basis, const double *moves,
                     bat_jet out[3])
{
    for (int c = 0; c < 3; c++) {
        out[c] = bat_jet_constant(0);
        for (int k = 0; k <= d->lattice.degrees[2]; k++)
            add_scaled(&out[c], moves[3 * k + c], &basis[k]);
    }
}

void bat_deformation_jets(const batten_deformation *d, const bat_jet x[3], bat_jet out[3])
{
    const double point[3] = {x[0].d[0], x[1].d[0], x[2].d[0]};
    const int *p = d->lattice.degrees;
    bat_jet along_z[WIDTH], line[3], sum[3];
    stance at[3];
    memcpy(sum, x, sizeof sum);
    const bool inside = find_stances(d, point, ORDER, at);
    for (int k = 0; k <= p[2] && inside; k++)
        along_z[k] = compose_basis(&at[2], k, x[2]);
    for (int i = 0; i <= p[0] && inside; i++)
        for (int j = 0; j <= p[1]; j++) {
            const bat_jet share = bat_jet_multiply(compose_basis(&at[0], i, x[0]),
                                                   compose_basis(&at[1], j, x[1]));
            const double *moves =
                d->moves + 3 * bat_lattice_index(&d->lattice, at[0].first + i, at[1].first + j,
                                                 at[2].first);
            sum_line(d, along_z, moves, line);
            for (int c = 0; c < 3; c++)
                sum[c] = bat_jet_add(sum[c], bat_jet_multiply(share, line[c]));
        }
    memcpy(out, sum, sizeof sum);
}

batten_status batten_deformation_apply(const batten_deformation *deformation,
                                       batten_points points, double *out)
{
    assert(deformation && (points.at || points.count == 0) && out);
    if (points.dimension != 3)
        return bat_fail(BATTEN_BAD_ARGUMENT, "points of dimension %d, not 3", points.dimension);
    batten_status status = BATTEN_OK;
    for (int i = 0; i < points.count && status == BATTEN_OK; i++) {
        char what[40];
        const double *p = points.at + 3 * (size_t)i;
        if (bat_first_not_finite(p, 3) < 3)
            return bat_fail(BATTEN_NOT_FINITE, "point %d has a coordinate that is not finite",
                            i + 1);
        snprintf(what, sizeof what, "point %d", i + 1);
        status = bat_deformation_check(deformation, bat_box_at(p), what);
    }
    for (int i = 0; i < points.count && status == BATTEN_OK; i++)
        bat_deformation_point(deformation, points.at + 3 * (size_t)i, out + 3 * (size_t)i);
    return status;
}
