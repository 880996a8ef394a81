/*
 * Laying flat in two files: the rulings and the plane (unroll_flat.c), and the surface with the
 * refinement (unroll.c).
 */
#ifndef BAT_UNROLL_PARTS_H
#define BAT_UNROLL_PARTS_H
#include "base/base.h"
#include <batten/plate.h>

/* The surface between its two edges, with a common parameter. */
typedef struct {
    const batten_curve *edge[2];
    batten_interval domain;
    double size; /* largest extent */
} bat_strip;

/* One ruling: from P[0] to P[1], velocities D of both ends; r along it, n the normal midway
 * along it, m = n x r, all of length 1. */
typedef struct {
    batten_vec3 P[2], D[2], r, m, n;
    double length;
} bat_strip_ruling;

/* Known rulings in the plane. */
typedef struct {
    int count;
    double *u;      /* [count] */
    double *points; /* [count][2][2] on both edges */
    double *rates;  /* [count - 1][2][2][2] velocities at the start and the end of each piece,
                       on both edges */
    double turn;
    double length[2][2], area[2];            /* of the edges, and the whole: in space, flat */
    double strain, strain_sum, strain_at[2]; /* the sum of squares over the area */
    double diagonal[2];
} bat_flat_strip;
/* Lay flat with so many steps between neighbouring knots; *out is all zeros before. */
batten_status bat_strip_flatten(const bat_strip *strip, int knot_count, const double *knots,
                                int steps, bat_flat_strip *out);
void bat_flat_strip_release(bat_flat_strip *flat);

#endif
