/* How cuts bend, as a linear measure of the control points. */
#include "loft/bending.h"
#include "numeric/vector.h"

/* The direction T = n x m in the basis S_u, S_v. */
static bool cutting_direction(const bat_loft_place *place, const bat_loft_cut *cut,
                              const double normal[3], double *a, double *b)
{
    const double *su = place->s[1][0], *sv = place->s[0][1];
    double t[3];
    bat_loft_cross(normal, cut->m, t);
    const double length = bat_norm(3, t);
    const double e = bat_dot(3, su, su), f = bat_dot(3, su, sv), g = bat_dot(3, sv, sv);
    const double det = e * g - f * f;
    if (!(length > 0) || !(det > 0))
        return false;
    const double tu = bat_dot(3, t, su) / length, tv = bat_dot(3, t, sv) / length;
    *a = (tu * g - tv * f) / det;
    *b = (tv * e - tu * f) / det;
    return true;
}

static double section_bending(const bat_loft_place *place, const bat_loft_cut *cut,
                              bat_loft_measure *out)
{
    double a, b, second[3];
    *out = (bat_loft_measure){0};
    if (!(bat_loft_normal(place, out->vector) > 0) ||
        !cutting_direction(place, cut, out->vector, &a, &b))
        return NAN;
    const double *su = place->s[1][0], *sv = place->s[0][1];
    for (int c = 0; c < 3; c++)
        second[c] = a * a * place->s[2][0][c] + 2 * a * b * place->s[1][1][c] +
                    b * b * place->s[0][2][c];
    const double e = bat_dot(3, su, su), f = bat_dot(3, su, sv), g = bat_dot(3, sv, sv);
    const double x = bat_dot(3, second, su), y = bat_dot(3, second, sv), det = e * g - f * f;
    out->weight[2][0] = a * a;
    out->weight[1][1] = 2 * a * b;
    out->weight[0][2] = b * b;
    out->weight[1][0] = -(x * g - y * f) / det;
    out->weight[0][1] = -(y * e - x * f) / det;
    return bat_dot(3, out->vector, second);
}

/* n . (c'' - g c') with n the normal of the edge c as it is seen along m, g frozen. */
static double edge_bending(const bat_loft_place *place, const bat_loft_cut *cut,
                           bat_loft_measure *out)
{
    const double *m = cut->m;
    double first[3], *n = out->vector;
    *out = (bat_loft_measure){0};
    const double sight = bat_dot(3, place->s[1][0], m);
    for (int c = 0; c < 3; c++)
        first[c] = place->s[1][0][c] - sight * m[c];
    const double square = bat_dot(3, first, first);
    if (!(square > 0))
        return NAN;
    bat_loft_cross(m, first, n);
    for (int c = 0; c < 3; c++)
        n[c] /= sqrt(square);
    out->weight[2][0] = 1;
    out->weight[1][0] = -bat_dot(3, place->s[2][0], first) / square;
    return bat_dot(3, n, place->s[2][0]);
}

double bat_loft_bending(const bat_loft_place *place, const bat_loft_cut *cut,
                        bat_loft_measure *out)
{
    return bat_cut_is_edge(cut) ? edge_bending(place, cut, out)
                                : section_bending(place, cut, out);
}
