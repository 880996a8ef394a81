/*
 * Integrals over an interval.
 */
#ifndef BAT_QUADRATURE_H
#define BAT_QUADRATURE_H
#include "base/base.h"

#define BAT_MAX_GAUSS 64

/* Gauss-Legendre on [-1, 1]: `n` nodes, rising, and their weights; exact for degree 2 n - 1. 1
 * <= n <= BAT_MAX_GAUSS; to a few units of the last place of 1. Source: [DLMF] 3.5. */
void bat_gauss(int n, double *nodes, double *weights);

/* The value of an integrand at `t`. */
typedef batten_status (*bat_integrand)(void *context, double t, double *value);

/* The integral of f from a to b within `tolerance` (of the integral, absolute; > 0), by halving
 * where Gauss with 15 nodes and its Kronrod companion disagree most, after at most `limit`
 * evaluations. *error: an estimate that is rarely below the true error, and never above
 * `tolerance` with BATTEN_OK. BATTEN_TOLERANCE_NOT_MET sets *value and *error nevertheless.
 * Source: [PDUK83] */
batten_status bat_integrate(bat_integrand f, void *context, double a, double b,
                            double tolerance, int limit, double *value, double *error);

/* An integrand whose peaks stand at breaks. No node of a rule need come near a narrow peak, but
 * the values just beside the breaks show it: an interval is halved until its nodes see at least
 * half of what they show. */
typedef struct {
    bat_integrand f;
    void *context;
    int count;            /* of breaks, 2 or more */
    const double *breaks; /* rising; the integral goes from the first to the last */
    double relative;      /* the error allowed, a part of the integral of |f| */
    int limit;            /* of evaluations for each interval between breaks, on average */
} bat_peaked_integral;

/* The ends of the intervals that were integrated in the end, rising. */
typedef struct {
    int count, room;
    double *at;
} bat_integral_breaks;

/* *error as above. BATTEN_TOLERANCE_NOT_MET sets *value, *error and *fine, too. `fine` may be
 * NULL; else what it holds is to be released. */
batten_status bat_integrate_peaked(const bat_peaked_integral *integral, double *value,
                                   double *error, bat_integral_breaks *fine);

#endif
