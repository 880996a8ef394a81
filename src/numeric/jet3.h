/*
 * Vectors of space whose coordinates are jets.
 */
#ifndef BAT_JET3_H
#define BAT_JET3_H
#include "numeric/jet.h"
#include "numeric/vector.h"

typedef struct {
    bat_jet x, y, z;
} bat_jet3;

/* A jet in v alone: a value and its first three derivatives. */
bat_jet bat_jet_of_v(const double d[4]);

/* Its derivative of order k in v, k <= 3. */
double bat_jet_in_v(const bat_jet *a, int k);

/* A point of a curve of dimension d, `values` [4][d], over v. */
bat_jet3 bat_jet3_of_v(int d, const double *values);
bat_jet3 bat_jet3_constant(batten_vec3 a);

/* Its derivative of order k in v. */
batten_vec3 bat_jet3_in_v(const bat_jet3 *a, int k);
bat_jet3 bat_jet3_add(bat_jet3 a, bat_jet3 b);
bat_jet3 bat_jet3_subtract(bat_jet3 a, bat_jet3 b);
bat_jet3 bat_jet3_multiply(bat_jet s, bat_jet3 a);
bat_jet bat_jet3_dot(bat_jet3 a, bat_jet3 b);
bat_jet3 bat_jet3_cross(bat_jet3 a, bat_jet3 b);

/* The caller sees to it that a is not 0, and that its square is a number. */
bat_jet bat_jet3_norm(bat_jet3 a);
bat_jet3 bat_jet3_unit(bat_jet3 a);

#endif
