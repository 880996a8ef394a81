/* What is linear in the unknowns of fairing by least change: values and derivatives of the difference of two battens. */
#include "fair/least_change.h"
#include "spline/spline.h"

enum { P = 3, SUPPORT = BAT_CHANGE_SUPPORT };

static void add_unknown(int unknown, double factor, bat_change_row *row)
{
    row->weight[unknown - row->first] += factor;
}

/* Coefficient `at` of the n + 2, as a sum of unknowns. */
static void add_coefficient(const bat_least_change *c, int at, double factor,
                            bat_change_row *row)
{
    const double *t = c->piece->batten->t;
    const int n = c->ducks;
    if (at == 1) {
        const double near = t[1] - t[0], far = t[2] - t[0];
        add_unknown(0, factor * far / (near + far), row);
        add_unknown(1, factor * near / (near + far), row);
    } else if (at == n) {
        const double near = t[n - 1] - t[n - 2], far = t[n - 1] - t[n - 3];
        add_unknown(n - 1, factor * far / (near + far), row);
        add_unknown(n - 2, factor * near / (near + far), row);
    } else {
        add_unknown(at == 0 ? 0 : bat_min_int(at - 1, n - 1), factor, row);
    }
}

bat_change_row bat_change_row_on(const bat_least_change *c, int span, bool last, int order)
{
    double basis[3 * SUPPORT];
    bat_change_row row = {.first = bat_max_int(0, bat_min_int(span - 1, c->ducks - SUPPORT))};
    bat_basis(P, c->knots, span + P, c->piece->batten->t[span + last], order, basis);
    for (int k = 0; k < SUPPORT; k++)
        add_coefficient(c, span + k, basis[order * SUPPORT + k], &row);
    return row;
}

bat_change_row bat_change_row_at(const bat_least_change *c, int i, int order)
{
    const int span = bat_min_int(i, c->ducks - 2);
    return bat_change_row_on(c, span, span < i, order);
}
