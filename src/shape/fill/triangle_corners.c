/*
 * Charrot's and Gregory's triangle. R_i takes over value and slope from the two sides that meet
 * in corner i, with x = b_j and y = b_k measured from there; a rational term lets both sides
 * have a mixed derivative of their own in the corner.
 */
#include "shape/fill/triangle_patch.h"

/* What one side gives at distance x from corner i: the point F, and the derivative G in the
 * direction of the other side. Side k leads from the corner to j, side j from k to the corner.
 */
static void from_side(const bat_triangle_patch *patch, int side, bool leads_in, bat_jet x,
                      bat_jets *F, bat_jets *G)
{
    const bat_jet t = leads_in ? bat_jet_subtract(bat_jet_constant(1), x) : x;
    bat_jets along;
    bat_side_frame(patch, side, t, F, &along, G);
    bat_jets_add(G, leads_in ? bat_jet_scale(-1, x) : x, &along);
}

/* The mixed derivatives in corner i, as sides j and k have them. */
static void find_twists(const bat_triangle_patch *patch, int i, double twist_j[3],
                        double twist_k[3])
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    for (int c = 0; c < 3; c++) {
        twist_j[c] = patch->tangent[i][1][c] - patch->turn[j][1][c];
        twist_k[c] = patch->turn[k][0][c] + patch->tangent[i][0][c];
    }
}

static void smooth_corner(const bat_triangle_patch *patch, int i, const bat_triangle_place *at,
                          bat_jets *out)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const bat_jet x = at->b[j], y = at->b[k], one = bat_jet_constant(1);
    double twist_j[3], twist_k[3];
    bat_jets F, G;
    from_side(patch, j, true, y, &F, &G); /* F(0, y), F_x(0, y) */
    bat_jets_add(out, one, &F);
    bat_jets_add(out, x, &G);
    from_side(patch, k, false, x, &F, &G); /* F(x, 0), F_y(x, 0) */
    bat_jets_add(out, one, &F);
    bat_jets_add(out, y, &G);
    bat_jets_add_constant(out, bat_jet_constant(-1), patch->corner[i]);
    bat_jets_add_constant(out, bat_jet_scale(-1, x), patch->tangent[i][0]);
    bat_jets_add_constant(out, bat_jet_scale(-1, y), patch->tangent[i][1]);
    /* x y (x t_j + y t_k) / (x + y), with y / (x + y) = along */
    find_twists(patch, i, twist_j, twist_k);
    const bat_jet xy = bat_jet_scale(-1, bat_jet_multiply(x, y));
    const bat_jet share = bat_jet_multiply(xy, at->along[i]);
    bat_jets_add_constant(out, bat_jet_subtract(xy, share), twist_j);
    bat_jets_add_constant(out, share, twist_k);
}

static void plain_corner(const bat_triangle_patch *patch, int i, const bat_triangle_place *at,
                         bat_jets *out)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const bat_jet one = bat_jet_constant(1);
    bat_jets F;
    bat_side_point(patch, j, bat_jet_subtract(one, at->b[k]), &F);
    bat_jets_add(out, one, &F);
    bat_side_point(patch, k, at->b[j], &F);
    bat_jets_add(out, one, &F);
    bat_jets_add_constant(out, bat_jet_constant(-1), patch->corner[i]);
}

/* b_i^2 (3 - 2 b_i + 6 b_j b_k): their sum is 1. */
static bat_jet weight(const bat_triangle_place *at, int i)
{
    const bat_jet b = at->b[i];
    const bat_jet others = bat_jet_multiply(at->b[(i + 1) % 3], at->b[(i + 2) % 3]);
    const bat_jet factor = bat_jet_add(
        bat_jet_subtract(bat_jet_constant(3), bat_jet_scale(2, b)), bat_jet_scale(6, others));
    return bat_jet_multiply(bat_jet_multiply(b, b), factor);
}

void bat_triangle_corners(const bat_triangle_patch *patch, const bat_triangle_place *at,
                          bat_jets *out)
{
    for (int i = 0; i < 3; i++) {
        bat_jets R = {0};
        if (patch->smooth)
            smooth_corner(patch, i, at, &R);
        else
            plain_corner(patch, i, at, &R);
        bat_jets_add(out, weight(at, i), &R);
    }
}
