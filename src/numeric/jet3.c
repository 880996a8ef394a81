/*
 * Vectors of space with jets as coordinates: products, length and direction, together with all
 * their derivatives.
 */
#include "numeric/jet3.h"

bat_jet bat_jet_of_v(const double d[4])
{
    return bat_jet_compose(d, bat_jet_v(0));
}

double bat_jet_in_v(const bat_jet *a, int k)
{
    static const int places[4] = {0, 2, 5, 9};
    return a->d[places[k]];
}

bat_jet3 bat_jet3_of_v(int d, const double *values)
{
    double rows[3][4] = {{0}};
    for (int c = 0; c < d; c++)
        for (int k = 0; k < 4; k++)
            rows[c][k] = values[k * d + c];
    return (bat_jet3){bat_jet_of_v(rows[0]), bat_jet_of_v(rows[1]), bat_jet_of_v(rows[2])};
}

bat_jet3 bat_jet3_constant(batten_vec3 a)
{
    return (bat_jet3){bat_jet_constant(a.x), bat_jet_constant(a.y), bat_jet_constant(a.z)};
}

batten_vec3 bat_jet3_in_v(const bat_jet3 *a, int k)
{
    return (batten_vec3){bat_jet_in_v(&a->x, k), bat_jet_in_v(&a->y, k),
                         bat_jet_in_v(&a->z, k)};
}

bat_jet3 bat_jet3_add(bat_jet3 a, bat_jet3 b)
{
    return (bat_jet3){bat_jet_add(a.x, b.x), bat_jet_add(a.y, b.y), bat_jet_add(a.z, b.z)};
}

bat_jet3 bat_jet3_subtract(bat_jet3 a, bat_jet3 b)
{
    return (bat_jet3){bat_jet_subtract(a.x, b.x), bat_jet_subtract(a.y, b.y),
                      bat_jet_subtract(a.z, b.z)};
}

bat_jet3 bat_jet3_multiply(bat_jet s, bat_jet3 a)
{
    return (bat_jet3){bat_jet_multiply(s, a.x), bat_jet_multiply(s, a.y),
                      bat_jet_multiply(s, a.z)};
}

bat_jet bat_jet3_dot(bat_jet3 a, bat_jet3 b)
{
    return bat_jet_add(bat_jet_add(bat_jet_multiply(a.x, b.x), bat_jet_multiply(a.y, b.y)),
                       bat_jet_multiply(a.z, b.z));
}

bat_jet3 bat_jet3_cross(bat_jet3 a, bat_jet3 b)
{
    return (bat_jet3){bat_jet_subtract(bat_jet_multiply(a.y, b.z), bat_jet_multiply(a.z, b.y)),
                      bat_jet_subtract(bat_jet_multiply(a.z, b.x), bat_jet_multiply(a.x, b.z)),
                      bat_jet_subtract(bat_jet_multiply(a.x, b.y), bat_jet_multiply(a.y, b.x))};
}

bat_jet bat_jet3_norm(bat_jet3 a)
{
    return bat_jet_square_root(bat_jet3_dot(a, a));
}

bat_jet3 bat_jet3_unit(bat_jet3 a)
{
    return bat_jet3_multiply(bat_jet_divide(bat_jet_constant(1), bat_jet3_norm(a)), a);
}
