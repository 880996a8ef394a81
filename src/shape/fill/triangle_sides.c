/* The sides of transfinite triangles as jets, sums of jets, and the cubics of Hermite. */
#include "shape/fill/triangle_patch.h"

#include <string.h>

/* Value and four derivatives of a curve over [0, 1] where t may be outside by rounding. */
static void curve_table(const batten_curve *curve, double t, int order, double table[5][3])
{
    double values[15] = {0};
    const double at = bat_max(0, bat_min(1, t));
    const batten_side side = at == 1 ? BATTEN_FROM_LEFT : BATTEN_FROM_RIGHT;
    /* A parameter in the domain: what overflows is found in the result. */
    if (batten_curve_evaluate_side(curve, at, side, order, values) != BATTEN_OK)
        for (int i = 0; i < 15; i++)
            values[i] = INFINITY;
    memcpy(table, values, sizeof values);
}

static void compose_jets(double table[5][3], int first, bat_jet t, bat_jets *out)
{
    for (int c = 0; c < 3; c++) {
        double g[4] = {0};
        for (int r = 0; r < 4 && first + r < 5; r++)
            g[r] = table[first + r][c];
        out->x[c] = bat_jet_compose(g, t);
    }
}

void bat_side_point(const bat_triangle_patch *patch, int e, bat_jet t, bat_jets *point)
{
    double table[5][3];
    curve_table(patch->sides[e].curve, t.d[0], 3, table);
    compose_jets(table, 0, t, point);
}

/* a (1 - t) + b t */
static bat_jet blend_ends(double a, double b, bat_jet t)
{
    return bat_jet_add(bat_jet_constant(a), bat_jet_scale(b - a, t));
}

void bat_side_frame(const bat_triangle_patch *patch, int e, bat_jet t, bat_jets *point,
                    bat_jets *along, bat_jets *across)
{
    const bat_triangle_side *side = &patch->sides[e];
    double table[5][3];
    curve_table(side->curve, t.d[0], 4, table);
    compose_jets(table, 0, t, point);
    compose_jets(table, 1, t, along);
    *across = (bat_jets){0};
    if (!side->slope) {
        bat_jets_add_constant(across, blend_ends(1, 0, t), side->ends[0]);
        bat_jets_add_constant(across, blend_ends(0, 1, t), side->ends[1]);
        return;
    }
    bat_jets slope;
    curve_table(side->slope, t.d[0], 3, table);
    compose_jets(table, 0, t, &slope);
    bat_jets_add(across, blend_ends(side->k[0], side->k[1], t), &slope);
    bat_jets_add(across, blend_ends(side->h[0], side->h[1], t), along);
}

/* ---- sums ---- */

void bat_jets_add(bat_jets *sum, bat_jet weight, const bat_jets *vector)
{
    for (int c = 0; c < 3; c++)
        sum->x[c] = bat_jet_add(sum->x[c], bat_jet_multiply(weight, vector->x[c]));
}

void bat_jets_add_constant(bat_jets *sum, bat_jet weight, const double vector[3])
{
    for (int c = 0; c < 3; c++)
        sum->x[c] = bat_jet_add(sum->x[c], bat_jet_scale(vector[c], weight));
}

bat_hermite bat_hermite_at(bat_jet s)
{
    const double x = s.d[0], y = 1 - x;
    const double h0[4] = {y * y * (1 + 2 * x), -6 * x * y, 12 * x - 6, 12};
    const double h1[4] = {x * x * (3 - 2 * x), 6 * x * y, 6 - 12 * x, -12};
    const double g0[4] = {x * y * y, y * (y - 2 * x), 6 * x - 4, 6};
    const double g1[4] = {-x * x * y, x * (x - 2 * y), 6 * x - 2, 6};
    return (bat_hermite){{bat_jet_compose(h0, s), bat_jet_compose(h1, s)},
                         {bat_jet_compose(g0, s), bat_jet_compose(g1, s)}};
}
