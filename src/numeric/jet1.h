/*
 * Jets of order 1: a number together with its first derivatives in u and v, and vectors of them.
 * The arithmetic of jet.h where second derivatives are neither known nor wanted, at a third of
 * its cost; inline, for fields are asked for at a hundred thousand points.
 */
#ifndef BAT_JET1_H
#define BAT_JET1_H
#include "numeric/vector.h"

typedef struct {
    double f, u, v;
} bat_jet1;

typedef struct {
    bat_jet1 x, y, z;
} bat_jet1_vector;

static inline bat_jet1 bat_jet1_constant(double f)
{
    return (bat_jet1){f, 0, 0};
}

static inline bat_jet1 bat_jet1_add(bat_jet1 a, bat_jet1 b)
{
    return (bat_jet1){a.f + b.f, a.u + b.u, a.v + b.v};
}

static inline bat_jet1 bat_jet1_subtract(bat_jet1 a, bat_jet1 b)
{
    return (bat_jet1){a.f - b.f, a.u - b.u, a.v - b.v};
}

static inline bat_jet1 bat_jet1_scale(double factor, bat_jet1 a)
{
    return (bat_jet1){factor * a.f, factor * a.u, factor * a.v};
}

static inline bat_jet1 bat_jet1_multiply(bat_jet1 a, bat_jet1 b)
{
    return (bat_jet1){a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v};
}

/* g(a), with the value and the derivative of g there. */
static inline bat_jet1 bat_jet1_compose(double g, double slope, bat_jet1 a)
{
    return (bat_jet1){g, slope * a.u, slope * a.v};
}

/* The caller sees to it that b is not 0. */
static inline bat_jet1 bat_jet1_divide(bat_jet1 a, bat_jet1 b)
{
    return bat_jet1_multiply(a, bat_jet1_compose(1 / b.f, -1 / (b.f * b.f), b));
}

/* a > 0 */
static inline bat_jet1 bat_jet1_square_root(bat_jet1 a)
{
    const double root = sqrt(a.f);
    return bat_jet1_compose(root, 0.5 / root, a);
}

/* a d - b c */
static inline bat_jet1 bat_jet1_minor(bat_jet1 a, bat_jet1 b, bat_jet1 c, bat_jet1 d)
{
    return bat_jet1_subtract(bat_jet1_multiply(a, d), bat_jet1_multiply(b, c));
}

/* ---- vectors ---- */

static inline bat_jet1_vector bat_jet1_fixed(batten_vec3 a)
{
    return (bat_jet1_vector){bat_jet1_constant(a.x), bat_jet1_constant(a.y),
                             bat_jet1_constant(a.z)};
}

static inline bat_jet1_vector bat_jet1_between(bat_jet1_vector a, bat_jet1_vector b)
{
    return (bat_jet1_vector){bat_jet1_subtract(a.x, b.x), bat_jet1_subtract(a.y, b.y),
                             bat_jet1_subtract(a.z, b.z)};
}

static inline bat_jet1_vector bat_jet1_times(bat_jet1 factor, bat_jet1_vector a)
{
    return (bat_jet1_vector){bat_jet1_multiply(factor, a.x), bat_jet1_multiply(factor, a.y),
                             bat_jet1_multiply(factor, a.z)};
}

static inline bat_jet1 bat_jet1_dot(bat_jet1_vector a, bat_jet1_vector b)
{
    return bat_jet1_add(bat_jet1_add(bat_jet1_multiply(a.x, b.x), bat_jet1_multiply(a.y, b.y)),
                        bat_jet1_multiply(a.z, b.z));
}

static inline bat_jet1_vector bat_jet1_cross(bat_jet1_vector a, bat_jet1_vector b)
{
    return (bat_jet1_vector){bat_jet1_minor(a.y, a.z, b.y, b.z),
                             bat_jet1_minor(a.z, a.x, b.z, b.x),
                             bat_jet1_minor(a.x, a.y, b.x, b.y)};
}

/* 1 / |a|; the caller sees to it that a is not 0. */
static inline bat_jet1 bat_jet1_reciprocal_length(bat_jet1_vector a)
{
    return bat_jet1_divide(bat_jet1_constant(1), bat_jet1_square_root(bat_jet1_dot(a, a)));
}

#endif
