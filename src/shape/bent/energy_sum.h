/* The energy of a curve of quintic spans and its derivatives, summed over all spans. */
#ifndef BAT_BENT_ENERGY_SUM_H
#define BAT_BENT_ENERGY_SUM_H
#include "shape/bent/energy.h"

enum { BAT_ENERGY_GAUSS = 8, BAT_ENERGY_CORNERS = 6, BAT_ENERGY_MOST = BAT_ENERGY_CORNERS * 3 };

/* The three derivatives of Hermite's six quintics on [0, 1] at the nodes of Gauss. */
typedef struct {
    double weights[BAT_ENERGY_GAUSS], derivatives[BAT_ENERGY_GAUSS][3][BAT_ENERGY_CORNERS];
} bat_energy_basis;

/* Gradient and matrix of one span by the numbers of its two nodes. */
typedef struct {
    double gradient[BAT_ENERGY_MOST], hessian[BAT_ENERGY_MOST * BAT_ENERGY_MOST];
} bat_energy_change;

/* What is minimised, and what Newton needs of it. */
typedef struct {
    const bat_energy_task *task;
    bat_energy_curve *curve;
    bat_energy_basis basis;
    double first;                /* what is minimised, at the start */
    double energy, length, size; /* at x; `size`: of the terms of the energy */
    double *gradient;            /* [unknown_count] */
    double *length_gradient;     /* the same of the length, when scale invariant */
    double *matrix, *factor;     /* [unknown_count][band + 1] */
    double *right;               /* [unknown_count][3] */
    double *step;                /* [unknown_count] */
    double *kept;                /* x before the step */
    bat_energy_change *span;     /* [1] */
} bat_energy_search;

void bat_energy_fill_basis(bat_energy_basis *b);
/* Energy and length at x. */
void bat_energy_sum(bat_energy_search *s, double *energy, double *length, double *size);
double bat_energy_objective(const bat_energy_search *s, double energy, double length);
void bat_energy_differentiate(bat_energy_search *s);
double bat_energy_length_factor(const bat_energy_search *s, double length);
/* What is minimised: E + tension L, or E L^p. */
double bat_energy_power(const bat_energy_search *s);
const double *bat_energy_frame_of(const bat_energy_curve *curve, int node);

#endif
