/* The clothoid between two points with given directions. */
#ifndef BAT_SPIRAL_H
#define BAT_SPIRAL_H
#include "base/base.h"

/* From (0, 0) to (1, 0): theta = alpha + (beta - alpha - A) t + A t^2, t = s / length. */
typedef struct {
    double A, A_alpha, A_beta; /* half the rate of curvature, and its partial derivatives */
    double chord;              /* 1 / length */
    double chord_alpha, chord_beta;
    int steps; /* of Newton */
} bat_clothoid;

/* SINGULAR_SYSTEM where Newton finds none: |alpha| and |beta| both near pi. */
batten_status bat_clothoid_solve(double alpha, double beta, bat_clothoid *out);

#endif
