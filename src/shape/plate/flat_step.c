/* One step in the plane of a curve that is known by how it turns. */
#include "shape/plate/flat_step.h"

#include "numeric/quadrature.h"

void bat_flat_rule_make(bat_flat_rule *rule)
{
    enum { N = BAT_FLAT_NODES };
    double nodes[N], plain[N];
    double *c = rule->c;
    bat_gauss(N, nodes, plain);
    for (int i = 0; i < N; i++) {
        c[i] = 0.5 + 0.5 * nodes[i];
        rule->weights[i] = plain[i] / 2;
    }
    for (int i = 0; i < N; i++)
        for (int j = 0; j < N; j++) {
            rule->A[i][j] = 0;
            for (int q = 0; q < N; q++) {
                double basis = 1;
                for (int m = 0; m < N; m++)
                    basis *= m == j ? 1 : (c[i] * c[q] - c[m]) / (c[j] - c[m]);
                rule->A[i][j] += c[i] * rule->weights[q] * basis;
            }
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
