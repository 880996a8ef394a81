/* One step in the plane of a curve that is known by how it turns. */
#include "shape/plate/flat_step.h"

#include "numeric/quadrature.h"

/* From 0 to node i, of the polynomial that is 1 at node j and 0 at the others. */
static double integral_of_basis(const bat_flat_rule *rule, int i, int j)
{
    const double *c = rule->c;
    double sum = 0;
    for (int q = 0; q < BAT_FLAT_NODES; q++) {
        double basis = 1;
        for (int m = 0; m < BAT_FLAT_NODES; m++)
            basis *= m == j ? 1 : (c[i] * c[q] - c[m]) / (c[j] - c[m]);
        sum += c[i] * rule->weights[q] * basis;
    }
    return sum;
}

void bat_flat_rule_make(bat_flat_rule *rule)
{
    enum { N = BAT_FLAT_NODES };
    double nodes[N], plain[N];
    bat_gauss(N, nodes, plain);
    for (int i = 0; i < N; i++) {
        rule->c[i] = 0.5 + 0.5 * nodes[i];
        rule->weights[i] = plain[i] / 2;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            rule->A[i][j] = integral_of_basis(rule, i, j);
        }
}

void bat_flat_step(const bat_flat_rule *rule, const bat_flat_rates *rates, double *phi,
                   double *x, double *y)
{
    for (int j = 0; j < BAT_FLAT_NODES; j++) {
        double turned = *phi;
        for (int m = 0; m < BAT_FLAT_NODES; m++)
            turned += rule->A[j][m] * rates->turn[m];
        const double c = bat_cos(turned), s = bat_sin(turned);
        *x += rule->weights[j] * (rates->along[j] * c - rates->across[j] * s);
        *y += rule->weights[j] * (rates->along[j] * s + rates->across[j] * c);
    }
    for (int j = 0; j < BAT_FLAT_NODES; j++)
        *phi += rule->weights[j] * rates->turn[j];
}
