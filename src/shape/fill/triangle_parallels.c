/*
 * The triangle of Barnhill, Birkhoff and Gordon. P_i interpolates along the parallels b_i =
 * const to side i, from point A of side k to point B of side j, s = b_k / (b_j + b_k); the
 * Boolean sum P_i + P_m - P_i P_m meets all three sides. It is P_m plus what P_i makes of that
 * by which P_m misses side m, the only one that it does not meet.
 */
#include "shape/fill/triangle_patch.h"

static bat_jet complement(bat_jet a)
{
    return bat_jet_subtract(bat_jet_constant(1), a);
}

/* ---- without slopes ---- */

/* (P_0 + P_1 + P_2 - L) / 2, L the plane through the corners */
static void continuous(const bat_triangle_patch *patch, const bat_triangle_place *at,
                       bat_jets *out)
{
    const bat_jet half = bat_jet_constant(0.5);
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        bat_jets A, B;
        bat_side_point(patch, k, complement(at->b[i]), &A);
        bat_side_point(patch, j, at->b[i], &B);
        bat_jets_add(out, bat_jet_multiply(half, complement(at->along[i])), &A);
        bat_jets_add(out, bat_jet_multiply(half, at->along[i]), &B);
        bat_jets_add_constant(out, bat_jet_scale(-0.5, at->b[i]), patch->corner[i]);
    }
}

/* ---- with slopes ---- */

/* P_i: *out += factor P_i F. Slopes are those in the direction from corner j to corner k: on
 * side k, which leads from corner i, the derivative across less b_i C'; on side j, which leads
 * to it, that with the opposite sign. */
static void add_hermite(const bat_triangle_patch *patch, const bat_triangle_place *at, int i,
                        double factor, bat_jets *out)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    const bat_hermite H = bat_hermite_at(at->along[i]);
    const bat_jet b = at->b[i], length = bat_jet_scale(factor, complement(b));
    bat_jets point, along, across;
    bat_side_frame(patch, k, complement(b), &point, &along, &across);
    bat_jets_add(out, bat_jet_scale(factor, H.value[0]), &point);
    bat_jet slope = bat_jet_multiply(length, H.slope[0]);
    bat_jets_add(out, slope, &across);
    bat_jets_add(out, bat_jet_scale(-1, bat_jet_multiply(slope, b)), &along);
    bat_side_frame(patch, j, b, &point, &along, &across);
    bat_jets_add(out, bat_jet_scale(factor, H.value[1]), &point);
    slope = bat_jet_scale(-1, bat_jet_multiply(length, H.slope[1]));
    bat_jets_add(out, slope, &across);
    bat_jets_add(out, bat_jet_multiply(slope, b), &along);
}

/* By how much P_m misses the data of side m: the value W, its derivative along the side, and
 * the derivative Z towards corner m. */
typedef struct {
    bat_jets W, along, Z;
    double twist[2][3]; /* d/dt of Z at both ends */
} defect;

/* Coordinate c of what P_m has on side m: Hermite's cubic between corners p = m + 1 and q = m +
 * 2. Towards corner m all that it is made of changes as sides q and p say. */
static void subtract_hermite(const bat_triangle_patch *patch, int m, bat_jet t, int c,
                             defect *out)
{
    const int p = (m + 1) % 3, q = (m + 2) % 3;
    const bat_hermite H = bat_hermite_at(t);
    const double x = t.d[0], to_m[2] = {patch->tangent[p][1][c], patch->tangent[q][0][c]};
    /* Slopes in the direction from p to q, and what they gain towards m. */
    const double slope[2] = {patch->tangent[p][0][c], -patch->tangent[q][1][c]};
    const double gain[2] = {to_m[0] - patch->turn[q][1][c] - slope[0],
                            -to_m[1] - patch->turn[p][0][c] - slope[1]};
    const double dh[2][4] = {{-6 * x * (1 - x), 12 * x - 6, 12, 0},
                             {6 * x * (1 - x), 6 - 12 * x, -12, 0}};
    const double dg[2][4] = {{(1 - x) * (1 - 3 * x), 6 * x - 4, 6, 0},
                             {x * (3 * x - 2), 6 * x - 2, 6, 0}};
    const double corner[2] = {patch->corner[p][c], patch->corner[q][c]};
    for (int end = 0; end < 2; end++) {
        const bat_jet value = H.value[end], rise = H.slope[end];
        bat_jet *W = &out->W.x[c], *along = &out->along.x[c], *Z = &out->Z.x[c];
        *W = bat_jet_subtract(*W, bat_jet_scale(corner[end], value));
        *W = bat_jet_subtract(*W, bat_jet_scale(slope[end], rise));
        *along =
            bat_jet_subtract(*along, bat_jet_scale(corner[end], bat_jet_compose(dh[end], t)));
        *along =
            bat_jet_subtract(*along, bat_jet_scale(slope[end], bat_jet_compose(dg[end], t)));
        *Z = bat_jet_subtract(*Z, bat_jet_scale(to_m[end], value));
        *Z = bat_jet_subtract(*Z, bat_jet_scale(gain[end], rise));
        out->twist[end][c] = patch->turn[m][end][c] - gain[end];
    }
}

/* What P_i makes of that by which P_m misses side m, where lines b_i = const end (m = j) or
 * begin (m = k). Where both sides i and m have a mixed derivative of their own in the corner
 * that they share, a share of the difference, 0 on side m and 1 on side i, is left out. */
static void add_correction(const bat_triangle_patch *patch, const bat_triangle_place *at, int i,
                           int m, double factor, bat_jets *out)
{
    const int j = (i + 1) % 3, k = (i + 2) % 3, end = m == j ? 0 : 1;
    const bat_jet b = at->b[i], t = m == j ? b : complement(b);
    const bat_jet share = m == j ? at->along[k] : complement(at->along[j]); /* b_m / (b_i + b_m)
                                                                             */
    defect miss;
    bat_side_frame(patch, m, t, &miss.W, &miss.along, &miss.Z);
    for (int c = 0; c < 3; c++)
        subtract_hermite(patch, m, t, c, &miss);
    const bat_jet left_out = bat_jet_multiply(share, bat_hermite_at(t).slope[end]);
    bat_jets_add_constant(&miss.Z, bat_jet_scale(-1, left_out), miss.twist[end]);

    const bat_hermite H = bat_hermite_at(at->along[i]);
    const bat_jet rise =
        bat_jet_multiply(bat_jet_scale(factor, complement(b)), H.slope[1 - end]);
    bat_jets_add(out, bat_jet_scale(factor, H.value[1 - end]), &miss.W);
    bat_jets_add(out, end == 0 ? bat_jet_scale(-1, rise) : rise, &miss.Z);
    bat_jets_add(out, bat_jet_scale(-1, bat_jet_multiply(rise, b)), &miss.along);
}

void bat_triangle_parallels(const bat_triangle_patch *patch, const bat_triangle_place *at,
                            bat_jets *out)
{
    if (!patch->smooth) {
        continuous(patch, at, out);
        return;
    }
    for (int i = 0; i < 3; i++) {
        add_hermite(patch, at, i, 2 / 6.0, out);
        add_correction(patch, at, i, (i + 1) % 3, 1 / 6.0, out);
        add_correction(patch, at, i, (i + 2) % 3, 1 / 6.0, out);
    }
}
