/*
 * A bicubic patch S(u, v) = sum N_i(u) N_j(v) P_ij over the unit square, whose control points
 * are found by convex programs. v runs fastest, for it is the shorter side of a hull.
 */
#ifndef BAT_LOFT_PATCH_H
#define BAT_LOFT_PATCH_H
#include "base/base.h"
#include "numeric/vector.h"
#include <batten/geometry.h>

enum { BAT_LOFT_DEGREE = 3, BAT_LOFT_SUPPORT = BAT_LOFT_DEGREE + 1 };

typedef struct {
    int nu, nv;      /* control points along u and v */
    double *u_knots; /* [nu + 4], from 0 to 1 */
    double *v_knots; /* [nv + 4] */
    double *points;  /* [nu][nv][3] */
} bat_loft_patch;

/* Two derivatives of the basis functions that live on a place, and of the surface there. */
typedef struct {
    double u, v;
    int i, j;                            /* the first basis functions */
    double along_u[3][BAT_LOFT_SUPPORT]; /* [order][function] */
    double along_v[3][BAT_LOFT_SUPPORT];
    double s[3][3][3]; /* [order in u][order in v][coordinate], orders that sum to 2 at most */
} bat_loft_place;

/* Clamped cubic knots over [0, 1] with these inside: `knots` [inner_count + 8]. */
void bat_loft_knots(int inner_count, const double *inner, double *knots);

batten_status bat_loft_patch_make(int nu, const double *u_knots, int nv, const double *v_knots,
                                  bat_loft_patch *out);
void bat_loft_patch_free(bat_loft_patch *patch);

/* The basis and the surface at (u, v), which are moved into the unit square. */
void bat_loft_place_at(const bat_loft_patch *patch, double u, double v, bat_loft_place *out);

/* out = a x b, which may be one of them. */
static inline void bat_loft_cross(const double a[3], const double b[3], double out[3])
{
    const batten_vec3 c =
        bat_vec3_cross((batten_vec3){a[0], a[1], a[2]}, (batten_vec3){b[0], b[1], b[2]});
    memcpy(out, (const double[3]){c.x, c.y, c.z}, 3 * sizeof *out);
}

/* The unit normal S_u x S_v; returns the length of that product. */
double bat_loft_normal(const bat_loft_place *place, double normal[3]);

#endif
