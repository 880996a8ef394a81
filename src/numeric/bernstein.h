/*
 * Polynomials in Bernstein form on [0, 1]: coefficients c[0 .. degree].
 */
#ifndef BAT_BERNSTEIN_H
#define BAT_BERNSTEIN_H
#include "base/base.h"

#define BAT_BERNSTEIN_DEGREE 128

/* The value at `t` by de Casteljau; degree <= BAT_BERNSTEIN_DEGREE. Cost degree^2. */
double bat_bernstein_value(int degree, const double *c, double t);

/* The parts on [0, t] and [t, 1]; `left` or `right` may be `c` itself, and either may be NULL.
 */
void bat_bernstein_split(int degree, const double *c, double t, double *left, double *right);

typedef struct {
    double t;
    int multiplicity; /* how many roots rounding does not tell apart; 2 too where the graph only
                         touches 0 */
} bat_root;

/*
 * All roots in [0, 1], rising. Simple ones are right to a few units of the last place of 1; of
 * those that rounding does not tell apart one stands for all.
 *
 * zero: values up to this count as 0, besides those that are rounding of the largest
 * coefficient roots: [degree] *count: -1 when all coefficients count as 0 INCOMPLETE when more
 * than `degree` places count as 0: then the polynomial vanishes within rounding over long
 * parts. Cost: about degree^2 log2(1 / distance) for each root. Source: [LR81], Descartes'
 * rule of signs.
 */
batten_status bat_bernstein_roots(int degree, const double *c, double zero, bat_root *roots,
                                  int *count);

#endif
