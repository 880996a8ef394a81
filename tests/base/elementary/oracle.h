/*
 * The elementary functions in numbers of 113 bits, by their series alone, and how many units of the last place a
 * double is away from them. Only where the compiler has such numbers: elsewhere these tests are skipped.
 */
#ifndef ORACLE_H
#define ORACLE_H
#include "support/test.h"

#ifdef __SIZEOF_FLOAT128__
__extension__ typedef __float128 quad;
#else
typedef long double quad;
#endif

quad oracle_exp(quad x);
quad oracle_expm1(quad x);
quad oracle_log(quad x);
quad oracle_log2(quad x);
quad oracle_log10(quad x);
quad oracle_sin(quad x); /* |x| < 2^50 */
quad oracle_cos(quad x);
quad oracle_tan(quad x);
quad oracle_atan(quad x);
quad oracle_asin(quad x);
quad oracle_acos(quad x);
quad oracle_sinh(quad x);
quad oracle_cosh(quad x);
quad oracle_cbrt(quad x);
quad oracle_pow(quad x, quad y);
quad oracle_atan2(quad y, quad x);
quad oracle_hypot(quad x, quad y);

/* How far `got` is from `want`, in units of the last place that a double near `want` has. */
double oracle_units(double got, quad want);

/* A stretch of arguments: even, or by their logarithms and of both signs. */
typedef struct {
    const char *name;
    double (*function)(double);
    quad (*oracle)(quad);
    double low, high;
    bool by_logarithm;
} oracle_stretch;

/* Random arguments of each stretch: none is wrong by more than `most` units. */
void oracle_check(const oracle_stretch *stretches, int count, double most);

/* Neighbours of arguments are in order: across 500 doubles about each of `count` places. */
void oracle_check_order(double (*function)(double), const double *places, int count,
                        int direction);

/* A function of one argument and what it is, to the bit; NaN stands for itself. */
typedef struct {
    double x, value;
} oracle_value;

void oracle_check_values(double (*function)(double), const oracle_value *values, int count);

/* The same of two arguments. */
typedef struct {
    double x, y, value;
} oracle_value2;

void oracle_check_values2(double (*function)(double, double), const oracle_value2 *values,
                          int count);

#endif
