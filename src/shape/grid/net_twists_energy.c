/*
 * The twists of least energy, the sum over all cells of the integrals of Suu^2 + 2 Suv^2 +
 * Svv^2 of bicubic patches. For a cell of h by k it is x^T M x with
 *     M = (k / h^3) K2 x K0 + (2 / (h k)) K1 x K1 + (h / k^3) K0 x K2
 * in the order of F0, F1, G0, G1 in either direction, tangents scaled by h or k, twists by h k.
 */
#include "shape/grid/net_twists.h"

#include "numeric/banded.h"

#include <string.h>

static const double K2[4][4] = {
    {12, -12, 6, 6}, {-12, 12, -6, -6}, {6, -6, 4, 2}, {6, -6, 2, 4}};
static const double K1[4][4] = {{6 / 5.0, -6 / 5.0, 1 / 10.0, 1 / 10.0},
                                {-6 / 5.0, 6 / 5.0, -1 / 10.0, -1 / 10.0},
                                {1 / 10.0, -1 / 10.0, 2 / 15.0, -1 / 30.0},
                                {1 / 10.0, -1 / 10.0, -1 / 30.0, 2 / 15.0}};
static const double K0[4][4] = {{13 / 35.0, 9 / 70.0, 11 / 210.0, -13 / 420.0},
                                {9 / 70.0, 13 / 35.0, 13 / 420.0, -11 / 210.0},
                                {11 / 210.0, 13 / 420.0, 1 / 105.0, -1 / 140.0},
                                {-13 / 420.0, -11 / 210.0, -1 / 140.0, 1 / 105.0}};

enum { MOST_NUMBERS = 200000000 };

/* The system: unknown (i, j) stands at i * stride[0] + j * stride[1], the shorter way first. */
typedef struct {
    const bat_net *net;
    int n, lower, stride[2];
    double *matrix, *right;
} energy;

static double entry(double h, double k, int a, int b, int c, int d)
{
    return k / (h * h * h) * K2[a][c] * K0[b][d] + 2 / (h * k) * K1[a][c] * K1[b][d] +
           h / (k * k * k) * K0[a][c] * K2[b][d];
}

static int unknown_of(const energy *e, int i, int j)
{
    return i * e->stride[0] + j * e->stride[1];
}

/* What the net knows for blends a in u, b in v of cell (i, j), scaled to the cell; not both G.
 */
static const double *known(const energy *e, int i, int j, int a, int b, double h, double k,
                           double *scale)
{
    const bat_net *net = e->net;
    const size_t at = bat_net_index(net, i + a % 2, j + b % 2);
    *scale = (a >= 2 ? h : 1) * (b >= 2 ? k : 1);
    return (a >= 2 ? net->su : b >= 2 ? net->sv : net->points) + at;
}

/* The row of twist (a, b) of cell (i, j), in the unknowns themselves: h k is split between
 * both factors of the square. */
static void add_row(energy *e, int i, int j, int a, int b)
{
    const bat_net *net = e->net;
    const int d = net->dimension, row = unknown_of(e, i + a % 2, j + b % 2);
    const double h = net->at[0][i + 1] - net->at[0][i], k = net->at[1][j + 1] - net->at[1][j];
    for (int c = 0; c < 4; c++)
        for (int l = 0; l < 4; l++) {
            const double m = entry(h, k, a, b, c, l) * h * k;
            if (c >= 2 && l >= 2) {
                const int column = unknown_of(e, i + c % 2, j + l % 2);
                if (column <= row)
                    e->matrix[(size_t)row * (size_t)(e->lower + 1) +
                              (size_t)(column - row + e->lower)] += m * h * k;
                continue;
            }
            double scale;
            const double *value = known(e, i, j, c, l, h, k, &scale);
            for (int x = 0; x < d; x++)
                e->right[row * d + x] -= m * scale * value[x];
        }
}

static batten_status solve_least_energy(energy *e, double *twists)
{
    const bat_net *net = e->net;
    const int d = net->dimension;
    for (int i = 0; i + 1 < net->count[0]; i++)
        for (int j = 0; j + 1 < net->count[1]; j++)
            for (int a = 2; a < 4; a++)
                for (int b = 2; b < 4; b++)
                    add_row(e, i, j, a, b);
    const batten_status status = bat_symmetric_factor(e->n, e->lower, e->matrix);
    if (status != BATTEN_OK)
        return status;
    bat_symmetric_solve(e->n, e->lower, e->matrix, (size_t)d, e->right);
    for (int i = 0; i < net->count[0]; i++)
        for (int j = 0; j < net->count[1]; j++)
            memcpy(twists + bat_net_index(net, i, j),
                   e->right + (size_t)unknown_of(e, i, j) * (size_t)d,
                   (size_t)d * sizeof *twists);
    return BATTEN_OK;
}

batten_status bat_net_energy_twists(const bat_net *net, double *twists)
{
    const int shorter = bat_min_int(net->count[0], net->count[1]);
    const bool v_first = net->count[1] <= net->count[0];
    energy e = {.net = net, .lower = shorter + 1};
    const double numbers = (double)net->count[0] * net->count[1] * (e.lower + 1);
    if (numbers > MOST_NUMBERS)
        return bat_fail(BATTEN_TOO_LARGE,
                        "twists of least energy on a net of %d x %d need %.0f numbers; the "
                        "limit is %d",
                        net->count[0], net->count[1], numbers, MOST_NUMBERS);
    e.n = net->count[0] * net->count[1];
    e.stride[0] = v_first ? net->count[1] : 1;
    e.stride[1] = v_first ? 1 : net->count[0];
    e.matrix = bat_array3((size_t)e.n, (size_t)e.lower + 1, sizeof *e.matrix);
    e.right = bat_array3((size_t)e.n, (size_t)net->dimension, sizeof *e.right);
    const batten_status status =
        e.matrix && e.right ? solve_least_energy(&e, twists) : BATTEN_OUT_OF_MEMORY;
    bat_release(e.matrix);
    bat_release(e.right);
    return status;
}
