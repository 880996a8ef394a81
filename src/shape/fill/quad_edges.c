/* The four functions of a quad along each parameter, linear in the unknowns. */
#include "shape/fill/fill.h"
#include <string.h>

/* In powers of t: value at 0, first, second derivative, then those at 1. */
static const double cubic[6][6] = {{1, 0, -3, 2}, {0, 1, -2, 1}, {0},
                                   {0, 0, 3, -2}, {0, 0, -1, 1}, {0}};
static const double quintic[6][6] = {{1, 0, 0, -10, 15, -6},       {0, 1, 0, -6, 8, -3},
                                     {0, 0, 0.5, -1.5, 1.5, -0.5}, {0, 0, 0, 10, -15, 6},
                                     {0, 0, 0, -4, 7, -3},         {0, 0, 0, 0.5, -1, 0.5}};

void bat_fill_hermite(int derivatives, double t, int order, double out[][6])
{
    const double(*power)[6] = derivatives == 2 ? quintic : cubic;
    for (int m = 0; m <= order; m++)
        for (int f = 0; f < 6; f++) {
            double sum = 0;
            for (int k = 5; k >= m; k--) {
                double factor = power[f][k];
                for (int j = 0; j < m; j++)
                    factor *= k - j;
                sum = sum * t + factor;
            }
            out[m][f] = sum;
        }
}

/* Add to out [FILL_ORDERS] the polynomial with these values [2 ends][derivatives + 1]. */
static void polynomial(const bat_fill *fill, int derivatives, double *const values[2][3],
                       double table[][6], double *out)
{
    const size_t length = bat_fill_length(fill);
    for (int m = 0; m < FILL_ORDERS; m++)
        for (int end = 0; end < 2; end++)
            for (int d = 0; d <= derivatives; d++) {
                const double factor = table[m][3 * end + d];
                for (size_t k = 0; k < length; k++)
                    out[(size_t)m * length + k] += factor * values[end][d][k];
            }
}

static void add_fixed(const bat_fill *fill, double *out, const double *values, int order)
{
    const size_t length = bat_fill_length(fill);
    for (int m = 0; m <= order; m++)
        for (int c = 0; c < 3; c++)
            out[(size_t)(m + 1) * length - 3 + (size_t)c] += values[3 * m + c];
}

/* D = a T + b C' by the rule of Leibniz. */
static void along_ribbon(const bat_fill *fill, const bat_fill_fields *side, int half,
                         double table[][6], const bat_fill_place *at, double *out)
{
    static const double binomial[FILL_ORDERS][4] = {{1}, {1, 1}, {1, 2, 1}, {1, 3, 3, 1}};
    const size_t length = bat_fill_length(fill);
    for (int which = 0; which < 2; which++)
        for (int m = 0; m < FILL_ORDERS; m++)
            for (int j = 0; j <= m; j++) { /* derivative j of the factor */
                const double *vector = which == 0 ? at->slope[m - j] : at->curve[m - j + 1];
                for (int k = 0; k <= fill->unknowns; k++) {
                    double factor = 0;
                    for (int end = 0; end < 2; end++)
                        for (int d = 0; d < 2; d++)
                            factor += table[j][3 * end + d] *
                                      side->factor[2 * half + end][which][d][k];
                    for (int c = 0; c < 3; c++)
                        out[(size_t)m * length + (size_t)(3 * k + c)] +=
                            binomial[m][j] * factor * vector[c];
                }
            }
}

/* The side and the derivative across it at side parameter t of the half. */
static batten_status along_side(const bat_fill *fill, int i, int half, double t, double *curve,
                                double *across)
{
    const bat_fill_side *given = &fill->loop->sides[i];
    const bat_fill_fields *side = &fill->side[i];
    const batten_side from = half == 0 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    bat_fill_place at;
    double table[FILL_ORDERS][6];
    batten_status status = batten_curve_evaluate_side(given->curve, t, from, 4, at.curve[0]);
    if (status == BATTEN_OK && given->slope)
        status = batten_curve_evaluate_side(given->slope, t, from, 3, at.slope[0]);
    if (status != BATTEN_OK)
        return status;
    add_fixed(fill, curve, at.curve[0], FILL_ORDERS - 1);
    bat_fill_hermite(1, t - half, FILL_ORDERS - 1, table);
    if (side->has_slope) {
        along_ribbon(fill, side, half, table, &at, across);
        return BATTEN_OK;
    }
    double *const values[2][3] = {
        {side->across[2 * half][0], side->across[2 * half][1]},
        {side->across[2 * half + 1][0], side->across[2 * half + 1][1]}};
    polynomial(fill, 1, values, table, across);
    return BATTEN_OK;
}

/* The spoke and sign W + c t G'. */
static void along_spoke(const bat_fill *fill, int i, double sign, double t, double *spoke,
                        double *across)
{
    const bat_fill_fields *side = &fill->side[i];
    const double c = fill->cosine;
    double table[FILL_ORDERS + 1][6], turn[FILL_ORDERS][6];
    bat_fill_hermite(2, t, FILL_ORDERS, table);
    bat_fill_hermite(1, t, FILL_ORDERS - 1, turn);
    for (int m = 0; m < FILL_ORDERS; m++)
        for (int f = 0; f < 6; f++)
            turn[m][f] *= sign;
    polynomial(fill, 2, side->spoke, table, spoke);
    double *const values[2][3] = {{side->turn[0][0], side->turn[0][1]},
                                  {side->turn[1][0], side->turn[1][1]}};
    polynomial(fill, 1, values, turn, across);
    /* c t G' and its derivatives */
    double product[FILL_ORDERS][6];
    for (int f = 0; f < 6; f++) {
        const double g1 = table[1][f], g2 = table[2][f], g3 = table[3][f];
        const double g4 = table[4][f];
        product[0][f] = c * t * g1;
        product[1][f] = c * (g1 + t * g2);
        product[2][f] = c * (2 * g2 + t * g3);
        product[3][f] = c * (3 * g3 + t * g4);
    }
    polynomial(fill, 2, side->spoke, product, across);
}

batten_status bat_fill_edges(const bat_fill *fill, int quad, int place, double t, double *out)
{
    const int before = (quad + fill->count - 1) % fill->count;
    const size_t step = FILL_ORDERS * bat_fill_length(fill);
    memset(out, 0, 4 * step * sizeof *out);
    if (place == 0) {
        along_spoke(fill, before, -1, t, out + 2 * step, out + 3 * step);
        return along_side(fill, quad, 0, t, out, out + step);
    }
    along_spoke(fill, quad, 1, t, out + 2 * step, out + 3 * step);
    const batten_status status = along_side(fill, before, 1, 2 - t, out, out + step);
    const size_t length = bat_fill_length(fill);
    for (int m = 1; m < FILL_ORDERS; m += 2) /* the side runs the other way */
        for (size_t k = (size_t)m * length; k < (size_t)(m + 1) * length; k++) {
            out[k] = -out[k];
            out[step + k] = -out[step + k];
        }
    return status;
}
