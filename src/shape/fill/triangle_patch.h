/*
 * What transfinite triangles share. Corners, sides and barycentric coordinates are counted 0,
 * 1, 2; side e is opposite corner e and runs, t = 0 .. 1, from corner e + 1 to corner e + 2
 * (modulo 3). For a side or corner i, j = i + 1 and k = i + 2.
 */
#ifndef BAT_TRIANGLE_PATCH_H
#define BAT_TRIANGLE_PATCH_H
#include "numeric/jet.h"
#include "shape/formula/formula.h"
#include <batten/fill.h>

/* A point or vector in space as jets. */
typedef struct {
    bat_jet x[3];
} bat_jets;

/* A side: its curve over [0, 1] and the derivative towards the opposite corner V, that is for
 * the step V - S from the point S of the side: k(t) T + h(t) C', or without T the blend of its
 * values at both ends. */
typedef struct {
    batten_curve *curve, *slope;
    double k[2], h[2]; /* at t = 0 and 1 */
    double ends[2][3]; /* the tangents of the other two curves, towards V */
} bat_triangle_side;

typedef struct {
    batten_triangle_method method;
    bool smooth; /* with slopes */
    bat_triangle_side sides[3];
    double corner[3][3];
    /* What follows is of smooth ones only. */
    double tangent[3][2][3]; /* at corner i along the sides to corners j and k */
    double turn[3][2][3];    /* at both ends of side i, d/dt of the derivative across */
} bat_triangle_patch;

/* Take curves and slopes over, as the loop has them; what was taken is the patch's also after a
 * failure. */
batten_status bat_triangle_fill(const batten_ribbon ribbons[3],
                                const batten_loop_place places[3], double angle_tolerance,
                                bat_triangle_patch *patch);

/* Where the formula is asked: the barycentric coordinates, and along[i] = b[k] / (b[j] + b[k]).
 */
typedef struct {
    bat_jet b[3], along[3];
} bat_triangle_place;

/* The point of side e at t. */
void bat_side_point(const bat_triangle_patch *patch, int e, bat_jet t, bat_jets *point);
/* The same, and the derivatives along the side (C') and across it, towards the corner. */
void bat_side_frame(const bat_triangle_patch *patch, int e, bat_jet t, bat_jets *point,
                    bat_jets *along, bat_jets *across);

/* *sum += weight * vector */
void bat_jets_add(bat_jets *sum, bat_jet weight, const bat_jets *vector);
void bat_jets_add_constant(bat_jets *sum, bat_jet weight, const double vector[3]);

/* Hermite's cubics on [0, 1]: value and slope at 0, value and slope at 1. */
typedef struct {
    bat_jet value[2], slope[2];
} bat_hermite;
bat_hermite bat_hermite_at(bat_jet s);

/* One method, for places away from corners 1 and 2. */
void bat_triangle_side_vertex(const bat_triangle_patch *patch, const bat_triangle_place *at,
                              bat_jets *out);
void bat_triangle_parallels(const bat_triangle_patch *patch, const bat_triangle_place *at,
                            bat_jets *out);
void bat_triangle_corners(const bat_triangle_patch *patch, const bat_triangle_place *at,
                          bat_jets *out);

#endif
