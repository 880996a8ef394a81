/*
 * Affine maps of space: translation, scaling, rotation about an axis, reflection in a plane,
 * and how they are composed and applied to points.
 */
#include "base/base.h"
#include <batten/geometry.h>

batten_affine batten_affine_identity(void)
{
    return batten_affine_scaling(1, 1, 1);
}

batten_affine batten_affine_translation(double x, double y, double z)
{
    batten_affine map = batten_affine_identity();
    map.t[0] = x;
    map.t[1] = y;
    map.t[2] = z;
    return map;
}

batten_affine batten_affine_scaling(double x, double y, double z)
{
    return (batten_affine){.m = {{x, 0, 0}, {0, y, 0}, {0, 0, z}}};
}

/* The unit vector along `v`, whatever its length. */
static void unit(batten_vec3 v, double n[3])
{
    const double largest = bat_max(fabs(v.x), bat_max(fabs(v.y), fabs(v.z)));
    assert(largest > 0);
    const double x = v.x / largest, y = v.y / largest, z = v.z / largest;
    const double norm = sqrt(x * x + y * y + z * z);
    n[0] = x / norm;
    n[1] = y / norm;
    n[2] = z / norm;
}

/* Give the linear map `map` the translation that leaves `origin` where it is. */
static batten_affine about(batten_affine map, batten_vec3 origin)
{
    const double o[3] = {origin.x, origin.y, origin.z};
    for (int i = 0; i < 3; i++)
        map.t[i] = o[i] - (map.m[i][0] * o[0] + map.m[i][1] * o[1] + map.m[i][2] * o[2]);
    return map;
}

/* Rodrigues: cos I + (1 - cos) n nt + sin [n]. */
batten_affine batten_affine_rotation(batten_vec3 origin, batten_vec3 axis, double angle)
{
    double n[3];
    unit(axis, n);
    const double c = bat_cos(angle), s = bat_sin(angle);
    /* 1 - cos without cancelling */
    const double versine = 2 * bat_sin(angle / 2) * bat_sin(angle / 2);
    const double cross[3][3] = {{0, -n[2], n[1]}, {n[2], 0, -n[0]}, {-n[1], n[0], 0}};
    batten_affine map = {.t = {0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            map.m[i][j] = (i == j ? c : 0) + versine * n[i] * n[j] + s * cross[i][j];
    return about(map, origin);
}

/* Householder: I - 2 n nt. */
batten_affine batten_affine_mirror(batten_vec3 origin, batten_vec3 normal)
{
    double n[3];
    unit(normal, n);
    batten_affine map = {.t = {0}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            map.m[i][j] = (i == j ? 1 : 0) - 2 * n[i] * n[j];
    return about(map, origin);
}

batten_affine batten_affine_compose(batten_affine first, batten_affine then)
{
    batten_affine map = {.t = {0}};
    for (int i = 0; i < 3; i++) {
        map.t[i] = then.t[i];
        for (int k = 0; k < 3; k++) {
            map.t[i] += then.m[i][k] * first.t[k];
            for (int j = 0; j < 3; j++)
                map.m[i][j] += then.m[i][k] * first.m[k][j];
        }
    }
    return map;
}

batten_vec3 batten_affine_apply(batten_affine map, batten_vec3 p)
{
    double q[3];
    for (int i = 0; i < 3; i++)
        q[i] = map.m[i][0] * p.x + map.m[i][1] * p.y + map.m[i][2] * p.z + map.t[i];
    return (batten_vec3){q[0], q[1], q[2]};
}

double batten_affine_determinant(const batten_affine map)
{
    const double(*m)[3] = map.m;
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}
