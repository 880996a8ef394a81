/*
 * Polynomials with whole coefficients, and their real roots as proved intervals.
 */
#ifndef BAT_WHOLE_POLYNOMIAL_H
#define BAT_WHOLE_POLYNOMIAL_H
#include "numeric/whole.h"

/* c[0 .. degree] with c[degree] not 0; degree -1 and no coefficients: 0, also what comes of an
 * effort that has failed. */
typedef struct {
    int degree;
    bat_whole *c;
} bat_whole_poly;

/* All coefficients 0, to be filled in; then bat_poly_trim finds the degree. */
bat_whole_poly bat_poly_make(bat_wholes *pool, int degree);
bat_whole_poly bat_poly_trim(bat_whole_poly p);
bat_whole_poly bat_poly_copy(bat_wholes *pool, bat_whole_poly p);
bat_whole_poly bat_poly_constant(bat_wholes *pool, int64_t value);
bat_whole_poly bat_poly_derivative(bat_wholes *pool, bat_whole_poly p);
/* a p + b q */
bat_whole_poly bat_poly_combine(bat_wholes *pool, int64_t a, bat_whole_poly p, int64_t b,
                                bat_whole_poly q);
bat_whole_poly bat_poly_multiply(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q);
/* p / q, which must divide it with whole coefficients. */
bat_whole_poly bat_poly_quotient(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q);
/* p by the greatest common divisor of its coefficients; the leading one becomes positive. */
bat_whole_poly bat_poly_primitive(bat_wholes *pool, bat_whole_poly p);
/* The primitive greatest common divisor. Modulo a prime it is seen that there is none; else
 * Source: [Knuth97] 4.6.1 C, the subresultants. */
bat_whole_poly bat_poly_gcd(bat_wholes *pool, bat_whole_poly p, bat_whole_poly q);
/* p = product of parts[i]^i, i = 1 .. the result, which is the highest multiplicity; parts
 * [degree + 1], primitive. p is primitive and not 0. Source: Yun, in [Knuth97] 4.6.2. */
int bat_poly_squarefree(bat_wholes *pool, bat_whole_poly p, bat_whole_poly *parts);
/* v^degree p(u / v) for a degree >= that of p; with v > 0 it has the sign of p. */
bat_whole bat_poly_value(bat_wholes *pool, bat_whole_poly p, int degree, bat_whole u,
                         bat_whole v);

/* p(t + by) */
bat_whole_poly bat_poly_shift(bat_wholes *pool, bat_whole_poly p, bat_whole by);
/* Bernstein coefficients on [0, 1], b [degree + 1], the largest of them 1 in size. */
void bat_poly_bernstein(bat_wholes *pool, bat_whole_poly p, double *b);

/* ---- real roots ---- */

/*
 * One real root of a squarefree polynomial: x = t, or x = 1 / t where `inverse`, in the open
 * interval (c, c + 1) / 2^k inside (-1, 1) and alone there; or x = c / 2^k itself.
 */
typedef struct {
    bool inverse, exact;
    bat_whole c;
    int k;
    int sign; /* of the polynomial in x right of c / 2^k */
} bat_whole_root;

/* All real roots, rising; roots [degree]. Effort INCOMPLETE when two are closer than 2^-200 of
 * their size. Source: [CA76], Descartes' rule on halved intervals. */
void bat_poly_isolate(bat_wholes *pool, bat_whole_poly p, bat_whole_root *roots, int *count);
/* Narrow an interval to `bits` binary places. Source: [Abbott14]. */
void bat_poly_refine(bat_wholes *pool, bat_whole_poly p, int bits, bat_whole_root *root);
/* The sign of q at a root of p. The interval may become narrower. */
int bat_poly_sign_at(bat_wholes *pool, bat_whole_poly q, bat_whole_poly p,
                     bat_whole_root *root);
/* The middle of the interval as a quotient u / v with v > 0. */
void bat_whole_root_middle(bat_wholes *pool, const bat_whole_root *root, bat_whole *u,
                           bat_whole *v);
double bat_whole_root_value(bat_wholes *pool, const bat_whole_root *root);

#endif
