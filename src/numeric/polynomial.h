/*
 * Polynomials in power form: c[0] + c[1] t + ... + c[degree] t^degree.
 */
#ifndef BAT_POLYNOMIAL_H
#define BAT_POLYNOMIAL_H
#include "base/base.h"

#define BAT_POLYNOMIAL_DEGREE 32

/*
 * The real roots in [a, b], rising, each once; -INFINITY and INFINITY ask for all. degree <=
 * BAT_POLYNOMIAL_DEGREE. Between the roots of the derivative a polynomial is monotone, so each
 * is known once those are. A root of the derivative where the value is lost in its rounding is
 * a multiple root. Simple roots are as good as the values of the polynomial allow, whatever the
 * scales of coefficients and roots.
 *
 * roots: [degree]
 * The count; -1 when all coefficients are 0. Cost: degree^2 refinements of degree
 * multiplications each.
 */
int bat_polynomial_roots(int degree, const double *c, double a, double b, double *roots);

#endif
