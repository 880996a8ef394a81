/*
 * Real roots of a polynomial in power form. The roots of each derivative, from the highest
 * down, separate those of the one before it.
 */
#include "numeric/polynomial.h"

#include <float.h>
#include <string.h>

/* The value at `t` by Horner; *error, where wanted, bounds its rounding. */
static double value_at(int degree, const double *c, double t, double *error)
{
    double value = c[degree], size = fabs(value);
    for (int i = degree - 1; i >= 0; i--) {
        value = value * t + c[i];
        size = size * fabs(t) + fabs(c[i]);
    }
    if (error)
        *error = (2 * degree + 1) * (DBL_EPSILON / 2) * size;
    return value;
}

/* The k-th derivative over k!: coefficient i is c[i + k] times the binomial of i + k over k. */
static void derivative(int degree, const double *c, int k, double *out)
{
    double binomial = 1;
    for (int i = 0; i <= degree - k; i++) {
        out[i] = binomial * c[i + k];
        binomial = binomial * (i + k + 1) / (i + 1);
    }
}

/* All roots lie within this of 0: twice the largest |c[n - k] / c[n]|^(1/k), by Fujiwara. */
static double root_bound(int degree, const double *c)
{
    double bound = 0;
    for (int k = 1; k <= degree; k++) {
        const double ratio = fabs(c[degree - k]) / fabs(c[degree]);
        bound = bat_max(bound, bat_pow(ratio, 1.0 / k));
    }
    return bat_min(2.1 * bound, DBL_MAX);
}

/* The root between a and b, where the values differ in sign: secants, and halves when they
 * crawl. */
static double refine(int degree, const double *c, double a, double b, double a_value,
                     double b_value)
{
    for (int i = 0; i < 4000; i++) {
        double t = a + (b - a) * (a_value / (a_value - b_value));
        if (i % 3 == 2 || !(t > a && t < b))
            t = 0.5 * a + 0.5 * b;
        if (t <= a || t >= b)
            break;
        const double value = value_at(degree, c, t, NULL);
        if (value == 0)
            return t;
        if ((value > 0) == (a_value > 0)) {
            a = t;
            a_value = value;
            b_value *= 0.5;
        } else {
            b = t;
            b_value = value;
            a_value *= 0.5;
        }
    }
    return fabs(a_value) < fabs(b_value) ? a : b;
}

/* The value at `t`, or 0 where it is lost in rounding. */
static double clear_value(int degree, const double *c, double t)
{
    double error;
    const double value = value_at(degree, c, t, &error);
    return fabs(value) <= error && isfinite(error) ? 0 : value;
}

/* Roots in [a, b] from those of the derivative, `turns`, which end monotone pieces. */
static int roots_between(int degree, const double *c, double a, double b, const double *turns,
                         int turn_count, double *roots)
{
    int count = 0;
    double from = a, from_value = clear_value(degree, c, a);
    if (from_value == 0)
        roots[count++] = a;
    for (int i = 0; i <= turn_count && count < degree; i++) {
        const double to = i < turn_count ? turns[i] : b;
        const double to_value = clear_value(degree, c, to);
        if (to_value == 0 && (count == 0 || roots[count - 1] < to))
            roots[count++] = to;
        else if ((from_value < 0 && to_value > 0) || (from_value > 0 && to_value < 0))
            roots[count++] = refine(degree, c, from, to, from_value, to_value);
        from = to;
        from_value = to_value;
    }
    return count;
}

int bat_polynomial_roots(int degree, const double *c, double a, double b, double *roots)
{
    assert(degree >= 0 && degree <= BAT_POLYNOMIAL_DEGREE);
    while (degree >= 0 && c[degree] == 0)
        degree--;
    if (degree <= 0)
        return degree;
    const double bound = root_bound(degree, c);
    a = bat_max(a, -bound);
    b = bat_min(b, bound);
    if (!(a <= b))
        return 0;
    double row[BAT_POLYNOMIAL_DEGREE + 1], turns[BAT_POLYNOMIAL_DEGREE];
    int count = 0;
    for (int k = degree - 1; k >= 0; k--) {
        derivative(degree, c, k, row);
        memcpy(turns, roots, (size_t)count * sizeof *turns);
        count = roots_between(degree - k, row, a, b, turns, count, roots);
    }
    return count;
}
