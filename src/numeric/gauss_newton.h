/* Least sums of squares that are not linear, with few unknowns. */
#ifndef BAT_GAUSS_NEWTON_H
#define BAT_GAUSS_NEWTON_H
#include "base/base.h"

/* Residuals [rows] at x, and their derivatives [rows][unknowns] unless NULL. False where x has
 * none: such steps are shortened. */
typedef bool (*bat_residuals)(void *context, const double *x, double *residuals,
                              double *derivatives);

/* The minimum near x [unknowns], in place; steps are damped after Levenberg and Marquardt, so
 * the sum of squares never grows. *rounds: steps that were taken. BAD_ARGUMENT when x has no
 * residuals. Cost: 2 rows unknowns^2 for each round, at most `limit`. Source: [NW06] 10.3. */
batten_status bat_gauss_newton(int rows, int unknowns, bat_residuals f, void *context,
                               int limit, double *x, int *rounds);

#endif
