/* Hulls whose values are known in closed form. */
#include "hydrostatics/hulls.h"

#include "support/test.h"

batten_surface *half_prism(double from, double to, int count, const double (*section)[2])
{
    double points[2][8][3];
    double knots_v[10];
    static const double knots_u[] = {0, 0, 1, 1};
    batten_surface *surface = NULL;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < count; j++) {
            double *p = &points[0][0][0] + 3 * (i * count + j);
            p[0] = i ? to : from;
            p[1] = section[j][0];
            p[2] = section[j][1];
        }
    for (int k = 0; k < count + 2; k++)
        knots_v[k] = k == 0 ? 0 : k > count ? count - 1 : k - 1;
    const batten_axis u = {1, 2, knots_u, false}, v = {1, count, knots_v, false};
    CHECK_OK(batten_surface_create(3, &u, &v, &points[0][0][0], NULL, &surface));
    return surface;
}

batten_hull *hull_of(batten_surface *half)
{
    batten_hull *hull = NULL;
    const batten_surface *const surfaces[] = {half};
    CHECK_OK(batten_hull_create(1, surfaces, NULL, &hull));
    batten_surface_unref(half);
    return hull;
}

batten_hull *box_hull(void)
{
    static const double section[][2] = {{0, 0}, {1, 0}, {1, 2}};
    return hull_of(half_prism(0, 4, 3, section));
}

/* The polynomial of degree 2 by 2 in Bezier points, and above it a strip of straight sides. */
batten_hull *wigley_hull(void)
{
    static const double knots[] = {0, 0, 0, 1, 1, 1};
    const double x[3] = {-WIGLEY_LENGTH / 2., 0, WIGLEY_LENGTH / 2.}, along[3] = {0, 2, 0};
    const double z[2][3] = {{-WIGLEY_DRAUGHT, -WIGLEY_DRAUGHT / 2, 0}, {0, 0.5, 1}};
    const double up[2][3] = {{0, 1, 1}, {1, 1, 1}};
    const batten_axis axis = {2, 3, knots, false};
    batten_surface *parts[2] = {NULL, NULL};
    batten_hull *hull = NULL;
    for (int part = 0; part < 2; part++) {
        double points[3][3][3];
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                points[i][j][0] = x[i];
                points[i][j][1] = WIGLEY_BREADTH / 2. * along[i] * up[part][j];
                points[i][j][2] = z[part][j];
            }
        CHECK_OK(batten_surface_create(3, &axis, &axis, &points[0][0][0], NULL, &parts[part]));
    }
    CHECK_OK(batten_hull_create(2, (const batten_surface *const *)parts, NULL, &hull));
    for (int part = 0; part < 2; part++)
        batten_surface_unref(parts[part]);
    return hull;
}

oblique_box box_at(double trim, double heel)
{
    const double length = 4, breadth = 2, draught = 0.9;
    const double a = tan(trim) / cos(heel), b = tan(heel);
    const double st = sin(trim), ct = cos(trim), sp = sin(heel), cp = cos(heel);
    const double plane = length * breadth / (ct * cp), mixed = tan(trim) * tan(heel);
    const double xx = length * length / 12, yy = breadth * breadth / 12;
    return (oblique_box){{draught + 2 * a, trim, heel},
                         {st, ct * sp, ct * cp},
                         {ct, -st * sp, -st * cp},
                         {0, cp, -sp},
                         {2 - a * xx / draught, -b * yy / draught,
                          draught / 2 + (a * a * xx + b * b * yy) / (2 * draught)},
                         plane,
                         {plane * xx / (ct * ct), plane * mixed / ct * xx,
                          plane * (yy / (cp * cp) + mixed * mixed * xx)}};
}
