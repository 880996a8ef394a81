/*
 * Nielson's side-vertex triangle. From each point S of side i a line leads to corner i; along
 * it the value is linear, or cubic with slopes, and three such surfaces are blended.
 */
#include "shape/fill/triangle_patch.h"

static bat_jet square(bat_jet a)
{
    return bat_jet_multiply(a, a);
}

/* Q = sum over i of (1 - b_i) F(S_i) - b_i F(V_i) */
static void continuous(const bat_triangle_patch *patch, const bat_triangle_place *at,
                       bat_jets *out)
{
    const bat_jet one = bat_jet_constant(1);
    for (int i = 0; i < 3; i++) {
        bat_jets S;
        bat_side_point(patch, i, at->along[i], &S);
        bat_jets_add(out, bat_jet_subtract(one, at->b[i]), &S);
        bat_jets_add_constant(out, bat_jet_scale(-1, at->b[i]), patch->corner[i]);
    }
}

/* D_i: Hermite's cubic along the line from S_i (b_i = 0) to the corner (b_i = 1). */
static void along_lines(const bat_triangle_patch *patch, const bat_triangle_place *at, int i,
                        bat_jets *out)
{
    bat_jets S, along, across;
    const bat_jet t = at->along[i];
    const bat_hermite H = bat_hermite_at(at->b[i]);
    bat_side_frame(patch, i, t, &S, &along, &across);
    bat_jets_add(out, H.value[0], &S);
    bat_jets_add(out, H.slope[0], &across);
    bat_jets_add_constant(out, H.value[1], patch->corner[i]);
    /* In the corner the line leads away from S = (1 - t) V_j + t V_k. */
    const bat_jet away = bat_jet_scale(-1, H.slope[1]);
    const bat_jet to_k = bat_jet_multiply(away, t);
    bat_jets_add_constant(out, bat_jet_subtract(away, to_k), patch->tangent[i][0]);
    bat_jets_add_constant(out, to_k, patch->tangent[i][1]);
}

/* The weights b_j^2 b_k^2 by the square of u, which they share. */
static void find_weights(const bat_triangle_place *at, bat_jet weights[3])
{
    const bat_jet one = bat_jet_constant(1), v = at->along[0];
    const bat_jet w = bat_jet_subtract(one, v), u = bat_jet_subtract(one, at->b[0]);
    weights[0] = square(bat_jet_multiply(u, bat_jet_multiply(v, w)));
    weights[1] = square(bat_jet_multiply(v, at->b[0]));
    weights[2] = square(bat_jet_multiply(at->b[0], w));
}

void bat_triangle_side_vertex(const bat_triangle_patch *patch, const bat_triangle_place *at,
                              bat_jets *out)
{
    if (!patch->smooth) {
        continuous(patch, at, out);
        return;
    }
    bat_jet weights[3], sum = bat_jet_constant(0);
    find_weights(at, weights);
    for (int i = 0; i < 3; i++)
        sum = bat_jet_add(sum, weights[i]);
    for (int i = 0; i < 3; i++) {
        bat_jets D = {0};
        along_lines(patch, at, i, &D);
        bat_jets_add(out, bat_jet_divide(weights[i], sum), &D);
    }
}
