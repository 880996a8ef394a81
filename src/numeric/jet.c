/*
 * Taylor arithmetic in two variables up to third order: sums, products and quotients by
 * Leibniz' rule, and composition with a function of one variable.
 */
#include "numeric/jet.h"

#include <math.h>

/* Where the derivatives stand. */
enum { O, U, V, UU, UV, VV, UUU, UUV, UVV, VVV };

bat_jet bat_jet_constant(double value)
{
    return (bat_jet){{value}};
}

bat_jet bat_jet_u(double u)
{
    return (bat_jet){{u, 1}};
}

bat_jet bat_jet_v(double v)
{
    return (bat_jet){{v, 0, 1}};
}

bat_jet bat_jet_add(bat_jet a, bat_jet b)
{
    for (int i = 0; i < BAT_JET_SIZE; i++)
        a.d[i] += b.d[i];
    return a;
}

bat_jet bat_jet_subtract(bat_jet a, bat_jet b)
{
    for (int i = 0; i < BAT_JET_SIZE; i++)
        a.d[i] -= b.d[i];
    return a;
}

bat_jet bat_jet_scale(double factor, bat_jet a)
{
    for (int i = 0; i < BAT_JET_SIZE; i++)
        a.d[i] *= factor;
    return a;
}

/* What the rule of Leibniz adds to a b0 in each derivative of a b; in the order in which the
 * derivatives stand, so that a quotient can use it with those of `a` that are known already. */
static double leibniz(const double *a, const double *b, int derivative)
{
    switch (derivative) {
    case U:
    case V:
        return a[O] * b[derivative];
    case UU:
        return 2 * a[U] * b[U] + a[O] * b[UU];
    case UV:
        return a[U] * b[V] + a[V] * b[U] + a[O] * b[UV];
    case VV:
        return 2 * a[V] * b[V] + a[O] * b[VV];
    case UUU:
        return 3 * (a[UU] * b[U] + a[U] * b[UU]) + a[O] * b[UUU];
    case UUV:
        return a[UU] * b[V] + 2 * (a[UV] * b[U] + a[U] * b[UV]) + a[V] * b[UU] + a[O] * b[UUV];
    case UVV:
        return a[VV] * b[U] + 2 * (a[UV] * b[V] + a[V] * b[UV]) + a[U] * b[VV] + a[O] * b[UVV];
    case VVV:
        return 3 * (a[VV] * b[V] + a[V] * b[VV]) + a[O] * b[VVV];
    default:
        return 0;
    }
}

bat_jet bat_jet_multiply(bat_jet a, bat_jet b)
{
    bat_jet product;
    for (int i = 0; i < BAT_JET_SIZE; i++)
        product.d[i] = a.d[i] * b.d[O] + leibniz(a.d, b.d, i);
    return product;
}

bat_jet bat_jet_divide(bat_jet a, bat_jet b)
{
    bat_jet quotient;
    for (int i = 0; i < BAT_JET_SIZE; i++)
        quotient.d[i] = (a.d[i] - leibniz(quotient.d, b.d, i)) / b.d[O];
    return quotient;
}

bat_jet bat_jet_compose(const double g[4], bat_jet a)
{
    const double *d = a.d;
    const double u = d[U], v = d[V];
    return (bat_jet){{
        g[0],
        g[1] * u,
        g[1] * v,
        g[2] * u * u + g[1] * d[UU],
        g[2] * u * v + g[1] * d[UV],
        g[2] * v * v + g[1] * d[VV],
        g[3] * u * u * u + 3 * g[2] * u * d[UU] + g[1] * d[UUU],
        g[3] * u * u * v + g[2] * (2 * u * d[UV] + v * d[UU]) + g[1] * d[UUV],
        g[3] * u * v * v + g[2] * (2 * v * d[UV] + u * d[VV]) + g[1] * d[UVV],
        g[3] * v * v * v + 3 * g[2] * v * d[VV] + g[1] * d[VVV],
    }};
}

bat_jet bat_jet_square_root(bat_jet a)
{
    const double root = sqrt(a.d[O]), first = 0.5 / root, second = -0.5 * first / a.d[O];
    const double g[4] = {root, first, second, -1.5 * second / a.d[O]};
    return bat_jet_compose(g, a);
}
