/* Nets of a sheet, for the tests of fairing them. */
#ifndef TESTS_LOFT_NET_SHEET_H
#define TESTS_LOFT_NET_SHEET_H
#include "support/test.h"

#include <batten/fair.h>
#include <math.h>

enum { NU = 12, NV = 8, NODES = NU * NV };

/* A sheet that bends one way along the rows and the other way nowhere: no section of it turns. */
static inline void sheet(int nu, int nv, double *out)
{
    for (int i = 0; i < nu; i++)
        for (int j = 0; j < nv; j++) {
            const double x = i / (nu - 1.), y = j / (nv - 1.);
            double *p = out + 3 * (i * nv + j);
            p[0] = 6 * x;
            p[1] = 3 * y;
            p[2] = 1.2 * x * (1 - x) - 0.5 * y * y + 0.1 * x * y;
        }
}

static inline double moved(const double *a, const double *b, int n)
{
    const double *p = a + 3 * n, *q = b + 3 * n;
    return sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                (p[2] - q[2]) * (p[2] - q[2]));
}

static inline batten_net_fair_options uniform(double within, batten_net_fair_method method)
{
    batten_net_fair_options options = batten_net_fair_defaults(within);
    options.parameters = BATTEN_UNIFORM;
    options.method = method;
    return options;
}

static inline batten_grid grid_of(const double *points)
{
    return (batten_grid){3, NU, NV, points};
}

#endif
