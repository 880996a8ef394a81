/* Curves in the plane from how they turn: the step that lays sheets flat. */
#ifndef BAT_FLAT_H
#define BAT_FLAT_H
#include "base/base.h"

enum { BAT_FLAT_NODES = 4 };

/* Integrals from 0 to each node c[i] of Gauss and Legendre in [0, 1], exact for degree 3; over
 * the whole step for degree 7. */
typedef struct {
    double c[BAT_FLAT_NODES], weights[BAT_FLAT_NODES];
    double A[BAT_FLAT_NODES][BAT_FLAT_NODES];
} bat_flat_rule;
void bat_flat_rule_make(bat_flat_rule *rule);

/* What is known at the nodes of one step, each times the step: how fast a direction turns, and
 * the velocity along it and to its left. */
typedef struct {
    double turn[BAT_FLAT_NODES], along[BAT_FLAT_NODES], across[BAT_FLAT_NODES];
} bat_flat_rates;
/* One step of the direction phi and of the point (x, y). */
void bat_flat_step(const bat_flat_rule *rule, const bat_flat_rates *rates, double *phi,
                   double *x, double *y);

#endif
