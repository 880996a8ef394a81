/*
 * The one formula of all Coons patches and networks (batten/coons.h), whatever the number of
 * lines:
 *
 *     S(u, v) = sum A_i(u) L_i(v) + sum M_j(u) B_j(v) + sum A_i(u) K_ij B_j(v).
 */
#ifndef BAT_COONS_H
#define BAT_COONS_H
#include "base/base.h"
#include <batten/coons.h>

typedef struct {
    int dimension;
    int count[2];            /* of A, of B */
    batten_curve **blend[2]; /* A [count[0]], B [count[1]], of dimension 1 */
    batten_curve **line[2];  /* L [count[0]] over v, M [count[1]] over u; NULL: 0 */
    double *corner;          /* K [count[0]][count[1]][dimension] */
    /* Gregory's twists: at (i, j) half of the difference of d/dv r_u and d/du r_v, which turns
     * from the one to the other. */
    bool gregory;
    double turn[2][2][3];
} bat_coons;

/* Arrays of this size, all NULL and 0; bat_coons_clear is due in any case. */
batten_status bat_coons_begin(int dimension, int count_u, int count_v, bat_coons *out);
void bat_coons_clear(bat_coons *coons);

/* The surface of kind "coons" over [0, 1] x [0, 1]; `coons` is taken over on success. *exact:
 * whether it has an equal NURBS surface. */
batten_status bat_coons_surface(bat_coons *coons, bool *exact, batten_surface **out);

/* ---- angles (coons_angle.c) ---- */

/* Between a direction in space and the plane of a and b, radians; 0 where these have none. */
double bat_coons_off_plane(const double *direction, const double *a, const double *b);
/* [4] by edge: the largest between the tangent planes of the patch and those of the side's
 * ribbon, radians; 0 for a side without slope. */
batten_status bat_coons_angles(const batten_ribbon sides[4], const batten_surface *surface,
                               double angle[4]);

/* ---- as one tensor B-spline (coons_spline.c) ---- */

/* Is there an equal NURBS surface? */
batten_status bat_coons_is_exact(const bat_coons *coons, bool *exact);
/* It, over [0, 1] x [0, 1], where there is one. TOO_LARGE before the work. With a tolerance
 * above 0 lines may move for the sake of knots that nearly coincide (near_knots.h); *error says
 * by how much the surface does. */
batten_status bat_coons_to_spline(const bat_coons *coons, double tolerance, double *error,
                                  batten_surface **out);

#endif
